#pragma once

#include <filesystem>
#include <functional>

/// C libraries that a hostile file may crash. Not installed.
namespace swayaw::inline core::detail {

/// Bytes that reading a MATLAB file may take beside those in proportion to it: libraries, buffers of HDF5, short files
/// of constant columns that MATLAB compressed to a thousandth.
inline constexpr std::size_t trial_memory = 64'000'000;

/// Bytes for each byte of the file: measured columns compress to a half, rounded ones to a tenth, and they are held as
/// the library's numbers and as ours.
inline constexpr std::size_t trial_memory_per_byte = 40;

/// Processor time that reading may take [s], and for each byte: a sixtieth of the slowest rate that was seen (HDF5).
inline constexpr double trial_time = 1.0, trial_time_per_byte = 1e-7;

/// Reads in a process of its own first, a copy of this one that nobody waits for but us: what crashes there, does not
/// end, or takes too much memory, is not begun here. What `read` leaves behind is lost, exceptions included.
/// @throws FileError
void require_harmless(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace swayaw::core::detail

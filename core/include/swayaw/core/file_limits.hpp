#pragma once

#include <cstddef>
#include <cstdint>

/// How large files may be that are read. A file that came from somebody else is refused in one line before it fills the
/// memory.
namespace swayaw::inline core {

/// What a file holds, which tells how large it may be.
enum class FileUse {
  samples,      ///< recordings, logs, tables of captive tests
  description,  ///< ships, plans, column maps, measured indices
};

/// Bytes of a file of samples: 10 Hz in 10 columns for a week. `swayaw check` of 40 MB takes 456 MB of memory, `import`
/// 150 MB: of the largest file 11 GB and 4 GB.
inline constexpr std::uint64_t usual_samples_size = 1'000'000'000;

/// Bytes of a description. The largest ship file of the project has 3 kB; TOML of 9 MB takes 190 MB of memory.
inline constexpr std::uint64_t usual_description_size = 10'000'000;

/// Bytes of a line of text. A row of a thousand numbers has some 20 kB; a description may stand on one line. A larger
/// file without ends of lines is no table.
inline constexpr std::size_t longest_line = usual_description_size;

/// Columns of a recording. Alarm and monitoring systems of ships log a few thousand; each name is compared with all
/// others, which takes 0.1 s here.
inline constexpr std::size_t most_columns = 10'000;

/// Bytes of the largest file of that use that is read now.
std::uint64_t largest_file(FileUse use);

/// From now on the largest file has so many bytes, whatever its use, in all of this process.
void set_largest_file(std::uint64_t bytes);

}  // namespace swayaw::core

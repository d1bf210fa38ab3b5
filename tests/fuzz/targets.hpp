#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// Readers of swayaw as functions of bytes that anybody may have written (docs/bad_input.md).
///
/// The same functions are called by clang's libFuzzer, which seeks inputs that reach new code (libfuzzer.cpp, run.sh),
/// and by the suite of tests with inputs of a mutator of its own (replay_test.cpp).
namespace swayaw::fuzz {

/// A promise of docs/bad_input.md that an input broke.
class BrokenPromise : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// @throws BrokenPromise  unless it holds
void promise(bool holds, std::string_view what);

/// Bytes that an input may take.
struct Memory {
  std::size_t at_rest = 4'000'000;  ///< tables of units and names, ships, buffers of streams
  std::size_t per_byte = 4;         ///< of the file

  std::size_t most(std::size_t bytes) const { return at_rest + per_byte * bytes; }
};

/// Writes a file of these bytes in place of any that is there. That one is removed first: a file that is cut to nothing
/// and written again goes to the disk at once on ext4 (2 ms; 0.06 ms anew), and 10^5 inputs wait for that.
void write(const std::filesystem::path& file, std::string_view bytes);

/// Reads the bytes, and what was read is used and written as far as that is quick.
/// @throws FileError      as readers do
/// @throws BrokenPromise  if what was read is not as they promise
using Read = void (*)(std::string_view bytes, const std::filesystem::path& file);

struct Target {
  const char* name;    ///< also of its folder of inputs in corpus/
  const char* file;    ///< name that the bytes have as a file
  bool is_text;        ///< lines and numbers mean something in it
  double share;        ///< of the replayed inputs, over that of others: what is slow has few
  const char* covers;  ///< for the table of docs/bad_input.md
  Read read;
  Memory memory = {};
};

/// Of files that need no ship: core, plans of sweeps, captive tests.
std::span<const Target> file_targets();

/// Of ship files, which are sailed, too, and of measured indices.
std::span<const Target> ship_targets();

/// How an input ended.
struct End {
  std::string refusal;  ///< the line that the program says; empty: it was read
};

/// Reads the bytes. Every end but a result or one line that names the file is a broken promise.
/// @param scratch  an empty folder for files of its own
/// @throws BrokenPromise
End end_of(const Target& target, std::string_view bytes, const std::filesystem::path& scratch);

}  // namespace swayaw::fuzz

#pragma once

#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

/// Files that tests read. The folders are set by CMake.
namespace swayaw::test {

inline const std::filesystem::path ships = SWAYAW_TEST_SHIPS;
inline const std::filesystem::path golden = SWAYAW_TEST_GOLDEN;
inline const std::filesystem::path example_recordings = SWAYAW_TEST_EXAMPLES;

/// A folder of recordings that are not part of the project, if it is there; else says that the test is skipped.
inline std::optional<std::filesystem::path> benchmark_recordings(const std::string& name) {
  const auto folder = std::filesystem::path(SWAYAW_TEST_SHARED) / "data" / name;
  if (std::filesystem::exists(folder)) return folder;
  std::cout << "[skipped] no recordings in " << folder.string() << "\n";
  return std::nullopt;
}

/// An empty folder for the files of one test, removed at its end.
class Scratch {
 public:
  Scratch()
      : folder_(std::filesystem::temp_directory_path() /
                ("swayaw-test-" + std::to_string(::getpid()) + "-" + std::to_string(made++))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  inline static int made = 0;
  std::filesystem::path folder_;
};

}  // namespace swayaw::test

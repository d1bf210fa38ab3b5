#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swayaw::inline core {

/// A question that the data or the model cannot answer; `what()` says why in one line.
class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A place in a text file, counted from 1; 0 where it is not known.
struct FilePlace {
  std::filesystem::path file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// A file that cannot be read: "FILE:LINE:COLUMN: what is wrong".
class FileError : public Refusal {
 public:
  FileError(const FilePlace& place, std::string_view what_is_wrong);

  const FilePlace& place() const { return place_; }

 private:
  FilePlace place_;
};

/// @return `value`
/// @throws std::domain_error  "ship length L [m] must be positive, got 0"
double require_positive(double value, std::string_view quantity);

}  // namespace swayaw::core

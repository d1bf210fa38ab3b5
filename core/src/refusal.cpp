#include "swayaw/core/refusal.hpp"

#include <fmt/format.h>

#include "swayaw/core/detail/printable.hpp"

namespace swayaw::inline core {
namespace {

std::string text_of(const FilePlace& place, std::string_view what_is_wrong) {
  const auto file = detail::printable(place.file.string()), what = detail::printable(what_is_wrong);
  if (place.line == 0) return fmt::format("{}: {}", file, what);
  return fmt::format("{}:{}:{}: {}", file, place.line, place.column, what);
}

/// A MATLAB file has no lines, though what stands in it may have been read as text.
FilePlace place_in(const FilePlace& place) {
  if (place.line == 0 || place.file.extension() != ".mat") return place;
  return {place.file, 1, 1};
}

}  // namespace

FileError::FileError(const FilePlace& place, std::string_view what_is_wrong)
    : Refusal(text_of(place_in(place), what_is_wrong)), place_(place_in(place)) {}

double require_positive(double value, std::string_view quantity) {
  if (value > 0.0) return value;
  throw std::domain_error(fmt::format("{} must be positive, got {}", quantity, value));
}

}  // namespace swayaw::core

#include "swayaw/core/refusal.hpp"

#include <fmt/format.h>

namespace swayaw::inline core {
namespace {

std::string text_of(const FilePlace& place, std::string_view what_is_wrong) {
  if (place.line == 0) return fmt::format("{}: {}", place.file.string(), what_is_wrong);
  return fmt::format("{}:{}:{}: {}", place.file.string(), place.line, place.column, what_is_wrong);
}

}  // namespace

FileError::FileError(const FilePlace& place, std::string_view what_is_wrong)
    : Refusal(text_of(place, what_is_wrong)), place_(place) {}

double require_positive(double value, std::string_view quantity) {
  if (value > 0.0) return value;
  throw std::domain_error(fmt::format("{} must be positive, got {}", quantity, value));
}

}  // namespace swayaw::core

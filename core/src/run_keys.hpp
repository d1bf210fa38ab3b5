#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "import/nmea_sentence.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/detail/toml_depth.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"

/// What a recording file says of its run, in the lines above the header row.
namespace swayaw::inline core::detail {
using namespace detail;

/// Facts of the run that change how samples are read.
struct Convention {
  double rudder_sign = 1.0;                     ///< inside sign of a recorded positive angle
  double reference_x = 0.0;                     ///< reported point forward of midship [m]
  bool rudder_is_order = false;                 ///< what stands in the column of the actual angle
  std::optional<double> ordered_rev = {};       ///< shaft speed where no column has it [1/s]
  std::vector<std::string> extra_columns = {};  ///< that the file itself says are none of a recording's
};

inline constexpr std::array<std::string_view, 9> run_keys{"rudder_positive", "reference_x_m", "water_depth_m",
                                                          "execute_s",       "manoeuvre",     "order_recorded",
                                                          "ordered_rev_s",   "group",         "start_utc"};

/// A TOML text on one line.
inline std::string in_quotes(const std::string& text) {
  const toml::value<std::string> value(text);
  std::ostringstream quoted;
  quoted << toml::toml_formatter(value, toml::format_flags::allow_unicode_strings);
  auto line = std::move(quoted).str();
  for (auto at = line.find('\x7F'); at != std::string::npos; at = line.find('\x7F', at))
    line.replace(at, 1, "\\u007F");  // which TOML does not allow as it is, and toml++ 3.3 writes
  return line;
}

/// The run key that was perhaps meant: one that begins alike.
inline std::string_view similar_run_key(std::string_view key) {
  constexpr std::size_t alike = 6;
  const auto begin = lower_case(key.substr(0, alike));
  const auto similar =
      std::ranges::find_if(run_keys, [&](auto known) { return begin.size() == alike && known.starts_with(begin); });
  return similar == run_keys.end() ? std::string_view{} : *similar;
}

/// Reads the lines above the header row of a recording, one by one.
class RunKeyReader {
 public:
  RunKeyReader(const std::filesystem::path& file, RunFacts& facts, Convention& convention,
               std::vector<std::string>& warnings)
      : file_(file), facts_(facts), convention_(convention), warnings_(warnings) {}

  /// Reads `key = value`; a line without '=' is a remark to human readers.
  void read(std::string_view line, std::size_t line_number, std::size_t column) {
    line_number_ = line_number;
    column_ = column;
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) return warn_of_remark(trimmed(line));
    const RunRemark as_written{std::string(trimmed(line.substr(0, equals))),
                               std::string(trimmed(line.substr(equals + 1)))};
    if (const auto deep = place_of_deep_key(line))
      throw FileError(at(*deep + 1), fmt::format("a key of more than {} dots", deepest_key));
    try {
      for (auto&& [key, value] : toml::parse(line))
        if (!take_key(key.str(), value)) keep(key.str(), as_written, value);
    } catch (const toml::parse_error& error) {
      throw FileError(at(error.source().begin.column), error.description());
    }
  }

 private:
  /// @return whether the key is one of `run_keys`
  bool take_key(std::string_view key, const toml::node& value) {
    if (std::ranges::count(run_keys, key) == 0) return false;
    if (std::ranges::count(seen_, key) > 0) throw FileError(at(1), fmt::format("{} appears twice", key));
    seen_.emplace_back(key);
    if (key == "rudder_positive") convention_.rudder_sign = rudder_sign_of(value);
    else if (key == "reference_x_m") convention_.reference_x = number(key, value);
    else if (key == "water_depth_m") facts_.water_depth = positive_number(key, value);
    else if (key == "execute_s") facts_.execute = number(key, value);
    else if (key == "order_recorded") convention_.rudder_is_order = truth(key, value);
    else if (key == "ordered_rev_s") convention_.ordered_rev = number(key, value);
    else if (key == "manoeuvre") facts_.manoeuvre = text(key, value);
    else facts_.remarks.push_back({std::string(key), in_quotes(key == "group" ? text(key, value) : instant(value))});
    return true;
  }

  void keep(std::string_view key, const RunRemark& as_written, const toml::node& value) {
    if (key == "extra_columns") take_extra_columns(value);
    facts_.remarks.push_back(as_written);
    if (const auto similar = similar_run_key(key); !similar.empty()) warn(key, similar);
  }

  void take_extra_columns(const toml::node& value) {
    if (const auto* list = value.as_array())
      for (const auto& name : *list) convention_.extra_columns.push_back(text("each of extra_columns", name));
  }

  void warn_of_remark(std::string_view remark) {
    const auto word = remark.substr(0, remark.find_first_of(" \t:"));
    if (std::ranges::count(run_keys, word) > 0) warn(remark, std::string(word) + " = ...");
  }

  void warn(std::string_view written, std::string_view meant) {
    const auto name = file_.filename().string();
    warnings_.push_back(
        fmt::format("{}: \"{}\" above the header is not understood; is {} meant?", name, shown(written), meant));
  }

  double rudder_sign_of(const toml::node& value) {
    const auto side = text("rudder_positive", value);
    if (side == "port") return 1.0;
    if (side == "starboard") return -1.0;
    throw FileError(at(value),
                    fmt::format("rudder_positive must be \"port\" or \"starboard\", got \"{}\"", shown(side)));
  }

  double number(std::string_view key, const toml::node& value) {
    const auto found = value.value<double>();
    if (found && value.is_number() && std::isfinite(*found)) return *found;
    throw FileError(at(value), fmt::format("{} must be a number", key));
  }

  double positive_number(std::string_view key, const toml::node& value) {
    const double found = number(key, value);
    if (found > 0.0) return found;
    throw FileError(at(value), fmt::format("{} must be positive, got {}", key, found));
  }

  bool truth(std::string_view key, const toml::node& value) {
    if (const auto found = value.value_exact<bool>()) return *found;
    throw FileError(at(value), fmt::format("{} must be true or false", key));
  }

  std::string text(std::string_view key, const toml::node& value) {
    if (const auto found = value.value_exact<std::string>()) return *found;
    throw FileError(at(value), fmt::format("{} must be a text in quotes", key));
  }

  /// A date with a time, in quotes or as TOML has them.
  std::string instant(const toml::node& value) {
    std::ostringstream written;
    if (const auto found = value.value_exact<std::string>()) written << *found;
    else if (const auto* stamp = value.as_date_time()) written << stamp->get();
    const auto stamp = time_stamp_in(written.str());
    if (stamp && stamp->kind == TimeStamp::Kind::instant) return written.str();
    throw FileError(at(value), "start_utc must be a date and a time, like \"2026-03-04T09:30:00Z\"");
  }

  FilePlace at(std::size_t column) const { return {file_, line_number_, column_ + column - 1}; }
  FilePlace at(const toml::node& value) const { return at(value.source().begin.column); }

  std::filesystem::path file_;
  std::size_t line_number_ = 0;
  std::size_t column_ = 0;  ///< of the first character after '#'
  RunFacts& facts_;
  Convention& convention_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> seen_;
};

}  // namespace swayaw::core::detail

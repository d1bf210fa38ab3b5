#include "swayaw/core/recording_csv.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#ifdef SWAYAW_GEOGRAPHICLIB
#include <GeographicLib/LocalCartesian.hpp>
#endif
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "mat/recording_mat.hpp"
#include "run_keys.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "swayaw/core/detail/printable.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {
using namespace detail;
namespace {

// ---------------------------------------------------------------- columns

/// A column while it is read.
struct Reading {
  std::string name;
  std::size_t place;  ///< of its name in the header row
  std::optional<Column> known = {};
  std::vector<double> values = {};
  std::vector<std::string> cells = {};  ///< as written, if the column is not understood

  bool is_understood() const { return known || name == "time_s" || name == "lat_deg" || name == "lon_deg"; }
};

/// The name that would be understood, if this one differs from it in capital letters only.
std::string_view same_but_for_capitals(std::string_view name) {
  constexpr std::array<std::string_view, 3> others{"time_s", "lat_deg", "lon_deg"};
  const auto same = [&](std::string_view known) { return lower_case(known) == lower_case(name); };
  if (const auto found = std::ranges::find_if(others, same); found != others.end()) return *found;
  const auto found = std::ranges::find_if(known_columns(), same, &Column::name);
  return found == known_columns().end() ? std::string_view{} : found->name;
}

class RecordingParser {
 public:
  RecordingParser(std::string_view text, const std::filesystem::path& file, std::optional<Side> rudder_positive)
      : rest_(text), file_(file), rudder_positive_(rudder_positive) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  RecordingFile parse() {
    read_header();
    read_rows();
    fill_recording();
    return {std::move(recording_), std::move(warnings_)};
  }

 private:
  bool next_line() {
    if (rest_.empty()) return false;
    line_ = take(rest_, '\n');
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    ++line_number_;
    if (const auto zero = line_.find('\0'); zero != std::string_view::npos)
      fail(line_.substr(zero), "a zero byte; a recording is plain text in UTF-8");
    return true;
  }

  /// `what` is wrong where `piece` begins, a piece of the current line.
  [[noreturn]] void fail(std::string_view piece, std::string_view what) const {
    throw FileError({file_, line_number_, column_of(piece)}, what);
  }

  std::size_t column_of(std::string_view piece) const {
    return characters(line_.substr(0, static_cast<std::size_t>(piece.data() - line_.data()))) + 1;
  }

  // -------------------------------------------------------------- header

  void read_header() {
    RunKeyReader run_key_reader(file_, recording_.facts, convention_, warnings_);
    while (next_line()) {
      if (trimmed(line_).empty()) continue;
      if (!trimmed(line_).starts_with('#')) return read_names();
      const auto after = line_.substr(line_.find('#') + 1);
      run_key_reader.read(after, line_number_, column_of(after));
    }
    throw FileError({file_, std::max<std::size_t>(line_number_, 1), 1}, "no header row");
  }

  void read_names() {
    header_line_ = line_number_;
    const auto cells = cells_of(line_);
    if (cells.size() > most_columns)
      fail(line_, fmt::format("{} columns; recordings of up to {} are read", cells.size(), most_columns));
    if (std::ranges::all_of(cells, [](auto cell) { return number_in(cell).has_value(); }))
      fail(line_, "no header row above the numbers; a line that starts with # is not one");
    for (const auto cell : cells) add_column(cell);
    require_columns();
  }

  void add_column(std::string_view cell) {
    const auto name = name_in(cell);
    if (name.empty()) fail(cell, "a column has no name");
    if (found(name)) fail(cell, fmt::format("column {} appears twice", shown(name)));
    auto known = column_named(name);
    if (known && known->channel == Channel::delta && convention_.rudder_is_order) known->channel = Channel::delta_order;
    if (const auto* rival = known ? source_of(known->channel) : nullptr)
      fail(cell, fmt::format("{} and {} both give the same quantity", rival->name, name));
    columns_.push_back({.name = name, .place = column_of(cell), .known = known});
  }

  bool found(std::string_view name) const {
    return std::ranges::find(columns_, name, &Reading::name) != columns_.end();
  }

  /// The column that tells the channel, if there is one.
  const Reading* source_of(Channel channel) const {
    const auto source =
        std::ranges::find_if(columns_, [&](const Reading& c) { return c.known && c.known->channel == channel; });
    return source == columns_.end() ? nullptr : &*source;
  }

  void require_columns() const {
    require_one_of({"time_s"}, "no column time_s");
    require_one_of({"psi_rad", "psi_deg"}, "no heading column (psi_rad or psi_deg)");
    require_one_of({"delta_rad", "delta_deg", "delta_order_rad", "delta_order_deg"},
                   "no rudder column (delta_rad, delta_deg, delta_order_rad or delta_order_deg)");
    if (found("lat_deg") != found("lon_deg")) fail(line_, "lat_deg and lon_deg must come together");
    if (found("lat_deg") && (source_of(Channel::x) || source_of(Channel::y)))
      fail(line_, "x_m, y_m and lat_deg, lon_deg both give the position");
#ifndef SWAYAW_GEOGRAPHICLIB
    if (found("lat_deg"))
      fail(line_, "lat_deg and lon_deg need a swayaw built with GeographicLib; or give x_m and y_m");
#endif
  }

  void require_one_of(std::initializer_list<std::string_view> names, std::string_view refusal) const {
    if (std::ranges::any_of(names, [&](auto name) { return found(name); })) return;
    const auto meant = [&](const Reading& c) { return std::ranges::count(names, same_but_for_capitals(c.name)) > 0; };
    if (columns_.size() == 1) fail(line_, fmt::format("{}{}", refusal, separator_hint()));
    const auto odd = std::ranges::find_if(columns_, meant);
    if (odd == columns_.end()) fail(line_, refusal);
    throw FileError({file_, line_number_, odd->place},
                    fmt::format("{}; is {} meant by {}?", refusal, same_but_for_capitals(odd->name), odd->name));
  }

  const Reading* rudder_source() const {
    const auto* actual = source_of(Channel::delta);
    return actual ? actual : source_of(Channel::delta_order);
  }

  /// What a line that falls into too few cells may be separated by.
  std::string_view separator_hint() const {
    if (line_.find(';') != std::string_view::npos)
      return "; is the file separated by semicolons? Commas are needed, and decimal points";
    if (trimmed(line_).find('\t') != std::string_view::npos)
      return "; is the file separated by tabs? Commas are needed";
    return "";
  }

  // -------------------------------------------------------------- rows

  void read_rows() {
    make_room();
    while (next_line())
      if (!trimmed(line_).empty()) read_row(cells_of(line_));
    if (samples_ == 0) throw FileError({file_, header_line_ + 1, 1}, "no samples below the header row");
  }

  /// For as many rows as there are lines, a row being a separator or an end of line for each column at least: columns
  /// that grow as they are read take up to three times the memory.
  void make_room() {
    const auto lines = static_cast<std::size_t>(std::ranges::count(rest_, '\n')) + 1;
    const auto rows = std::min(lines, rest_.size() / columns_.size() + 1);
    for (auto& column : columns_)
      if (column.is_understood()) column.values.reserve(rows);
      else column.cells.reserve(rows);
  }

  void read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != columns_.size()) fail_with_count(cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns_[i].is_understood()) columns_[i].values.push_back(value_in(unquoted(cells[i]), columns_[i]));
      else columns_[i].cells.emplace_back(cells[i]);
    }
    ++samples_;
  }

  [[noreturn]] void fail_with_count(const std::vector<std::string_view>& cells) const {
    const bool too_many = cells.size() > columns_.size();
    const auto hint = too_many ? "; are there decimal commas? Decimal points are needed" : separator_hint();
    fail(too_many ? cells[columns_.size()] : cells.back(),
         fmt::format("{} cell{}, but the header row has {}{}", cells.size(), cells.size() == 1 ? "" : "s",
                     columns_.size(), hint));
  }

  double value_in(std::string_view cell, const Reading& column) const {
    const bool is_time = column.name == "time_s";
    if (is_missing(cell)) {
      if (is_time) fail(cell, "time_s is missing");
      return missing;
    }
    const auto number = number_in(cell);
    const double value = number.value_or(missing) * (column.known ? column.known->si : 1.0);
    if (!std::isfinite(value)) fail_without_number(cell, column.name);
    if (is_time && !column.values.empty() && value <= column.values.back())
      fail(cell, fmt::format("time_s must increase, got {} after {}", value, column.values.back()));
    if (column.name == "lat_deg" && std::abs(value) > 90.0)
      fail(cell, fmt::format("lat_deg must lie between -90 and 90, got {}", value));
    if (column.name == "lon_deg" && std::abs(value) > 360.0)
      fail(cell, fmt::format("lon_deg must lie between -360 and 360, got {}", value));
    return value;
  }

  [[noreturn]] void fail_without_number(std::string_view cell, std::string_view column) const {
    const bool comma = cell.find(',') != std::string_view::npos;
    const bool first_row = samples_ == 0;
    const auto hint = comma       ? "; a decimal point is needed"
                      : first_row ? "; units belong in the column names, not in a row of their own"
                                  : "";
    fail(cell, fmt::format("\"{}\" in column {} is not a number{}", shown(cell), column, hint));
  }

  // -------------------------------------------------------------- to midship, SI, inside signs

  void fill_recording() {
    recording_.name = printable(file_.filename().string());
    for (auto& column : columns_) store(column);
    require_samples();
    project_position();
    unwrap_heading();
    if (rudder_positive_) convention_.rudder_sign = rudder_sign(*rudder_positive_);
    for (const Channel rudder : {Channel::delta, Channel::delta_order})
      for (double& angle : recording_.channels[index_of(rudder)]) angle *= convention_.rudder_sign;
    if (convention_.reference_x != 0.0) move_to_midship();
    if (convention_.ordered_rev) take_ordered_rev(*convention_.ordered_rev);
  }

  /// The shaft turns as it was ordered, unless a column says how it did.
  void take_ordered_rev(double rev) {
    if (recording_.has(Channel::rev)) recording_.facts.remarks.push_back({"ordered_rev_s", fmt::format("{}", rev)});
    else std::ranges::fill(recording_.fill(Channel::rev), rev);
  }

  void store(Reading& column) {
    if (column.name == "time_s") recording_.time = std::move(column.values);
    else if (column.known) recording_.channels[index_of(column.known->channel)] = std::move(column.values);
    else if (column.name == "lat_deg") latitude_ = std::move(column.values);
    else if (column.name == "lon_deg") longitude_ = std::move(column.values);
    else keep_unknown(column);
  }

  void keep_unknown(Reading& column) {
    const auto similar = same_but_for_capitals(column.name);
    const auto hint = similar.empty() ? std::string{} : fmt::format("; is {} meant?", similar);
    if (std::ranges::count(convention_.extra_columns, column.name) == 0)
      warnings_.push_back(
          fmt::format("{}: column {} is not understood; kept as it is{}", recording_.name, shown(column.name), hint));
    recording_.extra.push_back({column.name, std::move(column.cells)});
  }

  void require_samples() const {
    const bool rudder = recording_.has(Channel::delta) || recording_.has(Channel::delta_order);
    if (!recording_.has(Channel::psi))
      throw FileError({file_, header_line_, source_of(Channel::psi)->place}, "every heading sample is missing");
    if (!rudder) throw FileError({file_, header_line_, rudder_source()->place}, "every rudder sample is missing");
  }

  /// Latitude and longitude to metres north and east of the first fix.
  void project_position() {
#ifdef SWAYAW_GEOGRAPHICLIB
    if (latitude_.empty()) return;
    const auto x = recording_.fill(Channel::x), y = recording_.fill(Channel::y);
    std::optional<GeographicLib::LocalCartesian> plane;
    for (std::size_t i = 0; i < latitude_.size(); ++i) {
      if (std::isnan(latitude_[i]) || std::isnan(longitude_[i])) continue;
      if (!plane) plane.emplace(latitude_[i], longitude_[i]);
      double up = 0.0;
      plane->Forward(latitude_[i], longitude_[i], 0.0, y[i], x[i], up);
    }
#endif
  }

  /// A step of half a turn at most stays as it is, to the last bit.
  void unwrap_heading() {
    constexpr double half_turn = pi + 1e-9;
    std::optional<double> previous;
    for (double& psi : recording_.channels[index_of(Channel::psi)]) {
      if (std::isnan(psi)) continue;
      if (previous && std::abs(psi - *previous) > half_turn) psi = unwrapped(psi, *previous);
      previous = psi;
    }
  }

  /// x − l cos(psi), y − l sin(psi), v − l r
  void move_to_midship() {
    const double l = convention_.reference_x;
    const Interpolant heading(recording_, Channel::psi);
    const auto yaw_rate =
        recording_.has(Channel::r) ? std::optional<Interpolant>(std::in_place, recording_, Channel::r) : std::nullopt;
    for (std::size_t i = 0; i < recording_.samples(); ++i) {
      const double psi = heading(recording_.time[i]);
      const double r = yaw_rate ? (*yaw_rate)(recording_.time[i]) : turning_rate(heading, i);
      shift(Channel::x, i, -l * std::cos(psi));
      shift(Channel::y, i, -l * std::sin(psi));
      shift(Channel::v, i, -l * r);
      shift(Channel::v_ground, i, -l * r);
      shift_course(i, l * r * std::sin(psi), -l * r * std::cos(psi));
    }
  }

  void shift(Channel channel, std::size_t i, double by) {
    if (auto& values = recording_.channels[index_of(channel)]; !values.empty()) values[i] += by;
  }

  /// Speed and course over ground after a change of velocity; one without the other stays as it is.
  void shift_course(std::size_t i, double north, double east) {
    auto& speed = recording_.channels[index_of(Channel::speed_over_ground)];
    auto& course = recording_.channels[index_of(Channel::course_over_ground)];
    if (speed.empty() || course.empty() || std::isnan(speed[i]) || std::isnan(course[i])) return;
    north += speed[i] * std::cos(course[i]);
    east += speed[i] * std::sin(course[i]);
    speed[i] = std::hypot(north, east);
    course[i] = unwrapped(std::atan2(east, north), course[i]);
  }

  double turning_rate(const Interpolant& heading, std::size_t i) const {
    const double before = recording_.time[i > 0 ? i - 1 : 0];
    const double after = recording_.time[std::min(i + 1, recording_.samples() - 1)];
    return after > before ? (heading(after) - heading(before)) / (after - before) : 0.0;
  }

  std::string_view rest_;
  std::filesystem::path file_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  std::size_t header_line_ = 0;
  std::size_t samples_ = 0;
  Convention convention_;
  std::optional<Side> rudder_positive_;  ///< said by the caller
  std::vector<Reading> columns_;
  std::vector<double> latitude_;
  std::vector<double> longitude_;
  Recording recording_;
  std::vector<std::string> warnings_;
};

// ---------------------------------------------------------------- writing

using Text = fmt::memory_buffer;

void write_facts(Text& out, const RunFacts& facts) {
  auto to = fmt::appender(out);
  fmt::format_to(to, "# rudder_positive = \"port\"\n");
  if (!facts.manoeuvre.empty()) fmt::format_to(to, "# manoeuvre = {}\n", in_quotes(facts.manoeuvre));
  if (facts.execute) fmt::format_to(to, "# execute_s = {}\n", *facts.execute);
  if (facts.water_depth) fmt::format_to(to, "# water_depth_m = {}\n", *facts.water_depth);
  for (const auto& remark : facts.remarks) fmt::format_to(to, "# {} = {}\n", remark.key, remark.value);
}

std::vector<Channel> recorded_channels(const Recording& recording) {
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (const auto channel = static_cast<Channel>(i); !recording[channel].empty()) channels.push_back(channel);
  return channels;
}

void write_header(Text& out, const Recording& recording) {
  auto to = fmt::appender(out);
  fmt::format_to(to, "time_s");
  for (const Channel channel : recorded_channels(recording)) fmt::format_to(to, ",{}", column_name(channel));
  for (const auto& extra : recording.extra) fmt::format_to(to, ",{}", cell_naming(extra.name));
  out.push_back('\n');
}

void write_rows(Text& out, const Recording& recording) {
  auto to = fmt::appender(out);
  const auto channels = recorded_channels(recording);
  for (std::size_t i = 0; i < recording.samples(); ++i) {
    fmt::format_to(to, "{}", recording.time[i]);
    for (const Channel channel : channels) {
      out.push_back(',');
      if (const double value = recording[channel][i]; !std::isnan(value)) fmt::format_to(to, "{}", value);
    }
    for (const auto& extra : recording.extra) fmt::format_to(to, ",{}", extra.cells[i]);
    out.push_back('\n');
  }
}

}  // namespace

RecordingFile parse_recording(std::string_view text, const std::filesystem::path& name,
                              std::optional<Side> rudder_positive) {
  return RecordingParser(text, name, rudder_positive).parse();
}

RecordingFile read_recording(const std::filesystem::path& file, std::optional<Side> rudder_positive) {
  return is_mat(file) ? read_recording_mat(file, rudder_positive)
                      : parse_recording(read_text(file), file, rudder_positive);
}

std::string recording_text(const Recording& recording) {
  Text out;
  write_facts(out, recording.facts);
  write_header(out, recording);
  write_rows(out, recording);
  return fmt::to_string(out);
}

void write_recording(const Recording& recording, const std::filesystem::path& file) {
  if (is_mat(file)) write_mat(file, mat_of(recording));
  else write_text(file, recording_text(recording));
}

}  // namespace swayaw::core

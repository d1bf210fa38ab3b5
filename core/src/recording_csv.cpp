#include "swayaw/core/recording_csv.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- text

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes the text before the next separator off the front of `rest`.
std::string_view take(std::string_view& rest, char separator) {
  const auto end = rest.find(separator);
  const auto piece = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return piece;
}

struct Cell {
  std::string_view text;
  std::size_t column;  ///< character in the line, from 1
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  const char* start = line.data();
  bool more = true;
  while (more) {
    more = line.find(',') != std::string_view::npos;
    const auto piece = take(line, ',');
    const auto text = trimmed(piece);
    const char* place = text.empty() ? piece.data() : text.data();
    cells.push_back({text, static_cast<std::size_t>(place - start) + 1});
  }
  return cells;
}

bool is_missing(std::string_view text) {
  return text.empty() || text == "nan" || text == "NaN" || text == "NAN";
}

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// ---------------------------------------------------------------- run keys

/// Facts of the run that change how samples are read.
struct Convention {
  double rudder_sign = 1.0;  ///< inside sign of a recorded positive angle
  double reference_x = 0.0;  ///< reported point forward of midship [m]
};

class RunKeyReader {
 public:
  RunKeyReader(const FilePlace& place, RunFacts& facts, Convention& convention)
      : place_(place), facts_(facts), convention_(convention) {}

  /// Reads `key = value`; a line without '=' is a remark to human readers.
  void read(std::string_view line) {
    if (line.find('=') == std::string_view::npos) return;
    try {
      for (auto&& [key, value] : toml::parse(line)) take_key(key.str(), value);
    } catch (const toml::parse_error& error) {
      throw FileError(at(error.source().begin.column), error.description());
    }
  }

 private:
  void take_key(std::string_view key, const toml::node& value) {
    if (key == "rudder_positive") convention_.rudder_sign = rudder_sign_of(value);
    else if (key == "reference_x_m") convention_.reference_x = number(key, value);
    else if (key == "water_depth_m") facts_.water_depth = positive_number(key, value);
    else if (key == "execute_s") facts_.execute = number(key, value);
    else if (key == "manoeuvre") facts_.manoeuvre = text(key, value);
    else facts_.remarks.push_back({std::string(key), toml_text(value)});
  }

  double rudder_sign_of(const toml::node& value) {
    const auto side = text("rudder_positive", value);
    if (side == "port") return 1.0;
    if (side == "starboard") return -1.0;
    throw FileError(at(value), fmt::format("rudder_positive must be \"port\" or \"starboard\", got \"{}\"", side));
  }

  double number(std::string_view key, const toml::node& value) {
    const auto found = value.value<double>();
    if (value.is_number() && std::isfinite(*found)) return *found;
    throw FileError(at(value), fmt::format("{} must be a number", key));
  }

  double positive_number(std::string_view key, const toml::node& value) {
    const double found = number(key, value);
    if (found > 0.0) return found;
    throw FileError(at(value), fmt::format("{} must be positive, got {}", key, found));
  }

  std::string text(std::string_view key, const toml::node& value) {
    if (const auto found = value.value_exact<std::string>()) return *found;
    throw FileError(at(value), fmt::format("{} must be a text in quotes", key));
  }

  static std::string toml_text(const toml::node& value) {
    std::ostringstream out;
    value.visit([&](auto&& node) { out << node; });
    return std::move(out).str();
  }

  FilePlace at(std::size_t column) const {
    return {place_.file, place_.line, place_.column + column - 1};
  }
  FilePlace at(const toml::node& value) const { return at(value.source().begin.column); }

  FilePlace place_;  ///< first character after '#'
  RunFacts& facts_;
  Convention& convention_;
};

// ---------------------------------------------------------------- columns

/// A column while it is read.
struct Reading {
  std::string_view name;
  double si = 1.0;
  std::vector<double> values;
};

class RecordingParser {
 public:
  RecordingParser(std::string_view text, const std::filesystem::path& file) : rest_(text), file_(file) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  RecordingFile parse() {
    read_header();
    read_rows();
    fill_recording();
    return {std::move(recording_), std::move(warnings_)};
  }

 private:
  bool next_line(std::string_view& line) {
    if (rest_.empty()) return false;
    line = take(rest_, '\n');
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++line_number_;
    return true;
  }

  void read_header() {
    for (std::string_view line; next_line(line);) {
      if (trimmed(line).empty()) continue;
      if (!trimmed(line).starts_with('#')) return read_names(line);
      const auto hash = line.find('#');
      RunKeyReader({file_, line_number_, hash + 2}, recording_.facts, convention_).read(line.substr(hash + 1));
    }
    throw FileError({file_, std::max<std::size_t>(line_number_, 1), 1}, "no header row");
  }

  void read_names(std::string_view line) {
    header_line_ = line_number_;
    for (const auto& cell : cells_of(line)) {
      auto name = cell.text;
      if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
      if (name.empty()) fail(cell.column, "a column has no name");
      if (std::ranges::find(columns_, name, &Reading::name) != columns_.end())
        fail(cell.column, fmt::format("column {} appears twice", name));
      columns_.push_back({.name = name});
      if (const auto column = column_named(name)) claim(*column, cell.column);
    }
    require_columns();
  }

  /// Notes that a channel comes from this column, and refuses a second source for it.
  void claim(const Column& column, std::size_t place) {
    columns_.back().si = column.si;
    auto& source = source_[index_of(column.channel)];
    if (!source.empty()) fail(place, fmt::format("{} and {} both give the same quantity", source, column.name));
    source = column.name;
  }

  bool found(std::string_view name) const {
    return std::ranges::find(columns_, name, &Reading::name) != columns_.end();
  }
  bool found(Channel channel) const { return !source_[index_of(channel)].empty(); }

  void require_columns() {
    const bool heading = found(Channel::psi);
    const bool rudder = found(Channel::delta) || found(Channel::delta_order);
    if (!found("time_s")) fail(1, "no column time_s");
    if (!heading) fail(1, "no heading column (psi_rad or psi_deg)");
    if (!rudder) fail(1, "no rudder column (delta_rad, delta_deg, delta_order_rad or delta_order_deg)");
    if (found("lat_deg") != found("lon_deg")) fail(1, "lat_deg and lon_deg must come together");
    if (found(Channel::x) != found(Channel::y)) fail(1, "x_m and y_m must come together");
    if (found("lat_deg") && found(Channel::x)) fail(1, "x_m, y_m and lat_deg, lon_deg both give the position");
  }

  void read_rows() {
    for (std::string_view line; next_line(line);)
      if (!trimmed(line).empty()) read_row(cells_of(line));
    if (columns_.front().values.empty()) throw FileError({file_, header_line_ + 1, 1}, "no samples below the header row");
  }

  void read_row(const std::vector<Cell>& cells) {
    if (cells.size() != columns_.size())
      fail(cells.back().column, fmt::format("{} cells, but the header row has {}", cells.size(), columns_.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) columns_[i].values.push_back(value_in(cells[i], columns_[i]));
  }

  double value_in(const Cell& cell, const Reading& column) {
    const bool is_time = column.name == "time_s";
    if (is_missing(cell.text)) {
      if (is_time) fail(cell.column, "time_s is missing");
      return missing;
    }
    const auto value = number_in(cell.text);
    if (!value) fail(cell.column, fmt::format("\"{}\" in column {} is not a number", cell.text, column.name));
    if (is_time && !column.values.empty() && *value <= column.values.back())
      fail(cell.column, fmt::format("time_s must increase, got {} after {}", *value, column.values.back()));
    return *value * column.si;
  }

  [[noreturn]] void fail(std::size_t column, std::string_view what) const {
    throw FileError({file_, line_number_, column}, what);
  }

  // -------------------------------------------------------------- to midship, SI, inside signs

  void fill_recording() {
    recording_.name = file_.filename().string();
    for (auto& column : columns_) store(column);
    project_position();
    unwrap_heading();
    for (const Channel rudder : {Channel::delta, Channel::delta_order})
      for (double& angle : recording_.channels[index_of(rudder)]) angle *= convention_.rudder_sign;
    if (convention_.reference_x != 0.0) move_to_midship();
    require_samples();
  }

  void store(Reading& column) {
    const auto known = column_named(column.name);
    if (column.name == "time_s") recording_.time = std::move(column.values);
    else if (known) recording_.channels[index_of(known->channel)] = std::move(column.values);
    else if (column.name == "lat_deg") latitude_ = std::move(column.values);
    else if (column.name == "lon_deg") longitude_ = std::move(column.values);
    else keep_unknown(column);
  }

  void keep_unknown(Reading& column) {
    warnings_.push_back(fmt::format("{}: column {} is not understood; kept as it is", recording_.name, column.name));
    recording_.extra.push_back({std::string(column.name), std::move(column.values)});
  }

  /// Latitude and longitude to metres north and east of the first fix.
  void project_position() {
    std::optional<GeographicLib::LocalCartesian> plane;
    for (std::size_t i = 0; i < latitude_.size(); ++i) {
      auto x = recording_.fill(Channel::x), y = recording_.fill(Channel::y);
      if (std::isnan(latitude_[i]) || std::isnan(longitude_[i])) continue;
      if (!(std::abs(latitude_[i]) <= 90.0))
        throw FileError({.file = file_}, fmt::format("latitude {} is beyond 90 deg", latitude_[i]));
      if (!plane) plane.emplace(latitude_[i], longitude_[i]);
      double up = 0.0;
      plane->Forward(latitude_[i], longitude_[i], 0.0, y[i], x[i], up);
    }
  }

  void unwrap_heading() {
    std::optional<double> previous;
    for (double& psi : recording_.channels[index_of(Channel::psi)]) {
      if (std::isnan(psi)) continue;
      if (previous) psi = unwrapped(psi, *previous);
      previous = psi;
    }
  }

  /// x − l cos(psi), y − l sin(psi), v − l r
  void move_to_midship() {
    const double l = convention_.reference_x;
    const Interpolant heading(recording_, Channel::psi);
    for (std::size_t i = 0; i < recording_.samples(); ++i) {
      const double psi = heading(recording_.time[i]);
      shift(Channel::x, i, -l * std::cos(psi));
      shift(Channel::y, i, -l * std::sin(psi));
      const double r = found(Channel::r) ? recording_[Channel::r][i] : turning_rate(heading, i);
      shift(Channel::v, i, -l * r);
      shift(Channel::v_ground, i, -l * r);
    }
  }

  void shift(Channel channel, std::size_t i, double by) {
    if (auto& values = recording_.channels[index_of(channel)]; !values.empty()) values[i] += by;
  }

  double turning_rate(const Interpolant& heading, std::size_t i) const {
    const double before = recording_.time[i > 0 ? i - 1 : 0];
    const double after = recording_.time[std::min(i + 1, recording_.samples() - 1)];
    return after > before ? (heading(after) - heading(before)) / (after - before) : 0.0;
  }

  void require_samples() {
    const bool rudder = recording_.has(Channel::delta) || recording_.has(Channel::delta_order);
    if (!recording_.has(Channel::psi)) throw FileError({file_, header_line_, 1}, "every heading sample is missing");
    if (!rudder) throw FileError({file_, header_line_, 1}, "every rudder sample is missing");
  }

  std::string_view rest_;
  std::filesystem::path file_;
  std::size_t line_number_ = 0;
  std::size_t header_line_ = 0;
  Convention convention_;
  std::vector<Reading> columns_;
  std::array<std::string_view, channel_count> source_;
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
  if (!facts.manoeuvre.empty()) {
    std::ostringstream quoted;
    quoted << toml::value<std::string>(facts.manoeuvre);
    fmt::format_to(to, "# manoeuvre = {}\n", std::move(quoted).str());
  }
  if (facts.execute) fmt::format_to(to, "# execute_s = {}\n", *facts.execute);
  if (facts.water_depth) fmt::format_to(to, "# water_depth_m = {}\n", *facts.water_depth);
  for (const auto& remark : facts.remarks) fmt::format_to(to, "# {} = {}\n", remark.key, remark.value);
}

struct OutputColumn {
  std::string_view name;
  std::span<const double> values;
};

std::vector<OutputColumn> output_columns(const Recording& recording) {
  std::vector<OutputColumn> columns{{"time_s", recording.time}};
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    if (!recording[channel].empty()) columns.push_back({column_name(channel), recording[channel]});
  }
  for (const auto& extra : recording.extra) columns.push_back({extra.name, extra.values});
  return columns;
}

}  // namespace

RecordingFile parse_recording(std::string_view text, const std::filesystem::path& name) {
  return RecordingParser(text, name).parse();
}

RecordingFile read_recording(const std::filesystem::path& file) {
  return parse_recording(read_text(file), file);
}

std::string recording_text(const Recording& recording) {
  Text out;
  auto to = fmt::appender(out);
  write_facts(out, recording.facts);
  const auto columns = output_columns(recording);
  for (const auto& column : columns) fmt::format_to(to, "{}{}", column.name, &column == &columns.back() ? '\n' : ',');
  for (std::size_t i = 0; i < recording.samples(); ++i) {
    for (const auto& column : columns) {
      if (!std::isnan(column.values[i])) fmt::format_to(to, "{}", column.values[i]);
      out.push_back(&column == &columns.back() ? '\n' : ',');
    }
  }
  return fmt::to_string(out);
}

void write_recording(const Recording& recording, const std::filesystem::path& file) {
  write_text(file, recording_text(recording));
}

}  // namespace swayaw

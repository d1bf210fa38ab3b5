#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "nmea_log.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw::inline core {
using namespace detail;
namespace {

/// A column of the recording to be.
struct TimedColumn {
  std::string name;
  std::vector<std::pair<double, double>> samples = {};  ///< time [s], value
};

// ---------------------------------------------------------------- which instrument is taken

/// How often the samples jump: noise of the first number, directions taken the short way round.
double noise_of(const NmeaSeries& series) {
  std::vector<double> values;
  const bool bearing = series.quantity == NmeaQuantity::heading;
  for (const auto& sample : series.samples) {
    const bool turn = bearing && !values.empty();
    values.push_back(turn ? degrees(unwrapped(radians(sample.first), radians(values.back()))) : sample.first);
  }
  return white_noise_of(values);
}

/// The more direct one of those with at least a tenth of the samples; then the more frequent; of those that are
/// equally frequent within a tenth, the steadier.
bool is_better(const NmeaSeries& a, const NmeaSeries& b) {
  const auto count = [](const NmeaSeries& s) { return static_cast<double>(s.samples.size()); };
  if (count(a) < 0.1 * count(b)) return false;
  if (count(b) < 0.1 * count(a)) return true;
  if (a.directness != b.directness) return a.directness < b.directness;
  if (count(a) < 0.9 * count(b)) return false;
  if (count(b) < 0.9 * count(a)) return true;
  return noise_of(a) < noise_of(b);
}

class LogImport {
 public:
  LogImport(const std::vector<std::filesystem::path>& files, const ImportOptions& options) : files_(files) {
    if (!options.column_map.empty())
      result_.notes.emplace_back("the column map is not used: sentences say what they hold");
  }

  Import import() {
    for (const auto& file : files_) read(file);
    if (!dated_) result_.notes.emplace_back("no date is known: start_utc is not written");
    for (auto& series : series_) std::ranges::stable_sort(series.samples, {}, &NmeaSample::time);
    for (std::size_t i = 0; i < quantity_count; ++i) choose(static_cast<NmeaQuantity>(i));
    make_columns();
    require_columns();
    tell_counts();
    write();
    return std::move(result_);
  }

 private:
  void read(const std::filesystem::path& file) {
    auto log = read_nmea_log(file, end_);
    if (&file != &files_.front() && log.dated != dated_)
      throw FileError({file, 1, 1}, "of the files, some tell a date (RMC, ZDA) and some do not; import them apart");
    if (!log.dated && end_ && log.begin < *end_)
      throw FileError({file, 1, 1},
                      "its times begin before those of the file before end, and no date is told; import it apart");
    dated_ = log.dated;
    end_ = log.end;
    for (const auto& note : log.clock_notes) add_note(files_.size() > 1 ? name_of(file) + ": " + note : note);
    for (auto& series : log.series) join(std::move(series));
    tell_dropped(file, log.counts);
    sentences_ += log.counts.sentences;
    for (const auto& [name, count] : log.counts.not_used) not_used_[name] += count;
  }

  static std::string name_of(const std::filesystem::path& file) { return file.filename().string(); }

  void add_note(std::string note) { result_.notes.push_back(std::move(note)); }

  void tell_dropped(const std::filesystem::path& file, const NmeaCounts& counts) {
    const auto tell = [&](const NmeaCounts::Dropped& dropped, std::string_view what) {
      if (dropped.count > 0)
        add_note(fmt::format("{}: {} {}, dropped; the first in line {}", name_of(file), dropped.count, what,
                             dropped.first_line));
    };
    tell(counts.wrong_checksum, "with a wrong checksum");
    tell(counts.cut, "without the checksum that others of their kind have");
    tell(counts.unreadable, "not readable");
    if (counts.lines_without > 0)
      add_note(fmt::format("{}: {} lines without a sentence", name_of(file), counts.lines_without));
    if (!counts.invalid.empty())
      add_note(fmt::format("{}: status invalid, dropped: {}", name_of(file), list_of(counts.invalid)));
    if (!counts.without_checksum.empty())
      add_note(fmt::format("{}: taken without a checksum, as none of their kind has one: {}", name_of(file),
                           list_of(counts.without_checksum)));
  }

  /// "GSV 20, VDM 3"
  static std::string list_of(const std::map<std::string, std::size_t>& counts) {
    std::string list;
    for (const auto& [name, count] : counts)
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", printable(name), count);
    return list;
  }

  static std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c == 0x7F; }, '?');
    return text;
  }

  /// The same instrument in several files.
  void join(NmeaSeries series) {
    if (series.samples.empty()) return;
    const auto same = [&](const NmeaSeries& s) {
      return s.quantity == series.quantity && s.directness == series.directness && s.which == series.which &&
             s.address == series.address;
    };
    const auto found = std::ranges::find_if(series_, same);
    if (found == series_.end()) return series_.push_back(std::move(series));
    found->samples.insert(found->samples.end(), series.samples.begin(), series.samples.end());
  }

  // -------------------------------------------------------------- choice

  static bool by_shaft(NmeaQuantity quantity) {
    return quantity == NmeaQuantity::shaft_speed || quantity == NmeaQuantity::pitch;
  }

  /// The best series of a quantity; the others are named. Shafts do not compete with each other.
  void choose(NmeaQuantity quantity) {
    auto& chosen = chosen_[index_of(quantity)];
    for (const auto& series : series_) {
      if (series.quantity != quantity) continue;
      const auto rival = std::ranges::find_if(
          chosen, [&](const NmeaSeries* other) { return !by_shaft(quantity) || other->which == series.which; });
      if (rival == chosen.end()) chosen.push_back(&series);
      else if (is_better(series, **rival)) leave_out(std::exchange(*rival, &series), series);
      else leave_out(&series, **rival);
    }
    std::ranges::sort(chosen, {}, [](const NmeaSeries* series) { return series->which; });
  }

  void leave_out(const NmeaSeries* series, const NmeaSeries& taken) {
    left_out_.push_back({label(*series), "", reason_against(*series, taken), series->samples.size()});
  }

  static std::string reason_against(const NmeaSeries& series, const NmeaSeries& taken) {
    const auto words = words_for(series.quantity).name;
    if (series.directness > taken.directness)
      return fmt::format("{} is taken from {}, which tells it more directly", words, taken.address);
    if (taken.samples.size() > series.samples.size() + series.samples.size() / 10)
      return fmt::format("{} is taken from {}, which tells it more often", words, taken.address);
    return fmt::format("{} is taken from {}, which tells it as often and as steadily", words, taken.address);
  }

  static std::string label(const NmeaSeries& series, std::string_view part = {}) {
    auto label = series.address;
    if (by_shaft(series.quantity)) label += fmt::format(" {}", series.which);
    return part.empty() ? label : fmt::format("{} {}", label, part);
  }

  const NmeaSeries* only(NmeaQuantity quantity) const {
    const auto& chosen = chosen_[index_of(quantity)];
    return chosen.empty() ? nullptr : chosen.front();
  }

  // -------------------------------------------------------------- columns

  void make_columns() {
    make_heading();
    make(NmeaQuantity::yaw_rate, "positive the bow turns to starboard");
    make_rudder(NmeaQuantity::rudder);
    make_rudder(NmeaQuantity::rudder_order);
    make(NmeaQuantity::log_speed, "forward speed of the log");
    make(NmeaQuantity::log_drift, "positive to starboard, where the log is");
    make(NmeaQuantity::ground_motion, "over ground, where the log is");
    make(NmeaQuantity::course, "over ground, where the antenna is");
    make(NmeaQuantity::position, "where the antenna is");
    make_shaft_speed();
    make_pitch();
    make_wind();
    make_depth();
    for (auto& column : left_out_) result_.columns.push_back(std::move(column));
  }

  void make_heading() {
    const auto* series = only(NmeaQuantity::heading);
    if (series == nullptr) return;
    switch (series->directness) {
      case Directness::direct: return make(NmeaQuantity::heading, "true heading");
      case Directness::corrected:
        return make(NmeaQuantity::heading, series->address.ends_with("VHW") ? "true heading of the log's sentence"
                                                                            : "magnetic heading with its variation");
      case Directness::magnetic:
        make(NmeaQuantity::heading, "magnetic heading, no variation is told");
        add_note("the heading is magnetic and its variation is not known; positions and wind are true");
    }
  }

  void make(NmeaQuantity quantity, std::string_view why) {
    if (const auto* series = only(quantity)) make(*series, words_for(quantity), why);
  }

  void make(const NmeaSeries& series, const QuantityWords& words, std::string_view why) {
    const auto part = [&](std::string_view name, std::string_view which, double NmeaSample::*value) {
      TimedColumn column{std::string(name)};
      for (const auto& sample : series.samples)
        if (!std::isnan(sample.*value)) column.samples.emplace_back(sample.time, sample.*value);
      if (column.samples.empty()) return;
      result_.columns.push_back({label(series, which), column.name, std::string(why), column.samples.size()});
      columns_.push_back(std::move(column));
    };
    part(words.first, words.parts_first, &NmeaSample::first);
    if (!words.second.empty()) part(words.second, words.parts_second, &NmeaSample::second);
  }

  /// (starboard + port)/2 of twin rudders; of one that is told, its own
  void make_rudder(NmeaQuantity quantity) {
    if (only(quantity) == nullptr) return;
    auto series = *only(quantity);
    leave_out_idle(series, &NmeaSample::second, &NmeaSample::first, "port");
    leave_out_idle(series, &NmeaSample::first, &NmeaSample::second, "starboard");
    TimedColumn column{std::string(words_for(quantity).first)};
    std::size_t starboard = 0, port = 0, both = 0;
    for (const auto& [time, s, p] : series.samples) {
      starboard += std::isnan(s) ? 0 : 1;
      port += std::isnan(p) ? 0 : 1;
      both += std::isnan(s + p) ? 0 : 1;
      column.samples.emplace_back(time, std::isnan(p) ? s : std::isnan(s) ? p : 0.5 * (s + p));
    }
    const bool twin = starboard > 0 && port > 0;
    const std::string why = twin ? "mean of twin rudders, positive turns to starboard" : "positive turns to starboard";
    if (starboard > 0) result_.columns.push_back({label(series, twin ? "starboard" : ""), column.name, why, starboard});
    if (port > 0) result_.columns.push_back({label(series, "port"), column.name, why, port});
    if (const auto alone = column.samples.size() - both; twin && alone > 0)
      add_note(
          fmt::format("{}: {} times one of the twin rudders is told alone and stands for both", series.address, alone));
    columns_.push_back(std::move(column));
  }

  /// A field that stays at one number while the other rudder moves is no rudder.
  void leave_out_idle(NmeaSeries& series, double NmeaSample::*field, double NmeaSample::*other, std::string_view name) {
    const auto range_of = [&](double NmeaSample::*value) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const auto& sample : series.samples)
        low = std::fmin(low, sample.*value), high = std::fmax(high, sample.*value);
      return high - low;
    };
    constexpr double moves = 2.0;  // [deg]
    if (!(range_of(field) == 0.0 && range_of(other) >= moves)) return;
    result_.columns.push_back(
        {label(series, name), "", "always at one number while the other rudder moves", series.samples.size()});
    for (auto& sample : series.samples) sample.*field = missing;
    std::erase_if(series.samples,
                  [](const auto& sample) { return std::isnan(sample.first) && std::isnan(sample.second); });
  }

  // -------------------------------------------------------------- shafts

  /// The mean over the shafts at the times of the first, each positive as it mostly turns.
  void make_shaft_speed() {
    const auto& shafts = chosen_[index_of(NmeaQuantity::shaft_speed)];
    if (shafts.empty()) return;
    TimedColumn column{std::string(words_for(NmeaQuantity::shaft_speed).first)};
    for (const auto& sample : shafts.front()->samples) column.samples.emplace_back(sample.time, 0.0);
    for (const auto* shaft : shafts) add_shaft(*shaft, 1.0 / static_cast<double>(shafts.size()), column);
    columns_.push_back(std::move(column));
  }

  void add_shaft(const NmeaSeries& shaft, double share, TimedColumn& column) {
    const auto negative = std::ranges::count_if(shaft.samples, [](const auto& s) { return s.first < 0.0; });
    const bool reversed = 2 * negative > std::ssize(shaft.samples);
    const double sign = reversed ? -1.0 : 1.0;
    std::size_t k = 0;
    for (auto& sample : column.samples) {
      const auto further = [&](std::size_t i) { return std::abs(shaft.samples[i].time - sample.first); };
      while (k + 1 < shaft.samples.size() && further(k + 1) <= further(k)) ++k;
      sample.second += share * sign * shaft.samples[k].first;
    }
    const auto what =
        shaft.directness == Directness::direct ? "shaft speed" : "engine speed: with a gear, not the shaft's";
    result_.columns.push_back({label(shaft), column.name,
                               fmt::format("{}{}{}", what, share < 1.0 ? "; mean of all" : "",
                                           reversed ? "; sign changed, as it turns negative most of the time" : ""),
                               shaft.samples.size()});
  }

  /// Kept where it changes: then the thrust does not follow from the shaft speed alone.
  void make_pitch() {
    for (const auto* series : chosen_[index_of(NmeaQuantity::pitch)]) {
      const auto [low, high] = std::ranges::minmax(series->samples, {}, &NmeaSample::first);
      if (low.first == high.first) continue;
      auto words = words_for(NmeaQuantity::pitch);
      const auto name = fmt::format("{}{}", words.first, series->which > 0 ? fmt::format("_{}", series->which) : "");
      words.first = name;
      make(*series, words, "propeller pitch, kept as it is");
      result_.columns.back().taken_for.clear();
    }
  }

  void make_depth() {
    const auto* series = only(NmeaQuantity::depth);
    const bool surface = series != nullptr && series->directness == Directness::direct;
    make(NmeaQuantity::depth, surface ? "from the water line" : "below the transducer, as its draught is not told");
  }

  // -------------------------------------------------------------- wind

  /// The true wind as told; from the bow, with the heading; apparent, with heading and motion over ground.
  void make_wind() {
    const auto *north = only(NmeaQuantity::true_wind), *bow = only(NmeaQuantity::bow_wind),
               *apparent = only(NmeaQuantity::apparent_wind);
    const auto* taken = north ? north : bow ? bow : apparent;
    if (taken == nullptr) return;
    for (const auto* other : {bow, apparent})
      if (other != nullptr && other != taken)
        left_out_.push_back({label(*other) + " " + std::string(words_for(other->quantity).name), "",
                             fmt::format("the wind is taken from {}", taken->address), other->samples.size()});
    if (taken == north) return make(NmeaQuantity::true_wind, "direction it comes from");
    if (taken == bow)
      return make(turned_to_north(*bow), words_for(NmeaQuantity::bow_wind), "true wind, with the heading");
    auto computed = true_wind_of(*apparent);
    if (!computed.samples.empty())
      return make(computed, words_for(NmeaQuantity::true_wind),
                  "true wind over ground, computed from the apparent one, heading, course and speed over ground");
    keep_apparent_wind(*apparent);
  }

  void keep_apparent_wind(const NmeaSeries& apparent) {
    auto words = words_for(NmeaQuantity::apparent_wind);
    words.first = "apparent_wind_speed_kn";
    words.second = "apparent_wind_angle_deg";
    make(apparent, words,
         "apparent wind, kept as it is: without speed and course over ground the true one is not known");
    for (auto& column : result_.columns)
      if (column.taken_for.starts_with("apparent")) column.taken_for.clear();
  }

  /// A number of a series at a time, between its neighbours if they are near; directions the short way round.
  static double value_at(const NmeaSeries& series, double NmeaSample::*value, double time, bool direction) {
    constexpr double near = 5.0;  // [s], in which heading and speed of a ship are followed by a straight line
    const auto after = std::ranges::lower_bound(series.samples, time, {}, &NmeaSample::time);
    if (after == series.samples.end() || after == series.samples.begin()) {
      const auto& end = after == series.samples.end() ? series.samples.back() : *after;
      return std::abs(end.time - time) <= near ? end.*value : missing;
    }
    const auto &a = *(after - 1), &b = *after;
    if (b.time - a.time > 2.0 * near) return missing;
    const double step = direction ? std::remainder(b.*value - a.*value, 360.0) : b.*value - a.*value;
    return a.*value + step * (time - a.time) / (b.time - a.time);
  }

  double heading_at(double time) const {
    const auto* heading = only(NmeaQuantity::heading);
    return heading == nullptr ? missing : value_at(*heading, &NmeaSample::first, time, true);
  }

  NmeaSeries turned_to_north(const NmeaSeries& bow) const {
    NmeaSeries wind = bow;
    for (auto& sample : wind.samples)
      sample.second = 360.0 + std::remainder(sample.second + heading_at(sample.time) - 360.0, 360.0);
    for (auto& sample : wind.samples) sample.second = std::fmod(sample.second, 360.0);
    return wind;
  }

  /// The air over ground moves as it does past the ship, and with her:  w = −A (cos, sin)(psi + theta) + U (cos,
  /// sin)(chi); the wind comes from −w.
  NmeaSeries true_wind_of(const NmeaSeries& apparent) const {
    NmeaSeries wind{apparent.address, NmeaQuantity::true_wind, apparent.directness, 0};
    const auto* course = only(NmeaQuantity::course);
    if (course == nullptr) return wind;
    for (const auto& [time, A, theta] : apparent.samples) {
      const double U = value_at(*course, &NmeaSample::first, time, false);
      const double chi = radians(value_at(*course, &NmeaSample::second, time, true));
      const double from = radians(heading_at(time) + theta);
      const double north = A * std::cos(from) - U * std::cos(chi), east = A * std::sin(from) - U * std::sin(chi);
      if (std::isnan(north + east)) continue;
      wind.samples.push_back(
          {time, std::hypot(north, east), std::fmod(degrees(std::atan2(east, north)) + 360.0, 360.0)});
    }
    return wind;
  }

  // -------------------------------------------------------------- the recording file

  void require_columns() const {
    const auto has = [&](std::string_view name) { return std::ranges::count(columns_, name, &TimedColumn::name) > 0; };
    if (!has("psi_deg")) refuse("heading (HDT, THS, HDG, HDM or VHW)");
    if (!has("delta_deg") && !has("delta_order_deg")) refuse("rudder angle (RSA or ROR)");
  }

  [[noreturn]] void refuse(std::string_view lacking) const {
    std::set<std::string> found;
    for (const auto& series : series_) found.insert(series.address);
    throw FileError({files_.front(), 1, 1}, fmt::format("no sentence tells a {}; found are {}", lacking,
                                                        found.empty() ? "none that are understood"
                                                                      : fmt::format("{}", fmt::join(found, ", "))));
  }

  void tell_counts() {
    if (!not_used_.empty()) add_note("not used: " + list_of(not_used_));
    add_note(fmt::format("{} sentences in {} file{}", sentences_, files_.size(), files_.size() == 1 ? "" : "s"));
    add_note("positions and speeds are those of antenna and log; reference_x_m says where that is, if it is known");
  }

  /// A number of a row, before rows are known.
  struct Cell {
    double time;  ///< since the beginning, in whole milliseconds [s]
    std::uint32_t column;
    double value;
  };

  std::vector<Cell> cells_in_order(double begin) const {
    std::vector<Cell> cells;
    for (std::uint32_t k = 0; k < columns_.size(); ++k)
      for (const auto& [time, value] : columns_[k].samples)
        cells.push_back({std::round(1000.0 * (time - begin)) / 1000.0, k, value});
    std::ranges::stable_sort(cells, {}, &Cell::time);
    return cells;
  }

  double begin() const {
    double first = std::numeric_limits<double>::infinity();
    for (const auto& column : columns_) first = std::min(first, column.samples.front().first);
    return first;
  }

  void write() {
    const double zero = begin();
    const auto cells = cells_in_order(zero);
    fmt::memory_buffer out;
    write_head(out, zero);
    std::vector<double> row(columns_.size(), missing);
    double time = 0.0;
    std::size_t twice = 0;
    const auto flush = [&] {
      write_row(out, time, row);
      std::ranges::fill(row, missing);
    };
    for (const auto& cell : cells) {
      const bool filled = !std::isnan(row[cell.column]);
      if (filled && cell.time <= time) {
        ++twice;
        continue;
      }
      if (filled || cell.time - time > same_moment) {
        flush();
        time = cell.time;
      }
      row[cell.column] = cell.value;
    }
    flush();
    if (twice > 0) add_note(fmt::format("{} numbers that came twice at the same time are dropped", twice));
    result_.text = fmt::to_string(out);
  }

  void write_head(fmt::memory_buffer& out, double zero) const {
    auto to = fmt::appender(out);
    fmt::format_to(to, "# rudder_positive = \"starboard\"\n");
    if (dated_) fmt::format_to(to, "# start_utc = \"{}\"\n", utc_text(zero));
    fmt::format_to(to, "time_s");
    for (const auto& column : columns_) fmt::format_to(to, ",{}", column.name);
    out.push_back('\n');
  }

  static void write_row(fmt::memory_buffer& out, double time, const std::vector<double>& row) {
    auto to = fmt::appender(out);
    fmt::format_to(to, "{}", time);
    for (const double value : row) {
      out.push_back(',');
      if (!std::isnan(value)) fmt::format_to(to, "{}", std::round(1e9 * value) / 1e9 + 0.0);  // no "-0"
    }
    out.push_back('\n');
  }

  // A ship that turns by 1 deg/s changes her heading by 0.02 deg in that time; sentences tell it to 0.1 deg.
  static constexpr double same_moment = 0.02;  // [s]

  std::vector<std::filesystem::path> files_;
  std::vector<NmeaSeries> series_;
  std::array<std::vector<const NmeaSeries*>, quantity_count> chosen_;
  std::vector<ImportedColumn> left_out_;
  std::vector<TimedColumn> columns_;
  std::map<std::string, std::size_t> not_used_;
  std::size_t sentences_ = 0;
  std::optional<double> end_;
  bool dated_ = true;
  Import result_;
};

}  // namespace

Import import_nmea(const std::vector<std::filesystem::path>& files, const ImportOptions& options) {
  if (files.empty()) throw Refusal("no log is given");
  return LogImport(files, options).import();
}

}  // namespace swayaw::core

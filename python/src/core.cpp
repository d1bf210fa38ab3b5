#include <algorithm>
#include <charconv>
#include <cmath>

#include "module.hpp"
#include "record.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/file_limits.hpp"
#include "swayaw/core/import.hpp"
#include "swayaw/core/manoeuvres_in.hpp"
#include "swayaw/core/motion.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/core/ship_text.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::python {
namespace {

// ---------------------------------------------------------------- recordings from arrays

/// @throws std::domain_error  unless time increases strictly
void require_times(std::span<const double> time) {
  if (time.empty()) throw std::domain_error("a recording needs samples; time is empty");
  for (std::size_t i = 0; i < time.size(); ++i)
    if (!std::isfinite(time[i]) || (i > 0 && time[i] <= time[i - 1]))
      throw std::domain_error(i == 0 ? fmt::format("time must be finite, got {}", time[i])
                                     : fmt::format("time must increase, got {} after {}", time[i], time[i - 1]));
}

/// Copies a column, in its unit, into the samples of a channel: the only copy that is made.
void put(Recording& run, const Column& column, const Array& array) {
  if (array.ndim() != 1 || static_cast<std::size_t>(array.shape(0)) != run.samples())
    throw std::domain_error(fmt::format("{} must have one value for each of the {} times", column.name, run.samples()));
  auto& values = run.channels[index_of(column.channel)];
  values.resize(run.samples());
  const auto given = array.unchecked<1>();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = given(static_cast<py::ssize_t>(i)) * column.si;
    if (std::isinf(values[i])) throw std::domain_error(fmt::format("{} is infinite at sample {}", column.name, i));
  }
}

/// The column of that name, or the SI column of a channel by its short name.
std::optional<Column> column_or_channel(const std::string& name) {
  if (const auto column = column_named(name)) return column;
  const auto channel = channel_named(name);
  return channel ? column_named(column_name(*channel)) : std::nullopt;
}

Column column_of(const std::string& name) {
  if (const auto column = column_or_channel(name)) return *column;
  throw py::key_error(fmt::format("{} is no column of a recording", name));
}

/// A step of half a turn at most stays as it is, to the last bit, as in files.
void unwrap_heading(Recording& run) {
  std::optional<double> previous;
  for (double& psi : run.channels[index_of(Channel::psi)]) {
    if (std::isnan(psi)) continue;
    if (previous && std::abs(psi - *previous) > pi + 1e-9) psi = unwrapped(psi, *previous);
    previous = psi;
  }
}

Recording recording_of(const Array& time, const py::dict& columns, std::string name, Side rudder_positive) {
  Recording run;
  run.name = std::move(name);
  run.time = numbers_in(time, "time");
  require_times(run.time);
  for (const auto& [key, values] : columns) {
    const auto column = column_of(key.cast<std::string>());
    if (!run[column.channel].empty())
      throw std::domain_error(fmt::format("{} is given twice", column_name(column.channel)));
    put(run, column, values.cast<Array>());
  }
  unwrap_heading(run);
  for (const Channel rudder : {Channel::delta, Channel::delta_order})
    for (double& angle : run.channels[index_of(rudder)]) angle *= rudder_sign(rudder_positive);
  return run;
}

// ---------------------------------------------------------------- reading channels

/// SI columns without a copy, others converted.
py::object values_of(py::handle self, const std::string& name) {
  auto& run = self.cast<Recording&>();
  const auto column = column_of(name);
  auto& values = run.channels[index_of(column.channel)];
  if (values.empty()) throw py::key_error(fmt::format("{} was not recorded in {}", name, run.name));
  if (column.si == 1.0) return view(values, self, true);
  auto converted = values;
  for (double& x : converted) x /= column.si;
  return owned(std::move(converted));
}

std::vector<std::string_view> columns_of(const Recording& run) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < channel_count; ++i)
    if (!run.channels[i].empty()) names.push_back(column_name(static_cast<Channel>(i)));
  return names;
}

bool has_column(const Recording& run, const std::string& name) {
  const auto column = column_or_channel(name);
  return column && !run[column->channel].empty();
}

// ---------------------------------------------------------------- pickling

using Facts = std::tuple<std::string, Maybe, Maybe, std::vector<std::pair<std::string, std::string>>>;

Facts facts_of(const Recording& run) {
  std::vector<std::pair<std::string, std::string>> remarks;
  for (const auto& remark : run.facts.remarks) remarks.emplace_back(remark.key, remark.value);
  return {run.facts.manoeuvre, run.facts.execute, run.facts.water_depth, remarks};
}

void set_facts(Recording& run, const Facts& facts) {
  std::vector<std::pair<std::string, std::string>> remarks;
  std::tie(run.facts.manoeuvre, run.facts.execute, run.facts.water_depth, remarks) = facts;
  run.facts.remarks.clear();
  for (auto& [key, value] : remarks) run.facts.remarks.push_back({key, value});
}

py::dict extra_of(const Recording& run) {
  py::dict extra;
  for (const auto& column : run.extra) extra[py::str(column.name)] = column.cells;
  return extra;
}

void set_extra(Recording& run, const py::dict& extra) {
  run.extra.clear();
  for (const auto& [name, cells] : extra) {
    run.extra.push_back({name.cast<std::string>(), cells.cast<std::vector<std::string>>()});
    if (run.extra.back().cells.size() != run.samples())
      throw std::domain_error(
          fmt::format("{} must have one cell for each of the {} times", run.extra.back().name, run.samples()));
  }
}

py::tuple state_of(py::handle self) {
  auto& run = self.cast<Recording&>();
  py::dict channels;
  for (const auto name : columns_of(run)) channels[py::str(name)] = values_of(self, std::string(name));
  return py::make_tuple(run.name, facts_of(run), view(run.time, self), channels, extra_of(run));
}

Recording recording_from(const py::tuple& state) {
  auto run = recording_of(state[2].cast<Array>(), {}, state[0].cast<std::string>(), Side::port);
  set_facts(run, state[1].cast<Facts>());
  for (const auto& [name, values] : state[3].cast<py::dict>())
    put(run, column_of(name.cast<std::string>()), values.cast<Array>());
  set_extra(run, state[4].cast<py::dict>());
  return run;
}

// ---------------------------------------------------------------- the table of channels

py::list channel_list() {
  py::list rows;
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto channel = static_cast<Channel>(i);
    py::dict columns;
    for (const auto& column : known_columns())
      if (column.channel == channel) columns[py::str(column.name)] = column.si;
    rows.append(py::make_tuple(short_name(channel), column_name(channel), columns, shows_motion(channel)));
  }
  return rows;
}

void add_recordings(py::module_& m) {
  py::class_<Recording>(m, "Recording", R"(Samples of a ship in motion, recorded at sea, in a tank or by a simulation.

SI, radians, rudder positive to port, position and velocity of midship, heading unwrapped. Time increases strictly;
sampling may be irregular; a missing sample is NaN.

`run["psi_rad"]` is a numpy array on the samples themselves, and writing to it changes them; `run["psi_deg"]` is a copy in
another unit. `channels()` lists all columns.)")
      .def(py::init([](const Array& time, const py::dict& columns, std::string name, Side rudder_positive,
                       std::string manoeuvre, Maybe execute, Maybe water_depth) {
             auto run = recording_of(time, columns, std::move(name), rudder_positive);
             run.facts.manoeuvre = std::move(manoeuvre), run.facts.execute = execute;
             run.facts.water_depth = water_depth;
             return run;
           }),
           py::arg("time"), py::arg("columns"), py::kw_only(), py::arg("name") = "",
           py::arg("rudder_positive") = Side::port, py::arg("manoeuvre") = "", py::arg("execute") = py::none(),
           py::arg("water_depth") = py::none(),
           R"(From arrays by column, "psi_rad" or "psi_deg", copied once into SI; time in seconds.

rudder_positive: side to which the given rudder angles are positive. execute: time of the first rudder order [s].
water_depth [m]. Raises ValueError unless time increases and all columns are as long.)")
      .def("__len__", &Recording::samples)
      .def("__getitem__", &values_of, py::arg("column"), "Samples of a column, in its unit; KeyError if not recorded.")
      .def(
          "__setitem__",
          [](Recording& run, const std::string& name, const Array& values) { put(run, column_of(name), values); },
          py::arg("column"), py::arg("values"), "Sets the samples of a column given in its unit, NaN where missing.")
      .def("__contains__", &has_column, py::arg("column"), "Whether the quantity of that column was recorded.")
      .def("__iter__", [](const Recording& run) { return py::iter(py::cast(columns_of(run))); })
      .def_property_readonly(
          "time", [](py::handle self) { return view(self.cast<Recording&>().time, self); }, "Times [s], numpy.ndarray.")
      .def_property_readonly("columns", &columns_of, "Names of the SI columns that were recorded.")
      .def_readwrite("name", &Recording::name, "File name, or what made it.")
      .def_property(
          "manoeuvre", [](const Recording& run) { return run.facts.manoeuvre; },
          [](Recording& run, std::string words) { run.facts.manoeuvre = std::move(words); },
          "\"zigzag 10/10\", \"turn 35\", free text; empty if not said.")
      .def_property(
          "execute", [](const Recording& run) { return run.facts.execute; },
          [](Recording& run, Maybe time) { run.facts.execute = time; }, "Time of the first rudder order [s].")
      .def_property(
          "water_depth", [](const Recording& run) { return run.facts.water_depth; },
          [](Recording& run, Maybe depth) { run.facts.water_depth = depth; }, "[m]")
      .def_property(
          "remarks",
          [](const Recording& run) {
            py::dict remarks;
            for (const auto& remark : run.facts.remarks) remarks[py::str(remark.key)] = remark.value;
            return remarks;
          },
          [](Recording& run, const std::map<std::string, std::string>& remarks) {
            run.facts.remarks.clear();
            for (const auto& [key, value] : remarks) run.facts.remarks.push_back({key, value});
          },
          "Run keys that the recording carries along, as TOML: {\"group\": '\"calm\"'}.")
      .def_property_readonly("group", &group_of,
                             "Runs with instruments, loading and surroundings in common: the run key `group`, else the "
                             "day of `start_utc`, else \"\".")
      .def_property("extra", &extra_of, &set_extra, "Columns that swayaw does not understand, as text.")
      .def("csv_text", &recording_text, Unlocked(), "The text of a recording file: SI columns, full precision.")
      .def("write_csv", &write_recording, py::arg("file"), Unlocked(),
           "Writes a recording file, all of it or nothing. Raises FileError if it cannot be written.")
      .def(py::pickle(&state_of, &recording_from));
}

FileUse use_named(const std::string& use) {
  if (use == "samples") return FileUse::samples;
  if (use == "description") return FileUse::description;
  throw std::domain_error(fmt::format("use must be \"samples\" or \"description\", got \"{}\"", use));
}

void add_reading(py::module_& m) {
  m.def(
      "_read_csv",
      [](const std::filesystem::path& file, std::optional<Side> rudder_positive) {
        auto read = read_recording(file, rudder_positive);
        return std::pair(std::move(read.recording), std::move(read.warnings));
      },
      py::arg("file"), py::arg("rudder_positive") = py::none(), Unlocked());
  m.def(
      "_parse_csv",
      [](std::string_view text, const std::filesystem::path& name, std::optional<Side> rudder_positive) {
        auto read = parse_recording(text, name, rudder_positive);
        return std::pair(std::move(read.recording), std::move(read.warnings));
      },
      py::arg("text"), py::arg("name"), py::arg("rudder_positive") = py::none(), Unlocked());
  m.def("_channels", &channel_list);
  m.def("_ship_text", &read_ship_text, py::arg("file"), Unlocked());
  m.def(
      "largest_file", [](const std::string& use) { return largest_file(use_named(use)); }, py::arg("use") = "samples",
      R"(Bytes of the largest file that is read now; a larger one raises FileError.

use: "samples", of recordings, logs and tables; "description", of ships and measured indices.)");
  m.def("set_largest_file", &set_largest_file, py::arg("bytes"),
        R"(From now on the largest file that is read has so many bytes, whatever its use. 0: the usual sizes.

bytes: 4_000_000_000 is what `--max-file-size 4GB` is to the program.)");

  Record<ImportedColumn>(m, "ImportedColumn", "What one column of a raw file was taken for.")
      .field<&ImportedColumn::source>("source", "As the file names it: \"Kurs [°]\", \"HDT\".")
      .field<&ImportedColumn::taken_for>("taken_for",
                                         "Column of the recording, \"psi_deg\"; empty where it was left out.")
      .field<&ImportedColumn::why>("why", "By name, unit, values: plain words.")
      .field<&ImportedColumn::samples>("samples", "With a value.");
  Record<Import>(m, "Import", "A raw file as a recording file.")
      .field<&Import::columns>("columns", "What each column was taken for.")
      .field<&Import::notes>("notes",
                             "Facts of the whole file, one line each: encoding, clock, zone, what was dropped.")
      .field<&Import::text>("text", "The recording file, which parse_csv reads.");
  m.def(
      "import_table",
      [](const std::vector<std::filesystem::path>& files, const std::filesystem::path& columns) {
        return import_table(files, {.column_map = columns});
      },
      py::arg("files"), py::arg("columns") = "", Unlocked(),
      "Text tables of spreadsheets and loggers as one recording; `columns` is a column map (docs/import.md). Nothing "
      "is "
      "guessed silently: what stays open is refused with the line of the map that settles it."
      "\n\nfiles: in the order of time; FileError names file and line of what is refused.");
  m.def(
      "import_nmea",
      [](const std::vector<std::filesystem::path>& files, const std::filesystem::path& columns) {
        return import_nmea(files, {.column_map = columns});
      },
      py::arg("files"), py::arg("columns") = "", Unlocked(),
      "Logs of NMEA 0183 sentences as one recording."
      "\n\nfiles: in the order of time. columns: a column map (docs/import.md). Raises FileError for what stays open.");
  m.def(
      "import_mat",
      [](const std::filesystem::path& file, const std::filesystem::path& columns) {
        return import_mat(file, {.column_map = columns});
      },
      py::arg("file"), py::arg("columns") = "", Unlocked(),
      "A MATLAB file, versions 4 to 7.3, as a recording."
      "\n\nfile: to be read. columns: a column map, where the names of the file are not clear. Raises FileError for "
      "what stays open.");

  Record<ManoeuvrePiece>(m, "ManoeuvrePiece", "A stretch of a recording in which one manoeuvre is sailed.")
      .field<&ManoeuvrePiece::begin>("begin", "[s], time of the recording.")
      .field<&ManoeuvrePiece::end>("end", "[s]")
      .field<&ManoeuvrePiece::manoeuvre>("manoeuvre", "\"zigzag 10/10\", \"turn 35\", \"spiral 25\", \"steady run\" …")
      .field<&ManoeuvrePiece::execute>("execute", "First rudder order [s]; None for steady runs.")
      .field<&ManoeuvrePiece::why>("why", "How it was recognised, one line.");
  m.def("manoeuvres_in", &manoeuvres_in, py::arg("run"), Unlocked(),
        "What is sailed in a long recording, in order of time, found by rudder and heading."
        "\n\nrun: a recording of hours. Each ManoeuvrePiece has begin and end [s] and what was sailed.");
  m.def("piece_of", &piece_of, py::arg("run"), py::arg("piece"), Unlocked(),
        "The piece as a recording of its own: time from 0 at its first sample."
        "\n\nrun: a recording. piece: of `manoeuvres_in`.");
}

void add_motions(py::module_& m) {
  using Motion = PlanarMotion<double>;
  Record<Motion>(m, "PlanarMotion", "Velocity of midship in body axes, and yaw rate.", Made::by_anyone)
      .field<&Motion::u>("u", "Surge [m/s].")
      .field<&Motion::v>("v", "Sway, positive to starboard [m/s].")
      .field<&Motion::r>("r", "Yaw rate, positive to starboard [rad/s].");
  using Acceleration = PlanarAcceleration<double>;
  Record<Acceleration>(m, "PlanarAcceleration", "Time derivative of a planar motion in body axes.", Made::by_anyone)
      .field<&Acceleration::u>("u", "du/dt [m/s²].")
      .field<&Acceleration::v>("v", "dv/dt [m/s²].")
      .field<&Acceleration::r>("r", "dr/dt [rad/s²].");
  using Force = PlanarForce<double>;
  Record<Force>(m, "PlanarForce", "Force in body axes and moment about midship.", Made::by_anyone)
      .field<&Force::X>("X", "Surge force [N].")
      .field<&Force::Y>("Y", "Sway force, positive to starboard [N].")
      .field<&Force::N>("N", "Yaw moment about midship, positive to starboard [N m].");
  using State = ShipState<double>;
  Record<State>(m, "ShipState", "Where the ship is, where she points, how she moves.", Made::by_anyone)
      .field<&State::x>("x", "Midship, earth-fixed, northward [m].")
      .field<&State::y>("y", "Midship, earth-fixed, eastward [m].")
      .field<&State::psi>("psi", "Heading, clockwise from north [rad].")
      .field<&State::motion>("motion", "Through the water.");
  m.def("drift_angle", &drift_angle<double>, py::arg("motion"),
        "beta = atan2(-v, u) [rad]."
        "\n\nmotion: u and v of midship through the water.");
  m.def("speed", &speed<double>, py::arg("motion"),
        "U = sqrt(u² + v²) [m/s]."
        "\n\nmotion: u and v of midship [m/s].");
}

}  // namespace

void add_core(py::module_& m) {
  m.attr("__version__") = version();
  add_motions(m);
  add_recordings(m);
  add_reading(m);
}

}  // namespace swayaw::python

#include <algorithm>
#include <array>

#include "module.hpp"
#include "record.hpp"
#include "ship_values.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/linear/batch.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/simulation/batch.hpp"

namespace swayaw::python {

template <>
struct Words<InstructionSet> {
  static std::vector<std::string> list() { return {"best", "numbers", "baseline", "avx2", "avx512"}; }
};
template <>
struct Words<ZigzagEnd> {
  static std::vector<std::string> list() { return {"complete", "time_over", "unbounded", "no_propulsion"}; }
};

namespace {

// ---------------------------------------------------------------- tables

/// Numbers [row · columns + column] as a matrix.
py::object reshaped(const std::vector<double>& values, std::size_t rows, std::size_t columns) {
  return py::array_t<double>({rows, columns}, values.data());
}

std::vector<double> flat(py::handle value) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  return {array.data(), array.data() + array.size()};
}

template <auto Member, class Table>
py::object by_reversal(Table& table) {
  return reshaped(table.*Member, table.reversals, table.ships);
}

template <auto Member, class Table>
void set_by_reversal(Table& table, py::handle value) {
  table.*Member = flat(value);
}

template <class Table>
py::object counts(Table& table) {
  return py::array_t<std::uint8_t>(static_cast<py::ssize_t>(table.count.size()), table.count.data());
}

template <class Table>
void set_counts(Table& table, py::handle value) {
  table.count = value.cast<std::vector<unsigned char>>();
}

// ---------------------------------------------------------------- other values

/// Columns of numbers by name, all of one length.
struct Columns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  std::size_t rows = 0;

  std::vector<double> row(std::size_t i) const {
    std::vector<double> result;
    for (const auto& column : values) result.push_back(column[i]);
    return result;
  }
};

/// @throws std::domain_error  unless there are columns, of one length
Columns columns_in(const std::map<std::string, Array>& given) {
  Columns columns;
  for (const auto& [name, array] : given) {
    columns.names.push_back(name);
    columns.values.push_back(numbers_in(array, name));
    columns.rows = columns.values.front().size();
    if (columns.values.back().size() != columns.rows)
      throw std::domain_error(fmt::format("{} has {} values and {} has {}", columns.names.front(), columns.rows, name,
                                          columns.values.back().size()));
  }
  if (columns.rows == 0) throw std::domain_error("values must name a number and have one value for each ship");
  return columns;
}

// ---------------------------------------------------------------- ships of the MMG model

/// @throws Refusal  for another model, and for effects and wind, which a batch does not have
const MmgShip<double>& for_batch(const Ship& ship) {
  const auto* mmg = std::get_if<MmgShip<double>>(&ship.model);
  if (mmg == nullptr) throw Refusal(fmt::format("{}: batches are of ships of the model mmg", ship.name));
  if (!ship.effects.empty())
    throw Refusal(fmt::format("{} has the effect {}, batches are without", ship.name, id_of(ship.effects.front())));
  return *mmg;
}

std::vector<MmgShip<double>> fleet(const std::vector<Ship>& ships) {
  std::vector<MmgShip<double>> result;
  for (const auto& ship : ships) result.push_back(for_batch(ship));
  return result;
}

std::vector<MmgShip<double>> fleet(const Ship& ship, const std::map<std::string, Array>& values) {
  const auto columns = columns_in(values);
  const auto parameters = parameters_of(ship, columns.names);
  std::vector<MmgShip<double>> result(columns.rows, for_batch(ship));
  for (std::size_t i = 0; i < columns.rows; ++i) {
    const auto row = si_values(parameters, columns.row(i));
    set_values(result[i], std::span(parameters), std::span<const double>(row));
  }
  return result;
}

ZigzagBatch sailed(const std::vector<MmgShip<double>>& ships, double rudder, double heading, Side first,
                   std::size_t reversals, Maybe speed, Maybe rev, Maybe duration, double tolerance, unsigned threads,
                   InstructionSet set) {
  const py::gil_scoped_release unlocked;
  return zigzag_batch(ships, {.rudder = rudder, .heading = heading, .first = first},
                      {.reversals = reversals,
                       .speed = speed,
                       .rev = rev,
                       .duration = duration,
                       .tolerance = tolerance,
                       .batch = {.threads = threads, .set = set}});
}

#define SWAYAW_BATCH_ARGUMENTS                                                                                  \
  py::arg("rudder"), py::arg("heading"),                                                                        \
      py::arg("first") = Side::starboard, py::kw_only(), py::arg("reversals") = ZigzagBatchOptions{}.reversals, \
      py::arg("speed") = py::none(), py::arg("rev") = py::none(), py::arg("duration") = py::none(),             \
      py::arg("tolerance") = ZigzagBatchOptions{}.tolerance, py::arg("threads") = 0U,                           \
      py::arg("instruction_set") = InstructionSet::best

void add_zigzags(py::module_& m) {
  Record<ZigzagBatch>(m, "ZigzagBatch", "Zigzags of many ships: reversals by ships; NaN for what a ship did not reach.")
      .field<&ZigzagBatch::ships>("ships", "How many.")
      .field<&ZigzagBatch::reversals>("reversals", "Asked for.")
      .told<&by_reversal<&ZigzagBatch::time, ZigzagBatch>, &set_by_reversal<&ZigzagBatch::time, ZigzagBatch>>(
          "time", "numpy.ndarray", "When the heading reaches the switch angle [s].")
      .told<&by_reversal<&ZigzagBatch::peak_time, ZigzagBatch>, &set_by_reversal<&ZigzagBatch::peak_time, ZigzagBatch>>(
          "peak_time", "numpy.ndarray", "When the yaw rate passes zero [s].")
      .told<&by_reversal<&ZigzagBatch::overshoot, ZigzagBatch>, &set_by_reversal<&ZigzagBatch::overshoot, ZigzagBatch>>(
          "overshoot", "numpy.ndarray", "Heading peak beyond the switch angle [rad].")
      .told<&counts<ZigzagBatch>, &set_counts<ZigzagBatch>>("count", "numpy.ndarray", "Overshoots of each ship.")
      .field<&ZigzagBatch::end>("end", "Of each ship: complete, time_over, unbounded or no_propulsion.");
  m.def(
      "zigzag_batch",
      [](const std::vector<Ship>& ships, double rudder, double heading, Side first, std::size_t reversals, Maybe speed,
         Maybe rev, Maybe duration, double tolerance, unsigned threads, InstructionSet set) {
        return sailed(fleet(ships), rudder, heading, first, reversals, speed, rev, duration, tolerance, threads, set);
      },
      py::arg("ships"), SWAYAW_BATCH_ARGUMENTS,
      "The zigzag of every ship, in calm water, over packs and all cores.\n\nships: of the model mmg, without effects. "
      "rudder, heading: angles [rad]. first: side turned to first. reversals: after whose overshoots a ship ends, 255 "
      "at "
      "most. speed: of the approach [m/s], of each ship her service speed unless given. rev: shaft speed [1/s], that "
      "of self-propulsion unless given. duration [s]: 200 L/U unless given. tolerance: error of an integration step. "
      "threads: 0 for one on each core. instruction_set: best, numbers, baseline, avx2 or avx512.\n\nRaises Refusal "
      "for "
      "another model or an effect; ValueError for angles that are not positive or beyond the largest of a ship, or an "
      "instruction set that is not there.");
  m.def(
      "zigzag_batch",
      [](const Ship& ship, const std::map<std::string, Array>& values, double rudder, double heading, Side first,
         std::size_t reversals, Maybe speed, Maybe rev, Maybe duration, double tolerance, unsigned threads,
         InstructionSet set) {
        return sailed(fleet(ship, values), rudder, heading, first, reversals, speed, rev, duration, tolerance, threads,
                      set);
      },
      py::arg("ship"), py::arg("values"), SWAYAW_BATCH_ARGUMENTS,
      "The same for one ship with other values of her numbers.\n\nship: of the model mmg, without effects. values: "
      "arrays by name, one value for each ship, in the units of the ship file: {\"N_v\": -0.14 * numpy.ones(1000), …}. "
      "Raises besides ValueError for a value that her file would refuse.");
}

// ---------------------------------------------------------------- linear ships

void add_linear_zigzags(py::module_& m) {
  using Coefficients = SwayYawCoefficients<double>;
  Record<ZigzagTable>(m, "LinearZigzagBatch",
                      "Zigzags of many linear ships: reversals by ships; NaN for what a ship did not reach.")
      .field<&ZigzagTable::ships>("ships", "How many.")
      .field<&ZigzagTable::reversals>("reversals", "Asked for.")
      .told<&by_reversal<&ZigzagTable::execute, ZigzagTable>, &set_by_reversal<&ZigzagTable::execute, ZigzagTable>>(
          "execute", "numpy.ndarray", "s' at which the heading reaches H.")
      .told<&by_reversal<&ZigzagTable::peak, ZigzagTable>, &set_by_reversal<&ZigzagTable::peak, ZigzagTable>>(
          "peak", "numpy.ndarray", "s' at which the yaw rate passes zero.")
      .told<&by_reversal<&ZigzagTable::overshoot, ZigzagTable>, &set_by_reversal<&ZigzagTable::overshoot, ZigzagTable>>(
          "overshoot", "numpy.ndarray", "Heading beyond H at the peak [rad].")
      .told<&counts<ZigzagTable>, &set_counts<ZigzagTable>>("count", "numpy.ndarray", "Reversals of each ship.")
      .field<&ZigzagTable::by_numbers>("by_numbers", "Ships that the packs left to the scalar code.");
  m.def(
      "linear_zigzag_batch",
      [](const Coefficients& ship, const std::map<std::string, Array>& values, double rudder, double heading,
         double rate, Side first, std::size_t reversals, unsigned threads, InstructionSet set) {
        const auto columns = columns_in(values);
        const std::array<std::pair<std::string_view, double>, 6> all{
            {{"a1", ship.a1}, {"b1", ship.b1}, {"c1", ship.c1}, {"a2", ship.a2}, {"b2", ship.b2}, {"c2", ship.c2}}};
        std::array<std::vector<double>, 6> numbers;
        for (std::size_t k = 0; k < all.size(); ++k) numbers[k].assign(columns.rows, all[k].second);
        for (std::size_t i = 0; i < columns.names.size(); ++i) {
          const auto found = std::ranges::find(all, columns.names[i], &std::pair<std::string_view, double>::first);
          if (found == all.end())
            throw std::domain_error(fmt::format("{} is none of a1, b1, c1, a2, b2, c2", columns.names[i]));
          numbers[static_cast<std::size_t>(found - all.begin())] = columns.values[i];
        }
        const py::gil_scoped_release unlocked;
        const auto& [a1, b1, c1, a2, b2, c2] = numbers;
        return zigzag_batch(
            ShipColumns{.a1 = a1, .b1 = b1, .c1 = c1, .a2 = a2, .b2 = b2, .c2 = c2},
            {.rudder = rudder, .heading = heading, .rate = rate, .first = first, .reversals = reversals},
            {.threads = threads, .set = set});
      },
      py::arg("coefficients"), py::arg("values"), py::arg("rudder"), py::arg("heading"), py::arg("rate"),
      py::arg("first") = Side::starboard, py::arg("reversals") = LinearZigzagOrder{}.reversals, py::kw_only(),
      py::arg("threads") = 0U, py::arg("instruction_set") = InstructionSet::best,
      "The zigzag of many linear ships, switches as `linear_zigzag` gives them to 1e-10.\n\ncoefficients: of all ships "
      "but for `values`: arrays by name, a1 to c2, one value for each ship. rudder, heading [rad]; rate in rad per "
      "ship "
      "length. first: side turned to first. reversals: 16 at most. threads: 0 for one on each core. instruction_set: "
      "best, numbers, baseline, avx2 or avx512.\n\nRaises ValueError if lengths differ, an angle or the rate is not "
      "positive, or the instruction set is not there.");
}

// ---------------------------------------------------------------- the map of T3b and T3w

template <auto Member>
py::object over_map(T3Map& map) {
  std::vector<double> values;
  for (const auto& point : map.points) values.push_back(point.*Member);
  return reshaped(values, map.T3w.size(), map.T3b.size());
}

template <auto Member>
void set_over_map(T3Map& map, py::handle value) {
  const auto values = flat(value);
  map.points.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) map.points[i].*Member = values[i];
}

void add_t3_map(py::module_& m) {
  using P = T3Point;
  Record<T3Map>(m, "T3Map", "Loop measures, rows by T3w, columns by T3b; NaN where a ship makes no three reversals.")
      .field<&T3Map::T3b>("T3b", "Of the columns.")
      .field<&T3Map::T3w>("T3w", "Of the rows.")
      .told<&over_map<&P::area>, &set_over_map<&P::area>>("area", "numpy.ndarray", "Of the loop [rad].")
      .told<&over_map<&P::beta_max>, &set_over_map<&P::beta_max>>("beta_max", "numpy.ndarray", "Largest |beta| [rad].")
      .told<&over_map<&P::omega_max>, &set_over_map<&P::omega_max>>("omega_max", "numpy.ndarray", "Largest |omega'|.")
      .told<&over_map<&P::omega_at_beta_zero>, &set_over_map<&P::omega_at_beta_zero>>(
          "omega_at_beta_zero", "numpy.ndarray", "|omega'| where beta passes zero.")
      .told<&over_map<&P::overshoot1>, &set_over_map<&P::overshoot1>>("overshoot1", "numpy.ndarray", "First [rad].")
      .told<&over_map<&P::overshoot2>, &set_over_map<&P::overshoot2>>("overshoot2", "numpy.ndarray", "Second [rad].")
      .told<&over_map<&P::period>, &set_over_map<&P::period>>("period", "numpy.ndarray",
                                                              "Of the limit cycle [ship lengths].");
  m.def(
      "t3_map",
      [](const SteeringIndices<double>& indices, double rudder, double heading, double rate, const Array& T3b,
         const Array& T3w, unsigned threads) {
        const auto columns = numbers_in(T3b, "T3b"), rows = numbers_in(T3w, "T3w");
        const py::gil_scoped_release unlocked;
        return t3_map(indices, {.rudder = rudder, .heading = heading, .rate = rate}, columns, rows, threads);
      },
      py::arg("indices"), py::arg("rudder"), py::arg("heading"), py::arg("rate"), py::arg("T3b"), py::arg("T3w"),
      py::kw_only(), py::arg("threads") = 0U,
      "Loop measures of the limit cycle for every pair of T3b and T3w, the other indices held.\n\nindices: of the "
      "ship. "
      "rudder, heading [rad]; rate in rad per ship length. T3b, T3w: arrays of the map. threads: 0 for one on each "
      "core. Raises ValueError if T1 T2, Kb or Kw is 0, or an angle or the rate is not positive.");
}

}  // namespace

void add_batches(py::module_& m) {
  add_zigzags(m);
  add_linear_zigzags(m);
  add_t3_map(m);
}

}  // namespace swayaw::python

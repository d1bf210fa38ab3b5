#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

/// A parameter in the unit of ship files.
struct ParameterRow {
  std::string name, table, unit;
  double value;
  Range range;
  double deviation;  ///< 0 for what is no coefficient
};

std::vector<ParameterRow> rows_of(const Ship& ship) {
  std::vector<ParameterRow> rows;
  for (const auto& p : parameters_of(ship))
    rows.push_back({p.name, std::string(p.table), std::string(p.unit), p.value / p.si, scaled(p.range, 1.0 / p.si),
                    p.deviation / p.si});
  return rows;
}

template <class Part>
void add_rows(std::vector<ParameterRow>& rows, std::string_view table, const Part& part, const Confidence& confidence) {
  for (const auto& p : part.parameters()) {
    const double value = part.*p.member / p.si;
    const double deviation = p.role == Role::coefficient ? std::abs(value) * confidence.of(p.key) : 0.0;
    rows.push_back({std::string(p.key), std::string(table), std::string(p.unit), value, p.range, deviation});
  }
}

/// Rows of the form that the ship file has.
struct FormRows {
  std::vector<ParameterRow>& rows;
  const Confidence& confidence;

  void operator()(const LinearParts<double>& parts) const {
    add_rows(rows, "hull", parts.hull, confidence);
    add_rows(rows, "rudder", parts.rudder, confidence);
  }
  void operator()(const SwayYawCoefficients<double>& m) const { add_rows(rows, "linear", m, confidence); }
  void operator()(const SteeringIndices<double>& i) const { add_rows(rows, "nomoto", i, confidence); }
};

std::vector<ParameterRow> rows_of(const LinearShip& ship) {
  std::vector<ParameterRow> rows;
  add_rows(rows, "particulars", ship.particulars, ship.confidence);
  std::visit(FormRows{rows, ship.confidence}, ship.form);
  add_rows(rows, "rudder", ship.steering_gear, ship.confidence);
  return rows;
}

std::string range_words(const Range& range) {
  if (range.not_zero) return "not 0";
  const auto low = range.above_low ? "above" : "at least";
  if (std::isinf(range.low)) return std::isinf(range.high) ? "" : fmt::format("at most {:.6g}", range.high);
  if (std::isinf(range.high)) return fmt::format("{} {:.6g}", low, range.low);
  return fmt::format("{:.6g} to {:.6g}", range.low, range.high);
}

Json row_json(const ParameterRow& row) {
  return {{"table", row.table},
          {"value", number(row.value)},
          {"unit", row.unit},
          {"least", number(row.range.low)},
          {"greatest", number(row.range.high)},
          {"standard_deviation", number(row.deviation)}};
}

Json document_of(const std::string& name, std::string_view model, const std::vector<ParameterRow>& rows) {
  Json parameters = Json::object();
  for (const auto& row : rows) parameters[row.name] = row_json(row);
  return {{"schema", "swayaw.ship/1"}, {"ship", name}, {"model", model}, {"parameters", std::move(parameters)}};
}

void print_text(const std::string& name, std::string_view model, const std::vector<ParameterRow>& rows) {
  say("{}, model {}\n", name, model);
  std::string table;
  for (const auto& row : rows) {
    if (row.table != table) say("\n[{}]\n", table = row.table);
    const auto trust = row.deviation > 0.0 ? fmt::format("± {:.2g}", row.deviation) : "";
    say("  {:<26}{:>13.6g} {:<8} {:<11} {}\n", row.name, row.value, row.unit, trust, range_words(row.range));
  }
}

void write(const std::filesystem::path& file, const Ship& ship) { write_ship(file, ship); }
void write(const std::filesystem::path& file, const LinearShip& ship) { write_linear_ship(file, ship); }

}  // namespace

void describe_ship(const ShipArguments& a) {
  const auto model = model_of(ship_text(a.ship), a.ship);
  const auto tell = [&](const auto& ship) {
    if (!a.out.empty()) write(a.out, ship);
    if (a.json) print_document(document_of(ship.name, model, rows_of(ship)));
    else print_text(ship.name, model, rows_of(ship));
  };
  std::visit(tell, load_ship(a.ship));
}

}  // namespace swayaw::app

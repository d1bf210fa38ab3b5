#include "model_description.hpp"

#include <fmt/format.h>

#include <iterator>

#include "swayaw/core/angle.hpp"

namespace swayaw::fmu {
namespace {

/// Text between quotes.
std::string attribute(std::string_view text) {
  std::string xml = "\"";
  for (const char c : text) {
    if (c == '&') xml += "&amp;";
    else if (c == '<') xml += "&lt;";
    else if (c == '"') xml += "&quot;";
    else if (static_cast<unsigned char>(c) < ' ') xml += ' ';
    else xml += c;
  }
  return xml + '"';
}

/// A unit by its exponents of base units, and the unit that is shown in its place: shown = factor · value.
struct Unit {
  std::string_view name, exponents, shown{};
  double factor = 1.0;
};

const Unit units[] = {
    {"s", R"(s="1")"},
    {"m", R"(m="1")"},
    {"rad", R"(rad="1")", "deg", degrees(1.0)},
    {"m/s", R"(m="1" s="-1")", "kn", 3600.0 / 1852.0},
    {"rad/s", R"(rad="1" s="-1")", "deg/s", degrees(1.0)},
    {"1/s", R"(s="-1")", "rpm", 60.0},
    {"N", R"(kg="1" m="1" s="-2")", "kN", 1e-3},
    {"N.m", R"(kg="1" m="2" s="-2")", "kN.m", 1e-3},
};

void add_units(std::string& xml) {
  xml += "  <UnitDefinitions>\n";
  for (const auto& unit : units) {
    xml += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/>", unit.name, unit.exponents);
    if (!unit.shown.empty()) xml += fmt::format("<DisplayUnit name=\"{}\" factor=\"{}\"/>", unit.shown, unit.factor);
    xml += "</Unit>\n";
  }
  xml += "  </UnitDefinitions>\n";
}

std::string_view words_for(Causality causality) {
  switch (causality) {
    case Causality::parameter: return "parameter";
    case Causality::input: return "input";
    case Causality::output: return "output";
    case Causality::independent: return "independent";
  }
  return "";
}

std::string_view variability_of(const Variable& v) {
  if (v.causality == Causality::parameter) return "fixed";
  return v.type == Type::real ? "continuous" : "discrete";
}

/// What stands within a ScalarVariable. Outputs are calculated, so they have no start.
std::string value_of(const Variable& v) {
  const bool starts = v.causality == Causality::parameter || v.causality == Causality::input;
  switch (v.type) {
    case Type::integer: return "<Integer/>";
    case Type::boolean: return "<Boolean/>";
    case Type::string: return starts ? fmt::format("<String start={}/>", attribute(v.start_text)) : "<String/>";
    case Type::real: break;
  }
  const auto unit = v.unit == "1" ? "" : fmt::format(" unit=\"{}\"", v.unit);
  return starts ? fmt::format("<Real{} start=\"{}\"/>", unit, v.start) : fmt::format("<Real{}/>", unit);
}

void add_variables(std::string& xml, const std::vector<Variable>& variables) {
  xml += "  <ModelVariables>\n";
  for (const auto& v : variables)
    xml += fmt::format(
        "    <ScalarVariable name=\"{}\" valueReference=\"{}\" causality=\"{}\" variability=\"{}\" "
        "description={}>{}</ScalarVariable>\n",
        v.name, v.reference, words_for(v.causality), variability_of(v), attribute(v.description), value_of(v));
  xml += "  </ModelVariables>\n";
}

/// Outputs by their place among the variables, from 1. Each may depend on all inputs.
void add_structure(std::string& xml, const std::vector<Variable>& variables) {
  xml += "  <ModelStructure>\n";
  for (const std::string_view list : {"Outputs", "InitialUnknowns"}) {
    xml += fmt::format("    <{}>\n", list);
    for (std::size_t i = 0; i < variables.size(); ++i)
      if (variables[i].causality == Causality::output) xml += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
    xml += fmt::format("    </{}>\n", list);
  }
  xml += "  </ModelStructure>\n";
}

}  // namespace

std::string model_description(std::string_view ship_name, std::string_view guid,
                              const std::vector<Variable>& variables) {
  std::string xml = fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName={} guid="{}" description="A ship under way: rudder, shaft, wind, current and forces of others in, motion and instruments out. SI and radians; a rudder angle is positive to port." version={} generationTool="swayaw {}" variableNamingConvention="structured">
  <CoSimulation modelIdentifier="{}" canHandleVariableCommunicationStepSize="true" canNotUseMemoryManagementFunctions="true"/>
)",
      attribute(ship_name), guid, attribute(SWAYAW_VERSION), SWAYAW_VERSION, model_identifier);
  add_units(xml);
  xml += R"(  <LogCategories>
    <Category name="logStatusError" description="why a call was refused"/>
    <Category name="logStatusWarning" description="the ship went where her force model does not hold"/>
    <Category name="logEvents" description="the ship begins, and is back where her force model holds"/>
  </LogCategories>
  <DefaultExperiment startTime="0" stopTime="600" stepSize="0.1"/>
)";
  add_variables(xml, variables);
  add_structure(xml, variables);
  return xml + "</fmiModelDescription>\n";
}

}  // namespace swayaw::fmu

#pragma once

#include <swayaw.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// The variables of the unit: those that its description lists are those that it answers for.
namespace swayaw::fmu {

enum class Type { real, integer, boolean, string };
enum class Causality { parameter, input, output, independent };

struct Variable {
  unsigned reference;  ///< value reference, unique
  std::string name;    ///< of the C interface where it has one
  Type type;
  Causality causality;
  std::string unit;  ///< of a real number, "1" for none
  std::string description;
  double start = 0.0;        ///< of parameters and inputs
  std::string start_text{};  ///< of a text
};

/// Value references of what the C interface does not have; its quantities are counted from 0.
enum Reference : unsigned {
  ship_file = 1000,  ///< in the folder resources
  start_speed,
  start_x,
  start_y,
  start_psi,
  valid = 2000,
  why,
};

inline constexpr std::string_view default_ship_file = "ship.toml";

struct Closer {
  void operator()(swayaw_ship* ship) const { swayaw_close(ship); }
};
using ShipHandle = std::unique_ptr<swayaw_ship, Closer>;

/// @param speed  [m/s]; 0 for the service speed
/// @throws Refusal  in the words of the C interface
ShipHandle open_ship(const std::string& ship, double speed);

/// A quantity of the C interface. @throws Refusal
double value_of(const swayaw_ship& ship, const std::string& name);

/// Variables of a ship: a shaft speed or a thrust to order as her model takes it, a wind if it is known what she shows
/// it, the instruments that she has.
/// @throws Refusal
std::vector<Variable> variables_of(const std::string& ship);

/// Tells whether description and unit belong together: it changes with the ship file and with the variables.
std::string guid_of(std::string_view ship_text, const std::vector<Variable>& variables);

}  // namespace swayaw::fmu

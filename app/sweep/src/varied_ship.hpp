#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input.hpp"
#include "swayaw/app/sweep/plan.hpp"
#include "swayaw/app/sweep/points.hpp"
#include "swayaw/app/sweep/work.hpp"

/// A ship whose parameters vary as a plan says. Not seen outside the sweep.
namespace swayaw::app {

/// A ship at a point, to be put to the next one.
struct ShipAtPoint {
  AnyShip ship;
  std::optional<double> speed;  ///< of the approach [m/s]
};

class VariedShip {
 public:
  /// @param file  of the ship, or the name of a published one
  /// @throws FileError  if she cannot be read, or a parameter of the plan is none of hers
  VariedShip(const SweepPlan& plan, const std::string& file);

  const AnyShip& ship() const { return ship_; }
  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }  ///< of her file
  const std::vector<Law>& laws() const { return laws_; }
  const std::vector<SweepColumn>& columns() const { return columns_; }
  bool speed_varies() const;

  ShipAtPoint at_rest() const { return {ship_, speed_}; }

  /// Puts the ship to the point with these values, in the units of the columns.
  void put(ShipAtPoint& point, std::span<const double> values) const;

 private:
  /// Where a value goes.
  struct Target {
    enum class Kind { model, linear, effect, speed } kind;
    std::size_t effect = 0;  ///< of the ship
    std::size_t index = 0;   ///< among the parameters
    double si = 1.0;
  };

  /// What is known of a parameter that can vary, in the unit of the ship file.
  struct Known {
    std::string name;       ///< "area_m2", or "rudder.x_prime" where two tables have that key
    std::string qualified;  ///< "rudder.area_m2", which is understood as well
    std::string unit;
    double value, sd;  ///< sd by the confidence of the ship; 0 for a fact
    Range range;
    Target target;
  };

  std::vector<Known> parameters() const;
  void add(const Known& known, Law law);
  Law law_of(const Known& known, const Variation& v, SweepDesign design) const;

  std::string text_, name_;
  AnyShip ship_;
  std::optional<double> speed_;
  std::vector<Law> laws_;
  std::vector<SweepColumn> columns_;
  std::vector<Target> targets_;
};

}  // namespace swayaw::app

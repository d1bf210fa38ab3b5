#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "swayaw/app/page.hpp"
#include "swayaw/core/recording.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/linear/linear_ship.hpp"

namespace swayaw::app {

/// A dimensionless coefficient or index of the linear ship.
struct LinearRow {
  const char* name;
  Estimate estimate;
};

/// What was found, and the ship that was given.
struct LinearAnswer {
  std::string name;
  LinearFit fit;
  std::vector<LinearRow> rows;
  std::optional<SwayYawCoefficients<double>> before;  ///< of the ship file, at its service speed
  double L;                                           ///< [m]
  std::string stability;                              ///< in words
};

/// The page of a linear identification.
Page linear_page(const LinearAnswer& answer, const std::vector<Recording>& runs, const IdentifyArguments& arguments);

}  // namespace swayaw::app

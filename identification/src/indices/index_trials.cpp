#include "index_trials.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "swayaw/core/steering_gear.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

namespace swayaw::inline identification::detail {
namespace {

template <class Indices>
Eigen::VectorXd picked(const Indices& indices, const MeasuredTrial& trial) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(trial.indices.size()));
  for (std::size_t k = 0; k < trial.indices.size(); ++k)
    result[static_cast<Eigen::Index>(k)] = indices.*Indices::parameters()[trial.indices[k].place].member;
  return result;
}

template <class Indices>
Eigen::MatrixXd picked_slopes(const Indices& slopes, const MeasuredTrial& trial, std::size_t parameters) {
  const auto rows = static_cast<Eigen::Index>(trial.indices.size()), columns = static_cast<Eigen::Index>(parameters);
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(rows, columns, missing);
  for (std::size_t k = 0; k < trial.indices.size(); ++k) {
    const Slopes& row = slopes.*Indices::parameters()[trial.indices[k].place].member;
    if (!row.empty())
      result.row(static_cast<Eigen::Index>(k)) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), columns);
  }
  return result;
}

/// Slowest decay of a small disturbance of a steady turn, −max Re(pole) L/U.
double decay_of(const Ship& ship, const TurningCircle& circle, const TurnOrder& order) {
  if (!circle.steady) return missing;
  const auto rudder = RudderMotion<>::ordered(steering_gear(ship), 0.0, 0.0, rudder_sign(order.side) * order.rudder);
  const auto controls = with_rudder(circle.propulsion, rudder.at(circle.steps.back().to));
  const auto poles = linearize(ship, {*circle.steady, controls}).poles;
  const auto slowest = std::ranges::max(poles, {}, [](const std::complex<double>& p) { return p.real(); });
  return -slowest.real() * length(ship) / speed(*circle.steady);
}

/// Key of an index in the list of its manoeuvre.
std::string_view key_of(const MeasuredTrial& trial, const MeasuredIndex& index) {
  const bool turn = std::holds_alternative<TurnOrder>(trial.manoeuvre);
  return turn ? CircleIndices<>::parameters()[index.place].key : ZigzagIndices<>::parameters()[index.place].key;
}

/// The way made needs samples.
bool asks_for_way(const MeasuredTrial& trial) {
  return std::ranges::any_of(trial.indices,
                             [&](const MeasuredIndex& i) { return key_of(trial, i) == "initial_turning"; });
}

}  // namespace

bool asks_for_steady_turn(const MeasuredTrial& trial) {
  return std::ranges::any_of(trial.indices,
                             [&](const MeasuredIndex& i) { return key_of(trial, i).starts_with("final_"); });
}

int IndexTrials::turns() const {
  return static_cast<int>(std::ranges::count_if(
      trials(), [](const MeasuredTrial& t) { return std::holds_alternative<TurnOrder>(t.manoeuvre); }));
}

ManoeuvreOptions IndexTrials::options_for(const MeasuredTrial& trial) const {
  return {.speed = measured_.speed,
          .rev = measured_.rev,
          .thrust = measured_.thrust,
          .sampled = asks_for_way(trial),
          .traced = true};
}

void IndexTrials::count(const MeasuredTrial& trial, std::size_t times) {
  (std::holds_alternative<TurnOrder>(trial.manoeuvre) ? simulations_.turns : simulations_.zigzags) +=
      static_cast<int>(times);
}

SimulatedTrial IndexTrials::simulate(const Ship& ship, const MeasuredTrial& trial) {
  const auto options = options_for(trial);
  count(trial);
  if (const auto* order = std::get_if<TurnOrder>(&trial.manoeuvre)) {
    auto circle = turning_circle(ship, *order, options);
    auto indices = picked(indices_of(circle, order->side), trial);
    const double decay = asks_for_steady_turn(trial) ? decay_of(ship, circle, *order) : missing;
    return {std::move(circle), std::move(indices), decay};
  }
  auto run = zigzag(ship, std::get<ZigzagOrder>(trial.manoeuvre), options);
  auto indices = picked(indices_of(run), trial);
  return {std::move(run), std::move(indices), missing};
}

Eigen::MatrixXd IndexTrials::slopes(const Ship& ship, const MeasuredTrial& trial, const SimulatedTrial& simulated,
                                    std::span<const Parameter> parameters) {
  const auto options = options_for(trial);
  count(trial, (parameters.size() + slopes_at_once - 1) / slopes_at_once);
  if (const auto* order = std::get_if<TurnOrder>(&trial.manoeuvre))
    return picked_slopes(index_slopes(ship, *order, options, std::get<TurningCircle>(simulated.run), parameters), trial,
                         parameters.size());
  const auto& order = std::get<ZigzagOrder>(trial.manoeuvre);
  return picked_slopes(index_slopes(ship, order, options, std::get<Zigzag>(simulated.run), parameters), trial,
                       parameters.size());
}

}  // namespace swayaw::identification::detail

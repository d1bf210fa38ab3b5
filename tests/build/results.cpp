// Numbers that should not depend on the compiler, one a line: a name and the value to the last bit.
// tests/build/compilers.sh compares what two compilers make of them.
#include <fmt/format.h>

#include <random>
#include <span>
#include <string>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/identification/linear_fit.hpp"
#include "swayaw/identification/regression.hpp"
#include "swayaw/identification/state_estimate.hpp"
#include "swayaw/linear/batch.hpp"
#include "swayaw/linear/frequency_response.hpp"
#include "swayaw/linear/inversion.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/linear/loop.hpp"
#include "swayaw/linear/uncertainty.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/equilibria.hpp"
#include "swayaw/nonlinear/linearization.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulation/batch.hpp"
#include "swayaw/nonlinear/simulator.hpp"

namespace {

using namespace swayaw;

void print(const std::string& name, double value) { fmt::print("{} {:.17g}\n", name, value); }

template <class Part>
void print_parameters(const std::string& name, const Part& part) {
  for (const auto& p : Part::parameters()) print(fmt::format("{}.{}", name, p.key), part.*p.member);
}

// ---------------------------------------------------------------- linear

constexpr LinearZigzagOrder linear_order{.rudder = radians(20), .heading = radians(20), .rate = 0.6};

void print_zigzag(const std::string& name, const LinearZigzag<double>& zigzag) {
  for (std::size_t i = 0; i < zigzag.reversals.size(); ++i) {
    const auto& r = zigzag.reversals[i];
    print(fmt::format("{}.execute{}", name, i + 1), r.execute);
    print(fmt::format("{}.peak{}", name, i + 1), r.peak);
    print(fmt::format("{}.overshoot{}", name, i + 1), r.overshoot);
  }
}

/// Six zigzags at once, with that instruction set.
void print_batch(const std::string& name, const SwayYawCoefficients<double>& m, InstructionSet set) {
  std::array<std::vector<double>, 6> columns;
  for (int i = 0; i < 6; ++i) {
    const double factor = 1.0 + 0.02 * i;
    const std::array numbers{m.a1 * factor, m.b1, m.c1, m.a2, m.b2 * factor, m.c2 / factor};
    for (std::size_t k = 0; k < 6; ++k) columns[k].push_back(numbers[k]);
  }
  const ShipColumns ships{columns[0], columns[1], columns[2], columns[3], columns[4], columns[5]};
  const auto table = zigzag_batch(ships, linear_order, {.threads = 1, .set = set});
  for (std::size_t i = 0; i < 6; ++i) {
    print(fmt::format("{}.overshoot{}", name, i + 1), table.overshoot[table.at(0, i)]);
    print(fmt::format("{}.peak{}", name, i + 1), table.peak[table.at(1, i)]);
  }
}

void print_linear(const std::string& name, const LinearShip& ship) {
  const auto m = coefficients(ship);
  const auto i = steering_indices(m);
  const auto h = transfer_functions(m);
  print_parameters(name, m);
  print_parameters(name, i);
  print_parameters(name + ".back", coefficients_from(i));
  print(name + ".condition", condition_number(m));
  if (const auto t = time_constants(h)) print(name + ".T1", t->T1), print(name + ".T2", t->T2);
  for (const auto& point : bode(rudder_to_yaw(h), logarithmic_frequencies(0.01, 10.0, 4), {.L = 100.0, .U = 7.0})) {
    print(fmt::format("{}.gain_at_{:.2g}", name, point.frequency), point.gain);
    print(fmt::format("{}.phase_at_{:.2g}", name, point.frequency), point.phase);
  }
  if (const auto c = crossover(h, 2.0)) print(name + ".margin", c->phase_margin);
  print_zigzag(name + ".zigzag", linear_zigzag(m, linear_order));
  print_batch(name + ".one_by_one", m, InstructionSet::numbers);
  print_batch(name + ".in_packs", m, InstructionSet::baseline);
}

// ---------------------------------------------------------------- nonlinear

void print_state(const std::string& name, const ShipState<double>& state) {
  print(name + ".x", state.x);
  print(name + ".y", state.y);
  print(name + ".psi", state.psi);
  print(name + ".u", state.motion.u);
  print(name + ".v", state.motion.v);
  print(name + ".r", state.motion.r);
}

/// Steps of one size, with the rudder to port, then to starboard; forces by part at the end.
void print_simulated(const std::string& name, const Ship& ship) {
  const double second = time_unit_of(ship) / 50.0;
  Simulator simulator(ship);
  simulator.order_rudder(0.3);
  for (int k = 0; k < 300; ++k) simulator.step(second);
  print_state(name + ".turning", simulator.state());
  simulator.order_rudder(-0.2);
  for (int k = 0; k < 200; ++k) simulator.step(second);
  print_state(name + ".turned_back", simulator.state());
  for (const auto& part : simulator.forces()) print(fmt::format("{}.Y_{}", name, part.name), part.force.Y);
}

void print_manoeuvres(const std::string& name, const Ship& ship) {
  const auto run = zigzag(ship, {.rudder = radians(10), .heading = radians(10)}, {.sampled = false});
  for (std::size_t i = 0; i < run.reversals.size() && i < 2; ++i) {
    print(fmt::format("{}.time{}", name, i + 1), run.reversals[i].time);
    print(fmt::format("{}.overshoot{}", name, i + 1), run.reversals[i].overshoot.value_or(0.0));
  }
  const auto straight = straight_course(ship, service_speed(ship));
  const auto linear = linearize(ship, straight, Side::starboard);
  print_parameters(name, sway_yaw(linear.whole, linear.scale));
}

void print_fleet(const std::string& name, const Ship& ship, InstructionSet set) {
  std::vector<MmgShip<double>> fleet(4, std::get<MmgShip<double>>(ship.model));
  for (std::size_t i = 0; i < fleet.size(); ++i) fleet[i].hull.N_v *= 1.0 + 0.02 * static_cast<double>(i);
  const auto batch = zigzag_batch(fleet, {.rudder = radians(10), .heading = radians(10)},
                                  {.reversals = 2, .batch = {.threads = 1, .set = set}});
  for (std::size_t i = 0; i < fleet.size(); ++i)
    print(fmt::format("{}.overshoot{}", name, i + 1), batch.overshoot[batch.at(0, i)]);
}

// ---------------------------------------------------------------- identification

/// The filter alone, with noise that is known: nothing is iterated.
void print_filtered(const std::string& name, const Ship& ship, const Recording& run) {
  const double U = service_speed(ship), L = length(ship);
  EstimationOptions options{.process_noise = ProcessNoise{{1e-3 * U * U / L, 1e-3 * U * U / L, 1e-3 * U * U / L / L}},
                            .smooth = false};
  options.noise[index_of(Channel::x)] = options.noise[index_of(Channel::y)] = 1e-3 * L;
  options.noise[index_of(Channel::psi)] = 1e-3;
  options.noise[index_of(Channel::u)] = options.noise[index_of(Channel::v)] = 1e-3 * U;
  options.noise[index_of(Channel::r)] = 1e-3 * U / L;
  const auto estimate = estimate_states(ship, run, options);
  print(name + ".log_likelihood", estimate.noise.log_likelihood);
  for (const std::size_t part : {3u, 2u, 1u}) {
    const auto& at = estimate.states[estimate.states.size() / part - 1];
    print_state(fmt::format("{}.{}", name, 4 - part), at.state);
    print(fmt::format("{}.{}.deviation", name, 4 - part), std::sqrt(at.covariance(5, 5)));
  }
}

void print_regression(const std::string& name) {
  std::mt19937_64 engine(7);
  const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53) - 0.5; };
  Design design{.names = {"a", "b", "c", "d"}, .X = Eigen::MatrixXd(200, 4), .y = Eigen::VectorXd(200)};
  for (Eigen::Index t = 0; t < 200; ++t) {
    for (Eigen::Index j = 0; j < 4; ++j) design.X(t, j) = number();
    design.y[t] = design.X.row(t).dot(Eigen::Vector4d(1.0, -2.0, 0.5, 0.1)) + 0.1 * number();
  }
  const auto fit = regress(design);
  for (const auto& c : fit.coefficients) {
    print(fmt::format("{}.{}", name, c.name), c.estimate.value);
    print(fmt::format("{}.{}.deviation", name, c.name), c.estimate.standard_error);
  }
  print(name + ".rms", fit.residual_rms);
  print(name + ".condition", fit.condition_number);
}

void print_linear_fit(const std::string& name, const Recording& run, double L) {
  const auto fit = fit_linear(run, {.L = L});
  print(name + ".Kw", fit.indices.Kw.value);
  print(name + ".T3w", fit.indices.T3w.value);
  print(name + ".a1", fit.coefficients.a1.value);
  print(name + ".b2", fit.coefficients.b2.value);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return fmt::print(stderr, "results SHIPS RECORDINGS\n"), 2;
  const std::filesystem::path ships = arguments[1], recordings = arguments[2];
  for (const auto* name : {"tanker97", "tanker97_abc"})
    print_linear(name, read_linear_ship(ships / fmt::format("{}.toml", name)));
  for (const auto* name : {"kvlcc2_l7", "mariner", "wpcc_pi", "wpcc_pu", "nawigator_n7"}) {
    const auto ship = read_ship(ships / fmt::format("{}.toml", name));
    print_simulated(fmt::format("{}.simulated", name), ship);
    print_manoeuvres(fmt::format("{}.manoeuvres", name), ship);
  }
  const auto tanker = read_ship(ships / "kvlcc2_l7.toml");
  print_fleet("fleet.one_by_one", tanker, InstructionSet::numbers);
  print_fleet("fleet.in_packs", tanker, InstructionSet::baseline);
  const auto run = read_recording(recordings / "weak_rudder_zz10_10.csv").recording;
  print_filtered("filter", tanker, run);
  print_linear_fit("linear_fit", run, length(tanker));
  print_regression("regression");
}

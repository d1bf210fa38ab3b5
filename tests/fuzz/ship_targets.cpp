#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "swayaw/core/refusal.hpp"
#include "swayaw/identification/measured_indices.hpp"
#include "swayaw/linear/linear_ship_file.hpp"
#include "swayaw/linear/zigzag.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/simulator.hpp"
#include "targets.hpp"

namespace swayaw::fuzz {
namespace {

constexpr double ten_degrees = 10.0 * std::numbers::pi / 180.0;

/// What is asked of a ship that reads: an answer, or a sentence why there is none.
template <class Ask>
void answers(Ask&& ask) {
  const auto require_sentence = [](const std::exception& why) {
    const std::string_view text = why.what();
    promise(!text.empty() && text.find_first_of("\r\n") == std::string_view::npos,
            "an answer is refused without words");
  };
  try {
    ask();
  } catch (const Refusal& why) {
    require_sentence(why);
  } catch (const std::domain_error& why) {
    require_sentence(why);
  }
}

// ---------------------------------------------------------------- ships

void require_finite(const Recording& run) {
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r})
    promise(std::ranges::all_of(run[channel], [](double value) { return !std::isinf(value); }), "a sample is infinite");
  for (const auto channel : {Channel::u, Channel::v, Channel::r, Channel::psi})
    promise(std::ranges::none_of(run[channel], [](double value) { return std::isnan(value); }),
            "a simulated motion is not a number");
}

/// 10/10 zigzag and turn, short and with the error of a sketch; then a minute by the fixed steps of a simulator.
void sail(const Ship& ship) {
  const ManoeuvreOptions sketch{.duration = 15.0 * time_unit_of(ship), .tolerance = 1e-4};
  answers([&] { require_finite(zigzag(ship, {ten_degrees, ten_degrees}, sketch).run); });
  answers([&] { require_finite(turning_circle(ship, {ten_degrees}, sketch).run); });
  answers([&] {
    Simulator live(ship, {.longest_step = 0.05});
    live.order_rudder(ten_degrees);
    const double dt = 0.05 * time_unit_of(ship);
    for (int i = 0; i < 100; ++i) live.step(dt);
    const auto& m = live.state().motion;
    promise(std::isfinite(m.u + m.v + m.r), "the simulator left the finite numbers");
  });
}

void ship(std::string_view bytes, const std::filesystem::path& file) {
  const auto ship = parse_ship(bytes, file);
  const auto written = ship_text(ship);
  promise(ship_text(parse_ship(written, file)) == written, "a ship does not survive writing");
  sail(ship);
}

void linear_ship(std::string_view bytes, const std::filesystem::path& file) {
  const auto ship = parse_linear_ship(bytes, file);
  const auto written = ship_text(ship);
  promise(ship_text(parse_linear_ship(written, file)) == written, "a linear ship does not survive writing");
  answers([&] {
    const auto made = linear_zigzag(coefficients(ship), {ten_degrees, ten_degrees, ten_degrees, Side::port, 4, 30.0});
    for (const auto& reversal : made.reversals)
      promise(!std::isnan(reversal.overshoot), "an overshoot is not a number");
  });
}

// ---------------------------------------------------------------- indices

void indices(std::string_view bytes, const std::filesystem::path& file) {
  constexpr double L = 12.0;  // of the ship [m]
  for (const auto& trial : parse_indices(bytes, file, L).trials)
    for (const auto& index : trial.indices)
      promise(std::isfinite(index.value) && index.deviation > 0.0, "a measured index is no number with a deviation");
}

constexpr std::array targets{
    Target{"ship", "ship.toml", true, 0.5, "ship files of all models, sailed", ship},
    Target{"linear_ship", "ship.toml", true, 0.7, "linear ship files, sailed", linear_ship},
    Target{"indices", "indices.toml", true, 1.0, "measured indices of `tune`", indices},
};

}  // namespace

std::span<const Target> ship_targets() { return targets; }

}  // namespace swayaw::fuzz

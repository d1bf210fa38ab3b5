#include "verdict.hpp"

#include <algorithm>
#include <cmath>

#include "replay_errors.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// How large a force that follows nothing may be over the force on the hull, root mean square: so far the form of
/// simulated ships of another structure, to which files were fitted, was off.
constexpr double ordinary_form = 0.2;

/// A form alone, without a name, that makes up more than this of the force on the hull, root mean square, explains
/// nothing: 0.27 for the KVLCC2 in her published form, 0.55 and 0.66 where a state that nobody knows was hidden.
constexpr double largest_form = 0.4;

/// Force that follows one thing over the force on the hull, root mean square: what it is at least, a standard error of
/// its share below the estimate, since a share that may as well be ordinary is no finding.
double surely_off_by(const ForceBudget& b, Follows follows) {
  const auto i = static_cast<std::size_t>(follows);
  return std::sqrt(std::max(0.0, (b.share[i] - b.standard_error[i]) * b.size));
}

/// Across or about the vertical; along, a log that is read in coarse steps and a propulsion that is not recorded do as
/// much.
bool is_across(const ForceBudget& b) { return b.quantity != "surge_force"; }

/// Of what it is judged by in replays, over its variation: those four 0.16 to 0.47; the KVLCC2 in a tank, whose process
/// noise is 15 times the ordinary, 0.04; of the heading, two clean ships in waves of 0.7 L/U 0.03, a tug in waves 0.15.
constexpr double unexplained_discrepancy = 0.1;

/// Whether nothing has a name, the process noise is large and replays err by much. A name alone ends that: the wind
/// over the Esso Osaka is right and leaves 22 % of 27 %, her form is wrong besides.
bool is_much_left(const Diagnosis& d) {
  if (!d.effects.empty() || !(d.process_noise > unexplained_scale)) return false;
  const auto left = discrepancy_of(d.train, d.holdout, judged_by(d));
  return left && left->after > unexplained_discrepancy;
}

/// Whether force or moment across that follows nothing is larger than an ordinary error of the form, or the form itself
/// is too large to be one, and no effect but the form has a name; or nothing at all has one and much is left.
bool is_unexplained(const Diagnosis& d) {
  if (is_much_left(d)) return true;
  const auto is_form = [](const FoundEffect& e) { return id_of(e.effect) == form_id; };
  const auto is_large = [](const ForceBudget& b) {
    return is_across(b) && surely_off_by(b, Follows::nothing) > ordinary_form;
  };
  return std::ranges::all_of(d.effects, is_form) && ((!is_in_waves(d) && std::ranges::any_of(d.budget, is_large)) ||
                                                     (!d.effects.empty() && has_large_form(d.budget)));
}

}  // namespace

bool is_nameless(const FoundEffect& e) { return std::holds_alternative<UnknownForce<double>>(e.effect); }

bool may_be_a_wind(const Ship& ship, const Effect& effect) {
  return follows(effect) == Follows::earth && place_of(effect) == EffectPlace::force &&
         !feels_wind(ship.surroundings.windage);
}

void put_wind_beside_waves(Diagnosis& d, const Ship& ship) {
  constexpr double one_of_two = 0.5;
  for (auto& e : d.effects) {
    if (!may_be_a_wind(ship, e.effect)) continue;
    e.probability *= one_of_two;
    e.indistinguishable_from.emplace_back(SteadyWind<>::id);
    const auto candidate = std::ranges::find(d.candidates, id_of(e.effect), &Candidate::effect);
    if (candidate != d.candidates.end()) candidate->probability *= one_of_two;
  }
}

bool is_in_waves(const Diagnosis& d) {
  constexpr double half = 0.5;
  return d.runs_in_waves >= half;
}

Quantity judged_by(const Diagnosis& d) { return is_in_waves(d) ? Quantity::heading : Quantity::yaw_rate; }

bool has_large_form(std::span<const ForceBudget> budget) {
  return std::ranges::any_of(
      budget, [](const ForceBudget& b) { return is_across(b) && surely_off_by(b, Follows::form) > largest_form; });
}

DiagnosisVerdict verdict_of(const Diagnosis& d, bool on_board) {
  if (std::ranges::any_of(d.effects, is_nameless) || (on_board ? is_unexplained(d) : d.process_noise > ordinary_scale))
    return DiagnosisVerdict::unexplained;
  return d.effects.empty() ? DiagnosisVerdict::nothing_missing : DiagnosisVerdict::missing_physics;
}

}  // namespace swayaw::mismatch::detail

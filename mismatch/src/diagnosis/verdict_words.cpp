#include "verdict_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <span>
#include <vector>

#include "../missing_force/budget.hpp"
#include "verdict.hpp"
#include "words.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

/// ", as a constant push to starboard from 514 to 856 s, 0.3 lengths before midship"
std::string push_words(const UnknownForce<double>& push) {
  const double lever = push.N_0 / push.Y_0;
  constexpr double on_the_hull = 0.6;  // lengths from midship, with what the lever is uncertain by
  const bool sideways = std::abs(push.Y_0) > std::abs(push.X_0) && std::abs(lever) < on_the_hull;
  const auto when = fmt::format("from {:.5g} to {:.5g} s", push.onset, push.end);
  if (!sideways) return ", as a constant push " + when;
  return fmt::format(", as a constant push to {} {}, {:.2f} lengths {} midship", push.Y_0 > 0.0 ? "starboard" : "port",
                     when, std::abs(lever), lever > 0.0 ? "before" : "behind");
}

/// ", as a drag that grows with the square of the speed, 14 ± 3 m to starboard of the centreline: look for weed, a line
/// or damage on that side"; the side where it is told.
std::string drag_words(std::span<const ParameterEstimate> parameters) {
  const std::string words = ", as a drag that grows with the square of the speed";
  constexpr double told = 2.0;  // standard errors from the centreline: 95 %
  const auto place = std::ranges::find(parameters, "drag_y_m", &ParameterEstimate::key);
  if (place == parameters.end() || std::abs(place->value) < told * place->standard_error)
    return words + ", on which side is not told: look for fouling, weed, a line or damage";
  return fmt::format("{}, {:.2g} ± {:.1g} m to {} of the centreline: look for weed, a line or damage on that side",
                     words, std::abs(place->value), place->standard_error, place->value > 0.0 ? "starboard" : "port");
}

/// What acts that has no name, in words that go on with "; " or ", ": a push by its time, else its place, what it goes
/// with, and the terms of its map if there is one.
std::string what_unknown_goes_with(const Diagnosis& d) {
  std::string words;
  const auto place = std::ranges::max_element(d.location, {}, &MismatchPlace::share);
  if (place != d.location.end())
    words += fmt::format("; it acts on the {}", place->quantity == "yaw_moment"   ? "yaw moment"
                                                : place->quantity == "sway_force" ? "sway force"
                                                                                  : "surge force");
  const auto unknown = std::ranges::find_if(d.effects, is_nameless);
  if (unknown != d.effects.end()) {
    const auto& force = std::get<UnknownForce<double>>(unknown->effect);
    if (std::isfinite(force.onset)) return words + push_words(force);
    if (force.drag != 0.0) return words + drag_words(unknown->parameters);
  }
  if (place != d.location.end()) words += ", " + place->where;
  if (!d.symmetry.empty()) words += "; " + d.symmetry;
  if (unknown == d.effects.end()) return words;
  std::vector<std::string> terms;
  for (const auto& p : unknown->parameters) terms.push_back(p.key);
  return words + fmt::format("; as a map it has the terms {}", listed(terms));
}

std::string unknown_words(const Diagnosis& d) {
  return "Something real is missing that no known effect explains" + what_unknown_goes_with(d);
}

/// "added mass" of "added_mass".
std::string plain_name(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Whether something is missing that is not what it acts like.
bool lacks_a_name(const Diagnosis& d) { return !d.too_large.empty(); }

/// Of numbers beyond two deviations; the three that are furthest off, and what they come to at the rudder.
std::string shifted_words(const Diagnosis& d) {
  const auto shifts = std::span(d.shifts);
  constexpr std::size_t most = 3;
  std::vector<std::string> moved;
  for (const auto& s : shifts.first(std::min(most, shifts.size())))
    moved.push_back(fmt::format("{} from {:.3g} to {:.3g}, {:.1f} of its deviations", s.key, s.given, s.refitted,
                                std::abs(s.deviations)));
  const std::string others = shifts.size() > most ? fmt::format("; and {} more", shifts.size() - most) : "";
  const auto& part = shifts.front().part;
  const bool of_one = std::ranges::all_of(shifts, [&](const BaselineShift& s) { return s.part == part; });
  const bool is_said = d.moved && d.moved->rudder_force;
  const auto together = d.rudder_force && !is_said ? "; all in all " + rudder_force_words(*d.rudder_force) : "";
  return fmt::format("{}umbers of the {} are further off than was said: {}{}{}.",
                     lacks_a_name(d) ? "N" : "No physics is missing, but n", of_one ? plain_name(part) : "model",
                     fmt::join(moved, "; "), others, together);
}

/// "f_alpha from 2.75 to 2.31 (-16 %)"
std::string change_words(const BaselineShift& s) {
  const auto share = s.given != 0.0 ? fmt::format(" ({:+.0f} %)", 100.0 * (s.refitted / s.given - 1.0)) : "";
  return fmt::format("{} from {:.3g} to {:.3g}{}", s.key, s.given, s.refitted, share);
}

/// ", most of it by those of the rudder alone, to 7 %: f_alpha from 2.75 to 2.31 (-16 %)"
std::string moved_words(const MovedPart& moved) {
  std::vector<std::string> changes;
  for (const auto& s : moved.most) changes.push_back(change_words(s));
  const auto together = moved.rudder_force ? ", together " + rudder_force_words(*moved.rudder_force) : "";
  return fmt::format(", most of it by those of the {} alone, to {} %: {}{}", plain_name(moved.part),
                     in_two_digits(100.0 * moved.discrepancy), listed(changes), together);
}

/// Verdict in words, how well the baseline is known left out.
std::string verdict_words(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const auto& e : d.effects)
    if (!is_nameless(e)) names.push_back(phrase_of(e.effect));
  std::string traces;
  if (!d.as_form.empty())
    traces += fmt::format(" Not told from an error in the form of her forces: {}.", fmt::join(d.as_form, ", "));
  if (!d.traces.empty()) traces += fmt::format(" A trace, too small to matter: {}.", fmt::join(d.traces, ", "));
  if (lacks_a_name(d))
    traces += fmt::format(" Something without a name acts like {}, but larger than that can be.", listed(d.too_large));
  if (d.verdict == DiagnosisVerdict::nothing_missing)
    return (!d.shifts.empty() ? shifted_words(d)
            : lacks_a_name(d) ? "Nothing that has a name is missing."
            : d.moved         ? "No physics is missing: numbers of the ship file are off, within what was said of them."
                      : "Nothing is missing: the model explains the runs within its confidence and their noise.") +
           traces;
  if (d.verdict == DiagnosisVerdict::missing_physics)
    return fmt::format("The model leaves out {}.{}", listed(names), traces);
  const auto unknown = unknown_words(d);
  if (names.empty()) return unknown + "." + traces;
  if (d.process_noise <= ordinary_scale)
    return fmt::format("{}. Besides, the model leaves out {}.{}", unknown, listed(names), traces);
  std::string nearest = listed(names);
  nearest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(nearest[0])));
  return fmt::format("{}. {} {} nearest and {} not explain it all.{}", unknown, nearest,
                     names.size() > 1 ? "come" : "comes", names.size() > 1 ? "do" : "does", traces);
}

/// "The yaw rate is off by 39 % of its variation as given, by 7 % with the coefficients moved within their confidence,
/// by 5 % with what was found. "
std::string discrepancy_words(const Diagnosis& d) {
  if (!d.discrepancy) return {};
  const auto& by = *d.discrepancy;
  auto words = fmt::format(
      "The yaw rate is off by {} % of its variation as given, by {} % with the coefficients moved within what is known "
      "of them",
      in_two_digits(100.0 * by.given), in_two_digits(100.0 * by.refitted));
  if (d.moved) words += moved_words(*d.moved);
  if (!d.effects.empty()) words += fmt::format(", by {} % with what was found", in_two_digits(100.0 * by.after));
  return words + ". ";
}

}  // namespace

std::string unknown_depends_on(const Diagnosis& d) {
  constexpr std::size_t joined = 2;  // letters
  const auto words = what_unknown_goes_with(d);
  return words.size() > joined ? words.substr(joined) : words;
}

std::string words_of(const Diagnosis& d) {
  auto words = discrepancy_words(d) + verdict_words(d);
  if (is_in_waves(d))
    words += " Waves move the ship: a force that follows nothing else may be theirs, and is not counted.";
  if (std::ranges::any_of(d.effects, [&](const FoundEffect& e) { return may_be_a_wind(d.refitted, e.effect); }))
    words += " The force of waves may be that of a wind, which was not tried: give areas above water in [windage].";
  return d.prior_inflation > 1.0
             ? fmt::format("{} The baseline's numbers are known {:.0f} times less well than was said.", words,
                           d.prior_inflation)
             : words;
}

}  // namespace swayaw::mismatch::detail

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "swayaw/core/angle.hpp"
#include "swayaw/nonlinear/effects/effect.hpp"

/// An effect in the coordinates that a search moves.
namespace swayaw::inline nonlinear {

/// One coordinate of an effect: 0 or `centre` where little is known, of order 1 where the effect has its usual size.
struct Coordinate {
  std::string name;
  double centre = 0.0;     ///< mean before any data
  double deviation = 1.0;  ///< standard deviation before any data
  double step = 0.02;      ///< of differences
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  bool acts = false;  ///< of an effect that can be seen without acting: it acts where one of these is told from 0
};

/// An effect as a function of coordinates. Wind, stream and waves go by their north and east parts, since a direction
/// means nothing where the speed is 0; a depth by its inverse.
template <class E>
struct SearchForm {
  std::string id;  ///< as in ship files
  std::vector<Coordinate> coordinates;
  std::function<E(std::span<const double>)> at;
  std::vector<std::vector<double>> starts;  ///< where fits begin: an effect that is not linear has several valleys
  std::vector<double> window{};  ///< its last two coordinates, onset and end, where most force is missing; empty where
                                 ///< it has none
  std::function<SearchForm(std::span<const std::size_t>)>
      with_terms{};  ///< the same of some of its coordinates, where each is a term by itself
};

/// What a form needs to know of the ship and the runs.
struct SearchContext {
  std::span<const Parameter> parameters;  ///< of the effect, those that the model has a place for; at least one
  double time_unit;                       ///< L/U [s]
  double duration;                        ///< of the longest run [s]
  double rudder_rate;                     ///< of the steering gear [rad/s]

  /// The parameter of that key, which must be there.
  const Parameter& operator[](std::string_view key) const {
    return *std::ranges::find(parameters, key, &Parameter::key);
  }
};

// ---------------------------------------------------------------- one coordinate, one parameter

/// A parameter of an effect as a function of a coordinate.
struct ParameterMove {
  Coordinate coordinate;
  std::size_t index;  ///< of the parameter
  std::function<double(double)> value;
};

/// From null in prior deviations, within the parameter's range.
inline ParameterMove from_null(const Parameter& p) {
  const double low =
      p.range.low > -HUGE_VAL ? (p.range.low - p.null) / p.deviation + (p.range.above_low ? 1e-3 : 0.0) : -HUGE_VAL;
  const double high = p.range.high < HUGE_VAL ? (p.range.high - p.null) / p.deviation : HUGE_VAL;
  return {{.name = std::string(p.key), .low = low, .high = high},
          p.index,
          [null = p.null, deviation = p.deviation](double c) { return null + deviation * c; }};
}

/// From null between two values of the parameter.
inline ParameterMove from_null(const Parameter& p, double least, double most) {
  auto move = from_null(p);
  move.coordinate.low = (least - p.null) / p.deviation, move.coordinate.high = (most - p.null) / p.deviation;
  return move;
}

/// Between which factors a parameter may be searched.
struct FactorRange {
  double low = 0.02, high = 50.0;
};

/// A positive parameter that is known but for a factor: exp(c) times its null value.
inline ParameterMove by_factor(const Parameter& p, double deviation, const FactorRange& range = {}) {
  return {{.name = std::string(p.key),
           .deviation = deviation,
           .step = 0.05,
           .low = std::log(range.low),
           .high = std::log(range.high)},
          p.index,
          [null = p.null](double c) { return null * std::exp(c); }};
}

/// A time of a run, in L/U: it may be anywhere in it.
inline ParameterMove in_run(const Parameter& p, const SearchContext& context) {
  const double whole = context.duration / context.time_unit;
  return {{.name = std::string(p.key), .centre = 0.5 * whole, .deviation = whole, .low = 0.0, .high = whole},
          p.index,
          [unit = context.time_unit](double c) { return c * unit; }};
}

template <class Kind>
double& parameter_value(Kind& effect, std::size_t index) {
  return effect.*parameter_list<Kind>[index].member;
}

template <class Kind>
SearchForm<Kind> by_moves(const Kind& null, std::vector<ParameterMove> moves, std::vector<std::vector<double>> starts) {
  SearchForm<Kind> form{.id = std::string(Kind::id), .coordinates = {}, .at = {}, .starts = std::move(starts)};
  for (const auto& m : moves) form.coordinates.push_back(m.coordinate);
  form.at = [null, moves = std::move(moves)](std::span<const double> c) {
    Kind effect = null;
    for (std::size_t i = 0; i < moves.size(); ++i) parameter_value(effect, moves[i].index) = moves[i].value(c[i]);
    return effect;
  };
  return form;
}

// ---------------------------------------------------------------- terms

/// Parameters that a coordinate moves from null.
struct Term {
  struct Moved {
    ParameterMove parameter;  ///< from null in prior deviations
    double share = 1.0;       ///< of a deviation, for each unit of the coordinate
  };
  Coordinate coordinate;
  std::vector<Moved> moved;
};

/// The coefficient of which a parameter is one side: `gamma_R` of `gamma_R_positive`; empty for others.
constexpr std::string_view coefficient_of_side(std::string_view key) {
  for (const std::string_view side : {"_positive", "_negative"})
    if (key.ends_with(side)) return key.substr(0, key.size() - side.size());
  return {};
}

/// What both sides of a coefficient change alike, then what they differ by. Counted one by one, a flow straightening
/// that is larger on both sides by one factor had two numbers to pay for, and another `l_R` with one stood in its
/// place in three of three nearly exact cases of docs/concealed.md.
inline std::array<Term, 2> terms_of_sides(const Parameter& a, const Parameter& b) {
  constexpr double apart = 0.5;  // of the deviation of a side: sides of a hull are more alike than she is to her file
  const auto coefficient = coefficient_of_side(a.key);
  const auto one = from_null(a), other = from_null(b);
  const Coordinate both{.name = std::string(coefficient) + " of both sides",
                        .low = std::max(one.coordinate.low, other.coordinate.low),
                        .high = std::min(one.coordinate.high, other.coordinate.high)},
      between{.name = std::string(coefficient) + " between sides"};
  return {Term{both, {{one}, {other}}}, Term{between, {{one, apart}, {other, -apart}}}};
}

/// A term for each parameter, but for two sides of a coefficient.
inline std::vector<Term> terms_of(std::span<const Parameter> parameters) {
  std::vector<Term> terms;
  for (auto p = parameters.begin(); p != parameters.end(); ++p) {
    const auto is_other_side = [&](const Parameter& q) {
      const auto coefficient = coefficient_of_side(p->key);
      return !coefficient.empty() && q.key != p->key && coefficient_of_side(q.key) == coefficient;
    };
    if (std::any_of(parameters.begin(), p, is_other_side)) continue;
    const auto other = std::find_if(p, parameters.end(), is_other_side);
    if (other == parameters.end()) terms.push_back({from_null(*p).coordinate, {{from_null(*p)}}});
    else std::ranges::move(terms_of_sides(*p, *other), std::back_inserter(terms));
  }
  return terms;
}

/// Terms that add up; parameters that none of them moves stay at null.
template <class Kind>
SearchForm<Kind> by_terms(const Kind& null, std::vector<Term> terms) {
  SearchForm<Kind> form{
      .id = std::string(Kind::id), .coordinates = {}, .at = {}, .starts = {std::vector<double>(terms.size(), 0.0)}};
  for (const auto& term : terms) form.coordinates.push_back(term.coordinate);
  if (terms.size() > 1)
    form.with_terms = [null, terms](std::span<const std::size_t> kept) {
      std::vector<Term> some;
      for (const auto i : kept) some.push_back(terms[i]);
      return by_terms(null, std::move(some));
    };
  form.at = [null, terms = std::move(terms)](std::span<const double> c) {
    std::array<double, parameter_list<Kind>.size()> deviations{};
    for (std::size_t k = 0; k < terms.size(); ++k)
      for (const auto& [p, share] : terms[k].moved) deviations[p.index] += share * c[k];
    Kind effect = null;
    for (const auto& term : terms)
      for (const auto& [p, share] : term.moved)
        parameter_value(effect, p.index) =
            p.value(std::clamp(deviations[p.index], p.coordinate.low, p.coordinate.high));
    return effect;
  };
  return form;
}

/// Each parameter from null in prior deviations; more than one are terms.
template <class Kind>
SearchForm<Kind> by_parameters(const Kind& null, std::span<const Parameter> parameters) {
  return by_terms(null, terms_of(parameters));
}

// ---------------------------------------------------------------- directions and times

/// North and east part of what has a size and a direction, over its usual size; then further parameters.
template <class Kind>
SearchForm<Kind> by_parts(const Kind& null, const Parameter& size, const Parameter& direction,
                          std::vector<ParameterMove> further = {}) {
  SearchForm<Kind> form{.id = std::string(Kind::id), .coordinates = {{"north"}, {"east"}}, .at = {}, .starts = {}};
  for (const auto& m : further) form.coordinates.push_back(m.coordinate);
  for (int i = 0; i < 4; ++i) {
    form.starts.push_back({std::cos(0.4 + 0.5 * pi * i), std::sin(0.4 + 0.5 * pi * i)});
    for (const auto& m : further) form.starts.back().push_back(m.coordinate.centre);
  }
  form.at = [null, a = size.index, b = direction.index, unit = size.deviation,
             further = std::move(further)](std::span<const double> c) {
    Kind effect = null;
    parameter_value(effect, a) = unit * std::hypot(c[0], c[1]);
    parameter_value(effect, b) = from_north(std::atan2(c[1], c[0]));
    for (std::size_t i = 0; i < further.size(); ++i)
      parameter_value(effect, further[i].index) = further[i].value(c[2 + i]);
    return effect;
  };
  return form;
}

/// An effect that lasts at least a twentieth of L/U.
template <BeginsAndEnds Kind>
Kind not_too_short(Kind effect, double time_unit) {
  effect.end = std::max(effect.end, effect.onset + 0.05 * time_unit);
  return effect;
}

/// Starts of a form whose last two coordinates are onset and end: a quarter of the run, from four times on.
inline std::vector<std::vector<double>> starts_in_run(const std::vector<std::vector<double>>& before, double whole) {
  std::vector<std::vector<double>> starts;
  for (const auto& start : before)
    for (const double from : {0.1, 0.3, 0.5, 0.7}) {
      starts.push_back(start);
      starts.back().insert(starts.back().end(), {from * whole, (from + 0.25) * whole});
    }
  return starts;
}

// ---------------------------------------------------------------- defaults

/// The form of an effect that says nothing else: north and east parts of what has a direction, else each parameter.
template <class Kind>
SearchForm<Kind> usual_form(const Kind& null, const SearchContext& context) {
  const Parameter *size = nullptr, *direction = nullptr;
  for (const auto& p : context.parameters) {
    if (p.decides && !size) size = &p;
    if (p.direction && !direction) direction = &p;
  }
  return direction ? by_parts(null, *size, *direction) : by_parameters(null, context.parameters);
}

}  // namespace swayaw::nonlinear

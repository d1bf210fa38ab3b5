#include "swayaw/nonlinear/surroundings/recorded_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "swayaw/core/detail/median.hpp"
#include "swayaw/nonlinear/effects/acting_in_wind.hpp"
#include "swayaw/nonlinear/instruments/instruments.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

namespace swayaw::inline nonlinear {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

bool has_wind(const Recording& run) { return run.has(Channel::wind_speed) && run.has(Channel::wind_from); }

// ---------------------------------------------------------------- wind

/// The two columns, without what the instruments did to them.
Recording true_wind(const Recording& run, const Instruments<double>& instruments) {
  Recording wind;
  wind.time = run.time;
  for (const auto channel : {Channel::wind_speed, Channel::wind_from})
    wind.channels[index_of(channel)] = run.channels[index_of(channel)];
  return instruments == Instruments<>{} ? wind : as_it_was(std::move(wind), instruments);
}

/// Velocity of the air at each sample; none where both columns are nowhere there together.
struct Air {
  std::vector<double> north, east;
};

Air air_of(const Recording& wind) {
  const auto speed = wind[Channel::wind_speed], from = wind[Channel::wind_from];
  Recording vector;
  vector.time = wind.time;
  auto north = vector.fill(Channel::u), east = vector.fill(Channel::v);
  for (std::size_t i = 0; i < wind.samples(); ++i) {
    north[i] = -speed[i] * std::cos(from[i]);
    east[i] = -speed[i] * std::sin(from[i]);
  }
  if (!vector.has(Channel::u)) return {};
  const Interpolant bridged_north(vector, Channel::u), bridged_east(vector, Channel::v);
  Air air;
  for (const double time : wind.time) air.north.push_back(bridged_north(time)), air.east.push_back(bridged_east(time));
  return air;
}

/// Mean of straight lines through samples from one to another; of a single sample its value.
double mean_of(const std::vector<double>& time, const std::vector<double>& values, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) sum += 0.5 * (values[i] + values[i + 1]) * (time[i + 1] - time[i]);
  return from == to ? values[from] : sum / (time[to] - time[from]);
}

/// The last sample of a piece that begins with one.
std::size_t end_of_piece(const std::vector<double>& time, std::size_t from, double longest) {
  auto to = std::min(from + 1, time.size() - 1);
  while (to + 1 < time.size() && time[to + 1] - time[from] <= longest) ++to;
  return to;
}

// ---------------------------------------------------------------- depth

std::optional<double> draught_of(const Ship& ship) {
  return std::visit(
      [](const auto& model) -> std::optional<double> {
        if constexpr (requires { model.particulars.d; }) return model.particulars.d;
        else return std::nullopt;
      },
      ship.model);
}

bool tells_depth(const Effect& effect) {
  const auto* water = std::get_if<ShallowWater<>>(&effect);
  return water && std::isfinite(water->depth_over_draught);
}

/// Least depth over draught that the effect knows.
double least_depth() { return ShallowWater<>::parameters()[0].range.low; }

std::string depth_in_vain(const Ship& ship, double depth) {
  const auto draught = draught_of(ship);
  const auto why = cannot_act(ship.model, ShallowWater<>{2.0});
  if (!draught || !why.empty()) return fmt::format("the depth of {:.4g} m is not used: {}", depth, why);
  if (depth < least_depth() * *draught)
    return fmt::format(
        "the depth of {:.4g} m is not used: it is {:.3g} draughts, and shallow water is known from {:g} on", depth,
        depth / *draught, least_depth());
  return {};
}

}  // namespace

std::vector<WindPiece> recorded_wind(const Ship& ship, const Recording& run) {
  if (!has_wind(run) || !feels_wind(ship.surroundings.windage)) return {};
  const auto air = air_of(true_wind(run, instruments_of(ship)));
  if (air.north.empty()) return {};
  const double longest = wind_averaging * time_unit_of(ship);
  std::vector<WindPiece> pieces;
  for (std::size_t from = 0, to; pieces.empty() || from + 1 < run.samples(); from = to) {
    to = end_of_piece(run.time, from, longest);
    pieces.push_back({pieces.empty() ? -forever : run.time[from], mean_of(run.time, air.north, from, to),
                      mean_of(run.time, air.east, from, to)});
  }
  return pieces;
}

std::span<const WindPiece> wind_between(std::span<const WindPiece> wind, double from, double to) {
  if (wind.empty()) return wind;
  const auto first = std::ranges::upper_bound(wind, from, {}, &WindPiece::time) - 1,
             end = std::ranges::lower_bound(wind, to, {}, &WindPiece::time);
  return {first, std::max(first + 1, end)};
}

Surroundings<double> with_recorded_wind(Surroundings<double> rest, const WindPiece& recorded) {
  const double speed = rest.windy ? rest.wind.speed : 0.0;
  const double north = recorded.north - speed * std::cos(rest.wind.from),
               east = recorded.east - speed * std::sin(rest.wind.from);
  rest.wind = {std::hypot(north, east), std::atan2(-east, -north)};
  rest.windy = rest.wind.speed > 0.0;
  return rest;
}

std::vector<Change> changes_in_wind(const Change& before, std::span<const Change> own,
                                    std::span<const WindPiece> wind) {
  std::vector<Change> all;
  Change now = before;  // of her own
  std::size_t k = 0;
  const auto add = [&](const WindPiece& piece, double time) {
    const auto around = with_recorded_wind({.windage = {}, .wind = now.wind, .current = {}, .windy = now.windy}, piece);
    all.push_back({time, around.wind, around.windy, now.acting});
  };
  for (std::size_t i = 0; i < wind.size(); ++i) {
    const double end = i + 1 < wind.size() ? wind[i + 1].time : forever;
    for (; k < own.size() && own[k].time <= wind[i].time; ++k) now = own[k];
    add(wind[i], i == 0 ? -forever : wind[i].time);
    for (; k < own.size() && own[k].time < end; ++k) now = own[k], add(wind[i], now.time);
  }
  return all;
}

std::vector<Change> all_changes(const Ship& ship, std::span<const WindPiece> wind) {
  const auto around = surroundings_at(ship, -forever);
  const Change before{-forever, around.wind, around.windy, acting_at(ship.effects, -forever)};
  const auto own = changes_of(ship);
  if (!wind.empty()) return changes_in_wind(before, own, wind);
  std::vector all{before};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

std::optional<double> recorded_depth(const Recording& run) {
  if (run.facts.water_depth || !run.has(Channel::depth)) return run.facts.water_depth;
  std::vector<double> depth(run[Channel::depth].begin(), run[Channel::depth].end());
  std::erase_if(depth, [](double x) { return std::isnan(x); });
  return core::detail::median_of(std::move(depth));
}

std::optional<Ship> in_depth(const Ship& ship, const std::optional<double>& depth) {
  const auto draught = draught_of(ship);
  if (!depth || !draught || std::ranges::any_of(ship.effects, tells_depth)) return std::nullopt;
  const double ratio = *depth / *draught;
  if (ratio < least_depth() || ratio > deep_water) return std::nullopt;
  Ship result = ship;
  const auto is_shallow = [](const Effect& e) { return std::holds_alternative<ShallowWater<>>(e); };
  const auto own = std::ranges::find_if(result.effects, is_shallow);
  if (own == result.effects.end()) result.effects.push_back(ShallowWater<>{ratio});
  else std::get<ShallowWater<>>(*own).depth_over_draught = ratio;
  if (!cannot_act(result.model, ShallowWater<>{ratio}).empty()) return std::nullopt;
  return result;
}

std::vector<std::string> measured_in_vain(const Ship& ship, const Recording& run) {
  std::vector<std::string> words;
  if (run.has(Channel::wind_speed) != run.has(Channel::wind_from))
    words.push_back("the measured wind is not used: it needs both, wind_speed and wind_from");
  else if (has_wind(run) && !feels_wind(ship.surroundings.windage))
    words.push_back(
        "the measured wind is not used: the ship file has no [windage], which tells what she shows the wind "
        "(docs/formats.md)");
  if (const auto depth = recorded_depth(run))
    if (auto why = depth_in_vain(ship, *depth); !why.empty()) words.push_back(std::move(why));
  return words;
}

}  // namespace swayaw::nonlinear

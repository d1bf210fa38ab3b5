#include "column_names.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

#include "column_name_table.hpp"
#include "name_words.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/detail/csv_text.hpp"
#include "time_cell.hpp"

namespace swayaw::inline core::detail {
namespace {

using Words = std::vector<std::string>;

constexpr double two_turns = 4.0 * pi, right_angle = 0.5 * pi;
constexpr double sixty_knots = 60.0 * 1852.0 / 3600.0;

/// In the order of the enumerators. The largest values are those of ships: 60 kn, 300 deg/min of a launch hard over
/// fall below 1 rad/s, models of ships turn their shafts below 60 1/s, no wind is above 75 m/s.
constexpr std::array quantity_facts{
    QuantityFacts{"time", "time", Measure::time, 0.0},
    QuantityFacts{"date", "", Measure::none, 0.0},
    QuantityFacts{"heading", "psi", Measure::angle, 0.0},
    QuantityFacts{"magnetic heading", "psi", Measure::angle, two_turns},
    QuantityFacts{"course over ground", "cog", Measure::angle, 0.0},
    QuantityFacts{"a course", "", Measure::angle, 0.0},
    QuantityFacts{"yaw rate", "r", Measure::yaw_rate, 1.0},
    QuantityFacts{"rudder angle", "delta", Measure::angle, right_angle},
    QuantityFacts{"ordered rudder angle", "delta_order", Measure::angle, right_angle},
    QuantityFacts{"speed through the water", "stw", Measure::speed, sixty_knots},
    QuantityFacts{"speed over ground", "sog", Measure::speed, sixty_knots},
    QuantityFacts{"a speed", "", Measure::speed, sixty_knots},
    QuantityFacts{"latitude", "lat", Measure::angle, right_angle},
    QuantityFacts{"longitude", "lon", Measure::angle, two_turns / 2.0},
    QuantityFacts{"position northward", "x", Measure::length, 0.0},
    QuantityFacts{"position eastward", "y", Measure::length, 0.0},
    QuantityFacts{"surge velocity", "u", Measure::speed, sixty_knots},
    QuantityFacts{"sway velocity", "v", Measure::speed, sixty_knots},
    QuantityFacts{"velocity over ground, forward", "ug", Measure::speed, sixty_knots},
    QuantityFacts{"velocity over ground, to starboard", "vg", Measure::speed, sixty_knots},
    QuantityFacts{"shaft speed", "rev", Measure::frequency, 60.0},
    QuantityFacts{"thrust", "thrust", Measure::force, 0.0},
    QuantityFacts{"torque", "torque", Measure::moment, 0.0},
    QuantityFacts{"roll", "phi", Measure::angle, right_angle},
    QuantityFacts{"true wind speed", "wind_speed", Measure::speed, 75.0},
    QuantityFacts{"true wind direction", "wind_from", Measure::angle, 0.0},
    QuantityFacts{"a wind speed", "", Measure::speed, 75.0},
    QuantityFacts{"a wind direction", "", Measure::angle, 0.0},
    QuantityFacts{"relative wind speed", "", Measure::speed, 75.0},
    QuantityFacts{"relative wind angle", "", Measure::angle, 0.0},
    QuantityFacts{"water depth", "depth", Measure::length, 0.0},
};
static_assert(quantity_facts.size() == static_cast<std::size_t>(Quantity::depth) + 1);

/// Words that say nothing of which quantity it is.
constexpr std::array<std::string_view, 36> fillers{
    "act",      "actual",   "al",  "avg", "ca",     "data",    "de",     "del",  "der",   "des",      "el",     "fb",
    "feedback", "filtered", "het", "in",  "ist",    "istwert", "la",     "mean", "meas",  "measured", "of",     "os",
    "over",     "own",      "raw", "s",   "sensor", "ships",   "signal", "the",  "value", "van",      "vessel", "wert"};

constexpr std::array<std::string_view, 14> starboard_words{"starboard", "stbd",       "stb",      "sb",    "steuerbord",
                                                           "styrbord",  "stuurboord", "estribor", "right", "rechts",
                                                           "stdb",      "ugen",       "sbd",      "rh"};
constexpr std::array<std::string_view, 14> port_words{"port",  "bb", "backbord", "babord", "bakboord", "babor", "left",
                                                      "links", "ps", "larboard", "sagen",  "prt",      "pt",    "lh"};

bool is_one_of(std::string_view word, auto const& words) { return std::ranges::count(words, word) > 0; }

ShipSide side_of(std::string_view word) {
  if (is_one_of(word, starboard_words)) return ShipSide::starboard;
  return is_one_of(word, port_words) ? ShipSide::port : ShipSide::none;
}

std::string joined(const Words& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The same for all orders of the words and without fillers.
std::string key_of(Words words) {
  const auto is_filler = [](const std::string& word) { return is_one_of(word, fillers); };
  if (!std::ranges::all_of(words, is_filler)) std::erase_if(words, is_filler);
  std::ranges::sort(words);
  return joined(words);
}

std::string glued(const Words& words) {
  std::string text;
  for (const auto& word : words) text += word;
  return text;
}

using NameIndex = std::unordered_map<std::string, std::vector<Quantity>>;

/// All names by their key, and written as one word by that.
const NameIndex& name_index() {
  static const NameIndex index = [] {
    NameIndex names;
    const auto add = [&](const std::string& key, Quantity quantity) {
      auto& known = names[key];
      if (std::ranges::count(known, quantity) == 0) known.push_back(quantity);
    };
    for (const auto& row : name_table)
      for (auto rest = row.names; !rest.empty();) {
        const auto words = words_of(take(rest, '|'));
        add(key_of(words), row.quantity);
        if (words.size() > 1) add(glued(words), row.quantity);
      }
    return names;
  }();
  return index;
}

/// The quantity of that name; where a name has two, the unit decides.
std::optional<Quantity> quantity_of(const Words& words, const std::optional<Unit>& unit) {
  const auto fits = [&](Quantity q) { return !unit || facts_of(q).measure == unit->measure; };
  for (const auto& key : {key_of(words), glued(words)}) {
    const auto found = name_index().find(key);
    if (found == name_index().end()) continue;
    const auto fitting = std::ranges::find_if(found->second, fits);
    return fitting == found->second.end() ? found->second.front() : *fitting;
  }
  return std::nullopt;
}

/// The one quantity whose names begin like this: "Wendegeschw." is short for one.
std::optional<Quantity> quantity_of_short(const Words& words) {
  constexpr std::size_t enough = 5;  // letters
  const auto begin = glued(words);
  std::optional<Quantity> found;
  if (begin.size() < enough) return found;
  for (const auto& [key, quantities] : name_index()) {
    if (!key.starts_with(begin)) continue;
    if (quantities.size() > 1 || (found && found != quantities.front())) return std::nullopt;
    found = quantities.front();
  }
  return found;
}

/// A name in pieces: words outside of brackets, words inside, and the unit where a bracket holds one.
struct NamePieces {
  std::string base;
  std::string remark;
  std::optional<Unit> unit;
};

NamePieces pieces_of(std::string_view name) {
  NamePieces pieces;
  while (!name.empty()) {
    const auto open = name.find_first_of("[({");
    pieces.base += name.substr(0, open);
    if (open == std::string_view::npos) break;
    const auto close = std::min(name.find_first_of("])}", open), name.size());
    auto inside = name.substr(open + 1, close - open - 1);
    name.remove_prefix(std::min(close + 1, name.size()));
    pieces.base += ' ';
    while (!inside.empty()) {
      const auto part = trimmed(take(inside, ','));
      if (const auto unit = unit_named(part); unit && !pieces.unit) pieces.unit = unit;
      else pieces.remark.append(" ").append(part);
    }
  }
  return pieces;
}

/// "ROT °/min", "psi_deg", "Heading°": the unit at the end of a name without brackets, taken off it.
std::optional<Unit> take_unit(std::string& base) {
  for (std::size_t i = 1; i < base.size(); ++i) {
    const auto rest = std::string_view(base).substr(i);
    const bool separator = std::string_view(" _,/.").find(base[i]) != std::string_view::npos;
    const bool sign = rest.starts_with("\xC2\xB0") || rest.starts_with("\xC2\xBA");
    if (!separator && !sign) continue;
    if (const auto unit = unit_named(trimmed(rest.substr(separator ? 1 : 0)))) {
      base.resize(i);
      return unit;
    }
  }
  return std::nullopt;
}

/// "Shaft rpm", "Elapsed seconds": units that are the name itself.
std::optional<Unit> unit_among(const Words& words) {
  for (const auto& word : words)
    if (word == "rpm" || word == "rps" || word == "seconds") return unit_named(word);
  return std::nullopt;
}

/// Takes words for a side, or the number of one of two, out. @return the side, or of 1 and 2 port and starboard
ShipSide take_side(Words& words) {
  ShipSide side = ShipSide::none;
  std::erase_if(words, [&](const std::string& word) {
    const auto found = word == "1" || word == "p"   ? ShipSide::port
                       : word == "2" || word == "s" ? ShipSide::starboard
                                                    : side_of(word);
    if (found != ShipSide::none) side = found;
    return found != ShipSide::none;
  });
  return side;
}

bool may_have_sides(std::optional<Quantity> q) {
  return q == Quantity::rudder || q == Quantity::rudder_order || q == Quantity::shaft_speed || q == Quantity::thrust ||
         q == Quantity::torque;
}

bool is_positive(std::string_view word) { return word == "+" || word.starts_with("positiv") || word == "pos"; }

bool is_sign(std::string_view word) { return is_positive(word) || word == "-" || word.starts_with("negativ"); }

/// What the words of a name tell, with and without the side and the remarks in brackets.
void find_quantity(NamedColumn& column, const std::string& base, const std::string& remark) {
  for (auto words : {words_of(base + ' ' + remark), words_of(base)}) {
    const auto of_sign = [](const std::string& word) { return is_positive(word) || side_of(word) != ShipSide::none; };
    if (!column.rudder_positive.empty()) std::erase_if(words, of_sign);
    column.quantity = quantity_of(words, column.unit);
    if (column.quantity) return;
    auto unnumbered = words;
    std::erase_if(unnumbered,
                  [](const std::string& word) { return word.find_first_not_of("0123456789") == word.npos; });
    const auto side = take_side(words);
    column.quantity = quantity_of(unnumbered, column.unit);  // "Gyro 1"
    if (column.quantity && !may_have_sides(column.quantity)) return;
    column.quantity.reset();
    if (side == ShipSide::none) continue;
    column.quantity = quantity_of(words, column.unit);
    if (!may_have_sides(column.quantity)) column.quantity.reset();
    if (!column.quantity) continue;
    column.side = side;
    return;
  }
}

/// "Time (UTC+2)", "Uhrzeit MESZ".
std::optional<int> zone_in(std::string_view name) {
  constexpr std::array<std::string_view, 7> zones{"utc", "gmt", "cest", "cet", "mesz", "mez", "jst"};
  const auto words = words_of(name);
  for (const auto zone : zones) {
    if (!is_one_of(zone, words)) continue;
    const auto small = lower_case(name);
    const auto at = small.find(zone);
    const auto offset = zone_named(small.substr(at, small.find_first_of("])} _", at) - at));
    return offset ? offset : zone_named(zone);
  }
  return std::nullopt;
}

}  // namespace

ShipSide side_named(std::string_view word, bool letters) {
  const auto small = lower_case(word);
  if (letters && (small == "s" || small == "p")) return small == "s" ? ShipSide::starboard : ShipSide::port;
  return side_of(small);
}

const QuantityFacts& facts_of(Quantity quantity) { return quantity_facts[static_cast<std::size_t>(quantity)]; }

std::string positive_side_in(std::string_view text) {
  const auto words = words_of(text, true);
  const auto is_side = [](const std::string& word) { return side_of(word) != ShipSide::none; };
  const auto first_side = std::ranges::find_if(words, is_side);
  const auto first_sign = std::ranges::find_if(words, is_sign);
  const auto positive = std::ranges::find_if(words, is_positive);
  if (first_side == words.end() || positive == words.end()) return {};
  const bool side_follows = first_sign < first_side;
  const auto after = std::find_if(positive, words.end(), is_side);
  const auto before = std::find_if(std::make_reverse_iterator(positive), words.rend(), is_side);
  if (side_follows ? after == words.end() : before == words.rend()) return {};
  return side_of(side_follows ? *after : *before) == ShipSide::starboard ? "starboard" : "port";
}

NamedColumn named_column(std::string_view name, std::string_view units) {
  auto [base, remark, unit] = pieces_of(name);
  NamedColumn column{
      .quantity = {}, .unit = unit, .rudder_positive = positive_side_in(std::string(name) + ' ' + std::string(units))};
  if (!column.rudder_positive.empty()) remark.clear();
  if (!column.unit) column.unit = unit_named(units);
  find_quantity(column, base, remark);
  if (!column.unit || !column.quantity) {
    auto shorter = base;
    if (const auto at_end = take_unit(shorter)) {
      NamedColumn other{
          .quantity = {}, .unit = column.unit ? column.unit : at_end, .rudder_positive = column.rudder_positive};
      find_quantity(other, shorter, remark);
      if (other.quantity) column.quantity = other.quantity, column.unit = other.unit, column.side = other.side;
    }
  }
  if (!column.quantity && base.find('.') != std::string::npos) column.quantity = quantity_of_short(words_of(base));
  const auto words = words_of(name);
  if (!column.unit) column.unit = unit_among(words);
  column.zone_minutes = zone_in(name);
  if (!column.zone_minutes) column.zone_minutes = zone_in(units);
  return column;
}

}  // namespace swayaw::core::detail

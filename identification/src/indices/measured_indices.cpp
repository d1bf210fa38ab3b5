#include "swayaw/identification/measured_indices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/toml_text.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/manoeuvres/index_slopes.hpp"

namespace swayaw::inline identification {
namespace {

/// An end of a key, "_deg", and the SI value of its unit.
struct KeyUnit {
  std::string_view suffix;
  double si;
};

/// Units in which the file may give a quantity.
std::vector<KeyUnit> units_of(std::string_view unit, double L) {
  if (unit == "m") return {{"_m", 1.0}, {"_L", L}};
  if (unit == "rad") return {{"_deg", radians(1.0)}, {"_rad", 1.0}};
  if (unit == "rad/s") return {{"_rad_s", 1.0}, {"_deg_s", radians(1.0)}};
  if (unit == "m/s") return {{"_m_s", 1.0}, {"_kn", 1852.0 / 3600.0}};
  return {{"_s", 1.0}};
}

/// A key under which an index may stand.
struct IndexKey {
  std::string key;
  std::size_t place;  ///< of a list the place of its first number
  double si;
  Range range;
  bool list;
};

template <class Indices>
std::vector<IndexKey> index_keys(double L) {
  std::vector<IndexKey> keys;
  constexpr auto parameters = Indices::parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto bracket = parameters[i].key.find('[');
    const bool list = bracket != std::string_view::npos;
    if (list && parameters[i].key.substr(bracket) != "[0]") continue;
    for (const auto& u : units_of(parameters[i].unit, L))
      keys.push_back({std::string(parameters[i].key.substr(0, bracket)) + std::string(u.suffix), i, u.si,
                      parameters[i].range, list});
  }
  return keys;
}

constexpr std::size_t most_overshoots = 4;

class IndexFile : detail::TomlText {
 public:
  IndexFile(const toml::table& root, const std::filesystem::path& file, double L) : TomlText(root, file), L_(L) {}

  MeasuredIndices read() const {
    require_known(root(),
                  std::array<std::string_view, 6>{"speed_m_s", "rev_s", "thrust_N", "tolerance", "turn", "zigzag"}, {},
                  "");
    if (root().contains("rev_s") && root().contains("thrust_N"))
      fail(*root().get("thrust_N"), "thrust_N is given beside rev_s; one of them drives the ship");
    MeasuredIndices measured{.speed = positive_at(root(), "speed_m_s"),
                             .rev = positive_at(root(), "rev_s"),
                             .thrust = positive_at(root(), "thrust_N"),
                             .trials = {}};
    const double tolerance = positive_at(root(), "tolerance").value_or(default_index_tolerance);
    for (const auto* table : tables("turn")) measured.trials.push_back(turn(*table, tolerance));
    for (const auto* table : tables("zigzag")) measured.trials.push_back(zigzag(*table, tolerance));
    if (measured.trials.empty()) fail(root(), "there is neither a [[turn]] nor a [[zigzag]]");
    return measured;
  }

 private:
  void require_known(const toml::table& table, std::span<const std::string_view> known,
                     std::span<const IndexKey> indices, std::string_view where) const {
    for (auto&& [key, value] : table) {
      const auto name = key.str();
      if (std::ranges::find(known, name) != known.end() ||
          std::ranges::find(indices, name, &IndexKey::key) != indices.end())
        continue;
      fail(key.source().begin, fmt::format("{}{} is not known", name, where));
    }
  }

  std::optional<double> positive_at(const toml::table& table, std::string_view key) const {
    const auto* node = table.get(key);
    return node ? std::optional(number(*node, key, positive)) : std::nullopt;
  }

  double needed(const toml::table& table, std::string_view key, std::string_view where) const {
    const auto value = positive_at(table, key);
    if (!value) fail(table, fmt::format("{} is missing in {}", key, where));
    return *value;
  }

  Side side(const toml::table& table, std::string_view key) const {
    const auto* node = table.get(key);
    if (!node) return Side::starboard;
    const auto word = node->value_exact<std::string>();
    if (word == "port") return Side::port;
    if (word == "starboard") return Side::starboard;
    fail(*node, fmt::format("{} must be \"port\" or \"starboard\"", key));
  }

  std::vector<const toml::table*> tables(std::string_view key) const {
    std::vector<const toml::table*> result;
    const auto* node = root().get(key);
    if (!node) return result;
    const auto* list = node->as_array();
    if (!list || !list->is_homogeneous<toml::table>())
      fail(*node, fmt::format("{0}s are written as [[{0}]] tables", key));
    for (const auto& element : *list) result.push_back(element.as_table());
    return result;
  }

  // ---------------------------------------------------------------- an index

  /// A number, or { value = …, sd = … }.
  MeasuredIndex index(const toml::node& node, const IndexKey& key, std::size_t place, const std::string& name,
                      double tolerance) const {
    const auto* table = node.as_table();
    if (table)
      require_known(*table, std::array<std::string_view, 2>{"value", "sd"}, {}, fmt::format(" in {}", key.key));
    if (table && !table->contains("value")) fail(*table, fmt::format("value is missing in {}", key.key));
    const double value = number(table ? *table->get("value") : node, key.key, key.range);
    const auto deviation = table ? positive_at(*table, "sd") : std::nullopt;
    const MeasuredIndex result{.name = name,
                               .place = place,
                               .value = value * key.si,
                               .deviation = deviation.value_or(tolerance * std::abs(value)) * key.si,
                               .si = key.si};
    if (!std::isfinite(result.value) || !std::isfinite(result.deviation))
      fail(node, fmt::format("{} is too large, {}", key.key, value));
    if (!(result.deviation > 0.0))
      fail(node, fmt::format("{} = {} leaves no deviation; give {{ value = ..., sd = ... }}", key.key, value));
    return result;
  }

  void add_list(std::vector<MeasuredIndex>& indices, const toml::node& node, const IndexKey& key, std::size_t first,
                double tolerance) const {
    const auto* list = node.as_array();
    if (!list || list->empty()) fail(node, fmt::format("{} must be a list of numbers", key.key));
    if (first + list->size() > most_overshoots)
      fail(node, fmt::format("{} goes beyond the {} heading peaks that are sailed", key.key, most_overshoots));
    for (std::size_t i = 0; i < list->size(); ++i)
      indices.push_back(
          index(*list->get(i), key, key.place + first + i, fmt::format("{} {}", key.key, first + i + 1), tolerance));
  }

  std::vector<MeasuredIndex> indices_of(const toml::table& table, std::span<const IndexKey> keys,
                                        std::size_t first_peak, double tolerance, std::string_view where) const {
    std::vector<MeasuredIndex> indices;
    for (const auto& key : keys) {
      const auto* node = table.get(key.key);
      if (!node) continue;
      if (std::ranges::find(indices, key.place + (key.list ? first_peak : 0), &MeasuredIndex::place) != indices.end())
        fail(*node, fmt::format("{} is given twice, in two units", key.key));
      if (key.list) add_list(indices, *node, key, first_peak, tolerance);
      else indices.push_back(index(*node, key, key.place, key.key, tolerance));
    }
    if (indices.empty()) fail(table, fmt::format("{} has no index", where));
    return indices;
  }

  // ---------------------------------------------------------------- the manoeuvres

  MeasuredTrial turn(const toml::table& table, double tolerance) const {
    const auto keys = index_keys<CircleIndices<>>(L_);
    require_known(table, std::array<std::string_view, 3>{"rudder_deg", "side", "tolerance"}, keys, " in [[turn]]");
    const TurnOrder order{.rudder = radians(needed(table, "rudder_deg", "[[turn]]")), .side = side(table, "side")};
    return {order, indices_of(table, keys, 0, positive_at(table, "tolerance").value_or(tolerance), "[[turn]]")};
  }

  MeasuredTrial zigzag(const toml::table& table, double tolerance) const {
    const auto keys = index_keys<ZigzagIndices<>>(L_);
    require_known(table,
                  std::array<std::string_view, 5>{"rudder_deg", "heading_deg", "first", "first_peak", "tolerance"},
                  keys, " in [[zigzag]]");
    const ZigzagOrder order{.rudder = radians(needed(table, "rudder_deg", "[[zigzag]]")),
                            .heading = radians(needed(table, "heading_deg", "[[zigzag]]")),
                            .first = side(table, "first")};
    return {order, indices_of(table, keys, first_peak(table) - 1, positive_at(table, "tolerance").value_or(tolerance),
                              "[[zigzag]]")};
  }

  std::size_t first_peak(const toml::table& table) const {
    const auto* node = table.get("first_peak");
    if (!node) return 1;
    const auto peak = node->value_exact<std::int64_t>();
    if (!peak || *peak < 1 || *peak > static_cast<std::int64_t>(most_overshoots))
      fail(*node, fmt::format("first_peak must be a whole number from 1 to {}", most_overshoots));
    return static_cast<std::size_t>(*peak);
  }

  double L_;
};

}  // namespace

std::string name_of(const MeasuredManoeuvre& manoeuvre) {
  if (const auto* turn = std::get_if<TurnOrder>(&manoeuvre))
    return fmt::format("turn {:.6g} to {}", degrees(turn->rudder), name_of(turn->side));
  const auto& z = std::get<ZigzagOrder>(manoeuvre);
  return fmt::format("zigzag {:.6g}/{:.6g} first {}", degrees(z.rudder), degrees(z.heading), name_of(z.first));
}

MeasuredIndices parse_indices(std::string_view text, const std::filesystem::path& name, double L) {
  const auto root = detail::parsed_toml(text, name);
  return IndexFile(root, name, L).read();
}

MeasuredIndices read_indices(const std::filesystem::path& file, double L) {
  return parse_indices(read_text(file, FileUse::description), file, L);
}

}  // namespace swayaw::identification

#pragma once

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

/// Parameters in JSON: full precision, null for what is missing or not finite.
namespace swayaw::app {

using Json = nlohmann::ordered_json;

/// Without the sign of a zero.
inline Json number(double value) { return std::isfinite(value) ? Json(value + 0.0) : Json(nullptr); }

inline Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

inline Json parameters(std::span<const double> values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

/// Data for the script of a page.
nlohmann::json for_page(const Json& data);

/// Those keys of an object that are in the list: of a document, what the script of a page reads.
Json only(const Json& document, std::initializer_list<const char*> keys);

}  // namespace swayaw::app

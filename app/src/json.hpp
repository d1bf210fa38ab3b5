#pragma once

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

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

/// A document as text, with nothing in it that a terminal obeys: control characters and marks of direction in texts are
/// written "\u202e", which JSON reads back; bytes that are not UTF-8 are replaced.
std::string json_text(const Json& document);

/// Prints it on stdout.
void print_document(const Json& document);

/// Data for the script of a page. Texts are those that are shown: what would act is written out.
nlohmann::json for_page(const Json& document);

/// Those keys of an object that are in the list: of a document, what the script of a page reads.
Json only(const Json& document, std::initializer_list<const char*> keys);

}  // namespace swayaw::app

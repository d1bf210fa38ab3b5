#include "json.hpp"

#include <fmt/format.h>

#include "swayaw/core/detail/printable.hpp"

namespace swayaw::app {
namespace {

using core::detail::Lines;
using core::detail::printable;

constexpr auto replaced = Json::error_handler_t::replace;

/// Every text of the data as it is shown.
void make_printable(nlohmann::json& data) {
  if (data.is_string()) data = printable(data.get_ref<const std::string&>(), Lines::many);
  if (data.is_structured())
    for (auto& part : data) make_printable(part);
}

}  // namespace

// characters that act stand in texts only, where printable() writes them as JSON does
std::string json_text(const Json& document) { return printable(document.dump(2, ' ', false, replaced), Lines::many); }

void print_document(const Json& document) { fmt::print("{}\n", json_text(document)); }

nlohmann::json for_page(const Json& document) {
  auto data = nlohmann::json::parse(document.dump(-1, ' ', false, replaced));
  make_printable(data);
  return data;
}

Json only(const Json& document, std::initializer_list<const char*> keys) {
  Json chosen = Json::object();
  for (const char* key : keys)
    if (const auto found = document.find(key); found != document.end()) chosen[key] = *found;
  return chosen;
}

}  // namespace swayaw::app

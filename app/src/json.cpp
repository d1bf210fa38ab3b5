#include "json.hpp"

namespace swayaw::app {

nlohmann::json for_page(const Json& data) { return nlohmann::json::parse(data.dump()); }

Json only(const Json& document, std::initializer_list<const char*> keys) {
  Json chosen = Json::object();
  for (const char* key : keys)
    if (const auto found = document.find(key); found != document.end()) chosen[key] = *found;
  return chosen;
}

}  // namespace swayaw::app

#include "json.hpp"

namespace swayaw::app {

nlohmann::json for_page(const Json& document) { return nlohmann::json::parse(document.dump()); }

}  // namespace swayaw::app

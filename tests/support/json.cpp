#include "json.hpp"

#include <fstream>

namespace swayaw::test {

nlohmann::json json_of(const std::string& text) { return nlohmann::json::parse(text); }

nlohmann::json json_in(const std::filesystem::path& file) { return nlohmann::json::parse(std::ifstream(file)); }

}  // namespace swayaw::test

#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

/// Reading JSON, compiled once for all tests.
namespace swayaw::test {

nlohmann::json json_of(const std::string& text);

/// The file must be there.
nlohmann::json json_in(const std::filesystem::path& file);

}  // namespace swayaw::test

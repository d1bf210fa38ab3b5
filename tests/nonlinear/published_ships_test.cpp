#include "swayaw/nonlinear/published_ships.hpp"

#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "files.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw {
namespace {

TEST_CASE("the published ships are the files of the folder ships, letter by letter", "[nonlinear][second-route]") {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::ships)) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    const auto text = published_text(entry.path().stem().string());
    REQUIRE(text);
    CHECK(*text == read_text(entry.path()));
    ++files;
  }
  CHECK(published_ships().size() == files);
  CHECK(std::ranges::is_sorted(published_ships(), {}, &PublishedShip::name));
}

TEST_CASE("every published ship of a nonlinear model loads by her name", "[nonlinear]") {
  for (const auto& [name, text] : published_ships()) {
    INFO(name);
    if (model_of(text, name) == "linear") CHECK_THROWS_AS(published_ship(name), FileError);
    else CHECK(length(published_ship(name)) > 0.0);
  }
}

TEST_CASE("a name that no published ship has is refused with the names that there are", "[nonlinear][refusal]") {
  CHECK_THROWS_AS(published_ship("titanic"), Refusal);
  CHECK_THROWS_WITH(published_ship("titanic"),
                    ContainsSubstring("no published ship \"titanic\"") && ContainsSubstring("kvlcc2_l7"));
}

}  // namespace
}  // namespace swayaw

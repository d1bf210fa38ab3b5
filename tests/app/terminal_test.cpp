#include "../../app/src/terminal.hpp"

#include <algorithm>
#include <catch.hpp>

/// Words folded for a terminal.
namespace swayaw::app {
namespace {

constexpr const char* words =
    "  The yaw rate is off by 28 % of its variation as given, ± 3 deg/s, and much more to be said";

TEST_CASE("folded words keep every word and no line is wider", "[app][round-trip]") {
  for (const int columns : {20, 33, 60, 80}) {
    const auto text = folded(words, columns, 2);
    std::string again = text;
    for (auto at = again.find("\n  "); at != std::string::npos; at = again.find("\n  ")) again.replace(at, 3, " ");
    CHECK(again == words);
    std::size_t width = 0;
    for (const char c : text) {
      width = c == '\n' ? 0 : width + ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0);
      REQUIRE(width <= static_cast<std::size_t>(columns));
    }
  }
}

TEST_CASE("words to a file stay on one line, and a word wider than the terminal on its own", "[app][limit]") {
  CHECK(folded(words, 0) == words);
  CHECK(folded("a-word-without-any-blank b", 10) == "a-word-without-any-blank\nb");
}

TEST_CASE("a line that is too wide goes on below its last column, or below its first word", "[app]") {
  CHECK(fitted("  K   0.7   yaw rate by rudder to starboard, as owners have it   ", 40) ==
        "  K   0.7   yaw rate by rudder to\n            starboard, as owners have it");
  CHECK(fitted("  a sentence that is not a row", 20) == "  a sentence that is\n  not a row");
  CHECK(fitted("short  ", 20) == "short");
  CHECK(fitted("as long as it likes to be  ", 0) == "as long as it likes to be");
}

}  // namespace
}  // namespace swayaw::app

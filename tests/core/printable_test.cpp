#include "swayaw/core/detail/printable.hpp"

#include <catch.hpp>
#include <random>
#include <string>

/// Texts of others as they are shown.
namespace swayaw {
namespace {

using core::detail::Lines;
using core::detail::printable;

TEST_CASE("words of all languages are shown as they are", "[core]") {
  for (const std::string text :
       {"", "Esso Osaka, 3 m", "Yaw rate ω′", "Ålesund Øst", "大阪丸", "\U0001F6A2", "a\tb", "\\x1b"})
    CHECK(printable(text) == text);
}

TEST_CASE("what a terminal obeys is written out", "[core][refusal]") {
  CHECK(printable("\x1b]0;title\x07") == "\\u001b]0;title\\u0007");
  CHECK(printable("a\rb\bc\x7f") == "a\\u000db\\u0008c\\u007f");
  CHECK(printable("\xC2\x9B"
                  "31m") == "\\u009b31m");                      // the control sequence introducer in one character
  CHECK(printable("\xE2\x80\xAEgnp.exe") == "\\u202egnp.exe");  // from right to left
  CHECK(printable("a\xE2\x80\xA8"
                  "b") == "a\\u2028b");
  CHECK(printable(std::string("a\0b", 3)) == "a\\u0000b");
}

TEST_CASE("lines end where there may be several", "[core]") {
  CHECK(printable("one\ntwo") == "one\\u000atwo");
  CHECK(printable("one\ntwo", Lines::many) == "one\ntwo");
}

TEST_CASE("bytes that are not UTF-8 are written out", "[core][refusal]") {
  CHECK(printable("\xff") == "\\xff");
  CHECK(printable("\xC3(") == "\\xc3(");
  CHECK(printable("\xC0\xAF") == "\\xc0\\xaf");  // a slash in a form that is too long
  CHECK(printable("\xE0\x80\xAF") == "\\xe0\\x80\\xaf");
  CHECK(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");           // half a character
  CHECK(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond the last
  CHECK(printable("\xE2\x80") == "\\xe2\\x80");                    // broken off
}

TEST_CASE("what was shown once is shown the same again, whatever the bytes", "[core][limit]") {
  std::mt19937 engine(20);
  for (int i = 0; i < 2000; ++i) {
    std::string bytes(engine() % 12, '\0');
    for (char& c : bytes) c = static_cast<char>(engine());
    const auto once = printable(bytes);
    CHECK(printable(once) == once);
    for (const char c : once) REQUIRE((static_cast<unsigned char>(c) >= 0x20 || c == '\t'));
  }
}

}  // namespace
}  // namespace swayaw

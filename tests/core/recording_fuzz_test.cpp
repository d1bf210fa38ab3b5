#include <catch.hpp>
#include <cstdio>
#include <random>

#include "recording_text.hpp"

/// Damaged files are read or refused in one line; nothing else happens.
namespace swayaw {
namespace {

const std::string good =
    "\xEF\xBB\xBF# rudder_positive = \"starboard\"\n"
    "# reference_x_m = -1.5\r\n"
    "# manoeuvre = \"zigzag \\\"10/10\\\"\"\n"
    "# facility = { name = \"tank\", depths = [1, 2.5] }\n"
    "time_s,\"psi_deg\", lat_deg,lon_deg,delta_deg,r_deg_min,sog_kn,cog_deg,note\n"
    "0,350,54.1,10.2,10,,7,351,\"calm, dry\"\n"
    "1.5,2,54.1001,10.2001,nan,3,7,3,\n"
    "2,8,,10.2,-10,-2,7,9,Größe\n"
    "7e0,+20.5,54.1003,10.2003,-10,1,7,21,1";

/// Overwrites, removes, repeats or inserts a few bytes.
void damage(std::string& text, std::mt19937& random) {
  static const std::string telling = std::string(",\n\"#=\r;[]{}'.-+eE0\\ \t") + '\0' + "\xFF\xC3";
  const auto at = random() % text.size();
  const auto count = 1 + random() % 4;
  const char byte = random() % 2 == 0 ? telling[random() % telling.size()] : static_cast<char>(random());
  switch (random() % 5) {
    case 0: text[at] = byte; break;
    case 1: text.insert(at, count, byte); break;
    case 2: text.erase(at, count); break;
    case 3: text.insert(at, text.substr(random() % text.size(), random() % 60)); break;
    default: text.erase(at, random() % 60); break;
  }
  if (text.empty()) text.push_back('\n');
}

std::string damaged(unsigned seed) {
  std::mt19937 random(seed);
  std::string text = good;
  for (auto times = 1 + random() % 5; times > 0; --times) damage(text, random);
  return text;
}

bool is_one_line_with_place(const std::string& refusal) {
  std::size_t line = 0, column = 0;
  const bool has_place =
      std::sscanf(refusal.c_str(), "run.csv:%zu:%zu: ", &line, &column) == 2 && line > 0 && column > 0;
  return has_place && refusal.find_first_of("\r\n\x1b") == std::string::npos;
}

TEST_CASE("the undamaged file reads", "[core][fuzz]") { CHECK(test::recording_of(good).samples() == 4); }

TEST_CASE("a damaged file is refused in one line, or what was read survives writing", "[core][fuzz]") {
  int read = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    const auto text = damaged(seed);
    const auto refusal = test::refusal_of(text);
    if (!refusal.empty() && is_one_line_with_place(refusal)) continue;
    INFO("seed " << seed << "\n" << refusal << "\n" << text);
    REQUIRE(refusal.empty());
    const auto written = recording_text(test::recording_of(text));
    REQUIRE(recording_text(test::recording_of(written)) == written);
    ++read;
  }
  CHECK(read > 100);
}

TEST_CASE("random bytes are refused", "[core][fuzz]") {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    std::string junk(random() % 300, ' ');
    for (char& byte : junk) byte = static_cast<char>(random());
    REQUIRE(is_one_line_with_place(test::refusal_of(junk)));
  }
}

}  // namespace
}  // namespace swayaw

#include <random>

#include "import_truth.hpp"

/// Damaged raw files are refused in one line, or become a recording that reads; nothing else happens.
namespace swayaw {
namespace {

const std::string good =
    "Messfahrt;;;;;;\r\n# group = \"a\"\r\n"
    "Datum;Zeit;Kurs [°];Ruder port [°];Ruder stbd [°];Breite;Länge;Notiz\r\n"
    "12.03.2024;23:59:58,5;350,5;1,5;1,0;53°30.1'N;9°10'E;\"ruhig; klar\"\r\n"
    "12.03.2024;23:59:59,0;355,5;2,5;2,0;53°30.2'N;9°10'E;\r\n"
    "13.03.2024;00:00:00,0;0,5;n/a;2,0;53°30.3'N;9°10'E;Größe\r\n"
    "13.03.2024;00:00:01,0;5,5;3,5;-1;53°30.4'N;9°10'E;1\r\n";

void damage(std::string& text, std::mt19937& random) {
  static const std::string telling = std::string(",\n\"#=\r;[]{}'.-+eE0\\ \t:/NW") + '\0' + "\xFF\xC3\xB0";
  const auto at = random() % text.size();
  const char byte = random() % 3 != 0 ? telling[random() % telling.size()] : static_cast<char>(random());
  switch (random() % 5) {
    case 0: text[at] = byte; break;
    case 1: text.insert(at, 1 + random() % 4, byte); break;
    case 2: text.erase(at, 1 + random() % 4); break;
    case 3: text.insert(at, text.substr(random() % text.size(), random() % 60)); break;
    default: text.erase(at, random() % 60); break;
  }
  if (text.empty()) text.push_back('\n');
}

bool is_one_line_with_place(const std::string& refusal) {
  std::size_t line = 0, column = 0;
  return std::sscanf(refusal.c_str(), "log.csv:%zu:%zu: ", &line, &column) == 2 && line > 0 && column > 0 &&
         refusal.find_first_of("\r\n\x1b") == std::string::npos;
}

/// Whether the text was imported; what is not imported must be refused with its place.
bool import_survives(const std::string& text) {
  const auto refusal = test::import_refusal({text});
  INFO(refusal << "\n" << text);
  if (!refusal.empty()) {
    REQUIRE(is_one_line_with_place(refusal));
    return false;
  }
  const auto import = test::imported({text});
  INFO(import.text);
  const auto read = test::recording_of(import);
  REQUIRE(read.warnings.empty());
  return true;
}

TEST_CASE("the undamaged raw file is imported", "[core][import][fuzz]") { CHECK(import_survives(good)); }

TEST_CASE("a damaged raw file is refused in one line, or becomes a recording that reads", "[core][import][fuzz]") {
  int read = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    std::mt19937 random(seed);
    auto text = good;
    for (auto times = 1 + random() % 5; times > 0; --times) damage(text, random);
    INFO("seed " << seed);
    read += import_survives(text) ? 1 : 0;
  }
  CHECK(read > 100);
}

TEST_CASE("random bytes are refused by import", "[core][import][fuzz]") {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    std::string junk(random() % 300, ' ');
    for (char& byte : junk) byte = static_cast<char>(random());
    CHECK_FALSE(import_survives(junk));
  }
}

}  // namespace
}  // namespace swayaw

#include <catch.hpp>
#include <fstream>
#include <random>
#include <sstream>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/parts_reader.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"
#include "swayaw/nonlinear/ship_file.hpp"

namespace swayaw {
namespace {

// ---------------------------------------------------------------- text of a ship

/// Lines of a ship file.
using Lines = std::vector<std::string>;

Lines model_lines() {
  Lines lines;
  std::istringstream text(read_text(test::ships / "kvlcc2_l7.toml"));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const auto& line : lines) text.append(line).push_back('\n');
  return text;
}

/// Key of a line `key = value`; empty for other lines.
std::string key_of(const std::string& line) {
  const auto equals = line.find(" = ");
  return equals == std::string::npos || line.starts_with('#') ? std::string{} : line.substr(0, equals);
}

/// The line number, from 1, of the table header above a line.
std::size_t table_line(const Lines& lines, std::size_t line) {
  while (line > 0 && !lines[line].starts_with('[')) --line;
  return line + 1;
}

std::size_t line_of(const Lines& lines, const std::string& key) {
  const auto is_key = [&](const std::string& line) { return key_of(line) == key; };
  return static_cast<std::size_t>(std::ranges::find_if(lines, is_key) - lines.begin());
}

/// The KVLCC2 model with another value.
std::string text_with(const std::string& key, const std::string& value) {
  auto lines = model_lines();
  lines.at(line_of(lines, key)) = key + " = " + value;
  return joined(lines);
}

std::string text_with_tail(const std::string& tail) { return joined(model_lines()) + tail; }

Ship ship_of(const std::string& text) { return parse_ship(text, "ship.toml"); }

std::string refusal_of(const std::string& text) {
  try {
    ship_of(text);
    return {};
  } catch (const FileError& error) {
    return error.what();
  }
}

std::string place(std::size_t line, std::size_t column) {
  return "ship.toml:" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

// ---------------------------------------------------------------- good files

TEST_CASE("the MMG ships of the project load", "[nonlinear]") {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(test::ships)) {
    INFO(file.path());
    if (model_of(read_text(file.path()), file.path()) != "mmg") continue;
    const Ship ship = read_ship(file.path());
    CHECK_FALSE(ship.name.empty());
    CHECK(length(ship) > 0.0);
    ++count;
  }
  CHECK(count >= 2);
}

TEST_CASE("the MMG ships beside the project load", "[nonlinear]") {
  const auto folder = std::filesystem::path(SWAYAW_TEST_SHARED) / "ships";
  for (const auto* name : {"kvlcc2.toml", "kvlcc2_l7.toml"}) {
    if (std::filesystem::exists(folder / name)) CHECK(length(read_ship(folder / name)) > 0.0);
    else std::cout << "[skipped] no " << (folder / name).string() << "\n";
  }
}

/// Every number of the ship, in SI.
std::vector<double> numbers_of(const MmgShip<double>& ship) {
  std::vector<double> numbers;
  const auto add = [&](const auto& part) {
    for (const auto& p : part.parameters()) numbers.push_back(part.*p.member);
  };
  std::apply([&](const auto&... section) { (add(ship.*section.part), ...); }, MmgShip<double>::sections());
  return numbers;
}

TEST_CASE("every number of the KVLCC2 model is where it belongs, in SI", "[nonlinear][published]") {
  const Ship ship = read_ship(test::ships / "kvlcc2_l7.toml");
  const std::vector<double> expected{
      1000,  // water
      7,
      1.27,
      0.46,
      3.27,
      0.25,
      1.75,
      1.179,
      0.6,
      1.75,  // particulars
      0.022,
      0.223,
      0.011,  // added mass
      0.022,
      -0.04,
      0.002,
      0.011,
      0.771,  // hull X
      -0.315,
      0.083,
      -1.607,
      0.379,
      -0.391,
      0.008,  // hull Y
      -0.137,
      -0.049,
      -0.03,
      -0.294,
      0.055,
      -0.013,  // hull N
      0.216,
      -0.48,
      0.22,
      0.4,
      0.2931,
      -0.2753,
      -0.1385,
      2,
      1.6,
      1.1,
      0,
      0,
      0,  // propeller
      0.0539,
      0.345,
      -0.5,
      0.387,
      0.312,
      -0.464,
      -0.71,
      0.395,
      0.64,
      1.09,
      0.5,
      2.747,  // rudder
      0,
      0.5,
      0.05,
      0,
      0,  // its stall and gap
      radians(15.8),
      radians(35),
      0,
      0,  // steering gear
      0,  // engine
  };
  CHECK(ship.name == "KVLCC2 model 1:45.7 (L7)");
  CHECK(numbers_of(std::get<MmgShip<double>>(ship.model)) == expected);
}

TEST_CASE("an integer is a number, tables may be written inline, and the file may begin with a byte order mark",
          "[nonlinear]") {
  CHECK(length(ship_of(text_with("length_m", "7"))) == 7.0);
  auto lines = model_lines();
  const auto water = std::ranges::find(lines, "[water]");
  lines.erase(water, water + 2);
  lines.insert(lines.begin(), "\xEF\xBB\xBFwater = { density_kg_m3 = 1_026 }");
  CHECK(std::get<MmgShip<double>>(ship_of(joined(lines)).model).water.rho == 1026.0);
}

TEST_CASE("windage areas that are not given are zero", "[nonlinear][limit]") {
  auto lines = model_lines();
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line_of(lines, "frontal_area_m2")));
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line_of(lines, "lateral_area_m2")));
  const auto particulars = std::get<MmgShip<double>>(ship_of(joined(lines)).model).particulars;
  CHECK(particulars.A_front == 0.0);
  CHECK(particulars.A_lateral == 0.0);
}

// ---------------------------------------------------------------- keys

bool is_optional(const std::string& key) { return key == "frontal_area_m2" || key == "lateral_area_m2"; }

TEST_CASE("every key that is missing is named with the line of its table", "[nonlinear][refusal]") {
  const auto lines = model_lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto key = key_of(lines[i]);
    if (key.empty() || is_optional(key)) continue;
    auto less = lines;
    less[i].clear();
    const auto table = table_line(lines, i);
    INFO(key);
    if (table == 1) CHECK(refusal_of(joined(less)) == place(1, 1) + key + " is missing");
    else CHECK(refusal_of(joined(less)) == place(table, 1) + key + " is missing in " + lines[table - 1]);
  }
}

TEST_CASE("every key that is misspelt is named, where it stands, with the key that is missing",
          "[nonlinear][refusal]") {
  const auto lines = model_lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto key = key_of(lines[i]);
    if (key.empty()) continue;
    auto misspelt = lines;
    misspelt[i].insert(1, "_");
    const auto table = table_line(lines, i);
    const std::string where = table == 1 ? "" : " in " + lines[table - 1];
    const std::string hint = is_optional(key) ? "; did you mean \"" + key + "\"?" : "; " + key + " is missing";
    CHECK(refusal_of(joined(misspelt)) ==
          place(i + 1, 1) + key.substr(0, 1) + "_" + key.substr(1) + where + " is not known" + hint);
  }
}

TEST_CASE("a key or table more than the model has is refused", "[nonlinear][refusal]") {
  const auto end = model_lines().size();
  CHECK(refusal_of(text_with_tail("skeg = 1\n")) == place(end + 1, 1) + "skeg in [rudder] is not known");
  CHECK(refusal_of(text_with_tail("\n[skeg]\narea_m2 = 1\n")) == place(end + 2, 2) + "skeg is not known");
}

TEST_CASE("a table that is missing or misspelt is named", "[nonlinear][refusal]") {
  auto lines = model_lines();
  const auto hull = std::ranges::find(lines, "[hull]");
  const auto line = static_cast<std::size_t>(hull - lines.begin()) + 1;
  *hull = "[Hull]";
  CHECK(refusal_of(joined(lines)) == place(line, 2) + "Hull is not known; [hull] is missing");
  CHECK(refusal_of("name = \"a\"\nmodel = \"mmg\"\n") == place(1, 1) + "[water] is missing");
  CHECK(refusal_of(
            "name = \"a\"\nmodel = \"mmg\"\nwater = 1\n[particulars]\n[added_mass]\n[hull]\n[propeller]\n[rudder]\n") ==
        place(3, 9) + "water must be a table");
}

// ---------------------------------------------------------------- values

TEST_CASE("a value that makes no sense is refused with file, line and key", "[nonlinear][refusal]") {
  struct BadValue {
    const char *key, *value, *refusal;
  };
  const BadValue bad_values[] = {
      {"length_m", "0", "length_m in [particulars] must be positive, got 0"},
      {"length_m", "-7.5", "length_m in [particulars] must be positive, got -7.5"},
      {"length_m", "\"7\"", "length_m in [particulars] must be a number"},
      {"length_m", "true", "length_m in [particulars] must be a number"},
      {"length_m", "[7]", "length_m in [particulars] must be a number"},
      {"length_m", "2020-07-31", "length_m in [particulars] must be a number"},
      {"length_m", "inf", "length_m in [particulars] must be a number"},
      {"length_m", "9223372036854775807", "length_m in [particulars] must be a number"},
      {"N_v", "nan", "N_v in [hull] must be a number"},
      {"N_v", "-inf", "N_v in [hull] must be a number"},
      {"R_0", "-0.01", "R_0 in [hull] must not be negative, got -0.01"},
      {"frontal_area_m2", "-1", "frontal_area_m2 in [particulars] must not be negative, got -1"},
      {"wake_fraction", "2", "wake_fraction in [propeller] must lie between -1 and 1, got 2"},
      {"max_angle_deg", "95", "max_angle_deg in [rudder] must be above 0 and not above 90, got 95"},
      {"max_angle_deg", "0", "max_angle_deg in [rudder] must be above 0 and not above 90, got 0"},
      {"kt", "0.29", "kt in [propeller] must be a list of 3 numbers"},
      {"kt", "[]", "kt in [propeller] must be a list of 3 numbers, got 0"},
      {"kt", "[0.29, -0.28]", "kt in [propeller] must be a list of 3 numbers, got 2"},
      {"kt", "[0.29, -0.28, -0.14, 0.1]", "kt in [propeller] must be a list of 3 numbers, got 4"},
      {"name", "7", "name must be a text in quotes"},
      {"model", "1", "model must be a text in quotes"},
  };
  for (const auto& [key, value, refusal] : bad_values) {
    const auto line = line_of(model_lines(), key) + 1;
    CHECK(refusal_of(text_with(key, value)) == place(line, std::string(key).size() + 4) + refusal);
  }
}

TEST_CASE("a bad number in a list is refused where it stands", "[nonlinear][refusal]") {
  const auto line = line_of(model_lines(), "kt") + 1;
  CHECK(refusal_of(text_with("kt", "[0.29, \"b\", -0.1]")) == place(line, 13) + "kt in [propeller] must be a number");
  CHECK(refusal_of(text_with("kt", "[-0.29, -0.2, -0.1]")) ==
        place(line, 7) + "kt in [propeller] must be positive, got -0.29");
}

// ---------------------------------------------------------------- trust

TEST_CASE("coefficients are trusted to a tenth unless the file says otherwise", "[nonlinear]") {
  const auto confidence = ship_of(text_with_tail("")).confidence;
  CHECK(confidence.of("N_v") == 0.1);
}

TEST_CASE("trust is read for all coefficients and for single ones", "[nonlinear]") {
  const auto confidence =
      ship_of(text_with_tail("[confidence]\ncoefficients = 0.02\nN_v = 0.05\nkt = 0\nf_alpha = 1\n")).confidence;
  CHECK(confidence.of("Y_v") == 0.02);
  CHECK(confidence.of("N_v") == 0.05);
  CHECK(confidence.of("kt") == 0.0);
  CHECK(confidence.of("f_alpha") == 1.0);
  CHECK(ship_of(text_with_tail("[confidence]\nN_v = 0.05\n")).confidence.of("Y_v") == 0.1);
}

TEST_CASE("trust in what is not a coefficient, or that is not a number, is refused", "[nonlinear][refusal]") {
  const auto line = model_lines().size() + 2;
  const auto refusal = [](const std::string& text) {
    return refusal_of(text_with_tail("[confidence]\n" + text + "\n"));
  };
  CHECK(refusal("N_w = 0.05") == place(line, 1) + "N_w in [confidence] is not a coefficient of this model");
  CHECK(refusal("length_m = 0.05") == place(line, 1) + "length_m in [confidence] is not a coefficient of this model");
  CHECK(refusal("coefficients = -0.1") ==
        place(line, 16) + "coefficients in [confidence] must not be negative, got -0.1");
  CHECK(refusal("N_v = -0.1") == place(line, 7) + "N_v in [confidence] must not be negative, got -0.1");
  CHECK(refusal("N_v = \"high\"") == place(line, 7) + "N_v in [confidence] must be a number");
  CHECK(refusal_of("confidence = 0.1\n" + text_with_tail("")) == place(1, 14) + "confidence must be a table");
}

// ---------------------------------------------------------------- other models, other physics

TEST_CASE("a model of another kind is refused in words, before its keys are", "[nonlinear][refusal]") {
  const auto line = line_of(model_lines(), "model") + 1;
  CHECK(refusal_of(text_with("model", "\"mgm\"")) ==
        place(line, 9) + "model \"mgm\" is not known to this version (known: linear, mmg, pi, pu, abkowitz)");
  CHECK(refusal_of("model = \"linear\"\n[nomoto]\nT1 = 1\n") ==
        place(1, 9) + "a ship of a nonlinear model is needed here, got \"linear\"");
}

TEST_CASE("an effect surrounds the ship or is refused in words", "[nonlinear][refusal]") {
  const auto line = model_lines().size() + 2;
  const auto refusal = [](std::string_view lines) {
    return refusal_of(text_with_tail("\n[[effect]]\n" + std::string(lines)));
  };
  CHECK(refusal("kind = \"kelp\"\n") == place(line + 1, 8) + "effect kelp is not understood by this version");
  CHECK(refusal("kind = \"stedy_current\"\n") ==
        place(line + 1, 8) +
            "effect stedy_current is not understood by this version; did you mean \"steady_current\"?");
  CHECK(refusal("id = \"steady_current\"\n") == place(line, 1) + "kind is missing in [[effect]]");
  CHECK(refusal("kind = \"steady_current\"\ncurrent_speed = 1\n") ==
        place(line + 2, 17) + "current_speed is not a number of steady_current; did you mean \"current_speed_m_s\"?");
  CHECK(refusal_of(text_with_tail("\n[effects]\nwind = 1\n")) ==
        place(line, 2) + "effects is not known; did you mean \"effect\"?");
  CHECK(refusal("current_to_rad = 1\n") == place(line, 1) + "kind is missing in [[effect]]");
  CHECK(refusal("kind = \"steady_current\"\ncurrent_to_rad = 1\n") ==
        place(line, 1) + "steady_current needs current_speed_m_s");
  CHECK(refusal("kind = \"steady_current\"\nspeed = 1\n") ==
        place(line + 2, 9) + "speed is not a number of steady_current");
  CHECK(refusal("kind = \"steady_current\"\ncurrent_to_rad = \"north\"\n") ==
        place(line + 2, 18) + "current_to_rad in [[effect]] must be a number");
  const Ship ship = parse_ship(
      text_with_tail("\n[[effect]]\nkind = \"steady_current\"\ncurrent_speed_m_s = 0.5\ncurrent_to_rad = 1.5\n"), "s");
  CHECK(surroundings_at(ship, 0.0).current.speed == 0.5);
  CHECK(surroundings_at(ship, 0.0).current.to == 1.5);
}

// ---------------------------------------------------------------- no ship file at all

TEST_CASE("broken TOML is refused where it breaks", "[nonlinear][refusal]") {
  CHECK(refusal_of("name = \"a\nmodel = \"mmg\"\n").starts_with(place(1, 10)));
  CHECK(refusal_of("name = \"a\"\n[hull\n").starts_with(place(2, 6)));
  CHECK(refusal_of("name = \"a\"\nname = \"b\"\n").starts_with(place(2, 8)));
  CHECK(refusal_of("name = \"a\"\nlength = 7 m\n").starts_with(place(2, 12)));
  CHECK(refusal_of("") == place(1, 1) + "name is missing");
}

TEST_CASE("a ship file that cannot be read is refused", "[nonlinear][refusal]") {
  const test::Scratch scratch;
  CHECK_THROWS_WITH(read_ship(scratch / "absent.toml"),
                    (scratch / "absent.toml").string() + ":1:1: cannot be read (No such file or directory)");
  CHECK_THROWS_WITH(read_ship(scratch / ""), (scratch / "").string() + ":1:1: is a folder, not a file");
}

/// Overwrites, repeats or removes a piece of the text.
void damage(std::string& text, std::mt19937& random) {
  const auto at = random() % text.size();
  if (random() % 3 == 0) text[at] = static_cast<char>(random());
  else if (random() % 2 == 0) text.insert(at, text.substr(random() % text.size(), random() % 30));
  else text.erase(at, random() % 30);
}

TEST_CASE("a damaged ship file is read or refused in one line", "[nonlinear][fuzz]") {
  const auto good = text_with_tail("[confidence]\ncoefficients = 0.05\nkt = 0.1\n");
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937 random(seed);
    auto text = good;
    for (auto times = 1 + random() % 4; times > 0; --times) damage(text, random);
    INFO("seed " << seed);
    const auto refusal = refusal_of(text);
    REQUIRE((refusal.empty() ||
             (refusal.starts_with("ship.toml:") && refusal[10] != '0' && refusal.find('\n') == std::string::npos)));
  }
}

}  // namespace
}  // namespace swayaw

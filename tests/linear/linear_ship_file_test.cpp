#include "swayaw/linear/linear_ship_file.hpp"

#include <catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "files.hpp"
#include "random_linear_ships.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "tanker.hpp"

namespace swayaw {
namespace {

using nlohmann::json;
using Lines = std::vector<std::string>;

const auto files = {"tanker97.toml", "tanker97_abc.toml", "tanker97_nomoto.toml"};

Lines lines_of(const std::string& file) {
  Lines lines;
  std::istringstream text(read_text(test::ships / file));
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

std::size_t table_line(const Lines& lines, std::size_t line) {
  while (line > 0 && !lines[line].starts_with('[')) --line;
  return line + 1;
}

LinearShip ship_of(const std::string& text) { return parse_linear_ship(text, "ship.toml"); }

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

constexpr std::size_t head_lines = 7;  ///< the next line is the first after the head

/// A ship whose form is the given tables.
std::string text_of(const std::string& form) {
  return "name = \"a\"\nmodel = \"linear\"\n[particulars]\nlength_m = 100\nservice_speed_m_s = 8\n\n" + form +
         "\n[rudder]\nrate_deg_s = 2.5\nmax_angle_deg = 35\n";
}

const std::string coefficients_form = "[linear]\na1 = -0.6\nb1 = 0.4\nc1 = -0.2\na2 = 3.5\nb2 = -2.8\nc2 = -1.5\n";

// ---------------------------------------------------------------- good files

TEST_CASE("the linear ships of the project load with particulars and steering gear", "[linear]") {
  for (const auto* file : files) {
    INFO(file);
    const auto ship = read_linear_ship(test::ships / file);
    CHECK_FALSE(ship.name.empty());
    CHECK(ship.particulars.L == 97.4);
    CHECK(ship.particulars.U_0 == 7.272);
    CHECK(ship.steering_gear.rate == radians(2.5));
    CHECK(ship.steering_gear.max_angle == radians(35));
    CHECK(ship.confidence.of("a1") == 0.1);
  }
}

TEST_CASE("the ships of the project are those beside it", "[linear]") {
  const auto folder = std::filesystem::path(SWAYAW_TEST_SHARED) / "ships";
  for (const auto* file : files) {
    if (!std::filesystem::exists(folder / file)) {
      std::cout << "[skipped] no " << (folder / file).string() << "\n";
      continue;
    }
    const auto ours = coefficients(read_linear_ship(test::ships / file)),
               theirs = coefficients(read_linear_ship(folder / file));
    for (const auto& p : ours.parameters()) CHECK(ours.*p.member == theirs.*p.member);
  }
}

TEST_CASE("each form gives the reference's coefficients and indices", "[linear][published]") {
  const auto& golden = test::reference();
  const auto check = [](const SwayYawCoefficients<double>& m, const json& wanted) {
    for (const auto& p : m.parameters())
      CHECK_THAT(m.*p.member, WithinRel(wanted.at(std::string(p.key)).get<double>(), 1e-12));
  };
  check(coefficients(read_linear_ship(test::ships / "tanker97.toml")), golden.at("from_table1_record").at("abc"));
  check(coefficients(read_linear_ship(test::ships / "tanker97_abc.toml")), golden.at("printed_abc_record").at("abc"));
  check(coefficients(read_linear_ship(test::ships / "tanker97_nomoto.toml")), golden.at("printed_TK_to_abc"));
  const auto i = indices(read_linear_ship(test::ships / "tanker97_abc.toml"));
  CHECK_THAT(i.T1T2, WithinRel(golden.at("printed_abc_record").at("P").get<double>(), 1e-12));
  CHECK_THAT(i.Kw, WithinRel(golden.at("printed_abc_record").at("Kw").get<double>(), 1e-12));
}

TEST_CASE("product and sum of the time constants stand for complex poles", "[linear]") {
  const auto ship =
      ship_of(text_of("[nomoto]\nT1T2 = 0.45\nT1_plus_T2 = 1\nT3b = 0.27\nT3w = 1.67\nKb = -0.3\nKw = -0.27\n"));
  CHECK(indices(ship).T1T2 == 0.45);
  CHECK(has_complex_poles(coefficients(ship)));
  const auto real = ship_of(text_of("[nomoto]\nT1 = 10\nT2 = 0.3\nT3b = 0.15\nT3w = 1\nKb = -3\nKw = -4\n"));
  CHECK(indices(real).T1T2 == 3.0);
  CHECK(indices(real).T1_plus_T2 == 10.3);
}

TEST_CASE("the masses of a hull and its coefficients make SNAME derivatives that give the coefficients back",
          "[linear][round-trip]") {
  const auto ship = read_linear_ship(test::ships / "tanker97.toml");
  const auto m = coefficients(ship);
  const auto d = sname_derivatives(m, inertia(parts(ship)->hull));
  const auto again = coefficients(d);
  for (const auto& p : m.parameters()) CHECK_THAT(again.*p.member, WithinRel(m.*p.member, 1e-12));
  // the hull's own part is what the file says, in radians, and the rudder adds to it
  const auto hull = sname_derivatives(coefficients(*parts(ship)).hull, inertia(parts(ship)->hull));
  CHECK_THAT(hull.Y_v, WithinRel(-degrees(1.0) * 0.0043, 1e-12));
  CHECK_THAT(hull.N_v, WithinRel(-degrees(1.0) * 0.0024, 1e-12));
  CHECK_THAT(hull.N_r, WithinRel(-0.063, 1e-12));
}

TEST_CASE("trust is read for the numbers of the form", "[linear]") {
  CHECK(ship_of(text_of(coefficients_form) + "[confidence]\ncoefficients = 0.02\nb1 = 0.3\n").confidence.of("b1") ==
        0.3);
  const auto line = head_lines + 11;
  CHECK(refusal_of(text_of(coefficients_form) + "[confidence]\nT3b = 0.3\n") ==
        place(line + 1, 1) + "T3b in [confidence] is not a coefficient of this model");
}

// ---------------------------------------------------------------- refusals

TEST_CASE("every key that a linear ship lacks is named with the line of its table", "[linear][refusal]") {
  for (const auto* file : files) {
    const auto lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto key = key_of(lines[i]);
      if (key.empty() || key == "model") continue;
      auto less = lines;
      less[i].clear();
      const auto table = table_line(lines, i);
      INFO(file << " without " << key);
      if (table == 1) CHECK(refusal_of(joined(less)).ends_with(": " + key + " is missing"));
      else CHECK(refusal_of(joined(less)) == place(table, 1) + key + " is missing in " + lines[table - 1]);
    }
  }
}

TEST_CASE("every key of a linear ship that is misspelt is named where it stands", "[linear][refusal]") {
  for (const auto* file : files) {
    const auto lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto key = key_of(lines[i]);
      if (key.empty()) continue;
      auto misspelt = lines;
      misspelt[i].insert(std::size_t{0}, std::size_t{1}, '_');
      INFO(file << ": " << key);
      CHECK(refusal_of(joined(misspelt)).starts_with(place(i + 1, 1) + "_" + key));
      CHECK_THAT(refusal_of(joined(misspelt)), ContainsSubstring("is not known; " + key + " is missing"));
    }
  }
}

TEST_CASE("a value of a linear ship that makes no sense is refused with its key", "[linear][refusal]") {
  const std::string nomoto = "T3b = 0.15\nT3w = 1\nKb = -3\nKw = -4\n";
  const std::pair<std::string, std::string> cases[] = {
      {"[linear]\na1 = nan\nb1 = 0.4\nc1 = -0.2\na2 = 3.5\nb2 = -2.8\nc2 = -1.5\n",
       place(8, 6) + "a1 in [linear] must be a number"},
      {"[linear]\na1 = \"x\"\nb1 = 0.4\nc1 = -0.2\na2 = 3.5\nb2 = -2.8\nc2 = -1.5\n",
       place(8, 6) + "a1 in [linear] must be a number"},
      {"[nomoto]\nT1 = 10\nT2 = 0\n" + nomoto, place(9, 6) + "T2 in [nomoto] must not be 0, got 0"},
      {"[nomoto]\nT1T2 = 0\nT1_plus_T2 = 1\n" + nomoto, place(8, 8) + "T1T2 in [nomoto] must not be 0, got 0"},
      {"[nomoto]\nT1 = 1\nT1T2 = 2\nT1_plus_T2 = 1\n" + nomoto,
       place(8, 6) + "T1 in [nomoto] is one too many: T1T2 and T1_plus_T2 replace T1 and T2"},
  };
  for (const auto& [form, refusal] : cases) CHECK(refusal_of(text_of(form)) == refusal);
}

TEST_CASE("a linear ship has one form, no less and no more", "[linear][refusal]") {
  CHECK(refusal_of(text_of("")) ==
        place(1, 1) + "a linear ship has one of [hull], [linear] and [nomoto]; none is there");
  CHECK(refusal_of(text_of(coefficients_form + "[nomoto]\nT1 = 1\n")) ==
        place(14, 1) + "a linear ship has one of [hull], [linear] and [nomoto]; [linear] and [nomoto] are there");
  CHECK(
      refusal_of(text_of(coefficients_form) + "area_ratio = 0.02\n").ends_with("area_ratio in [rudder] is not known"));
}

TEST_CASE("a ship of another model, or with an effect, is refused in words", "[linear][refusal]") {
  CHECK(refusal_of("model = \"mmg\"\n") == place(1, 9) + "a ship of model \"linear\" is needed here, got \"mmg\"");
  CHECK(refusal_of("model = \"pi\"\n") == place(1, 9) + "a ship of model \"linear\" is needed here, got \"pi\"");
  CHECK(refusal_of(text_of(coefficients_form) + "[[effect]]\nkind = \"steady_wind\"\n")
            .ends_with("[[effect]] is not understood in a linear ship"));
}

TEST_CASE("indices without coupled equations are read, and refused where equations are needed", "[linear][refusal]") {
  const auto ship = [](const std::string& last) {
    return ship_of(text_of("[nomoto]\nT1 = 10\nT2 = 0.3\nT3b = 0.5\n" + last));
  };
  const auto equal = ship("T3w = 0.5\nKb = -3\nKw = -4\n"), no_drift = ship("T3w = 0.8\nKb = 0\nKw = -4\n"),
             no_yaw = ship("T3w = 0.8\nKb = -3\nKw = 0\n");
  for (const auto* s : {&equal, &no_drift, &no_yaw}) {
    CHECK_FALSE(has_coefficients(*s));
    CHECK(transfer_functions(*s).e0 > 0.0);
    CHECK_THROWS_AS(coefficients(*s), Refusal);
  }
  CHECK_THROWS_WITH(coefficients(equal), "T3b and T3w are both 0.5: the indices do not tell the coupled equations");
}

/// Overwrites, repeats or removes a piece of the text.
void damage(std::string& text, std::mt19937& random) {
  const auto at = random() % text.size();
  if (random() % 3 == 0) text[at] = static_cast<char>(random());
  else if (random() % 2 == 0) text.insert(at, text.substr(random() % text.size(), random() % 30));
  else text.erase(at, random() % 30);
}

TEST_CASE("a damaged file of a linear ship is read or refused in one line", "[linear][fuzz]") {
  for (const auto* file : files) {
    const auto good = read_text(test::ships / file) + "[confidence]\ncoefficients = 0.05\n";
    for (unsigned seed = 0; seed < 300; ++seed) {
      std::mt19937 random(seed);
      auto text = good;
      for (auto times = 1 + random() % 4; times > 0; --times) damage(text, random);
      INFO(file << ", seed " << seed);
      const auto refusal = refusal_of(text);
      REQUIRE((refusal.empty() ||
               (refusal.starts_with("ship.toml:") && refusal[10] != '0' && refusal.find('\n') == std::string::npos)));
    }
  }
}

}  // namespace
TEST_CASE("a linear ship written to a file and read again is the same in each of her forms", "[linear][round-trip]") {
  test::RandomLinearShips random(5);
  const SteeringGear<double> gear{.rate = radians(2.5), .max_angle = radians(35.0), .lag = 0.0, .dead_band = 0.0};
  for (int i = 0; i < 100; ++i) {
    const auto coefficients = random.ship();
    for (const LinearForm& form :
         {LinearForm(random.parts()), LinearForm(coefficients), LinearForm(steering_indices(coefficients))}) {
      const LinearShip ship{.name = "a ship",
                            .particulars = {100.0, 7.0},
                            .steering_gear = gear,
                            .form = form,
                            .confidence = {.coefficients = 0.05, .named = {}}};
      const auto text = ship_text(ship, "from a fit");
      const auto back = parse_linear_ship(text, "back.toml");
      CHECK(back.form.index() == ship.form.index());
      CHECK(ship_text(back, "from a fit") == text);
      CHECK(transfer_functions(back).e0 == transfer_functions(ship).e0);
      CHECK(transfer_functions(back).nw1 == transfer_functions(ship).nw1);
      CHECK(back.confidence.coefficients == 0.05);
    }
  }
}

}  // namespace swayaw

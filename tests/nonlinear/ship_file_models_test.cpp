#include <catch.hpp>
#include <string>

#include "files.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "swayaw/nonlinear/surroundings/wind.hpp"
#include "swayaw/nonlinear/surroundings/windage_sources.hpp"

/// What ship files of a model need beyond their lists of keys, and the table [windage].
namespace swayaw {
namespace {

/// A ship file of the project with one line of it replaced and further lines at its end.
std::string text_of(const std::string& file, const std::string& line = {}, const std::string& other = {},
                    const std::string& tail = {}) {
  auto text = read_text(test::ships / file);
  const auto begin = text.find('\n' + line);
  REQUIRE((line.empty() || begin != std::string::npos));
  if (!line.empty()) text.replace(begin + 1, text.find('\n', begin + 1) - begin - 1, other);
  return text + tail;
}

/// The refusal without its place; empty where the file is read.
std::string refusal_of(const std::string& text) {
  try {
    parse_ship(text, "ship.toml");
    return {};
  } catch (const FileError& error) {
    const std::string what = error.what();
    CHECK(what.starts_with("ship.toml:"));
    return what.substr(what.find(": ") + 2);
  }
}

// ---------------------------------------------------------------- models

TEST_CASE("a PI ship needs one measure of its inertia in yaw, and one only", "[nonlinear][refusal]") {
  const std::string rule = "one of inertia_z_kg_m2 and radius_of_gyration_m is needed in [particulars]";
  const auto with = [](const std::string& line) {
    return refusal_of(text_of("wpcc_pi.toml", "inertia_z_kg_m2", line));
  };
  CHECK(with("inertia_z_kg_m2 = 742.0").empty());
  CHECK(with("radius_of_gyration_m = 1.2").empty());
  CHECK(with("") == rule + "; none is there");
  CHECK(with("inertia_z_kg_m2 = 742.0\nradius_of_gyration_m = 1.2") == rule + "; both are there");
  CHECK(with("inertia_z_kg_m2 = 20.0") ==
        "inertia_z_kg_m2 in [particulars] is about midship and must be larger than m x_G2");
}

TEST_CASE("a PI hull needs the slopes by drift and yaw, a PU rudder those by its angle", "[nonlinear][refusal]") {
  for (const std::string key : {"Y_v", "N_v", "N_r"})
    CHECK(refusal_of(text_of("wpcc_pi.toml", key + " =", "")) == key + " is missing in [hull]");
  for (const std::string key : {"Y_delta", "N_delta"})
    CHECK(refusal_of(text_of("wpcc_pu.toml", key + " =", "")) == key + " is missing in [rudder]");
}

TEST_CASE("a wake that changes with the flow needs its numbers", "[nonlinear][refusal]") {
  for (const std::string key : {"wake_C1", "wake_C2_positive", "wake_C2_negative"})
    CHECK(refusal_of(text_of("kvlcc2_pi.toml", key, "")) == "wake = \"mmg\" needs " + key + " in [propeller]");
  CHECK(refusal_of(text_of("kvlcc2_pi.toml")).empty());
}

TEST_CASE("an engine with a limit of torque needs the limit and the torque of the propeller", "[nonlinear][refusal]") {
  const auto with = [](const std::string& engine, const std::string& kq = {}) {
    const auto kt = std::string("kt = [0.2931, -0.2753, -0.1385]");
    return refusal_of(text_of("kvlcc2_l7.toml", "kt = ", kt + kq, "\n[engine]\nkind = \"torque_limited\"\n" + engine));
  };
  CHECK(with("") == "a torque limited engine needs torque_limit_kN_m");
  CHECK(with("torque_limit_kN_m = 0.01\n") == "a torque limited engine needs the torque curve kq in [propeller]");
  CHECK(with("torque_limit_kN_m = 0.01\n", "\nkq = [0.03, -0.02, -0.01]").empty());
}

// ---------------------------------------------------------------- windage

std::string text_with_windage(const std::string& lines) {
  return text_of("wpcc_pi.toml", {}, {},
                 "\n[windage]\nfrontal_area_m2 = 0.2\nlateral_area_m2 = 0.9\nlength_over_all_m = 5.2\n" + lines);
}

Windage<double> windage_with(const std::string& lines) {
  return parse_ship(text_with_windage(lines), "ship.toml").surroundings.windage;
}

TEST_CASE("a type of ship gives the windage its drag, where the file does not", "[nonlinear][published]") {
  for (const auto& type : blendermann_ships) {
    const auto named = "type = \"" + std::string(type.type) + "\"\n";
    const auto w = windage_with(named);
    INFO(type.type);
    CHECK(w.C_Dt == type.C_Dt);
    CHECK(w.C_Dl_bow == type.C_Dl_bow);
    CHECK(w.C_Dl_stern == type.C_Dl_stern);
    CHECK(w.delta == type.delta);
    const auto own =
        windage_with(named + "transverse_drag = 1.1\nbow_drag = 1.2\nstern_drag = 1.3\ncross_force = 0.7\n");
    CHECK(own.C_Dt == 1.1);
    CHECK(own.C_Dl_bow == 1.2);
    CHECK(own.C_Dl_stern == 1.3);
    CHECK(own.delta == 0.7);
  }
}

/// Force of a wind of 10 m/s from an angle off the bow on a ship that lies still.
PlanarForce<double> force_from(const Windage<double>& w, double angle) {
  return wind_force(w, Wind<double>{10.0, angle}, PlanarMotion<double>{0.0, 0.0, 0.0}, 0.0);
}

TEST_CASE("a table of one side is that of both, mirrored", "[nonlinear][symmetry]") {
  const auto w = windage_with(
      "angle_deg = [0, 60, 120, 180]\nC_X = [-0.7, -0.3, 0.4, 0.6]\nC_Y = [0, 0.8, 0.7, 0]\nC_N = [0, 0.1, -0.1, 0]\n");
  for (const double angle : {0.3, 1.0, radians(60), 2.5}) {
    const auto starboard = force_from(w, angle), port = mirrored(force_from(w, -angle));
    CHECK_THAT(port.X, WithinRel(starboard.X, 1e-12));
    CHECK_THAT(port.Y, WithinRel(starboard.Y, 1e-12));
    CHECK_THAT(port.N, WithinRel(starboard.N, 1e-12));
  }
}

TEST_CASE("a table of windage that makes no curve is refused", "[nonlinear][refusal]") {
  const auto refusal = [](const std::string& lines) { return refusal_of(text_with_windage(lines)); };
  CHECK(refusal("angle_deg = [0, 90, 180]\nC_X = [0, 1]\nC_Y = [0, 1, 0]\nC_N = [0, 1, 0]\n") ==
        "C_X in [windage] has 2 numbers, angle_deg 3");
  CHECK(refusal("angle_deg = [0, 90, 180]\nC_X = [0, 1, 0]\nC_Y = [0, 1, 0]\n") ==
        "C_N in [windage] has 0 numbers, angle_deg 3");
  CHECK_THAT(refusal("angle_deg = [0, 90, 90, 180]\nC_X = [0, 1, 2, 0]\nC_Y = [0, 1, 0, 0]\nC_N = [0, 1, 0, 0]\n"),
             ContainsSubstring("two different rows at 90 deg"));
  CHECK_THAT(refusal("type = \"dhow\"\n"), ContainsSubstring("type"));
}

TEST_CASE("wind on a ship with nothing for it to take hold of is refused", "[nonlinear][refusal]") {
  CHECK(refusal_of(text_of("wpcc_pi.toml", {}, {},
                           "\n[[effect]]\nkind = \"steady_wind\"\nwind_speed_m_s = 5\nwind_from_rad = 1\n")) ==
        "wind needs frontal and lateral area of the ship, in [windage] or [particulars]");
}

}  // namespace
}  // namespace swayaw

#include <algorithm>
#include <catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/atomic_file.hpp"

/// Plots of the commands as SVG, from the outside.
namespace swayaw {
namespace {

using test::refusal;
using test::run;
using test::Scratch;

const std::string linear_ship = test::ship_file("tanker97_nomoto.toml");
const std::string mmg_ship = test::ship_file("kvlcc2_l7.toml");

/// Every command with a plot.
const std::string plotting[] = {
    "loop " + linear_ship + " --zigzag 10/10",     "indices " + linear_ship,
    "simulate " + linear_ship + " --zigzag 10/10", "simulate " + mmg_ship + " --zigzag 20/20",
    "simulate " + mmg_ship + " --turn 35",
};

const bool has_gnuplot = std::system("gnuplot --version >/dev/null 2>&1") == 0;

/// Whether this test can be done; else says that it is skipped.
bool can_plot() {
  if (!has_gnuplot) std::cout << "[skipped] gnuplot is not installed\n";
  return has_gnuplot;
}

/// The plot of a command that must succeed.
std::string plot_of(const std::string& arguments) {
  const Scratch scratch;
  const auto file = scratch / "plot.svg";
  const auto outcome = run(scratch, arguments + " --svg " + file.string());
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK_FALSE(outcome.out.empty());
  return read_text(file);
}

/// Whether every element of an XML text is closed, in the right order and inside one root, without stray < and &.
bool elements_match(std::string_view text) {
  std::vector<std::string_view> open;
  std::size_t roots = 0;
  for (auto at = text.find_first_of("<&"); at != std::string_view::npos; at = text.find_first_of("<&", at + 1)) {
    const auto rest = text.substr(at + 1);
    if (text[at] == '&') {
      if (rest.find(';') > 5) return false;
      continue;
    }
    const auto tag = rest.substr(0, rest.find_first_of("<>"));
    if (tag.size() == rest.size() || rest[tag.size()] == '<') return false;
    if (tag.starts_with('?')) continue;  // the declaration
    const auto name = tag.substr(0, tag.find_first_of(" \t\n/", 1));
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != name.substr(1)) return false;
      open.pop_back();
      continue;
    }
    if (open.empty()) ++roots;
    if (!tag.ends_with('/')) open.push_back(name);
  }
  return open.empty() && roots == 1;
}

/// How often a text is drawn.
std::size_t drawn(const std::string& svg, const std::string& text) {
  const std::string element = "<text>" + text + "</text>";
  std::size_t count = 0;
  for (auto at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1)) ++count;
  return count;
}

/// Points of the longest line of that colour, moves and straight lines.
std::size_t points_in(const std::string& svg, const std::string& colour) {
  std::size_t most = 0;
  for (auto at = svg.find("stroke='" + colour); at != std::string::npos; at = svg.find("stroke='" + colour, at + 1)) {
    const auto path = svg.substr(at, svg.find('>', at) - at);
    most = std::max(most, static_cast<std::size_t>(std::ranges::count(path, ' ')));
  }
  return most;
}

TEST_CASE("the check of XML sees what is wrong", "[app]") {
  CHECK(elements_match("<?xml version='1.0'?>\n<svg><g>\n<path d='1' /></g>a &amp; b</svg>"));
  CHECK_FALSE(elements_match("<svg><g></svg></g>"));
  CHECK_FALSE(elements_match("<svg><g></svg>"));
  CHECK_FALSE(elements_match("<svg><text>a < b</text></svg>"));
  CHECK_FALSE(elements_match("<svg>a & b</svg>"));
  CHECK_FALSE(elements_match("<svg/><svg/>"));
}

TEST_CASE("every plot is an SVG document whose elements match", "[app]") {
  if (!can_plot()) return;
  for (const auto& command : plotting) {
    INFO(command);
    const auto svg = plot_of(command);
    CHECK(svg.starts_with("<?xml"));
    CHECK_THAT(svg, ContainsSubstring("xmlns=\"http://www.w3.org/2000/svg\""));
    CHECK(elements_match(svg));
  }
}

TEST_CASE("plots name their axes and curves", "[app]") {
  if (!can_plot()) return;
  const auto loop = plot_of(plotting[0]), bode = plot_of(plotting[1]), zigzag = plot_of(plotting[3]),
             turn = plot_of(plotting[4]);
  for (const char* text : {"Chemical tanker, 97.4 m, printed T and K: zigzag 10/10 first starboard", "Drift angle, deg",
                           "Yaw rate ω′", "first-order line", "from straight ahead", "limit cycle"})
    CHECK(drawn(loop, text) == 1);
  for (const char* text : {"Frequency, rad per ship length", "drift angle β / δ", "yaw rate ω′ / δ"})
    CHECK(drawn(bode, text) == 2);
  for (const char* text : {"Gain", "Phase, deg"}) CHECK(drawn(bode, text) == 1);
  for (const char* text : {"KVLCC2 model 1:45.7 (L7): zigzag 20/20 first starboard", "Time, s", "Heading, rudder, deg",
                           "heading", "rudder, to port"})
    CHECK(drawn(zigzag, text) == 1);
  for (const char* text : {"East, m", "North, m", "track of midship"}) CHECK(drawn(turn, text) == 1);
}

TEST_CASE("a ship's name is drawn as it is and commands nothing", "[app][refusal]") {
  if (!can_plot()) return;
  const Scratch scratch;
  auto text = read_text(linear_ship);
  const auto name = text.find("name = \"");
  const std::string made = (scratch / "made").string();
  const std::string evil =
      R"(a'b ''c\"7 `touch )" + made + R"(` <g> & _x^2 {/Bold y} @z \\ \nsystem 'touch )" + made + R"(' # $0)";
  text.replace(name, text.find('\n', name) - name, "name = \"" + evil + "\"");
  write_text(scratch / "ship.toml", text);
  const auto svg = plot_of("indices " + (scratch / "ship.toml").string());
  CHECK(elements_match(svg));
  CHECK_THAT(svg, ContainsSubstring("_x^2 {/Bold y} @z \\  system 'touch "));
  CHECK_THAT(svg, ContainsSubstring("a'b ''c\"7 `touch " + made + "` &lt;g"));
  CHECK_THAT(svg, ContainsSubstring("' # $0: drift and yaw by rudder"));
  CHECK_FALSE(std::filesystem::exists(made));
}

TEST_CASE("without gnuplot a plot is refused in one line, and nothing is written", "[app][refusal]") {
  const Scratch scratch;
  const auto svg = scratch / "plot.svg", csv = scratch / "run.csv", page = scratch / "page.html";
  const std::string nowhere = "PATH=" + (scratch / "no_such_folder").string() + " ";
  for (const auto& command : plotting) {
    auto arguments = command + " --svg " + svg.string();
    if (!command.starts_with("indices")) arguments += " --out " + csv.string();
    if (command.starts_with("loop")) arguments += " --report " + page.string();
    CHECK_THAT(refusal(arguments, 1, nowhere), ContainsSubstring("install the Debian package gnuplot-nox"));
    for (const auto& file : {svg, csv, page}) CHECK_FALSE(std::filesystem::exists(file));
  }
  CHECK(run(scratch, plotting[1], nowhere).code == 0);
}

TEST_CASE("a gnuplot that fails leaves the old plot", "[app][refusal]") {
  const Scratch scratch;
  write_text(scratch / "gnuplot", "#!/bin/sh\necho '<svg'\necho 'line 0: no memory' >&2\nexit 3\n");
  std::filesystem::permissions(scratch / "gnuplot", std::filesystem::perms::owner_all);
  const auto file = scratch / "plot.svg";
  write_text(file, "old");
  const auto said =
      refusal("indices " + linear_ship + " --svg " + file.string(), 1, "PATH=" + (scratch / "").string() + " ");
  CHECK(said == "swayaw: gnuplot ended with code 3: line 0: no memory\n");
  CHECK(read_text(file) == "old");
}

TEST_CASE("curves reach the plot with all their points", "[app]") {
  if (!can_plot()) return;
  const auto bode = plot_of(plotting[1]), loop = plot_of(plotting[0]);
  CHECK(points_in(bode, "rgb(  0, 114, 178)") > 100);
  CHECK(points_in(loop, "rgb(224, 123,   0)") > 40);
}

TEST_CASE("the turn of a linear ship has no track to plot", "[app][refusal]") {
  CHECK_THAT(refusal("simulate " + linear_ship + " --turn 20 --svg /dev/null"),
             ContainsSubstring("no track for --svg"));
}

TEST_CASE("with T3b = T3w plot and page draw drift proportional to yaw", "[app][regression]") {
  // 2026-11-21: T3b = T3w = 0.98, the page drew the drift of another ship
  const Scratch scratch;
  const auto ship = scratch / "ship.toml", page = scratch / "page.html";
  write_text(ship,
             "name = \"a\"\nmodel = \"linear\"\n[particulars]\nlength_m = 100\nservice_speed_m_s = 8\n[nomoto]\nT1 = "
             "10\nT2 = 0.3\nT3b = 0.98\nT3w = 0.98\n"
             "Kb = -3\nKw = -4\n[rudder]\nrate_deg_s = 2.5\nmax_angle_deg = 35\n");
  REQUIRE(run(scratch, "loop " + ship.string() + " --zigzag 10/10 --report " + page.string()).code == 0);
  const auto text = read_text(page);
  const auto cycle = text.find("\"cycle\":{");
  REQUIRE(cycle != std::string::npos);
  const auto columns = test::json_of(text.substr(cycle + 8, text.find('}', cycle) - cycle - 7));
  REQUIRE(columns.at("omega").size() > 100);
  for (std::size_t i = 0; i < columns.at("omega").size(); ++i)
    CHECK_THAT(columns.at("beta_rad")[i].get<double>(), WithinAbs(0.75 * columns.at("omega")[i].get<double>(), 1e-12));
}

}  // namespace
}  // namespace swayaw

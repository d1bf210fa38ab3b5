#include <fmt/format.h>

#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "files.hpp"
#include "json.hpp"
#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"

/// The pages of `swayaw simulate`, `indices` and `loop`, as they are read without scripts.
namespace swayaw {
namespace {

using nlohmann::json;
using test::run;
using test::Scratch;
using test::ship_file;

/// With ordinary blanks in place of those that do not break a line.
std::string with_blanks(std::string text) {
  const std::string unbreakable = "\u00a0";
  for (auto at = text.find(unbreakable); at != std::string::npos; at = text.find(unbreakable, at))
    text.replace(at, unbreakable.size(), " ");
  return text;
}

/// Page and JSON of one command.
struct Told {
  std::string page;
  json document;
};

Told told(const std::string& command, const std::string& units = "ship") {
  const Scratch scratch;
  const auto file = scratch / "page.html";
  const auto outcome = run(scratch, command + " --json --units " + units + " --report " + file.string());
  INFO(command << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return {with_blanks(read_text(file)), test::json_of(outcome.out)};
}

/// What is between two texts, from the first of each on.
std::string between(const std::string& text, std::string_view before, std::string_view after) {
  const auto from = text.find(before);
  REQUIRE(from != std::string::npos);
  const auto to = text.find(after, from + before.size());
  REQUIRE(to != std::string::npos);
  return text.substr(from + before.size(), to - from - before.size());
}

std::string headline_of(const std::string& page) {
  const auto paragraph = between(page, "<p class=\"verdict", "</p>");
  return paragraph.substr(paragraph.find('>') + 1);
}

/// The table of the first screen, which comes after those that are opened on demand.
std::string table_of(const std::string& page) {
  const auto first = between(page, "<div class=\"shown\">", "<details class=\"assumed\"");
  const auto details = first.rfind("</details>");
  return between(details == std::string::npos ? first : first.substr(details), "<tbody>", "</tbody>");
}

std::size_t times(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// The number before a unit, the k-th of them.
double number_before(const std::string& text, const std::string& unit, std::size_t k = 0) {
  auto at = text.find(unit);
  for (; k > 0 && at != std::string::npos; --k) at = text.find(unit, at + 1);
  REQUIRE(at != std::string::npos);
  const auto from = text.find_last_not_of("0123456789.-", at - 1) + 1;
  return std::stod(text.substr(from, at - from));
}

/// Whether a number with three digits stands for another.
bool stands_for(double shown, double value) { return std::abs(shown - value) <= 0.0051 * std::abs(value); }

TEST_CASE("the headline of the IMO criteria tells what the JSON tells", "[app]") {
  for (const char* name : {"kvlcc2.toml", "mariner.toml", "nawigator_ym.toml"}) {
    const auto [page, imo] = told("simulate " + ship_file(name) + " --imo");
    const auto& criteria = imo.at("criteria");
    const auto failed = std::ranges::count_if(criteria, [](const json& c) { return c.at("pass") == false; });
    const auto headline = headline_of(page), table = table_of(page);
    INFO(headline);
    if (failed == 0) CHECK_THAT(headline, ContainsSubstring(fmt::format("passes all {}", criteria.size())));
    else CHECK_THAT(headline, ContainsSubstring(fmt::format("fails {} of {}", failed, criteria.size())));
    CHECK(times(table, "<tr>") == criteria.size());
    CHECK(times(table, ">fail<") == static_cast<std::size_t>(failed));
    CHECK_THAT(page, ContainsSubstring("Stopping is not simulated"));
  }
}

TEST_CASE("the headlines of zigzag and turning circle have the numbers of the JSON", "[app]") {
  const auto [zigzag, z] = told("simulate " + ship_file("kvlcc2.toml") + " --zigzag 10/10");
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& c = z.at("criteria")[k + 1];
    CHECK(stands_for(number_before(headline_of(zigzag), " deg", 2 * k), c.at("value")));
    CHECK(stands_for(number_before(headline_of(zigzag), " deg", 2 * k + 1), c.at("limit")));
  }
  const auto [turn, t] = told("simulate " + ship_file("kvlcc2.toml") + " --turn 35");
  CHECK(stands_for(number_before(headline_of(turn), " m ("), t.at("advance_m")));
  CHECK(stands_for(number_before(headline_of(turn), " m (", 1), t.at("tactical_diameter_m")));
  const auto [free, f] = told("simulate " + ship_file("wpcc_pi.toml") + " --zigzag 20/10");
  CHECK(stands_for(number_before(headline_of(free), " deg"), f.at("overshoot_deg")[0]));
}

TEST_CASE("the headlines of the other manoeuvres have the numbers of the JSON", "[app]") {
  const auto ship = "simulate " + ship_file("kvlcc2.toml");
  const auto [spiral, s] = told(ship + " --spiral");
  CHECK_THAT(headline_of(spiral), ContainsSubstring("course unstable"));
  CHECK(stands_for(number_before(headline_of(spiral), " deg of rudder"),
                   degrees(s.at("instability_loop").at("width_rad").get<double>())));
  CHECK(times(table_of(spiral), "<tr>") == s.at("down").at("delta_rad").size());
  const auto [reverse, r] = told(ship + " --reverse-spiral");
  CHECK(times(table_of(reverse), "unstable") ==
        static_cast<std::size_t>(std::ranges::count(r.at("stable"), json(false))));
  const auto [pullout, p] = told(ship + " --pullout 20");
  CHECK(stands_for(number_before(headline_of(pullout), " deg/s to port"),
                   -degrees(p.at("port").at("residual_yaw_rate_rad_s").get<double>())));
  const auto [williamson, w] = told(ship + " --williamson");
  CHECK(stands_for(number_before(headline_of(williamson), " s,"), w.at("reciprocal").at("time_s")));
  CHECK(stands_for(number_before(headline_of(williamson), " m ("), w.at("reciprocal").at("offset_m")));
  const auto [straight, h] = told("simulate " + ship_file("mariner.toml") + " --straight 45");
  CHECK(stands_for(number_before(headline_of(straight), " deg to port"), degrees(h.at("helm_rad").get<double>())));
}

TEST_CASE("pages in SI have neither knots nor ship lengths", "[app]") {
  for (const auto& command :
       {"simulate " + ship_file("kvlcc2.toml") + " --turn 35", "simulate " + ship_file("kvlcc2.toml") + " --imo",
        "simulate " + ship_file("tanker97.toml") + " --zigzag 10/10", "indices " + ship_file("tanker97.toml"),
        "simulate " + ship_file("mariner.toml") + " --straight 0"}) {
    INFO(command);
    const auto page = told(command, "si").page;
    const auto first = between(page, "<div class=\"first\">", "<details class=\"assumed\"");
    CHECK(times(first, " kn") == 0);
    CHECK(times(first, " L)") == 0);
    CHECK(times(first, " m/s") > 0);
  }
}

TEST_CASE("the page of a linear ship says whether she is stable, as the JSON does", "[app]") {
  for (const char* name : {"tanker97.toml", "tanker97_abc.toml", "tanker97_nomoto.toml"}) {
    const auto [page, indices] = told("indices " + ship_file(name));
    INFO(headline_of(page));
    const bool stable = indices.at("stable");
    CHECK_THAT(headline_of(page), ContainsSubstring(stable ? "course stable" : "course unstable"));
    CHECK_THAT(headline_of(page), ContainsSubstring(stable ? "is halved" : "doubles"));
    CHECK(stands_for(number_before(headline_of(page), " 1/s"), indices.at("dimensional").at("K_to_starboard_per_s")));
  }
}

TEST_CASE("a ship whose time constant is negative doubles a disturbance in ln 2 of it", "[app][second-route]") {
  const Scratch scratch;
  const auto file = scratch / "unstable.toml";
  auto text = read_text(test::ships / "tanker97_nomoto.toml");
  for (const auto& [stable, unstable] :
       {std::pair{"T1 = 10.491", "T1 = -10.491"}, {"Kb = -", "Kb = "}, {"Kw = -", "Kw = "}})
    text.replace(text.find(stable), std::string_view(stable).size(), unstable);
  write_text(file, text);
  const auto [page, indices] = told("indices " + file.string());
  CHECK(indices.at("stable") == false);
  CHECK_THAT(headline_of(page), ContainsSubstring("course unstable"));
  const double T1 = indices.at("T1");
  REQUIRE(T1 < 0.0);
  CHECK(stands_for(number_before(headline_of(page), " ship lengths"), -std::log(2.0) * T1));
}

TEST_CASE("the page of a loop tells its shape and what T3w does to the overshoot", "[app]") {
  const auto [page, loop] = told("loop " + ship_file("tanker97_abc.toml") + " --zigzag 10/10");
  CHECK(std::abs(number_before(headline_of(page), " %") -
                 100.0 * loop.at("width").get<double>() / loop.at("length").get<double>()) < 0.6);
  const auto indices = test::document("indices " + ship_file("tanker97_abc.toml"));
  const double change =
      0.1 * indices.at("T3w").get<double>() * loop.at("sensitivity").at("T3w").at("overshoot_deg")[0].get<double>();
  CHECK(stands_for(number_before(between(page, "What does T3w do?", "</dd>"), " deg"), change));
}

TEST_CASE("pictures have the units of their page", "[app]") {
  const auto command = "simulate " + ship_file("kvlcc2.toml") + " --spiral";
  const auto numbers = [&](const char* units) {
    return between(told(command, units).page, "The numbers of this picture", "</thead>");
  };
  CHECK_THAT(numbers("ship"), ContainsSubstring("port, deg<") && ContainsSubstring("deg/s<"));
  CHECK_THAT(numbers("si"), ContainsSubstring("port, rad<") && ContainsSubstring("rad/s<"));
}

}  // namespace
}  // namespace swayaw

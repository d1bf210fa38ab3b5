#include <catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "program.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/recording_csv.hpp"
#include "swayaw/nonlinear/manoeuvre.hpp"
#include "swayaw/nonlinear/published_ships.hpp"

/// First screens of the pages of trial, check, identify and tune beside the JSON of the same command.
namespace swayaw {
namespace {

using test::run;
using test::Scratch;

const std::string kvlcc2_l7 = test::ship_file("kvlcc2_l7.toml");

struct Written {
  nlohmann::json json;
  std::string html;

  /// What is read first, without markup.
  std::string first_screen() const {
    const auto from = html.find("<div class=\"first\">"), to = html.find("class=\"assumed\"");
    REQUIRE(from < to);
    std::string words;
    bool inside = false;
    for (std::size_t i = from; i < to; ++i) {
      if (html[i] == '<') inside = true, words += ' ';
      else if (html[i] == '>') inside = false;
      else if (!inside) words += html[i];
    }
    return std::regex_replace(words, std::regex("\u00a0"), " ");
  }

  /// Rows of the table whose caption begins so, without that of the headings.
  std::size_t rows_of(const std::string& caption) const {
    const auto from = html.find("<caption>" + caption), to = html.find("</table>", from);
    REQUIRE(from < to);
    std::size_t rows = 0;
    for (auto at = html.find("<tr>", from); at < to; at = html.find("<tr>", at + 1)) ++rows;
    return rows - 1;
  }

  std::string tone() const {
    std::smatch found;
    const auto at = html.find("<p class=\"verdict ");
    const auto line = html.substr(at, 60);
    return std::regex_search(line, found, std::regex("verdict (\\w+)")) ? found[1].str() : "";
  }
};

Written written(const Scratch& scratch, const std::string& command) {
  const auto page = scratch / "page.html";
  const auto outcome = run(scratch, command + " --json --report " + page.string());
  INFO(command << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return {test::json_of(outcome.out), read_text(page)};
}

/// Keys of JSON and files; symbols of coefficients begin with a capital.
bool has_raw_key(const std::string& words) {
  return std::regex_search(words, std::regex("\\b[a-z][a-z0-9]+_[a-z0-9]+"));
}

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

/// To the second digit of the error.
std::string told(double value, double error) {
  const int decimals = std::min(8, 1 - static_cast<int>(std::floor(std::log10(error))));
  return fixed(value, decimals) + " ± " + fixed(error, decimals);
}

std::string percent(double share) { return fixed(100.0 * share, share < 0.095 ? 1 : 0) + " %"; }

/// The recordings of the project by names without underscores.
std::string recording(const Scratch& scratch, const std::string& name) {
  const auto file = scratch / (name + ".csv");
  const auto of = name == "turn" ? "weak_rudder_turn35.csv" : "weak_rudder_zz10_10.csv";
  std::filesystem::copy_file(test::example_recordings / of, file, std::filesystem::copy_options::overwrite_existing);
  return file.string();
}

}  // namespace

TEST_CASE("the page of identify tells what its JSON tells", "[app][second-route]") {
  const Scratch scratch;
  const auto page = written(
      scratch, "identify " + recording(scratch, "zigzag") + " --holdout " + recording(scratch, "turn") + " --ship " +
                   kvlcc2_l7 + " --model mmg --find Y_v,Y_r,N_v,N_r --out " + (scratch / "new.toml").string());
  const auto words = page.first_screen();
  CHECK(page.rows_of("Coefficients") == page.json["coefficients"].size());
  for (const auto& c : page.json["coefficients"]) CHECK_THAT(words, ContainsSubstring(c["name"].get<std::string>()));
  const auto& held = page.json["verdict"]["holdout"];
  CHECK_THAT(words, ContainsSubstring("from " + percent(held["before"].get<double>()) + " to " +
                                      percent(held["after"].get<double>())));
  CHECK(!has_raw_key(words));
  CHECK(page.html.find("<script") == std::string::npos);
}

TEST_CASE("the page of identify is written, and bad, where held-out runs are predicted worse", "[app]") {
  const Scratch scratch;
  const auto page = scratch / "page.html";
  const auto outcome = run(scratch, "identify " + recording(scratch, "zigzag") + " --holdout " +
                                        recording(scratch, "turn") + " --ship " + kvlcc2_l7 + " --model mmg --out " +
                                        (scratch / "new.toml").string() + " --report " + page.string());
  CHECK(outcome.code == 1);
  const Written shown{{}, read_text(page)};
  CHECK(shown.tone() == "bad");
  CHECK_THAT(shown.first_screen(), ContainsSubstring("predicted worse"));
}

TEST_CASE("the page of identify says that no run was held out", "[app]") {
  const Scratch scratch;
  const auto page = written(scratch, "identify " + recording(scratch, "zigzag") + " --ship " + kvlcc2_l7 +
                                         " --model mmg --find Y_v,N_v --out " + (scratch / "new.toml").string());
  CHECK_THAT(page.first_screen(), ContainsSubstring("No run was held out"));
  CHECK(page.rows_of("Coefficients") == 2);
  CHECK(page.tone() == "look");
}

TEST_CASE("a linear identification has a page, too", "[app]") {
  const Scratch scratch;
  const auto page = written(scratch, "identify " + recording(scratch, "zigzag") + " --ship " + kvlcc2_l7 +
                                         " --model linear --out " + (scratch / "new.toml").string());
  CHECK(page.rows_of("Dimensionless coefficients") == page.json["coefficients"].size());
  const auto& a1 = page.json["coefficients"][0];
  const auto words = page.first_screen();
  CHECK_THAT(words, ContainsSubstring(told(a1["value"].get<double>(), a1["standard_error"].get<double>())));
  CHECK(!has_raw_key(words));
}

TEST_CASE("the page of tune counts indices that agree and changes as its JSON has them", "[app][second-route]") {
  const Scratch scratch;
  const auto indices = (test::example_recordings.parent_path() / "indices" / "nawigator.toml").string();
  const auto page = written(scratch, "tune " + test::ship_file("nawigator_ym.toml") + " --indices " + indices +
                                         " --prior 1 --bound 1 --out " + (scratch / "new.toml").string());
  double squares = 0.0;
  std::size_t agree = 0, held = 0;
  for (const auto& i : page.json["indices"]) {
    const double off = i["after"].get<double>() - i["measured"].get<double>();
    squares += std::pow(off / i["measured"].get<double>(), 2);
    agree += std::abs(off) <= 2.0 * i["sd"].get<double>() ? 1 : 0;
  }
  for (const auto& n : page.json["numbers"]) held += n["at_bound"] ? 1 : 0;
  const auto all = page.json["indices"].size();
  const auto words = page.first_screen();
  CHECK_THAT(words, ContainsSubstring(std::to_string(agree) + " of " + std::to_string(all) + " agree now"));
  CHECK_THAT(words, ContainsSubstring("off by " + percent(std::sqrt(squares / static_cast<double>(all)))));
  CHECK_THAT(words, ContainsSubstring(std::to_string(held) + " coefficients went to the bound"));
  CHECK(page.rows_of("Indices") == all + 4);  // a title for each manoeuvre
  CHECK(page.rows_of("Coefficients") == page.json["numbers"].size());
  CHECK(!has_raw_key(words));
}

TEST_CASE("the page of trial has the overshoots in its headline and a verdict for each criterion",
          "[app][second-route]") {
  const Scratch scratch;
  const auto page = written(scratch, "trial " + recording(scratch, "zigzag") + " --ship " + kvlcc2_l7);
  const auto words = page.first_screen();
  const auto& overshoots = page.json["runs"][0]["overshoot_deg"];
  CHECK_THAT(words, ContainsSubstring("first overshoot " + fixed(overshoots[0]["value"].get<double>(), 2) +
                                      " deg (limit 10 deg)"));
  CHECK_THAT(words, ContainsSubstring("second overshoot " + fixed(overshoots[1]["value"].get<double>(), 1) +
                                      " deg (limit 25 deg)"));
  CHECK_THAT(words, ContainsSubstring("the zigzag 20/20 and the turning circle with full rudder were not sailed"));
  std::size_t passed = 0;
  for (auto at = page.html.find("\"good\">pass<"); at != std::string::npos;
       at = page.html.find("\"good\">pass<", at + 1))
    ++passed;
  CHECK(passed == page.json["runs"][0]["imo"].size());
  CHECK(!has_raw_key(words));
}

TEST_CASE("the page of trial without a length judges nothing and says why", "[app]") {
  const Scratch scratch;
  const auto words = written(scratch, "trial " + recording(scratch, "zigzag")).first_screen();
  CHECK_THAT(words, ContainsSubstring("No criterion of MSC.137(76) is judged"));
  CHECK_THAT(words, ContainsSubstring("the length of the ship is not known"));
}

TEST_CASE("the page of check names the gyro's zero with the number of its JSON", "[app][second-route]") {
  const Scratch scratch;
  auto recorded = zigzag(published_ship("kvlcc2_l7"), {radians(20), radians(20), Side::port}, {.step = 0.2}).run;
  for (double& r : recorded.fill(Channel::r)) r += radians(0.05);
  write_recording(recorded, scratch / "run.csv");
  const auto command = "check " + (scratch / "run.csv").string();
  const auto page = written(scratch, command);
  const auto& instruments = page.json["runs"][0]["instruments"];
  const auto zero =
      std::ranges::find_if(instruments, [](const auto& e) { return e["channel"] == "r" && e["error"] == "zero"; });
  REQUIRE(zero != instruments.end());
  const double value = (*zero)["value"].get<double>(), error = (*zero)["standard_error"].get<double>();
  const auto words = page.first_screen();
  CHECK_THAT(words, ContainsSubstring("Yaw rate: zero off by " + told(degrees(value), degrees(error)) + " deg/s"));
  CHECK(page.rows_of("Told errors first") == instruments.size());
  CHECK(page.tone() == "look");
  CHECK(!has_raw_key(words));
  CHECK_THAT(written(scratch, command + " --units si").first_screen(),
             ContainsSubstring("zero off by " + told(value, error) + " rad/s"));
}

TEST_CASE("the page of check begins with a mistake and its remedy", "[app]") {
  const Scratch scratch;
  auto reversed = zigzag(published_ship("kvlcc2_l7"), {radians(20), radians(20), Side::port}, {.step = 0.2}).run;
  for (double& delta : reversed.fill(Channel::delta)) delta = -delta;
  write_recording(reversed, scratch / "run.csv");
  const auto page = written(scratch, "check " + (scratch / "run.csv").string());
  CHECK(page.tone() == "bad");
  CHECK_THAT(page.first_screen(), ContainsSubstring("--rudder-positive"));
}

}  // namespace swayaw

#include "swayaw/app/report.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace {

using nlohmann::json;

int failures = 0;

void check(bool holds, std::string_view sentence) {
  if (holds) return;
  ++failures;
  std::fprintf(stderr, "not true: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

swayaw::Page first() { return {.kicker = "Comparison", .title = "A ship", .headline = "She is off by 3 %."}; }

std::vector<double> wave(std::size_t count, double size) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = size * std::sin(0.0123456789 * double(i));
  return values;
}

json channels(std::size_t count) {
  json all = json::object();
  for (const char* name : {"x_m", "y_m", "psi_rad", "u_m_s", "v_m_s", "r_rad_s", "delta_rad"}) {
    all[name] = wave(count, 1.23456789);
  }
  all["drift_rad"] = wave(count, 0.2);
  return all;
}

json with_break_at(json windows, std::size_t index) {
  for (auto& values : windows) values[index] = nullptr;
  return windows;
}

json run_of(const std::string& name, std::size_t samples) {
  return {{"run", name},
          {"manoeuvre", nullptr},
          {"duration_s", 66.2},
          {"samples", samples},
          {"windows", 2},
          {"quantities", json::array({{{"quantity", "heading"},
                                       {"unit", "rad"},
                                       {"window_rms", 0.0123456789},
                                       {"normalised", 0.12},
                                       {"worst", nullptr},
                                       {"region", nullptr},
                                       {"by_region", json::array()}}})},
          {"series",
           {{"time_s", wave(samples, 60.0)},
            {"recorded", channels(samples)},
            {"open_loop", channels(samples)},
            {"windows", with_break_at(channels(samples), samples / 2 + 1)}}}};
}

json data_of(const std::vector<json>& runs) {
  return {{"version", "0.1.0"}, {"length_m", 7.0}, {"window_ship_lengths", 2}, {"runs", runs}};
}

std::string element(const std::string& page, const std::string& opening) {
  const auto start = page.find(opening) + opening.size();
  return page.substr(start, page.find("</script>", start) - start);
}

std::string data_text(const std::string& page) {
  return element(page, "<script id=\"data\" type=\"application/json\">");
}

std::string plotly(const std::string& page) { return element(page, "<script id=\"plotly\" type=\"text/plain\">"); }

bool contains(const std::string& text, std::string_view piece) { return text.find(piece) != std::string::npos; }

std::size_t occurrences(const std::string& text, std::string_view piece) {
  std::size_t count = 0;
  for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++count;
  return count;
}

void the_page_carries_the_data() {
  const json given = data_of({run_of("zz10.csv", 40)});
  const json shown = json::parse(data_text(swayaw::comparison_page(first(), given)));
  check(shown["length_m"] == given["length_m"], "the length is carried unchanged");
  check(shown["runs"][0]["quantities"] == given["runs"][0]["quantities"], "the errors are carried with full precision");
  check(shown["runs"][0]["series"]["recorded"]["x_m"].size() == 40, "short series are kept whole");
  const double value = given["runs"][0]["series"]["recorded"]["x_m"][7];
  const double rounded = shown["runs"][0]["series"]["recorded"]["x_m"][7];
  check(std::abs(rounded - value) <= 5e-6 * std::abs(value), "series keep six digits");
}

void the_page_is_whole() {
  const auto page = swayaw::comparison_page(first(), data_of({run_of("zz10.csv", 40)}));
  check(page.starts_with("<!DOCTYPE html>"), "the page is an HTML document");
  check(!contains(page.substr(0, page.find("<script")), "{{"), "every marker in the head is filled");
  check(plotly(page).size() > 900'000, "Plotly is in the page");
  check(contains(page, "IntersectionObserver"), "our script is in the page");
}

void the_page_names_no_address() {
  auto page = swayaw::comparison_page(first(), data_of({run_of("zz10.csv", 40)}));
  const auto library = plotly(page);
  page.erase(page.find(library), library.size());
  check(!contains(page, "http://"), "nothing outside Plotly names an http address");
  check(!contains(page, "https://"), "nothing outside Plotly names an https address");
  check(!contains(page, "src="), "nothing is loaded from elsewhere");
}

void a_run_name_stays_text() {
  const std::string name = "</script><!--<script>alert(1)</script>\u2028\u2029{{plotly}}.csv";
  const auto page = swayaw::comparison_page(first(), data_of({run_of(name, 40)}));
  const auto harmless = swayaw::comparison_page(first(), data_of({run_of("zz10.csv", 40)}));
  check(occurrences(page, "</script>") == occurrences(harmless, "</script>"),
        "a run name cannot close the script element");
  check(json::parse(data_text(page))["runs"][0]["run"] == name, "a run name is carried exactly");
  check(!contains(data_text(page), "\u2028"), "line separators are escaped");
}

void broken_text_is_shown_all_the_same() {
  const auto page = swayaw::comparison_page(first(), data_of({run_of("zz\xff.csv", 40)}));
  check(json::accept(data_text(page)), "a name that is not UTF-8 does not spoil the data");
}

void long_runs_are_thinned() {
  const std::size_t samples = 20'000;
  const auto page = swayaw::comparison_page(first(), data_of({run_of("long.csv", samples)}));
  const json series = json::parse(data_text(page))["runs"][0]["series"];
  const auto& windows = series["windows"]["psi_rad"];
  check(series["time_s"].size() <= 1600, "a long run is thinned");
  check(windows.size() == series["time_s"].size(), "all series of a run keep one length");
  check(occurrences(windows.dump(), "null") == 1, "the break between two windows survives");
  check(series["time_s"].back() != nullptr, "the last sample has its time");
}

void three_runs_stay_small() {
  const auto page =
      swayaw::comparison_page(first(), data_of({run_of("a.csv", 1000), run_of("b.csv", 1000), run_of("c.csv", 1000)}));
  check(page.size() < 2'500'000, "three runs of a thousand samples take less than 2.5 MB");
}

void sparse_data_are_accepted() {
  check(!swayaw::comparison_page(first(), json::object()).empty(), "an empty object gives a page");
  check(!swayaw::comparison_page(first(), data_of({json{{"run", "a.csv"}}})).empty(),
        "a run without series gives a page");
}

}  // namespace

void the_loop_page_carries_its_data() {
  const json data = {{"slope", 0.25}, {"version", "<Tanker>"}};
  const auto page = swayaw::loop_page(first(), data);
  check(json::parse(data_text(page)) == data, "the numbers of a loop are carried unchanged");
  check(contains(page, "showLoop"), "the loop page has its own script");
  check(!contains(page, "<Tanker>"), "the ship's name cannot become markup");
}

void the_diagnosis_page_carries_its_data() {
  const json effect = {{"effect", "steady_wind"},
                       {"probability", 0.98},
                       {"parameters", {{"wind_speed_m_s", {{"value", 11.25}, {"standard_error", 0.4}}}}}};
  const json data = {{"version", "<Tanker>"}, {"effects", {effect}}, {"runs", {run_of("zz10.csv", 40)}}};
  const auto page = swayaw::diagnosis_page(first(), data);
  const json shown = json::parse(data_text(page));
  check(shown["effects"] == data["effects"], "the effects are carried unchanged");
  check(shown["runs"][0]["series"]["time_s"].size() == 40, "the series are in the page");
  check(contains(page, "showDiagnosis"), "the page of a diagnosis has its own script");
  check(!contains(page, "<Tanker>"), "the ship's name cannot become markup");
  check(!swayaw::diagnosis_page(first(), json::object()).empty(), "an empty object gives a page");
}

void the_trial_page_carries_its_data() {
  const json run = {{"run", "zz10.csv"}, {"overshoot_deg", {{{"value", 8.25}, {"standard_error", 0.04}}}}};
  const json data = {{"version", "<Tanker>"}, {"runs", {run}}};
  const auto page = swayaw::trial_page(first(), data);
  check(json::parse(data_text(page))["runs"] == data["runs"], "the numbers of a trial are carried unchanged");
  check(contains(page, "showTrial"), "the page of a trial has its own script");
  check(!contains(page, "<Tanker>"), "the ship's name cannot become markup");
  check(!swayaw::trial_page(first(), json::object()).empty(), "an empty object gives a page");
}

int main() {
  the_page_carries_the_data();
  the_page_is_whole();
  the_page_names_no_address();
  a_run_name_stays_text();
  broken_text_is_shown_all_the_same();
  long_runs_are_thinned();
  three_runs_stay_small();
  sparse_data_are_accepted();
  the_loop_page_carries_its_data();
  the_diagnosis_page_carries_its_data();
  the_trial_page_carries_its_data();
  return failures == 0 ? 0 : 1;
}

#include "swayaw/app/report.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "base64.hpp"
#include "script_hashes.hpp"

extern "C" {
extern const char swayaw_report_page_html[];
extern const char swayaw_report_page_html_end[];
extern const char swayaw_report_scripts_html[];
extern const char swayaw_report_scripts_html_end[];
extern const char swayaw_report_page_css[];
extern const char swayaw_report_page_css_end[];
extern const char swayaw_report_page_js[];
extern const char swayaw_report_page_js_end[];
extern const char swayaw_report_check_js[];
extern const char swayaw_report_check_js_end[];
extern const char swayaw_report_compare_js[];
extern const char swayaw_report_compare_js_end[];
extern const char swayaw_report_loop_js[];
extern const char swayaw_report_loop_js_end[];
extern const char swayaw_report_diagnose_js[];
extern const char swayaw_report_diagnose_js_end[];
extern const char swayaw_report_trial_js[];
extern const char swayaw_report_trial_js_end[];
extern const char swayaw_report_plotly_js[];
extern const char swayaw_report_plotly_js_end[];
}

namespace swayaw {
namespace {

using nlohmann::json;

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

std::string_view skeleton() { return between(swayaw_report_page_html, swayaw_report_page_html_end); }

// The fewer the runs, the finer each may be drawn: the page stays a few megabytes.
std::size_t sample_limit(std::size_t runs) {
  return std::clamp<std::size_t>(12000 / std::max<std::size_t>(runs, 1), 600, 1500);
}

double six_digits(double value) {
  char text[32];
  const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
  double rounded = value;
  std::from_chars(text, written.ptr, rounded);
  return rounded;
}

void round_values(json& values) {
  for (auto& value : values) {
    if (value.is_number_float() && std::isfinite(value.get<double>())) {
      value = six_digits(value.get<double>());
    }
  }
}

void keep_only(json& values, const std::vector<std::size_t>& kept) {
  json chosen = json::array();
  for (const auto index : kept) chosen.push_back(std::move(values[index]));
  values = std::move(chosen);
}

// Marks where a line stops, and the sample after it, so that thinning cannot join two windows.
void mark_breaks(const json& values, std::vector<bool>& wanted) {
  for (std::size_t i = 1; i < wanted.size(); ++i) {
    if (!values[i].is_null() || values[i - 1].is_null()) continue;
    wanted[i] = true;
    if (i + 1 < wanted.size()) wanted[i + 1] = true;
  }
}

std::vector<std::size_t> samples_to_keep(const json& series, std::size_t count, std::size_t limit) {
  std::vector<bool> wanted(count, false);
  const std::size_t stride = (count + limit - 1) / limit;
  for (std::size_t i = 0; i < count; i += stride) wanted[i] = true;
  wanted.back() = true;
  if (const auto windows = series.find("windows"); windows != series.end()) {
    for (const auto& values : *windows) {
      if (values.is_array() && values.size() == count) mark_breaks(values, wanted);
    }
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; ++i) {
    if (wanted[i]) kept.push_back(i);
  }
  return kept;
}

template <typename Change>
void for_each_channel(json& series, std::size_t count, Change change) {
  for (auto& part : series) {
    if (part.is_array() && part.size() == count) {
      change(part);
    } else if (part.is_object()) {
      for_each_channel(part, count, change);
    }
  }
}

void compact_series(json& series, std::size_t limit) {
  const auto time = series.find("time_s");
  if (time == series.end() || !time->is_array()) return;
  const std::size_t count = time->size();
  if (count > limit) {
    const auto kept = samples_to_keep(series, count, limit);
    for_each_channel(series, count, [&](json& values) { keep_only(values, kept); });
    for_each_channel(series, kept.size(), round_values);
  } else {
    for_each_channel(series, count, round_values);
  }
}

json compact(json data) {
  const auto runs = data.find("runs");
  if (runs == data.end()) return data;
  for (auto& run : *runs) {
    const auto series = run.find("series");
    if (series != run.end() && series->is_object()) {
      compact_series(*series, sample_limit(runs->size()));
    }
  }
  return data;
}

// JSON text that no HTML parser can take for markup: these three only occur inside strings.
std::string script_safe(std::string_view text) {
  constexpr std::string_view line_separator = "\xe2\x80\xa8";
  constexpr std::string_view paragraph_separator = "\xe2\x80\xa9";
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto three = text.substr(i, 3);
    if (text[i] == '<') {
      safe += "\\u003c";
    } else if (three == line_separator || three == paragraph_separator) {
      safe += three == line_separator ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += text[i];
    }
  }
  return safe;
}

std::string data_text(const json& data) {
  return script_safe(data.dump(-1, ' ', false, json::error_handler_t::replace));
}

using Texts = std::map<std::string_view, std::string_view>;

// The text with each {{marker}} replaced.
std::string fill(std::string_view page, const Texts& texts) {
  constexpr std::string_view open = "{{";
  constexpr std::string_view close = "}}";
  std::string filled;
  for (;;) {
    const auto start = page.find(open);
    filled += page.substr(0, start);
    if (start == std::string_view::npos) return filled;
    page.remove_prefix(start + open.size());
    const auto stop = page.find(close);
    filled += texts.at(page.substr(0, stop));
    page.remove_prefix(stop + close.size());
  }
}

std::string scripts_html(std::string_view script, const std::string& data) {
  return fill(between(swayaw_report_scripts_html, swayaw_report_scripts_html_end),
              {{"data", data},
               {"plotly", between(swayaw_report_plotly_js, swayaw_report_plotly_js_end)},
               {"helpers", between(swayaw_report_page_js, swayaw_report_page_js_end)},
               {"script", script}});
}

constexpr std::string_view drawn_details =
    "<noscript><p class=\"note\">The plots further down are drawn with JavaScript, which is switched off "
    "here.</p></noscript>\n<div id=\"report\"></div>";

/// How a Content-Security-Policy names a script by its hash, which is told in hexadecimal digits.
std::string by_hash(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    unsigned char byte = 0;
    std::from_chars(digits.data() + i, digits.data() + i + 2, byte, 16);
    bytes += static_cast<char>(byte);
  }
  return "'sha256-" + base64(bytes) + "'";
}

/// @param allowed  scripts that the browser may run; no other, whatever a text of a file might smuggle in
std::string filled(const Page& page, std::string_view details, std::string_view scripts, std::string_view allowed) {
  const auto title = escaped(page.title + ": " + page.kicker), description = escaped(page.headline),
             first = first_screen_html(page), sections = sections_html(page);
  return fill(skeleton(), {{"allowed", allowed},
                           {"title", title},
                           {"description", description},
                           {"style", between(swayaw_report_page_css, swayaw_report_page_css_end)},
                           {"first", first},
                           {"details", details},
                           {"sections", sections},
                           {"scripts", scripts}});
}

std::string with_plots(const Page& page, std::string_view script, std::string_view hash, const json& data) {
  return filled(page, drawn_details, scripts_html(script, data_text(data)),
                by_hash(hash) + " " + by_hash(script_hash::plotly));
}

}  // namespace

std::string html(const Page& page) { return filled(page, {}, {}, "'none'"); }

std::string check_page(const Page& page, const json& data) {
  return with_plots(page, between(swayaw_report_check_js, swayaw_report_check_js_end), script_hash::check, data);
}

std::string comparison_page(const Page& page, const json& data) {
  return with_plots(page, between(swayaw_report_compare_js, swayaw_report_compare_js_end), script_hash::compare,
                    compact(data));
}

std::string loop_page(const Page& page, const json& data) {
  return with_plots(page, between(swayaw_report_loop_js, swayaw_report_loop_js_end), script_hash::loop, data);
}

std::string diagnosis_page(const Page& page, const json& data) {
  return with_plots(page, between(swayaw_report_diagnose_js, swayaw_report_diagnose_js_end), script_hash::diagnose,
                    compact(data));
}

std::string trial_page(const Page& page, const json& data) {
  return with_plots(page, between(swayaw_report_trial_js, swayaw_report_trial_js_end), script_hash::trial, data);
}

}  // namespace swayaw

#include <algorithm>

#include "check_page.hpp"
#include "checked_runs.hpp"
#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "swayaw/app/report.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/data_compatibility.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- JSON

Json error_json(const InstrumentError& e) {
  Json json{{"channel", short_name(e.channel)},
            {"error", name_of(e.kind)},
            {"value", number(e.value)},
            {"standard_error", number(e.standard_error)},
            {"unit", unit_of(e)},
            {"told", e.told},
            {"words", words_for(e)},
            {"remedy", remedy_for(e)}};
  if (e.kind == InstrumentErrorKind::jump) {
    json["at_s"] = number(e.at);
    json["at_standard_error_s"] = number(e.at_standard_error);
  }
  if (!e.readings.empty()) json["readings"] = e.readings;
  return json;
}

Json errors_json(const std::vector<InstrumentError>& errors) {
  Json list = Json::array();
  for (const auto& e : errors) list.push_back(error_json(e));
  return list;
}

Json channel_json(const ChannelCharacter& c) {
  return {{"channel", short_name(c.channel)}, {"samples", c.samples},
          {"step", number(c.step)},           {"noise", number(c.noise)},
          {"interval_s", number(c.interval)}, {"interpolated", c.interpolated},
          {"outliers", c.outliers.size()}};
}

Json run_json(const RunCheck& check) {
  Json channels = Json::array(), gaps = Json::array();
  for (const auto& c : check.channels) channels.push_back(channel_json(c));
  for (std::size_t i = 0; i + 1 < check.gaps.size(); i += 2) gaps.push_back({check.gaps[i], check.gaps[i + 1]});
  Json derived = Json::array();
  for (const auto& d : check.derived) derived.push_back({{"channel", short_name(d.channel)}, {"made_of", d.made_of}});
  return {{"run", check.run},
          {"group", check.group},
          {"derived", std::move(derived)},
          {"instruments", errors_json(check.errors)},
          {"channels", std::move(channels)},
          {"gaps_s", std::move(gaps)},
          {"cannot_tell", check.cannot_tell}};
}

Json document_of(const std::vector<RunCheck>& checks, const std::optional<RunCheck>& one_clock) {
  Json runs = Json::array();
  for (const auto& check : checks) runs.push_back(run_json(check));
  Json document{{"schema", "swayaw.check/1"}, {"version", version()}, {"runs", std::move(runs)}};
  if (checks.size() > 1) document["all_runs"] = errors_json(pooled(checks));
  if (const auto groups = grouped(checks); groups.size() > 1)
    for (const auto& g : groups)
      document["groups"].push_back({{"group", g.group}, {"runs", g.runs}, {"instruments", errors_json(g.errors)}});
  if (one_clock) document["one_clock"] = errors_json(one_clock->errors);
  return document;
}

// ---------------------------------------------------------------- text

/// The factor from SI to the unit in which people read a channel, and its name.
struct Unit {
  double factor;
  std::string_view name;
};

Unit unit_of(Channel channel) {
  switch (dimension_of(channel)) {
    case Dimension::length: return {1.0, "m"};
    case Dimension::bearing:
    case Dimension::angle: return {degrees(1.0), "deg"};
    case Dimension::yaw_rate: return {degrees(1.0), "deg/s"};
    case Dimension::speed: return {1.0, "m/s"};
    default: return {1.0, ""};
  }
}

void print_channel(const ChannelCharacter& c) {
  const auto [factor, unit] = unit_of(c.channel);
  say("    {:<12}{:>8} samples, noise {:.2g} {}", short_name(c.channel), c.samples, factor * c.noise, unit);
  if (c.step > c.noise) say(", in steps of {:.2g} {}", factor * c.step, unit);
  if (c.interpolated) say(", measured every {:.2g} s and on straight lines between", c.interval);
  if (!c.outliers.empty()) say(", {} outlier{}", c.outliers.size(), c.outliers.size() == 1 ? "" : "s");
  say("\n");
}

void print_errors(const std::vector<InstrumentError>& errors, bool told) {
  for (const auto& e : errors) {
    if (e.told != told) continue;
    say("    {}\n", words_for(e));
    if (const auto remedy = remedy_for(e); !remedy.empty()) say("        {}\n", remedy);
  }
}

bool has(const std::vector<InstrumentError>& errors, bool told) {
  return std::ranges::any_of(errors, [&](const InstrumentError& e) { return e.told == told; });
}

void print_all(const std::vector<InstrumentError>& errors) {
  say("{}\n", has(errors, true) ? "  Told:" : "  No error of an instrument is told.");
  print_errors(errors, true);
  if (has(errors, false)) say("  Not told from none, or too small to matter (± standard error):\n");
  print_errors(errors, false);
}

void print(const RunCheck& check) {
  say("{}\n", check.run);
  print_all(check.errors);
  for (const auto& d : check.derived)
    say("  Not measured: {} is made of {}; it is left out of the check\n", short_name(d.channel), d.made_of);
  for (const auto& line : check.cannot_tell) say("  Cannot tell: {}\n", line);
  for (std::size_t i = 0; i + 1 < check.gaps.size(); i += 2)
    say("  No heading from {:.6g} to {:.6g} s\n", check.gaps[i], check.gaps[i + 1]);
  say("  Channels:\n");
  std::ranges::for_each(check.channels, print_channel);
}

/// Of runs that were not all made with the same instruments, loading and surroundings.
void print_groups(const std::vector<RunCheck>& checks) {
  const auto groups = grouped(checks);
  if (groups.size() < 2) return;
  for (const auto& group : groups) {
    say("{}: {}\n", group.group.empty() ? "Without group" : "Group " + group.group, fmt::join(group.runs, ", "));
    print_all(group.errors);
  }
}

}  // namespace

void check(const CheckArguments& a) {
  const auto runs = loaded_runs(a.runs, a.rudder_positive);
  const auto checks = checks_of(runs, ShortRuns::refused);
  const auto log = joined(runs);
  const auto one_clock = log ? std::optional(check_run(*log)) : std::nullopt;
  if (!a.out.empty()) {
    write_recording(repaired(runs.front(), checks.front()), a.out);
    say_aside("swayaw: repaired recording written to {}\n", a.out.string());
  }
  if (a.report.wanted())
    write_page(a.report.file,
               check_page(first_screen(checks, one_clock, a.report.si),
                          for_page(only(document_of(checks, one_clock), {"version", "runs", "all_runs"}))));
  if (a.json) {
    print_document(document_of(checks, one_clock));
    return;
  }
  std::ranges::for_each(checks, print);
  if (checks.size() < 2) return;
  print_groups(checks);
  say("All runs\n");
  print_all(pooled(checks));
  if (!one_clock) return;
  say("The log that the runs were cut from, on one clock\n");
  print_all(one_clock->errors);
}

}  // namespace swayaw::app

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

#include "fleet_case.hpp"
#include "swayaw/core/refusal.hpp"

/// Fleets by chance, diagnosed: how many changes are found, with their dates and sizes. The table goes to stdout, each
/// vessel to stderr. docs/results/make_fleets.sh
namespace {

using namespace swayaw;
using namespace swayaw::concealed;

struct Count {
  int vessels = 0, found = 0, worst = 0, date = 0, size = 0, others = 0;
};

double departure(const VesselChange& c) { return c.after - c.before; }

std::string words_of(const VesselReport& v) {
  std::string told;
  for (const auto& c : v.changes)
    told += fmt::format(" {} {} {:+.3g} ± {:.2g} since {} ({} to {}), gain {:.1f};", id_of(c.effect), name_of(c.shape),
                        departure(c), c.standard_error, date_text(c.since.likeliest), date_text(c.since.from),
                        date_text(c.since.to), c.log_evidence_gain);
  for (const auto& x : v.differences)
    told += fmt::format(" [{} {:+.3g} ± {:.2g}]", id_of(x.effect), x.own - x.sisters, x.standard_error);
  return told.empty() ? " nothing" : told;
}

std::string words_of(const std::optional<TrueChange>& change) {
  return change ? fmt::format("{} {} {:+.3g} since {}", change->effect, name_of(change->shape), change->size,
                              date_text(change->since))
                : "nothing";
}

class Tables {
 public:
  void add(const FleetCase& fleet, const FleetDiagnosis& d, double seconds) {
    ++fleets_, seconds_ += seconds, runs_ += fleet.runs.size();
    for (const auto& v : d.vessels) {
      const auto place = static_cast<std::size_t>(std::ranges::find(fleet.vessels, v.vessel) - fleet.vessels.begin());
      const auto& truth = fleet.changes[place];
      fmt::print(stderr, "  {} {} days: {} ->{} | {:.3f} {:.3f} {:.3f}\n", v.vessel, v.days, words_of(truth),
                 words_of(v), v.errors.given, v.errors.sisters, v.errors.own);
      given_ += v.errors.given, sisters_ += v.errors.sisters, own_ += v.errors.own, ++vessels_;
      auto& count = counts_[truth ? truth->effect : "nothing"];
      ++count.vessels;
      const auto found = truth ? std::ranges::find_if(
                                     v.changes, [&](const VesselChange& c) { return id_of(c.effect) == truth->effect; })
                               : v.changes.end();
      count.others += static_cast<int>(v.changes.size()) - (found != v.changes.end());
      if (found == v.changes.end()) continue;
      ++count.found;
      count.worst += found == v.changes.begin();
      count.date += found->since.from <= truth->since && truth->since <= found->since.to;
      count.size += std::abs(departure(*found) - truth->size) <= 1.96 * found->standard_error;
    }
  }

  void print() const {
    fmt::print(
        "| what changed | vessels | found | named first | 95 % of the dates hold it | 95 % of the sizes hold it | "
        "something else named |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    Count all;
    for (const auto& [effect, c] : counts_) {
      fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", effect, c.vessels, c.found, c.worst, c.date, c.size,
                 c.others);
      if (effect == "nothing") continue;
      all.vessels += c.vessels, all.found += c.found, all.worst += c.worst, all.date += c.date, all.size += c.size,
          all.others += c.others;
    }
    fmt::print("| **all that changed** | {} | {} | {} | {} | {} | {} |\n\n", all.vessels, all.found, all.worst,
               all.date, all.size, all.others);
    fmt::print(
        "{} fleets, {} vessels, {} runs; {:.0f} s on all cores, {:.2f} s a run. Errors of replays, mean of all "
        "vessels: {:.1f} % of the variation by the file as given, {:.1f} % by the class, {:.1f} % with what each "
        "vessel has of her own.\n",
        fleets_, vessels_, runs_, seconds_, seconds_ / static_cast<double>(runs_), 100.0 * given_ / vessels_,
        100.0 * sisters_ / vessels_, 100.0 * own_ / vessels_);
  }

 private:
  std::map<std::string, Count> counts_;
  int fleets_ = 0, vessels_ = 0;
  std::size_t runs_ = 0;
  double seconds_ = 0.0, given_ = 0.0, sisters_ = 0.0, own_ = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Fleets by chance and what is found in them");
  std::uint64_t seed = 1;
  int count = 20, quiet = 10;
  FleetOptions options;
  app.add_option("--seed", seed, "of the first fleet");
  app.add_option("--count", count, "fleets in which something may change");
  app.add_option("--quiet", quiet, "fleets in which nothing changes");
  app.add_option("--detection", options.detection, "gain in log evidence that a change must bring");
  CLI11_PARSE(app, argc, argv);
  Tables tables;
  for (int i = 0; i < count + quiet; ++i) {
    const auto number = seed + static_cast<std::uint64_t>(i);
    try {
      const auto fleet = fleet_by_chance(number, i >= count);
      const auto begin = std::chrono::steady_clock::now();
      const auto d = diagnose_fleet(fleet.ship, fleet.runs, options);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      fmt::print(stderr, "fleet {} of {}: {} runs, {:.1f} s, spread {:.3f}, days {:.3f}\n", number, fleet.structure,
                 fleet.runs.size(), seconds, d.spread, d.day_to_day);
      tables.add(fleet, d, seconds);
    } catch (const std::exception& e) {
      fmt::print(stderr, "fleet {}: {}\n", number, e.what());
    }
  }
  tables.print();
}

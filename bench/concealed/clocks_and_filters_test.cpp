#include <cmath>
#include <vector>

#include "first_effect.hpp"
#include "on_board_instruments.hpp"

/// A clock that runs slow and a filter, in recordings of ships on which nothing else is hidden.
using namespace swayaw;
using namespace swayaw::concealed;

namespace {

/// c(t) = c₀(t − rate (t − begin)), by straight lines between samples.
void on_slow_clock(Recording& run, Channel channel, double rate) {
  const Interpolant truth(run, channel);
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) values[i] = truth(run.time[i] - rate * (run.time[i] - run.time.front()));
}

/// T dy/dt + y = c, worked out at a hundred steps a sample.
void lagged(Recording& run, Channel channel, double T) {
  constexpr int steps = 100;
  const double step = (run.time[1] - run.time[0]) / steps;
  const Interpolant truth(run, channel);
  std::vector<double> fine;
  for (std::size_t i = 0; i + 1 < run.samples(); ++i)
    for (int k = 0; k < steps; ++k) fine.push_back(truth(run.time[i] + k * step));
  fine = smoothed(std::move(fine), step, Smoothing::causal, T);
  auto& values = run.channels[index_of(channel)];
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    if (!std::isnan(values[i])) values[i] = fine[i * steps];
}

ConcealedCase clean_case(std::string_view structure, std::uint64_t seed) {
  auto c = made(on_board_plan(structure, FileForm::mmg, {}, seed));
  REQUIRE(c.labels.empty());
  REQUIRE(c.train.front().has(Channel::r));
  return c;
}

template <class Change>
void change_all(ConcealedCase& c, Change&& change) {
  for (auto* runs : {&c.train, &c.holdout})
    for (auto& run : *runs) change(run);
}

void check_told(const FoundEffect& found, Channel channel, std::string_view key, double truth) {
  REQUIRE(channel_of(found.effect));
  CHECK(*channel_of(found.effect) == channel);
  const auto& p = told(found, key);
  CHECK(std::abs(p.value - truth) < 2.5 * p.standard_error);
  CHECK(p.standard_error < 0.35 * std::abs(truth));
}

}  // namespace

TEST_CASE("positions on a clock that runs slow are told by its rate", "[bench][on_board]") {
  auto c = clean_case("polynomial", 54);
  constexpr double rate = 0.006;
  change_all(c, [](Recording& run) { on_slow_clock(run, Channel::x, rate), on_slow_clock(run, Channel::y, rate); });
  const auto d = diagnosed(c);
  INFO(d.words);
  check_told(checked_first(d, DiagnosisVerdict::missing_physics, "clock_drift"), Channel::x, "rate", rate);
  CHECK(d.words.find("clock runs or jumps against the others (positions)") != std::string::npos);
}

TEST_CASE("a yaw rate behind a filter is told by its time", "[bench][on_board]") {
  auto c = clean_case("twin_screw", 54);
  constexpr double T = 3.0;  // s, 0.2 L/U
  change_all(c, [](Recording& run) { lagged(run, Channel::r, T); });
  const auto d = diagnosed(c);
  INFO(d.words);
  check_told(checked_first(d, DiagnosisVerdict::missing_physics, "channel_filter"), Channel::r, "time_s", T);
}

// Log and gyro of ships are smoothed over half a second to two.
TEST_CASE("a filter as ships have it is no effect", "[bench][on_board]") {
  const auto d = diagnosed(clean_case("cross_flow", 54));
  INFO(d.words);
  CHECK(d.verdict == DiagnosisVerdict::nothing_missing);
}

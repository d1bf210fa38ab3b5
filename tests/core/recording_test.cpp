#include <catch.hpp>
#include <cmath>

#include "swayaw/core/recording.hpp"
#include "swayaw/core/refusal.hpp"

namespace swayaw {
namespace {

Recording run_with_speeds(std::vector<double> time, const std::vector<double>& speeds) {
  Recording run;
  run.name = "run.csv";
  run.time = std::move(time);
  std::ranges::copy(speeds, run.fill(Channel::u).begin());
  return run;
}

TEST_CASE("a channel to be filled is missing at first and keeps what was filled in", "[core]") {
  Recording run;
  run.time = {0.0, 1.0};
  CHECK(run[Channel::u].empty());
  CHECK(std::isnan(run.fill(Channel::u)[1]));
  CHECK_FALSE(run.has(Channel::u));
  run.fill(Channel::u)[1] = 3.0;
  CHECK(run.fill(Channel::u)[1] == 3.0);
  CHECK(run.has(Channel::u));
}

TEST_CASE("samples are joined by straight lines across missing ones and held beyond the ends", "[core]") {
  const Interpolant speed(run_with_speeds({0.0, 1.0, 2.0, 4.0, 5.0}, {missing, 1.0, missing, 7.0, missing}),
                          Channel::u);
  const std::pair<double, double> expected[] = {{-9.0, 1.0}, {1.0, 1.0}, {1.5, 2.0}, {2.0, 3.0},
                                                {4.0, 7.0},  {4.5, 7.0}, {99.0, 7.0}};
  for (const auto& [time, value] : expected) CHECK_THAT(speed(time), WithinAbs(value, 1e-15));
  CHECK(speed.times().size() == 2);
}

TEST_CASE("a single sample is held for ever", "[core][limit]") {
  const Interpolant speed(run_with_speeds({3.0}, {2.0}), Channel::u);
  for (const double time : {-1e9, 3.0, 1e9}) CHECK(speed(time) == 2.0);
}

TEST_CASE("a channel without samples is not interpolated", "[core][refusal]") {
  const auto run = run_with_speeds({0.0, 1.0}, {missing, missing});
  CHECK_THROWS_WITH(Interpolant(run, Channel::u), "run.csv: no sample of u_m_s");
  CHECK_THROWS_AS(Interpolant(run, Channel::psi), Refusal);
}

TEST_CASE("every channel has an SI column and every column a channel of the same name", "[core]") {
  for (std::size_t i = 0; i < channel_count; ++i) {
    const auto column = column_named(column_name(static_cast<Channel>(i)));
    REQUIRE(column.has_value());
    CHECK(index_of(column->channel) == i);
    CHECK(column->si == 1.0);
  }
  CHECK_FALSE(column_named("psi_grad").has_value());
}

}  // namespace
}  // namespace swayaw

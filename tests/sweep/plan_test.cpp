#include <catch.hpp>

#include "swayaw/app/sweep/plan.hpp"
#include "swayaw/app/sweep/work.hpp"

namespace swayaw::app {
namespace {

using Catch::Matchers::Message;

SweepPlan parsed(const std::string& text) { return parse_sweep_plan(text, "plan.toml"); }

std::string refusal(const std::string& text) {
  try {
    const SweepWork work(parsed(text));
  } catch (const Refusal& e) {
    return e.what();
  }
  return "accepted";
}

const std::string head = "task = \"zigzag 10/10\"\nships = [\"kvlcc2\"]\n";

TEST_CASE("a plan is read with its task, ships and laws", "[sweep]") {
  const auto plan = parsed(
      "task = \"zigzag 20/10\"\nfirst = \"port\"\novershoots = 3\nships = [\"kvlcc2\", \"kcs\"]\nspeed_m_s = 7.5\n"
      "draws = 50\nseed = 9\n[vary]\nN_v = { relative_sd = 0.1 }\nN_r = { from = -0.1, to = -0.05 }\n");
  CHECK(plan.task == SweepTask::zigzag);
  CHECK_THAT(plan.rudder, WithinRel(20.0 * 3.14159265358979324 / 180.0));
  CHECK_THAT(plan.heading, WithinRel(10.0 * 3.14159265358979324 / 180.0));
  CHECK(plan.first == Side::port);
  CHECK(plan.overshoots == 3);
  CHECK(plan.ships == std::vector<std::string>{"kvlcc2", "kcs"});
  CHECK(plan.speed == 7.5);
  CHECK(plan.size == 50);
  CHECK(plan.seed == 9);
  REQUIRE(plan.variations.size() == 2);
  CHECK(plan.variations[0].name == "N_r");
  CHECK(plan.variations[0].from == -0.1);
  CHECK(plan.variations[1].relative_sd == 0.1);
}

TEST_CASE("a wrong plan is refused in one line with its place", "[sweep]") {
  CHECK_THAT(refusal("ships = [\"kvlcc2\"]\n"), ContainsSubstring("task is missing"));
  CHECK_THAT(refusal("task = \"zigzag 10\"\nships = [\"kvlcc2\"]\n"),
             ContainsSubstring("plan.toml:1:8: \"zigzag 10\""));
  CHECK_THAT(refusal("task = \"zigzag 10/10 20\"\nships = [\"kvlcc2\"]\n"), ContainsSubstring("is too much"));
  CHECK_THAT(refusal("task = \"spiral\"\nships = [\"kvlcc2\"]\n"), ContainsSubstring("is no task"));
  CHECK_THAT(refusal(head), ContainsSubstring("nothing varies"));
  CHECK_THAT(refusal(head + "[vary]\nN_v = { relative_sd = 0.1 }\n"), ContainsSubstring("draws is missing"));
  CHECK_THAT(refusal(head + "draws = 10\n[vary]\nN_w = { relative_sd = 0.1 }\n"),
             ContainsSubstring("plan.toml:5:7: KVLCC2") && ContainsSubstring("has no parameter N_w"));
  CHECK_THAT(refusal(head + "draws = 10\n[vary]\nN_v = { relativ_sd = 0.1 }\n"), ContainsSubstring("relative_sd"));
  CHECK_THAT(refusal(head + "draws = 10\n[vary]\nN_v = { from = 1.0 }\n"), ContainsSubstring("needs from and to"));
  CHECK_THAT(refusal(head + "draws = 10\n[vary]\nN_v = { sd = 0.1, relative_sd = 0.1 }\n"),
             ContainsSubstring("takes one law"));
  CHECK_THAT(refusal(head + "draws = 10\n[vary]\nlength_m = { from = -5.0, to = 10.0 }\n"),
             ContainsSubstring("length_m of KVLCC2") && ContainsSubstring("cannot be -5 m"));
  CHECK_THAT(refusal(head + "design = \"grid\"\n[vary]\nN_v = { relative_sd = 0.1 }\n"),
             ContainsSubstring("a grid needs values"));
  CHECK_THAT(refusal(head + "pairs = 10\n"), ContainsSubstring("takes draws"));
  CHECK_THAT(refusal(head + "draws = 2.5\n"), ContainsSubstring("whole number"));
  CHECK_THAT(refusal("task = \"turn 35\"\nships = [\"tanker97\"]\ndraws = 3\nconfidence = true\n"),
             ContainsSubstring("linear ship"));
  CHECK_THAT(refusal("task = \"zigzag 10/10\"\nships = [\"kvlcc2\", \"mariner\"]\ndraws = 3\nconfidence = true\n"),
             ContainsSubstring("other parameters vary"));
}

}  // namespace
}  // namespace swayaw::app

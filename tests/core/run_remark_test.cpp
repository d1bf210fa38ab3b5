#include "swayaw/core/run_remark.hpp"

#include <catch.hpp>

namespace swayaw {
namespace {

Recording with_key(std::string key, std::string value) {
  Recording run;
  run.facts.remarks.push_back({std::move(key), std::move(value)});
  return run;
}

}  // namespace

TEST_CASE("a run tells when it began, by the clock of the world", "[core][limit]") {
  CHECK(start_utc(with_key("start_utc", "\"1970-01-02T00:00:30Z\"")) == 86430.0);
  CHECK(start_utc(with_key("start_utc", "'2026-03-04T09:30:00Z'")) == 1772616600.0);
  CHECK(!start_utc(with_key("start_utc", "\"9 o'clock\"")));
  CHECK(!start_utc(with_key("start_utc", "\"09:30:00\"")));
  CHECK(!start_utc(with_key("group", "\"2026-03-04\"")));
  CHECK(!start_utc(Recording{}));
}

TEST_CASE("a remark loses its quotes and nothing else", "[core][limit]") {
  CHECK(remark_of(with_key("vessel", "\"Athena \\\"II\\\"\""), "vessel") == "Athena \\\"II\\\"");
  CHECK(remark_of(with_key("vessel", "12"), "vessel") == "12");
  CHECK(remark_of(with_key("vessel", "\""), "vessel") == "\"");
  CHECK(remark_of(Recording{}, "vessel").empty());
}

}  // namespace swayaw

#include "swayaw/core/run_remark.hpp"

#include <algorithm>

#include "import/nmea_sentence.hpp"

namespace swayaw::inline core {

std::string remark_of(const Recording& run, std::string_view key) {
  const auto found = std::ranges::find(run.facts.remarks, key, &RunRemark::key);
  if (found == run.facts.remarks.end()) return "";
  auto text = found->value;
  if (text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\''))
    text = text.substr(1, text.size() - 2);
  return text;
}

std::optional<double> start_utc(const Recording& run) {
  const auto stamp = detail::time_stamp_in(remark_of(run, "start_utc"));
  if (!stamp || stamp->kind != detail::TimeStamp::Kind::instant) return std::nullopt;
  return stamp->seconds;
}

}  // namespace swayaw::core

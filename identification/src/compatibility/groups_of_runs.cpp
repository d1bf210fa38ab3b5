#include <algorithm>

#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification {
namespace {

/// The text of a run key, without the quotes of TOML; empty if the run has none.
std::string text_of(const Recording& run, std::string_view key) {
  const auto found = std::ranges::find(run.facts.remarks, key, &RunRemark::key);
  if (found == run.facts.remarks.end()) return "";
  auto text = found->value;
  if (text.size() >= 2 && text.front() == text.back() && (text.front() == '"' || text.front() == '\''))
    text = text.substr(1, text.size() - 2);
  return text;
}

}  // namespace

std::string group_of(const Recording& run) {
  constexpr std::size_t day = 10;  // characters of 2022-10-27T09:30:00Z
  const auto group = text_of(run, "group");
  return group.empty() ? text_of(run, "start_utc").substr(0, day) : group;
}

std::vector<GroupCheck> grouped(std::span<const RunCheck> runs) {
  std::vector<GroupCheck> groups;
  for (const auto& run : runs)
    if (std::ranges::find(groups, run.group, &GroupCheck::group) == groups.end()) groups.push_back({run.group, {}, {}});
  for (auto& group : groups) {
    std::vector<RunCheck> members;
    std::ranges::copy_if(runs, std::back_inserter(members), [&](const RunCheck& r) { return r.group == group.group; });
    for (const auto& member : members) group.runs.push_back(member.run);
    group.errors = pooled(members);
  }
  return groups;
}

}  // namespace swayaw::identification

#include <algorithm>

#include "swayaw/core/run_remark.hpp"
#include "swayaw/identification/data_compatibility.hpp"

namespace swayaw::inline identification {

std::string group_of(const Recording& run) {
  constexpr std::size_t day = 10;  // characters of 2022-10-27T09:30:00Z
  const auto group = remark_of(run, "group");
  return group.empty() ? remark_of(run, "start_utc").substr(0, day) : group;
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

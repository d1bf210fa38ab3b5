#include "swayaw/app/sweep/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <system_error>

#include "swayaw/core/angle.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/detail/spelling.hpp"
#include "swayaw/core/detail/toml_text.hpp"

namespace swayaw::app {
namespace {

/// Largest counts that are taken for meant.
constexpr double most_points = 1e9, most_overshoots = 16;

/// Also where the name is longer than any file's, or the way to it is closed.
bool is_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

bool is_folder(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_directory(file, ignored);
}

/// A number at the front of a text, which is taken off.
std::optional<double> number_at_front(std::string_view& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

class PlanText : core::detail::TomlText {
 public:
  PlanText(const toml::table& root, const std::filesystem::path& file) : TomlText(root, file), file_(file) {}

  SweepPlan read(const std::string& text_of_file) const {
    if (const auto* task = root().get("task"))
      if (const auto found = std::ranges::find(tasks_of_recordings, text(*task, "task"), &NamedTask::name);
          found != tasks_of_recordings.end())
        return read_of_recordings(text_of_file, found->task);
    require_known(root(),
                  std::array<std::string_view, 12>{"task", "first", "overshoots", "tolerance", "speed_m_s", "ships",
                                                   "design", "draws", "pairs", "seed", "confidence", "vary"},
                  "a plan");
    SweepPlan plan{.file = file_, .text = text_of_file, .task = SweepTask::zigzag, .ships = {}};
    read_task(plan);
    read_ships(plan);
    read_design(plan);
    if (const auto* node = root().get("confidence")) plan.confidence = flag(*node, "confidence");
    if (const auto* node = root().get("vary")) read_variations(plan, *node);
    for (const auto& v : plan.variations)
      if (plan.design == SweepDesign::grid && v.steps == 0 && v.values.empty())
        throw FileError(v.place, fmt::format("{}: a grid needs values = [...], or from, to and steps", v.name));
    if (plan.design == SweepDesign::grid && plan.confidence)
      fail(*root().get("confidence"), "a grid has no draws; confidence goes with design = \"draws\" or \"sobol\"");
    if (plan.variations.empty() && !plan.confidence && plan.ships.size() == 1)
      fail(root(), "nothing varies: give [vary], confidence = true, or several ships");
    if (plan.variations.empty() && !plan.confidence && root().contains("draws"))
      fail(*root().get("draws"), "draws without [vary] or confidence = true would all be the same");
    return plan;
  }

 private:
  void require_known(const toml::table& table, std::span<const std::string_view> known, std::string_view where) const {
    for (auto&& [key, value] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        fail(key.source().begin,
             fmt::format("{} is not known in {}{}", key.str(), where, core::detail::did_you_mean(key.str(), known)));
  }

  bool flag(const toml::node& node, std::string_view name) const {
    if (const auto value = node.value_exact<bool>()) return *value;
    fail(node, fmt::format("{} must be true or false", name));
  }

  std::size_t count(const toml::node& node, std::string_view name, double most) const {
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 1 || static_cast<double>(*value) > most)
      fail(node, fmt::format("{} must be a whole number from 1 to {:g}", name, most));
    return static_cast<std::size_t>(*value);
  }

  static std::string tasks() {
    return "\"zigzag 10/10\", \"turn 35\", \"indices\", \"trial\", \"identify\" or \"diagnose\"";
  }

  // ---------------------------------------------------------------- recordings

  struct NamedTask {
    std::string_view name;
    SweepTask task;
  };
  static constexpr std::array<NamedTask, 3> tasks_of_recordings{
      {{"trial", SweepTask::trial}, {"identify", SweepTask::identify}, {"diagnose", SweepTask::diagnose}}};

  /// What is to be found of every case.
  void read_identification(SweepPlan& plan) const {
    constexpr std::array<std::string_view, 3> models{"mmg", "pi", "pu"};
    const auto* model = root().get("model");
    plan.model = model ? text(*model, "model") : "";
    if (std::ranges::count(models, plan.model) == 0)
      fail(model ? *model : static_cast<const toml::node&>(root()), "model must be \"mmg\", \"pi\" or \"pu\"");
    const auto* find = root().get("find");
    const auto* list = find ? find->as_array() : nullptr;
    if (!list || list->empty())
      fail(find ? *find : static_cast<const toml::node&>(root()),
           "find must be a list of coefficients, [\"N_v\", \"N_r\"]");
    for (const auto& element : *list) plan.find.push_back(text(element, "a coefficient"));
    if (const auto* node = root().get("prior")) plan.prior = flag(*node, "prior");
  }

  SweepPlan read_of_recordings(const std::string& text_of_file, SweepTask task) const {
    const bool trial = task == SweepTask::trial;
    const auto* key = trial ? "runs" : "cases";
    std::vector<std::string_view> known{"task", key, "ship"};
    if (task == SweepTask::identify) known.insert(known.end(), {"model", "find", "prior"});
    require_known(root(), known, "a plan of recordings");
    SweepPlan plan{.file = file_, .text = text_of_file, .task = task, .ships = {}};
    if (task == SweepTask::identify) read_identification(plan);
    const auto* list = root().get(key);
    if (!list || !list->is_array() || list->as_array()->empty())
      fail(root(), trial ? "runs is missing: a list of recordings, \"trials/*.csv\""
                         : "cases is missing: a list of folders, \"cases/*\"");
    std::string ship;
    if (const auto* node = root().get("ship")) ship = beside(text(*node, "ship"));
    for (const auto& element : *list->as_array())
      for (const auto& found : matches(element, text(element, key)))
        plan.cases.push_back(trial ? SweepCase{found.filename().string(), ship, {found.string()}, {}, {}}
                                   : case_in(element, found, ship));
    return plan;
  }

  /// A file of the plan as seen from the working folder; where none is there, the name of a published ship.
  std::string beside(const std::filesystem::path& name) const {
    const auto file = file_.parent_path() / name;
    return is_there(file) ? file.string() : name.string();
  }

  /// Files or folders of that name, whose last part may have one *, in the order of their names.
  std::vector<std::filesystem::path> matches(const toml::node& node, const std::string& pattern) const {
    const auto whole = file_.parent_path() / pattern;
    const auto last = whole.filename().string();
    const auto star = last.find('*');
    std::vector<std::filesystem::path> found;
    if (star == std::string::npos) {
      if (is_there(whole)) found.push_back(whole);
    } else if (is_folder(whole.parent_path())) {
      const auto begin = last.substr(0, star), end = last.substr(star + 1);
      std::error_code readable;
      for (const auto& entry : std::filesystem::directory_iterator(whole.parent_path(), readable)) {
        const auto name = entry.path().filename().string();
        if (name.size() >= begin.size() + end.size() && name.starts_with(begin) && name.ends_with(end))
          found.push_back(entry.path());
      }
      std::ranges::sort(found);
    }
    if (found.empty()) fail(node, fmt::format("\"{}\": there is no such file or folder", pattern));
    return found;
  }

  /// Recordings of a folder; none where it is not there.
  static std::vector<std::string> recordings_in(const std::filesystem::path& folder) {
    std::vector<std::string> runs;
    if (!is_folder(folder)) return runs;
    std::error_code readable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, readable))
      if (entry.path().extension() == ".csv") runs.push_back(entry.path().string());
    std::ranges::sort(runs);
    return runs;
  }

  /// @param ship  of all cases; empty: ship.toml of the folder
  SweepCase case_in(const toml::node& node, const std::filesystem::path& folder, const std::string& ship) const {
    SweepCase found{.name = folder.filename().string(),
                    .ship = ship.empty() ? (folder / "ship.toml").string() : ship,
                    .runs = recordings_in(folder / "train"),
                    .reference = recordings_in(folder / "reference"),
                    .holdout = recordings_in(folder / "holdout")};
    if (ship.empty() && !is_there(found.ship))
      fail(node, fmt::format("{}: there is no ship.toml, and the plan has no ship", folder.string()));
    if (found.runs.empty()) fail(node, fmt::format("{}: there is no recording in train/", folder.string()));
    return found;
  }

  // ---------------------------------------------------------------- ships

  void read_task(SweepPlan& plan) const {
    const auto* node = root().get("task");
    if (!node) fail(root(), "task is missing: " + tasks());
    const std::string whole = text(*node, "task");
    std::string_view rest = whole;
    const auto take = [&](std::string_view word) {
      if (!rest.starts_with(word)) return false;
      rest.remove_prefix(word.size());
      return true;
    };
    const auto angle = [&] {
      const auto degree = number_at_front(rest);
      if (!degree || !(*degree > 0.0) || *degree > 90.0)
        fail(*node, fmt::format("\"{}\": angles are in degrees from 0 to 90, as in \"zigzag 20/10\"", whole));
      return radians(*degree);
    };
    if (take("zigzag ")) {
      plan.task = SweepTask::zigzag;
      plan.rudder = angle();
      if (!take("/")) fail(*node, fmt::format("\"{}\": write rudder and heading as in \"zigzag 20/10\"", whole));
      plan.heading = angle();
    } else if (take("turn ")) {
      plan.task = SweepTask::turn;
      plan.rudder = angle();
    } else if (take("indices")) {
      plan.task = SweepTask::indices;
    } else {
      fail(*node, fmt::format("\"{}\" is no task: {}", whole, tasks()));
    }
    if (!rest.empty()) fail(*node, fmt::format("\"{}\": \"{}\" is too much", whole, rest));
    if (const auto* first = root().get("first")) {
      const auto word = text(*first, "first");
      if (word != "port" && word != "starboard") fail(*first, "first must be \"port\" or \"starboard\"");
      plan.first = word == "port" ? Side::port : Side::starboard;
    }
    if (const auto* n = root().get("overshoots")) plan.overshoots = count(*n, "overshoots", most_overshoots);
    if (const auto* n = root().get("tolerance"))
      plan.tolerance = number(*n, "tolerance", Range{.low = 1e-12, .high = 1e-2});
    if (const auto* n = root().get("speed_m_s")) plan.speed = number(*n, "speed_m_s", positive);
  }

  void read_ships(SweepPlan& plan) const {
    const auto* node = root().get("ships");
    if (!node) fail(root(), "ships is missing: a list of ship files, or of names of published ships");
    const auto* list = node->as_array();
    if (!list || list->empty()) fail(*node, "ships must be a list of texts in quotes");
    for (const auto& element : *list) {
      plan.ships.push_back(beside(text(element, "a ship")));
    }
    plan.ships_place = place(*node);
  }

  void read_design(SweepPlan& plan) const {
    constexpr std::array<std::string_view, 3> names{"grid", "draws", "sobol"};
    if (const auto* node = root().get("design")) {
      const auto word = text(*node, "design");
      const auto found = std::ranges::find(names, word);
      if (found == names.end()) fail(*node, "design must be \"draws\", \"grid\" or \"sobol\"");
      plan.design = static_cast<SweepDesign>(found - names.begin());
    }
    const std::string_view key = plan.design == SweepDesign::sobol ? "pairs" : "draws";
    for (const std::string_view other : {"draws", "pairs"}) {
      const auto* node = root().get(other);
      if (!node) continue;
      if (plan.design == SweepDesign::grid) fail(*node, fmt::format("a grid has no {}", other));
      if (other != key) fail(*node, fmt::format("design = \"{}\" takes {}", names[static_cast<int>(plan.design)], key));
      plan.size = count(*node, key, most_points);
    }
    const bool varies = root().contains("vary") || root().contains("confidence");
    if (varies && plan.design != SweepDesign::grid && !root().contains(key))
      fail(root(), fmt::format("{} is missing: how many {} there are for each ship", key, key));
    if (const auto* node = root().get("seed")) {
      const auto value = node->value_exact<std::int64_t>();
      if (!value || *value < 0) fail(*node, "seed must be a whole number, not negative");
      plan.seed = static_cast<std::uint64_t>(*value);
    }
  }

  FilePlace place(const toml::node& node) const {
    return {file_, node.source().begin.line, node.source().begin.column};
  }

  /// Tables within [vary] are those of the ship file: [vary.rudder] and "rudder.area_m2" are the same.
  void read_variations(SweepPlan& plan, const toml::node& node, const std::string& prefix = {}) const {
    constexpr std::array<std::string_view, 6> laws{"relative_sd", "sd", "from", "to", "steps", "values"};
    const auto* table = node.as_table();
    if (!table) fail(node, "[vary] is a table: N_v = { relative_sd = 0.1 }");
    for (auto&& [key, value] : *table) {
      const auto name = prefix + std::string(key.str());
      const auto* law = value.as_table();
      if (!law || law->empty()) fail(value, fmt::format("{} must be a law: {{ relative_sd = 0.1 }}", name));
      const bool is_law = std::ranges::any_of(
          *law, [&](const auto& entry) { return std::ranges::find(laws, entry.first.str()) != laws.end(); });
      if (!is_law && law->begin()->second.is_table()) {
        read_variations(plan, value, name + ".");
        continue;
      }
      require_known(*law, laws, fmt::format("the law of {}", name));
      plan.variations.push_back(variation(name, *law));
    }
  }

  Variation variation(const std::string& name, const toml::table& law) const {
    Variation v{.name = name, .place = place(law)};
    const auto read = [&](std::string_view key, const Range& range = any_number) {
      const auto* node = law.get(key);
      return node ? std::optional(number(*node, fmt::format("{} of {}", key, name), range)) : std::nullopt;
    };
    v.relative_sd = read("relative_sd", positive);
    v.sd = read("sd", positive);
    v.from = read("from");
    v.to = read("to");
    if (const auto* node = law.get("steps")) v.steps = count(*node, fmt::format("steps of {}", name), most_points);
    if (const auto* node = law.get("values")) {
      const auto* list = node->as_array();
      if (!list || list->empty()) fail(*node, fmt::format("values of {} must be a list of numbers", name));
      for (const auto& element : *list) v.values.push_back(number(element, fmt::format("a value of {}", name)));
    }
    const bool range = v.from || v.to;
    if (v.from.has_value() != v.to.has_value()) fail(law, fmt::format("{} needs from and to", name));
    if (range && !(*v.from < *v.to)) fail(law, fmt::format("from of {} must be below to", name));
    if (v.steps > 0 && !range) fail(law, fmt::format("steps of {} go with from and to", name));
    if (v.relative_sd.has_value() + v.sd.has_value() + range + !v.values.empty() != 1)
      fail(law, fmt::format("{} takes one law: relative_sd, sd, from and to, or values", name));
    return v;
  }

  const std::filesystem::path& file_;
};

}  // namespace

SweepPlan parse_sweep_plan(const std::string& text, const std::filesystem::path& name) {
  const auto root = core::detail::parsed_toml(text, name);
  return PlanText(root, name).read(text);
}

SweepPlan read_sweep_plan(const std::filesystem::path& file) {
  return parse_sweep_plan(read_text(file, FileUse::description), file);
}

}  // namespace swayaw::app

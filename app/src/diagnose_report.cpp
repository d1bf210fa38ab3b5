#include "diagnose_report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "diagnose_page.hpp"
#include "page_writing.hpp"
#include "swayaw/app/report.hpp"
#include "swayaw/core/atomic_file.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/quantity.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- series of a run

Json channels_json(const std::optional<Recording>& run) {
  Json series = Json::object();
  if (!run) return series;
  for (const auto channel : {Channel::x, Channel::y, Channel::psi, Channel::u, Channel::v, Channel::r, Channel::delta})
    if (run->has(channel)) series[std::string(column_name(channel))] = parameters((*run)[channel]);
  if (!run->has(Channel::u) && run->has(Channel::speed_through_water))
    series["u_m_s"] = parameters((*run)[Channel::speed_through_water]);
  return series;
}

/// A number of every sample.
template <class Get>
Json list_json(const std::vector<MissingForce>& samples, Get&& get) {
  Json list = Json::array();
  for (const auto& sample : samples) list.push_back(number(get(sample)));
  return list;
}

Json force_json(const std::vector<MissingForce>& samples) {
  if (samples.empty()) return nullptr;
  return {{"X_N", list_json(samples, [](const MissingForce& f) { return f.force.X; })},
          {"Y_N", list_json(samples, [](const MissingForce& f) { return f.force.Y; })},
          {"N_Nm", list_json(samples, [](const MissingForce& f) { return f.force.N; })},
          {"X_deviation_N", list_json(samples, [](const MissingForce& f) { return f.force_deviation.X; })},
          {"Y_deviation_N", list_json(samples, [](const MissingForce& f) { return f.force_deviation.Y; })},
          {"N_deviation_Nm", list_json(samples, [](const MissingForce& f) { return f.force_deviation.N; })}};
}

/// Drift angle and r' = r L/U of the estimated motion: most runs do not tell the sway velocity.
Json motion_json(const std::vector<MissingForce>& samples, double L) {
  if (samples.empty()) return nullptr;
  return {{"drift_rad", list_json(samples, [](const MissingForce& f) { return drift_angle(f.motion); })},
          {"r_prime", list_json(samples, [L](const MissingForce& f) { return f.motion.r * L / speed(f.motion); })}};
}

Json picture_json(const RunPicture& p, double L, bool held_out, bool with_effects) {
  const auto& run = p.recorded;
  const auto& manoeuvre = run.facts.manoeuvre;
  Json series{{"time_s", parameters(run.time)},
              {"recorded", channels_json(run)},
              {"given", channels_json(p.given)},
              {"refitted", channels_json(p.refitted)},
              {"motion", motion_json(p.missing_before, L)},
              {"missing_before", force_json(p.missing_before)}};
  if (with_effects) {
    series["after"] = channels_json(p.after);
    series["missing_after"] = force_json(p.missing_after);
  }
  return {{"run", p.run},
          {"manoeuvre", manoeuvre.empty() ? Json(nullptr) : Json(manoeuvre)},
          {"held_out", held_out},
          {"series", std::move(series)}};
}

Json pictures_json(const Ship& ship, const Diagnosis& d) {
  Json runs = Json::array();
  for (const auto& p : d.train_pictures) runs.push_back(picture_json(p, length(ship), false, !d.effects.empty()));
  for (const auto& p : d.holdout_pictures) runs.push_back(picture_json(p, length(ship), true, !d.effects.empty()));
  return runs;
}

Json ordinary_json(const Ship& ship) {
  const auto force = ordinary_force(ship);
  return {{"X_N", number(force.X)}, {"Y_N", number(force.Y)}, {"N_Nm", number(force.N)}};
}

/// What the page calls the effects that were found, and the order of their parameters: its objects are sorted by key.
void put_words(Json& effects, const std::vector<FoundEffect>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    effects[i]["label"] = label_of(found[i].effect);
    effects[i]["keys"] = Json::array();
    for (const auto& p : found[i].parameters) effects[i]["keys"].push_back(p.key);
  }
}

/// What the page calls each effect.
Json effect_names() {
  Json names = Json::object();
  for (const auto id : effect_ids()) names[std::string(id)] = text_of(make_effect(id)).label;
  return names;
}

}  // namespace

void require_folder(const std::filesystem::path& page) {
  std::error_code ignored;
  const auto folder = page.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
    throw FileError({.file = page}, "cannot be written (there is no such folder)");
}

void write_diagnosis_report(const Json& document, const Ship& ship, const Diagnosis& diagnosis, double needed_gain,
                            const DiagnoseArguments& asked) {
  Json data = only(document, {"version", "verdict", "location", "effects", "candidates", "budget", "surroundings",
                              "fit", "next_manoeuvre", "detectable"});
  data["length_m"] = length(ship);
  data["needed_gain"] = needed_gain;
  data["ordinary_force"] = ordinary_json(diagnosis.refitted);
  data["effect_names"] = effect_names();
  put_words(data["effects"], diagnosis.effects);
  data["runs"] = pictures_json(ship, diagnosis);
  write_page(asked.report.file, diagnosis_page(diagnosis_first_screen(ship, diagnosis, asked), for_page(data)));
}

}  // namespace swayaw::app

#include "module.hpp"
#include "record.hpp"
#include "swayaw/mismatch/diagnose.hpp"

namespace swayaw::python {
namespace {

/// A number for each of what a force may follow, by name.
py::dict by_cause(const std::array<double, follows_count>& numbers) {
  py::dict result;
  for (std::size_t i = 0; i < follows_count; ++i) result[py::str(name_of(static_cast<Follows>(i)))] = numbers[i];
  return result;
}

}  // namespace

void add_budget(py::module_& m) {
  Record<ForceBudget>(m, "ForceBudget", "The force that the given ship lacks, split by what it follows.")
      .field<&ForceBudget::quantity>("quantity", "surge_force, sway_force or yaw_moment.")
      .field<&ForceBudget::share>("share", "Of its mean square; they add up to 1. `shares` has the names.")
      .field<&ForceBudget::standard_error>("standard_error", "In the same order.")
      .field<&ForceBudget::size>("size", "Its mean square over that of the force on the ship's own hull.")
      .of()
      .def_property_readonly(
          "shares", [](const ForceBudget& b) { return by_cause(b.share); },
          "By form, form_asymmetric, earth_fixed, delayed, instruments, unexplained.")
      .def_property_readonly("standard_errors", [](const ForceBudget& b) { return by_cause(b.standard_error); });
  Record<ZigzagView>(m, "ZigzagView", "A zigzag by Nomoto's first-order equation and its drift–yaw loop.")
      .field<&ZigzagView::K>("K", "K L/U, rudder positive to port.")
      .field<&ZigzagView::T>("T", "T U/L.")
      .field<&ZigzagView::delta_r>("delta_r", "Rudder offset beside the recorded angle [rad].")
      .field<&ZigzagView::loop_area>("loop_area", "∮ beta d(r') over one period; NaN without sway velocity.");
  Record<LinearView>(m, "LinearView", "A recorded zigzag and the refitted ship's, by K, T and the loop.")
      .field<&LinearView::run>("run", "Its name.")
      .field<&LinearView::amplitude>("amplitude", "Largest rudder angle [rad].")
      .field<&LinearView::recorded>("recorded", "")
      .field<&LinearView::model>("model", "");
  m.def(
      "linear_view", [](const Ship& model, const std::vector<Recording>& runs) { return linear_view(model, runs); },
      py::arg("model"), py::arg("runs"), Unlocked(),
      "Each zigzag among runs beside a ship's replay of it, by K, T and the drift-yaw loop.\n\nmodel: who replays. "
      "runs: those that are no zigzags, or that she cannot sail, are left out.");
  m.def(
      "linear_words", [](const std::vector<LinearView>& views) { return words_of(views); }, py::arg("views"),
      "What follows from zigzags: offset, gain, history, in words; empty where recordings and model agree within a "
      "tenth.\n\nviews: of `linear_view`.");
}

}  // namespace swayaw::python

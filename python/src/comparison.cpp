#include "module.hpp"
#include "record.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/mismatch/run_picture.hpp"

namespace swayaw::python {

template <>
struct Words<Quantity> : NamedWords<Quantity, all_quantities.size(), name_of> {};
template <>
struct Words<Variable> : NamedWords<Variable, 3, name_of> {};

namespace {

void add_errors(py::module_& m) {
  Record<WorstInterval>(m, "WorstInterval", "Part of a run that holds most of the error above the run's mean.")
      .field<&WorstInterval::from>("begin", "[s]")
      .field<&WorstInterval::to>("end", "[s]")
      .field<&WorstInterval::share>("share", "Of all squared errors.")
      .field<&WorstInterval::rms>("rms", "SI.");
  Record<RegionError>(m, "RegionError", "Errors while one variable lay between two bounds.")
      .field<&RegionError::variable>("variable", "drift, yaw rate or rudder.")
      .field<&RegionError::from>("low", "[rad], yaw rate rL/U; None for an open bound.")
      .field<&RegionError::to>("high", "Likewise.")
      .field<&RegionError::samples>("samples", "In it.")
      .field<&RegionError::rms>("rms", "SI.")
      .field<&RegionError::bias>("bias", "Mean, simulated minus recorded.")
      .field<&RegionError::share>("share", "Of all squared errors.")
      .of()
      .def_property_readonly("words", &words_for, "\"rudder 15 to 25 deg to port\"");
  Record<QuantityError>(m, "QuantityError", "Simulated minus recorded, in the SI unit of the quantity.")
      .field<&QuantityError::quantity>("quantity", "heading, yaw_rate, speed, drift or position.")
      .field<&QuantityError::variation>("variation", "Root-mean-square variation of the recorded quantity.")
      .field<&QuantityError::noise>("noise", "Scatter of the samples about local parabolas.")
      .field<&QuantityError::waves>("waves", "What waves add to the recorded quantity, root mean square.")
      .field<&QuantityError::window_rms>("window_rms", "Restarted every window.")
      .field<&QuantityError::bias>("bias", "Mean error, restarted every window.")
      .field<&QuantityError::open_loop_rms>("open_loop_rms", "Never restarted.")
      .field<&QuantityError::worst>("worst", "Where most of it is.")
      .field<&QuantityError::regions>("regions", "By drift, yaw rate and rudder.")
      .field<&QuantityError::region>("region", "The worst of them.")
      .of()
      .def_property_readonly("beyond_noise", &QuantityError::beyond_noise, "sqrt(max(0, window_rms² - noise²)).")
      .def_property_readonly("normalised_beyond_waves", &QuantityError::normalised_beyond_waves,
                             "sqrt(max(0, window_rms² - waves²)) over variation.")
      .def_property_readonly("is_in_waves", &QuantityError::is_in_waves,
                             "Whether waves add as much to the recording as the window error is.")
      .def_property_readonly("normalised", &QuantityError::normalised, "window_rms over variation.")
      .def_property_readonly("open_loop_normalised", &QuantityError::open_loop_normalised);
  Record<Conditions>(m, "Conditions", "Motion and rudder of every sample.")
      .field<&Conditions::drift>("drift", "beta [rad].")
      .field<&Conditions::yaw_rate>("yaw_rate", "rL/U.")
      .field<&Conditions::rudder>("rudder", "Positive to port [rad].");
  Record<Comparison>(m, "Comparison", "One run beside its simulations, which share its times.")
      .field<&Comparison::recorded>("recorded", "The run.")
      .field<&Comparison::open_loop>("open_loop", "Simulated from its start to its end.")
      .field<&Comparison::restarted>("restarted", "Simulated window after window.")
      .field<&Comparison::window_starts>("window_starts", "First sample of each window.")
      .field<&Comparison::conditions>("conditions", "Motion and rudder.")
      .field<&Comparison::errors>("errors", "Of every quantity that the run tells.")
      .of()
      .def("__getitem__", [](py::handle self, const Quantity quantity) -> py::object {
        for (auto& e : self.cast<Comparison&>().errors)
          if (e.quantity == quantity) return py::cast(&e, py::return_value_policy::reference_internal, self);
        throw py::key_error(fmt::format("the run does not tell {}", name_of(quantity)));
      });
}

void add_pictures(py::module_& m) {
  Record<MissingForce>(m, "MissingForce", "What drives a ship beyond her model at a time, given the whole run.")
      .field<&MissingForce::motion>("motion", "Through the water, as estimated along with it.")
      .field<&MissingForce::acceleration>("acceleration", "[m/s², m/s², rad/s²]")
      .field<&MissingForce::acceleration_deviation>("acceleration_deviation", "Standard deviation.")
      .field<&MissingForce::force>("force", "That accelerates ship and entrained water so [N, N, N m].")
      .field<&MissingForce::force_deviation>("force_deviation", "Standard deviation.");
  Record<RunPicture>(m, "RunPicture", "A run as people look at it: at most 500 points.")
      .field<&RunPicture::run>("run", "Its name.")
      .field<&RunPicture::recorded>("recorded", "The run.")
      .field<&RunPicture::missing_before>("missing_before", "Force that the refitted ship lacks.")
      .field<&RunPicture::missing_after>("missing_after", "Force that the ship with the effects lacks.")
      .field<&RunPicture::given>("given", "Replay by the ship as given.")
      .field<&RunPicture::refitted>("refitted", "Replay by the refitted ship.")
      .field<&RunPicture::after>("after", "Replay with the effects.");
  m.def(
      "missing_force",
      [](const Ship& ship, const Recording& run, const Noise& noise) { return missing_force(ship, run, noise); },
      py::arg("ship"), py::arg("run"), py::arg("noise") = Noise{}, Unlocked(),
      "The force that drives a recorded ship beyond her model, by a Kalman filter and smoother that carry an "
      "acceleration with a memory of L/U: a list of MissingForce, one for each sample.\n\nship: the model. run: tells "
      "rudder and speed, else Refusal. noise: a Noise; its scale is the deviation of that acceleration over that of an "
      "adequate model.");
  m.def("ordinary_force", &ordinary_force, py::arg("ship"),
        "Standard deviation of the force that an adequate model leaves out [N, N, N m].\n\nship: of any nonlinear "
        "model.");
  m.def("run_picture", &run_picture, py::arg("given"), py::arg("refitted"), py::arg("after"), py::arg("run"),
        py::arg("noise") = Noise{}, Unlocked(),
        "A run beside replays and missing forces of three ships, at most 500 points.\n\ngiven: the ship as she was "
        "given. refitted: with other coefficients. after: with effects. run: as recorded. noise: one for all, so that "
        "what shrinks is the force and not the allowance for it.");
}

}  // namespace

void add_comparison(py::module_& m) {
  add_errors(m);
  add_pictures(m);
  m.def(
      "compare",
      [](const Ship& ship, const Recording& run, double window_lengths) {
        return compare(ship, run, {.window_lengths = window_lengths, .replay = {}});
      },
      py::arg("ship"), py::arg("run"), py::kw_only(), py::arg("window_lengths") = CompareOptions{}.window_lengths,
      Unlocked(),
      "Where a simulation and a recording differ: the recorded rudder and shaft speed drive the ship from the recorded "
      "state, anew every two ship lengths of way, and once more from the start of the run to its end. Raises Refusal "
      "if "
      "the run does not tell rudder or speed."
      "\n\nship, run: that are compared. window_lengths: of a window, in ship lengths of way.");
  m.def(
      "compare_verdict", [](const std::vector<Comparison>& comparisons) { return verdict(comparisons); },
      py::arg("comparisons"),
      "One sentence: in which quantity, run, interval and region the ship is farthest off."
      "\n\ncomparisons: of `compare`, one for each run.");
  m.def(
      "pooled_errors", [](const std::vector<Comparison>& comparisons) { return pooled(comparisons); },
      py::arg("comparisons"),
      "Errors of each quantity in all runs together."
      "\n\ncomparisons: of `compare`, one for each run. The result has a QuantityError for each quantity.");
}

}  // namespace swayaw::python

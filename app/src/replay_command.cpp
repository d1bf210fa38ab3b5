#include "swayaw/nonlinear/replay.hpp"

#include "commands.hpp"
#include "input.hpp"
#include "json.hpp"
#include "recorded_inputs.hpp"
#include "swayaw/nonlinear/models/force_breakdown.hpp"
#include "swayaw/nonlinear/ship_file.hpp"
#include "terminal.hpp"

namespace swayaw::app {

void replay(const ReplayArguments& a) {
  const Ship ship = parse_ship(ship_text(a.ship), a.ship);
  const Recording run = without(load_run(a.run, a.rudder_positive), a.ignored);
  tell_in_vain(ship, {&run, 1});
  const Shaft shaft = shaft_named(a.shaft);
  if (shaft == Shaft::recorded) tell_propulsion(ship, {&run, 1});
  Recording simulated = swayaw::replay(ship, run, {.shaft = shaft});
  if (a.forces) add_forces(simulated, ship);
  write_recording(simulated, a.out);
  const double begin = run.time.front(), end = run.time.back();
  if (a.json) {
    const Json document{{"schema", "swayaw.replay/1"}, {"run", run.name}, {"out", a.out.string()},
                        {"samples", run.samples()},    {"from_s", begin}, {"to_s", end}};
    print_document(document);
    return;
  }
  say("{}: {} samples from {:.6g} to {:.6g} s written to {}\n", run.name, run.samples(), begin, end, a.out.string());
}

}  // namespace swayaw::app

#include "taped_ship.hpp"

#include "swayaw/nonlinear/simulation/equations_of_motion.hpp"

namespace swayaw::inline identification::detail {
namespace {

/// The parts of a ship that act in her equations of motion, with a scalar of their own.
template <class Model, class S = typename Model::Scalar>
struct Acting {
  Model model;
  Surroundings<S> around;
  ActingEffects<S> added;
  std::vector<Wind<S>> winds;  ///< the first, and from each change on
};

/// In the order in which they are numbered.
template <class S, class Model>
auto cast_all(const Acting<Model>& from) {
  auto model = cast<S>(from.model);
  auto around = cast<S>(from.around);
  auto added = cast<S>(from.added);
  std::vector<Wind<S>> winds;
  for (const auto& wind : from.winds) winds.push_back({S(wind.speed), S(wind.from)});
  return Acting<decltype(model)>{std::move(model), std::move(around), std::move(added), std::move(winds)};
}

template <class Model>
Acting<Model> parts_of(const ActingShip<Model>& ship) {
  std::vector winds{ship.surroundings.wind};
  for (const auto& change : ship.changes) winds.push_back(change.wind);
  return {ship.model, ship.surroundings, ship.added, std::move(winds)};
}

template <class Model>
class TapedModel final : public TapedShip {
 public:
  /// @param variables  how many there are
  TapedModel(const ActingShip<Model>& ship, const std::vector<Tape::Place>& places, Tape::Place variables)
      : ship_(parts_of(ship)),
        taped_([&] {
          const Numbering numbering(places);
          return cast_all<Taped>(cast_all<Numbered>(ship_));
        }()),
        before_{.time = 0.0, .wind = ship_.around.wind, .windy = ship_.around.windy, .acting = ship_.added.acting},
        changes_(ship.changes),
        variables_(variables) {}

  void at(const ShipState<double>& state, const Hidden<double>& hidden, const Controls<double>& controls,
          Slopes& slopes) override {
    using V = TapedVariables;
    begin();
    const auto& m = state.motion;
    const ShipState<Taped> s{Taped(state.x), Taped(state.y), {state.psi, V::psi + 1}, as_variables(m)};
    const auto c = as_variables(controls);
    const auto branch = branch_at(ship_.model, m, driven(ship_.added, m, controls));
    const auto f = rates_of(taped_.model, taped_.around, taped_.added, s, as_variables(hidden), c, branch);
    slopes.resize(6, variables_);
    take(slopes, {3, 4, 5}, {f[3].place, f[4].place, f[5].place, 0});
    take(slopes, {0, 1, 2}, {f[0].place, f[1].place, f[2].place, 0});
  }

  void of_hidden(const PlanarMotion<double>& motion, const Hidden<double>& hidden, double by_rudder,
                 HiddenSlopes& slopes) override {
    begin();
    take(slopes, hidden_rates(taped_.added, as_variables(motion), as_variables(hidden),
                              Taped{by_rudder, TapedVariables::by_rudder + 1}));
  }

  void of_rudder(const PlanarMotion<double>& motion, const Controls<double>& controls, RowSlopes& slopes) override {
    begin();
    const auto f = sway_by_rudder(taped_.model, taped_.added, as_variables(motion), as_variables(controls));
    const auto& by = tape_.slopes(std::array<Tape::Place, 4>{f.place, 0, 0, 0});
    slopes.resize(variables_);
    for (Eigen::Index i = 0; i < variables_; ++i) slopes[i] = by[static_cast<std::size_t>(i) + 1][0];
  }

  void of_steady_hidden(const PlanarMotion<double>& motion, const Controls<double>& controls,
                        HiddenSlopes& slopes) override {
    begin();
    const auto m = as_variables(motion);
    const bool follow = may_follow_rudder(taped_.added);
    const auto by_rudder = follow ? sway_by_rudder(taped_.model, taped_.added, m, as_variables(controls)) : Taped(0.0);
    take(slopes, steady_hidden(taped_.added, m, by_rudder));
  }

  void restart() override { apply(before_, 0); }
  void apply(std::size_t change) override { apply(changes_[change], change + 1); }

 private:
  void begin() {
    Tape::now = &tape_;
    tape_.restart(variables_);
  }

  static PlanarMotion<Taped> as_variables(const PlanarMotion<double>& m) {
    using V = TapedVariables;
    return {{m.u, V::u + 1}, {m.v, V::v + 1}, {m.r, V::r + 1}};
  }

  static Controls<Taped> as_variables(const Controls<double>& controls) {
    using V = TapedVariables;
    return {{controls.delta, V::delta + 1},
            {controls.rev, V::rev + 1},
            {{controls.thrust.port, V::port + 1}, {controls.thrust.starboard, V::starboard + 1}},
            controls.by_thrust};
  }

  static Hidden<Taped> as_variables(const Hidden<double>& hidden) {
    Hidden<Taped> variables;
    for (std::size_t i = 0; i < hidden_count; ++i)
      variables[i] = {hidden[i], TapedVariables::hidden + static_cast<Tape::Place>(i) + 1};
    return variables;
  }

  void apply(const Change& change, std::size_t wind) {
    change.apply(ship_.around, ship_.added);
    change.apply(ship_.around, taped_.added);
    taped_.around.wind = taped_.winds[wind], taped_.around.windy = change.windy;
  }

  void take(Slopes& slopes, const std::array<int, 3>& rows, const std::array<Tape::Place, 4>& of) {
    const auto& by = tape_.slopes(of);
    for (Eigen::Index i = 0; i < variables_; ++i)
      for (std::size_t k = 0; k < rows.size(); ++k) slopes(rows[k], i) = by[static_cast<std::size_t>(i) + 1][k];
  }

  void take(HiddenSlopes& slopes, const Hidden<Taped>& of) {
    slopes.resize(Eigen::NoChange, variables_);
    std::array<Tape::Place, hidden_count> places;
    std::ranges::transform(of, places.begin(), &Taped::place);
    const auto& by = tape_.slopes(places);
    for (Eigen::Index i = 0; i < variables_; ++i)
      slopes.col(i) = Eigen::Map<const Eigen::Vector<double, hidden_count>>(by[static_cast<std::size_t>(i) + 1].data());
  }

  Acting<Model> ship_;
  decltype(cast_all<Taped>(std::declval<Acting<Model>>())) taped_;
  Change before_;
  std::vector<Change> changes_;
  Tape tape_;
  Tape::Place variables_;
};

// clang++ 14 leaves out virtual functions of a template that is first named in a generic lambda
template class TapedModel<MmgShip<double>>;
template class TapedModel<PiShip<double>>;
template class TapedModel<PuShip<double>>;
template class TapedModel<AbkowitzShip<double>>;

}  // namespace

ShipNumbers numbers_of(const Ship& ship) {
  ShipNumbers numbers;
  numbers.structure.push_back(static_cast<double>(ship.model.index()));
  visit_acting(ship, [&](const auto& acting) {
    const Numbering numbering;
    cast_all<Numbered>(parts_of(acting));
    numbers.values = numbering.values();
    const auto& around = acting.surroundings;
    numbers.structure.insert(numbers.structure.end(),
                             {around.windy ? 1.0 : 0.0, static_cast<double>(acting.added.acting)});
    numbers.angles = {around.wind.from, around.current.to};
    for (const auto& change : acting.changes) {
      numbers.structure.insert(numbers.structure.end(),
                               {change.time, change.windy ? 1.0 : 0.0, static_cast<double>(change.acting)});
      numbers.angles.push_back(change.wind.from);
    }
  });
  return numbers;
}

std::unique_ptr<TapedShip> taped_ship(const Ship& ship, const std::vector<bool>& variable) {
  std::vector<Tape::Place> places;
  Tape::Place last = TapedVariables::count;
  for (const bool is : variable) places.push_back(is ? ++last : 0);
  return visit_acting(ship, [&]<class Model>(const ActingShip<Model>& acting) -> std::unique_ptr<TapedShip> {
    return std::make_unique<TapedModel<Model>>(acting, places, last);
  });
}

}  // namespace swayaw::identification::detail

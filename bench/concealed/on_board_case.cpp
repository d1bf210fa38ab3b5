#include "on_board_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "day.hpp"
#include "seaway.hpp"
#include "swayaw/core/angle.hpp"
#include "swayaw/core/refusal.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/nonlinear/effects/acting_ship.hpp"

namespace swayaw::concealed {
namespace {

using Json = nlohmann::ordered_json;
using Effects = std::vector<std::pair<std::string, Severity>>;

constexpr std::array quantities{Quantity::heading, Quantity::yaw_rate, Quantity::speed, Quantity::position};

constexpr double largest_level = 2.5;            ///< of what is hidden: winds of 2.5 U, a compass off by 4 deg
constexpr std::size_t tries_for_strong = 3;      ///< effects that are tried before a moderate one is taken instead
constexpr double error_of_sense = radians(8.0);  ///< in heading over two lengths: a file that is worse is not used

// ---------------------------------------------------------------- runs

Manoeuvre numbered(Manoeuvre m, std::size_t number, const char* name = nullptr) {
  m.name = fmt::format("{}_{}", number, name ? name : m.name);
  return m;
}

struct Programme {
  std::vector<Manoeuvre> train, holdout, reference;

  std::vector<Manoeuvre> all() const {
    auto runs = train;
    runs.insert(runs.end(), holdout.begin(), holdout.end());
    return runs;
  }
};

/// Three to eight runs of five kinds, on headings all round; the last one or two are held out.
Programme programme_by_chance(RandomSource& random) {
  const std::size_t runs = 3 + random.below(6), held_out = runs > 4 ? 2 : 1;
  const double first = random.uniform(0.0, 2.0 * pi);
  const bool port = random.below(2) == 0;
  const auto heading = [&](std::size_t i) { return wrapped(first + 2.4 * static_cast<double>(i)); };
  const std::array all{zigzag(10, 10, port, heading(0)),  turn(35, !port, heading(1)),
                       zigzag(20, 20, !port, heading(2)), passage(heading(3), radians(10.0)),
                       turn(35, port, heading(4)),        zigzag(15, 10, port, heading(5))};
  const std::array unseen{zigzag(20, 10, !port, heading(6)), turn(25, port, heading(7))};
  Programme p;
  for (std::size_t i = 0; i < runs - held_out; ++i) p.train.push_back(numbered(all[i], i + 1));
  for (std::size_t i = 0; i < held_out; ++i) p.holdout.push_back(numbered(unseen[i], runs - held_out + i + 1));
  if (random.below(2) == 0)
    p.reference = {numbered(zigzag(15, 15, !port, heading(8)), runs + 1),
                   numbered(turn(30, port, heading(9)), runs + 2),
                   numbered(zigzag(20, 15, port, heading(10)), runs + 3)};
  return p;
}

// what draws by a seed of its own: three parts of a case, and what is hidden in the place of what was planned
constexpr std::uint64_t train_part = 1, holdout_part = 2, reference_part = 3, in_its_place = 4;

/// How a run is wanted: as the ship brings it home; without losses of the fixes, so that replays can be begun anywhere;
/// or without any error but what is hidden.
enum class Wanted { as_on_board, without_losses, faultless };

/// Everything of a case but what is hidden.
struct Scene {
  TrueShip truth;
  Ship file;
  std::uint64_t board, weather, noise;  ///< seeds

  OnBoardInstruments instruments(const Concealment& hidden) const {
    RandomSource random(board);
    return instruments_by_chance(random, truth, hidden);
  }

  /// That of reference runs is of another day.
  Seaway seaway(std::uint64_t part) const {
    RandomSource random(seed_of(board, part == reference_part ? reference_part : train_part));
    return seaway_by_chance(random);
  }

  /// The same weather and the same noise whatever is hidden; instruments are those that go with what is hidden in `of`.
  std::vector<Recording> recorded(const Concealment& hidden, const Concealment& of, const Day& day,
                                  const std::vector<Manoeuvre>& runs, std::uint64_t part,
                                  Wanted wanted = Wanted::without_losses) const {
    auto board_now = wanted == Wanted::faultless ? faultless(instruments(of)) : instruments(of);
    if (wanted != Wanted::as_on_board) board_now.gaps = false;
    const std::size_t wild = runs.empty() ? 0 : seed_of(noise, part) % runs.size();
    std::vector<Recording> result;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      Manoeuvre longer = runs[i];
      longer.lengths += 0.8;  // filters look ahead
      auto track = true_track(
          truth, hidden, longer,
          {.turbulence = day.turbulence, .gust_memory = day.gust_memory, .seed = seed_of(weather, 100 * part + i)});
      if (wanted != Wanted::faultless) track = in_waves(std::move(track), seaway(part));
      RandomSource random(seed_of(noise, 100 * part + i));
      result.push_back(recorded_on_board(truth, hidden, runs[i], board_now, track, random,
                                         wanted == Wanted::as_on_board && part == train_part && i == wild));
    }
    return result;
  }
};

// ---------------------------------------------------------------- what is hidden

/// Whether an effect is one in that ship, and her file can have it.
bool makes_sense(const Scene& scene, std::string_view kind) {
  const auto& s = scene.truth;
  if (kind == "roll_coupling" && s.GM > 0.0) return false;
  if (kind == "rudder_stall" && (s.stall > 0.0 || s.pods)) return false;
  if (kind == "propeller_side_force" && s.screws() > 1) return false;
  const auto effect = effect_named(kind);
  return !effect || cannot_act(scene.file.model, *effect).empty();
}

/// An effect at a level, alone in the ship, and what it does to the runs held out.
struct Trial {
  std::string kind;
  double level;
  std::uint64_t seed;
  double detectability;

  Label put_into(Concealment& hidden, const TrueShip& truth) const {
    RandomSource random(seed);
    auto label = conceal(hidden, kind, level, truth, {}, random);
    label.severity = detectability >= strongly ? Severity::strong : Severity::moderate;
    label.detectability = detectability;
    return label;
  }
};

/// Finds the level at which an effect is as detectable as wanted, or as far as levels go; nothing if that is less than
/// `least`.
std::optional<Trial> sized(const Scene& scene, const Day& day, const std::vector<Manoeuvre>& runs,
                           std::string_view kind, double least, double wanted, std::uint64_t seed) {
  const auto at_level = [&](double level) {
    Trial trial{.kind = std::string(kind), .level = level, .seed = seed, .detectability = 0.0};
    Concealment hidden = day.calm();
    trial.put_into(hidden, scene.truth);
    trial.detectability = detectability(scene.file, scene.recorded(hidden, hidden, day, runs, holdout_part),
                                        scene.recorded(day.calm(), hidden, day, runs, holdout_part));
    return trial;
  };
  // 1.35 draughts of water, an antenna 0.4 L away, gusts of 2.6 U: no farther
  constexpr std::array strong_at_most{"shallow_water", "antenna_lever_arm", "gust"};
  double low = 0.0, high = std::ranges::count(strong_at_most, kind) > 0 ? 2.0 : largest_level;
  Trial best = at_level(low);
  if (best.detectability >= wanted) return best;
  best = at_level(high);
  for (int step = 0; step < 5 && best.detectability > wanted; ++step) {
    const double middle = 0.5 * (low + high);
    auto trial = at_level(middle);
    (trial.detectability >= wanted ? high : low) = middle;
    if (trial.detectability >= wanted) best = std::move(trial);
  }
  return best.detectability >= least ? std::optional(best) : std::nullopt;
}

/// The effect that was planned or, where it cannot be as detectable as its severity asks, another by chance; a moderate
/// one where three cannot be strong.
Trial hide(const Scene& scene, const Day& day, const std::vector<Manoeuvre>& runs, const std::string& planned,
           Severity severity, const std::vector<Label>& others, RandomSource& random) {
  const auto list = planned.starts_with("unknown") ? on_board_unknown_kinds() : on_board_kinds();
  std::vector<std::string_view> kinds(list.begin(), list.end());
  std::iter_swap(kinds.begin(), std::ranges::find(kinds, planned));
  RandomSource others_by_chance(seed_of(scene.board, in_its_place));
  for (std::size_t left = kinds.size() - 1; left > 1; --left)
    std::swap(kinds[1 + others_by_chance.below(left)], kinds[left]);
  std::erase_if(kinds, [&](std::string_view kind) {
    return !makes_sense(scene, kind) || std::ranges::count(others, kind, &Label::effect) > 0;
  });
  const auto first = [&](std::size_t most, double least) -> std::optional<Trial> {
    const double wanted = least * random.uniform(1.05, 1.5);
    for (std::size_t i = 0; i < std::min(most, kinds.size()); ++i)
      if (auto trial = sized(scene, day, runs, kinds[i], least, wanted, random.bits())) return trial;
    return std::nullopt;
  };
  if (severity == Severity::strong)
    if (auto trial = first(tries_for_strong, strongly)) return *trial;
  if (auto trial = first(kinds.size(), noticeable)) return *trial;
  throw std::domain_error("nothing that is hidden in this ship can be noticed");
}

// ---------------------------------------------------------------- the file

std::vector<QuantityError> errors(const Ship& ship, const std::vector<Recording>& runs) {
  std::vector<Comparison> comparisons;
  for (const auto& run : runs) comparisons.push_back(compare(ship, run));
  return pooled(comparisons);
}

double window_error(const std::vector<QuantityError>& all, Quantity quantity) {
  const auto found = std::ranges::find(all, quantity, &QuantityError::quantity);
  return found == all.end() ? missing : found->window_rms;
}

/// Mean over the quantities that both have.
double mean_ratio(const std::vector<QuantityError>& all, const std::vector<QuantityError>& others) {
  double sum = 0.0;
  int told = 0;
  for (const auto quantity : quantities) {
    const double ratio = window_error(all, quantity) / window_error(others, quantity);
    if (std::isfinite(ratio)) sum += ratio, ++told;
  }
  return sum / told;
}

/// Whether replays by a file stay near the ship: a number wrong by its confidence may make her turn by herself.
bool has_sense(const Ship& file, const std::vector<Recording>& runs) {
  try {
    return window_error(errors(file, runs), Quantity::heading) < error_of_sense;
  } catch (const Refusal&) {
    return false;
  }
}

/// The fair file with every coefficient wrong by a normal deviate of its confidence.
Ship wrong_file(const Scene& scene, const Ship& fair, const Day& day, const std::vector<Manoeuvre>& runs,
                RandomSource& random) {
  const auto calm = scene.recorded(day.calm(), day.calm(), day, runs, train_part);
  for (int draw = 0; draw < 20; ++draw)
    if (Ship file = slightly_wrong(fair, random.bits()); has_sense(file, calm)) return file;
  throw std::domain_error("no file that is wrong by its confidence replays " + scene.truth.kind);
}

// ---------------------------------------------------------------- truth.json

Json nuisances(const OnBoardInstruments& i, const Day& day) {
  return {{{"effect", "channel_delay"}, {"channel", "x"}, {"delay_s", i.clock}},
          {{"effect", "gyro_bias"}, {"bias_rad_s", i.gyro ? i.gyro_zero : 0.0}},
          {{"effect", "gyro_scale"}, {"scale", i.gyro ? i.gyro_scale : 1.0}},
          {{"effect", "log_scale"}, {"scale", i.log_scale}},
          {{"effect", "heading_bias"}, {"bias_rad", i.compass_zero}},
          {{"effect", "rudder_offset"}, {"offset_rad", -i.rudder_zero}},
          {{"effect", "steady_wind"}, {"wind_speed_m_s", day.wind_speed}, {"wind_from_rad", day.wind_from}},
          {{"effect", "steady_current"}, {"current_speed_m_s", day.current_speed}, {"current_to_rad", day.current_to}}};
}

Json as_json(const OnBoardInstruments& i) {
  constexpr std::array filters{"none", "symmetric", "causal"}, drifts{"none", "ground", "water"};
  return {{"rate", i.rate},
          {"gnss", i.fix.slow},
          {"gnss_memory_s", i.fix.memory},
          {"gnss_white", i.fix.white},
          {"drift", drifts[static_cast<std::size_t>(i.sway)]},
          {"speed", i.sway == SwayRecord::through_water ? "u"
                    : i.log                             ? "stw"
                                                        : "sog"},
          {"gyro", i.gyro},
          {"gyro_scale", i.gyro_scale},
          {"gyro_zero", i.gyro_zero},
          {"log_scale", i.log_scale},
          {"compass", i.compass_zero},
          {"rudder_zero", i.rudder_zero},
          {"filter", filters[static_cast<std::size_t>(i.smoothing)]},
          {"width", i.smoothing_width},
          {"derivative", i.slope_width},
          {"clock", i.clock},
          {"rev", i.shaft},
          {"heel", i.heel}};
}

Json as_json(const Seaway& sea) {
  if (sea.waves.empty()) return nullptr;
  return {{"to_rad", sea.to}, {"period_s", sea.period}, {"yaw_rad", sea.yaw}, {"sway_m_s", sea.sway}};
}

Json floor_of(const std::vector<QuantityError>& all) {
  constexpr std::array keys{"heading_rad", "yaw_rate_rad_s", "speed_m_s", "position_m"};
  Json floor = Json::object();
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (const double e = window_error(all, quantities[i]); std::isfinite(e)) floor[keys[i]] = e;
  return floor;
}

}  // namespace

double detectability(const Ship& file, const std::vector<Recording>& runs, const std::vector<Recording>& calm_runs) {
  return mean_ratio(errors(file, runs), errors(file, calm_runs));
}

Ship with_label(const Ship& ship, const Label& label) {
  Effect effect = make_effect(label.effect);
  if (auto* channel = channel_of(effect)) *channel = channel_named(label.channel).value();
  for (const auto& n : parameters_of(ship, effect))
    for (const auto& told : label.parameters)
      if (n.key == told.key) parameter_value(effect, n.index) = told.value;
  return with_effect(ship, effect);
}

std::optional<double> replay_gain(const Ship& file, std::span<const Label> labels, std::size_t one,
                                  const std::vector<Recording>& runs) {
  if (!effect_named(labels[one].effect)) return std::nullopt;
  Ship others = file;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (i != one) others = with_label(others, labels[i]);
  try {
    const double gain = mean_ratio(errors(others, runs), errors(with_label(others, labels[one]), runs));
    return std::isfinite(gain) ? std::optional(gain) : std::nullopt;
  } catch (const Refusal&) {
    return std::nullopt;
  }
}

namespace {

/// Every one of a list equally often and in an order by chance: a pack of cards, shuffled anew when it is used up.
class Pack {
 public:
  Pack(std::span<const std::string_view> cards, RandomSource& random)
      : cards_(cards.begin(), cards.end()), random_(random) {}

  std::string drawn() {
    if (left_ == 0) left_ = cards_.size();
    std::swap(cards_[random_.below(left_)], cards_[left_ - 1]);
    return std::string(cards_[--left_]);
  }
  /// Another than the one that is named, by chance.
  std::string other_than(std::string_view name) {
    std::vector<std::string_view> others;
    std::ranges::copy_if(cards_, std::back_inserter(others), [&](std::string_view card) { return card != name; });
    return std::string(others[random_.below(others.size())]);
  }

 private:
  std::vector<std::string_view> cards_;
  RandomSource& random_;
  std::size_t left_ = 0;
};

}  // namespace

CasePlan on_board_plan(std::string_view structure, FileForm form, Effects effects, std::uint64_t seed) {
  return {.name = {},
          .ship_kind = std::string(structure),
          .effects = std::move(effects),
          .wrong_baseline = true,
          .seed = seed,
          .on_board = form};
}

std::vector<CasePlan> on_board_plans(bool something_hidden, std::size_t count, std::uint64_t seed) {
  constexpr std::array forms{FileForm::mmg, FileForm::abkowitz, FileForm::mmg, FileForm::pi};
  RandomSource random(seed_of(seed, something_hidden ? 0x0b0a : 0x0bc1));
  Pack structures(ship_structures(), random), singles(on_board_kinds(), random), firsts(on_board_kinds(), random),
      unknown(on_board_unknown_kinds(), random);
  const auto severity = [&] { return random.below(2) > 0 ? Severity::strong : Severity::moderate; };
  const auto effects = [&](std::size_t i) -> Effects {
    const std::size_t place = i % 10;  // six singles, two pairs, two unknown
    if (!something_hidden) return {};
    if (place == 4 || place == 9) return {{unknown.drawn(), severity()}};
    if (place != 2 && place != 7) return {{singles.drawn(), severity()}};
    const auto first = firsts.drawn(), second = firsts.other_than(first);
    return {{first, severity()}, {second, severity()}};
  };
  std::vector<CasePlan> plans;
  for (std::size_t i = 0; i < (count > 0 ? count : something_hidden ? 60 : 20); ++i) {
    const auto structure = structures.drawn();
    auto hidden = effects(i);
    const auto form = forms[random.below(forms.size())];
    plans.push_back(on_board_plan(structure, form, std::move(hidden), random.bits()));
    plans.back().name = fmt::format("{:03}", i + 1);
  }
  return plans;
}

namespace {

/// @throws std::domain_error  where the ship that the seed draws can sail by no file, or shows nothing that is hidden
ConcealedCase made_by(const CasePlan& plan, std::uint64_t seed) {
  RandomSource random(seed);
  Scene scene{.truth = true_ship(plan.ship_kind, random.bits()),
              .file = {},
              .board = random.bits(),
              .weather = random.bits(),
              .noise = random.bits()};
  // a shaft that gives way and is not recorded would be something missing
  if (!scene.instruments({}).shaft) scene.truth.droop = 0.0;
  const double ship_error = random.uniform(0.03, 0.08);
  const auto fair = fair_ship(scene.truth, *plan.on_board, ship_error);
  const auto programme = programme_by_chance(random);
  const Day day = day_by_chance(random, scene.truth), day_of_reference = day_by_chance(random, scene.truth);
  scene.file = wrong_file(scene, fair.ship, day, programme.all(), random);
  scene.file.name = fmt::format("ship of {:.0f} m", scene.truth.L);
  ConcealedCase c{
      .plan = plan, .ship = scene.file, .train = {}, .holdout = {}, .reference = {}, .true_holdout = {}, .labels = {}};
  Concealment hidden = day.calm();
  for (const auto& [kind, severity] : plan.effects) {
    const auto found = hide(scene, day, programme.holdout, kind, severity, c.labels, random);
    c.labels.push_back(found.put_into(hidden, scene.truth));
  }
  const auto held_out = scene.recorded(hidden, hidden, day, programme.holdout, holdout_part);
  for (std::size_t i = 0; i < c.labels.size(); ++i)
    c.labels[i].replay_gain = replay_gain(scene.file, c.labels, i, held_out);
  c.plan.reference = !programme.reference.empty();
  c.train = scene.recorded(hidden, hidden, day, programme.train, train_part, Wanted::as_on_board);
  c.holdout = scene.recorded(hidden, hidden, day, programme.holdout, holdout_part, Wanted::as_on_board);
  c.true_holdout = scene.recorded(hidden, hidden, day, programme.holdout, holdout_part, Wanted::faultless);
  c.reference = scene.recorded(day_of_reference.calm(), hidden, day_of_reference, programme.reference, reference_part,
                               Wanted::as_on_board);
  const auto board = scene.instruments(hidden);
  c.truth = {{"nuisances", nuisances(board, day)},
             {"family", plan.ship_kind},
             {"form", name_of(*plan.on_board)},
             {"ship_error", ship_error},
             {"form_misfit", {fair.residue.X, fair.residue.Y, fair.residue.N}},
             {"reference", c.plan.reference},
             {"air",
              {{"mean_m_s", day.wind_speed},
               {"from_rad", day.wind_from},
               {"turbulence", day.turbulence},
               {"current_m_s", day.current_speed},
               {"current_to_rad", day.current_to}}},
             {"sea", as_json(scene.seaway(train_part))},
             {"instruments", as_json(board)},
             {"replay_floor",
              floor_of(errors(scene.file, scene.recorded(day.calm(), hidden, day, programme.holdout, holdout_part)))},
             {"length_m", scene.truth.L},
             {"speed_m_s", scene.truth.U_0},
             {"seed", seed}};
  return c;
}

}  // namespace

ConcealedCase made_on_board(const CasePlan& plan) {
  constexpr std::uint64_t ships = 5;
  for (std::uint64_t ship = 0;; ++ship) try {
      return made_by(plan, ship == 0 ? plan.seed : seed_of(plan.seed, ship));
    } catch (const std::domain_error&) {
      if (ship + 1 == ships) throw;
    }
}

}  // namespace swayaw::concealed

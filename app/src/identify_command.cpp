#include "swayaw/identification/identify.hpp"

#include <algorithm>
#include <cmath>

#include "checked_runs.hpp"
#include "commands.hpp"
#include "identify_linear.hpp"
#include "identify_page.hpp"
#include "input.hpp"
#include "json.hpp"
#include "page_writing.hpp"
#include "progress.hpp"
#include "recorded_inputs.hpp"
#include "run_selection.hpp"
#include "swayaw/core/version.hpp"
#include "swayaw/identification/trajectory_fit.hpp"
#include "swayaw/mismatch/compare.hpp"
#include "swayaw/nonlinear/coefficients.hpp"
#include "swayaw/nonlinear/writable_ship.hpp"
#include "terminal.hpp"

namespace swayaw::app {
namespace {

// ---------------------------------------------------------------- the question

/// Those asked for, or the usual ones, with `also` and without `keep`.
std::vector<std::string> parameters_to_find(const Ship& ship, const IdentifyArguments& a) {
  auto names = a.find.empty() ? usual_parameters(ship) : a.find;
  for (const auto& name : a.also)
    if (std::ranges::count(names, name) == 0) names.push_back(name);
  for (const auto& name : a.keep) {
    (void)parameters_of(ship, std::array{name});
    std::erase(names, name);
  }
  (void)parameters_of(ship, names);
  return names;
}

std::vector<Channel> channels_named(const std::vector<std::string>& names) {
  std::vector<Channel> channels;
  for (const auto& name : names) {
    const auto measured = measured_channels();
    const auto found = std::ranges::find(measured, name, [](Channel c) { return column_name(c); });
    if (found == measured.end())
      throw Refusal(fmt::format(
          "--channels: {} is not among the channels that are used, which are x_m, y_m, psi_rad, u_m_s …", name));
    channels.push_back(*found);
  }
  return channels;
}

/// Coefficients are found as of the water in which the runs were sailed: their depth does not act besides.
Recording with_depth_in_coefficients(const Ship& ship, Recording run) {
  const auto depth = recorded_depth(run);
  if (in_depth(ship, depth))
    say_aside("swayaw: {}: the coefficients will be those of water {:.4g} m deep, as it was measured\n", run.name,
              *depth);
  return without(std::move(run), {.depth = true});
}

Question question_of(const IdentifyArguments& a) {
  Question q{.ship = in_model(load_nonlinear_ship(a.ship), a.model),
             .runs = checked_runs(a.runs, a.reading),
             .holdout = checked_runs(a.holdout, a.reading),
             .options = {.parameters = {}}};
  q.options.parameters = parameters_to_find(q.ship, a);
  q.options.priors = a.prior;
  q.options.ridge = a.ridge;
  q.options.states.channels = channels_named(a.channels);
  q.runs = sailable(q.ship, std::move(q.runs), q.aside);
  require_some(q.runs, q.aside);
  q.holdout = sailable(q.ship, std::move(q.holdout), q.aside);
  for (auto* runs : {&q.runs, &q.holdout}) {
    tell_in_vain(q.ship, *runs), tell_propulsion(q.ship, *runs);
    for (auto& run : *runs) run = with_depth_in_coefficients(q.ship, std::move(run));
  }
  return q;
}

// ---------------------------------------------------------------- the answer

/// Smaller than any instrument tells: a simulation recorded without noise.
bool is_negligible(const ChannelResiduals& c, const Ship& ship) {
  const double L = length(ship), U = service_speed(ship);
  switch (c.channel) {
    case Channel::x:
    case Channel::y: return c.after < 1e-4 * L;
    case Channel::psi:
    case Channel::course_over_ground: return c.after < 1e-4;
    case Channel::r: return c.after < 1e-4 * U / L;
    default: return c.after < 1e-4 * U;
  }
}

/// Residuals of a right model are as white as noise, or nothing.
bool explains(const TrajectoryFit& fit) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto& run : fit.runs)
    for (const auto& c : run.channels) {
      sum += is_negligible(c, fit.ship) ? 0.0 : std::abs(c.autocorrelation);
      ++count;
    }
  return fit.status == TrajectoryFitStatus::converged && sum < 0.2 * static_cast<double>(count);
}

TrajectoryFit fit_on_trajectories(const Question& q, const ForceFit& start, Progress& progress,
                                  const Interrupt& interrupt) {
  TrajectoryFitOptions options{
      .parameters = q.options.parameters, .channels = q.options.states.channels, .priors = q.options.priors};
  const double began = progress.seconds();
  options.progress = [&](const TrajectoryProgress& p) {
    if (p.iteration > 0) {
      const double each = (progress.seconds() - began) / p.iteration;
      progress.tell_rest(0.0, (options.most_iterations - p.iteration) * each);
    }
    progress.tell(fmt::format("trajectories, iteration {}, parameters move by {:.2g}", p.iteration, p.change));
    return !interrupt.asked();
  };
  return fit_trajectories(start.ship, q.runs, options);
}

Found found_by_forces(const Parameter& number, const ForceFit& fit) {
  for (const auto& equation : fit.equations)
    for (const auto& c : equation.fit.coefficients)
      if (c.name == number.name) return {number, c.estimate, c.low, c.high, c.variance_inflation, c.undetermined};
  return {number, {}, std::nan(""), std::nan(""), std::nullopt, true};
}

Found found_on_trajectories(const Parameter& number, const TrajectoryFit& fit) {
  const auto n = std::ranges::find(fit.parameters, number.name, &FittedParameter::name);
  const auto& [value, error] = n->estimate;
  const bool undetermined = std::ranges::count(fit.undetermined, number.name) > 0;
  return {number, n->estimate, value - 1.96 * error, value + 1.96 * error, std::nullopt, undetermined};
}

/// What to record next, where the data leave something open.
std::vector<std::string> advice_for(const Question& q, const Answer& answer) {
  std::vector<std::string> advice;
  const auto worst = [&](auto&& measure) {
    double most = 0.0;
    for (const auto& e : answer.forces.equations)
      if (e.component != ForceComponent::X) most = std::max(most, measure(e.fit));
    return most;
  };
  const double condition = worst([](const Regression& r) { return r.condition_number; });
  const double inflation = worst([](const Regression& r) {
    double most = 0.0;
    for (const auto& c : r.coefficients) most = std::max(most, c.variance_inflation);
    return most;
  });
  if (condition < 100.0 && inflation < 1000.0) return advice;
  advice.push_back(fmt::format(
      "ill-conditioned: condition number {:.0f}, variance inflation up to {:.2g}; single coefficients mean little",
      condition, inflation));
  if (!std::holds_alternative<PuShip<double>>(q.ship.model)) {
    advice.push_back(
        "drift and yaw rate went together in these runs; turning circles beside zigzags, or zigzags of other sizes, "
        "would separate their terms");
    return advice;
  }
  std::vector<int> amplitudes;
  for (const auto& run : q.runs) amplitudes.push_back(rudder_amplitude(q.ship, run));
  const auto [low, high] = std::ranges::minmax(amplitudes);
  if (high - low <= 2)
    advice.push_back(
        fmt::format("all runs have one rudder amplitude, {} deg: its square hardly varies, so terms with delta² are "
                    "copies of those without; "
                    "record runs with a second rudder amplitude",
                    high));
  else
    advice.push_back(
        fmt::format("rudder amplitudes from {} to {} deg do not separate the rudder terms enough: record more "
                    "amplitudes, or take model pi, whose "
                    "rudder is known beforehand",
                    low, high));
  return advice;
}

std::vector<ZigzagCheck> zigzag_checks(const Question& q, const Ship& after) {
  std::vector<ZigzagCheck> checks;
  const auto add = [&](const Recording& run) {
    const auto order = zigzag_order(run);
    if (!order) return;
    const auto recorded = recorded_overshoots(run, *order);
    if (recorded.empty()) return;
    checks.push_back({run.name, recorded, simulated_overshoots(q.ship, run, *order, recorded.size()),
                      simulated_overshoots(after, run, *order, recorded.size())});
  };
  for (const auto& run : q.runs) add(run);
  for (const auto& run : q.holdout) add(run);
  return checks;
}

/// Standard errors become the trust that the file has in its parameters.
void set_confidence(Ship& ship, std::span<const Found> found) {
  for (const auto& f : found) {
    const double relative = f.estimate.standard_error / std::abs(f.estimate.value);
    if (!std::isfinite(relative)) continue;
    std::erase_if(ship.confidence.named, [&](const auto& named) { return named.first == f.before.key; });
    ship.confidence.named.emplace_back(f.before.key, std::min(relative, 10.0));
  }
}

std::string_view words_for(TrajectoryFitStatus status) {
  switch (status) {
    case TrajectoryFitStatus::converged: return "converged";
    case TrajectoryFitStatus::iteration_limit: return "iteration limit";
    case TrajectoryFitStatus::stopped: return "stopped";
    case TrajectoryFitStatus::rank_deficient: return "rank deficient";
  }
  return {};
}

/// Whether the trajectory fit is taken, and why.
void choose(Answer& answer, const IdentifyArguments& a) {
  if (!answer.trajectories) {
    answer.reason = "least squares on the forces of inverse dynamics";
    return;
  }
  const bool right = explains(*answer.trajectories);
  answer.lacks_something = answer.trajectories->status == TrajectoryFitStatus::converged && !right;
  answer.from_trajectories = a.fit == "trajectories" || right;
  if (a.fit == "trajectories") answer.reason = "fitted to the recorded trajectories, as asked";
  else if (right) answer.reason = "fitted to the recorded trajectories, whose residuals are no more than noise";
  else if (answer.trajectories->status == TrajectoryFitStatus::converged)
    answer.reason =
        "least squares on the forces of inverse dynamics; on trajectories the residuals are not noise: the model lacks "
        "something, and such a fit would bend the coefficients to it";
  else
    answer.reason =
        fmt::format("least squares on the forces of inverse dynamics; the fit to trajectories did not end well ({})",
                    words_for(answer.trajectories->status));
}

/// States of the runs that the filter can follow to their end; the others are set aside.
/// @throws Refusal  if none is left
std::vector<StateEstimate> motions_of(Question& q, Progress& progress) {
  std::vector<StateEstimate> states;
  std::vector<Recording> followed;
  for (auto& run : q.runs) {
    progress.tell(fmt::format("motion of {}", run.name));
    try {
      states.push_back(estimate_states(q.ship, run, q.options.states));
      followed.push_back(std::move(run));
    } catch (const std::exception& trouble) {
      set_aside(q.aside, run.name, trouble.what());
    }
  }
  q.runs = std::move(followed);
  require_some(q.runs, q.aside);
  return states;
}

/// The first step. Numbers that trajectories alone tell have none, if these were asked for: the ship as given begins.
ForceFit first_step(const Question& q, const IdentifyArguments& a, std::vector<StateEstimate> states) try {
  return fit_forces(q.ship, q.runs, std::move(states), q.options);
} catch (const Refusal&) {
  if (a.fit != "trajectories") throw;
  return {.ship = q.ship, .equations = {}, .range = {}, .states = {}};
}

Answer answer_to(Question& q, const IdentifyArguments& a) {
  Progress progress("identify");
  const Interrupt interrupt;
  Answer answer{.ship = q.ship,
                .forces = {},
                .trajectories = {},
                .reason = {},
                .found = {},
                .stability = {.straight_course = StraightCourse::not_told,
                              .e0 = std::nan(""),
                              .standard_error = std::nan(""),
                              .range = {},
                              .linear_hull = false,
                              .words = "not told"},
                .resamples = {},
                .zigzags = {},
                .advice = {}};
  auto states = motions_of(q, progress);
  answer.forces = first_step(q, a, std::move(states));
  if (a.fit != "forces" && !interrupt.asked()) {
    try {
      answer.trajectories = fit_on_trajectories(q, answer.forces, progress, interrupt);
    } catch (const std::exception& trouble) {
      if (answer.forces.equations.empty()) throw;
      if (a.fit == "trajectories") answer.failed = fmt::format("not fitted to trajectories: {}", trouble.what());
      else say_aside("swayaw: not fitted to trajectories: {}\n", trouble.what());
    }
  }
  choose(answer, a);
  answer.ship = answer.from_trajectories ? answer.trajectories->ship : answer.forces.ship;
  for (const auto& number : parameters_of(q.ship, q.options.parameters))
    answer.found.push_back(answer.from_trajectories ? found_on_trajectories(number, *answer.trajectories)
                                                    : found_by_forces(number, answer.forces));
  attempt(answer.troubles, "stability on a straight course",
          [&] { answer.stability = stability_verdict(answer.forces); });
  if (a.resample && !interrupt.asked()) {
    progress.tell("other choices of runs");
    attempt(answer.troubles, "what other choices of runs give",
            [&] { answer.resamples = resample(q.ship, q.runs, answer.forces, q.options); });
  }
  attempt(answer.troubles, "overshoots of the zigzags", [&] { answer.zigzags = zigzag_checks(q, answer.ship); });
  attempt(answer.troubles, "what to record next", [&] { answer.advice = advice_for(q, answer); });
  set_confidence(answer.ship, answer.found);
  return answer;
}

// ---------------------------------------------------------------- errors of a replay

std::optional<std::vector<ErrorShare>> shares_of(const Ship& ship, const Recording& run) {
  try {
    std::vector<ErrorShare> shares;
    for (const auto& e : compare(ship, run).errors) shares.push_back({e.quantity, e.normalised()});
    return shares;
  } catch (const std::exception&) {  // she cannot sail it
    return std::nullopt;
  }
}

/// Errors of the ship before and after.
std::vector<Prediction> predictions_of(const Ship& before, const Ship& after, const std::vector<Recording>& runs) {
  std::vector<Prediction> predictions;
  for (const auto& run : runs) predictions.push_back({run.name, shares_of(before, run), shares_of(after, run)});
  return predictions;
}

Json shares_json(const std::optional<std::vector<ErrorShare>>& shares) {
  if (!shares) return nullptr;
  Json json = Json::object();
  for (const auto& [quantity, share] : *shares) json[std::string(name_of(quantity))] = number(share);
  return json;
}

Json errors_json(const std::vector<Prediction>& predictions) {
  Json list = Json::array();
  for (const auto& p : predictions)
    list.push_back({{"run", p.run}, {"before", shares_json(p.before)}, {"after", shares_json(p.after)}});
  return list;
}

// ---------------------------------------------------------------- verdict

std::string held_out_words(const Question& q, const std::optional<PredictionErrors>& h) {
  if (q.holdout.empty())
    return "No run was held out: whether the coefficients hold for others is not told (--holdout).";
  if (!h) return "The held-out runs could not be replayed: whether the coefficients hold for them is not told.";
  if (!h->lost.empty())
    return fmt::format("Held-out runs WORSEN: with the coefficients found she cannot sail {}.",
                       fmt::join(h->lost, ", "));
  return fmt::format("Held-out runs {}: their error goes from {:.1f} to {:.1f} % of the variation.",
                     h->worse()             ? "WORSEN"
                     : h->after < h->before ? "improve"
                                            : "stay as they were",
                     100.0 * h->before, 100.0 * h->after);
}

/// What was found, and whether it holds elsewhere, in two or three sentences.
std::string verdict_words(const Question& q, const Answer& answer, const std::optional<PredictionErrors>& h) {
  std::vector<std::string> open;
  for (const auto& f : answer.found)
    if (f.undetermined) open.push_back(f.before.name);
  auto words = fmt::format("{} of {} coefficients determined by {} run{}", answer.found.size() - open.size(),
                           answer.found.size(), q.runs.size(), q.runs.size() == 1 ? "" : "s");
  words += open.empty() ? "." : fmt::format("; not determined: {}.", fmt::join(open, ", "));
  if (!q.aside.empty()) {
    std::vector<std::string> names;
    for (const auto& [run, why] : q.aside) names.push_back(run);
    words += fmt::format(" Set aside: {}.", fmt::join(names, ", "));
  }
  return words + " " + held_out_words(q, h);
}

Json verdict_json(const Question& q, const Answer& answer, const std::optional<PredictionErrors>& h) {
  Json aside = Json::array();
  for (const auto& [run, why] : q.aside) aside.push_back({{"run", run}, {"why", why}});
  const Json held = h ? Json{{"before", number(h->before)},
                             {"after", number(h->after)},
                             {"cannot_sail", h->lost},
                             {"worse", h->worse()}}
                      : Json(nullptr);
  return {{"words", verdict_words(q, answer, h)}, {"holdout", held}, {"set_aside", std::move(aside)}};
}

// ---------------------------------------------------------------- JSON

Json coefficient_json(const Found& f) {
  return {{"name", f.before.name},
          {"before", number(f.before.value)},
          {"value", number(f.estimate.value)},
          {"standard_error", number(f.estimate.standard_error)},
          {"low", number(f.low)},
          {"high", number(f.high)},
          {"variance_inflation", f.variance_inflation ? number(*f.variance_inflation) : Json(nullptr)},
          {"undetermined", f.undetermined}};
}

Json equation_json(const ForceEquation& e) {
  Json names = Json::array(), combinations = Json::array(), bias = Json::object();
  for (std::size_t i = 0; i < e.fit.coefficients.size(); ++i) {
    names.push_back(e.fit.coefficients[i].name);
    bias[e.fit.coefficients[i].name] = number(e.bias[i]);
  }
  for (const auto& combination : e.fit.undetermined) combinations.push_back(in_words(combination));
  return {{"force", in_words(e.component)},
          {"coefficients", std::move(names)},
          {"R2", number(e.fit.R2)},
          {"condition_number", number(e.fit.condition_number)},
          {"effective_samples", number(e.fit.samples)},
          {"solver", in_words(e.fit.solver)},
          {"bias_of_motion_errors", std::move(bias)},
          {"undetermined", std::move(combinations)}};
}

Json stability_json(const StabilityVerdict& s) {
  constexpr std::array names{"stable", "unstable", "not_told"};
  return {{"straight_course", names[static_cast<std::size_t>(s.straight_course)]},
          {"e0", number(s.e0)},
          {"standard_error", number(s.standard_error)},
          {"linear_hull", s.linear_hull},
          {"largest_drift_rad", s.range.drift},
          {"largest_r_prime", s.range.omega},
          {"words", s.words}};
}

Json trajectory_json(const TrajectoryFit& fit) {
  Json runs = Json::array(), parameters = Json::array();
  for (const auto& n : fit.parameters)
    parameters.push_back({{"name", n.name},
                          {"value", number(n.estimate.value)},
                          {"standard_error", number(n.estimate.standard_error)},
                          {"at_bound", n.at_bound}});
  for (const auto& run : fit.runs) {
    Json channels = Json::array();
    for (const auto& c : run.channels)
      channels.push_back({{"channel", column_name(c.channel)},
                          {"rms_before", number(c.before)},
                          {"rms_after", number(c.after)},
                          {"autocorrelation", number(c.autocorrelation)}});
    runs.push_back({{"run", run.name}, {"channels", std::move(channels)}});
  }
  return {{"status", words_for(fit.status)},
          {"iterations", fit.iterations},
          {"condition_number", number(fit.condition_number)},
          {"best_combination", fit.best_combination},
          {"undetermined", fit.undetermined},
          {"numbers", std::move(parameters)},
          {"runs", std::move(runs)}};
}

Json zigzag_json(const ZigzagCheck& z) {
  const auto angles = [](const std::optional<std::vector<double>>& o) {
    return o ? parameters(in_degrees(*o)) : Json(nullptr);
  };
  return {{"run", z.run},
          {"recorded_deg", parameters(in_degrees(z.recorded))},
          {"before_deg", angles(z.before)},
          {"after_deg", angles(z.after)}};
}

Json resamples_json(const std::vector<Resample>& resamples, const std::vector<std::string>& names) {
  Json list = Json::array();
  for (const auto& r : resamples) {
    Json values = Json::object();
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = number(r.values[i]);
    list.push_back({{"runs", r.runs}, {"values", std::move(values)}});
  }
  return list;
}

Json names_of(const std::vector<Recording>& runs) {
  Json list = Json::array();
  for (const auto& run : runs) list.push_back(run.name);
  return list;
}

Json document_of(const Question& q, const Answer& answer, const Predictions& predictions, const IdentifyArguments& a,
                 const std::vector<std::string>& not_written) {
  Json coefficients = Json::array(), equations = Json::array(), zigzags = Json::array();
  Json train = errors_json(predictions.train), holdout = errors_json(predictions.holdout);
  const auto judged = together(predictions.holdout);
  for (const auto& f : answer.found) coefficients.push_back(coefficient_json(f));
  for (const auto& e : answer.forces.equations) equations.push_back(equation_json(e));
  for (const auto& z : answer.zigzags) zigzags.push_back(zigzag_json(z));
  return {{"schema", "swayaw.identification/1"},
          {"version", version()},
          {"ship", q.ship.name},
          {"model", a.model},
          {"verdict", verdict_json(q, answer, judged)},
          {"runs", names_of(q.runs)},
          {"method", answer.from_trajectories ? "trajectories" : "forces"},
          {"reason", answer.reason},
          {"coefficients", std::move(coefficients)},
          {"equations", std::move(equations)},
          {"trajectories", answer.trajectories ? trajectory_json(*answer.trajectories) : Json(nullptr)},
          {"stability", stability_json(answer.stability)},
          {"errors", {{"train", std::move(train)}, {"holdout", std::move(holdout)}}},
          {"zigzags", std::move(zigzags)},
          {"resamples", resamples_json(answer.resamples, q.options.parameters)},
          {"advice", answer.advice},
          {"not_written", not_written},
          {"troubles", answer.troubles}};
}

// ---------------------------------------------------------------- text

void print_coefficients(const Answer& answer) {
  say("  {:<17}{:>10}{:>10}{:>10}  {:<20}{:>9}\n", "coefficient", "before", "found", "std error", "95 % interval",
      "inflation");
  for (const auto& f : answer.found)
    say("  {:<17}{:>10.4g}{:>10.4g}{:>10.2g}  {:<20}{:>9}\n", f.before.name + (f.undetermined ? " *" : ""),
        f.before.value, f.estimate.value, f.estimate.standard_error, fmt::format("{:.4g} to {:.4g}", f.low, f.high),
        f.variance_inflation ? fmt::format("{:.3g}", *f.variance_inflation) : "");
  if (std::ranges::any_of(answer.found, &Found::undetermined)) say("  * not determined by these runs\n");
}

void print_equations(const Answer& answer) {
  for (const auto& e : answer.forces.equations) {
    say("  {}: R2 {:.3f}, condition number {:.3g}, {:.0f} independent samples, {}\n", in_words(e.component), e.fit.R2,
        e.fit.condition_number, e.fit.samples, in_words(e.fit.solver));
    for (const auto& combination : e.fit.undetermined) say("     not determined: {}\n", in_words(combination));
  }
}

std::string angles_text(const std::optional<std::vector<double>>& angles) {
  if (!angles) return "cannot sail it";
  std::string text;
  for (const double angle : *angles) text += fmt::format("{}{:.1f}", text.empty() ? "" : ", ", degrees(angle));
  return text.empty() ? "-" : text;
}

void print_errors(std::string_view title, const Json& list) {
  if (list.empty()) return;
  say("\n{}: error of replays over two ship lengths, of the variation\n", title);
  say("  {:<40}{:<12}{:>11}{:>11}\n", "run", "quantity", "before", "after");
  for (const auto& run : list) {
    auto name = run["run"].get<std::string>();
    const auto share = [&](const char* when, const char* quantity) {
      return run[when].is_object() && run[when].contains(quantity) && run[when][quantity].is_number()
                 ? fmt::format("{:.1f} %", 100.0 * run[when][quantity].get<double>())
                 : std::string("-");
    };
    for (const auto& [quantity, words] : {std::pair{"heading", "heading"}, std::pair{"yaw_rate", "yaw rate"},
                                          std::pair{"speed", "speed"}, std::pair{"drift", "drift"}}) {
      say("  {:<40}{:<12}{:>11}{:>11}\n", name, words, share("before", quantity), share("after", quantity));
      name.clear();
    }
  }
}

/// Values of numbers over the choices of runs, some numbers beside each other.
void print_resamples(const std::vector<Resample>& resamples, const std::vector<std::string>& names) {
  if (resamples.empty()) return;
  constexpr std::size_t beside = 3;
  for (std::size_t first = 0; first < names.size(); first += beside) {
    const auto last = std::min(first + beside, names.size());
    say("\n  {:<38}", first == 0 ? "other choices of runs" : "");
    for (std::size_t j = first; j < last; ++j) say("{:>13}", names[j]);
    say("\n");
    for (const auto& r : resamples) {
      say("  {:<38}", r.runs);
      for (std::size_t j = first; j < last; ++j)
        say("{:>13}", r.values[j] ? fmt::format("{:.5g}", *r.values[j]) : std::string("-"));
      say("\n");
    }
  }
}

void print_answer(const Question& q, const Answer& answer, const Json& document) {
  say("{}\n", q.ship.name);
  say("{}\n", document["verdict"]["words"].get<std::string>());
  say("{}\n\n", answer.reason);
  print_coefficients(answer);
  if (!answer.forces.equations.empty()) say("\nforce equations\n");
  print_equations(answer);
  print_errors("runs used", document["errors"]["train"]);
  print_errors("runs held out", document["errors"]["holdout"]);
  if (!answer.zigzags.empty()) say("\nzigzags, overshoots in deg\n");
  for (const auto& z : answer.zigzags)
    say("  {:<28}  recorded {}; before {}; after {}\n", z.run, angles_text(z.recorded), angles_text(z.before),
        angles_text(z.after));
  print_resamples(answer.resamples, q.options.parameters);
  say("\nstraight course: {}\n", answer.stability.words);
  for (const auto& line : answer.advice) say("{}\n", line);
  for (const auto& line : document["not_written"]) say("{}\n", line.get<std::string>());
  for (const auto& line : answer.troubles) say("{}\n", line);
}

/// What a script must know of a work that was done: runs that were not used are predicted worse, or what was asked for
/// could not be done.
/// @throws Refusal  in one line
void require_success(const Answer& answer, const Json& document) {
  if (!answer.failed.empty()) throw Refusal(answer.failed);
  const auto& held = document["verdict"]["holdout"];
  if (held.is_object() && held["worse"].get<bool>())
    throw Refusal("held-out runs are predicted worse with the coefficients found than with those of the ship file");
}

/// Where the parameters of the file come from.
std::string remark_of(const Question& q, const Answer& answer) {
  auto remark = fmt::format("Coefficients identified by swayaw {} from", version());
  for (const auto& run : q.runs) remark += fmt::format(" {}", run.name);
  remark += fmt::format(",\nbeginning with {}: {}.\nStraight course: {}.", q.ship.name, answer.reason,
                        answer.stability.words);
  std::string undetermined;
  for (const auto& f : answer.found)
    if (f.undetermined) undetermined += (undetermined.empty() ? "" : ", ") + f.before.name;
  if (!undetermined.empty()) remark += fmt::format("\nNot determined by these runs: {}.", undetermined);
  return remark + "\n[confidence] holds the relative standard errors.";
}

}  // namespace

std::optional<PredictionErrors> together(const std::vector<Prediction>& predictions) {
  PredictionErrors result{0.0, 0.0, {}};
  int count = 0;
  for (const auto& p : predictions) {
    if (!p.before) continue;
    if (!p.after) {
      result.lost.push_back(p.run);
      continue;
    }
    for (const auto& [quantity, before] : *p.before) {
      const auto after = std::ranges::find(*p.after, quantity, &ErrorShare::quantity);
      if (after == p.after->end() || !std::isfinite(before) || !std::isfinite(after->share)) continue;
      result.before += before * before;
      result.after += after->share * after->share;
      ++count;
    }
  }
  if (count == 0 && result.lost.empty()) return std::nullopt;
  result.before = std::sqrt(result.before / std::max(1, count));
  result.after = std::sqrt(result.after / std::max(1, count));
  return result;
}

void identify(const IdentifyArguments& a) {
  if (a.model == "linear") return identify_linear(a);
  auto question = question_of(a);
  auto answer = answer_to(question, a);
  const auto kept = writable(answer.ship, question.ship);
  auto remark = remark_of(question, answer);
  for (const auto& line : kept.changed) remark += "\n" + line + ".";
  bool saved = a.out.empty();
  if (!saved)
    attempt(answer.troubles, a.out.string(), [&] {
      write_ship(a.out, kept.ship, remark);
      saved = true;
    });
  const Predictions predictions{predictions_of(question.ship, answer.ship, question.runs),
                                predictions_of(question.ship, answer.ship, question.holdout)};
  const auto document = document_of(question, answer, predictions, a, kept.changed);
  if (a.json) print_document(document);
  else print_answer(question, answer, document);
  if (a.report.wanted()) write_page(a.report.file, html(identify_page(question, answer, predictions, a)));
  if (!saved) throw Refusal(fmt::format("{}: the ship file was not written", a.out.string()));
  if (!a.out.empty()) say_aside("swayaw: ship file written to {}\n", a.out.string());
  require_success(answer, document);
}

}  // namespace swayaw::app

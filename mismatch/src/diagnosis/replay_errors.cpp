#include "replay_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "swayaw/core/parallel.hpp"

namespace swayaw::inline mismatch::detail {

ShipInRun ships_at(const Trial& trial, Hypothesis effects, Point point) {
  return [&trial, effects = std::move(effects), point = std::move(point)](const Recording& run) {
    return ship_at(trial, effects, point, &run);
  };
}

std::vector<QuantityError> errors_of(const Ship& ship, const Recording& run) try {
  return compare(ship, run).errors;
} catch (const std::exception&) {
  return {};
}

std::vector<RunErrors> errors_of(const Ship& before, const ShipInRun& refitted, const ShipInRun& after,
                                 std::span<const Recording> runs) {
  std::vector<RunErrors> errors(runs.size());
  in_parallel(runs.size(), 0, [&](std::size_t i) {
    const auto& run = runs[i];
    errors[i] = {run.name, errors_of(before, run), errors_of(refitted(run), run), errors_of(after(run), run)};
  });
  return errors;
}

std::vector<RunErrors> with_after(std::vector<RunErrors> errors, const ShipInRun& after,
                                  std::span<const Recording> runs) {
  in_parallel(runs.size(), 0, [&](std::size_t i) { errors[i].after = errors_of(after(runs[i]), runs[i]); });
  return errors;
}

double gain_of(std::span<const RunErrors> runs) {
  double sum = 0.0;
  int count = 0;
  for (const auto& run : runs)
    for (const auto quantity : {Quantity::heading, Quantity::yaw_rate, Quantity::speed, Quantity::position}) {
      const auto a = std::ranges::find(run.refitted, quantity, &QuantityError::quantity),
                 b = std::ranges::find(run.after, quantity, &QuantityError::quantity);
      if (a == run.refitted.end() || b == run.after.end() || !(a->window_rms > 0.0)) continue;
      sum += 1.0 - b->window_rms / a->window_rms;
      ++count;
    }
  return count ? sum / count : 0.0;
}

std::optional<Discrepancy> discrepancy_of(std::span<const RunErrors> train, std::span<const RunErrors> holdout,
                                          Quantity quantity) {
  Discrepancy sum{0.0, 0.0, 0.0};
  int count = 0;
  const auto of = [quantity](const std::vector<QuantityError>& errors) {
    const auto found = std::ranges::find(errors, quantity, &QuantityError::quantity);
    return found == errors.end() ? HUGE_VAL : found->normalised_beyond_waves();
  };
  for (const auto& runs : {train, holdout})
    for (const auto& run : runs) {
      const double given = of(run.before), refitted = of(run.refitted), after = of(run.after);
      if (!std::isfinite(given + refitted + after)) continue;
      sum.given += given, sum.refitted += refitted, sum.after += after, ++count;
    }
  if (count == 0) return std::nullopt;
  return Discrepancy{sum.given / count, sum.refitted / count, sum.after / count};
}

std::map<Quantity, double> falls_of(const ShipInRun& from, const ShipInRun& to,
                                    std::initializer_list<std::span<const Recording>> sets) {
  std::map<Quantity, std::pair<double, int>> sums;
  for (const auto& runs : sets) {
    std::vector<std::pair<std::vector<QuantityError>, std::vector<QuantityError>>> errors(runs.size());
    in_parallel(runs.size(), 0, [&](std::size_t i) {
      errors[i] = {errors_of(from(runs[i]), runs[i]), errors_of(to(runs[i]), runs[i])};
    });
    for (const auto& [a, b] : errors)
      for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        auto& [sum, count] = sums[a[i].quantity];
        sum += a[i].normalised_beyond_waves() - b[i].normalised_beyond_waves(), ++count;
      }
  }
  std::map<Quantity, double> falls;
  for (const auto& [quantity, sum] : sums) falls[quantity] = sum.first / sum.second;
  return falls;
}

bool differ_by_more(double share, const ShipInRun& one, const ShipInRun& other,
                    std::initializer_list<std::span<const Recording>> sets) {
  constexpr std::array seen{std::pair{Quantity::heading, Channel::psi}, std::pair{Quantity::yaw_rate, Channel::r},
                            std::pair{Quantity::speed, Channel::u}};
  for (const auto& runs : sets)
    for (const auto& run : runs) {
      const auto a = compare(one(run), run), b = compare(other(run), run);
      for (const auto& [quantity, channel] : seen) {
        const auto error = std::ranges::find(a.errors, quantity, &QuantityError::quantity);
        if (error == a.errors.end()) continue;
        double squares = 0.0;
        for (std::size_t k = 0; k < run.samples(); ++k)
          squares += std::pow(a.restarted[channel][k] - b.restarted[channel][k], 2);
        if (!(std::sqrt(squares / static_cast<double>(run.samples())) < share * error->variation)) return true;
      }
    }
  return false;
}

}  // namespace swayaw::mismatch::detail

#include "swayaw/app/sweep/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "swayaw/app/sweep/points.hpp"
#include "swayaw/core/parallel.hpp"

namespace swayaw::app {
namespace {

constexpr std::size_t bins = 40, extremes = 3;

// ---------------------------------------------------------------- one column

/// Quantiles of values, which are put in another order: by linear interpolation between the two nearest, as numpy's.
void find_quantiles(std::span<double> values, ColumnSummary& summary) {
  std::size_t settled = 0;  // what comes before is smaller
  for (std::size_t q = 0; q < summary_quantiles.size(); ++q) {
    const double place = summary_quantiles[q] * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    std::nth_element(values.begin() + static_cast<std::ptrdiff_t>(settled),
                     values.begin() + static_cast<std::ptrdiff_t>(below), values.end());
    settled = below;
    const double at = values[below], share = place - static_cast<double>(below);
    const double above =
        share > 0.0 ? *std::min_element(values.begin() + static_cast<std::ptrdiff_t>(below) + 1, values.end()) : at;
    summary.quantile[q] = at + share * (above - at);
  }
}

/// A few items, the first by that order; equal ones by their number.
template <class Order>
std::vector<ItemValue> first_by(std::span<const double> values, std::size_t first_item, Order order) {
  std::vector<ItemValue> found;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    if (found.size() == extremes && !order(values[i], found.back().value)) continue;
    const auto place = std::ranges::find_if(found, [&](const ItemValue& f) { return order(values[i], f.value); });
    found.insert(place, {first_item + i, values[i]});
    if (found.size() > extremes) found.pop_back();
  }
  return found;
}

ColumnSummary summary_of_column(std::vector<double> values, std::size_t subject, std::size_t column,
                                std::size_t first_item) {
  ColumnSummary s{.subject = subject, .column = column};
  s.lowest = first_by(values, first_item, std::less<>());
  s.highest = first_by(values, first_item, std::greater<>());
  const auto all = values.size();
  std::erase_if(values, [](double x) { return !std::isfinite(x); });
  s.count = values.size();
  s.missing = all - s.count;
  if (values.empty()) return s;
  const auto n = static_cast<double>(s.count);
  s.mean = std::reduce(values.begin(), values.end()) / n;
  double squares = 0.0;
  for (const double x : values) squares += (x - s.mean) * (x - s.mean);
  s.standard_deviation = s.count > 1 ? std::sqrt(squares / (n - 1.0)) : 0.0;
  s.low = s.lowest.front().value, s.high = s.highest.front().value;
  s.histogram.assign(bins, 0);
  const double width = s.high - s.low;
  for (const double x : values)
    ++s.histogram[width > 0.0 ? std::min(bins - 1, static_cast<std::size_t>(bins * (x - s.low) / width)) : 0];
  find_quantiles(values, s);
  return s;
}

// ---------------------------------------------------------------- sensitivity

/// Results of one ship at the pairs of a Sobol design.
struct Pairs {
  std::size_t parameters;
  std::vector<double> values;  ///< A, B, A with each of B, pair after pair

  std::size_t count() const { return values.size() / sobol_stride(parameters); }
  double a(std::size_t pair) const { return values[pair * sobol_stride(parameters)]; }
  double b(std::size_t pair) const { return values[pair * sobol_stride(parameters) + 1]; }
  double mixed(std::size_t pair, std::size_t d) const { return values[pair * sobol_stride(parameters) + 2 + d]; }
};

struct FirstAndTotal {
  double first, total;
};

/// Source: Saltelli et al., Comput. Phys. Commun. 181 (2010), table 2: first order (b), total (f) of Jansen.
/// @param weight  how often each pair counts
FirstAndTotal indices_of(const Pairs& pairs, std::size_t d, std::span<const unsigned> weight) {
  double n = 0.0, sum = 0.0, squares = 0.0, alone = 0.0, together = 0.0;
  for (std::size_t j = 0; j < pairs.count(); ++j) {
    const double w = weight.empty() ? 1.0 : weight[j], a = pairs.a(j), b = pairs.b(j), m = pairs.mixed(j, d);
    n += w;
    sum += w * (a + b);
    squares += w * (a * a + b * b);
    alone += w * b * (m - a);
    together += w * (a - m) * (a - m);
  }
  const double mean = sum / (2.0 * n), variance = squares / (2.0 * n) - mean * mean;
  return {alone / n / variance, 0.5 * together / n / variance};
}

/// About the mean of all, which the first-order estimate is more certain for.
Pairs complete_pairs(std::vector<double> column, std::size_t parameters, std::size_t& left_out) {
  const auto stride = static_cast<std::ptrdiff_t>(sobol_stride(parameters));
  Pairs pairs{.parameters = parameters, .values = {}};
  for (auto pair = column.begin(); column.end() - pair >= stride; pair += stride) {
    if (std::all_of(pair, pair + stride, [](double x) { return std::isfinite(x); }))
      pairs.values.insert(pairs.values.end(), pair, pair + stride);
    else ++left_out;
  }
  if (pairs.values.empty()) return pairs;
  const double mean = std::reduce(pairs.values.begin(), pairs.values.end()) / static_cast<double>(pairs.values.size());
  for (double& x : pairs.values) x -= mean;
  return pairs;
}

/// Intervals by so many resamplings of the pairs: the 2.5 % on each side are 10 of them.
constexpr std::size_t resamplings = 400;

std::vector<SobolIndex> sobol_of(const Pairs& pairs, std::size_t subject, std::size_t result, std::uint64_t seed) {
  std::vector<SobolIndex> indices;
  const auto n = pairs.count();
  std::vector<std::vector<FirstAndTotal>> resampled(pairs.parameters);
  std::vector<unsigned> weight(n);
  for (std::size_t r = 0; r < resamplings; ++r) {
    std::ranges::fill(weight, 0u);
    for (std::size_t j = 0; j < n; ++j)
      ++weight[std::min(n - 1, static_cast<std::size_t>(unit_draw(seed + 1, r, j) * static_cast<double>(n)))];
    for (std::size_t d = 0; d < pairs.parameters; ++d) resampled[d].push_back(indices_of(pairs, d, weight));
  }
  const auto interval = [&](std::size_t d, double FirstAndTotal::*which) {
    std::vector<double> sorted;
    for (const auto& r : resampled[d]) sorted.push_back(r.*which);
    std::ranges::sort(sorted);
    return std::pair(sorted[resamplings / 40], sorted[resamplings - 1 - resamplings / 40]);
  };
  for (std::size_t d = 0; d < pairs.parameters; ++d) {
    const auto found = indices_of(pairs, d, {});
    const auto [first_low, first_high] = interval(d, &FirstAndTotal::first);
    const auto [total_low, total_high] = interval(d, &FirstAndTotal::total);
    indices.push_back({subject, result, d, found.first, first_low, first_high, found.total, total_low, total_high});
  }
  return indices;
}

}  // namespace

SweepSummary summary_of(const SweepStore& store, const SweepWork& work, unsigned threads) {
  SweepSummary summary;
  const auto columns = work.columns().size(), all = columns * work.subjects().size();
  const bool pairs_wanted = work.plan().design == SweepDesign::sobol;
  summary.columns.resize(all);
  std::vector<std::vector<SobolIndex>> sobol(all);
  std::vector<std::size_t> left_out(all, 0);
  std::mutex reading;
  core::in_parallel(all, threads, [&](std::size_t i) {
    const auto subject = i / columns, column = i % columns;
    std::vector<double> values;
    {
      const std::scoped_lock lock(reading);
      values = store.column(subject, column);
    }
    if (pairs_wanted && column >= work.varied()) {
      const auto pairs = complete_pairs(values, work.varied(), left_out[i]);
      if (pairs.count() > 1) sobol[i] = sobol_of(pairs, subject, column, work.plan().seed);
    }
    summary.columns[i] = summary_of_column(std::move(values), subject, column, subject * work.points());
  });
  for (const auto& some : sobol) summary.sobol.insert(summary.sobol.end(), some.begin(), some.end());
  if (pairs_wanted && !left_out.empty()) summary.pairs_left_out = *std::ranges::max_element(left_out);
  return summary;
}

}  // namespace swayaw::app

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "swayaw/app/sweep/store.hpp"

/// What the results of a sweep come to.
namespace swayaw::app {

inline constexpr std::array<double, 7> summary_quantiles{0.01, 0.05, 0.25, 0.50, 0.75, 0.95, 0.99};

struct ItemValue {
  std::size_t item;
  double value;
};

/// One column of one ship.
struct ColumnSummary {
  std::size_t subject, column;
  std::size_t count = 0, missing = 0;
  double mean = 0.0, standard_deviation = 0.0, low = 0.0, high = 0.0;
  std::array<double, summary_quantiles.size()> quantile{};
  std::vector<std::size_t> histogram{};        ///< from low to high in equal bins
  std::vector<ItemValue> lowest{}, highest{};  ///< a few, the most extreme first
};

/// Share of the variance of a result that a parameter makes, with the 95 % interval of resampled pairs.
struct SobolIndex {
  std::size_t subject, result, parameter;  ///< columns
  double first, first_low, first_high;     ///< alone
  double total, total_low, total_high;     ///< with all that it does together with others
};

struct SweepSummary {
  std::vector<ColumnSummary> columns{};
  std::vector<SobolIndex> sobol{};
  std::size_t pairs_left_out = 0;  ///< of the Sobol design, where an item has no result
};

/// Of the items that are there. Quantiles are those of the values themselves, whatever the number of items.
SweepSummary summary_of(const SweepStore& store, const SweepWork& work, unsigned threads = 0);

}  // namespace swayaw::app

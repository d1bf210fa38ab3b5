#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "../search/search.hpp"

/// How far replays are off, of ships with some effects or others. Not installed.
namespace swayaw::inline mismatch::detail {

/// The ship with these effects at a point, as she is in any run.
ShipInRun ships_at(const Trial& trial, Hypothesis effects, Point point);

/// Nothing where the ship cannot sail the run.
std::vector<QuantityError> errors_of(const Ship& ship, const Recording& run);

std::vector<RunErrors> errors_of(const Ship& before, const ShipInRun& refitted, const ShipInRun& after,
                                 std::span<const Recording> runs);

/// The same errors with another ship at last.
std::vector<RunErrors> with_after(std::vector<RunErrors> errors, const ShipInRun& after,
                                  std::span<const Recording> runs);

/// Mean relative fall of the errors of heading, yaw rate, speed and position over the refitted baseline.
double gain_of(std::span<const RunErrors> runs);

std::optional<Discrepancy> discrepancy_of(std::span<const RunErrors> train, std::span<const RunErrors> holdout,
                                          Quantity quantity = Quantity::yaw_rate);

/// Fall of the errors of replays, mean over runs of their share of the variation, quantity by quantity.
std::map<Quantity, double> falls_of(const ShipInRun& from, const ShipInRun& to,
                                    std::initializer_list<std::span<const Recording>> sets);

/// Whether replays over two ship lengths of heading, yaw rate or speed differ in some run by more than this share of
/// the variation of the quantity, root mean square.
bool differ_by_more(double share, const ShipInRun& one, const ShipInRun& other,
                    std::initializer_list<std::span<const Recording>> sets);

}  // namespace swayaw::mismatch::detail

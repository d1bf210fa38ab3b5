#pragma once

#include <span>
#include <vector>

#include "../search/search.hpp"

/// What a fit tells of effects, of wind and stream, and of instruments, with standard errors. Not installed.
namespace swayaw::inline mismatch::detail {

/// Parameters of an effect in a part of the runs. To the scatter of the fit, as wide as evidence is in excess, comes
/// what the law of the effect is worth, and the ordinary error that is in it where it stands in the place of one.
/// @param widening  of the deviation of each coordinate, or nothing
std::vector<ParameterEstimate> estimates(const Trial& trial, const EffectForm& form,
                                         const std::vector<double>& widening, const MapFit& found, Eigen::Index from,
                                         const Eigen::MatrixXd& part);

FoundEffect found_effect(const Trial& trial, const Accepted& accepted, const MapFit& now, Eigen::Index from);

/// Wind or stream as it is in each part of the runs.
std::vector<SurroundingsEstimate> surroundings_of(const Trial& trial, const Accepted& accepted, const MapFit& found,
                                                  Eigen::Index from, std::span<const Recording> runs);

/// Where no wind or stream was found: why one cannot be told, or how much of it, and what would tell it.
void put_untold_surroundings(Diagnosis& d, const Trial& trial, const Search& s, std::span<const Recording> runs,
                             std::span<const EffectForm> forms, double needed);

/// Those of more than two standard errors.
std::vector<InstrumentEstimate> instruments_of(const Trial& trial, const Search& s);

/// Those that an effect which was found is.
std::vector<InstrumentEstimate> instruments_in(const FoundEffect& found, const Ship& ship);

std::vector<MismatchPlace> places_of(const Effect& sensor, std::span<const Recording> runs);

}  // namespace swayaw::mismatch::detail

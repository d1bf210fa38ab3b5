#pragma once

#include "search.hpp"

/// Fits of what is accepted so far: the baseline, its form, its noise. Not installed.
namespace swayaw::inline mismatch::detail {

/// The form takes these sizes, and all is fitted once more beside it.
void fit_form(Search& s, const FormSizes& sizes);

/// The likelihood has several summits by sizes of noise: a motion is process noise or an error of positions. From the
/// sizes with which a search begins another may be reached, and if that is likelier, all is fitted once more from
/// there: a ship in a stream with a gyro that is off stood 230 in log evidence too low, and the stream could not be
/// told.
void stand_on_highest_summit(Search& s);

/// The baseline alone, fitted.
/// @param begun  where its fit goes on, if it has begun
Search with_baseline(const Trial& trial, const Noise& start, const MapFit& begun = {});

}  // namespace swayaw::mismatch::detail

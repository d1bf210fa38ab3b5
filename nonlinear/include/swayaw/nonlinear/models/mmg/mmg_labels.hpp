#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "swayaw/nonlinear/models/mmg/mmg_ship.hpp"

/// Hull derivatives that a source prints under other names than their own.
namespace swayaw::inline nonlinear {

/// A name in the table of a source, and the derivative whose number stands there.
struct PermutedLabel {
  std::string_view printed;
  std::string_view meant;
};

/// Table 3 of [Kulbiej2021]. Its second column gives the formulas of [Yoshimura2012] for L = 60, B = 10.5, d = 3.15 m
/// and C_B = 0.59 to the printed digit, five of them under these names; with the names as printed neither set turns or
/// zigzags.
inline constexpr std::array<PermutedLabel, 5> kulbiej2021_labels{{
    {"Y_vvr", "Y_rrr"},
    {"Y_rrr", "Y_vvr"},
    {"N_vvr", "N_rrr"},
    {"N_vrr", "N_vvr"},
    {"N_rrr", "N_vrr"},
}};

/// The derivative that a ship file with `labels = "kulbiej2021"` means by that key.
constexpr std::string_view meant_by(std::string_view key) {
  const auto* found = std::ranges::find(kulbiej2021_labels, key, &PermutedLabel::printed);
  return found == kulbiej2021_labels.end() ? key : found->meant;
}

/// The number of the hull with that key.
template <class S>
S MmgHull<S>::*hull_number(std::string_view key) {
  static constexpr auto list = MmgHull<S>::parameters();
  return std::ranges::find(list, key, &ParameterOf<MmgHull<S>, S>::key)->member;
}

/// The hull with every number under its own name, and `labels` back to "standard".
template <class S>
MmgHull<S> relabelled(const MmgHull<S>& hull) {
  MmgHull<S> result = hull;
  result.labels = {};
  if (hull.labels.index == 0) return result;
  for (const auto& [printed, meant] : kulbiej2021_labels) result.*hull_number<S>(meant) = hull.*hull_number<S>(printed);
  return result;
}

}  // namespace swayaw::nonlinear

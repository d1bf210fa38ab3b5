#pragma once

#include <array>
#include <cstddef>

/// The classical Runge–Kutta step, for every stepper of fixed steps.
namespace swayaw::inline nonlinear {

/// A state some time along its rates.
template <class S, std::size_t N, class T>
std::array<S, N> along(const std::array<S, N>& s, const T& h, const std::array<S, N>& rate) {
  std::array<S, N> there;
  for (std::size_t i = 0; i < N; ++i) there[i] = s[i] + h * rate[i];
  return there;
}

/// x⁺ = x + h/6 (k₁ + 2 k₂ + 2 k₃ + k₄). `begin`, `middle` and `end` give the rates there.
template <class S, std::size_t N, class T, class Begin, class Middle, class End>
std::array<S, N> runge_kutta_step(const std::array<S, N>& s, const T& h, Begin&& begin, Middle&& middle, End&& end) {
  const auto k1 = begin(s);
  const auto k2 = middle(along(s, T(0.5 * h), k1));
  const auto k3 = middle(along(s, T(0.5 * h), k2));
  const auto k4 = end(along(s, h, k3));
  std::array<S, N> next;
  const T sixth = h / 6.0;
  for (std::size_t i = 0; i < N; ++i) next[i] = s[i] + sixth * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
  return next;
}

}  // namespace swayaw::nonlinear

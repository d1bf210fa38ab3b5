#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "swayaw/core/scalar.hpp"

/// Derivatives of a few results by very many numbers: a scalar that writes down how it came about, in reverse mode.
/// Not installed.
namespace swayaw::inline identification::detail {

/// What was computed, step by step: each result by at most two others, with its derivatives by them.
///
/// Places 1 … variables are the variables. Place 0 is of all that depends on none of them, and of it nothing is kept.
/// Source: [Griewank2008]
class Tape {
 public:
  using Place = std::int32_t;

  /// Derivatives of four results.
  using Slopes = std::array<double, 4>;

  /// The tape that this thread writes on.
  static inline constinit thread_local Tape* now = nullptr;

  /// Only the variables.
  void restart(Place variables) {
    variables_ = next_ = variables;
    if (const auto least = static_cast<std::size_t>(next_) + 1; results_.size() < least) make_room(least);
  }

  /// A result with its derivatives by two others.
  Place put(Place p, double by_p, Place q = 0, double by_q = 0.0) {
    if (static_cast<std::size_t>(++next_) >= results_.size()) make_room(2 * results_.size());
    results_[static_cast<std::size_t>(next_)] = {p, q, by_p, by_q};
    return next_;
  }

  /// Derivatives of four results by each variable, which are at their places; from the last step back to the first
  /// that matters, with the adjoint g of each,
  ///
  ///     g_p += g ∂(result)/∂p,   g_q += g ∂(result)/∂q
  const std::vector<Slopes>& slopes(const std::array<Place, 4>& of) {
    for (Place i = 0; i <= variables_; ++i) adjoint_[static_cast<std::size_t>(i)] = {};
    Place first = 0, last = next_ + 1;
    for (std::size_t k = 0; k < of.size(); ++k) {
      if (of[k] == 0) continue;
      adjoint_[static_cast<std::size_t>(of[k])][k] += 1.0;
      first = std::max(first, of[k]);
      if (of[k] > variables_) last = std::min(last, of[k]);
    }
    for (Place i = first; i >= last; --i) {
      const auto& [p, q, by_p, by_q] = results_[static_cast<std::size_t>(i)];
      const auto g = std::exchange(adjoint_[static_cast<std::size_t>(i)], Slopes{});
      auto& g_p = adjoint_[static_cast<std::size_t>(p)];
      for (std::size_t k = 0; k < g.size(); ++k) g_p[k] += g[k] * by_p;
      if (p > variables_) last = std::min(last, p);
      if (q == 0) continue;
      auto& g_q = adjoint_[static_cast<std::size_t>(q)];
      for (std::size_t k = 0; k < g.size(); ++k) g_q[k] += g[k] * by_q;
      if (q > variables_) last = std::min(last, q);
    }
    return adjoint_;
  }

 private:
  struct Result {
    Place p, q;
    double by_p, by_q;
  };

  void make_room(std::size_t size) { results_.resize(size), adjoint_.resize(size); }

  std::vector<Result> results_ = std::vector<Result>(1024);
  std::vector<Slopes> adjoint_ = std::vector<Slopes>(1024);  ///< zero but while slopes are worked out
  Place variables_ = 0, next_ = 0;
};

// ---------------------------------------------------------------- numbers of a ship

/// The numbers of whatever is cast to Numbered in its scope, in the order in which the cast comes to them.
class Numbering {
 public:
  static inline constinit thread_local Numbering* now = nullptr;

  /// @param place  of each number on a tape; 0 for all where there are none
  explicit Numbering(std::vector<Tape::Place> place = {}) : place_(std::move(place)), before_(now) { now = this; }
  Numbering(const Numbering&) = delete;
  Numbering& operator=(const Numbering&) = delete;
  ~Numbering() { now = before_; }

  Tape::Place take(double value) {
    values_.push_back(value);
    return values_.size() <= place_.size() ? place_[values_.size() - 1] : 0;
  }

  const std::vector<double>& values() const { return values_; }

 private:
  std::vector<Tape::Place> place_;
  std::vector<double> values_;
  Numbering* before_;
};

/// A number that is counted; a scalar to be cast to, not to compute with.
struct Numbered {
  double a = 0.0;
  Tape::Place place = 0;

  Numbered() = default;
  explicit Numbered(double value) : a(value), place(Numbering::now->take(value)) {}
};

// ---------------------------------------------------------------- scalar

/// A number with its place on the tape.
struct Taped {
  double a = 0.0;
  Tape::Place place = 0;

  Taped() = default;
  Taped(double value) : a(value) {}  // NOLINT: a number is a constant
  explicit Taped(const Numbered& number) : a(number.a), place(number.place) {}
  Taped(double value, Tape::Place at) : a(value), place(at) {}

  /// f(x) with its derivative.
  static Taped of(double value, const Taped& x, double by_x) {
    return {value, x.place == 0 ? 0 : Tape::now->put(x.place, by_x)};
  }

  /// f(x, y) with its derivatives.
  static Taped of(double value, const Taped& x, double by_x, const Taped& y, double by_y) {
    if (y.place == 0) return of(value, x, by_x);
    if (x.place == 0) return of(value, y, by_y);
    return {value, Tape::now->put(x.place, by_x, y.place, by_y)};
  }

  friend Taped operator+(const Taped& x, const Taped& y) {
    if (y.place == 0) return {x.a + y.a, x.place};
    if (x.place == 0) return {x.a + y.a, y.place};
    return {x.a + y.a, Tape::now->put(x.place, 1.0, y.place, 1.0)};
  }
  friend Taped operator-(const Taped& x, const Taped& y) {
    if (y.place == 0) return {x.a - y.a, x.place};
    return of(x.a - y.a, x, 1.0, y, -1.0);
  }
  friend Taped operator*(const Taped& x, const Taped& y) { return of(x.a * y.a, x, y.a, y, x.a); }
  friend Taped operator/(const Taped& x, const Taped& y) {
    const double over = 1.0 / y.a, value = x.a / y.a;
    return of(value, x, over, y, -value * over);
  }
  friend Taped operator-(const Taped& x) { return of(-x.a, x, -1.0); }

  friend bool operator<(const Taped& x, const Taped& y) { return x.a < y.a; }
  friend bool operator>(const Taped& x, const Taped& y) { return x.a > y.a; }
  friend bool operator<=(const Taped& x, const Taped& y) { return x.a <= y.a; }
  friend bool operator>=(const Taped& x, const Taped& y) { return x.a >= y.a; }
  friend bool operator==(const Taped& x, const Taped& y) { return x.a == y.a; }

  friend Taped sqrt(const Taped& x) {
    const double root = std::sqrt(x.a);
    return of(root, x, 0.5 / root);
  }
  friend Taped sin(const Taped& x) { return of(std::sin(x.a), x, std::cos(x.a)); }
  friend Taped cos(const Taped& x) { return of(std::cos(x.a), x, -std::sin(x.a)); }
  friend Taped exp(const Taped& x) {
    const double value = std::exp(x.a);
    return of(value, x, value);
  }
  friend Taped log(const Taped& x) { return of(std::log(x.a), x, 1.0 / x.a); }
  friend Taped atan(const Taped& x) { return of(std::atan(x.a), x, 1.0 / (1.0 + x.a * x.a)); }
  friend Taped atan2(const Taped& y, const Taped& x) {
    const double over = 1.0 / (x.a * x.a + y.a * y.a);
    return of(std::atan2(y.a, x.a), y, x.a * over, x, -y.a * over);
  }
  friend Taped hypot(const Taped& x, const Taped& y) {
    const double value = std::hypot(x.a, y.a);
    return of(value, x, x.a / value, y, y.a / value);
  }
  friend Taped abs(const Taped& x) { return x.a < 0.0 ? -x : x; }
};

}  // namespace swayaw::identification::detail

namespace swayaw::inline core {

/// Sine and cosine have each other for derivatives.
template <>
struct Elementary<identification::detail::Taped> {
  using S = identification::detail::Taped;
  static SinCos<S> sin_cos(const S& x) {
    const double s = std::sin(x.a), c = std::cos(x.a);
    return {S::of(s, x, c), S::of(c, x, -s)};
  }
  static S decay(const S& x) { return exp(-x); }
  static S angle_of(const S& y, const S& x) { return atan2(y, x); }
};

}  // namespace swayaw::core

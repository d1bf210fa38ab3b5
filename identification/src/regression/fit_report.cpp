#include "swayaw/identification/fit_report.hpp"

#include <cmath>

namespace swayaw::inline identification {

std::string_view in_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::determined: return "determined";
    case Verdict::weakly_determined: return "weakly determined";
    case Verdict::not_determined: return "not determined";
  }
  return "";
}

Verdict Estimate::verdict() const {
  const double size = std::abs(value) / standard_error;
  return size >= 10.0 ? Verdict::determined : size >= 2.0 ? Verdict::weakly_determined : Verdict::not_determined;
}

std::string_view in_words(FitStatus status) {
  switch (status) {
    case FitStatus::converged: return "converged";
    case FitStatus::iteration_limit: return "iteration limit";
    case FitStatus::rank_deficient: return "rank deficient";
  }
  return "";
}

}  // namespace swayaw::identification

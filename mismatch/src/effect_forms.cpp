#include "effect_forms.hpp"

#include <algorithm>
#include <cmath>

#include "swayaw/core/angle.hpp"

namespace swayaw::inline mismatch::detail {
namespace {

/// The form of one kind as that of an effect.
template <class Kind>
EffectForm as_effect(SearchForm<Kind> form) {
  EffectForm result{.id = std::move(form.id),
                    .coordinates = std::move(form.coordinates),
                    .at = [at = std::move(form.at)](std::span<const double> c) { return Effect(at(c)); },
                    .starts = std::move(form.starts)};
  if (form.with_terms)
    result.with_terms = [with_terms = std::move(form.with_terms)](std::span<const std::size_t> kept) {
      return as_effect(with_terms(kept));
    };
  return result;
}

/// The form that the kind tells, or the usual one.
template <class Kind>
EffectForm form_of(const Kind& null, const SearchContext& context) {
  if constexpr (requires { search_form(null, context); }) return as_effect(search_form(null, context));
  else return as_effect(usual_form(null, context));
}

/// One of each channel: of the rudder, and of those seen, where a position has one receiver.
template <class Kind>
void add_forms_by_channel(std::vector<EffectForm>& forms, Kind null, const SearchContext& context,
                          std::span<const Channel> channels) {
  std::vector<Channel> all{Channel::delta};
  std::ranges::copy_if(channels, std::back_inserter(all), [](Channel c) { return c != Channel::y; });
  for (const auto channel : all) {
    null.channel = channel;
    forms.push_back(form_of(null, context));
  }
}

}  // namespace

std::optional<EffectForm> ordinary_lift_loss(const Ship& ship) {
  const auto parameters = parameters_of(ship, RudderGap<>{});
  const auto s = std::ranges::find(parameters, "s", &Parameter::key);
  if (s == parameters.end() || s->null != 0.0) return std::nullopt;
  return as_effect(usual_lift_loss());
}

Eigen::MatrixXd parameter_slopes(const Ship& ship, const EffectForm& form, const Eigen::VectorXd& c) {
  constexpr double step = 1e-4;
  const auto size = c.size();
  const auto parameters_at = [&](const Eigen::VectorXd& p) {
    return parameters_of(ship, form.at({p.data(), static_cast<std::size_t>(size)}));
  };
  Eigen::MatrixXd slopes(std::ssize(parameters_at(c)), size);
  for (Eigen::Index k = 0; k < size; ++k) {
    Eigen::VectorXd up = c, down = c;
    up[k] += step, down[k] -= step;
    const auto a = parameters_at(up), b = parameters_at(down);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double change = a[i].value - b[i].value;
      slopes(static_cast<Eigen::Index>(i), k) = (a[i].direction ? wrapped(change) : change) / (2.0 * step);
    }
  }
  return slopes;
}

EffectForm unknown_map(const Ship& ship) {
  const UnknownForce<> null;
  auto terms = parameters_of(ship, null);
  std::erase_if(terms, [](const Parameter& p) { return !p.decides; });
  return as_effect(by_parameters(null, std::span<const Parameter>(terms)));
}

std::vector<EffectForm> effect_forms(const Ship& ship, std::span<const Channel> channels, double duration) {
  std::vector<EffectForm> forms;
  for_each_kind([&]<class Kind>() {
    const Kind null{};
    const auto parameters = parameters_of(ship, null);
    if (parameters.empty()) return;
    const SearchContext context{.parameters = parameters,
                                .time_unit = length(ship) / service_speed(ship),
                                .duration = duration,
                                .rudder_rate = steering_gear(ship).rate};
    if constexpr (requires { null.channel; }) add_forms_by_channel(forms, null, context, channels);
    else forms.push_back(form_of(null, context));
  });
  return forms;
}

bool is_finding(const Ship& ship, const Effect& effect) {
  const auto parameters = parameters_of(ship, effect);
  return !parameters.empty() && !is_ordinary(effect, parameters) &&
         std::ranges::any_of(parameters,
                             [](const Parameter& p) { return p.decides && !(std::abs(p.value - p.null) <= p.floor); });
}

}  // namespace swayaw::mismatch::detail

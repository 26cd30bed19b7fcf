#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// A second machine part warms up with another time constant. The displacement also follows the
/// input of a channel with a second gain and a second first-order lag.
struct SecondTimeConstant final : EffectKind {
  static constexpr EffectCard second_card{
      .id = "second-time-constant",
      .title = "a second part that warms up more slowly than the first",
      .form = "+ K/(1 + tau s) u on a channel",
      .needs = "transients longer than three times the fast time constant",
      .confused = "sensor-lag, kinematic-displacement (fast), slow-drift (slow)",
      .numbers = gain_and_time_constant,
      .at_channel = true};

  [[nodiscard]] const EffectCard& card() const override { return second_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<Effect> list;
    for (const DrivenChannel& c : in.model.channels)
      if (!c.sections.empty()) list.push_back(at(in.where(c)));
    return list;
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    return lag_of_input(*this, e, m);
  }
};

}  // namespace raceway::correction

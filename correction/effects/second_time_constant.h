#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// A second part of the machine warms up with another time constant. The channel that describes the
/// first part therefore gets a second first-order lag of the same input, with its own gain.
struct SecondTimeConstant final : EffectKind {
  static constexpr EffectCard second_card{
      .id = "second-time-constant",
      .title = "a second part of the machine has another time constant",
      .form =
          "+ K/(1 + tau s) u (u: input of a channel, K: gain, tau: time constant, s: Laplace "
          "variable)",
      .needs = "transients longer than three times the shorter of the two time constants",
      .confused =
          "sensor-lag; kinematic-displacement if the second lag is fast; slow-drift if the "
          "second lag is slow",
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

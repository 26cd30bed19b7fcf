#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The time constant of the machine during cool-down differs from the time constant during warm-up.
/// The time constant τ of a lag is multiplied by a ratio while the input u of the lag is below its
/// state x.
struct ThermalAsymmetry final : EffectKind {
  static constexpr record::NumberCard ratio{"ratio", "1", 1.0, 0.2, 5.0, 0.2, 5.0, 1.0};
  static constexpr std::array one{ratio};
  static constexpr EffectCard asymmetry_card{
      .id = "thermal-asymmetry",
      .title = "the machine cools more slowly or faster than it warms up",
      .form =
          "tau is multiplied by the parameter ratio while the part cools (input u below the state "
          "x of the lag)",
      .needs = "steps down from one speed to a lower speed above zero",
      .confused = "speed-dependent-time-constant",
      .numbers = one,
      .of_channel = true,
      .at_channel = true};

  [[nodiscard]] const EffectCard& card() const override { return asymmetry_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    if (!in.first_channel_lags()) return {};
    return {at()};
  }

  void change(const Effect& e, const Model&, Answer& answer) const override {
    answer.falling = value_of(e, ratio);
  }
};

}  // namespace raceway::correction

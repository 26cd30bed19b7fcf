#pragma once

#include "correction/effect_kind.h"
#include "correction/range.h"

namespace raceway::correction {

/// The time constant τ and the gain K of a channel's lags decrease with the speed n:
///
///   τ = τ0 f,  K = K0 f^g,  f = 1/(1 + s n/10 000 rpm)
///
/// τ0 and K0 are the values at standstill, and s and g are the parameters of the effect.
struct SpeedDependentTimeConstant final : EffectKind {
  static constexpr record::NumberCard s{"s", "1", 0.0, 0.0, 6.0, 0.0, 6.0, 0.0};
  static constexpr record::NumberCard g{"g", "1", 1.0, 0.0, 1.5, 0.0, 1.5, unset};
  static constexpr std::array both{s, g};
  static constexpr EffectCard speed_card{
      .id = "speed-dependent-time-constant",
      .title = "the machine warms up faster at higher speed",
      .form =
          "tau = tau0 f, K = K0 f^g, f = 1/(1 + s n/10 000 rpm) (n: speed, tau0 and K0: time "
          "constant and gain of the lag at standstill)",
      .needs = "several speeds and phases of cooling",
      .confused = "thermal-asymmetry, motor-heat",
      .numbers = both,
      .of_channel = true,
      .at_channel = true};

  [[nodiscard]] const EffectCard& card() const override { return speed_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    if (!in.varies(record::speed) || !in.first_channel_lags()) return {};
    return {at()};
  }
  [[nodiscard]] std::vector<const Channel*> other_columns(const Effect&) const override {
    return {&record::speed};
  }

  void change(const Effect& e, const Model& m, Answer& answer) const override {
    answer.speed_factor = value_of(e, s);
    answer.gain_power = value_of(e, g);
    answer.speed = seen_speed(m);
  }
};

}  // namespace raceway::correction

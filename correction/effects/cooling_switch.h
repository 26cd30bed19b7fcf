#pragma once

#include "correction/effect_kind.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// While the coolant is off, the gains of a channel's lags are multiplied by the parameter
/// gain_ratio, and their time constants by the parameter time_constant_ratio.
struct CoolingSwitch final : EffectKind {
  static constexpr record::NumberCard gain_ratio{"gain_ratio", "1", 1.0, 0.1, 10, 0.1, 10, 1.0};
  static constexpr record::NumberCard time_ratio{
      "time_constant_ratio", "1", 1.0, 0.1, 10, 0.1, 10, 1.0};
  static constexpr std::array both{gain_ratio, time_ratio};
  static constexpr EffectCard cooling_card{
      .id = "cooling-switch",
      .title = "gain and time constant change while the coolant is off",
      .form =
          "dx/dt = (K u - x)/tau (u: input, x: state of the lag); while coolant_on = 0, K is "
          "multiplied by gain_ratio and tau by time_constant_ratio",
      .needs = "a column coolant_on that changes between 0 and 1",
      .confused = "motor-heat, thermal-asymmetry",
      .numbers = both,
      .of_channel = true,
      .at_channel = true};

  [[nodiscard]] const EffectCard& card() const override { return cooling_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    if (!in.varies(*coolant()) || !in.first_channel_lags()) return {};
    return {at()};
  }
  [[nodiscard]] std::vector<const Channel*> other_columns(const Effect&) const override {
    return {coolant()};
  }

  void change(const Effect& e, const Model&, Answer& answer) const override {
    answer.off_gain = value_of(e, gain_ratio);
    answer.off_time_constant = value_of(e, time_ratio);
  }

 private:
  static const Channel* coolant() { return record::series_channel("coolant_on"); }
};

}  // namespace raceway::correction

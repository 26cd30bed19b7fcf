#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The reading of a temperature sensor lags behind the temperature. The input of the channel is
/// therefore (1 + τ s) T, with the reading T, the time constant τ of the sensor and the Laplace
/// variable s.
struct SensorLag final : EffectKind {
  static constexpr record::NumberCard lag{
      "sensor_time_constant_s", "s", 0.0, 0.0, 3600, 0.0, 3600, 0.0};
  static constexpr std::array one{lag};
  static constexpr EffectCard sensor_card{
      .id = "sensor-lag",
      .title = "the sensor reading follows the true temperature with a lag",
      .form =
          "the input of the channel is (1 + tau_s s) T (T: sensor reading, tau_s: time constant "
          "of the sensor, s: Laplace variable)",
      .needs = "a temperature as input",
      .confused = "second-time-constant, which looks nearly the same",
      .numbers = one,
      .of_channel = true,
      .at_channel = true};

  [[nodiscard]] const EffectCard& card() const override { return sensor_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<Effect> list;
    for (const DrivenChannel& c : in.model.channels)
      if (!c.sections.empty() && !c.input.is_power() && c.feedthrough == 0.0 &&
          c.input.course() == record::Course::straight)
        list.push_back(at(in.where(c)));
    return list;
  }

  void change(const Effect& e, const Model&, Answer& answer) const override {
    answer.sensor_time_constant = value_of(e, lag);
  }
};

}  // namespace raceway::correction

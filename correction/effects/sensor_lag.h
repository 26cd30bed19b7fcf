#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The reading of a temperature sensor lags behind the temperature. The channel therefore has the
/// input T (1 + τ s), with the reading T, the time constant τ of the sensor and the Laplace
/// variable s.
struct SensorLag final : EffectKind {
  static constexpr record::NumberCard lag{
      "sensor_time_constant_s", "s", 0.0, 0.0, 3600, 0.0, 3600, 0.0};
  static constexpr std::array one{lag};
  static constexpr EffectCard sensor_card{
      .id = "sensor-lag",
      .title = "the sensor follows its temperature with a lag",
      .form = "the input is (1 + tau_s s) T, with the sensor time constant tau_s",
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

#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// The heat of a motor moves the machine. The displacement follows the motor temperature with a
/// gain and a first-order lag. The effect does not use motor temperatures that are already inputs
/// of the model. If the record has no other motor temperature, the input of the lag is exp(-n/n0)
/// while the spindle turns at the speed n, and 0 at standstill. n0 is the parameter
/// decay_speed_rpm.
struct MotorHeat final : EffectKind {
  static constexpr record::NumberCard decay_speed{
      "decay_speed_rpm", "rpm", 2000, 300, 8000, 300, 8000, unset};
  static constexpr std::array all{gain_number, time_constant_number, decay_speed};
  static constexpr EffectCard motor_card{
      .id = "motor-heat",
      .title = "the heat of a motor moves the machine",
      .form =
          "+ K/(1 + tau s) u (K: gain, tau: time constant, s: Laplace variable). u is the motor "
          "temperature. If no motor temperature is available, u is exp(-n/n0) while the spindle "
          "turns at the speed n, with n0 = decay_speed_rpm",
      .needs = "a temperature of the motor, or speeds that change",
      .confused =
          "speed-dependent-time-constant; a machine part that warms up together with the motor",
      .numbers = all};

  [[nodiscard]] const EffectCard& card() const override { return motor_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<const Channel*> columns = in.unused(is_of_motor);
    if (columns.empty() && !in.varies(record::speed)) return {};
    return {at({}, std::move(columns))};
  }
  [[nodiscard]] std::span<const record::NumberCard> numbers(const Effect& e) const override {
    return std::span(all).first(e.columns.empty() ? 3 : 2);
  }
  [[nodiscard]] Input input(const Effect& e, const Model& m) const override {
    return e.columns.empty() ? Input{} : EffectKind::input(e, m);
  }
  [[nodiscard]] std::vector<const Channel*> other_columns(const Effect& e) const override {
    if (e.columns.empty()) return {&record::speed};
    return {};
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    if (!e.columns.empty()) return lag_of_input(*this, e, m);
    return MotorShare{value_of(e, gain_number), value_of(e, time_constant_number),
                      value_of(e, decay_speed)};
  }

 private:
  static bool is_of_motor(const Channel& c) {
    return record::is_temperature(c) && c.variable.starts_with("motor");
  }
};

}  // namespace raceway::correction

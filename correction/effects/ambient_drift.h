#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// The ambient temperature moves the machine. The displacement follows the mean of the recorded
/// ambient temperatures with a gain and a first-order lag. If no ambient temperature is available,
/// the mean temperature of the machine base is used instead. Temperatures that are already inputs
/// of the model are left out.
struct AmbientDrift final : EffectKind {
  static constexpr EffectCard ambient_card{
      .id = "ambient-drift",
      .title = "the room temperature moves the machine",
      .form =
          "+ K/(1 + tau s) u (u: mean of the room temperatures, K: gain, tau: time constant, s: "
          "Laplace variable)",
      .needs = "a temperature of the room or of the machine base that the model does not use",
      .confused = "slow-drift, a slow lag of another input, the temperature of the motor",
      .numbers = gain_and_time_constant,
      .needs_input = true};

  [[nodiscard]] const EffectCard& card() const override { return ambient_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<const Channel*> columns = in.unused(record::is_ambient);
    if (columns.empty()) columns = in.unused(is_of_base);
    if (columns.empty()) return {};
    return {at({}, std::move(columns))};
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    return lag_of_input(*this, e, m);
  }

 private:
  static bool is_of_base(const Channel& c) {
    return record::is_temperature(c) && c.variable.starts_with("base");
  }
};

}  // namespace raceway::correction

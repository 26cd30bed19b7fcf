#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The predicted displacement has steps, because it responds instantly to each change in the last
/// digit of a temperature sensor (feedthrough). At such a change, the residual (reading minus
/// prediction) has a step in the opposite direction. faults() computes the ratio of the residual
/// step to the predicted step, as the mean over at least 30 changes. The effect is reported if this
/// ratio exceeds 0.4 and also exceeds 8 times its standard error. In addition, the rounding error
/// of the sensor must explain at least 40 % of the variance of the residual.
struct SensorQuantisation final : EffectKind {
  static constexpr EffectCard quantisation_card{
      .id = "sensor-quantisation",
      .title = "the predicted displacement steps with the last digit of a sensor",
      .form =
          "the predicted displacement steps by K0 q (K0: feedthrough of the channel, q: "
          "resolution of the sensor)",
      .needs =
          "a channel with a feedthrough, and a sensor whose resolution is visible in the record",
      .confused = "second-time-constant",
      .numbers = {},
      .of_reading = true,
      .evidence = true};

  [[nodiscard]] const EffectCard& card() const override { return quantisation_card; }
  [[nodiscard]] std::vector<fit::Fault> faults(const FittedRecord& in) const override;
};

}  // namespace raceway::correction

#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The predicted displacement has steps, because a feedthrough passes on each change in the last
/// digit of a temperature sensor. faults() reports this effect if reading minus prediction steps by
/// more than 0.4 of the predicted step, in the opposite direction. The ratio of the two steps is
/// the mean over 30 or more changes and must exceed 8 standard errors. The rounding error of the
/// sensor must also explain at least 40 % of the variance of the residual.
struct SensorQuantisation final : EffectKind {
  static constexpr EffectCard quantisation_card{
      .id = "sensor-quantisation",
      .title = "the predicted displacement steps with the last digit of a sensor",
      .form = "y steps by K0 q, with a feedthrough K0 and a quantum q",
      .needs = "a feedthrough, and a quantum that the record shows",
      .confused = "second-time-constant",
      .numbers = {},
      .of_reading = true,
      .evidence = true};

  [[nodiscard]] const EffectCard& card() const override { return quantisation_card; }
  [[nodiscard]] std::vector<fit::Fault> faults(const FittedRecord& in) const override;
};

}  // namespace raceway::correction

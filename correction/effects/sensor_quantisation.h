#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// The displacement steps with the last digit of a sensor. The record itself shows this effect: at
/// each change of that digit, the residual steps back by at most the amount that the feedthrough
/// explains.
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

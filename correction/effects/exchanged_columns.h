#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// Two temperature columns are swapped, because two plugs or two column headers were exchanged.
/// faults() returns a possible fault for each pair of temperatures if at least one of the two is an
/// input of the model. Each fault contains a corrected record, in which the two columns are swapped
/// back. The function does not consider columns with jumps, or pairs whose mean is the input of a
/// channel.
struct ExchangedColumns final : EffectKind {
  static constexpr EffectCard exchanged_card{
      .id = "exchanged-columns",
      .title = "the columns of two temperatures are swapped",
      .form = "T1 is read from column T2, and T2 from column T1",
      .needs = "two temperatures that vary; the model uses at least one of them",
      .confused = "motor-heat and other effects that use a swapped column",
      .numbers = {},
      .of_reading = true,
      .evidence = true};

  [[nodiscard]] const EffectCard& card() const override { return exchanged_card; }
  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override;
  [[nodiscard]] std::vector<fit::Fault> faults(const FittedRecord& in) const override;
};

}  // namespace raceway::correction

#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// A temperature sensor was loose for some time, and measured only a fraction of the temperature
/// rise above ambient. The loose period begins and ends with a jump of the reading. If the reading
/// has only one clear jump, the time of the other jump is unknown. faults() then returns up to six
/// possible faults with different times of the other jump. The possible times are small jumps that
/// give about the same fraction as the clear jump, times at which the reading is close to ambient,
/// and the start or the end of the record. Only records with one run are examined.
struct LooseSensor final : EffectKind {
  static constexpr EffectCard loose_card{
      .id = "loose-sensor",
      .title = "a temperature sensor was loose for a while",
      .form =
          "between two times, T_read = T_room + share (T - T_room) (T_read: reading, T: true "
          "temperature)",
      .needs = "a temperature of the model that jumps towards the room temperature and back",
      .confused = "a body that cools quickly; offset-jump",
      .numbers = {},
      .of_reading = true,
      .evidence = true};

  [[nodiscard]] const EffectCard& card() const override { return loose_card; }
  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override;
  [[nodiscard]] std::vector<fit::Fault> faults(const FittedRecord& in) const override;
};

}  // namespace raceway::correction

#pragma once

#include "correction/effect_kind.h"

namespace raceway::correction {

/// A temperature sensor came loose for some time: it measured only a share of the rise above
/// ambient. The fault begins and ends with a jump of the reading. If one of the two jumps is
/// missing, several times are tried for this jump: times at which the reading is close to ambient,
/// and the end of the record on that side. Only records with one run are examined.
struct LooseSensor final : EffectKind {
  static constexpr EffectCard loose_card{
      .id = "loose-sensor",
      .title = "a temperature sensor was loose for a while",
      .form = "between two times, T_read = T_room + share (T - T_room)",
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

#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// The shaft moves instantly when the speed n changes: u = A n^(1 - B exp(-C n)) with the
/// parameters A, B and C, see shaft/kinematic_law.h.
struct KinematicDisplacement final : EffectKind {
  static constexpr record::NumberCard A{"A", "um", 0.0, -any_size, any_size};
  static constexpr record::NumberCard B{"B", "1", 0.7, 0.0, 1.2, 0.0, 1.2, unset};
  static constexpr record::NumberCard C{"C", "1/rpm", 5e-4, 1e-4, 3e-3, 1e-4, 3e-3, unset};
  static constexpr std::array law{A, B, C};
  static constexpr EffectCard kinematic_card{
      .id = "kinematic-displacement",
      .title = "the shaft moves immediately with speed",
      .form = "+ A n^(1 - B exp(-C n)) (n: spindle speed in rpm)",
      .needs = "readings at several speeds above 0",
      .confused = "a lag with a time constant below 3 min; offset-jump at a change of speed",
      .numbers = law};

  [[nodiscard]] const EffectCard& card() const override { return kinematic_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    if (!in.varies(record::speed) || in.model.kinematic) return {};
    return {at()};
  }
  [[nodiscard]] std::string key(const Effect&, std::size_t number, const Model&) const override {
    return std::string(law[number].name);
  }
  [[nodiscard]] std::vector<const Channel*> other_columns(const Effect&) const override {
    return {&record::speed};
  }

  [[nodiscard]] Share share(const Effect& e, const Model&) const override {
    return Kinematic{value_of(e, A), value_of(e, B), value_of(e, C)};
  }
};

}  // namespace raceway::correction

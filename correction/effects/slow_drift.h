#pragma once

#include <cmath>

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// A part of the machine that warms up slowly has no sensor, and its temperature changes during the
/// whole record. The displacement is c (1 - exp(-t/τ)). c is the final displacement, τ the time
/// constant, and t the time since the start of the record, without the breaks between runs.
struct SlowDrift final : EffectKind {
  static constexpr record::NumberCard size{"size", "um", 0.0, -any_size, any_size};
  static constexpr std::array both{size, time_constant_number};
  static constexpr EffectCard drift_card{
      .id = "slow-drift",
      .title =
          "a slow part of the machine without a sensor warms up or cools down over the whole "
          "record",
      .form =
          "+ c (1 - exp(-t/tau)) (c: final displacement, t: time since the start of the record, "
          "tau: time constant)",
      .needs = "pauses of the machine, and a recorded room temperature",
      .confused = "ambient-drift, a slow lag of an input",
      .numbers = both,
      .of_reading = true};

  [[nodiscard]] const EffectCard& card() const override { return drift_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings&) const override { return {at()}; }
  [[nodiscard]] Interval bounds(const Effect& e, std::size_t number, const Model& m,
                                const TimeConstantLimits& limits) const override {
    // Time constants relative to the length of the record.
    constexpr double shortest = 0.15, longest = 5.0;
    if (number == 0 || std::isnan(limits.record)) return EffectKind::bounds(e, number, m, limits);
    return {shortest * limits.record, longest * limits.record};
  }

  [[nodiscard]] Share share(const Effect& e, const Model&) const override {
    return SettlingShare{value_of(e, size), value_of(e, time_constant_number)};
  }
};

}  // namespace raceway::correction

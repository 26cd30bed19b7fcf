#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// A temperature that was recorded and that the model does not use: a lag of it. It counts above
/// the reference of the model's channels, where they have one in common.
struct RecordedInput final : EffectKind {
  static constexpr EffectCard recorded_card{
      .id = "input",
      .title = "a recorded temperature that the model does not use moves the machine",
      .form = "+ K/(1 + tau s) T, less the reference that all channels of temperatures have",
      .needs = "a temperature that varies and that the model does not use",
      .confused = "ambient-drift; motor-heat; a body that warms up with the one that was read",
      .numbers = gain_and_time_constant,
      .by_column = true,
      .needs_input = true};

  [[nodiscard]] const EffectCard& card() const override { return recorded_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<Effect> list;
    for (const Channel* c : in.unused(is_nameless)) list.push_back(at({}, {c}));
    return list;
  }

  [[nodiscard]] Input input(const Effect& e, const Model& m) const override {
    Input driving = EffectKind::input(e, m);
    if (record::is_temperature(*e.columns.front())) driving.reference = common_reference(m);
    return driving;
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    return lag_of_input(*this, e, m);
  }

 private:
  /// Temperatures of the room belong to ambient-drift.
  static bool is_nameless(const Channel& c) {
    return record::is_temperature(c) && !record::is_ambient(c);
  }
  /// Reference that all temperature-driven channels share, the channel of the reference itself
  /// aside; null for none.
  static const Channel* common_reference(const Model& m) {
    const Channel* common = nullptr;
    for (const DrivenChannel& c : m.channels)
      if (c.input.reference) common = c.input.reference;
    for (const DrivenChannel& c : m.channels) {
      const bool is_temperature =
          !c.input.columns.empty() && record::is_temperature(*c.input.columns.front());
      const bool is_reference =
          is_temperature && c.input.columns.size() == 1 && common == c.input.columns.front();
      if (is_temperature && !is_reference && c.input.reference != common) return nullptr;
    }
    return common;
  }
};

}  // namespace raceway::correction

#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// The ball screw of an axis becomes warm as the axis moves. The displacement follows the absolute
/// value of the feed rate or of the screw speed, with a gain and a first-order lag.
struct FeedAxisHeat final : EffectKind {
  static constexpr EffectCard feed_card{
      .id = "feed-axis-heat",
      .title = "the screw of an axis warms up as it moves",
      .form = "+ K/(1 + tau s) |feed| (K: gain, tau: time constant, s: Laplace variable)",
      .needs = "a feed that varies independently of the spindle speed",
      .confused = "ambient-drift; second-time-constant if the feed varies with the spindle speed",
      .numbers = gain_and_time_constant,
      .needs_input = true};

  [[nodiscard]] const EffectCard& card() const override { return feed_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<Effect> list;
    for (const Channel* c : in.unused(is_of_axis))
      list.push_back(at(std::string(c->variable.substr(0, c->variable.find('_'))), {c}));
    return list;
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    return lag_of_input(*this, e, m);
  }

 private:
  static bool is_of_axis(const Channel& c) {
    return c.kind == "feed" || (c.kind == "speed" && c.variable != "speed");
  }
};

}  // namespace raceway::correction

#pragma once

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"

namespace raceway::correction {

/// Parameters of one jump: its size [um] and its time [s].
inline constexpr record::NumberCard jump_size(std::string_view name) {
  return {name, "um", 0.0, -any_size, any_size};
}
inline constexpr record::NumberCard jump_time(std::string_view name) {
  return {name, "s", 0.0, -any_size, any_size, -any_size, any_size, unset};
}

/// The displacement reading jumps, for example because of a loose collet, probe or cable. The
/// effect has up to three jumps, each with a size and a time.
struct OffsetJump final : EffectKind {
  static constexpr std::array jumps{jump_size("size"),   jump_time("time_s"),
                                    jump_size("size_2"), jump_time("time_2_s"),
                                    jump_size("size_3"), jump_time("time_3_s")};
  static constexpr EffectCard jump_card{
      .id = "offset-jump",
      .title = "the reading jumps, for example because of a collet, a probe or a cable",
      .form =
          "+ c H(t - t1) for each of at most three jumps (c: size, t1: time of the jump, H: "
          "unit step)",
      .needs = "closely spaced readings before and after a jump",
      .confused = "kinematic-displacement, an unmeasured heat source that is switched on",
      .numbers = jumps,
      .of_reading = true};

  [[nodiscard]] const EffectCard& card() const override { return jump_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    if (in.jump_times.empty()) return {};
    Effect e = at();
    for (std::size_t k = 0; k < e.values.size(); ++k)
      if (is_time(k)) e.values[k] = in.end;
    return {std::move(e)};
  }
  [[nodiscard]] std::vector<double> choices(std::size_t number,
                                            const Surroundings& in) const override {
    if (!is_time(number)) return {};
    return {in.jump_times.begin(), in.jump_times.end()};
  }
  /// Returns true for the size of the second and of the third jump, because a model file may omit
  /// these jumps.
  [[nodiscard]] bool may_end_before(std::size_t number) const override {
    return number > 0 && !is_time(number);
  }

  [[nodiscard]] Share share(const Effect& e, const Model&) const override {
    JumpShare made;
    for (std::size_t k = 0; k + 1 < e.values.size(); k += 2)
      made.jumps.push_back({.size = e.values[k], .time = e.values[k + 1]});
    return made;
  }

 private:
  static bool is_time(std::size_t number) { return number % 2 == 1; }
};

}  // namespace raceway::correction

#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "correction/effect_kind.h"
#include "correction/effects/shared_numbers.h"
#include "record/series_channel.h"

namespace raceway::correction {

/// A recorded quantity that is not an input of the model moves the machine. The displacement
/// follows this quantity with a gain and a first-order lag. An axis position is not a heat source,
/// so the displacement follows the position without a lag. If the quantity is a temperature, and
/// all temperature inputs of the model have the same reference temperature, this reference is
/// subtracted.
///
/// An axis position can also define a window. While the axis is in the window, the displacement
/// follows the input of a channel with an additional gain and lag. The program tries five windows
/// within the recorded range of the position.
struct RecordedInput final : EffectKind {
  static constexpr EffectCard recorded_card{
      .id = "input",
      .title = "a recorded quantity that the model does not use moves the machine",
      .form =
          "+ K/(1 + tau s) u (u: recorded quantity, K: gain, tau: time constant, s: Laplace "
          "variable). For a position: + K u. If u is a temperature and all temperature inputs "
          "of the model have the same reference temperature, this reference is subtracted from "
          "u. For a window of a position: + w K/(1 + tau s) u, where u is the input of a "
          "channel, and w is a factor of the position from 0 (outside the window) to 1 (inside)",
      .needs =
          "a column that varies and that the model does not use: a temperature, power, current, "
          "load, torque, flow, pressure or position",
      .confused = "ambient-drift; motor-heat; a part that warms up together with the measured part",
      .numbers = gain_and_time_constant,
      .by_column = true,
      .by_window = true,
      .needs_input = true};

  [[nodiscard]] const EffectCard& card() const override { return recorded_card; }

  [[nodiscard]] std::vector<Effect> possible(const Surroundings& in) const override {
    std::vector<Effect> list;
    for (const Channel* c : in.unused(is_nameless)) {
      list.push_back(at({}, {c}));
      if (record::is_position(*c)) list.back().values.resize(1);
    }
    for (std::size_t k = 0; k < in.varying.size() && k < in.ranges.size(); ++k) {
      if (!record::is_position(*in.varying[k])) continue;
      for (const DrivenChannel& c : in.model.channels) {
        if (c.sections.empty() || c.input.window) continue;
        for (const Window& w : windows_of(*in.varying[k], in.ranges[k])) {
          list.push_back(at(in.where(c)));
          list.back().window = w;
        }
      }
    }
    return list;
  }

  /// Returns true for the parameter with the index 1, the time constant, because a model file may
  /// omit it. The displacement then follows the column without a lag.
  [[nodiscard]] bool may_end_before(std::size_t number) const override { return number == 1; }

  [[nodiscard]] Input input(const Effect& e, const Model& m) const override {
    Input driving = EffectKind::input(e, m);
    if (e.window) {
      driving.window = e.window;
      return driving;
    }
    if (record::is_temperature(*e.columns.front())) driving.reference = common_reference(m);
    return driving;
  }

  [[nodiscard]] Share share(const Effect& e, const Model& m) const override {
    if (e.values.size() > 1) return lag_of_input(*this, e, m);
    return DrivenShare{input(e, m), e.values.front()};
  }

 private:
  static constexpr double endless = std::numeric_limits<double>::infinity();

  /// Returns the windows that are tried. In one window, the factor of the window rises linearly
  /// from 0 to 1 over the recorded range of the position. The other windows are the upper half, the
  /// lower third, the middle third and the upper third of the range. The lower half is not
  /// necessary: its response is the response of the channel minus the response in the upper half.
  /// The limits of the windows are round numbers in the unit of the column.
  static std::array<Window, 5> windows_of(const Channel& position, const Interval& range) {
    const double low = position.in_unit(range.lower), width = position.in_unit(range.upper) - low;
    const double grain = std::pow(10.0, std::floor(std::log10(width)) - 2.0);
    const auto edge = [&](double share) {
      return position.to_SI(grain * std::round((low + share * width) / grain));
    };
    const double half = edge(0.5), third = edge(1.0 / 3.0), two_thirds = edge(2.0 / 3.0);
    const auto between = [&](double from, double full_from, double full_to, double to) {
      return Window{.column = &position, .points = {from, full_from, full_to, to}};
    };
    return {between(edge(0.0), edge(1.0), endless, endless), between(half, half, endless, endless),
            between(-endless, -endless, third, third),
            between(third, third, two_thirds, two_thirds),
            between(two_thirds, two_thirds, endless, endless)};
  }
  /// Returns true for the columns that this effect tests. Not tested are offsets that the control
  /// applied, and columns for which another effect exists: ambient temperatures, speeds, feeds and
  /// the coolant state.
  static bool is_nameless(const Channel& c) {
    return !record::is_ambient(c) && !record::acts_by_amount(c) && c.kind != record::offset_kind;
  }
  /// Returns the common reference temperature of all channels with a temperature as input; null if
  /// these channels have no common reference. A channel whose only input is this reference is
  /// ignored.
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

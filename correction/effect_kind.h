#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "correction/numbers.h"
#include "correction/share.h"
#include "fit/judged.h"
#include "record/parameter.h"

namespace raceway::correction {

/// Description of an effect on a displacement over time.
struct EffectCard {
  std::string_view id;
  std::string_view title;
  std::string_view form;      ///< formula with u: input, x: state, y: displacement
  std::string_view needs;     ///< description of the record that the effect needs
  std::string_view confused;  ///< effects with a similar influence
  /// Parameters in the units of files. The unit "um/u" means um per unit of the input.
  std::span<const record::NumberCard> numbers;
  std::size_t size = 0;     ///< index of the parameter whose neutral value switches the effect off
  bool of_channel = false;  ///< true: changes a channel's response; false: adds to the displacement
  bool at_channel = false;  ///< true: `where` names a channel; empty means the first one
  /// True if the full id contains a column: the column that drives the effect, or the column of its
  /// window.
  bool by_column = false;
  bool by_window = false;   ///< true: may be limited to a range of an axis position
  bool of_reading = false;  ///< true: valid only for this record, and not for a control
  /// True if the record itself shows the effect; such an effect has no parameter and is never
  /// switched on.
  bool evidence = false;
  bool needs_input = false;  ///< true: a file must name the columns of the effect
};

/// Properties of a record that determine on which channels and columns effects can act.
struct Surroundings {
  const Model& model;
  std::span<const Channel* const> varying{};  ///< inputs of the record that vary
  std::span<const Interval> ranges{};         ///< range of each varying input [SI]
  std::span<const double> jump_times{};       ///< times at which the displacement jumps [s]
  double end = 0.0;                           ///< end of the record: 1 s after the last row [s]

  [[nodiscard]] bool varies(const Channel& column) const;
  /// Returns true if the first channel has lags, which effects can modify.
  [[nodiscard]] bool first_channel_lags() const {
    return !model.channels.empty() && !model.channels.front().sections.empty();
  }
  /// Returns the name of the channel on which an effect acts. The name is empty for the first
  /// channel.
  [[nodiscard]] std::string where(const DrivenChannel& channel) const {
    return &channel == &model.channels.front() ? std::string() : channel.name;
  }
  /// Returns the columns that vary, that the model does not use as inputs, and for which
  /// `is_of_kind` is true.
  [[nodiscard]] std::vector<const Channel*> unused(bool (*is_of_kind)(const Channel&)) const;
};

/// A model fitted to a record, with its residual.
struct FittedRecord {
  const Model& model;
  const Series& series;
  std::span<const double> left;  ///< residual [m] by row; NaN without a reading
};

/// Behaviour of an effect on a displacement over time. Each effect of the catalogue is a struct in
/// its own file (correction/effects/); OwnEffect is an effect defined by a user.
class EffectKind {
 public:
  EffectKind() = default;
  EffectKind(const EffectKind&) = delete;
  EffectKind& operator=(const EffectKind&) = delete;
  virtual ~EffectKind() = default;

  [[nodiscard]] virtual const EffectCard& card() const = 0;

  /// Returns one effect with initial values for each channel or column on which the record allows
  /// it.
  [[nodiscard]] virtual std::vector<Effect> possible(const Surroundings& in) const;
  /// Returns the allowed values of a parameter. An empty result allows all values within the
  /// bounds.
  [[nodiscard]] virtual std::vector<double> choices(std::size_t number,
                                                    const Surroundings& in) const;

  /// Returns the entries of EffectCard::numbers that this effect uses.
  [[nodiscard]] virtual std::span<const record::NumberCard> numbers(const Effect& effect) const;
  /// Returns true if a file may omit this parameter and the following ones.
  [[nodiscard]] virtual bool may_end_before(std::size_t number) const;
  /// Returns true if the contribution of the effect is proportional to this parameter.
  [[nodiscard]] virtual bool is_proportional(std::size_t number) const;
  /// Returns the bounds of a parameter; `limits` of the record apply to time constants.
  [[nodiscard]] virtual Interval bounds(const Effect& effect, std::size_t number,
                                        const Model& model, const TimeConstantLimits& limits) const;
  /// Returns the key of a parameter in a file if the displacement is a length: "gain_um_K".
  /// key_of() also handles angles.
  [[nodiscard]] virtual std::string key(const Effect& effect, std::size_t number,
                                        const Model& model) const;

  /// Returns the input of the effect: its columns, or the input of the channel on which the effect
  /// acts if the effect has no columns.
  [[nodiscard]] virtual Input input(const Effect& effect, const Model& model) const;
  /// Returns the columns that the effect needs in addition to its input.
  [[nodiscard]] virtual std::vector<const Channel*> other_columns(const Effect& effect) const;

  /// Returns faults of this kind that the record itself shows. Default: none.
  [[nodiscard]] virtual std::vector<fit::Fault> faults(const FittedRecord& in) const;

  /// Returns the contribution to the displacement.
  [[nodiscard]] virtual Share share(const Effect& effect, const Model& model) const;
  /// Changes the response of the channel on which the effect acts.
  virtual void change(const Effect& effect, const Model& model, Answer& answer) const;

 protected:
  /// Returns the effect with its initial values, on this channel or axis and with these columns.
  [[nodiscard]] Effect at(std::string where = {}, std::vector<const Channel*> columns = {}) const;
};

/// Returns the key of an effect's parameter in a model file: "gain_um_K", or "gain_urad_K" for an
/// angle.
[[nodiscard]] std::string key_of(const Effect& effect, std::size_t number, const Model& model);

/// Returns the unit of an effect's parameter for the reader: "um/K", or "urad/K" for an angle.
[[nodiscard]] std::string unit_of(const Effect& effect, std::size_t number, const Model& model);

/// Returns the contribution of an effect that follows its input with a first-order lag. The
/// parameters of the effect are `gain` and `time_constant_s`.
[[nodiscard]] DrivenShare lag_of_input(const EffectKind& kind, const Effect& effect,
                                       const Model& model);

/// Returns the kind of an effect, from the catalogue or user-defined.
[[nodiscard]] const EffectKind& kind_of(const Effect& effect);
[[nodiscard]] const EffectCard& card_of(const Effect& effect);

/// Returns the value of an effect's parameter in the unit of its card. Throws std::logic_error if
/// the effect has no such parameter.
[[nodiscard]] double value_of(const Effect& effect, const record::NumberCard& number);

}  // namespace raceway::correction

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

/// Description of an effect, a physical mechanism that changes a displacement over time.
struct EffectCard {
  std::string_view id;
  std::string_view title;
  std::string_view form;      ///< formula with input u, state x of a lag and displacement y
  std::string_view needs;     ///< properties that a record needs so that a fit finds the effect
  std::string_view confused;  ///< effects with a similar influence on the displacement
  /// Parameters in the units of the model file. The unit "um/u" means um per unit of the input.
  std::span<const record::NumberCard> numbers;
  /// Index in `numbers` of the parameter for the size of the effect. The effect is off if this
  /// parameter has its neutral value.
  std::size_t size = 0;
  /// True if the effect changes the response of a channel to its input (a channel is a contribution
  /// to the displacement that one input drives). Otherwise the effect adds its own contribution.
  bool of_channel = false;
  /// True: the effect acts on one channel. `Effect::where` is the name of this channel; "" means
  /// the first channel.
  bool at_channel = false;
  /// True if full_id() contains the name of a column. The column is the input of the effect, or the
  /// axis position that limits the effect to a window.
  bool by_column = false;
  bool by_window = false;   ///< true: the effect can be limited to a range of an axis position
  bool of_reading = false;  ///< true: the effect is valid only for the record of the fit
  /// True for a fault of the record, such as a loose sensor. faults() finds these faults. A fault
  /// has no parameters and is never part of a model.
  bool evidence = false;
  bool needs_input = false;  ///< true: a model file must name the columns of the effect
};

/// Properties of a model and a record that determine on which channels and columns effects can act.
struct Surroundings {
  const Model& model;
  std::span<const Channel* const> varying{};  ///< input columns that vary in the record
  std::span<const Interval> ranges{};         ///< range of each varying input [SI]
  std::span<const double> jump_times{};       ///< times at which the displacement jumps [s]
  double end = 0.0;                           ///< time 1 s after the last row of the record [s]

  [[nodiscard]] bool varies(const Channel& column) const;
  /// Returns true if the first channel has first-order lags.
  [[nodiscard]] bool first_channel_lags() const {
    return !model.channels.empty() && !model.channels.front().sections.empty();
  }
  /// Returns the value of Effect::where for an effect on this channel. The value is the name of the
  /// channel, or an empty string for the first channel.
  [[nodiscard]] std::string where(const DrivenChannel& channel) const {
    return &channel == &model.channels.front() ? std::string() : channel.name;
  }
  /// Returns the columns that vary, are not inputs of the model, and satisfy `is_of_kind`.
  [[nodiscard]] std::vector<const Channel*> unused(bool (*is_of_kind)(const Channel&)) const;
};

/// A fitted model with its record and residual.
struct FittedRecord {
  const Model& model;
  const Series& series;
  /// Residual as reading minus prediction [m], one value per row; NaN without a reading.
  std::span<const double> left;
};

/// Base class of the effects on a displacement over time. Each effect of the catalogue is a struct
/// in its own file (correction/effects/); OwnEffect is an effect defined by a user.
class EffectKind {
 public:
  EffectKind() = default;
  EffectKind(const EffectKind&) = delete;
  EffectKind& operator=(const EffectKind&) = delete;
  virtual ~EffectKind() = default;

  [[nodiscard]] virtual const EffectCard& card() const = 0;

  /// Returns the effects of this kind that can act in the record, with initial values: one effect
  /// for each possible channel, column or window. The default is an empty list.
  [[nodiscard]] virtual std::vector<Effect> possible(const Surroundings& in) const;
  /// Returns the only values that a fit may give to a parameter. If the list is empty, the fit may
  /// use all values within the bounds.
  [[nodiscard]] virtual std::vector<double> choices(std::size_t number,
                                                    const Surroundings& in) const;

  /// Returns the entries of EffectCard::numbers that this effect uses.
  [[nodiscard]] virtual std::span<const record::NumberCard> numbers(const Effect& effect) const;
  /// Returns true if a model file may omit this parameter and all later ones.
  [[nodiscard]] virtual bool may_end_before(std::size_t number) const;
  /// Returns true if the contribution of the effect is proportional to this parameter.
  [[nodiscard]] virtual bool is_proportional(std::size_t number) const;
  /// Returns the bounds of a parameter. `limits` is the range of time constants that a fit can
  /// determine from the record. The bounds of a time constant lie within this range.
  [[nodiscard]] virtual Interval bounds(const Effect& effect, std::size_t number,
                                        const Model& model, const TimeConstantLimits& limits) const;
  /// Returns the key of a parameter in a model file, such as "gain_um_K", for a displacement in um.
  /// For an angle, use key_of().
  [[nodiscard]] virtual std::string key(const Effect& effect, std::size_t number,
                                        const Model& model) const;

  /// Returns the input of the effect, which is the mean of its columns. If the effect has no
  /// columns, the result is the input of the channel on which the effect acts.
  [[nodiscard]] virtual Input input(const Effect& effect, const Model& model) const;
  /// Returns the columns that the effect needs in addition to its input.
  [[nodiscard]] virtual std::vector<const Channel*> other_columns(const Effect& effect) const;

  /// Returns the faults that this kind of effect finds in the record, such as a loose sensor. The
  /// default is an empty list.
  [[nodiscard]] virtual std::vector<fit::Fault> faults(const FittedRecord& in) const;

  /// Returns the contribution of the effect to the displacement. The default is no contribution.
  [[nodiscard]] virtual Share share(const Effect& effect, const Model& model) const;
  /// Writes to `answer` the changes that the effect makes to the lags of its channel. The default
  /// is no change.
  virtual void change(const Effect& effect, const Model& model, Answer& answer) const;

 protected:
  /// Returns an effect of this kind with initial values. `where` is the channel or axis of the
  /// effect, and `columns` are its input columns.
  [[nodiscard]] Effect at(std::string where = {}, std::vector<const Channel*> columns = {}) const;
};

/// Returns the key of an effect's parameter in a model file, such as "gain_um_K"; "gain_urad_K" for
/// an angle.
[[nodiscard]] std::string key_of(const Effect& effect, std::size_t number, const Model& model);

/// Returns the unit of an effect's parameter, such as "um/K"; "urad/K" for an angle.
[[nodiscard]] std::string unit_of(const Effect& effect, std::size_t number, const Model& model);

/// Returns the contribution of an effect that follows its input with a first-order lag. The
/// parameters of the effect are `gain` and `time_constant_s`.
[[nodiscard]] DrivenShare lag_of_input(const EffectKind& kind, const Effect& effect,
                                       const Model& model);

/// Returns the kind of an effect. This is an entry of the catalogue or a user-defined effect.
/// Throws std::logic_error for an unknown id.
[[nodiscard]] const EffectKind& kind_of(const Effect& effect);
[[nodiscard]] const EffectCard& card_of(const Effect& effect);

/// Returns the value of an effect's parameter in the unit of `number`. Throws std::logic_error if
/// the effect has no parameter with the name of `number`.
[[nodiscard]] double value_of(const Effect& effect, const record::NumberCard& number);

}  // namespace raceway::correction

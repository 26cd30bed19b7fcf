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
  std::string_view needs;     ///< properties of a record in which the effect can be identified
  std::string_view confused;  ///< effects with a similar influence on the displacement
  /// Parameters in the units of the model file. The unit "um/u" means um per unit of the input.
  std::span<const record::NumberCard> numbers;
  std::size_t size = 0;  ///< index of the parameter whose neutral value switches the effect off
  /// True: the effect changes the response of a channel; false: it adds to the displacement.
  bool of_channel = false;
  bool at_channel = false;  ///< true: `Effect::where` names a channel; "" is the first channel
  /// True if full_id() contains a column: the column that drives the effect or limits its window.
  bool by_column = false;
  bool by_window = false;   ///< true: the effect may be limited to a range of an axis position
  bool of_reading = false;  ///< true: valid only for the record of the fit, not for a control
  /// True for a fault that faults() finds in the record. Such an effect has no parameter, and a
  /// model never contains it.
  bool evidence = false;
  bool needs_input = false;  ///< true: a model file must name the columns of the effect
};

/// Model and record properties that determine on which channels and columns effects can act.
struct Surroundings {
  const Model& model;
  std::span<const Channel* const> varying{};  ///< input columns that vary in the record
  std::span<const Interval> ranges{};         ///< range of each varying input [SI]
  std::span<const double> jump_times{};       ///< times at which the displacement jumps [s]
  double end = 0.0;                           ///< time 1 s after the last row of the record [s]

  [[nodiscard]] bool varies(const Channel& column) const;
  /// Returns true if the first channel has lags that an effect can change.
  [[nodiscard]] bool first_channel_lags() const {
    return !model.channels.empty() && !model.channels.front().sections.empty();
  }
  /// Returns the value of Effect::where for an effect on this channel: its name, or an empty text
  /// for the first channel.
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

  /// Returns the effects of this kind that the record allows, one for each possible channel, column
  /// or window, with initial values. Default: none.
  [[nodiscard]] virtual std::vector<Effect> possible(const Surroundings& in) const;
  /// Returns the values to which a fit restricts a parameter. An empty result means all values
  /// within its bounds.
  [[nodiscard]] virtual std::vector<double> choices(std::size_t number,
                                                    const Surroundings& in) const;

  /// Returns the entries of EffectCard::numbers that this effect uses.
  [[nodiscard]] virtual std::span<const record::NumberCard> numbers(const Effect& effect) const;
  /// Returns true if a model file may omit this parameter and all later ones.
  [[nodiscard]] virtual bool may_end_before(std::size_t number) const;
  /// Returns true if the contribution of the effect is proportional to this parameter.
  [[nodiscard]] virtual bool is_proportional(std::size_t number) const;
  /// Returns the bounds of a parameter. The bounds of a time constant also lie within `limits`, the
  /// range that the record can determine.
  [[nodiscard]] virtual Interval bounds(const Effect& effect, std::size_t number,
                                        const Model& model, const TimeConstantLimits& limits) const;
  /// Returns the key of a parameter in a model file, such as "gain_um_K", for a displacement that
  /// is a length. key_of() also handles angles.
  [[nodiscard]] virtual std::string key(const Effect& effect, std::size_t number,
                                        const Model& model) const;

  /// Returns the input of the effect: its columns, or the input of the channel on which the effect
  /// acts if the effect has no columns.
  [[nodiscard]] virtual Input input(const Effect& effect, const Model& model) const;
  /// Returns the columns that the effect needs in addition to its input.
  [[nodiscard]] virtual std::vector<const Channel*> other_columns(const Effect& effect) const;

  /// Returns the faults, such as a loose sensor, that this kind of effect finds in the record.
  /// Default: none.
  [[nodiscard]] virtual std::vector<fit::Fault> faults(const FittedRecord& in) const;

  /// Returns the contribution of the effect to the displacement. Default: none.
  [[nodiscard]] virtual Share share(const Effect& effect, const Model& model) const;
  /// Writes to `answer` the changes that the effect makes to the lags of its channel. Default: no
  /// change.
  virtual void change(const Effect& effect, const Model& model, Answer& answer) const;

 protected:
  /// Returns an effect of this kind with its initial values, on this channel or axis and with these
  /// columns.
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

/// Returns the kind of an effect: the kind with its id in the catalogue, or the user-defined
/// effect. Throws std::logic_error for an unknown id.
[[nodiscard]] const EffectKind& kind_of(const Effect& effect);
[[nodiscard]] const EffectCard& card_of(const Effect& effect);

/// Returns the value of an effect's parameter in the unit of its card. Throws std::logic_error if
/// the effect has no such parameter.
[[nodiscard]] double value_of(const Effect& effect, const record::NumberCard& number);

}  // namespace raceway::correction

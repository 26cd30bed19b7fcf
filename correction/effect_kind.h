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

/// Properties of an effect on a displacement over time that are known beforehand.
struct EffectCard {
  std::string_view id;
  std::string_view title;
  std::string_view form;      ///< u: input, x: state, y: displacement
  std::string_view needs;     ///< of a record, in words
  std::string_view confused;  ///< with what
  /// Parameters, in the units of files. A unit "um/u" is per unit of the input.
  std::span<const record::NumberCard> numbers;
  std::size_t size = 0;      ///< which of them changes nothing at its neutral value
  bool of_channel = false;   ///< changes how a channel answers; otherwise adds a share of its own
  bool at_channel = false;   ///< `where` names a channel, or is empty for the first one
  bool by_column = false;    ///< named by a column: the one that drives it, or of its window
  bool by_window = false;    ///< may act in a window of a position
  bool of_reading = false;   ///< of this record alone: not carried to another one, nor to a control
  bool evidence = false;     ///< told by the record itself: has no number, is never switched on
  bool needs_input = false;  ///< its columns cannot be left out in a file
};

/// Properties of a record that decide where effects can act on a model.
struct Surroundings {
  const Model& model;
  std::span<const Channel* const> varying{};  ///< inputs of the record that vary
  std::span<const Interval> ranges{};         ///< through which each of them goes [SI]
  std::span<const double> jump_times{};       ///< at which the displacement leaps [s]
  double end = 0.0;                           ///< behind the last row [s]

  [[nodiscard]] bool varies(const Channel& column) const;
  /// Returns true if the first channel is a sum of lags, which effects can change.
  [[nodiscard]] bool first_channel_lags() const {
    return !model.channels.empty() && !model.channels.front().sections.empty();
  }
  /// Name of a channel that an effect acts on; empty for the first one.
  [[nodiscard]] std::string where(const DrivenChannel& channel) const {
    return &channel == &model.channels.front() ? std::string() : channel.name;
  }
  /// Columns that vary, drive nothing in the model, and are of a kind.
  [[nodiscard]] std::vector<const Channel*> unused(bool (*is_of_kind)(const Channel&)) const;
};

/// A model that was fitted to a record, and its residual there.
struct FittedRecord {
  const Model& model;
  const Series& series;
  std::span<const double> left;  ///< [m] by row, NaN where nothing was read
};

/// Behaviour of an effect on a displacement over time. Each effect of the catalogue is a struct in
/// a file of its own (correction/effects/); OwnEffect is one that a user wrote.
class EffectKind {
 public:
  EffectKind() = default;
  EffectKind(const EffectKind&) = delete;
  EffectKind& operator=(const EffectKind&) = delete;
  virtual ~EffectKind() = default;

  [[nodiscard]] virtual const EffectCard& card() const = 0;

  /// The effect at every place where a record lets it act, with its initial values.
  [[nodiscard]] virtual std::vector<Effect> possible(const Surroundings& in) const;
  /// Values that a number may have; empty: all between its bounds.
  [[nodiscard]] virtual std::vector<double> choices(std::size_t number,
                                                    const Surroundings& in) const;

  /// Numbers of the card that the effect has, switched on as it is.
  [[nodiscard]] virtual std::span<const record::NumberCard> numbers(const Effect& effect) const;
  /// Returns true if a file may leave out this number and those after it.
  [[nodiscard]] virtual bool may_end_before(std::size_t number) const;
  /// Returns true if the displacement is proportional to a number.
  [[nodiscard]] virtual bool is_proportional(std::size_t number) const;
  /// Bounds of a number; `limits` of the record apply to time constants.
  [[nodiscard]] virtual Interval bounds(const Effect& effect, std::size_t number,
                                        const Model& model, const TimeConstantLimits& limits) const;
  /// Key of a number in a file, for a displacement that is a length: "gain_um_K". key_of() gives it
  /// for any.
  [[nodiscard]] virtual std::string key(const Effect& effect, std::size_t number,
                                        const Model& model) const;

  /// Input of the effect: its columns, else the input of the channel that it acts on.
  [[nodiscard]] virtual Input input(const Effect& effect, const Model& model) const;
  /// Columns that it needs in addition to its input.
  [[nodiscard]] virtual std::vector<const Channel*> other_columns(const Effect& effect) const;

  /// Faults of this kind that the record itself shows. Default: none.
  [[nodiscard]] virtual std::vector<fit::Fault> faults(const FittedRecord& in) const;

  /// Contribution to the displacement.
  [[nodiscard]] virtual Share share(const Effect& effect, const Model& model) const;
  /// Changes how the channel answers that it acts on.
  virtual void change(const Effect& effect, const Model& model, Answer& answer) const;

 protected:
  /// Switched on there, with its initial values.
  [[nodiscard]] Effect at(std::string where = {}, std::vector<const Channel*> columns = {}) const;
};

/// Key of a number of an effect in the file of a model: "gain_um_K", of an angle "gain_urad_K".
[[nodiscard]] std::string key_of(const Effect& effect, std::size_t number, const Model& model);

/// The unit of a number of an effect, for people: "um/K", of an angle "urad/K".
[[nodiscard]] std::string unit_of(const Effect& effect, std::size_t number, const Model& model);

/// A lag of what drives it: the share of effects with the numbers `gain` and `time_constant`.
[[nodiscard]] DrivenShare lag_of_input(const EffectKind& kind, const Effect& effect,
                                       const Model& model);

/// The kind of an effect, of the catalogue or the user's own.
[[nodiscard]] const EffectKind& kind_of(const Effect& effect);
[[nodiscard]] const EffectCard& card_of(const Effect& effect);

/// The value of a number of an effect, in the unit of its card. Throws std::logic_error for a
/// number that is none of it.
[[nodiscard]] double value_of(const Effect& effect, const record::NumberCard& number);

}  // namespace raceway::correction

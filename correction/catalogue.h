#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "record/parameter.h"

namespace raceway::correction {

/// What is known beforehand of an effect on a displacement over time.
struct EffectCard {
  std::string_view id;
  std::string_view title;
  std::string_view form;      ///< u: input, x: state, y: displacement
  std::string_view needs;     ///< of a record, in words
  std::string_view confused;  ///< with what
  /// In the units of files. A unit "um/u" is per unit of what drives it.
  std::span<const record::NumberCard> numbers;
  std::size_t size = 0;     ///< which of them changes nothing at its neutral value
  bool of_channel = false;  ///< changes how a channel answers; otherwise adds a share of its own
  bool of_reading = false;  ///< of this record alone: not carried to another one, nor to a control
  bool evidence = false;    ///< told by the record itself: has no number, is never switched on
};

/// All of them, by id.
[[nodiscard]] std::span<const EffectCard> catalogue();
/// Null where there is none of that id.
[[nodiscard]] const EffectCard* find_card(std::string_view id);

/// The value of a number of an effect by its name, in the unit of its card.
[[nodiscard]] double value_of(const Effect& effect, std::string_view name);

}  // namespace raceway::correction

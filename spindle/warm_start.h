#pragma once

#include <optional>
#include <span>
#include <string>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Operation of a spindle before the first row of a run, if the thermometers show that the spindle
/// was warm.
struct WarmStart {
  Inputs inputs{};          ///< constant inputs of this operation
  double duration = unset;  ///< [s]
  double rise = unset;      ///< rise of the warmest thermometer above ambient in the first row [K]
  bool zeroed = false;      ///< true if the displacement was set to zero in the first row

  /// Returns a sentence: "the thermometers are up to 11 K above the room in the first row: ...".
  [[nodiscard]] std::string statement() const;
};

/// Finds the past operation that agrees best with the thermometers in the first row of a run. The
/// result is empty unless two thermometers (or the only one) are more than 2 K above a cold start.
/// The result is also empty if the record has no ambient temperature, or if no past operation
/// halves the error of a cold start.
///
/// Candidates are constant speeds above 0: the speed of the first row, the mean and the highest
/// speed. Each lasts a quarter of an hour to eight hours, with the other inputs of the first row.
/// The displacement is treated as set to zero if the amount of its first reading is less than a
/// quarter of the displacement that the model predicts after the past operation.
[[nodiscard]] std::optional<WarmStart> find_warm_start(const model::Model& model,
                                                       const record::Record& run,
                                                       std::span<const ProfileRow> profile);

/// Returns the state of a spindle after the operation `past`. The run begins from this state.
[[nodiscard]] State state_after(Simulator& simulator, const WarmStart& past,
                                std::span<const ProfileRow> profile);

}  // namespace raceway::spindle

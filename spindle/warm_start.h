#pragma once

#include <optional>
#include <span>
#include <string>

#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// History of a spindle before the first row of a run, where its thermometers show that it was
/// warm.
struct WarmStart {
  Inputs inputs{};          ///< constant
  double duration = unset;  ///< [s]
  double rise = unset;      ///< of the warmest thermometer above the room, in the first row [K]
  bool zeroed = false;      ///< the displacement was set to zero in the first row

  /// "front_bearing_temperature_C and others are up to 11 K above the room ...", for people.
  [[nodiscard]] std::string statement() const;
};

/// The past of a run that agrees best with the thermometers of its first row; nothing where they
/// are within 2 K of a run from cold, where the record has no room temperature, or where no past
/// has less than half the error of a cold start.
///
/// Candidates are constant speeds (of the first row, the mean and the highest) for a quarter of an
/// hour to eight hours at the other inputs of the first row. The displacement was set to zero where
/// its first row reads less than a quarter of the displacement of that past.
[[nodiscard]] std::optional<WarmStart> find_warm_start(const model::Model& model,
                                                       const record::Record& run,
                                                       std::span<const ProfileRow> profile);

/// The state of a spindle after that past, at which the run begins.
[[nodiscard]] State state_after(Simulator& simulator, const WarmStart& past,
                                std::span<const ProfileRow> profile);

}  // namespace raceway::spindle

#pragma once

#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::tolerance {

/// Record without stray readings, and notes about the removed readings.
struct WithoutStrays {
  std::shared_ptr<const record::Record> record{};
  std::vector<record::Note> notes{};  ///< notes with the lines of the removed readings
};

/// Removes stray readings. At a stray reading, the residual jumps away from its neighbours and then
/// returns, for example because a chip touches the probe (fit/isolated_readings.h). The function
/// repeats two steps up to three times: it fits the model and removes the stray readings. The
/// record is unchanged for a costly model (Subject::is_costly()) and for a model that cannot be
/// fitted.
[[nodiscard]] WithoutStrays without_strays(const fit::Subject& subject,
                                           const record::Record& record);

}  // namespace raceway::tolerance

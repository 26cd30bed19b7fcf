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

/// Removes stray readings, whose residual jumps and returns (fit/isolated_readings.h), for example
/// because chips touch a probe that measures every few minutes. The function fits the model and
/// removes these readings, in up to three rounds. The record is unchanged for costly models
/// (Subject::is_costly()) and for models that cannot be fitted.
[[nodiscard]] WithoutStrays without_strays(const fit::Subject& subject,
                                           const record::Record& record);

}  // namespace raceway::tolerance

#pragma once

#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::tolerance {

/// A record without the readings that no model could explain, and notes on the removed readings.
struct WithoutStrays {
  std::shared_ptr<const record::Record> record{};
  std::vector<record::Note> notes{};  ///< notes with the lines of the removed readings
};

/// Removes readings whose residual jumps and returns (fit/isolated_readings.h), for example because
/// chips touch a probe that measures every few minutes. The model is refitted without these
/// readings. If the new fit shows further readings of this kind, the step is repeated; there are at
/// most three rounds. The record is unchanged for costly models and for models that cannot be
/// fitted.
[[nodiscard]] WithoutStrays without_strays(const fit::Subject& subject,
                                           const record::Record& record);

}  // namespace raceway::tolerance

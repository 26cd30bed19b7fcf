#pragma once

#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::tolerance {

/// A record without readings that no model of it could have made, and what to say of them.
struct WithoutStrays {
  std::shared_ptr<const record::Record> record{};
  std::vector<record::Note> notes{};  ///< with their lines
};

/// Takes out readings that leave what the refitted subject leaves around them and return
/// (fit/isolated_readings.h), as where chips touch a probe that reads every few minutes. The
/// subject is fitted again without them as long as that shows others, three times at most. A
/// subject that is costly, or that cannot be fitted, keeps its record.
[[nodiscard]] WithoutStrays without_strays(const fit::Subject& subject,
                                           const record::Record& record);

}  // namespace raceway::tolerance

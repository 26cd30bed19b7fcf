#pragma once

#include <string>
#include <vector>

#include "correction/learning.h"
#include "record/record.h"

namespace raceway::results {

/// Result of a correction that learns from readings, for one displacement.
struct Learnt {
  const record::Channel* displacement = nullptr;
  correction::Learning learning{};
};

/// Returns CSV with the columns time_s, predicted_um, std_um, residual_um and reading. The
/// prediction in a row uses only earlier readings. std_um is the expected standard deviation of
/// residual_um. residual_um (reading minus prediction) is empty in rows without a reading. The
/// column `reading` contains "learnt" if the correction used the reading of the row, and "refused"
/// if the correction rejected the reading as too far from the prediction. In all other rows,
/// `reading` is empty. For several displacements, each name ends with the column name of the
/// displacement instead of the unit, such as predicted_COLUMN.
[[nodiscard]] std::string learnt_text(const record::Record& record,
                                      const std::vector<Learnt>& learnt);
/// Returns the document of `raceway correct --learn --json`.
[[nodiscard]] std::string learnt_json(const std::string& model_file, const record::Record& record,
                                      const std::vector<Learnt>& learnt,
                                      const std::vector<record::Note>& messages);

}  // namespace raceway::results

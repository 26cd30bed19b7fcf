#pragma once

#include <string>
#include <vector>

#include "correction/learning.h"
#include "record/record.h"

namespace raceway::results {

/// Result of learning from the readings of one displacement.
struct Learnt {
  const record::Channel* displacement = nullptr;
  correction::Learning learning{};
};

/// Returns the columns time_s, predicted_um and std_um. The prediction of a row uses only earlier
/// readings. Rows with a reading also have residual_um and, in the column `reading`, "learnt" or
/// "refused". For several displacements, the names are predicted_COLUMN and so on.
[[nodiscard]] std::string learnt_text(const record::Record& record,
                                      const std::vector<Learnt>& learnt);
/// Returns the document of `raceway correct --learn --json`.
[[nodiscard]] std::string learnt_json(const std::string& model_file, const record::Record& record,
                                      const std::vector<Learnt>& learnt,
                                      const std::vector<record::Note>& messages);

}  // namespace raceway::results

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

/// time_s, predicted_um and std_um of every row from readings before it, residual_um where it was
/// read, and what became of a reading that was offered; of several displacements predicted_COLUMN
/// and so on.
[[nodiscard]] std::string learnt_text(const record::Record& record,
                                      const std::vector<Learnt>& learnt);
/// The document of `raceway correct --learn --json`.
[[nodiscard]] std::string learnt_json(const std::string& model_file, const record::Record& record,
                                      const std::vector<Learnt>& learnt,
                                      const std::vector<record::Note>& messages);

}  // namespace raceway::results

#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted from a prediction before the comparison with readings, because the
/// zero of a displacement is arbitrary.
enum class Zero {
  none,   ///< no constant: the prediction contains the offset of the model
  first,  ///< error at the first reading of each run and each setup (setup_id)
  mean    ///< mean error of each run and each setup, which minimises the rms residual
};

/// Returns the model for prediction on a record, with the constants that `zero` selects. For a
/// model with `initial_state = "free"` (a machine that is warm at the start), the offset and the
/// initial states of the lags are also fitted. This fit uses the readings before the first gap that
/// is longer than 1 h and longer than 20 median intervals between readings.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

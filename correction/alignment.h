#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted from a prediction before the comparison with readings. A constant is
/// necessary because the zero of a displacement is arbitrary.
enum class Zero {
  none,   ///< no constant is subtracted; the prediction contains the offset of the model
  first,  ///< error at the first reading of each run and each setup (setup_id)
  mean    ///< mean error of each run and each setup, which minimises the rms residual
};

/// Returns the model prepared for predictions on `record`. The constants that `zero` selects are
/// subtracted from these predictions. If the machine is warm at the start (`initial_state =
/// "free"`), the offset and the initial states of the lags are also fitted. This fit uses the
/// readings before the first long gap between readings. A gap is long if the gap exceeds both 1 h
/// and 20 times the median interval between readings.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

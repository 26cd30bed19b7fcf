#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted from a prediction before the comparison with readings. The zero of a
/// displacement is arbitrary.
enum class Zero {
  none,   ///< subtracts nothing: the prediction contains the offset of the model
  first,  ///< subtracts the error of the first reading of each run
  mean    ///< subtracts the mean error of each run, which minimises the rms residual
};

/// Returns the model as a subject, with these constants fitted to a record. If the model has
/// `initial_state = "free"` (a machine that was warm at the start), the initial states are also
/// fitted, to the readings before the first long gap. `model` itself does not change.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

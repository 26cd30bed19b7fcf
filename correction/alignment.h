#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted from a prediction before the comparison with readings. The zero of a
/// displacement is arbitrary.
enum class Zero {
  none,   ///< subtracts nothing: the prediction keeps the offset of the model
  first,  ///< subtracts the error of the first reading of each run
  mean    ///< subtracts the mean error, which gives the smallest residual
};

/// Returns the subject with the constants of every run from a record. If the machine was warm at
/// the start, the function also finds the initial states from the readings before the first long
/// gap. The model itself remains unchanged.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

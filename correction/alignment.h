#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted from a prediction before a comparison, because the zero of a
/// displacement is arbitrary.
enum class Zero {
  none,   ///< subtracts nothing: the offset of the model is kept
  first,  ///< subtracts the error of the first reading of each run
  mean    ///< subtracts the mean error, which gives the smallest residual
};

/// Returns the subject with the constants of every run, found from a record. For a machine that was
/// warm at the start, it also finds the initial states from the readings before the first long gap.
/// Everything in the model remains unchanged.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

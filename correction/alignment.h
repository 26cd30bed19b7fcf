#pragma once

#include <memory>

#include "correction/correction_subject.h"

namespace raceway::correction {

/// Constant that is subtracted before a prediction is compared, because the zero of a displacement
/// is arbitrary.
enum class Zero {
  none,   ///< none: the offset of the model stands
  first,  ///< the constant that makes the first reading of each run right
  mean    ///< the constant with the smallest residual
};

/// The subject informed by a record, with the constant of every run, and the states that a warm
/// machine had when its record began, found from the readings before the first long gap. All else
/// as in the model.
[[nodiscard]] std::shared_ptr<const CorrectionSubject> aligned(const Model& model,
                                                               const record::Record& record,
                                                               Zero zero);

}  // namespace raceway::correction

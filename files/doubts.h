#pragma once

#include <vector>

#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns questions about a record that must be answered before a verdict. Compared with the
/// current model, some data look as if they had another unit or sign, or were in the wrong column.
///
/// Readings:     the median of |reading / prediction| over the rows decides. Free parameters or
///               missing effects may explain a factor of up to 5. A larger factor is named if it is
///               near 1000, 1e6, 60, or 9.81 and 60/(2 pi). Fewer than 5 rows are not judged.
/// Temperatures: the range decides.
/// Refits:       a refit of the free numbers in either unit decides about degrees Fahrenheit (if no
///               row is colder than 59 C), loads in kgf, preloads of a shaft, and times of a
///               coast-down in min, ms or h. The error of the refit counts, and how usual its
///               numbers are.
/// Columns:      two columns look exchanged if the record agrees with the model only after the
///               exchange.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

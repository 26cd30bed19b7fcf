#pragma once

#include <vector>

#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns questions about a record that must be answered before a verdict. A question is asked if,
/// compared with the model, a column seems to have another unit or sign, or two columns seem to be
/// exchanged.
///
/// Readings:     the test uses the median of |reading / prediction| over the rows. Free parameters
///               or missing effects may explain a factor of up to 5. A larger factor is reported if
///               it is near 1000, 1e6, 60 or 9.7 (9.81 for kgf, 60/(2 pi) for rad/s). Fewer than 5
///               rows are not judged.
/// Temperatures: the test uses the range of the values.
/// Refits:       the free parameters are refitted with temperatures in degrees Fahrenheit (if no
///               row is colder than 59 C), with axial loads of a bearing in kgf, and with times of
///               a coast-down in min, h or ms. The test compares the errors of the refits and how
///               usual the fitted values are. Preloads and loads of a shaft are tested for kgf and
///               kN without a refit.
/// Columns:      two columns look exchanged if the record agrees with the model only after the
///               exchange.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

#pragma once

#include <vector>

#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Returns questions that the user must answer before a verdict on this record. The function
/// compares the record with the model, and asks if a column seems to have another unit or sign, or
/// if two columns seem to be exchanged.
///
/// Readings:     the test uses the median of |reading / prediction| over at least 5 rows. Free
///               parameters or missing effects may explain a factor of up to 5. A larger factor is
///               reported if it is near 1000, 1e6, 60 or 9.7 (9.81 for kgf, 60/(2 pi) for rad/s).
/// Temperatures: the test uses the lowest and the highest value.
/// Refits:       the free parameters are fitted again with temperatures in degrees Fahrenheit (if
///               no row is colder than 59 C), with axial loads of a bearing in kgf, and with times
///               of a coast-down in min, h or ms. The test compares the errors of these fits and
///               the deviations of the fitted values from usual values. Preloads and loads of a
///               shaft are tested for kgf and kN without a fit.
/// Columns:      two columns are reported if the record agrees with the model only after they are
///               exchanged.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

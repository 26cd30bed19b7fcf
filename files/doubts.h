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
///               parameters or missing effects may explain a ratio from 1/5 to 5. A ratio outside
///               this range is reported if the ratio or its reciprocal is near 1000, 1e6, 60 or 9.7
///               (9.81 for kgf, 60/(2 pi) for rad/s).
/// Temperatures: values between 220 and 470 C look like kelvin. Other values of temperature_C
///               between 150 and 400 C look like Fahrenheit.
/// Refits:       the free parameters are fitted again with temperatures in degrees Fahrenheit (if
///               no row is colder than 59 C), with axial loads of a bearing in kgf, and with times
///               of a coast-down in min, h or ms. The test compares the RMS relative error of a
///               refit with the error of the fit to the record as read. The test also compares the
///               ratios of the fitted values to the values of the model.
///               Preloads and loads of a shaft are tested for kgf and kN without a fit.
/// Speeds:       for a bearing on a rig, speeds with n d_m above 6e6 mm/min (d_m: pitch diameter)
///               look like rpm that were read as 1/s or rad/s.
/// Columns:      two columns are reported if the record agrees with the model only after they are
///               exchanged.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

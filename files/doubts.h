#pragma once

#include <vector>

#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Compares a record with the model, and returns questions that the user must answer before the
/// record is used for a verdict: does a column have another unit or sign, are two columns
/// exchanged, or does the column of a ring temperature contain the lubricant temperature?
///
/// Readings:     the test uses the median of |reading / prediction| over at least 5 rows. A ratio
///               from 1/5 to 5 can come from wrong parameters or a missing effect. For a torque, a
///               ratio outside this range and near 1000, 1e6, 60 or 9.7, or near the reciprocal of
///               one of these factors, indicates another unit. The factor 9.7 covers kgf (9.81) and
///               rad/s (60/(2 pi) = 9.55). For a displacement, the factors are 1000 and 1e6.
/// Temperatures: values between 220 and 470 C suggest that the column is in kelvin. Other values of
///               temperature_C between 150 and 400 C suggest Fahrenheit.
/// Loads:        for a bearing on a rig, axial loads far below or far above the static load rating
///               look like another unit (N, kN). Preloads and loads of a shaft look like kgf or kN
///               if the model agrees far better with the readings after conversion from this unit.
/// Refits:       the free parameters are fitted again with temperatures in Fahrenheit (if no row is
///               below 59 C, because 59 F is 15 C), with axial loads of a bearing in kgf, and with
///               times of a coast-down in min, h or ms. The unit is doubtful if the fit with the
///               other unit is much better than the fit to the record as read. The comparison uses
///               the RMS relative error and the ratios of the fitted parameters to the parameters
///               of the model.
/// Speeds:       for a bearing on a rig, speeds with n d_m above 6e6 mm/min look like rpm that were
///               read as 1/s or rad/s (n: speed, d_m: pitch diameter).
/// Columns:      two columns are reported if the record agrees with the model only after they are
///               exchanged.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

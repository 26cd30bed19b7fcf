#pragma once

#include <vector>

#include "files/doubt.h"
#include "model/model_subject.h"
#include "record/record.h"

namespace raceway::files {

/// Lists data of a record that look entered in another unit, with the other sign or in the wrong
/// column, compared with the current model: questions to answer before any verdict.
///
/// Readings are judged by the median of |reading / prediction| over the rows. A factor of up to 5
/// may come from free parameters or missing effects; beyond it one near 1000, 1e6, 60 or 9.81 and
/// 60/(2 pi) is named. Temperatures are judged by their range. Degrees Fahrenheit, where no row is
/// colder than 59 C, loads in kgf, of a shaft its preloads too, and times of a coast-down in min,
/// ms or h are judged by a refit of the free numbers in either unit: by what it errs, and by how
/// far the numbers are from those believed; two columns where the record makes no sense as it
/// stands and does once they are exchanged. Nothing is said of fewer than 5 rows.
[[nodiscard]] std::vector<Doubt> doubts(const model::ModelSubject& subject,
                                        const record::Record& data);

}  // namespace raceway::files

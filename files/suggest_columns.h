#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// Returns the text of a table [columns] (TOML) for a measurement file, from the words and units in
/// its header and its row of units. A comment names each needed column that was not found. Throws
/// InputError like read_csv().
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

/// Returns the text of a table [columns] for a time record and these correction models. Words in
/// the headers identify the columns that the models need. Other columns are named after their
/// headers.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const std::vector<correction::Model>& models);

}  // namespace raceway::files

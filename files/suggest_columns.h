#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// Suggests a table [columns] (TOML) for a data file, from the words and units in its header and
/// its row of units. The table has a comment for each column that was not found. Throws InputError
/// like read_csv().
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

/// Suggests [columns] for a record over time and the corrections of a file. Words in the headers
/// identify the columns that the corrections need. Other columns get names made from their headers.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const std::vector<correction::Model>& models);

}  // namespace raceway::files

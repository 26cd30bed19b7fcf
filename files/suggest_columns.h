#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// Suggests a table [columns] (TOML) for a data file, from the words and units in its header and
/// its row of units; columns that were not found stand in it as comments. Throws InputError as
/// read_csv().
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

/// Suggests [columns] for a record over time and the corrections of a file: their columns by the
/// words of their names, others under names of their own.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const std::vector<correction::Model>& models);

}  // namespace raceway::files

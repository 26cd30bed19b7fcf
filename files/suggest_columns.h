#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// A table [columns] (TOML) for a file of somebody else, by the words and units in its header and
/// its row of units; what was not found stands in it as a comment. Throws InputError as read_csv().
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

/// The same of a record over time, for the corrections of a file: columns that they ask for by the
/// words of their names, others by names of their own.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const std::vector<correction::Model>& models);

}  // namespace raceway::files

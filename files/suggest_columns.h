#pragma once

#include <string>

#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// A table [columns] (TOML) for a file of somebody else, by the words and units in its header and
/// its row of units; what was not found stands in it as a comment. Throws InputError as read_csv().
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

}  // namespace raceway::files

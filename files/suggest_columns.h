#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "files/source.h"
#include "model/model_subject.h"

namespace raceway::files {

/// Proposes a table [columns] (TOML text), which assigns the columns of a measurement file to the
/// inputs of a model. The proposal uses the words in the header and the units in the header or in a
/// row of units. A TOML comment names each input for which no column was found. Throws InputError
/// if read_csv() rejects the file.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const model::ModelSubject& subject);

/// Proposes a table [columns] for a time record and these correction models. The function finds the
/// inputs of the models by the words in the header. Each other column gets a name that contains the
/// words of its header.
[[nodiscard]] std::string suggested_columns(const Source& source,
                                            const std::vector<correction::Model>& models);

}  // namespace raceway::files

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bearing/solve.h"
#include "c/raceway.h"
#include "files/model_file.h"
#include "session/source.h"

/// Model that raceway_create() returns. A model never changes, so several threads may use it.
struct raceway_model {
  raceway::files::ModelFile file;
  std::string messages;
  std::vector<std::string> columns;
};

namespace raceway::c {

/// Reads a model in the same way as the commands `solve` and `table`. Throws text::InputError. The
/// caller owns the model.
[[nodiscard]] raceway_model* open_handle(const session::Source& source);

/// Returns the RACEWAY_STATUS constant of raceway.h for a status of the solver.
[[nodiscard]] int status_number(bearing::SolveStatus status);

/// Returns the names of the columns with these indices. The result is empty if `columns` is NULL or
/// `count` is 0, which selects all columns. Throws text::InputError for an index out of range.
[[nodiscard]] std::vector<std::string> column_names(const raceway_model& model, const int* columns,
                                                    std::size_t count);

}  // namespace raceway::c

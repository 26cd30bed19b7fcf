#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bearing/solve.h"
#include "c/raceway.h"
#include "files/model_file.h"
#include "session/source.h"

/// Model that raceway_create() returns. The functions of raceway.h never change a model, so several
/// threads may use the same model.
struct raceway_model {
  raceway::files::ModelFile file;
  std::string messages;
  std::vector<std::string> columns;
};

namespace raceway::c {

/// Reads a model in the same way as the commands `solve` and `table`. Throws text::InputError for
/// an invalid model. The caller owns the returned model.
[[nodiscard]] raceway_model* open_handle(const session::Source& source);

/// Returns the RACEWAY_STATUS constant of raceway.h for a status of the solver.
[[nodiscard]] int status_number(bearing::SolveStatus status);

/// Returns the names of the columns with these indices. If `columns` is NULL or `count` is 0, the
/// result is empty, which means all columns. Throws text::InputError for an index out of range.
[[nodiscard]] std::vector<std::string> column_names(const raceway_model& model, const int* columns,
                                                    std::size_t count);

}  // namespace raceway::c

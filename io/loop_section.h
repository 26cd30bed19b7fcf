#pragma once

#include <vector>

#include "model/model.h"

// Last: see io/toml_text.h.
#include "io/model_tables.h"

/// [calibration] and [loop] of a model file: what is asked of it; shared with the reader of models,
/// not for other code. Both look at the model that all other tables make, and throw InputError as
/// read_model() does.
namespace raceway::io {

/// Full names of the parameters that may be fitted.
[[nodiscard]] Names read_free(ModelTables& tables, const model::Model& model);

/// `tolerance_Nmm`, `tolerance_um`, ...: of a channel that the model predicts.
[[nodiscard]] std::vector<record::NamedValue> read_tolerances(const ModelTables& tables,
                                                              const model::Model& model);

}  // namespace raceway::io

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Readers of [calibration] and [loop] of a model file; shared with the reader of models. Both
/// readers need the model from all other tables and throw InputError like read_model().
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> loop_tables();
[[nodiscard]] Section loop_section(const ModelTables& tables);
[[nodiscard]] Section calibration_section(const ModelTables& tables);

/// Returns the full names of the parameters that may be fitted.
[[nodiscard]] Names read_free(ModelTables& tables, const model::Model& model);

/// Reads [calibration.covariance]; returns nothing if the table is missing.
[[nodiscard]] std::optional<fit::Covariance> read_covariance(const ModelTables& tables,
                                                             const model::Model& model);

/// Returns a text if the covariance does not belong to the values of the model; empty if the values
/// agree.
[[nodiscard]] std::string other_values(const fit::Covariance& covariance,
                                       const model::Model& model);

/// Reads `tolerance_Nmm`, `tolerance_um`, ...: tolerances of channels that the model predicts.
[[nodiscard]] std::vector<record::NamedValue> read_tolerances(const ModelTables& tables,
                                                              const model::Model& model);

}  // namespace raceway::files

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"

// This include must be the last one: see text/detail/toml_text.h.
#include "files/detail/model_tables.h"

/// Reads the tables [calibration] and [loop] of a model file, after all other tables. All functions
/// throw InputError like read_model().
namespace raceway::files {

[[nodiscard]] std::vector<KeyTable> loop_tables();
[[nodiscard]] Section loop_section(const ModelTables& tables);
[[nodiscard]] Section calibration_section(const ModelTables& tables);

/// Returns the full names of the free parameters, which a fit can change.
[[nodiscard]] Names read_free(ModelTables& tables, const model::Model& model);

/// Returns the covariance in [calibration.covariance]; nothing if the table is missing.
[[nodiscard]] std::optional<fit::Covariance> read_covariance(const ModelTables& tables,
                                                             const model::Model& model);

/// Returns a description of the difference if the parameter values of the covariance differ from
/// the values of the model; otherwise an empty text.
[[nodiscard]] std::string other_values(const fit::Covariance& covariance,
                                       const model::Model& model);

/// Returns the tolerances in `tolerance_Nmm`, `tolerance_um`, ... for the quantities that the model
/// predicts.
[[nodiscard]] std::vector<record::NamedValue> read_tolerances(const ModelTables& tables,
                                                              const model::Model& model);

}  // namespace raceway::files

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

/// Functions for model data that may be wrong and that affect the predictions: contact angle and
/// groove conformity of bearings on a shaft, and for a spindle the inlet temperature of each
/// coolant circuit and the position of each thermometer. `diagnose` tests these data like effects,
/// and `add` corrects them in the model.
namespace raceway::model {

/// Returns the ids of the data that this model has.
[[nodiscard]] std::vector<std::string> own_data(const Model& model);

/// Returns a datum as a candidate that `diagnose` tests; empty if the model does not have the
/// datum.
[[nodiscard]] std::optional<fit::Candidate> own_datum(const Model& model, std::string_view id);

/// Returns the parameter of the candidate that own_datum() returns for the id. Throws
/// std::invalid_argument if the model does not have the datum.
[[nodiscard]] fit::Parameter own_datum_parameter(const Model& model, std::string_view id);

/// Returns an explanation of a datum, for any model; empty if the id is not a datum.
[[nodiscard]] std::string own_datum_explained(std::string_view id);

/// Describes a corrected datum: "contact angle 24.1 deg instead of the entered 25"; empty if the id
/// is not a datum.
[[nodiscard]] std::string own_datum_text(const Model& model, std::string_view id, double value);

}  // namespace raceway::model

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

/// Numbers of the model itself that may have been entered wrong and that what is measured feels: of
/// the bearings on a shaft the contact angle and the conformity of the grooves, of a spindle the
/// inlet temperature of its coolant and the place of each thermometer. They are tried as effects
/// are, and put right where they stand.
namespace raceway::model {

/// Ids of those that this model has.
[[nodiscard]] std::vector<std::string> own_data(const Model& model);

/// The number as something that may be wrong; nothing where the model has no such number.
[[nodiscard]] std::optional<fit::Candidate> own_datum(const Model& model, std::string_view id);

/// The parameter of the model behind it, with the name of the candidate.
[[nodiscard]] fit::Parameter own_datum_parameter(const Model& model, std::string_view id);

/// Explanation in one sentence, for any model; empty for another id.
[[nodiscard]] std::string own_datum_explained(std::string_view id);

/// "contact angle 24.1 deg where 25 is entered"; empty for another id.
[[nodiscard]] std::string own_datum_text(const Model& model, std::string_view id, double value);

}  // namespace raceway::model

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"

/// Functions for uncertain data of a model. For bearing sets on a shaft, these data are the contact
/// angle and the groove conformity. For a spindle, these data are the inlet temperature of each
/// coolant circuit and the position of each thermometer. `diagnose` tests whether these data are
/// wrong, and `add` corrects them in the model.
namespace raceway::model {

/// Returns the ids of the uncertain data in this model.
[[nodiscard]] std::vector<std::string> own_data(const Model& model);

/// Returns one uncertain datum in the form in which `diagnose` tests it. The result is empty if the
/// model does not have the datum.
[[nodiscard]] std::optional<fit::Candidate> own_datum(const Model& model, std::string_view id);

/// Returns the parameter that describes this uncertain datum, as in the result of own_datum().
/// Throws std::invalid_argument if the model does not have the datum.
[[nodiscard]] fit::Parameter own_datum_parameter(const Model& model, std::string_view id);

/// Explains an uncertain datum. The text is empty if the id is unknown.
[[nodiscard]] std::string own_datum_explained(std::string_view id);

/// Describes a corrected datum: "contact angle 24.1 deg instead of the entered 25". The text is
/// empty if the model has no datum with this id.
[[nodiscard]] std::string own_datum_text(const Model& model, std::string_view id, double value);

}  // namespace raceway::model

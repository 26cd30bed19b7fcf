#pragma once

#include <optional>

#include "verdict/diagnosis.h"
#include "verdict/evidence.h"

namespace raceway::verdict {

/// Fits a power law of the inputs to the misfit of the first channel, together with all free
/// parameters of the model. Subject::formula() gives the inputs. The result is empty if
/// Subject::formula() is empty or if no fit converges.
[[nodiscard]] std::optional<fit::Shape> find_unknown_shape(const Evidence& evidence);

}  // namespace raceway::verdict

#pragma once

#include <string>

#include "effects/effect.h"
#include "fit/data_set.h"
#include "fit/model.h"

namespace raceway::fit {

/// What an effect cannot be felt without and the model or the data do not have, in words; empty if
/// there is nothing. A need for several levels is not among these: whether base parameters do the
/// same is found out on the data themselves.
[[nodiscard]] std::string missing_need(const effects::Description& effect, const Model& model,
                                       const DataSet& data);

/// The levels an effect wants and the data do not have: without them base parameters do nearly the
/// same; empty if there is nothing.
[[nodiscard]] std::string missing_levels(const effects::Description& effect, const Model& model,
                                         const DataSet& data);

}  // namespace raceway::fit

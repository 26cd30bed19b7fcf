#pragma once

#include <memory>

#include "bearing/bearing.h"
#include "effects/effect.h"

namespace raceway::model {

/// The bearing with grown rings and other balls; null where it has no free contact angle left.
/// Growth u of the inner raceway moves its groove centres outwards: cos α0 -> cos α0 + u/(B D).
[[nodiscard]] std::shared_ptr<const bearing::Bearing> changed_bearing(
    const bearing::Bearing& entered, const effects::Condition& condition);

}  // namespace raceway::model

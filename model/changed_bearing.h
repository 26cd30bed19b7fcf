#pragma once

#include <memory>

#include "bearing/bearing.h"
#include "effects/effect.h"

namespace raceway::model {

/// Returns the bearing with grown rings and changed balls; null if no free contact angle remains. A
/// growth u of the inner raceway moves its groove centres outwards: cos α0 -> cos α0 + u/(B D).
[[nodiscard]] std::shared_ptr<const bearing::Bearing> changed_bearing(
    const bearing::Bearing& entered, const effects::Condition& condition);

}  // namespace raceway::model

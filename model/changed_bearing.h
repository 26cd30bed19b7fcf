#pragma once

#include <memory>

#include "bearing/bearing.h"
#include "effects/effect.h"

namespace raceway::model {

/// Returns the bearing with the ring growth and the ball material of `condition`; null if no such
/// bearing is possible, for example because no free contact angle remains. A radial growth u of the
/// inner raceway moves its groove centres outwards: cos α0 -> cos α0 + u/(B D). α0 is the free
/// contact angle, and B D is the distance between the groove centres of both rings. In a
/// deep-groove bearing, the growth reduces the clearance by 2 u.
[[nodiscard]] std::shared_ptr<const bearing::Bearing> changed_bearing(
    const bearing::Bearing& entered, const effects::Condition& condition);

}  // namespace raceway::model

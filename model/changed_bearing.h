#pragma once

#include <memory>

#include "bearing/bearing.h"
#include "effects/effect.h"

namespace raceway::model {

/// Returns a copy of the bearing with the ring growth and the ball material in `condition`. The
/// result is null if this bearing is geometrically impossible, for example if the ring growth uses
/// up all radial play, so that no free contact angle remains. A radial growth u of the inner
/// raceway changes the free contact angle α0: cos α0 -> cos α0 + u/(B D). B D is the distance
/// between the centres of groove curvature of both rings, with the ball diameter D. If α0 is zero
/// (deep-groove bearing), the growth reduces the radial clearance by 2 u.
[[nodiscard]] std::shared_ptr<const bearing::Bearing> changed_bearing(
    const bearing::Bearing& entered, const effects::Condition& condition);

}  // namespace raceway::model

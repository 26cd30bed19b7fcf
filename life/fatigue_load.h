#pragma once

#include "bearing/bearing.h"

namespace raceway::life {

/// Fatigue load limit of a ball bearing of good bearing steel [N].
///
///   C_u = 0.2288 Z Q_u cos α                        d_m <= 100 mm
///   C_u = 0.2288 Z Q_u cos α (100 mm/d_m)^0.5       d_m >  100 mm
///
/// Q_u is the smallest ball load at which the inner or the outer contact reaches a pressure of 1500
/// MPa. Z is the number of balls, α the nominal contact angle and d_m the pitch diameter.
/// Source:   [ISO281, annex B, eqs. B.9 to B.11], as quoted in two texts, not checked against the
///           printed standard.
/// Domain:   radial ball bearings, α up to 45 deg; the result is NaN above 45 deg. The function
///           always uses steel for balls and rings (elastic modulus 207 GPa, Poisson's ratio 0.3),
///           because the standard covers no other material. The standard gives no value for hybrid
///           bearings.
[[nodiscard]] double fatigue_load(const bearing::BearingGeometry& geometry);

}  // namespace raceway::life

#pragma once

#include "bearing/bearing.h"

namespace raceway::life {

/// Fatigue load limit of a ball bearing of good bearing steel [N].
///
///   C_u = 0.2288 Z Q_u cos α                        d_m <= 100 mm
///   C_u = 0.2288 Z Q_u cos α (100 mm/d_m)^0.5       d_m >  100 mm
///
/// Q_u is the smallest ball load at which one of the two contacts reaches a pressure of 1500 MPa. α
/// is the nominal contact angle.
/// Source:   [ISO281, annex B, eqs. B.9 to B.11], as quoted in two texts, not checked against the
///           print.
/// Domain:   radial ball bearings, α up to 45 deg; NaN above. The function always uses the modulus
///           207 GPa and Poisson's ratio 0.3 of steel, for balls and rings. The standard covers no
///           other material, and gives no value for hybrid bearings.
[[nodiscard]] double fatigue_load(const bearing::BearingGeometry& geometry);

}  // namespace raceway::life

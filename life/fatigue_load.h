#pragma once

#include "bearing/bearing.h"

namespace raceway::life {

/// Fatigue load limit of good bearing steel [N].
///
///   C_u = 0.2288 Z Q_u cos α                        d_m <= 100 mm
///   C_u = 0.2288 Z Q_u cos α (100 mm/d_m)^0.5       above
///
/// Q_u: load of the ball contact, of the two, that reaches 1500 MPa first. α nominal.
/// Source:   [ISO281, annex B, eqs. B.9 to B.11], print not seen; read in two texts.
/// Domain:   radial ball bearings, α up to 45 deg; no number beyond. Steel of 207 GPa and 0.3 in
///           balls and rings, for any bearing: the standard covers no other material and gives no
///           value for hybrid bearings.
[[nodiscard]] double fatigue_load(const bearing::BearingGeometry& geometry);

}  // namespace raceway::life

#pragma once

#include <string_view>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Position of the loaded balls of an angular-contact bearing in the inner groove.
enum class Seat {
  shoulder,       ///< against the shoulders, the intended position
  groove_bottom,  ///< at the bottom, without contact angle
  far_side        ///< some beyond the bottom, where such a bearing has no shoulder
};

/// Name of the seat in JSON results, e.g. "groove_bottom".
[[nodiscard]] std::string_view name(Seat seat);

/// Determines the seat from the least and largest inner contact angles of the loaded balls [rad].
///
/// A ball at a contact angle pushes the ring away along the axis. Under a radial load alone these
/// pushes have to vanish together, and with a shoulder on one side only they are all of one sign:
/// the ring stands back until the groove centres lie opposite each other, and the load is carried
/// at contact angle 0. A moment without enough axial load needs balls that push the other way; the
/// solver lets grooves go on beyond the bottom, a real bearing comes apart there.
///
/// Domain:   angles within a tenth of the nominal one count as none; α0 = 0 (deep groove, with two
///           shoulders) is always seated.
[[nodiscard]] Seat seat(double least_inner_angle, double largest_inner_angle, double contact_angle);
[[nodiscard]] Seat seat(const BearingEquilibrium& equilibrium, const BearingGeometry& geometry);

/// Axial load that presses half of the circle against the shoulders under a radial load, the
/// contact angle held at its nominal value [N]: 1.22 F_r tan α0.
/// Source: the load integrals of point contact, J_a/J_r = 0.2782/0.2288 at ε = 0.5
///         [Harris2006, vol. 1, ch. 7], recomputed.
[[nodiscard]] double seating_load(double radial_load, double contact_angle);

}  // namespace raceway::bearing

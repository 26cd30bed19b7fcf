#pragma once

#include <string_view>

#include "bearing/bearing_equilibrium.h"

namespace raceway::bearing {

/// Position of the loaded balls of an angular-contact bearing in the inner groove.
enum class Seat {
  shoulder,       ///< on the side of the shoulder, as intended
  groove_bottom,  ///< at the bottom of the groove, with contact angle 0
  far_side        ///< some balls on the other side of the bottom, where there is no shoulder
};

/// Name of the seat in JSON results, e.g. "groove_bottom".
[[nodiscard]] std::string_view name(Seat seat);

/// Determines the seat from the least and largest inner contact angles of the loaded balls [rad].
///
/// A ball with a contact angle above 0 pushes the ring along the axis. If the groove has a shoulder
/// on one side only, all balls push in the same direction. Under a purely radial load, the sum of
/// the axial ball forces must be zero, so each axial ball force is zero. The ring moves axially
/// until the balls carry the load at contact angle 0. If a moment acts without enough axial load,
/// an equilibrium needs balls that push in the opposite direction. The solver permits this opposite
/// contact, because the grooves of the model continue on the other side of the bottom. In a real
/// bearing without a second shoulder, the rings separate.
///
/// Domain:   angles up to a tenth of the nominal contact angle α0 are treated as zero. The result
///           is `shoulder` for a deep-groove bearing (α0 = 0, two shoulders) and for a bearing
///           without loaded balls.
[[nodiscard]] Seat seat(double least_inner_angle, double largest_inner_angle, double contact_angle);
[[nodiscard]] Seat seat(const BearingEquilibrium& equilibrium, const BearingGeometry& geometry);

/// Returns the axial load that seats a bearing under a radial load F_r [N]: 1.22 F_r tan α0. At
/// this axial load, half of the balls carry load, on the side of the shoulders. α0 is the nominal
/// contact angle `contact_angle`.
/// Source: the load integrals of point contact, J_a/J_r = 0.2782/0.2288 for a load zone of half the
///         circumference (ε = 0.5) [Harris2006, vol. 1, ch. 7], recomputed.
[[nodiscard]] double seating_load(double radial_load, double contact_angle);

}  // namespace raceway::bearing

#pragma once

#include <span>

#include "model/model.h"
#include "record/record.h"

namespace raceway::rig {

/// Time in which a free shaft slows down from one speed to another.
struct Fall {
  double from = unset, to = unset;  ///< [rad/s], from > to > 0
  double time = unset;              ///< duration of the fall [s]
  double time_deviation = unset;    ///< standard deviation of the time [s]; NaN if unknown
};

/// Returns the speed at which a torque M ~ ω^p equals the mean torque over the time of a fall
/// [rad/s].
///
/// A shaft with the inertia J slows down from ω1 to ω2 in the time t. The mean torque over time,
/// J (ω1 - ω2)/t, is the harmonic mean of M(ω) over speed, because dt = J dω/M(ω):
///
///   1/M(ω_e) = ∫ dω/M / (ω1 - ω2)   gives   ω_e^-p = (ω1^(1-p) - ω2^(1-p)) / ((1 - p)(ω1 - ω2))
///
/// ω_e is a Stolarsky mean of ω1 and ω2. For p = 1, ω_e is the logarithmic mean. For p = 2, ω_e is
/// sqrt(ω1 ω2).
/// Source:   derived.
/// Domain:   ω1 > ω2 > 0, any p. For p = 0 and p = 1, the result is the limit of the formula.
/// Accuracy: the result has only rounding errors. With the mean ω of ω1 and ω2 instead of ω_e, the
///           relative error of the torque would be p (p + 1) s²/24 with s = (ω1 - ω2)/ω. For p = 2
///           and s = 0.1, this is 0.25 %.
[[nodiscard]] double speed_of_mean_torque(double from, double to, double exponent);

/// Computes the friction torque of the rig from the times between given speeds [N m], one row for
/// each fall:
///
///   M = J (ω1 - ω2)/t   at   ω_e = speed_of_mean_torque(ω1, ω2, p) (1 + (p'/p) s²/24)
///
/// s = (ω1 - ω2)/ω is the relative width of the fall, with the mean ω of ω1 and ω2. The exponent p
/// and its change p' = dp/d ln ω come from a parabola of ln M over ln ω. The parabola passes
/// through the row and two neighbours: the nearest fall at lower speed and the nearest fall at
/// higher speed. A neighbour belongs to the same run as the row and has the same inputs except the
/// speed. The mean speed of a neighbour lies outside the speed range of the row. The fastest and
/// the slowest fall of a run have neighbours on one side only; for these two falls, the function
/// uses the two nearest falls on that side. p and p'/p are limited to the range from -4 to 4. With
/// only one neighbour, p' is 0. Without neighbours, p' is 0 and p is 2/3, as for the viscous moment
/// of the Palmgren law. ω_e is correct to second order in s for every smooth law.
///
/// `falls` has one entry for each row of `record`. `record` contains the runs and all inputs except
/// the speed. The result is a copy of `record` with the speed ω_e and the torque M of each row. If
/// every fall has a standard deviation σ_t of its time t, the torque M has the standard deviation M
/// σ_t/t. Throws std::invalid_argument if the inertia is missing or not positive, if `falls` and
/// `record` differ in length, and for a fall that does not satisfy from > to > 0 and time > 0. The
/// message gives the line of this fall.
[[nodiscard]] record::Record fall_torque(const record::Record& record, std::span<const Fall> falls,
                                         const model::Rig& rig);

}  // namespace raceway::rig

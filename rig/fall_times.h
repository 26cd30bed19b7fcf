#pragma once

#include <span>

#include "model/model.h"
#include "record/record.h"

namespace raceway::rig {

/// Time in which a shaft slows down from one speed to another by itself.
struct Fall {
  double from = unset, to = unset;  ///< [rad/s], from > to > 0
  double time = unset;              ///< of the fall [s]
  double time_deviation = unset;    ///< standard deviation of it [s]; NaN: not declared
};

/// Speed at which a torque M ~ ω^p equals its mean over the time of a fall [rad/s].
///
/// The mean over time, J (ω1 - ω2)/t, is the harmonic mean over speed, as dt = J dω/M(ω):
///
///   1/M(ω_e) = ∫ dω/M / (ω1 - ω2)   gives   ω_e^-p = (ω1^(1-p) - ω2^(1-p)) / ((1 - p)(ω1 - ω2))
///
/// a mean of Stolarsky's: for p = 1 the logarithmic one, for p = 2 sqrt(ω1 ω2).
/// Source:   derived.
/// Domain:   ω1 > ω2 > 0, any p; p = 0 and p = 1 are limits.
/// Accuracy: rounding. The middle of the speeds instead would be wrong in M by p (p + 1) s²/24 with
///           s = (ω1 - ω2)/ω, 0.25 % for p = 2 at s = 0.1.
[[nodiscard]] double speed_of_mean_torque(double from, double to, double exponent);

/// Friction torque of the rig from the times between given speeds [N m]: a row for each fall,
///
///   M = J (ω1 - ω2)/t   at   ω_e = speed_of_mean_torque(ω1, ω2, p) (1 + (p'/p) s²/24)
///
/// Exponent p and its change p' = dp/d ln ω come from a parabola of ln M over ln ω through the row
/// and its neighbours: falls of the same run with the same inputs whose middle is further off than
/// half a fall. At an end they are the next two; of two falls p' is 0, of a single one p = 2/3, as
/// for a viscous moment. With it ω_e is right to second order in s for every smooth law.
///
/// `falls` has one for each row of `record`, which holds what else was recorded, inputs and runs; a
/// speed that it has is replaced. A deviation of the time makes one of the torque, σ_M = M σ_t/t.
/// Throws std::invalid_argument: no inertia, other lengths, a fall that is none (names the place).
[[nodiscard]] record::Record fall_torque(const record::Record& record, std::span<const Fall> falls,
                                         const model::Rig& rig);

}  // namespace raceway::rig

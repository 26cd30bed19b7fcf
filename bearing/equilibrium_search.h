#pragma once

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// True if statics proves that no equilibrium exists. There are two cases: no load acts in a
/// direction in which the ring can move, or an axial load pulls the ring of an angular-contact
/// bearing off its shoulder. The balls of such a bearing push the ring in one direction only, so
/// their axial forces cannot balance this load.
[[nodiscard]] bool cannot_balance(const RingSystem& system, const OperatingPoint& point);

/// Finds an equilibrium at `point`, the operating point of the system, by Newton's method. If
/// `neighbour` has a solution, the search starts from this solution. If this start fails, the
/// search tries these methods in this order:
///   1. the closed-form thrust solution as start,
///   2. under inner control, guesses which balls touch the inner race, beginning with a guess from
///      statics (lost_contacts.h),
///   3. increasing radial load and moment in steps, from pure thrust to the full load,
///   4. increasing the speed in steps, from standstill to full speed, under the full load,
///   5. if the axial load is below a tenth of the radial load, increasing the axial load in steps,
///      from zero to the full axial load,
///   6. under inner control, guesses in which the least loaded balls do not touch the inner race,
///      then guesses that differ from a guess of step 2 by one ball, with more Newton steps,
///   7. under inner control, guesses that are found on a grid of ring positions (contact_scan.h).
///
/// Without axial load, the search uses only step 4. Under outer control, the ball forces are
/// continuous functions of the ring displacement, and steps 1, 3, 4 and 5 have found every
/// equilibrium that is known to exist. Under inner control, the gyroscopic couple of a ball becomes
/// zero when the ball loses the inner contact, so an equilibrium may exist only for one combination
/// of lost contacts. At about 0.02 % of random operating points under inner control, the search
/// does not find a known equilibrium (docs/solver.md).
[[nodiscard]] SolveStatus find_equilibrium(RingSystem& system, const OperatingPoint& point,
                                           const BearingEquilibrium* neighbour, RingState& state);

}  // namespace raceway::bearing

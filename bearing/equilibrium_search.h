#pragma once

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// True if statics excludes an equilibrium: no load acts on the free coordinates, or an axial load
/// pulls the ring of an angular-contact bearing off its shoulder. The balls of such a bearing push
/// the ring in one direction only, so their axial forces cannot balance this load.
[[nodiscard]] bool cannot_balance(const RingSystem& system, const OperatingPoint& point);

/// Finds an equilibrium at the system's operating point by Newton's method. If `neighbour` has a
/// solution, the search starts from this solution. If that fails, the search tries in this order:
///   1. the closed-form thrust solution as start,
///   2. under inner control, the inner contacts that statics allows (lost_contacts.h),
///   3. following the solution from pure thrust to the full radial load and moment,
///   4. following the solution from standstill to full speed, under the full load,
///   5. if the axial load is below a tenth of the radial load, following the solution from zero to
///      the full axial load,
///   6. under inner control, states in which the least loaded balls have lost the inner race, then
///      sets of contacts that differ from a set of step 2 by one ball, with more Newton steps,
///   7. under inner control, the contacts that occur on a grid of ring positions (contact_scan.h).
///
/// Without axial load, the search uses only step 4. Under outer control the forces are continuous
/// in the displacement, and steps 1, 3, 4 and 5 find every equilibrium that is known to exist.
/// Under inner control the gyroscopic couple vanishes with the contact, so an equilibrium may exist
/// only for one combination of lost contacts. Steps 2 and 6 try the likely combinations of lost
/// contacts, and step 7 tries the combinations that occur on a grid of ring positions. Under inner
/// control, the search misses a known equilibrium at about 0.02 % of random operating points
/// (docs/solver.md).
[[nodiscard]] SolveStatus find_equilibrium(RingSystem& system, const OperatingPoint& point,
                                           const BearingEquilibrium* neighbour, RingState& state);

}  // namespace raceway::bearing

#pragma once

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// True where statics alone shows that nothing balances the load: there is no load that the ring
/// can move under, or an axial load pulls the ring of an angular-contact bearing off its shoulder.
/// Its balls push the ring one way alone, so that no sum of their axial forces is that load.
[[nodiscard]] bool cannot_balance(const RingSystem& system, const OperatingPoint& point);

/// Finds a state of balance for the system's operating point, from a neighbour's solution where one
/// is given, and otherwise by
///   1. Newton from the closed-form thrust solution,
///   2. under inner control, from the balls that statics lets keep the inner race
///   (lost_contacts.h),
///   3. following the solution from pure thrust to the full radial load and moment,
///   4. following it from standstill to full speed,
///   5. where the axial load is small, following it from the radial load alone,
///   6. under inner control, from states without the balls that carry least, and more of 2,
///   7. under inner control, from the sets of contacts that a scan over the places of the ring
///   finds (contact_scan.h).
/// Under outer control the forces are continuous in the displacement and the paths find every state
/// known to exist. Under inner control the gyroscopic couple vanishes with the contact, a state can
/// hang on a combination of lost balls; 2 and 6 try those that are likely, 7 those that occur at
/// the nodes of a grid. 0.01 % of the states that exist are missed still (docs/solver.md).
[[nodiscard]] SolveStatus find_equilibrium(RingSystem& system, const OperatingPoint& point,
                                           const BearingEquilibrium* neighbour, RingState& state);

}  // namespace raceway::bearing

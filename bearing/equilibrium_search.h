#pragma once

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Finds a state of balance for the system's operating point, from a neighbour's solution where one
/// is given, and otherwise by
///   1. Newton from the closed-form thrust solution,
///   2. following the solution from pure thrust to the full radial load and moment,
///   3. following it from standstill to full speed,
///   4. where the axial load is small, following it from the radial load alone,
///   5. under inner control, searching which balls have lost the inner race.
/// Under outer control the forces are continuous in the displacement and 1 to 4 find every state
/// known to exist. Under inner control the gyroscopic couple vanishes with the contact, a state can
/// hang on a combination of lost balls; 5 tries the combinations that are contiguous in the
/// direction of the load, and a few more.
[[nodiscard]] SolveStatus find_equilibrium(RingSystem& system, const OperatingPoint& point,
                                           const BearingEquilibrium* neighbour, RingState& state);

}  // namespace raceway::bearing

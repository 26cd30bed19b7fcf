#pragma once

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Under inner control: looks for a state of balance with each ball's inner contact held kept or
/// lost, from the set of kept balls that statics chooses (load_shares.h). Kept balls that would
/// pull are dropped and lost ones that reach into the race are added until neither is left; where
/// that comes back to a set it has seen, sets beside it are tried. At most `steps` Newton steps.
[[nodiscard]] bool settle_contacts(RingSystem& system, int steps, RingState& state);

}  // namespace raceway::bearing

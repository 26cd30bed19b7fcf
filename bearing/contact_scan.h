#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// A set of kept and lost inner contacts, and where ring and balls stood when it occurred.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< of the balls that are unknowns
  RingState state;
  double imbalance;  ///< largest component of the unbalanced load, by the load [1]
};

/// Under inner control: which inner contacts can be kept together, from a scan over places of the
/// ring. The last resort, where statics (load_shares.h) and the paths have led to no balance.
///
/// The ring is put to the nodes of a grid: axially, along the load and, with free tilt, turned
/// about the axis across it. At each node every ball is balanced by itself in all the ways in which
/// it can stand there: on the inner race at a larger or a smaller contact angle, or off it. Of
/// these ways the balls take, by turns, those that leave the least of the load. The sets that occur
/// are returned in rising order of imbalance: each from the node that leaves least (within a
/// third), and from earlier ones that at their time were the nearest by such a margin.
///
/// A set is a start and no balance: whether its contacts hold, Newton's method says.
///
/// Source:   the brute-force search of bench/equilibrium_scan.h, made quick: a ball depends on the
///           place of its groove alone, so balls come from a table over these places.
/// Domain:   inner control at speed, two balls or more as unknowns. `direction` is the azimuth of
///           the load [rad]; a ring that stands across it is not looked at.
/// Accuracy: a set that occurs between the nodes alone is missed; docs/solver.md says how often.
/// Cost:     6 to 8 ms for the bearings of a spindle, up to 25 ms for 200 balls.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

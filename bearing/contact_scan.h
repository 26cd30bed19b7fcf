#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// A set of kept and lost inner contacts, with the positions of ring and balls where it occurred.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< of the balls that are unknowns
  RingState state;
  double imbalance;  ///< largest component of the unbalanced load, by the load [1]
};

/// Finds inner contacts that can exist together under inner control, by a scan over ring positions.
/// It is the last resort when statics (load_shares.h) and continuation find no equilibrium.
///
/// The ring is put to the nodes of a grid: axially, along the load and, with free tilt, turned
/// about the axis across it. At each node every ball is balanced by itself in all the ways in which
/// it can stand there: on the inner race at a larger or a smaller contact angle, or off it. Of
/// these ways the balls take, by turns, those that leave the least of the load. The sets that occur
/// are returned in rising order of imbalance: each from the node that leaves least (within a
/// third), and from earlier ones that at their time were the nearest by such a margin.
///
/// A set is a start, not an equilibrium; Newton's method decides if its contacts hold.
///
/// Source:   the brute-force search of bench/equilibrium_scan.h, accelerated: a ball depends only
///           on its groove position, so balls come from a table over these positions.
/// Domain:   inner control at speed, two balls or more as unknowns. `direction` is the azimuth of
///           the load [rad]; ring positions across it are not tested.
/// Accuracy: a set that occurs only between nodes is missed; docs/solver.md gives the frequency.
/// Cost:     6 to 8 ms for the bearings of a spindle, up to 25 ms for 200 balls.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

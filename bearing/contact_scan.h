#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// A set of kept and lost inner contacts, with the positions of ring and balls at which the set
/// occurred.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< contacts of the balls that are unknowns
  RingState state;
  double imbalance;  ///< largest component of the unbalanced load, relative to the load [1]
};

/// Finds inner contacts that can exist together under inner control, by a scan over ring positions.
/// The scan is the last resort when statics (load_shares.h) and continuation find no equilibrium.
///
/// The scan moves the ring to the nodes of a grid: along the axis, along the load and, with free
/// tilt, turned about the axis across the load. At each node the scan solves the equilibrium of
/// each ball separately. A ball has up to three states: on the inner race at a larger or a smaller
/// contact angle, or without contact with the inner race. For one ball after the other, the scan
/// selects the state that reduces the imbalance of the ring most. The sets that occur are returned
/// in rising order of imbalance. A set is returned with the positions at the first node at which it
/// occurs. A set is returned again for a later node if the imbalance at this node is at most 0.7
/// times the imbalance for which the set was returned last.
///
/// A set is a starting state, not an equilibrium. Newton's method decides whether the contacts of
/// the set are valid.
///
/// Source:   the brute-force search of bench/equilibrium_scan.h, accelerated. The state of a ball
///           depends only on its groove position, so the scan reads balls from a table over these
///           positions.
/// Domain:   inner control at speed, two balls or more as unknowns. `direction` is the azimuth of
///           the load [rad]; ring positions across it are not tested.
/// Accuracy: a set that occurs only between nodes is missed; docs/solver.md gives the frequency.
/// Cost:     a few milliseconds for the bearings of a spindle, see docs/speed.md.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

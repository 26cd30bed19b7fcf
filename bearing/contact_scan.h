#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Combination of kept and lost inner contacts, with the ring and ball positions of this
/// combination.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< contacts of the balls that are unknowns
  RingState state;
  double imbalance;  ///< largest component of the unbalanced load, relative to the load [1]
};

/// Finds sets of inner contacts that can exist together under inner control, by a scan over ring
/// positions. The scan is the last resort when statics (load_shares.h) and continuation find no
/// equilibrium.
///
/// The scan moves the ring to the nodes of a grid over the axial displacement, the displacement
/// along the load and, with free tilt, the tilt about the axis perpendicular to the load. At each
/// node the scan solves the equilibrium of each ball separately. A ball has up to three states: on
/// the inner race at a larger or a smaller contact angle, or without contact with the inner race.
/// For one ball after the other, the scan selects the state that reduces the imbalance of the ring
/// most. The function returns the sets of contacts that occur, in rising order of imbalance. Each
/// set has the positions at the first node at which it occurs. A set is returned again for a later
/// node if the imbalance at this node is at most 0.7 times the imbalance for which the set was
/// returned last.
///
/// A set is a starting state, not an equilibrium. Newton's method decides whether the contacts of
/// the set are valid.
///
/// Source:   a faster version of the brute-force search of bench/equilibrium_scan.h. The
///           equilibrium of a ball depends only on the position of its inner groove centre, so the
///           scan uses a table of balls over these positions.
/// Domain:   inner control, speed > 0, two balls or more as unknowns. `direction` is the azimuth of
///           the radial load or, without radial load, the azimuth that the moment loads most [rad].
///           Displacements perpendicular to this direction are not tested.
/// Accuracy: the scan misses a set that occurs only between nodes. docs/solver.md gives the share
///           of missed equilibria.
/// Cost:     a few milliseconds for a spindle bearing, see docs/speed.md.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

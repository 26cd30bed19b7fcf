#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// Combination of kept and lost inner contacts, with the ring and ball positions of this
/// combination.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< inner contact of each distinct ball (see balls.h)
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
/// The scan repeatedly changes the state of one ball, each time the change that reduces the
/// imbalance of the ring most. The resulting set of contacts is stored with the positions of ring
/// and balls. If the same set occurs again at a later node, it is stored again only if its
/// imbalance is at most 0.7 times the imbalance of the last stored entry of this set. The function
/// returns all entries in rising order of imbalance.
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

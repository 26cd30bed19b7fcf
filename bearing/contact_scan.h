#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// One assumption about the inner contact of every ball (InnerContact::kept or lost), with the ring
/// and ball positions for this assumption.
struct ScannedSet {
  std::vector<InnerContact> contacts;  ///< inner contact of each distinct ball (see balls.h)
  RingState state;
  double imbalance;  ///< largest component of the unbalanced load, relative to the load [1]
};

/// Finds possible sets of inner contacts under inner control, by a scan over ring positions. A set
/// states for each ball whether the ball touches the inner race. The solver uses the scan only if
/// all other methods find no equilibrium (equilibrium_search.h).
///
/// The scan moves the ring to the nodes of a grid over the axial displacement, the displacement
/// along the load and, with free tilt, the tilt about the axis perpendicular to the load. At each
/// node the scan solves the equilibrium of each ball separately. A ball has up to three states: on
/// the inner race at a larger or a smaller contact angle, or without contact with the inner race.
/// From the states at a node, the scan makes a sequence of changes. Each change gives one ball
/// another state, so that the imbalance of the ring becomes as small as possible. When no change
/// reduces the imbalance by more than 0.1 %, the set of contacts is stored with the positions of
/// ring and balls. A set that is already stored is stored again only if its imbalance at a later
/// node is at most 0.7 times the earlier imbalance. The function returns all stored sets in rising
/// order of imbalance.
///
/// A returned set is a start for Newton's method, not an equilibrium. The result of Newton's method
/// shows whether the contacts of the set are valid.
///
/// Source:   a faster version of the brute-force search in bench/equilibrium_scan.h. The
///           equilibrium of a ball depends only on the position of its inner groove centre, so the
///           scan computes a table of ball equilibria over these positions.
/// Domain:   inner control, speed > 0, at least two distinct balls. `direction` is the azimuth of
///           the radial load [rad]. Without radial load, `direction` is the azimuth at which the
///           moment loads the balls most. Ring displacements perpendicular to this direction are
///           not tested.
/// Accuracy: the scan does not find a set that occurs only between nodes. docs/solver.md gives the
///           share of equilibria that the solver does not find.
/// Cost:     a few milliseconds for a spindle bearing, see docs/speed.md.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

#pragma once

#include <vector>

#include "bearing/ring_system.h"

namespace raceway::bearing {

/// A set of kept and lost inner contacts that occurs with the ring and the balls near by.
struct ScannedSet {
  std::vector<InnerContact> contacts;
  RingState state;
  double imbalance;  ///< of the ring there, of the load [1]
};

/// Under inner control, where all else has found nothing: the ring put to the places of a grid
/// along the load, in its plane and with free tilt about the axis across it; at each every ball
/// balanced by itself with its inner contact kept, or where it cannot be, lost, and the other way
/// round. Returns the sets that occur, each from where the ring is nearest to balance, those first
/// that come nearest. Takes some 10 ms.
[[nodiscard]] std::vector<ScannedSet> scan_contacts(const RingSystem& system, double direction);

}  // namespace raceway::bearing

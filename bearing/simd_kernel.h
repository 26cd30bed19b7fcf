#pragma once

#include <cstddef>

#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// Eight operating points of a KernelCall, with their results. All axial loads are above 0.
struct KernelBlock {
  RingPoint<Eight> points;
  bool converged[Eight::size];
  int steps[Eight::size];  ///< number of Newton steps
  Eight ring[5];           ///< ring displacement; tilts are multiplied by RingPoint::lever [m]
  RingReport<Eight> report;
};

/// Points that one call of a kernel solves. All points have equal ball count, symmetry, ball model
/// and free coordinates. If the points do not fill the last block, the caller must fill the
/// remaining lanes with any point. The results of the remaining lanes are not used.
struct KernelCall {
  BallCircle circle;
  BallModel model;
  bool tilts;
  double tolerance;
  KernelBlock* blocks;
  std::size_t count;         ///< number of points
  BallReport<Eight>* balls;  ///< circle.used() reports for each block
};

// These functions solve many points in parallel by Newton's method from the closed-form thrust
// start, and report their balls. The search for single points solves the points that do not
// converge here. A result does not depend on the other points of the call. There is one function
// for each instruction set.
void solve_sse2(const KernelCall& call);
void solve_avx2(const KernelCall& call);
void solve_avx512(const KernelCall& call);

}  // namespace raceway::bearing

#pragma once

#include <cstddef>

#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// Eight operating points and their results. The points are calculated in parallel. `Eight`
/// contains one number for each point; the place of a number is called a lane (lanes.h). The axial
/// load of each point is above 0.
struct KernelBlock {
  RingPoint<Eight> points;
  bool converged[Eight::size];
  int steps[Eight::size];  ///< number of Newton steps
  /// Displacement of the inner ring [m]. The two tilts are multiplied by RingPoint::lever.
  Eight ring[5];
  RingReport<Eight> report;
};

/// Operating points for one call of solve_sse2(), solve_avx2() or solve_avx512(), eight in each
/// block. All points have the same number of balls, the same symmetry of the load, the same ball
/// model and the same free coordinates of the inner ring. If the points do not fill the last block,
/// the caller must fill the remaining lanes with any point. The results of these lanes are not
/// used.
struct KernelCall {
  BallCircle circle;
  BallModel model;
  bool tilts;
  double tolerance;
  KernelBlock* blocks;
  std::size_t count;  ///< number of points
  /// Results of the balls. Each block has circle.used() elements, one for each distinct ball.
  BallReport<Eight>* balls;
};

// These functions solve many points in parallel by Newton's method, and write the results to
// KernelCall::blocks and KernelCall::balls. Newton's method starts from the approximate solution
// for pure thrust (thrust_start.h). If a point does not converge in these functions, the caller
// solves this point alone (solve_many.h). A result does not depend on the other points of the call.
// There is one function for each instruction set.
void solve_sse2(const KernelCall& call);
void solve_avx2(const KernelCall& call);
void solve_avx512(const KernelCall& call);

}  // namespace raceway::bearing

#pragma once

#include <cstddef>

#include "bearing/ring_balance.h"

namespace raceway::bearing {

/// One operating point on its way through a kernel. Axial load > 0.
struct KernelPoint {
  RingPoint<double> point;
  bool converged;
  int steps;       ///< of Newton's method
  double ring[5];  ///< displacement, tilts times the lever [m]
  RingReport<double> report;
};

/// Points that share ball count, symmetry, ball model and free coordinates.
struct KernelCall {
  BallCircle circle;
  BallModel model;
  bool tilts;
  double tolerance;
  KernelPoint* points;
  std::size_t count;
  BallReport<double>* balls;  ///< circle.used() for each point
};

// Newton's method from the closed-form thrust start on many points side by side, and their reports.
// Points that do not converge so are left to the search that one point has for itself. What a point
// gets does not depend on the others of the call. One source, compiled for each instruction set.
void solve_sse2(const KernelCall& call);
void solve_avx2(const KernelCall& call);
void solve_avx512(const KernelCall& call);

}  // namespace raceway::bearing

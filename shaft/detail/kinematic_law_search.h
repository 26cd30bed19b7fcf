#pragma once

#include <limits>
#include <vector>

#include "fit/fit_status.h"
#include "record/parameter.h"
#include "record/units.h"

/// Search for the parameters A, B and C of the law u = A n^(1 - B exp(-C n)) for
/// fit_kinematic_law(), in the units of the law (rpm, um).
namespace raceway::shaft {

/// Rows for the fit, by increasing speed: speed n [rpm], ln n, displacement u [um], and weight
/// 1/std [1/um] or, without standard deviations, 1.
struct LawRows {
  std::vector<double> n, log_n, u, weight;
};

struct LawShape {
  double B = unset, C = unset;
};

/// Bounds of B [1] and C [1/rpm]; the bounds of C are above 0.
struct LawRange {
  double lower_B, upper_B, lower_C, upper_C;
};

/// Optimum reached by one descent.
struct LawOptimum {
  double size = unset;  ///< displacement at the highest speed [um]
  LawShape shape;
  double cost = std::numeric_limits<double>::infinity();  ///< Σ (weight (law - u))²
  int iterations = 0;
  fit::FitStatus status = fit::FitStatus::failed;
};

/// Returns the optimum of A, B and C that a descent reaches from the start values of B and C. The
/// law is linear in A, which is eliminated.
[[nodiscard]] LawOptimum nearest_optimum(const LawRows& rows, const LawRange& range,
                                         const LawShape& start);

/// Returns the best of the optima that descents reach. The descents start from all minima of the
/// cost on a grid of B and C.
[[nodiscard]] LawOptimum best_optimum(const LawRows& rows, const LawRange& range);

/// Returns the bound at which a value lies, if any.
[[nodiscard]] record::Bound bound_of(double value, double lower, double upper);

}  // namespace raceway::shaft

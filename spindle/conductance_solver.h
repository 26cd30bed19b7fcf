#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "spindle/heat_paths.h"

namespace raceway::spindle {

/// Solves A T = r with A = capacity_factor C + G for the temperatures T of all bodies. C is the
/// diagonal matrix of heat capacities, G the matrix of thermal conductances, and r the given
/// right-hand side.
///
/// A is factorised as L D Lᵀ. The constructor finds an order of the bodies in which L has few
/// nonzero elements. first_half() does the forward substitution, and second_half() does the back
/// substitution. The product
///
///   uᵀ A⁻¹ r = (L⁻¹ u)ᵀ D⁻¹ (L⁻¹ r)
///
/// for a given vector u needs no back substitution.
/// Accuracy: rounding errors only; the matrix is diagonally dominant.
class ConductanceSolver {
 public:
  /// Finds the order of elimination for the bodies and heat paths in `paths`. In later calls of
  /// factorise(), the conductances may differ from `paths`, but the bodies and heat paths must be
  /// the same.
  explicit ConductanceSolver(const HeatPaths& paths);
  /// Factorises A. Returns false if A is not positive definite. This is the case if a body has
  /// neither heat capacity nor a path by which heat can leave, or if a value is not finite.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  [[nodiscard]] Vector solve(const Vector& right) const {
    return second_half(first_half(in_order(right)));
  }

  /// Returns `right` with its rows (one for each body) in the order of elimination.
  template <typename Right>
  [[nodiscard]] Right in_order(const Right& right) const {
    return order_ * right;
  }
  /// Forward substitution: returns L⁻¹ r for each column r of `in_order`, the result of in_order().
  template <typename Right>
  [[nodiscard]] Right first_half(Right in_order) const {
    ldlt_.matrixL().solveInPlace(in_order);
    return in_order;
  }
  /// Back substitution: returns the solution T = A⁻¹ r. `first` is the result L⁻¹ r of
  /// first_half().
  [[nodiscard]] Vector second_half(const Vector& first) const {
    Vector in_order = inverse_.cwiseProduct(first);
    ldlt_.matrixU().solveInPlace(in_order);
    return order_.transpose() * in_order;
  }
  /// Diagonal of D⁻¹ [K/W].
  [[nodiscard]] const Vector& inverse() const { return inverse_; }

 private:
  /// Indices of the nonzero elements of A to which one heat path adds its conductance.
  struct LinkPlaces {
    Eigen::Index first, second, off;
  };
  Eigen::PermutationMatrix<Eigen::Dynamic> order_;
  SparseMatrix matrix_;  // upper half of A, in the order of elimination
  std::vector<Eigen::Index> diagonal_;
  std::vector<LinkPlaces> links_;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt_;
  Vector inverse_;
};

}  // namespace raceway::spindle

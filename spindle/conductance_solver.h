#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "spindle/heat_paths.h"

namespace raceway::spindle {

/// Solves A T = r with A = capacity_factor C + G for the temperatures T of all bodies. C contains
/// the heat capacities and G the thermal conductances.
///
/// A is factorised as L D Lᵀ. The constructor finds an order of the bodies in which L has few
/// nonzero elements. first_half() does the forward substitution, and second_half() does the back
/// substitution. The product
///
///   uᵀ A⁻¹ r = (L⁻¹ u)ᵀ D⁻¹ (L⁻¹ r)
///
/// with a vector u needs only forward substitutions. The forward substitution of u is short if only
/// a few elements of u are not zero.
/// Accuracy: rounding errors only; the matrix is diagonally dominant.
class ConductanceSolver {
 public:
  /// Finds the order of elimination. After the construction, only the conductances in `paths` may
  /// change.
  explicit ConductanceSolver(const HeatPaths& paths);
  /// Factorises A. Returns false if A is not positive definite: a body has neither heat capacity
  /// nor a path for heat to leave, or a number is not finite.
  [[nodiscard]] bool factorise(const HeatPaths& paths, double capacity_factor);
  [[nodiscard]] Vector solve(const Vector& right) const {
    return second_half(first_half(in_order(right)));
  }

  /// Returns right-hand sides with the bodies in the order of elimination.
  template <typename Right>
  [[nodiscard]] Right in_order(const Right& right) const {
    return order_ * right;
  }
  /// Returns L⁻¹ r for each column r of right-hand sides in the order of elimination.
  template <typename Right>
  [[nodiscard]] Right first_half(Right in_order) const {
    ldlt_.matrixL().solveInPlace(in_order);
    return in_order;
  }
  /// Returns A⁻¹ r, where `first` is L⁻¹ r.
  [[nodiscard]] Vector second_half(const Vector& first) const {
    Vector in_order = inverse_.cwiseProduct(first);
    ldlt_.matrixU().solveInPlace(in_order);
    return order_.transpose() * in_order;
  }
  /// Diagonal of D⁻¹ [K/W].
  [[nodiscard]] const Vector& inverse() const { return inverse_; }

 private:
  /// Indices of the matrix values to which a heat path adds its conductance.
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

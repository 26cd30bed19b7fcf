#pragma once

#include <Eigen/Core>
#include <memory>

/// Decompositions of matrices of any size.
///
/// Eigen's decompositions are templates that take many seconds to compile. This folder compiles
/// them once, for matrices of double, and other files call the functions below. Each function
/// returns exactly the result of the Eigen class for the same method, with one exception: if the
/// sum of the squared entries of A is not finite, results are NaN and ranks are 0. HouseholderQr,
/// LowerRoot and reduce_to_triangle() do not check this sum.
namespace raceway::algebra {

/// Solution x of min |b - A x|, by QR with column pivoting. A: m × n, b: m, x: n.
///
/// If the columns of A are linearly dependent (to rounding), the pivoting selects independent
/// columns. The entries of x for all other columns are 0. PivotedQr gives the rank and solves for
/// several b.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Solution x of min |b - A x| with the least |x|, by a complete orthogonal decomposition.
/// A: m × n, b: m, x: n.
[[nodiscard]] Eigen::VectorXd minimum_norm_solution(const Eigen::MatrixXd& A,
                                                    const Eigen::VectorXd& b);

/// Pseudoinverse of A, by a complete orthogonal decomposition. A: m × n, result: n × m.
[[nodiscard]] Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& A);

/// Solution x of A x = b for a symmetric, semidefinite A, by L D Lᵀ. A: n × n; only the lower
/// triangle is read.
///
/// SymmetricSolver solves for several b.
[[nodiscard]] Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Inverse of a symmetric, definite A, by L D Lᵀ. A: n × n; only the lower triangle is read.
[[nodiscard]] Eigen::MatrixXd symmetric_inverse(const Eigen::MatrixXd& A);

/// Solution x of A x = b for a nonsingular A, by LU with partial pivoting. A: n × n.
///
/// For a singular A, x is not finite or is huge.
[[nodiscard]] Eigen::VectorXd solve_square(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

/// Inverse of a nonsingular A, by LU with partial pivoting. A: n × n.
[[nodiscard]] Eigen::MatrixXd inverse(const Eigen::MatrixXd& A);

/// Inverse of the lower triangular L in A = L Lᵀ. A: n × n, symmetric and positive definite.
[[nodiscard]] Eigen::MatrixXd inverse_lower_root(const Eigen::MatrixXd& A);

/// Eigenvalues of a general A: n × n, in no particular order. Complex eigenvalues form conjugate
/// pairs.
[[nodiscard]] Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& A);

/// Decomposition A = V diag(values) Vᵀ of a symmetric A: n × n.
struct SymmetricEigen {
  Eigen::VectorXd values;   ///< ascending
  Eigen::MatrixXd vectors;  ///< V: n × n, a unit vector in each column
};

/// Eigenvalues and eigenvectors of a symmetric A: n × n; only the lower triangle is read.
[[nodiscard]] SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// The min(m, n) singular values of A: m × n, descending.
[[nodiscard]] Eigen::VectorXd singular_values(const Eigen::MatrixXd& A);

/// Decomposition A = U diag(values) Vᵀ of A: m × n, with k = min(m, n) singular values.
struct ThinSvd {
  Eigen::MatrixXd U;       ///< m × k
  Eigen::VectorXd values;  ///< k, descending
  Eigen::MatrixXd V;       ///< n × k
};

/// Singular values and vectors of A: m × n.
[[nodiscard]] ThinSvd thin_svd(const Eigen::MatrixXd& A);

/// Singular values and right singular vectors of A: m × n, for the covariance of parameters.
struct RightSvd {
  Eigen::VectorXd values;  ///< k = min(m, n), descending
  Eigen::MatrixXd V;       ///< n × k
};

/// Singular values and right singular vectors of A: m × n, from the R of A = Q R, which is small
/// even if A has many rows.
[[nodiscard]] RightSvd right_svd(const Eigen::MatrixXd& A);

/// Replaces A: m × n by the R of A = Q R, without a copy. The entries below the diagonal are
/// Householder vectors, not zeros.
void reduce_to_triangle(Eigen::MatrixXd& A);

/// Decomposition A P = Q R of A: m × n. P orders the columns: each next column has the largest
/// component outside the span of the previous columns.
class PivotedQr {
 public:
  /// The rank is the number of pivots |R_kk| above rounding error.
  explicit PivotedQr(const Eigen::MatrixXd& A);
  /// The rank is the number of pivots |R_kk| above `threshold` times the largest pivot [1].
  PivotedQr(const Eigen::MatrixXd& A, double threshold);

  [[nodiscard]] Eigen::Index rank() const;
  /// Solution x of min |b - A x|, as from least_squares(). b: m.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Solutions for the columns of B: m × k. Result: n × k.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;
  /// R: n × n, upper triangular; m >= n.
  [[nodiscard]] Eigen::MatrixXd R() const;
  /// Orthonormal basis of the space of the columns of A: m × rank.
  [[nodiscard]] Eigen::MatrixXd column_space() const;

 private:
  std::shared_ptr<const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>> qr_;
};

/// Decomposition A = Q R without pivoting of A: m × n, with m >= n and independent columns.
class HouseholderQr {
 public:
  explicit HouseholderQr(const Eigen::MatrixXd& A);

  /// Solution x of min |b - A x|. b: m.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// First n columns of Q: m × n.
  [[nodiscard]] Eigen::MatrixXd Q() const;
  /// R⁻¹: n × n, upper triangular.
  [[nodiscard]] Eigen::MatrixXd inverse_R() const;
  /// Returns ln det(AᵀA).
  [[nodiscard]] double log_determinant() const;

 private:
  std::shared_ptr<const Eigen::HouseholderQR<Eigen::MatrixXd>> qr_;
};

/// Decomposition A = L D Lᵀ of a symmetric, semidefinite A: n × n; only the lower triangle is read.
class SymmetricSolver {
 public:
  explicit SymmetricSolver(const Eigen::MatrixXd& A);

  /// Solution x of A x = b.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

 private:
  std::shared_ptr<const Eigen::LDLT<Eigen::MatrixXd>> ldlt_;
};

/// Decomposition A = L Lᵀ of a symmetric, positive definite A: n × n; only the lower triangle is
/// read.
class LowerRoot {
 public:
  explicit LowerRoot(const Eigen::MatrixXd& A);

  /// Returns L⁻¹ b. b: n.
  [[nodiscard]] Eigen::VectorXd solve_root(const Eigen::VectorXd& b) const;
  /// Returns A⁻¹ b. b: n.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Returns L⁻¹: n × n, lower triangular.
  [[nodiscard]] Eigen::MatrixXd inverse() const;
  /// Returns ln det A. The result is meaningless if A is not positive definite.
  [[nodiscard]] double log_determinant() const;

 private:
  std::shared_ptr<const Eigen::LLT<Eigen::MatrixXd>> llt_;
};

}  // namespace raceway::algebra

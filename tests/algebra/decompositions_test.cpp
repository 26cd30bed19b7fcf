#include "algebra/detail/decompositions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace raceway::algebra {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Largest difference of two matrices of the same shape.
double distance(const MatrixXd& a, const MatrixXd& b) { return (a - b).lpNorm<Eigen::Infinity>(); }

constexpr double rounding = 1e-14;
constexpr double rounding_of_hilbert = 1e-11;  // condition 524, entries up to 192

MatrixXd hilbert() {
  return MatrixXd{{1.0, 1.0 / 2.0, 1.0 / 3.0},
                  {1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0},
                  {1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0}};
}

/// Known exactly: whole numbers.
MatrixXd inverse_of_hilbert() {
  return MatrixXd{{9.0, -36.0, 30.0}, {-36.0, 192.0, -180.0}, {30.0, -180.0, 180.0}};
}

/// Ordinates at 0, 1 and 2 as a line has them: columns 1 and x.
MatrixXd line() { return MatrixXd{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}}; }

TEST(Decompositions, EverySolverAgreesOnTheHilbertMatrix) {
  const VectorXd ones = VectorXd::Ones(3);
  const VectorXd x{{3.0, -24.0, 30.0}};
  EXPECT_LT(distance(solve_square(hilbert(), ones), x), rounding_of_hilbert);
  EXPECT_LT(distance(solve_symmetric(hilbert(), ones), x), rounding_of_hilbert);
  EXPECT_LT(distance(SymmetricSolver(hilbert()).solve(ones), x), rounding_of_hilbert);
  EXPECT_LT(distance(least_squares(hilbert(), ones), x), rounding_of_hilbert);
  EXPECT_LT(distance(minimum_norm_solution(hilbert(), ones), x), rounding_of_hilbert);
  EXPECT_LT(distance(HouseholderQr(hilbert()).solve(ones), x), rounding_of_hilbert);
}

/// Eigen chooses pivots by norms that are NaN then, and reads behind its arrays.
TEST(Decompositions, AMatrixWithoutANormHasNoSolution) {
  for (const double odd : {1e300, -1e160, HUGE_VAL, std::nan("")}) {
    MatrixXd A = hilbert();
    A(1, 0) = A(0, 1) = odd;
    const VectorXd b = VectorXd::Ones(3);
    for (const VectorXd& x :
         {least_squares(A, b), minimum_norm_solution(A, b), solve_symmetric(A, b),
          solve_square(A, b), SymmetricSolver(A).solve(b), PivotedQr(A).solve(b),
          singular_values(A), symmetric_eigen(A).values, thin_svd(A).values, right_svd(A).values}) {
      ASSERT_EQ(x.size(), 3);
      EXPECT_TRUE(x.array().isNaN().all()) << odd;
    }
    EXPECT_TRUE(pseudo_inverse(A).array().isNaN().all());
    EXPECT_TRUE(inverse(A).array().isNaN().all());
    EXPECT_TRUE(symmetric_inverse(A).array().isNaN().all());
    EXPECT_TRUE(std::isnan(eigenvalues(A)(2).real()));
    EXPECT_EQ(PivotedQr(A, 1e-4).rank(), 0);
    EXPECT_EQ(PivotedQr(A).column_space().cols(), 0);
    EXPECT_EQ(PivotedQr(A).R().rows(), 3);
  }
}

TEST(Decompositions, EveryInverseOfTheHilbertMatrixIsOfWholeNumbers) {
  EXPECT_LT(distance(inverse(hilbert()), inverse_of_hilbert()), rounding_of_hilbert);
  EXPECT_LT(distance(symmetric_inverse(hilbert()), inverse_of_hilbert()), rounding_of_hilbert);
  EXPECT_LT(distance(pseudo_inverse(hilbert()), inverse_of_hilbert()), rounding_of_hilbert);
  const MatrixXd root = inverse_lower_root(hilbert());
  EXPECT_LT(distance(root.transpose() * root, inverse_of_hilbert()), rounding_of_hilbert);
}

TEST(Decompositions, LeastSquaresDrawTheLineOfThreePoints) {
  const VectorXd y{{1.0, 2.0, 4.0}}, expected{{5.0 / 6.0, 3.0 / 2.0}};
  EXPECT_LT(distance(least_squares(line(), y), expected), rounding);
  EXPECT_LT(distance(PivotedQr(line()).solve(y), expected), rounding);
  EXPECT_LT(distance(HouseholderQr(line()).solve(y), expected), rounding);
  const MatrixXd two{{1.0, 0.0}, {2.0, 1.0}, {4.0, 2.0}};
  const MatrixXd of_two{{5.0 / 6.0, 0.0}, {3.0 / 2.0, 1.0}};
  EXPECT_LT(distance(PivotedQr(line()).solve(two), of_two), rounding);
}

TEST(Decompositions, DependentColumnsShareTheSolutionOfMinimumNorm) {
  const MatrixXd alike = MatrixXd::Ones(3, 2);
  EXPECT_LT(distance(minimum_norm_solution(alike, VectorXd{{2.0, 2.0, 2.0}}), VectorXd::Ones(2)),
            rounding);
  EXPECT_LT(distance(pseudo_inverse(MatrixXd::Ones(2, 2)), MatrixXd::Constant(2, 2, 0.25)),
            rounding);
}

TEST(Decompositions, RankCountsColumnsAboveTheThreshold) {
  const MatrixXd nearly{{1.0, 1.0}, {0.0, 1e-6}};
  EXPECT_EQ(PivotedQr(nearly).rank(), 2);
  EXPECT_EQ(PivotedQr(nearly, 1e-4).rank(), 1);
  const MatrixXd space = PivotedQr(MatrixXd::Ones(3, 2), 1e-7).column_space();
  ASSERT_EQ(space.cols(), 1);
  EXPECT_LT(distance(space.cwiseAbs(), MatrixXd::Constant(3, 1, 1.0 / std::numbers::sqrt3)),
            rounding);
}

TEST(Decompositions, TrianglesHaveTheSquareOfTheirMatrix) {
  const MatrixXd square = line().transpose() * line();  // columns 3 and 5 squared
  const MatrixXd swapped = square.reverse();            // the longer column comes first
  const MatrixXd R = PivotedQr(line()).R();
  EXPECT_LT(distance(R.transpose() * R, swapped), rounding);
  MatrixXd reduced = line();
  reduce_to_triangle(reduced);
  const MatrixXd top = reduced.topRows(2).triangularView<Eigen::Upper>();
  EXPECT_LT(distance(top.transpose() * top, square), rounding);
}

TEST(Decompositions, HouseholderQrGivesProjectionInverseAndDeterminant) {
  const MatrixXd A = line();  // AᵀA = (3 3; 3 5), det 6
  const HouseholderQr qr(A);
  EXPECT_LT(distance(qr.Q().transpose() * qr.Q(), MatrixXd::Identity(2, 2)), rounding);
  EXPECT_LT(distance(qr.Q() * (qr.Q().transpose() * A), A), rounding);
  const MatrixXd expected{{5.0 / 6.0, -0.5}, {-0.5, 0.5}};
  EXPECT_LT(distance(qr.inverse_R() * qr.inverse_R().transpose(), expected), rounding);
  EXPECT_NEAR(qr.log_determinant(), std::log(6.0), rounding);
}

TEST(Decompositions, LowerRootOfAMatrixWorkedByHand) {
  const MatrixXd A{{4.0, 2.0}, {2.0, 5.0}};  // L = (2 0; 1 2)
  EXPECT_LT(distance(inverse_lower_root(A), MatrixXd{{0.5, 0.0}, {-0.25, 0.5}}), rounding);
  EXPECT_LT(distance(LowerRoot(A).solve_root(VectorXd{{2.0, 5.0}}), VectorXd{{1.0, 2.0}}),
            rounding);
  EXPECT_LT(distance(LowerRoot(A).solve(VectorXd{{8.0, 12.0}}), VectorXd{{1.0, 2.0}}), rounding);
  EXPECT_LT(distance(LowerRoot(A).inverse(), MatrixXd{{0.5, 0.0}, {-0.25, 0.5}}), rounding);
  EXPECT_NEAR(LowerRoot(A).log_determinant(), std::log(16.0), rounding);
  EXPECT_NEAR(LowerRoot(hilbert()).log_determinant(), -std::log(2160.0), 1e-12);
}

TEST(Decompositions, SquareSystemsMayHaveAZeroOnTheDiagonal) {
  const MatrixXd A{{0.0, 2.0}, {1.0, 1.0}};
  EXPECT_LT(distance(solve_square(A, VectorXd{{2.0, 2.0}}), VectorXd::Ones(2)), rounding);
}

TEST(Decompositions, EigenvaluesOfACompanionMatrixAreTheRoots) {
  // (z - 1)(z - 2)(z - 3) = z³ - 6 z² + 11 z - 6
  const Eigen::VectorXcd z =
      eigenvalues(MatrixXd{{6.0, -11.0, 6.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  std::vector<double> roots;
  for (const std::complex<double>& root : z) {
    roots.push_back(root.real());
    EXPECT_NEAR(root.imag(), 0.0, 1e-12);
  }
  std::sort(roots.begin(), roots.end());
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(roots[k], static_cast<double>(k + 1), 1e-12);
  // z² + 1
  const Eigen::VectorXcd pair = eigenvalues(MatrixXd{{0.0, -1.0}, {1.0, 0.0}});
  EXPECT_LT(std::abs(pair[0] * pair[1] - 1.0), rounding);
  EXPECT_LT(std::abs(pair[0] + pair[1]), rounding);
}

TEST(Decompositions, SymmetricEigenAscendsAndRebuildsTheMatrix) {
  const MatrixXd A{{2.0, 1.0}, {1.0, 2.0}};
  const SymmetricEigen eigen = symmetric_eigen(A);
  EXPECT_LT(distance(eigen.values, VectorXd{{1.0, 3.0}}), rounding);
  EXPECT_LT(distance(eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose(), A),
            rounding);
}

TEST(Decompositions, SingularValuesOfADiagonalMatrixAreItsSizesInOrder) {
  const MatrixXd A = VectorXd{{3.0, -5.0, 2.0}}.asDiagonal();
  EXPECT_LT(distance(singular_values(A), VectorXd{{5.0, 3.0, 2.0}}), rounding);
}

TEST(Decompositions, SingularVectorsOfOrthogonalColumnsAreTheirDirections) {
  const MatrixXd A{{2.0, 0.0}, {0.0, 7.0}, {0.0, 0.0}, {0.0, 0.0}};
  const VectorXd values{{7.0, 2.0}};
  const MatrixXd V{{0.0, 1.0}, {1.0, 0.0}};
  const ThinSvd thin = thin_svd(A);
  EXPECT_LT(distance(thin.values, values), rounding);
  EXPECT_LT(distance(thin.V.cwiseAbs(), V), rounding);
  EXPECT_LT(distance(thin.U * thin.values.asDiagonal() * thin.V.transpose(), A), rounding);
  const RightSvd right = right_svd(A);
  EXPECT_LT(distance(right.values, values), rounding);
  EXPECT_LT(distance(right.V.cwiseAbs(), V), rounding);
}

}  // namespace
}  // namespace raceway::algebra

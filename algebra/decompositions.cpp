#include "algebra/detail/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

namespace raceway::algebra {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Pivots are chosen by norms and iterations end by them: where they overflow, Eigen may leave its
/// arrays. Results are NaN then, and ranks 0.
bool has_norm(const MatrixXd& A) { return std::isfinite(A.squaredNorm()); }

MatrixXd no_matrix(Index rows, Index columns) { return MatrixXd::Constant(rows, columns, none); }

VectorXd no_vector(Index size) { return VectorXd::Constant(size, none); }

}  // namespace

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) {
  if (!has_norm(A)) return no_vector(A.cols());
  return A.colPivHouseholderQr().solve(b);
}

VectorXd minimum_norm_solution(const MatrixXd& A, const VectorXd& b) {
  if (!has_norm(A)) return no_vector(A.cols());
  return A.completeOrthogonalDecomposition().solve(b);
}

MatrixXd pseudo_inverse(const MatrixXd& A) {
  if (!has_norm(A)) return no_matrix(A.cols(), A.rows());
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

VectorXd solve_symmetric(const MatrixXd& A, const VectorXd& b) {
  if (!has_norm(A)) return no_vector(A.cols());
  return A.ldlt().solve(b);
}

MatrixXd symmetric_inverse(const MatrixXd& A) {
  if (!has_norm(A)) return no_matrix(A.rows(), A.cols());
  return A.ldlt().solve(MatrixXd::Identity(A.rows(), A.cols()));
}

VectorXd solve_square(const MatrixXd& A, const VectorXd& b) {
  if (!has_norm(A)) return no_vector(A.cols());
  return A.partialPivLu().solve(b);
}

MatrixXd inverse(const MatrixXd& A) {
  if (!has_norm(A)) return no_matrix(A.rows(), A.cols());
  return A.inverse();
}

MatrixXd inverse_lower_root(const MatrixXd& A) {
  if (!has_norm(A)) return no_matrix(A.rows(), A.cols());
  return LowerRoot(A).inverse();
}

VectorXcd eigenvalues(const MatrixXd& A) {
  if (!has_norm(A)) return VectorXcd::Constant(A.rows(), {none, none});
  return A.eigenvalues();
}

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  if (!has_norm(A))
    return {.values = no_vector(A.rows()), .vectors = no_matrix(A.rows(), A.cols())};
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  return {.values = eigen.eigenvalues(), .vectors = eigen.eigenvectors()};
}

VectorXd singular_values(const MatrixXd& A) {
  if (!has_norm(A)) return no_vector(std::min(A.rows(), A.cols()));
  return A.jacobiSvd().singularValues();
}

ThinSvd thin_svd(const MatrixXd& A) {
  const Index k = std::min(A.rows(), A.cols());
  if (!has_norm(A))
    return {.U = no_matrix(A.rows(), k), .values = no_vector(k), .V = no_matrix(A.cols(), k)};
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {.U = svd.matrixU(), .values = svd.singularValues(), .V = svd.matrixV()};
}

RightSvd right_svd(const MatrixXd& A) {
  const Index k = std::min(A.rows(), A.cols());
  if (!has_norm(A)) return {.values = no_vector(k), .V = no_matrix(A.cols(), k)};
  const Eigen::JacobiSVD<MatrixXd> svd(
      A.householderQr().matrixQR().topRows(k).triangularView<Eigen::Upper>().toDenseMatrix(),
      Eigen::ComputeThinV);
  return {.values = svd.singularValues(), .V = svd.matrixV()};
}

void reduce_to_triangle(MatrixXd& A) { const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(A); }

namespace {

using Qr = Eigen::ColPivHouseholderQR<MatrixXd>;

/// Threshold that marks the decomposition of a matrix with an infinite norm. It keeps the shape
/// only.
constexpr double of_no_norm = -1.0;

std::shared_ptr<Qr> pivoted_qr(const MatrixXd& A) {
  if (has_norm(A)) return std::make_shared<Qr>(A);
  auto shape = std::make_shared<Qr>(A.rows(), A.cols());
  shape->setThreshold(of_no_norm);
  return shape;
}

bool is_decomposed(const Qr& qr) { return qr.threshold() != of_no_norm; }

}  // namespace

PivotedQr::PivotedQr(const MatrixXd& A) : qr_(pivoted_qr(A)) {}

PivotedQr::PivotedQr(const MatrixXd& A, double threshold) {
  const auto qr = pivoted_qr(A);
  if (is_decomposed(*qr)) qr->setThreshold(threshold);
  qr_ = qr;
}

Index PivotedQr::rank() const { return is_decomposed(*qr_) ? qr_->rank() : 0; }

VectorXd PivotedQr::solve(const VectorXd& b) const {
  if (!is_decomposed(*qr_)) return no_vector(qr_->cols());
  return qr_->solve(b);
}

MatrixXd PivotedQr::solve(const MatrixXd& B) const {
  if (!is_decomposed(*qr_)) return no_matrix(qr_->cols(), B.cols());
  return qr_->solve(B);
}

MatrixXd PivotedQr::R() const {
  if (!is_decomposed(*qr_)) return no_matrix(qr_->cols(), qr_->cols());
  return qr_->matrixR().topRows(qr_->cols()).triangularView<Eigen::Upper>();
}

MatrixXd PivotedQr::column_space() const {
  if (!is_decomposed(*qr_)) return MatrixXd(qr_->rows(), 0);
  return qr_->householderQ() * MatrixXd::Identity(qr_->rows(), qr_->rank());
}

HouseholderQr::HouseholderQr(const MatrixXd& A)
    : qr_(std::make_shared<const Eigen::HouseholderQR<MatrixXd>>(A)) {}

VectorXd HouseholderQr::solve(const VectorXd& b) const { return qr_->solve(b); }

MatrixXd HouseholderQr::Q() const {
  return qr_->householderQ() * MatrixXd::Identity(qr_->rows(), qr_->cols());
}

MatrixXd HouseholderQr::inverse_R() const {
  const Index n = qr_->cols();
  return qr_->matrixQR().topRows(n).triangularView<Eigen::Upper>().solve(MatrixXd::Identity(n, n));
}

double HouseholderQr::log_determinant() const {
  return 2.0 * qr_->matrixQR().diagonal().head(qr_->cols()).array().abs().log().sum();
}

SymmetricSolver::SymmetricSolver(const MatrixXd& A)
    : ldlt_(std::make_shared<const Eigen::LDLT<MatrixXd>>(
          has_norm(A) ? A : no_matrix(A.rows(), A.cols()))) {}

VectorXd SymmetricSolver::solve(const VectorXd& b) const {
  const MatrixXd& d = ldlt_->matrixLDLT();
  if (d.size() > 0 && std::isnan(d(0, 0))) return no_vector(d.rows());
  return ldlt_->solve(b);
}

LowerRoot::LowerRoot(const MatrixXd& A) : llt_(std::make_shared<const Eigen::LLT<MatrixXd>>(A)) {}

VectorXd LowerRoot::solve_root(const VectorXd& b) const { return llt_->matrixL().solve(b); }

VectorXd LowerRoot::solve(const VectorXd& b) const { return llt_->solve(b); }

MatrixXd LowerRoot::inverse() const {
  return llt_->matrixL().solve(MatrixXd::Identity(llt_->rows(), llt_->cols()));
}

double LowerRoot::log_determinant() const {
  return 2.0 * llt_->matrixLLT().diagonal().array().log().sum();
}

}  // namespace raceway::algebra

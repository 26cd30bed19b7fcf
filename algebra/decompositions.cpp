#include "algebra/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace raceway::algebra {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd least_squares(const MatrixXd& A, const VectorXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

VectorXd minimum_norm_solution(const MatrixXd& A, const VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

MatrixXd pseudo_inverse(const MatrixXd& A) {
  return A.completeOrthogonalDecomposition().pseudoInverse();
}

VectorXd solve_symmetric(const MatrixXd& A, const VectorXd& b) { return A.ldlt().solve(b); }

MatrixXd symmetric_inverse(const MatrixXd& A) {
  return A.ldlt().solve(MatrixXd::Identity(A.rows(), A.cols()));
}

VectorXd solve_square(const MatrixXd& A, const VectorXd& b) { return A.partialPivLu().solve(b); }

MatrixXd inverse(const MatrixXd& A) { return A.inverse(); }

MatrixXd inverse_lower_root(const MatrixXd& A) {
  const MatrixXd L = A.llt().matrixL();
  return L.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(A.rows(), A.cols()));
}

VectorXcd eigenvalues(const MatrixXd& A) { return A.eigenvalues(); }

SymmetricEigen symmetric_eigen(const MatrixXd& A) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  return {.values = eigen.eigenvalues(), .vectors = eigen.eigenvectors()};
}

VectorXd singular_values(const MatrixXd& A) { return A.jacobiSvd().singularValues(); }

ThinSvd thin_svd(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {.U = svd.matrixU(), .values = svd.singularValues(), .V = svd.matrixV()};
}

RightSvd right_svd(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A.householderQr()
                                           .matrixQR()
                                           .topRows(std::min(A.rows(), A.cols()))
                                           .triangularView<Eigen::Upper>()
                                           .toDenseMatrix(),
                                       Eigen::ComputeThinV);
  return {.values = svd.singularValues(), .V = svd.matrixV()};
}

void reduce_to_triangle(MatrixXd& A) { const Eigen::HouseholderQR<Eigen::Ref<MatrixXd>> qr(A); }

PivotedQr::PivotedQr(const MatrixXd& A)
    : qr_(std::make_shared<const Eigen::ColPivHouseholderQR<MatrixXd>>(A)) {}

PivotedQr::PivotedQr(const MatrixXd& A, double threshold) {
  const auto qr = std::make_shared<Eigen::ColPivHouseholderQR<MatrixXd>>(A);
  qr->setThreshold(threshold);
  qr_ = qr;
}

Index PivotedQr::rank() const { return qr_->rank(); }

VectorXd PivotedQr::solve(const VectorXd& b) const { return qr_->solve(b); }

MatrixXd PivotedQr::solve(const MatrixXd& B) const { return qr_->solve(B); }

MatrixXd PivotedQr::R() const {
  return qr_->matrixR().topRows(qr_->cols()).triangularView<Eigen::Upper>();
}

MatrixXd PivotedQr::column_space() const {
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
    : ldlt_(std::make_shared<const Eigen::LDLT<MatrixXd>>(A)) {}

VectorXd SymmetricSolver::solve(const VectorXd& b) const { return ldlt_->solve(b); }

LowerRoot::LowerRoot(const MatrixXd& A) : llt_(std::make_shared<const Eigen::LLT<MatrixXd>>(A)) {}

VectorXd LowerRoot::solve_root(const VectorXd& b) const { return llt_->matrixL().solve(b); }

double LowerRoot::log_determinant() const {
  return 2.0 * llt_->matrixLLT().diagonal().array().log().sum();
}

}  // namespace raceway::algebra

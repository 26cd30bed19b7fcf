#include "spindle/unbalance.h"

#include <Eigen/SparseLU>
#include <cmath>
#include <complex>
#include <vector>

namespace raceway::spindle {
namespace {

using Complex = std::complex<double>;
constexpr Complex i_unit{0.0, 1.0};

void put_complex(std::vector<Eigen::Triplet<Complex>>& to, const Eigen::SparseMatrix<double>& block,
                 Eigen::Index row, Eigen::Index column, Complex factor) {
  for (int c = 0; c < block.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator it(block, c); it; ++it)
      to.emplace_back(static_cast<int>(row + it.row()), static_cast<int>(column + it.col()),
                      factor * it.value());
}

}  // namespace

Orbit unbalance_orbit(const Beam& beam, std::span<const Spring> springs, double speed,
                      const Unbalance& unbalance, double at) {
  if (speed == 0.0) return {.amplitude = 0.0, .lag = unset};
  std::vector<double> places;
  std::vector<PlaneSpring> in_y, in_z;
  for (const Spring& s : springs) {
    places.push_back(s.position);
    in_y.push_back(s.y);
    in_z.push_back(s.z);
  }
  const Eigen::Index n = beam.mass().rows();
  const double squared = speed * speed;
  const Complex lossy(1.0, 2.0 * unbalance.damping_ratio);
  std::vector<Eigen::Triplet<Complex>> entries;
  put_complex(entries, beam.held_by(places, in_y), 0, 0, lossy);
  put_complex(entries, beam.held_by(places, in_z), n, n, lossy);
  for (const Eigen::Index p : {Eigen::Index{0}, n})
    put_complex(entries, beam.mass(), p, p, -squared);
  put_complex(entries, beam.gyroscopic(), 0, n, i_unit * squared);
  put_complex(entries, beam.gyroscopic(), n, 0, -i_unit * squared);
  Eigen::SparseMatrix<Complex> matrix(2 * n, 2 * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseLU<Eigen::SparseMatrix<Complex>> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  Eigen::VectorXd one = Eigen::VectorXd::Zero(n);
  beam.add_load({.position = unbalance.position, .force = unbalance.size * squared}, one);
  Eigen::VectorXcd force(2 * n);
  force << one.cast<Complex>(), -i_unit * one.cast<Complex>();
  const Eigen::VectorXcd q = solver.solve(force);
  const auto value = [&](Eigen::Index plane) {
    const Eigen::VectorXcd part = q.segment(plane * n, n);
    return Complex(beam.at(at, part.real())[0], beam.at(at, part.imag())[0]);
  };
  const Complex v = value(0), w = value(1);
  const Complex forward = 0.5 * (v + i_unit * w);
  const Complex backward = 0.5 * (std::conj(v) + i_unit * std::conj(w));
  if (!std::isfinite(std::abs(forward))) return {};
  return {.amplitude = std::abs(forward) + std::abs(backward), .lag = -std::arg(forward)};
}

}  // namespace raceway::spindle

#include "spindle/modes.h"

#include <Spectra/MatOp/SparseCholesky.h>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymGEigsSolver.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace raceway::spindle {
namespace {

using SparsePart = Eigen::SparseMatrix<double>;

/// Share of the whole motion that must run in one sense to be called so [1].
constexpr double least_whirl = 1e-6;
constexpr double eigen_tolerance = 1e-12;
/// Of the largest k/m of a node; what is below is a free shaft and rounding [1].
constexpr double least_squared_frequency = 1e-13;

void put(std::vector<Eigen::Triplet<double>>& to, const SparsePart& block, Eigen::Index row,
         Eigen::Index column, double factor) {
  for (int c = 0; c < block.outerSize(); ++c)
    for (SparsePart::InnerIterator it(block, c); it; ++it)
      to.emplace_back(static_cast<int>(row + it.row()), static_cast<int>(column + it.col()),
                      factor * it.value());
}

SparsePart sparse(Eigen::Index size, const std::vector<Eigen::Triplet<double>>& entries) {
  SparsePart m(size, size);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

/// A and B of the linear problem. `planes` is 1 for v + i w, 2 for (v, w).
struct Problem {
  SparsePart a, b;
};

Problem linear_problem(const Beam& beam, std::span<const SparsePart> stiffness, double speed) {
  const Eigen::Index n = beam.mass().rows();
  const auto planes = static_cast<Eigen::Index>(stiffness.size());
  const Eigen::Index half = planes * n;
  std::vector<Eigen::Triplet<double>> a, b;
  for (Eigen::Index p = 0; p < planes; ++p) {
    put(a, stiffness[static_cast<std::size_t>(p)], p * n, p * n, 1.0);
    put(a, beam.mass(), half + p * n, half + p * n, 1.0);
    put(b, beam.mass(), p * n, half + p * n, 1.0);
    put(b, beam.mass(), half + p * n, p * n, 1.0);
    // Of one plane on itself in v + i w, else on the other one.
    put(b, beam.gyroscopic(), p * n, (planes - 1 - p) * n, -speed);
  }
  return {sparse(2 * half, a), sparse(2 * half, b)};
}

Whirl whirl_of(const Beam& beam, const Mode& m) {
  const double around = m.y.dot(beam.mass() * m.z);
  const double all = 0.5 * (m.y.dot(beam.mass() * m.y) + m.z.dot(beam.mass() * m.z));
  if (std::abs(around) <= least_whirl * all) return Whirl::standing;
  return around > 0.0 ? Whirl::forward : Whirl::backward;
}

void scale_shape(Mode& m) {
  double largest = 0.0;
  Eigen::Index at = 0;
  for (Eigen::Index i = 0; i < m.y.size(); i += 2)
    for (const double v : {std::abs(m.y[i]), std::abs(m.z[i])})
      if (v > largest) {
        largest = v;
        at = i;
      }
  if (!(largest > 0.0)) return;
  const bool by_y = std::abs(m.y[at]) >= std::abs(m.z[at]);
  const double factor = std::copysign(1.0 / largest, by_y ? m.y[at] : m.z[at]);
  m.y *= factor;
  m.z *= factor;
}

Mode mode_of(const Beam& beam, double omega, const Eigen::VectorXd& vector, bool one_plane,
             double speed) {
  const Eigen::Index n = beam.mass().rows();
  Mode m;
  m.frequency = std::abs(omega);
  m.y = vector.head(n);
  if (one_plane) {
    m.z = omega > 0.0 ? m.y : Eigen::VectorXd(-m.y);
    // At standstill both senses are one mode in two planes.
    m.whirl = speed == 0.0 ? Whirl::standing : omega > 0.0 ? Whirl::forward : Whirl::backward;
  } else {
    m.z = vector.segment(n, n);
    m.whirl = speed == 0.0 ? Whirl::standing : whirl_of(beam, m);
  }
  scale_shape(m);
  return m;
}

}  // namespace

std::string_view name(Whirl whirl) {
  return whirl == Whirl::backward ? "backward" : whirl == Whirl::forward ? "forward" : "standing";
}

Modes find_modes(const Beam& beam, std::span<const Spring> springs, double speed, int count) {
  if (count < 1) throw std::invalid_argument("number of modes: must be at least 1");
  std::vector<double> places;
  std::vector<PlaneSpring> in_y, in_z;
  bool one_plane = true;
  for (const Spring& s : springs) {
    places.push_back(s.position);
    in_y.push_back(s.y);
    in_z.push_back(s.z);
    one_plane = one_plane && s.isotropic();
  }
  std::vector<SparsePart> stiffness{beam.held_by(places, in_y)};
  if (!one_plane) stiffness.push_back(beam.held_by(places, in_z));
  const Problem problem = linear_problem(beam, stiffness, speed);
  const Eigen::Index size = problem.a.rows();
  // Both senses of v + i w are wanted; of (v, w) the one of each pair ±ω.
  const Eigen::Index wanted = std::min<Eigen::Index>(count, size / (one_plane ? 1 : 2) - 1);
  const Eigen::Index kept = std::min<Eigen::Index>(size, std::max<Eigen::Index>(3 * wanted, 24));
  Modes result;
  using Product = Spectra::SparseSymMatProd<double>;
  using Factor = Spectra::SparseCholesky<double>;
  Product product(problem.b);
  Factor factor(problem.a);
  if (factor.info() != Spectra::CompInfo::Successful) {
    result.status = ModesStatus::not_held;
    return result;
  }
  Spectra::SymGEigsSolver<Product, Factor, Spectra::GEigsMode::Cholesky> solver(product, factor,
                                                                                wanted, kept);
  solver.init();
  solver.compute(one_plane ? Spectra::SortRule::LargestMagn : Spectra::SortRule::LargestAlge, 1000,
                 eigen_tolerance);
  if (solver.info() != Spectra::CompInfo::Successful) {
    result.status = ModesStatus::not_converged;
    return result;
  }
  const Eigen::VectorXd values = solver.eigenvalues();
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    result.modes.push_back(mode_of(beam, 1.0 / values[i], vectors.col(i), one_plane, speed));
  std::stable_sort(result.modes.begin(), result.modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  const Eigen::VectorXd local =
      stiffness[0].diagonal().cwiseQuotient(Eigen::VectorXd(beam.mass().diagonal()));
  const double lowest = result.modes.front().frequency;
  const bool held = lowest * lowest > least_squared_frequency * local.maxCoeff();
  if (!held) result.modes.clear();
  result.status = held ? ModesStatus::converged : ModesStatus::not_held;
  return result;
}

std::vector<Modes> campbell(const Beam& beam, std::span<const double> speeds,
                            std::span<const std::vector<Spring>> springs, int count) {
  if (speeds.size() != springs.size())
    throw std::invalid_argument("campbell: give one set of springs for each speed");
  std::vector<Modes> results(speeds.size());
  tbb::parallel_for(std::size_t{0}, speeds.size(), [&](std::size_t i) {
    results[i] = find_modes(beam, springs[i], speeds[i], count);
  });
  return results;
}

}  // namespace raceway::spindle

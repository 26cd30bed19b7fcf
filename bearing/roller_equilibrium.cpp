#include "bearing/roller_equilibrium.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace raceway::bearing {
namespace {

using Vector2 = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Matrix24 = Eigen::Matrix<double, 2, 4>;

constexpr double no_contact = 1e-15;     // approach below which nothing touches [m]
constexpr double least_damping = 1e-10;  // of a stiffness, so that every step is defined [1]
constexpr double search_slope = 0.5;     // share of the slope at which a line search ends [1]
constexpr int search_steps = 60;
constexpr double singular_share = 1e-12;  // of the larger eigenvalue of (Ki + Ko) [1]

Matrix2 pseudo_inverse(const Matrix2& a) {
  const Eigen::SelfAdjointEigenSolver<Matrix2> e(a);
  const double largest = e.eigenvalues().cwiseAbs().maxCoeff();
  Matrix2 inverse = Matrix2::Zero();
  for (int i = 0; i < 2; ++i)
    if (e.eigenvalues()[i] > singular_share * largest)
      inverse += e.eigenvectors().col(i) * e.eigenvectors().col(i).transpose() / e.eigenvalues()[i];
  return inverse;
}

}  // namespace

/// Ring and rollers at one set of unknowns.
class RollerBalance {
 public:
  RollerBalance(const RollerBearing& bearing, double speed, double clearance)
      : bearing_(bearing),
        half_clearance_(0.5 * clearance),
        lever_(0.5 * bearing.geometry().roller_length),
        centrifugal_(bearing.centrifugal_force(speed)),
        rollers_(bearing.azimuths().size(), Vector2::Zero()) {
    for (std::size_t j = 0; j < lamina_count; ++j) x_[j] = bearing.positions()[j] / lever_;
  }

  [[nodiscard]] double lever() const { return lever_; }
  [[nodiscard]] double centrifugal() const { return centrifugal_; }
  void set_clearance(double clearance) { half_clearance_ = 0.5 * clearance; }

  /// Puts the ring there, and the rollers near the places where they end.
  void start(const Vector4& ring) {
    ring_ = ring;
    const double c = bearing_.contact().stiffness * static_cast<double>(lamina_count);
    const double thrown = std::pow(centrifugal_ / c, 0.9);
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      const Vector2 e = approach(k, ring);
      rollers_[k] = 0.5 * e;
      if (!(centrifugal_ > 0.0)) continue;
      rollers_[k][0] = std::max(rollers_[k][0], 0.0) + thrown;
      if (e[0] <= 0.0) rollers_[k][1] = 0.0;
    }
  }

  /// Puts the ring there, and the rollers where their stiffness at the last balance takes them.
  void follow(const Vector4& ring, double clearance) {
    const double moved = 0.5 * clearance - half_clearance_;
    half_clearance_ = 0.5 * clearance;
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      const Vector2 by = lever_matrix(k) * (ring - ring_) - Vector2(moved, 0.0);
      if (!(centrifugal_ > 0.0))
        rollers_[k] = 0.5 * approach(k, ring);
      else if (inner_[k].force[0] > 0.0)
        rollers_[k] +=
            pseudo_inverse(inner_[k].stiffness + outer_[k].stiffness) * inner_[k].stiffness * by;
    }
    ring_ = ring;
  }

  /// Newton's method; the first `free` of y, z, θ_y, θ_z are unknown, the others stay.
  SolveReport solve(const Vector4& load, int free, const RollerOptions& options) {
    SolveReport report;
    evaluate(load, free);
    for (report.iterations = 0;; ++report.iterations) {
      report.residual = scale_ > 0.0 ? residual_ / scale_ : 0.0;
      if (!std::isfinite(residual_)) {
        report.status = SolveStatus::not_finite;
        return report;
      }
      if (residual_ <= options.tolerance * scale_ || residual_ <= rounding()) {
        report.status = SolveStatus::converged;
        return report;
      }
      if (report.iterations == options.max_iterations) {
        report.status = SolveStatus::iteration_limit;
        return report;
      }
      find_step(free);
      search(load, free);
    }
  }

  /// Force on the ring by all rollers, and its tangent stiffness.
  void ring_into(Vector4& load, Matrix4& stiffness) const {
    load.setZero();
    stiffness.setZero();
    const std::vector<Matrix2> series = all_in_series();
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      if (!(inner_[k].force[0] > 0.0)) continue;
      const Matrix24 B = lever_matrix(k);
      load += B.transpose() * inner_[k].force;
      stiffness += B.transpose() * series[k] * B;
    }
    if (in_plane_) {
      // Terms that cancel between the two halves.
      for (const int odd : {1, 2}) {
        load[odd] = 0.0;
        for (const int even : {0, 3}) stiffness(odd, even) = stiffness(even, odd) = 0.0;
      }
    }
    load.tail<2>() *= lever_;
    stiffness.bottomRows<2>() *= lever_;
    stiffness.rightCols<2>() *= lever_;
  }

  void report_into(RollerEquilibrium& result) const {
    result.displacement = ring_;
    result.displacement.tail<2>() /= lever_;
    result.clearance = 2.0 * half_clearance_;
    result.centrifugal_force = centrifugal_;
    ring_into(result.load, result.stiffness);
    result.sum_by_clearance = sum_by_clearance(result.stiffness.topLeftCorner<2, 2>());
    result.rollers.resize(rollers_.size());
    for (std::size_t k = 0; k < rollers_.size(); ++k) fill(k, result.rollers[k]);
  }

  [[nodiscard]] bool inner_contact() const {
    return std::any_of(inner_.begin(), inner_.end(),
                       [](const RaceForce& f) { return f.force[0] > 0.0; });
  }

 private:
  /// Force and stiffness of one race against the middle and the tilt of a roller. Tilts are times
  /// half the length, so that all unknowns are lengths.
  struct RaceForce {
    Vector2 force = Vector2::Zero();
    Matrix2 stiffness = Matrix2::Zero();
  };

  /// Roller that carries what roller k does: where the ring is moved within the plane of x and y,
  /// the one on the other side of it.
  [[nodiscard]] std::size_t twin(std::size_t k) const {
    return in_plane_ && 2 * k > rollers_.size() ? rollers_.size() - k : k;
  }

  /// Approach and its slope at a roller, B times the ring, less the clearance.
  [[nodiscard]] Vector2 approach(std::size_t k, const Vector4& ring) const {
    const auto& a = bearing_.azimuths()[k];
    return {ring[0] * a.cosine + ring[1] * a.sine - half_clearance_,
            ring[3] * a.cosine - ring[2] * a.sine};
  }
  [[nodiscard]] Matrix24 lever_matrix(std::size_t k) const {
    const auto& a = bearing_.azimuths()[k];
    Matrix24 B;
    B << a.cosine, a.sine, 0.0, 0.0, 0.0, 0.0, -a.sine, a.cosine;
    return B;
  }

  [[nodiscard]] double lamina(const Vector2& near, std::size_t j, double& root) const {
    const double d = near[0] + x_[j] * near[1] - bearing_.relief()[j];
    if (!(d > no_contact)) return root = 0.0;
    root = std::pow(d, 1.0 / 9.0);  // three times as fast as two cube roots
    return bearing_.contact().stiffness * d * root;
  }

  [[nodiscard]] RaceForce race(const Vector2& near) const {
    RaceForce f;
    const double slope = 10.0 / 9.0 * bearing_.contact().stiffness;
    double tilting = 0.0;
    for (std::size_t j = 0; j < lamina_count; ++j) {
      double root;
      const double q = lamina(near, j, root);
      if (!(q > 0.0)) continue;
      const double k = slope * root, x = x_[j];
      f.force[0] += q;
      f.force[1] += x * q;
      f.stiffness(0, 0) += k;
      tilting += x * k;
      f.stiffness(1, 1) += x * x * k;
    }
    f.stiffness(0, 1) = f.stiffness(1, 0) = tilting;
    return f;
  }

  /// All forces at the unknowns as they are, and what is out of balance.
  void evaluate(const Vector4& load, int free) {
    inner_.resize(rollers_.size());
    outer_.resize(rollers_.size());
    ring_gradient_ = -load;
    roller_gradient_.resize(rollers_.size());
    scale_ = std::max(load.cwiseAbs().maxCoeff(), centrifugal_);
    residual_ = 0.0;
    in_plane_ = free == 0 && ring_[1] == 0.0 && ring_[2] == 0.0;
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      if (const std::size_t other = twin(k); other != k) {
        rollers_[k] = rollers_[other];
        inner_[k] = inner_[other];
        outer_[k] = outer_[other];
      } else {
        inner_[k] = race(approach(k, ring_) - rollers_[k]);
        outer_[k] = race(rollers_[k]);
      }
      ring_gradient_ += lever_matrix(k).transpose() * inner_[k].force;
      roller_gradient_[k] = outer_[k].force - inner_[k].force - Vector2(centrifugal_, 0.0);
      residual_ = std::max(residual_, roller_gradient_[k].cwiseAbs().maxCoeff());
      scale_ = std::max({scale_, inner_[k].force[0], outer_[k].force[0]});
    }
    if (free > 0) residual_ = std::max(residual_, ring_gradient_.head(free).cwiseAbs().maxCoeff());
  }

  /// Stiffness of all slices of a contact at a micrometre, its usual size [N/m].
  [[nodiscard]] double usual_stiffness() const {
    return 10.0 / 9.0 * bearing_.contact().stiffness * static_cast<double>(lamina_count) *
           std::cbrt(std::cbrt(1e-6));
  }
  /// Imbalance that the rounding of the ring's displacement and the least contact leave [N].
  [[nodiscard]] double rounding() const {
    return 4.0 * std::numeric_limits<double>::epsilon() * usual_stiffness() *
               (ring_.cwiseAbs().maxCoeff() + std::abs(half_clearance_)) +
           2.0 * bearing_.contact().stiffness * std::pow(no_contact, 10.0 / 9.0);
  }

  /// The step of Newton's method, rollers eliminated.
  void find_step(int free) {
    const double damping = least_damping * usual_stiffness();
    Matrix4 K = damping * Matrix4::Identity();
    Vector4 g = ring_gradient_;
    std::vector<Matrix2>& inverse = inverses_;
    inverse.resize(rollers_.size());
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      const Matrix24 B = lever_matrix(k);
      const Matrix2& Ki = inner_[k].stiffness;
      inverse[k] = (Ki + outer_[k].stiffness + damping * Matrix2::Identity()).inverse();
      K += B.transpose() * (Ki - Ki * inverse[k] * Ki) * B;
      // Coupling of ring and roller: -B' Ki.
      g += B.transpose() * Ki * inverse[k] * roller_gradient_[k];
    }
    ring_step_.setZero();
    if (free > 0) ring_step_.head(free) = K.topLeftCorner(free, free).ldlt().solve(-g.head(free));
    roller_step_.resize(rollers_.size());
    for (std::size_t k = 0; k < rollers_.size(); ++k)
      roller_step_[k] =
          inverse[k] * (inner_[k].stiffness * lever_matrix(k) * ring_step_ - roller_gradient_[k]);
  }

  [[nodiscard]] double slope_along_step() const {
    double slope = ring_gradient_.dot(ring_step_);
    for (std::size_t k = 0; k < rollers_.size(); ++k)
      slope += roller_gradient_[k].dot(roller_step_[k]);
    return slope;
  }

  void move(double by) {
    ring_ += by * ring_step_;
    // At standstill each roller is halfway between the raceways, as both contacts are alike.
    for (std::size_t k = 0; k < rollers_.size(); ++k)
      if (centrifugal_ > 0.0)
        rollers_[k] += by * roller_step_[k];
      else
        rollers_[k] = 0.5 * approach(k, ring_);
  }

  /// Goes along the step until the derivative of the energy along it, which grows all the way, is
  /// small. The full step is taken where it is already.
  void search(const Vector4& load, int free) {
    const double first = slope_along_step();
    double low = 0.0, high = 1.0, at = 1.0;
    double low_slope = first, high_slope = unset;
    move(1.0);
    for (int i = 0; i < search_steps; ++i) {
      evaluate(load, free);
      const double slope = slope_along_step();
      if (std::abs(slope) <= search_slope * std::abs(first) || !std::isfinite(slope)) return;
      if (slope < 0.0) {
        low = at;
        low_slope = slope;
        if (std::isnan(high_slope)) high = 2.0 * at;
      } else {
        high = at;
        high_slope = slope;
      }
      double next =
          std::isnan(high_slope) ? high : low - low_slope * (high - low) / (high_slope - low_slope);
      if (!std::isnan(high_slope)) {
        const double margin = 0.1 * (high - low);
        next = std::clamp(next, low + margin, high - margin);
      }
      move(next - at);
      at = next;
    }
    evaluate(load, free);
  }

  /// Stiffness of both contacts of a roller in series: its middle and tilt settle in between.
  [[nodiscard]] Matrix2 in_series(std::size_t k) const {
    const Matrix2& Ki = inner_[k].stiffness;
    return Ki - Ki * pseudo_inverse(Ki + outer_[k].stiffness) * Ki;
  }

  [[nodiscard]] std::vector<Matrix2> all_in_series() const {
    std::vector<Matrix2> list(rollers_.size(), Matrix2::Zero());
    for (std::size_t k = 0; k < rollers_.size(); ++k)
      if (inner_[k].force[0] > 0.0) list[k] = twin(k) == k ? in_series(k) : list[twin(k)];
    return list;
  }

  /// A clearance that grows by ds takes ds/2 from every approach; the ring moves until its forces
  /// are what they were.
  [[nodiscard]] double sum_by_clearance(const Matrix2& radial_stiffness) const {
    const std::vector<Matrix2> series = all_in_series();
    Vector2 missing = Vector2::Zero();
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      if (!(inner_[k].force[0] > 0.0)) continue;
      const auto& a = bearing_.azimuths()[k];
      missing += 0.5 * series[k](0, 0) * Vector2(a.cosine, a.sine);
    }
    const Vector2 moved = pseudo_inverse(radial_stiffness) * missing;
    double sum = 0.0;
    for (std::size_t k = 0; k < rollers_.size(); ++k) {
      if (!(inner_[k].force[0] > 0.0)) continue;
      const auto& a = bearing_.azimuths()[k];
      sum += series[k](0, 0) * (a.cosine * moved[0] + a.sine * moved[1] - 0.5);
    }
    return sum;
  }

  void fill(std::size_t k, LoadedRoller& roller) const {
    roller.azimuth = bearing_.azimuths()[k].angle;
    roller.inner_load = inner_[k].force[0];
    roller.outer_load = outer_[k].force[0];
    roller.shift = rollers_[k][0];
    roller.tilt = rollers_[k][1] / lever_;
    const Vector2 inner = approach(k, ring_) - rollers_[k];
    double root;
    for (std::size_t j = 0; j < lamina_count; ++j) {
      roller.inner_laminae[j] = lamina(inner, j, root);
      roller.outer_laminae[j] = lamina(rollers_[k], j, root);
    }
  }

  const RollerBearing& bearing_;
  double half_clearance_, lever_, centrifugal_;
  std::array<double, lamina_count> x_{};  // of slices, over the lever
  Vector4 ring_ = Vector4::Zero();        // tilts times the lever [m]
  std::vector<Vector2> rollers_;          // shift, tilt times the lever [m]
  std::vector<RaceForce> inner_, outer_;
  Vector4 ring_gradient_ = Vector4::Zero(), ring_step_ = Vector4::Zero();
  std::vector<Vector2> roller_gradient_, roller_step_;
  std::vector<Matrix2> inverses_;
  double residual_ = unset, scale_ = unset;
  bool in_plane_ = false;  // the ring is moved within the plane of x and y
};

namespace {

void require(const OperatingPoint& point) {
  validate(point);
  if (point.axial_load != 0.0) {
    std::ostringstream text;
    text << "axial_load = " << point.axial_load
         << " N: must be 0, because a cylindrical roller bearing of type N cannot carry an axial "
            "load";
    throw std::invalid_argument(text.str());
  }
}

/// Start of the search: approximate ring position under a radial load on straight rollers.
Vector4 first_ring(const RollerBearing& bearing, const OperatingPoint& p, double clearance) {
  const double radial = std::hypot(p.radial_load, p.radial_load_z);
  if (!(radial > 0.0)) return Vector4::Zero();
  const double largest = 4.1 * radial / static_cast<double>(bearing.geometry().roller_count);
  const double c = bearing.contact().stiffness * static_cast<double>(lamina_count);
  const double way = std::max(0.5 * clearance, 0.0) + 2.0 * std::pow(largest / c, 0.9);
  return {way * p.radial_load / radial, way * p.radial_load_z / radial, 0.0, 0.0};
}

}  // namespace

double RollerEquilibrium::inner_sum() const {
  double sum = 0.0;
  for (const LoadedRoller& r : rollers) sum += r.inner_load;
  return sum;
}

double RollerEquilibrium::outer_sum() const {
  double sum = 0.0;
  for (const LoadedRoller& r : rollers) sum += r.outer_load;
  return sum;
}

int RollerEquilibrium::loaded_rollers() const {
  return static_cast<int>(std::count_if(rollers.begin(), rollers.end(),
                                        [](const LoadedRoller& r) { return r.inner_load > 0.0; }));
}

double RollerEquilibrium::largest_lamina(Race race) const {
  double largest = 0.0;
  for (const LoadedRoller& r : rollers)
    for (const double q : race == Race::inner ? r.inner_laminae : r.outer_laminae)
      largest = std::max(largest, q);
  return largest;
}

RollerEquilibrium solve_roller_bearing(const RollerBearing& bearing, const OperatingPoint& point,
                                       const RollerOptions& options) {
  require(point);
  const double clearance =
      std::isnan(options.clearance) ? bearing.geometry().radial_clearance : options.clearance;
  const bool locked = options.tilt == Tilt::locked;
  const int free = locked ? 2 : 4;
  RollerEquilibrium result;
  RollerBalance balance(bearing, point.speed, clearance);
  const double lever = balance.lever();
  Vector4 load(point.radial_load, point.radial_load_z, point.moment_y / lever,
               point.moment_z / lever);
  if (locked) load.tail<2>().setZero();
  Vector4 ring = first_ring(bearing, point, clearance);
  if (locked) ring.tail<2>() = lever * Eigen::Vector2d(options.tilt_y, options.tilt_z);
  balance.start(ring);
  result.report = balance.solve(load, free, options);
  if (!result.report.converged()) return result;
  balance.report_into(result);
  result.loose = load.isZero(0.0) && !balance.inner_contact();
  const Vector4 given(load[0], load[1], lever * load[2], lever * load[3]);
  const double largest = std::max(given.head<2>().norm(), std::numeric_limits<double>::min());
  result.report.recovered_load_error =
      load.isZero(0.0) ? 0.0 : (result.load - given).head<2>().norm() / largest;
  return result;
}

DisplacedRollerBearing::DisplacedRollerBearing(const RollerBearing& bearing, double speed,
                                               double clearance)
    : clearance_(std::isnan(clearance) ? bearing.geometry().radial_clearance : clearance),
      balance_(std::make_unique<RollerBalance>(bearing, speed, clearance_)) {}
DisplacedRollerBearing::DisplacedRollerBearing(DisplacedRollerBearing&&) noexcept = default;
DisplacedRollerBearing& DisplacedRollerBearing::operator=(DisplacedRollerBearing&&) noexcept =
    default;
DisplacedRollerBearing::~DisplacedRollerBearing() = default;

void DisplacedRollerBearing::set_clearance(double clearance) { clearance_ = clearance; }

bool DisplacedRollerBearing::hold(const Vector5& displacement) {
  Vector4 ring = displacement.tail<4>();
  ring.tail<2>() *= balance_->lever();
  if (report_.converged()) {
    balance_->follow(ring, clearance_);
    report_ = balance_->solve(Vector4::Zero(), 0, {});
  }
  if (!report_.converged()) {
    balance_->set_clearance(clearance_);
    balance_->start(ring);
    report_ = balance_->solve(Vector4::Zero(), 0, {});
  }
  if (!report_.converged()) return false;
  Vector4 load;
  Matrix4 stiffness;
  balance_->ring_into(load, stiffness);
  force_ << 0.0, load;
  stiffness_.setZero();
  stiffness_.bottomRightCorner<4, 4>() = stiffness;
  return true;
}

RollerEquilibrium DisplacedRollerBearing::equilibrium() const {
  RollerEquilibrium result;
  result.report = report_;
  if (report_.converged()) balance_->report_into(result);
  return result;
}

RollerEquilibrium displaced_roller_bearing(const RollerBearing& bearing,
                                           const Vector4& displacement, double speed,
                                           double clearance) {
  DisplacedRollerBearing held(bearing, speed, clearance);
  Vector5 place;
  place << 0.0, displacement;
  (void)held.hold(place);
  return held.equilibrium();
}

ContactPressure largest_pressure(const RollerBearing& bearing,
                                 const RollerEquilibrium& equilibrium) {
  if (!equilibrium.report.converged()) return {};
  const auto of = [&](Race race) {
    return bearing.contact().peak_pressure(
        race, equilibrium.largest_lamina(race) / bearing.lamina_length());
  };
  return {.inner = of(Race::inner), .outer = of(Race::outer)};
}

}  // namespace raceway::bearing

#include "bench/equilibrium_scan.h"

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "bearing/ball_equilibrium.h"

namespace raceway::robustness {
namespace {

using namespace raceway::bearing;

class Scan {
 public:
  Scan(const Bearing& bearing, const OperatingPoint& point, const EquilibriumOptions& options)
      : bearing_(bearing), point_(point), free_tilt_(options.tilt == Tilt::free) {
    constants_ =
        ball_constants(bearing, point.speed, options.race_control, options.gyroscopic_moment);
    const BearingGeometry& g = bearing.geometry();
    lever_ = g.inner_groove_centre_radius();
    arm_ = g.inner_conformity * g.ball_diameter / lever_;
    distance_ = g.groove_centre_distance();
    free_ = {distance_ * std::sin(g.contact_angle), distance_ * std::cos(g.contact_angle)};
    balls_ = g.ball_count / 2 + 1;
    thrown_ = {0.0, constants_.outer_radius +
                        std::pow(0.2 * constants_.full_centrifugal / constants_.outer_stiffness,
                                 2.0 / 3.0)};
  }

  bool run(int nodes) {
    const double x0 = -free_.axial, x1 = 0.3 * distance_;
    const double y0 = 0.4 * distance_, t0 = free_tilt_ ? 0.6 * distance_ : 0.0;
    const int tilts = free_tilt_ ? nodes : 1;
    for (int it = 0; it < tilts; ++it) {
      const double tilt = tilts == 1 ? 0.0 : t0 * (2.0 * it / (tilts - 1) - 1.0);
      for (int iy = 0; iy < nodes; ++iy) {
        const double y = y0 * (2.0 * iy / (nodes - 1) - 1.0);
        for (int ix = 0; ix < nodes; ++ix) {
          const double x = x0 + (x1 - x0) * ix / (nodes - 1);
          for (const bool prefer_contact : {true, false})
            if (try_node({x, y, tilt}, prefer_contact)) return true;
        }
      }
    }
    return false;
  }

 private:
  using Ring = std::array<double, 3>;  // x, y, R θ_z

  Plane centre(const Ring& q, int k) const {
    const double c = bearing_.cos_azimuth()[static_cast<std::size_t>(k)];
    return {free_.axial + q[0] - q[2] * c, free_.radial + q[1] * c};
  }

  /// Equilibrium of one ball with its inner contact held one way; nothing if there is none.
  std::optional<Plane> ball(Plane a, InnerContact contact) const {
    Plane x = thrown_;
    if (contact == InnerContact::kept) {
      // On the line between the grooves, both races pressed.
      const double length = std::hypot(a.axial, a.radial);
      const double part =
          std::max(constants_.outer_radius + 1e-7, length * constants_.outer_radius / distance_);
      x = {part * a.axial / length, part * a.radial / length};
    }
    for (int i = 0; i < 40; ++i) {
      const BallBalance b = ball_balance(constants_, a, x, arm_, contact);
      const double det = b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2];
      double dx = -(b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial) / det;
      double dr = -(b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial) / det;
      const double longest = std::hypot(dx, dr), most = 0.2 * constants_.outer_radius;
      if (!std::isfinite(longest)) return std::nullopt;
      if (longest > most) dx *= most / longest, dr *= most / longest;
      x = {x.axial + dx, x.radial + dr};
      const double outer = std::hypot(x.axial, x.radial);
      const double least = constants_.outer_radius + 0.1 * b.outer_approach;
      if (b.outer_approach > 0.0 && outer < least) {
        x.axial *= least / outer;
        x.radial *= least / outer;
      }
      if (longest < 1e-12 * distance_) {
        const double approach =
            std::hypot(a.axial - x.axial, a.radial - x.radial) - constants_.inner_radius;
        if ((approach > 0.0) == (contact == InnerContact::kept)) return x;
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  bool try_node(const Ring& q, bool prefer_contact) {
    std::vector<Plane> x(static_cast<std::size_t>(balls_));
    std::vector<InnerContact> pattern(x.size());
    for (int k = 0; k < balls_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Plane a = centre(q, k);
      const InnerContact first = prefer_contact ? InnerContact::kept : InnerContact::lost;
      const InnerContact second = prefer_contact ? InnerContact::lost : InnerContact::kept;
      pattern[i] = first;
      auto found = ball(a, first);
      if (!found) {
        pattern[i] = second;
        found = ball(a, second);
      }
      if (!found) return false;
      x[i] = *found;
    }
    // Each pattern is tried from the node where the ring is nearest to balance, and from others
    // only while that improves.
    const double distance = ring_imbalance(q, x, pattern);
    const auto [seen, fresh] = best_.try_emplace(pattern, distance);
    if (!fresh && distance > 0.7 * seen->second) return false;
    seen->second = distance;
    return newton(q, x, pattern);
  }

  double ring_imbalance(const Ring& q, const std::vector<Plane>& x,
                        const std::vector<InnerContact>& pattern) const {
    return residual(q, x, pattern).head(free_tilt_ ? 3 : 2).cwiseAbs().maxCoeff();
  }

  Eigen::VectorXd residual(const Ring& q, const std::vector<Plane>& x,
                           const std::vector<InnerContact>& pattern) const {
    const int ring = free_tilt_ ? 3 : 2;
    Eigen::VectorXd r = Eigen::VectorXd::Zero(ring + 2 * balls_);
    const double load = std::max(std::abs(point_.axial_load), std::abs(point_.radial_load));
    r[0] = -point_.axial_load;
    r[1] = -point_.radial_load;
    if (free_tilt_) r[2] = -point_.moment_z / lever_;
    for (int k = 0; k < balls_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double w = k == 0 || 2 * k == bearing_.geometry().ball_count ? 1.0 : 2.0;
      const double c = bearing_.cos_azimuth()[i];
      const BallBalance b = ball_balance(constants_, centre(q, k), x[i], arm_, pattern[i]);
      r[0] += w * b.force.axial;
      r[1] += w * b.force.radial * c;
      if (free_tilt_) r[2] -= w * b.moment_force * c;
      const double scale = load / bearing_.geometry().ball_count + b.outer_load;
      r[ring + 2 * k] = b.imbalance.axial / scale;
      r[ring + 2 * k + 1] = b.imbalance.radial / scale;
    }
    r.head(ring) /= load;
    return r;
  }

  bool newton(Ring q, std::vector<Plane> x, const std::vector<InnerContact>& pattern) const {
    const int ring = free_tilt_ ? 3 : 2, n = ring + 2 * balls_;
    const double h = 1e-9 * distance_;
    const auto coordinate = [&](int j) -> double& {
      if (j < ring) return q[static_cast<std::size_t>(j)];
      Plane& p = x[static_cast<std::size_t>((j - ring) / 2)];
      return (j - ring) % 2 == 0 ? p.axial : p.radial;
    };
    Eigen::VectorXd r = residual(q, x, pattern);
    for (int i = 0; i < 25; ++i) {
      if (!r.allFinite()) return false;
      if (r.cwiseAbs().maxCoeff() < 1e-8) return contacts_hold(q, x, pattern);
      Eigen::MatrixXd jacobian(n, n);
      for (int j = 0; j < n; ++j) {
        double& v = coordinate(j);
        const double keep = v;
        v = keep + h;
        const Eigen::VectorXd up = residual(q, x, pattern);
        v = keep - h;
        jacobian.col(j) = (up - residual(q, x, pattern)) / (2.0 * h);
        v = keep;
      }
      Eigen::VectorXd step = jacobian.partialPivLu().solve(-r);
      if (!step.allFinite()) return false;
      const double longest = step.cwiseAbs().maxCoeff(), most = 0.1 * distance_;
      double fraction = longest > most ? most / longest : 1.0;
      const double before = r.norm();
      const Ring q0 = q;
      const std::vector<Plane> x0 = x;
      for (int halving = 0; halving < 8; ++halving, fraction *= 0.5) {
        q = q0;
        x = x0;
        for (int j = 0; j < n; ++j) coordinate(j) += fraction * step[j];
        r = residual(q, x, pattern);
        if (r.allFinite() && r.norm() < (halving == 0 ? 2.0 : 1.0) * before) break;
      }
    }
    return false;
  }

  bool contacts_hold(const Ring& q, const std::vector<Plane>& x,
                     const std::vector<InnerContact>& pattern) const {
    for (int k = 0; k < balls_; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Plane a = centre(q, k);
      const double approach =
          std::hypot(a.axial - x[i].axial, a.radial - x[i].radial) - constants_.inner_radius;
      if ((approach > 0.0) != (pattern[i] == InnerContact::kept)) return false;
    }
    return true;
  }

  const Bearing& bearing_;
  const OperatingPoint& point_;
  bool free_tilt_;
  BallConstants constants_{};
  double lever_, arm_, distance_;
  Plane free_, thrown_;
  int balls_;
  std::map<std::vector<InnerContact>, double> best_;  ///< nearest to balance so far, by pattern
};

}  // namespace

bool scan_finds_equilibrium(const bearing::Bearing& bearing, const bearing::OperatingPoint& point,
                            const bearing::EquilibriumOptions& options, int nodes) {
  return Scan(bearing, point, options).run(nodes);
}

}  // namespace raceway::robustness

#include "bearing/load_shares.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bearing/thrust_start.h"

namespace raceway::bearing {

LoadShares::LoadShares(const RingSystem& system, double direction)
    : system_(system),
      constants_(system.constants()),
      tilts_(system.options().tilt == Tilt::free),
      cos_direction_(std::cos(direction)),
      sin_direction_(std::sin(direction)),
      free_(system.free_groove_centre()),
      thrown_(system.thrown_ball()) {
  const Vector5 load = system.load();
  axial_ = load[0];
  radial_ = load[1] * cos_direction_ + load[2] * sin_direction_;
  moment_ = load[3] * sin_direction_ - load[4] * cos_direction_;
  const std::size_t n = system.balls_used();
  for (std::size_t k = 0; k < n; ++k)
    along_.push_back(system.bearing().cos_azimuth()[k] * cos_direction_ +
                     system.bearing().sin_azimuth()[k] * sin_direction_);
  order_.resize(n);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return along_[a] > along_[b] + 1e-9; });
}

void LoadShares::Sums::add(double weight, double cosine) {
  w += weight;
  c += weight * cosine;
  cc += weight * cosine * cosine;
  most = std::max(most, cosine);
  least = std::min(least, cosine);
}

bool LoadShares::choose(std::vector<InnerContact>& contacts, RingState& state) const {
  const std::size_t n = order_.size();
  const bool mirrored = system_.symmetry() == Symmetry::mirror;
  if (n < 2 || !(axial_ > 0.0)) return false;
  // As few as hold the ring's coordinates that are free: from one end, or from both.
  std::size_t first = mirrored ? 1 : 2, last = tilts_ ? 1 : 0;
  if (first + last > n) return false;
  Sums sums;
  const auto keep = [&](std::size_t place) {
    sums.add(system_.weight(order_[place]), along_[order_[place]]);
  };
  for (std::size_t i = 0; i < first; ++i) keep(i);
  for (std::size_t i = 0; i < last; ++i) keep(n - 1 - i);
  Vector5 ring;
  bool at_far_end = false;
  for (bool grown = false; first + last <= n; grown = true) {
    if (!ring_of(sums, ring)) {
      // More than statics can have: the one before.
      if (grown) --(at_far_end ? last : first);
      break;
    }
    const std::size_t place = reaching(ring, first, last);
    if (place == n) break;
    at_far_end = tilts_ && along_[order_[place]] <= 0.0;
    keep(at_far_end ? n - 1 - last++ : first++);
  }
  contacts.assign(n, InnerContact::lost);
  for (std::size_t i = 0; i < first; ++i) contacts[order_[i]] = InnerContact::kept;
  for (std::size_t i = 0; i < last; ++i) contacts[order_[n - 1 - i]] = InnerContact::kept;
  return spread(contacts, state);
}

bool LoadShares::spread(const std::vector<InnerContact>& contacts, RingState& state) const {
  return std::isfinite(violation(contacts, state));
}

double LoadShares::violation(const std::vector<InnerContact>& contacts, RingState& state) const {
  const Sums sums = sums_of(contacts);
  double moment = tilts_ ? moment_ : axial_ * sums.c / sums.w;
  if (tilts_ || !untilted_ring(sums, state.ring, moment)) {
    if (!ring_of(sums, state.ring)) return unset;
    if (!tilts_) moment = axial_ * sums.c / sums.w;
  }
  state.balls.assign(contacts.size(), thrown_);
  double worst = 0.0;
  Share share{};
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Plane a = system_.groove_centre(state.ring, k);
    if (contacts[k] == InnerContact::kept) {
      share = share_at(axial_share(sums, moment, along_[k]), a.radial, share);
      state.balls[k] = share.ball;
      const double root = std::cbrt(std::max(-share.inner_load, 0.0) / constants_.inner_stiffness);
      worst = std::max(worst, root * root);
    } else {
      const double reach =
          std::hypot(a.axial - thrown_.axial, a.radial - thrown_.radial) - constants_.inner_radius;
      worst = std::max(worst, reach);
    }
  }
  return worst;
}

LoadShares::Excess LoadShares::set_forces(double axial, double radius, Share& share) const {
  const BallConstantsOf<double>& c = constants_;
  const double si = std::sin(share.inner_angle), ci = std::cos(share.inner_angle);
  const double so = std::sin(share.outer_angle), co = std::cos(share.outer_angle);
  const double cd = ci * co + si * so, sd = si * co - ci * so, g = c.diameter_ratio;
  // m is ω_m/ω. The suffix _i or _o marks a derivative with respect to αi or αo, _m to m.
  const double m = (cd - g * co) / (1.0 + cd);
  const double m_i = -sd * (1.0 - m) / (1.0 + cd);
  const double m_o = (sd + g * so - m * sd) / (1.0 + cd);
  const double couple = 0.2 * c.full_centrifugal * c.gyroscopic;
  share.tau = couple * m * (1.0 - m);
  const double tau_m = couple * (1.0 - 2.0 * m), tau_i = tau_m * m_i, tau_o = tau_m * m_o;
  const double centrifugal = c.full_centrifugal * m * m,
               centrifugal_m = 2.0 * c.full_centrifugal * m;
  share.radial = axial * ci / si - share.tau;
  const double turned = axial / (si * si);
  const double radial = share.radial + centrifugal;
  const double radial_i = centrifugal_m * m_i - tau_i - turned;
  const double radial_o = centrifugal_m * m_o - tau_o;
  share.inner_load = axial / si - share.tau * ci;
  share.outer_load = axial * so + radial * co;
  const double outer_load = std::max(share.outer_load, 0.0);
  const double outer_root = std::cbrt(outer_load / c.outer_stiffness);
  const double inner_root = std::cbrt(share.inner_load / c.inner_stiffness);
  const double inner_approach = inner_root * std::abs(inner_root);
  const double outer = c.outer_radius + outer_root * outer_root;
  const double inner = c.inner_radius + inner_approach;
  share.ball = {outer * so, outer * co};
  share.groove = {share.ball.axial + inner * si, share.ball.radial + inner * ci};
  // The slope of an approach is infinite without load: below this load, its slope there is used.
  const double least = 1e-3 * axial;
  const double per_inner =
      ci * std::abs(inner_approach) / (1.5 * std::max(std::abs(share.inner_load), least));
  const double per_outer = co * outer_root * outer_root / (1.5 * std::max(outer_load, least));
  const double across = axial * co - radial * so;
  return {.force = across - share.tau * si,
          .force_i = -radial_i * so - tau_i * si - share.tau * ci,
          .force_o = -share.outer_load - radial_o * so - tau_o * si,
          .radius = share.groove.radial - radius,
          .radius_i = -inner * si + per_outer * radial_i * co +
                      per_inner * (share.tau * si - tau_i * ci - turned * ci),
          .radius_o = -outer * so - per_inner * tau_o * ci + per_outer * (across + radial_o * co)};
}

LoadShares::Share LoadShares::share_at(double axial, double radius, const Share& near) const {
  constexpr double least_angle = 1e-3, most_angle = 1.55, most_outer_angle = 1.2;  // [rad]
  constexpr double longest_step = 0.3;                                             // [rad]
  constexpr double largest_fall = 0.6;  // of the inner angle
  constexpr double tolerance = 1e-8;    // of the loads and of the outer distance
  constexpr int most_steps = 20;
  Share share = near.found ? near : Share{};
  share.found = false;
  if (!(share.inner_angle > 0.0))
    share.inner_angle =
        std::acos(std::clamp((radius - thrown_.radial) / constants_.inner_radius, 0.05, 0.99));
  for (int step = 0; step < most_steps; ++step) {
    const Excess e = set_forces(axial, radius, share);
    share.found = std::abs(e.radius) < tolerance * constants_.outer_radius &&
                  std::abs(e.force) < tolerance * (std::abs(share.outer_load) + axial);
    const double determinant = e.force_i * e.radius_o - e.force_o * e.radius_i;
    const double inner = (e.force_o * e.radius - e.force * e.radius_o) / determinant;
    const double outer = (e.force * e.radius_i - e.force_i * e.radius) / determinant;
    if (share.found || !std::isfinite(inner) || !std::isfinite(outer)) break;
    share.inner_angle += std::clamp(inner, -largest_fall * share.inner_angle, longest_step);
    share.inner_angle = std::clamp(share.inner_angle, least_angle, most_angle);
    share.outer_angle += std::clamp(outer, -longest_step, longest_step);
    share.outer_angle = std::clamp(share.outer_angle, -most_outer_angle, most_outer_angle);
  }
  return share;
}

bool LoadShares::ring_of(const Sums& sums, Vector5& ring) const {
  return tilts_ ? linear_ring(sums, moment_, ring) : even_ring(sums, ring);
}

bool LoadShares::even_ring(const Sums& sums, Vector5& ring) const {
  const Plane share{axial_ / sums.w, radial_ / sums.c};
  Plane groove, ball;
  if (!std::isfinite(share.radial) || !ball_under_force(constants_, share, groove, ball))
    return false;
  const double shift = (groove.radial - free_.radial) * sums.w / sums.c;
  ring.setZero();
  ring[0] = groove.axial - free_.axial;
  ring[1] = shift * cos_direction_;
  ring[2] = shift * sin_direction_;
  return ring.allFinite();
}

double LoadShares::axial_share(const Sums& s, double moment, double c) const {
  const double determinant = s.w * s.cc - s.c * s.c;
  if (!(determinant > 1e-9)) return axial_ / s.w;
  return ((axial_ * s.cc - moment * s.c) + (s.w * moment - s.c * axial_) * c) / determinant;
}

bool LoadShares::untilted_ring(const Sums& s, Vector5& ring, double& moment) const {
  // The moment at which a ring that could tilt would not. The unknown is by how much the axial
  // shares fall along the load, in parts of their mean: a secant from even shares.
  const double length = constants_.inner_radius + constants_.outer_radius;
  const double per_slope = (s.w * s.cc - s.c * s.c) / ((s.most - s.least) * s.w * s.w) * axial_;
  const auto tilt_at = [&](double slope) {
    moment = axial_ * s.c / s.w + slope * per_slope;
    return linear_ring(s, moment, ring) ? ring[4] * cos_direction_ - ring[3] * sin_direction_
                                        : unset;
  };
  double before = 0.0, at_before = tilt_at(before), slope = 0.2;
  if (!std::isfinite(at_before)) return false;
  for (int i = 0; i < 12; ++i) {
    const double at_slope = tilt_at(slope);
    if (std::abs(at_slope) < 1e-5 * length) {
      ring[3] = ring[4] = 0.0;
      return true;
    }
    if (std::isnan(at_slope)) {
      slope = 0.5 * (slope + before);
      continue;
    }
    const double step = -at_slope * (slope - before) / (at_slope - at_before);
    before = std::exchange(slope, slope + std::clamp(step, -0.6, 0.6));
    at_before = at_slope;
  }
  return false;
}

bool LoadShares::linear_ring(const Sums& s, double moment, Vector5& ring) const {
  if (!(s.most - s.least > 1e-6) || !(s.w * s.cc - s.c * s.c > 1e-9)) return false;
  const double axial_most = axial_share(s, moment, s.most);
  const double axial_least = axial_share(s, moment, s.least);
  Share most{}, least{};
  const auto surplus = [&](double shift) {
    most = share_at(axial_most, free_.radial + shift * s.most, most);
    least = share_at(axial_least, free_.radial + shift * s.least, least);
    if (!most.found || !least.found) return unset;
    const double slope = (most.radial - least.radial) / (s.most - s.least);
    return (most.radial - slope * s.most) * s.c + slope * s.cc - radial_;
  };
  // From where the balls pressed most stand at no angle, which is too far, back to too little. No
  // share at all is too little as well: a ball that carries little does not reach that far in.
  const double length = constants_.inner_radius + constants_.outer_radius;
  double step = 0.01 * length;
  double high = (thrown_.radial + constants_.inner_radius - free_.radial) / std::max(s.most, 0.1);
  double at_high = surplus(high);
  for (int i = 0; i < 8 && !(at_high > 0.0); ++i) at_high = surplus(high += step *= 2.0);
  if (!(at_high > 0.0)) return false;
  step = 0.01 * length;
  double low = high - step, at_low = surplus(low);
  for (int i = 0; i < 8 && at_low > 0.0; ++i) {
    high = low;
    at_high = at_low;
    at_low = surplus(low -= step *= 2.0);
  }
  if (at_low > 0.0) return false;
  // A secant that keeps both ends; a start needs few digits.
  const double enough = 1e-5 * std::max(std::abs(radial_), 0.01 * axial_);
  double value = at_low;
  for (int i = 0; i < 24 && !(std::abs(value) < enough) && high - low > 1e-8 * length; ++i) {
    const double secant = high - at_high * (high - low) / (at_high - at_low);
    const double middle = std::isfinite(secant) ? secant : 0.5 * (low + high);
    const double before = value;
    value = surplus(middle);
    if (value > 0.0) {
      high = middle;
      at_high = value;
      if (before > 0.0) at_low *= 0.5;
    } else {
      low = middle;
      at_low = value;
      if (before < 0.0) at_high *= 0.5;
    }
  }
  if (std::isnan(value)) return false;
  const double tilt = (least.groove.axial - most.groove.axial) / (s.most - s.least);
  const double shift = (most.groove.radial - least.groove.radial) / (s.most - s.least);
  ring[0] = most.groove.axial + tilt * s.most - free_.axial;
  ring[1] = shift * cos_direction_;
  ring[2] = shift * sin_direction_;
  ring[3] = -tilt * sin_direction_;
  ring[4] = tilt * cos_direction_;
  return ring.allFinite();
}

LoadShares::Sums LoadShares::sums_of(const std::vector<InnerContact>& contacts) const {
  Sums sums;
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (contacts[k] == InnerContact::kept) sums.add(system_.weight(k), along_[k]);
  return sums;
}

std::size_t LoadShares::reaching(const Vector5& ring, std::size_t first, std::size_t last) const {
  const std::size_t n = order_.size();
  std::size_t found = n;
  double furthest = 0.0;
  for (std::size_t i = first; i + last < n; ++i) {
    const Plane a = system_.groove_centre(ring, order_[i]);
    const double approach =
        std::hypot(a.axial - thrown_.axial, a.radial - thrown_.radial) - constants_.inner_radius;
    if (!(approach > furthest)) continue;
    furthest = approach;
    found = i;
  }
  return found;
}

}  // namespace raceway::bearing

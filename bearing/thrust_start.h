#pragma once

#include "bearing/ball_equilibrium.h"
#include "bearing/lanes.h"

namespace raceway::bearing {

/// Approximate positions of the ring and of every ball under a pure axial load (thrust). If the
/// axial load is above 0, the solver starts Newton's method from these positions. If the solution
/// of a neighbouring operating point is known, the solver first starts from this solution. T is
/// double, or a SIMD batch with one operating point in each lane (lanes.h).
template <typename T>
struct ThrustStart {
  T axial_displacement;    ///< displacement of the inner ring [m]
  PlaneOf<T> ball_centre;  ///< position X of the ball centre [m]
};

/// Static equilibrium of a ball under a thrust P per ball, at a given cotangent of the inner
/// contact angle:
///
///   Qi = (P - Ti cos αi)/sin αi,   tan αo = P / (Qi cos αi - Ti sin αi + 1.4 Fc)   (outer control)
///
/// Qi, Ti, Fc and the contact angles αi, αo are explained in BallBalanceOf. The term 0.4 Fc in 1.4
/// Fc comes from the friction force To, which balances the gyroscopic moment.
template <RaceControl control, typename T>
class ThrustStatics {
 public:
  ThrustStatics(const BallConstantsOf<T>& constants, const T& thrust)
      : c_(constants),
        thrust_(thrust),
        inner_share_(T(1.0) / constants.inner_stiffness),
        outer_share_(T(1.0) / constants.outer_stiffness) {}

  /// Computes the static equilibrium at the given cotangent of αi. The iteration for αo starts at
  /// the result of the previous call. If `active` is false for an operating point (lane), αo of
  /// this point does not change, and possible() is false.
  [[gnu::always_inline]] void solve(const T& cotangent, const Mask<T>& active) {
    using std::abs, std::cbrt, std::sqrt;
    const T one(1.0), zero(0.0);
    si_ = one / sqrt(one + cotangent * cotangent);
    ci_ = cotangent * si_;
    T qi = zero, qo = zero;
    Mask<T> possible(true), moving = active;
    // The orbital speed depends on αo, and αo depends on the orbital speed. A few iterations are
    // accurate enough for a start value.
    for (int round = 0; round < 6 && any(moving); ++round) {
      const T cd = ci_ * co_ + si_ * so_;
      const T m = cage_speed_ratio(control, ci_, co_, cd, c_.diameter_ratio);
      const T fc = c_.full_centrifugal * m * m;
      T ti = zero;
      if constexpr (control == RaceControl::inner)
        ti = 0.2 * c_.full_centrifugal * c_.gyroscopic * m * (one - m) * si_;
      const T load = (thrust_ - ti * ci_) / si_;
      const T radial = load * ci_ - ti * si_ + fc;
      T so, co;
      Mask<T> valid = load > zero;
      if constexpr (control == RaceControl::inner) {
        // P cos αo - R sin αo = To with R = `radial`: turn (P, R) back by asin(To/|(P, R)|).
        const T inv = one / sqrt(thrust_ * thrust_ + radial * radial);
        const T sin_turn = ti * inv;
        valid = valid && sin_turn < one;
        const T cos_turn = sqrt(select(valid, one - sin_turn * sin_turn, zero));
        so = (thrust_ * cos_turn - radial * sin_turn) * inv;
        co = (radial * cos_turn + thrust_ * sin_turn) * inv;
      } else {
        const T turned = radial + 0.4 * fc * c_.gyroscopic;
        const T inv = one / sqrt(thrust_ * thrust_ + turned * turned);
        so = thrust_ * inv;
        co = turned * inv;
      }
      possible = possible && (valid || !moving);
      const Mask<T> update = moving && valid;
      moving = update && !(abs(so - so_) < T(1e-4));
      qi = select(update, load, qi);
      qo = select(update, thrust_ * so + radial * co, qo);
      so_ = select(update, so, so_);
      co_ = select(update, co, co_);
    }
    possible = possible && qo > zero;
    const T inner_root = cbrt(select(possible, qi, zero) * inner_share_);
    const T outer_root = cbrt(select(possible, qo, zero) * outer_share_);
    possible_ = possible;
    inner_length_ = c_.inner_radius + inner_root * inner_root;
    outer_length_ = c_.outer_radius + outer_root * outer_root;
  }

  [[nodiscard]] Mask<T> possible() const { return possible_; }
  /// Radial distance between the groove centres [m].
  [[nodiscard]] T radial_distance() const { return outer_length_ * co_ + inner_length_ * ci_; }
  [[nodiscard]] T axial_distance() const { return outer_length_ * so_ + inner_length_ * si_; }
  [[nodiscard]] PlaneOf<T> ball_centre() const {
    return {outer_length_ * so_, outer_length_ * co_};
  }

 private:
  BallConstantsOf<T> c_;
  T thrust_, inner_share_, outer_share_;
  Mask<T> possible_ = Mask<T>(false);
  T si_ = T(0.0), ci_ = T(1.0), so_ = T(0.0), co_ = T(1.0);
  T inner_length_ = T(unset), outer_length_ = T(unset);  ///< groove centre to ball centre [m]
};

/// Improves an approximate cube root of x by one step of Halley's method, which triples the number
/// of correct digits.
template <typename T>
[[gnu::always_inline]] inline T better_root(const T& root, const T& x) {
  const T cube = root * root * root;
  return root * (cube + 2.0 * x) / (2.0 * cube + x);
}

/// Finds the positions under pure thrust (ThrustStart) by Newton's method. The unknowns are c = cos
/// αi and the orbital speed ratio m:
///
///   E = Lo cos αo + Li c - R = 0,   m = F(c, cos(αi - αo))
///   t = cot αo = (Qi c + 1.4 Fc)/P,   ∂t/∂c = 1/sin³ αi,   ∂t/∂m = 2.8 C m/P
///   d sin αo = -cos αo sin² αo dt,   d cos αo = sin³ αo dt,   dδ = (2/3) (δ/Q) dQ
///
/// Lo and Li are the distances from the ball centre to the outer and the inner groove centre.
/// `free` is the inner groove centre of the undisplaced ring, and R = `free.radial` is the radial
/// distance between the groove centres. F is cage_speed_ratio(), and P is the thrust per ball. Q is
/// the load and δ the Hertz approach of one contact. Qi, Fc and C are explained in BallBalanceOf.
/// The formula of cot αo is valid for outer control. Under inner control, the function uses the
/// same derivatives and neglects the change of the gyroscopic couple. The iteration ends when a
/// step changes c by less than 0.01 and αo by less than 0.01 rad. Returns true in each lane
/// (operating point) in which the iteration converges.
template <RaceControl control, typename T>
Mask<T> quick_thrust_start(const BallConstantsOf<T>& c, const PlaneOf<T>& free, const T& thrust,
                           ThrustStart<T>& start) {
  using std::abs, std::cbrt, std::max, std::min, std::sqrt;
  using M = Mask<T>;
  constexpr double last_step = 0.01;  // largest change of c [1] and of αo [rad] in the last step
  const T one(1.0), zero(0.0), lowest(0.02), highest(0.999);
  const T inner_share = one / c.inner_stiffness, outer_share = one / c.outer_stiffness;
  const T inv_thrust = one / thrust;
  const T friction = 0.4 * c.gyroscopic;
  T ci = min(free.radial / sqrt(free.axial * free.axial + free.radial * free.radial), highest);
  T m = 0.5 * (one - c.diameter_ratio * ci);
  T inner_root(0.0), outer_root(0.0);
  M open(true), found(false);
  start.axial_displacement = zero;
  start.ball_centre = {zero, zero};
  for (int i = 0; i < 6 && any(open); ++i) {
    const T si = sqrt(one - ci * ci);
    const T inv_si = one / si;
    const T fc = c.full_centrifugal * m * m;
    T qi, radial, so, co;
    M possible(true);
    if constexpr (control == RaceControl::inner) {
      // Both races carry the gyroscopic couple. The outer contact angle follows from the same
      // formula as in ThrustStatics.
      const T ti = 0.2 * c.full_centrifugal * c.gyroscopic * m * (one - m) * si;
      qi = (thrust - ti * ci) * inv_si;
      radial = qi * ci - ti * si + fc;
      const T inv = one / sqrt(thrust * thrust + radial * radial);
      const T sin_turn = ti * inv;
      possible = qi > zero && sin_turn < one;
      const T cos_turn = sqrt(select(possible, one - sin_turn * sin_turn, zero));
      so = (thrust * cos_turn - radial * sin_turn) * inv;
      co = (radial * cos_turn + thrust * sin_turn) * inv;
    } else {
      qi = thrust * inv_si;
      radial = qi * ci + fc;
      const T cotangent = (radial + friction * fc) * inv_thrust;
      so = one / sqrt(one + cotangent * cotangent);
      co = cotangent * so;
    }
    const T inner = max(qi, zero) * inner_share;
    const T qo = thrust * so + radial * co;
    const T outer = max(qo, zero) * outer_share;
    if (i == 0) {
      inner_root = cbrt(inner);
      outer_root = better_root(inner_root, outer);
    } else {
      inner_root = better_root(inner_root, inner);
    }
    outer_root = better_root(outer_root, outer);
    const T inner_approach = inner_root * inner_root, outer_approach = outer_root * outer_root;
    const T li = c.inner_radius + inner_approach, lo = c.outer_radius + outer_approach;
    const T excess = lo * co + li * ci - free.radial;

    // Derivatives of αo and of Lo with respect to c and m.
    const T flatter = ci * inv_si, inv_si2 = inv_si * inv_si, so2 = so * so;
    const T t_c = inv_si2 * inv_si;
    const T fc_m = 2.0 * c.full_centrifugal * m;
    const T t_m = (one + friction) * fc_m * inv_thrust;
    const T co_t = so2 * so, so_t = -co * so2;
    const T soft = (2.0 / 3.0) * outer_approach / qo;
    const T lo_t = -soft * co_t * friction * fc;
    const T lo_c = soft * co * thrust * t_c + lo_t * t_c, lo_m = soft * co * fc_m + lo_t * t_m;
    const T li_c = (2.0 / 3.0) * inner_approach * ci * inv_si2;
    const T e_c = li + li_c * ci + lo * co_t * t_c + co * lo_c;
    const T e_m = lo * co_t * t_m + co * lo_m;
    // Derivatives of F - m with respect to c and m.
    const T cd = ci * co + si * so, sd = si * co - ci * so;
    const T inv = one / (one + cd);
    T ratio, ratio_c, ratio_t;
    if constexpr (control == RaceControl::inner) {
      ratio = (cd - c.diameter_ratio * co) * inv;
      ratio_c = (one - ratio) * inv * sd * inv_si;
      ratio_t = -inv * so2 * ((one - ratio) * sd + c.diameter_ratio * so);
    } else {
      ratio = (one - c.diameter_ratio * ci) * inv;
      ratio_c = -inv * (c.diameter_ratio + ratio * sd * inv_si);
      ratio_t = ratio * inv * so2 * sd;
    }
    const T behind = ratio - m;
    const T f_c = ratio_c + ratio_t * t_c, f_m = ratio_t * t_m - one;
    const T scale = one / (e_c * f_m - e_m * f_c);
    const T dc = (e_m * behind - excess * f_m) * scale;
    const T dm = (excess * f_c - e_c * behind) * scale;
    const T dt = t_c * dc + t_m * dm;

    const M close = possible && abs(dc) < T(last_step) && abs(dt) * so2 < T(last_step);
    const M keep = open && close;
    const T next_so = so + so_t * dt, next_co = co + co_t * dt;
    const T next_lo = lo + lo_c * dc + lo_m * dm;
    start.axial_displacement =
        select(keep,
               next_lo * next_so + (li + li_c * dc) * (si - flatter * dc - 0.5 * t_c * dc * dc) -
                   free.axial,
               start.axial_displacement);
    start.ball_centre.axial = select(keep, next_lo * next_so, start.ball_centre.axial);
    start.ball_centre.radial = select(keep, next_lo * next_co, start.ball_centre.radial);
    found = found || keep;
    const T next = ci + dc;
    open = open && possible && !close && next > lowest && finite(next);
    ci = min(max(next, lowest), highest);
    m = m + dm;
  }
  return found;
}

/// Finds the positions under pure thrust (ThrustStart) by quick_thrust_start(). In lanes in which
/// quick_thrust_start() fails, a bracketing secant method solves the equation
/// ThrustStatics::radial_distance() = `free.radial` for cot αi. Returns false in lanes whose
/// operating points have no equilibrium under pure thrust.
template <RaceControl control, typename T>
Mask<T> thrust_start(const BallConstantsOf<T>& c, const PlaneOf<T>& free, const T& thrust,
                     ThrustStart<T>& start) {
  using std::abs, std::max;
  using M = Mask<T>;
  const T zero(0.0);
  const M quick = quick_thrust_start<control>(c, free, thrust, start);
  if (all(quick)) return quick;
  ThrustStatics<control, T> statics(c, thrust);
  const auto excess = [&](const T& cotangent, const M& active) {
    statics.solve(cotangent, active);
    return select(statics.possible(), statics.radial_distance() - free.radial, T(unset));
  };
  // Bracket the root: the radial distance is too long at small contact angles and too short at
  // large contact angles. Under inner control, the static equilibrium may have no solution in a
  // part of the range, so there may be no root.
  T high = free.radial / max(free.axial, 0.01 * free.radial);
  T at_high = excess(high, !quick);
  for (int i = 0; i < 20; ++i) {
    const M flatter = !quick && at_high < zero;
    if (!any(flatter)) break;
    high = select(flatter, 4.0 * high, high);
    at_high = select(flatter, excess(high, flatter), at_high);
  }
  const M rooted = !quick && at_high >= zero;
  T low = high, at_low = at_high;
  for (int i = 0; i < 80; ++i) {
    const M steeper = rooted && at_low > zero;
    if (!any(steeper)) break;
    high = select(steeper, low, high);
    at_high = select(steeper, at_low, at_high);
    low = select(steeper, select(low > T(0.05), 0.7 * low, low - 0.5), low);
    at_low = select(steeper, excess(low, steeper), at_low);
  }
  // The static equilibrium may have no solution near `low`. Search for a root on the side of
  // `high`.
  for (int i = 0; i < 60; ++i) {
    const M outside = rooted && at_low != at_low;
    if (!any(outside)) break;
    const T middle = 0.5 * (low + high);
    const T value = excess(middle, outside);
    const M above = outside && value > zero;
    low = select(outside && !above, middle, low);
    at_low = select(outside && !above, value, at_low);
    high = select(above, middle, high);
    at_high = select(above, value, at_high);
  }
  M open = rooted && at_low <= zero;
  M found = quick;
  for (int i = 0; i < 30 && any(open); ++i) {
    const T secant = high - at_high * (high - low) / (at_high - at_low);
    const T cotangent = select(finite(secant), secant, 0.5 * (low + high));
    const T value = excess(cotangent, open);
    const PlaneOf<T> ball = statics.ball_centre();
    start.axial_displacement =
        select(open, statics.axial_distance() - free.axial, start.axial_displacement);
    start.ball_centre.axial = select(open, ball.axial, start.ball_centre.axial);
    start.ball_centre.radial = select(open, ball.radial, start.ball_centre.radial);
    found = found || (open && statics.possible());
    found = found && !(open && !statics.possible());
    open = open && !(abs(value) < 1e-4 * free.radial || high - low < 1e-9 * (1.0 + abs(high)));
    // Illinois method: halve the value at the end that did not move, so that both ends move.
    const M above = value > zero;
    high = select(open && above, cotangent, high);
    low = select(open && !above, cotangent, low);
    at_low = select(open, select(above, 0.5 * at_low, value), at_low);
    at_high = select(open, select(above, value, 0.5 * at_high), at_high);
  }
  return found;
}

[[nodiscard]] bool thrust_start(RaceControl control, const BallConstantsOf<double>& constants,
                                Plane free_groove_centre, double thrust_per_ball,
                                ThrustStart<double>& start);

/// Finds the ball centre and the inner groove centre at which one ball under inner control exerts
/// the given force f on the inner ring: tan αi = f_axial / (f_radial + τ), τ = Ti / sin αi. Ti is
/// the friction force at the inner race. The outer contact angle and load follow from the static
/// equilibrium of the ball. Returns false if there is no such equilibrium, for example because a
/// contact would be in tension.
[[nodiscard]] bool ball_under_force(const BallConstantsOf<double>& constants, Plane force,
                                    Plane& groove_centre, Plane& ball_centre);

}  // namespace raceway::bearing

#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/bearing.h"
#include "bearing/kinematics.h"
#include "bearing/lanes.h"

// The templates compute one ball, or the same ball at several operating points in parallel. lanes.h
// describes the number types of these templates. Names without the suffix `Of` are for one ball in
// double precision.
namespace raceway::bearing {

/// Vector (axial, radial) in the plane through the bearing axis and the centre of one ball.
template <typename T>
struct PlaneOf {
  T axial = T(0.0);
  T radial = T(0.0);
  bool operator==(const PlaneOf&) const = default;
};
using Plane = PlaneOf<double>;

/// Constants of all balls of a bearing at one speed.
template <typename T>
struct BallConstantsOf {
  T inner_radius;      ///< (f_i - 0.5) D: inner groove centre to ball centre, unloaded [m]
  T outer_radius;      ///< (f_o - 0.5) D: outer groove centre to ball centre, unloaded [m]
  T inner_stiffness;   ///< K_i, HertzContact::contact_stiffness at the inner race [N/m^1.5]
  T outer_stiffness;   ///< K_o, HertzContact::contact_stiffness at the outer race [N/m^1.5]
  T diameter_ratio;    ///< g = D/d_m [1]
  T full_centrifugal;  ///< C = m_ball d_m ω²/2: centrifugal force of a ball orbiting at ω [N]
  T gyroscopic;        ///< 1 with the gyroscopic moment, 0 without it [1]
};

struct BallConstants : BallConstantsOf<double> {
  RaceControl race_control;
};

/// Law for the rotation of a ball: race control, or values given by the caller.
enum class Rotation { outer_control, inner_control, given };

/// Centrifugal force of a ball that would orbit at the shaft speed ω, C = m_ball d_m ω²/2 [N].
[[nodiscard]] double full_centrifugal(const Bearing& bearing, double speed);
[[nodiscard]] BallConstants ball_constants(const Bearing& bearing, double speed,
                                           RaceControl race_control, bool gyroscopic_moment);

/// Contact loads and forces of one ball.
template <typename T>
struct BallForcesOf {
  T inner_load, outer_load;          ///< Qi, Qo: normal forces at the races [N]
  T inner_friction, outer_friction;  ///< Ti, To: friction forces at the races [N]
  T centrifugal;                     ///< Fc [N]
  T inner_approach, outer_approach;  ///< δi, δo: elastic approaches [m]; negative: gap
};

/// Imbalance of one ball (sum of all forces on the ball), its forces on the inner ring, and all
/// first derivatives.
///
/// The coordinates are (axial, radial) with the outer groove centre at the origin. X is the ball
/// centre, A the inner groove centre, V = A - X. n and t are the normal and the tangent of a
/// contact, and the indices i and o are inner and outer race. f_i, f_o, D, d_m and R_i are
/// explained in BearingGeometry, K in BallConstantsOf, and the forces Q, T, Fc and the approach δ
/// in BallForcesOf:
///
///   n = (sin α, cos α),  t = (cos α, -sin α),   sin αo = X1/|X|,  sin αi = V1/|V|
///   Q = K δ^1.5,  δo = |X| - (f_o - 0.5) D,  δi = |V| - (f_i - 0.5) D
///   imbalance           r = Qi ni + Ti ti + (0, Fc) - Qo no - To to = 0
///   force on the ring   f = Qi ni + Ti ti
///   moment / R_i        f_m = f_axial - (f_i D / R_i) Ti   (Ti acts at the groove surface)
///
/// Fc = C m² with m = ω_m/ω, C = m_ball d_m ω²/2. ω is the shaft speed, and J is the moment of
/// inertia of a ball. ω_m, ω_R and β are explained in BallSpeeds. The friction forces T = λ M_g/D
/// balance the gyroscopic couple M_g = J ω_m ω_R sin β. Under outer control, the friction acts only
/// at the outer race (λo = 2): To = 0.4 Fc sin αo and Ti = 0.
///
/// Under inner control, the friction is equal at both races (λi = λo = 1):
///
///   Ti = To = 0.2 C m (1 - m) sin αi
///
/// A positive M_g reduces αo. In equations (14) and (18) of [CaseStudy], M_g has the opposite sign,
/// so a positive M_g increases αo. A ball without inner contact (δi <= 0) is under outer control
/// and exerts no force on the inner ring. Under inner control, the forces of a ball jump when the
/// ball loses the inner contact, so some loads have no equilibrium. For a given rotation, m, Ti and
/// To follow from GivenRotation.
template <typename T>
struct BallBalanceOf : BallForcesOf<T> {
  PlaneOf<T> imbalance;  ///< r [N]
  PlaneOf<T> force;      ///< f [N]
  T moment_force;        ///< f_m [N]
  // Row-major blocks. The two columns are the derivatives with respect to (axial, radial).
  T r_a[4];  ///< ∂r/∂A at fixed X [N/m]
  T r_x[4];  ///< ∂r/∂X at fixed A [N/m]
  T f_a[6];  ///< ∂(f, f_m)/∂A at fixed X, 3x2 [N/m]
  T f_x[6];  ///< ∂(f, f_m)/∂X at fixed A, 3x2 [N/m]
};
using BallBalance = BallBalanceOf<double>;

/// Contact of a ball with the inner race. With `automatic`, the ball touches the race if the
/// approach δi is positive. During a search, a solver can fix the contact: a ball with a `kept`
/// contact always touches, and a ball with a `lost` contact never touches. A `kept` contact may be
/// in tension, with the load Q = K δ |δ|^0.5 (K: contact stiffness). A solution is valid only if no
/// `kept` contact is in tension and no ball with a `lost` contact penetrates the race.
enum class InnerContact : signed char { automatic, kept, lost };

/// Sines (s) and cosines (c) of the contact angles αi and αo, and inv = 1/(1 + cos(αi - αo)).
template <typename T>
struct ContactAngles {
  T si, ci, so, co;
  T cos_difference, sin_difference;  ///< cosine and sine of αi - αo
  T inv;
};

/// Results of a rotation law: the ratio m = ω_m/ω of orbital speed to shaft speed, the forces Fc,
/// Ti and To of BallForcesOf, and their derivatives. The suffixes _i and _o denote derivatives with
/// respect to the contact angles αi and αo [1/rad].
template <typename T>
struct RaceLaw {
  T m, m_i, m_o;
  T fc, fc_i, fc_o;
  T ti, ti_i, ti_o;
  T to, to_i, to_o;
};

template <typename T>
[[gnu::always_inline]] inline void add_centrifugal(const BallConstantsOf<T>& c, RaceLaw<T>& law) {
  const T full = c.full_centrifugal, twice = 2.0 * full * law.m;
  law.fc = full * law.m * law.m;
  law.fc_i = twice * law.m_i;
  law.fc_o = twice * law.m_o;
}

template <typename T>
[[nodiscard, gnu::always_inline]] inline RaceLaw<T> outer_race_law(const BallConstantsOf<T>& c,
                                                                   const ContactAngles<T>& a) {
  const T g = c.diameter_ratio;
  RaceLaw<T> law;
  law.m = (1.0 - g * a.ci) * a.inv;
  law.m_i = (g * a.si + law.m * a.sin_difference) * a.inv;
  law.m_o = -law.m * a.sin_difference * a.inv;
  add_centrifugal(c, law);
  law.ti = law.ti_i = law.ti_o = T(0.0);
  const T scale = 0.4 * c.gyroscopic;
  law.to = scale * law.fc * a.so;
  law.to_i = scale * law.fc_i * a.so;
  law.to_o = scale * (law.fc_o * a.so + law.fc * a.co);
  return law;
}

template <typename T>
[[nodiscard, gnu::always_inline]] inline RaceLaw<T> inner_race_law(const BallConstantsOf<T>& c,
                                                                   const ContactAngles<T>& a) {
  const T g = c.diameter_ratio;
  const T turn = a.sin_difference * (1.0 + g * a.co) * a.inv;
  RaceLaw<T> law;
  law.m = (a.cos_difference - g * a.co) * a.inv;
  law.m_i = -turn * a.inv;
  law.m_o = (turn + g * a.so) * a.inv;
  add_centrifugal(c, law);
  const T scale = 0.2 * c.full_centrifugal * c.gyroscopic;
  const T slope = scale * (1.0 - 2.0 * law.m) * a.si;
  const T couple = scale * law.m * (1.0 - law.m);
  law.ti = law.to = couple * a.si;
  law.ti_i = law.to_i = slope * law.m_i + couple * a.ci;
  law.ti_o = law.to_o = slope * law.m_o;
  return law;
}

template <typename T>
[[nodiscard, gnu::always_inline]] inline RaceLaw<T> given_rotation_law(const BallConstantsOf<T>& c,
                                                                       const ContactAngles<T>& a,
                                                                       const GivenRotation& r,
                                                                       const T& inner_load) {
  const T g = c.diameter_ratio;
  const T inner = 1.0 - g * a.ci, outer = 1.0 + g * a.co;
  const T inner_axis = a.ci * r.cos_pitch + a.si * r.sin_pitch;
  const T outer_axis = a.co * r.cos_pitch + a.so * r.sin_pitch;
  const T p = inner * outer_axis, q = outer * inner_axis;
  const T inv = 1.0 / (p + q);
  RaceLaw<T> law;
  law.m = p * inv + r.creep;
  law.m_i = (g * a.si * outer_axis * q - p * outer * (a.ci * r.sin_pitch - a.si * r.cos_pitch)) *
            (inv * inv);
  law.m_o = (inner * (a.co * r.sin_pitch - a.so * r.cos_pitch) * q + p * g * a.so * inner_axis) *
            (inv * inv);
  add_centrifugal(c, law);
  const T share = std::min(std::max(inner_load / r.inner_load, T(0.0)), T(1.0));
  law.ti = r.inner_friction * share * (2.0 - share);
  law.to = r.outer_friction * share * (2.0 - share);
  law.ti_i = law.ti_o = law.to_i = law.to_o = T(0.0);
  return law;
}

/// Derivatives of the friction forces Ti (`inner`) and To (`outer`) with respect to the load at the
/// inner contact [N/N], for a given rotation.
struct FrictionGain {
  double inner, outer;
};
[[nodiscard]] inline FrictionGain friction_gain(const GivenRotation& r, double inner_load) {
  const double share = inner_load / r.inner_load;
  if (!(share > 0.0 && share < 1.0)) return {0.0, 0.0};
  const double slope = 2.0 * (1.0 - share) / r.inner_load;
  return {r.inner_friction * slope, r.outer_friction * slope};
}

/// Results of the rotation law of a ball. Under inner control, a ball without inner contact follows
/// the law of outer control.
template <Rotation rotation, typename T>
[[nodiscard, gnu::always_inline]] inline RaceLaw<T> race_law(const BallConstantsOf<T>& c,
                                                             const ContactAngles<T>& a,
                                                             const Mask<T>& touches,
                                                             const T& inner_load,
                                                             const GivenRotation* given) {
  if constexpr (rotation == Rotation::outer_control) {
    return outer_race_law(c, a);
  } else if constexpr (rotation == Rotation::given) {
    return given_rotation_law(c, a, *given, inner_load);
  } else if constexpr (is_scalar<T>) {
    return touches ? inner_race_law(c, a) : outer_race_law(c, a);
  } else {
    const RaceLaw<T> in = inner_race_law(c, a), out = outer_race_law(c, a);
    const auto of = [&](T RaceLaw<T>::*x) { return select(touches, in.*x, out.*x); };
    using L = RaceLaw<T>;
    return {of(&L::m),  of(&L::m_i),  of(&L::m_o),  of(&L::fc), of(&L::fc_i), of(&L::fc_o),
            of(&L::ti), of(&L::ti_i), of(&L::ti_o), of(&L::to), of(&L::to_i), of(&L::to_o)};
  }
}

/// Returns the imbalance and the forces of a ball whose rotation follows the law `rotation`. The
/// argument `given` is used only for Rotation::given.
template <Rotation rotation, typename T>
[[nodiscard, gnu::always_inline]] inline BallBalanceOf<T> ball_balance_under(
    const BallConstantsOf<T>& c, const PlaneOf<T>& groove_centre, const PlaneOf<T>& ball_centre,
    const T& moment_arm_ratio, InnerContact contact, const GivenRotation* given = nullptr) {
  constexpr bool inner_couple = rotation != Rotation::outer_control;
  using std::abs, std::max, std::sqrt;
  const T x1 = ball_centre.axial, x2 = ball_centre.radial;
  const T v1 = groove_centre.axial - x1, v2 = groove_centre.radial - x2;
  const T outer_length = sqrt(x1 * x1 + x2 * x2);
  const T inner_length = sqrt(v1 * v1 + v2 * v2);
  const T delta_o = outer_length - c.outer_radius;
  const T delta_i = inner_length - c.inner_radius;
  const T product = outer_length * inner_length, straight = x1 * v1 + x2 * v2;
  // For a ball without inner contact, the inner groove centre may lie behind the ball, where no
  // contact is possible. cos(αi - αo) is then set to -1/2, because 1/(1 + cos(αi - αo)) is infinite
  // for cos(αi - αo) = -1.
  const Mask<T> behind = straight < -0.5 * product;
  const Mask<T> touches = contact == InnerContact::automatic
                              ? delta_i > T(0.0) && !behind
                              : Mask<T>(contact == InnerContact::kept);
  const T along = select(behind, -0.5 * product, straight);
  // One division for 1/|X|, 1/|V| and 1/(1 + cos(αi - αo)).
  const T both = product + along;
  const T reciprocal = 1.0 / (product * both);
  const T inv_product = both * reciprocal;
  const T inv_lo = inner_length * inv_product, inv_li = outer_length * inv_product;
  const T si = v1 * inv_li, ci = v2 * inv_li;
  const T so = x1 * inv_lo, co = x2 * inv_lo;

  const T root_o = sqrt(max(delta_o, T(0.0)));
  const T root_i = select(touches, sqrt(abs(delta_i)), T(0.0));
  const T ko = 1.5 * c.outer_stiffness * root_o;  // dQ/dδ
  const T ki = 1.5 * c.inner_stiffness * root_i;
  const T qo = c.outer_stiffness * root_o * root_o * root_o;
  const T qi = c.inner_stiffness * root_i * delta_i;

  const ContactAngles<T> angles{
      .si = si,
      .ci = ci,
      .so = so,
      .co = co,
      .cos_difference = along * inv_product,
      .sin_difference = select(behind, T(0.0), (v1 * x2 - v2 * x1) * inv_product),
      .inv = product * (product * reciprocal)};
  const RaceLaw<T> law = race_law<rotation>(c, angles, touches, qi, given);
  const T fc = law.fc, fc_i = law.fc_i, fc_o = law.fc_o;
  const T ti = law.ti, ti_i = law.ti_i, ti_o = law.ti_o;
  const T to = law.to, to_i = law.to_i, to_o = law.to_o;

  BallBalanceOf<T> b;
  b.force = {qi * si, qi * ci};
  if constexpr (inner_couple) b.force = {b.force.axial + ti * ci, b.force.radial - ti * si};
  b.moment_force = b.force.axial;
  if constexpr (inner_couple) b.moment_force -= moment_arm_ratio * ti;
  b.imbalance = {b.force.axial - qo * so - to * co, b.force.radial + fc - qo * co + to * so};
  b.inner_load = qi;
  b.outer_load = qo;
  b.inner_friction = ti;
  b.outer_friction = to;
  b.centrifugal = fc;
  b.outer_approach = delta_o;
  b.inner_approach = delta_i;

  // With dV = dA - dX: dδi = n_i·dV, dαi = t_i·dV/|V|. The same formulas apply to the outer contact
  // with dX. f_ai and r_ai are derivatives of f and r with respect to αi. r_ao is the derivative of
  // r with respect to αo.
  T f_ai_1 = qi * ci, f_ai_2 = -qi * si;
  T r_ao_1 = to * so - (qo + to_o) * co, r_ao_2 = fc_o + (qo + to_o) * so + to * co;
  if constexpr (inner_couple) {
    f_ai_1 += ti_i * ci - ti * si;
    f_ai_2 -= ti_i * si + ti * ci;
    r_ao_1 += ti_o * ci;
    r_ao_2 -= ti_o * si;
  }
  const T r_ai_1 = f_ai_1 - to_i * co, r_ai_2 = f_ai_2 + fc_i + to_i * so;
  const T tiv1 = ci * inv_li, tiv2 = -si * inv_li;  // ∂αi/∂V
  const T tox1 = co * inv_lo, tox2 = -so * inv_lo;  // ∂αo/∂X

  [[maybe_unused]] T r_n_1(0.0),
      r_n_2(0.0);  // derivative of r with respect to δi for a given rotation
  const T n11 = ki * si * si, n12 = ki * si * ci, n22 = ki * ci * ci;
  b.f_a[0] = b.f_a[4] = n11 + f_ai_1 * tiv1;
  b.f_a[1] = b.f_a[5] = n12 + f_ai_1 * tiv2;
  b.f_a[2] = n12 + f_ai_2 * tiv1;
  b.f_a[3] = n22 + f_ai_2 * tiv2;
  if constexpr (inner_couple) {
    b.f_a[4] -= moment_arm_ratio * ti_i * tiv1;
    b.f_a[5] -= moment_arm_ratio * ti_i * tiv2;
  }
  if constexpr (rotation == Rotation::given) {
    const FrictionGain gain = friction_gain(*given, qi);
    const T gi = gain.inner * ki, go = gain.outer * ki;
    const T f1 = gi * ci, f2 = -gi * si, fm = gi * (ci - moment_arm_ratio);
    b.f_a[0] += f1 * si;
    b.f_a[1] += f1 * ci;
    b.f_a[2] += f2 * si;
    b.f_a[3] += f2 * ci;
    b.f_a[4] += fm * si;
    b.f_a[5] += fm * ci;
    r_n_1 = f1 - go * co;
    r_n_2 = f2 + go * so;
  }
  // The ring forces depend on the ball position through V and through Ti, which depends on αo.
  for (int j = 0; j < 6; ++j) b.f_x[j] = -b.f_a[j];
  if constexpr (inner_couple) {
    b.f_x[0] += ti_o * ci * tox1;
    b.f_x[1] += ti_o * ci * tox2;
    b.f_x[2] -= ti_o * si * tox1;
    b.f_x[3] -= ti_o * si * tox2;
    b.f_x[4] += ti_o * (ci - moment_arm_ratio) * tox1;
    b.f_x[5] += ti_o * (ci - moment_arm_ratio) * tox2;
  }
  b.r_a[0] = n11 + r_ai_1 * tiv1;
  b.r_a[1] = n12 + r_ai_1 * tiv2;
  b.r_a[2] = n12 + r_ai_2 * tiv1;
  b.r_a[3] = n22 + r_ai_2 * tiv2;
  if constexpr (rotation == Rotation::given) {
    b.r_a[0] += r_n_1 * si;
    b.r_a[1] += r_n_1 * ci;
    b.r_a[2] += r_n_2 * si;
    b.r_a[3] += r_n_2 * ci;
  }
  b.r_x[0] = -b.r_a[0] - ko * so * so + r_ao_1 * tox1;
  b.r_x[1] = -b.r_a[1] - ko * so * co + r_ao_1 * tox2;
  b.r_x[2] = -b.r_a[2] - ko * so * co + r_ao_2 * tox1;
  b.r_x[3] = -b.r_a[3] - ko * co * co + r_ao_2 * tox2;
  return b;
}

/// Returns the imbalance and the forces of a ball under the race control `c.race_control` or, if
/// `given` is not null, with the given rotation. `moment_arm_ratio` = f_i D / R_i [1].
[[nodiscard]] inline BallBalance ball_balance(const BallConstants& c, Plane groove_centre,
                                              Plane ball_centre, double moment_arm_ratio,
                                              InnerContact contact = InnerContact::automatic,
                                              const GivenRotation* given = nullptr) {
  if (given)
    return ball_balance_under<Rotation::given, double>(c, groove_centre, ball_centre,
                                                       moment_arm_ratio, contact, given);
  return c.race_control == RaceControl::outer
             ? ball_balance_under<Rotation::outer_control, double>(c, groove_centre, ball_centre,
                                                                   moment_arm_ratio, contact)
             : ball_balance_under<Rotation::inner_control, double>(c, groove_centre, ball_centre,
                                                                   moment_arm_ratio, contact);
}

/// Ball at rest. The two contacts of the ball are springs in series on the line between the groove
/// centres: (1/K)^(2/3) = (1/K_i)^(2/3) + (1/K_o)^(2/3). The ball position is therefore not an
/// unknown.
template <typename T>
struct StaticBallOf {
  PlaneOf<T> ball_centre;  ///< X [m]
  PlaneOf<T> force;        ///< f [N]
  /// Derivatives df/dA of the force f with respect to the inner groove centre A, row-major [N/m].
  T f_a[4];
  T load;  ///< Q [N], equal at both contacts
};
using StaticBall = StaticBallOf<double>;

/// Spring that replaces both contacts of a ball at rest, which act as springs in series.
template <typename T>
struct SpringPairOf {
  T stiffness;    ///< K [N/m^1.5]
  T outer_share;  ///< approach at the outer race divided by the sum of both approaches [1]
};

[[nodiscard]] SpringPairOf<double> spring_pair(const BallConstants& constants);

template <typename T>
[[nodiscard, gnu::always_inline]] inline StaticBallOf<T> static_ball(const BallConstantsOf<T>& c,
                                                                     const SpringPairOf<T>& pair,
                                                                     const PlaneOf<T>& a) {
  using std::max, std::sqrt;
  const T length = sqrt(a.axial * a.axial + a.radial * a.radial);
  const Mask<T> apart = length > T(0.0);
  const T inv = 1.0 / select(apart, length, T(1.0));
  const T s = a.axial * inv;
  const T co = select(apart, a.radial * inv, T(1.0));
  const T free_length = c.inner_radius + c.outer_radius;
  const T delta = length - free_length;
  // Without contact, the position of the ball is arbitrary. Here, the ball is placed between the
  // grooves.
  const T outer_length = select(delta > T(0.0), c.outer_radius + delta * pair.outer_share,
                                length * c.outer_radius / free_length);
  const T root = sqrt(max(delta, T(0.0)));
  const T along = 1.5 * pair.stiffness * root;
  StaticBallOf<T> b;
  b.ball_centre = {outer_length * s, outer_length * co};
  b.load = pair.stiffness * root * root * root;
  b.force = {b.load * s, b.load * co};
  const T across = b.load * inv;
  b.f_a[0] = along * s * s + across * co * co;
  b.f_a[1] = b.f_a[2] = (along - across) * s * co;
  b.f_a[3] = along * co * co + across * s * s;
  return b;
}

[[nodiscard]] inline StaticBall static_ball(const BallConstants& constants, Plane groove_centre) {
  return static_ball<double>(constants, spring_pair(constants), groove_centre);
}

}  // namespace raceway::bearing

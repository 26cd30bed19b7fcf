#pragma once

#include <algorithm>
#include <cmath>

#include "bearing/bearing.h"
#include "bearing/kinematics.h"

namespace raceway::bearing {

/// Plane vector (axial, radial) in the plane of one ball.
struct Plane {
  double axial = 0.0;
  double radial = 0.0;
  bool operator==(const Plane&) const = default;
};

/// What all balls of a bearing share at one speed.
struct BallConstants {
  double inner_radius;      ///< (f_i - 0.5) D: groove centre to ball centre without load [m]
  double outer_radius;      ///< (f_o - 0.5) D [m]
  double inner_stiffness;   ///< K_i [N/m^1.5]
  double outer_stiffness;   ///< K_o [N/m^1.5]
  double diameter_ratio;    ///< g = D/d_m [1]
  double full_centrifugal;  ///< C = m d_m ω²/2: centrifugal force of a ball that orbits at ω [N]
  double gyroscopic;        ///< 1, or 0 for a ball without gyroscopic moment [1]
  RaceControl race_control;
};

[[nodiscard]] BallConstants ball_constants(const Bearing& bearing, double speed,
                                           RaceControl race_control, bool gyroscopic_moment);

/// Contact loads and forces of one ball.
struct BallForces {
  double inner_load, outer_load;          ///< Qi, Qo [N]
  double inner_friction, outer_friction;  ///< Ti, To [N]
  double centrifugal;                     ///< Fc [N]
  double inner_approach, outer_approach;  ///< δi, δo [m]
};

/// Imbalance of one ball and what it does to the inner ring, with all first derivatives.
///
/// In the (axial, radial) plane, outer groove centre at the origin, X the ball centre, A the inner
/// groove centre, V = A - X; n and t are normal and tangent of a contact:
///
///   n = (sin α, cos α),  t = (cos α, -sin α),   sin αo = X1/|X|,  sin αi = V1/|V|
///   Q = K δ^1.5,  δo = |X| - (f_o - 0.5) D,  δi = |V| - (f_i - 0.5) D
///   imbalance   r = Qi ni + Ti ti + (0, Fc) - Qo no - To to = 0
///   force on the ring   f = Qi ni + Ti ti
///   moment arm force    f_m = f_axial - (f_i D / R_i) Ti     (Ti acts at the groove, not its
///   centre)
///
/// Fc = C m² with m = ω_m/ω, C = m_ball d_m ω²/2. The gyroscopic couple M_g = J ω_m ω_R sin β is
/// carried by friction T = λ M_g/D: at the outer race alone (λo = 2) under outer control,
///
///   To = 0.4 Fc sin αo,  Ti = 0,
///
/// at both alike (λi = λo = 1) under inner control, Ti = To = 0.2 C m (1 - m) sin αi. (M_g with the
/// ω_R and β of kinematics.h; the products of ω_R and sin β are rational in sines and cosines.)
/// Sign: M_g > 0 lowers αo. [CaseStudy] eqs. (14) and (18) together give the wrong sign.
/// A ball that has lost the inner race (δi <= 0) is under outer control and pushes on nothing.
/// The race control jumps there when it is `inner`, so a load can fall into a gap without balance.
struct BallBalance : BallForces {
  Plane imbalance;      ///< r [N]
  Plane force;          ///< f [N]
  double moment_force;  ///< f_m [N]
  // Row-major 2x2 blocks: derivatives with respect to (axial, radial).
  double r_a[4];  ///< ∂r/∂A at fixed X [N/m]
  double r_x[4];  ///< ∂r/∂X at fixed A [N/m]
  double f_a[6];  ///< ∂(f, f_m)/∂A at fixed X, 3x2 [N/m]
  double f_x[6];  ///< ∂(f, f_m)/∂X at fixed A, 3x2 [N/m]
};

/// Who decides whether a ball touches the inner race. `automatic` is the physics; the other two
/// hold one side of the switch while a solver looks for a solution there. A `kept` contact may
/// pull: Q = K δ |δ|^0.5, smooth through zero; such a solution counts only if no contact pulls.
enum class InnerContact : signed char { automatic, kept, lost };

/// The balance of a ball, written once for both race controls; `control` is that of the constants.
template <RaceControl control>
[[nodiscard, gnu::always_inline]] inline BallBalance ball_balance_under(const BallConstants& c,
                                                                        Plane groove_centre,
                                                                        Plane ball_centre,
                                                                        double moment_arm_ratio,
                                                                        InnerContact contact) {
  const double x1 = ball_centre.axial, x2 = ball_centre.radial;
  const double v1 = groove_centre.axial - x1, v2 = groove_centre.radial - x2;
  const double outer_length = std::sqrt(x1 * x1 + x2 * x2);
  const double inner_length = std::sqrt(v1 * v1 + v2 * v2);
  const double inv_lo = 1.0 / outer_length, inv_li = 1.0 / inner_length;
  const double so = x1 * inv_lo, co = x2 * inv_lo;
  const double si = v1 * inv_li, ci = v2 * inv_li;

  const double delta_o = outer_length - c.outer_radius;
  const double delta_i = inner_length - c.inner_radius;
  const double root_o = std::sqrt(std::max(delta_o, 0.0));
  const bool touches =
      contact == InnerContact::kept || (contact == InnerContact::automatic && delta_i > 0.0);
  const double root_i = touches ? std::sqrt(std::abs(delta_i)) : 0.0;
  const double ko = 1.5 * c.outer_stiffness * root_o;  // dQ/dδ
  const double ki = 1.5 * c.inner_stiffness * root_i;
  const double qo = c.outer_stiffness * root_o * root_o * root_o;
  const double qi = c.inner_stiffness * root_i * delta_i;

  // Orbital speed ratio m and its derivatives by the two contact angles.
  const double cd = ci * co + si * so;
  const double sd = si * co - ci * so;
  const double inv = 1.0 / (1.0 + cd);
  const double g = c.diameter_ratio;
  const bool inner_control = control == RaceControl::inner && touches;
  double m, m_i, m_o;
  if (inner_control) {
    m = (cd - g * co) * inv;
    m_i = -sd * (1.0 + g * co) * inv * inv;
    m_o = (sd * (1.0 + g * co) * inv + g * so) * inv;
  } else {
    m = (1.0 - g * ci) * inv;
    m_i = (g * si + m * sd) * inv;
    m_o = -m * sd * inv;
  }
  const double full = c.full_centrifugal;
  const double fc = full * m * m;
  const double fc_i = 2.0 * full * m * m_i, fc_o = 2.0 * full * m * m_o;

  double ti = 0.0, ti_i = 0.0, ti_o = 0.0, to, to_i, to_o;
  if (inner_control) {
    const double scale = 0.2 * full * c.gyroscopic;
    const double slope = scale * (1.0 - 2.0 * m) * si;
    ti = scale * m * (1.0 - m) * si;
    ti_i = slope * m_i + scale * m * (1.0 - m) * ci;
    ti_o = slope * m_o;
    to = ti;
    to_i = ti_i;
    to_o = ti_o;
  } else {
    const double scale = 0.4 * c.gyroscopic;
    to = scale * fc * so;
    to_i = scale * fc_i * so;
    to_o = scale * (fc_o * so + fc * co);
  }

  BallBalance b;
  b.force = {qi * si, qi * ci};
  if constexpr (control == RaceControl::inner)
    b.force = {b.force.axial + ti * ci, b.force.radial - ti * si};
  b.moment_force = b.force.axial;
  if constexpr (control == RaceControl::inner) b.moment_force -= moment_arm_ratio * ti;
  b.imbalance = {b.force.axial - qo * so - to * co, b.force.radial + fc - qo * co + to * so};
  b.inner_load = qi;
  b.outer_load = qo;
  b.inner_friction = ti;
  b.outer_friction = to;
  b.centrifugal = fc;
  b.outer_approach = delta_o;
  b.inner_approach = delta_i;

  // With dV = dA - dX: dδi = n_i·dV, dαi = t_i·dV/|V|; with dX alike at the outer contact.
  // f_ai, r_ai: what one radian of αi does to f and to r; f_ao, r_ao: the same of αo.
  double f_ai_1 = qi * ci, f_ai_2 = -qi * si;
  double r_ao_1 = to * so - (qo + to_o) * co, r_ao_2 = fc_o + (qo + to_o) * so + to * co;
  if constexpr (control == RaceControl::inner) {
    f_ai_1 += ti_i * ci - ti * si;
    f_ai_2 -= ti_i * si + ti * ci;
    r_ao_1 += ti_o * ci;
    r_ao_2 -= ti_o * si;
  }
  const double r_ai_1 = f_ai_1 - to_i * co, r_ai_2 = f_ai_2 + fc_i + to_i * so;
  const double tiv1 = ci * inv_li, tiv2 = -si * inv_li;  // ∂αi/∂V
  const double tox1 = co * inv_lo, tox2 = -so * inv_lo;  // ∂αo/∂X

  const double n11 = ki * si * si, n12 = ki * si * ci, n22 = ki * ci * ci;
  b.f_a[0] = b.f_a[4] = n11 + f_ai_1 * tiv1;
  b.f_a[1] = b.f_a[5] = n12 + f_ai_1 * tiv2;
  b.f_a[2] = n12 + f_ai_2 * tiv1;
  b.f_a[3] = n22 + f_ai_2 * tiv2;
  if constexpr (control == RaceControl::inner) {
    b.f_a[4] -= moment_arm_ratio * ti_i * tiv1;
    b.f_a[5] -= moment_arm_ratio * ti_i * tiv2;
  }
  // The ring feels the ball's place only through V, and through Ti that follows αo.
  for (int j = 0; j < 6; ++j) b.f_x[j] = -b.f_a[j];
  if constexpr (control == RaceControl::inner) {
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
  b.r_x[0] = -b.r_a[0] - ko * so * so + r_ao_1 * tox1;
  b.r_x[1] = -b.r_a[1] - ko * so * co + r_ao_1 * tox2;
  b.r_x[2] = -b.r_a[2] - ko * so * co + r_ao_2 * tox1;
  b.r_x[3] = -b.r_a[3] - ko * co * co + r_ao_2 * tox2;
  return b;
}

/// The same for the race control of the constants; `moment_arm_ratio` = f_i D / R_i [1].
[[nodiscard]] inline BallBalance ball_balance(const BallConstants& c, Plane groove_centre,
                                              Plane ball_centre, double moment_arm_ratio,
                                              InnerContact contact = InnerContact::automatic) {
  return c.race_control == RaceControl::outer
             ? ball_balance_under<RaceControl::outer>(c, groove_centre, ball_centre,
                                                      moment_arm_ratio, contact)
             : ball_balance_under<RaceControl::inner>(c, groove_centre, ball_centre,
                                                      moment_arm_ratio, contact);
}

/// A ball of a bearing at rest, between groove centres at distance A: two springs in series on one
/// line, (1/K)^(2/3) = (1/K_i)^(2/3) + (1/K_o)^(2/3). No ball unknowns are left.
struct StaticBall {
  Plane ball_centre;  ///< X [m]
  Plane force;        ///< f [N]
  double f_a[4];      ///< df/dA, row-major [N/m]
  double load;        ///< Q [N], the same at both contacts
};

[[nodiscard]] StaticBall static_ball(const BallConstants& constants, Plane groove_centre);

}  // namespace raceway::bearing

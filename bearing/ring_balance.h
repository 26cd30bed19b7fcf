#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "bearing/ball_equilibrium.h"
#include "bearing/ball_report.h"
#include "bearing/bearing_equilibrium.h"
#include "bearing/lanes.h"

// Sums of the ball forces on one inner ring, derivatives of these sums, and results of each ball.
// Tilts are multiplied and moments are divided by the radius R_i of the circle of the inner groove
// centres. With this scaling, all unknowns are lengths and all loads are forces, so the imbalances
// of all components can be divided by one load (load_scale).
namespace raceway::bearing {

/// Model of a ball. The contacts of a ball at rest are two springs in series. The rotation of an
/// orbiting ball is given, or race control determines it.
enum class BallModel { at_rest, outer_control, inner_control, given_rotation };

/// Ring coordinates that are unknowns. The indices 0 to 4 mean x, y, z, θy, θz.
template <int... indices>
struct Coordinates {
  static constexpr int count = sizeof...(indices);
  static constexpr int at[] = {indices...};
};
using AllCoordinates = Coordinates<0, 1, 2, 3, 4>;

/// Calls f with a Coordinates object that contains the unknown ring coordinates.
template <typename F>
decltype(auto) with_coordinates(Symmetry symmetry, bool tilts, F&& f) {
  switch (symmetry) {
    case Symmetry::thrust:
      return f(Coordinates<0>());
    case Symmetry::mirror:
      return tilts ? f(Coordinates<0, 1, 4>()) : f(Coordinates<0, 1>());
    case Symmetry::none:
      break;
  }
  return tilts ? f(AllCoordinates()) : f(Coordinates<0, 1, 2>());
}

template <BallModel model>
struct ModelConstant {
  static constexpr BallModel value = model;
};

/// Calls f with ModelConstant<model> for balls at rest or under race control. The functions that
/// solve several operating points in parallel (simd_kernel.h) support only these ball models.
template <typename F>
decltype(auto) with_race_control(BallModel model, F&& f) {
  switch (model) {
    case BallModel::at_rest:
      return f(ModelConstant<BallModel::at_rest>());
    case BallModel::outer_control:
      return f(ModelConstant<BallModel::outer_control>());
    case BallModel::inner_control:
    case BallModel::given_rotation:
      break;
  }
  return f(ModelConstant<BallModel::inner_control>());
}

/// Calls f with ModelConstant<model> for any ball model.
template <typename F>
decltype(auto) with_model(BallModel model, F&& f) {
  if (model == BallModel::given_rotation) return f(ModelConstant<BallModel::given_rotation>());
  return with_race_control(model, f);
}

/// Azimuths of the balls and the symmetry of the load. The symmetry determines the distinct balls
/// (distinct_balls()). Only the positions of the distinct balls are unknowns.
struct BallCircle {
  const double* azimuth;  ///< [rad]
  const double* cosine;   ///< cosine of the azimuth
  const double* sine;
  int count;  ///< Z, number of balls
  Symmetry symmetry;
  /// Given rotations (EquilibriumOptions::rotations): one for each ball, or one for all balls. The
  /// list is empty under race control.
  std::span<const GivenRotation> rotations = {};

  [[nodiscard, gnu::always_inline]] int used() const { return distinct_balls(symmetry, count); }
  /// Number of balls with the same load as ball k, including ball k [1].
  [[nodiscard, gnu::always_inline]] double weight(int k) const {
    return weight_of_ball(symmetry, count, k);
  }
  /// Given rotation of ball k, or null if race control determines the rotation.
  [[nodiscard, gnu::always_inline]] const GivenRotation* rotation(int k) const {
    if (rotations.empty()) return nullptr;
    return &rotations[rotations.size() == 1 ? 0 : static_cast<std::size_t>(k)];
  }
};

/// Bearing, speed and load as inputs of the equilibrium. T is double for one operating point, or
/// Eight for eight operating points that are solved together. Every member consists of numbers of
/// the type T, because copy_lanes() copies the struct number by number.
template <typename T>
struct RingPoint {
  BallConstantsOf<T> ball;
  SpringPairOf<T> springs;  ///< contact springs of a ball at rest
  PlaneOf<T> free;     ///< position of the inner groove centre if the ring is not displaced [m]
  T lever;             ///< R_i, radius of the circle of inner groove centres [m]
  T moment_arm_ratio;  ///< inner groove radius divided by R_i [1]
  T load[5];           ///< forces, and moments divided by the lever [N]
  T load_scale;        ///< largest magnitude in `load` [N]
  T ball_scale;        ///< load_scale divided by the number of balls [N]
  T rounding;          ///< largest residual that rounding errors of lengths cause [1]
};

/// Returns the RingPoint of a bearing at rest without load.
[[nodiscard]] RingPoint<double> unloaded_point(const Bearing& bearing,
                                               const EquilibriumOptions& options);
/// Sets the speed and the loads of `ring` to the values of `point`. `ring` must come from
/// unloaded_point() of this bearing.
void set_operating_point(RingPoint<double>& ring, const Bearing& bearing,
                         const OperatingPoint& point, const EquilibriumOptions& options);
[[nodiscard]] BallCircle ball_circle(const Bearing& bearing, const OperatingPoint& point,
                                     const EquilibriumOptions& options = {});
[[nodiscard]] BallModel ball_model(const RingPoint<double>& ring,
                                   const EquilibriumOptions& options);

/// Newton step of a ball, and the elastic approach δo of ball and outer race before the step. The
/// solver shortens a step after which the approach would be less than a tenth of `outer_approach`.
template <typename T>
struct BallStep {
  T own[2];     ///< step of the ball if the ring does not move [m]
  T follow[4];  ///< additional step per unit step of the inner groove centre, row-major 2x2 [1]
  T outer_approach;  ///< δo [m]
};

/// Forces of one ball on the ring and their derivatives, in the plane through the bearing axis and
/// the ball. The position of the ball is eliminated from the equations.
template <typename T>
struct BallShare {
  T force[3];  ///< axial and radial force, and f_m for the moment: see BallBalanceOf [N]
  T gain[3];   ///< change of these forces by the ball's own Newton step [N]
  /// Derivatives of `force` with respect to the inner groove centre (axial, radial), row-major 3x2
  /// [N/m].
  T tangent[6];
  T imbalance;             ///< square of |r|/(RingPoint::ball_scale + Qo); r: see BallBalanceOf [1]
  BallForcesOf<T> forces;  ///< contact loads and forces of the ball
};

template <BallModel model, typename T>
[[gnu::always_inline]] inline BallShare<T> ball_share(const RingPoint<T>& p,
                                                      const PlaneOf<T>& centre, const PlaneOf<T>& x,
                                                      InnerContact contact, BallStep<T>& step,
                                                      const GivenRotation* given = nullptr) {
  BallShare<T> share;
  if constexpr (model == BallModel::at_rest) {
    const StaticBallOf<T> b = static_ball<T>(p.ball, p.springs, centre);
    const T zero(0.0);
    share.force[0] = share.force[2] = b.force.axial;
    share.force[1] = b.force.radial;
    share.gain[0] = share.gain[1] = share.gain[2] = zero;
    share.tangent[0] = share.tangent[4] = b.f_a[0];
    share.tangent[1] = share.tangent[5] = b.f_a[1];
    share.tangent[2] = b.f_a[2];
    share.tangent[3] = b.f_a[3];
    share.imbalance = zero;
    share.forces = {b.load, b.load, zero, zero, zero, zero, zero};
  } else {
    constexpr auto rotation = model == BallModel::outer_control   ? Rotation::outer_control
                              : model == BallModel::inner_control ? Rotation::inner_control
                                                                  : Rotation::given;
    const BallBalanceOf<T> b =
        ball_balance_under<rotation>(p.ball, centre, x, p.moment_arm_ratio, contact, given);
    share.forces = b;
    step.outer_approach = b.outer_approach;
    // follow = -r_x⁻¹ r_a, own = -r_x⁻¹ r. One division is enough for both and for the scaled
    // imbalance.
    const T scale = p.ball_scale + b.outer_load;
    const T squared = scale * scale;
    // The determinant is 0 if the approach at the outer race is smaller than its rounding error.
    // A ball with the determinant 0 is not moved.
    const T product = b.r_x[0] * b.r_x[3] - b.r_x[1] * b.r_x[2];
    const Mask<T> lies = product == T(0.0);
    const T determinant = select(lies, T(1.0), product);
    const T reciprocal = 1.0 / (determinant * squared);
    const T inv = select(lies, T(0.0), -squared * reciprocal);
    step.own[0] = inv * (b.r_x[3] * b.imbalance.axial - b.r_x[1] * b.imbalance.radial);
    step.own[1] = inv * (b.r_x[0] * b.imbalance.radial - b.r_x[2] * b.imbalance.axial);
    step.follow[0] = inv * (b.r_x[3] * b.r_a[0] - b.r_x[1] * b.r_a[2]);
    step.follow[1] = inv * (b.r_x[3] * b.r_a[1] - b.r_x[1] * b.r_a[3]);
    step.follow[2] = inv * (b.r_x[0] * b.r_a[2] - b.r_x[2] * b.r_a[0]);
    step.follow[3] = inv * (b.r_x[0] * b.r_a[3] - b.r_x[2] * b.r_a[1]);
    // Under outer control, Ti = 0, so f_m equals f_axial and has the same derivatives.
    constexpr int rows = rotation == Rotation::outer_control ? 2 : 3;
    for (int j = 0; j < rows; ++j) {
      const T fx0 = b.f_x[2 * j], fx1 = b.f_x[2 * j + 1];
      share.gain[j] = fx0 * step.own[0] + fx1 * step.own[1];
      share.tangent[2 * j] = b.f_a[2 * j] + fx0 * step.follow[0] + fx1 * step.follow[2];
      share.tangent[2 * j + 1] = b.f_a[2 * j + 1] + fx0 * step.follow[1] + fx1 * step.follow[3];
    }
    if constexpr (rows == 2) {
      share.gain[2] = share.gain[0];
      share.tangent[4] = share.tangent[0];
      share.tangent[5] = share.tangent[1];
    }
    share.force[0] = b.force.axial;
    share.force[1] = b.force.radial;
    share.force[2] = b.moment_force;
    share.imbalance =
        (b.imbalance.axial * b.imbalance.axial + b.imbalance.radial * b.imbalance.radial) *
        (determinant * reciprocal);
  }
  return share;
}

/// Returns the displacement of the inner groove centre at ball k for a displacement `ring` of the
/// ring. The result is in the plane through the bearing axis and the ball.
template <class C, typename T>
[[gnu::always_inline]] inline PlaneOf<T> groove_step(const BallCircle& circle, const T* ring,
                                                     int k) {
  const double c = circle.cosine[k], s = circle.sine[k];
  PlaneOf<T> moved;
  for (const int i : C::at) {
    if (i == 0) moved.axial = moved.axial + ring[0];
    if (i == 1) moved.radial = moved.radial + ring[1] * c;
    if (i == 2) moved.radial = moved.radial + ring[2] * s;
    if (i == 3) moved.axial = moved.axial + ring[3] * s;
    if (i == 4) moved.axial = moved.axial - ring[4] * c;
  }
  return moved;
}

template <class C, typename T>
[[gnu::always_inline]] inline PlaneOf<T> groove_centre(const RingPoint<T>& p,
                                                       const BallCircle& circle, const T* ring,
                                                       int k) {
  const PlaneOf<T> moved = groove_step<C>(circle, ring, k);
  return {p.free.axial + moved.axial, p.free.radial + moved.radial};
}

/// Forces of the balls on the ring in the coordinates C, and their derivatives.
template <class C, typename T>
struct RingSums {
  T carried[C::count];  ///< ball forces on the ring; moments divided by the lever [N]
  T ahead[C::count];    ///< ball forces on the ring after the step BallStep::own of each ball [N]
  T stiffness[C::count][C::count];  ///< stiffness after elimination of the ball positions [N/m]

  RingSums() {
    for (int i = 0; i < C::count; ++i) {
      carried[i] = ahead[i] = T(0.0);
      for (int j = 0; j < C::count; ++j) stiffness[i][j] = T(0.0);
    }
  }

  /// Adds the forces of ball k. The forces are transformed from the plane of the ball to the axes
  /// of the bearing.
  [[gnu::always_inline]] void add(const BallCircle& circle, int k, const BallShare<T>& share) {
    const double c = circle.cosine[k], s = circle.sine[k], w = circle.weight(k);
    // `unit`: displacement of the groove centre per unit of each coordinate. `column` is 0 for an
    // axial and 1 for a radial displacement. The force of the ball on the ring is transformed with
    // the same factors `unit`. `row` is the component of BallShare::force: f_m acts on the tilts.
    const double unit[] = {1.0, c, s, s, -c};
    constexpr int row[] = {0, 1, 1, 2, 2}, column[] = {0, 1, 1, 0, 0};
    for (int i = 0; i < C::count; ++i) {
      const int a = C::at[i];
      const double factor = w * unit[a];
      const T force = share.force[row[a]];
      carried[i] = carried[i] + factor * force;
      ahead[i] = ahead[i] + factor * (force + share.gain[row[a]]);
      for (int j = 0; j < C::count; ++j) {
        const int b = C::at[j];
        stiffness[i][j] =
            stiffness[i][j] + (factor * unit[b]) * share.tangent[2 * row[a] + column[b]];
      }
    }
  }
};

/// Converts the weighted sums over the distinct balls to sums over all balls.
template <typename T>
void complete(const BallCircle& circle, RingSums<AllCoordinates, T>& sums) {
  T(&k)[5][5] = sums.stiffness;
  const T zero(0.0);
  if (circle.symmetry == Symmetry::thrust) {
    // The sums contain one ball at ψ = 0 with weight Z. With t = BallShare::tangent: k00 = Z t00,
    // k11 = Z t11, k14 = -Z t10, k41 = -Z t21, k44 = Z t20. The mean of cos² ψ over all balls is
    // 1/2.
    const T k00 = k[0][0], k11 = 0.5 * k[1][1], k14 = 0.5 * k[1][4], k41 = 0.5 * k[4][1],
            k44 = 0.5 * k[4][4];
    for (auto& row : k)
      for (T& entry : row) entry = zero;
    k[0][0] = k00;
    k[1][1] = k[2][2] = k11;
    k[3][3] = k[4][4] = k44;
    k[1][4] = k14;
    k[2][3] = -k14;
    k[4][1] = k41;
    k[3][2] = -k41;
    for (int i = 1; i < 5; ++i) sums.carried[i] = zero;
  } else if (circle.symmetry == Symmetry::mirror) {
    // Sets terms to zero that cancel each other between the two halves of the bearing.
    for (const int odd : {2, 3}) {
      sums.carried[odd] = zero;
      for (const int even : {0, 1, 4}) k[odd][even] = k[even][odd] = zero;
    }
  }
}

/// Largest allowed difference between the applied load and the sum of the reported ball forces,
/// relative to the load [1]. The solvers for a bearing and for an arrangement reject a solution
/// with a larger difference. Rounding errors are about a thousandth of this limit.
inline constexpr double largest_load_error = 1e-8;

/// Results for a ring in equilibrium.
template <typename T>
struct RingReport {
  /// Tangent stiffness; tilts are multiplied and moments divided by RingPoint::lever [N/m].
  T stiffness[5][5];
  T residual;  ///< largest scaled imbalance of ring and balls, see NewtonLimits [1]
  /// Difference between the applied load and the sum of the reported ball forces, relative to the
  /// applied load [1]. NaN if a result is not finite.
  T recovered_load_error;
};

/// Computes angles and forces of the distinct balls for a ring in equilibrium, and stores them in
/// `reports`. As an independent check of the results, the function compares the sum of the stored
/// ball forces with the applied load.
template <BallModel model, typename T>
void report_ring(const RingPoint<T>& p, const BallCircle& circle, bool tilts, const T* ring,
                 const PlaneOf<T>* balls, BallReport<T>* reports, RingReport<T>& report) {
  using std::abs, std::max, std::sqrt;
  const T zero(0.0);
  const T diameter = 2.0 * p.moment_arm_ratio * p.lever - 2.0 * p.ball.inner_radius;
  RingSums<AllCoordinates, T> sums;
  T worst_ball = zero, sum[5] = {zero, zero, zero, zero, zero};
  T nothing = zero;  // 0, or NaN if a result is not finite
  const auto look = [&nothing](const T& number) { nothing = nothing + (number - number); };
  for (int k = 0; k < circle.used(); ++k) {
    const PlaneOf<T> a = groove_centre<AllCoordinates>(p, circle, ring, k);
    const PlaneOf<T> x = balls[k];
    BallStep<T> step;
    const BallShare<T> share =
        ball_share<model>(p, a, x, InnerContact::automatic, step, circle.rotation(k));
    sums.add(circle, k, share);
    worst_ball = max(worst_ball, share.imbalance);
    const BallForcesOf<T>& f = share.forces;
    const Mask<T> touches = f.inner_load > zero;
    const BallReport<T> b = reports[k] =
        ball_report<model == BallModel::at_rest>(f, a, x, diameter);

    const T angle = select(touches, b.inner_contact_angle, zero);
    // A ball at rest without contact has no outer contact angle.
    look(select(b.outer_load > zero, b.outer_contact_angle, zero));
    for (const T& number :
         {angle, b.inner_load, b.outer_load, b.outer_friction, b.centrifugal_force})
      look(number);
    const auto [s, c] = sincos(angle);
    const T axial = select(touches, b.inner_load * s + b.inner_friction * c, zero);
    const T radial = select(touches, b.inner_load * c - b.inner_friction * s, zero);
    const T moment = select(touches, axial - p.moment_arm_ratio * b.inner_friction, zero);
    const double cp = circle.cosine[k], sp = circle.sine[k], w = circle.weight(k);
    sum[0] = sum[0] + w * axial;
    sum[1] = sum[1] + w * cp * radial;
    sum[2] = sum[2] + w * sp * radial;
    sum[3] = sum[3] + w * sp * moment;
    sum[4] = sum[4] - w * cp * moment;
  }
  complete(circle, sums);
  T missing = zero, error = zero;
  for (int i = 0; i < (tilts ? 5 : 3); ++i) {
    missing = max(missing, abs(p.load[i] - sums.carried[i]));
    // Load components that are zero by symmetry are not checked, because `sum` contains only the
    // distinct balls.
    const bool even = circle.symmetry == Symmetry::none || i == 0 ||
                      (circle.symmetry == Symmetry::mirror && (i == 1 || i == 4));
    if (even) error = max(error, abs(p.load[i] - sum[i]));
  }
  for (int i = 0; i < 5; ++i) {
    look(ring[i]);
    for (int j = 0; j < 5; ++j) look(report.stiffness[i][j] = sums.stiffness[i][j]);
  }
  report.residual = max(missing / p.load_scale, sqrt(worst_ball));
  report.recovered_load_error = error / p.load_scale + nothing;
}

/// Sets displacement, stiffness, balls, rotations, residual and load error of `result`. T is double
/// for one operating point, or Eight for eight operating points. With Eight, the function uses the
/// values of operating point i in `lever`, `ring`, `report` and `balls`.
template <typename T>
void fill_equilibrium(const T& lever, const BallCircle& circle, const T* ring,
                      const RingReport<T>& report, const BallReport<T>* balls, std::size_t i,
                      BearingEquilibrium& result);

}  // namespace raceway::bearing

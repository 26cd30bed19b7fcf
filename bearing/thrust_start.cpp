#include "bearing/thrust_start.h"

#include <cmath>

namespace raceway::bearing {
namespace {

double norm_of(double a, double b) { return std::sqrt(a * a + b * b); }

double length(double load, double stiffness, double radius) {
  const double root = std::cbrt(load / stiffness);
  return radius + root * root;
}

}  // namespace

bool thrust_start(RaceControl control, const BallConstantsOf<double>& constants,
                  Plane free_groove_centre, double thrust_per_ball, ThrustStart<double>& start) {
  return control == RaceControl::outer ? thrust_start<RaceControl::outer, double>(
                                             constants, free_groove_centre, thrust_per_ball, start)
                                       : thrust_start<RaceControl::inner, double>(
                                             constants, free_groove_centre, thrust_per_ball, start);
}

bool ball_under_force(const BallConstantsOf<double>& c, Plane force, Plane& groove_centre,
                      Plane& ball_centre) {
  double si = 0.0, ci = 1.0, so = 0.0, co = 1.0, qi = 0.0, qo = 0.0;
  for (int round = 0; round < 12; ++round) {
    const double m =
        cage_speed_ratio(RaceControl::inner, ci, co, ci * co + si * so, c.diameter_ratio);
    const double tau = 0.2 * c.full_centrifugal * c.gyroscopic * m * (1.0 - m);
    const double fc = c.full_centrifugal * m * m;
    const double turned = force.radial + tau;
    const double norm = norm_of(force.axial, turned);
    si = force.axial / norm;
    ci = turned / norm;
    const double radial = force.radial + fc, friction = tau * si;
    const double outer = norm_of(force.axial, radial);
    if (!(friction < outer)) return false;
    const double sin_turn = friction / outer, cos_turn = std::sqrt(1.0 - sin_turn * sin_turn);
    so = (force.axial * cos_turn - radial * sin_turn) / outer;
    co = (radial * cos_turn + force.axial * sin_turn) / outer;
    qi = force.axial * si + force.radial * ci;
    qo = force.axial * so + radial * co;
  }
  if (!(qi > 0.0 && qo > 0.0)) return false;
  const double inner = length(qi, c.inner_stiffness, c.inner_radius);
  const double outer = length(qo, c.outer_stiffness, c.outer_radius);
  ball_centre = {outer * so, outer * co};
  groove_centre = {ball_centre.axial + inner * si, ball_centre.radial + inner * ci};
  return true;
}

}  // namespace raceway::bearing

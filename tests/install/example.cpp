#include <cstdio>

#include "bearing/bearing_equilibrium.h"
#include "friction/lubricant.h"
#include "friction/palmgren.h"

int main() {
  using namespace raceway;
  const bearing::Bearing bearing({.ball_count = 21,
                                  .ball_diameter = 11.906 * mm,
                                  .pitch_diameter = 90 * mm,
                                  .contact_angle = 15 * degree,
                                  .inner_conformity = 0.52,
                                  .outer_conformity = 0.52,
                                  .static_load_rating = 46000},
                                 bearing::steel(), bearing::steel());
  const bearing::OperatingPoint point{.speed = 10000 * rpm, .axial_load = 600};
  const auto solved = solve_bearing_equilibrium(bearing, point);
  if (!solved.report.converged()) return 2;

  const friction::Lubricant oil(22 * mm2_per_s, 4.8 * mm2_per_s);
  const friction::BearingState<> state{
      .bearing = &bearing,
      .equilibrium = &solved,
      .speed = point.speed,
      .axial_load = point.axial_load,
      .kinematic_viscosity = oil.kinematic_viscosity(point.temperature)};
  const double torque = friction::PalmgrenLoad::moment(state, 0.001, 0.33) +
                        friction::PalmgrenViscous::moment(state, 1.5);
  std::printf("outer contact angle %.2f deg, friction torque %.1f N mm\n",
              solved.balls[0].outer_contact_angle / degree, torque / N_mm);
}

#include "friction/spin.h"

#include "effects/spin_friction.h"
#include "tests/friction/sample.h"
#include "tests/reference_table.h"

namespace raceway {
namespace {

using bearing::RaceControl;

TEST(Spin, MeetsTheReferenceCases) {
  for (const auto& row : tests::reference_table("spin_friction.csv")) {
    SCOPED_TRACE(row.place());
    const bearing::Material material{.name = "reference",
                                     .elastic_modulus = row["elastic_modulus_Pa"],
                                     .poisson_ratio = row["poisson_ratio"],
                                     .density = row["density_kg_m3"],
                                     .thermal_expansion = 0.0};
    const bearing::Bearing bearing({.ball_count = static_cast<int>(row["ball_count"]),
                                    .ball_diameter = row["ball_diameter_m"],
                                    .pitch_diameter = row["pitch_diameter_m"],
                                    .contact_angle = row["contact_angle_deg"] * degree,
                                    .inner_conformity = row["inner_conformity"],
                                    .outer_conformity = row["outer_conformity"]},
                                   material, material);
    const bearing::OperatingPoint point{.speed = row["speed_rpm"] * rpm,
                                        .axial_load = row["axial_load_N"]};
    const auto e = solve_bearing_equilibrium(bearing, point);
    ASSERT_TRUE(e.report.converged());
    const double mu = row["friction_coefficient"], tolerance = row["relative_tolerance"];
    const auto& inner = bearing.contact(bearing::Race::inner);
    tests::expect_relative(mu * friction::unit_spin_moment(inner, e.balls[0].inner_load) / N_mm,
                           row["spin_moment_Nmm"], tolerance);
    tests::expect_relative(
        e.speeds(0, bearing, point.speed, RaceControl::outer).inner_spin_speed / point.speed,
        row["spin_speed_ratio"], tolerance);
    const auto s = tests::state_of(bearing, e, point, RaceControl::outer);
    const double moment =
        mu * effects::SpinFriction::unit_moment(
                 {.state = s, .base = {.load = 0.0, .viscous = 0.0}, .record = {}});
    tests::expect_relative(moment / N_mm, row["moment_Nmm"], tolerance);
    tests::expect_relative(moment * point.speed, row["power_W"], tolerance);
  }
}

TEST(Spin, MomentOfACircularContactIsThatOfASlidingDisc) {
  // Pressure of Hertz p0 sqrt(1 - r²/a²) on a disc: M = (3 π/16) μ Q a.
  const auto contact =
      bearing::hertz_contact({.sum = 200.0, .difference = 0.0}, bearing::steel(), bearing::steel());
  const double load = 150.0;
  tests::expect_relative(friction::unit_spin_moment(contact, load),
                         3.0 * pi / 16.0 * load * contact.semi_major_axis(load), 1e-12);
  EXPECT_EQ(friction::unit_spin_moment(contact, 0.0), 0.0);
  EXPECT_EQ(friction::unit_spin_moment(contact, -1.0), 0.0);
}

TEST(Spin, HappensAtTheRaceThatIsNotInControl) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{.speed = 6000 * rpm, .axial_load = 1500};
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
    const auto e = solve_bearing_equilibrium(bearing, point, {.race_control = control});
    ASSERT_TRUE(e.report.converged());
    const auto spin = friction::unit_spin_friction(bearing, e, control);
    const bool outer = control == RaceControl::outer;
    EXPECT_GT(outer ? spin.inner : spin.outer, 0.0);
    EXPECT_NEAR(outer ? spin.outer : spin.inner, 0.0, 1e-12 * (spin.inner + spin.outer));
  }
}

TEST(Spin, SumsOverUnequalBalls) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{
      .speed = 12000 * rpm, .axial_load = 600, .radial_load = 250, .radial_load_z = 90};
  const auto e = solve_bearing_equilibrium(bearing, point);
  ASSERT_TRUE(e.report.converged());
  double power = 0.0;
  for (std::size_t k = 0; k < e.balls.size(); ++k) {
    if (!(e.balls[k].inner_load > 0.0)) continue;
    const auto speeds = e.speeds(k, bearing, point.speed, RaceControl::outer);
    power +=
        friction::unit_spin_moment(bearing.contact(bearing::Race::inner), e.balls[k].inner_load) *
        speeds.inner_spin_speed;
  }
  const auto spin = friction::unit_spin_friction(bearing, e, RaceControl::outer);
  tests::expect_relative((spin.inner + spin.outer) * point.speed, power, 1e-12);
}

TEST(Spin, HasALimitAtStandstill) {
  const auto bearing = tests::spindle_bearing();
  const auto moment = [&](double speed) {
    const auto e = solve_bearing_equilibrium(bearing, {.speed = speed, .axial_load = 600});
    return friction::unit_spin_friction(bearing, e, RaceControl::outer).inner;
  };
  EXPECT_GT(moment(0.0), 0.0);
  tests::expect_relative(moment(1 * rpm), moment(0.0), 1e-5);
}

TEST(Spin, BallsOffTheInnerRaceTakeNoPart) {
  const auto bearing = tests::spindle_bearing();
  const bearing::OperatingPoint point{.speed = 15000 * rpm, .axial_load = 150, .radial_load = 400};
  const auto e = solve_bearing_equilibrium(bearing, point);
  ASSERT_TRUE(e.report.converged());
  ASSERT_GT(e.lost_balls(), 0);
  const auto spin = friction::unit_spin_friction(bearing, e, RaceControl::outer);
  EXPECT_TRUE(std::isfinite(spin.inner));
  EXPECT_GT(spin.inner, 0.0);
  EXPECT_NEAR(spin.outer, 0.0, 1e-12 * spin.inner);
}

TEST(Spin, HasNoNumberWithoutBalance) {
  const auto bearing = tests::spindle_bearing();
  EXPECT_TRUE(std::isnan(friction::unit_spin_friction(bearing, {}, RaceControl::outer).inner));
}

}  // namespace
}  // namespace raceway

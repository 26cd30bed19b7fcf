#include "spindle/loaded_shaft.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using nlohmann::json;

model::ShaftBody shaft_of(const ReferenceCase& c) {
  model::SolidMaterial steel = model::steel_of_shafts;
  steel.elastic_modulus = c.in("elastic_modulus_GPa") * GPa;
  steel.poissons_ratio = c.in("poisson_ratio");
  model::ShaftBody body;
  for (const json& s : c.inputs().at("segments"))
    body.segments.push_back({.length = s.at("length_mm").get<double>() * mm,
                             .diameter = s.at("diameter_mm").get<double>() * mm,
                             .bore = c.in("shaft_bore_mm") * mm,
                             .material = steel});
  for (const json& s : c.inputs().at("springs"))
    body.supports.push_back({.position = s.at("position_mm").get<double>() * mm,
                             .radial_stiffness = s.at("radial_N_um").get<double>() * N_per_um,
                             .tilt_stiffness = s.at("tilt_Nm_rad")});
  return body;
}

// Beam, springs and rollers in one balance: under a belt, preloaded at speed, and through the gap
// of a clearance.
TEST(RollerReference, AShaftOnRollersUnderABeltIsInBalance) {
  const std::vector<ReferenceCase> cases = reference_cases("spindle");
  ASSERT_EQ(cases.size(), 3U);
  for (const ReferenceCase& c : cases) {
    const bearing::RollerBearing rollers = steel_bearing(geometry(c));
    const double place = c.in("position_mm") * mm, belt = c.in("belt_position_mm") * mm;
    const model::ShaftBody body = shaft_of(c);
    const std::vector<double> nodes{0.0, place, belt};
    const spindle::Beam beam(body, nodes);
    const std::vector<spindle::ShaftLoad> loads{{.position = 0.0, .radial = c.in("nose_load_N")},
                                                {.position = belt, .radial = c.in("belt_load_N")}};
    const double clearance[] = {c.in("radial_clearance_um") * um};
    spindle::ShaftOnBearings shaft(beam, {.rollers = {{&rollers, place}}},
                                   std::vector<double>{0.0, belt});
    const bearing::ArrangementCondition condition{.speed = c.in("speed_rpm") * rpm};
    // The second time from where the first one ended, after another clearance.
    const double wider[] = {clearance[0] + 2 * um};
    ASSERT_TRUE(shaft.solve(condition, clearance, loads).report.converged()) << c.id();
    ASSERT_TRUE(shaft.solve(condition, wider, loads).report.converged()) << c.id();
    const spindle::LoadedShaft bent = shaft.solve(condition, clearance, loads);
    ASSERT_TRUE(bent.report.converged()) << c.id();
    const bearing::RollerEquilibrium& e = bent.rollers.at(0);
    const json& out = c.outputs();
    const Eigen::Vector2d at_rollers = beam.at(place, bent.y);
    c.holds(out, "nose_um", bent.y[0] / um);
    c.holds(out, "roller_place_um", at_rollers[0] / um);
    c.holds(out, "roller_tilt_mrad", at_rollers[1] / mrad);
    c.holds(out, "belt_place_um", beam.at(belt, bent.y)[0] / um);
    c.holds(out, "roller_reaction_N", e.load[0]);
    c.holds(out, "roller_moment_Nm", e.load[3]);
    std::vector<double> reactions, inner;
    for (const model::Support& s : body.supports)
      reactions.push_back(s.radial_stiffness * beam.at(s.position, bent.y)[0]);
    c.holds(out, "front_reactions_N", reactions);
    const spindle::Spring spring = spindle::roller_spring(place, e);
    c.holds(out, "stiffness_yy_N_um", spring.y.radial * um);
    c.holds(out, "stiffness_tilt_z_Nm_rad", spring.y.tilt);
    c.holds(out, "stiffness_y_tilt_z_N_mrad", spring.y.coupling * mrad);
    for (const bearing::LoadedRoller& r : e.rollers) inner.push_back(r.inner_load);
    c.holds(out, "inner_load_N", inner);
    EXPECT_EQ(e.loaded_rollers(), out.at("loaded_rollers").get<int>()) << c.id();
  }
}

// Heat follows the rollers along this tangent within a time step.
TEST(RollerSum, FallsWithTheClearanceAsTheDifferenceQuotient) {
  int beyond = 0;
  const bearing::RollerBearing b = steel_bearing(n1012());
  for (const double speed : {0.0, 8000 * rpm})
    for (const double load : {0.0, 1500.0})
      for (const double clearance : {-6 * um, -1 * um, 3 * um}) {
        const auto at = [&](double s) {
          const bearing::RollerEquilibrium e = solve_roller_bearing(
              b, {.speed = speed, .radial_load = 0.8 * load, .radial_load_z = 0.6 * load},
              {.clearance = s});
          EXPECT_TRUE(e.report.converged());
          return e;
        };
        const double step = 1e-3 * um;
        const double quotient =
            (at(clearance + step).inner_sum() - at(clearance - step).inner_sum()) / (2.0 * step);
        const double outer =
            (at(clearance + step).outer_sum() - at(clearance - step).outer_sum()) / (2.0 * step);
        const double slope = at(clearance).sum_by_clearance;
        const double size = std::abs(quotient) + 1e6,
                     off = std::max(std::abs(slope - quotient), std::abs(slope - outer)) / size;
        EXPECT_LT(off, 2e-3) << speed << ' ' << load << ' ' << clearance;
        beyond += off > 1e-4 ? 1 : 0;
      }
  // In one of the 12 a slice comes into touch within the step, where its slope is infinite.
  EXPECT_LE(beyond, 1);
}

}  // namespace
}  // namespace raceway::roller

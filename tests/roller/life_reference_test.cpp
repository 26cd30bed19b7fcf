#include <cmath>

#include "bearing/contact_pressure.h"
#include "friction/lubricant.h"
#include "life/modified_life.h"
#include "life/roller_life.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using nlohmann::json;

TEST(RollerReference, Ratings) {
  const ReferenceCase c = reference_case("life", "ratings");
  for (const json& row : c.outputs().at("rows")) {
    const bearing::RollerGeometry g = geometry(c, row);
    c.holds(row, "f_c", life::roller_rating_factor(g.diameter_ratio()));
    c.holds(row, "C_N", life::dynamic_load_rating(g));
    c.holds(row, "C0_N", life::static_load_rating(g));
    c.holds(row, "C_u_N", life::fatigue_load(g));
    // The formula itself, of which the tolerance of a table is no measure.
    EXPECT_NEAR(life::dynamic_load_rating(g) / row.at("C_N").get<double>(), 1.0, 1e-8);
  }
}

TEST(RollerReference, LifeOfTheSlices) {
  const ReferenceCase c = reference_case("life", "life");
  const friction::Lubricant oil(c.in("viscosity_40C_mm2_s") * mm2_per_s,
                                c.in("viscosity_100C_mm2_s") * mm2_per_s);
  const double C = c.in("dynamic_load_rating_N");
  for (const json& row : c.outputs().at("rows")) {
    SCOPED_TRACE(row.dump());
    bearing::RollerGeometry g = geometry(c, row);
    g.static_load_rating = c.in("C0_N");
    const bearing::RollerBearing b = steel_bearing(g);
    const double speed = row.at("speed_rpm").get<double>() * rpm;
    const double load = row.at("radial_load_N");
    const auto e = solve_roller_bearing(b, {.speed = speed, .radial_load = load});
    const life::RollerRatings ratings = life::race_ratings(g, C);
    const double L10r = life::reference_life(ratings, e), P = life::roller_reference_load(C, L10r);
    c.holds(row, "Q_ci_N", ratings.inner);
    c.holds(row, "Q_ce_N", ratings.outer);
    c.holds(row, "L10r_Mrev", L10r);
    c.holds(row, "L10r_without_edge_factor_Mrev", life::reference_life(ratings, e, false));
    c.holds(row, "P_ref_N", P);
    c.holds(row, "L10_Mrev", life::roller_rating_life(C, load));
    const bearing::ContactPressure p = largest_pressure(b, e);
    c.holds(row, "largest_pressure_MPa", std::max(p.inner, p.outer) / MPa);
    c.holds(row, "static_safety", life::roller_static_safety(std::max(p.inner, p.outer)));
    const double kappa = life::viscosity_ratio(
        oil.kinematic_viscosity(kelvin(c.in("temperature_C"))), speed, g.pitch_diameter);
    c.holds(row, "kappa", kappa);
    const double a =
        life::roller_life_modification(kappa, c.in("contamination") * life::fatigue_load(g) / P);
    c.holds(row, "a_ISO", a);
    c.holds(row, "Lnm_h", life::life_hours(a * L10r, speed));
  }
}

TEST(RollerReference, LifeModification) {
  const ReferenceCase c = reference_case("life", "a_iso_roller");
  for (const json& row : c.outputs().at("rows"))
    c.holds(row, "a_ISO", life::roller_life_modification(row.at("kappa"), row.at("ratio")));
}

TEST(RollerReference, EdgeFactors) {
  const ReferenceCase c = reference_case("contact", "profile_iso");
  for (const json& row : c.outputs().at("rows"))
    c.holds(row, "edge_factor",
            std::vector{life::edge_factor(0), life::edge_factor(1), life::edge_factor(5),
                        life::edge_factor(20)});
}

TEST(RollerLife, AnUnloadedBearingLivesForever) {
  bearing::RollerGeometry g = n1012();
  g.radial_clearance = 5 * um;
  const auto e = solve_roller_bearing(steel_bearing(g), {});
  EXPECT_TRUE(std::isinf(life::reference_life(life::race_ratings(g, 41.4e3), e)));
}

}  // namespace
}  // namespace raceway::roller

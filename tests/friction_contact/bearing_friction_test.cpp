#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "friction/contact/contact_friction.h"
#include "tests/friction_contact/contact_cases.h"
#include "tests/friction_contact/reference_bearing.h"

namespace raceway::friction::contact {
namespace {

/// A bearing of a case on its load, at its oil.
struct LoadedRun {
  bearing::Bearing bearing;
  bearing::BearingEquilibrium equilibrium;
  OilState oil;
  ContactLaw law;
  double speed;

  LoadedRun(const nlohmann::json& in, const bearing::Material& balls, double speed_rpm)
      : bearing(reference_bearing(in.at("geometry"), balls)),
        equilibrium(
            bearing::solve_bearing_equilibrium(bearing, {.speed = speed_rpm * rpm,
                                                         .axial_load = in.at("Fa"),
                                                         .radial_load = in.value("Fr", 0.0)})),
        speed(speed_rpm * rpm) {
    const Lubricant lubricant(in.at("nu40").get<double>() * mm2_per_s,
                              in.at("nu100").get<double>() * mm2_per_s);
    oil = oil_state(lubricant, {.type = *find_oil_type(in.at("lubricant").get<std::string>())},
                    kelvin(in.at("T_C")));
    law.supply = in.value("supply", "limited") == "flooded" ? Inlet::flooded : Inlet::limited;
    law.boundary_friction = in.value("mu_b", 0.1);
    law.composite_roughness = in.at("composite_roughness_um").get<double>() * um;
  }

  [[nodiscard]] BearingFriction friction() const {
    return bearing_friction(bearing, equilibrium, bearing::RaceControl::outer, speed, oil, law);
  }
  [[nodiscard]] ContactFriction contact(bearing::Race race) const {
    const bearing::BallEquilibrium ball = equilibrium.balls[0];
    const BallMotion m = ball_motion(bearing.geometry(), ball, bearing::RaceControl::outer, speed);
    const bool inner = race == bearing::Race::inner;
    return race_friction(bearing, race, oil, law, speed)
        .contact(inner ? ball.inner_load : ball.outer_load, inner ? m.inner : m.outer);
  }
};

/// Parts below 1 N mm are held by their share of 1 N mm.
constexpr double smallest_part = 1.0;

void hold_thrust(const LoadedRun& run, const nlohmann::json& out, const std::string& where,
                 Distance& torque, Distance& parts, Distance& contacts) {
  const BearingFriction f = run.friction();
  EXPECT_TRUE(f.converged) << where;
  torque.holds(f.moment() / N_mm, out.at("torque_Nmm"), 5e-4, where + " torque");
  const auto part = [&](const char* key, double moment) {
    parts.holds(moment / N_mm, out.at(key), 1e-3, where + " " + key, smallest_part);
  };
  part("sliding_inner_Nmm", f.inner.sliding);
  part("sliding_outer_Nmm", f.outer.sliding);
  part("rolling_inner_Nmm", f.inner.rolling);
  part("rolling_outer_Nmm", f.outer.rolling);
  part("hysteresis_inner_Nmm", f.inner.hysteresis);
  part("hysteresis_outer_Nmm", f.outer.hysteresis);
  parts.holds(f.inner.sum() * run.speed, out.at("heat_inner_W"), 1e-3, where + " heat_inner_W");
  parts.holds(f.outer.sum() * run.speed, out.at("heat_outer_W"), 1e-3, where + " heat_outer_W");
  const ContactFriction i = run.contact(bearing::Race::inner),
                        o = run.contact(bearing::Race::outer);
  const auto contact = [&](const char* key, double value, double tolerance = 1e-5) {
    contacts.holds(value, out.at(key), tolerance, where + " " + key);
  };
  contact("h_min_inner_um", i.film.minimum / um);
  contact("h_min_outer_um", o.film.minimum / um);
  contact("lambda_inner", i.film_ratio);
  contact("lambda_outer", o.film_ratio);
  contact("p_max_inner_GPa", i.peak_pressure / GPa);
  contact("p_max_outer_GPa", o.peak_pressure / GPa);
  contact("spin_inner_rad_s", i.spin);
  // What friction must hold against the gyroscopic moment, which a full film cannot.
  const bearing::BallEquilibrium ball = run.equilibrium.balls[0];
  contact("holding_coefficient", ball.outer_friction / ball.outer_load);
  contact("mu_mean_inner", i.mean_friction, 5e-3);  // |τ| near the pole, of 12 x 16 points
  contact("slip_mean_inner_m_s", i.mean_slip, 1e-3);
}

TEST(BearingFriction, OfSteelAndHybridUnderThrustIsThatOfTheReference) {
  Distance torque("bearing_torque"), parts("bearing_parts"), contacts("bearing_contacts");
  for (const auto& c : contact_cases("bearing_")) {
    const auto& in = c.at("inputs");
    const auto& out = c.at("outputs");
    if (!out.contains("steel")) continue;
    const std::string id = c.at("id");
    const LoadedRun steel(in, bearing::steel(), in.at("rpm"));
    const LoadedRun hybrid(in, bearing::silicon_nitride(), in.at("rpm"));
    hold_thrust(steel, out.at("steel"), id + " steel", torque, parts, contacts);
    hold_thrust(hybrid, out.at("nitride"), id + " hybrid", torque, parts, contacts);
    torque.holds(hybrid.friction().moment() / steel.friction().moment(),
                 out.at("ratio_nitride_steel"), 5e-4, id + " ratio");
  }
}

TEST(BearingFriction, OfCombinedLoadIsThatOfTheReference) {
  Distance off("bearing_combined");
  for (const auto& c : contact_cases("bearing_combined")) {
    const auto& in = c.at("inputs");
    const auto& out = c.at("outputs");
    const std::string id = c.at("id");
    const LoadedRun run(in, bearing::steel(), in.at("rpm"));
    const BearingFriction f = run.friction();
    off.holds(f.moment() / N_mm, out.at("torque_Nmm"), 5e-4, id + " torque");
    off.holds((f.inner.sliding + f.outer.sliding) / N_mm, out.at("sliding_Nmm"), 1e-3, id);
    off.holds((f.inner.rolling + f.outer.rolling) / N_mm, out.at("rolling_Nmm"), 1e-3, id);
    off.holds((f.inner.hysteresis + f.outer.hysteresis) / N_mm, out.at("hysteresis_Nmm"), 1e-3, id);
    off.holds(f.smallest_film_ratio, out.at("lambda_min"), 1e-4, id + " lambda_min");
  }
}

TEST(BearingFriction, OfACatalogueScrewSupportIsThatOfTheReference) {
  Distance off("catalogue");
  for (const auto& c : contact_cases("catalogue_")) {
    const auto& in = c.at("inputs");
    const std::string id = c.at("id");
    for (const auto& [key, out] : c.at("outputs").items()) {
      if (!key.ends_with("_rpm")) continue;
      const LoadedRun run(in, bearing::steel(), std::stod(key));
      const BearingFriction f = run.friction();
      const std::string where = id + " " + key;
      off.holds(f.moment() / N_mm, out.at("torque_Nmm"), 1e-3, where + " torque");
      off.holds((f.inner.sliding + f.outer.sliding) / N_mm, out.at("sliding_Nmm"), 1e-3, where);
      off.holds((f.inner.rolling + f.outer.rolling) / N_mm, out.at("rolling_Nmm"), 1e-3, where);
      off.holds((f.inner.hysteresis + f.outer.hysteresis) / N_mm, out.at("hysteresis_Nmm"), 1e-3,
                where);
      off.holds(run.contact(bearing::Race::inner).film_ratio, out.at("lambda_inner"), 1e-5, where);
    }
  }
}

TEST(BearingFriction, OfACatalogueScrewSupportMeetsThePrintWithTheBoundaryFrictionOfTheReference) {
  for (const auto& c : contact_cases("catalogue_")) {
    const auto& out = c.at("outputs");
    if (!out.contains("mu_that_meets_print")) continue;
    LoadedRun run(c.at("inputs"), bearing::steel(), 0.01);
    run.law.boundary_friction = out.at("mu_that_meets_print");
    const double printed = out.at("printed_torque_of_one_Nmm");
    EXPECT_NEAR(run.friction().moment() / N_mm, printed, 3e-3 * printed) << c.at("id");
  }
}

TEST(BearingFriction, StandsOnTheOuterControlOfTheReference) {
  for (const auto& c : contact_cases("balanced_")) {
    const auto& in = c.at("inputs");
    const auto& out = c.at("outputs").at("outer_control");
    const bool hybrid = in.at("ball") == "nitride";
    const LoadedRun run(in, hybrid ? bearing::silicon_nitride() : bearing::steel(), in.at("rpm"));
    const bearing::BallEquilibrium ball = run.equilibrium.balls[0];
    const bearing::BallSpeeds v =
        run.equilibrium.speeds(0, run.bearing, run.speed, bearing::RaceControl::outer);
    const std::string id = c.at("id");
    EXPECT_NEAR(v.pitch_angle / degree, out.at("beta_deg"), 1e-6) << id;
    EXPECT_NEAR(ball.inner_contact_angle / degree, out.at("angle_inner_deg"), 1e-6) << id;
    EXPECT_NEAR(ball.outer_contact_angle / degree, out.at("angle_outer_deg"), 1e-6) << id;
    EXPECT_NEAR(run.equilibrium.displacement[0] / um, out.at("displacement_um"), 1e-5) << id;
  }
}

nlohmann::json spindle_bearing() {
  return nlohmann::json::parse(R"({"geometry": {"D": 0.0127, "dm": 0.09, "Z": 18, "alpha0": 25.0,
    "fi": 0.525, "fo": 0.515}, "Fa": 500.0, "T_C": 40.0, "lubricant": "mineral", "nu40": 22.0,
    "nu100": 4.8, "composite_roughness_um": 0.05})");
}

TEST(BearingFriction, AtStandstillIsTheLimitOfSlowRotation) {
  const BearingFriction still = LoadedRun(spindle_bearing(), bearing::steel(), 0.0).friction();
  const BearingFriction slow = LoadedRun(spindle_bearing(), bearing::steel(), 1e-6).friction();
  ASSERT_TRUE(still.converged);
  EXPECT_NEAR(slow.moment(), still.moment(), 1e-3 * still.moment());
  EXPECT_EQ(still.inner.rolling, 0.0);
  EXPECT_EQ(still.smallest_film_ratio, 0.0);
}

TEST(BearingFriction, IsSmoothOverSpeed) {
  double before = 0.0, slope = 0.0;
  for (double n = 5.0; n < 20000.0; n *= 1.05) {
    const double value =
        std::log(LoadedRun(spindle_bearing(), bearing::steel(), n).friction().moment());
    if (slope != 0.0) {
      EXPECT_NEAR(value - before, slope, 0.02) << n;
    }
    if (before != 0.0) slope = value - before;
    before = value;
  }
}

TEST(BearingFriction, OfAFullFilmGrowsWithViscosity) {
  double before = 0.0;
  for (const double nu40 : {10.0, 15.0, 22.0, 46.0, 100.0}) {
    nlohmann::json in = spindle_bearing();
    in["nu40"] = nu40;
    in["nu100"] = 0.13 * nu40 + 2.0 * std::pow(nu40 / 22.0, 0.5);
    const double moment = LoadedRun(in, bearing::steel(), 3000.0).friction().moment();
    EXPECT_GT(moment, before) << nu40;
    before = moment;
  }
}

TEST(BearingFriction, IsNotANumberWithoutABalance) {
  LoadedRun run(spindle_bearing(), bearing::steel(), 1000.0);
  run.equilibrium = {};
  EXPECT_TRUE(std::isnan(run.friction().moment()));
  EXPECT_FALSE(run.friction().converged);
}

TEST(BearingFriction, FactorsActOnTheirPartAlone) {
  LoadedRun run(spindle_bearing(), bearing::steel(), 6000.0);
  const BearingFriction plain = run.friction();
  run.law.rolling_factor = 2.0;
  run.law.hysteresis_factor = 0.0;
  const BearingFriction other = run.friction();
  EXPECT_DOUBLE_EQ(other.inner.rolling, 2.0 * plain.inner.rolling);
  EXPECT_EQ(other.outer.hysteresis, 0.0);
  EXPECT_EQ(other.inner.sliding, plain.inner.sliding);
  run.law.replenishment = 6e-8;
  EXPECT_LT(run.friction().inner.rolling, other.inner.rolling);
  run.law.inlet_over_b = 1.5;
  EXPECT_LT(run.friction().smallest_film, other.smallest_film);
}

TEST(BearingFriction, TakesPowerInEveryPartOfTenThousandRandomContacts) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>()(random));
  };
  const nlohmann::json in = spindle_bearing();
  const bearing::Bearing steel = reference_bearing(in.at("geometry"), bearing::steel());
  for (int i = 0; i < 10000; ++i) {
    const double nu40 = between(5.0, 500.0) * mm2_per_s;
    const Lubricant lubricant(nu40, nu40 * between(0.12, 0.3));
    const OilType type = i % 3 == 0 ? OilType::mineral : i % 3 == 1 ? OilType::pao : OilType::ester;
    const OilState oil = oil_state(lubricant, {.type = type}, kelvin(between(1.0, 150.0) - 10.0));
    ContactLaw law;
    law.supply = i % 2 == 0 ? Inlet::flooded : Inlet::limited;
    law.replenishment = i % 5 == 0 ? 6e-8 : 0.0;
    law.inlet_over_b = i % 4 == 0 ? between(1.05, 100.0) : unset;
    law.composite_roughness = between(0.01, 1.0) * um;
    const double speed = between(1e-3, 60000.0) * rpm;
    const bearing::Race race = i % 2 == 0 ? bearing::Race::inner : bearing::Race::outer;
    const RaceFriction friction = race_friction(steel, race, oil, law, speed);
    const double rolling = speed * between(1.0, 5.0);
    const ContactMotion motion{.surface_speed = rolling * 5e-3,
                               .rolling = rolling,
                               .spin = i % 7 == 0 ? 0.0 : rolling * between(1e-4, 1.0)};
    const ContactFriction c = friction.contact(between(0.1, 20e3), motion);
    ASSERT_TRUE(c.converged) << i;
    ASSERT_TRUE(std::isfinite(c.power())) << i;
    ASSERT_GT(c.sliding, 0.0) << i;
    ASSERT_GE(c.rolling, 0.0) << i;  // none is left where K_rs starves it
    ASSERT_GT(c.hysteresis, 0.0) << i;
    ASSERT_LE(c.mean_friction, 0.1 + 1e-9) << i;
  }
}

}  // namespace
}  // namespace raceway::friction::contact

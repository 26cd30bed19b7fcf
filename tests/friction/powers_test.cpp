#include "friction/powers.h"

#include <span>
#include <vector>

#include "friction/friction_law.h"
#include "tests/friction/sample.h"

namespace raceway {
namespace {

using friction::BearingState;
using friction::F1Load;
using friction::FrictionLaw;
using friction::PalmgrenViscous;
using friction::PowersViscous;

BearingState<double> at(const bearing::Bearing& bearing, double speed, double axial_load,
                        double viscosity) {
  BearingState<double> s;
  s.bearing = &bearing;
  s.speed = speed;
  s.axial_load = axial_load;
  s.kinematic_viscosity = viscosity;
  return s;
}

friction::BaseMoments<double> moments(FrictionLaw law, const BearingState<double>& state,
                                      const std::vector<double>& values) {
  return friction::base_moments(law, state, std::span<const double>(values));
}

TEST(Powers, WithTheExponentsOfPalmgrenItIsPalmgrens) {
  const bearing::Bearing bearing = tests::spindle_bearing();
  for (const F1Load load : {F1Load::P0, F1Load::F_b})
    for (const double speed : {200 * rpm, 4000 * rpm, 18000 * rpm})
      for (const double viscosity : {8 * mm2_per_s, 40 * mm2_per_s}) {
        BearingState<double> s = at(bearing, speed, 700.0, viscosity);
        s.f1_load = load;
        s.radial_load = 150.0;
        const auto palmgren = moments(FrictionLaw::palmgren, s, {2.0, 0.001, 0.33});
        const auto powers = moments(FrictionLaw::powers, s, {2.0, 0.001, 0.33, 2.0 / 3.0, 0.0});
        EXPECT_EQ(powers.load, palmgren.load);
        // Below ν n = 2000 the constant of Palmgren's law is rounded.
        const bool slow = speed / rpm * viscosity / mm2_per_s < 2000.0;
        tests::expect_relative(powers.viscous, palmgren.viscous, slow ? 0.009 : 1e-12);
      }
}

TEST(Powers, KeepsPalmgrensMomentsAtTheMediumPoint) {
  const bearing::Bearing bearing = tests::spindle_bearing();
  // nu n = 300 000 and P0 = Y0 F_a = 200 N, with Y0 = 0.38 at 25 deg.
  const BearingState<double> s = at(
      bearing, 10000 * rpm, 200.0 / friction::static_load_factors(25 * degree).Y0, 30 * mm2_per_s);
  const double viscous = moments(FrictionLaw::palmgren, s, {2.0, 0.001, 0.33}).viscous;
  for (const double exponent : {0.5, 0.656, 0.8})
    for (const double load_exponent : {0.0, 0.466})
      tests::expect_relative(
          moments(FrictionLaw::powers, s, {2.0, 0.001, 0.33, exponent, load_exponent}).viscous,
          viscous, 1e-12);
}

TEST(Powers, TheViscousMomentGoesWithThePowersOfItsExponents) {
  const bearing::Bearing bearing = tests::spindle_bearing();
  const double a = 0.656, b = 0.466;
  const auto moment = [&](double speed, double load, double viscosity) {
    return PowersViscous::moment(at(bearing, speed, load, viscosity), 1.5, a, b);
  };
  const double reference = moment(5000 * rpm, 400.0, 20 * mm2_per_s);
  tests::expect_relative(moment(10000 * rpm, 400.0, 20 * mm2_per_s), std::pow(2.0, a) * reference,
                         1e-12);
  tests::expect_relative(moment(5000 * rpm, 400.0, 60 * mm2_per_s), std::pow(3.0, a) * reference,
                         1e-12);
  tests::expect_relative(moment(5000 * rpm, 3600.0, 20 * mm2_per_s), std::pow(9.0, b) * reference,
                         1e-12);
}

TEST(Powers, HasDerivativesAndIsFiniteAtTheEdges) {
  const auto law = [](const auto& state, const auto& p) {
    return PowersViscous::moment(state, p[0], p[1], p[2]);
  };
  const bearing::Bearing bearing = tests::spindle_bearing();
  tests::expect_derivatives<3>(bearing, {8000 * rpm, 600.0, 100.0, 22 * mm2_per_s},
                               {1.5, 0.66, 0.45}, law);
  tests::expect_finite_at_the_edges<3>(bearing, {1.5, 0.66, 0.45}, law);
}

TEST(Powers, NeedsTheStaticLoadRating) {
  bearing::BearingGeometry g = tests::spindle_geometry();
  g.static_load_rating = unset;
  const bearing::Bearing bearing(g, bearing::steel(), bearing::steel());
  EXPECT_EQ(tests::message_of([&] { friction::require_data(FrictionLaw::powers, bearing); }),
            "static_load_rating is missing: the law powers needs a rating above 0 N");
}

/// Moments of the law `contact-powers` in a solved equilibrium.
struct OfContacts {
  bearing::Bearing bearing;
  bearing::BearingEquilibrium equilibrium;
  BearingState<double> state;

  OfContacts(const bearing::Bearing& of, const bearing::OperatingPoint& point)
      : bearing(of),
        equilibrium(bearing::solve_bearing_equilibrium(bearing, point)),
        state(tests::state_of(bearing, equilibrium, point, bearing::RaceControl::outer)) {}

  [[nodiscard]] friction::BaseMoments<double> moments(const std::vector<double>& values) const {
    return raceway::moments(FrictionLaw::contact_powers, state, values);
  }
  /// Sum of the loads of all contacts [N].
  [[nodiscard]] double load_sum() const {
    double sum = 0.0;
    for (const bearing::BallEquilibrium& ball : equilibrium.balls)
      sum += ball.inner_load + ball.outer_load;
    return sum;
  }
};

const bearing::OperatingPoint fast_and_skew{
    .speed = 16000 * rpm, .axial_load = 700.0, .radial_load = 150.0, .radial_load_z = 60.0};

TEST(ContactPowers, WithLoadsToThePowerOneItCountsTheSumOfTheContactLoads) {
  const OfContacts at(tests::spindle_bearing(), fast_and_skew);
  ASSERT_TRUE(at.equilibrium.report.converged());
  const double alpha = 25 * degree, dm = 90 * mm;
  const auto m = at.moments({2.0, 0.001, 0.0, 2.0 / 3.0, 1.0});
  // F_b = 0.9 Z Q sin α0 cot α0, mean over 2 Z contacts.
  tests::expect_relative(m.load, 0.001 * dm * 0.9 * std::cos(alpha) * 0.5 * at.load_sum(), 1e-12);
  // P0 = Y0 Z Q sin α0 over 200 N times Palmgren's moment.
  const double ratio =
      friction::static_load_factors(alpha).Y0 * std::sin(alpha) * 0.5 * at.load_sum() / 200.0;
  const double nu_n = 22.0 * 16000.0;
  tests::expect_relative(
      m.viscous, 1e-10 * 2.0 * std::pow(nu_n, 2.0 / 3.0) * std::pow(90.0, 3) * ratio, 1e-12);
}

TEST(ContactPowers, IsTheLawPowersUnderALightThrustAtRest) {
  const OfContacts at(tests::spindle_bearing(), {.speed = 1 * rpm, .axial_load = 5.0});
  ASSERT_TRUE(at.equilibrium.report.converged());
  const std::vector<double> values{2.0, 0.001, 0.33, 0.66, 0.47};
  const auto contacts = at.moments(values),
             bearing = moments(FrictionLaw::powers, at.state, values);
  // The running contact angle is 25.3 deg.
  tests::expect_relative(contacts.load, bearing.load, 0.02);
  tests::expect_relative(contacts.viscous, bearing.viscous, 0.02);
}

TEST(ContactPowers, TheCentrifugalForceOfSteelBallsIsFeltMore) {
  const bearing::OperatingPoint point{.speed = 20000 * rpm, .axial_load = 300.0};
  const std::vector<double> values{2.0, 0.001, 0.33, 0.66, 0.47};
  const auto steel = OfContacts(tests::spindle_bearing(), point).moments(values),
             ceramic = OfContacts(tests::spindle_bearing(bearing::silicon_nitride()), point)
                           .moments(values);
  EXPECT_GT(steel.load, 1.2 * ceramic.load);
  EXPECT_GT(steel.viscous, 1.1 * ceramic.viscous);
}

TEST(ContactPowers, HasNoMomentsWithoutEquilibrium) {
  const bearing::Bearing bearing = tests::spindle_bearing();
  const auto m = moments(FrictionLaw::contact_powers, at(bearing, 100.0, 500.0, 22 * mm2_per_s),
                         {2.0, 0.001, 0.33, 0.66, 0.47});
  EXPECT_TRUE(std::isnan(m.load));
  EXPECT_TRUE(std::isnan(m.viscous));
}

}  // namespace
}  // namespace raceway

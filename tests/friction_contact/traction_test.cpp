#include "friction/contact/traction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "friction/contact/film_traction.h"
#include "tests/friction_contact/contact_cases.h"

namespace raceway::friction::contact {
namespace {

SlidingEllipse ellipse_of(const nlohmann::json& in) {
  return {.load = in.at("Q"),
          .semi_major_axis = in.at("a"),
          .semi_minor_axis = in.at("b"),
          .differential = in.at("roll_rad_s").get<double>() / (2.0 * in.at("R").get<double>()),
          .spin = in.at("spin_rad_s")};
}

template <std::size_t Radial, std::size_t Angles>
Traction traction_of(const nlohmann::json& in) {
  const auto& r = in.at("rheology");
  const auto solve = [&](const auto& shear) {
    const TractionField<std::decay_t<decltype(shear)>, Radial, Angles> field(ellipse_of(in), shear);
    return holding_traction(field, in.at("T_N"));
  };
  if (r.at("mode") == "coulomb") return solve(CoulombShear{r.at("mu"), r.at("eps")});
  if (r.at("mode") == "newton") return solve(NewtonShear{r.at("eta"), r.at("h")});
  return solve(FilmShear{.viscosity = Roelands(r.at("eta0"), r.at("alpha")),
                         .film = r.at("h"),
                         .eyring_stress = r.at("tau0"),
                         .limiting_traction = r.at("limit"),
                         .asperity_share = r.at("phi"),
                         .boundary_friction = r.at("mu_b"),
                         .small_speed = r.at("eps")});
}

template <std::size_t Radial, std::size_t Angles>
void hold_reference(const std::string& name, double tolerance, double slip_tolerance) {
  Distance off(name), off_slip(name + "_slip");
  for (const auto& c : contact_cases("traction_")) {
    const auto& out = c.at("outputs");
    const Traction t = traction_of<Radial, Angles>(c.at("inputs"));
    EXPECT_TRUE(t.converged) << c.at("id");
    const std::string where = c.at("id").get<std::string>() + " ";
    const double spin_scale = out.at("mu_mean").get<double>() *
                              c.at("inputs").at("Q").get<double>() *
                              c.at("inputs").at("a").get<double>() / N_mm;
    off.holds(t.power, out.at("power_W"), tolerance, where + "power_W");
    off.holds(t.spin_moment / N_mm, out.at("spin_moment_Nmm"), tolerance, where + "spin",
              spin_scale);
    off.holds(t.mean_friction, out.at("mu_mean"), tolerance, where + "mu_mean");
    off.holds(t.mean_slip, out.at("slip_mean"), tolerance, where + "slip_mean");
    // A kink of the integral: where dry friction rolls freely the slip along is known badly.
    const double slip = out.at("slip_mean");
    off_slip.holds(t.slip.along / slip, out.at("v_x0").get<double>() / slip, slip_tolerance,
                   where + "v_x0", 1.0);
    off_slip.holds(t.slip.across / slip, out.at("v_y0").get<double>() / slip, slip_tolerance,
                   where + "v_y0", 1.0);
  }
}

TEST(Traction, IsThatOfTheReference) { hold_reference<16, 24>("traction", 1e-3, 3e-2); }

TEST(Traction, ConvergesToTheReferenceWithItsPoints) {
  hold_reference<100, 100>("traction_fine", 1e-4, 5e-3);
}

constexpr SlidingEllipse sample{.load = 100.0,
                                .semi_major_axis = 0.6e-3,
                                .semi_minor_axis = 0.08e-3,
                                .differential = 3500.0 / 13e-3,
                                .spin = 900.0};

FilmShear film_shear(double film, double asperities) {
  return {.viscosity = Roelands(0.019, 1.52e-8),
          .film = film,
          .eyring_stress = 5e6,
          .limiting_traction = 0.06,
          .asperity_share = asperities,
          .boundary_friction = 0.1,
          .small_speed = 1e-5};
}

TEST(Traction, OfDrySpinAloneIsTheMomentOfTheTextbook) {
  SlidingEllipse e = sample;
  e.differential = 0.0;
  const Traction t = rolling_traction(TractionField<CoulombShear, 60, 60>(e, {0.07, 1e-9}));
  const double k2 = 1.0 - std::pow(e.semi_minor_axis / e.semi_major_axis, 2);
  const double moment =
      0.375 * 0.07 * e.load * e.semi_major_axis * std::comp_ellint_2(std::sqrt(k2));
  EXPECT_NEAR(t.spin_moment, moment, 1e-5 * moment);
  EXPECT_NEAR(t.power, moment * e.spin, 1e-5 * moment * e.spin);
  EXPECT_EQ(t.slip.along, 0.0);
}

TEST(Traction, OfDryDifferentialSlidingAloneRollsOnTwoLines) {
  // y0 = 0.347 a and 0.1611 μ Q ω a²/(2 R), the zero of the cubic of a Hertz pressure.
  SlidingEllipse e = sample;
  e.spin = 0.0;
  const double size = e.differential * e.semi_major_axis * e.semi_major_axis;
  const Traction t = rolling_traction(TractionField<CoulombShear, 100, 200>(e, {0.07, 1e-9}));
  EXPECT_NEAR(std::sqrt(-t.slip.along / size), 0.3473, 1e-3);
  EXPECT_NEAR(t.power, 0.1611 * 0.07 * e.load * size, 1e-3 * t.power);
  EXPECT_NEAR(t.spin_moment, 0.0, 1e-9 * t.power);
}

TEST(Traction, OfOneViscosityIsTheClosedFormWithAnyNumberOfPoints) {
  // Polynomials in x and y; the bracket is Σ of the squares of the slip over the ellipse.
  const double a = sample.semi_major_axis, b = sample.semi_minor_axis, d = sample.differential;
  const NewtonShear shear{0.5, 4e-7};
  for (const double force : {0.0, 2.0}) {
    const Traction t = holding_traction(TractionField<NewtonShear, 6, 4>(sample, shear), force);
    const double slope = shear.viscosity / shear.film * pi * a * b;
    const double expected =
        slope * (d * d * a * a * a * a / 16.0 + sample.spin * sample.spin * (a * a + b * b) / 4.0) +
        force * force / slope;
    EXPECT_NEAR(t.power, expected, 1e-9 * expected);
    EXPECT_NEAR(t.slip.along, -d * a * a / 4.0, 1e-9 * d * a * a);
    EXPECT_NEAR(t.slip.across, force / slope, 1e-9);
  }
}

TEST(Traction, OfBothSlidingsIsLessThanTheSumOfEach) {
  const auto power = [](const SlidingEllipse& e) {
    return rolling_traction(TractionField<FilmShear, 16, 24>(e, film_shear(3e-7, 0.2))).power;
  };
  SlidingEllipse spin = sample, differential = sample;
  spin.differential = 0.0;
  differential.spin = 0.0;
  EXPECT_LT(power(sample), power(spin) + power(differential));
  EXPECT_GT(power(sample), power(spin));
}

TEST(Traction, OfTheHalfIsThatOfTheWholeWhereNothingIsHeldAcross) {
  const TractionField<FilmShear, 16, 24> field(sample, film_shear(3e-7, 0.2));
  const TractionSums half = field.sums({-0.01, 0.0}, false), whole = field.sums({-0.01, 0.0}, true);
  EXPECT_NEAR(half.power, whole.power, 1e-12 * whole.power);
  EXPECT_NEAR(half.along, whole.along, 1e-12 * whole.force);
  EXPECT_NEAR(whole.across, 0.0, 1e-12 * whole.force);
}

TEST(Traction, SlopesAreTheDifferenceQuotientsOfTheSums) {
  const TractionField<FilmShear, 12, 12> field(sample, film_shear(3e-7, 0.3));
  const double step = 1e-7;
  const CentreSlip at{-0.012, 0.03};
  const TractionSums s = field.sums(at, true);
  const auto moved = [&](double dx, double dy) {
    return field.sums({at.along + dx, at.across + dy}, true);
  };
  const TractionSums right = moved(step, 0), left = moved(-step, 0);
  const TractionSums up = moved(0, step), down = moved(0, -step);
  EXPECT_NEAR(s.along_slope, (right.along - left.along) / (2 * step), 1e-5 * s.along_slope);
  EXPECT_NEAR(s.mixed_slope, (up.along - down.along) / (2 * step), 1e-5 * s.along_slope);
  EXPECT_NEAR(s.mixed_slope, (right.across - left.across) / (2 * step), 1e-5 * s.along_slope);
  EXPECT_NEAR(s.across_slope, (up.across - down.across) / (2 * step), 1e-5 * s.across_slope);
}

TEST(Traction, HoldsNoMoreThanItsLimit) {
  const TractionField<FilmShear, 12, 12> field(sample, film_shear(3e-7, 0.0));
  EXPECT_TRUE(holding_traction(field, 1.0).converged);
  EXPECT_NEAR(holding_traction(field, -1.0).power, holding_traction(field, 1.0).power, 1e-9);
  EXPECT_FALSE(holding_traction(field, 0.061 * sample.load).converged);
}

TEST(Traction, TakesPowerAndNeverGivesItInTenThousandStates) {
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>()(random));
  };
  for (int i = 0; i < 10000; ++i) {
    SlidingEllipse e{.load = between(0.1, 5000.0),
                     .semi_major_axis = between(1e-4, 2e-3),
                     .differential = between(1.0, 1e7),
                     .spin = between(1e-4, 2e4)};
    e.semi_minor_axis = e.semi_major_axis / between(1.0, 12.0);
    if (i % 7 == 0) e.spin = 0.0;
    if (i % 11 == 0) e.differential = 0.0;
    FilmShear shear = film_shear(between(1e-9, 3e-6), i % 3 == 0 ? 0.0 : between(1e-6, 1.0));
    shear.viscosity = Roelands(between(1e-3, 1.0), between(5e-9, 4e-8));
    shear.small_speed = 1e-6 * between(1e-3, 60.0);
    const Traction t = film_traction(e, shear);
    ASSERT_TRUE(t.converged) << i;
    ASSERT_TRUE(t.power >= 0.0 && std::isfinite(t.power)) << i;
    ASSERT_LE(t.mean_friction, 0.1 + 1e-12) << i;
    ASSERT_GE(t.slip.along, -e.differential * e.semi_major_axis * e.semi_major_axis) << i;
    ASSERT_LE(t.slip.along, 0.0) << i;
  }
}

TEST(Traction, SideBySideIsThatOfThePlainVersion) {
  std::mt19937_64 random(11);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<>()(random));
  };
  for (int i = 0; i < 600; ++i) {
    SlidingEllipse e = sample;
    e.load = between(1.0, 3000.0);
    e.differential *= between(1e-3, 10.0);
    e.spin = i % 4 == 0 ? 0.0 : between(0.1, 5e3);
    FilmShear shear =
        film_shear(i % 5 == 0 ? 0.0 : between(1e-8, 2e-6), i % 3 == 0 ? 0.0 : between(1e-4, 1.0));
    if (i % 5 == 0) shear.asperity_share = 1.0;
    const Traction fast = film_traction(e, shear);
    const Traction plain = e.spin == 0.0
                               ? rolling_traction(TractionField<FilmShear, 16, 24>(e, shear))
                               : rolling_traction(TractionField<FilmShear, 12, 16>(e, shear));
    ASSERT_TRUE(fast.converged && plain.converged) << i;
    ASSERT_NEAR(fast.power, plain.power, 1e-6 * plain.power) << i;
    double centre = between(0.01, 0.9);
    const Traction from_elsewhere = film_traction(e, shear, centre);
    ASSERT_TRUE(from_elsewhere.converged) << i;
    ASSERT_NEAR(from_elsewhere.power, plain.power, 1e-6 * plain.power) << i;
    ASSERT_NEAR(fast.spin_moment, plain.spin_moment, 1e-4 * plain.mean_friction * e.load * 6e-4);
    ASSERT_NEAR(fast.mean_slip, plain.mean_slip, 1e-4 * plain.mean_slip) << i;
    // |τ| turns within the small speed of asperities, which is below the 1e-6 of v_x0.
    ASSERT_NEAR(fast.mean_friction, plain.mean_friction, 5e-3 * plain.mean_friction) << i;
  }
}

TEST(Traction, OfAContactThatDoesNotSlideIsNothing) {
  SlidingEllipse e = sample;
  e.spin = e.differential = 0.0;
  for (const double share : {0.0, 0.5, 1.0}) {
    const Traction t = film_traction(e, film_shear(3e-7, share));
    EXPECT_TRUE(t.converged);
    EXPECT_EQ(t.power, 0.0);
    EXPECT_EQ(t.mean_slip, 0.0);
  }
}

TEST(Traction, IsSmoothInSpinAndLoad) {
  // A step of a thousandth moves the logarithm of power by as much before as after, but for the
  // curvature: no edge that a fit would stumble on.
  const auto log_power = [](double factor, bool spin) {
    SlidingEllipse e = sample;
    (spin ? e.spin : e.load) *= factor;
    return std::log(film_traction(e, film_shear(3e-7, 0.1)).power);
  };
  for (const bool spin : {true, false})
    for (double x = 0.2; x < 3.0; x *= 1.07) {
      const double before = log_power(x, spin) - log_power(x * 0.999, spin);
      const double after = log_power(x * 1.001, spin) - log_power(x, spin);
      EXPECT_NEAR(after, before, 2e-2 * std::abs(before)) << x;
    }
}

}  // namespace
}  // namespace raceway::friction::contact

#include "spindle/contact.h"

#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

RoughContact ground_seat() {
  return {.roughness = 0.8 * um,
          .slope = 0.15,
          .hardness = 3e9,
          .first_conductivity = 46.0,
          .second_conductivity = 48.0};
}

TEST(Contact, OfRoughSurfacesIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("contact_")) {
    const RoughContact contact{.roughness = c.in("Ra_m"),
                               .slope = c.in("slope"),
                               .hardness = c.in("H_Pa"),
                               .first_conductivity = c.in("lambda1"),
                               .second_conductivity = c.in("lambda2")};
    c.holds("seed_eq4_W_m2K", solid_contact(contact, c.in("p_Pa")));
    c.holds("yovanovich_W_m2K", yovanovich_contact(contact, c.in("p_Pa")));
  }
}

TEST(Contact, ConstrictionIsThatOfTheReference) {
  for (const ReferenceCase& c : reference_cases("constriction_")) {
    const double a = c.in("a_m"), b = c.in("b_m");
    c.holds("R_K_W", constriction_resistance(a, b, c.in("lambda1"), c.in("lambda2")));
    c.holds("R_K_W", constriction_resistance(b, a, c.in("lambda2"), c.in("lambda1")));
  }
}

TEST(Contact, ConstrictionOfACircleIsAQuarterOfAndStaysSmoothNearIt) {
  const double circle = constriction_resistance(1e-4, 1e-4, 46.0, 30.0);
  EXPECT_NEAR(circle, (1.0 / 46.0 + 1.0 / 30.0) / (4.0 * 1e-4), 1e-12 * circle);
  EXPECT_NEAR(constriction_resistance(1e-4, 1e-4 * (1.0 - 1e-9), 46.0, 30.0), circle,
              1e-8 * circle);
  EXPECT_TRUE(std::isinf(constriction_resistance(1e-4, 0.0, 46.0, 46.0)));
}

TEST(Contact, OfALooseSeatIsTheAirBetween) {
  const RoughContact seat = ground_seat();
  for (const double pressure : {0.0, -1e6}) {
    EXPECT_EQ(solid_contact(seat, pressure), 0.0);
    EXPECT_EQ(yovanovich_contact(seat, pressure), 0.0);
  }
  EXPECT_NEAR(seat_conductance(seat, 0.0, 0.0), 0.027 / 2.4e-6, 1e-9);
  EXPECT_NEAR(seat_conductance(seat, 0.0, 2 * um), 0.027 / 4.4e-6, 1e-9);
  // 2 um of air are as good as some MPa.
  EXPECT_GT(seat_conductance(seat, 0.0, 2 * um), solid_contact(seat, 1e6));
}

TEST(Contact, GrowsWithPressureAndHasNoStepWhereASeatComesLoose) {
  const RoughContact seat = ground_seat();
  const double loose = seat_conductance(seat, 0.0, 0.0);
  EXPECT_NEAR(seat_conductance(seat, 1e-3, 0.0), loose, 1e-4 * loose);
  EXPECT_NEAR(seat_conductance(seat, 0.0, 1e-12), loose, 1e-4 * loose);
  double before = loose;
  for (double p = 1e4; p < 2e7; p *= 1.5) {
    const double now = seat_conductance(seat, p, 0.0);
    EXPECT_GT(now, before);
    before = now;
  }
}

}  // namespace
}  // namespace raceway::spindle

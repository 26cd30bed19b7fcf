#include "bearing/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "record/units.h"
#include "tests/bearing/expect.h"
#include "tests/reference_table.h"

namespace raceway::bearing {
namespace {

using tests::expect_relative;

/// Ball and cage speed over shaft speed for any attitude β of the ball's axis, inner ring driven
/// [Harris2006, vol. 2, ch. 5]: what the reduced forms of kinematics.h come from.
struct GeneralSpeeds {
  double ball;
  double cage;
};

GeneralSpeeds general_speeds(double inner, double outer, double pitch_angle, double g) {
  const double tan_b = std::tan(pitch_angle);
  const double out = (std::cos(outer) + tan_b * std::sin(outer)) / (1.0 + g * std::cos(outer));
  const double in = (std::cos(inner) + tan_b * std::sin(inner)) / (1.0 - g * std::cos(inner));
  return {.ball = 1.0 / ((out + in) * g * std::cos(pitch_angle)), .cage = out / (out + in)};
}

TEST(Kinematics, ReducedFormsEqualTheGeneralFormula) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0.0, 60 * degree), ratio(0.05, 0.3);
  for (int k = 0; k < 1000; ++k) {
    const double inner = angle(random), outer = angle(random), g = ratio(random);
    const double speed = 1000.0;
    for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
      const BallSpeeds s = ball_speeds(control, inner, outer, g, speed);
      const GeneralSpeeds general = general_speeds(inner, outer, s.pitch_angle, g);
      expect_relative(s.ball_speed, general.ball * speed, 1e-12);
      expect_relative(s.cage_speed, general.cage * speed, 1e-12);
    }
  }
}

TEST(Kinematics, ABallWhoseAxisIsGivenRollsByTheGeneralFormula) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(0.0, 60 * degree), ratio(0.05, 0.3);
  for (int k = 0; k < 1000; ++k) {
    const double inner = angle(random), outer = angle(random), pitch = angle(random);
    const double g = ratio(random), speed = 1000.0, creep = 1e-3;
    const GivenRotation given{
        .cos_pitch = std::cos(pitch), .sin_pitch = std::sin(pitch), .creep = creep};
    const BallSpeeds s = ball_rotation(given, inner, outer, g, speed).speeds();
    const GeneralSpeeds general = general_speeds(inner, outer, pitch, g);
    expect_relative(s.ball_speed, general.ball * speed, 1e-12);
    expect_relative(s.cage_speed, (general.cage + creep) * speed, 1e-12);
    EXPECT_NEAR(s.pitch_angle, pitch, 1e-12);
  }
  // About the axis that a race would hold, the ball does what it does there.
  const BallSpeeds held = ball_speeds(RaceControl::outer, 0.5, 0.3, 0.14, 1000.0);
  const BallSpeeds same = ball_rotation(GivenRotation{.cos_pitch = std::cos(held.pitch_angle),
                                                      .sin_pitch = std::sin(held.pitch_angle)},
                                        0.5, 0.3, 0.14, 1000.0)
                              .speeds();
  EXPECT_NEAR(same.inner_spin_speed, held.inner_spin_speed, 1e-9);
  EXPECT_NEAR(same.outer_spin_speed, 0.0, 1e-9);
}

TEST(Kinematics, TheControllingRaceDoesNotSpin) {
  const BallSpeeds outer = ball_speeds(RaceControl::outer, 0.5, 0.3, 0.14, 1000.0);
  EXPECT_NEAR(outer.outer_spin_speed, 0.0, 1e-10);
  EXPECT_GT(outer.inner_spin_speed, 1.0);
  const BallSpeeds inner = ball_speeds(RaceControl::inner, 0.5, 0.3, 0.14, 1000.0);
  EXPECT_NEAR(inner.inner_spin_speed, 0.0, 1e-10);
  EXPECT_GT(inner.outer_spin_speed, 1.0);
}

// With one common normal the spins of both contacts add up to the ring's rotation about it.
TEST(Kinematics, AtEqualAnglesTheFreeRaceTakesAllTheSpin) {
  for (const double angle : {0.0, 0.2, 0.7}) {
    const double spin = 1000.0 * std::sin(angle);
    EXPECT_NEAR(ball_speeds(RaceControl::outer, angle, angle, 0.14, 1000.0).inner_spin_speed, spin,
                1e-9);
    EXPECT_NEAR(ball_speeds(RaceControl::inner, angle, angle, 0.14, 1000.0).outer_spin_speed, spin,
                1e-9);
  }
}

TEST(Kinematics, CageSpeedAtEqualAnglesIsTheTextbookFormula) {
  for (const auto& row : tests::reference_table("cage_speed.csv")) {
    SCOPED_TRACE(row.place());
    const double angle = row["contact_angle_deg"] * degree;
    const double g = row["ball_diameter_m"] / row["pitch_diameter_m"];
    for (const RaceControl control : {RaceControl::outer, RaceControl::inner}) {
      const double cage = ball_speeds(control, angle, angle, g, row["speed_rpm"] * rpm).cage_speed;
      // Printed with 8 digits, so the tolerance is that of the digits, not of the formula.
      EXPECT_NEAR(cage / rpm, row["cage_speed_rpm"], 0.5e-4);
      EXPECT_NEAR(cage / (2.0 * pi), row["outer_passage_per_ball_Hz"], 0.5e-6);
      expect_relative(cage / rpm, row["cage_speed_rpm"], 1.2e-8);
    }
  }
}

TEST(Kinematics, CageIsSlowerThanHalfTheShaft) {
  for (const RaceControl control : {RaceControl::outer, RaceControl::inner})
    EXPECT_LT(ball_speeds(control, 0.4, 0.4, 0.14, 1.0).cage_speed, 0.5);
}

}  // namespace
}  // namespace raceway::bearing

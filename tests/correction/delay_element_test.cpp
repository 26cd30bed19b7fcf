#include "correction/delay_element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "shaft/kinematic_law.h"
#include "tests/correction/reference.h"

namespace raceway::correction {
namespace {

constexpr double minute = 60.0;

/// Gain and time constant as [Brecher2021] prints them.
DelayElement published() {
  return {Characteristic::Line{0.4817 * um, 10.3617 * um},
          Characteristic::Line{-0.6298 * minute, 135.245 * minute}};
}

TEST(DelayElement, HasThePublishedGainsAndTimeConstants) {
  const auto known = reference("S0_K_T");
  const DelayElement element = published();
  const auto power = numbers(known["power_W"]);
  for (std::size_t k = 0; k < power.size(); ++k) {
    EXPECT_NEAR(element.target(power[k]) / um, known["K_um"][k].get<double>(), 1e-9);
    EXPECT_NEAR(element.time_constant(power[k]) / minute, known["T_min"][k].get<double>(), 1e-9);
  }
  EXPECT_NEAR(element.gain(0.0) / um, known["K_at_zero_um"].get<double>(), 1e-9);
  EXPECT_NEAR(element.domain().upper, known["power_limit_W"].get<double>(), 1e-8);
  EXPECT_DOUBLE_EQ(element.target(0.0), 0.0);
}

TEST(DelayElement, GoesOnFromWhereItIsWhenThePowerChanges) {
  const auto known = reference("S0_state_form_varying");
  std::vector<double> power = numbers(known["power_W"]);
  power.push_back(0.0);  // of the last row, which ends the last step
  Clock clock;
  for (std::size_t k = 0; k < power.size(); ++k) {
    clock.steps.push_back(k == 0 ? 0.0 : known["step_min"].get<double>() * minute);
    clock.begins.push_back(k == 0);
  }
  std::vector<double> displacement(power.size());
  delay_response(clock, power, published(), displacement);
  const auto expected = numbers(known["u_um"]);
  ASSERT_EQ(expected.size(), displacement.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(displacement[k] / um, expected[k], 1e-9) << k;
}

TEST(DelayElement, HasNoAnswerOnceThePowerHasLeftItsDomain) {
  Clock clock{.steps = {0, 60, 60, 60, 60}, .begins = {true, false, false, false, true}};
  const std::vector<double> power{100, 300, 100, 100, 100};
  std::vector<double> displacement(power.size());
  delay_response(clock, power, published(), displacement);
  EXPECT_GT(displacement[1], 0.0);
  EXPECT_TRUE(std::isnan(displacement[2]));
  EXPECT_TRUE(std::isnan(displacement[3])) << "a step within the domain does not heal it";
  EXPECT_DOUBLE_EQ(displacement[4], 0.0);
}

TEST(DelayElement, ALoadDrivesItBothWaysAndNoLoadDrivesNothing) {
  // K is 10 um at 1000 N and -8 um at -500 N; T 1200 s under tension, 600 s else.
  const DelayElement element{Characteristic::Table{{-500, 0, 1000}, {-8 * um, 3 * um, 10 * um}},
                             Characteristic::Table{{-500, 0, 1000}, {600, 600, 1200}}, true};
  EXPECT_TRUE(std::isinf(element.domain().lower));
  const Clock clock{.steps = {0, 900, 900, 900}, .begins = {true, false, false, false}};
  std::vector<double> u(4);
  delay_response(clock, std::vector<double>{1000, -500, 0, 0}, element, u);
  const double loaded = -10 * std::expm1(-900.0 / 1200);
  const double turned = -8 + (loaded + 8) * std::exp(-1.5);
  EXPECT_NEAR(u[1] / um, loaded, 1e-12);
  EXPECT_NEAR(u[2] / um, turned, 1e-12);
  EXPECT_NEAR(u[3] / um, turned * std::exp(-1.5), 1e-12) << "K(0) = 0 whatever the table says";
}

TEST(DelayElement, TakesWhatItsTimeConstantIsPositiveFor) {
  const Characteristic gain = Characteristic::Line{1e-9, 0.0};
  const DelayElement rising{gain, Characteristic::Line{2.0, 600}, true};
  EXPECT_NEAR(rising.domain().lower, -300, 1e-9);
  EXPECT_GT(rising.time_constant(rising.domain().lower), 0.0);
  EXPECT_TRUE(std::isinf(rising.domain().upper));
  const DelayElement between{gain, Characteristic::Table{{-200, 0, 300}, {-100, 100, -50}}, true};
  EXPECT_NEAR(between.domain().lower, -100, 1e-9);
  EXPECT_NEAR(between.domain().upper, 200, 1e-9);
  EXPECT_EQ((DelayElement{gain, Characteristic::Power{600, -0.2}, true}.domain().lower), 0.0);
  EXPECT_EQ((DelayElement{Characteristic::Power{1e-9, 1.1}, Characteristic::Line{0, 600}, true}
                 .domain()
                 .lower),
            0.0);
  EXPECT_EQ((DelayElement{gain, Characteristic::Line{2.0, 600}}.domain().lower), 0.0);
  Clock clock{.steps = {0, 60, 60}, .begins = {true, false, false}};
  std::vector<double> u(3);
  delay_response(clock, std::vector<double>{-299, -301, 0}, rising, u);
  EXPECT_TRUE(std::isfinite(u[1]));
  EXPECT_TRUE(std::isnan(u[2]));
}

TEST(Characteristic, IsStraightBetweenThePointsOfATable) {
  const Characteristic table(Characteristic::Table{{10, 20, 40}, {1, 3, -1}});
  EXPECT_DOUBLE_EQ(table(5), 1.0);
  EXPECT_DOUBLE_EQ(table(15), 2.0);
  EXPECT_DOUBLE_EQ(table(30), 1.0);
  EXPECT_DOUBLE_EQ(table(90), -1.0);
  EXPECT_DOUBLE_EQ(table.positive_within().upper, 35.0);
  EXPECT_TRUE(std::isinf(Characteristic(Characteristic::Power{2.0, 0.5}).positive_within().upper));
  EXPECT_DOUBLE_EQ(Characteristic(Characteristic::Power{2.0, 0.5})(9.0), 6.0);
}

TEST(Characteristic, RefusesATableThatIsNoFunction) {
  EXPECT_THROW(Characteristic(Characteristic::Table{{10, 10}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(Characteristic(Characteristic::Table{{10, 20}, {1}}), std::invalid_argument);
  EXPECT_THROW(Characteristic(Characteristic::Table{{}, {}}), std::invalid_argument);
}

TEST(KinematicPart, HasThePublishedValues) {
  const auto known = reference("S0_kinematic");
  const auto speed = numbers(known["speed_rpm"]);
  for (std::size_t k = 0; k < speed.size(); ++k)
    EXPECT_NEAR(shaft::kinematic_displacement_um(speed[k], 1.28e-3, 0.697, 5.3e-4),
                known["u_um"][k].get<double>(), 1e-9);
}

}  // namespace
}  // namespace raceway::correction

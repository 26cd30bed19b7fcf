#include "rig/torque_sensor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rig/sensor_calibration.h"

namespace raceway::rig {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TorqueSensor sensor(std::initializer_list<double> coefficients) {
  TorqueSensor s;
  const auto size = static_cast<Eigen::Index>(coefficients.size());
  s.coefficients = Eigen::Map<const Eigen::VectorXd>(coefficients.begin(), size);
  s.covariance = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) s.covariance(k, k) = 1e-6 * std::pow(0.1, k);
  s.scatter = 2e-3;
  s.lowest_torque = 0.0;
  s.highest_torque = 10.0;
  s.lowest_signal = s.coefficients[0];
  s.highest_signal = signal_at(s, 10.0);
  return s;
}

const TorqueSensor line = sensor({0.1, 0.5});
const TorqueSensor cubic = sensor({0.1, 0.5, -0.02, 0.001});
const TorqueSensor falling = sensor({4.0, -0.5, 0.01});

TEST(TorqueSensor, TheTorqueOfASignalHasThatSignal) {
  for (const TorqueSensor& s : {line, cubic, falling})
    for (double m = -3.0; m < 14.0; m += 0.25)
      EXPECT_NEAR(torque_of(s, signal_at(s, m)).torque, m, 1e-12);
}

TEST(TorqueSensor, GoesOnAlongTheTangentBeyondItsCalibration) {
  const double slope = (signal_at(cubic, 10.0 + 1e-6) - signal_at(cubic, 10.0)) / 1e-6;
  EXPECT_NEAR(slope, 0.5 - 0.4 + 0.3, 1e-6);
  EXPECT_NEAR(signal_at(cubic, 30.0), signal_at(cubic, 10.0) + 20.0 * slope, 1e-4);
}

// ∂M/∂b and ∂M/∂V by differences, inside and on both tangents.
TEST(TorqueSensor, StandardDeviationsAreThoseOfTheDifferenceQuotients) {
  for (const double zero : {unset, 0.13})
    for (TorqueSensor s : {line, cubic})
      for (const double signal : {-0.4, 0.3, 1.7, 6.0}) {
        if (!std::isnan(zero)) s.zero = zero;
        double variance = 0.0;
        for (Eigen::Index k = 0; k < s.coefficients.size(); ++k) {
          const double h = 1e-6;
          TorqueSensor up = s, down = s;
          up.coefficients[k] += h;
          down.coefficients[k] -= h;
          const double g =
              (torque_of(up, signal).torque - torque_of(down, signal).torque) / (2 * h);
          variance += g * g * s.covariance(k, k);
        }
        const double h = 1e-6,
                     slope = (torque_of(s, signal + h).torque - torque_of(s, signal - h).torque) /
                             (2 * h);
        if (s.zero) variance += std::pow(slope * s.scatter, 2);  // read once
        const SensedTorque m = torque_of(s, signal);
        EXPECT_NEAR(m.common, std::sqrt(variance), 1e-6 * m.common);
        EXPECT_NEAR(m.std, std::hypot(m.common, slope * s.scatter), 1e-6 * m.std);
        EXPECT_NEAR(torque_of(s, signal, 0.01).std, std::hypot(m.common, slope * 0.01),
                    1e-6 * m.std);
      }
}

TEST(TorqueSensor, AZeroOfTheDayShiftsTheSignalAndNotTheGain) {
  TorqueSensor tared = line;
  tared.zero = 0.15;
  tared.zero_std = 0.0;
  EXPECT_NEAR(torque_of(tared, 0.15).torque, 0.0, 1e-12);
  EXPECT_NEAR(torque_of(tared, 2.65).torque, 5.0, 1e-12);
  EXPECT_NEAR(torque_of(tared, 0.15).common, 0.0, 1e-12);  // whatever the zero of the calibration
}

// The error of a reading, scatter and calibration, is what std says; what all readings of one
// calibration have in common is what `common` says.
TEST(TorqueSensor, ErrorsOfManyCalibrationsAreThoseThatItStates) {
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.02);
  const auto curve = [](double m) { return 0.1 + 0.5 * m - 0.01 * m * m; };
  constexpr int draws = 2000;
  double square = 0.0, common_square = 0.0, stated = 0.0, common = 0.0;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<SensorReading> readings;
    for (int k = 0; k <= 10; ++k) readings.push_back({1.0 * k, curve(k) + noise(random), k});
    const TorqueSensor s = calibrate_sensor(readings, 2).sensor;
    const SensedTorque one = torque_of(s, curve(9.0) + noise(random));
    square += std::pow(one.torque - 9.0, 2) / draws;
    common_square += std::pow(torque_of(s, curve(9.0)).torque - 9.0, 2) / draws;
    stated += one.std * one.std / draws;
    common += one.common * one.common / draws;
  }
  // 2000 draws know a standard deviation to 1.6 %; the inverse is linearised.
  EXPECT_NEAR(std::sqrt(stated / square), 1.0, 0.06);
  EXPECT_NEAR(std::sqrt(common / common_square), 1.0, 0.06);
}

TEST(TorqueSensor, ASignalThatTurnsHasNoTorque) {
  EXPECT_FALSE(turning_torque(line.coefficients, 0, 10));
  EXPECT_FALSE(turning_torque(cubic.coefficients, -5, 20));
  const auto turn = [](std::initializer_list<double> b) {
    return turning_torque(sensor(b).coefficients, 0.0, 10.0);
  };
  EXPECT_NEAR(turn({0, 1, -0.1}).value(), 5.0, 1e-9);
  // Falls between 2 and 4 alone: the ends of the range both rise.
  EXPECT_NEAR(turn({0, 8, -3, 1.0 / 3}).value(), 2.0, 1e-9);
  EXPECT_TRUE(turn({1, 0}));
}

TEST(SensedTorques, NameTheSignalsThatNoWeightHasMade) {
  const std::vector<double> signals{0.05, 0.6, 5.2, 5.3};
  const std::vector<int> lines{2, 3, 4, 5};
  const SensedTorques sensed = sensed_torques(line, signals, {}, lines);
  EXPECT_THAT(sensed.torque, testing::Pointwise(testing::DoubleNear(1e-12),
                                                std::vector<double>{-0.1, 1.0, 10.2, 10.4}));
  EXPECT_THAT(texts(sensed.notes),
              Contains(HasSubstr("signals outside the calibrated range of 0.1 to 5.1 V: 3 of 4, "
                                 "down to 0.05 and up to 5.3 V (lines 2, 4, 5)")));
  const SensedTorques inside = sensed_torques(line, std::vector<double>{0.1, 5.1}, {}, lines);
  EXPECT_THAT(texts(inside.notes), Not(Contains(HasSubstr("outside"))));
}

TEST(SensedTorques, OfASensorWithoutScatterHaveNoStandardDeviation) {
  TorqueSensor exact = line;
  exact.covariance.setZero();
  exact.scatter = 0.0;
  const SensedTorques sensed =
      sensed_torques(exact, std::vector<double>{0.6}, {}, std::vector<int>{2});
  EXPECT_THAT(sensed.std, IsEmpty());
  EXPECT_THAT(texts(sensed.notes),
              Contains(HasSubstr("the readings of the calibration have no scatter")));
}

}  // namespace
}  // namespace raceway::rig

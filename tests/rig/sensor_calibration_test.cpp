// Certified regressions of NIST, and sensors whose curve is known.
#include "rig/sensor_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/reference_table.h"

namespace raceway::rig {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<SensorReading> published(const std::string& file) {
  std::vector<SensorReading> readings;
  for (const tests::ReferenceRow& row : tests::reference_table(file))
    readings.push_back({row["reference_Nm"], row["signal_V"], static_cast<int>(readings.size())});
  return readings;
}

/// 0 to 10 N m and back, `cycles` times.
std::vector<double> up_and_down(int cycles) {
  std::vector<double> torques;
  for (int c = 0; c < cycles; ++c) {
    for (int k = 0; k <= 10; ++k) torques.push_back(k);
    for (int k = 9; k >= 0; --k) torques.push_back(k);
  }
  return torques;
}

template <typename Signal>
std::vector<SensorReading> readings(const std::vector<double>& torques, const Signal& signal) {
  std::vector<SensorReading> list;
  for (std::size_t i = 0; i < torques.size(); ++i)
    list.push_back({torques[i], signal(torques[i], i), static_cast<int>(i) + 2});
  return list;
}

std::string refusal(const std::vector<SensorReading>& list, std::optional<int> degree = {}) {
  try {
    (void)calibrate_sensor(list, degree);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "(taken)";
}

// Certified to 15 digits; what is lost is the condition of the powers of M, 1e3 on a scaled torque.
constexpr double certified = 1e-10;

void expect_near(double value, double reference, double relative) {
  EXPECT_NEAR(value, reference, relative * std::abs(reference));
}

TEST(SensorCalibration, OfALoadCellHasTheNumbersCertifiedByNist) {
  const SensorCalibration c = calibrate_sensor(published("nist_pontius.csv"), 2);
  const double b[] = {0.673565789473684e-3, 0.732059160401003e-6, -0.316081871345029e-14};
  const double std[] = {0.107938612033077e-3, 0.157817399981659e-9, 0.486652849992036e-16};
  for (int k = 0; k < 3; ++k) {
    expect_near(c.sensor.coefficients[k], b[k], certified);
    expect_near(c.std(k), std[k], certified);
  }
  expect_near(c.sensor.scatter, 0.205177424076185e-3, certified);
  EXPECT_EQ(c.degrees_of_freedom, 37);
  EXPECT_EQ(c.torques, 20);
  EXPECT_GT(c.lack_of_fit.p_value, 0.5);
}

TEST(SensorCalibration, OfAnOzoneMonitorHasTheNumbersCertifiedByNist) {
  const SensorCalibration c = calibrate_sensor(published("nist_norris.csv"));
  EXPECT_EQ(c.degree(), 1);
  expect_near(c.sensor.coefficients[0], -0.262323073774029, certified);
  expect_near(c.sensor.coefficients[1], 1.00211681802045, certified);
  expect_near(c.sensor.scatter, 0.884796396144373, certified);
}

// Computed in single precision there: rounding of 1e-7 of the deflections, which range over 2,
// moves residuals of 2e-3 in the fifth digit.
TEST(SensorCalibration, LackOfFitOfALineThroughTheLoadCellIsThatOfTheHandbook) {
  const SensorCalibration c = calibrate_sensor(published("nist_pontius.csv"), 1);
  expect_near(c.sensor.coefficients[0], 0.614969e-2, 1e-5);
  expect_near(c.sensor.coefficients[1], 0.722103e-6, 1e-5);
  expect_near(c.sensor.scatter, 0.0021712694, 1e-5);
  expect_near(c.std(0), 0.7132e-3, 1e-4);
  expect_near(c.std(1), 0.3969e-9, 1e-4);
  expect_near(c.lack_of_fit.statistic, 214.7464, 1e-5);
  expect_near(c.lack_of_fit.statistic, 214.74692365390877, certified);  // in exact fractions
  EXPECT_EQ(c.lack_of_fit.degrees, 18);
  EXPECT_EQ(c.lack_of_fit.error_degrees, 20);
  EXPECT_LT(c.lack_of_fit.p_value, 1e-12);
  EXPECT_THAT(texts(c.warnings), Contains(HasSubstr("use --degree 2")));
}

TEST(SensorCalibration, TakesTheLowestDegreeThatTheReadingsFollow) {
  EXPECT_EQ(calibrate_sensor(published("nist_pontius.csv")).degree(), 2);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1e-3);
  for (const int degree : {1, 2, 3}) {
    const auto list = readings(up_and_down(1), [&](double m, std::size_t) {
      const double x = m / 10.0;
      return 0.1 + x + (degree > 1 ? 0.05 * x * x : 0.0) + (degree > 2 ? 0.1 * x * x * x : 0.0) +
             noise(random);
    });
    EXPECT_EQ(calibrate_sensor(list).degree(), degree);
  }
}

// A line over exact torques is unbiased however the signal scatters; a fit of the torque over the
// signal would be flatter by a tenth here.
TEST(SensorCalibration, ScatterOfTheSignalDoesNotFlattenTheCurve) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1.0);
  double gain = 0.0;
  constexpr int draws = 400;
  for (int draw = 0; draw < draws; ++draw)
    gain +=
        calibrate_sensor(
            readings(up_and_down(2), [&](double m, std::size_t) { return m + noise(random); }), 1)
            .sensor.coefficients[1] /
        draws;
  EXPECT_NEAR(gain, 1.0, 4.0 * 0.05 / std::sqrt(draws));
}

// Chance brings each of them once in a hundred calibrations without such a fault: 500 draws have 5,
// and more than 14 once in 3000 such tests.
TEST(SensorCalibration, SoundSensorsAreRarelySuspected) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 2e-3);
  int curved = 0, off = 0, hysteresis = 0, uneven = 0, warned = 0;
  for (int draw = 0; draw < 500; ++draw) {
    const SensorCalibration c = calibrate_sensor(readings(
        up_and_down(2), [&](double m, std::size_t) { return 0.03 + 0.5 * m + noise(random); }));
    curved += c.degree() > 1;
    off += c.lack_of_fit.p_value < sensor_significance;
    hysteresis += c.hysteresis.p_value < sensor_significance;
    uneven += c.even_scatter_p_value < sensor_significance;
    warned += !c.warnings.empty();
  }
  EXPECT_LE(curved, 14);
  EXPECT_LE(off, 14);
  EXPECT_LE(hysteresis, 14);
  EXPECT_LE(uneven, 14);
  EXPECT_LE(warned, 40);
  EXPECT_GE(curved + off + hysteresis + uneven, 5);
}

TEST(SensorCalibration, StandardErrorsAreTheScatterOfManyCalibrations) {
  std::mt19937 random(5);
  std::normal_distribution<double> even(0.0, 1.0);
  for (const bool grows : {false, true}) {
    double mean_square[] = {0.0, 0.0}, stated[] = {0.0, 0.0};
    constexpr int draws = 1000;
    for (int draw = 0; draw < draws; ++draw) {
      const SensorCalibration c =
          calibrate_sensor(readings(up_and_down(3),
                                    [&](double m, std::size_t) {
                                      return 0.1 + m + (grows ? 0.003 * m : 0.01) * even(random);
                                    }),
                           1);
      for (int k = 0; k < 2; ++k) {
        mean_square[k] += std::pow(c.sensor.coefficients[k] - (k == 0 ? 0.1 : 1.0), 2) / draws;
        stated[k] += std::pow(c.std(k), 2) / draws;
      }
    }
    // 1000 draws know a variance to 4.5 %; what uneven scatter is not found adds a little.
    for (int k = 0; k < 2; ++k)
      EXPECT_NEAR(std::sqrt(stated[k] / mean_square[k]), 1.0, 0.1)
          << "b" << k << " grows " << grows;
  }
}

TEST(SensorCalibration, HysteresisIsFoundAtItsSizeAndPlace) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::vector<double> torques = up_and_down(2);
  const SensorCalibration c = calibrate_sensor(readings(torques, [&](double m, std::size_t i) {
    const bool falling = i > 0 && torques[i] < torques[i - 1];
    return 0.5 * m + (falling ? 1 : -1) * 0.01 * 4.0 * m / 10 * (1.0 - m / 10) + noise(random);
  }));
  EXPECT_EQ(c.hysteresis.torques, 9);
  EXPECT_LT(c.hysteresis.p_value, 1e-3);
  EXPECT_NEAR(c.hysteresis.largest, 0.02, 3e-3);  // three standard errors
  EXPECT_NEAR(c.hysteresis.largest_at, 5.0, 1.5);
  EXPECT_THAT(texts(c.warnings),
              Contains(HasSubstr("hysteresis: the signal at falling torque differs")));
}

TEST(SensorCalibration, SaysWhatItCouldNotLookFor) {
  const SensorCalibration c = calibrate_sensor(
      readings({0, 1, 2, 3, 4}, [](double m, std::size_t i) { return m + (i % 2 ? 1e-3 : 0.0); }));
  EXPECT_TRUE(std::isnan(c.lack_of_fit.statistic));
  EXPECT_EQ(c.hysteresis.torques, 0);
  EXPECT_THAT(texts(c.notes), Contains(HasSubstr("no torque was read twice")));
  EXPECT_THAT(texts(c.notes), Contains(HasSubstr("so the hysteresis is unknown")));
}

TEST(SensorCalibration, AMistypedWeightIsNamedByItsLine) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 1e-3);
  auto list = readings(up_and_down(1), [&](double m, std::size_t) { return m + noise(random); });
  list[4].signal += 0.1;
  const SensorCalibration c = calibrate_sensor(list, 1);
  EXPECT_THAT(texts(c.warnings), Contains(HasSubstr("line 6: 4.1")));
}

TEST(SensorCalibration, RowsAlikeToTheLastDigitAreCounted) {
  auto list = readings({0, 1, 2, 3, 4, 2, 1}, [](double m, std::size_t i) {
    return 0.5 * m + 1e-3 * static_cast<double>(i * i % 11);
  });
  list[6].signal = list[1].signal;
  EXPECT_THAT(texts(calibrate_sensor(list).notes),
              Contains(HasSubstr("1 reading has the same torque and signal as another one")));
}

TEST(SensorCalibration, ManySamplesOfACoarseSignalAreCountedAndNotListed) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 2e-3);
  std::vector<double> torques;
  for (int k = 0; k <= 10; ++k) torques.insert(torques.end(), 2000, k);
  auto list = readings(torques, [&](double m, std::size_t) {
    return std::round((0.5 * m + noise(random)) * 1e3) / 1e3;
  });
  for (std::size_t i = 0; i < 20; ++i) list[2000 * 5 + i].signal += 1.0;
  const SensorCalibration c = calibrate_sensor(list, 1);
  EXPECT_THAT(texts(c.notes), Contains(HasSubstr(", ...): they are treated as repeated readings")));
  EXPECT_THAT(texts(c.warnings),
              Contains(HasSubstr("further readings that are too far off the curve: 15")));
}

TEST(SensorCalibration, WithoutScatterTellsOfNone) {
  const SensorCalibration c = calibrate_sensor(
      readings(up_and_down(1), [](double m, std::size_t) { return 0.25 + 0.5 * m; }));
  EXPECT_EQ(c.degree(), 1);
  EXPECT_EQ(c.sensor.scatter, 0.0);
  EXPECT_EQ(c.std(1), 0.0);
  EXPECT_THAT(texts(c.warnings), IsEmpty());
}

TEST(SensorCalibration, AFallingSignalIsASensorToo) {
  const SensorCalibration c = calibrate_sensor(readings(
      up_and_down(1), [](double m, std::size_t i) { return 5.0 - 0.5 * m + 1e-3 * (i % 3 == 0); }));
  EXPECT_LT(c.sensor.coefficients[1], 0.0);
  EXPECT_NEAR(torque_of(c.sensor, 2.5).torque, 5.0, 1e-2);
}

TEST(SensorCalibration, RefusesWhatIsNoCalibration) {
  const auto line = [](double m, std::size_t) { return m; };
  EXPECT_THAT(refusal(readings({3, 3, 3, 3}, line)),
              HasSubstr("all 4 readings are at one reference torque, 3 N m"));
  EXPECT_THAT(
      refusal(readings({0, 1}, line)),
      HasSubstr(
          "2 readings at 2 reference torques: a line needs at least 3 readings at 2 torques"));
  EXPECT_THAT(refusal(readings({0, 1, 2, 3}, line), 3),
              HasSubstr("a cubic needs at least 5 readings at 4 torques"));
  EXPECT_THAT(refusal(readings({0, 1, 2, 3, 4}, line), 4), HasSubstr("must be from 1 to 3"));
  EXPECT_THAT(refusal({}), HasSubstr("no readings"));
  const std::vector<double> tiny{0, 1e-310, 2e-310, 3e-310, 4e-310};
  EXPECT_THAT(refusal(readings(tiny, [](double, std::size_t i) { return static_cast<double>(i); })),
              HasSubstr("cannot fit a curve"));
}

TEST(SensorCalibration, RefusesASignalThatTurns) {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, 1e-3);
  const auto turning = [&](double m, std::size_t) {
    return m - 0.08 * m * m + noise(random);  // highest at 6.25 N m
  };
  const auto list = readings(up_and_down(1), turning);
  for (const std::optional<int> degree : {std::optional<int>(), std::optional(1)})
    EXPECT_THAT(refusal(list, degree), HasSubstr("the curve has a maximum or minimum at 6.2"));
}

TEST(SensorCalibration, RefusesASignalThatIsNoneOfTheTorque) {
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, 1.0);
  EXPECT_THAT(refusal(readings(up_and_down(1), [&](double, std::size_t) { return noise(random); })),
              HasSubstr("the signal does not follow the reference torque"));
}

}  // namespace
}  // namespace raceway::rig

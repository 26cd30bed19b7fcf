#include "fit/noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>

#include "fit/noise_model.h"
#include "record/repeats.h"
#include "record/series_channel.h"
#include "tests/support/rows.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

/// Readings of a machine that warms up by 20 um in an hour, in stops of `approaches` every 5 min, 8
/// s apart, of a sensor of 0.3 um.
record::Record stops_of(int approaches, double last_hours = 0.0) {
  const record::Channel& z = *record::series_channel("displacement_z_um");
  std::vector<double> time, values;
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 0.3 * um);
  for (int stop = 0; stop < 60; ++stop)
    for (int k = 0; k < approaches; ++k) {
      const double t = 300.0 * stop + 8.0 * k;
      const double until = last_hours > 0.0 ? std::min(t, last_hours * 3600.0) : t;
      time.push_back(t);
      values.push_back(20.0 * um * -std::expm1(-until / 3600.0) + noise(engine));
    }
  record::Record record{.source = "stops.csv"};
  record.set(record::time, time);
  record.set(z, values);
  return record;
}

const record::Channel& z_of_stops() { return *record::series_channel("displacement_z_um"); }

TEST(Repeatability, OfFiveApproachesInAStopIsThatOfTheSensor) {
  const Repeatability five = repeatability(stops_of(5), z_of_stops());
  ASSERT_EQ(five.stops.size(), 60u);
  EXPECT_EQ(five.stops.front().readings, 5);
  EXPECT_EQ(five.degrees_of_freedom, 60 * 3);  // a line is taken off each
  EXPECT_NEAR(five.std / um, 0.3, 0.05);
  EXPECT_NEAR(five.stops.back().mean / um, 20.0 * -std::expm1(-17716.0 / 3600.0), 0.5);
  EXPECT_EQ(noise_of_neighbours(stops_of(5), z_of_stops()), five.std);
  // Of pairs the machine may move a little meanwhile.
  const Repeatability two = repeatability(stops_of(2), z_of_stops());
  EXPECT_EQ(two.degrees_of_freedom, 60);
  EXPECT_NEAR(two.std / um, 0.3, 0.08);
}

TEST(Repeatability, IsNotKnownWhereNothingWasRepeated) {
  EXPECT_FALSE(repeatability(stops_of(1), z_of_stops()).known());
  EXPECT_TRUE(std::isnan(noise_of_neighbours(stops_of(1), z_of_stops())));
  // A dense record with a few breaks has no stops.
  record::Record dense{.source = "dense.csv"};
  std::vector<double> time, values;
  for (int k = 0; k < 300; ++k) {
    time.push_back(10.0 * k + 500.0 * (k / 100));
    values.push_back(1e-6 * k);
  }
  dense.set(record::time, time);
  dense.set(z_of_stops(), values);
  EXPECT_FALSE(repeatability(dense, z_of_stops()).known());
}

/// A third of the time the machine stands still.
TEST(Repeatability, SingleReadingsAtStopsBoundTheNoise) {
  const double bound = noise_of_calm_readings(stops_of(1, 3.3), z_of_stops());
  EXPECT_GT(bound / um, 0.2);
  EXPECT_LT(bound / um, 0.6);
}

TEST(Repeats, AreFoundWhereverTheyStandInTheFile) {
  const DataSet data = factorial_plan({1000, 5000}, {300, 600}, {40}, 3);
  const std::vector<record::RepeatGroup> groups = record::find_repeats(data);
  ASSERT_EQ(groups.size(), 4U);
  for (const record::RepeatGroup& group : groups) {
    ASSERT_EQ(group.size(), 3U);
    for (const std::size_t i : group) {
      EXPECT_EQ(data.rows[i].point.speed, data.rows[group[0]].point.speed);
      EXPECT_EQ(data.rows[i].point.axial_load, data.rows[group[0]].point.axial_load);
    }
  }
}

TEST(Repeats, AllowForTheScatterOfASetValueOnly) {
  DataSet data = factorial_plan({5000, 5002, 5050}, {300, 310}, {40});
  EXPECT_EQ(record::find_repeats(data).size(), 2U);  // 5000 and 5002 at either load
  data.rows[1].point.temperature += 1.0;
  EXPECT_EQ(record::find_repeats(data).size(), 1U);
  data.rows[4].inner_ring_temperature = kelvin(45.0);
  EXPECT_TRUE(record::find_repeats(data).empty());
}

TEST(Noise, OfRepeatsIsTheirScatter) {
  std::mt19937 random(3);
  DataSet data = factorial_plan({1000, 2000, 5000, 8000, 10000}, {300, 600, 900}, {30, 50}, 10);
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  const Noise noise = estimate_noise(data, data.measured());
  EXPECT_EQ(noise.source, NoiseSource::repeats);
  EXPECT_EQ(noise.degrees_of_freedom, 270);
  EXPECT_NEAR(noise.rms, 2.0 * N_mm, 0.2 * N_mm);  // 2.3 standard deviations at 270 degrees
}

TEST(Noise, ThatIsDeclaredComesFirst) {
  std::mt19937 random(4);
  DataSet data = factorial_plan({1000, 5000}, {300, 600}, {40}, 3);
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  declare_noise(1.5 * N_mm, data);
  EXPECT_EQ(estimate_noise(data, data.measured()).source, NoiseSource::declared);
  EXPECT_DOUBLE_EQ(estimate_noise(data, data.measured()).rms, 1.5 * N_mm);
  data.noise = NoiseSource::regression;
  EXPECT_EQ(name(estimate_noise(data, data.measured()).source), "regression");
  data.rows[0].std = unset;  // one row without: the declared values do not cover the set
  EXPECT_EQ(estimate_noise(data, data.measured()).source, NoiseSource::repeats);
}

TEST(Noise, IsUnknownWithoutStdAndRepeats) {
  std::mt19937 random(5);
  DataSet data = factorial_plan({1000, 3000, 5000}, {300}, {40});
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  const Noise noise = estimate_noise(data, data.measured());
  EXPECT_EQ(noise.source, NoiseSource::none);
  EXPECT_TRUE(std::isnan(noise.rms));
}

TEST(Noise, CountsTheCoarsenessOfAModel) {
  std::mt19937 random(6);
  DataSet data = factorial_plan({1000, 3000, 5000}, {300}, {40});
  measure(synthetic_model(), 0.0, random, data);
  declare_noise(3.0 * N_mm, data);
  const Record record = data;
  const std::vector<Measured> channels{{.channel = &data.measured()}};
  const ChannelReadings readings =
      readings_of(record, observe(channels, record, record.values(data.measured())), 0);
  NoiseModel noise = known_noise_model(readings);
  add_model_error(noise, readings, 4.0 * N_mm);
  EXPECT_NEAR(noise.rms, 5.0 * N_mm, 1e-12);
  EXPECT_NEAR(noise.whitening.std()[1], 5.0 * N_mm, 1e-12);
}

/// Noise of 9 speeds x 4 loads, twice, whose scatter `share(speed)` is one of the torque.
template <typename Share>
NoiseModel noise_of_stairs(unsigned seed, const Share& share, std::vector<std::size_t> far = {}) {
  DataSet data = factorial_plan({600, 900, 1360, 2060, 3100, 4670, 7040, 10610, 16000},
                                {250, 570, 1310, 3000}, {40}, 2);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  measure(synthetic_model(), 0.0, random, data);
  Eigen::VectorXd truth(static_cast<Eigen::Index>(data.rows.size()));
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    Row& row = data.rows[i];
    truth[static_cast<Eigen::Index>(i)] = row.measured;
    row.measured *= 1.0 + share(row.point.speed / rpm) * normal(random);
  }
  for (const std::size_t i : far) data.rows[i].measured *= 1.3;
  const Record record = data;
  const std::vector<Measured> channels{{.channel = &data.measured()}};
  const ChannelReadings readings =
      readings_of(record, observe(channels, record, record.values(data.measured())), 0);
  return estimate_noise_model(readings, truth, truth);
}

/// -2 ln of the restricted likelihood of independent readings, up to a constant.
double restricted_misfit(const Eigen::VectorXd& variance, const Eigen::MatrixXd& x,
                         const Eigen::VectorXd& y) {
  const Eigen::VectorXd weight = variance.cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> gram(x.transpose() * weight.asDiagonal() * x);
  const Eigen::VectorXd rest =
      y - x * gram.solve(Eigen::VectorXd(x.transpose() * weight.cwiseProduct(y)));
  return static_cast<double>(x.rows() - x.cols()) * std::log(weight.dot(rest.cwiseAbs2())) +
         variance.array().log().sum() +
         2.0 * Eigen::MatrixXd(gram.matrixL()).diagonal().array().log().sum();
}

/// Shares of the variance: in proportion to the reading, from the scatter of an input, and the
/// rest.
struct NoiseParts {
  double relative, input;
  [[nodiscard]] double absolute() const { return std::max(0.0, 1.0 - relative - input); }
};

/// The search leaves most shares out. It must not leave out better ones.
TEST(Noise, HasThePartsThatAreBestOfAll) {
  constexpr Eigen::Index rows = 90, columns = 8;
  const Eigen::ArrayXd u = Eigen::ArrayXd::LinSpaced(rows, -1.0, 1.0);
  const Eigen::VectorXd size = (1.5 * u).exp();
  Eigen::MatrixXd x(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    x.col(k) = (size.array() * (0.5 * pi * static_cast<double>(k) * (u + 1.0)).cos()).matrix();
  ChannelReadings readings{.slope = (1.2 + (9.0 * u).sin()).matrix()};
  readings.slope /= rms(readings.slope);
  readings.order.step.assign(rows, std::numeric_limits<double>::infinity());
  readings.order.new_run.assign(rows, false);
  const NoiseOptions only_parts{
      .correlation = false, .runs = false, .outliers = false, .growth = false};
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (const NoiseParts& truth : {NoiseParts{1.0, 0.0}, {0.9, 0.0}, {0.4, 0.0}, {0.3, 0.6}})
    for (int sample = 0; sample < 10; ++sample) {
      const Eigen::ArrayXd variance = truth.relative * (size / rms(size)).array().square() +
                                      truth.absolute() +
                                      truth.input * readings.slope.array().square();
      readings.measured = size;
      for (Eigen::Index i = 0; i < rows; ++i)
        readings.measured[i] += 0.01 * std::sqrt(variance[i]) * normal(random);
      const NoiseModel noise = estimate_noise_model(readings, x, size, only_parts);
      const double all = noise.rms * noise.rms;
      const auto value = [&](const NoiseParts& s) {
        const Eigen::ArrayXd square = s.relative * (size / rms(size)).array().square() +
                                      s.absolute() + s.input * readings.slope.array().square();
        const int parts = (s.relative > 0.0) + (s.input > 0.0) + (s.absolute() > 1e-12);
        return restricted_misfit(square.matrix(), x, readings.measured) + parts +
               (s.input > 0.0 ? 3.84 : 0.0);
      };
      double best = std::numeric_limits<double>::infinity();
      for (const double input : {0.0, 0.1, 0.25, 0.45, 0.7, 0.9})
        for (const double s : {1.0, 0.998, 0.99, 0.97, 0.93, 0.85, 0.7, 0.5, 0.25, 0.1, 0.0})
          best = std::min(best, value({s * (1.0 - input), input}));
      const double input = std::pow(noise.input, 2) / all;
      const double absolute = std::pow(noise.absolute, 2) / all;
      // The search takes the sizes of the fitted readings, which are 1 % off.
      EXPECT_LT(value({1.0 - input - absolute, input}), best + 0.1) << truth.relative;
    }
}

TEST(Noise, GrowsWithTheSpeedThatIsSwept) {
  // 0.5 to 5 %, a power of 0.70: ten draws of 71 degrees of freedom each, one of which tells the
  // power to 0.08, their mean to 0.025; the steps of the search are 0.15 to 0.2.
  double power = 0.0, top = 0.0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const NoiseModel noise = noise_of_stairs(seed, [](double n) {
      return 0.05 * std::pow(n / 16000.0, std::log(10.0) / std::log(16000.0 / 600.0));
    });
    ASSERT_NE(noise.swept, nullptr);
    EXPECT_EQ(noise.swept->name, record::speed.name);
    EXPECT_TRUE(noise.outliers.empty()) << seed;
    power += noise.growth / 10;
    top += noise.relative / 10;
  }
  EXPECT_NEAR(power, 0.70, 0.1);
  EXPECT_NEAR(top, 0.05, 0.01);
}

TEST(Noise, ThatIsOneShareOfTheReadingDoesNotGrow) {
  int grows = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
    grows += noise_of_stairs(seed, [](double) { return 0.02; }).growth > 0.0 ? 1 : 0;
  EXPECT_LE(grows, 3);  // 1 in 200 of one parameter that cannot be negative; 4 of 40 in 1 of 10^5
}

TEST(Noise, OutliersDoNotMakeItGrow) {
  // Two readings at two speeds, 15 standard deviations off, in data that scatter by 2 %.
  const NoiseModel noise = noise_of_stairs(7, [](double) { return 0.02; }, {7, 33});
  EXPECT_EQ(noise.growth, 0.0);
  EXPECT_THAT(noise.outliers, testing::ElementsAre(7, 33));
}

TEST(Noise, WhatGathersAtOneLevelIsNoOutlier) {
  // A resonance: the rows of one speed scatter eight times as much.
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const NoiseModel noise =
        noise_of_stairs(seed, [](double n) { return n == 2060.0 ? 0.08 : 0.01; });
    int there = 0;
    for (const std::size_t i : noise.outliers) there += i % 9 == 3 ? 1 : 0;
    EXPECT_LT(there, 3) << seed;
  }
}

TEST(Whitening, KnowsWhatThePiecesOfADwellHaveInCommon) {
  // Two dwells of two pieces each; h of the variance is common to those, a quarter is white.
  RowOrder order;
  order.step.assign(4, 1.0);
  order.new_run = {true, false, false, false};
  order.new_state = {true, false, true, false};
  const double h = 0.6, c2 = 0.75;
  const Whitening whitening(Eigen::VectorXd::Constant(4, 2.0), order, 0.0, 0.0, h,
                            Eigen::VectorXd::Constant(4, std::sqrt(c2)));
  Eigen::MatrixXd covariance = 4.0 * Eigen::MatrixXd::Identity(4, 4);
  covariance(0, 1) = covariance(1, 0) = covariance(2, 3) = covariance(3, 2) = 4.0 * c2 * h;
  const Eigen::MatrixXd w = whitening(Eigen::MatrixXd(Eigen::MatrixXd::Identity(4, 4)));
  EXPECT_LT((w * covariance * w.transpose() - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-12);
  EXPECT_NEAR(whitening.log_determinant(), 2.0 * std::log(16.0 * (1.0 - std::pow(c2 * h, 2))),
              1e-12);
}

TEST(Whitening, KnowsAZeroThatIsSetBeforeEachRun) {
  // Two runs of two readings, correlated along time; one offset for both readings of a run.
  RowOrder order;
  order.step = {std::numeric_limits<double>::infinity(), 1.0, 1.0, 2.0};
  order.new_run = {true, false, true, false};
  const double phi = 0.5, g = 0.6, unit = 3.0;
  const Eigen::Vector4d std(1.0, 2.0, 3.0, 5.0), time(0.0, 1.0, 2.0, 4.0);
  const Whitening whitening(std, order, phi, g, 0.0, {}, unit);
  Eigen::MatrixXd covariance(4, 4);
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 4; ++k)
      covariance(i, k) = (1.0 - g) * std[i] * std[k] * std::pow(phi, std::abs(time[i] - time[k])) +
                         (i / 2 == k / 2 ? g * unit * unit : 0.0);
  const Eigen::MatrixXd w = whitening(Eigen::MatrixXd(Eigen::MatrixXd::Identity(4, 4)));
  EXPECT_LT((w * covariance * w.transpose() - Eigen::MatrixXd::Identity(4, 4)).norm(), 1e-12);
  EXPECT_NEAR(whitening.log_determinant(), std::log(covariance.determinant()), 1e-12);
}

/// Noise found in a record of runs of nine rows at 0.5 % scatter. The offset of a run has a part in
/// proportion to the reading and one of equal size [SI].
NoiseModel noise_with_offsets(int runs, double in_proportion, double even, unsigned seed) {
  constexpr Eigen::Index rows_of_run = 9;
  const Eigen::Index rows = runs * rows_of_run;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd truth(rows);
  ChannelReadings readings{.measured = Eigen::VectorXd(rows)};
  readings.order.has_runs = true;
  readings.order.step.assign(static_cast<std::size_t>(rows),
                             std::numeric_limits<double>::infinity());
  double offset = 0.0;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Index run = i / rows_of_run, row = i % rows_of_run;
    readings.order.new_run.push_back(row == 0);
    truth[i] = 60.0 * (1.0 + static_cast<double>(row)) * (1.0 + static_cast<double>(run % 4));
    if (row == 0) offset = normal(random);
    readings.measured[i] =
        truth[i] + offset * (in_proportion * truth[i] + even) + 0.005 * truth[i] * normal(random);
  }
  return estimate_noise_model(readings, truth, truth);
}

/// In how many of 20 records of 24 runs offsets of one size are found.
int records_with_even_offsets(double in_proportion, double even) {
  int count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    count += noise_with_offsets(24, in_proportion, even, seed).run_unit > 0.0 ? 1 : 0;
  return count;
}

TEST(Noise, TellsOffsetsOfOneSizeFromThoseInProportion) {
  EXPECT_GE(records_with_even_offsets(0.0, 15.0), 19);
  EXPECT_LE(records_with_even_offsets(0.03, 0.0), 1);
}

/// True if the noise makes an equal offset of the first run likelier than one in proportion.
bool favours_equal_offsets(const Whitening& noise) {
  Eigen::VectorXd equal = Eigen::VectorXd::Zero(noise.std().size()), in_proportion = equal;
  equal.head(9).setConstant(1.0);
  in_proportion.head(9) = Eigen::VectorXd::LinSpaced(9, 1.0, 9.0) / std::sqrt(285.0 / 9.0);
  return noise(equal).squaredNorm() < noise(in_proportion).squaredNorm();
}

/// In how many of 20 records the noise has offsets in proportion but allows equal ones.
int records_that_allow_equal_offsets(int runs, double in_proportion, double even) {
  int count = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const NoiseModel noise = noise_with_offsets(runs, in_proportion, even, seed);
    count += noise.run_unit == 0.0 &&
                     std::any_of(noise.allowed.begin(), noise.allowed.end(), favours_equal_offsets)
                 ? 1
                 : 0;
  }
  return count;
}

TEST(Noise, AllowsBothFormsOfRunOffsetsWhereTheyFitAlike) {
  EXPECT_GE(records_that_allow_equal_offsets(4, 0.02, 3.0), 10);
  EXPECT_LE(records_that_allow_equal_offsets(24, 0.03, 0.0), 1);
}

}  // namespace
}  // namespace raceway::fit

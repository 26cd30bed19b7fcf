#include "rig/coast_down.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>

#include "tests/support/rows.h"

namespace raceway::fit {

using rig::CoastDownRun;

namespace {

using Torque = std::function<double(double)>;  // [N m] of speed [rad/s]

constexpr double inertia = 0.85;

double palmgren_like(double speed) { return 0.03 + 0.0075 * std::pow(speed, 2.0 / 3.0); }
double with_drag(double speed) { return palmgren_like(speed) + 6e-6 * speed * speed; }
/// A Stribeck curve: boundary friction that fades with speed.
double stribeck(double speed) { return palmgren_like(speed) + 0.04 * std::exp(-speed / 8.0); }

struct CoastDownSample {
  double time = unset;   // [s]
  double speed = unset;  // [rad/s]
  int run = -1;
  int line = 0;
  bearing::OperatingPoint point;
};

struct CoastDownRecord {
  std::string source;
  std::vector<CoastDownSample> samples;
  std::vector<std::string> runs;

  operator record::Record() const {
    DataSet data{.source = source, .rows = {}, .runs = runs, .notes = {}};
    for (const CoastDownSample& s : samples) {
      data.rows.push_back({.point = s.point, .time = s.time, .run = s.run, .line = s.line});
      data.rows.back().point.speed = s.speed;
    }
    record::Record record = data;
    std::erase_if(record.columns, [](const record::Column& c) {
      return c.channel->role == record::Role::measured;
    });
    return record;
  }
};

struct CoastDownTorque {
  DataSet data;
  std::vector<CoastDownRun> runs;
};

CoastDownTorque coast_down_torque(const CoastDownRecord& record, const Rig& rig) {
  const rig::CoastDownTorque torque = rig::coast_down_torque(record, rig);
  return {data_of(torque.record), torque.runs};
}

Rig rig(double minimum_speed = 40.0 * rpm) {
  Rig r;
  r.inertia = inertia;
  r.minimum_speed = minimum_speed;
  return r;
}

/// Exact coast-down (Runge-Kutta, steps of at most 20 ms) sampled at the given times.
CoastDownRecord coast_down(const Torque& torque, double speed, const std::vector<double>& times) {
  CoastDownRecord record;
  record.source = "run.csv";
  record.runs = {"first"};
  const auto slope = [&](double w) { return -torque(w) / inertia; };
  double now = 0.0;
  for (const double time : times) {
    const int steps = std::max(1, static_cast<int>(std::ceil((time - now) / 0.02)));
    const double h = (time - now) / steps;
    for (int k = 0; k < steps; ++k) {
      const double a = slope(speed), b = slope(speed + 0.5 * h * a);
      const double c = slope(speed + 0.5 * h * b), d = slope(speed + h * c);
      speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    now = time;
    if (speed < 40.0 * rpm) break;
    record.samples.push_back({.time = time,
                              .speed = speed,
                              .run = 0,
                              .line = static_cast<int>(record.samples.size()) + 2,
                              .point = {.axial_load = 100.0, .temperature = kelvin(40.0)}});
  }
  return record;
}

std::vector<double> every(double spacing, double end) {
  std::vector<double> times;
  for (double t = spacing; t < end; t += spacing) times.push_back(t);
  return times;
}

void add_noise(CoastDownRecord& record, double std, std::mt19937& random,
               double correlation = 0.0) {
  std::normal_distribution<double> gauss;
  double noise = std * gauss(random);
  for (CoastDownSample& s : record.samples) {
    s.speed += noise;
    noise = correlation * noise + std * std::sqrt(1.0 - correlation * correlation) * gauss(random);
  }
}

struct Recovery {
  double mean_square = 0.0;  // of (torque - truth)/std
  double inside = 0.0;       // share within 1.96 std
  double bias = 0.0;         // mean of (torque - truth)/std
  double lag = 0.0;          // mean product of neighbouring (torque - truth)/std
};

Recovery recover(const CoastDownRecord& clean, const Torque& torque, double noise, int sets,
                 double correlation = 0.0) {
  std::mt19937 random(42);
  Recovery result;
  double count = 0.0;
  for (int set = 0; set < sets; ++set) {
    CoastDownRecord record = clean;
    add_noise(record, noise, random, correlation);
    double before = 0.0;
    for (const Row& row : coast_down_torque(record, rig()).data.rows) {
      const double t = (row.measured - torque(row.point.speed)) / row.std;
      result.mean_square += t * t;
      result.inside += std::abs(t) < 1.96 ? 1.0 : 0.0;
      result.bias += t;
      result.lag += t * before;
      before = t;
      count += 1.0;
    }
  }
  result.mean_square /= count;
  result.inside /= count;
  result.bias /= count;
  result.lag /= count;
  return result;
}

TEST(CoastDown, RecoversTheTorqueOfExactSpeeds) {
  // What is left is the third derivative of speed; see the comment of coast_down_torque().
  for (const Torque& torque : {Torque(palmgren_like), Torque(with_drag), Torque(stribeck)}) {
    const CoastDownRecord record = coast_down(torque, 1000 * rpm, every(1.0, 2000.0));
    const CoastDownTorque result = coast_down_torque(record, rig());
    EXPECT_GE(result.data.rows.size(), 25U);
    for (const Row& row : result.data.rows)
      EXPECT_NEAR(row.measured, torque(row.point.speed), 2e-3 * row.measured)
          << row.point.speed / rpm << " rpm";
  }
}

TEST(CoastDown, HasAnHonestStandardDeviationAndNoBias) {
  const CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  const Recovery r = recover(record, with_drag, 0.06 * rpm, 100);
  EXPECT_NEAR(r.mean_square, 1.0, 0.1);
  EXPECT_NEAR(r.inside, 0.95, 0.01);
  EXPECT_NEAR(r.bias, 0.0, 0.1);
  EXPECT_NEAR(r.lag, 0.0, 0.06);  // windows share no sample
}

TEST(CoastDown, AllowsForUnequalSpacingAndGaps) {
  std::mt19937 random(7);
  std::exponential_distribution<double> wait(1.0);
  std::vector<double> times;
  for (double t = 1.0; t < 2000.0; t += 0.2 + wait(random))
    if (t < 200.0 || t > 260.0) times.push_back(t);
  const CoastDownRecord record = coast_down(with_drag, 1000 * rpm, times);
  for (const Row& row : coast_down_torque(record, rig()).data.rows) {
    EXPECT_NEAR(row.measured, with_drag(row.point.speed), 4e-3 * row.measured);
    EXPECT_FALSE(row.time > 215.0 && row.time < 245.0) << "a window spans the gap";
  }
  const Recovery r = recover(record, with_drag, 0.06 * rpm, 100);
  EXPECT_NEAR(r.mean_square, 1.0, 0.1);
  EXPECT_NEAR(r.inside, 0.95, 0.01);
}

TEST(CoastDown, AllowsForSamplesPerRevolution) {
  // One sample in 20 revolutions: the spacing grows as the shaft slows down.
  std::vector<double> times;
  double speed = 1000 * rpm, t = 0.0;
  while (speed > 45 * rpm) {
    const double dt = 20.0 * 2.0 * pi / speed;
    t += dt;
    speed -= dt * with_drag(speed) / inertia;
    times.push_back(t);
  }
  const CoastDownRecord record = coast_down(with_drag, 1000 * rpm, times);
  const CoastDownTorque result = coast_down_torque(record, rig());
  EXPECT_GE(result.data.rows.size(), 20U);
  for (const Row& row : result.data.rows)
    EXPECT_NEAR(row.measured, with_drag(row.point.speed), 5e-3 * row.measured);
}

TEST(CoastDown, WidensTheStandardDeviationOfFilteredSpeeds) {
  const CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  const Recovery r = recover(record, with_drag, 0.06 * rpm, 100, 0.6);
  EXPECT_NEAR(r.mean_square, 1.0, 0.2);
  EXPECT_GT(r.inside, 0.92);
}

TEST(CoastDown, AllowsForQuantisedSpeeds) {
  // Steps of 0.5 rpm, up to ten times the fall between samples.
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  for (CoastDownSample& s : record.samples) s.speed = std::round(s.speed / rpm / 0.5) * 0.5 * rpm;
  int inside = 0, rows = 0;
  for (const Row& row : coast_down_torque(record, rig()).data.rows) {
    ++rows;
    if (std::abs(row.measured - with_drag(row.point.speed)) < 3.0 * row.std) ++inside;
  }
  EXPECT_GE(inside, rows - 1);
}

TEST(CoastDown, AveragesADenseRecord) {
  std::mt19937 random(8);
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(0.02, 2000.0));
  ASSERT_GT(record.samples.size(), 20000U);
  add_noise(record, 0.4 * rpm, random);
  const CoastDownTorque result = coast_down_torque(record, rig());
  double square = 0.0;
  for (const Row& row : result.data.rows) {
    const double t = (row.measured - with_drag(row.point.speed)) / row.std;
    square += t * t / static_cast<double>(result.data.rows.size());
  }
  EXPECT_NEAR(square, 1.0, 0.7);
  EXPECT_LT(result.runs[0].torque_std, 0.3 * N_mm);
}

TEST(CoastDown, LeavesOutSpikesAndNamesThem) {
  std::mt19937 random(9);
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  add_noise(record, 0.06 * rpm, random);
  record.samples[100].speed += 30 * rpm;
  record.samples[101].speed += 3 * rpm;
  record.samples[300].speed = 0.0;
  const CoastDownTorque result = coast_down_torque(record, rig());
  EXPECT_EQ(result.runs[0].outliers, 2);
  EXPECT_THAT(texts(result.data.notes), testing::Contains(testing::HasSubstr("lines 102, 103")));
  EXPECT_THAT(texts(result.data.notes), testing::Contains(testing::HasSubstr("line 302")));
  for (const Row& row : result.data.rows)
    EXPECT_NEAR(row.measured, with_drag(row.point.speed), 5.0 * row.std);
}

TEST(CoastDown, KeepsRunsApartAndGivesEachRowItsPlace) {
  std::mt19937 random(10);
  CoastDownRecord record = coast_down(palmgren_like, 1000 * rpm, every(1.0, 2000.0));
  CoastDownRecord other = coast_down(with_drag, 900 * rpm, every(2.0, 2000.0));
  add_noise(record, 0.02 * rpm, random);
  add_noise(other, 0.2 * rpm, random);
  record.runs = {"first", "second"};
  const int lines = static_cast<int>(record.samples.size());
  for (CoastDownSample s : other.samples) {
    s.run = 1;
    s.line += lines;
    s.point.axial_load = 250.0;
    record.samples.push_back(s);
  }
  const CoastDownTorque result = coast_down_torque(record, rig());
  EXPECT_EQ(result.data.quantity, Quantity::friction_torque);
  EXPECT_EQ(result.data.noise, NoiseSource::regression);
  ASSERT_EQ(result.runs.size(), 2U);
  EXPECT_EQ(result.runs[1].run, "second");
  EXPECT_NEAR(result.runs[0].speed_noise, 0.02 * rpm, 0.003 * rpm);
  EXPECT_NEAR(result.runs[1].speed_noise, 0.2 * rpm, 0.03 * rpm);
  for (const Row& row : result.data.rows) {
    const CoastDownSample& s = record.samples[static_cast<std::size_t>(row.line) - 2];
    EXPECT_EQ(s.run, row.run);
    EXPECT_NEAR(s.time, row.time, row.run == 0 ? 1.0 : 2.0);
    EXPECT_EQ(row.point.axial_load, row.run == 0 ? 100.0 : 250.0);
    EXPECT_NEAR(row.point.temperature, kelvin(40.0), 1e-9);
    EXPECT_GT(row.std, 0.0);
  }
}

TEST(CoastDown, RefusesTimeThatGoesBackAndNamesTheLine) {
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 100.0));
  record.samples[50].time = record.samples[49].time - 0.5;
  try {
    (void)coast_down_torque(record, rig());
    FAIL() << "time goes back";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("run.csv, line 52: time_s = 49.5 goes back"));
  }
}

TEST(CoastDown, AveragesSamplesOfOneTime) {
  // Ten samples a second, of which the clock of the file tells whole seconds alone.
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(0.1, 400.0));
  for (CoastDownSample& s : record.samples) s.time = std::floor(s.time + 1e-9);
  const CoastDownTorque result = coast_down_torque(record, rig());
  EXPECT_EQ(result.runs[0].samples + result.runs[0].outliers, 400);  // the first second has nine
  EXPECT_THAT(texts(result.data.notes),
              testing::Contains("run first: 3999 samples have only 400 different times, so samples "
                                "of the same time are averaged (first in line 2)"));
  for (const Row& row : result.data.rows)
    EXPECT_NEAR(row.measured, with_drag(row.point.speed), 4e-3 * row.measured);
}

TEST(CoastDown, RefusesTooFewSamplesAndAMissingInertia) {
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 6.5));
  ASSERT_EQ(record.samples.size(), 6U);
  EXPECT_THROW((void)coast_down_torque(record, rig()), std::invalid_argument);
  record = coast_down(with_drag, 1000 * rpm, every(1.0, 7.5));
  EXPECT_EQ(coast_down_torque(record, rig()).data.rows.size(), 1U);
  EXPECT_THROW((void)coast_down_torque(record, Rig{}), std::invalid_argument);
}

TEST(CoastDown, LeavesOutARunThatIsTooShortByName) {
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  const CoastDownTorque alone = coast_down_torque(record, rig());
  record.runs = {"first", "broken off"};
  for (std::size_t i = 0; i < 5; ++i) {
    CoastDownSample s = record.samples[i];
    s.run = 1;
    record.samples.push_back(s);
  }
  const CoastDownTorque result = coast_down_torque(record, rig());
  EXPECT_EQ(result.data.rows.size(), alone.data.rows.size());
  EXPECT_THAT(
      texts(result.data.notes),
      testing::Contains("run broken off: the run has only 5 usable samples; a torque needs at "
                        "least 7, so the run is not used"));
  ASSERT_EQ(result.runs.size(), 2U);
  EXPECT_EQ(result.runs[1].rows, 0);
}

TEST(CoastDown, LeavesOutAShaftThatSpeedsUp) {
  CoastDownRecord record = coast_down(with_drag, 1000 * rpm, every(1.0, 2000.0));
  CoastDownRecord driven = record;
  const double turn = record.samples[199].time;
  driven.samples.clear();
  for (std::size_t i = 200; i-- > 0;) {  // the first 200 samples backwards: a run-up
    CoastDownSample s = record.samples[i];
    s.time = turn - s.time;
    driven.samples.push_back(s);
  }
  for (CoastDownSample s : record.samples) {
    s.time += turn;
    driven.samples.push_back(s);
  }
  const CoastDownTorque result = coast_down_torque(driven, rig());
  EXPECT_THAT(texts(result.data.notes),
              testing::Contains(testing::HasSubstr("before the release")));
  for (const Row& row : result.data.rows) {
    EXPECT_GT(row.time, turn);
    EXPECT_NEAR(row.measured, with_drag(row.point.speed), 2e-3 * row.measured);
  }
}

}  // namespace
}  // namespace raceway::fit

// Coast-downs in closed form: nothing here is integrated, and no law of the program takes part.
#include "rig/detail/release.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "rig/coast_down.h"

namespace raceway::rig {
namespace {

using Speed = std::function<double(double)>;  // [rad/s] of the time since the release [s]

constexpr double top = 100.0;  // [rad/s]

/// M = a + b ω: an exponential. Stands after 200 s.
double loaded(double t) { return (top + 20.0) * std::exp(-t * std::log(6.0) / 200.0) - 20.0; }
/// M constant, and so small that a second hardly shows: 1 rpm in 10 s.
double light(double t) { return top - 0.1 * rpm * t; }
/// M ~ ω²: a hyperbola.
double windy(double t) { return top / (1.0 + t / 50.0); }
/// M ~ exp(-ω/15): it hardly falls at first and ever faster then, 800 times faster at the end.
double gentle(double t) { return 15.0 * std::log(std::exp(top / 15.0) * (1.0 - t / 200.5)); }

struct Case {
  Speed speed;
  double end;         // [s] after the release
  double spacing;     // [s]
  double noise;       // [rad/s]
  double step = 0.0;  // of the speed as it is written [rad/s]
};

struct Made {
  std::vector<Block> samples;
  std::size_t driven = 0;  // samples up to the release, the first of the coast-down not counted
};

/// Run-up at constant rate for `rise` seconds from 20 % of the speed, `plateau` seconds of constant
/// speed, coast-down.
Made made(const Case& c, double rise, double plateau, unsigned seed, double hunting = 0.0) {
  Made m;
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  double t = 0.0;
  const auto add = [&](double speed) {
    speed += c.noise * gauss(random);
    if (c.step > 0.0) speed = std::round(speed / c.step) * c.step;
    m.samples.push_back({.time = t, .speed = speed, .row = m.samples.size()});
    t += c.spacing;
  };
  for (double s = 0.0; s < rise - 1e-9; s += c.spacing) add(top * (0.2 + 0.8 * s / rise));
  for (double s = 0.0; s < plateau - 1e-9; s += c.spacing)
    add(top + hunting * std::sin(2.0 * pi * s / 1.7));
  m.driven = m.samples.size();
  for (double s = 0.0; s < c.end; s += c.spacing) add(c.speed(s));
  return m;
}

/// As printed to 0.001 rpm, as a good and as a poor encoder reads it, and in steps of 0.5 rpm.
std::vector<Case> cases(const Speed& speed, double end, std::vector<double> spacings) {
  std::vector<Case> list;
  for (const double spacing : spacings)
    for (const double noise : {0.0, 0.03, 0.3})
      for (const double step : {0.001, 0.5})
        list.push_back({speed, end, spacing, noise * rpm, step * rpm});
  return list;
}

std::string name(const Case& c) {
  return "every " + std::to_string(c.spacing) + " s, noise " + std::to_string(c.noise / rpm) +
         " rpm, steps of " + std::to_string(c.step / rpm) + " rpm";
}

std::size_t found(const Made& m) { return samples_before_release(m.samples, {}); }

TEST(Release, ARecordThatBeginsWithItKeepsEverySample) {
  for (const auto& [speed, end] : {std::pair{Speed(loaded), 195.0}, std::pair{Speed(light), 600.0},
                                   std::pair{Speed(windy), 400.0}, std::pair{Speed(gentle), 200.0}})
    for (const Case& c : cases(speed, end, {0.01, 0.1, 0.5, 1.0}))
      for (unsigned seed = 1; seed <= 3; ++seed)
        EXPECT_EQ(found(made(c, 0.0, 0.0, seed)), 0U) << name(c) << ", law of end " << end;
}

TEST(Release, APlateauOfAnyLengthIsLeftOut) {
  for (const auto& [speed, end] : {std::pair{Speed(loaded), 195.0}, std::pair{Speed(windy), 400.0}})
    for (const Case& c : cases(speed, end, {0.01, 0.1, 0.5}))
      for (const double plateau : {4.0, 30.0, end}) {
        const Made m = made(c, 0.0, plateau, 5);
        const double beyond = static_cast<double>(found(m)) - static_cast<double>(m.driven);
        SCOPED_TRACE(name(c) + ", plateau " + std::to_string(plateau));
        // A tenth of a second is missed at most, 1 % of the coast-down lost.
        EXPECT_GE(beyond, -0.1 / c.spacing);
        EXPECT_LE(beyond, std::max(3.0, 0.01 * (end + plateau) / c.spacing));
      }
}

TEST(Release, RunUpAndADriveThatHuntsAreLeftOutToo) {
  for (const Case& c : cases(loaded, 195.0, {0.05, 0.5}))
    for (const double plateau : {0.0, 20.0, 195.0})
      for (const double hunting : {0.0, 0.5 * rpm}) {
        const Made m = made(c, 10.0, plateau, 6, hunting);
        const double beyond = static_cast<double>(found(m)) - static_cast<double>(m.driven);
        SCOPED_TRACE(name(c) + ", plateau " + std::to_string(plateau));
        EXPECT_GE(beyond, -0.5 / c.spacing);
        EXPECT_LE(beyond, std::max(4.0, 0.02 * (205.0 + plateau) / c.spacing));
      }
}

TEST(Release, AGentleBeginningIsToldFromAPlateauInFrontOfIt) {
  Made m = made({light, 600.0, 0.5, 0.01 * rpm, 0.0}, 0.0, 60.0, 7);
  EXPECT_NEAR(static_cast<double>(found(m)), static_cast<double>(m.driven), 12.0);
  m = made({gentle, 150.0, 0.5, 0.01 * rpm, 0.0}, 0.0, 60.0, 7);
  EXPECT_NEAR(static_cast<double>(found(m)), static_cast<double>(m.driven), 12.0);
}

TEST(Release, ABrakeFurtherDownIsNone) {
  Made m = made({light, 2000.0, 1.0, 0.01 * rpm, 0.0}, 0.0, 0.0, 8);
  // From a half of the speed on a hundred times as steep.
  const double half = 0.5 * top, at = (top - half) / (0.1 * rpm);
  for (Block& b : m.samples)
    if (b.time > at) b.speed = half - 10.0 * rpm * (b.time - at);
  std::erase_if(m.samples, [](const Block& b) { return b.speed <= 0.0; });
  EXPECT_EQ(found(m), 0U);
}

TEST(Release, ASpikeIsNone) {
  Made m = made({loaded, 195.0, 0.5, 0.03 * rpm, 0.0}, 0.0, 0.0, 9);
  m.samples[1].speed -= 8 * rpm;
  m.samples[40].speed += 30 * rpm;
  EXPECT_EQ(found(m), 0U);
}

TEST(Release, EveryStartOfARunHasItsOwn) {
  // Two starts in one run, told from each other by no run_id.
  const Case c{loaded, 195.0, 0.5, 0.03 * rpm, 0.0};
  const Made first = made(c, 10.0, 20.0, 10), second = made(c, 10.0, 20.0, 11);
  record::Record record{.source = "run.csv", .runs = {"both"}};
  std::vector<double> time, speed, loads;
  for (const Made* m : {&first, &second})
    for (const Block& b : m->samples) {
      time.push_back(b.time + (m == &second ? 225.0 : 0.0));
      speed.push_back(b.speed);
    }
  const std::vector<double> none(time.size(), 0.0);
  record.set(record::speed, speed);
  record.set(record::axial_load, none);
  record.set(record::time, time);
  record.set(record::run, none);
  model::Rig rig;
  rig.inertia = 0.5;
  const CoastDownTorque torque = coast_down_torque(record, rig);
  EXPECT_THAT(texts(torque.record.notes),
              testing::Contains(testing::HasSubstr("before the release")).Times(2));
  EXPECT_NEAR(torque.runs[0].before_release, 2 * 60, 8);
  // dω/dt = -k (ω + 20) of the exponential.
  const double k = std::log(6.0) / 200.0;
  std::size_t in_the_second = 0;
  for (std::size_t i = 0; i < torque.record.rows(); ++i) {
    const double moment = 0.5 * k * (torque.record.value(record::speed, i) + 20.0);
    EXPECT_NEAR(torque.record.value(record::friction_torque, i), moment,
                5.0 * torque.record.value(record::torque_deviation, i) + 1e-3 * moment);
    in_the_second += torque.record.value(record::time, i) > 225.0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(in_the_second), 0.5 * static_cast<double>(torque.record.rows()),
              2.0);
}

}  // namespace
}  // namespace raceway::rig

// Times of falls in closed form, of laws that are none of the program's.
#include "rig/fall_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace raceway::rig {
namespace {

constexpr double inertia = 0.5;

struct Law {
  std::function<double(double)> torque;        // [N m] of ω
  std::function<double(double, double)> time;  // [s] from ω1 to ω2
};

Law power(double p) {
  return {[p](double w) { return 1e-3 * std::pow(w, p); },
          [p](double a, double b) {
            return p == 1.0 ? inertia / 1e-3 * std::log(a / b)
                            : inertia / 1e-3 * (std::pow(a, 1 - p) - std::pow(b, 1 - p)) / (1 - p);
          }};
}
const Law linear{[](double w) { return 0.03 + 1e-3 * w; },
                 [](double a, double b) {
                   return inertia / 1e-3 * std::log((0.03 + 1e-3 * a) / (0.03 + 1e-3 * b));
                 }};
const Law airy{[](double w) { return 0.03 + 1e-5 * w * w; },
               [](double a, double b) {
                 const double k = std::sqrt(1e-5 / 0.03);
                 return inertia / std::sqrt(0.03 * 1e-5) * (std::atan(k * a) - std::atan(k * b));
               }};

model::Rig rig() {
  model::Rig r;
  r.inertia = inertia;
  return r;
}

/// A chain of falls from 100 rad/s, each to `share` of the speed before.
std::vector<Fall> chain(const Law& law, double share, int count) {
  std::vector<Fall> falls;
  double speed = 100.0;
  for (int i = 0; i < count; ++i, speed *= share)
    falls.push_back({speed, share * speed, law.time(speed, share * speed)});
  return falls;
}

record::Record record_of(const std::vector<Fall>& falls) {
  record::Record record{.source = "falls.csv", .runs = {"a"}};
  record.set(record::axial_load, std::vector<double>(falls.size(), 100.0));
  record.set(record::run, std::vector<double>(falls.size(), 0.0));
  return record;
}

/// Largest relative difference of a torque from that of the law at its speed.
double worst(const Law& law, const record::Record& record) {
  double w = 0.0;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    const double truth = law.torque(record.value(record::speed, i));
    w = std::max(w, std::abs(record.value(record::friction_torque, i) / truth - 1.0));
  }
  return w;
}

TEST(FallTimes, ThePowerMeanIsExactForPowers) {
  for (const double p : {-1.0, 1e-7, 0.3, 2.0 / 3.0, 1.0, 1.8, 2.0, 3.0})
    for (const double to : {20.0, 80.0, 99.9}) {
      const Law law = power(p);
      const double mean = inertia * (100.0 - to) / law.time(100.0, to);
      EXPECT_NEAR(law.torque(speed_of_mean_torque(100.0, to, p)) / mean, 1.0, 1e-9) << p;
    }
  EXPECT_NEAR(speed_of_mean_torque(100.0, 25.0, 2.0), 50.0, 1e-12);
  EXPECT_NEAR(speed_of_mean_torque(100.0, 25.0, 1.0), 75.0 / std::log(4.0), 1e-12);
}

TEST(FallTimes, AChainOfFallsGivesTheTorqueOfAnyPower) {
  for (const double p : {0.0, 2.0 / 3.0, 1.0, 2.0}) {
    const Law law = power(p);
    EXPECT_LT(worst(law, fall_torque(record_of(chain(law, 0.8, 8)), chain(law, 0.8, 8), rig())),
              1e-9)
        << p;
  }
}

TEST(FallTimes, TheErrorOfSmoothLawsFallsFasterThanTheSquareOfTheWidth) {
  for (const Law& law : {linear, airy}) {
    double before = unset;
    for (const double share : {0.7, 0.84, 0.92}) {  // widths in the ratio 4 : 2 : 1
      const std::vector<Fall> falls = chain(law, share, 6);
      const double error = worst(law, fall_torque(record_of(falls), falls, rig()));
      EXPECT_LT(error, 0.02 * std::pow(1.0 - share, 2)) << share;
      if (!std::isnan(before)) {
        EXPECT_LT(error, before / 5.0) << share;
      }
      before = error;
    }
  }
}

TEST(FallTimes, AFallAloneIsTakenAsViscous) {
  const Law law = power(2.0 / 3.0);
  const std::vector<Fall> falls = chain(law, 0.5, 1);
  EXPECT_LT(worst(law, fall_torque(record_of(falls), falls, rig())), 1e-9);
}

TEST(FallTimes, RepeatsAndOtherLoadsAreNoNeighbours) {
  const Law law = linear;
  std::vector<Fall> falls = chain(law, 0.8, 6);
  const std::size_t count = falls.size();
  for (std::size_t i = 0; i < count; ++i) falls.push_back(falls[i]);  // again
  for (std::size_t i = 0; i < count; ++i)  // and with ten times the torque
    falls.push_back({falls[i].from, falls[i].to, 0.1 * falls[i].time});
  record::Record record = record_of(falls);
  record.find(record::axial_load)->values.assign(falls.size(), 100.0);
  for (std::size_t i = 2 * count; i < falls.size(); ++i)
    record.find(record::axial_load)->values[i] = 900.0;
  const record::Record torque = fall_torque(record, falls, rig());
  const record::Record alone =
      fall_torque(record_of(chain(law, 0.8, 6)), chain(law, 0.8, 6), rig());
  for (std::size_t i = 0; i < falls.size(); ++i)
    EXPECT_DOUBLE_EQ(torque.value(record::speed, i), alone.value(record::speed, i % count)) << i;
}

TEST(FallTimes, ADeviationOfTheTimeBecomesOneOfTheTorque) {
  std::vector<Fall> falls = chain(linear, 0.8, 3);
  EXPECT_EQ(fall_torque(record_of(falls), falls, rig()).deviation_of(record::friction_torque),
            nullptr);
  for (Fall& f : falls) f.time_deviation = 0.02 * f.time;
  const record::Record torque = fall_torque(record_of(falls), falls, rig());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(torque.value(record::torque_deviation, i),
                0.02 * torque.value(record::friction_torque, i), 1e-15);
}

TEST(FallTimes, WhatIsNoFallIsRefused) {
  for (const Fall& f : {Fall{50, 60, 1}, Fall{60, 0, 1}, Fall{60, 50, 0}, Fall{60, 50, unset}}) {
    const std::vector<Fall> falls{f};
    EXPECT_THROW((void)fall_torque(record_of(falls), falls, rig()), std::invalid_argument);
  }
  const std::vector<Fall> falls = chain(linear, 0.8, 2);
  EXPECT_THROW((void)fall_torque(record_of(falls), falls, model::Rig{}), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::rig

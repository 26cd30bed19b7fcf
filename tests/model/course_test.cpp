#include "model/course.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace raceway::model {
namespace {

constexpr double minute = 60.0, hour = 3600.0;

/// Speeds of each load in turn, a row every ten minutes.
record::Record passages(int count, double pause) {
  std::vector<double> time, load, speed;
  double now = 0.0;
  for (int k = 0; k < count; ++k) {
    for (const double F : {250.0, 600.0, 1400.0})
      for (const double n : {100.0, 300.0, 900.0, 300.0, 100.0}) {
        time.push_back(now);
        load.push_back(F);
        speed.push_back(n);
        now += 10.0 * minute;
      }
    now += pause;
  }
  record::Record record;
  record.set(record::time, time);
  record.set(record::axial_load, load);
  record.set(record::speed, speed);
  return record;
}

TEST(Course, ADayBeginsAfterANight) {
  const std::vector<Course> course = course_of(passages(2, 12.0 * hour));
  EXPECT_EQ(course[14].since_start, 140.0 * minute);
  EXPECT_EQ(course[15].since_start, 0.0);
  EXPECT_EQ(course[29].since_start, 140.0 * minute);
}

TEST(Course, WithoutAPauseEachPassageThroughTheLoadsBeginsAnew) {
  const std::vector<Course> course = course_of(passages(3, 0.0));
  for (const std::size_t first : {0U, 15U, 30U}) {
    EXPECT_EQ(course[first].since_start, 0.0) << first;
    EXPECT_EQ(course[first + 14].since_start, 140.0 * minute) << first;
  }
}

TEST(Course, KnowsFromWhereASpeedWasReached) {
  const std::vector<Course> course = course_of(passages(1, 0.0));
  const std::vector<double> wanted{1, 1, 1, -1, -1};
  for (std::size_t i = 0; i < course.size(); ++i)
    EXPECT_EQ(course[i].direction, wanted[i % 5]) << i;
}

TEST(Course, GoesByTheClockAndNotByTheOrderOfTheRows) {
  const record::Record record = passages(1, 0.0);
  std::vector<std::size_t> back(record.rows());
  for (std::size_t i = 0; i < back.size(); ++i) back[i] = back.size() - 1 - i;
  const record::Record turned = record.picked(back);
  const std::vector<Course> one = course_of(record), other = course_of(turned);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_EQ(other[14 - i].since_start, one[i].since_start);
    EXPECT_EQ(other[14 - i].direction, one[i].direction);
  }
}

TEST(Course, IsNotKnownWithoutTheTimeOfEveryRow) {
  record::Record record = passages(1, 0.0);
  std::vector<double> time(record.values(record::time).begin(), record.values(record::time).end());
  time[3] = unset;
  record.set(record::time, time);
  for (const Course& c : course_of(record)) {
    EXPECT_TRUE(std::isnan(c.since_start));
    EXPECT_TRUE(std::isnan(c.direction));
  }
}

}  // namespace
}  // namespace raceway::model

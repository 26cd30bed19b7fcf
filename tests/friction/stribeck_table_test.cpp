#include "friction/stribeck_table.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "friction/friction_law.h"
#include "friction/spin.h"
#include "tests/friction/sample.h"

namespace raceway {
namespace {

using bearing::OperatingPoint;
using bearing::SolveStatus;
using friction::Outside;
using friction::StribeckTable;
using friction::TableAxes;
using friction::TablePoint;
using testing::HasSubstr;

/// A table of a formula, without bearing.
template <typename F>
StribeckTable table_of(const TableAxes& axes, const F& f) {
  return build_stribeck_table(
      axes, {"speed", "load"},
      [&](std::span<const OperatingPoint> points, std::span<TablePoint> results) {
        for (std::size_t i = 0; i < points.size(); ++i) {
          results[i].friction_moment = f(points[i]);
          results[i].columns[0] = points[i].speed;
          results[i].columns[1] = points[i].axial_load;
          results[i].status = SolveStatus::converged;
        }
      });
}

std::vector<double> range(double from, double step, int count) {
  std::vector<double> values(static_cast<std::size_t>(count), from);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += step * static_cast<double>(i);
  return values;
}

std::vector<double> random_axis(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> step(0.1, 10.0);
  std::vector<double> values{step(random)};
  while (static_cast<int>(values.size()) < count) values.push_back(values.back() + step(random));
  return values;
}

const TableAxes small_axes{.speed = range(0, 100, 6),
                           .axial_load = {100, 300, 900},
                           .radial_load = {0},
                           .temperature = {kelvin(20), kelvin(40)}};

TEST(StribeckTable, HoldsEachPointAtItsIndex) {
  const auto f = [](const OperatingPoint& p) {
    return p.speed + 1e3 * p.axial_load + 1e7 * p.temperature;
  };
  const auto table = table_of(small_axes, f);
  ASSERT_EQ(table.friction_moment.size(), small_axes.size());
  ASSERT_EQ(table.values.size(), 2 * small_axes.size());
  for (std::size_t i = 0; i < small_axes.size(); ++i) {
    EXPECT_EQ(table.friction_moment[i], f(table.point(i)));
    EXPECT_EQ(table.row(i)[0], table.point(i).speed);
    EXPECT_EQ(table.row(i)[1], table.point(i).axial_load);
  }
  const auto p = table.point(table.index(4, 2, 0, 1));
  EXPECT_EQ(p.speed, 400);
  EXPECT_EQ(p.axial_load, 900);
  EXPECT_EQ(p.temperature, kelvin(40));
}

TEST(StribeckTable, RepeatsItsGridPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  TableAxes axes{random_axis(random, 7), random_axis(random, 4), random_axis(random, 2),
                 random_axis(random, 5)};
  auto table = table_of(axes, [](const OperatingPoint&) { return 0.0; });
  for (double& m : table.friction_moment) m = any(random);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto p = table.point(i);
    const auto m =
        interpolate(table, {p.speed, p.axial_load, p.radial_load, p.temperature}, Outside::error);
    EXPECT_EQ(m.friction_moment, table.friction_moment[i]);
    EXPECT_FALSE(m.clamped);
  }
}

TEST(StribeckTable, IsExactForAPlane) {
  TableAxes axes{range(0, 100, 9), range(100, 50, 5), {0, 200, 300}, {kelvin(20), kelvin(60)}};
  const auto plane = [](double n, double a, double r, double t) {
    return 1.0 + 2e-3 * n + 3e-3 * a - 1e-3 * r - 0.01 * t;
  };
  const auto table = table_of(axes, [&](const OperatingPoint& p) {
    return plane(p.speed, p.axial_load, p.radial_load, p.temperature);
  });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 300; ++i) {
    const friction::TablePosition x{800 * u(random), 100 + 200 * u(random), 300 * u(random),
                                    kelvin(20 + 40 * u(random))};
    EXPECT_NEAR(interpolate(table, x, Outside::error).friction_moment,
                plane(x.speed, x.axial_load, x.radial_load, x.temperature), 1e-12);
  }
}

TEST(StribeckTable, IsMonotoneAlongEachGridLineWhereverThePointsAre) {
  std::mt19937 random(6);
  std::exponential_distribution<double> rise(1.0);
  for (int trial = 0; trial < 100; ++trial) {
    const int count = 2 + trial % 9;
    TableAxes axes{random_axis(random, count), {100, 200}, {0}, {300}};
    auto table = table_of(axes, [](const OperatingPoint&) { return 0.0; });
    const double sign = trial % 2 == 0 ? 1.0 : -1.0;
    for (std::size_t i = 1; i < axes.speed.size(); ++i)
      table.friction_moment[i] =
          table.friction_moment[i - 1] + (i % 3 == 0 ? 0.0 : sign * std::pow(rise(random), 4));
    double before = table.friction_moment[0];
    const double span = axes.speed.back() - axes.speed.front();
    const double largest = std::abs(table.friction_moment[axes.speed.size() - 1]);
    for (int i = 0; i <= 400; ++i) {
      const double speed = axes.speed.front() + span * i / 400.0;
      const double m = interpolate(table, {speed, 100, 0, 300}, Outside::error).friction_moment;
      EXPECT_GE(sign * (m - before), -1e-14 * largest);
      before = m;
    }
  }
}

TEST(StribeckTable, FourPointsOfALineInterpolateAsTheWholeLine) {
  // Values of the PCHIP of Fritsch and Butland with one-sided slopes at the ends, by hand: on
  // 0 1 2 3 4 with y = x², slopes 1, 1.5, 3.75, 35/6 and 7.
  TableAxes axes{range(0, 1, 5), {100}, {0}, {300}};
  const auto table = table_of(axes, [](const OperatingPoint& p) { return p.speed * p.speed; });
  const auto at = [&](double speed) {
    return interpolate(table, {speed, 100, 0, 300}, Outside::error).friction_moment;
  };
  const auto middle = [](double y0, double y1, double s0, double s1) {
    return 0.5 * (y0 + y1) + (s0 - s1) / 8.0;
  };
  EXPECT_NEAR(at(0.5), middle(0, 1, 1, 1.5), 1e-14);
  EXPECT_NEAR(at(1.5), middle(1, 4, 1.5, 3.75), 1e-14);
  EXPECT_NEAR(at(2.5), middle(4, 9, 3.75, 35.0 / 6.0), 1e-14);
  EXPECT_NEAR(at(3.5), middle(9, 16, 35.0 / 6.0, 7), 1e-14);
}

double interpolation_error(int count) {
  TableAxes axes{range(0, 1.0 / (count - 1), count), {100}, {0}, {300}};
  const auto f = [](double x) { return std::exp(x); };
  const auto table = table_of(axes, [&](const OperatingPoint& p) { return f(p.speed); });
  double largest = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = 0.25 + 0.5 * i / 1000.0;  // away from the ends
    const double m = interpolate(table, {x, 100, 0, 300}, Outside::error).friction_moment;
    largest = std::max(largest, std::abs(m - f(x)));
  }
  return largest;
}

TEST(StribeckTable, ErrorInsideFallsWithTheCubeOfTheSpacing) {
  EXPECT_NEAR(std::log2(interpolation_error(41) / interpolation_error(81)), 3.0, 0.2);
}

TEST(StribeckTable, OutsideIsAnErrorOrAFlaggedClamp) {
  const auto table =
      table_of(small_axes, [](const OperatingPoint& p) { return p.speed + p.axial_load; });
  const friction::TablePosition fast{501, 100, 0, kelvin(30)};
  const std::string message =
      tests::message_of([&] { (void)interpolate(table, fast, Outside::error); });
  EXPECT_THAT(message, HasSubstr("speed = 4784.197"));
  EXPECT_THAT(message, HasSubstr("rpm: the table covers from 0 to 4774.648"));
  const auto m = interpolate(table, fast, Outside::clamp);
  EXPECT_TRUE(m.clamped);
  EXPECT_NEAR(m.friction_moment, 600, 1e-12);

  const auto refused = [&](const friction::TablePosition& x) {
    return tests::message_of([&] { (void)interpolate(table, x, Outside::error); });
  };
  EXPECT_EQ(refused({100, 50, 0, kelvin(30)}),
            "axial_load = 50 N: the table covers from 100 to 900 N");
  EXPECT_EQ(refused({100, 100, 0, kelvin(45)}),
            "temperature = 45 C: the table covers from 20 to 40 C");
}

TEST(StribeckTable, AnAxisOfOneValueAnswersForThatValueOnly) {
  TableAxes axes = small_axes;
  axes.radial_load = {250};
  const auto table = table_of(axes, [](const OperatingPoint& p) { return p.speed; });
  EXPECT_EQ(tests::message_of([&] {
              (void)interpolate(table, {100, 100, 240, kelvin(30)}, Outside::error);
            }),
            "radial_load = 240 N: the table covers 250 N");
  EXPECT_TRUE(interpolate(table, {100, 100, 240, kelvin(30)}, Outside::clamp).clamped);
  const double rounded = 250 * (1 + 1e-12);
  EXPECT_FALSE(interpolate(table, {100, 100, rounded, kelvin(30)}, Outside::error).clamped);
}

TEST(StribeckTable, EndsBelongToItDespiteRoundingOfUnits) {
  const auto table = table_of(small_axes, [](const OperatingPoint& p) { return p.speed; });
  const double last = std::nextafter(500.0, 1000.0);
  const auto m = interpolate(table, {last, 100, 0, kelvin(30)}, Outside::error);
  EXPECT_EQ(m.friction_moment, 500);
  EXPECT_FALSE(m.clamped);
}

TEST(StribeckTable, APositionThatIsNoNumberIsAlwaysAnError) {
  const auto table = table_of(small_axes, [](const OperatingPoint& p) { return p.speed; });
  for (const double x : {unset, std::numeric_limits<double>::infinity()})
    for (const Outside outside : {Outside::error, Outside::clamp})
      EXPECT_THROW((void)interpolate(table, {100, x, 0, kelvin(30)}, outside),
                   std::invalid_argument);
}

TEST(StribeckTable, PointsWithoutValueAreNeverInterpolatedOver) {
  TableAxes axes = small_axes;
  axes.speed = range(0, 100, 8);
  auto table = table_of(axes, [](const OperatingPoint& p) { return p.speed; });
  table.friction_moment[table.index(3, 1, 0, 0)] = unset;
  const auto at = [&](double speed, double axial, double celsius) {
    return interpolate(table, {speed, axial, 0, kelvin(celsius)}, Outside::error);
  };
  EXPECT_FALSE(at(310, 300, 20).has_value());
  EXPECT_FALSE(at(310, 200, 30).has_value());
  // Its neighbours on the grid keep their own values.
  EXPECT_EQ(at(200, 300, 20).friction_moment, 200);
  EXPECT_EQ(at(400, 300, 20).friction_moment, 400);
  EXPECT_TRUE(at(310, 300, 40).has_value());
  EXPECT_TRUE(at(650, 300, 20).has_value());
}

TEST(StribeckTable, StatusIsThatOfThePointAndAMomentThatIsNotFiniteIsNone) {
  const auto table = build_stribeck_table(
      small_axes, {}, [](std::span<const OperatingPoint> points, std::span<TablePoint> results) {
        for (std::size_t i = 0; i < points.size(); ++i) {
          const bool fast = points[i].speed > 250;
          results[i].friction_moment = fast ? std::numeric_limits<double>::infinity() : 1.0;
          results[i].status = fast ? SolveStatus::not_finite : SolveStatus::no_equilibrium;
        }
      });
  for (std::size_t i = 0; i < small_axes.size(); ++i) {
    const bool fast = table.point(i).speed > 250;
    EXPECT_EQ(std::isnan(table.friction_moment[i]), fast);
    EXPECT_EQ(table.status[i], fast ? SolveStatus::not_finite : SolveStatus::no_equilibrium);
  }
}

/// A table of the base law with spin, each point started from the one before it.
StribeckTable bearing_table(const bearing::Bearing& bearing, const TableAxes& axes) {
  return build_stribeck_table(
      axes, {"spin"}, [&](std::span<const OperatingPoint> points, std::span<TablePoint> results) {
        bearing::BearingEquilibrium last;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const bearing::EquilibriumOptions options;
          last = last.report.converged()
                     ? solve_bearing_equilibrium(bearing, points[i], options, last)
                     : solve_bearing_equilibrium(bearing, points[i], options);
          results[i].status = last.report.status;
          if (!last.report.converged()) continue;
          const auto s = tests::state_of(bearing, last, points[i], options.race_control);
          const std::array values{1.5, 0.001, 0.33};
          const auto base = base_moments<double>(friction::FrictionLaw::palmgren, s, values);
          const auto spin = friction::unit_spin_friction(bearing, last, options.race_control);
          results[i].columns[0] = 0.06 * (spin.inner + spin.outer);
          results[i].friction_moment = base.load + base.viscous + results[i].columns[0];
        }
      });
}

TEST(StribeckTable, ThreadsDoNotChangeADigit) {
  const auto bearing = tests::spindle_bearing();
  const TableAxes axes{range(0, 10, 150), {300, 900}, {0, 100}, {kelvin(40)}};
  const auto with_threads = [&](std::size_t count) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, count);
    return bearing_table(bearing, axes);
  };
  const auto one = with_threads(1);
  for (const std::size_t count : {2u, 4u}) {
    const auto many = with_threads(count);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(one.friction_moment[i]),
                std::bit_cast<std::uint64_t>(many.friction_moment[i]));
      EXPECT_EQ(std::bit_cast<std::uint64_t>(one.values[i]),
                std::bit_cast<std::uint64_t>(many.values[i]));
    }
  }
  EXPECT_GT(one.friction_moment.back(), 0.0);
}

TEST(StribeckTable, SlabsTogetherAreTheTable) {
  const TableAxes axes{range(0, 1, 23), range(100, 1, 5), {0, 50, 90}, {300, 310}};
  const friction::TableLine line = [](std::span<const OperatingPoint> points,
                                      std::span<TablePoint> results) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      results[i].status = bearing::SolveStatus::converged;
      results[i].friction_moment = points[i].speed + points[i].axial_load;
      results[i].columns[0] = points[i].radial_load * points[i].temperature;
    }
  };
  const auto whole = build_stribeck_table(axes, {"x"}, line);
  for (const std::size_t count : {1u, 2u, 7u, 689u, 1000u}) {
    std::vector<double> moments, values;
    for (std::size_t index = 0; index < count; ++index) {
      const auto slab = build_stribeck_table(axes, {"x"}, line, {}, {index, count});
      EXPECT_EQ(slab.first(), moments.size());
      moments.insert(moments.end(), slab.friction_moment.begin(), slab.friction_moment.end());
      values.insert(values.end(), slab.values.begin(), slab.values.end());
    }
    EXPECT_EQ(moments, whole.friction_moment) << count << " slabs";
    EXPECT_EQ(values, whole.values) << count << " slabs";
  }
  EXPECT_THROW((void)build_stribeck_table(axes, {"x"}, line, {}, {3, 3}), std::invalid_argument);
  const auto slab = build_stribeck_table(axes, {"x"}, line, {}, {0, 2});
  EXPECT_THROW((void)interpolate(slab, {.speed = 1, .axial_load = 101}, Outside::error),
               std::invalid_argument);
}

TEST(StribeckTable, TellsItsProgressInOrder) {
  TableAxes axes{range(0, 1, 200), range(100, 1, 20), {0}, {300}};
  std::vector<double> told;
  (void)build_stribeck_table(
      axes, {}, [](std::span<const OperatingPoint>, std::span<TablePoint>) {},
      [&](double fraction) { told.push_back(fraction); });
  EXPECT_EQ(told.size(), 16u);  // pieces of 256 of 4000 points
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
}

TEST(StribeckTable, PassesOnWhatALineThrows) {
  EXPECT_THROW((void)build_stribeck_table(small_axes, {},
                                          [](std::span<const OperatingPoint>,
                                             std::span<TablePoint>) { throw std::bad_alloc(); }),
               std::bad_alloc);
}

TEST(StribeckTable, NamesTheAxisThatIsWrong) {
  const auto message = [](auto change) {
    TableAxes axes = small_axes;
    change(axes);
    return tests::message_of([&] { validate(axes); });
  };
  EXPECT_EQ(message([](TableAxes&) {}), "");
  EXPECT_THAT(message([](TableAxes& a) { a.speed.clear(); }), HasSubstr("speed: a table needs"));
  EXPECT_THAT(message([](TableAxes& a) {
                a.axial_load = {300, 100};
              }),
              HasSubstr("axial_load = 100 N: must be above the value before it, 300 N"));
  EXPECT_THAT(message([](TableAxes& a) { a.temperature = {300, 300}; }), HasSubstr("temperature"));
  EXPECT_THAT(message([](TableAxes& a) {
                a.radial_load = {-1, 0};
              }),
              HasSubstr("radial_load = -1 N"));
  EXPECT_THAT(message([](TableAxes& a) { a.speed = {unset}; }), HasSubstr("speed = nan rpm"));
}

}  // namespace
}  // namespace raceway

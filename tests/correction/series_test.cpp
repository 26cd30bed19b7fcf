#include "correction/series.h"

#include <gmock/gmock.h>

#include <numeric>
#include <stdexcept>

#include "correction/numbers.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Input input(const std::string& name) {
  return {.name = name, .columns = {record::series_channel(name)}};
}

double room_temperature(double t) { return 20.0 + 3.0 * std::sin(t / 4000.0); }

MadeRecord day() {
  MadeRecord made(30000, 30);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 6000); })
      .with("spindle_temperature_C", [](double t) { return 25.0 + 6.0 * std::sin(t / 3000.0); })
      .with("base_temperature_C", room_temperature)
      .with("x_feed_m_min", [](double t) { return t < 15000 ? -20.0 : 5.0; })
      .with("coolant_on", [](double t) { return t < 12000 ? 1.0 : 0.0; });
  return made;
}

/// dx/dt = (g(t) u - x)/T(t, x) in steps of a hundredth of those of the record, by the midpoint.
std::vector<double> integrated(const MadeRecord& made, const std::function<double(double)>& u,
                               const std::function<double(double, double)>& time_constant) {
  std::vector<double> states{0.0};
  double x = 0.0;
  for (std::size_t k = 1; k < made.time.size(); ++k) {
    constexpr int parts = 100;
    const double h = (made.time[k] - made.time[k - 1]) / parts;
    for (int i = 0; i < parts; ++i) {
      const double t = made.time[k - 1] + i * h;
      const double half = x + 0.5 * h * (u(t) - x) / time_constant(t, x);
      x += h * (u(t + 0.5 * h) - half) / time_constant(t + 0.5 * h, half);
    }
    states.push_back(x);
  }
  return states;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  double worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::abs(a[k] - b[k]));
  EXPECT_LT(worst, tolerance);
}

TEST(Series, TemperaturesCountFromTheFirstRowLessTheReference) {
  const MadeRecord made = day();
  const Series series(made.record);
  Input of = input("spindle_temperature_C");
  of.reference = record::series_channel("base_temperature_C");
  const auto values = series.input(of);
  EXPECT_EQ(values->front(), 0.0);
  const double t = made.time[100];
  EXPECT_NEAR((*values)[100],
              6.0 * std::sin(t / 3000.0) - (room_temperature(t) - room_temperature(0)), 1e-9);
}

TEST(Series, FeedsActByTheirAbsoluteValue) {
  const MadeRecord made = day();
  const Series series(made.record);
  EXPECT_NEAR(series.input(input("x_feed_m_min"))->front(), 20.0 / 60.0, 1e-12);
}

TEST(Series, AMeanOfColumnsDrives) {
  const MadeRecord made = day();
  Input of = input("spindle_temperature_C");
  of.columns.push_back(record::series_channel("base_temperature_C"));
  const Series series(made.record);
  const double t = made.time[50];
  EXPECT_NEAR((*series.input(of))[50],
              0.5 * (6.0 * std::sin(t / 3000.0) + room_temperature(t) - room_temperature(0)), 1e-9);
}

TEST(Series, ALagThatDependsOnTheSpeedIsThatOfTheEquation) {
  const MadeRecord made = day();
  const Series series(made.record);
  const auto speed = [](double t) { return stepped_speed(t, 6000); };
  const auto f = [&](double t) { return 1.0 / (1.0 + 2.0 * speed(t) / 10000.0); };
  const auto lag =
      series.lag(input("spindle_temperature_C"), 2500, {.speed_factor = 2.0, .gain_power = 0.7});
  expect_near(*lag,
              integrated(
                  made, [&](double t) { return std::pow(f(t), 0.7) * 6.0 * std::sin(t / 3000.0); },
                  [&](double t, double) { return 2500 * f(t); }),
              2e-3);
}

TEST(Series, ALagWithTheCoolantOffIsThatOfTheEquation) {
  const MadeRecord made = day();
  const Series series(made.record);
  const auto off = [](double t) { return t >= 12000; };
  const auto lag =
      series.lag(input("spindle_temperature_C"), 1800, {.off_gain = 1.6, .off_time_constant = 2.5});
  expect_near(*lag,
              integrated(
                  made, [&](double t) { return (off(t) ? 1.6 : 1.0) * 6.0 * std::sin(t / 3000.0); },
                  [&](double t, double) { return off(t) ? 2.5 * 1800 : 1800; }),
              2e-3);
}

TEST(Series, ALagThatFallsOtherwiseIsThatOfTheEquation) {
  const MadeRecord made = day();
  const Series series(made.record);
  const auto u = [](double t) { return 6.0 * std::sin(t / 3000.0); };
  const auto lag = series.lag(input("spindle_temperature_C"), 1800, {.falling = 3.0});
  // The side changes within a row; the row as a whole takes one of them.
  expect_near(*lag,
              integrated(made, u, [&](double t, double x) { return u(t) < x ? 5400.0 : 1800.0; }),
              2e-2);
}

/// A sensor that lags behind T shows T/(1 + s tau_s): taking that back gives the lag of T itself.
TEST(Series, ALaggingSensorIsTakenBack) {
  MadeRecord made = day();
  const auto shown = integrated(
      made, [](double t) { return 6.0 * std::sin(t / 3000.0); },
      [](double, double) { return 400.0; });
  made.with("spindle_temperature_C", [&](double t) {
    return 25.0 + shown[static_cast<std::size_t>(std::lround(t / 30.0))];
  });
  const Series series(made.record);
  const auto lag =
      series.lag(input("spindle_temperature_C"), 2500, {.sensor_time_constant = 400.0});
  expect_near(*lag,
              integrated(
                  made, [](double t) { return 6.0 * std::sin(t / 3000.0); },
                  [](double, double) { return 2500.0; }),
              5e-3);
}

TEST(Series, TheKinematicLawIsThePublishedOne) {
  MadeRecord made(600, 60);
  made.with("speed_rpm", [](double) { return 10000.0; });
  EXPECT_NEAR(1.28e-3 * Series(made.record).kinematic(0.697, 5.3e-4)->front(), 12.396, 5e-4);
}

TEST(Series, RunsAndClampingsHaveZerosOfTheirOwn) {
  MadeRecord made(300, 30);
  made.record.runs = {"a", "b"};
  std::vector<double> run(11, 0.0), setup(11, 0.0);
  for (std::size_t k = 5; k < 11; ++k) run[k] = 1.0;
  for (std::size_t k = 8; k < 11; ++k) setup[k] = 1.0;
  made.record.set(record::run, run);
  made.record.set(*record::series_channel("setup_id"), setup);
  const Series series(made.record);
  EXPECT_EQ(series.zeros(), 3);
  EXPECT_TRUE(series.clock().begins[5]);
  EXPECT_FALSE(series.clock().begins[8]);
}

/// What was set from each row on, as a logger has it that stamps the end of an interval.
MadeRecord stamped_at_the_end(MadeRecord made) {
  for (record::Column& column : made.record.columns)
    if (column.channel->is_input() && record::course_of(*column.channel) == record::Course::held)
      for (std::size_t k = column.values.size() - 1; k > 0; --k)
        column.values[k] = column.values[k - 1];
  made.record.settings_hold = record::SettingsHold::until_row;
  return made;
}

TEST(Series, EventsAndIntervalsOfOneProgrammeAreAnsweredAlike) {
  MadeRecord events = day();
  events.record.settings_hold = record::SettingsHold::from_row;
  const MadeRecord intervals = stamped_at_the_end(day());
  const Series a(events.record), b(intervals.record);
  const Input feed = input("x_feed_m_min"), warmth = input("spindle_temperature_C");
  EXPECT_EQ(*a.lag(feed, 2500, {}), *b.lag(feed, 2500, {}));
  EXPECT_EQ(*a.at_once(feed), *b.at_once(feed));
  EXPECT_EQ(*a.motor(3000, 900), *b.motor(3000, 900));
  EXPECT_EQ(*a.kinematic(0.697, 5.3e-4), *b.kinematic(0.697, 5.3e-4));
  const Answer answer{.off_gain = 1.6, .speed_factor = 2.0};
  EXPECT_EQ(*a.lag(warmth, 2500, answer), *b.lag(warmth, 2500, answer));
  EXPECT_EQ(*a.lag(feed, 2500, answer), *b.lag(feed, 2500, answer));
}

TEST(Series, AReadingWithoutAStatementSeesTheSpeedOfItsRow) {
  const MadeRecord sampled = day();
  MadeRecord events = day();
  events.record.settings_hold = record::SettingsHold::from_row;
  const Series a(sampled.record), b(events.record);
  constexpr std::size_t change = 200;  // 6000 s
  const auto law = [](const Series& s) { return *s.kinematic(0.697, 5.3e-4); };
  EXPECT_EQ(law(a)[change], law(a)[change + 1]);
  EXPECT_EQ(law(b)[change], law(b)[change - 1]);
  EXPECT_EQ(*a.lag(input("x_feed_m_min"), 2500, {}), *b.lag(input("x_feed_m_min"), 2500, {}));
}

TEST(Series, TimeThatGoesBackIsRefused) {
  record::Record record{.source = "made.csv"};
  record.set(record::time, {0, 60, 30});
  EXPECT_THAT([&] { Series{record}; },
              ThrowsMessage<std::invalid_argument>(HasSubstr("earlier than 60 s")));
  record.set(record::time, {0, 60, 60});
  EXPECT_THAT([&] { Series{record}; },
              ThrowsMessage<std::invalid_argument>(HasSubstr("the same as 60 s")));
}

TEST(FrictionTable, IsStraightBetweenItsPointsAndHoldsItsEdges) {
  const FrictionTable table{
      .speed = {0, 100}, .axial_load = {500}, .temperature = {300, 320}, .torque = {1, 2, 3, 6}};
  EXPECT_NEAR(table({50, 500, 0, 300}), 1.5, 1e-14);
  EXPECT_NEAR(table({50, 500, 0, 310}), 3.0, 1e-14);
  EXPECT_NEAR(table({200, 900, 0, 350}), 6.0, 1e-14);
  EXPECT_TRUE(table.holds({50, 900, 0, 310}));
  EXPECT_FALSE(table.holds({101, 500, 0, 310}));
}

/// Torque (1 + n)(2 + F_a)(3 + F_r)(T - 290), which straight lines between points give exactly.
FrictionTable product_table(std::vector<double> axial) {
  FrictionTable table{.file = "t.csv",
                      .speed = {0, 10, 25},
                      .axial_load = std::move(axial),
                      .radial_load = {0, 4},
                      .temperature = {300, 310, 330}};
  for (const double T : table.temperature)
    for (const double radial : table.radial_load)
      for (const double load : table.axial_load)
        for (const double n : table.speed)
          table.torque.push_back((1 + n) * (2 + load) * (3 + radial) * (T - 290));
  return table;
}

TEST(FrictionTable, IsReadAtBothLoads) {
  const FrictionTable table = product_table({1, 3, 9});
  EXPECT_NEAR(table({20, 7, 1, 315}), 21.0 * 9 * 4 * 25, 1e-9);
  EXPECT_EQ(table({20, -7, -1, 315}), table({20, 7, 1, 315}));  // by their amount
  EXPECT_EQ(table({20, 12, 5, 315}), table({20, 9, 4, 315}));
  EXPECT_TRUE(table.holds({20, -7, -1, 315}));
  EXPECT_FALSE(table.holds({20, 7, 5, 315}));
  EXPECT_FALSE(table.holds({20, 0.5, 1, 315}));
  // A table that has loads of both signs tells them apart.
  EXPECT_NEAR(product_table({-1, 3, 9})({20, -0.5, 1, 315}), 21.0 * 1.5 * 4 * 25, 1e-9);
}

TEST(Series, ThePowerFollowsRecordedLoads) {
  record::Record record{.source = "made.csv"};
  record.set(record::time, {0, 60, 120, 180});
  record.set(record::speed, {20, -20, 0, 10});
  record.set(record::axial_load, {7, -3, 50, 50});
  record.set(record::radial_load, {1, 4, 0, 2});
  const Channel& oil = *record::series_channel("oil_temperature_C");
  record.set(oil, {315, 300, 300, 320});
  const Input power{.name = "power_W",
                    .table = std::make_shared<const FrictionTable>(product_table({1, 3, 9})),
                    .axial_load = {.column = &record::axial_load},
                    .radial_load = {.column = &record::radial_load},
                    .temperature = {.column = &oil}};
  const Series series(record);
  const double expected[] = {20 * 21.0 * 9 * 4 * 25, 20 * 21.0 * 5 * 7 * 10, 0,
                             10 * 11.0 * 11 * 5 * 30};  // 50 N counts as 9 N
  const auto values = series.input(power);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR((*values)[k], expected[k], 1e-8) << k;
  EXPECT_EQ(series.rows_beyond_table(power), 1U);

  record::Record without{.source = "made.csv"};
  without.set(record::time, {0, 60});
  without.set(record::speed, {20, 20});
  without.set(record::axial_load, {7, 7});
  EXPECT_THAT([&] { (void)Series(without).input(power); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("needs a column radial_load_N")));
}

}  // namespace
}  // namespace raceway::correction

#include "correction/range.h"

#include <gmock/gmock.h>

#include <cmath>

#include "correction/alignment.h"
#include "correction/band.h"
#include "correction/simulation.h"
#include "loop/loop.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

const Channel& series_column(const std::string& name) { return *record::series_channel(name); }

TEST(Continued, IsTheLawWithinAndNeverSteeperThanItsTangentBeyond) {
  const auto check = [](const auto& law, const auto& slope, Interval seen, double x) {
    const double edge = std::clamp(x, seen.lower, seen.upper);
    const double moved = continued(law, seen, x) - law(edge), along = slope(edge) * (x - edge);
    EXPECT_GE(moved * along, 0.0) << x;
    EXPECT_LE(std::abs(moved), std::abs(along) * (1.0 + 1e-5)) << x;
    EXPECT_LE(std::abs(moved), std::abs(law(x) - law(edge)) * (1.0 + 1e-12)) << x;
  };
  const Interval seen{1000.0, 6000.0};
  for (const double x : {1.0, 400.0, 7000.0, 20000.0}) {
    check([](double n) { return n * n; }, [](double n) { return 2 * n; }, seen, x);
    check([](double n) { return std::sqrt(n); }, [](double n) { return 0.5 / std::sqrt(n); }, seen,
          x);
    check([](double n) { return std::exp(-n / 2000); },
          [](double n) { return -std::exp(-n / 2000) / 2000; }, seen, x);
  }
  const auto square = [](double n) { return n * n; };
  for (const double x : {1000.0, 3000.0, 6000.0}) EXPECT_EQ(continued(square, seen, x), x * x);
  // Above, the square is steeper than its tangent; below, flatter.
  EXPECT_NEAR(continued(square, seen, 7000), 36e6 + 2 * 6000 * 1000, 100);
  EXPECT_EQ(continued(square, seen, 500), 250e3);
  // A law that turns round holds at its edge.
  EXPECT_EQ(continued([](double n) { return std::abs(n - 6500); }, seen, 9000), 500);
}

/// A spindle that is cooled: temperatures go their own ways.
MadeRecord cooled_record() {
  MadeRecord made(40000, 20);
  made.with("front_temperature_C", [](double t) { return 30 + 8 * std::sin(t / 3000.0); })
      .with("coolant_temperature_C", [](double t) { return 22 + 2 * std::sin(t / 1700.0); })
      .with("speed_rpm", [](double t) { return stepped_speed(t, 2500); });
  return made;
}

Model driven_model() {
  Model m{.name = "z", .displacement = &series_column("displacement_z_um")};
  m.tolerance = 1e-6;
  m.channels = {{.name = "front",
                 .input = {.columns = {&series_column("front_temperature_C")}},
                 .sections = {{5e-6, 1800}}},
                {.name = "coolant",
                 .input = {.columns = {&series_column("coolant_temperature_C")}},
                 .sections = {{3e-6, 900}}}};
  return m;
}

Model seen_cooled_model() {
  Model m = driven_model();
  see(m, cooled_record().record);
  return m;
}

const Beyond::Part* part_of(const Beyond& beyond, const std::string& name) {
  for (const Beyond::Part& p : beyond.parts)
    if (p.name == name) return &p;
  return nullptr;
}

TEST(Range, TheRecordOfTheNumbersLiesWithin) {
  const MadeRecord made = cooled_record();
  const Series series(made.record);
  const Beyond beyond = beyond_range(seen_cooled_model(), series);
  EXPECT_TRUE(beyond.known);
  EXPECT_TRUE(beyond.parts.empty());
  EXPECT_EQ(beyond.rows(), 0U);
  for (const double e : extrapolated(seen_cooled_model(), series, beyond)) EXPECT_EQ(e, 0.0);
}

/// The failure to make impossible: a regression that extrapolates in silence.
TEST(Range, ACoolantColderThanEverBeforeIsToldAndWidensTheBand) {
  Model m = seen_cooled_model();
  m.covariance = fit::Covariance{.names = {"coolant.gain_1"},
                                 .values = Eigen::VectorXd::Constant(1, 3.0),
                                 .matrix = Eigen::MatrixXd::Constant(1, 1, 0.01)};
  m.left = Left{.rms = 0.5e-6, .correlation_time = 1000};
  MadeRecord made = cooled_record();
  const double cold_from = 24000;
  made.with("coolant_temperature_C",
            [&](double t) { return t < cold_from ? 22.0 : 22.0 - 12.0 * (t - cold_from) / 4000; });
  const auto series = std::make_shared<const Series>(made.record);
  const Beyond beyond = beyond_range(m, *series);
  const Beyond::Part* const cold = part_of(beyond, "coolant_temperature_C");
  ASSERT_NE(cold, nullptr);
  EXPECT_NEAR(celsius(cold->lower), 20.0, 1e-4);
  // 2 K further down, 12 K in 4000 s.
  EXPECT_NEAR(series->time()[cold->first], cold_from + 2.0 / 12.0 * 4000, 20.0);
  EXPECT_LE(cold->value, cold->lower);
  EXPECT_NEAR(celsius(cold->farthest), 22.0 - 12.0 * 4, 1e-6);
  EXPECT_EQ(cold->rows, series->rows() - cold->first);
  const auto subject = aligned(m, made.record, Zero::none);
  const Band band = band_of(*subject, m, series, beyond);
  const std::vector<double> half = band.half_width();
  for (std::size_t k = 1; k < half.size(); ++k) {
    if (k < cold->first) {
      EXPECT_EQ(band.extrapolated[k], 0.0) << k;
      EXPECT_LT(half[k], 3e-6) << k;
    } else {
      EXPECT_GT(half[k], half[k - 1]) << k;
    }
  }
  // 3 um/K of what is left of the way down after 900 s, twice: from nothing more to as much again.
  const double further = 3e-6 * (20.0 - (22.0 - 48.0) - 900 * 12.0 / 4000);
  // Drawn a little nearer to what stood together: the corner of two ranges was not met.
  EXPECT_NEAR(band.extrapolated.back(), further, 0.1e-6);
}

TEST(Range, ARoomThatIsWarmWhileTheSpindleIsColdWasNeverSeen) {
  MadeRecord made(40000, 20);
  const auto warmth = [](double t) { return 1.0 - std::cos(t / 3000.0); };
  made.with("front_temperature_C", [&](double t) { return 22 + 10 * warmth(t); })
      .with("coolant_temperature_C",
            [&](double t) { return 21 + 3 * warmth(t) + 0.2 * std::sin(t / 170.0); });
  Model m = driven_model();
  see(m, made.record);
  ASSERT_TRUE(m.together);
  MadeRecord other(20000, 20);
  other.with("front_temperature_C", [](double) { return 23.0; })
      .with("coolant_temperature_C", [](double t) { return t < 10000 ? 21.5 : 26.5; });
  const Series series(other.record);
  const Beyond beyond = beyond_range(m, series);
  ASSERT_EQ(beyond.parts.size(), 1U);  // each by itself has stood there
  const Beyond::Part& apart = beyond.parts.front();
  EXPECT_TRUE(apart.together());
  EXPECT_EQ(series.time()[apart.first], 10000.0);
  EXPECT_GT(apart.value, 1.5 * apart.upper);
  const std::vector<double> size = extrapolated(m, series, beyond);
  EXPECT_EQ(size[apart.first - 1], 0.0);
  EXPECT_GT(size.back(), 1e-6);
}

TEST(Range, SizesActWithoutTheirSign) {
  MadeRecord made = cooled_record();
  Model m = driven_model();
  m.kinematic = Kinematic{1.28e-3, 0.697, 5.3e-4};
  see(m, made.record);
  EXPECT_EQ(seen_speed(m).lower, 0.0);
  EXPECT_NEAR(seen_speed(m).upper, 9000.0, 1e-9);
  made.with("speed_rpm", [](double t) { return -stepped_speed(t, 2500); });
  EXPECT_TRUE(beyond_range(m, Series(made.record)).parts.empty());
}

/// Displacement of a model of one law after a long time at each speed, with and without what it
/// saw.
double displacement_settled(Model m, double speed, double lowest, double highest) {
  m.range = {{.column = &record::speed,
              .name = "speed_rpm",
              .lower = lowest * rpm,
              .upper = highest * rpm}};
  MadeRecord made(200000, 100);
  made.with("speed_rpm", [&](double) { return speed; });
  std::vector<double> y(made.time.size());
  simulate(m, Series(made.record), y);
  return y.back();
}

TEST(Range, LawsOfTheSpeedAreBoundedBeyondIt) {
  const double endless = std::numeric_limits<double>::infinity();
  Model law{.displacement = &series_column("displacement_z_um")};
  law.kinematic = Kinematic{1e-3, 1.2, 1e-4};  // steeper and steeper
  const auto bounded = [&](double n) { return displacement_settled(law, n, 2000, 6000); };
  const auto free = [&](double n) { return displacement_settled(law, n, 0, endless); };
  for (const double n : {0.0, 1000.0, 2000.0, 6000.0}) EXPECT_EQ(bounded(n), free(n)) << n;
  const double slope = (free(6000) - free(5999));
  EXPECT_GT(free(12000) - free(6000), 1.5 * slope * 6000);
  EXPECT_NEAR(bounded(12000) - free(6000), slope * 6000, 1e-3 * slope * 6000);

  Model motor{.displacement = &series_column("displacement_z_um")};
  motor.effects = {{.id = "motor-heat", .values = {10.0, 600.0, 500.0}}};
  const auto heat = [&](double n) { return displacement_settled(motor, n, 1500, 6000) / 10e-6; };
  EXPECT_NEAR(heat(1500), std::exp(-3.0), 1e-9);
  EXPECT_NEAR(heat(500), std::exp(-3.0) * (1 + 1000.0 / 500), 1e-5);  // the law itself: e^-1
  EXPECT_NEAR(heat(9000), std::exp(-18.0), 1e-12);                    // flatter by itself
  EXPECT_EQ(heat(0), 0.0);

  Model lag{.displacement = &series_column("displacement_z_um")};
  lag.channels = {
      {.name = "s", .input = {.columns = {&record::speed}}, .sections = {{1e-6 / rpm, 1000}}}};
  lag.effects = {{.id = "speed-dependent-time-constant", .values = {6.0, 1.5}}};
  const auto gain = [&](double n, double lowest) {
    return displacement_settled(lag, n, lowest, 10000) / (1e-6 * n);
  };
  const auto f = [](double n) { return std::pow(1 + 6.0 * n / 10000, -1.5); };
  EXPECT_NEAR(gain(5000, 5000), f(5000), 1e-9);
  const double tangent = -1.5 * 6e-4 * std::pow(1 + 6.0 * 0.5, -2.5);
  EXPECT_NEAR(gain(1000, 5000), f(5000) - 4000 * tangent, 1e-6);
  EXPECT_GT(gain(1000, 0), 1.5 * gain(1000, 5000));
}

TEST(Range, ADelayElementIsBoundedBeyondThePowersSeenAndRefusesWhatItRefused) {
  const Clock clock{{0, 1e7, 1e7, 1e7}, {true, false, false, false}};
  const DelayElement element{Characteristic::Power{1e-9, 2.0},
                             Characteristic::Line{-60.0 * 0.6298, 60.0 * 135.245}};
  std::vector<double> y(4);
  const std::vector<double> power{100.0, 150.0, 0.0, 0.0};
  delay_response(clock, power, element, y, {20.0, 100.0});
  EXPECT_NEAR(y[1], 1e-5, 1e-12);
  EXPECT_NEAR(y[2], 1e-5 + 2e-7 * 50, 1e-10);  // 2.25e-5 by the law
  EXPECT_NEAR(y[3], 0.0, 1e-12);               // nothing heats at rest
  delay_response(clock, std::vector<double>{100.0, 215.0, 0.0, 0.0}, element, y, {20.0, 100.0});
  EXPECT_TRUE(std::isnan(y[2]));
  EXPECT_TRUE(std::isnan(y[3]));
}

/// What is fitted to a record has seen all of it, whatever the file says of another one.
TEST(Range, AFitIsNotBoundedByTheRangeOfTheRecordBefore) {
  Model m{.displacement = &series_column("displacement_z_um")};
  m.tolerance = 1e-6;
  m.kinematic = Kinematic{1e-3, 1.2, 1e-4};
  m.free = {"kinematic.A"};
  MadeRecord made(40000, 20);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 2500); });
  std::vector<double> y(made.time.size());
  simulate(m, Series(made.record), y);
  made.record.set(*m.displacement, y);
  m.range = {{.column = &record::speed, .name = "speed_rpm", .lower = 0, .upper = 3000 * rpm}};
  m.kinematic->A = 2e-3;
  const verdict::Calibration found = loop::calibrate(CorrectionSubject(m), made.record);
  EXPECT_NEAR(model_of(*found.subject).kinematic->A, 1e-3, 1e-9);
  const Model trusted_model = trusted(found, made.record);
  EXPECT_NEAR(seen_speed(trusted_model).upper, 9000, 1e-9);
  // Held against a record, the range counts.
  const auto subject = aligned(m, made.record, Zero::none);
  EXPECT_EQ(subject->model().range.size(), 1U);
}

/// y = g x: its error is that of g times x, and none where two gains on one lag cancel.
TEST(Band, IsThePropagatedErrorOfTheNumbers) {
  const MadeRecord made = cooled_record();
  Model m = driven_model();
  m.channels.push_back(m.channels.front());
  m.channels.back().name = "again";
  const auto series = std::make_shared<const Series>(made.record);
  const auto of_numbers = [&](const Eigen::Matrix2d& matrix) {
    m.covariance = fit::Covariance{.names = {"front.gain_1", "again.gain_1"},
                                   .values = Eigen::Vector2d(5.0, 5.0),
                                   .matrix = matrix};
    return band_of(*aligned(m, made.record, Zero::none), m, series, {}).of_numbers;
  };
  const std::vector<double> x = *series->lag(m.channels[0].input, 1800, {});
  const std::vector<double> apart = of_numbers(Eigen::Vector2d(0.09, 0.16).asDiagonal());
  const std::vector<double> against =
      of_numbers((Eigen::Matrix2d() << 0.09, -0.09, -0.09, 0.09).finished());
  for (std::size_t k = 0; k < x.size(); ++k) {
    EXPECT_NEAR(apart[k], 0.5e-6 * std::abs(x[k]), 1e-12);
    EXPECT_NEAR(against[k], 0.0, 1e-12);
  }
}

TEST(Band, ALastDigitInTheFirstRowsStays) {
  MadeRecord made(40000, 20);
  made.with("front_temperature_C",
            [](double t) { return 30 + 0.5 * std::round(16 * std::sin(t / 3000.0)); })
      .with("coolant_temperature_C", [](double t) { return 22 + 2 * std::sin(t / 1700.0); });
  Model m = driven_model();
  m.covariance = fit::Covariance{.names = {"offset"},
                                 .values = Eigen::VectorXd::Zero(1),
                                 .matrix = Eigen::MatrixXd::Zero(1, 1)};
  const auto series = std::make_shared<const Series>(made.record);
  const Band band = band_of(*aligned(m, made.record, Zero::none), m, series, {});
  EXPECT_EQ(band.of_beginning.front(), 0.0);
  // 5 um/K of 0.5 K, evenly spread, in two records.
  EXPECT_NEAR(band.of_beginning.back(), 5e-6 * 0.5 * std::sqrt(2.0 / 12.0), 1e-10);
}

}  // namespace
}  // namespace raceway::correction

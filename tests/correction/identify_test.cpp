#include "correction/identify.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "correction/alignment.h"
#include "correction/record_check.h"
#include "correction/simulation.h"
#include "fit/problem.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Answer of a lag to a ramp of slope r from 0: r (t - tau + tau exp(-t/tau)).
double ramp(double t, double slope, double tau) {
  return t <= 0.0 ? 0.0 : slope * (t - tau * -std::expm1(-t / tau));
}

/// A temperature of straight pieces, and its lags in closed form, piece by piece.
struct Pieces {
  std::vector<std::pair<double, double>> turns;  // time [s], slope from there on [K/s]
  [[nodiscard]] double value(double t) const {
    double sum = 0.0, before = 0.0;
    for (const auto& [at, slope] : turns) {
      sum += (slope - before) * std::max(0.0, t - at);
      before = slope;
    }
    return sum;
  }
  [[nodiscard]] double lag(double t, double tau) const {
    double sum = 0.0, before = 0.0;
    for (const auto& [at, slope] : turns) {
      sum += ramp(t - at, slope - before, tau);
      before = slope;
    }
    return sum;
  }
};

const Pieces bearing_rise{
    {{0, 3e-3}, {4000, 0}, {12000, -2e-3}, {16000, 4e-3}, {19000, -1e-3}, {30000, 0}}};
const Pieces room{{{0, 2e-4}, {9000, -4e-4}, {20000, 3e-4}}};

MadeRecord made_record() {
  MadeRecord made(40000, 20);
  made.with("front_temperature_C", [](double t) { return 22 + bearing_rise.value(t); })
      .with("ambient_temperature_C", [](double t) { return 20 + room.value(t); })
      .with("displacement_z_um", [](double t) {
        return 1.5 + 5 * bearing_rise.lag(t, 5400) + 3 * bearing_rise.lag(t, 900) -
               2.5 * room.lag(t, 8000);
      });
  return made;
}

Model start() {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.tolerance = 1e-6;
  for (const char* name : {"front", "ambient"})
    m.channels.push_back(
        {.name = name,
         .input = {.columns = {record::series_channel(std::string(name) + "_temperature_C")}},
         .sections = {{2e-6, 3000}}});
  return m;
}

TEST(Identify, FindsOrdersGainsAndTimeConstantsOfAClosedForm) {
  const MadeRecord made = made_record();
  const Identification found = identify(start(), made.record);
  ASSERT_EQ(found.model.channels[0].sections.size(), 2U);
  ASSERT_EQ(found.model.channels[1].sections.size(), 1U);
  std::vector<Section> s = found.model.channels[0].sections;
  if (s[0].time_constant < s[1].time_constant) std::swap(s[0], s[1]);
  EXPECT_NEAR(s[0].gain / um, 5.0, 5e-6);
  EXPECT_NEAR(s[0].time_constant, 5400, 5e-3);
  EXPECT_NEAR(s[1].gain / um, 3.0, 3e-6);
  EXPECT_NEAR(s[1].time_constant, 900, 1e-3);
  EXPECT_NEAR(found.model.channels[1].sections[0].gain / um, -2.5, 3e-6);
  EXPECT_NEAR(found.model.channels[1].sections[0].time_constant, 8000, 1e-2);
  EXPECT_NEAR(found.model.offset / um, 1.5, 1e-6);
}

TEST(Identify, TakesUpTheInputsThatHelp) {
  MadeRecord made = made_record();
  made.with("spare_temperature_C", [](double t) { return 20 + std::sin(t / 700.0); });
  Model m = start();
  m.channels.clear();
  const Identification found =
      identify(m, made.record,
               {.offered = {record::series_channel("spare_temperature_C"),
                            record::series_channel("ambient_temperature_C"),
                            record::series_channel("front_temperature_C")}});
  ASSERT_EQ(found.model.channels.size(), 2U);
  EXPECT_EQ(found.model.channels[0].name, "front");
  EXPECT_EQ(found.model.channels[1].name, "ambient");
}

TEST(Identify, AWarmMachineIsFoundFromItsFirstReadings) {
  MadeRecord made = made_record();
  // The record begins at 8000 s of the other one.
  const auto later = [](double t) { return t + 8000.0; };
  made.with("front_temperature_C", [&](double t) { return 22 + bearing_rise.value(later(t)); })
      .with("ambient_temperature_C", [&](double t) { return 20 + room.value(later(t)); })
      .with("displacement_z_um", [&](double t) {
        return 5 * bearing_rise.lag(later(t), 5400) + 3 * bearing_rise.lag(later(t), 900) -
               2.5 * room.lag(later(t), 8000);
      });
  Model m = start();
  m.initial_state = InitialState::free;
  m.channels[0].sections = {{5e-6, 5400}, {3e-6, 900}};
  m.channels[1].sections = {{-2.5e-6, 8000}};
  // With the right numbers the states are all that is missing.
  const auto subject = aligned(m, made.record, Zero::mean);
  EXPECT_LT(metrics(made.record.values(*m.displacement), fit::predict(*subject, made.record)).rms,
            1e-9);
  EXPECT_LT(identify(m, made.record).metrics.rms, 1e-9);
}

TEST(Identify, CarriesTheRangeOfItsInputs) {
  const Identification found = identify(start(), made_record().record);
  ASSERT_EQ(found.model.range.size(), 2U);
  EXPECT_NEAR(celsius(found.model.range[0].lower), 22.0, 1e-9);
  EXPECT_NEAR(celsius(found.model.range[0].upper), 22.0 + 16.0, 1e-9);
}

/// Told to end at any time it leaves no numbers: those of a search that was cut short are none.
TEST(Identify, EndsWhereItIsTold) {
  const MadeRecord made = made_record();
  int asked = 0;
  IdentifyOptions options{.highest_order = 2};
  options.cancelled = [&] { return ++asked < 0; };
  (void)identify(start(), made.record, options);
  const int all = asked;
  ASSERT_GT(all, 10);
  for (int last = 0; last < all; last += 1 + all / 20) {
    asked = 0;
    options.cancelled = [&] { return asked++ >= last; };
    EXPECT_THROW((void)identify(start(), made.record, options), fit::Cancelled) << last;
  }
}

TEST(Identify, ARecordThatIsTooShortIsSaid) {
  MadeRecord made = made_record();
  std::vector<std::size_t> rows(40);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = k;
  EXPECT_THROW((void)identify(start(), made.record.picked(rows)), std::invalid_argument);
}

/// The usual reason for too few readings in a long file: 11 h become 11 min.
TEST(Identify, ARecordInMinutesIsAskedForTheUnitOfItsTime) {
  record::Record record = made_record().record;
  for (double& t : record.find(record::time)->values) t /= 60.0;
  EXPECT_THAT([&] { (void)identify(start(), record); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr(fmt::format(
                  "the record has {} rows over 666.7 s. Is time_s in seconds?", record.rows()))));
}

TEST(Alignment, TakesOneConstantOffEveryRun) {
  MadeRecord made = made_record();
  made.record.runs = {"a", "b"};
  std::vector<double> run(made.time.size(), 0.0);
  for (std::size_t k = 1000; k < run.size(); ++k) run[k] = 1.0;
  made.record.set(record::run, run);
  Model m = start();
  m.channels.clear();
  made.with("displacement_z_um", [](double t) { return t < 20000 ? 4.0 : -3.0; });
  for (const Zero zero : {Zero::mean, Zero::first})
    EXPECT_LT(metrics(made.record.values(*m.displacement),
                      fit::predict(*aligned(m, made.record, zero), made.record))
                  .rms,
              1e-12);
  EXPECT_NEAR(metrics(made.record.values(*m.displacement),
                      fit::predict(*aligned(m, made.record, Zero::none), made.record))
                      .max_abs /
                  um,
              4.0, 1e-9);
}

TEST(RecordCheck, NamesWhatIsWrongWithSensors) {
  MadeRecord made = made_record();
  made.with("dead_temperature_C", [](double) { return 21.0; })
      .with(
          "stuck_temperature_C",
          [](double t) { return 20 + room.value(std::min(t, 21000.0)) + (t > 24000 ? 0.4 : 0.0); })
      .with("jumping_temperature_C",
            [](double t) { return 20 + room.value(t) + (t > 15000 ? 6.0 : 0.0); });
  const RecordCheck check = check_record(start(), made.record);
  EXPECT_THAT(texts(check.warnings), Contains(HasSubstr("dead_temperature_C does not vary")));
  EXPECT_THAT(texts(check.warnings), Contains(HasSubstr("stuck_temperature_C is constant")));
  EXPECT_THAT(texts(check.warnings), Contains(HasSubstr("jumping_temperature_C jumps")));
  EXPECT_EQ(check.sampling, 20.0);
  EXPECT_EQ(check.shortest, 40.0);
  EXPECT_EQ(check.longest, 20000.0);
}

TEST(RecordCheck, AGapIsNoSensorThatSticks) {
  MadeRecord made = made_record();
  made.with("same_temperature_C",
            [](double t) {
              return 20.0 + 1e-4 * (t <= 15000 ? t : t < 19000 ? 15000 : t - 4000);
            })
      .with("moving_temperature_C",
            [](double t) { return 20 + 1e-4 * t + (t > 17000 ? 6.0 : 0.0); });
  const auto sticks = Contains(HasSubstr("same_temperature_C is constant"));
  EXPECT_THAT(texts(check_record(start(), made.record).warnings), sticks);
  const std::span<const double> time = made.record.values(record::time);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < time.size(); ++row)
    if (time[row] <= 15000 || time[row] >= 19000) rows.push_back(row);
  EXPECT_THAT(texts(check_record(start(), made.record.picked(rows)).warnings),
              testing::Not(sticks));
}

/// A speed that is there from the first row on is a step; one that is 0 throughout is nothing.
TEST(RecordCheck, ASpeedFromTheFirstRowOnIsAStep) {
  MadeRecord step(3600, 60);
  step.with("speed_rpm", [](double) { return 5000.0; })
      .with("table_speed_rpm", [](double) { return 0.0; })
      .with("displacement_z_um", [](double t) { return t / 600; });
  const Model of_step{.displacement = record::series_channel("displacement_z_um")};
  const RecordCheck check = check_record(of_step, step.record);
  EXPECT_THAT(texts(check.warnings),
              testing::Not(Contains(testing::StartsWith("speed_rpm never varies"))));
  EXPECT_THAT(texts(check.warnings), Contains(HasSubstr("table_speed_rpm does not vary")));
}

TEST(RecordCheck, FindsTheLastDigitOfASensor) {
  MadeRecord made = made_record();
  made.with("front_temperature_C",
            [](double t) { return std::round((22 + bearing_rise.value(t)) / 0.05) * 0.05; });
  const RecordCheck check = check_record(start(), made.record);
  bool found = false;
  for (const RecordCheck::Quantum& q : check.quanta)
    if (q.column->name == "front_temperature_C") {
      EXPECT_NEAR(q.step, 0.05, 1e-6);
      found = true;
    }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace raceway::correction

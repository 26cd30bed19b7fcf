#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <utility>

#include "correction/correction_subject.h"
#include "correction/effect_kind.h"
#include "correction/leaps.h"
#include "loop/loop.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double one_hour = 3600.0;

const record::Channel& spindle_bearing() {
  return *record::series_channel("front_bearing_temperature_C");
}
const record::Channel& spindle_motor() { return *record::series_channel("motor_temperature_C"); }

/// A spindle whose bearing warms up in 20 min and its motor in 2 h; the displacement follows the
/// bearing through a body of 1.2 h.
MadeRecord machine() {
  MadeRecord made(24.0 * one_hour, 30.0);
  std::vector<double> bearing, motor, moved;
  double b = 0.0, m = 0.0, body = 0.0;
  for (const double t : made.time) {
    bearing.push_back(b);
    motor.push_back(m);
    moved.push_back(5.0 * body);
    const double n = stepped_speed(t, 1.5 * one_hour);
    b += 30.0 / 1200.0 * (3e-3 * n - b);
    m += 30.0 / 7200.0 * (4.5e-3 * n * (n < 5000 ? 1.0 : 0.6) - m);
    body += 30.0 / 4300.0 * (b - body);
  }
  std::mt19937 engine(7);
  std::normal_distribution<double> noise;
  const auto row = [](double t) { return static_cast<std::size_t>(std::lround(t / 30.0)); };
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 1.5 * one_hour); });
  made.with("front_bearing_temperature_C",
            [&](double t) { return 21.0 + bearing[row(t)] + 0.02 * noise(engine); });
  made.with("motor_temperature_C",
            [&](double t) { return 21.0 + motor[row(t)] + 0.02 * noise(engine); });
  made.with("room_temperature_C", [&](double) { return 21.0 + 0.02 * noise(engine); });
  made.with("displacement_z_um", [&](double t) { return moved[row(t)] + 0.2 * noise(engine); });
  return made;
}

Model driven_by_the_bearing() {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.tolerance = 1e-6;
  m.channels.push_back(
      {.name = "spindle",
       .input = {.name = "front_bearing_temperature_C", .columns = {&spindle_bearing()}},
       .sections = {{3e-6, 3000}}});
  return m;
}

void loosen(MadeRecord& made, double from, double to, double seen) {
  std::vector<double>& read = made.record.find(spindle_bearing())->values;
  const double cold = spindle_bearing().to_SI(21.0);
  for (std::size_t k = 0; k < read.size(); ++k)
    if (made.time[k] >= from && made.time[k] < to) read[k] = cold + seen * (read[k] - cold);
}

verdict::Diagnosis diagnosed(const MadeRecord& made) {
  return loop::diagnose(CorrectionSubject(driven_by_the_bearing()), made.record);
}

/// What is wrong, and how.
std::string datum_of(const verdict::Diagnosis& d, const std::string& id) {
  for (const verdict::RankedEffect& e : d.effects)
    if (e.id == id) return e.datum + ": " + e.correction;
  return {};
}

TEST(WrongData, NothingIsWrongWithTheMachineItself) {
  const MadeRecord made = machine();
  EXPECT_EQ(diagnosed(made).verdict, verdict::Verdict::nothing_missing);
}

TEST(WrongData, ExchangedColumnsAreNamed) {
  MadeRecord made = machine();
  std::swap(made.record.find(spindle_bearing())->values, made.record.find(spindle_motor())->values);
  const verdict::Diagnosis d = diagnosed(made);
  ASSERT_FALSE(d.sets.empty()) << d.sentence;
  EXPECT_THAT(d.sets, testing::Contains(ElementsAre("exchanged-columns"))) << d.sentence;
  EXPECT_THAT(datum_of(d, "exchanged-columns"),
              HasSubstr("front_bearing_temperature_C and motor_temperature_C"));
}

TEST(WrongData, ASensorThatCameLooseIsNamedWithItsTimes) {
  MadeRecord made = machine();
  loosen(made, 9.4 * one_hour, 13.0 * one_hour, 0.4);
  const verdict::Diagnosis d = diagnosed(made);
  ASSERT_FALSE(d.sets.empty()) << d.sentence;
  EXPECT_THAT(d.sets.front(), ElementsAre("loose-sensor")) << d.sentence;
  EXPECT_THAT(datum_of(d, "loose-sensor"),
              HasSubstr("front_bearing_temperature_C: from 9.4 h to 13 h the sensor showed "
                        "40 % of the temperature rise"));
}

/// A sensor that comes loose where the spindle is cold shows one leap: that of its return.
TEST(WrongData, OneEndIsEnough) {
  MadeRecord made = machine();
  loosen(made, 4.4 * one_hour, 10.0 * one_hour, 0.5);
  const verdict::Diagnosis d = diagnosed(made);
  ASSERT_FALSE(d.sets.empty()) << d.sentence;
  EXPECT_THAT(d.sets.front(), ElementsAre("loose-sensor")) << d.sentence;
  EXPECT_THAT(datum_of(d, "loose-sensor"),
              HasSubstr("to 10 h the sensor showed 50 % of the temperature rise"));
}

/// It returns by a jump that is too small to begin with, and is never as cold as the room.
TEST(WrongData, AFaintReturnIsFound) {
  MadeRecord made = machine();
  constexpr double room = 20.4, seen = 0.5;
  const double cold = spindle_bearing().to_SI(room);
  made.with("room_temperature_C", [](double) { return room; });
  std::vector<double>& read = made.record.find(spindle_bearing())->values;
  const std::size_t from = 1128;  // 9.4 h
  std::size_t back = from;
  while (read[back] - cold > 0.85) ++back;
  for (std::size_t k = from; k < back; ++k) read[k] = cold + seen * (read[k] - cold);
  ASSERT_LT(read[back] - read[back - 1], seen_leap_of_a_sensor);
  const verdict::Diagnosis d = diagnosed(made);
  ASSERT_FALSE(d.sets.empty()) << d.sentence;
  EXPECT_THAT(d.sets.front(), ElementsAre("loose-sensor")) << d.sentence;
  EXPECT_THAT(datum_of(d, "loose-sensor"),
              testing::ContainsRegex(fmt::format("from 9.4 h to {:.3g} h the sensor showed 5[01] %",
                                                 made.time[back] / one_hour)));
}

/// The clock of a logger jitters; a gap may hide a slow change.
TEST(WrongData, ALeapNeedsNoEvenClockAndNoGap) {
  MadeRecord made = machine();
  std::vector<double>& read = made.record.find(spindle_bearing())->values;
  for (std::size_t k = 700; k < read.size(); ++k) read[k] -= 2.0;
  std::vector<double>& time = made.record.find(record::time)->values;
  time[699] -= 6.0;
  time[700] += 6.0;
  EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), ElementsAre(700U));
  for (std::size_t k = 700; k < time.size(); ++k) time[k] += 60.0;
  EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), testing::IsEmpty());
}

TEST(WrongData, ALeapLiesWithinOneRun) {
  for (const std::size_t first : {699U, 700U, 701U}) {
    MadeRecord made = machine();
    std::vector<double>& read = made.record.find(spindle_bearing())->values;
    for (std::size_t k = 700; k < read.size(); ++k) read[k] -= 2.0;
    std::vector<double> run(read.size(), 0.0);
    for (std::size_t k = first; k < run.size(); ++k) run[k] = 1.0;
    made.record.runs = {"monday", "friday"};
    made.record.set(record::run, std::move(run));
    EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), testing::IsEmpty()) << first;
  }
}

TEST(WrongData, ALeapIsOneOfTheSensorAndNoBody) {
  MadeRecord made = machine();
  EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), testing::IsEmpty());
  std::vector<double>& read = made.record.find(spindle_bearing())->values;
  for (std::size_t k = 700; k < read.size(); ++k) read[k] -= 2.0;
  EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), ElementsAre(700U));
  // A change of the speed explains it.
  std::vector<double>& speed = made.record.find(record::speed)->values;
  for (std::size_t k = 700; k < read.size(); ++k) speed[k] += 100.0;
  EXPECT_THAT(leaping_rows(made.record, spindle_bearing()), testing::IsEmpty());
}

TEST(WrongData, WhatARecordCannotShowIsSaid) {
  MadeRecord made = machine();
  std::erase_if(made.record.columns, [](const record::Column& c) {
    return *c.channel == spindle_motor() || record::is_ambient(*c.channel);
  });
  const auto informed = CorrectionSubject(driven_by_the_bearing()).informed_by(made.record);
  EXPECT_THAT(informed->lacks("exchanged-columns", made.record), HasSubstr("two temperatures"));
  EXPECT_EQ(informed->lacks("loose-sensor", made.record), "");
}

}  // namespace
}  // namespace raceway::correction

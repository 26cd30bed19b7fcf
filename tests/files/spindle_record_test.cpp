// Records and speed programmes of a spindle.

#include "files/spindle_record.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "files/model_file.h"
#include "record/spindle_channel.h"
#include "spindle/record_rows.h"
#include "tests/files/spindle_text.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const model::Spindle& spindle_of_records() {
  static const model::Spindle spindle =
      parse_model(tests::base_spindle, "s.toml").model.spindle.value();
  return spindle;
}

record::Record read_rows(const std::string& text) {
  return read_spindle_record({"day.csv", text}, spindle_of_records());
}

std::string rows_error(const std::string& text) {
  return tests::message_of([&] { (void)read_rows(text); });
}

TEST(SpindleRecord, InputsAndReadingsComeInSi) {
  const record::Record r = read_rows(
      "time_s,speed_rpm,ambient_temperature_C,coolant_on,motor_heat_W,front_bearing_temperature_C,"
      "shaft_end_temperature_C,axial_displacement_um\n"
      "60,0,20,1,0,20.1,20,-0.4\n120,6000,21,0,35,,20.2,3\n");
  const auto rows = spindle::profile_of(r);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].time, 120);
  EXPECT_DOUBLE_EQ(rows[1].inputs.speed, 6000 * rpm);
  EXPECT_DOUBLE_EQ(rows[1].inputs.ambient_temperature, kelvin(21));
  EXPECT_TRUE(std::isnan(rows[1].inputs.machine_temperature));
  EXPECT_EQ(rows[1].inputs.motor_heat, 35);
  EXPECT_TRUE(rows[0].inputs.coolant_on);
  EXPECT_FALSE(rows[1].inputs.coolant_on);
  const auto front = r.values(record::sensor_channel("front_bearing"));
  EXPECT_DOUBLE_EQ(front[0], kelvin(20.1));
  EXPECT_TRUE(std::isnan(front[1]));
  EXPECT_DOUBLE_EQ(r.values(record::axial_displacement)[1], 3e-6);
}

TEST(SpindleRecord, TemperaturesOfSensorsAreMeasuredAndThoseAroundAreNot) {
  const record::Record r =
      read_rows("time_s,speed_rpm,ambient_temperature_C,shaft_end_temperature_C\n60,0,20,20\n");
  EXPECT_EQ(r.find(record::sensor_channel("shaft_end"))->channel->role, record::Role::measured);
  EXPECT_TRUE(r.find(*record::spindle_channel("ambient_temperature_C"))->channel->is_input());
}

TEST(SpindleRecord, LoadsAtTheNoseHaveASense) {
  const auto rows = spindle::profile_of(
      read_rows("time_s,speed_rpm,radial_load_N,moment_Nm\n60,0,300,0\n120,6000,-250,-12\n"));
  EXPECT_EQ(rows[0].inputs.radial_load, 300);
  EXPECT_EQ(rows[1].inputs.radial_load, -250);
  EXPECT_EQ(rows[1].inputs.moment, -12);
  EXPECT_TRUE(std::isnan(rows[1].inputs.belt_force));
}

TEST(SpindleRecord, LoadsThatNothingCarriesAreRefused) {
  const std::string belt = "time_s,speed_rpm,belt_force_N\n60,0,900\n";
  EXPECT_THAT(rows_error(belt), HasSubstr("belt_force_N: the model has no belt"));
  model::Spindle driven = spindle_of_records();
  driven.belt = model::Belt{.position = 350 * mm};
  const auto rows = spindle::profile_of(read_spindle_record({"day.csv", belt}, driven));
  EXPECT_EQ(rows[0].inputs.belt_force, 900);
  model::Spindle network = spindle_of_records();
  network.network = model::Network{};
  for (const char* load : {"radial_load_N", "axial_load_N", "moment_Nm"}) {
    const std::string text = fmt::format("time_s,speed_rpm,{}\n60,0,5\n", load);
    EXPECT_THAT(tests::message_of([&] {
                  (void)read_spindle_record({"day.csv", text}, network);
                }),
                HasSubstr("a model with [network] has no shaft, so it cannot carry a load"));
  }
}

TEST(SpindleRecord, SensorsStandBeforeTheDisplacement) {
  const auto channels = spindle::measured_channels(spindle_of_records());
  ASSERT_EQ(channels.size(), 3u);
  EXPECT_EQ(channels[0]->name, "front_bearing_temperature_C");
  EXPECT_EQ(channels[2]->name, "axial_displacement_um");
}

// A run of 1e150 s had no end.
TEST(SpindleRecord, AProgrammeOfMoreThanTenYearsIsRefused) {
  const record::Record r =
      read_rows("time_s,speed_rpm,shaft_end_temperature_C\n0,0,20\n3e8,100,20\n1e150,100,20\n");
  EXPECT_THAT([&] { (void)spindle::profile_of(r); },
              testing::ThrowsMessage<std::invalid_argument>(
                  HasSubstr("time_s = 1e+150 s: a record can last at most 3.2e+08 s (10 years)")));
}

TEST(SpindleRecord, GermanFileWithDatesIsRead) {
  const record::Record r = read_rows(

      "time_s;speed_rpm;shaft_end_temperature_C\n"
      "12.03.2024 08:15:00;1000;20,5\n12.03.2024 08:16:00;2000;21,5\n");
  EXPECT_EQ(spindle::profile_of(r)[1].time, 60);
  EXPECT_DOUBLE_EQ(r.values(record::sensor_channel("shaft_end"))[1], kelvin(21.5));
}

TEST(SpindleRecord, RowsBeforeTheFirstValueOfAnInputAreLeftOut) {
  const record::Record r = read_rows("time_s,speed_rpm\n60,\n120,1000\n180,\n");
  EXPECT_EQ(r.rows(), 2u);
  EXPECT_EQ(r.line(0), 3);
  EXPECT_THAT(texts(r.notes),
              Contains("rows before the first value of speed_rpm are not used: line 2"));
  EXPECT_THAT(rows_error("time_s,speed_rpm\n60,\n120,nan\n"),
              HasSubstr(": no row has values for all inputs:"));
}

TEST(SpindleRecord, TimeThatGoesBackIsRefused) {
  EXPECT_THAT(rows_error("time_s,speed_rpm\n60,1000\n50,1000\n"), HasSubstr("goes back"));
}

TEST(SpindleRecord, SpeedIsNeeded) {
  EXPECT_THAT(rows_error("time_s,coolant_on\n60,1\n"), HasSubstr("column speed_rpm is missing"));
}

TEST(SpindleRecord, MisspeltSensorIsNamed) {
  EXPECT_THAT(rows_error("time_s,speed_rpm,shaft_ent_temperature_C\n60,1000,20\n"),
              HasSubstr("did you mean shaft_end_temperature_C?"));
}

// 6000 rpm from 100 s to 200 s, written as events and as a logger stamps them.
TEST(SpindleRecord, SettingsHoldAsTheMapSays) {
  const auto speeds = [](const std::string& text, const std::string& hold) {
    const record::Record r =
        read_spindle_record({"day.csv", "time_s,speed_rpm\n" + text}, spindle_of_records(),
                            {.columns = parse_column_map(hold, "map.toml")});
    std::vector<double> list;
    for (const spindle::ProfileRow& row : spindle::profile_of(r))
      list.push_back(row.inputs.speed / rpm);
    list.erase(list.begin());
    EXPECT_THAT(texts(r.notes), Not(Contains(HasSubstr("settings_hold"))));
    return list;
  };
  EXPECT_THAT(speeds("0,0\n100,6000\n200,0\n300,0\n", "[columns]\nsettings_hold = \"from row\""),
              ElementsAre(0, DoubleEq(6000), 0));
  EXPECT_THAT(speeds("0,0\n100,0\n200,6000\n300,0\n", "[columns]\nsettings_hold = \"until row\""),
              ElementsAre(0, DoubleEq(6000), 0));
}

TEST(SpindleRecord, SettingsWithoutAStatementHoldUntilTheirRowWithANote) {
  const record::Record r = read_rows("time_s,speed_rpm\n0,0\n100,6000\n");
  EXPECT_DOUBLE_EQ(spindle::profile_of(r)[1].inputs.speed, 6000 * rpm);
  EXPECT_THAT(
      texts(r.notes),
      Contains(HasSubstr(
          "the program assumes that the settings of a row apply from the previous "
          "row to this row; set settings_hold = \"until row\" in [columns] "
          "to confirm this, or \"from row\" if the settings of a row apply until the next row")));
  EXPECT_THAT(texts(read_rows("time_s,speed_rpm\n0,6000\n100,6000\n").notes),
              Not(Contains(HasSubstr("settings_hold"))));
}

TEST(SpindleRecord, SensorThatTheModelLacksIsTold) {
  EXPECT_THAT(
      texts(read_rows("time_s,speed_rpm,gearbox_temperature_C\n60,1000,20\n").notes),
      Contains("columns not used, because the model does not predict them: gearbox_temperature_C"));
}

TEST(SpindleRecord, LoadsHaveASignAlongTheShaft) {
  const auto rows = spindle::profile_of(
      read_rows("time_s,speed_rpm,axial_load_N,radial_load_N\n60,-1000,-200,50\n"));
  EXPECT_EQ(rows[0].inputs.axial_load, -200);
  EXPECT_EQ(rows[0].inputs.radial_load, 50);
  EXPECT_DOUBLE_EQ(rows[0].inputs.speed, 1000 * rpm);
}

}  // namespace
}  // namespace raceway::files

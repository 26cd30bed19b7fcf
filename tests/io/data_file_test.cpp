#include "io/data_file.h"

#include <cmath>
#include <fstream>

#include "bearing/units.h"
#include "tests/io/message_of.h"

namespace raceway::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

fit::Rig loaded_rig() {
  fit::Rig rig;
  rig.axial_load = 100;
  return rig;
}

fit::Rig flywheel() {
  fit::Rig rig;
  rig.axial_load = 0;
  rig.inertia = 0.85;
  rig.minimum_speed = 40 * rpm;
  return rig;
}

fit::DataSet data_of(const std::string& text, const fit::Rig& rig = loaded_rig()) {
  return std::get<fit::DataSet>(parse_measurement(text, "d.csv", rig));
}

fit::CoastDownRecord record_of(const std::string& text, const fit::Rig& rig = flywheel()) {
  return std::get<fit::CoastDownRecord>(parse_measurement(text, "d.csv", rig));
}

std::string error_of(const std::string& text, const fit::Rig& rig = loaded_rig()) {
  return message_of([&] { (void)parse_measurement(text, "d.csv", rig); });
}

TEST(DataFile, UnitsBecomeSI) {
  const fit::DataSet data = data_of(
      "speed_rpm,axial_load_N,radial_load_N,temperature_C,inner_ring_temperature_C,"
      "outer_ring_temperature_C,time_s,preload_N,friction_torque_Nmm,std_Nmm\n"
      "3000,600,20,25,30,28,1.5,300,120,2\n");
  ASSERT_EQ(data.rows.size(), 1u);
  const fit::Row& row = data.rows[0];
  EXPECT_DOUBLE_EQ(row.point.speed, 100 * pi);
  EXPECT_DOUBLE_EQ(row.point.axial_load, 600);
  EXPECT_DOUBLE_EQ(row.point.radial_load, 20);
  EXPECT_DOUBLE_EQ(row.point.temperature, 298.15);
  EXPECT_DOUBLE_EQ(row.inner_ring_temperature, 303.15);
  EXPECT_DOUBLE_EQ(row.outer_ring_temperature, 301.15);
  EXPECT_DOUBLE_EQ(row.time, 1.5);
  EXPECT_DOUBLE_EQ(row.preload, 300);
  EXPECT_DOUBLE_EQ(row.measured, 0.12);
  EXPECT_DOUBLE_EQ(row.std, 0.002);
  EXPECT_EQ(row.run, -1);
  EXPECT_EQ(row.line, 2);
  EXPECT_EQ(data.noise, fit::NoiseSource::declared);
  EXPECT_TRUE(data.notes.empty());
}

TEST(DataFile, DisplacementIsAQuantityOfItsOwn) {
  const fit::DataSet data = data_of("speed_rpm,axial_displacement_um,std_um\n1000,-12,0.5\n");
  EXPECT_EQ(data.quantity, fit::Quantity::axial_displacement);
  EXPECT_DOUBLE_EQ(data.rows[0].measured, -12e-6);
  EXPECT_DOUBLE_EQ(data.rows[0].std, 0.5e-6);
}

TEST(DataFile, WhatTheFileLacksComesFromTheRigAndIsNoted) {
  const fit::DataSet data = data_of("speed_rpm,friction_torque_Nmm\n1000,50\n");
  EXPECT_EQ(data.noise, fit::NoiseSource::none);
  EXPECT_DOUBLE_EQ(data.rows[0].point.axial_load, 100);
  EXPECT_DOUBLE_EQ(data.rows[0].point.temperature, 313.15);
  EXPECT_THAT(data.notes, Contains("no column axial_load_N: 100 N for all rows, from [rig]"));
  EXPECT_THAT(data.notes, Contains("no column temperature_C: 40 C for all rows, from [rig]"));
}

TEST(DataFile, ForAShaftTheAxialLoadIsTheExternalOne) {
  const auto one =
      std::make_shared<const bearing::Bearing>(bearing::BearingGeometry{.ball_count = 20,
                                                                        .ball_diameter = 0.0119,
                                                                        .pitch_diameter = 0.09,
                                                                        .contact_angle = 0.4,
                                                                        .inner_conformity = 0.52,
                                                                        .outer_conformity = 0.52},
                                               bearing::steel(), bearing::steel());
  const fit::Shaft shaft{
      .arrangement = bearing::Arrangement(
          {.front = {{one}}, .rear = {{one}}, .preload = bearing::PreloadForce{500}}),
      .external_load = 70};
  const fit::Rig rig;
  const auto read = [&](const std::string& text) {
    return std::get<fit::DataSet>(parse_measurement(text, "d.csv", rig, &shaft));
  };
  const fit::DataSet filled = read("speed_rpm,axial_displacement_um\n1000,2\n");
  EXPECT_DOUBLE_EQ(filled.rows[0].point.axial_load, 70);
  EXPECT_THAT(filled.notes, Contains("no column axial_load_N: 70 N for all rows, from "
                                     "external_load_N of [arrangement]"));
  EXPECT_THAT(
      read("speed_rpm,inner_ring_temperature_C,axial_displacement_um\n1000,30,2\n").notes,
      Contains("no column outer_ring_temperature_C: that of [arrangement] for all rows, else "
               "as mounted"));
  const fit::DataSet both = read(
      "speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm,axial_displacement_um\n"
      "1000,-40,10,90,2\n");
  EXPECT_DOUBLE_EQ(both.rows[0].point.axial_load, -40);
  EXPECT_EQ(both.quantity, fit::Quantity::axial_displacement);
  EXPECT_THAT(both.notes, Contains("two measured columns: axial_displacement_um is used, "
                                   "friction_torque_Nmm is not"));
  EXPECT_THAT(both.notes, Contains(HasSubstr("radial_load_N is not used")));
}

TEST(DataFile, RunsAreNumberedInOrderOfAppearance) {
  const fit::DataSet data = data_of("run_id,speed_rpm,friction_torque_Nmm\nb,1,1\na,1,1\nb,2,1\n");
  EXPECT_THAT(data.runs, ElementsAre("b", "a"));
  EXPECT_EQ(data.rows[1].run, 1);
  EXPECT_EQ(data.rows[2].run, 0);
}

TEST(DataFile, SemicolonsDecimalCommasMarkAndCarriageReturnsAreReadWithANote) {
  const std::string path = testing::TempDir() + "german.csv";
  std::ofstream(path, std::ios::binary)
      << "\xef\xbb\xbfspeed_rpm;friction_torque_Nmm\r\n1000;50,5\r\n";
  const auto data = std::get<fit::DataSet>(read_measurement(path, loaded_rig()));
  EXPECT_DOUBLE_EQ(data.rows[0].measured, 0.0505);
  EXPECT_EQ(data.notes[0],
            "read with semicolons, decimal commas, a byte order mark and CRLF line ends");
}

TEST(DataFile, DecimalPointsAndCommasInOneFileAreAnError) {
  EXPECT_EQ(error_of("speed_rpm;friction_torque_Nmm\n1000;50,5\n1000;1.234\n"),
            "d.csv:2: 50,5 has a decimal comma, but 1.234 in line 3 a decimal point; use one of "
            "them");
  EXPECT_THAT(error_of("speed_rpm;friction_torque_Nmm\n1000;1.234,5\n"), HasSubstr("ambiguous"));
  // A name is no number, whatever it looks like.
  EXPECT_EQ(data_of("run_id;speed_rpm;friction_torque_Nmm\n5.28;1000;50,5\n").runs[0], "5.28");
}

TEST(DataFile, BadCellsAreAllReportedWithTheirLines) {
  const std::string text = error_of(
      "speed_rpm,temperature_C,friction_torque_Nmm\n1000,20,nan\n-5,20,1\n1000,-300,1\n1000,20,\n"
      "1000,20,x1\n");
  EXPECT_THAT(text, StartsWith("d.csv:2: friction_torque_Nmm = \"nan\""));
  EXPECT_THAT(text, HasSubstr("d.csv:3: speed_rpm = -5: must be from 0 to 1000000 rpm"));
  EXPECT_THAT(text, HasSubstr("d.csv:4: temperature_C = -300: must be from -273 to 500 C"));
  EXPECT_THAT(text, HasSubstr("d.csv:5: friction_torque_Nmm = \"\": is empty"));
  EXPECT_THAT(text, HasSubstr("d.csv:6: friction_torque_Nmm = \"x1\": is not a number"));
  EXPECT_THAT(text, HasSubstr("5 bad values in 5 rows"));
}

TEST(DataFile, BadCellsComeInTheOrderOfTheirLines) {
  const std::string text = error_of("speed_rpm,friction_torque_Nmm\n1000,x\n-5,1\n1000,y\n");
  EXPECT_LT(text.find("d.csv:2"), text.find("d.csv:3"));
  EXPECT_LT(text.find("d.csv:3"), text.find("d.csv:4"));
}

TEST(DataFile, OfManyBadCellsTenAreShownAndAllCounted) {
  std::string text = "speed_rpm,friction_torque_Nmm\n";
  for (int i = 0; i < 30; ++i) text += "1000,oops\n";
  const std::string error = error_of(text);
  EXPECT_THAT(error, HasSubstr("d.csv:11: "));
  EXPECT_THAT(error, Not(HasSubstr("d.csv:12: ")));
  EXPECT_THAT(error, HasSubstr("and 20 more"));
  EXPECT_THAT(error, HasSubstr("30 bad values in 30 rows"));
}

TEST(DataFile, AStandardDeviationMustBePositive) {
  for (const char* std : {"0", "-1"})
    EXPECT_THAT(error_of(std::string("speed_rpm,friction_torque_Nmm,std_Nmm\n1,1,") + std + "\n"),
                StartsWith("d.csv:2: std_Nmm = "));
}

TEST(DataFile, AStandardDeviationNeedsItsQuantity) {
  EXPECT_THAT(error_of("speed_rpm,friction_torque_Nmm,std_um\n1,1,1\n"),
              HasSubstr("column std_um has no axial_displacement_um"));
  EXPECT_THAT(error_of("speed_rpm,axial_displacement_um,std_Nmm\n1,1,1\n"),
              HasSubstr("column std_Nmm has no friction_torque_Nmm"));
}

TEST(DataFile, MissingColumnsAreNamed) {
  EXPECT_THAT(error_of("speed_rpm,axial_load_N\n1,1\n"),
              StartsWith("d.csv:1: no measured column: friction_torque_Nmm or"));
  EXPECT_THAT(error_of("friction_torque_Nmm\n1\n"),
              StartsWith("d.csv:1: column speed_rpm is missing"));
}

TEST(DataFile, AnAxialLoadMustStandSomewhere) {
  for (const char* text : {"speed_rpm,friction_torque_Nmm\n1,1\n", "time_s,speed_rpm\n1,100\n"}) {
    fit::Rig rig;
    rig.inertia = 1;
    EXPECT_THAT(error_of(text, rig), HasSubstr("write axial_load_N under [rig]"));
  }
}

TEST(DataFile, MisspeltColumnsAreErrorsAndForeignOnesAreNoted) {
  EXPECT_EQ(error_of("speed_rpm,friction_torque_Nm\n1,1\n"),
            "d.csv:1: column friction_torque_Nm is unknown; did you mean friction_torque_Nmm?");
  EXPECT_THAT(error_of("speed,friction_torque_Nmm\n1,1\n"), HasSubstr("did you mean speed_rpm?"));
  const auto data = data_of("speed_rpm,friction_torque_Nmm,samples_in_median\n1,1,50\n");
  EXPECT_THAT(data.notes, Contains("column samples_in_median is unknown and ignored"));
}

TEST(DataFile, TimeThatGoesBackIsNoted) {
  const auto data = data_of("time_s,speed_rpm,friction_torque_Nmm\n2,1,1\n1,1,1\n");
  EXPECT_THAT(data.notes, Contains("time_s goes back at line 3; rows are taken as they stand"));
}

TEST(DataFile, ACoastDownIsReadAndSlowRowsAreCounted) {
  const auto record =
      record_of("run_id,time_s,speed_rpm\na,0,1000\na,1,900\na,2,30\nb,0,800\nb,1,700\n");
  EXPECT_EQ(record.samples.size(), 4u);
  EXPECT_THAT(record.runs, ElementsAre("a", "b"));
  EXPECT_DOUBLE_EQ(record.samples[0].speed, 1000 * rpm);
  EXPECT_EQ(record.samples[2].line, 5);
  EXPECT_DOUBLE_EQ(record.samples[0].point.axial_load, 0.0);
  EXPECT_DOUBLE_EQ(record.samples[0].point.speed, record.samples[0].speed);
  EXPECT_THAT(record.notes, Contains("1 of 5 rows below minimum_speed_rpm = 40 left out"));
}

TEST(DataFile, ACoastDownNeedsTheInertia) {
  EXPECT_THAT(error_of("run_id,time_s,speed_rpm\na,0,1000\n"),
              HasSubstr("the model needs inertia_kgm2 under [rig]"));
}

TEST(DataFile, TimeMustIncreaseWithinARunOfACoastDown) {
  EXPECT_EQ(error_of("run_id,time_s,speed_rpm\na,0,1000\nb,0,1000\na,0,900\n", flywheel()),
            "d.csv:4: time_s = 0: must increase within a run");
}

TEST(DataFile, ACoastDownBelowTheMinimumSpeedIsAnError) {
  EXPECT_THAT(error_of("time_s,speed_rpm\n0,10\n1,9\n", flywheel()),
              HasSubstr("all 2 rows are below minimum_speed_rpm = 40"));
}

TEST(DataFile, TheFlywheelRecordIsRead) {
  const std::string path =
      std::string(RACEWAY_SOURCE_DIR) + "/data/measurements/flywheel_unloaded.csv";
  const auto record = std::get<fit::CoastDownRecord>(read_measurement(path, flywheel()));
  EXPECT_EQ(record.runs.size(), 1u);
  EXPECT_GT(record.samples.size(), 400u);
  for (const auto& sample : record.samples) EXPECT_GE(sample.speed, 40 * rpm);
}

}  // namespace
}  // namespace raceway::io

#include "files/data_file.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "files/subject.h"
#include "record/kept_channel.h"
#include "record/units.h"
#include "tests/places.h"
#include "tests/support/message_of.h"
#include "tests/support/shafts.h"

namespace raceway::files {
namespace {

using record::Record;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

std::shared_ptr<const model::ModelSubject> on(const model::Rig& rig) {
  model::Model model = fit::synthetic_model();
  model.rig = rig;
  return make_subject(model);
}

model::Rig loaded_rig() {
  model::Rig rig;
  rig.axial_load = 100;
  return rig;
}

model::Rig flywheel() {
  model::Rig rig;
  rig.axial_load = 0;
  rig.inertia = 0.85;
  rig.minimum_speed = 40 * rpm;
  return rig;
}

Record record_of(const std::string& text, const model::Rig& rig = loaded_rig()) {
  return read_record({"d.csv", text}, *on(rig));
}

std::string data_error(const std::string& text, const model::Rig& rig = loaded_rig()) {
  return tests::message_of([&] { (void)record_of(text, rig); });
}

/// A bearing that reads torque and displacement at once.
class TwoSensors : public model::ModelSubject {
 public:
  TwoSensors() : ModelSubject(fit::synthetic_model()) {}
  [[nodiscard]] std::vector<fit::Measured> measured() const override {
    return {{.channel = &record::friction_torque}, {.channel = &record::axial_displacement}};
  }
  void require(const Record&) const override {}
  [[nodiscard]] std::unique_ptr<fit::Predictor> predictor(
      const Record&, const std::vector<std::string>&,
      const std::shared_ptr<const void>&) const override {
    return nullptr;
  }
  [[nodiscard]] model::Expected expected() const override {
    model::Expected e;
    e.defaults = {{&record::speed, unset, ""}};
    e.measured = {&record::friction_torque, &record::axial_displacement};
    return e;
  }

 private:
  [[nodiscard]] std::unique_ptr<ModelSubject> make(model::Model,
                                                   std::vector<std::string>) const override {
    return nullptr;
  }
};

TEST(DataFile, UnitsBecomeSI) {
  const Record r = record_of(
      "speed_rpm,axial_load_N,radial_load_N,temperature_C,inner_ring_temperature_C,"
      "outer_ring_temperature_C,time_s,preload_N,friction_torque_Nmm,std_Nmm\n"
      "3000,600,20,25,30,28,1.5,300,120,2\n");
  ASSERT_EQ(r.rows(), 1u);
  EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 100 * pi);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 0), 600);
  EXPECT_DOUBLE_EQ(r.value(record::radial_load, 0), 20);
  EXPECT_DOUBLE_EQ(r.value(record::temperature, 0), 298.15);
  EXPECT_DOUBLE_EQ(r.value(record::inner_ring_temperature, 0), 303.15);
  EXPECT_DOUBLE_EQ(r.value(record::outer_ring_temperature, 0), 301.15);
  EXPECT_DOUBLE_EQ(r.value(record::time, 0), 1.5);
  EXPECT_DOUBLE_EQ(r.value(record::preload, 0), 300);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.12);
  EXPECT_DOUBLE_EQ(r.value(record::torque_deviation, 0), 0.002);
  EXPECT_FALSE(r.deviation_of(record::friction_torque)->known);
  EXPECT_EQ(r.run_of(0), -1);
  EXPECT_EQ(r.place(0), "line 2");
  EXPECT_TRUE(r.notes.empty());
}

TEST(DataFile, DisplacementIsAQuantityOfItsOwn) {
  const Record r = record_of("speed_rpm,axial_displacement_um,std_um\n1000,-12,0.5\n");
  EXPECT_FALSE(r.has(record::friction_torque));
  EXPECT_DOUBLE_EQ(r.value(record::axial_displacement, 0), -12e-6);
  EXPECT_DOUBLE_EQ(r.value(record::displacement_deviation, 0), 0.5e-6);
}

TEST(DataFile, WhatTheFileLacksComesFromTheRigAndIsNoted) {
  const Record r = record_of("speed_rpm,friction_torque_Nmm\n1000,50\n");
  EXPECT_EQ(r.deviation_of(record::friction_torque), nullptr);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 0), 100);
  EXPECT_DOUBLE_EQ(r.value(record::temperature, 0), 313.15);
  EXPECT_THAT(texts(r.notes), Contains("no column axial_load_N: 100 N for all rows, from [rig]"));
  EXPECT_THAT(texts(r.notes), Contains("no column temperature_C: 40 C for all rows, from [rig]"));
}

TEST(DataFile, ForAShaftTheAxialLoadIsTheExternalOne) {
  model::Model model = fit::two_against_one();
  model.shaft->external_load = 70;
  const auto shaft = make_subject(model);
  const auto read = [&](const std::string& text) { return read_record({"d.csv", text}, *shaft); };
  const Record filled = read("speed_rpm,axial_displacement_um\n1000,2\n");
  EXPECT_DOUBLE_EQ(filled.value(record::axial_load, 0), 70);
  EXPECT_THAT(texts(filled.notes), Contains("no column axial_load_N: 70 N for all rows, from "
                                            "external_load_N of [arrangement]"));
  EXPECT_THAT(
      texts(read("speed_rpm,inner_ring_temperature_C,axial_displacement_um\n1000,30,2\n").notes),
      Contains("no column outer_ring_temperature_C: the ring temperature under [arrangement] for "
               "all rows, or "
               "the mounting temperature if [arrangement] has no value"));
  const Record both = read(
      "speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm,std_Nmm,axial_displacement_um\n"
      "1000,-40,10,90,1,2\n");
  EXPECT_DOUBLE_EQ(both.value(record::axial_load, 0), -40);
  EXPECT_TRUE(both.has(record::axial_displacement));
  EXPECT_FALSE(both.has(record::friction_torque) || both.has(record::torque_deviation));
  EXPECT_THAT(texts(both.notes),
              Contains("two measured columns: axial_displacement_um is used, friction_torque_Nmm "
                       "is not used"));
  EXPECT_THAT(texts(both.notes), Contains(HasSubstr("radial_load_N is not used")));
}

TEST(DataFile, BesideAnotherSensorACellMayBeEmpty) {
  const std::string text =
      "speed_rpm,friction_torque_Nmm,std_Nmm,axial_displacement_um\n"
      "1000,50,1,\n2000,,,3\n3000,60,1,4\n";
  const Record r = read_record({"d.csv", text}, TwoSensors());
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.05);
  EXPECT_TRUE(std::isnan(r.value(record::friction_torque, 1)));
  EXPECT_TRUE(std::isnan(r.value(record::torque_deviation, 1)));
  EXPECT_TRUE(std::isnan(r.value(record::axial_displacement, 0)));
  EXPECT_DOUBLE_EQ(r.value(record::axial_displacement, 1), 3e-6);
  EXPECT_TRUE(r.notes.empty());
  const auto refused = [](const std::string& cells, const model::ModelSubject& subject) {
    return tests::message_of([&] {
      (void)read_record(
          {"d.csv",
           "speed_rpm,axial_load_N,friction_torque_Nmm,std_Nmm,axial_displacement_um\n" + cells},
          subject);
    });
  };
  // What was read has a deviation, inputs stand in every row, and a channel alone is always read.
  EXPECT_EQ(refused("1000,9,50,,2\n", TwoSensors()), "d.csv:2: std_Nmm = \"\": is empty");
  EXPECT_EQ(refused("1000,,50,1,2\n", TwoSensors()), "d.csv:2: axial_load_N = \"\": is empty");
  EXPECT_EQ(refused("1000,9,,1,2\n", *on(loaded_rig())),
            "d.csv:2: friction_torque_Nmm = \"\": is empty");
}

TEST(DataFile, RunsAreNumberedInOrderOfAppearance) {
  const Record r = record_of("run_id,speed_rpm,friction_torque_Nmm\nb,1,1\na,1,1\nb,2,1\n");
  EXPECT_THAT(r.runs, ElementsAre("b", "a"));
  EXPECT_EQ(r.run_of(1), 1);
  EXPECT_EQ(r.run_of(2), 0);
}

TEST(DataFile, SemicolonsDecimalCommasMarkAndCarriageReturnsAreReadWithANote) {
  const std::string path = testing::TempDir() + "german.csv";
  std::ofstream(path, std::ios::binary)
      << "\xef\xbb\xbfspeed_rpm;friction_torque_Nmm\r\n1000;50,5\r\n";
  const Record r = read_record(path, *on(loaded_rig()));
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.0505);
  EXPECT_EQ(r.notes[0].text,
            "read with semicolons, decimal commas, a byte order mark and CRLF line ends");
}

TEST(DataFile, DecimalPointsAndCommasInOneFileAreAnError) {
  EXPECT_EQ(data_error("speed_rpm;friction_torque_Nmm\n1000;50,5\n1000;1.234\n"),
            "d.csv:2: 50,5 has a decimal comma, but 1.234 in line 3 has a decimal point; use the "
            "same decimal mark in the whole file");
  EXPECT_THAT(data_error("speed_rpm;friction_torque_Nmm\n1000;1.234,5\n"), HasSubstr("ambiguous"));
  // A name is no number, whatever it looks like.
  EXPECT_EQ(record_of("run_id;speed_rpm;friction_torque_Nmm\n5.28;1000;50,5\n").runs[0], "5.28");
}

TEST(DataFile, BadCellsAreAllReportedWithTheirLines) {
  const std::string text = data_error(
      "speed_rpm,temperature_C,friction_torque_Nmm\n1000,20,nan\n-5,20,1\n1000,-300,1\n1000,20,\n"
      "1000,20,x1\n");
  EXPECT_THAT(text, StartsWith("d.csv:2: friction_torque_Nmm = \"nan\""));
  EXPECT_THAT(text, HasSubstr("d.csv:3: speed_rpm = -5: must be from 0 to 1000000 rpm"));
  EXPECT_THAT(text, HasSubstr("d.csv:4: temperature_C = -300: must be from -273 to 500 C"));
  EXPECT_THAT(text, HasSubstr("d.csv:5: friction_torque_Nmm = \"\": is empty"));
  EXPECT_THAT(text, HasSubstr("d.csv:6: friction_torque_Nmm = \"x1\": is not a number"));
  EXPECT_THAT(text, HasSubstr("5 invalid values in 5 rows"));
}

TEST(DataFile, BadCellsComeInTheOrderOfTheirLines) {
  const std::string text = data_error("speed_rpm,friction_torque_Nmm\n1000,x\n-5,1\n1000,y\n");
  EXPECT_LT(text.find("d.csv:2"), text.find("d.csv:3"));
  EXPECT_LT(text.find("d.csv:3"), text.find("d.csv:4"));
}

TEST(DataFile, OfManyBadCellsTenAreShownAndAllCounted) {
  std::string text = "speed_rpm,friction_torque_Nmm\n";
  for (int i = 0; i < 30; ++i) text += "1000,oops\n";
  const std::string error = data_error(text);
  EXPECT_THAT(error, HasSubstr("d.csv:11: "));
  EXPECT_THAT(error, Not(HasSubstr("d.csv:12: ")));
  EXPECT_THAT(error, HasSubstr("number of further invalid values: 20"));
  EXPECT_THAT(error, HasSubstr("30 invalid values in 30 rows"));
}

TEST(DataFile, AStandardDeviationMustBePositive) {
  for (const char* std : {"0", "-1"})
    EXPECT_THAT(data_error(std::string("speed_rpm,friction_torque_Nmm,std_Nmm\n1,1,") + std + "\n"),
                StartsWith("d.csv:2: std_Nmm = "));
}

TEST(DataFile, AStandardDeviationNeedsItsQuantity) {
  EXPECT_THAT(data_error("speed_rpm,friction_torque_Nmm,std_um\n1,1,1\n"),
              HasSubstr("column std_um needs a column axial_displacement_um"));
  EXPECT_THAT(data_error("speed_rpm,axial_displacement_um,std_Nmm\n1,1,1\n"),
              HasSubstr("column std_Nmm needs a column friction_torque_Nmm"));
}

TEST(DataFile, MissingColumnsAreNamed) {
  EXPECT_THAT(data_error("speed_rpm,axial_load_N\n1,1\n"),
              StartsWith("d.csv:1: a measured column is missing: friction_torque_Nmm or"));
  EXPECT_THAT(data_error("friction_torque_Nmm\n1\n"),
              StartsWith("d.csv:1: column speed_rpm is missing"));
}

TEST(DataFile, AnAxialLoadMustStandSomewhere) {
  for (const char* text : {"speed_rpm,friction_torque_Nmm\n1,1\n", "time_s,speed_rpm\n1,100\n"}) {
    model::Rig rig;
    rig.inertia = 1;
    EXPECT_THAT(data_error(text, rig), HasSubstr("or axial_load_N in the model under [rig]"));
  }
}

TEST(DataFile, MisspeltColumnsAreErrorsAndForeignOnesAreNoted) {
  EXPECT_EQ(data_error("speed_rpm,friction_torque_Nnm\n1,1\n"),
            "d.csv:1: column friction_torque_Nnm is unknown; did you mean friction_torque_Nmm?");
  EXPECT_THAT(data_error("speed,friction_torque_Nmm\n1,1\n"), HasSubstr("did you mean speed_rpm?"));
  const Record data = record_of("speed_rpm,friction_torque_Nmm,samples_in_median\n1,1,50\n");
  EXPECT_THAT(texts(data.notes),
              Contains("columns kept, but not used by the model: samples_in_median"));
}

TEST(DataFile, ColumnsThatNoModelAsksForAreKeptWithTheirUnit) {
  const Record data = record_of(
      "speed_rpm,friction_torque_Nmm,motor_power_kW,Position [mm],valve,who\n"
      "1000,100,1.5,20,3,a\n2000,120,,21,4,b\n");
  ASSERT_EQ(data.columns.back().channel->role, record::Role::kept);
  const record::Channel& power = record::kept_channel("motor_power_kW", "kW");
  EXPECT_EQ(data.values(power)[0], 1.5);
  EXPECT_TRUE(std::isnan(data.values(power)[1]));
  EXPECT_EQ(data.values(record::kept_channel("Position [mm]", "mm"))[1], 21.0);
  EXPECT_EQ(data.values(record::kept_channel("valve", ""))[1], 4.0);
  EXPECT_THAT(
      texts(data.notes),
      IsSupersetOf(
          {"columns kept, but not used by the model: motor_power_kW, Position [mm] and valve",
           "column who is unknown and ignored"}));
}

/// Numbers of loggers, and of a thermocouple that is broken.
TEST(DataFile, RowsWithANumberThatIsNoReadingAreLeftOut) {
  std::string text = "speed_rpm,temperature_C,friction_torque_Nmm\n";
  for (int row = 0; row < 20; ++row)
    text += fmt::format("{},{},{}\n", 1000 + 100 * row, row == 7 ? 1372.0 : 30.0 + 0.1 * row,
                        row == 3    ? "-9999"
                        : row == 12 ? "9.9e37"
                                    : fmt::format("{}", 100 + row));
  const Record data = record_of(text);
  EXPECT_EQ(data.rows(), 17u);
  EXPECT_THAT(texts(data.notes),
              Contains("3 of 20 rows have a number that cannot be a reading (such as -9999, or a "
                       "physically impossible value) and are not used (lines 5, 9, 14)"));
  // A load or a speed of 999 was set.
  EXPECT_EQ(record_of("speed_rpm,axial_load_N,friction_torque_Nmm\n10,100,1\n20,999,1\n").rows(),
            2u);
  // Half of them are in another unit.
  EXPECT_THAT(data_error("speed_rpm,temperature_C,friction_torque_Nmm\n1,600,1\n2,650,1\n3,30,1\n"),
              HasSubstr("must be from -273 to 500"));
}

TEST(DataFile, TimeThatGoesBackIsNoted) {
  const Record data = record_of("time_s,speed_rpm,friction_torque_Nmm\n2,1,1\n1,1,1\n");
  EXPECT_THAT(texts(data.notes),
              Contains("time_s goes back at line 3; the rows are used in the order of the file"));
}

/// Rows of a run that slows down from 1000 rpm, a second apart.
std::string falling(const std::string& run, int rows, double step = 9.0) {
  std::string text;
  for (int k = 0; k < rows; ++k) text += fmt::format("{},{},{:.3f}\n", run, k, 1000.0 - step * k);
  return text;
}

TEST(DataFile, ACoastDownBecomesTorqueAndSlowRowsAreCounted) {
  const std::string text =
      "run_id,time_s,speed_rpm\n" + falling("a", 60) + "a,60,30\n" + falling("b", 60, 10.0);
  const Record r = record_of(text, flywheel());
  EXPECT_THAT(r.runs, ElementsAre("a", "b"));
  EXPECT_THAT(texts(r.notes),
              Contains("1 of 121 rows have a speed below minimum_speed_rpm = 40 and are not used"));
  EXPECT_THAT(texts(r.notes), Contains(HasSubstr("run a: ")));
  ASSERT_GT(r.rows(), 8u);
  EXPECT_TRUE(r.deviation_of(record::friction_torque)->known);
  for (std::size_t i = 0; i < r.rows(); ++i) {
    const double step = r.run_of(i) == 0 ? 9.0 : 10.0;
    EXPECT_NEAR(r.value(record::friction_torque, i), 0.85 * step * rpm, 1e-6);
    EXPECT_DOUBLE_EQ(r.value(record::axial_load, i), 0.0);
    EXPECT_GE(r.line(i), r.run_of(i) == 0 ? 2 : 63);
  }
}

TEST(DataFile, ACoastDownWithoutRunIdIsOneRun) {
  std::string text = "time_s,speed_rpm\n";
  for (int k = 0; k < 60; ++k) text += fmt::format("{},{}\n", k, 1000 - 9 * k);
  const Record r = record_of(text, flywheel());
  EXPECT_THAT(r.runs, ElementsAre("1"));
  EXPECT_THAT(texts(r.notes), Contains("no column run_id: all rows are read as one run"));
}

TEST(DataFile, ACoastDownThatGivesNoTorqueIsAnErrorOfTheFile) {
  EXPECT_EQ(data_error("run_id,time_s,speed_rpm\n" + falling("a", 5), flywheel()),
            "d.csv: run a: 5 samples are too few for a torque, which needs at least 7 samples");
  EXPECT_EQ(data_error("run_id,time_s,speed_rpm\n" + falling("a", 5) + falling("b", 6), flywheel()),
            "d.csv: run b: 6 samples are too few for a torque, which needs at least 7 samples; "
            "none of the 2 runs has more");
}

TEST(DataFile, AShortRunBesideALongOneIsLeftOut) {
  const Record r =
      record_of("run_id,time_s,speed_rpm\n" + falling("a", 60) + falling("b", 3), flywheel());
  EXPECT_THAT(texts(r.notes),
              Contains("run b: the run has only 3 usable samples; a torque needs at least 7, "
                       "so the run is not used"));
  for (std::size_t i = 0; i < r.rows(); ++i) EXPECT_EQ(r.run_of(i), 0);
  EXPECT_THAT(r.runs, ElementsAre("a"));
}

TEST(DataFile, EqualTimesInACoastDownAreAveraged) {
  std::string text = "run_id,time_s,speed_rpm\n";
  for (int k = 0; k < 60; ++k)
    text += fmt::format("a,{0},{1}\na,{0},{2}\n", k, 1000.3 - 9 * k, 999.7 - 9 * k);
  const Record r = record_of(text, flywheel());
  EXPECT_THAT(texts(r.notes), Contains("run a: 120 samples have only 60 different times, so "
                                       "samples of the same time are averaged (first in line 2)"));
  for (std::size_t i = 0; i < r.rows(); ++i)
    EXPECT_NEAR(r.value(record::friction_torque, i), 0.85 * 9 * rpm, 1e-6);
}

TEST(DataFile, ACoastDownNeedsTheInertia) {
  EXPECT_THAT(data_error("run_id,time_s,speed_rpm\na,0,1000\n"),
              HasSubstr("the model needs inertia_kgm2 under [rig]"));
}

/// Times of falls by 100 rpm from 1000 to 500 under M = J k (ω + ω0): t = ln(...)/k.
std::string falls(const std::string& header = "speed_from_rpm,speed_to_rpm,time_s") {
  std::string text = header + "\n";
  for (int from = 1000; from > 500; from -= 100)
    text += fmt::format("{},{},{:.6f}\n", from, from - 100,
                        std::log((from + 300.0) / (from + 200.0)) / 0.01);
  return text;
}

TEST(DataFile, TimesBetweenTwoSpeedsBecomeTorque) {
  const Record r = record_of(falls(), flywheel());
  ASSERT_EQ(r.rows(), 5u);
  EXPECT_FALSE(r.has(record::time));
  EXPECT_EQ(r.deviation_of(record::friction_torque), nullptr);
  for (std::size_t i = 0; i < r.rows(); ++i) {
    const double truth = 0.85 * 0.01 * (r.value(record::speed, i) + 300 * rpm);
    EXPECT_NEAR(r.value(record::friction_torque, i), truth, 3e-5 * truth);
    EXPECT_EQ(r.line(i), static_cast<int>(i) + 2);
  }
  EXPECT_THAT(texts(r.notes),
              Contains(StartsWith("5 torques from the times between two speeds, M = J (w1 "
                                  "- w2)/t with J = 0.85 kg m2")));
}

TEST(DataFile, TimesBetweenTwoSpeedsAreReadAsExcelWritesThem) {
  const Record r = record_of(
      "run_id;speed_from_rpm;speed_to_rpm;time_s;std_time_s;axial_load_N\r\n"
      "a;1000,0;900,0;10,5;0,1;250\r\na;900,0;800,0;12,5;0,1;250\r\na;50;30;9;0,1;250\r\n",
      flywheel());
  EXPECT_THAT(texts(r.notes), Contains("read with semicolons, decimal commas and CRLF line ends"));
  EXPECT_THAT(
      texts(r.notes),
      Contains("1 of 3 falls of the speed end below minimum_speed_rpm = 40 and are not used"));
  ASSERT_EQ(r.rows(), 2u);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.85 * 100 * rpm / 10.5);
  EXPECT_NEAR(r.value(record::torque_deviation, 1),
              r.value(record::friction_torque, 1) * 0.1 / 12.5, 1e-12);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 0), 250.0);
  EXPECT_THAT(r.runs, ElementsAre("a"));
}

TEST(DataFile, WhatIsWrongWithTimesBetweenTwoSpeedsIsNamed) {
  const auto error = [](const std::string& header, const std::string& row) {
    return data_error(header + "\n" + row + "\n", flywheel());
  };
  const std::string header = "speed_from_rpm,speed_to_rpm,time_s";
  EXPECT_EQ(error(header, "800,900,5"),
            "d.csv:2: speed_to_rpm = 900: must be below speed_from_rpm = 800 rpm");
  EXPECT_EQ(error(header, "900,800,0"), "d.csv:2: time_s = 0: must be from 1e-06 to 1000000000 s");
  EXPECT_EQ(error(header, "900,0,5"),
            "d.csv:2: speed_to_rpm = 0: must be from 0.001 to 1000000 rpm");
  EXPECT_EQ(
      error(header + ",speed_rpm", "900,800,5,850"),
      "d.csv:1: columns speed_rpm and speed_from_rpm cannot be in the same file: a file has only "
      "one of these: times between two speeds, speeds over time, or readings at constant speeds");
  EXPECT_THAT(error(header + ",friction_torque_Nmm", "900,800,5,850"),
              StartsWith("d.csv:1: columns friction_torque_Nmm and speed_from_rpm"));
  EXPECT_THAT(error("speed_from_rpm,time_s", "900,5"),
              StartsWith("d.csv:1: column speed_to_rpm is missing"));
  EXPECT_THAT(error("speed_from_rpm,speed_to_rpm", "900,800"),
              StartsWith("d.csv:1: column time_s is missing"));
  EXPECT_EQ(error(header, "30,20,5"),
            "d.csv: no fall of the speed ends above minimum_speed_rpm = 40 of [rig], so no row can "
            "be used");
  EXPECT_THAT(data_error(falls()), HasSubstr("the model needs inertia_kgm2 under [rig]"));
}

TEST(DataFile, AnUnknownInertiaMakesTheMeanTorqueThatOfTheModel) {
  model::Rig rig = flywheel();
  rig.axial_load = 100.0;
  const std::string text = "run_id,time_s,speed_rpm\n" + falling("a", 60);
  const Record known = record_of(text, rig);
  rig.inertia = unset;
  rig.unknown_inertia = true;
  for (const std::string& data : {text, falls()}) {
    const Record r = record_of(data, rig);
    EXPECT_THAT(texts(r.notes), Contains(StartsWith("inertia_kgm2 = \"unknown\": ")));
    // The model's torques by its own formula, f0 and z of the sample.
    double of_model = 0.0, of_record = 0.0;
    for (std::size_t i = 0; i < r.rows(); ++i) {
      const bearing::OperatingPoint point{.speed = r.value(record::speed, i),
                                          .axial_load = 100.0,
                                          .temperature = r.value(record::temperature, i)};
      of_model += model::predict_friction(fit::synthetic_model(), point).reading;
      of_record += r.value(record::friction_torque, i);
    }
    EXPECT_NEAR(of_record, of_model, 1e-9 * of_model);
  }
  // A factor, and nothing else.
  const Record r = record_of(text, rig);
  ASSERT_EQ(r.rows(), known.rows());
  const double factor =
      r.value(record::friction_torque, 0) / known.value(record::friction_torque, 0);
  for (std::size_t i = 0; i < r.rows(); ++i) {
    EXPECT_NEAR(r.value(record::friction_torque, i),
                factor * known.value(record::friction_torque, i), 1e-12);
    EXPECT_NEAR(r.value(record::torque_deviation, i),
                factor * known.value(record::torque_deviation, i), 1e-12);
  }
}

TEST(DataFile, TimeMustNotGoBackWithinARunOfACoastDown) {
  EXPECT_EQ(data_error("run_id,time_s,speed_rpm\na,1,1000\nb,0,1000\na,0,900\n", flywheel()),
            "d.csv:4: time_s = 0: must not go back within a run");
}

TEST(DataFile, ACoastDownBelowTheMinimumSpeedIsAnError) {
  EXPECT_THAT(data_error("time_s,speed_rpm\n0,10\n1,9\n", flywheel()),
              HasSubstr("all 2 rows have a speed below minimum_speed_rpm = 40"));
}

TEST(DataFile, TheFlywheelRecordIsRead) {
  const std::string path = tests::source_dir() + "/data/measurements/flywheel_unloaded.csv";
  const Record r = read_record(path, *on(flywheel()));
  EXPECT_EQ(r.runs.size(), 1u);
  EXPECT_GT(r.rows(), 20u);
  for (std::size_t i = 0; i < r.rows(); ++i) {
    EXPECT_GE(r.value(record::speed, i), 40 * rpm);
    EXPECT_GT(r.value(record::friction_torque, i), 0.0);
  }
}

}  // namespace
}  // namespace raceway::files

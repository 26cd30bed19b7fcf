// A torque sensor in files: its calibration, the table that says it, records of its signal.
#include <cmath>
#include <filesystem>
#include <fstream>

#include "files/data_file.h"
#include "files/model_file.h"
#include "files/sensor_file.h"
#include "files/subject.h"
#include "results/record_text.h"
#include "tests/support/message_of.h"
#include "tests/support/model_text.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string weights =
    "reference_Nm,signal_V\n0,0.101\n0.5,2.6\n1,5.102\n0.5,2.602\n0,0.1\n0.5,2.601\n1,5.099\n";

rig::SensorCalibration calibration(const std::string& text = weights) {
  return rig::calibrate_sensor(read_sensor_readings({"weights.csv", text}).readings);
}

ModelFile model_with(const std::string& table) {
  return parse_model(tests::model_text + "\n[rig]\naxial_load_N = 100\n" + table, "m.toml");
}

std::string model_problem(const std::string& table) {
  return tests::message_of([&] { (void)model_with(table); });
}

const std::string table = torque_sensor_text(calibration(), "weights.csv");

record::Record record_by(const ModelFile& file, const std::string& text) {
  return read_record({"d.csv", text}, *make_subject(file.model),
                     {.columns = file.columns, .sensor = file.sensor});
}

std::string record_problem(const ModelFile& file, const std::string& text) {
  return tests::message_of([&] { (void)record_by(file, text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == text.npos)
    throw std::logic_error(from + "does not apply, because the file has no column \"");
  return text.replace(at, from.size(), to);
}

TEST(SensorReadings, AreReadIntoSiWithTheirLines) {
  const SensorReadings read =
      read_sensor_readings({"w.csv", "# weights\nreference_Nm,signal_V,who\n0,0.1,A\n2.5,1.6,B\n"});
  ASSERT_EQ(read.readings.size(), 2U);
  EXPECT_DOUBLE_EQ(read.readings[1].torque, 2.5);
  EXPECT_DOUBLE_EQ(read.readings[1].signal, 1.6);
  EXPECT_EQ(read.readings[1].line, 4);
  EXPECT_THAT(texts(read.notes), ElementsAre("not used: who"));
}

TEST(SensorReadings, AreReadInOtherUnitsAsAGermanExcelWritesThem) {
  const std::string german = "Kalibrierung vom Montag\n\nreference;signal\nNmm;mV\n250;1248,1\n";
  const SensorReadings read = read_sensor_readings(
      {"w.csv", german}, {.columns = parse_column_map("[columns]\nreference_Nm = \"reference\"\n"
                                                      "signal_V = \"signal\"\n",
                                                      "map.toml")});
  EXPECT_DOUBLE_EQ(read.readings.at(0).torque, 0.25);
  EXPECT_DOUBLE_EQ(read.readings.at(0).signal, 1.2481);
  EXPECT_THAT(texts(read.notes), Contains(HasSubstr("1 mV = 0.001 V")));
  const SensorReadings named =
      read_sensor_readings({"w.csv", "reference_Nmm;torque_signal_mV\n250;1248,1\n"});
  EXPECT_DOUBLE_EQ(named.readings.at(0).torque, 0.25);
  EXPECT_DOUBLE_EQ(named.readings.at(0).signal, 1.2481);
}

// A sensor was calibrated by 9999.9 V of an instrument beyond its range.
TEST(SensorReadings, LeaveOutNumbersThatAreNoReadings) {
  const SensorReadings read =
      read_sensor_readings({"w.csv", "reference_Nm,signal_V\n0,0.1\n1,0.7\n2.5,9999.9\n5,3.1\n"});
  EXPECT_EQ(read.readings.size(), 3U);
  EXPECT_THAT(texts(read.notes), ElementsAre(HasSubstr("are not used (line 4)")));
}

TEST(SensorReadings, SayWhichColumnIsMissing) {
  EXPECT_THAT(tests::message_of([] {
                (void)read_sensor_readings({"w.csv", "reference_Nm,Signal\n0,0\n"});
              }),
              HasSubstr("w.csv:1: column signal_V is missing"));
  EXPECT_THAT(tests::message_of([] {
                (void)read_sensor_readings({"w.csv", "reference_Nm,signal_V\n0,-\n"});
              }),
              HasSubstr("w.csv:2: signal_V = \"-\": is not a number"));
}

TEST(TorqueSensorTable, ReadsBackAsItWas) {
  const rig::SensorCalibration c = calibration();
  const rig::TorqueSensor s = model_with(table).sensor.value();
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(s.coefficients[k], c.sensor.coefficients[k], 1e-14);
    EXPECT_NEAR(std::sqrt(s.covariance(k, k)), c.std(k), 1e-6 * c.std(k));
  }
  EXPECT_NEAR(s.covariance(0, 1), c.sensor.covariance(0, 1), 2e-6 * -c.sensor.covariance(0, 1));
  EXPECT_NEAR(s.scatter, c.sensor.scatter, 1e-6 * c.sensor.scatter);
  EXPECT_EQ(s.highest_torque, 1.0);
  EXPECT_EQ(s.highest_signal, 5.102);
  EXPECT_EQ(s.source, "weights.csv");
  EXPECT_FALSE(s.zero);
}

TEST(TorqueSensorTable, StaysWhenAModelIsWrittenAgain) {
  const ModelFile file = model_with(table);
  EXPECT_TRUE(parse_model(with_model(file, file.model), "again.toml").sensor);
}

TEST(TorqueSensorTable, RefusesWhatIsNoSensor) {
  EXPECT_THAT(model_problem(replaced(table, "residual_std_V", "residual_std_mV")),
              HasSubstr("unknown key in [torque_sensor]; did you mean residual_std_V?"));
  EXPECT_THAT(model_problem(replaced(table, "\"V/Nm\"", "\"mV/Nm\"")),
              HasSubstr("units = \"mV/Nm\": the unit of coefficient 2 must be \"V/Nm\""));
  EXPECT_THAT(model_problem(replaced(table, "torque_to_Nm = 1", "torque_to_Nm = 0")),
              HasSubstr("torque_to_Nm = 0 Nm: must be above torque_from_Nm = 0"));
  EXPECT_THAT(model_problem(replaced(table, "readings = 7", "zero_std_V = 1")),
              HasSubstr("zero_std_V is the standard deviation of zero_V, but zero_V is missing"));
  EXPECT_THAT(model_problem("[torque_sensor]\ncoefficients = [1]\n"),
              HasSubstr("must be a list of 2 to 4 numbers"));
  EXPECT_THAT(model_problem("[torque_sensor]\ncoefficients = [0, 1, -1]\nunits = [\"V\", "
                            "\"V/Nm\", \"V/Nm2\"]\nstd = [0, 0, 0]\ncorrelation = [[1], [0, 1], "
                            "[0, 0, 1]]\nresidual_std_V = 0\ntorque_from_Nm = 0\ntorque_to_Nm = "
                            "1\nsignal_from_V = 0\nsignal_to_V = 1\n"),
              HasSubstr("the curve has a maximum or minimum at 0.5 N m"));
  EXPECT_THAT(model_problem("[torque_sensor]\nfile = \"-\"\n"),
              HasSubstr("must be the name of a file"));
  EXPECT_THAT(model_problem("[torque_sensor]\nfile = \"none.toml\"\n"),
              HasSubstr("none.toml: no such file (names are relative to the model)"));
}

TEST(TorqueSensorTable, MayStandInAFileBesideTheModel) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "torque_signal_test";
  fs::create_directories(folder);
  std::ofstream(folder / "sensor.toml") << table;
  std::ofstream(folder / "model.toml")
      << tests::model_text << "[torque_sensor]\nfile = \"sensor.toml\"\nzero_V = 0.2\n";
  const ModelFile file = read_model((folder / "model.toml").string());
  EXPECT_EQ(file.sensor.value().zero, 0.2);
  ASSERT_EQ(file.files.size(), 1u);
  EXPECT_EQ(file.files.front().path, (fs::weakly_canonical(folder) / "sensor.toml").string());
  std::ofstream(folder / "sensor.toml") << "[rig]\n";
  EXPECT_THAT(tests::message_of([&] { (void)read_model((folder / "model.toml").string()); }),
              HasSubstr("sensor.toml: the file has no table [torque_sensor]"));
  fs::remove_all(folder);
}

TEST(TorqueSignal, IsFrictionTorqueWithItsStandardDeviation) {
  const ModelFile file = model_with(table);
  const record::Record r = record_by(file, "speed_rpm;torque_signal_mV\n1000;600,5\n2000;1100,5\n");
  const rig::SensedTorque first = rig::torque_of(*file.sensor, 0.6005);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), first.torque);
  EXPECT_DOUBLE_EQ(r.value(record::torque_deviation, 0), first.std);
  EXPECT_NEAR(first.torque, 0.1, 1e-3);
  EXPECT_THAT(texts(r.notes),
              Contains(HasSubstr("[torque_sensor] (weights.csv) converts torque_signal_V to the "
                                 "friction torque: std_Nmm of a row")));
  EXPECT_THAT(texts(r.notes), Not(Contains(HasSubstr("outside"))));
}

TEST(TorqueSignal, WrittenAsRowsIsReadBackAsTorque) {
  const ModelFile file = model_with(table);
  const record::Record r = record_by(file, "speed_rpm,torque_signal_V\n1000,0.6\n2000,1.1\n");
  const record::Record again =
      read_record({"rows.csv", results::record_text(r)}, *make_subject(file.model));
  EXPECT_NEAR(again.value(record::friction_torque, 1), r.value(record::friction_torque, 1), 1e-12);
  EXPECT_NEAR(again.value(record::torque_deviation, 1), r.value(record::torque_deviation, 1),
              1e-12);
}

TEST(TorqueSignal, HasADeviationOfItsOwnInThePlaceOfTheScatterOfAReading) {
  const ModelFile file = model_with(table);
  const record::Record r =
      record_by(file, "speed_rpm,torque_signal_V,std_V\n1000,0.6,0.05\n2000,1.1,0.0001\n");
  EXPECT_NEAR(r.value(record::torque_deviation, 0), 0.01, 1e-4);
  EXPECT_LT(r.value(record::torque_deviation, 1), rig::torque_of(*file.sensor, 1.1).std);
}

TEST(TorqueSignal, BeyondTheCalibrationIsToldWithItsLines) {
  const record::Record r = record_by(
      model_with(table), "speed_rpm,torque_signal_V\n1000,0.6\n2000,5.5\n3000,-0.2\n4000,1.0\n");
  EXPECT_THAT(texts(r.notes),
              Contains(HasSubstr("signals outside the calibrated range of 0.1 to 5.102 V: 2 of 4, "
                                 "down to -0.2 and up to 5.5 V (lines 3, 4)")));
}

TEST(TorqueSignal, TakesThePlaceOfATorqueBesideIt) {
  const record::Record r = record_by(
      model_with(table), "speed_rpm,friction_torque_Nmm,std_Nmm,torque_signal_V\n1000,900,1,0.6\n");
  EXPECT_NEAR(r.value(record::friction_torque, 0), 0.1, 1e-3);
  EXPECT_THAT(texts(r.notes), Contains(HasSubstr("column friction_torque_Nmm is not used")));
  EXPECT_THAT(texts(r.notes), Contains(HasSubstr("column std_Nmm is not used")));
}

TEST(TorqueSignal, WithoutACalibrationIsNoTorque) {
  const ModelFile file = model_with("");
  EXPECT_THAT(record_problem(file, "speed_rpm,torque_signal_V\n1000,0.6\n"),
              HasSubstr("d.csv:1: column torque_signal_V needs the calibration of the sensor, but "
                        "the model has no [torque_sensor]"));
  const record::Record r =
      record_by(file, "speed_rpm,friction_torque_Nmm,torque_signal_V\n1000,90,0.6\n");
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.09);
  EXPECT_THAT(texts(r.notes), Contains("column torque_signal_V is not used: the model has no "
                                       "[torque_sensor]"));
}

TEST(TorqueSignal, IsMappedLikeEveryColumn) {
  const ModelFile file = model_with(
      table + "[columns]\ntorque_signal_V = { column = \"DMS [mV/V]\", unit = \"mV\" }\n");
  EXPECT_NEAR(record_by(file, "speed_rpm,DMS [mV/V]\n1000,600\n").value(record::friction_torque, 0),
              0.1, 1e-3);
}

TEST(TorqueSignal, BadCellsAreNamed) {
  const ModelFile file = model_with(table);
  EXPECT_THAT(record_problem(file, "speed_rpm,torque_signal_V\n1000,x\n2000,\n"),
              HasSubstr("d.csv:2: torque_signal_V = \"x\": is not a number"));
  EXPECT_THAT(record_problem(file, "speed_rpm,torque_signal_V\n1000,0.6\n2000,\n"),
              HasSubstr("d.csv:3: torque_signal_V = \"\": is empty"));
  EXPECT_THAT(record_problem(file, "speed_rpm,std_V\n1000,0.6\n"),
              HasSubstr("column std_V needs a column torque_signal_V"));
  EXPECT_THAT(record_problem(file, "speed_rpm,signal_V\n1000,0.6\n"),
              HasSubstr("column signal_V is unknown; did you mean torque_signal_V?"));
  EXPECT_THAT(
      record_problem(file, "speed_from_rpm,speed_to_rpm,time_s,torque_signal_V\n10,5,1,0.6\n"),
      HasSubstr("columns torque_signal_V and speed_from_rpm"));
}

TEST(TorqueSignal, RowsWithoutOneAreDroppedWhereThatIsAskedFor) {
  const ModelFile file = model_with(table);
  const record::Record r =
      read_record({"d.csv", "speed_rpm,torque_signal_V\n1000,0.6\n2000,nan\n"},
                  *make_subject(file.model), {.sensor = file.sensor, .drop_nan = true});
  EXPECT_EQ(r.rows(), 1U);
}

}  // namespace
}  // namespace raceway::files

// A torque sensor from its calibration to a verdict on a record of its signal.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

const std::string measurements = tests::source_dir() + "/data/measurements/";
const std::string weights = measurements + "torque_weights.csv";
const std::string signals = measurements + "torque_signals.csv";

/// A folder with sensor.toml and rig.toml, which names it.
class Rig {
 public:
  explicit Rig(const std::string& more = "") {
    const Result sensor = run("calibrate-sensor " + weights + " -o " + file("sensor.toml"));
    EXPECT_EQ(sensor.status, 0) << sensor.err;
    scratch_.write("rig.toml",
                   "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22.0\n"
                   "viscosity_100C_mm2_s = 4.8\n[torque_sensor]\nfile = \"sensor.toml\"\n" +
                       more);
  }
  [[nodiscard]] std::string file(const std::string& name) const { return scratch_.file(name); }
  [[nodiscard]] std::string model() const { return file("rig.toml"); }

 private:
  ScratchFolder scratch_;
};

TEST(CalibrateSensor, PrintsCurveTestsAndTheErrorOfARow) {
  const Result r = run("calibrate-sensor " + weights);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("42 readings at 11 torques, 0 to 1 N m, 0.0298 to 4.9008 V"));
  EXPECT_THAT(r.out, HasSubstr("b1             4.86855    0.00062  V/Nm"));
  EXPECT_THAT(r.out, HasSubstr("M = (signal - 0.0311258 V) / 4.86855 V/Nm"));
  EXPECT_THAT(r.out, HasSubstr("lack of fit F(9, 31) = 0.359, p = 0.95"));
  EXPECT_THAT(r.out, HasSubstr("torque  std of a reading  common to all"));
  EXPECT_THAT(r.err, HasSubstr("warning: hysteresis: the signal at falling torque differs"));
  EXPECT_THAT(run("calibrate-sensor " + weights + " --quiet").err, Not(HasSubstr("note:")));
}

TEST(CalibrateSensor, TextAndJsonAndFileAgree) {
  const json document = parsed(run("calibrate-sensor " + weights + " --json"));
  EXPECT_THAT(keys(document),
              IsSupersetOf({"degree", "coefficients", "correlation", "residual_std_V", "readings",
                            "gain_std_percent", "linearity", "lack_of_fit", "hysteresis"}));
  EXPECT_EQ(document["degree"], 1);
  EXPECT_EQ(document["coefficients"][1]["unit"], "V/Nm");
  const double gain = document["coefficients"][1]["value"].get<double>();
  EXPECT_NEAR(gain, 4.86855, 5e-6);  // as the text has it
  const std::string file = run("calibrate-sensor " + weights + " -o - --quiet").out;
  const std::size_t at = file.find(", ", file.find("coefficients = [")) + 2;
  EXPECT_NEAR(std::stod(file.substr(at)), gain, 1e-14);
  EXPECT_THAT(file, HasSubstr("residual_std_V = 0.00121652"));
}

TEST(CalibrateSensor, ReadsAPipe) {
  const Result r = run_shell(
      "printf 'reference_Nm;signal_V\\n0;0,1\\n1;1,1\\n2;2,2\\n3;3,1\\n' | "
      "$raceway calibrate-sensor - --degree 1 --json");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(parsed(r)["source"], "standard input");
}

TEST(CalibrateSensor, RefusesInOneMessage) {
  EXPECT_THAT(run("calibrate-sensor " + weights + " --degree 4").err,
              HasSubstr("--degree = 4: must be 1, 2, 3 or auto"));
  EXPECT_EQ(run("calibrate-sensor " + weights + " --degree line").status, 1);
  EXPECT_THAT(run("calibrate-sensor " + weights + " --json -o -").err,
              HasSubstr("both --json and \"--output -\" write to stdout"));
  const ScratchFolder scratch;
  const std::string one = scratch.write("one.csv", "reference_Nm,signal_V\n1,1\n1,2\n1,3\n");
  const Result r = run("calibrate-sensor " + one + " -o " + scratch.file("s.toml"));
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("one.csv: all 3 readings are at one reference torque, 1 N m"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("s.toml")));
  const std::string kept = scratch.write("kept.toml", "kept");
  EXPECT_THAT(run("calibrate-sensor " + weights + " -o " + kept).err, HasSubstr("--force"));
  EXPECT_EQ(file_text(kept), "kept");
}

// Without the zero of the day its shift looks like a missing effect; with it nothing is missing,
// and f0 and z are those that made the record.
TEST(TorqueSignalRecord, GoesThroughTheLoop) {
  const Rig moved, tared("zero_V = 0.038\n");
  for (const Rig* rig : {&moved, &tared}) {
    const std::string fitted = rig->file("fitted.toml");
    const json calibration =
        parsed(run("calibrate " + rig->model() + " " + signals + " --json -o " + fitted));
    const json diagnosis = parsed(run("diagnose " + fitted + " " + signals + " --json"));
    if (rig == &moved) {
      EXPECT_EQ(diagnosis["verdict"], "ambiguous");
      EXPECT_THAT(diagnosis["explanations"].dump(), HasSubstr("torque-offset"));
      continue;
    }
    const json f0 = calibration["parameters"]["f0"], z = calibration["parameters"]["z"];
    EXPECT_NEAR(f0["value"].get<double>(), 1.9, 3 * f0["std"].get<double>());
    EXPECT_NEAR(z["value"].get<double>(), 0.0008, 3 * z["std"].get<double>());
    EXPECT_EQ(diagnosis["verdict"], "nothing-missing");
    EXPECT_EQ(diagnosis["baseline"]["noise"]["source"], "declared");
    EXPECT_NEAR(diagnosis["baseline"]["noise"]["rms"].get<double>(), 0.357, 1e-3);
  }
}

TEST(TorqueSignalRecord, IsTheSameRecordAsItsRows) {
  const Rig rig;
  const std::string rows = rig.file("rows.csv");
  ASSERT_EQ(run("check " + rig.model() + " " + signals + " -o " + rows).status, 0);
  const json signal = parsed(run("compare " + rig.model() + " " + signals + " --json"));
  const json torque = parsed(run("compare " + rig.model() + " " + rows + " --json"));
  EXPECT_NEAR(signal["rmse"].get<double>(), torque["rmse"].get<double>(), 1e-9);
  EXPECT_NEAR(signal["noise"]["rms"].get<double>(), torque["noise"]["rms"].get<double>(), 1e-9);
}

TEST(TorqueSignalRecord, SaysWhichPartOfItsErrorIsCommonToAllRows) {
  const Rig rig;
  EXPECT_THAT(run("compare " + rig.model() + " " + signals).err,
              HasSubstr("std_Nmm of a row is 0.253 to 0.257 N mm, of which 0.0386 to 0.0601 N mm "
                        "comes from the calibration: this part is common to all rows"));
}

TEST(TorqueSignalRecord, ASensorFileIsNeverWrittenOver) {
  const Rig rig;
  const std::string sensor = rig.file("sensor.toml"), text = file_text(sensor);
  const std::string of = rig.model() + " " + signals + " -o " + sensor + " --force";
  const Result calibrated = run("calibrate " + of), checked = run("check " + of);
  EXPECT_EQ(calibrated.status, 1);
  EXPECT_THAT(
      calibrated.err,
      HasSubstr(
          ": this run reads this file, so it cannot write to the same file; name another file"));
  EXPECT_EQ(checked.status, 1);
  EXPECT_THAT(checked.err, HasSubstr("tables are written as CSV"));
  EXPECT_EQ(file_text(sensor), text);
}

TEST(TorqueSignalRecord, AModelWrittenElsewhereFindsItsSensor) {
  const Rig rig;
  std::filesystem::create_directories(rig.file("sub"));
  // Another file of that name, which it once read without a word.
  std::ofstream(rig.file("sub/sensor.toml")) << "[torque_sensor]\n";
  const Result r =
      run("calibrate " + rig.model() + " " + signals + " -o " + rig.file("sub/m.toml"));
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(file_text(rig.file("sub/m.toml")), HasSubstr("file = \"../sensor.toml\""));
  const Result beside =
      run("calibrate " + rig.model() + " " + signals + " -o " + rig.file("m.toml"));
  ASSERT_EQ(beside.status, 0) << beside.err;
  EXPECT_THAT(file_text(rig.file("m.toml")), HasSubstr("file = \"sensor.toml\""));
  const auto errors = [&](const std::string& model) {
    return parsed(run("compare " + rig.file(model) + " " + signals + " --json"))["rmse"];
  };
  EXPECT_EQ(errors("sub/m.toml"), errors("m.toml"));
}

TEST(TorqueSignalRecord, ModelsWithOtherSensorsAreComparedByThatOfTheFirst) {
  const Rig rig, tared("zero_V = 0.038\n");
  EXPECT_THAT(run("compare " + rig.model() + " " + tared.model() + " " + signals).err,
              HasSubstr("its [torque_sensor] differs from [torque_sensor] of " + rig.model()));
  EXPECT_THAT(run("compare " + rig.model() + " " + rig.model() + " " + signals).err,
              Not(HasSubstr("differs from [torque_sensor]")));
}

}  // namespace
}  // namespace raceway::tests

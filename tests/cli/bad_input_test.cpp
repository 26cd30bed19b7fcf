#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// Every wrong file gets one message with file, line, key or column, value and range, status 1, and
/// leaves no output behind.
class BadInput : public testing::Test {
 protected:
  void expect_model_refused(const std::string& text, const std::string& message) const {
    const std::string model = scratch_.write("my.toml", text), out = scratch_.file("out.csv");
    const Result r = run("table " + model + " --speed 0,1000 --axial-load 100 -o " + out);
    expect_refused(r, model + message);
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  /// Changes one line of the model.
  void expect_refused_with(const std::string& from, const std::string& to,
                           const std::string& message) const {
    expect_model_refused(replaced(model_text, from, to), message);
  }
  void expect_data_refused(const std::string& text, const std::string& message) const {
    const std::string data = scratch_.write("rig.csv", text), out = scratch_.file("out.toml");
    const std::string model = scratch_.write("my.toml", model_text);
    expect_refused(run("calibrate " + model + " " + data + " -o " + out), data + message);
    expect_refused(run("compare " + model + " " + data), data + message);
    EXPECT_FALSE(std::filesystem::exists(out));
  }
  ScratchFolder scratch_;
};

TEST_F(BadInput, MissingKeyIsNamedWithItsRange) {
  expect_refused_with("ball_count = 20\n", "",
                      ":1: [bearing] ball_count is missing: must be from 3");
  expect_refused_with("viscosity_40C_mm2_s = 22.0\n", "",
                      ":11: [lubricant] viscosity_40C_mm2_s is missing");
  expect_refused_with("[lubricant]\nviscosity_40C_mm2_s = 22.0\nviscosity_100C_mm2_s = 4.8\n", "",
                      ": table [lubricant] is missing");
}

TEST_F(BadInput, MisspeltKeyTableAndNameAreAnsweredWithTheNearest) {
  expect_refused_with("ball_count", "ball_cuont",
                      ":3: ball_cuont = 20: unknown key in [bearing]; did you mean ball_count?");
  expect_refused_with("[lubricant]", "[lubricnt]",
                      ":11: [lubricnt]: unknown table; did you mean lubricant?");
  expect_refused_with(
      "static", "ball_material = \"stel\"\nstatic",
      ":9: ball_material = \"stel\": must be steel or silicon-nitride; did you mean "
      "steel?");
  expect_model_refused(model_text + "[[effect]]\nid = \"spin-frction\"\n",
                       ":20: id = \"spin-frction\": unknown effect; did you mean spin-friction?");
  expect_refused_with("name = \"7014\"", "catalogue = \"S 6041 C\"",
                      ":2: bearing \"S 6041 C\" is not in the catalogue; similar designations: ");
  expect_model_refused(
      model_text + "[solver]\nrace_control = \"iner\"\n",
      ":20: race_control = \"iner\": must be outer, inner or balanced; did you mean inner?");
}

TEST_F(BadInput, WrongTypeIsNamed) {
  expect_refused_with("ball_count = 20", "ball_count = \"20\"",
                      ":3: ball_count = \"20\": must be a number, not a text");
  expect_refused_with("ball_count = 20", "ball_count = 20.5",
                      ":3: ball_count = 20.5: must be a whole number from 3 to 200");
  expect_refused_with("name = \"7014\"", "name = 7014",
                      ":2: name = 7014: must be a text in quotes, not a number");
  const std::string friction = "[friction]\nf0 = 1.5\nz = 0.001\ny = 0.33\n";
  expect_model_refused("friction = 3\n" + replaced(model_text, friction, ""),
                       ":1: friction = 3: must be a table, written as [friction]");
}

TEST_F(BadInput, ImpossibleValueIsNamedWithUnitAndRange) {
  expect_refused_with("ball_diameter_mm = 11.906", "ball_diameter_mm = -11.906",
                      ":4: ball_diameter_mm = -11.906 mm: must be from 0.1 to 300 mm");
  expect_refused_with("f0 = 1.5", "f0 = nan", ":16: f0 = nan: must be from");
  expect_refused_with("pitch_diameter_mm = 90.0", "pitch_diameter_mm = inf",
                      ":5: pitch_diameter_mm = inf mm: must be from 1 to 5000 mm");
  expect_refused_with("inner_conformity = 0.52", "inner_conformity = 0.5",
                      ":7: inner_conformity = 0.5: must be from 0.5005 to 0.7");
  expect_refused_with("ball_count = 20", "ball_count = 30", ":3: ball_count = 30");
  expect_refused_with("ball_count = 20", "ball_count = 0", ":3: ball_count = 0: must be from 3");
}

TEST_F(BadInput, TextThatIsNoTomlIsPlaced) {
  expect_refused_with("ball_count = 20", "ball_count = ", ":3:");
  expect_refused_with("ball_count = 20", "ball_count = 20\nball_count = 21", ":4:");
  expect_refused_with("[friction]", "[friction", ":15:");
}

TEST_F(BadInput, FileThatIsNoneIsNamed) {
  const std::string folder = scratch_.path().string();
  const std::string model = scratch_.write("my.toml", model_text);
  expect_refused(run("solve none.toml --speed 1 --axial-load 1"), "none.toml: no such file\n");
  expect_refused(run("solve " + folder + " --speed 1"), folder + ": is a directory");
  expect_refused(run("compare " + model + " none.csv"), "none.csv: no such file\n");
  expect_refused(run("compare " + model + " " + folder), folder + ": is a directory");
  expect_refused(run("solve '' --speed 1"), "name of an input file is empty");
}

TEST_F(BadInput, ModelAndDataInTheWrongOrderAreToldApart) {
  const std::string model = scratch_.write("my.toml", model_text);
  const std::string data = scratch_.write("rig.csv", data_text);
  expect_refused(run("calibrate " + data + " " + model),
                 data + ": this is a file of measurements; a model (TOML) is expected here\n");
  expect_refused(run("compare " + model + " " + model),
                 model + ": this is a model file; measurements (CSV) are expected here\n");
}

TEST_F(BadInput, DataWithoutWhatIsNeededNameIt) {
  expect_data_refused("", ": the file is empty");
  expect_data_refused("\n\n", ": the file is empty");
  expect_data_refused("speed_rpm,axial_load_N,friction_torque_Nmm\n", ": no data rows");
  expect_data_refused("speed_rpm,axial_load_N\n1000,100\n", ":1: a measured column is missing:");
  expect_data_refused("axial_load_N,friction_torque_Nmm\n1000,100\n",
                      ":1: column speed_rpm is missing");
  expect_data_refused("speed_rpm,friction_torque_Nmm\n1000,100\n",
                      ":1: the axial load is missing: give a column axial_load_N");
  expect_data_refused("1000,100,92\n2000,100,140\n",
                      ":1: the header line with the column names is missing");
}

TEST_F(BadInput, MisspeltColumnIsAnsweredWithTheNearest) {
  expect_data_refused(
      "speed_rpm,axial_load_N,fricton_torque_Nmm\n1000,100,92\n",
      ":1: column fricton_torque_Nmm is unknown; did you mean friction_torque_Nmm?");
  expect_data_refused("speed,axial_load_N,friction_torque_Nmm\n1000,100,92\n",
                      ":1: column speed is unknown; did you mean speed_rpm?");
}

TEST_F(BadInput, BadCellsAreListedWithTheirLines) {
  const std::string header = "speed_rpm,axial_load_N,friction_torque_Nmm\n";
  expect_data_refused(header + "1000,100,abc\n",
                      ":2: friction_torque_Nmm = \"abc\": is not a number");
  expect_data_refused(header + "1000,100,92\n# pause\n2000,,140\n",
                      ":4: axial_load_N = \"\": is empty");
  expect_data_refused(header + "1000,100,nan\n",
                      ":2: friction_torque_Nmm = \"nan\": is not a finite");
  expect_data_refused(header + "-1000,100,92\n", ":2: speed_rpm = -1000: must be from 0 to");
  expect_data_refused(header + "1000,100,92\n1000,100\n",
                      ":3: 2 cells, but the header (line 1) has 3");
}

TEST_F(BadInput, MixedOrDoubleColumnsAreRefused) {
  expect_data_refused(
      "speed_rpm,axial_load_N,friction_torque_Nmm\n1000;100;92\n",
      ":2: the header (line 1) has commas as separators, but this row has semicolons");
  expect_data_refused("speed_rpm;axial_load_N,friction_torque_Nmm\n1000;100;92\n",
                      ":1: the header has");
  expect_data_refused("speed_rpm,speed_rpm,axial_load_N,friction_torque_Nmm\n1,1,1,1\n",
                      ":1: column speed_rpm occurs twice, as columns 1 and 2");
  expect_data_refused("speed_rpm;axial_load_N;friction_torque_Nmm\n1000;100,5;92.5\n", ":2: ");
}

TEST_F(BadInput, APointThatMaySeparateThousandsInAFlagIsAskedAbout) {
  const std::string model = scratch_.write("my.toml", model_text);
  const auto table = [&](const std::string& flags) { return run("table " + model + flags); };
  expect_refused(table(" --speed 0:12.000:500 --axial-load 100"),
                 "--speed = 12.000: is it 12000, or is the point a decimal mark? Write 12000 or "
                 "12.0000");
  expect_refused(table(" --speed 600 --axial-load 600,1.200"), "--axial-load = 1.200: is it 1200");
  expect_refused(run("solve " + model + " --speed 10.000 --axial-load 300"),
                 "--speed = 10.000: is it 10000");
  // A point at another place is a decimal mark for all, and no oil has 40 125 C.
  for (const char* flags :
       {" --speed 600.5,1000.125 --axial-load 100", " --speed 600 --axial-load 1.2000",
        " --speed 600 --axial-load 100 --temperature 40.125"})
    EXPECT_EQ(table(flags).status, 0) << flags;
}

TEST_F(BadInput, ANegativeNumberOfTriedExplanationsIsRefused) {
  const std::string model = scratch_.write("my.toml", model_text);
  const std::string data = scratch_.write("rig.csv", data_text);
  expect_refused(run("diagnose " + model + " " + data + " --tried-before -5"),
                 "--tried-before = -5 explanations: must be from 0 to 1000000 explanations");
}

TEST_F(BadInput, UnwritableOutputIsToldBeforeTheWork) {
  const std::string model = scratch_.write("my.toml", model_text);
  const std::string table = "table " + model + " --speed 0:9000:0.001 --axial-load 100 -o ";
  expect_refused(run(table + scratch_.path().string()), ": is a directory");
  expect_refused(run(table + scratch_.file("none/t.csv")),
                 ": cannot be written: this folder does not exist:");
  const std::string old = scratch_.write("old.csv", "old");
  expect_refused(run(table + old), "exists already");
  EXPECT_EQ(file_text(old), "old");
}

}  // namespace
}  // namespace raceway::tests

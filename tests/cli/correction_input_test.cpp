// Records and files that are wrong: a clear message each, nothing half written.
#include <string>

#include "tests/cli/correction_record.h"
#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string cell(const std::string& line, std::size_t column, const std::string& value) {
  std::size_t begin = 0;
  for (; column > 0; --column) begin = line.find(',', begin) + 1;
  return line.substr(0, begin) + value + line.substr(line.find_first_of(",\n", begin));
}

class CorrectionInput : public testing::Test {
 protected:
  /// The record of a day with a fault in its lines.
  std::string record(const std::function<std::string(int, std::string)>& line, int rows = 1440) {
    return scratch_.write("r.csv", RecordOfADay{.line = line, .rows = rows}.csv());
  }
  ScratchFolder scratch_;
  const std::string model_ = scratch_.write("z.toml", z_model());
};

TEST_F(CorrectionInput, TimeThatIsUnsortedOrRepeatedIsRefused) {
  const std::string back =
      record([](int k, std::string text) { return k == 9 ? cell(text, 0, "300") : text; });
  const std::string twice =
      scratch_.write("twice.csv", RecordOfADay{.line = [](int k, std::string text) {
                                    return k == 9 ? cell(text, 0, "480") : text;
                                  }}.csv());
  for (const char* command : {"check ", "identify ", "correct ", "compare ", "diagnose "}) {
    expect_refused(run(command + model_ + " " + back), "r.csv:11: time_s = 300: goes back within");
    expect_refused(run(command + model_ + " " + twice),
                   "twice.csv:11: time_s = 480: occurs twice within a run");
  }
}

TEST_F(CorrectionInput, AGapIsNamedAndIsNoLeap) {
  const std::string gap =
      record([](int k, std::string text) { return k > 300 && k < 500 ? std::string() : text; });
  const Result r = run("identify " + model_ + " " + gap);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("1 gap in time, the first before line 303, the longest 1.2e+04 s"));
  EXPECT_THAT(r.err, HasSubstr("enter another run_id for the rows after the gap"));
  EXPECT_THAT(r.err, Not(HasSubstr("leaps")));
}

TEST_F(CorrectionInput, ASensorThatSticksIsNamedBeforeAnyVerdict) {
  const std::string stuck = record(
      [](int k, std::string text) { return k >= 300 && k < 500 ? cell(text, 2, "28.5") : text; });
  for (const char* command : {"identify ", "diagnose --no-pairs ", "calibrate ", "check "})
    EXPECT_THAT(run(command + model_ + " " + stuck).err,
                HasSubstr("front_temperature_C is constant for 199 min from 1.8e+04 s on, while "
                          "other columns change: check the sensor"))
        << command;
  const json d = parsed(run("diagnose --no-pairs " + model_ + " " + stuck + " --json"));
  EXPECT_THAT(d["notes"].dump(), HasSubstr("check the sensor"));
}

TEST_F(CorrectionInput, ASensorThatLeapsIsNamedBeforeAnyVerdict) {
  const std::string leap = record([](int k, std::string text) {
    return k >= 700 ? cell(text, 2, std::to_string(60.0 + 0.01 * (k % 7))) : text;
  });
  for (const char* command : {"identify ", "diagnose --no-pairs ", "calibrate ", "check "})
    EXPECT_THAT(run(command + model_ + " " + leap).err,
                HasSubstr("front_temperature_C jumps by more than"))
        << command;
}

TEST_F(CorrectionInput, AColumnThatNeverVariesIsNamed) {
  const std::string still = record([](int, std::string text) { return cell(text, 2, "20"); });
  for (const char* command : {"identify ", "diagnose --no-pairs ", "calibrate ", "check "})
    EXPECT_THAT(run(command + model_ + " " + still).err,
                HasSubstr("front_temperature_C does not vary, so it gives no information"))
        << command;
}

TEST_F(CorrectionInput, ARecordShorterThanTheSlowTimeConstantIsSaid) {
  const std::string brief = record([](int, std::string text) { return text; }, 60);
  EXPECT_THAT(run("check " + model_ + " " + brief).err,
              HasSubstr("channel front: the time constant of 1800 s is more than a third of the "
                        "record of 3540 s, so the record does not determine it"));
  EXPECT_THAT(run("identify " + model_ + " " + brief).err,
              HasSubstr("the record of 3.54e+03 s is shorter than three time constants"));
}

TEST_F(CorrectionInput, PowerNeedsAFrictionTable) {
  const std::string power = scratch_.write(
      "p.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "input = \"power_W\"\nsections = [{ gain_um_W = 0.2, time_constant_s = 4000 }]\n");
  expect_refused(run("correct " + power + " " + record([](int, std::string t) { return t; })),
                 "p.toml:4: input = \"power_W\": friction_table is missing");
}

/// K and T of a published spindle end at 214.7 W, where T is 0.
TEST_F(CorrectionInput, PowerBeyondTheDelayElementIsSaid) {
  scratch_.write("friction.csv",
                 "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n"
                 "0,500,40,300\n10000,500,40,300\n");
  const std::string element =
      scratch_.write("e.toml",
                     "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
                     "input = \"power_W\"\nfriction_table = \"friction.csv\"\naxial_load_N = 500\n"
                     "gain = { slope_um_W = 0.4817, offset_um = 10.3617 }\n"
                     "time_constant = { slope_min_W = -0.6298, offset_min = 135.245 }\n");
  const std::string data = record([](int, std::string text) { return text; });
  const Result r = run("correct " + element + " " + data);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("no displacement is predicted from line 123 on, because the input "
                               "of a delay element is outside the range of this element"));
  const std::string beyond =
      "channel power: 282.7 W in line 122: this power is outside the range of the delay element, "
      "because the time constant of the element is positive only below 214.7 W";
  EXPECT_THAT(run("compare " + element + " " + data).err, HasSubstr(beyond));
  // Nothing is fitted that rests on it: calibrate and diagnose once ended without a word.
  for (const char* command : {"identify ", "calibrate ", "diagnose --tolerance 1um "})
    expect_refused(run(command + element + " " + data), beyond);
}

TEST_F(CorrectionInput, APolynomialAtAnotherSamplingIsRefused) {
  const std::string printed = scratch_.write(
      "p.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 1\n"
      "[[correction.channel]]\nname = \"published\"\ninput = \"front_temperature_C\"\n"
      "numerator = [16.0005, -15.9975]\ndenominator = [1, -0.99983]\n");
  const std::string data = record([](int, std::string text) { return text; });
  for (const char* command : {"correct ", "compare ", "identify ", "diagnose --tolerance 1um "})
    expect_refused(run(command + printed + " " + data),
                   "the coefficients of channel published are only valid for a sampling interval "
                   "of 1 s, but line 3 comes 60 s after the row before");
}

TEST_F(CorrectionInput, TablesThatAModelNamesAreNeverWrittenOver) {
  const std::string friction = scratch_.write(
      "friction.csv",
      "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n0,500,40,1\n20000,500,40,1\n");
  const std::string gains = scratch_.write("K.csv", "power_W,gain_um\n0,0\n50,20\n");
  const std::string constants =
      scratch_.write("T.csv", "power_W,time_constant_min\n0,100\n50,60\n");
  const std::string element =
      scratch_.write("e.toml",
                     "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
                     "input = \"power_W\"\nfriction_table = \"friction.csv\"\naxial_load_N = 500\n"
                     "gain = { table = \"K.csv\" }\ntime_constant = { table = \"T.csv\" }\n");
  const std::string data = record([](int, std::string text) { return text; });
  for (const std::string& table : {friction, gains, constants}) {
    const std::string before = file_text(table);
    for (const std::string& command :
         {"correct " + element + " " + data, "identify " + element + " " + data,
          "calibrate " + element + " " + data, "export " + element + " --format csv"}) {
      const Result r = run(command + " --force -o " + table);
      EXPECT_EQ(r.status, 1) << command;
      EXPECT_THAT(r.err, HasSubstr(": this run reads this file, so it cannot write to the same "
                                   "file; name another file"));
      EXPECT_EQ(file_text(table), before) << command;
    }
  }
}

TEST_F(CorrectionInput, AModelFromStandardInputIsReadOnce) {
  const std::string data = record([](int, std::string text) { return text; });
  for (const char* command : {"compare - ", "diagnose --no-pairs - ", "calibrate - ", "check - "}) {
    const Result r = run_shell("$raceway " + std::string(command) + data + " < " + model_);
    EXPECT_EQ(r.status, 0) << command << r.err;
  }
  const Result bearing = run_shell("$raceway check - < " + scratch_.write("b.toml", model_text));
  EXPECT_EQ(bearing.status, 0) << bearing.err;
}

/// One file of a machine: its bearing on a rig, and its displacement over hours.
class BesideABearing : public CorrectionInput {
 protected:
  const std::string both_ = scratch_.write(
      "both.toml", std::string(model_text) + "\n" + z_model() +
                       "\n[calibration]\nfree = [\"f0\", \"gains\", \"time_constants\"]\n");
  const std::string rig_ = scratch_.write("rig.csv", data_text);
  const std::string day_ = record([](int, std::string text) { return text; });
};

TEST_F(BesideABearing, AColumnSaysWhichOfThemIsMeant) {
  const std::string torque = " --channel friction_torque_Nmm", z = " --channel displacement_z_um";
  const std::string asks =
      "the file has a bearing and the correction of displacement_z_um: choose one with --channel";
  for (const std::string& data : {rig_, day_}) {
    expect_refused(run("compare " + both_ + " " + data), asks);
    expect_refused(run("check " + both_ + " " + data), asks);
    expect_refused(run("diagnose " + both_ + " " + data), asks);
  }
  EXPECT_EQ(parsed(run("compare " + both_ + " " + rig_ + torque + " --json"))["unit"], "Nmm");
  EXPECT_EQ(parsed(run("compare " + both_ + " " + day_ + z + " --json"))["unit"], "um");
  const json of_torque = parsed(run("calibrate " + both_ + " " + rig_ + torque + " --json"));
  EXPECT_EQ(keys(of_torque["parameters"]), std::set<std::string>{"f0"});
  const json over_time = parsed(run("calibrate " + both_ + " " + day_ + z + " --json"));
  EXPECT_EQ(keys(over_time["parameters"]),
            (std::set<std::string>{"front.gain_1", "front.time_constant_1"}));
  EXPECT_EQ(parsed(run("diagnose " + both_ + " " + day_ + z + " --no-pairs --json"))["unit"], "um");
  expect_refused(run("diagnose " + both_ + " " + rig_ + torque), "8 rows can be predicted");
  EXPECT_EQ(parsed(run("check " + both_ + " " + day_ + z + " --json"))["sampling_s"], 60.0);
  EXPECT_EQ(run("solve " + both_ + " --speed 1000 --axial-load 100").status, 0);
  EXPECT_EQ(run("correct " + both_ + " " + day_).status, 0);
  EXPECT_EQ(run_shell("$raceway compare - " + day_ + z + " < " + both_).status, 0);
  // The flag's former name.
  EXPECT_EQ(run("compare " + both_ + " " + day_ + " --displacement displacement_z_um").status, 0);
}

TEST_F(BesideABearing, WithoutDataBothAreChecked) {
  const Result r = run("check " + both_);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("correction.initial_state"));
  EXPECT_THAT(r.out, HasSubstr("solver.tilt"));
  const Result piped = run_shell("$raceway check - < " + both_);
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_THAT(piped.out, HasSubstr("correction.initial_state"));
}

/// Options that once were taken and did nothing.
TEST_F(BesideABearing, AnOptionThatMeansNothingIsRefused) {
  const std::string bearing = scratch_.write("bearing.toml", model_text);
  expect_refused(run("compare " + bearing + " " + rig_ + " --channel displacement_z_um"),
                 "--channel displacement_z_um: " + bearing +
                     " does not predict this channel; it predicts friction_torque_Nmm");
  expect_refused(run("compare " + bearing + " " + rig_ + " --zero first"), "--zero");
  expect_refused(run("diagnose " + model_ + " " + day_ + " --per-record front.gain_1"),
                 "--per-record: a correction is compared with one record");
}

TEST_F(CorrectionInput, AModelWrittenElsewhereFindsItsTables) {
  scratch_.write("friction.csv",
                 "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n"
                 "0,500,40,1\n20000,500,40,1\n");
  scratch_.write("K.csv", "power_W,gain_um\n0,0\n50,20\n");
  scratch_.write("T.csv", "power_W,time_constant_min\n0,100\n50,60\n");
  const std::string model = scratch_.write(
      "e.toml",
      "[correction]  # Gr\u00fc\u00dfe\ndisplacement = "
      "\"displacement_z_um\"\n[[correction.channel]]\n"
      "input = \"power_W\"\nfriction_table = \"friction.csv\"\naxial_load_N = 500\n"
      "gain = { table = \"K.csv\" }  # \u00b5m\ntime_constant = { table = \"T.csv\" }\n"
      "[calibration]\nfree = [\"offset\"]\n");
  const std::string data = record([](int, std::string text) { return text; });
  std::filesystem::create_directories(scratch_.file("other"));
  // A table of that name in the other folder, which it once read without a word.
  std::ofstream(scratch_.file("other/K.csv")) << "power_W,gain_um\n0,0\n50,2000\n";
  const auto written = [&](const std::string& name) {
    const Result r = run("calibrate " + model + " " + data + " --force -o " + scratch_.file(name));
    EXPECT_EQ(r.status, 0) << r.err;
    return parsed(run("compare " + scratch_.file(name) + " " + data + " --json"))["rmse"];
  };
  EXPECT_EQ(written("other/moved.toml"), written("beside.toml"));
  const std::string moved = file_text(scratch_.file("other/moved.toml"));
  for (const char* table :
       {"\"../friction.csv\"", "{ table = \"../K.csv\" }  # \u00b5m", "{ table = \"../T.csv\" }"})
    EXPECT_THAT(moved, HasSubstr(table));
}

TEST_F(BesideABearing, ANameThatNeitherKnowsIsRefused) {
  const std::string wrong =
      scratch_.write("wrong.toml", std::string(model_text) + "\n" + z_model() +
                                       "\n[calibration]\nfree = [\"f0\", \"front.gian_1\"]\n");
  expect_refused(run("calibrate " + wrong + " " + day_ + " --channel displacement_z_um"),
                 "front.gain_1");
}

}  // namespace
}  // namespace raceway::tests

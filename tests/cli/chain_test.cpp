// The chain from a friction rig to one correction of a machine: data/chain, scripts/chain-demo.
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string chain = tests::source_dir() + "/data/chain/";

/// A spindle whose K is 10 % and whose T is 15 % too small, and the rest of the machine.
const std::string computed_spindle =
    "[correction]\nname = \"spindle\"\ndisplacement = \"displacement_z_um\"\ntolerance_um = 2.0\n"
    "[[correction.channel]]\nname = \"spindle\"\ninput = \"power_W\"\n"
    "friction_table = \"friction_table.csv\"\n"
    "gain = { slope_um_W = 0.158, offset_um = 5.3 }\n"
    "time_constant = { slope_min_W = -0.056, offset_min = 29.0 }\n"
    "[correction.kinematic]\nA = 0.00115\nB = 0.6151\nC = 0.000634\n";

class Chain : public testing::Test {
 protected:
  void SetUp() override {
    scratch_.write("friction_table.csv", file_text(chain + "friction_table.csv"));
    scratch_.write("spindle.toml", computed_spindle);
    ASSERT_EQ(run("identify " + chain + "machine.toml " + chain + "calibration.csv -o " +
                  path("machine.toml"))
                  .status,
              0);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return scratch_.file(name); }
  [[nodiscard]] double error(const std::string& model) const {
    const json d =
        parsed(run("compare " + model + " " + chain + "verification.csv --from 20h --json"));
    return d["rmse_um"].get<double>();
  }
  Result calibrated(const std::string& model) const {
    return run("calibrate " + model + " " + chain + "verification.csv --until 20h --force -o " +
               path("fitted.toml"));
  }
  ScratchFolder scratch_;
};

/// With the spindle's numbers free and no priors the error on the rest rose from 1.60 to 2.00 um.
TEST_F(Chain, AFitOfTheSumDoesNotMakeTheRestWorse) {
  ASSERT_EQ(
      run("join " + path("spindle.toml") + " " + path("machine.toml") + " -o " + path("sum.toml"))
          .status,
      0);
  const double before = error(path("sum.toml"));
  const Result fit = calibrated(path("sum.toml"));
  ASSERT_EQ(fit.status, 0) << fit.err;
  EXPECT_THAT(fit.err, Not(HasSubstr("is at a bound")));
  EXPECT_LT(error(path("fitted.toml")), before);

  // Without the priors it does, and the program says so.
  const std::string text = file_text(path("sum.toml"));
  const std::size_t begin = text.find("[correction.prior]"), end = text.find("\n\n", begin);
  ASSERT_NE(begin, text.npos);
  const std::string free =
      replaced(text.substr(0, begin) + text.substr(end), "\"spindle.scale\", ", "");
  const Result worse = calibrated(scratch_.write("free.toml", free));
  ASSERT_EQ(worse.status, 0) << worse.err;
  EXPECT_THAT(worse.err, HasSubstr("but before the fit the error was"));
}

/// Half a day at rest says nothing of a spindle.
TEST_F(Chain, ARecordAtRestLeavesTheSpindleWhereItIs) {
  ASSERT_EQ(
      run("join " + path("spindle.toml") + " " + path("machine.toml") + " -o " + path("sum.toml"))
          .status,
      0);
  const Result fit = run("calibrate " + path("sum.toml") + " " + chain +
                         "calibration.csv --json -o " + path("fitted.toml"));
  ASSERT_EQ(fit.status, 0) << fit.err;
  const json parameters = parsed(fit)["parameters"];
  for (const char* const name : {"spindle.scale", "kinematic.A", "kinematic.B", "kinematic.C"}) {
    EXPECT_TRUE(parameters[name]["held"].get<bool>()) << name;
    EXPECT_EQ(parameters[name]["value"], parameters[name]["prior"]["value"]) << name;
  }
  EXPECT_THAT(fit.err, HasSubstr("spindle.scale stays at its prior, 1 ± 0.2"));
}

/// The spindle that the record is of.
TEST_F(Chain, TheSumOfBothPartsIsWithinATenthOfAMicrometre) {
  ASSERT_EQ(
      run("join " + chain + "true_spindle.toml " + path("machine.toml") + " -o " + path("sum.toml"))
          .status,
      0);
  EXPECT_NEAR(error(chain + "true_spindle.toml"), 7.0, 0.5);
  EXPECT_GT(error(path("machine.toml")), 20.0);
  EXPECT_LT(error(path("sum.toml")), 0.1);
}

/// From volts to the correction of the machine; every command takes the files of the one before.
TEST_F(Chain, TheTableOfTheRigHeatsTheSpindle) {
  for (const char* const name : {"rig.toml", "spindle.toml"})
    scratch_.write(name, file_text(chain + name));
  const auto must = [](const std::string& command) {
    const Result r = run(command);
    EXPECT_EQ(r.status, 0) << command << "\n" << r.err;
    return r;
  };
  const auto table = [&](const std::string& loads) {
    must("table " + path("fitted.toml") + " --speed 0:10000:500 --axial-load " + loads +
         " --temperature 20:100:10 --band --force -o " + path("stribeck.csv"));
    return must("spindle " + path("spindle.toml") + " --speed 10000 --coolant off --steady --json");
  };
  must("calibrate-sensor " + chain + "weights.csv -o " + path("sensor.toml"));
  must("calibrate " + path("rig.toml") + " " + chain + "signals.csv -o " + path("fitted.toml"));
  // The rear bearing carries 1180 N at 10 000 rpm.
  EXPECT_THAT(table("100:900:100").err, HasSubstr("outside the friction table stribeck.csv"));
  const Result steady = table("100:1500:100");
  EXPECT_THAT(steady.err, Not(HasSubstr("outside the friction table")));
  EXPECT_THAT(steady.out, HasSubstr("friction_power_band_W"));
  must("step-response " + path("spindle.toml") +
       " --speed 1000:10000:1000 --coolant off --law line --lags one --correction " +
       path("spindle_part.toml"));
  must("join " + path("spindle_part.toml") + " " + path("machine.toml") + " -o " +
       path("sum.toml"));
  must("calibrate " + path("sum.toml") + " " + chain + "verification.csv --until 20h -o " +
       path("correction.toml"));
  EXPECT_LT(error(path("sum.toml")), 1.8);
  EXPECT_LT(error(path("correction.toml")), 1.3);
}

TEST_F(Chain, CheckSaysBetweenWhichRowsSettingsHold) {
  const auto said = [&](const std::string& name, const std::string& columns) {
    const std::string text = file_text(chain + "machine.toml") + columns;
    return run("check " + scratch_.write(name, text) + " " + chain + "calibration.csv").out;
  };
  const std::string until =
      "apply from this row to the next row; the reading of the row was taken ";
  EXPECT_THAT(said("a.toml", ""),
              HasSubstr(until + "with the settings of this row (settings_hold is not given)"));
  EXPECT_THAT(
      said("b.toml", "[columns]\nsettings_hold = \"from row\"\n"),
      HasSubstr(until + "just before the change of the settings (settings_hold = \"from row\")"));
  EXPECT_THAT(
      said("c.toml", "[columns]\nsettings_hold = \"until row\"\n"),
      HasSubstr(
          "apply from the previous row to this row; the reading of the row was taken with the "
          "settings of this row (settings_hold = \"until row\")"));
}

TEST(PriorTable, WhatIsWrongIsSaid) {
  const ScratchFolder scratch;
  const auto said = [&](const std::string& line) {
    return run("check " + scratch.write("z.toml", computed_spindle + "[correction.prior]\n" + line))
        .err;
  };
  scratch.write("friction_table.csv", file_text(chain + "friction_table.csv"));
  EXPECT_THAT(said("\"spindle.scal\" = { value = 1.0, std = 0.2 }\n"),
              HasSubstr("spindle.scal: unknown parameter; nearest: spindle.scale"));
  EXPECT_THAT(said("\"spindle.scale\" = { value = 1.0, std = 0.0 }\n"), HasSubstr("std = 0"));
  EXPECT_THAT(said("\"spindle.scale\" = 0.2\n"), HasSubstr("must be { value = ..., std = ... }"));
  EXPECT_THAT(said("\"spindle.scale\" = { value = 1.0 }\n"), HasSubstr("std"));
}

}  // namespace
}  // namespace raceway::tests

// --tolerance, and [loop] of the model.
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string root = tests::source_dir();
const std::string wheel = root + "/data/measurements/flywheel.toml";
const std::string spin_down = root + "/data/measurements/flywheel_unloaded.csv";
/// A rig whose model lacks a drag of 62.5 N mm at 10 000 rpm.
const std::string rig_folder = root + "/tests/hidden_effect/rigs/dev-03/";
const std::string train = rig_folder + "train.csv";

std::string with_loop(const ScratchFolder& scratch, const std::string& lines) {
  return scratch.write("loop.toml", file_text(rig_folder + "model.toml") + "\n[loop]\n" + lines);
}

TEST(Tolerance, DecidesOfAWheelMeasuredFinerThanAnyModel) {
  const std::string diagnose = "diagnose " + wheel + " " + spin_down;
  EXPECT_EQ(parsed(run(diagnose + " --json"))["verdict"], "not-in-catalogue");
  const Result r = run(diagnose + " --tolerance 2Nmm --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const json d = parsed(r);
  EXPECT_EQ(d["verdict"], "several-effects") << d["sentence"];
  for (const json& effect : d["effects"]) {
    if (!effect["in_verdict"]) continue;
    EXPECT_LE(effect["rmse_held_out_Nmm"].get<double>(), 2.0);
  }
  // With a little more allowed a single effect does, but which cannot be told.
  EXPECT_EQ(parsed(run(diagnose + " --tolerance 2.5Nmm --json"))["verdict"], "ambiguous");
  EXPECT_EQ(parsed(run(diagnose + " --tolerance 6Nmm --json"))["verdict"], "nothing-missing");
}

TEST(Tolerance, AboveTheErrorLeavesNothingThatMatters) {
  const std::string diagnose =
      "diagnose " + rig_folder + "model.toml " + train + " --tolerance 100Nmm";
  EXPECT_EQ(parsed(run(diagnose + " --json"))["verdict"], "nothing-missing");
  EXPECT_THAT(run(diagnose).out, testing::ContainsRegex("\\| noise [0-9.]+, : tolerance 100"));
  const Result text = run(diagnose + " --verbose");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("| noise, : tolerance\n"));
  EXPECT_THAT(text.out, HasSubstr("\ntolerance "));
  EXPECT_THAT(text.out,
              testing::ContainsRegex("\neffects that are significant, but within the tolerance: "
                                     ".*lubricant-drag"));
}

TEST(Tolerance, WithoutOneNothingIsSaidOfIt) {
  const Result r = run("diagnose " + rig_folder + "model.toml " + train);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, Not(HasSubstr("tolerance")));
}

TEST(Tolerance, OfTheFlagIsThatOfTheModel) {
  const ScratchFolder scratch;
  const std::string model = with_loop(scratch, "tolerance_Nmm = 20\n");
  const std::string plain = rig_folder + "model.toml";
  for (const std::string command : {"compare ", "diagnose "}) {
    const Result by_model = run(command + model + " " + train + " 2>/dev/null");
    const std::string by_flag = run(command + plain + " " + train + " --tolerance 20Nmm").out;
    EXPECT_THAT(by_flag, HasSubstr("tolerance"));
    EXPECT_EQ(by_flag.substr(by_flag.find('\n')), by_model.out.substr(by_model.out.find('\n')));
    EXPECT_EQ(run(command + plain + " " + train + " --tolerance '20 N mm'").out, by_flag);
  }
  const std::string add = " lubricant-drag --data " + train;
  EXPECT_EQ(run("add " + plain + add + " --tolerance 20Nmm").out, run("add " + model + add).out);
}

TEST(Tolerance, IsSaidByCompare) {
  const std::string compare = "compare " + rig_folder + "model.toml " + train + " --tolerance ";
  EXPECT_THAT(run(compare + "2Nmm").out,
              HasSubstr("The RMS misfit exceeds the tolerance of 2 N mm."));
  EXPECT_THAT(run(compare + "500Nmm").out,
              HasSubstr("The RMS misfit is within the tolerance of 500 N mm."));
}

TEST(Tolerance, ThatCannotBeIsToldInOneMessage) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("my.toml", file_text(rig_folder + "model.toml"));
  const auto refused = [&](const std::string& tolerance, const std::string& message) {
    for (const std::string& command :
         {"diagnose " + model + " " + train, "compare " + model + " " + train,
          "add " + model + " lubricant-drag --data " + train}) {
      const Result r = run(command + " --tolerance=" + tolerance);
      expect_refused(r, "--tolerance: " + message + "\n");
      EXPECT_EQ(r.err.find("--tolerance"), r.err.rfind("--tolerance")) << "once";
    }
  };
  const std::string allowed = "; allowed: Nmm (friction torque)";
  refused("2um", "\"2um\": " + model + " predicts no quantity in um" + allowed);
  refused("2Nmm,0.5K", "\"0.5K\": " + model + " predicts no quantity in K" + allowed);
  const std::string form = ": write a number and its unit, such as 2Nmm or 2um,0.5K";
  refused("2", "\"2\"" + form);
  refused("Nmm", "\"Nmm\"" + form);
  refused("2,5Nmm", "\"2\"" + form);
  refused("0Nmm", "\"0Nmm\": must be a number above 0");
  refused("-1Nmm", "\"-1Nmm\": must be a number above 0");
  refused("nanNmm", "\"nanNmm\": must be a number above 0");
  refused("1Nmm,2Nmm", "\"2Nmm\": two tolerances in Nmm are given; keep one");
}

TEST(Tolerance, GivenTwiceIsRefused) {
  const ScratchFolder scratch;
  const std::string model = with_loop(scratch, "tolerance_Nmm = 2\n");
  expect_refused(run("diagnose " + model + " " + train + " --tolerance 3Nmm"),
                 "--tolerance: \"3Nmm\": tolerance_Nmm is already given under [loop] of " + model);
}

}  // namespace
}  // namespace raceway::tests

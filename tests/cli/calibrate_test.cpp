#include <fmt/format.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

const std::string measurement_folder = tests::source_dir() + "/data/measurements/";

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

TEST(Calibrate, OfACoastDownBringsTheErrorDownAndSaysThatStructureIsLeft) {
  const ScratchFolder scratch;
  const std::string model = measurement_folder + "flywheel.toml",
                    data = measurement_folder + "flywheel_unloaded.csv";
  const std::string fitted = scratch.file("fitted.toml");
  const Result r = run("calibrate " + model + " " + data + " -o " + fitted);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("correlation of f0 and z"));
  EXPECT_THAT(r.out, Not(HasSubstr("Nmm")));

  const json before = parsed(run("compare " + model + " " + data + " --json"));
  const json after = parsed(run("compare " + fitted + " " + data + " --json"));
  EXPECT_LT(after["rmse"].get<double>(), 0.2 * before["rmse"].get<double>());
  EXPECT_LT(after["lack_of_fit"]["p_value"].get<double>(), 0.01);
  EXPECT_THAT(after["statement"].get<std::string>(), HasSubstr("is systematic, not noise"));

  const Result text = run("compare " + fitted + " " + data);
  EXPECT_THAT(text.out, HasSubstr("mean error (bias)      -0.01 N mm"));
  EXPECT_THAT(text.out, HasSubstr("p < 1e-300"));
  EXPECT_THAT(text.out, Not(HasSubstr("e-0")));
}

TEST(Calibrate, ChangesTheValuesAndAddsTheirCovarianceAndNothingElse) {
  const ScratchFolder scratch;
  const std::string fitted = scratch.file("fitted.toml");
  ASSERT_EQ(run("calibrate " + measurement_folder + "flywheel.toml " + measurement_folder +
                "flywheel_unloaded.csv -o " + fitted)
                .status,
            0);
  const auto old_lines = lines(file_text(measurement_folder + "flywheel.toml"));
  const auto new_lines = lines(file_text(fitted));
  ASSERT_GT(new_lines.size(), old_lines.size() + 1);
  EXPECT_EQ(new_lines[old_lines.size()], "");
  EXPECT_THAT(new_lines[old_lines.size() + 1], HasSubstr("[calibration.covariance]"));
  std::vector<std::string> changed;
  for (std::size_t i = 0; i < old_lines.size(); ++i)
    if (old_lines[i] != new_lines[i]) changed.push_back(old_lines[i]);
  EXPECT_THAT(changed, testing::ElementsAre("f0 = 2", "z = 0.001"));
}

TEST(Calibrate, KeepsCommentsBlanksAndLineEndsOfTheModel) {
  const ScratchFolder scratch;
  const std::string model = replaced(
      model_text, "f0 = 1.5\n", "  f0   =   1.5   # ölarm: \"f0 = 9\"\r\n# f0 = 7 was before\n");
  const std::string fitted = scratch.file("fitted.toml");
  const Result r = run("calibrate " + scratch.write("my.toml", model) + " " +
                       scratch.write("rig.csv", data_text) + " -o " + fitted);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(file_text(fitted), HasSubstr("  # ölarm: \"f0 = 9\"\r\n# f0 = 7 was before\nz = 0."));
  EXPECT_THAT(file_text(fitted), HasSubstr("\n  f0   =   "));
}

TEST(Calibrate, AddsTheKeysOfACatalogueModel) {
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "my.toml",
      "[bearing]\ncatalogue = \"S 6014 C\" # mine\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
      "viscosity_100C_mm2_s = 4.8\n");
  const std::string data = scratch.write("rig.csv", data_text), fitted = scratch.file("new.toml");
  ASSERT_EQ(run("calibrate " + model + " " + data + " -o " + fitted).status, 0);
  EXPECT_THAT(file_text(fitted), HasSubstr("\"S 6014 C\" # mine\n"));
  EXPECT_THAT(file_text(fitted), HasSubstr("\n[friction]\nf0 = "));
  EXPECT_EQ(run("compare " + fitted + " " + data).status, 0);
}

TEST(Calibrate, JsonHasValueErrorAndUnitOfEachParameter) {
  const ScratchFolder scratch;
  const Result r = run("calibrate " + scratch.write("my.toml", model_text) + " " +
                       scratch.write("rig.csv", data_text) + " --json");
  EXPECT_EQ(r.status, 0);
  const json d = parsed(r);
  EXPECT_EQ(keys(d["parameters"]), (std::set<std::string>{"f0", "z"}));
  EXPECT_THAT(keys(d["parameters"]["f0"]), IsSupersetOf({"value", "std", "unit"}));
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_EQ(d["rows"], 8);
}

TEST(Calibrate, ProfilesAreOpenAtABoundInTextAndJson) {
  const std::string files =
      measurement_folder + "spindle_dyno.toml " + measurement_folder + "spindle_dyno.csv";
  const Result text = run("calibrate " + files + " --profile");
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("95 % from"));
  EXPECT_THAT(text.out, HasSubstr("0.010000 (bound)"));
  const json document = parsed(run("calibrate " + files + " --profile --json"));
  const json& f0 = document["parameters"]["f0"];
  EXPECT_EQ(f0["at_bound"], true);
  EXPECT_EQ(f0["profile"]["open_from"], true);
  EXPECT_EQ(f0["profile"]["from"], f0["lower"]);
  EXPECT_EQ(f0["profile"]["open_to"], false);
  EXPECT_GT(f0["profile"]["to"].get<double>(), f0["value"].get<double>());
  EXPECT_LE(document["profile"]["refits"].get<int>(), 40);
  EXPECT_FALSE(parsed(run("calibrate " + files + " --json")).contains("profile"));
}

TEST(Calibrate, ProfilesNeedReadingsAndALikelihood) {
  const Result none = run("calibrate \"S 6014 C\" --profile");
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("--profile needs measurements"));
  const std::string folder = tests::source_dir() + "/data/corrections/ambient/";
  const Result over_time =
      run("calibrate " + folder + "correction.toml " + folder + "train.csv --profile");
  EXPECT_EQ(over_time.status, 1);
  EXPECT_THAT(over_time.err, HasSubstr("profile likelihood intervals need"));
}

TEST(Calibrate, FitsAnEffectOfTheModel) {
  const ScratchFolder scratch;
  const std::string free = "\n[calibration]\nfree = [\"f0\", \"friction_coefficient\"]\n";
  const std::string fitted = scratch.file("fitted.toml");
  const Result r = run("calibrate " + scratch.write("my.toml", model_text + free + spin_effect) +
                       " " + scratch.write("rig.csv", data_text) + " -o " + fitted);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("spin-friction.friction_coefficient"));
  EXPECT_THAT(file_text(fitted), HasSubstr("id = \"spin-friction\"\nfriction_coefficient = "));
}

TEST(Calibrate, WritesNothingWhereItCannotFit) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("my.toml", model_text), out = scratch.file("out.toml");
  const auto refused = [&](const std::string& data, const std::string& message) {
    expect_refused(run("calibrate " + model + " " + scratch.write("rig.csv", data) + " -o " + out),
                   message);
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  refused("speed_rpm,axial_load_N,friction_torque_Nmm\n1000,100,92\n",
          "number of free parameters: 2");
  refused("speed_rpm,axial_load_N,axial_displacement_um\n1,100,1\n2,100,2\n3,100,3\n",
          "has axial displacement, which needs a model with an [arrangement]");
}

TEST(Calibrate, ThePreloadOfSetsFollowsFromTheirTorque) {
  const ScratchFolder scratch;
  const auto model = [](const std::string& preload) {
    return model_text +
           "\n[arrangement]\nlayout = \"O\"\nfront = 1\nrear = 1\npreload_N = " + preload + "\n";
  };
  const json truth = parsed(run("table " + scratch.write("truth.toml", model("900")) +
                                " --speed 1000:16000:3000 --axial-load 0,400,1500 --json"));
  std::string rows = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (const json& row : truth["rows"])
    rows += fmt::format("{},{},{},{}\n", row["speed_rpm"].get<double>(),
                        row["axial_load_N"].get<double>(), row["temperature_C"].get<double>(),
                        row["friction_torque_Nmm"].get<double>());
  const std::string files =
      scratch.write("my.toml", model("600") + "[calibration]\nfree = [\"preload_N\"]\n") + " " +
      scratch.write("torque.csv", rows);
  const json found = parsed(run("calibrate " + files + " --json"));
  EXPECT_NEAR(found["parameters"]["preload_N"]["value"].get<double>(), 900.0, 1.0);
  EXPECT_EQ(run("check " + files).status, 0);
  EXPECT_LT(parsed(run("compare " + files + " --json"))["bias"].get<double>(), 0.0);
}

TEST(Calibrate, NeverOverwritesWithoutForce) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("my.toml", model_text);
  const std::string data = scratch.write("rig.csv", data_text);
  const std::string command = "calibrate " + model + " " + data + " -o ";
  expect_refused(run(command + model), model + ": exists already; --force replaces it");
  expect_refused(run(command + "-"), "name a file");
  EXPECT_EQ(file_text(model), model_text);
  EXPECT_EQ(run(command + model + " --force").status, 0);
  EXPECT_NE(file_text(model), model_text);
}

TEST(Flow, FromANewModelToTheComparisonOfTheFittedOne) {
  const ScratchFolder scratch;
  const std::string my = scratch.file("my.toml"), fitted = scratch.file("fitted.toml");
  const std::string data = scratch.write("rig.csv", data_text);
  EXPECT_EQ(run("new \"S 6014 C\" -o " + my).status, 0);
  EXPECT_EQ(run("table " + my + " --speed 0:12000:1000 --axial-load 100,300,900").status, 0);
  EXPECT_EQ(run("check " + my + " " + data).status, 0);
  EXPECT_EQ(run("calibrate " + my + " " + data + " -o " + fitted).status, 0);
  const Result ladder = run("compare " + my + " " + fitted + " " + data);
  EXPECT_EQ(ladder.status, 0);
  EXPECT_THAT(ladder.out, HasSubstr("\n" + fitted + "  "));
}

}  // namespace
}  // namespace raceway::tests

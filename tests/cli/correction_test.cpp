#include <gmock/gmock.h>

#include <string>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string data = std::string(RACEWAY_SOURCE_DIR) + "/data/corrections/";

/// Records of machines whose hidden effect is known, made by a program of its own.
class Correction : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  ScratchFolder scratch_;
};

json section(const json& found, std::size_t channel, std::size_t k) {
  return found["channels"][channel]["sections"][k];
}

/// Truth: 5 um/K at 5400 s, 3 at 900 s; -2.5 at 14 000 s; noise 0.3 um, uneven clock.
TEST_F(Correction, IdentifyFindsKnownLagsOnAnUnevenClock) {
  const json d = parsed(run("identify " + data + "exact/correction.toml " + data +
                            "exact/train.csv --json -o " + path("found.toml")));
  ASSERT_EQ(d["channels"].size(), 2U);
  ASSERT_EQ(d["channels"][0]["sections"].size(), 2U);
  const double gains[] = {5.0, 3.0}, lags[] = {5400, 900};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(section(d, 0, k)["gain"]["value"].get<double>() / gains[k], 1.0, 4e-3);
    EXPECT_NEAR(section(d, 0, k)["time_constant_s"]["value"].get<double>() / lags[k], 1.0, 6e-3);
  }
  EXPECT_NEAR(section(d, 1, 0)["gain"]["value"].get<double>() / -2.5, 1.0, 4e-3);
  EXPECT_NEAR(section(d, 1, 0)["time_constant_s"]["value"].get<double>() / 14000, 1.0, 6e-3);
  const json c =
      parsed(run("correct " + path("found.toml") + " " + data + "exact/test.csv --json"));
  EXPECT_NEAR(c["metrics"]["rmse_um"].get<double>(), 0.3, 0.02);
}

TEST_F(Correction, DiagnoseNamesWhatIsMissing) {
  const json one = parsed(
      run("diagnose " + data + "ambient/correction.toml " + data + "ambient/train.csv --json"));
  EXPECT_EQ(one["verdict"], "effect");
  EXPECT_EQ(one["explanations"], (json{{"ambient-drift"}}));
  const json two =
      parsed(run("diagnose " + data + "power/correction.toml " + data + "power/train.csv --json"));
  EXPECT_EQ(two["verdict"], "several-effects");
  EXPECT_EQ(two["explanations"][0], (json{"ambient-drift", "motor-heat"}));
}

/// On the profile that no fit saw: 14.2 um without, 1.1 with what the machine has.
TEST_F(Correction, AddMakesTheErrorFallOnAnotherProfile) {
  const std::string model = data + "ambient/correction.toml", train = data + "ambient/train.csv";
  ASSERT_EQ(run("calibrate " + model + " " + train + " -o " + path("base.toml")).status, 0);
  ASSERT_EQ(
      run("add " + model + " ambient-drift --data " + train + " -o " + path("better.toml")).status,
      0);
  const json c = parsed(run("compare " + path("base.toml") + " " + path("better.toml") + " " +
                            data + "ambient/test.csv --json"));
  EXPECT_GT(c["models"][0]["rmse"], 12.0);
  EXPECT_LT(c["models"][1]["rmse"], 1.5);
  const json again = parsed(run("diagnose " + path("better.toml") + " " + train + " --json"));
  EXPECT_EQ(again["verdict"], "nothing-missing");
  // What does not matter is not added.
  const Result more = run("add " + path("better.toml") + " slow-drift --data " + train);
  EXPECT_EQ(more.status, 1);
  EXPECT_THAT(more.err, HasSubstr("within the tolerance"));
}

TEST_F(Correction, CorrectSaysWhereTheModelHasNeverBeen) {
  const std::string found = path("found.toml");
  ASSERT_EQ(run("identify " + data + "exact/correction.toml " + data + "exact/test.csv -o " + found)
                .status,
            0);
  EXPECT_THAT(file_text(found), HasSubstr("[correction.range]"));
  const Result r = run("correct " + found + " " + data + "exact/train.csv -o " + path("c.csv"));
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("rows lie beyond"));
  EXPECT_THAT(file_text(path("c.csv")), testing::StartsWith("time_s,predicted_um,"));
}

TEST_F(Correction, ReadingsThatAreMissingArePredicted) {
  const std::string model = scratch_.write(
      "z.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = \"a\"\n"
      "input = \"a_temperature_C\"\nsections = [{ gain_um_K = 2.0, time_constant_s = 100 }]\n");
  std::string csv = "time_s,a_temperature_C,displacement_z_um\n0,20,0\n";
  for (int k = 1; k < 30; ++k) csv += std::to_string(100 * k) + ",21,\n";
  const Result r = run("correct " + model + " " + scratch_.write("r.csv", csv) + " -o -");
  EXPECT_EQ(r.status, 0);
  // 1 K in a straight line over the first 100 s: 2 (1 - (1 - e^-1)) there, e^-1 of the rest later.
  EXPECT_THAT(r.out, HasSubstr("\n100,0.735758882,0.735758882,\n"));
}

TEST_F(Correction, WrongInputIsRefusedWithItsPlace) {
  const std::string model = data + "ambient/correction.toml";
  expect_refused(
      run("correct " + model + " " + scratch_.write("r.csv", "time_s,displacement_z_um\n0,1\n")),
      "front_bearing_temperature_C is missing");
  expect_refused(run("identify " + model + " " + data + "ambient/train.csv --order 3:1"),
                 "--order");
  expect_refused(
      run("identify " + model + " " + data + "ambient/train.csv --inputs motr_temperature_C"),
      "motor_temperature_C");
  expect_refused(run("diagnose " + model + " " + data + "ambient/train.csv --tolerance 2um"),
                 "two of them");
  expect_refused(run("add " + model + " nonsense --data " + data + "ambient/train.csv"),
                 "unknown effect");
  expect_refused(
      run("compare " + model + " " + data + "ambient/train.csv --displacement displacement_y_um"),
      "models displacement_z_um");
}

/// A record that only warms up once holds out nothing.
TEST_F(Correction, AHeatUpAloneCannotValidate) {
  std::string csv = "time_s,a_temperature_C,displacement_z_um\n";
  for (int k = 0; k < 600; ++k)
    csv += std::to_string(60 * k) + "," + std::to_string(20 + 10 * (1 - std::exp(-k / 60.0))) +
           "," + std::to_string(30 * (1 - std::exp(-k / 100.0))) + "\n";
  const std::string model =
      scratch_.write("z.toml",
                     "[correction]\ndisplacement = \"displacement_z_um\"\ntolerance_um = 1\n"
                     "[[correction.channel]]\nname = \"a\"\ninput = \"a_temperature_C\"\n"
                     "sections = [{ gain_um_K = 2.0, time_constant_s = 1000 }]\n");
  expect_refused(run("diagnose " + model + " " + scratch_.write("r.csv", csv)),
                 "cannot validate a model");
}

TEST_F(Correction, CheckTellsWhatARecordIsWorth) {
  const json d =
      parsed(run("check " + data + "power/correction.toml " + data + "power/train.csv --json"));
  EXPECT_EQ(d["sampling_s"], 30.0);
  EXPECT_EQ(d["readings"], 2880);
  EXPECT_EQ(d["time_constants_visible_s"], (json{90.0, 43185.0}));
  EXPECT_NEAR(d["quanta"]["front_bearing_temperature_C"].get<double>(), 0.1, 1e-9);
}

}  // namespace
}  // namespace raceway::tests

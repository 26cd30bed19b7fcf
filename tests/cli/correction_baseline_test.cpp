// Baselines: what others have to beat, and what is not used.
#include <algorithm>
#include <string>

#include "tests/cli/correction_record.h"
#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

class CorrectionBaseline : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const std::string model_ = scratch_.write("z.toml", z_model());
  const std::string record_ = scratch_.write("r.csv", RecordOfADay{}.csv());
};

TEST_F(CorrectionBaseline, ARegressionIsComparedBesideTheOthers) {
  const std::string regression = scratch_.file("regression.toml"), lags = scratch_.file("l.toml");
  const json found = parsed(
      run("identify " + model_ + " " + record_ + " --baseline regression --json -o " + regression));
  EXPECT_EQ(found["channels"][0]["sections"], json::array());
  EXPECT_EQ(found["channels"][0]["feedthrough"]["unit"], "um/K");
  EXPECT_GT(found["channels"][0]["feedthrough"]["value"], 1.0);
  EXPECT_GT(found["channels"][0]["feedthrough"]["std"], 0.0);
  EXPECT_THAT(file_text(regression), HasSubstr("# Multiple linear regression on "));
  EXPECT_THAT(file_text(regression), HasSubstr("feedthrough_um_K = "));
  EXPECT_THAT(file_text(regression), HasSubstr("[correction.range]"));
  ASSERT_EQ(run("identify " + model_ + " " + record_ + " -o " + lags).status, 0);
  const json c = parsed(run("compare " + regression + " " + lags + " " + record_ + " --json"));
  // Without memory it cannot follow a lag of half an hour.
  EXPECT_GT(c["models"][0]["rmse"], 5.0);
  EXPECT_LT(c["models"][1]["rmse"], 0.01);
  EXPECT_NEAR(c["models"][0]["rmse"].get<double>(), found["metrics"]["rmse_um"].get<double>(),
              1e-4);
}

TEST_F(CorrectionBaseline, ARegressionSaysHowMuchItExtrapolates) {
  const std::string regression = scratch_.file("regression.toml");
  ASSERT_EQ(
      run("identify " + model_ + " " + record_ + " --baseline regression -o " + regression).status,
      0);
  // The temperature of one row is far below all others.
  const std::string colder =
      scratch_.write("colder.csv", RecordOfADay{.line = [](int k, std::string text) {
                                     return k == 700 ? "42000,8000,5,1\n" : text;
                                   }}.csv());
  const Result told = run("compare " + regression + " " + colder);
  EXPECT_EQ(told.status, 0);
  EXPECT_THAT(told.err, HasSubstr("training data of 20.000 to 42.496 C"));
  EXPECT_THAT(told.err, HasSubstr("outside the training data a regression extrapolates linearly."));
  EXPECT_THAT(told.err, HasSubstr("The largest extrapolated part of its prediction is "));
  EXPECT_THAT(run("correct " + regression + " " + colder).err,
              HasSubstr("outside the training data a regression extrapolates linearly."));
  // Sections do not run away as far, and are not told so.
  EXPECT_THAT(run("compare " + model_ + " " + colder).err,
              testing::Not(HasSubstr("a regression extrapolates linearly")));
}

TEST_F(CorrectionBaseline, ArxShowsWhyItIsNotUsed) {
  const std::string coarse = scratch_.write("coarse.csv", RecordOfADay{.moves = [](int k, double) {
                                                            return 0.8 * ((k * 7919) % 5 - 2);
                                                          }}.csv());
  const std::string command = "identify " + model_ + " " + coarse + " --baseline arx --order 1:2";
  const Result text = run(command);
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("ARX model (inputs: front), fitted to 1440 points every 60 s"));
  EXPECT_THAT(text.out,
              HasSubstr("one step: prediction of each point from the readings before it"));
  const json d = parsed(run(command + " --json"));
  EXPECT_EQ(d["baseline"], "arx");
  EXPECT_EQ(d["sampling_s"], 60.0);
  ASSERT_EQ(d["fits"].size(), 2U);
  for (const json& f : d["fits"]) {
    EXPECT_LT(f["one_step"]["rmse_um"], f["simulated"]["rmse_um"]);
    EXPECT_EQ(f["poles"].size(), f["order"]);
    EXPECT_TRUE(f.contains("stable"));
  }
  // As transfer functions: they run as the simulation does, and in a control.
  const std::string written = scratch_.file("arx.toml");
  const Result wrote = run(command + " -o " + written);
  ASSERT_EQ(wrote.status, 0) << wrote.err;
  EXPECT_THAT(wrote.err,
              HasSubstr("A control uses the simulation and must calculate one step every 60 s"));
  EXPECT_THAT(file_text(written), HasSubstr("sampling_s = 60"));
  EXPECT_THAT(file_text(written), HasSubstr("numerator = ["));
  const Result ran = run("correct " + written + " " + coarse + " --json");
  ASSERT_EQ(ran.status, 0) << ran.err;
  const auto best =
      *std::min_element(d["fits"].begin(), d["fits"].end(), [](const auto& a, const auto& b) {
        return a["simulated_second_half"]["rmse_um"] < b["simulated_second_half"]["rmse_um"];
      });
  EXPECT_NEAR(parsed(ran)["metrics"]["rmse_um"].get<double>(),
              best["simulated"]["rmse_um"].get<double>(), 0.02);
  EXPECT_EQ(run("export " + written + " --format python -o " + scratch_.file("arx.py")).status, 0);
}

TEST_F(CorrectionBaseline, WrongUseIsRefused) {
  const std::string power =
      scratch_.write("empty.toml", "[correction]\ndisplacement = \"displacement_z_um\"\n");
  expect_refused(run("identify " + power + " " + record_ + " --baseline regression"), "--inputs");
  EXPECT_EQ(run("identify " + power + " " + record_ + " --baseline regression --inputs all").status,
            0);
  EXPECT_NE(run("identify " + model_ + " " + record_ + " --baseline lasso").status, 0);
}

}  // namespace
}  // namespace raceway::tests

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class Compare : public testing::Test {
 protected:
  [[nodiscard]] Result with(const std::string& command, const std::string& data,
                            const std::string& flags = "") const {
    return run(command + " " + model_ + " " + scratch_.write("rig.csv", data) + " " + flags);
  }
  ScratchFolder scratch_;
  std::string model_ = scratch_.write("my.toml", model_text);
};

TEST_F(Compare, JsonHasTheKeysOfTheContract) {
  const json d = parsed(with("compare", data_text, "--json"));
  EXPECT_THAT(keys(d), IsSupersetOf({"quantity", "unit", "rows", "rmse", "mae", "max_abs", "bias",
                                     "fit_percent", "noise", "lack_of_fit", "where"}));
  EXPECT_EQ(d["quantity"], "friction_torque");
  EXPECT_EQ(d["unit"], "Nmm");
  EXPECT_EQ(d["rows"], 8);
  EXPECT_EQ(keys(d["noise"]), (std::set<std::string>{"rms", "source"}));
  EXPECT_EQ(keys(d["lack_of_fit"]), (std::set<std::string>{"p_value", "statistic"}));
  ASSERT_FALSE(d["where"].empty());
  EXPECT_THAT(keys(d["where"][0]),
              IsSupersetOf({"variable", "from", "to", "rows", "rmse", "bias"}));
  for (std::size_t i = 1; i < d["where"].size(); ++i)
    EXPECT_GE(d["where"][i - 1]["rmse"], d["where"][i]["rmse"]) << "worst first";
}

TEST_F(Compare, WithoutKnownNoiseGivesNull) {
  const json d = parsed(with("compare", data_text, "--json"));
  EXPECT_TRUE(d["noise"]["rms"].is_null());
  EXPECT_EQ(d["noise"]["source"], "none");
  EXPECT_TRUE(d["lack_of_fit"]["p_value"].is_null());
}

TEST_F(Compare, TextNamesLevelsOnceAndUnitsWithABlank) {
  const Result r = with("compare", data_text);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("speed 8000 rpm "));
  EXPECT_THAT(r.out, HasSubstr("axial load 900 N "));
  EXPECT_THAT(r.out, Not(HasSubstr(" Nmm")));
}

TEST_F(Compare, SeveralModelsMakeALadder) {
  const std::string second = scratch_.write("spin.toml", model_text + spin_effect);
  const std::string data = scratch_.write("rig.csv", data_text);
  const Result text = run("compare " + model_ + " " + second + " " + data);
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.out, HasSubstr("spin.toml"));
  const json d = parsed(run("compare " + model_ + " " + second + " " + data + " --json"));
  ASSERT_EQ(d["models"].size(), 2U);
  EXPECT_EQ(d["models"][1]["model"], second);
}

TEST_F(Compare, TellsWhereModelsDifferInTheirRig) {
  const std::string other = scratch_.write("other.toml", model_text + "[rig]\nradial_load_N = 9\n");
  const Result r =
      run("compare " + model_ + " " + other + " " + scratch_.write("d.csv", data_text));
  EXPECT_THAT(r.err, HasSubstr(other + ": its [rig] differs from [rig] of " + model_));
}

TEST_F(Compare, LeavesOutRowsWithoutBalanceAndSaysSo) {
  const std::string model = scratch_.write("spin.toml", model_text + inner_control + spin_effect);
  const std::string data = scratch_.write("d.csv", data_text + "20000,5,500\n");
  const Result r = run("compare " + model + " " + data + " --json");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("rows, which are left out"));
  EXPECT_THAT(parsed(r)["rows_not_predicted"], testing::Contains(10));
}

TEST_F(Compare, ReadsAGermanSpreadsheetWithANote) {
  const std::string german =
      "\xef\xbb\xbfspeed_rpm;axial_load_N;friction_torque_Nmm\r\n"
      "1000;100;92,5\r\n2000;100;140,25\r\n4000;100;221\r\n8000;100;347,0\r\n";
  const Result r = with("compare", german, "--json");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("read with semicolons, decimal commas, a byte order mark and CRLF"));
  const std::string english =
      "speed_rpm,axial_load_N,friction_torque_Nmm\n"
      "1000,100,92.5\n2000,100,140.25\n4000,100,221\n8000,100,347.0\n";
  json one = parsed(r), other = parsed(with("compare", english, "--json"));
  EXPECT_THAT(one["notes"].dump(), HasSubstr("read with semicolons"));
  for (json* document : {&one, &other}) {
    document->erase("notes");
    document->erase("said");
  }
  EXPECT_EQ(one, other);
}

TEST_F(Compare, OfADisplacementIsRefusedInOneLine) {
  const Result r = with("compare", "speed_rpm,axial_load_N,axial_displacement_um\n1,100,1\n");
  expect_refused(r, "rig.csv with " + model_ +
                        ": has axial displacement, which needs a model with an [arrangement]; a "
                        "single bearing needs measured friction torque\n");
}

TEST_F(Compare, CheckTellsWhatWasRead) {
  const Result r = with("check", data_text);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("8 rows of friction torque\n"));
  EXPECT_THAT(r.out, HasSubstr("free parameter f0: can be fitted\n"));
  const std::size_t testable = r.out.find("effects testable\n  ");
  ASSERT_NE(testable, r.out.npos);
  EXPECT_THAT(r.out.substr(testable, r.out.find("\neffects not testable: needs ") - testable),
              HasSubstr(" spin-friction,"));
  EXPECT_THAT(r.out, EndsWith("\nnext step: raceway diagnose " + model_ + " " +
                              scratch_.file("rig.csv") + "\n"));
  const json d = parsed(with("check", data_text, "--json"));
  EXPECT_THAT(keys(d), IsSupersetOf({"quantity", "unit", "rows", "runs", "noise", "columns",
                                     "free_parameters", "effects", "defaults", "notes", "said"}));
  EXPECT_EQ(d["columns"][0]["name"], "speed_rpm");
  EXPECT_EQ(d["columns"][0]["to"], 8000.0);
}

/// One load for each run: what the load does and what a new set-up does are one.
TEST_F(Compare, CheckWarnsWhereEveryRunHasALevelOfItsOwn) {
  const auto rows = [](int runs_of_a_load) {
    std::string text = "speed_rpm,axial_load_N,run_id,friction_torque_Nmm\n";
    for (int run = 0; run < 3 * runs_of_a_load; ++run)
      for (int speed = 1000; speed <= 4000; speed += 1000)
        text += std::to_string(speed) + "," + std::to_string(200 * (1 + run / runs_of_a_load)) +
                ",r" + std::to_string(run) + "," + std::to_string(80 + speed / 100 + run) + "\n";
    return text;
  };
  const auto warning = HasSubstr("each run has a different axial load");
  EXPECT_THAT(with("check", rows(1)).err, warning);
  EXPECT_THAT(parsed(with("check", rows(1), "--json"))["notes"].dump(), warning);
  EXPECT_THAT(with("check", rows(2)).err, testing::Not(warning));
}

TEST_F(Compare, CheckOfTooFewRowsSaysWhatCannotBeFitted) {
  const Result r = with("check", "speed_rpm,axial_load_N,friction_torque_Nmm\n1000,100,92\n");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("free parameter f0: these data do not determine it\n"));
  EXPECT_THAT(r.err, HasSubstr("number of free parameters: 2"));
}

TEST_F(Compare, CheckOfADisplacementHasItsUnit) {
  const std::string data =
      "speed_rpm,axial_load_N,axial_displacement_um,std_um\n1,100,1,0.5\n2,100,2,0.5\n";
  EXPECT_THAT(with("check", data).out, HasSubstr("noise: 0.500 um rms (declared)"));
  const json d = parsed(with("check", data, "--json"));
  EXPECT_EQ(d["unit"], "um");
  EXPECT_EQ(d["noise"]["rms"], 0.5);
}

}  // namespace
}  // namespace raceway::tests

// What several commands, or several outputs of one, say of the same data and model.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

const std::string root = tests::source_dir();
const std::string shaft = root + "/data/spindles/two_against_one.toml";
const std::string sweep = root + "/data/spindles/ring_growth_sweep.csv";

/// Model and data of a rig with a known hidden effect.
std::string sampled_rig(int number) {
  const std::string folder =
      root + "/tests/hidden_effect/rigs/dev-0" + std::to_string(number) + "/";
  return folder + "model.toml " + folder + "train.csv";
}

/// The first number of more than 15 significant digits, empty if there is none: 65.67000000000002.
std::string rounding_dust(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", i), text.size());
    const std::string number = text.substr(i, end - i);
    std::string digits = number;
    std::erase(digits, '.');
    digits.erase(0, digits.find_first_not_of('0'));
    if (digits.size() > 15) return number;
    i = end + 1;
  }
  return {};
}

/// Of a column of a page: one value, or one for each row.
double rms_of_column(const json& columns, const std::string& name) {
  for (const json& column : columns) {
    if (column["name"] != name) continue;
    if (column.contains("constant")) return column["constant"];
    double square = 0.0;
    for (const json& value : column["values"]) square += std::pow(value.get<double>(), 2);
    return std::sqrt(square / static_cast<double>(column["values"].size()));
  }
  ADD_FAILURE() << "no column " << name;
  return 0.0;
}

void expect_no_dust(const std::string& command) {
  const Result r = run(command + " --json");
  ASSERT_NE(r.out, "") << r.err;
  EXPECT_EQ(rounding_dust(r.out), "") << command;
}

TEST(Agreement, AnEffectAddedToAShaftReadsBack) {
  const ScratchFolder scratch;
  const std::string better = scratch.file("out.toml");
  // --force: what is asked here is what the file says, not whether the effect helps.
  const Result added = run("add " + shaft + " centrifugal-ring-growth --data " + sweep +
                           " --force --json -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_THAT(file_text(better), HasSubstr("id = \"centrifugal-ring-growth\""));
  const Result checked = run("check " + better + " " + sweep);
  EXPECT_EQ(checked.status, 0) << checked.err;
  const json after = parsed(run("compare " + better + " " + sweep + " --json"));
  EXPECT_NEAR(after["rmse"].get<double>(), parsed(added)["after"]["rmse"].get<double>(), 1e-9);
}

TEST(Agreement, JsonPageAndTextStateOneEstimatedNoise) {
  const ScratchFolder scratch;
  const std::string compare = "compare " + shaft + " " + sweep;
  const json noise = parsed(run(compare + " --json"))["noise"];
  EXPECT_TRUE(noise["rms"].is_null());
  ASSERT_TRUE(noise.contains("estimated_rms")) << noise;
  const double estimated = noise["estimated_rms"];
  const std::string text = run(compare).out;
  const std::string words =
      "noise of the data: not known (too few repeated rows, and std_um is not given in every row); "
      "estimated ";
  const std::size_t at = text.find(words);
  ASSERT_NE(at, text.npos) << text;
  const std::string shown = text.substr(at + words.size());
  EXPECT_NEAR(std::stod(shown), estimated, 0.005 * estimated);
  EXPECT_EQ(shown.substr(shown.find(' '), 4), " um\n");
  if (!has_reports()) GTEST_SKIP() << "built with -DRACEWAY_REPORT=OFF";
  const std::string page = scratch.file("page.html");
  ASSERT_EQ(run(compare + " --report " + page).status, 0);
  const json document = page_document(page);
  EXPECT_EQ(document["results"]["noise"], noise);
  EXPECT_NEAR(rms_of_column(document["rows"]["columns"], "std_um"), estimated, 0.01 * estimated);
}

TEST(Agreement, ALadderHasOneNoiseForAllModels) {
  const json models = parsed(run("compare " + shaft + " " + shaft + " " + sweep + " --json"));
  EXPECT_EQ(models["models"][0]["noise"], models["models"][1]["noise"]);
  EXPECT_TRUE(models["models"][0]["noise"].contains("estimated_rms"));
}

TEST(Agreement, DiagnoseAndAddGiveAnEffectOneSize) {
  const std::string dev_03 = root + "/tests/hidden_effect/rigs/dev-03/";
  const json found = parsed(run("diagnose " + sampled_rig(3) + " --json"))["effects"][0];
  const json added = parsed(run("add " + dev_03 + "model.toml lubricant-drag --data " + dev_03 +
                                "train.csv --json"))["calibration"]["parameters"];
  ASSERT_EQ(found["id"], "lubricant-drag");
  const json by_diagnose = found["parameters"]["torque_at_10000_rpm_Nmm"];
  const json by_add = added["lubricant-drag.torque_at_10000_rpm_Nmm"];
  for (const char* number : {"value", "std"}) {
    const double expected = by_diagnose[number];
    EXPECT_NEAR(by_add[number].get<double>(), expected, 1e-6 * expected) << number;
  }
}

TEST(Agreement, CalibrateGivesAnAddedEffectTheSizeThatAddGave) {
  // All of its parameters free, so that it is the same question.
  const std::map<int, std::string> hidden{{2, "spin-friction"},
                                          {3, "lubricant-drag"},
                                          {4, "inlet-shear-heating"},
                                          {5, "thermal-preload"}};
  const ScratchFolder scratch;
  for (const auto& [number, id] : hidden) {
    const std::string folder = root + "/tests/hidden_effect/rigs/dev-0" + std::to_string(number);
    const std::string better = scratch.file(id + ".toml");
    const json added = parsed(run("add " + folder + "/model.toml " + id + " --data " + folder +
                                  "/train.csv --json -o " + better))["calibration"]["parameters"];
    json names = json::array();
    for (const auto& [name, parameter] : added.items()) names.push_back(name);
    std::string text = file_text(better);
    const std::string fixed = "free = [\"f0\", \"z\"]";
    ASSERT_NE(text.find(fixed), text.npos);
    text.replace(text.find(fixed), fixed.size(), "free = " + names.dump());
    const json calibrated = parsed(run("calibrate " + scratch.write("free.toml", text) + " " +
                                       folder + "/train.csv --json"))["parameters"];
    ASSERT_EQ(calibrated.size(), added.size());
    for (const auto& [name, parameter] : added.items())
      for (const char* value : {"value", "std"}) {
        const double expected = parameter[value];
        EXPECT_NEAR(calibrated[name][value].get<double>(), expected, 1e-6 * std::abs(expected))
            << name << " " << value;
      }
  }
}

TEST(Agreement, NoNumberHasRoundingDust) {
  EXPECT_EQ(rounding_dust("{\"a\": 65.67000000000002}"), "65.67000000000002");
  EXPECT_EQ(rounding_dust("{\"a\": 0.000123456789012345, \"b\": 1e-300}"), "");
  for (int number = 1; number <= 8; ++number) {
    expect_no_dust("compare " + sampled_rig(number));
    expect_no_dust("calibrate " + sampled_rig(number));
    expect_no_dust("diagnose --no-pairs " + sampled_rig(number));
  }
  const std::string dev_03 = root + "/tests/hidden_effect/rigs/dev-03/";
  expect_no_dust("add " + dev_03 + "model.toml lubricant-drag --data " + dev_03 + "train.csv");
  for (const char* command : {"compare ", "calibrate ", "diagnose "})
    expect_no_dust(command + shaft + " " + sweep);
  expect_no_dust("add " + shaft + " centrifugal-ring-growth --data " + sweep);
}

}  // namespace
}  // namespace raceway::tests

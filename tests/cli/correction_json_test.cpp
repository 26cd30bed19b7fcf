// What programs read: the documents of commands on corrections, key by key.
#include <cmath>
#include <string>

#include "tests/cli/correction_record.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::Contains;
using testing::IsSupersetOf;

const std::string correction_folder = tests::source_dir() + "/data/corrections/";
const std::string exact =
    correction_folder + "exact/correction.toml " + correction_folder + "exact/train.csv";

const std::set<std::string> metric_keys{
    "rmse_um",        "mae_um",          "max_abs_um",  "residue_min_um",
    "residue_max_um", "peak_to_peak_um", "fit_percent", "reduction_of_max_percent"};

const json* effect(const json& document, const std::string& id, const std::string& field,
                   const std::string& value) {
  for (const json& e : document["effects"])
    if (e["id"] == id && (field.empty() || e.value(field, "") == value)) return &e;
  return nullptr;
}

TEST(CorrectionJson, IdentifyHasItsKeys) {
  const json d = parsed(run("identify " + exact + " --order 1 --validate " + correction_folder +
                            "exact/test.csv --json"));
  EXPECT_THAT(keys(d), IsSupersetOf({"channels", "order_tried", "condition", "at_bound", "metrics",
                                     "validation", "warnings", "noise", "correlation_time_s",
                                     "tolerance_um", "initial_state"}));
  const json& channel = d["channels"][0];
  EXPECT_THAT(keys(channel), IsSupersetOf({"name", "input", "sections", "feedthrough"}));
  EXPECT_EQ(channel["feedthrough"]["value"], 0.0);
  EXPECT_EQ(channel["feedthrough"]["unit"], "um/K");
  const json& section = channel["sections"][0];
  EXPECT_THAT(keys(section["gain"]), IsSupersetOf({"value", "std", "unit"}));
  EXPECT_THAT(keys(section["time_constant_s"]), IsSupersetOf({"value", "std"}));
  EXPECT_THAT(keys(d["order_tried"][0]), IsSupersetOf({"order", "rmse_held_out_um"}));
  EXPECT_EQ(d["noise"], (json{{"rms", 0.3}, {"source", "declared"}}));
  EXPECT_EQ(d["tolerance_um"], 1.0);
  EXPECT_EQ(d["initial_state"], "rest");
  EXPECT_THAT(keys(d["metrics"]), IsSupersetOf(metric_keys));
  EXPECT_THAT(keys(d["validation"]), IsSupersetOf(metric_keys));
  EXPECT_EQ(d["validation"]["data"], correction_folder + "exact/test.csv");
}

TEST(CorrectionJson, CompareKeepsItsKeysAndAddsTheMetrics) {
  const json d = parsed(run("compare " + exact + " --json"));
  EXPECT_THAT(keys(d), IsSupersetOf(metric_keys));
  EXPECT_THAT(keys(d), IsSupersetOf({"rmse", "mae", "max_abs", "bias", "fit_percent", "unit",
                                     "noise", "correlation_time_s", "tolerance_um",
                                     "within_tolerance", "initial_state"}));
  EXPECT_THAT(keys(d["noise"]), IsSupersetOf({"rms", "source"}));
  EXPECT_EQ(d["rmse"], d["rmse_um"]);
  EXPECT_EQ(d["max_abs"], d["max_abs_um"]);
  EXPECT_EQ(d["initial_state"], "rest");
  // |max| + |min| of the residue, which is measured minus simulated.
  EXPECT_NEAR(
      d["peak_to_peak_um"].get<double>(),
      std::abs(d["residue_max_um"].get<double>()) + std::abs(d["residue_min_um"].get<double>()),
      1e-9);
  // What is left of start values is slow: minutes to hours, of a day and a half.
  EXPECT_GT(d["correlation_time_s"], 600.0);
  EXPECT_LT(d["correlation_time_s"], 40000.0);
}

TEST(CorrectionJson, ATemperatureHasItsMetricsInKelvin) {
  const std::string spindle = tests::source_dir() + "/data/spindles/drive/";
  const json d = parsed(run("compare " + spindle + "model.toml " + spindle + "train.csv --json"));
  int temperatures = 0;
  for (const json& channel : d["channels"]) {
    if (channel["unit"] != "C") continue;
    ++temperatures;
    EXPECT_EQ(channel["max_abs_K"], channel["max_abs"]) << channel["quantity"];
    EXPECT_FALSE(channel.contains("max_abs_um"));
    EXPECT_FALSE(channel.contains("tolerance_um"));
  }
  EXPECT_GT(temperatures, 2);
}

TEST(CorrectionJson, IdsArePlainAndSayWhereTheyActInAFieldOfTheirOwn) {
  const json d = parsed(run("diagnose " + exact + " --json"));
  EXPECT_EQ(d["verdict"], "nothing-missing");
  EXPECT_EQ(d["within_tolerance"], true);
  EXPECT_TRUE(d["significant_but_immaterial"].is_array());
  EXPECT_EQ(d["tolerance_um"], 1.0);
  EXPECT_LT(d["rmse_held_out_um"], 1.0);
  for (const json& e : d["effects"]) {
    EXPECT_EQ(e["id"].get<std::string>().find(':'), std::string::npos) << e["id"];
    EXPECT_THAT(keys(e),
                IsSupersetOf({"rmse_held_out_um", "parameters", "indistinguishable_from"}));
  }
  for (const char* channel : {"spindle", "ambient"}) {
    EXPECT_NE(effect(d, "second-time-constant", "channel", channel), nullptr) << channel;
    EXPECT_NE(effect(d, "sensor-lag", "channel", channel), nullptr) << channel;
  }
  // What may be looked for in one of its forms is not told as missing.
  for (const json& n : d["not_testable"]) EXPECT_NE(n["id"], "second-time-constant");
}

TEST(CorrectionJson, AddTakesAnIdWithAndWithoutItsChannel) {
  const std::string tail = " --data " + correction_folder + "exact/train.csv --force --json";
  const std::string model = "add " + correction_folder + "exact/correction.toml ";
  const auto added = [&](const std::string& id) {
    return parsed(run(model + id + tail))["calibration"]["parameters"];
  };
  EXPECT_TRUE(added("second-time-constant").contains("second-time-constant.gain"));
  EXPECT_TRUE(added("second-time-constant:spindle").contains("second-time-constant.gain"));
  EXPECT_TRUE(added("second-time-constant:ambient").contains("second-time-constant:ambient.gain"));
}

TEST(CorrectionJson, AnAxisIsAskedForWhereThereAreSeveral) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model()),
                    record = scratch.write("r.csv", with_feeds());
  const std::string tail = " --data " + record + " --force --json";
  expect_refused(
      run("add " + model + " feed-axis-heat" + tail),
      "the effect feed-axis-heat is ambiguous: write feed-axis-heat:x or feed-axis-heat:y");
  const json d = parsed(run("diagnose " + model + " " + record + " --json"));
  EXPECT_NE(effect(d, "feed-axis-heat", "axis", "x"), nullptr);
  EXPECT_NE(effect(d, "feed-axis-heat", "axis", "y"), nullptr);
}

/// A swing every 100 min that no column tells of.
TEST(CorrectionJson, TheShapeOfTheUnknownIsWhenHowOftenAndHowLong) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("z.toml", z_model()),
                    record = scratch.write("r.csv", with_swing());
  const json d = parsed(run("diagnose " + model + " " + record + " --json"));
  EXPECT_EQ(d["verdict"], "not-in-catalogue");
  const json& shape = d["shape"];
  EXPECT_EQ(keys(shape), (std::set<std::string>{"when", "period_s", "time_constant_s"}));
  ASSERT_FALSE(shape["when"].empty());
  for (const json& stretch : shape["when"]) EXPECT_LT(stretch[0], stretch[1]);
  EXPECT_NEAR(shape["period_s"].get<double>(), 6000.0, 300.0);
  EXPECT_GT(shape["time_constant_s"], 300.0);
  EXPECT_LT(shape["time_constant_s"], 3000.0);
}

TEST(CorrectionJson, CorrectHasItsKeys) {
  const json d = parsed(run("correct " + exact + " --json"));
  EXPECT_THAT(keys(d), IsSupersetOf({"rows", "predicted_range_um", "metrics", "initial_state"}));
  EXPECT_LT(d["predicted_range_um"][0], d["predicted_range_um"][1]);
  EXPECT_THAT(keys(d["metrics"]), IsSupersetOf(metric_keys));
}

TEST(CorrectionJson, CheckOfAPolynomialHasItsKeys) {
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "z.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 1\n"
      "[[correction.channel]]\nname = \"published\"\ninput = \"front_temperature_C\"\n"
      "numerator = [16.0005, -15.9975]\ndenominator = [1, -0.99983]\n");
  std::string csv = "time_s,front_temperature_C,displacement_z_um\n";
  for (int k = 0; k < 400; ++k)
    csv += std::to_string(k) + "," + std::to_string(200 + (k % 50)) + "e-1," +
           std::to_string(0.1 * k) + "\n";
  const json d =
      parsed(run("check " + model + " " + scratch.write("r.csv", csv) + " --json --quiet"));
  EXPECT_THAT(keys(d),
              IsSupersetOf({"poles", "time_constants_s", "dc_gain", "dc_gain_5_95_percent",
                            "feedthrough", "step_per_quantum_um", "warnings", "polynomials"}));
  EXPECT_NEAR(d["poles"][0][0].get<double>(), 0.99983, 1e-9);
  EXPECT_NEAR(d["time_constants_s"][0].get<double>(), 5881.85, 0.1);
  EXPECT_NEAR(d["dc_gain"].get<double>(), 17.6470588, 1e-5);
  EXPECT_NEAR(d["feedthrough"].get<double>(), 16.0005, 1e-9);
  // The sensor shows tenths.
  EXPECT_NEAR(d["step_per_quantum_um"].get<double>(), 1.60005, 1e-4);
}

}  // namespace
}  // namespace raceway::tests

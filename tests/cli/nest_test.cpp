#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

const std::string nest_folder = tests::source_dir() + "/data/corrections/nest/";

/// Gains of the two bodies that made the record, at 2400 s and 9000 s [um/K], [urad/K].
struct NestTruth {
  std::string displacement, unit;
  double head, column;
  double noise;  ///< of probes of 0.1 um
};
const std::vector<NestTruth> nest_truth{{"displacement_x_um", "um", 0.8, -1.0, 0.1160},
                                        {"displacement_y_um", "um", 1.6, 2.0, 0.1160},
                                        {"displacement_z_um", "um", 2.5, -1.5, 0.1},
                                        {"displacement_a_urad", "urad", -3.0, 5.0, 0.7071},
                                        {"displacement_b_urad", "urad", 2.0, -2.5, 0.7071}};

class Nest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    found_ = parsed(run("identify " + nest_folder + "correction.toml " + nest_folder +
                        "train.csv --json -o " + model()));
  }
  static void TearDownTestSuite() { scratch().reset(); }
  static std::unique_ptr<ScratchFolder>& scratch() {
    static auto folder = std::make_unique<ScratchFolder>();
    return folder;
  }
  static std::string model() { return scratch()->file("nest.toml"); }
  static json found_;
};
json Nest::found_;

TEST_F(Nest, FiveDegreesOfFreedomAreFound) {
  ASSERT_EQ(found_["axes"].size(), 5U);
  for (std::size_t k = 0; k < nest_truth.size(); ++k) {
    const NestTruth& t = nest_truth[k];
    const json& axis = found_["axes"][k];
    EXPECT_EQ(axis["displacement"], t.displacement);
    ASSERT_EQ(axis["channels"][0]["sections"].size(), 1U) << t.displacement;
    ASSERT_EQ(axis["channels"][1]["sections"].size(), 1U) << t.displacement;
    const json head = axis["channels"][0]["sections"][0],
               column = axis["channels"][1]["sections"][0];
    EXPECT_EQ(head["gain"]["unit"], t.unit + "/K");
    for (const auto& [part, gain, lag] :
         {std::tuple{head, t.head, 2400.0}, std::tuple{column, t.column, 9000.0}}) {
      // Within four standard errors, of which none is above 5 %.
      EXPECT_NEAR(part["gain"]["value"].get<double>(), gain,
                  4.0 * part["gain"]["std"].get<double>())
          << t.displacement;
      EXPECT_LT(part["gain"]["std"].get<double>(), 0.05 * std::abs(gain)) << t.displacement;
      EXPECT_NEAR(part["time_constant_s"]["value"].get<double>(), lag,
                  4.0 * part["time_constant_s"]["std"].get<double>())
          << t.displacement;
    }
    EXPECT_NEAR(axis["metrics"]["rmse_" + t.unit].get<double>() / t.noise, 1.0, 0.1);
    EXPECT_TRUE(axis.contains("rmse_held_out_" + t.unit));
    EXPECT_EQ(axis["offset_" + t.unit]["unit"], t.unit);
  }
}

TEST_F(Nest, AnotherProfileIsCorrectedToTheNoise) {
  const std::string csv = scratch()->file("corrected.csv");
  const json c =
      parsed(run("correct " + model() + " " + nest_folder + "test.csv --json -o " + csv));
  for (std::size_t k = 0; k < nest_truth.size(); ++k) {
    const json& axis = c["axes"][k];
    const std::string unit = nest_truth[k].unit;
    EXPECT_NEAR(axis["metrics"]["rmse_" + unit].get<double>() / nest_truth[k].noise, 1.0, 0.15)
        << axis["displacement"];
    EXPECT_TRUE(axis["band"].contains("half_width_" + unit)) << axis.dump(1);
  }
  EXPECT_EQ(c["axes"][4].dump().find("_um\""), std::string::npos) << "an angle has no um";
  EXPECT_EQ(c["axes"][0].dump().find("_urad\""), std::string::npos);
  EXPECT_THAT(file_text(csv), HasSubstr("predicted_displacement_b_urad"));
}

TEST_F(Nest, NumbersOfAnAngleStandWithTheirUnit) {
  const std::string text = run("correct " + model() + " " + nest_folder + "test.csv").out;
  EXPECT_THAT(text, HasSubstr("95 % band of displacement_b_urad: smallest half width "));
  EXPECT_THAT(text, HasSubstr(" urad, largest "));
  // One table has lengths and angles, so each number has its unit.
  const std::string table = text.substr(0, text.find("RMS and largest"));
  EXPECT_THAT(table, testing::ContainsRegex("displacement_z_um .* um .* um "));
  EXPECT_THAT(table, testing::ContainsRegex("displacement_b_urad .* urad .* urad "));
  for (const char* const command : {"compare ", "diagnose ", "calibrate "}) {
    const Result said =
        run(command + model() + " " + nest_folder + "test.csv --displacement displacement_b_urad");
    EXPECT_EQ(said.status, 0) << command << said.err;
    EXPECT_THAT(said.out, HasSubstr("urad")) << command;
    EXPECT_THAT(said.out, testing::Not(HasSubstr(" um "))) << command;
  }
}

TEST_F(Nest, ItsProgramsPassTheirCheck) {
  const std::string program = scratch()->file("nest.py");
  const Result written = run("export " + model() + " --format python -o " + program);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(file_text(program), HasSubstr("\"output\": \"offset_b_urad\""));
  EXPECT_EQ(run_shell("python3 " + program + " --check").status, 0);
  EXPECT_THAT(run("export " + model() + " --format c -o -").out, HasSubstr("offset_b_urad"));
  const std::string csv = run("export " + model() + " --format csv --quiet").out;
  EXPECT_THAT(csv, HasSubstr("displacement_b_urad,,displacement,limit,100,urad\n"));
  EXPECT_THAT(
      run("export " + model() + " --format linuxcnc -o " + scratch()->file("nest_hal.py")).status,
      0);
  EXPECT_THAT(file_text(scratch()->file("nest_hal.hal")), HasSubstr("axis.b.eoffset-counts"));
}

TEST_F(Nest, AMissingProbeIsNamed) {
  const std::string record = scratch()->write(
      "few.csv",
      "time_s,front_bearing_temperature_C,ambient_temperature_C,x1_um,y1_um,y2_um,z_um\n"
      "0,20,20,0,0,0,0\n60,20,20,0,0,0,0\n");
  expect_refused(run("correct " + model() + " " + record),
                 "column x2_um is missing, from which " + model());
}

}  // namespace
}  // namespace raceway::tests

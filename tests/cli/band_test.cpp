#include <cmath>

#include "tests/cli/sample.h"

// --band: what the errors of fitted parameters do to a prediction.
namespace raceway::tests {
namespace {

using testing::HasSubstr;

const std::string covariance =
    "\n[calibration.covariance]\nparameters = [\"f0\"]\nunits = [\"1\"]\nvalues = [1.5]\n"
    "std = [0.05]\ncorrelation = [[1.0]]\n";

const std::string shaft_folder =
    "\n[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload_N = 600.0\n";
const std::string of_preload =
    "\n[calibration.covariance]\nparameters = [\"preload_N\"]\nunits = [\"N\"]\nvalues = [600.0]\n"
    "std = [25.0]\ncorrelation = [[1.0]]\n";

/// Palmgren's viscous moment per f0 at 40 C, d_m 90 mm [N mm].
double slope(double speed_rpm) {
  return 1e-7 * std::pow(22.0 * speed_rpm, 2.0 / 3.0) * std::pow(90.0, 3);
}

TEST(Band, OfTorqueThatIsLinearInF0IsTheSlopeTimesItsError) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text + covariance);
  const double expected = 1.959964 * 0.05 * slope(8000);
  const json solved =
      parsed(run("solve " + model + " --speed 8000 --axial-load 300 --band --json"));
  EXPECT_NEAR(solved["friction_torque_band_Nmm"].get<double>(), expected, 1e-5 * expected);
  const double watt = expected * 1e-3 * 8000 * std::acos(-1.0) / 30;
  EXPECT_NEAR(solved["power_loss_band_W"].get<double>(), watt, 1e-5 * watt);
  EXPECT_NEAR(solved["inner_ring_heat_band_W"].get<double>() +
                  solved["outer_ring_heat_band_W"].get<double>(),
              watt, 1e-5 * watt);
  EXPECT_EQ(solved["band"]["level"], 0.95);
  EXPECT_EQ(solved["band"]["parameters"], json{"f0"});
  const json table =
      parsed(run("table " + model + " --speed 2000,8000 --axial-load 300,900 --band --json"));
  for (const json& row : table["rows"])
    EXPECT_NEAR(row["friction_torque_band_Nmm"].get<double>(),
                1.959964 * 0.05 * slope(row["speed_rpm"].get<double>()), 1e-4);
  const Result csv = run("table " + model + " --speed 8000 --axial-load 300 --band -o -");
  EXPECT_THAT(csv.out, HasSubstr(",friction_torque_band_Nmm,power_loss_band_W,status\n"));
  EXPECT_THAT(csv.err, HasSubstr("95 % band from the uncertainty of the fitted f0 only"));
  EXPECT_THAT(run("table " + model + " --speed 8000 --axial-load 300 --band").out,
              HasSubstr(" +- 22"));
  EXPECT_THAT(run("solve " + model + " --speed 8000 --axial-load 300 --band").out,
              HasSubstr("only; it does not include missing effects or noise"));
}

TEST(Band, LeavesAllOtherNumbersAsTheyAre) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text + covariance);
  for (const std::string& command :
       {"solve " + model + " --speed 8000 --axial-load 300 --json",
        "table " + model + " --speed 0:9000:3000 --axial-load 300 --json"}) {
    json with = parsed(run(command + " --band")), without = parsed(run(command));
    EXPECT_NE(with, without);
    with.erase("band");
    for (json* part : with.contains("rows") ? std::vector<json*>{&with["rows"][0], &with["rows"][1],
                                                                 &with["rows"][2], &with["rows"][3]}
                                            : std::vector<json*>{&with})
      for (const char* key : {"friction_torque_band_Nmm", "power_loss_band_W",
                              "inner_ring_heat_band_W", "outer_ring_heat_band_W"})
        part->erase(key);
    EXPECT_EQ(with, without);
  }
}

TEST(Band, OfAShaftIsThatOfItsPosition) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("s.toml", model_text + shaft_folder + of_preload);
  const json d = parsed(run("displacement " + model + " --speed 4000,12000 --band --json"));
  const auto position = [&](double preload) {
    const std::string text = replaced(model_text + shaft_folder, "600.0", std::to_string(preload));
    return parsed(run("displacement " + scratch.write("p.toml", text) +
                      " --speed 12000 --json"))["rows"][0]["axial_displacement_um"]
        .get<double>();
  };
  const double expected = 1.959964 * std::abs(position(625.0) - position(575.0)) / 2;
  EXPECT_NEAR(d["rows"][1]["axial_displacement_band_um"].get<double>(), expected, 2e-3 * expected);
  const json s = parsed(run("solve " + model + " --speed 12000 --band --json"));
  EXPECT_NEAR(s["axial_displacement_band_um"].get<double>(), expected, 2e-3 * expected);
  const json t = parsed(run("table " + model + " --speed 12000 --band --json"));
  EXPECT_NEAR(t["rows"][0]["axial_displacement_band_um"].get<double>(), expected, 2e-3 * expected);
  EXPECT_THAT(run("displacement " + model + " --speed 12000 --band -o -").out,
              HasSubstr("axial_displacement_band_um,friction_torque_band_Nmm,power_loss_band_W,"));
  EXPECT_THAT(run("displacement " + model + " --speed 12000 --band").out,
              HasSubstr("95 % band from the uncertainty of the fitted preload_N only"));
}

TEST(Band, OfACalibratedModelNeedsNothingElse) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const std::string fitted = scratch.file("fitted.toml");
  const json c = parsed(
      run("calibrate " + model + " " + scratch.write("d.csv", data_text) + " --json -o " + fitted));
  const Result r = run("solve " + fitted + " --speed 8000 --axial-load 300 --band --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const double f0 = c["parameters"]["f0"]["std"], z = c["parameters"]["z"]["std"];
  const double correlation = c["correlation"][0][1];
  const json at = parsed(r)["friction"];
  const double per_z = at["load_Nmm"].get<double>() / c["parameters"]["z"]["value"].get<double>();
  const double a = f0 * slope(8000), b = z * per_z;
  EXPECT_NEAR(parsed(r)["friction_torque_band_Nmm"].get<double>(),
              1.959964 * std::sqrt(a * a + b * b + 2 * correlation * a * b), 1e-4);
}

TEST(Band, NeedsACalibrationOfTheValuesThatStandInTheModel) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const std::string at = " --speed 8000 --axial-load 300 --band";
  for (const std::string command : {"solve", "table"})
    expect_refused(run(command + " " + model + at), "raceway calibrate " + model);
  const std::string changed =
      scratch.write("c.toml", replaced(model_text, "f0 = 1.5", "f0 = 1.6") + covariance);
  const Result r = run("solve " + changed + at);
  expect_refused(r, "has no [calibration.covariance] for the present values of its parameters;");
  EXPECT_THAT(r.err, HasSubstr("the model has f0 = 1.6"));
  EXPECT_EQ(run("solve " + changed + " --speed 8000 --axial-load 300").status, 0);
}

}  // namespace
}  // namespace raceway::tests

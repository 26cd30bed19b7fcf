#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_program.h"

// A cylindrical roller bearing as a user has it: from `new` to `diagnose`.
namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Rows of a rig with an N1012 under radial load. The torque is written out here, by Palmgren's
/// formulas with f0 = 1.8 and f1 = 0.00035, with `added(rpm, N)` on top, in N mm.
template <typename Added>
std::string rig_of_n1012(const Added& added) {
  std::string text = "speed_rpm,radial_load_N,temperature_C,friction_torque_Nmm\n";
  int k = 0;
  for (const double speed : {600.0, 1200.0, 2500.0, 4500.0, 7000.0})
    for (const double load : {500.0, 1500.0, 3000.0, 5000.0})
      for (const double temperature : {30.0, 50.0}) {
        const double nu = temperature == 30.0 ? 30.0 : 14.0;  // mm²/s, see the model
        const double viscous = 1.8e-7 * std::pow(nu * speed, 2.0 / 3.0) * std::pow(77.5, 3);
        const double torque = viscous + 0.00035 * load * 77.5 + added(speed, load);
        const double scatter = 1.0 + 0.004 * std::sin(1.0 + 7.3 * k++);
        text += fmt::format("{},{},{},{:.4f}\n", speed, load, temperature, torque * scatter);
      }
  return text;
}

/// `viscosity_*` of an oil with 30 and 14 mm²/s at 30 and 50 C by ASTM D341.
constexpr const char* n1012_text = R"([bearing]
type = "cylindrical-roller"
roller_count = 20
roller_diameter_mm = 8
roller_length_mm = 8
pitch_diameter_mm = 77.5
bore_mm = 60
outer_diameter_mm = 95
[lubricant]
viscosity_40C_mm2_s = 19.95448
viscosity_100C_mm2_s = 4.049896
[friction]
f1_load = "F_r"
)";

TEST(RollerCommand, NewWritesAModelThatSolveTakes) {
  const ScratchFolder scratch;
  const std::string model = scratch.file("n1012.toml");
  const Result made = run("new \"N1012 KTN/SP\" -o " + model);
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err,
              HasSubstr("is a cylindrical roller bearing: its roller data are estimated"));
  EXPECT_THAT(file_text(model), HasSubstr("the catalogue has 44300 N and 55200 N"));
  const Result solved = run("solve " + model + " --speed 4000 --radial-load 2000 --json");
  ASSERT_EQ(solved.status, 0) << solved.err;
  const json document = json::parse(solved.out);
  EXPECT_EQ(document["type"], "cylindrical-roller");
  EXPECT_EQ(document["rollers"].size(), 22u);
  EXPECT_NEAR(
      document["inner_ring_heat_W"].get<double>() + document["outer_ring_heat_W"].get<double>(),
      document["power_loss_W"].get<double>(), 1e-6);
  const Result text = run("solve " + model + " --speed 4000 --radial-load 2000");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("rollers touch the inner ring"));
  EXPECT_THAT(text.out, HasSubstr("reference L10r"));
}

TEST(RollerCommand, NewRefusesWhatItDoesNotKnow) {
  EXPECT_THAT(run("new \"NU 210 ECP\"").err,
              HasSubstr("the program can estimate only cylindrical roller bearings of series N10"));
  EXPECT_THAT(
      run("new N1012 --balls 20").err,
      HasSubstr(
          "--bore, --outer-diameter, --balls and --contact-angle are only for ball bearings"));
  EXPECT_THAT(run("new N1012 --law contact").err, HasSubstr("choose the law palmgren or skf"));
  EXPECT_THAT(run("new N1099").err,
              HasSubstr("the table of ISO 15 has no boundary dimensions for this size"));
}

TEST(RollerCommand, ATableHasTheRadialLoadAcross) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("n1012.toml", n1012_text);
  const Result text = run("table " + model + " --speed 1000,4000 --radial-load 0,1000,2000");
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("columns: radial load"));
  const Result rows = run("table " + model + " --speed 0 --radial-load 2000 --json");
  ASSERT_EQ(rows.status, 0) << rows.err;
  const json row = json::parse(rows.out)["rows"][0];
  EXPECT_NEAR(row["radial_stiffness_N_um"].get<double>(), 510.0, 1.0);
  EXPECT_EQ(row["status"], "converged");
}

TEST(RollerCommand, AnAxialLoadIsAnError) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("n1012.toml", n1012_text);
  const Result solved = run("solve " + model + " --speed 1000 --axial-load 100 --radial-load 500");
  EXPECT_EQ(solved.status, 1);
  EXPECT_THAT(solved.err, HasSubstr("--axial-load: must be 0"));
  EXPECT_THAT(solved.err, HasSubstr("cannot carry an axial load"));
  const std::string data = scratch.write(
      "rig.csv", "speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm\n1000,50,500,40\n");
  const Result compared = run("compare " + model + " " + data);
  EXPECT_EQ(compared.status, 1);
  EXPECT_THAT(compared.err, HasSubstr("axial_load_N = 50: must be 0"));
}

TEST(RollerCommand, TyposAndNumbersOutOfRangeAreNamed) {
  const ScratchFolder scratch;
  const auto why = [&](const std::string& from, const std::string& to) {
    std::string text = n1012_text;
    text.replace(text.find(from), from.size(), to);
    const Result r = run("check " + scratch.write("bad.toml", text));
    EXPECT_EQ(r.status, 1) << to;
    return r.err;
  };
  EXPECT_THAT(why("\"cylindrical-roller\"", "\"cylindrical-rollers\""),
              HasSubstr("bad.toml:2: type = \"cylindrical-rollers\": must be ball or "
                        "cylindrical-roller; did you mean cylindrical-roller?"));
  EXPECT_THAT(why("roller_count", "rollers_count"), HasSubstr("did you mean roller_count?"));
  EXPECT_THAT(why("roller_count = 20", "ball_count = 20"),
              HasSubstr("ball_count = 20: this key is only for ball bearings, but the type is "
                        "\"cylindrical-roller\"; use roller_count"));
  EXPECT_THAT(why("roller_count = 20", "roller_count = 31"), HasSubstr("at most 29 rollers"));
  EXPECT_THAT(why("roller_length_mm = 8", "roller_length_mm = 81"), HasSubstr("roller_length_mm"));
  EXPECT_THAT(why("bore_mm = 60", "bore_mm = 70"), HasSubstr("bore_mm"));
  EXPECT_THAT(why("[friction]", "[solver]\nrace_control = \"inner\"\n[friction]"),
              HasSubstr("race_control = \"inner\": this key is only for ball bearings"));
  EXPECT_THAT(why("[friction]", "[shaft]\n[friction]"), HasSubstr("is a single bearing on a rig"));
  EXPECT_THAT(why("f1_load = \"F_r\"", "f1_load = \"P0\""), HasSubstr("must be F_r or rollers"));
  EXPECT_THAT(why("f1_load = \"F_r\"", "mu_EHL = 0.02"),
              HasSubstr("this key is only for law = \"skf\""));
}

TEST(RollerCommand, KeysTellOfThem) {
  EXPECT_THAT(run("keys roller_count").out,
              HasSubstr("[bearing]\n  roller_count  4 to 200; required\n      cylindrical "
                        "rollers: "));
  EXPECT_THAT(run("keys \"f1_load rollers\"").out, HasSubstr("F_r or rollers"));
}

TEST(RollerCommand, CommandsOfSetsRefuseIt) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("n1012.toml", n1012_text);
  for (const char* command : {"displacement MODEL --speed 1000", "deflection MODEL --force 100",
                              "modes MODEL --speed 1000"}) {
    std::string arguments = command;
    const Result r = run(arguments.replace(arguments.find("MODEL"), 5, model));
    EXPECT_EQ(r.status, 1) << command;
    EXPECT_THAT(r.err, HasSubstr("has no [arrangement]"));
  }
  EXPECT_THAT(run("spindle " + model + " --speed 1000 --steady").err,
              HasSubstr("is not a spindle"));
  EXPECT_THAT(run("table " + model + " --speed 1000 --radial-load 500 --report " +
                  scratch.file("page.html"))
                  .err,
              HasSubstr("--report is not possible for cylindrical roller bearings"));
}

TEST(RollerCommand, CalibrateFindsTheFactorsOfARig) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("n1012.toml", n1012_text);
  const std::string data = scratch.write("rig.csv", rig_of_n1012([](double, double) { return 0; }));
  const Result r = run("calibrate " + model + " " + data + " --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const json parameters = json::parse(r.out)["parameters"];
  EXPECT_EQ(parameters.size(), 2u);
  EXPECT_NEAR(parameters["f0"]["value"].get<double>(), 1.8, 0.02);
  EXPECT_NEAR(parameters["f1"]["value"].get<double>(), 0.00035, 0.000005);
}

TEST(RollerCommand, DiagnoseFindsNothingMissingOnARigWithoutHiddenEffect) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("n1012.toml", n1012_text);
  const std::string data = scratch.write("rig.csv", rig_of_n1012([](double, double) { return 0; }));
  const Result r = run("diagnose " + model + " " + data + " --json");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(json::parse(r.out)["verdict"], "nothing-missing") << r.out;
}

}  // namespace
}  // namespace raceway::tests

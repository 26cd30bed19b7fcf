#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class Solve : public testing::Test {
 protected:
  [[nodiscard]] Result solve(const std::string& model, const std::string& flags) const {
    return run("solve " + scratch_.write("my.toml", model) + " " + flags);
  }
  ScratchFolder scratch_;
};

TEST_F(Solve, JsonHasTheKeysOfTheContract) {
  const Result r = solve(model_text + spin_effect, "--speed 10000 --axial-load 600 --json");
  EXPECT_EQ(r.status, 0);
  const json d = parsed(r);
  EXPECT_THAT(keys(d), IsSupersetOf({"axial_displacement_um", "radial_displacement_um",
                                     "tilt_y_mrad", "tilt_z_mrad", "balls", "stiffness", "friction",
                                     "friction_torque_Nmm", "power_loss_W", "report"}));
  ASSERT_EQ(d["balls"].size(), 20U);
  EXPECT_THAT(keys(d["balls"][0]),
              IsSupersetOf({"azimuth_deg", "inner_contact_angle_deg", "outer_contact_angle_deg",
                            "inner_load_N", "outer_load_N", "centrifugal_force_N",
                            "gyroscopic_moment_Nmm"}));
  EXPECT_THAT(keys(d["stiffness"]), IsSupersetOf({"axial_N_um", "radial_N_um", "matrix"}));
  ASSERT_EQ(d["stiffness"]["matrix"].size(), 5U);
  for (const json& row : d["stiffness"]["matrix"]) EXPECT_EQ(row.size(), 5U);
  EXPECT_THAT(keys(d["friction"]), IsSupersetOf({"load_Nmm", "viscous_Nmm", "spin-friction_Nmm"}));
  EXPECT_THAT(keys(d["report"]),
              IsSupersetOf({"status", "iterations", "residual", "recovered_load_error"}));
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_EQ(d["speed_rpm"], 10000.0) << "no rounding of a change of unit";
}

TEST_F(Solve, PartsOfTheTorqueAndHeatAddUp) {
  const json d = parsed(solve(model_text + spin_effect, "--speed 10000 --axial-load 600 --json"));
  double sum = 0.0;
  for (const auto& [name, part] : d["friction"].items()) sum += part.get<double>();
  // 15 digits are printed.
  EXPECT_NEAR(d["friction_torque_Nmm"].get<double>() / sum, 1.0, 1e-13);
  const double heat = d["inner_ring_heat_W"].get<double>() + d["outer_ring_heat_W"].get<double>();
  EXPECT_NEAR(d["power_loss_W"].get<double>() / heat, 1.0, 1e-13);
}

TEST_F(Solve, BallsOfAPureThrustFitEightyColumns) {
  for (const std::string load : {"", " --radial-load 100"}) {
    const Result r = solve(model_text, "--speed 10000 --axial-load 600" + load);
    std::istringstream lines(r.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_THAT(r.out, HasSubstr("gyrosc.\n"));
  }
  EXPECT_THAT(solve(model_text, "--speed 10000 --axial-load 600").out, HasSubstr("all 20  "));
}

TEST_F(Solve, WritesTorqueForPeopleWithABlank) {
  const Result r = solve(model_text, "--speed 10000 --axial-load 600");
  EXPECT_THAT(r.out, HasSubstr(" N mm "));
  EXPECT_THAT(r.out, Not(HasSubstr("Nmm")));
}

TEST_F(Solve, CheckNamesEveryDefault) {
  const ScratchFolder scratch;
  const Result r = run("check " + scratch.write("my.toml", model_text));
  for (const char* text : {"bearing.ball_material = \"steel\"", "solver.tilt = \"locked\"",
                           "solver.race_control = \"outer\"", "friction.law = \"palmgren\"",
                           "rig.temperature_C = 40", "calibration.free = [\"f0\", \"z\"]"})
    EXPECT_THAT(r.out, HasSubstr(text));
}

TEST_F(Solve, WithoutBalanceGivesStatusTwoAndNoNumber) {
  const std::string flags = "--speed 20000 --axial-load 5";
  const Result text = solve(model_text + inner_control, flags);
  EXPECT_EQ(text.status, 2);
  EXPECT_EQ(text.out, "");
  EXPECT_THAT(text.err, HasSubstr("no_equilibrium at 20000 rpm, 5 N axial"));
  EXPECT_THAT(text.err,
              HasSubstr(": the solver found no inner ring position that carries this load"));
  const Result bare = solve(model_text, "--speed 1000 --axial-load 0");
  EXPECT_THAT(bare.err, HasSubstr(": no load presses the ring against the balls"));
  EXPECT_TRUE(parsed(solve(model_text, "--speed 1000 --axial-load 0 --json"))["report"]["certain"]);

  for (const std::string& effect : {std::string(), spin_effect}) {
    const Result r = solve(model_text + inner_control + effect, flags + " --json");
    EXPECT_EQ(r.status, 2);
    const json d = parsed(r);
    EXPECT_EQ(d["report"]["status"], "no_equilibrium");
    EXPECT_EQ(d["report"]["certain"], false);
    for (const char* key : {"axial_displacement_um", "radial_displacement_um", "tilt_y_mrad",
                            "friction_torque_Nmm", "power_loss_W", "inner_ring_heat_W"})
      EXPECT_TRUE(d[key].is_null()) << key;
    EXPECT_TRUE(d["stiffness"]["axial_N_um"].is_null());
    for (const auto& [name, part] : d["friction"].items()) EXPECT_TRUE(part.is_null()) << name;
    EXPECT_TRUE(d["balls"].empty());
  }
}

TEST_F(Solve, ARadialLoadAloneSaysWhatCarriesIt) {
  const std::string flags = "--speed 6000 --axial-load 0 --radial-load 300";
  const Result text = solve(model_text, flags);
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.err, HasSubstr("at the bottom of the grooves"));
  const json d = parsed(solve(model_text, flags + " --json"));
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_EQ(d["seat"], "groove_bottom");
  EXPECT_EQ(parsed(solve(model_text, "--speed 6000 --axial-load 300 --json"))["seat"], "shoulder");
}

std::string with_shoulders(double inner, double outer) {
  return replaced(model_text, "[bearing]\n",
                  "[bearing]\ninner_shoulder_diameter_mm = " + std::to_string(inner) +
                      "\nouter_shoulder_diameter_mm = " + std::to_string(outer) + "\n");
}

TEST_F(Solve, SaysHowFarTheEllipsesStayBelowTheShoulders) {
  EXPECT_EQ(parsed(solve(model_text, "--speed 6000 --axial-load 300 --json"))["shoulder"], nullptr);
  const std::string model = with_shoulders(83.0, 97.0), flags = "--speed 0 --axial-load ";
  const Result text = solve(model, flags + "300");
  EXPECT_THAT(text.out, HasSubstr("deg to the inner shoulder"));
  EXPECT_THAT(text.out, HasSubstr("permissible axial load at standstill"));
  EXPECT_THAT(text.err, Not(HasSubstr("shoulder")));
  const json shoulder = parsed(solve(model, flags + "300 --json"))["shoulder"];
  EXPECT_GT(shoulder["inner"]["margin_deg"], 0.0);
  EXPECT_EQ(shoulder["inner"]["cut_share"], 0.0);
  const double load = shoulder["permissible_axial_load_N"];
  EXPECT_EQ(load, std::min(shoulder["inner"]["permissible_axial_load_N"].get<double>(),
                           shoulder["outer"]["permissible_axial_load_N"].get<double>()));
  const auto at = [&](double share) {
    return solve(model, flags + std::to_string(share * load)).err;
  };
  EXPECT_THAT(at(0.999), Not(HasSubstr("the contact ellipse reaches over the")));
  EXPECT_THAT(at(1.01), HasSubstr("warning: the "));
  EXPECT_THAT(at(1.01), HasSubstr("the contact ellipse reaches over the"));
}

TEST_F(Solve, AShoulderOutsideItsGrooveIsRefusedWithItsLine) {
  const Result r = solve(with_shoulders(70.0, 97.0), "--speed 0 --axial-load 300");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("inner_shoulder_diameter_mm = 70"));
  EXPECT_THAT(r.err, HasSubstr("must be from"));
}

TEST_F(Solve, AMomentAloneIsCarriedWhereTiltIsFree) {
  const std::string free = model_text + "[solver]\ntilt = \"free\"\n";
  const std::string flags = "--speed 6000 --axial-load 0 --moment-z 10000";
  const Result text = solve(free, flags);
  EXPECT_EQ(text.status, 0);
  EXPECT_THAT(text.err, HasSubstr("side without a shoulder"));
  const json d = parsed(solve(free, flags + " --json"));
  EXPECT_EQ(d["seat"], "far_side");
  EXPECT_GT(d["tilt_z_mrad"], 0.1);
}

TEST_F(Solve, RadialDisplacementHasASign) {
  const std::string free = model_text + "[solver]\ntilt = \"free\"\n";
  const json d = parsed(solve(free, "--speed 6000 --axial-load 300 --moment-z 2000 --json"));
  const json other = parsed(solve(free, "--speed 6000 --axial-load 300 --moment-z -2000 --json"));
  const double y = d["radial_displacement_y_um"];
  EXPECT_NE(y, 0.0);
  EXPECT_EQ(d["radial_displacement_um"], std::abs(y));
  EXPECT_LT(y * other["radial_displacement_y_um"].get<double>(), 0.0);
  const json about_y = parsed(solve(free, "--speed 6000 --axial-load 300 --moment-y 2000 --json"));
  EXPECT_LT(about_y["radial_displacement_z_um"].get<double>() * y, 0.0);
}

TEST_F(Solve, WithoutAnyLoadHasNoBalance) {
  EXPECT_EQ(solve(model_text, "--speed 0 --axial-load 0").status, 2);
}

TEST_F(Solve, LostBallsHaveNoInnerAngle) {
  // A radial load beyond the axial one frees the balls of the far side.
  const json d = parsed(solve(model_text, "--speed 0 --axial-load 100 --radial-load 300 --json"));
  ASSERT_EQ(d["balls"].size(), 20U);
  EXPECT_TRUE(d["balls"][10]["inner_contact_angle_deg"].is_null());
  EXPECT_FALSE(d["balls"][0]["inner_contact_angle_deg"].is_null());
}

TEST_F(Solve, TakesMaterialsSolverAndLawFromTheModel) {
  const auto torque = [&](const std::string& model) {
    const Result r = solve(model, "--speed 12000 --axial-load 500 --radial-load 100 --json");
    EXPECT_EQ(r.status, 0) << r.err;
    return parsed(r);
  };
  const std::string rating = "static_load_rating_N = 43000\n";
  const json steel = torque(model_text);
  const json nitride =
      torque(replaced(model_text, rating, rating + "ball_material = \"silicon-nitride\"\n"));
  EXPECT_LT(nitride["balls"][0]["centrifugal_force_N"], steel["balls"][0]["centrifugal_force_N"]);
  // Steel by another name gives the same numbers.
  const json own = torque(replaced(model_text, rating, rating + "ball_material = \"my\"\n") +
                          "[material.my]\nelastic_modulus_GPa = 208\npoisson_ratio = 0.3\n"
                          "density_kg_m3 = 7800\nthermal_expansion_1e6_K = 11.5\n");
  EXPECT_EQ(own["balls"], steel["balls"]);
  const json free = torque(model_text + "[solver]\ntilt = \"free\"\n");
  EXPECT_NE(free["tilt_z_mrad"], 0.0);
  EXPECT_EQ(steel["tilt_z_mrad"], 0.0);
  const json skf = torque(replaced(model_text, "f0 = 1.5\nz = 0.001\ny = 0.33", "law = \"skf\""));
  EXPECT_EQ(skf["balls"], steel["balls"]);
  EXPECT_NE(skf["friction_torque_Nmm"], steel["friction_torque_Nmm"]);
  const json catalogue = torque(
      "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
      "viscosity_100C_mm2_s = 4.8\n");
  EXPECT_EQ(catalogue["balls"].size(), 21U);
}

TEST_F(Solve, LoadsOfTheRigStandInForFlags) {
  const std::string rig = "[rig]\naxial_load_N = 600\nradial_load_N = 50\ntemperature_C = 30\n";
  const json d = parsed(solve(model_text + rig, "--speed 1000 --json"));
  EXPECT_EQ(d["axial_load_N"], 600.0);
  EXPECT_EQ(d["radial_load_N"], 50.0);
  EXPECT_EQ(d["temperature_C"], 30.0);
  expect_refused(solve(model_text, "--speed 1000"), "--axial-load is missing, and ");
}

TEST_F(Solve, RefusesNumbersOutOfRange) {
  const auto refused = [&](const std::string& flags, const std::string& message) {
    expect_refused(solve(model_text, flags), message);
  };
  refused("--speed -5 --axial-load 1", "--speed = -5 rpm: must be from 0 to 1000000 rpm");
  refused("--speed nan --axial-load 1",
          "--speed = \"nan\": is not a finite number; must be from 0");
  refused("--speed 10,5 --axial-load 1", "--speed = \"10,5\": has a decimal comma");
  refused("--speed 10rpm --axial-load 1", "--speed = \"10rpm\": is not a number");
  refused("--speed 10 --axial-load inf", "--axial-load = \"inf\": is not a finite number");
  refused("--speed 10 --axial-load -1", "--axial-load = -1 N: must be from 0 to 100000000 N");
  refused("--speed 10 --axial-load 9 --radial-load -1", "--radial-load = -1 N: must be from 0");
  refused("--speed 10 --axial-load 9 --temperature 401", "must be from -100 to 400 C");
}

}  // namespace
}  // namespace raceway::tests

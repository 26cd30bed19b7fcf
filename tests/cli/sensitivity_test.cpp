#include <cmath>
#include <limits>

#include "tests/cli/sample.h"
#include "tests/places.h"

// raceway sensitivity: which datum matters, against laws whose powers are known.
namespace raceway::tests {
namespace {

using testing::HasSubstr;

const std::string at_point = " --speed 8000 --axial-load 300";

json answer(const std::string& arguments) {
  const Result result = run("sensitivity " + arguments + " --json");
  EXPECT_EQ(result.status, 0) << result.err;
  return parsed(result);
}

const json& datum(const json& prediction, const std::string& name) {
  for (const json& one : prediction["data"])
    if (one["name"] == name) return one;
  static const json none;
  ADD_FAILURE() << name << " is none of the data that enter";
  return none;
}

TEST(Sensitivity, OfPalmgrensViscousMomentHasItsPowers) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  // M0 ~ f0 (ν n)^(2/3) d_m³; at 40 C the viscosity is that of the card.
  const json found = answer(model + at_point + " --of viscous_Nmm");
  const json& viscous = found["predictions"][0];
  const double value = 1e-7 * 1.5 * std::pow(22.0 * 8000.0, 2.0 / 3.0) * std::pow(90.0, 3);
  EXPECT_NEAR(viscous["value"].get<double>(), value, 1e-9 * value);
  const auto elasticity = [&](const char* name) {
    return datum(viscous, name)["elasticity"].get<double>();
  };
  EXPECT_NEAR(elasticity("friction.f0"), 1.0, 1e-9);
  EXPECT_NEAR(elasticity("lubricant.viscosity_40C_mm2_s"), 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(elasticity("speed_rpm"), 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(elasticity("bearing.pitch_diameter_mm"), 3.0, 1e-9);
  // A temperature in C has no percent.
  EXPECT_TRUE(datum(viscous, "rig.temperature_C")["elasticity"].is_null());
  EXPECT_EQ(datum(viscous, "rig.temperature_C")["spread"], 1.0);
  EXPECT_THAT(found["does_not_enter"].dump(), HasSubstr("bearing.ball_count"));
  double shares = 0.0;
  for (const json& one : viscous["data"]) shares += one["share"].get<double>();
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

TEST(Sensitivity, OfLoadAndSpeedOfASphereOnASphereIsThatOfHertz) {
  const ScratchFolder scratch;
  // Slow: no inertia. δ ~ Q^(2/3) at a steep angle, the stiffness then ~ Q^(1/3).
  const std::string text =
      replaced(model_text, "contact_angle_deg = 25.0", "contact_angle_deg = 60.0");
  const json found = answer(scratch.write("m.toml", text) +
                            " --of displacement,stiffness --speed 1 --axial-load 1");
  EXPECT_NEAR(datum(found["predictions"][0], "axial_load_N")["elasticity"].get<double>(), 2.0 / 3.0,
              0.005);
  EXPECT_NEAR(datum(found["predictions"][1], "axial_load_N")["elasticity"].get<double>(), 1.0 / 3.0,
              0.005);
}

TEST(Sensitivity, CountsGoByOneAndHaveNoSecondStep) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const json found = answer(model + at_point + " --of stiffness");
  const json& balls = datum(found["predictions"][0], "bearing.ball_count");
  const auto stiffness = [&](int count) {
    const std::string other =
        replaced(model_text, "ball_count = 20", "ball_count = " + std::to_string(count));
    return parsed(run("sensitivity " + scratch.write("o.toml", other) + at_point +
                      " --of stiffness --data ball_count --json"))["predictions"][0]["value"]
        .get<double>();
  };
  EXPECT_NEAR(balls["derivative"].get<double>(), 0.5 * (stiffness(21) - stiffness(19)), 1e-9);
  EXPECT_NEAR(balls["high"].get<double>(), stiffness(21), 1e-9);
  EXPECT_EQ(balls["spread"], 1.0);
}

TEST(Sensitivity, SeesTheKinkOfALaw) {
  const ScratchFolder scratch;
  // At ν n = 2000 Palmgren's viscous moment begins to grow.
  const std::string model = scratch.write("m.toml", model_text);
  const auto kink = [&](const std::string& speed) {
    const json found = answer(model + " --speed " + speed + " --axial-load 300 --of viscous_Nmm");
    for (const json& one : found["predictions"][0]["data"])
      if (one["name"] == "speed_rpm")
        return one["kink"].get<bool>() || one["steps_disagree"].get<bool>();
    return false;
  };
  EXPECT_TRUE(kink("90.909090909"));
  EXPECT_FALSE(kink("200"));
}

TEST(Sensitivity, TakesTheStandardErrorsThatAModelCarries) {
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "m.toml", model_text +
                    "\n[calibration.covariance]\nparameters = [\"f0\"]\nunits = [\"1\"]\n"
                    "values = [1.5]\nstd = [0.05]\ncorrelation = [[1.0]]\n");
  const json f0 = datum(answer(model + at_point)["predictions"][0], "friction.f0");
  EXPECT_EQ(f0["spread_from"], "standard error");
  EXPECT_NEAR(f0["spread"].get<double>(), std::sqrt(3.0) * 0.05, 1e-12);
  const json given =
      datum(answer(model + at_point + " --spread f0=10%")["predictions"][0], "friction.f0");
  EXPECT_EQ(given["spread_from"], "given");
  EXPECT_NEAR(given["spread"].get<double>(), 0.15, 1e-12);
}

TEST(Sensitivity, IndicesOfAProductAreThoseOfItsFactors) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const std::string question =
      model +
      " --speed 8000 --axial-load 300 --of viscous_Nmm --data f0,pitch_diameter_mm "
      "--spread f0=50%,pitch_diameter_mm=10% --global 2048";
  const json found = answer(question);
  const json& viscous = found["predictions"][0];
  // f0 d³, both even: V = E[x²] E[y²] - 1 with x of f0 and y of d³, each over its mean.
  const double x = 0.25 / 3.0;    // variance of f0 over its mean
  const auto power = [](int n) {  // mean of (1 + 0.1 s)^n, s even from -1 to 1
    return (std::pow(1.1, n + 1) - std::pow(0.9, n + 1)) / (0.2 * (n + 1));
  };
  const double y = power(6) / (power(3) * power(3)) - 1.0;
  const double all = (1.0 + x) * (1.0 + y) - 1.0;
  const auto near = [&](const char* name, double first, double total) {
    const json& global = datum(viscous, name)["global"];
    EXPECT_NEAR(global["first"].get<double>(), first, 0.004) << name;
    EXPECT_NEAR(global["total"].get<double>(), total, 0.004) << name;
    EXPECT_LT(std::fabs(global["total"].get<double>() - total),
              global["total_error"].get<double>());
  };
  near("friction.f0", x / all, x * (1.0 + y) / all);
  near("bearing.pitch_diameter_mm", y / all, y * (1.0 + x) / all);
  EXPECT_EQ(found["global"]["evaluations"], 4 * 2048);
  EXPECT_EQ(found["global"]["failed"], 0);
}

TEST(Sensitivity, FollowsItsSeedAlone) {
  const ScratchFolder scratch;
  const std::string question = "sensitivity " + scratch.write("m.toml", model_text) + at_point +
                               " --data friction --global 64 --json";
  EXPECT_EQ(run(question).out, run(question + " --seed 1").out);
  EXPECT_NE(run(question).out, run(question + " --seed 2").out);
}

TEST(Sensitivity, NamesAndCountsSamplesWithoutAValue) {
  const ScratchFolder scratch;
  // Under inner control nothing balances the gyroscopic couple of a small load.
  const std::string model =
      scratch.write("m.toml", model_text + "[solver]\nrace_control = \"inner\"\n");
  const Result result = run("sensitivity " + model +
                            " --speed 12000 --axial-load 400 --of displacement "
                            "--data axial_load_N,ball_diameter_mm --spread axial_load_N=390 "
                            "--global 64 --json");
  EXPECT_EQ(result.status, 0);  // the model itself has a balance
  EXPECT_THAT(result.err,
              HasSubstr("evaluations have no prediction, and their samples are not used:"));
  const json found = parsed(result);
  EXPECT_GT(found["global"]["failed"].get<int>(), 0);
  const auto complete = found["predictions"][0]["complete_samples"].get<int>();
  EXPECT_GT(complete, 0);
  EXPECT_LT(complete, 64);
  // The one that is named has no balance by itself either.
  const auto load = found["global"]["first_failed"]["data"]["axial_load_N"].get<double>();
  const Result alone =
      run("solve " + model + " --speed 12000 --axial-load " + std::to_string(load));
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.err, HasSubstr("no_equilibrium"));
}

TEST(Sensitivity, OfASpindleIsThatOfItsSteadyStates) {
  const std::string spindle = tests::source_dir() + "/data/spindles/small.toml";
  const json found = answer(spindle + " --steady --speed 6000 --data ambient,f0,speed_rpm");
  const json& moved = found["predictions"][0];
  EXPECT_EQ(moved["name"], "axial_displacement_um");
  const auto at = [&](const std::string& speed) {
    return parsed(run("spindle " + spindle + " --steady --json --speed " +
                      speed))["steady"][0]["axial_displacement_um"]
        .get<double>();
  };
  EXPECT_NEAR(moved["value"].get<double>(), at("6000"), 1e-9);
  const json& speed = datum(moved, "speed_rpm");
  EXPECT_NEAR(speed["low"].get<double>(), at("5940"), 1e-6);
  EXPECT_NEAR(speed["high"].get<double>(), at("6060"), 1e-6);
  EXPECT_NEAR(speed["derivative"].get<double>(), (at("6060") - at("5940")) / 120.0, 1e-5);
}

TEST(Sensitivity, TakesSpreadsFromAFileWithTheKeysOfTheModel) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const std::string spreads = scratch.write(
      "s.toml", "[bearing]\nball_diameter_mm = 0.01\n[lubricant]\nviscosity_40C_mm2_s = \"10%\"\n");
  const json found = answer(model + at_point + " --of stiffness,torque --spread " + spreads);
  EXPECT_NEAR(datum(found["predictions"][0], "bearing.ball_diameter_mm")["spread"].get<double>(),
              0.01, 1e-15);
  EXPECT_NEAR(
      datum(found["predictions"][1], "lubricant.viscosity_40C_mm2_s")["spread"].get<double>(), 2.2,
      1e-12);
}

TEST(Sensitivity, RefusesWhatWasAskedWrong) {
  const ScratchFolder scratch;
  const std::string model = "sensitivity " + scratch.write("m.toml", model_text);
  const auto refused = [&](const std::string& more, const std::string& message) {
    expect_refused(run(model + more), message);
  };
  refused(" --axial-load 300", "--speed is required");
  refused(" --speed 8000", "--axial-load is missing");
  refused(at_point + " --spread bal_diameter_mm=1", "ball_diameter_mm");
  refused(at_point + " --spread ball_diameter_mm=-1",
          "must be 0 or more, because it is the possible error in both directions");
  refused(at_point + " --spread ball_diameter_mm=wide",
          "must be a number in the unit of the value, or a percentage such as 10%");
  refused(at_point + " --spread ball_diameter_mm=nan",
          "must be a number in the unit of the value, or a percentage such as 10%");
  refused(at_point + " --spread ball_diameter_mm=",
          ": write a number of the model and its possible error, such as ball_diameter_mm=0.01 or "
          "viscosity_40C_mm2_s=10%");
  refused(at_point + " --spread ball_count=0.5", "whole number");
  refused(at_point + " --spread radial_load_N=10%",
          "the value is 0, so a percentage has no effect; give the error in the unit of the value");
  refused(at_point + " --spread nothing.toml", "nothing.toml");
  refused(at_point + " --of torqe", ": unknown prediction; must be one of");
  refused(at_point + " --data nonsense", "has no number of this name");
  refused(at_point + " --global 1000", "must be a power of two");
  refused(at_point + " --global -4", "--global");
  refused(at_point + " --steady", "is not a spindle");
  refused(at_point + " --global 64 --spread inner_conformity=0.2 --of stiffness",
          "): the varied model is not valid:");
  refused(at_point + " --global 64 --data f0 --spread f0=0",
          "no number with a spread influences the prediction, so no indices can be calculated");
}

TEST(Sensitivity, TellsDataThatAreZeroApartFromThoseThatDoNotEnter) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("m.toml", model_text);
  const json found = answer(model + at_point + " --of displacement");
  EXPECT_THAT(found["not_varied"].dump(), HasSubstr("rig.radial_load_N"));
  EXPECT_THAT(found["does_not_enter"].dump(), HasSubstr("friction.f0"));
  // With a spread it is varied, to the one side that a load has.
  const json with = answer(model + at_point + " --of displacement --spread radial_load_N=30");
  EXPECT_TRUE(datum(with["predictions"][0], "rig.radial_load_N")["one_sided"].get<bool>());
}

}  // namespace
}  // namespace raceway::tests

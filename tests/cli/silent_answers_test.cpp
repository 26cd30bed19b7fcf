// Answers that a user could take for something else: each of these once passed without a word.
#include <fmt/format.h>

#include <string_view>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string at_a_point = " --speed 15000 --axial-load 300";

class SilentAnswers : public testing::Test {
 protected:
  [[nodiscard]] std::string model(const std::string& text) const {
    return scratch_.write("my.toml", text);
  }
  [[nodiscard]] Result command(const std::string& verb, const std::string& text,
                               const std::string& flags) const {
    return run(verb + " " + model(text) + " " + flags);
  }
  /// Of the one point of a table, as JSON.
  [[nodiscard]] json point(const std::string& text, const std::string& flags) const {
    return parsed(command("table", text, flags + " --json"))["rows"][0];
  }
  ScratchFolder scratch_;
};

std::string with_balls(const std::string& material) {
  return replaced(model_text, "ball_count", "ball_material = \"" + material + "\"\nball_count");
}

TEST_F(SilentAnswers, PalmgrenSaysThatItTakesNoAccountOfTheBalls) {
  const std::string expected =
      "my.toml: the friction torque by palmgren does not depend on ball_count, ball_diameter_mm, "
      "inner_conformity, outer_conformity, ball_material and running contact angles; law = \"skf\" "
      "uses ball_material, and law = \"contact\" uses all these quantities (docs/laws.md)\n";
  const std::string hybrid = with_balls("silicon-nitride");
  for (const char* verb : {"solve", "table"}) {
    const Result r = command(verb, hybrid, at_a_point);
    EXPECT_THAT(r.err, HasSubstr("warning: ")) << verb;
    EXPECT_THAT(r.err, HasSubstr(expected)) << verb;
  }
  EXPECT_THAT(run("compare " + model(hybrid) + " " + scratch_.write("d.csv", data_text)).err,
              HasSubstr(expected));
  EXPECT_EQ(point(hybrid, at_a_point)["friction_torque_Nmm"],
            point(with_balls("steel"), at_a_point)["friction_torque_Nmm"]);
}

TEST_F(SilentAnswers, NoWarningNamesWhatTheUserDidNotWriteOrWhatIsTakenIn) {
  const std::string catalogue =
      "[bearing]\ncatalogue = \"S 6014 C\"\n\n[lubricant]\nviscosity_40C_mm2_s = 22.0\n"
      "viscosity_100C_mm2_s = 4.8\n";
  EXPECT_THAT(command("table", catalogue, at_a_point).err, Not(HasSubstr("warning")));
  EXPECT_THAT(command("table", model_text + spin_effect, at_a_point).err,
              Not(HasSubstr("warning")));
  EXPECT_THAT(command("table",
                      replaced(catalogue, "[lubricant]",
                               "ball_material = \"silicon-nitride\"\n[lubricant]"),
                      at_a_point)
                  .err,
              HasSubstr("palmgren does not depend on ball_material and running"));
}

TEST_F(SilentAnswers, AMomentThatALockedTiltCarriesIsNamed) {
  const std::string flags = at_a_point + " --moment-z 500";
  EXPECT_THAT(command("solve", model_text, flags).err, HasSubstr("warning: "));
  EXPECT_THAT(command("solve", model_text, flags).err,
              HasSubstr("have no effect, because the tilt is locked"));
  EXPECT_THAT(command("solve", model_text + "\n[solver]\ntilt = \"free\"\n", flags).err,
              Not(HasSubstr("have no effect, because the tilt is locked")));
}

// Once `singular` in one and `converged` with empty angles in the other.
TEST_F(SilentAnswers, StatusIsOneForSolveAndTable) {
  for (const char* speed : {"1000", "10000", "60000"})
    for (const char* load : {"10", "500"}) {
      const std::string at = fmt::format("--speed {} --axial-load {}", speed, load);
      const Result solved = command("solve", model_text + inner_control, at + " --json");
      const json row = point(model_text + inner_control, at);
      EXPECT_EQ(row["status"], parsed(solved)["report"]["status"]) << at;
      EXPECT_EQ(row["inner_contact_angle_min_deg"].is_null(), solved.status == 2) << at;
      EXPECT_EQ(row["status"] == "converged", solved.status == 0) << at;
    }
}

TEST_F(SilentAnswers, AFormulaWithoutANumberHasNotConverged) {
  for (const auto& [formula, is] : {std::pair("c / (speed_rpm - 1000)", "infinite"),
                                    std::pair("c * sqrt(-speed_rpm)", "not a number")}) {
    const std::string text =
        model_text +
        fmt::format("\n[[effect]]\nid = \"mine\"\ntorque_Nmm = \"{}\"\nc = 3.0\n", formula);
    const std::string at = "--speed 1000 --axial-load 100",
                      why = fmt::format(
                          "not_finite: the moment of effect mine is {}, torque_Nmm "
                          "= \"{}\"",
                          is, formula);
    const Result solved = command("solve", text, at);
    EXPECT_EQ(solved.status, 2);
    EXPECT_EQ(solved.out, "");
    EXPECT_THAT(solved.err, HasSubstr(why));
    const Result csv = command("table", text, at + " -o -");
    EXPECT_EQ(csv.status, 2);
    EXPECT_THAT(csv.err, HasSubstr(why));
    EXPECT_THAT(csv.out, HasSubstr("\n1000,100,0,40,,"));
    EXPECT_THAT(csv.out, HasSubstr(",not_finite\n"));
    EXPECT_THAT(csv.out.substr(csv.out.find("\nspeed_rpm")), Not(HasSubstr("inf")));
    const Result compared =
        run("compare " + model(text) + " " +
            scratch_.write("d.csv", data_text + "1000,500,100\n2000,500,150\n"));
    if (std::string_view(is) == "infinite")
      EXPECT_THAT(compared.err,
                  HasSubstr("rows, which are left out; the first is in line 2: " + why));
    else
      expect_refused(compared, "the model predicts none of the rows");
  }
}

TEST_F(SilentAnswers, BallsThatHaveLostTheRaceAreCountedInTables) {
  const std::string at = "--speed 20000 --axial-load 100 --radial-load 300";
  const json solved = parsed(command("solve", model_text, at + " --json"));
  const json row = point(model_text, at);
  ASSERT_GT(solved["lost_balls"], 0);
  EXPECT_EQ(row["lost_balls"], solved["lost_balls"]);
  EXPECT_THAT(command("solve", model_text, at).out,
              HasSubstr(fmt::format("{} of 20 balls have no contact with the inner race",
                                    solved["lost_balls"].get<int>())));
  EXPECT_THAT(
      command("table", model_text, "--speed 20000 --axial-load 100,5000 --radial-load 300").err,
      HasSubstr(
          fmt::format("1 of 2 points: up to {} balls have lost contact with the inner race at "
                      "20000 rpm, 100 N axial, 300 N radial",
                      solved["lost_balls"].get<int>())));
}

TEST_F(SilentAnswers, ContactPressureStandsInSolveAndTable) {
  const json solved = parsed(command("solve", model_text, at_a_point + " --json"));
  const json row = point(model_text, at_a_point);
  for (const char* key : {"inner_contact_pressure_MPa", "outer_contact_pressure_MPa"}) {
    EXPECT_GT(solved[key], 300.0);
    EXPECT_NEAR(row[key].get<double>(), solved[key].get<double>(), 1e-6);
  }
  EXPECT_THAT(command("solve", model_text, at_a_point).out, HasSubstr("\ninner pressure  "));
}

TEST_F(SilentAnswers, LoadsThatLeaveDentsAreNamed) {
  const std::string much = "--speed 100 --axial-load 200000";
  for (const char* verb : {"solve", "table"}) {
    const std::string err = command(verb, model_text, much).err;
    EXPECT_THAT(
        err, testing::ContainsRegex("note: the static equivalent load reaches [0-9.e+]+ N, above "
                                    "C0 = 43000 N"))
        << verb;
    EXPECT_THAT(err, HasSubstr("above 4.2 GPa the balls leave permanent dents")) << verb;
  }
  EXPECT_THAT(command("table", model_text, at_a_point).err, Not(HasSubstr("C0")));
}

TEST_F(SilentAnswers, InchesAndKelvinAreNoticed) {
  const std::string inches = replaced(model_text, "11.906", "0.4687");
  EXPECT_THAT(
      command("solve", inches, "--speed 100 --axial-load 10").err,
      HasSubstr(
          "note: " + scratch_.file("my.toml") +
          ": ball_diameter_mm = 0.4687: the value is probably in inches; this would be 11.905 mm"));
  const std::string all = replaced(inches, "90.0", "3.5433");
  EXPECT_THAT(command("solve", all, "--speed 100 --axial-load 10").err,
              HasSubstr("ball_diameter_mm = 0.4687, pitch_diameter_mm = 3.5433: the values are "
                        "probably in inches; this would be 11.905 and 89.9998 mm"));
  EXPECT_THAT(
      command("solve", model_text, at_a_point + " --temperature 313").err,
      HasSubstr(
          "note: --temperature = 313 C: the value is probably in kelvin; this would be 39.85 C"));
  EXPECT_THAT(command("solve", model_text + "\n[rig]\ntemperature_C = 313\n", at_a_point).err,
              HasSubstr("temperature_C = 313 C: the value is probably in kelvin"));
  EXPECT_THAT(command("solve", model_text, at_a_point + " --temperature 60").err,
              Not(HasSubstr("looks like")));
}

const std::string shaft_text =
    replaced(model_text, "\n[lubricant]",
             "\n[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\nmounting = \"rigid\"\n"
             "preload_N = 600\n\n[lubricant]");

// The fit once ran to preload_N = 1e8, which was written with status 0.
TEST_F(SilentAnswers, CalibrateWritesNoPreloadThatTheDataDoNotHold) {
  const std::string file = model(shaft_text), out = scratch_.file("out.toml");
  const json curve = parsed(run("displacement " + file + " --speed 0:10000:1000 --json"));
  std::string data = "speed_rpm,axial_displacement_um\n";
  int k = 0;
  for (const json& row : curve["rows"])
    data += fmt::format("{},{:.5f}\n", row["speed_rpm"].get<double>(),
                        -row["axial_displacement_um"].get<double>() + 0.001 * (k++ % 3));
  const Result r =
      run("calibrate " + file + " " + scratch_.write("against.csv", data) + " -o " + out);
  EXPECT_EQ(r.status, 2) << r.out;
  EXPECT_THAT(r.err, HasSubstr("these data do not determine preload_N: the fit ends at a bound of "
                               "this parameter, 1e+08 N, so the program keeps it at 600 N"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(SilentAnswers, ALoadDeflectionCurveIsNotTakenForTheKinematicOne) {
  const std::string data = scratch_.write("deflection.csv",
                                          "speed_rpm,axial_load_N,axial_displacement_um\n"
                                          "0,0,0\n0,200,0.7\n0,400,1.3\n0,600,2.0\n");
  for (const char* verb : {"check", "compare"})
    EXPECT_THAT(run(std::string(verb) + " " + model(shaft_text) + " " + data).err,
                HasSubstr("4 rows at standstill with axial loads from 0 to 600 N: "
                          "axial_displacement_um is measured "
                          "from standstill under the same load"))
        << verb;
  const json rows =
      parsed(command("table", shaft_text, "--speed 0 --axial-load 0:600:200 --json"))["rows"];
  EXPECT_NEAR(rows[3]["axial_displacement_um"].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(rows[0]["axial_position_um"].get<double>(), 0.0, 1e-9);
  EXPECT_GT(rows[3]["axial_position_um"], 1.0);
}

TEST_F(SilentAnswers, ASetOnASoftSpringComesFreeAtNoLoad) {
  const std::string spring =
      replaced(shaft_text, "mounting = \"rigid\"", "mounting = \"spring\"\nspring_rate_N_um = 0.5");
  const Result r = command("displacement", spring, "--speed 0,1000");
  EXPECT_THAT(r.out, HasSubstr(", and the rear set at no load"));
  EXPECT_THAT(r.out, Not(HasSubstr("-5")));
}

TEST_F(SilentAnswers, AFormulaIsAnsweredWithWhatToWrite) {
  const auto refused = [&](const std::string& formula, const std::string& more,
                           const std::string& message) {
    expect_refused(command("solve",
                           model_text + "\n[[effect]]\nid = \"mine\"\ntorque_Nmm = \"" + formula +
                               "\"\n" + more,
                           at_a_point),
                   message);
  };
  refused(
      "1,5 * speed_rpm", "",
      "a comma may only separate the arguments of a function; write decimals with a point, 1.5");
  refused("c = 3", "c = 1.0\n", "a formula cannot assign a value with =; write == to compare");
  refused("c * speed_rpm**2", "c = 1.0\n",
          "** is not an operator in formulas; write a power as x^2");
  refused("drag * speed_rpm", "", "give drag = {value = 1.0, unit = \"N mm\"}");
  refused("c * speed_rpm", "c = { value = 1.0, unit = \"Nm\" }\n", "unit = \"Nm\"");
  refused("c * speed_rpm", "c = { value = 1.0, unit = \"N m\" }\n", "The program does not convert");
}

}  // namespace
}  // namespace raceway::tests

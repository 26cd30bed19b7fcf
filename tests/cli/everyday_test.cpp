#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/run_program.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

// Files as a test laboratory writes them, with a known truth (tests/cli/everyday/README.md).
namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

const std::string everyday = tests::source_dir() + "/tests/cli/everyday/";

std::string files_of(const std::string& kind) {
  return everyday + kind + "/model.toml " + everyday + kind + "/train.csv";
}

json diagnosed(const std::string& name, const std::string& flags = "") {
  const Result found = run("diagnose " + files_of(name) + " --json " + flags);
  EXPECT_EQ(found.status, 0) << found.err;
  return json::parse(found.out);
}

TEST(Everyday, RowsOfALoggerAreThoseOfItsStates) {
  const json d = diagnosed("logger-states");
  EXPECT_EQ(d["verdict"], "nothing-missing") << d["sentence"];
  EXPECT_EQ(d["rows"], 36);
  EXPECT_EQ(d["dwells"]["rows"], 1440);
  EXPECT_EQ(d["dwells"]["dwells"], 36);
  EXPECT_THAT(d["dwells"]["averaged"].dump(),
              AllOf(HasSubstr("friction_torque_Nmm"), HasSubstr("temperature_C")));
  EXPECT_THAT(d["notes"].dump(), HasSubstr("1440 rows form 36 dwells"));
  // States are reproducible to 1.5 % and their means to 0.7 % more: 1.65 %, known from some 18
  // degrees of freedom to 17 %.
  EXPECT_NEAR(d["noise"]["relative"].get<double>(), 0.0165, 3 * 0.17 * 0.0165);
}

TEST(Everyday, RowsStayApartWhereThatIsAskedFor) {
  const Result kept = run("calibrate " + files_of("logger-states") + " --rows --json");
  ASSERT_EQ(kept.status, 0) << kept.err;
  const json c = json::parse(kept.out);
  EXPECT_EQ(c["rows"], 1440);
  EXPECT_FALSE(c.contains("dwells"));
  EXPECT_THAT(kept.err, Not(HasSubstr("dwells")));
  EXPECT_THAT(run("calibrate " + files_of("logger-states")).err,
              HasSubstr("1440 rows form 36 dwells"));
}

TEST(Everyday, ADragInTheRowsOfALoggerIsFound) {
  const json d = diagnosed("logger-drag");
  EXPECT_THAT(d["verdict"].get<std::string>(), AnyOf("effect", "ambiguous")) << d["sentence"];
  ASSERT_FALSE(d["effects"].empty());
  EXPECT_THAT(d["effects"][0]["id"].get<std::string>(), AnyOf("lubricant-drag", "windage"));
}

TEST(Everyday, ScatterThatGrowsWithSpeedIsNoEffect) {
  const json d = diagnosed("scatter-with-speed");
  EXPECT_EQ(d["verdict"], "nothing-missing") << d["sentence"];
  // 5 % at the highest speed, known from some 8 rows there.
  EXPECT_NEAR(d["noise"]["relative"].get<double>(), 0.05, 0.025);
  EXPECT_GT(d["noise"]["growth"].get<double>(), 0.3);
  // The rows that scatter most are no outliers; one of 72 may look like one by chance.
  EXPECT_LE(d["outlier_lines"].size(), 1u) << d["outlier_lines"];
}

TEST(Everyday, AnotherBaseLawIsOfferedAndTaken) {
  const ScratchFolder scratch;
  const Result found = run("diagnose --verbose " + files_of("law-skf"));
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(found.out, HasSubstr("law = skf explains these data"));
  EXPECT_THAT(found.out, HasSubstr("use it with: raceway add MODEL law:skf"));
  EXPECT_THAT(found.out, HasSubstr("verdict: not-in-catalogue"));
  EXPECT_THAT(found.out, HasSubstr("verdict with law = skf: nothing-missing"));
  const json d = json::parse(run("diagnose " + files_of("law-skf") + " --json").out);
  EXPECT_EQ(d["other_bases"][0]["id"], "law:skf");
  EXPECT_TRUE(d["other_bases"][0]["explains"]);
  EXPECT_EQ(d["given_other_base"]["verdict"], "nothing-missing");

  const std::string better = scratch.file("skf.toml"), model = everyday + "law-skf/model.toml";
  const Result added =
      run("add " + model + " law:skf --data " + everyday + "law-skf/train.csv -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string text = file_text(better);
  EXPECT_THAT(text, HasSubstr("law = \"skf\""));
  EXPECT_THAT(text, HasSubstr("free = [\"mu_EHL\", \"K_rs\"]"));
  EXPECT_THAT(text, Not(HasSubstr("f0 =")));
  EXPECT_THAT(text, HasSubstr("ball_diameter_mm = 11.906"));

  const json again =
      json::parse(run("diagnose " + better + " " + everyday + "law-skf/train.csv --json").out);
  EXPECT_EQ(again["verdict"], "nothing-missing") << again["sentence"];
  const json ladder = json::parse(
      run("compare " + model + " " + better + " " + everyday + "law-skf/test.csv --json").out);
  EXPECT_LT(ladder["models"][1]["rmse"].get<double>(),
            0.05 * ladder["models"][0]["rmse"].get<double>());
}

TEST(Everyday, AnotherBaseLawIsOfferedWithTheEffectThatItLeaves) {
  const ScratchFolder scratch;
  const std::string model = scratch.file("contact.toml");
  ASSERT_EQ(run("new '7014 AC' --oil 'VG 32' -o " + model).status, 0);
  // Palmgren's law with a drag of 10 %: one effect of the contact law comes nearer than Palmgren's
  // law alone.
  const json d =
      json::parse(run("diagnose --json " + model + " " + everyday + "logger-drag/train.csv").out);
  EXPECT_EQ(d["verdict"], "not-in-catalogue");
  EXPECT_EQ(d["other_bases"][0]["id"], "law:palmgren");
  EXPECT_FALSE(d["other_bases"][0]["explains"]);
  EXPECT_THAT(d["sentence"].get<std::string>(),
              AnyOf(HasSubstr("palmgren the verdict is ambiguous: lubricant-drag or windage"),
                    HasSubstr("palmgren the verdict is ambiguous: windage or lubricant-drag")));
}

TEST(Everyday, CheckFindsTheNoiseThatADiagnosisFinds) {
  for (const std::string name : {"logger-drag", "law-skf"}) {
    const json check = json::parse(run("check --json " + files_of(name)).out);
    const json verdict = json::parse(run("diagnose --json " + files_of(name)).out);
    const double found = verdict["noise"]["rms"].get<double>();
    EXPECT_NEAR(check["noise"]["estimated_rms"].get<double>(), found, 1e-6 * found) << name;
  }
}

TEST(Everyday, TheShapeOfTheSentenceIsWrittenAndTheLoopGoesOn) {
  const ScratchFolder scratch;
  const std::string model = everyday + "law-skf/model.toml", train = everyday + "law-skf/train.csv";
  EXPECT_THAT(run("diagnose --verbose " + model + " " + train).out,
              HasSubstr("raceway add MODEL shape --data DATA adds this law"));
  const std::string better = scratch.file("shape.toml");
  const Result added = run("add " + model + " shape --data " + train + " -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_THAT(file_text(better), HasSubstr("id = \"shape\""));
  EXPECT_THAT(file_text(better), HasSubstr("torque_Nmm = \"c * (speed_rpm / "));
  const json before = json::parse(run("diagnose " + model + " " + train + " --json").out);
  const json after = json::parse(run("diagnose " + better + " " + train + " --json").out);
  EXPECT_LT(after["rmse_before"].get<double>(), 0.2 * before["rmse_before"].get<double>());
}

TEST(Everyday, DegreesFahrenheitAreAskedAboutBeforeTheVerdict) {
  expect_refused(run("diagnose " + files_of("fahrenheit")),
                 "If so, set the unit in [columns]: temperature_C = { column = \"temperature_C\", "
                 "unit = \"F\" }");
}

TEST(Everyday, ReadingsInOurUnitUnderAnotherHeaderAreOfferedOurs) {
  const ScratchFolder scratch;
  const std::string data = scratch.file("d.csv");
  ASSERT_EQ(run_shell("sed '1s/_Nmm/_Nm/' " + everyday + "logger-drag/train.csv >" + data).status,
            0);
  expect_refused(run("check " + everyday + "logger-drag/model.toml " + data),
                 "friction_torque_Nmm = { column = \"friction_torque_Nm\", unit = \"Nmm\" }");
}

TEST(Everyday, TwoOilsOfOneModelAreToldAndHideNoEffect) {
  const std::string both = everyday + "two-oils/model.toml " + everyday + "two-oils/vg32.csv " +
                           everyday + "two-oils/vg68.csv";
  const Result found = run("diagnose " + both + " --per-record f0,z --json");
  ASSERT_EQ(found.status, 0) << found.err;
  const json d = json::parse(found.out);
  EXPECT_THAT(d["verdict"].get<std::string>(), AnyOf("effect", "ambiguous")) << d["sentence"];
  EXPECT_THAT(d["explanations"].dump(), AnyOf(HasSubstr("lubricant-drag"), HasSubstr("windage")));
  EXPECT_THAT(found.err, HasSubstr("check the oil of vg68"));
  const Result fitted =
      run("calibrate " + both + " --per-record f0,z,viscosity-slope.factor_at_100_C --json");
  ASSERT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_THAT(fitted.out, HasSubstr("viscosity-slope.factor_at_100_C@vg68"));
}

}  // namespace
}  // namespace raceway::tests

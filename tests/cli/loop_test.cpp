#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A rig with a known hidden effect: drag of 62.5 N mm at 10 000 rpm.
const std::string rig_folder_of_loop = tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/";

TEST(Loop, NamesTheMissingEffectAndAddsIt) {
  const ScratchFolder scratch;
  const Result found = run("diagnose " + rig_folder_of_loop + "model.toml " + rig_folder_of_loop +
                           "train.csv --json");
  ASSERT_EQ(found.status, 0) << found.err;
  const json d = json::parse(found.out);
  EXPECT_EQ(d["verdict"], "effect");
  EXPECT_EQ(d["effects"][0]["id"], "lubricant-drag");
  EXPECT_TRUE(d["effects"][0]["in_verdict"]);
  for (const char* key : {"sentence", "baseline", "effects", "would_have_been_found",
                          "not_testable", "suggested_measurements"})
    EXPECT_TRUE(d.contains(key)) << key;

  const std::string better = scratch.file("better.toml");
  const Result added = run("add " + rig_folder_of_loop + "model.toml lubricant-drag --data " +
                           rig_folder_of_loop + "train.csv -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string before = file_text(rig_folder_of_loop + "model.toml"),
                    after = file_text(better);
  EXPECT_THAT(after, StartsWith(before.substr(0, before.find('\n'))));
  EXPECT_THAT(after, HasSubstr("id = \"lubricant-drag\""));

  const Result ladder = run("compare " + rig_folder_of_loop + "model.toml " + better + " " +
                            rig_folder_of_loop + "test.csv --json");
  ASSERT_EQ(ladder.status, 0) << ladder.err;
  const json models = json::parse(ladder.out)["models"];
  EXPECT_LT(models[1]["rmse"].get<double>(), 0.25 * models[0]["rmse"].get<double>());
}

/// The model of a given rig whose oil is a guess, 8 % thinner at 100 C than the oil in the bearing.
std::string with_guessed_oil(const std::string& folder) {
  std::string text = file_text(folder + "model.toml");
  const std::string entered = "viscosity_100C_mm2_s = 5.9";
  return text.replace(text.find(entered), entered.size(),
                      "viscosity_100C_mm2_s = 5.4 # assumed: a mineral oil of viscosity index 100");
}

/// A guess of the oil neither hides the effect of dev-03 nor gives dev-04 the name of another one;
/// with 5.4 as a known value it does both.
TEST(Loop, AGuessedOilHidesNoEffect) {
  const ScratchFolder scratch;
  for (const auto& [rig, effect] :
       {std::pair{"dev-03", "lubricant-drag"}, std::pair{"dev-04", "inlet-shear-heating"},
        std::pair{"dev-05", "thermal-preload"}}) {
    const std::string folder = tests::source_dir() + "/tests/hidden_effect/rigs/" + rig + "/";
    const std::string model = scratch.write("guessed.toml", with_guessed_oil(folder));
    const json d = json::parse(run("diagnose " + model + " " + folder + "train.csv --json").out);
    EXPECT_EQ(d["verdict"], "effect") << rig;
    EXPECT_EQ(d["effects"][0]["id"], effect) << rig;
    EXPECT_THAT(d["messages"].dump(), HasSubstr("instead of the entered 5.4; enter the value"))
        << rig;
  }
}

/// The fitted value stands in the new file and stays a guess; a confirmed value stays as it is.
TEST(Loop, AddWritesAGuessedOilAsItWasFitted) {
  const ScratchFolder scratch;
  const std::string guessed = scratch.write("guessed.toml", with_guessed_oil(rig_folder_of_loop));
  const std::string data = rig_folder_of_loop + "train.csv", better = scratch.file("better.toml");
  const Result added = run("add " + guessed + " lubricant-drag --data " + data + " -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string text = file_text(better);
  const std::string key = "viscosity_100C_mm2_s = ";
  EXPECT_NEAR(std::stod(text.substr(text.find(key) + key.size())), 5.9, 0.12);  // two sigma
  EXPECT_THAT(text, HasSubstr("# assumed; corrected by measurements; entered value: 5.4\n"));
  EXPECT_THAT(text, Not(HasSubstr("viscosity-slope")));

  const Result known = run("add " + rig_folder_of_loop + "model.toml lubricant-drag --data " +
                           data + " -o " + scratch.file("known.toml"));
  EXPECT_THAT(file_text(scratch.file("known.toml")), HasSubstr("viscosity_100C_mm2_s = 5.9\n"));
}

/// At one temperature, nothing tells a guess from f0: the guess stays.
TEST(Loop, AGuessThatTheRecordCannotTellStays) {
  const ScratchFolder scratch;
  std::string record = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (const int load : {300, 1000, 3000})
    for (int speed = 1000; speed <= 12000; speed += 1000)
      record += fmt::format("{},{},40,{}\n", speed, load,
                            std::pow(speed, 0.667) * 0.4 + 0.05 * load + speed % 7);
  const std::string model = scratch.write("guessed.toml", with_guessed_oil(rig_folder_of_loop));
  const Result found = run("diagnose " + model + " " + scratch.write("r.csv", record) + " --json");
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(found.out, Not(HasSubstr("viscosity-slope.factor_at_100_C")));
}

/// --force replaces a file, and adds a refused effect, but does not do both at once.
TEST(Loop, ARefusedEffectReplacesNoModel) {
  const ScratchFolder scratch;
  const std::string better = scratch.write("better.toml", "a good model\n");
  const std::string add = "add " + rig_folder_of_loop + "model.toml torque-time-drift --data " +
                          rig_folder_of_loop + "train.csv --force -o ";
  const Result kept = run(add + better);
  EXPECT_EQ(kept.status, 1);
  EXPECT_THAT(kept.err, HasSubstr("is not replaced, because the effect was refused: "));
  EXPECT_EQ(file_text(better), "a good model\n");
  EXPECT_EQ(run(add + scratch.file("new.toml")).status, 0);
}

/// A temperature that is in the file and not in the map is named.
TEST(Loop, AForgottenTemperatureIsNamed) {
  const ScratchFolder scratch;
  std::string record = file_text(rig_folder_of_loop + "train.csv");
  const std::string ours = "temperature_C";
  record.replace(record.find(ours), ours.size(), "Lager [C]");
  const Result found =
      run("diagnose " + rig_folder_of_loop + "model.toml " + scratch.write("train.csv", record));
  EXPECT_THAT(found.err, HasSubstr("the record has the temperature Lager [C]"));
}

/// Lines of a diagnosis in a terminal of 80 columns, without blanks at its end.
std::vector<std::string> on_screen(const std::string& files) {
  const Result r = run_shell("script -qc \"stty cols 80; NO_COLOR=1 $raceway diagnose --quiet " +
                             files + "\" /dev/null");
  std::vector<std::string> lines;
  std::istringstream in(r.out);
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    line.erase(0, line.rfind('\r') + 1);  // behind the progress bar
    lines.push_back(line);
  }
  return lines;
}

TEST(Loop, TheVerdictStandsAtTheEndOfOneScreen) {
  const std::string root = tests::source_dir() + "/";
  for (const std::string files :
       {"tests/hidden_effect/rigs/dev-03", "tests/hidden_effect/rigs/real-03",
        "tests/hidden_effect/rigs/real-04", "tests/cli/everyday/law-skf",
        "data/corrections/ambient"}) {
    SCOPED_TRACE(files);
    const std::string model =
        root + files + (files.starts_with("data/corr") ? "/correction.toml " : "/model.toml ");
    const std::string both = model + root + files + "/train.csv";
    const std::vector<std::string> lines = on_screen(both);
    EXPECT_LE(lines.size(), 20U) << testing::PrintToString(lines);
    EXPECT_GE(lines.size(), 6U) << testing::PrintToString(lines);
    for (const std::string& line : lines) EXPECT_LE(line.size(), 80U) << line;
    const std::string headline = json::parse(run("diagnose --json " + both).out)["headline"];
    std::string all;
    for (const std::string& line : lines) all += (all.empty() ? "" : " ") + line;
    EXPECT_THAT(all, testing::EndsWith(headline));
    EXPECT_THAT(run("diagnose " + both).out, testing::EndsWith("\n" + headline + "\n"));
    EXPECT_THAT(run("diagnose --verbose " + both).out, testing::EndsWith("\n" + headline + "\n"));
  }
}

TEST(Loop, StatesOneNoise) {
  const std::string files =
      rig_folder_of_loop + "model.toml " + rig_folder_of_loop + "train.csv --json";
  const auto answer = [&](const std::string& command) {
    return json::parse(run(command + " " + files).out);
  };
  const double found = answer("diagnose")["noise"]["rms"].get<double>();
  EXPECT_GT(found, 0.0);
  EXPECT_DOUBLE_EQ(answer("check")["noise"]["estimated_rms"].get<double>(), found);
  EXPECT_DOUBLE_EQ(answer("compare")["noise"]["estimated_rms"].get<double>(), found);
}

TEST(Loop, AnswersAnUnknownEffectWithTheNearestAndWritesNothing) {
  const ScratchFolder scratch;
  const Result r = run("add " + rig_folder_of_loop + "model.toml lubricant-drug --data " +
                       rig_folder_of_loop + "train.csv -o " + scratch.file("x.toml"));
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("lubricant-drag"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("x.toml")));
}

TEST(Loop, ExplainsEveryEffectOfTheCatalogue) {
  const Result all = run("effects --json");
  ASSERT_EQ(all.status, 0) << all.err;
  const json list = json::parse(all.out)["effects"];
  EXPECT_GE(list.size(), 29U);
  const Result one = run("effects spin-friction");
  EXPECT_EQ(one.status, 0);
  EXPECT_THAT(one.out, HasSubstr("friction_coefficient"));
  const Result unknown = run("effects spin-frictoin");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("spin-friction"));
}

TEST(Loop, FindsAndAddsAFormulaOfTheUsersOwnWhereItStands) {
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "m.toml", file_text(rig_folder_of_loop + "model.toml") +
                    "\n[[effect]]\nid = \"my-drag\"\ntorque_Nmm = \"c * (speed_rpm/10000)^2\"  "
                    "# mine\nc = { value = 0.0, unit = \"N mm\", lower = 0.0 }\n");
  const Result found = run("diagnose " + model + " " + rig_folder_of_loop + "train.csv --json");
  ASSERT_EQ(found.status, 0) << found.err;
  const json d = json::parse(found.out);
  EXPECT_EQ(d["verdict"], "ambiguous");  // it is lubricant-drag by another name
  const json verdict = d["explanations"];
  EXPECT_NE(std::find(verdict.begin(), verdict.end(), json::array({"my-drag"})), verdict.end());

  const std::string better = scratch.file("better.toml");
  const Result added =
      run("add " + model + " my-drag --data " + rig_folder_of_loop + "train.csv -o " + better);
  ASSERT_EQ(added.status, 0) << added.err;
  const std::string text = file_text(better);
  EXPECT_THAT(text, HasSubstr("(speed_rpm/10000)^2\"  # mine"));
  EXPECT_THAT(text, Not(HasSubstr("value = 0.0")));
  EXPECT_EQ(text.find("id = \"my-drag\""), text.rfind("id = \"my-drag\""));
}

TEST(Loop, RefusesAnEffectThatImitatesTheMissingOne) {
  const ScratchFolder scratch;
  const Result r = run("add " + rig_folder_of_loop + "model.toml spin-friction --data " +
                       rig_folder_of_loop + "train.csv -o " + scratch.file("x.toml"));
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("lubricant-drag explains these data down to the noise"));
  EXPECT_FALSE(std::filesystem::exists(scratch.file("x.toml")));
}

TEST(Loop, RefitsWhatDiffersFromDayToDayBeforeComparing) {
  const Result as_it_stands =
      run("compare " + rig_folder_of_loop + "model.toml " + rig_folder_of_loop + "test.csv --json");
  const Result refitted = run("compare --refit f0,z " + rig_folder_of_loop + "model.toml " +
                              rig_folder_of_loop + "test.csv --json");
  ASSERT_EQ(refitted.status, 0) << refitted.err;
  EXPECT_LT(json::parse(refitted.out)["rmse"].get<double>(),
            0.8 * json::parse(as_it_stands.out)["rmse"].get<double>());
  EXPECT_THAT(refitted.err, HasSubstr("f0 and z are refitted to"));
  const Result unknown = run("compare --refit f1 " + rig_folder_of_loop + "model.toml " +
                             rig_folder_of_loop + "test.csv");
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.err, HasSubstr("nearest: f0"));
}

/// Rows of the rig's plan with another torque.
std::string rows(const std::function<std::string(int)>& row, int count) {
  std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (int i = 0; i < count; ++i) text += row(i) + "\n";
  return text;
}

TEST(Loop, GivesNoVerdictWhereTheDataCannotCarryOne) {
  const ScratchFolder scratch;
  const auto message = [&](const std::string& data) {
    const Result r =
        run("diagnose " + rig_folder_of_loop + "model.toml " + scratch.write("d.csv", data));
    EXPECT_EQ(r.status, 1) << data;
    EXPECT_EQ(r.out, "");
    return r.err;
  };
  const auto speed = [](int i) { return std::to_string(1000 + 500 * i); };
  const auto torque = [](int i) { return std::to_string(200 + 7 * i + i * i % 5); };
  EXPECT_THAT(message(rows([&](int i) { return speed(i) + ",600,40," + torque(i); }, 8)),
              testing::AllOf(HasSubstr("needs at least 15"), HasSubstr("or at least 8"),
                             HasSubstr("(std_Nmm)")));
  EXPECT_THAT(message(rows([&](int i) { return "5000,600,40," + torque(i); }, 30)),
              HasSubstr("one operating point"));
  EXPECT_THAT(message(rows([&](int i) { return speed(i % 2) + ",600,40," + torque(i); }, 30)),
              HasSubstr("three levels"));
  EXPECT_THAT(message(rows([&](int i) { return speed(i) + ",600,40,100"; }, 30)),
              HasSubstr("all readings are 100 N mm"));
}

TEST(Loop, ShowsWhereAFormulaIsWrong) {
  const ScratchFolder scratch;
  const std::string model =
      scratch.write("m.toml", file_text(rig_folder_of_loop + "model.toml") +
                                  "\n[[effect]]\nid = \"mine\"\ntorque_Nmm = \"c * sped_rpm\"\n"
                                  "c = { value = 0.0, unit = \"N mm\" }\n");
  const Result r = run("compare " + model + " " + rig_folder_of_loop + "train.csv");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("did you mean speed_rpm?"));
}

}  // namespace
}  // namespace raceway::tests

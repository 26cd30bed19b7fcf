#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const char* const commands[] = {
    "solve",    "table", "displacement", "fit-law",       "calibrate",   "compare",
    "diagnose", "add",   "effects",      "bearings",      "new",         "check",
    "export",   "keys",  "join",         "step-response", "sensitivity", "workbench"};

TEST(CommandLine, TellsItsVersion) {
  const Result r = run("--version");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("raceway 0.2.0"));
}

TEST(CommandLine, ShowsItsHelpWhenNothingIsAsked) {
  const Result r = run("");
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(r.out, "");
  for (const std::string command : commands) EXPECT_THAT(r.err, HasSubstr("\n  " + command + " "));
  EXPECT_EQ(run("--help").out, r.err);
  EXPECT_EQ(run("help").out, r.err);
}

TEST(CommandLine, HelpStartsWithWhatMostPeopleNeed) {
  const std::string help = run("help").out;
  std::size_t before = 0;
  for (const char* group :
       {"\nMeasure and model:\n  new ", "\nBearing:\n  solve ", "\nMachine:\n  identify ",
        "\nSensors:\n", "\nUnderstand:\n", "\nLook up:\n", "\nShaft and spindle:\n"}) {
    const std::size_t at = help.find(group);
    ASSERT_NE(at, std::string::npos) << group;
    EXPECT_GT(at, before) << group;
    before = at;
  }
  EXPECT_THAT(help, Not(HasSubstr("describe")));
}

TEST(CommandLine, AFileAsCommandIsToldHowToStart) {
  const ScratchFolder scratch;
  expect_refused(run("data.csv"), "raceway: data.csv is a file; give a command first.");
  expect_refused(run("data.csv"), "  raceway diagnose my.toml data.csv\n");
  expect_refused(run("my.toml --json"), "raceway check my.toml\n");
  const std::string plain = scratch.write("record", "1 2\n");
  expect_refused(run(plain), "is a file; give a command first.");
}

TEST(CommandLine, HelpOfEveryCommandHasAnExample) {
  for (const std::string command : commands) {
    const Result r = run(command + " --help");
    EXPECT_EQ(r.status, 0) << command;
    EXPECT_EQ(r.err, "") << command;
    EXPECT_THAT(r.out, HasSubstr("Usage: raceway " + command));
    EXPECT_THAT(r.out, HasSubstr("Example:\n  raceway " + command));
    // Types of the implementation are no help.
    EXPECT_THAT(r.out, Not(testing::AnyOf(HasSubstr("TEXT"), HasSubstr("FLOAT"))));
  }
}

TEST(CommandLine, HelpLinesFitAHundredColumns) {
  for (const std::string command : commands) {
    std::istringstream lines(run(command + " --help").out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  }
}

TEST(CommandLine, AnswersAMisspeltCommandWithTheNearest) {
  expect_refused(run("sovle my.toml"), "raceway: sovle: no such command; did you mean solve?\n");
  expect_refused(run("calibrat a b"), "did you mean calibrate?");
  expect_refused(run("frobnicate"), "raceway: frobnicate: no such command\n");
}

TEST(CommandLine, AnswersAMisspeltFlagWithTheNearest) {
  const std::string place = "raceway solve: ";
  expect_refused(
      run("solve m.toml --sped 100"),
      place + "--sped: no such flag; did you mean --speed?\nTry raceway solve --help.\n");
  expect_refused(run("solve m.toml --speed=100 --load 5"), "did you mean --axial-load?");
  expect_refused(run("solve m.toml --speed 100 --axial_load_N 5"), "did you mean --axial-load?");
  expect_refused(run("solve m.toml --speed 100 --temp 5"), "did you mean --temperature?");
  expect_refused(run("solve m.toml --speed 100 -x"), place + "-x: no such flag\n");
  expect_refused(run("--jsn"), "raceway: --jsn: no such flag\n");
}

TEST(CommandLine, TellsWhatIsMissingOrTooMuch) {
  expect_refused(run("solve"), "raceway solve: MODEL is required\n");
  expect_refused(run("solve m.toml"), "raceway solve: --speed is required\n");
  expect_refused(run("solve m.toml --speed"), "raceway solve: --speed: its value is missing\n");
  expect_refused(run("solve m.toml --speed --json"), "--speed: its value is missing\n");
  expect_refused(run("new \"S 6014 C\" -o \"\""), "raceway new: -o: its value is missing\n");
  expect_refused(run("new \"S 6014 C\" --output="), "--output: its value is missing\n");
  expect_refused(run("solve m.toml --speed 1 --speed 2"), "--speed is given twice\n");
  expect_refused(run("solve m.toml n.toml --speed 1"),
                 "was not expected: n.toml (write a name with blanks in quotes");
  expect_refused(run("calibrate"), "raceway calibrate: MODEL is required\n");
  expect_refused(run("calibrate m.toml"), "m.toml: no such file");
  expect_refused(run("compare m.toml"), "raceway compare: DATA is missing");
  expect_refused(run("compare"), "raceway compare: DATA is missing");
}

TEST(CommandLine, FlagsOfARecordNeedOne) {
  for (const auto& [flag, name] : {std::pair{"--drop-nan", "--drop-nan"},
                                   {"--columns map.toml", "--columns"},
                                   {"--beside b.csv", "--beside"},
                                   {"-o rows.csv", "--output"}})
    expect_refused(run(fmt::format("check my.toml {}", flag)),
                   fmt::format("{} requires DATA", name));
}

TEST(CommandLine, EndsQuietlyWhereTheReaderOfAPipeHasEnough) {
  const Result r = run_shell("$raceway bearings | head -1");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, StartsWith("bearing"));
  EXPECT_EQ(r.err, "");
}

TEST(CommandLine, ReportsAStdoutThatTakesNothing) {
  const Result closed = run_shell("$raceway bearings >&-");
  EXPECT_EQ(closed.status, 1);
  EXPECT_THAT(closed.err, HasSubstr("raceway: "));
  const Result full = run_shell("$raceway bearings >/dev/full");
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("No space left"));
}

TEST(Bearings, AreFoundByPartOfTheirName) {
  const Result r = run("bearings \"s 6014\"");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("GMN S 6014 C TA    70    110     90     21  11.906     15"));
  const json all = parsed(run("bearings --json"))["bearings"];
  EXPECT_GE(all.size(), 60U);
  EXPECT_EQ(keys(all[0]), keys(json{{"name", 0},
                                    {"bore_mm", 0},
                                    {"outer_diameter_mm", 0},
                                    {"pitch_diameter_mm", 0},
                                    {"ball_diameter_mm", 0},
                                    {"ball_count", 0},
                                    {"contact_angle_deg", 0},
                                    {"static_load_rating_N", 0}}));
}

TEST(Bearings, ThatDoNotExistAreWrongInput) {
  expect_refused(run("bearings 9999"), "no bearing has \"9999\" in its name");
  expect_refused(run("new \"S 6041 C\""),
                 "bearing \"S 6041 C\" is not in the catalogue; similar designations: ");
}

TEST(New, WritesAModelThatEveryCommandTakes) {
  const ScratchFolder scratch;
  for (const std::string law : {"palmgren", "skf"}) {
    const std::string model = scratch.file(law + ".toml");
    const Result written = run("new \"S 6014 C\" --law " + law + " -o " + model);
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.out, "");
    EXPECT_EQ(written.err, model + " written\n");
    const Result r = run("solve " + model + " --speed 10000 --axial-load 600");
    EXPECT_EQ(r.status, 0);
    EXPECT_EQ(r.err, "note: 4 assumptions; raceway check " + model + " lists them\n");
    // Every default stands in the file. Its comments mark what is assumed.
    const json assumed = parsed(run("check " + model + " --json"))["defaults"];
    EXPECT_EQ(assumed.size(), 4U) << assumed;
    for (const json& one : assumed) EXPECT_THAT(one.get<std::string>(), HasSubstr("assumed"));
  }
  const std::string model = scratch.file("contact.toml");
  EXPECT_EQ(run("new \"S 6014 C\" -o " + model).status, 0);
  // Values that follow from the type of the oil are remarks in the file, and `check` lists them.
  const json defaults = parsed(run("check " + model + " --json"))["defaults"];
  const auto by_oil = [](const json& one) {
    return one.get<std::string>().find("assumed") == std::string::npos;
  };
  EXPECT_EQ(std::count_if(defaults.begin(), defaults.end(), by_oil), 5) << defaults;
  for (const json& d : defaults)
    EXPECT_TRUE(!by_oil(d) || d.get<std::string>().starts_with("lubricant.")) << d;
  EXPECT_EQ(run("solve " + model + " --speed 10000 --axial-load 600").status, 0);
  EXPECT_EQ(run("new \"S 6014 C\"").out, file_text(model));
  EXPECT_EQ(run("new \"S 6014 C\" -o -").out, file_text(model));
}

TEST(New, NeverOverwritesWithoutForce) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("my.toml", "mine");
  expect_refused(run("new \"S 6014 C\" -o " + model), "exists already; --force replaces it");
  EXPECT_EQ(file_text(model), "mine");
  EXPECT_EQ(run("new \"S 6014 C\" --force -o " + model).status, 0);
  EXPECT_THAT(file_text(model), HasSubstr("ball_count = 21"));
}

TEST(New, RefusesPlacesThatCannotBeWritten) {
  const ScratchFolder scratch;
  const std::string folder = scratch.path().string();
  expect_refused(run("new \"S 6014 C\" -o " + folder), folder + ": is a directory");
  expect_refused(run("new \"S 6014 C\" -o " + folder + "/none/my.toml"),
                 ": cannot be written: this folder does not exist:");
  expect_refused(run("new \"S 6014 C\" -o /dev/full"), "/dev/full: cannot be written");
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

}  // namespace
}  // namespace raceway::tests

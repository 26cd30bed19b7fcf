#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "cli/progress.h"
#include "cli/text_table.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A folder with a model, data for it, and files that are wrong.
struct Files : ScratchFolder {
  std::string model = write("m.toml", model_text);
  std::string data = write("rig.csv", data_text);
};

TEST(Messages, DefaultsAreOneShortNoteAndCheckListsThem) {
  const Files files;
  for (const std::string& rest : {"solve " + files.model + " --speed 1000 --axial-load 100",
                                  "table " + files.model + " --speed 1000 --axial-load 100",
                                  "compare " + files.model + " " + files.data}) {
    const Result r = run(rest);
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_THAT(r.err, testing::ContainsRegex("note: [0-9]+ assumptions; raceway check "));
    EXPECT_THAT(r.err, Not(HasSubstr("race_control")));
  }
  const Result listed = run("check " + files.model);
  EXPECT_EQ(listed.status, 0);
  EXPECT_EQ(listed.err, "");
  EXPECT_THAT(listed.out, testing::AllOf(HasSubstr("friction.law = \"palmgren\""),
                                         HasSubstr("solver.tilt = \"locked\"")));
  EXPECT_THAT(run("check " + files.model + " " + files.data).out,
              HasSubstr("solver.tilt = \"locked\""));
  const json document = parsed(run("check " + files.model + " --json"));
  EXPECT_EQ(keys(document),
            keys(json{{"format", 1}, {"model", 0}, {"defaults", 0}, {"notes", 0}, {"said", 0}}));
  EXPECT_FALSE(document["defaults"].empty());
}

TEST(Messages, AreBrokenBetweenWordsAtTheWidthOfATerminal) {
  const Files files;
  const std::string wrong = "solve " + files.model + " --speed 1000 --axial-load 1e9";
  const std::string message = run(wrong).err;
  ASSERT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << "in a file: one line";
  std::istringstream lines(
      run_shell("script -qc \"stty cols 40; $raceway " + wrong + "\" /dev/null").out);
  std::string again;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    EXPECT_TRUE(line.size() <= 40 || line.find(' ', 2) == line.npos) << line;
    again += (again.empty() ? "" : " ") + line.substr(again.empty() ? 0 : 2);
  }
  EXPECT_EQ(again + '\n', message);
}

TEST(Messages, QuietLeavesErrorsAlone) {
  const Files files;
  const std::string solve = "solve " + files.model + " --speed 1000 --axial-load 100";
  EXPECT_THAT(run(solve).err, testing::AllOf(HasSubstr("note: "), HasSubstr("warning: ")));
  const Result quiet = run(solve + " --quiet");
  EXPECT_EQ(quiet.err, "");
  EXPECT_EQ(quiet.out, run(solve).out);
  const Result written = run("new \"S 6014 C\" --quiet -o " + files.file("new.toml"));
  EXPECT_EQ(written.status, 0);
  EXPECT_EQ(written.err, "");
  const std::string loose = files.write("loose.toml", model_text + spin_effect + inner_control);
  const std::string table = "table " + loose + " --speed 0,60000 --axial-load 10";
  EXPECT_THAT(run(table).err, HasSubstr("warning: 1 of 2 points have no value"));
  const Result warned = run(table + " --quiet");
  EXPECT_EQ(warned.status, 2);
  EXPECT_EQ(warned.err, "");
  expect_refused(run("solve none.toml --speed 1 --quiet"), "none.toml: no such file\n");
}

struct Wrong {
  std::string arguments;
  json file, line, key;
};

TEST(Messages, OfOneKindAtMostThreeArePrinted) {
  const ScratchFolder scratch;
  const std::string spindle = tests::source_dir() + "/data/measurements/spindle_thermal/";
  const std::string bank = scratch.file("bank.toml");
  const std::string bare = spindle + "bare3.toml ", record = spindle + "record.csv ";
  ASSERT_EQ(run("identify " + bare + record + "--lags auto --until 26h -o " + bank).status, 0);
  const std::string compare = "compare " + bank + " " + record + "--from 26h --zero none";
  const Result r = run(compare);
  std::size_t warnings = 0;
  for (std::size_t at = 0; (at = r.err.find("warning: ", at)) != std::string::npos; ++at)
    ++warnings;
  EXPECT_EQ(warnings, 4U) << r.err;
  EXPECT_THAT(r.err, testing::ContainsRegex("warning: number of further messages with the code .*: "
                                            "[0-9]+; --json shows all messages"));
  EXPECT_GT(parsed(run(compare + " --json"))["beyond_range"].size(), 6U);
}

TEST(Messages, JsonErrorsSayWhere) {
  const Files files;
  const std::string at = " --speed 1000 --axial-load 100";
  const std::string balls =
      files.write("balls.toml", replaced(model_text, "ball_count = 20", "ball_count = 2"));
  const std::string key = files.write("key.toml", replaced(model_text, "f0 = ", "fo = "));
  const std::string toml = files.write("toml.toml", "[bearing]\nname = \n");
  const std::string cell = files.write("cell.csv", replaced(data_text, ",92", ",n/a"));
  const std::string column =
      files.write("column.csv", replaced(data_text, "speed_rpm", "sped_rpm"));
  // A map that names no column of the data, two of one quantity, a unit of another kind.
  const auto map = [&](const std::string& name, const std::string& text) {
    return files.write(name, "[columns]\n" + text);
  };
  const std::string absent = map("absent.toml", "radial_load_N = \"n\"\n");
  const std::string twice = map("twice.toml", "speed_rpm = \"a\"\nspeed_1_s = \"b\"\n");
  const std::string unit = map("unit.toml", "axial_load_N = { column = \"F\", unit = \"mm\" }\n");
  const std::string other = files.write("other.toml", "[columns]\n[rig]\n");
  const std::string mapped = "check " + files.model + " " + files.data + " --columns ";
  const std::string few = files.write("few.toml", "[bearing]\nball_count = 20\n");
  const std::string dots = files.write("dots.toml", "\na.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r = 1\n");
  const std::string bell = files.write("bell.csv", replaced(data_text, ",92", ",\a92"));
  const json none;
  for (const Wrong& w : std::vector<Wrong>{
           {"solve " + balls + at, balls, 3, "ball_count"},
           {"solve " + key + at, key, 16, "fo"},
           {"solve " + toml + at, toml, 2, none},
           {"solve " + files.file("none.toml") + at, files.file("none.toml"), none, none},
           {"compare " + files.model + " " + cell, cell, 2, "friction_torque_Nmm"},
           {"check " + files.model + " " + column, column, 1, "sped_rpm"},
           {mapped + absent, files.data, 1, "n"},
           {mapped + twice, twice, 3, "speed_1_s"},
           {mapped + unit, unit, 2, "axial_load_N"},
           {mapped + other, other, 2, "rig"},
           {"check " + few, few, 1, "ball_diameter_mm"},
           {"check " + dots, dots, 2, none},
           {"check " + files.model + " " + bell, bell, 2, none},
           {"solve " + files.model + " --speed 1,5 --axial-load 100", none, none, "--speed"},
           {"diagnose " + files.model + " " + files.file("none.csv"), files.file("none.csv"), none,
            none},
           {"calibrate " + files.model + " " + cell, cell, 2, "friction_torque_Nmm"},
           {"add " + files.model + " windage --data " + cell, cell, 2, "friction_torque_Nmm"},
           {"table " + files.model + " --speed 1:2 --axial-load 1", none, none, "--speed"},
           {"displacement " + files.model + " --speed 1", files.model, none, "arrangement"},
           {"fit-law " + files.file("none.csv"), files.file("none.csv"), none, none},
           {"effects frobnicate", none, none, "ID"},
           {"bearings frobnicate", none, none, "FILTER"},
           {"solve " + files.model, none, none, "--speed"},
           {"solve " + files.model + " --sped 1", none, none, "--sped"},
           {"new nothing", none, none, "--json"},
           {"table --merge nothing", none, none, none},
           {"sovle", none, none, "sovle"}}) {
    SCOPED_TRACE(w.arguments);
    const Result r = run(w.arguments + " --json");
    EXPECT_EQ(r.status, 1);
    const json document = parsed(r);
    ASSERT_EQ(keys(document), (std::set<std::string>{"format", "error"}));
    const json& error = document["error"];
    EXPECT_EQ(error["file"], w.file);
    EXPECT_EQ(error["line"], w.line);
    EXPECT_EQ(error["key"], w.key);
    EXPECT_THAT(r.err, testing::EndsWith(error["message"].get<std::string>() + "\n"));
    EXPECT_EQ(run(w.arguments).out, "") << "without --json stdout is empty";
  }
}

TEST(Messages, AnErrorBehindTheResultLeavesOneDocument) {
  const Files files;
  const Result r =
      run("table " + files.model + " --speed 1000 --axial-load 100 --json --report /dev/full");
  if (!has_reports()) GTEST_SKIP();
  EXPECT_EQ(r.status, 1);
  EXPECT_EQ(keys(parsed(r)), (std::set<std::string>{"format", "error"}));
}

TEST(StandardInput, StandsForEveryFileThatIsRead) {
  const Files files;
  const auto same = [&](const std::string& piped, const std::string& file, const std::string& a,
                        const std::string& b) {
    const Result named = run(a + file + b),
                 through = run_shell("cat " + file + " | $raceway " + a + piped + b);
    EXPECT_EQ(through.status, 0) << a << b << through.err;
    // The program suggests no next step for standard input, because it cannot be read twice.
    std::string out = named.out.substr(0, named.out.find("\nnext step: "));
    for (std::size_t at = 0; (at = out.find(file)) != out.npos;)
      out.replace(at, file.size(), "standard input");
    EXPECT_EQ(through.out, out) << a << b;
  };
  same("-", files.model, "solve ", " --speed 1000 --axial-load 100");
  same("-", files.model, "table ", " --speed 1000 --axial-load 100");
  same("-", files.model, "check ", "");
  same("-", files.data, "check " + files.model + " ", "");
  same("-", files.model, "compare ", " " + files.data);
  same("-", files.data, "compare " + files.model + " ", "");
  same("-", files.data, "calibrate " + files.model + " ", "");
  const std::string rig = tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/";
  same("-", rig + "train.csv", "diagnose " + rig + "model.toml ", " --no-pairs");
  same("-", rig + "train.csv", "add " + rig + "model.toml windage --force --data ", "");
}

TEST(StandardInput, IsReadOnce) {
  const Files files;
  expect_refused(
      run_shell("$raceway check - - <" + files.model),
      "-: standard input can be used for one input only; name a file for the other input\n");
}

TEST(Help, OfACommandIsThatOfItsFlag) {
  EXPECT_EQ(run("help solve").out, run("solve --help").out);
  EXPECT_THAT(run("help solve").out, HasSubstr("--speed"));
  expect_refused(run("help slove"), "slove: no such command; did you mean solve?");
}

/// Longest line above the notes and the examples of a help, in a terminal of so many columns.
std::size_t widest_line_of_help(const std::string& command, int columns) {
  const Result r = run_shell("script -qc \"stty cols " + std::to_string(columns) +
                             "; $raceway help " + command + "\" /dev/null");
  EXPECT_THAT(r.out, HasSubstr("Options:"));
  std::istringstream lines(r.out.substr(0, r.out.find("Example")));
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    widest = std::max(widest, line.size());
  }
  return widest;
}

TEST(Help, WrapsAtTheWidthOfTheTerminal) {
  for (const std::string command : {"table", "identify", "export", "new"}) {
    EXPECT_LE(widest_line_of_help(command, 60), 60U) << command;
    EXPECT_LE(widest_line_of_help(command, 80), 80U) << command;
    EXPECT_GT(widest_line_of_help(command, 130), 80U) << command;
    EXPECT_LE(widest_line_of_help(command, 130), 100U) << command;
  }
}

TEST(Effects, AreSearchedByTheirTexts) {
  EXPECT_EQ(run("effects windage").out, run("effects windag").out) << "the only one";
  const Result several = run("effects AIR");
  EXPECT_EQ(several.status, 0);
  EXPECT_THAT(several.out, HasSubstr("windage"));
  const json all = parsed(run("effects lubricant --json"));
  EXPECT_GT(all["effects"].size(), 3u);
  EXPECT_LT(all["effects"].size(), parsed(run("effects --json"))["effects"].size());
  expect_refused(run("effects frobnicate"), "unknown effect; raceway effects lists all effects");
}

TEST(Progress, SaysHowLongItWillTake) {
  EXPECT_EQ(cli::progress_line(0.25, 10.0, "writing", 79),
            "[##########..............................]  25 %  30 s left  writing");
  EXPECT_EQ(cli::progress_line(0.5, 600.0, "", 79),
            "[####################....................]  50 %  10 min left");
  EXPECT_THAT(cli::progress_line(0.01, 60.0, "", 79), Not(HasSubstr("left"))) << "too early";
}

TEST(Progress, IsHundredPercentOnlyAtItsEnd) {
  EXPECT_THAT(cli::progress_line(0.9999, 1.0, "", 79), HasSubstr(" 99 %"));
  EXPECT_THAT(cli::progress_line(1.0, 1.0, "", 79), HasSubstr("#] 100 %"));
}

TEST(Progress, FitsANarrowTerminal) {
  for (const std::size_t width : {20U, 30U, 40U, 60U})
    EXPECT_LE(cli::progress_line(0.5, 60.0, "pairs of effects", width).size(), width);
}

TEST(NarrowTerminal, WordsOfTheLastColumnAreFilledIntoItsWidth) {
  cli::TextTable table({{"effect", "", true}, {"what it is", "", true, true}});
  table.add({"windage", "friction of the air about all that turns"});
  table.add({"churning", "oil"});
  EXPECT_EQ(table.text(34),
            "effect    what it is\n"
            "windage   friction of the air\n"
            "          about all that turns\n"
            "churning  oil\n");
  EXPECT_EQ(table.text(80),
            "effect    what it is\n"
            "windage   friction of the air about all that turns\n"
            "churning  oil\n");
}

TEST(NarrowTerminal, TheListOfEffectsFitsEightyColumns) {
  std::istringstream lines(run("effects").out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace raceway::tests

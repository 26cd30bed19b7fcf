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
using testing::StartsWith;

class Table : public testing::Test {
 protected:
  [[nodiscard]] Result table(const std::string& flags,
                             const std::string& model = model_text) const {
    return run("table " + scratch_.write("my.toml", model) + " " + flags);
  }
  ScratchFolder scratch_;
};

/// Lines that are neither comment nor header.
std::vector<std::string> rows(const std::string& csv) {
  std::vector<std::string> result;
  std::istringstream lines(csv);
  bool header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    if (!std::exchange(header, false)) result.push_back(line);
  }
  return result;
}

TEST_F(Table, ShowsSpeedDownAndLoadAcross) {
  const Result r = table("--speed 0:12000:4000 --axial-load 100,900");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, StartsWith("Friction torque [N mm] of 7014\n"));
  EXPECT_THAT(r.out, HasSubstr("speed  100 N  900 N\n  rpm   N mm   N mm\n    0"));
  EXPECT_THAT(r.out, HasSubstr("\n12000  "));
}

TEST_F(Table, WritesTheModelItCameFromAndEveryPointOfFourAxes) {
  const std::string file = scratch_.file("t.csv");
  const Result r = table(
      "--speed 0:8000:2000 --axial-load 100,900 --radial-load 0,50 --temperature 20,40,60 -o " +
          file,
      model_text + spin_effect);
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(r.out, "");
  EXPECT_THAT(r.err, HasSubstr(file + " written, 60 points\n"));
  const std::string csv = file_text(file);
  EXPECT_THAT(csv, StartsWith("# Stribeck table: 7014\n"));
  EXPECT_THAT(csv, HasSubstr("\n#| [bearing]\n#| name = \"7014\"\n"));
  EXPECT_THAT(csv, HasSubstr("\nspeed_rpm,axial_load_N,radial_load_N,temperature_C,"
                             "friction_torque_Nmm,load_Nmm,viscous_Nmm,spin-friction_Nmm,"
                             "power_loss_W,"));
  const auto points = rows(csv);
  ASSERT_EQ(points.size(), 60U);
  EXPECT_THAT(points[1], StartsWith("2000,100,0,20,"));
  EXPECT_THAT(points.back(), StartsWith("8000,900,50,60,"));
}

TEST_F(Table, OnStdoutIsTheFile) {
  const std::string file = scratch_.file("t.csv");
  const std::string axes = "--speed 0,1000 --axial-load 100 -o ";
  EXPECT_EQ(table(axes + file).status, 0);
  EXPECT_EQ(table(axes + "-").out, file_text(file));
  expect_refused(table(axes + "- --json"), "both --json and \"--output -\" write to stdout");
}

TEST_F(Table, JsonHasTheUnitsOfTheFile) {
  const json d = parsed(table("--speed 0:6000:3000 --axial-load 100 --json"));
  ASSERT_EQ(d["rows"].size(), 3U);
  EXPECT_THAT(keys(d["rows"][2]),
              IsSupersetOf({"speed_rpm", "axial_load_N", "radial_load_N", "temperature_C",
                            "friction_torque_Nmm", "load_Nmm", "viscous_Nmm", "status"}));
  EXPECT_EQ(d["rows"][2]["speed_rpm"], 6000.0);
  const json solved =
      parsed(run("solve " + scratch_.file("my.toml") + " --speed 6000 --axial-load 100 --json"));
  EXPECT_NEAR(d["rows"][2]["friction_torque_Nmm"].get<double>(),
              solved["friction_torque_Nmm"].get<double>(), 1e-10);
}

TEST_F(Table, LeavesPointsWithoutBalanceEmptyWhereAnEffectNeedsIt) {
  const std::string axes = "--speed 0,20000 --axial-load 5,500 ";
  const Result r = table(axes + "--json", model_text + inner_control + spin_effect);
  EXPECT_EQ(r.status, 2);
  EXPECT_THAT(r.err,
              HasSubstr("points have no value: no_equilibrium; the first is at 20000 rpm, 5 N"));
  const json point = parsed(r)["rows"][1];
  EXPECT_EQ(point["status"], "no_equilibrium");
  EXPECT_TRUE(point["friction_torque_Nmm"].is_null());
  EXPECT_TRUE(point["inner_contact_angle_min_deg"].is_null());
  const Result csv = table(axes + "-o -", model_text + inner_control + spin_effect);
  EXPECT_EQ(csv.status, 2);
  EXPECT_THAT(csv.out, HasSubstr("\n20000,5,0,40,,,,,,,,,,,,,,,no_equilibrium\n"));
}

TEST_F(Table, OfALawThatNeedsNoBalanceHasATorqueEverywhere) {
  const Result r = table("--speed 0,20000 --axial-load 5 --json", model_text + inner_control);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(
      r.err,
      HasSubstr("1 of 2 points have no equilibrium (the friction torque does not depend on it): "));
  const json point = parsed(r)["rows"][1];
  EXPECT_TRUE(point["friction_torque_Nmm"].is_number());
  EXPECT_EQ(point["status"], "no_equilibrium");
  EXPECT_TRUE(point["inner_contact_angle_min_deg"].is_null());
}

TEST_F(Table, OfManyPointsHasNoProgressBarInAPipe) {
  const Result r = table("--speed 1:20000:1 --axial-load 100 -o -");
  EXPECT_EQ(r.status, 0);
  EXPECT_EQ(rows(r.out).size(), 20000U);
  EXPECT_THAT(r.err, Not(HasSubstr("%")));
}

TEST_F(Table, NeverOverwritesWithoutForce) {
  const std::string file = scratch_.write("t.csv", "mine");
  const std::string flags = "--speed 0 --axial-load 100 -o " + file;
  expect_refused(table(flags), file + ": exists already; --force replaces it");
  EXPECT_EQ(file_text(file), "mine");
  EXPECT_EQ(table(flags + " --force").status, 0);
  EXPECT_THAT(file_text(file), StartsWith("# Stribeck table"));
}

TEST_F(Table, RefusesAxesThatAreNone) {
  const std::string out = " -o " + scratch_.file("t.csv");
  const auto refused = [&](const std::string& flags, const std::string& message) {
    expect_refused(table(flags + out), message);
  };
  refused("--speed 9:0:1 --axial-load 1", "--speed: \"9:0:1\": the end of a range");
  refused("--speed 0:9:0 --axial-load 1", "--speed: \"0:9:0\": the end of a range");
  refused("--speed 0:9 --axial-load 1", "--speed: \"0:9\": write a range as from:to:step");
  refused("--speed 1,a --axial-load 1", "--speed: \"a\" is not a number");
  refused("--speed 0:nan:1 --axial-load 1", "--speed: \"nan\" is not a finite number");
  refused("--speed 1,1 --axial-load 1", "--speed: \"1,1\": the values must be in ascending order");
  refused("--speed -1,0 --axial-load 1", "--speed = -1 rpm: must be from 0 to 1000000 rpm");
  refused("--speed 1 --axial-load -1", "--axial-load = -1 N: must be from 0 to 100000000 N");
  refused("--speed 1 --axial-load 1 --temperature 900", "must be from -100 to 400 C");
  refused("--speed 0:1e6:0.01 --axial-load 1", "more than ten million values");
  refused("--speed 1", "--axial-load is missing");
  EXPECT_FALSE(std::filesystem::exists(scratch_.file("t.csv")));
}

TEST_F(Table, FitsANarrowTerminal) {
  // A terminal needs `script`; where there is none the width cannot be set.
  if (run_shell("command -v script").status != 0) GTEST_SKIP();
  const std::string model = scratch_.write("my.toml", model_text);
  const Result r =
      run_shell("script -qc \"stty cols 40; $raceway table " + model +
                " --speed 0,9000 --axial-load 1,2,3,4,5,6,7,8 2>/dev/null\" /dev/null");
  std::istringstream lines(r.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 50U) << line;
  EXPECT_THAT(r.out, HasSubstr("8 N"));
}

/// Twelve points of a table whose slabs are made one by one.
class Slabs : public Table {
 protected:
  const std::string axes = "--speed 0:8000:2000 --axial-load 100,900 --radial-load 0,50";
  [[nodiscard]] std::string slab(const std::string& part, const std::string& name,
                                 const std::string& flags) const {
    const std::string file = scratch_.file(name);
    EXPECT_EQ(table(flags + " --slab " + part + " -o " + file).status, 0);
    return file;
  }
  [[nodiscard]] std::string merge_refusal(const std::string& files) const {
    const Result r = run("table --merge " + files + " -o " + scratch_.file("refused.csv"));
    EXPECT_EQ(r.status, 1);
    EXPECT_FALSE(std::filesystem::exists(scratch_.file("refused.csv")));
    return r.err;
  }
};

TEST_F(Slabs, MergeToTheTableMadeInOneGoToTheLastByte) {
  const std::string whole = scratch_.file("whole.csv"), merged = scratch_.file("merged.csv");
  ASSERT_EQ(table(axes + " -o " + whole).status, 0);
  const std::string a = slab("1/3", "a.csv", axes), b = slab("2/3", "b.csv", axes),
                    c = slab("3/3", "c.csv", axes);
  const Result r = run("table --merge " + c + " " + a + " " + b + " -o " + merged);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("merged.csv written from 3 slabs\n"));
  EXPECT_EQ(file_text(merged), file_text(whole));
  // A file that is there stays.
  EXPECT_EQ(run("table --merge " + a + " " + b + " " + c + " -o " + merged).status, 1);
  EXPECT_EQ(run("table --merge " + a + " " + b + " " + c + " --force -o " + merged).status, 0);
}

TEST_F(Slabs, AreMadeAndMergedByGnuParallel) {
  const std::string model = scratch_.write("my.toml", model_text);
  const std::string whole = scratch_.file("whole.csv");
  ASSERT_EQ(run("table " + model + " " + axes + " -o " + whole).status, 0);
  const Result r = run_shell("cd " + scratch_.path().string() +
                             " && parallel --jobs 2 $raceway table my.toml " + axes +
                             " --slab {}/5 -o slab-{}.csv ::: 1 2 3 4 5"
                             " && $raceway table --merge slab-*.csv -o merged.csv");
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(file_text(scratch_.file("merged.csv")), file_text(whole));
}

TEST_F(Slabs, AreRefusedWhereOneIsMissingTwiceStrangeOrCut) {
  const std::string a = slab("1/3", "a.csv", axes), b = slab("2/3", "b.csv", axes),
                    c = slab("3/3", "c.csv", axes);
  EXPECT_THAT(merge_refusal(a + " " + c), HasSubstr("missing slabs: 1 of 3; the first is 2/3"));
  EXPECT_THAT(merge_refusal(a + " " + b + " " + c + " " + b), HasSubstr("slab 2/3 is given twice"));
  const std::string other = slab("2/3", "other.csv", "--speed 0:8000:1000 --axial-load 100,900");
  EXPECT_THAT(
      merge_refusal(a + " " + other + " " + c),
      HasSubstr("slabs of different tables: they have different speeds, loads or temperatures"));
  const std::string model = scratch_.file("b2.csv");
  ASSERT_EQ(table(axes + " --slab 2/3 -o " + model, model_text + spin_effect).status, 0);
  EXPECT_THAT(merge_refusal(a + " " + model + " " + c),
              HasSubstr("slabs of different tables: they come from different models or versions"));
  std::string text = file_text(b);
  text.resize(text.size() - 40);
  EXPECT_THAT(merge_refusal(a + " " + scratch_.write("cut.csv", text) + " " + c),
              HasSubstr("points; was it truncated?"));
  const std::string whole = scratch_.file("whole.csv");
  ASSERT_EQ(table(axes + " -o " + whole).status, 0);
  EXPECT_THAT(merge_refusal(whole),
              HasSubstr(": the file is not a slab of a table; raceway table --slab writes slabs"));
  EXPECT_THAT(merge_refusal(a + " --speed 100"), HasSubstr("--speed excludes --merge"));
  EXPECT_THAT(merge_refusal(a + " --format modelica"), HasSubstr("--format csv or excel"));
  EXPECT_THAT(run("table --merge " + a).err, HasSubstr("--output is missing"));
}

TEST_F(Slabs, NeedAPlaceAmongThemAndAFile) {
  for (const char* part : {"0/3", "4/3", "2", "a/b", "1/0", "-1/3"}) {
    const Result r = table(axes + " --slab=" + part + " -o " + scratch_.file("x.csv"));
    EXPECT_EQ(r.status, 1);
    EXPECT_THAT(r.err, HasSubstr("write i/N with i from 1 to N")) << part;
  }
  EXPECT_THAT(table(axes + " --slab 1/3").err, HasSubstr("--slab needs --output FILE"));
}

}  // namespace
}  // namespace raceway::tests

#include <cmath>
#include <functional>
#include <random>

#include "tests/cli/sample.h"

// Several files of measurements at once, as a user gives them.
namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Rows of a day by Palmgren's formula at 40 C, 22 mm2/s and d_m 90 mm, 2 N mm of scatter, and a
/// windage of 60 N mm at 10 000 rpm.
std::string day(double f0, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  for (const double speed : {600, 1500, 3000, 5000, 7500, 10000, 13000, 16000})
    for (const double load : {100, 400, 1200}) {
      const double viscous = 1e-7 * f0 * std::pow(22.0 * speed, 2.0 / 3.0) * std::pow(90.0, 3);
      const double bearing =
          0.001 * std::pow(0.38 * load / 43000, 0.33) * 0.9 * load / 0.46630766 * 90;
      const double air = 60.0 * std::pow(speed / 1e4, 1.8);
      text += std::to_string(speed) + "," + std::to_string(load) + ",40," +
              std::to_string(viscous + bearing + air + 2.0 * gauss(random)) + "\n";
    }
  return text;
}

struct Days {
  ScratchFolder scratch;
  std::string model = scratch.write("m.toml", model_text);
  std::string monday = scratch.write("monday.csv", day(1.5, 1));
  std::string friday = scratch.write("friday.csv", day(2.1, 2));
  std::string both = monday + " " + friday;
};

TEST(SeveralFiles, CompareTellsTheErrorOfEachAndOfAll) {
  const Days d;
  const json all = parsed(run("compare " + d.model + " " + d.both + " --json"));
  ASSERT_EQ(all["records"].size(), 2u);
  EXPECT_EQ(all["records"][0]["record"], "friday");
  EXPECT_EQ(all["records"][0]["data"], d.friday);
  EXPECT_EQ(all["data"].size(), 2u);
  EXPECT_EQ(all["rows"], 48);
  double square = 0.0;
  for (const json& r : all["records"]) square += 24 * std::pow(r["rmse"].get<double>(), 2);
  EXPECT_NEAR(std::sqrt(square / 48), all["rmse"].get<double>(), 1e-9);
  const Result alone = run("compare " + d.model + " " + d.monday + " --json");
  EXPECT_NEAR(all["records"][1]["rmse"].get<double>(), parsed(alone)["rmse"].get<double>(), 1e-9);
  EXPECT_FALSE(parsed(alone).contains("records"));
  const Result text = run("compare " + d.model + " " + d.both);
  EXPECT_THAT(text.out, HasSubstr("\nmonday "));
  EXPECT_THAT(text.out, HasSubstr(" of friday "));  // of a line
}

TEST(SeveralFiles, CalibrateAndAddWriteAModelForEachRecord) {
  const Days d;
  const std::string out = d.scratch.file("better.toml");
  const std::string flags = " --per-record f0 --json -o " + out;
  const Result r = run("add " + d.model + " windage --data " + d.both + flags);
  ASSERT_EQ(r.status, 0) << r.err;
  const json p = parsed(r)["calibration"]["parameters"];
  const auto near = [&](const char* name, double truth) {
    EXPECT_NEAR(p[name]["value"].get<double>(), truth, 3.5 * p[name]["std"].get<double>()) << name;
  };
  near("f0@friday", 2.1);
  near("f0@monday", 1.5);
  near("z", 0.001);
  near("windage.torque_at_10000_rpm_Nmm", 60.0);
  EXPECT_FALSE(std::filesystem::exists(out));
  const std::string monday = d.scratch.file("better-monday.toml");
  const std::string friday = d.scratch.file("better-friday.toml");
  EXPECT_LT(parsed(run("compare " + monday + " " + d.monday + " --json"))["rmse"].get<double>(), 3);
  EXPECT_LT(parsed(run("compare " + friday + " " + d.friday + " --json"))["rmse"].get<double>(), 3);
  EXPECT_GT(parsed(run("compare " + monday + " " + d.friday + " --json"))["rmse"].get<double>(),
            30);
  EXPECT_THAT(file_text(monday), HasSubstr("[calibration.covariance]"));
  EXPECT_THAT(file_text(monday), Not(HasSubstr("@")));
  // Nothing is overwritten, of either.
  std::filesystem::remove(friday);
  expect_refused(run("calibrate " + d.model + " " + d.both + flags), monday);
  EXPECT_FALSE(std::filesystem::exists(friday));
}

TEST(SeveralFiles, DiagnoseFindsWhatTheyShareInAnyOrder) {
  const Days d;
  const Result one = run("diagnose " + d.model + " " + d.both + " --per-record f0,z --json");
  const Result other =
      run("diagnose " + d.model + " " + d.friday + " " + d.monday + " --per-record f0,z --json");
  EXPECT_EQ(one.out, other.out);
  const json found = parsed(one);
  EXPECT_EQ(found["effects"][0]["id"], "windage") << found["sentence"];
  EXPECT_NE(found["verdict"], "nothing-missing");
  // Without a value of its own for f0 the days are a misfit.
  const auto error = [&](const std::string& flags) {
    return parsed(run("compare " + d.model + " " + d.both + flags + " --json"))["rmse"]
        .get<double>();
  };
  EXPECT_GT(error(" --refit f0,z"), 2.0 * error(" --per-record f0,z"));
}

TEST(SeveralFiles, OnesThatDifferMayHaveValuesOfTheirOwn) {
  const Days d;
  const std::string other = d.scratch.write("other.csv", day(6.0, 3));
  const char* const advice = "all records are fitted with the same f0 and z. If the rig changed";
  EXPECT_THAT(run("diagnose " + d.model + " " + d.monday + " " + other).err, HasSubstr(advice));
  EXPECT_THAT(run("diagnose " + d.model + " " + d.monday + " " + other + " --per-record f0").err,
              Not(HasSubstr(advice)));
}

TEST(SeveralFiles, ReportShowsTheRecordOfEachRow) {
  if (!has_reports()) GTEST_SKIP();
  const Days d;
  const std::string page = d.scratch.file("page.html");
  const Result r = run("diagnose " + d.model + " " + d.both + " --per-record f0 --report " + page);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(page_document(page)["runs"], (json{"friday", "monday"}));
}

TEST(SeveralFiles, RefusesWhatCannotBeOneRecord) {
  const Days d;
  const std::string start = "calibrate " + d.model + " ";
  expect_refused(run(start + d.monday + " " + d.scratch.file("no.csv")), "no.csv: no such file");
  expect_refused(run(start + d.monday + " " + d.monday), "monday.csv: is given twice");
  expect_refused(run(start + d.both + " --per-record f00"), "nearest: f0");
  expect_refused(run(start + d.both + " --per-record f0,f0"), "listed twice");
  expect_refused(
      run(start + d.monday + " --per-record f0"),
      "is the only record, but --per-record needs several records; name at least two files "
      "of measurements");
  expect_refused(run(start + "--per-record f0"), "DATA is missing");
  const std::string shaft = d.scratch.write(
      "shaft.csv", "speed_rpm,axial_load_N,axial_displacement_um\n100,10,1\n200,10,2\n");
  expect_refused(run(start + d.monday + " " + shaft), "shaft.csv with " + d.model);
  expect_refused(run("compare " + d.model + " " + d.monday + " " + d.model),
                 ": this is a model file; measurements (CSV) are expected here");
  expect_refused(run("add " + d.model + " --data " + d.both), "EFFECT is missing");
}

}  // namespace
}  // namespace raceway::tests

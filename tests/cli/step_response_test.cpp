#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// The published K(P), T(P) [Brecher2021, eq. 8 and 9] at 50, 100 and 150 W, over eight hours.
std::string published_rows(const std::string& header, bool with_speed) {
  std::string text = header + "\n";
  for (const int power : {50, 100, 150})
    for (int minutes = 0; minutes <= 480; minutes += 20) {
      const double K = 0.4817 * power + 10.3617, T = -0.6298 * power + 135.245;
      text +=
          fmt::format("{0}W,{1},{2:.9f},{0}", power, 60 * minutes, -K * std::expm1(-minutes / T));
      text += with_speed ? fmt::format(",{}\n", 40 * power) : "\n";
    }
  return text;
}

TEST(StepResponseCommand, GivesThePublishedLawsOfImportedLoadCases) {
  const ScratchFolder scratch;
  const std::string fe = scratch.write(
      "fe.csv", published_rows("load_case,time_s,axial_displacement_um,power_W", false));
  const Result r = run("step-response --import " + fe + " --json");
  EXPECT_EQ(r.status, 0) << r.err;
  const json document = parsed(r);
  EXPECT_NEAR(document["K_of_P"]["slope_um_W"].get<double>(), 0.4817, 1e-5);
  EXPECT_NEAR(document["K_of_P"]["offset_um"].get<double>(), 10.3617, 1e-4);
  EXPECT_NEAR(document["T_of_P"]["slope_min_W"].get<double>(), -0.6298, 1e-5);
  EXPECT_NEAR(document["T_of_P"]["offset_min"].get<double>(), 135.245, 1e-3);
  EXPECT_NEAR(document["valid_to_W"].get<double>(), 214.7428, 2e-3);
  EXPECT_EQ(document["valid_from_W"], 0.0);
  EXPECT_TRUE(document["rows"][0]["speed_rpm"].is_null());
  EXPECT_FALSE(document["two_needed"].get<bool>());
  EXPECT_THAT(r.err, HasSubstr("um has no physical meaning; valid powers:"));

  const std::string steps = scratch.file("steps.csv");
  EXPECT_EQ(run("step-response --import " + fe + " -o " + steps).status, 0);
  const std::string csv = file_text(steps);
  EXPECT_THAT(csv, HasSubstr("\nspeed_rpm,power_start_W,power_end_W,kinematic_um,K_um,T_min,"
                             "fit_rms_um,"));
  const Result text = run("step-response --import " + fe);
  EXPECT_THAT(text.out, HasSubstr("K = 0.4817 um/W P + 10.36 um"));
}

// The same rows in files of their own.
TEST(StepResponseCommand, TakesTimeHistoriesForLoadCases) {
  const ScratchFolder scratch;
  std::string flags;
  for (const int power : {50, 150}) {
    std::string rows = " TIME  UX\n";
    for (int minutes = 20; minutes <= 480; minutes += 20)
      rows += fmt::format(
          "  {:.6E} {:.9E}\n", 60.0 * minutes,
          -1e-3 * (0.4817 * power + 10.3617) * std::expm1(-minutes / (-0.6298 * power + 135.245)));
    flags += fmt::format(" --load-case {}W={}", power,
                         scratch.write(fmt::format("{}.txt", power), rows));
  }
  const json document = parsed(run("step-response" + flags + " --units s,mm --json"));
  EXPECT_NEAR(document["K_of_P"]["slope_um_W"].get<double>(), 0.4817, 1e-5);
  EXPECT_TRUE(document["K_of_P"]["slope_um_W_std"].is_null());
  EXPECT_EQ(document["rows"][1]["load_case"], "150W");
}

/// The displacement that `correct` predicts, by its rows.
std::vector<double> corrected(const ScratchFolder& scratch, const std::string& model,
                              const std::string& record) {
  const std::string out = scratch.file("corrected.csv");
  const Result r = run("correct " + model + " " + record + " --force -o " + out);
  EXPECT_EQ(r.status, 0) << r.err;
  std::istringstream lines(file_text(out));
  std::vector<double> values;
  std::size_t column = 0;
  bool headed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (!headed) {
      headed = true;
      while (column < cells.size() && !cells[column].starts_with("predicted") &&
             !cells[column].starts_with("displacement_z"))
        ++column;
      continue;
    }
    values.push_back(std::stod(cells.at(column)));
  }
  return values;
}

// What was imported comes out of the correction again, at speeds and with all three laws.
TEST(StepResponseCommand, WritesACorrectionThatCorrectRuns) {
  const ScratchFolder scratch;
  const std::string fe = scratch.write(
      "fe.csv", published_rows("load_case,time_s,axial_displacement_um,power_W,speed_rpm", true));
  std::string rows = "time_s,speed_rpm\n";
  for (int minutes = 0; minutes <= 240; minutes += 2)
    rows += fmt::format("{},4000\n", 60 * minutes);
  for (int minutes = 242; minutes <= 2000; minutes += 2)
    rows += fmt::format("{},0\n", 60 * minutes);
  const std::string record = scratch.write("record.csv", rows);
  for (const std::string law : {"curve", "line"}) {
    const std::string model = scratch.file(law + ".toml");
    const Result r =
        run("step-response --import " + fe + " --law " + law + " --correction " + model);
    ASSERT_EQ(r.status, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr(law + ".toml written"));
    const std::vector<double> u = corrected(scratch, model, record);
    ASSERT_GT(u.size(), 900U);
    // 4000 rpm is 100 W: 58.53 um in 72.3 min.
    EXPECT_NEAR(u[60], -58.5317 * std::expm1(-120 / 72.265), 1e-3) << law;
    EXPECT_NEAR(u[120], -58.5317 * std::expm1(-240 / 72.265), 1e-3) << law;
    EXPECT_LT(std::abs(u.back()), 0.01) << law << ": it cools to where it was";
  }
  const Result again =
      run("step-response --import " + fe + " --correction " + scratch.file("curve.toml"));
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
}

// The power is then that of the model's friction, as `displacement` says it.
TEST(StepResponseCommand, TakesThePowerOfImportedSpeedsFromTheModel) {
  const std::string model = tests::source_dir() + "/data/spindles/two_against_one.toml";
  const ScratchFolder scratch;
  std::string rows = "time_s,axial_displacement_um,speed_rpm\n";
  for (int minutes = 5; minutes <= 240; minutes += 5)
    rows += fmt::format("{},{:.9f},6000\n", 60 * minutes, -30.0 * std::expm1(-minutes / 40.0));
  const json steps = parsed(
      run("step-response " + model + " --import " + scratch.write("fe.csv", rows) + " --json"));
  const json shaft = parsed(run("displacement " + model + " --speed 6000 --json"));
  const json& step = steps["rows"][0];
  EXPECT_EQ(step["power_end_W"], shaft["rows"][0]["power_loss_W"]);
  EXPECT_EQ(step["kinematic_um"], shaft["rows"][0]["axial_displacement_um"]);
  EXPECT_NEAR(step["K_um"].get<double>(), 30.0, 1e-4);
  EXPECT_NEAR(step["T_min"].get<double>(), 40.0, 1e-3);
}

const std::string small_spindle = shortest_spindle + "[solver]\ncells = \"coarse\"\n";

// A step that the correction was made of comes out of it as it came out of the simulation.
TEST(StepResponseCommand, MakesACorrectionOfASpindle) {
  const ScratchFolder scratch;
  const std::string model = scratch.write("spindle.toml", small_spindle);
  std::string programme = "time_s,speed_rpm\n";
  for (int minutes = 0; minutes <= 240; minutes += 2)
    programme += fmt::format("{},3000\n", 60 * minutes);
  const std::string day = scratch.write("day.csv", programme);
  const std::string correction = scratch.file("correction.toml");
  const Result r = run("step-response " + model + " --speed 0:4500:1500 --lags two --correction " +
                       correction + " --programme " + day + " --json");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.err, HasSubstr(": 0 rpm is not used, because each step starts from rest"));
  EXPECT_THAT(r.err, HasSubstr("correction_fast.csv, "));
  const json document = parsed(r);
  ASSERT_EQ(document["rows"].size(), 3U);
  EXPECT_TRUE(document["two_needed"].get<bool>());
  EXPECT_LT(document["superposition"]["rms_um"].get<double>(), 0.1);
  const json& step = document["rows"][1];
  const std::vector<double> u = corrected(scratch, correction, day);
  EXPECT_NEAR(u.back(), step["end_um"].get<double>() + step["kinematic_um"].get<double>(), 0.3);
  EXPECT_GT(step["highest_front_force_N"], step["front_force_N"]);
}

// Rows that say what begins and rows that say what was until then: one programme, one error.
TEST(StepResponseCommand, AProgrammeMeansTheSameToSimulationAndCorrection) {
  const ScratchFolder scratch;
  std::string events = "time_s,speed_rpm\n", intervals = "time_s,speed_rpm\n0,0\n";
  constexpr int speeds[] = {3000, 0, 4500, 1500};
  for (int k = 0; k < 24; ++k) {
    events += fmt::format("{},{}\n", 600 * k, speeds[k / 6]);
    intervals += fmt::format("{},{}\n", 600 * (k + 1), speeds[k / 6]);
  }
  events += "14400,0\n";
  const auto error = [&](const std::string& hold, const std::string& programme) {
    const std::string model = scratch.write(
        "spindle.toml", small_spindle + "[columns]\nsettings_hold = \"" + hold + "\"\n");
    const Result r =
        run("step-response " + model + " --speed 1500:4500:1500 --lags two --correction " +
            scratch.file("z.toml") + " --force --programme " + scratch.write("day.csv", programme) +
            " --json");
    EXPECT_EQ(r.status, 0) << r.err;
    return parsed(r)["superposition"]["rms_um"].get<double>();
  };
  const double of_events = error("from row", events), of_intervals = error("until row", intervals);
  EXPECT_NEAR(of_events, of_intervals, 1e-8 * of_events);
  EXPECT_LT(of_events, 3.0);  // two delay elements on a spindle that is warm
}

// A day with loads: with elements of loads the correction follows the simulation closer.
TEST(StepResponseCommand, StepsOfLoadsBecomeDelayElements) {
  const ScratchFolder scratch;
  const std::string model =
      scratch.write("spindle.toml", small_spindle + "[columns]\nsettings_hold = \"from row\"\n");
  std::string day = "time_s,speed_rpm,axial_load_N,radial_load_N\n";
  constexpr int speeds[] = {3000, 3000, 4500, 4500, 0, 1500}, axial[] = {0, 300, 300, -200, 0, 250},
                radial[] = {0, 0, 400, 400, 0, 0};
  for (int k = 0; k < 60; ++k)
    day += fmt::format("{},{},{},{}\n", 300 * k, speeds[k / 10], axial[k / 10], radial[k / 10]);
  day += "18000,0,0,0\n";
  const std::string programme = scratch.write("day.csv", day);
  const std::string common =
      "step-response " + model + " --speed 1500:4500:1500 --lags one --programme " + programme;
  const auto error = [&](const std::string& flags, const std::string& file) {
    const Result r = run(common + " --correction " + scratch.file(file) + flags + " --json");
    EXPECT_EQ(r.status, 0) << r.err;
    return parsed(r)["superposition"]["rms_um"].get<double>();
  };
  const double without = error("", "plain.toml");
  const double with =
      error(" --axial-load=-300,300 --radial-load 400 --load-speed 1500,4500", "loads.toml");
  EXPECT_LT(with, 0.75 * without);
  const std::string text = file_text(scratch.file("loads.toml"));
  EXPECT_THAT(
      text, HasSubstr("window = { column = \"speed_rpm\", points = [-inf, -inf, 1500.0, 4500.0]"));
  EXPECT_THAT(text,
              HasSubstr("name = \"axial_load_4500rpm\"\ninput = \"axial_load_N\"\n"
                        "window = { column = \"speed_rpm\", points = [1500.0, 4500.0, inf, inf]"));
  EXPECT_THAT(file_text(scratch.file("loads_axial_load_1500rpm.csv")),
              HasSubstr("axial_load_N,gain_um,time_constant_min"));
  // `correct` reads it, and refuses nothing that a control has.
  const Result corrected = run("correct " + scratch.file("loads.toml") + " " + programme);
  EXPECT_EQ(corrected.status, 0) << corrected.err;
  EXPECT_EQ(run("export " + scratch.file("loads.toml") + " --format python -o " +
                scratch.file("loads.py") + " --record " + programme)
                .status,
            0);
  // A table of all steps, and the same in text.
  const Result steps = run("step-response " + model + " --speed 3000 --axial-load 200 -o -");
  EXPECT_THAT(steps.out, HasSubstr("speed_rpm,axial_load_N,radial_load_N,power_start_W"));
  EXPECT_THAT(run("step-response " + model + " --speed 3000 --axial-load 0,200").err,
              HasSubstr("--axial-load: 0 N is not a load step and is not used"));
  EXPECT_THAT(run("step-response " + model + " --speed 3000 --load-speed 3000").err,
              HasSubstr("--load-speed: no load step is given for these speeds"));
  EXPECT_THAT(run("step-response --import x.csv --axial-load 100").err, HasSubstr("choose one"));
}

TEST(StepResponseCommand, ItsFilesDoNotWriteOverEachOther) {
  const ScratchFolder scratch;
  const std::string table = scratch.file("z_fast.csv");
  const Result r =
      run("step-response " + scratch.write("spindle.toml", small_spindle) + " --speed 3000 -o " +
          table + " --correction " + scratch.file("z.toml") + " --force");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(
      r.err,
      HasSubstr(table + ": this run already writes a file with this name; choose another name"));
  EXPECT_FALSE(std::filesystem::exists(table));
}

TEST(StepResponseCommand, SaysWhatIsMissing) {
  const ScratchFolder scratch;
  const std::string fe = scratch.write(
      "fe.csv", "time_s,axial_displacement_um,speed_rpm\n60,1,2000\n600,2,2000\n1200,3,2000\n");
  const Result no_model = run("step-response --import " + fe);
  EXPECT_EQ(no_model.status, 1);
  EXPECT_THAT(no_model.err, HasSubstr("has a speed but no power: give power_W, or name a MODEL "
                                      "whose friction gives the power"));
  EXPECT_THAT(run("step-response").err, HasSubstr("give MODEL or --import FILE"));
  EXPECT_THAT(run("step-response some.toml").err,
              HasSubstr("give --speed, such as 2000:10000:2000, or --import FILE"));
  EXPECT_THAT(run("step-response --import " + fe + " --speed 100").err, HasSubstr("choose one"));
  EXPECT_THAT(run("step-response --import nothing.csv").err, HasSubstr("nothing.csv"));
  const std::string power = scratch.write(
      "p.csv", published_rows("load_case,time_s,axial_displacement_um,power_W", false));
  EXPECT_THAT(
      run("step-response --import " + power + " --correction " + scratch.file("c.toml")).err,
      HasSubstr("needs the power at a speed"));
  // Flags of another question were taken without a word.
  for (const auto& [flags, missing] : {std::pair{"--hours 3", "--hours requires --speed"},
                                       {"--coolant off", "--coolant requires --speed"},
                                       {"--units min,um", "--units requires --load-case"},
                                       {"--law line", "--law requires --correction"},
                                       {"--lags one", "--lags requires --correction"}})
    expect_refused(run("step-response --import " + power + " " + flags), missing);
  expect_refused(run("step-response some.toml --speed 1000 --temperature 50"),
                 "--speed excludes --temperature");
}

}  // namespace
}  // namespace raceway::tests

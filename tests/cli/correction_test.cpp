#include <gmock/gmock.h>

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/correction_record.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string corrections = tests::source_dir() + "/data/corrections/";

/// Records of machines whose hidden effect is known, made by a program of its own.
class Correction : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  ScratchFolder scratch_;
};

json section(const json& found, std::size_t channel, std::size_t k) {
  return found["channels"][channel]["sections"][k];
}

/// Truth: 5 um/K at 5400 s, 3 at 900 s; -2.5 at 14 000 s; noise 0.3 um, uneven clock.
TEST_F(Correction, IdentifyFindsKnownLagsOnAnUnevenClock) {
  const json d = parsed(run("identify " + corrections + "exact/correction.toml " + corrections +
                            "exact/train.csv --json -o " + path("found.toml")));
  ASSERT_EQ(d["channels"].size(), 2U);
  ASSERT_EQ(d["channels"][0]["sections"].size(), 2U);
  const double gains[] = {5.0, 3.0}, lags[] = {5400, 900};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(section(d, 0, k)["gain"]["value"].get<double>() / gains[k], 1.0, 4e-3);
    EXPECT_NEAR(section(d, 0, k)["time_constant_s"]["value"].get<double>() / lags[k], 1.0, 6e-3);
  }
  EXPECT_NEAR(section(d, 1, 0)["gain"]["value"].get<double>() / -2.5, 1.0, 4e-3);
  EXPECT_NEAR(section(d, 1, 0)["time_constant_s"]["value"].get<double>() / 14000, 1.0, 6e-3);
  const json c =
      parsed(run("correct " + path("found.toml") + " " + corrections + "exact/test.csv --json"));
  EXPECT_NEAR(c["metrics"]["rmse_um"].get<double>(), 0.3, 0.02);
}

TEST_F(Correction, DiagnoseNamesWhatIsMissing) {
  const json one = parsed(run("diagnose " + corrections + "ambient/correction.toml " + corrections +
                              "ambient/train.csv --json"));
  EXPECT_EQ(one["verdict"], "effect");
  EXPECT_EQ(one["explanations"], (json{{"ambient-drift"}}));
  const json two = parsed(run("diagnose " + corrections + "power/correction.toml " + corrections +
                              "power/train.csv --json"));
  EXPECT_EQ(two["verdict"], "several-effects");
  EXPECT_EQ(two["explanations"][0], (json{"ambient-drift", "motor-heat"}));
}

/// On the profile that no fit saw: 14.2 um without, 1.1 with what the machine has.
TEST_F(Correction, AddMakesTheErrorFallOnAnotherProfile) {
  const std::string model = corrections + "ambient/correction.toml",
                    train = corrections + "ambient/train.csv";
  ASSERT_EQ(run("calibrate " + model + " " + train + " -o " + path("base.toml")).status, 0);
  ASSERT_EQ(
      run("add " + model + " ambient-drift --data " + train + " -o " + path("better.toml")).status,
      0);
  const json c = parsed(run("compare " + path("base.toml") + " " + path("better.toml") + " " +
                            corrections + "ambient/test.csv --json"));
  EXPECT_GT(c["models"][0]["rmse"], 12.0);
  EXPECT_LT(c["models"][1]["rmse"], 1.5);
  const json again = parsed(run("diagnose " + path("better.toml") + " " + train + " --json"));
  EXPECT_EQ(again["verdict"], "nothing-missing");
  // What does not matter is not added.
  const Result more = run("add " + path("better.toml") + " slow-drift --data " + train);
  EXPECT_EQ(more.status, 1);
  EXPECT_THAT(more.err, HasSubstr("within the tolerance"));
}

TEST_F(Correction, CorrectSaysWhereTheModelHasNeverBeen) {
  const std::string found = path("found.toml");
  ASSERT_EQ(run("identify " + corrections + "exact/correction.toml " + corrections +
                "exact/test.csv -o " + found)
                .status,
            0);
  EXPECT_THAT(file_text(found), HasSubstr("[correction.range]"));
  const Result r =
      run("correct " + found + " " + corrections + "exact/train.csv -o " + path("c.csv"));
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("outside the training data"));
  EXPECT_THAT(file_text(path("c.csv")),
              testing::StartsWith("time_s,predicted_um,band_low_um,band_high_um,"));
}

/// The rows of a record from a time on with another value in one of its columns.
std::string with_column(const std::string& csv, const std::string& name, double from,
                        const std::function<double(double)>& value) {
  std::istringstream in(csv);
  std::string line, out, cell;
  std::getline(in, line);
  out = line + "\n";
  std::vector<std::string> names;
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  while (std::getline(in, line)) {
    std::vector<std::string> row;
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) row.push_back(cell);
    row.resize(names.size());
    const double t = std::stod(row[0]);
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == name && t >= from) row[k] = std::to_string(value(t - from));
      out += (k > 0 ? "," : "") + row[k];
    }
    out += "\n";
  }
  return out;
}

/// The model is exact in its range; beyond it nobody knows, and it says so, from when on and by how
/// much.
TEST_F(Correction, ARoomColderThanEverBeforeIsNeverSilent) {
  const std::string model = path("found.toml");
  ASSERT_EQ(run("identify " + corrections + "exact/correction.toml " + corrections +
                "exact/train.csv -o " + model)
                .status,
            0);
  const json inside =
      parsed(run("correct " + model + " " + corrections + "exact/train.csv --json"));
  EXPECT_EQ(inside["rows_beyond_range"], 0);
  EXPECT_GT(inside["band"]["readings_within_percent"], 90.0);
  EXPECT_LT(inside["band"]["half_width_um"][1], 0.5);
  const std::string cold = scratch_.write(
      "cold.csv", with_column(file_text(corrections + "exact/test.csv"), "ambient_temperature_C",
                              30000, [](double t) { return 22.0 - 12.0 * t / 27600; }));
  const Result r = run("correct " + model + " " + cold + " -o " + path("cold_corrected.csv"));
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("warning: ambient_temperature_C: from line "));
  EXPECT_THAT(r.err, HasSubstr("outside the training data of 19.137 to 24.900 C"));
  EXPECT_THAT(r.out, HasSubstr("95 % band of displacement_z_um: smallest half width "));
  for (const std::string command : {"correct ", "compare "}) {
    const json d = parsed(run(command + model + " " + cold + " --json"));
    EXPECT_GT(d["rows_beyond_range"], 500) << command;
    ASSERT_FALSE(d["beyond_range"].empty()) << command;
    const json& first = d["beyond_range"][0];
    EXPECT_EQ(first["input"], "ambient_temperature_C") << command;
    // 22 C falls to 19.14 C.
    EXPECT_NEAR(first["first_time_s"].get<double>(), 30000 + 2.863 * 27600 / 12, 60) << command;
    EXPECT_LT(first["farthest"], 10.1) << command;
    if (d.contains("band")) {
      EXPECT_GT(d["band"]["half_width_um"][1], 5.0);
    }
  }
}

/// A model that was changed by hand is another model.
TEST_F(Correction, ABandEndsWithTheNumbersThatItIsOf) {
  const std::string model = path("found.toml");
  ASSERT_EQ(run("identify " + corrections + "exact/correction.toml " + corrections +
                "exact/train.csv -o " + model)
                .status,
            0);
  std::string text = file_text(model);
  const std::size_t at = text.find("offset_um = ");
  ASSERT_NE(at, text.npos);
  text.insert(at + std::string("offset_um = ").size(), "1");
  const Result r = run("correct " + scratch_.write("edited.toml", text) + " " + corrections +
                       "exact/test.csv --json");
  EXPECT_THAT(r.err, HasSubstr("offset = "));
  EXPECT_THAT(r.err, HasSubstr("no error band"));
  EXPECT_EQ(parsed(r)["band"], nullptr);
}

TEST_F(Correction, ReadingsThatAreMissingArePredicted) {
  const std::string model = scratch_.write(
      "z.toml",
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = \"a\"\n"
      "input = \"a_temperature_C\"\nsections = [{ gain_um_K = 2.0, time_constant_s = 100 }]\n");
  std::string csv = "time_s,a_temperature_C,displacement_z_um\n0,20,0\n";
  for (int k = 1; k < 30; ++k) csv += std::to_string(100 * k) + ",21,\n";
  const Result r = run("correct " + model + " " + scratch_.write("r.csv", csv) + " -o -");
  EXPECT_EQ(r.status, 0);
  // 1 K in a straight line over the first 100 s: 2 (1 - (1 - e^-1)) there, e^-1 of the rest later.
  EXPECT_THAT(r.out, HasSubstr("\n100,0.735758882,0.735758882,\n"));
}

TEST_F(Correction, WrongInputIsRefusedWithItsPlace) {
  const std::string model = corrections + "ambient/correction.toml";
  expect_refused(
      run("correct " + model + " " + scratch_.write("r.csv", "time_s,displacement_z_um\n0,1\n")),
      "front_bearing_temperature_C is missing");
  expect_refused(run("identify " + model + " " + corrections + "ambient/train.csv --order 3:1"),
                 "--order");
  expect_refused(run("identify " + model + " " + corrections +
                     "ambient/train.csv --inputs motr_temperature_C"),
                 "motor_temperature_C");
  expect_refused(run("diagnose " + model + " " + corrections + "ambient/train.csv --tolerance 2um"),
                 "tolerance_um is already given under");
  expect_refused(run("add " + model + " nonsense --data " + corrections + "ambient/train.csv"),
                 "unknown effect");
  expect_refused(run("compare " + model + " " + corrections +
                     "ambient/train.csv --displacement displacement_y_um"),
                 "does not model this channel; it models displacement_z_um");
}

/// A record that only warms up once holds out nothing.
TEST_F(Correction, AHeatUpAloneCannotValidate) {
  std::string csv = "time_s,a_temperature_C,displacement_z_um\n";
  for (int k = 0; k < 600; ++k)
    csv += std::to_string(60 * k) + "," + std::to_string(20 + 10 * (1 - std::exp(-k / 60.0))) +
           "," + std::to_string(30 * (1 - std::exp(-k / 100.0))) + "\n";
  const std::string model =
      scratch_.write("z.toml",
                     "[correction]\ndisplacement = \"displacement_z_um\"\ntolerance_um = 1\n"
                     "[[correction.channel]]\nname = \"a\"\ninput = \"a_temperature_C\"\n"
                     "sections = [{ gain_um_K = 2.0, time_constant_s = 1000 }]\n");
  expect_refused(run("diagnose " + model + " " + scratch_.write("r.csv", csv)),
                 "cannot validate a model");
}

/// Five channels of a real spindle: found in 26 h, run over the next 8 h without a new zero.
TEST_F(Correction, ABankOfLagsPredictsHoursThatItDidNotSee) {
  const std::string spindle = tests::source_dir() + "/data/measurements/spindle_thermal/";
  const std::string record = " " + spindle + "record.csv ";
  double sum = 0.0, sum_of_nothing = 0.0;
  for (int channel = 1; channel <= 5; ++channel) {
    const std::string bare = spindle + "bare" + std::to_string(channel) + ".toml",
                      bank = path("bank" + std::to_string(channel) + ".toml");
    const json found =
        parsed(run("identify " + bare + record + "--lags auto --until 26h --json -o " + bank));
    EXPECT_EQ(found["ahead"].size(), 6U);
    EXPECT_EQ(found["strengths"].size(), 21U);
    EXPECT_EQ(found["metrics"]["readings"], 6241);
    const json c =
        parsed(run("compare " + bare + " " + bank + record + "--from 26h --zero none --json"));
    // One reading of the fifth channel (line 6284) leaves and returns: it takes no part.
    EXPECT_EQ(c["models"][1]["rows"], channel == 5 ? 1920 : 1921);
    sum_of_nothing += c["models"][0]["rmse"].get<double>() / 5;
    sum += c["models"][1]["rmse"].get<double>() / 5;
  }
  EXPECT_GT(sum_of_nothing, 25.0);
  EXPECT_LT(sum, 2.0);
}

/// Their inputs drive the model all the same.
TEST_F(Correction, ReadingsCountFromAndUntil) {
  const std::string model = corrections + "exact/correction.toml",
                    record = corrections + "exact/train.csv";
  const auto readings = [&](const std::string& flags) {
    return parsed(
               run("correct " + model + " " + record + " --json " + flags))["metrics"]["readings"]
        .get<int>();
  };
  const int all = readings("");
  EXPECT_EQ(readings("--until 10h") + readings("--from 600.001min"), all);
  EXPECT_EQ(readings("--from 0s"), all);
  expect_refused(run("correct " + model + " " + record + " --from 5x"), "as 22h, 90min or 3600s");
  expect_refused(run("correct " + model + " " + record + " --from 5000h"), "no reading from 5000h");
  expect_refused(
      run("compare " + tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/model.toml " +
          tests::source_dir() + "/tests/hidden_effect/rigs/dev-03/train.csv --from 1h"),
      "--from, --until are only for records over time and models with [correction]");
}

/// Two models of one displacement do not count its readings twice.
TEST_F(Correction, ThePeriodOfTwoModelsHasTheReadingsOfOne) {
  const std::string model = corrections + "exact/correction.toml";
  const auto note = [&](const std::string& models) {
    const Result r = run("compare " + models + " " + corrections + "exact/train.csv --until 10h");
    const std::size_t at = r.err.find("chosen period: ");
    return at == r.err.npos ? r.err : r.err.substr(at, r.err.find('\n', at) - at);
  };
  EXPECT_EQ(note(model + " " + model), note(model));
  EXPECT_THAT(note(model), testing::StartsWith("chosen period: 1201 of "));
}

TEST_F(Correction, CheckTellsWhatARecordIsWorth) {
  const json d = parsed(run("check " + corrections + "power/correction.toml " + corrections +
                            "power/train.csv --json"));
  EXPECT_EQ(d["sampling_s"], 30.0);
  EXPECT_EQ(d["readings"], 2880);
  EXPECT_EQ(d["time_constants_visible_s"], (json{60.0, 43185.0}));
  EXPECT_NEAR(d["quanta"]["front_bearing_temperature_C"].get<double>(), 0.1, 1e-9);
}

/// The share of each channel for each axis, and the errors that papers state.
TEST(CorrectionColumns, WritesTheShareOfEachChannelForEachAxis) {
  const ScratchFolder scratch;
  std::string model;
  for (const char* axis : {"z", "y"})
    model += fmt::format(
        "[[correction]]\ndisplacement = \"displacement_{0}_um\"\n[[correction.channel]]\n"
        "name = \"front\"\ninput = \"front_temperature_C\"\n"
        "sections = [{{ gain_um_K = {1}, time_constant_s = 1800 }}]\n[[correction.channel]]\n"
        "name = \"axis\"\ninput = \"x_position_mm\"\nfeedthrough_um_mm = {2}\n",
        axis, axis[0] == 'z' ? 4 : 2, axis[0] == 'z' ? 0.01 : -0.02);
  const std::string record = scratch.write(
      "day.csv", RecordOfADay{.columns = ",x_position_mm",
                              .cells = [](int k) { return fmt::format(",{}", (k / 30) % 2 * 400); },
                              .moves = [](int k, double) { return (k / 30) % 2 * 4.0; }}
                     .csv());
  const std::string out = scratch.file("out.csv");
  const Result ran = run("correct " + scratch.write("m.toml", model) + " " + record + " -o " + out);
  ASSERT_EQ(ran.status, 0) << ran.err;
  const std::string text = file_text(out);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "time_s,predicted_displacement_z_um,front_displacement_z_um,axis_displacement_z_um,"
            "residual_displacement_z_um,predicted_displacement_y_um,front_displacement_y_um,"
            "axis_displacement_y_um,residual_displacement_y_um");
  std::istringstream lines(text);
  std::string line;
  for (int k = 0; k < 100; ++k) std::getline(lines, line);
  std::vector<double> cells;
  std::istringstream words(line);
  for (std::string cell; std::getline(words, cell, ',');)
    cells.push_back(cell.empty() ? 0.0 : std::stod(cell));
  EXPECT_NEAR(cells[1], cells[2] + cells[3], 1e-6);
  EXPECT_NEAR(cells[5], cells[6] + cells[7], 1e-6);
  EXPECT_NEAR(cells[6], 0.5 * cells[2], 1e-6);
  EXPECT_THAT(ran.out, HasSubstr("displacement_z_um: mean absolute error"));
  EXPECT_THAT(ran.out, HasSubstr("% smaller than the largest displacement"));
}

/// Power and position as a control records them, found by their names.
TEST(CorrectionColumns, RecordedColumnsDriveAModel) {
  const ScratchFolder scratch;
  const std::string record = scratch.write(
      "day.csv",
      RecordOfADay{
          .columns = ",Spindle power [kW],x_position_mm",
          .cells =
              [](int k) { return fmt::format(",{},{}", (k / 200) % 2 * 1.5, (k / 30) % 2 * 400); },
          .moves = [](int k, double) { return (k / 30) % 2 * 4.0; }}
          .csv());
  const std::string model =
      z_model() +
      "[[correction.channel]]\nname = \"power\"\ninput = \"spindle_power_W\"\n"
      "sections = [{ gain_um_W = 0.001, time_constant_s = 900 }]\nwindow = { column = "
      "\"x_position_mm\", points = [0, 400, inf, inf] }\n[[correction.channel]]\n"
      "name = \"axis\"\ninput = \"x_position_mm\"\nfeedthrough_um_mm = 0.001\n";
  const std::string found = scratch.file("found.toml");
  const Result ran =
      run("identify " + scratch.write("m.toml", model) + " " + record + " --order 1 -o " + found);
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::ContainsRegex("axis.feedthrough +0.01"));
  EXPECT_THAT(ran.out, HasSubstr("um/mm"));
  EXPECT_THAT(file_text(found), HasSubstr("points = [0, 400, inf, inf]"));
  // What the model lacks is named by its column.
  const Result named = run("diagnose " + scratch.write("z.toml", z_model()) + " " + record);
  EXPECT_THAT(named.out, HasSubstr("input:x_position_mm")) << named.out << named.err;
  const std::string better = scratch.file("better.toml");
  ASSERT_EQ(run("add " + scratch.file("z.toml") + " input:x_position_mm --data " + record + " -o " +
                better)
                .status,
            0);
  EXPECT_THAT(file_text(better), testing::ContainsRegex("gain_um_mm = 0.0(1|09)"));
  EXPECT_EQ(run("export " + better + " --format python -o " + scratch.file("z.py")).status, 0);
}

/// Five approaches of a probe in every stop.
TEST(CorrectionStops, TellsTheRepeatabilityOfApproaches) {
  const ScratchFolder scratch;
  std::string text = "time_s,front_temperature_C,displacement_z_um\n";
  for (int k = 0; k < 40; ++k)
    for (int i = 0; i < 5; ++i)
      text += fmt::format("{},{:.2f},{:.3f}\n", 600 * k + 6 * i, 20 + 0.1 * k,
                          0.4 * k + 0.2 * ((7 * k + 3 * i * i) % 5 - 2));
  const std::string command =
      "check " + scratch.write("m.toml", z_model()) + " " + scratch.write("r.csv", text);
  EXPECT_THAT(
      run(command).out,
      HasSubstr("number of machine stops with repeated readings: 40; scatter of a reading ±"));
  const auto document = parsed(run(command + " --json"));
  EXPECT_EQ(document["repeatability"]["stops"].size(), 40u);
  EXPECT_EQ(document["repeatability"]["stops"][3]["readings"], 5);
  EXPECT_NEAR(document["repeatability"]["stops"][3]["mean_um"].get<double>(), 1.2, 0.4);
}

}  // namespace
}  // namespace raceway::tests

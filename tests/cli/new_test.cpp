// `raceway new` of a spindle and of a correction.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/cli/run_program.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string drift_record = tests::source_dir() + "/tests/cli/everyday/over-time/train.csv";

/// Small and large, of the catalogue and estimated, hybrid, and under each law.
TEST(New, ASpindleRunsAsItIsWritten) {
  const ScratchFolder scratch;
  for (const std::string bearing :
       {"", "'S 6006 E'", "HCB7014-C", "'SM 6014 C'", "'S 61920 C'", "'KH 6008 E'",
        "mine --bore 70 --outer-diameter 110", "'S 6014 C' --law contact", "'S 6014 C' --law skf",
        "'S 6014 C' --ball-material silicon-nitride"}) {
    const std::string model = scratch.file("spindle.toml");
    const Result written = run("new " + bearing + " --spindle --force -o " + model);
    ASSERT_EQ(written.status, 0) << bearing << written.err;
    // Status 2 where it does not converge.
    EXPECT_EQ(run("spindle " + model + " --speed 3000 --steady").status, 0) << bearing;
    EXPECT_EQ(run("modes " + model + " --speed 0:3000:1500").status, 0) << bearing;
  }
}

TEST(New, EveryAssumedNumberOfASpindleIsMarked) {
  const Result written = run("new --spindle");
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(written.out, HasSubstr("settings_hold = \"until row\""));
  std::istringstream lines(written.out);
  bool is_assumed = false;
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) {
      table = line;
      is_assumed = line.find("assumed") != line.npos;
    }
    const bool has_number = line.find(" = ") != line.npos && !line.starts_with('#') &&
                            line.find_first_of("0123456789", line.find(" = ")) != line.npos;
    // What the catalogue prints is no assumption, and friction says how sure it is.
    if (!has_number || line.starts_with("format") || table.starts_with("[bearing]") ||
        table.starts_with("[friction]"))
      continue;
    EXPECT_TRUE(is_assumed || line.find("assumed") != line.npos) << line;
  }
  EXPECT_THAT(written.out, HasSubstr("width_mm = 20"));
}

TEST(New, ASpindleHasBallBearings) {
  expect_refused(run("new 'N1012 KTN/SP' --spindle"), "a spindle needs ball bearings");
  expect_refused(run("new"), "BEARING is missing");
}

TEST(New, ACorrectionOfARecordIsFoundByIdentify) {
  const ScratchFolder scratch;
  const std::string model = scratch.file("drift.toml"), found = scratch.file("found.toml");
  const Result written = run("new --record " + drift_record + " -o " + model);
  ASSERT_EQ(written.status, 0) << written.err;
  const std::string text = file_text(model);
  EXPECT_THAT(text, HasSubstr("displacement = \"displacement_z_um\""));
  EXPECT_THAT(text, HasSubstr("name = \"bearing\"\ninput = \"bearing_temperature_C\""));
  EXPECT_THAT(text, HasSubstr("name = \"room\"\ninput = \"room_temperature_C\""));
  EXPECT_THAT(text, testing::ContainsRegex("tolerance_um = [0-9.]+  # assumed"));
  EXPECT_THAT(text, testing::ContainsRegex("sections = .*time_constant_s = 5000.0.*# assumed"));
  EXPECT_THAT(text, Not(HasSubstr("[columns]")));
  const Result identified = run("identify " + model + " " + drift_record + " --json -o " + found);
  ASSERT_EQ(identified.status, 0) << identified.err;
  const json bearing = json::parse(identified.out)["channels"][0]["sections"][0];
  EXPECT_NEAR(bearing["gain"]["value"].get<double>(), 5.0, 0.006);
  EXPECT_NEAR(bearing["time_constant_s"]["value"].get<double>(), 3600.0, 6.0);
  EXPECT_EQ(run("diagnose " + found + " " + drift_record).status, 0);
}

/// The record under headers of another program.
std::string german_drift(const std::string& displacement) {
  std::istringstream in(file_text(drift_record));
  std::string text = "Zeit;n Spindel [1/min];T Lager [\u00b0C];Raumtemperatur [\u00b0C];" +
                     displacement + "\n",
              line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    for (char& c : line) c = c == ',' ? ';' : c == '.' ? ',' : c;
    text += line + "\n";
  }
  return text;
}

TEST(New, ACorrectionHasTheColumnsOfAnotherProgram) {
  const ScratchFolder scratch;
  const std::string record = scratch.write("export.csv", german_drift("Verlagerung Z [\u00b5m]")),
                    model = scratch.file("drift.toml");
  ASSERT_EQ(run("new --record " + record + " -o " + model).status, 0);
  EXPECT_THAT(file_text(model), HasSubstr("[columns]\ntime_s = \"Zeit\""));
  const Result identified = run("identify " + model + " " + record + " --json");
  ASSERT_EQ(identified.status, 0) << identified.err;
  EXPECT_NEAR(
      json::parse(identified.out)["channels"][0]["sections"][0]["gain"]["value"].get<double>(), 5.0,
      0.006);
}

TEST(New, AMapNamesWhatTheWordsDoNot) {
  const ScratchFolder scratch;
  const std::string record = scratch.write("export.csv", german_drift("Y7")),
                    model = scratch.file("drift.toml");
  expect_refused(run("new --record " + record), "no column is a displacement");
  const std::string map = scratch.write("map.toml",
                                        "[columns]\nsettings_hold = \"until row\"\n"
                                        "displacement_y_um = \"Y7\"\n");
  const Result written = run("new --record " + record + " --columns " + map + " -o " + model);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(file_text(model), HasSubstr("displacement_y_um = { column = \"Y7\" }\n"));
  EXPECT_THAT(file_text(model), HasSubstr("settings_hold = \"until row\"\n"));
  EXPECT_EQ(run("identify " + model + " " + record).status, 0);
  expect_refused(run("new 'S 6014 C' --columns " + map), "--columns and --beside need --record");
  EXPECT_EQ(run("new 'S 6014 C' --record " + record).status, 1);
  EXPECT_EQ(run("new --law skf --record " + record).status, 1);
}

TEST(New, ManySensorsAreForABank) {
  const ScratchFolder scratch;
  const std::string real = tests::source_dir() + "/data/measurements/spindle_thermal/record.csv";
  const std::string model = scratch.file("many.toml");
  const Result written = run("new --record " + real + " -o " + model);
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(file_text(model), HasSubstr("16 temperatures vary"));
  EXPECT_THAT(file_text(model), HasSubstr("[[correction]]"));
  EXPECT_THAT(file_text(model), Not(HasSubstr("[[correction.channel]]")));
  EXPECT_EQ(run("check " + model + " --json").status, 0);
}

/// A unit that looks wrong is told; the file has no result.
TEST(New, ACorrectionOfMillimetresIsWarnedOf) {
  const ScratchFolder scratch;
  std::istringstream in(file_text(drift_record));
  std::string text, line;
  std::getline(in, line);
  text = line + "\n";
  while (std::getline(in, line)) {
    const std::size_t last = line.rfind(',') + 1;
    text += fmt::format("{}{:.6f}\n", line.substr(0, last), 1e-3 * std::stod(line.substr(last)));
  }
  const std::string record = scratch.write("mm.csv", text), model = scratch.file("mm.toml");
  const Result written = run("new --record " + record + " -o " + model);
  EXPECT_EQ(written.status, 0);
  EXPECT_THAT(written.err, HasSubstr("warning: displacement_z_um changes by"));
  expect_refused(run("identify " + model + " " + record), "unit = \"mm\" }");
}

}  // namespace
}  // namespace raceway::tests

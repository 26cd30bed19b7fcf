// One record over time, whose truth is known (tests/cli/everyday/README.md), in the forms in which
// loggers and controls export it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string folder_of_record = tests::source_dir() + "/tests/cli/everyday/over-time/";
const std::string record_model = folder_of_record + "model.toml";

using Cells = std::vector<std::string>;
constexpr std::size_t at_time = 0, at_bearing = 2, at_room = 3, at_displacement = 4;

Cells cells_of(const std::string& line) {
  Cells cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The record with each row changed, in a file of its own.
struct Exported {
  ScratchFolder folder;
  std::string file;

  /// `row` counts from 1, the header is 0.
  explicit Exported(const std::function<void(std::size_t row, Cells&)>& change) {
    std::istringstream in(file_text(folder_of_record + "train.csv"));
    std::string text;
    std::size_t row = 0;
    for (std::string line; std::getline(in, line); ++row) {
      Cells cells = cells_of(line);
      change(row, cells);
      text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    file = folder.write("export.csv", text);
  }

  [[nodiscard]] std::vector<std::string> commands() const {
    const std::string both = record_model + " " + file;
    return {"check " + both, "identify " + both, "compare " + both, "calibrate " + both,
            "diagnose " + both};
  }
};

/// One cell of every row as a number times a factor.
Exported scaled(std::size_t column, double factor, double offset = 0.0) {
  return Exported([=](std::size_t row, Cells& cells) {
    if (row > 0) cells[column] = fmt::format("{:.9g}", factor * std::stod(cells[column]) + offset);
  });
}

/// `coarse`: temperatures were read so seldom that their corners are round.
void expect_truth(const std::string& data, const std::string& flags = "", bool coarse = false) {
  const Result found = run("identify " + record_model + " " + data + " --json " + flags);
  ASSERT_EQ(found.status, 0) << found.err;
  const json channels = json::parse(found.out)["channels"];
  ASSERT_EQ(channels.size(), 2u);
  const auto near = [&](std::size_t channel, double gain, double gain_within, double lag,
                        double lag_within) {
    const json section = channels[channel]["sections"][0];
    EXPECT_NEAR(section["gain"]["value"].get<double>(), gain, gain_within);
    EXPECT_NEAR(section["time_constant_s"]["value"].get<double>(), lag, lag_within);
  };
  // Three standard errors.
  near(0, 5.0, coarse ? 0.03 : 0.006, 3600.0, coarse ? 30.0 : 6.0);
  near(1, -2.0, 0.06, 9000.0, 300.0);
}

TEST(LoggerExports, TheRecordItselfIsAskedNothing) {
  const Exported as_it_is([](std::size_t, Cells&) {});
  for (const std::string& command : as_it_is.commands())
    EXPECT_THAT(run(command).err, Not(HasSubstr("Say so in [columns]"))) << command;
  expect_truth(as_it_is.file);
}

/// Of readings from 0 to 98 um one of 1000, at a steady speed and at a change of it.
TEST(LoggerExports, AReadingThatCannotBeIsNamedAndLeftOut) {
  const Exported wild([](std::size_t row, Cells& cells) {
    if (row == 99 || row == 272) cells[at_displacement] = "1000";
  });
  for (const std::string& command : wild.commands()) {
    const Result result = run(command);
    EXPECT_EQ(result.status, 0) << command << result.err;
    EXPECT_THAT(result.err, HasSubstr("note: 2 readings of displacement z leave and return"))
        << command;
    EXPECT_THAT(result.err, HasSubstr("take no part, lines 100, 273")) << command;
  }
  EXPECT_THAT(run("correct " + record_model + " " + wild.file).err, HasSubstr("lines 100, 273"));
  expect_truth(wild.file);
}

TEST(LoggerExports, DisplacementsInMillimetresAreAskedAboutBeforeAnyResult) {
  const Exported in_mm = scaled(at_displacement, 1e-3);
  for (const std::string& command : in_mm.commands())
    expect_refused(run(command),
                   "is it in mm, 3.67 um/K? Say so in [columns]: displacement_z_um = { column = "
                   "\"displacement_z_um\", unit = \"mm\" }");
  const std::string map = in_mm.folder.write(
      "map.toml",
      "[columns]\ndisplacement_z_um = { column = \"displacement_z_um\", unit = \"mm\" }\n");
  expect_truth(in_mm.file, "--columns " + map);
}

TEST(LoggerExports, TimesInOtherUnitsAreAskedAboutBeforeAnyResult) {
  for (const auto& [factor, unit] :
       {std::pair{1.0 / 60.0, "min"}, {1e3, "ms"}, {1.0 / 3600.0, "h"}}) {
    const Exported other = scaled(at_time, factor);
    for (const std::string& command : other.commands())
      expect_refused(run(command),
                     fmt::format("is time_s in {}, so that they come every 60 s over 14 h? "
                                 "Say so in [columns]: time_s = {{ column = \"time_s\", unit "
                                 "= \"{}\" }}",
                                 unit, unit));
    const std::string map = other.folder.write(
        "map.toml",
        fmt::format("[columns]\ntime_s = {{ column = \"time_s\", unit = \"{}\" }}\n", unit));
    expect_truth(other.file, "--columns " + map);
  }
}

TEST(LoggerExports, TemperaturesInOtherUnitsAreAskedAboutBeforeAnyResult) {
  for (const auto& [factor, offset, unit] :
       {std::tuple{1.0, 273.15, "K"}, std::tuple{1.8, 32.0, "F"}}) {
    const Exported other([&](std::size_t row, Cells& cells) {
      if (row == 0) return;
      for (const std::size_t c : {at_bearing, at_room})
        cells[c] = fmt::format("{:.9g}", factor * std::stod(cells[c]) + offset);
    });
    for (const std::string& command : other.commands())
      expect_refused(run(command), fmt::format("bearing_temperature_C = {{ column = "
                                               "\"bearing_temperature_C\", unit = \"{}\" }}",
                                               unit));
  }
}

/// The rows from 20:11:33 on the given day, the stamp made by `stamp` of the seconds since
/// midnight.
Exported stamped(const std::string& header, const std::function<std::string(int seconds)>& stamp) {
  return Exported([=](std::size_t row, Cells& cells) {
    cells[at_time] = row == 0 ? header : stamp(72693 + 60 * (static_cast<int>(row) - 1));
  });
}

std::string clock_of(int seconds) {
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600 % 24, seconds / 60 % 60, seconds % 60);
}

std::string half_day_clock_of(int seconds) {
  const int hour = seconds / 3600 % 24;
  return fmt::format("{:02}:{:02}:{:02} {}", hour % 12 == 0 ? 12 : hour % 12, seconds / 60 % 60,
                     seconds % 60, hour < 12 ? "AM" : "PM");
}

TEST(LoggerExports, ADateAndATimeInTwoColumnsAreOneTime) {
  using Date = const char* (*)(bool next);
  const std::pair<Date, std::string (*)(int)> forms[] = {
      {[](bool next) { return next ? "2024-09-12" : "2024-09-11"; }, clock_of},
      {[](bool next) { return next ? "12.09.24" : "11.09.24"; }, clock_of},
      {[](bool next) { return next ? "09/14/2024" : "09/13/2024"; }, half_day_clock_of}};
  for (const auto& [date, clock] : forms) {
    const Exported two = stamped("Date,Time", [&](int seconds) {
      return fmt::format("{},{}", date(seconds >= 86400), clock(seconds));
    });
    // Whichever of the two is named.
    for (const char* named : {"Time", "Date"}) {
      const std::string map =
          two.folder.write("map.toml", fmt::format("[columns]\ntime_s = \"{}\"\n", named));
      expect_truth(two.file, "--columns " + map);
      EXPECT_THAT(run("check " + record_model + " " + two.file + " --columns " + map).err,
                  HasSubstr("together are time_s"));
    }
  }
}

TEST(LoggerExports, TimesOfDayGoOnBehindMidnight) {
  for (const auto& clock : {clock_of, half_day_clock_of}) {
    const Exported of_day = stamped("Time", clock);
    const std::string map = of_day.folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n");
    expect_truth(of_day.file, "--columns " + map);
    EXPECT_THAT(
        run("check " + record_model + " " + of_day.file + " --columns " + map).err,
        HasSubstr("column Time passes midnight once, first before line 231: time_s goes on"));
  }
}

TEST(LoggerExports, ASpeedThatIsWrittenWhenItChangesHolds) {
  std::string last;
  const Exported on_change([&](std::size_t row, Cells& cells) {
    if (row == 0) return;
    const std::string now = cells[1];
    if (row > 1 && now == last) cells[1] = "";
    last = now;
  });
  expect_truth(on_change.file);
  EXPECT_THAT(
      run("check " + record_model + " " + on_change.file).err,
      HasSubstr("833 of 841 rows have no speed_rpm: the last value holds until the next one"));
}

TEST(LoggerExports, SensorsOfOtherRatesAreAligned) {
  const Exported joined([](std::size_t row, Cells& cells) {
    if (row == 0) return;
    if ((row - 1) % 5 != 0) cells[at_bearing] = "";
    if ((row - 1) % 30 != 0) cells[at_room] = "";
  });
  expect_truth(joined.file, "", true);
  EXPECT_THAT(run("check " + record_model + " " + joined.file).err,
              HasSubstr("812 of 841 rows have no room_temperature_C: a straight line goes from one "
                        "reading to the next, over gaps of up to 1.8e+04 s"));
}

TEST(LoggerExports, ReadingsThatCannotBeTrueAreNamedAndDoNotTakePart) {
  for (const char* mark : {"-9999", "9.9e37", "OVER"}) {
    const Exported faulty([&](std::size_t row, Cells& cells) {
      if (row == 201 || row == 202 || row == 601) cells[at_displacement] = mark;
    });
    expect_truth(faulty.file);
    for (const char* command : {"check ", "identify ", "compare "})
      EXPECT_THAT(
          run(command + record_model + " " + faulty.file).err,
          HasSubstr(fmt::format("3 of 841 readings of displacement_z_um are no readings ({}) "
                                "and do not take part (lines 202, 203, 602)",
                                mark)));
  }
}

/// A room goes through steps of 0.5 K in hours: a program that took it for stuck after one hour
/// would not correct.
TEST(LoggerExports, AnExportGivesCoarseSensorsTheTimeThatTheyNeed) {
  const Exported coarse([](std::size_t row, Cells& cells) {
    if (row > 0)
      cells[at_room] = fmt::format("{}", std::round(2.0 * std::stod(cells[at_room])) / 2.0);
  });
  const std::string command = "export " + record_model + " --format csv --record ";
  const Result found = run(command + coarse.file);
  ASSERT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(found.err, HasSubstr("room_temperature_C stands still for "));
  EXPECT_THAT(found.err, HasSubstr("in steps of 0.5 K: it counts as stuck after "));
  EXPECT_THAT(found.err, Not(HasSubstr("bearing_temperature_C stands still")));
  EXPECT_THAT(run(command + folder_of_record + "train.csv").err, Not(HasSubstr("counts as stuck")));
}

}  // namespace
}  // namespace raceway::tests

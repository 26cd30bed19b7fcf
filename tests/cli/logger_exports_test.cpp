// One record over time, whose truth is known (tests/cli/everyday/README.md), in the forms in which
// loggers and controls export it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
  explicit Exported(const std::function<void(std::size_t row, Cells&)>& change,
                    const std::string& of = folder_of_record + "train.csv") {
    std::istringstream in(file_text(of));
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
    EXPECT_THAT(run(command).err, Not(HasSubstr("If so, set the unit in [columns]:"))) << command;
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
    EXPECT_THAT(result.err, HasSubstr("note: 2 readings of displacement z jump and return"))
        << command;
    EXPECT_THAT(result.err, HasSubstr("are not used, lines 100, 273")) << command;
  }
  EXPECT_THAT(run("correct " + record_model + " " + wild.file).err, HasSubstr("lines 100, 273"));
  expect_truth(wild.file);
}

TEST(LoggerExports, DisplacementsInMillimetresAreAskedAboutBeforeAnyResult) {
  const Exported in_mm = scaled(at_displacement, 1e-3);
  for (const std::string& command : in_mm.commands())
    expect_refused(
        run(command),
        "are the values in mm (then the change is 3.67 um/K)? If so, set the unit in [columns]: "
        "displacement_z_um = { column = "
        "\"displacement_z_um\", unit = \"mm\" }");
  const std::string map = in_mm.folder.write(
      "map.toml",
      "[columns]\ndisplacement_z_um = { column = \"displacement_z_um\", unit = \"mm\" }\n");
  expect_truth(in_mm.file, "--columns " + map);
}

TEST(LoggerExports, TimesInOtherUnitsAreAskedAboutBeforeAnyResult) {
  for (const auto& [factor, unit] :
       {std::pair{1.0 / 60.0, "min"}, {1e3, "ms"}, {1.0 / 3600.0, "h"}, {1.0 / 86400.0, "d"}}) {
    const Exported other = scaled(at_time, factor);
    for (const std::string& command : other.commands())
      expect_refused(
          run(command),
          fmt::format("is time_s in {} instead of s (then the sampling interval is 60 s and the "
                      "duration 14 h)? If so, set the unit in [columns]: time_s = {{ column = "
                      "\"time_s\", unit = \"{}\" }}",
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

// One of two temperatures is in F: it is far warmer than the other, in a machine from a room of 20
// C.
TEST(LoggerExports, OneTemperatureInFahrenheitIsAskedAboutBeforeAnyResult) {
  const Exported one = scaled(at_bearing, 1.8, 32.0);
  for (const std::string& command : one.commands())
    expect_refused(
        run(command),
        "are the values in fahrenheit, that is 19.3 to 45.8 C? If so, set the unit in [columns]: "
        "bearing_temperature_C = { column = \"bearing_temperature_C\", unit = \"F\" }");
}

// A simulation explains the readings in one unit alone.
TEST(LoggerExports, UnitsOfARecordOfASpindleAreAskedAboutBeforeAnyResult) {
  const std::string folder = tests::source_dir() + "/data/spindles/clean/";
  constexpr std::size_t time = 0, speed = 1, shaft_end = 8;
  const auto refused = [&](std::size_t column, double factor, double offset,
                           const std::string& question) {
    const Exported other(
        [&](std::size_t row, Cells& cells) {
          if (row > 1)  // below a comment and the header
            cells[column] = fmt::format("{:.9g}", factor * std::stod(cells[column]) + offset);
        },
        folder + "train.csv");
    for (const char* command : {"check ", "compare "})
      expect_refused(run(command + folder + "model.toml " + other.file), question);
  };
  for (const auto& [factor, unit] : {std::pair{1.0 / 60.0, "min"}, {1.0 / 86400.0, "d"}})
    refused(time, factor, 0.0,
            fmt::format("is time_s in {0} instead of s (then the sampling interval is 60 s and the "
                        "duration 7.98 h)? If so, set the unit in [columns]: time_s = {{ column = "
                        "\"time_s\", unit = \"{0}\" }}",
                        unit));
  for (const auto& [factor, words, unit] : {std::tuple{1.0 / 60.0, "1/s", "1_s"},
                                            {std::acos(-1.0) / 30.0, "rad/s", "rad_s"},
                                            {1e-3, "krpm", "krpm"}})
    refused(speed, factor, 0.0,
            fmt::format("are the values in {} instead of rpm? If so, set the unit in [columns]: "
                        "speed_rpm = {{ column = "
                        "\"speed_rpm\", unit = \"{}\" }}",
                        words, unit));
  refused(shaft_end, 1.8, 32.0,
          "shaft_end_temperature_C goes from 67.84 to 102.6 C: are the values in fahrenheit");
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
                  HasSubstr("are read together as"));
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
        HasSubstr("the times in column Time pass midnight once, first before line 231: time_s "
                  "continues without a jump"));
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
      HasSubstr("833 of 841 rows have no speed_rpm: the last value is used until the next one"));
}

TEST(LoggerExports, SensorsOfOtherRatesAreAligned) {
  const Exported joined([](std::size_t row, Cells& cells) {
    if (row == 0) return;
    if ((row - 1) % 5 != 0) cells[at_bearing] = "";
    if ((row - 1) % 30 != 0) cells[at_room] = "";
  });
  expect_truth(joined.file, "", true);
  EXPECT_THAT(run("check " + record_model + " " + joined.file).err,
              HasSubstr("812 of 841 rows have no room_temperature_C: values are interpolated "
                        "linearly between readings, over gaps of up to 1.8e+04 s"));
}

TEST(LoggerExports, ReadingsThatCannotBeTrueAreNamedAndDoNotTakePart) {
  for (const char* mark : {"-9999", "9.9e37", "OVER"}) {
    const Exported faulty([&](std::size_t row, Cells& cells) {
      if (row == 201 || row == 202 || row == 601) cells[at_displacement] = mark;
    });
    expect_truth(faulty.file);
    for (const char* command : {"check ", "identify ", "compare "})
      EXPECT_THAT(run(command + record_model + " " + faulty.file).err,
                  HasSubstr(fmt::format("3 of 841 readings of displacement_z_um have no valid "
                                        "value ({}) and are not used (lines 202, 203, 602)",
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
  EXPECT_THAT(found.err, HasSubstr("room_temperature_C did not change for "));
  EXPECT_THAT(found.err, HasSubstr(", so the exported program reports it as stuck after"));
  EXPECT_THAT(found.err, Not(HasSubstr("bearing_temperature_C did not change")));
  EXPECT_THAT(run(command + folder_of_record + "train.csv").err,
              Not(HasSubstr(", so the exported program reports it as stuck after")));
  // The identified model keeps the time without the record.
  const std::string model = coarse.folder.file("found.toml");
  ASSERT_EQ(run("identify " + record_model + " " + coarse.file + " -o " + model).status, 0);
  EXPECT_THAT(file_text(model), HasSubstr("\n[correction.still_s]"));
  const std::string table = coarse.folder.file("found.csv");
  EXPECT_THAT(run("export " + model + " --format csv -o " + table).err,
              AllOf(HasSubstr(", so the exported program reports it as stuck after"),
                    Not(HasSubstr("bearing_temperature_C did not change"))));
  EXPECT_THAT(run("export " + model + " --format csv --record " + coarse.file).err,
              Not(HasSubstr("instead of 24600 s")));
}

/// From 20:11:33 on the 11th: only a year in front makes a day of what passes at midnight.
TEST(LoggerExports, AYearOfTwoDigitsInFrontIsReadWhereItIsDecided) {
  const auto date = [](int seconds) {
    return fmt::format("24/09/{} {}", seconds < 86400 ? 11 : 12, clock_of(seconds));
  };
  const Exported japanese = stamped("Time", date);
  const std::string map = japanese.folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n");
  expect_truth(japanese.file, "--columns " + map);
  EXPECT_THAT(run("check " + record_model + " " + japanese.file + " --columns " + map).err,
              HasSubstr(": time_s is measured from"));
  // At the end of a month it may be another month, or another day.
  const Exported undecided = stamped("Time", [](int seconds) {
    return fmt::format("{}/12 {}", seconds < 86400 ? "10/11" : "10/12", clock_of(seconds));
  });
  expect_refused(run("check " + record_model + " " + undecided.file + " --columns " +
                     undecided.folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n")),
                 "Set date_order = \"day first\", \"month first\" or \"year first\" in [columns]");
  const std::string said = undecided.folder.write(
      "said.toml", "[columns]\ndate_order = \"month first\"\ntime_s = \"Time\"\n");
  expect_truth(undecided.file, "--columns " + said);
}

// As whole numbers of seconds these had run for 2e13 s.
TEST(LoggerExports, DatesOfDigitsAloneAreRead) {
  const Exported digits = stamped("Time", [](int seconds) {
    std::string clock = clock_of(seconds);
    std::erase(clock, ':');
    return fmt::format("202409{}{}", seconds < 86400 ? 11 : 12, clock);
  });
  const auto map = [&](const char* unit) {
    return digits.folder.write(
        "map.toml", fmt::format("[columns]\ntime_s = {{ column = \"Time\"{} }}\n", unit));
  };
  expect_truth(digits.file, "--columns " + map(""));
  const std::string check = "check " + record_model + " " + digits.file + " --columns ";
  EXPECT_THAT(run(check + map("")).err, HasSubstr(": time_s is measured from"));
  // A unit says that they are numbers.
  EXPECT_THAT(run(check + map(", unit = \"s\"")).err, Not(HasSubstr("is measured from")));
}

TEST(LoggerExports, UnitsInCellsAreRead) {
  const Exported with_units([](std::size_t row, Cells& cells) {
    if (row == 0) return;
    cells[at_time] += " s";
    cells[at_bearing] = fmt::format("{:.3f} K", std::stod(cells[at_bearing]) + 273.15);
    cells[at_room] += " \u00b0C";
    cells[at_displacement] = fmt::format("{:.6f} mm", 1e-3 * std::stod(cells[at_displacement]));
  });
  const std::string map = with_units.folder.write(
      "map.toml",
      "[columns]\nbearing_temperature_C = { column = \"bearing_temperature_C\", unit = \"K\" }\n"
      "displacement_z_um = { column = \"displacement_z_um\", unit = \"mm\" }\n");
  expect_truth(with_units.file, "--columns " + map);
  // A name that says another unit than the cells is refused.
  expect_refused(run("check " + record_model + " " + with_units.file),
                 "give different units; correct one of them");
}

/// A clock of local time, rows as they come.
Exported in_the_night(int first_second, bool forward, int jitter) {
  return stamped("Time", [=](int seconds) {
    int now = seconds - 72693 + first_second;
    now += jitter > 0 ? (now * 7919) % jitter : 0;
    constexpr int change = 3 * 3600;
    // 31 March and 27 October 2024, from the evening before on.
    if (now >= 86400 + change - (forward ? 3600 : 0)) now += forward ? 3600 : -3600;
    return fmt::format("{}.{}.2024 {}", (forward ? 30 : 26) + now / 86400, forward ? "03" : "10",
                       clock_of(now % 86400));
  });
}

TEST(LoggerExports, ChangesOfClocksAreRecognisedWhereRowsAreUneven) {
  for (const bool forward : {false, true})
    for (const int jitter : {0, 40}) {
      const Exported night = in_the_night(20 * 3600, forward, jitter);
      const std::string map = night.folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n");
      const Result checked = run("check " + record_model + " " + night.file + " --columns " + map);
      EXPECT_THAT(checked.err, HasSubstr(forward ? "the clock goes forward by one hour"
                                                 : "the clock goes back by one hour"))
          << jitter;
      expect_truth(night.file, "--columns " + map, jitter > 0);
    }
}

TEST(LoggerExports, FilesWithClocksOfTheirOwnAreOneRecord) {
  // Temperatures every minute, the speed when it changes, readings of the probe 20 s later; each
  // file has another name for the time.
  const Exported temperatures([](std::size_t, Cells& cells) {
    cells = {cells[0], cells[2], cells[3]};
  });
  std::string last, speeds, probe = "Timestamp,displacement_z_um\n";
  std::istringstream in(file_text(folder_of_record + "train.csv"));
  for (std::string line; std::getline(in, line);) {
    const Cells cells = cells_of(line);
    // The number of the block in the program is kept.
    if (cells[1] != last)
      speeds += (last.empty() ? "Zeit" : cells[0]) + "," + cells[1] +
                (last.empty() ? ",block" : ",10") + "\n";
    last = cells[1];
    if (cells[0] != "time_s") probe += cells[0] + ".0," + cells[4] + "\n";
  }
  const std::string beside =
      " --beside " + temperatures.folder.write("speed.csv", speeds) + " --beside " +
      temperatures.folder.write("probe.csv", probe) + " --columns " +
      temperatures.folder.write("map.toml", "[columns]\ntime_s = [\"Zeit\", \"Timestamp\"]\n");
  expect_truth(temperatures.file, beside);
  const Result checked = run("check " + record_model + " " + temperatures.file + beside);
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.err, HasSubstr("speed.csv and "));
  EXPECT_THAT(checked.err, HasSubstr("are joined into one record of"));
  EXPECT_THAT(checked.err,
              HasSubstr("have no speed_rpm: the last value is used until the next one"));
  EXPECT_THAT(checked.err, HasSubstr("speed.csv has one row for each change of a setting: its last "
                                     "row, at 41460 s, applies until the end of the record"));
  expect_refused(
      run("check " + record_model + " " + temperatures.file + " --beside " + temperatures.file),
      "is also in another of the joined files; keep it in one file only");
}

TEST(LoggerExports, OneOfTheJoinedFilesMayNameTheRuns) {
  const Exported temperatures([](std::size_t row, Cells& cells) {
    const std::string run = row == 0 ? "run_id" : row < 300 ? "monday" : "tuesday";
    cells = {cells[0], cells[1], cells[2], cells[3], run};
  });
  std::string probe;
  std::istringstream in(file_text(folder_of_record + "train.csv"));
  for (std::string line; std::getline(in, line);) {
    const Cells cells = cells_of(line);
    probe += cells[0] + "," + cells[4] + "\n";
  }
  const std::string rows = temperatures.folder.file("rows.csv");
  const Result r = run("check " + record_model + " " + temperatures.file + " --beside " +
                       temperatures.folder.write("probe.csv", probe) + " -o " + rows);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(file_text(rows), HasSubstr("monday"));
  EXPECT_THAT(file_text(rows), HasSubstr("tuesday"));
}

TEST(LoggerExports, ANewCorrectionComesFromSeveralFiles) {
  const Exported temperatures([](std::size_t row, Cells& cells) {
    if (row == 0) cells = {"Zeit [s]", "n [1/min]", "T Lager [\u00b0C]", "T Raum [\u00b0C]"};
    cells.resize(4);
  });
  std::string probe;
  std::istringstream in(file_text(folder_of_record + "train.csv"));
  for (std::string line; std::getline(in, line);) {
    const Cells cells = cells_of(line);
    probe += probe.empty() ? "t in s,Taster [um]\n" : cells[0] + "," + cells[4] + "\n";
  }
  const std::string beside = " --beside " + temperatures.folder.write("probe.csv", probe);
  const std::string model = temperatures.folder.file("new.toml");
  const Result made = run("new --record " + temperatures.file + beside + " -o " + model);
  ASSERT_EQ(made.status, 0) << made.err;
  const Result found = run("identify " + model + " " + temperatures.file + beside);
  EXPECT_EQ(found.status, 0) << found.err;
  const Result map =
      run("check " + model + " " + temperatures.file + beside + " --suggest-columns");
  EXPECT_THAT(map.out, HasSubstr("\ntime_s = ["));
}

TEST(LoggerExports, ARecordWithoutTheProbeIsPredicted) {
  const Exported production([](std::size_t, Cells& cells) { cells.resize(4); });
  const std::string map = production.folder.write(
      "map.toml", "[columns]\ndisplacement_z_um = \"probe\"\ntime_s = \"time_s\"\n");
  const std::string files = record_model + " " + production.file + " --columns " + map;
  const Result alone = run("correct " + files);
  EXPECT_EQ(alone.status, 0);
  EXPECT_THAT(alone.err, HasSubstr("no column \"probe\", which "));
  EXPECT_EQ(run("export " + record_model + " --format csv --accept-untrusted --columns " + map +
                " --record " + production.file)
                .status,
            0);
  expect_refused(run("export " + record_model + " --format csv --columns " + map),
                 "--columns, --beside and --drop-nan need --record");
  expect_refused(run("compare " + files), "the column \"probe\" is missing; ");
}

// The runs of the record stand in one file, the speed when it changes in another.
TEST(LoggerExports, ASpeedHoldsIntoTheNextRun) {
  const Exported temperatures([](std::size_t row, Cells& cells) {
    cells = {cells[0], cells[2], cells[3], cells[4],
             row == 0    ? "run_id"
             : row < 300 ? "monday"
                         : "tuesday"};
  });
  const std::string speed = temperatures.folder.write("speed.csv", "time_s,speed_rpm\n0,3000\n");
  const Result r = run("check " + record_model + " " + temperatures.file + " --beside " + speed);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.err, Not(HasSubstr("before the first value")));
}

TEST(LoggerExports, FilesOfDifferentClocksAreNotJoined) {
  const ScratchFolder folder;
  // Every ten minutes from 01:00 on; the clock of `changes` goes back at 03:00.
  const auto file = [&](const char* name, const std::string& columns, const char* zone,
                        bool changes) {
    std::string text = fmt::format("Time,{}\n", columns);
    for (int minute = 60; minute < 360; minute += 10) {
      const int shown = changes && minute >= 180 ? minute - 60 : minute;
      text += fmt::format("2024-10-27T{:02}:{:02}:00{}", shown / 60, shown % 60, zone);
      for (auto k = std::count(columns.begin(), columns.end(), ','); k >= 0; --k)
        text += fmt::format(",{}", 20 + minute % 7);
      text += "\n";
    }
    return folder.write(name, text);
  };
  const std::string map = folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n");
  const auto joined = [&](const std::string& a, const std::string& b) {
    return run("check " + record_model + " " + a + " --beside " + b + " --columns " + map);
  };
  const std::string temperatures = "bearing_temperature_C,room_temperature_C,displacement_z_um",
                    speed = file("speed.csv", "speed_rpm", "", false),
                    changing = file("changing.csv", temperatures, "", true),
                    zoned = file("zoned.csv", temperatures, "+01:00", false);
  for (const auto& [a, b] : {std::pair(speed, changing), std::pair(changing, speed)})
    expect_refused(joined(a, b), "changing.csv:14: the clock goes back by one hour, and ");
  expect_refused(joined(speed, zoned), "have an offset from UTC, and the dates of ");
  // One that begins after the change: there, 04:00 is four hours after 01:00.
  const std::string later =
      folder.write("later.csv", "Time,speed_rpm\n2024-10-27T04:00:00,20\n2024-10-27T04:50:00,30\n");
  const std::string rows = folder.file("rows.csv");
  const Result r = run("check " + record_model + " " + changing + " --beside " + later +
                       " --columns " + map + " -o " + rows);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(file_text(rows), HasSubstr("\n14400,"));
  EXPECT_THAT(r.err, HasSubstr("rows before 14400 s"));
}

/// A logger that samples has stopped: what the control set after its last row is not known.
TEST(LoggerExports, AFileBesideThatSamplesEndsWithItsLastRow) {
  const Exported rest([](std::size_t, Cells& cells) { cells.erase(cells.begin() + 1); });
  std::string speeds;
  std::istringstream in(file_text(folder_of_record + "train.csv"));
  for (std::string line; std::getline(in, line) && speeds.size() < 4000;)
    speeds += cells_of(line)[0] + "," + cells_of(line)[1] + "\n";
  const Result checked = run("check " + record_model + " " + rest.file + " --beside " +
                             rest.folder.write("speed.csv", speeds));
  EXPECT_THAT(
      checked.err,
      HasSubstr("s are not used, because one of the joined files does not cover this time"));
  EXPECT_THAT(checked.err, Not(HasSubstr("s, applies until the end")));
}

TEST(LoggerExports, ALoggerThatBeganAnewRepeatsItsHeaderAndItsUnits) {
  const Exported anew([](std::size_t row, Cells& cells) {
    const std::string header =
        "time_s,speed_rpm,bearing_temperature_C,room_temperature_C,"
        "displacement_z_um\ns,rpm,°C,°C,µm\n";
    if (row == 0) cells = {header.substr(0, header.size() - 1)};
    if (row == 300) cells[0] = "Logger stopped\n" + header + cells[0];
  });
  const Result checked = run("check " + record_model + " " + anew.file);
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(
      checked.err,
      HasSubstr("the header occurs once more in the file; the program skips each repetition"));
  expect_truth(anew.file);
}

/// "Tue Mar 12 20:11:33 2024" of ctime(), and hours and minutes without seconds.
TEST(LoggerExports, DatesOfCtimeAndTimesWithoutSecondsAreRead) {
  const Exported dates = stamped("Time", [](int seconds) {
    return fmt::format("Tue Mar {:2} {} 2024", 12 + seconds / 86400, clock_of(seconds % 86400));
  });
  const std::string map = dates.folder.write("map.toml", "[columns]\ntime_s = \"Time\"\n");
  expect_truth(dates.file, "--columns " + map);

  const auto written = [&](const std::string& header) {
    return Exported([=](std::size_t row, Cells& cells) {
      const int at = row > 0 ? static_cast<int>(row) - 1 : 0;
      cells[at_time] = row == 0 ? header : fmt::format("{}:{:02}", at / 60, at % 60);
    });
  };
  const Exported asked = written("Time"), form = written("Time [h:mm]");
  expect_refused(run("identify " + record_model + " " + asked.file + " --columns " + map),
                 ": does the column have hours and minutes, or minutes and seconds? Set unit = "
                 "\"h\" or \"min\" in [columns]:");
  const std::string hours =
      asked.folder.write("hours.toml", "[columns]\ntime_s = { column = \"Time\", unit = \"h\" }\n");
  expect_truth(asked.file, "--columns " + hours);
  const std::string named =
      form.folder.write("named.toml", "[columns]\ntime_s = \"Time [h:mm]\"\n");
  expect_truth(form.file, "--columns " + named);
}

TEST(LoggerExports, AFileBesideMayHaveItsUnitsAskedFor) {
  const Exported inputs([](std::size_t, Cells& cells) { cells.resize(4); });
  std::string probe = "time_s,displacement_z_um\n";
  std::istringstream in(file_text(folder_of_record + "train.csv"));
  for (std::string line; std::getline(in, line);) {
    const Cells cells = cells_of(line);
    if (cells[0] != "time_s")
      probe += fmt::format("{},{:.6f}\n", cells[0], 1e-3 * std::stod(cells[4]));
  }
  expect_refused(run("identify " + record_model + " " + inputs.file + " --beside " +
                     inputs.folder.write("probe.csv", probe)),
                 "displacement_z_um = { column = \"displacement_z_um\", unit = \"mm\" }");
}

TEST(LoggerExports, ALongGapOfASensorBreaksTheRecord) {
  const Exported gap([](std::size_t row, Cells& cells) {
    if (row >= 401 && row < 461) cells[at_room] = "";
  });
  const Result found = run("identify " + record_model + " " + gap.file);
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(
      found.err,
      HasSubstr(
          "room_temperature_C has no reading for more than 10 min, line 402 to 461: "
          "the program treats these rows as a gap of the record and does not use their readings"));
  expect_truth(gap.file, "", true);
}

TEST(LoggerExports, AnInputThatIsImpossibleIsNamedAndLeftOut) {
  for (const char* wild : {"850.0", "1372", "300"}) {
    const Exported spikes([&](std::size_t row, Cells& cells) {
      if (row == 99 || row == 500) cells[at_bearing] = wild;
    });
    const Result found = run("check " + record_model + " " + spikes.file);
    EXPECT_EQ(found.status, 0) << found.err;
    EXPECT_THAT(found.err, testing::ContainsRegex("2 (of 841 )?readings of bearing.temperature"));
    EXPECT_THAT(found.err, testing::ContainsRegex("are not used|are left out"));
    EXPECT_THAT(found.err, HasSubstr("100, 501"));
    expect_truth(spikes.file);
  }
}

TEST(LoggerExports, ColumnsThatNoModelHasAreKeptAndSharesAreInputs) {
  const Exported more([](std::size_t row, Cells& cells) {
    cells.push_back(row == 0 ? "X axis [mm]" : fmt::format("{}", row % 50));
    cells.push_back(row == 0 ? "spindle load (%)" : row % 7 == 0 ? "" : "23.5");
    cells.push_back(row == 0 ? "operator" : "day shift");
  });
  const std::string rows = more.folder.file("rows.csv");
  const Result checked = run("check " + record_model + " " + more.file + " -o " + rows);
  ASSERT_EQ(checked.status, 0) << checked.err;
  EXPECT_THAT(checked.err, HasSubstr("columns kept, but not used by the model: X axis [mm]\n"));
  EXPECT_THAT(checked.err, HasSubstr("column operator is unknown and ignored"));
  EXPECT_THAT(checked.out, testing::ContainsRegex("X axis .mm. +0 +49"));
  EXPECT_THAT(file_text(rows), HasSubstr("X axis [mm]\n"));
  EXPECT_THAT(file_text(rows), HasSubstr("spindle_load_percent"));
  expect_truth(more.file);
  expect_truth(rows);
  EXPECT_EQ(run("identify " + record_model + " " + more.file + " --inputs all").out.find("axis"),
            std::string::npos);
}

/// A day of a spindle, simulated, with noise of 0.05 K and 0.2 um, its times times `factor`; in the
/// model of the reader its friction and its preload are off by 30 %.
struct SpindleDay {
  ScratchFolder folder;
  std::string model, record;

  explicit SpindleDay(double factor, double hours = 6.0) {
    const std::string truth = folder.file("truth.toml"), run_of_day = folder.file("run.csv");
    EXPECT_EQ(run("new --spindle -o " + truth).status, 0);
    std::string programme = "time_s,speed_rpm\n0,0\n";
    for (int minute = 1; minute <= static_cast<int>(60 * hours); ++minute)
      programme += fmt::format("{},{}\n", 60 * minute, minute / 45 % 4 * 2000);
    EXPECT_EQ(run("spindle " + truth + " --speed-profile " + folder.write("p.csv", programme) +
                  " -o " + run_of_day)
                  .status,
              0);
    std::istringstream in(file_text(run_of_day));
    std::vector<std::size_t> columns;
    std::string text;
    int noise = 1;
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) continue;
      const Cells cells = cells_of(line);
      if (columns.empty()) {
        for (const char* name :
             {"time_s", "speed_rpm", "axial_displacement_um", "front_bearing_temperature_C"})
          columns.push_back(static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) -
                                                     cells.begin()));
        text = "time_s,speed_rpm,axial_displacement_um,front_bearing_temperature_C\n";
        continue;
      }
      const auto number = [&](std::size_t c) { return std::stod(cells[columns[c]]); };
      noise = noise * 7919 % 1009;
      const double off = noise / 504.5 - 1.0;
      text += fmt::format("{:.9g},{},{:.3f},{:.3f}\n", factor * number(0), number(1),
                          number(2) + 0.2 * off, number(3) + 0.05 * off);
    }
    record = folder.write("record.csv", text);
    std::string other = file_text(truth);
    other = replaced(other, "f0 = 1.5", "f0 = 2.0");
    other = replaced(other, "preload_N = 3", "preload_N = 4");
    model = folder.write("model.toml", other);
  }
};

TEST(LoggerExports, TimesOfASpindleInOtherUnitsAreAskedAboutBeforeAnyResult) {
  for (const double hours : {6.0, 1.5}) {
    const SpindleDay right(1.0, hours);
    EXPECT_EQ(run("check " + right.model + " " + right.record).status, 0) << hours;
  }
  for (const auto& [factor, unit] :
       {std::pair{1.0 / 60.0, "min"}, {1.0 / 3600.0, "h"}, {1e3, "ms"}}) {
    const SpindleDay day(factor);
    for (const std::string command : {"check ", "compare ", "calibrate ", "diagnose "})
      expect_refused(run(command + day.model + " " + day.record),
                     fmt::format("time_s = {{ column = \"time_s\", unit = \"{}\" }}", unit));
  }
  const SpindleDay minutes(1.0 / 60.0, 1.5);
  expect_refused(run("check " + minutes.model + " " + minutes.record), "unit = \"min\" }");
}

}  // namespace
}  // namespace raceway::tests

#include "files/step_import.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

/// 34.4467 um in 103.755 min, the published response to 50 W, and 58.5317 um in 72.265 min to 100
/// W.
double published(double power, double time) {
  return (power == 50.0 ? 34.4467 * -std::expm1(-time / (103.755 * spindle::one_minute))
                        : 58.5317 * -std::expm1(-time / (72.265 * spindle::one_minute)));
}

/// Rows of the two, one behind the other at each time.
std::string mixed_rows(const std::string& columns) {
  std::string text = columns + "\n";
  for (const double t : {0.0, 300.0, 900.0, 2400.0, 7200.0, 14400.0, 28800.0})
    for (const double power : {100.0, 50.0})
      text += fmt::format("{}W,{},{:.9f},{}\n", power, t, published(power, t), power);
  return text;
}

void expect_published(const spindle::StepResponse& step) {
  const bool small = step.power_end == 50.0;
  EXPECT_NEAR(step.fit.one.gain / um, small ? 34.4467 : 58.5317, 1e-4);
  EXPECT_NEAR(step.fit.one.time_constant / spindle::one_minute, small ? 103.755 : 72.265, 1e-3);
  EXPECT_TRUE(step.converged());
}

/// A file in a folder of its own, with the load before it.
class History {
 public:
  explicit History(const std::string& text)
      : path_(
            std::filesystem::temp_directory_path() /
            fmt::format("raceway_history_{}.txt", testing::UnitTest::GetInstance()->random_seed() +
                                                      reinterpret_cast<std::uintptr_t>(this))) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~History() { std::filesystem::remove(path_); }
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  [[nodiscard]] std::string with(const std::string& load) const {
    return load + "=" + path_.string();
  }

 private:
  std::filesystem::path path_;
};

TEST(StepImport, TakesMixedLoadCasesAtAnyTimes) {
  const auto cases =
      parse_load_cases(mixed_rows("load_case,time_s,axial_displacement_um,power_W"), "fe.csv");
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].name, "100W");
  for (const spindle::StepResponse& step : fit_load_cases(cases)) expect_published(step);
}

TEST(StepImport, TakesOtherUnitsAndNoLoadCase) {
  std::string text = "Time [min];Displacement [mm];Power_kW\n";
  for (const double t : {10.0, 30.0, 60.0, 120.0, 240.0, 480.0})
    text += fmt::format("{};{:.12f};0.05\n", t, published(50.0, t * spindle::one_minute) * 1e-3);
  const auto cases = parse_load_cases(text, "fe.csv");
  ASSERT_EQ(cases.size(), 1U);
  expect_published(fit_load_cases(cases).front());
}

// What is there at 0 s comes at once: K and T are those without it.
TEST(StepImport, TakesWhatIsThereAtOnceOff) {
  std::string text = "time_s,axial_displacement_um,speed_rpm\n";
  for (const double t : {14400.0, 0.0, 300.0, 900.0, 2400.0, 7200.0, 28800.0})
    text += fmt::format("{},{:.9f},6000\n", t, 2.5 + published(50.0, t));
  const auto cases = parse_load_cases(text, "fe.csv");
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_NEAR(cases[0].at_once / um, 2.5, 1e-12);
  EXPECT_NEAR(cases[0].speed / rpm, 6000.0, 1e-9);
  EXPECT_TRUE(std::isnan(cases[0].power_end));
  EXPECT_NEAR(fit_load_cases(cases).front().fit.one.gain / um, 34.4467, 1e-4);
}

TEST(StepImport, ReadsTimeHistoriesAsProgramsWriteThem) {
  const auto rows = [](const char* form, double time_unit) {
    std::string text;
    for (const double t : {300.0, 900.0, 2400.0, 7200.0, 14400.0, 28800.0})
      text += fmt::format(fmt::runtime(form), t / time_unit, published(50.0, t));
    return text;
  };
  const std::string ansys =
      "\n     TIME         2 UX\n                  UX_2\n" + rows("  {:.6E}  {:.9E}\n", 1.0);
  std::string commas = rows("{:.6f}; {:.9f}\r\n", 1.0);
  for (char& c : commas) c = c == '.' ? ',' : c;
  std::string blanks = rows("{:.6f} {:.9f}\n", 1.0);
  for (char& c : blanks) c = c == '.' ? ',' : c;
  for (const std::string& text :
       {ansys, rows("{},{}\n", 1.0), "# CalculiX\n" + rows("{}\t{}\n", 1.0), commas, blanks}) {
    const History file(text);
    const LoadCase load = read_history(file.with("50W"), {});
    EXPECT_EQ(load.power_end, 50.0);
    ASSERT_EQ(load.time.size(), 6U) << text;
    expect_published(fit_load_cases({load}).front());
  }
  const History minutes(rows("{} {}\n", 60.0));
  expect_published(
      fit_load_cases({read_history(minutes.with("0.05 kW"), history_units("min,um", "--units"))})
          .front());
  const LoadCase by_speed = read_history(minutes.with("6000rpm"), {});
  EXPECT_NEAR(by_speed.speed / rpm, 6000.0, 1e-9);
}

TEST(StepImport, SaysWhatIsMissingOrWrong) {
  const auto of = [](const std::string& text) {
    return tests::message_of([&] { (void)parse_load_cases(text, "fe.csv"); });
  };
  EXPECT_THAT(of("time_s,power_W\n1,50\n"),
              HasSubstr("fe.csv:1: column axial_displacement_um is missing"));
  EXPECT_THAT(of("time_s,axial_displacement_um\n1,50\n"), HasSubstr("column power_W is missing"));
  EXPECT_THAT(of("time_s,axial_displacement_um,power_W\n1,x,50\n"), HasSubstr("fe.csv:2"));
  EXPECT_THAT(of("time_s,axial_displacement_um,power_W\n-1,1,50\n"), HasSubstr("time_s"));
  EXPECT_THAT(of("time_s,axial_displacement_um,power_W\n1,1,50\n1,2,50\n"),
              HasSubstr("the time 1 s occurs twice"));
  EXPECT_THAT(of("load_case,time_s,axial_displacement_um,speed_rpm\na,1,1,50\na,2,2,60\n"),
              HasSubstr("fe.csv:3: load case a: the speed changes from 50 to 60 rpm"));
  const History three("1 2 3\n");
  EXPECT_THAT(tests::message_of([&] { (void)read_history(three.with("50W"), {}); }),
              HasSubstr(":1: \"1 2 3\": must be a time"));
  // A row is not left out because its time is none, and what overflows is not fitted.
  const std::string around = "2024-03-12 made\nTIME 2 UX\n0 0\n10 1\n{}\n30 2.5\n100 3\n200 3.1\n";
  for (const char* row : {"nan 2", "inf 2", "1.#QNAN 2", "-1.#IND 2", "1e999 2", "1e300 2", "-5 2",
                          "20 1e300", "20 -2e9", "20 nan"}) {
    const History wrong(fmt::format(fmt::runtime(around), row));
    EXPECT_THAT(tests::message_of([&] { (void)read_history(wrong.with("50W"), {}); }),
                HasSubstr(fmt::format(":5: \"{}\": must be a time from 0 to 1e+12 s and a "
                                      "displacement from -1 to 1 m",
                                      row)));
  }
  const History marked(fmt::format(fmt::runtime(around), "20 -9999"));
  EXPECT_THAT(tests::message_of([&] { (void)read_history(marked.with("50W"), {}); }),
              HasSubstr(":5: displacement = -9999: is not a reading"));
  EXPECT_THAT(of("time_s,axial_displacement_um,power_W\n1,1,50\n2,1.5,50\n3,9.9e37,50\n"),
              HasSubstr("fe.csv:4: axial_displacement_um = 9.9e37: "));
  EXPECT_THAT(of("time_s,axial_displacement_um,power_W\n1,1,50\n2,1.5,50\n3,999.9,50\n"),
              HasSubstr("fe.csv:4: axial_displacement_um = 999.9: is not a reading, but a number "
                        "that marks a missing reading"));
  const History right(fmt::format(fmt::runtime(around), "20 2"));
  EXPECT_EQ(read_history(right.with("50W"), {}).time.size(), 6U);
  EXPECT_THAT(tests::message_of([&] { (void)read_history(three.with("50"), {}); }),
              HasSubstr("no unit"));
  EXPECT_THAT(tests::message_of([&] { (void)read_history(three.with("50mm"), {}); }),
              HasSubstr("is not a unit of power or speed"));
  EXPECT_THAT(tests::message_of([&] { (void)read_history("a.csv", {}); }),
              HasSubstr("must be LOAD=FILE"));
  EXPECT_THAT(tests::message_of([] { (void)history_units("s", "--units"); }), HasSubstr("as s,um"));
  EXPECT_THAT(tests::message_of([] {
                (void)fit_load_cases(
                    parse_load_cases("time_s,axial_displacement_um,power_W\n1,1,50\n", "fe.csv"));
              }),
              HasSubstr("two or more times after 0 s"));
}

}  // namespace
}  // namespace raceway::files

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run_program.h"
#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string byte_order_mark = "\xEF\xBB\xBF";

TEST(CsvStyle, ExcelHasItsHeaderInTheFirstLineAndTheModelBesideIt) {
  const ScratchFolder folder;
  const std::string model = folder.write("m.toml", model_text), out = folder.file("st.csv");
  const Result made =
      run("table " + model + " --speed 1000,2000 --axial-load 300 -o " + out + " --format excel");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(file_text(out), StartsWith(byte_order_mark + "speed_rpm;axial_load_N;"));
  EXPECT_THAT(file_text(out), Not(HasSubstr("#")));
  EXPECT_THAT(file_text(folder.file("st_comments.txt")), HasSubstr("#| [bearing]"));
  EXPECT_THAT(made.out + made.err, HasSubstr("st_comments.txt written"));
  // Neither file is replaced without a word.
  expect_refused(run("table " + model + " --speed 1000 --axial-load 300 --format excel -o " + out),
                 "st.csv");
}

TEST(CsvStyle, PlainHasItsHeaderInTheFirstLineAndAllElseAsItIs) {
  const ScratchFolder folder;
  const std::string displacement = "displacement " + source_dir() +
                                   "/data/spindles/small.toml --speed 0,3000 -o " +
                                   folder.file("c.csv");
  ASSERT_EQ(run(displacement).status, 0);
  const std::string whole = file_text(folder.file("c.csv"));
  ASSERT_THAT(whole, StartsWith("# "));
  ASSERT_EQ(run(displacement + " --force --format plain").status, 0);
  const std::string table = file_text(folder.file("c.csv"));
  EXPECT_THAT(table, StartsWith("speed_rpm,"));
  EXPECT_EQ(file_text(folder.file("c_comments.txt")) + table, whole);
  expect_refused(run(displacement + " --force --format plain --separator tab"),
                 "--separator: only possible with --format excel");
}

TEST(CsvStyle, MarksAreChosenByOption) {
  const ScratchFolder folder;
  const std::string model = folder.write("m.toml", model_text);
  const std::string table = "table " + model + " --speed 1500 --axial-load 300 -o - --format excel";
  EXPECT_THAT(run(table + " --separator tab").out, HasSubstr("speed_rpm\taxial_load_N"));
  EXPECT_THAT(run(table + " --decimal-mark point").out, HasSubstr("speed_rpm,axial_load_N"));
  expect_refused(run(table + " --separator comma"), "add --decimal-mark point");
  expect_refused(run("table " + model + " --speed 1500 --axial-load 300 -o - --separator tab"),
                 "--separator: only possible with --format excel");
}

/// Every command that writes a table takes the same flags.
TEST(CsvStyle, EveryCommandThatWritesATableHasIt) {
  for (const char* command : {"check", "table", "displacement", "deflection", "modes", "correct",
                              "spindle", "step-response"})
    EXPECT_THAT(run(std::string(command) + " --help").out,
                AllOf(HasSubstr("--decimal-mark"), HasSubstr("plain (first")))
        << command;
}

TEST(CsvStyle, RowsThatWereReadMayGoBackToExcel) {
  const ScratchFolder folder;
  const std::string record = source_dir() + "/tests/cli/everyday/over-time/";
  const std::string out = folder.file("rows.csv");
  const Result made =
      run("check " + record + "model.toml " + record + "train.csv --format excel -o " + out);
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(file_text(out), HasSubstr("\r\n0;60;20,007;"));
  const Result again = run("identify " + record + "model.toml " + out);
  EXPECT_EQ(again.status, 0) << again.err;
}

}  // namespace
}  // namespace raceway::tests

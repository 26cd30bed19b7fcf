#include "text/detail/csv_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "text/csv.h"

namespace raceway::text {
namespace {

std::string cell(std::string_view text) {
  fmt::memory_buffer out;
  append_text(out, text);
  return fmt::to_string(out);
}

TEST(CsvText, ACellIsQuotedWhereItMust) {
  for (const auto& [text, expected] : {std::pair{"", ""},
                                       {"plain text", "plain text"},
                                       {"a,b", "\"a,b\""},
                                       {"a;b", "\"a;b\""},
                                       {"say \"no\"", "\"say \"\"no\"\"\""},
                                       {"# of a kind", "\"# of a kind\""},
                                       {" in front", "\" in front\""},
                                       {"behind ", "\"behind \""}})
    EXPECT_EQ(cell(text), expected);
}

TEST(CsvText, NoSpreadsheetTakesACellForAFormula) {
  for (const char* formula : {"=1+1", "+1", "-1", "@SUM(A1)"})
    EXPECT_EQ(cell(formula), std::string("'") + formula);
  EXPECT_EQ(cell("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
  EXPECT_EQ(cell("a=b"), "a=b");
  EXPECT_EQ(cell("'=1"), "''=1");
}

TEST(CsvText, ControlCharactersAreWrittenOut) {
  EXPECT_EQ(cell("two\nlines"), "two\\x0alines");
  EXPECT_EQ(cell("\x1b[31mred\t"), "\\x1b[31mred\\x09");
}

/// As this program reads it again, in a header too.
TEST(CsvText, ACellComesBackAsItWasWritten) {
  for (const char* text : {"a,b", "say \"no\"", "# of a kind", "\"", "Öl; 40 °C", "=1+1", "+x",
                           "-5 mm", "@SUM(A1)", "'=1", "''-x", "'quoted'", "=a,\"b\""}) {
    const CsvTable table = parse_csv("a," + cell(text) + "\n1," + cell(text) + "\n", "t.csv");
    EXPECT_EQ(table.cell(0, 1), text);
    EXPECT_EQ(table.header[1], text);
  }
}

TEST(CsvText, AModelStandsInComments) {
  fmt::memory_buffer out;
  append_model(out, "a = 1\r\n\nb = 2");
  EXPECT_EQ(fmt::to_string(out), "# model:\n#| a = 1\n#|\n#| b = 2\n");
}

TEST(CsvText, WhatIsNotFiniteIsAnEmptyCell) {
  fmt::memory_buffer out;
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) append_value(out, value);
  EXPECT_EQ(out.size(), 0U);
  append_value(out, 1.0 / 3.0);
  EXPECT_EQ(fmt::to_string(out), "0.333333333333");
}

}  // namespace
}  // namespace raceway::text

#include "text/csv.h"

#include <clocale>
#include <filesystem>
#include <fstream>

#include "tests/support/message_of.h"
#include "text/csv_form.h"

namespace raceway::text {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string error_of(const std::string& text) {
  return tests::message_of([&] { (void)parse_csv(text, "d.csv"); });
}

TEST(Csv, CommentsAndBlankLinesAreSkippedAndLinesStillCount) {
  const CsvTable t = parse_csv("# one\n\na,b\n1, 2 \n# two\n  \n3,4", "d.csv");
  EXPECT_EQ(t.header, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.header_line, 3);
  EXPECT_EQ(t.line(0), 4);
  EXPECT_EQ(t.line(1), 7);
  EXPECT_EQ(t.cell(0, 1), "2");
  EXPECT_EQ(t.number(1, 0), 3.0);
  EXPECT_EQ(t.comments, (std::vector<std::string>{"# one", "# two"}));
}

TEST(Csv, SemicolonsDecimalCommasAndCarriageReturnsAreRead) {
  const CsvTable t = parse_csv("a;b\r\n1,5;2\r\n-3,25e2;4\r\n", "d.csv");
  EXPECT_EQ(t.separator, ';');
  EXPECT_TRUE(t.carriage_returns);
  EXPECT_EQ(t.number(0, 0), 1.5);
  EXPECT_EQ(t.number(1, 0), -325.0);
}

TEST(Csv, TabsSeparate) {
  const CsvTable t = parse_csv("a\tb\n1,5\t\n", "d.csv");
  EXPECT_EQ(t.number(0, 0), 1.5);
  EXPECT_EQ(t.cell(0, 1), "");
}

TEST(Csv, QuotedCellsMayHoldSeparatorsAndQuotes) {
  const CsvTable t = parse_csv("run_id,\"x\"\n\"a, \"\"b\"\"\",\"2\"\n", "d.csv");
  EXPECT_EQ(t.header[1], "x");
  EXPECT_EQ(t.cell(0, 0), "a, \"b\"");
  EXPECT_EQ(t.number(0, 1), 2.0);
  EXPECT_THAT(error_of("a,b\n\"1,2\n"),
              StartsWith("d.csv:2: the closing quote of a cell is missing"));
  EXPECT_THAT(error_of("a,b\n\"1\"2,3\n"), StartsWith("d.csv:2: text follows the closing quote"));
}

TEST(Csv, TrailingSeparatorsAndEmptyRowsOfSpreadsheetsAreHarmless) {
  const CsvTable t = parse_csv("a,b,\n1,2,\n,,\n3,4\n", "d.csv");
  EXPECT_EQ(t.header.size(), 2u);
  EXPECT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.notes, (std::vector<std::string>{"the program skips 1 row with only empty cells"}));
}

TEST(Csv, EmptyFilesAndFilesWithoutRowsAreErrors) {
  EXPECT_EQ(error_of(""), "d.csv: the file is empty");
  EXPECT_EQ(error_of("\n \r\n"), "d.csv: the file is empty");
  EXPECT_EQ(error_of("# x\n"), "d.csv: the file has only comments, no header and no rows");
  EXPECT_EQ(error_of("a,b\n# x\n"), "d.csv: no data rows below the header (line 1)");
}

TEST(Csv, AnotherSeparatorBelowTheHeaderIsNamed) {
  EXPECT_EQ(error_of("a,b\n1;2\n"),
            "d.csv:2: the header (line 1) has commas as separators, but this row has semicolons; "
            "use the same separator");
  EXPECT_THAT(error_of("a;b;c\n1,2,3\n"),
              HasSubstr("semicolons as separators, but this row has commas"));
  EXPECT_THAT(error_of("a\tb\n1,2\n"), HasSubstr("tabs as separators, but this row has commas"));
  EXPECT_THAT(error_of("a,b;c\n1;2\n"), StartsWith("d.csv:1: the header has"));
  const CsvTable t = parse_csv("a,b\n1,5;2\n", "d.csv");
  EXPECT_THAT(
      tests::message_of([&] { (void)t.number(0, 1); }),
      HasSubstr("is not a number; does this row have a different separator from the header?"));
}

TEST(Csv, ColumnsThatStandTwiceOrHaveNoNameAreErrors) {
  EXPECT_EQ(error_of("a,b,a\n1,2,3\n"), "d.csv:1: column a occurs twice, as columns 1 and 3");
  EXPECT_EQ(error_of("a,,b\n1,2,3\n"), "d.csv:1: column 2 has no name");
}

TEST(Csv, AMissingHeaderIsNoticed) {
  EXPECT_THAT(error_of("100,100\n3,4\n"),
              HasSubstr(": the header line with the column names is missing"));
}

TEST(Csv, ARowWhoseFirstCellBeginsWithAHashIsARow) {
  const CsvTable t = parse_csv("speed_rpm,duration_s\n#N/A,10\n1000,20\n#WERT!,30\n", "d.csv");
  ASSERT_EQ(t.rows(), 3u);
  EXPECT_EQ(t.cell(0, 0), "#N/A");
  EXPECT_EQ(t.line(2), 4);
  EXPECT_TRUE(t.comments.empty());
  // In one column, in quotes, with a separator at the end of each line.
  EXPECT_EQ(parse_csv("speed_rpm\n#N/A\n1\n", "d.csv").rows(), 2u);
  EXPECT_EQ(parse_csv("run_id,a\n\"# 7\",1\n", "d.csv").cell(0, 0), "# 7");
  EXPECT_EQ(parse_csv("a,b,\n#N/A,1,\n2,3,\n", "d.csv").rows(), 2u);
}

TEST(Csv, RemarksAmongTheRowsAreComments) {
  const CsvTable t = parse_csv(
      "a,b,c\n# one remark\n1,2,3\n# oil changed, again\n#| [bearing],x,y\n# filled up,,\n4,5,6\n",
      "d.csv");
  EXPECT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.comments.size(), 4u);
}

TEST(Csv, TheLastCommentAboveTheDataIsTheHeaderWhereItsCellsFit) {
  const CsvTable t = parse_csv("# group: run\n# time_s, n (rpm) \n0,100\n60,200\n", "d.csv");
  EXPECT_EQ(t.header, (std::vector<std::string>{"time_s", "n (rpm)"}));
  EXPECT_EQ(t.header_line, 2);
  ASSERT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.line(0), 3);
  EXPECT_EQ(t.comments, (std::vector<std::string>{"# group: run"}));
  EXPECT_EQ(parse_csv("#;a;b\n1;0,5;2\n", "d.csv").header,
            (std::vector<std::string>{"#", "a", "b"}));
  // Cells that do not fit, and a header of its own.
  EXPECT_THAT(error_of("# a,b,c\n1,2\n"),
              HasSubstr(": the header line with the column names is missing"));
  EXPECT_EQ(parse_csv("# x,y\na,b\n1,2\n", "d.csv").header, (std::vector<std::string>{"a", "b"}));
}

TEST(Csv, ShapesOfOtherProgramsAreRead) {
  // Row numbers without a name, as pandas writes them.
  const CsvTable pandas = parse_csv(",a,b\n0,1,2\n1,3,4\n", "d.csv");
  EXPECT_EQ(pandas.header, (std::vector<std::string>{"column 1", "a", "b"}));
  EXPECT_EQ(pandas.number(1, 2), 4);
  EXPECT_THAT(error_of("a,,b\n1,2,3\n"), HasSubstr("column 2 has no name"));
  // Empty columns at the end.
  const CsvTable empty = parse_csv("a;b;;;\n1;2;;;\n3;4\n", "d.csv");
  EXPECT_EQ(empty.header.size(), 2u);
  EXPECT_EQ(empty.number(1, 1), 4);
  // A header that stands again, and words behind the rows.
  const CsvTable again = parse_csv("a,b\n1,2\na,b\n3,4\nEnd of file\nMade by a logger\n", "d.csv");
  EXPECT_EQ(again.rows(), 2u);
  EXPECT_EQ(again.notes,
            (std::vector<std::string>{
                "the header occurs once more in the file; the program skips each repetition",
                "the program skips the text after the rows, from line 5 on"}));
  EXPECT_EQ(error_of("a,b\n1,2\nstopped\n3,4\n"),
            "d.csv:3: this row has fewer cells than the header (line 1)");
  // Old line ends.
  EXPECT_EQ(parse_csv("a,b\r1,2\r3,4\r", "d.csv").rows(), 2u);
}

TEST(Csv, AColumnOfUnitsBehindEachValueIsItsUnit) {
  const auto read = [](const std::string& text) {
    return parse_csv(text, "d.csv", false, [](std::string_view) { return CsvForm{}; });
  };
  for (const char* header : {"t,unit,n,unit", "t,,n,", "t,Einheit,n,Einheit", "t,unit,n,unit.1"}) {
    const CsvTable table = read(std::string(header) + "\n1,s,600,rpm\n2,s,-,1/min\n3,s,700,\n");
    EXPECT_EQ(table.header, (std::vector<std::string>{"t", "n"})) << header;
  }
  const CsvTable table = read("t,unit,n,unit\n1,s,600,rpm\n2,s,700,rpm\n");
  EXPECT_EQ(table.units, (std::vector<std::string>{"s", "rpm"}));
  EXPECT_EQ(table.number(1, 1), 700);
  EXPECT_THAT(tests::message_of([&] { (void)read("t,unit\n1,s\n2,min\n"); }),
              HasSubstr("d.csv:3: the unit of t is min in this row, but s in the rows above"));
  EXPECT_THAT(tests::message_of([&] { (void)read("t,unit,n,unit\n1,a,600,b\n"); }),
              HasSubstr("column unit occurs twice"));
  // A table of this program may have a column of that name.
  EXPECT_EQ(parse_csv("value,unit\n1,s\n2,C\n", "t.csv").cell(1, 1), "C");
}

TEST(Csv, BlanksSeparateBelowACommentThatNamesTheColumns) {
  // numpy.savetxt(file, data, header="time_s speed_rpm")
  const CsvTable table =
      parse_csv("# time_s speed_rpm\n0.0e+00 1.0e+03\n6.0e+01  -2.0e+03\n", "d.csv");
  EXPECT_EQ(table.header, (std::vector<std::string>{"time_s", "speed_rpm"}));
  EXPECT_EQ(table.number(1, 1), -2000);
}

TEST(Csv, EmptyCellsAtTheEndOfRowsAlone) {
  EXPECT_EQ(parse_csv("a,b\n1,2,\n3,4,,\n", "d.csv").number(1, 1), 4);
}

TEST(Csv, RowsOfStatisticsBehindTheRowsAreNoRows) {
  const CsvTable table = parse_csv("t,n\n1,600\n2,700\nMean,650\nMax,700\n", "d.csv");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table.notes,
              testing::Contains("the program skips the text after the rows, from line 4 on"));
  // Between rows it is a row, of which the reader says what is wrong.
  EXPECT_EQ(parse_csv("t,n\n1,600\nMean,650\n2,700\n", "d.csv").rows(), 3u);
}

TEST(Csv, WordsInTheFirstCellBehindTheRowsAreNoRow) {
  const CsvTable table = parse_csv("t,n,x\n1,600,1\n2,700,2\nEnd of data,,\n", "d.csv");
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_THAT(table.notes,
              testing::Contains("the program skips the text after the rows, from line 4 on"));
  EXPECT_EQ(parse_csv("t,n\n1,600\nPause,\n2,700\n", "d.csv").rows(), 3u);
}

TEST(Csv, AHeaderThatStandsAgainMayHaveItsUnitsBelowIt) {
  const auto read = [](const std::string& text) {
    return parse_csv(text, "d.csv", false,
                     [](std::string_view) { return CsvForm{.header_line = 1, .unit_line = 2}; });
  };
  const CsvTable table =
      read("t;T\ns;°C\n1;20\n2;21\nstopped\nMean;20.5\nt;T\ns;C\n3;22\nt;T\n4;23\n");
  EXPECT_EQ(table.rows(), 4u);
  EXPECT_EQ(table.number(2, 1), 22);
  EXPECT_EQ(table.notes,
            (std::vector<std::string>{
                "line 2 is a row of units",
                "the header occurs 2 times more in the file; the program skips each repetition",
                "the program skips 2 lines between the rows and the repeated header"}));
  EXPECT_EQ(tests::message_of([&] { (void)read("t;T\ns;C\n1;20\nt;T\ns;F\n2;70\n"); }),
            "d.csv:5: the unit of T is \"F\" in this row, but \"C\" in the rows above; use one "
            "unit in a column");
}

TEST(Csv, ALabviewFileWithoutTimesHasThemFromItsHead) {
  const std::string top =
      "LabVIEW Measurement\t\nDecimal_Separator\t.\nX_Columns\tNo\nX0\t0.5\nDelta_X\t60.0\n"
      "***End_of_Header***\t\n";
  const CsvTable table =
      parse_csv(top + "X_Value\tspeed_rpm\tComment\n\t100\n\t200\n", "d.lvm", false,
                [](std::string_view) { return CsvForm{.header_line = 7, .separator = '\t'}; });
  EXPECT_EQ(table.number(0, 0), 0.5);
  EXPECT_EQ(table.number(1, 0), 60.5);
  EXPECT_EQ(table.number(1, 1), 200);
}

TEST(Csv, TypesetNumbersAreRead) {
  const CsvTable t = parse_csv(
      "a\n\u22125.5\n- 7\n+ 3\n1'200.5\n1\u2019200'000\n2e\u22123\n1\u00a0200.5\n12\u202f345\n"
      "1 000\n1'20\n1\u00a020\n",
      "d.csv");
  const double expected[] = {-5.5, -7, 3, 1200.5, 1200000, 2e-3, 1200.5, 12345};
  for (std::size_t row = 0; row < 8; ++row) EXPECT_EQ(t.number(row, 0), expected[row]) << row;
  for (const std::size_t row : {8u, 9u, 10u}) EXPECT_FALSE(t.parsed(row, 0).problem.empty()) << row;
}

TEST(Csv, RowsWithMoreOrFewerCellsAreErrors) {
  EXPECT_EQ(error_of("a,b\n1,2\n3\n"), "d.csv:3: 1 cell, but the header (line 1) has 2 columns");
  EXPECT_THAT(error_of("a,b\n1,5,2,5\n"), HasSubstr("decimal commas need semicolons or tabs"));
}

TEST(Csv, NumbersAreReadAsWholeCells) {
  EXPECT_EQ(parse_number("1e3", false).value, 1000.0);
  EXPECT_EQ(parse_number("+.5", false).value, 0.5);
  EXPECT_EQ(parse_number("-2.", false).value, -2.0);
  EXPECT_EQ(parse_number("12.396", false).value, 12.396);
  EXPECT_EQ(parse_number("1,5", true).decimal_mark, ',');
  for (const char* text : {"", "x", "12 mm", "1e", "0x1F", "nan", "NaN", "inf", "-inf", "+-1",
                           "--1", "1 000", "1e999", "#N/A", "-", ".", "1;2"})
    EXPECT_FALSE(parse_number(text, false).problem.empty()) << text;
}

TEST(Csv, AmbiguousDecimalMarksAreErrors) {
  EXPECT_THAT(parse_number("1.234,5", true).problem, HasSubstr("ambiguous"));
  EXPECT_THAT(parse_number("1,234,567", true).problem, HasSubstr("ambiguous"));
  EXPECT_THAT(parse_number("1,5", false).problem, HasSubstr("decimal comma"));
}

TEST(Csv, NumberErrorsNameLineColumnAndCell) {
  const CsvTable t = parse_csv("a,speed_rpm\n1,fast\n", "d.csv");
  EXPECT_EQ(tests::message_of([&] { (void)t.number(0, 1); }),
            "d.csv:2: speed_rpm = \"fast\": is not a number");
}

TEST(Csv, Latin1IsReadWithANote) {
  const CsvTable t = parse_csv(
      "# 20 \xb0"
      "C\na\n1\n",
      "d.csv");
  EXPECT_EQ(t.comments[0], "# 20 °C");
  EXPECT_EQ(t.notes.size(), 1u);
}

TEST(Csv, FilesThatCannotBeReadAreNamed) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(tests::message_of([&] { (void)read_csv(folder); }),
            folder + ": is a directory; name a file");
  EXPECT_EQ(tests::message_of([] { (void)read_csv("no/such.csv"); }), "no/such.csv: no such file");
  const std::string path = folder + "binary.csv";
  std::ofstream(path, std::ios::binary) << std::string("a,b\n1,\0\n", 8);
  EXPECT_THAT(tests::message_of([&] { (void)read_csv(path); }), HasSubstr("NUL bytes"));
  std::ofstream(path, std::ios::binary) << "\xff\xfe"
                                        << "a";
  EXPECT_THAT(tests::message_of([&] { (void)read_csv(path); }), HasSubstr("UTF-16"));
  std::ofstream(path, std::ios::binary) << "\xef\xbb\xbf"
                                        << "a\n1\n";
  const CsvTable t = read_csv(path);
  EXPECT_TRUE(t.byte_order_mark);
  EXPECT_EQ(t.header[0], "a");
}

TEST(Csv, AHundredThousandRowsAreRead) {
  std::string text = "speed_rpm,friction_torque_Nmm\n";
  for (int i = 0; i < 100'000; ++i) text += std::to_string(i) + ",12.5\n";
  const CsvTable t = parse_csv(text, "d.csv");
  ASSERT_EQ(t.rows(), 100'000u);
  EXPECT_EQ(t.number(99'999, 0), 99'999.0);
  EXPECT_EQ(t.line(99'999), 100'001);
}

CsvTable of_others(const std::string& text) {
  return parse_csv(text, "t.csv", false, [](std::string_view all) {
    return find_form(all, [](std::string_view) { return false; });
  });
}

TEST(Csv, UnitsInCellsAreThoseOfTheirColumns) {
  const CsvTable table = of_others(
      "time;T1;T2;n;x\n0;12,3 \u00b0C;\u2212 4 K;1.200 1/min;5 mm\n"
      "1;12,4 \u00b0C;NaN;600 1/min;6 inch\n2;12,5;- 3 K;600 1/min;7 mm\n");
  EXPECT_DOUBLE_EQ(table.number(1, 1), 12.4);
  EXPECT_DOUBLE_EQ(table.number(2, 1), 12.5);
  EXPECT_DOUBLE_EQ(table.number(0, 2), -4.0);
  EXPECT_DOUBLE_EQ(table.number(0, 3), 1200.0);
  EXPECT_THAT(table.units, testing::ElementsAre("", "\u00b0C", "K", "1/min", ""));
  // A column in two units has no numbers.
  EXPECT_THAT(tests::message_of([&] { (void)table.number(0, 4); }), HasSubstr("is not a number"));
}

TEST(Csv, WordsAndTimesAreNoUnitsOfCells) {
  const CsvTable table = of_others("clock,run,part\n8:15 AM,1 a,3 W1\n8:16 AM,2 a,4 W1\n");
  EXPECT_EQ(table.cell(0, 0), "8:15 AM");
  EXPECT_EQ(table.cell(0, 1), "1 a");
  EXPECT_EQ(table.cell(0, 2), "3 W1");
  EXPECT_TRUE(table.units.empty());
}

}  // namespace
}  // namespace raceway::text

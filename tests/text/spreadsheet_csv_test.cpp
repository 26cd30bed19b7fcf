#include "text/spreadsheet_csv.h"

#include "tests/support/message_of.h"
#include "text/csv.h"

namespace raceway::text {
namespace {

const std::string csv =
    "# raceway 0.1.0\n# model:\n#| [bearing]\nspeed_rpm,moment_Nmm,case\n1000,12.5,a\n"
    "2000,-1.5e-05,\"b; \"\"c\"\"\"\n3000,,'=1+1\n";

TEST(SpreadsheetCsv, TheHeaderIsTheFirstLineAndMarksAreGerman) {
  const PlainCsv sheet = spreadsheet_csv(csv);
  EXPECT_EQ(sheet.table,
            "\xEF\xBB\xBFspeed_rpm;moment_Nmm;case\r\n1000;12,5;a\r\n"
            "2000;-1,5e-05;\"b; \"\"c\"\"\"\r\n3000;;'=1+1\r\n");
  EXPECT_EQ(sheet.comments, "# raceway 0.1.0\n# model:\n#| [bearing]\n");
}

TEST(SpreadsheetCsv, OtherMarksMayBeAskedFor) {
  EXPECT_THAT(spreadsheet_csv(csv, {.separator = '\t', .decimal = '.'}).table,
              testing::HasSubstr("\r\n1000\t12.5\ta\r\n"));
  EXPECT_THAT(spreadsheet_csv(csv, {.separator = ',', .decimal = '.'}).table,
              testing::HasSubstr("\r\n1000,12.5,a\r\n"));
  EXPECT_THROW((void)spreadsheet_csv(csv, {.separator = ',', .decimal = ','}),
               std::invalid_argument);
}

/// The readers of this program take it back.
TEST(SpreadsheetCsv, IsReadAsTheTableThatItWas) {
  const PlainCsv sheet = spreadsheet_csv(csv);
  const CsvTable was = parse_csv(csv, "a.csv"), is = parse_csv(sheet.table.substr(3), "b.csv");
  ASSERT_EQ(is.header, was.header);
  ASSERT_EQ(is.rows(), was.rows());
  for (std::size_t row = 0; row < was.rows(); ++row) {
    EXPECT_EQ(is.cell(row, 2), was.cell(row, 2));
    if (!was.is_empty(row, 1)) {
      EXPECT_EQ(is.number(row, 1), was.number(row, 1));
    }
  }
}

}  // namespace
}  // namespace raceway::text

#include "text/detail/decimal_marks.h"

#include "files/column_map.h"
#include "files/data_file.h"
#include "files/subject.h"
#include "record/units.h"
#include "tests/support/message_of.h"
#include "tests/support/synthetic.h"

namespace raceway::text {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

double number(const std::string& text, std::size_t row, std::size_t column) {
  return parse_csv(text, "d.csv").number(row, column);
}

std::string problem(const std::string& text, std::size_t row, std::size_t column) {
  return tests::message_of([&] { (void)number(text, row, column); });
}

record::Record record_by(const std::string& text, const std::string& map) {
  model::Model model = fit::synthetic_model();
  return files::read_record({"d.csv", text}, *files::make_subject(model),
                            {.columns = files::parse_column_map(map, "map.toml")});
}

TEST(DecimalMarks, GroupsOfThreeDigitsAreThousands) {
  for (const char* text : {"1.200", "-12.345", "999.999.999"}) EXPECT_TRUE(is_grouped(text, '.'));
  for (const char* text : {"0.200", "1.20", "1.2000", "1200.000", ".200", "1.200.00", "1.2e3", "7"})
    EXPECT_FALSE(is_grouped(text, '.')) << text;
  EXPECT_TRUE(is_grouped("1.200,5", '.', ','));
  EXPECT_FALSE(is_grouped("1.200,", '.', ','));
}

TEST(DecimalMarks, ANumberThatCanBeReadInTwoWaysIsAskedAbout) {
  const std::string german = "n;F;M\n600;200;113\n1.200;200;177\n";
  EXPECT_EQ(problem(german, 1, 0),
            "d.csv:3: n = 1.200: is it 1200, or is the point a decimal mark? Set decimal_mark = "
            "\",\" or \".\" in [columns], or write the file without thousands separators");
  EXPECT_EQ(number(german, 0, 0), 600);  // the other cells are read
  // The mirror image with tabs, and commas between the columns.
  EXPECT_THAT(problem("n\tM\n600\t1\n1,200\t2\n", 1, 0), HasSubstr("is it 1200, or is the comma"));
  EXPECT_THAT(problem("n,M\n600,1\n1.200,2\n", 1, 0), HasSubstr("is it 1200"));
  // All speeds above 999, in a file that is German by its semicolons.
  EXPECT_THAT(problem("n;M\n1.200;113\n1.800;177\n", 1, 0), HasSubstr("is it 1800"));
}

TEST(DecimalMarks, AnyCellThatTellsSettlesIt) {
  EXPECT_EQ(number("n;M\n600;0.5\n1.200;2\n", 1, 0), 1.2);     // a decimal point elsewhere
  EXPECT_EQ(number("n;M\n600;0,5\n1.200;2\n", 1, 0), 1200.0);  // a decimal comma elsewhere
  EXPECT_EQ(number("n;M\n600;0,5\n1.200.000;2\n", 1, 0), 1.2e6);
  EXPECT_EQ(number("n\tM\n1,200\t0.5\n1,300\t2\n", 1, 0), 1300.0);
  EXPECT_EQ(number("n,M\n600,0.5\n\"1,200\",2\n", 1, 0), 1200.0);
  EXPECT_EQ(number("t,M\n20.000,1.500\n20.007,1.250\n", 1, 0), 20.007);  // three digits each
  EXPECT_EQ(number("k,t,M\n1,20.000,1.500\n2,20.007,1.250\n", 1, 1), 20.007);
  EXPECT_THAT(parse_csv("n;M\n600;0,5\n1.200;2\n", "d.csv").notes,
              Contains("points are read as thousands separators"));
  EXPECT_THAT(parse_csv("n;M\n600;0,5\n1200;2\n", "d.csv").notes,
              Not(Contains("points are read as thousands separators")));
}

TEST(DecimalMarks, AMapAnswersForAFile) {
  const std::string text =
      "speed_rpm;friction_torque_Nmm;axial_load_N;temperature_C\n600;113;200;30\n1.200;177;600;"
      "30\n";
  EXPECT_THAT(tests::message_of([&] { (void)record_by(text, "[columns]\n"); }),
              HasSubstr("d.csv:3: speed_rpm = 1.200: is it 1200"));
  EXPECT_DOUBLE_EQ(record_by(text, "[columns]\ndecimal_mark = \",\"\n").value(record::speed, 1),
                   1200 * rpm);
  EXPECT_DOUBLE_EQ(record_by(text, "[columns]\ndecimal_mark = \".\"\n").value(record::speed, 1),
                   1.2 * rpm);
  EXPECT_THAT(
      tests::message_of([&] { (void)record_by(text, "[columns]\ndecimal_mark = \"x\"\n"); }),
      HasSubstr("decimal_mark"));
  // What contradicts the answer is told.
  EXPECT_THAT(tests::message_of([&] {
                (void)record_by(
                    "speed_rpm;friction_torque_Nmm;axial_load_N;temperature_C\n"
                    "600.5;113;200;30\n",
                    "[columns]\ndecimal_mark = \",\"\n");
              }),
              HasSubstr("has a point, but the decimal mark of this file is the comma"));
}

}  // namespace
}  // namespace raceway::text

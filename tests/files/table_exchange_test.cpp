#include "files/table_exchange.h"

#include <sstream>

#include "record/units.h"
#include "report/table_plot.h"
#include "tests/support/message_of.h"
#include "text/csv.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

friction::StribeckTable sample(std::vector<double> loads = {100, 300}, bool hole = false) {
  return friction::build_stribeck_table({.speed = {0, 1000 * rpm, 2000 * rpm},
                                         .axial_load = std::move(loads),
                                         .radial_load = {0},
                                         .temperature = {kelvin(40)}},
                                        {"spin-friction_Nmm"}, [&](auto points, auto out) {
                                          for (std::size_t i = 0; i < points.size(); ++i) {
                                            if (hole && points[i].speed == 0) continue;
                                            out[i].status = bearing::SolveStatus::converged;
                                            out[i].friction_moment = 0.01 + points[i].speed * 1e-3 +
                                                                     points[i].axial_load * 1e-4;
                                            out[i].columns[0] = 0.002;
                                          }
                                        });
}

TEST(TableExchange, ThePlainFileHasOneHeaderLineOfIdentifiers) {
  const std::string text = plain_table_text(sample());
  EXPECT_THAT(text, testing::StartsWith("speed_rpm,axial_load_N,radial_load_N,temperature_C,"
                                        "friction_torque_Nmm,spin_friction_Nmm,status\n"));
  const text::CsvTable csv = text::parse_csv(text, "t.csv");
  ASSERT_EQ(csv.rows(), 6u);
  EXPECT_DOUBLE_EQ(csv.number(0, 4), 20);
  EXPECT_DOUBLE_EQ(csv.number(0, 5), 2);
  EXPECT_THAT(plain_table_text(sample({100}, true)), HasSubstr("\n0,100,0,40,NaN,NaN,"));
}

TEST(TableExchange, TheModelicaFileIsAMatrixInSI) {
  std::istringstream lines(modelica_table_text(sample(), "X"));
  std::string line;
  std::vector<std::string> rows;
  while (std::getline(lines, line))
    if (!line.starts_with("# ")) rows.push_back(line);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], "#1");
  EXPECT_EQ(rows[1], "double friction_torque(4,3)");
  EXPECT_EQ(rows[2], "0 100 300");
  EXPECT_EQ(rows[3], "0 0.02 0.04");
  EXPECT_EQ(rows[4], "104.71975512 0.12471975512 0.14471975512");
  EXPECT_THAT(modelica_table_text(sample({100}), "X"),
              HasSubstr("double friction_torque(3,2)\n0 0.02\n"));
  EXPECT_THAT(tests::message_of([] { (void)modelica_table_text(sample({100}, true), "X"); }),
              HasSubstr("there is none at 0 rpm, 100 N"));
}

TEST(TablePlot, DrawsACurveForEachLoad) {
  const std::string svg = report::table_svg(sample(), "A & B");
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, HasSubstr("Friction torque of A &amp; B"));
  std::size_t curves = 0;
  for (std::size_t at = svg.find("fill=\"none\""); at != svg.npos;
       at = svg.find("fill=\"none\"", at + 1))
    ++curves;
  EXPECT_EQ(curves, 2u);
  EXPECT_THAT(svg, HasSubstr(">300 N</text>"));
  // Names of curves that end together stand one above the other.
  const auto y_of = [](const std::string& picture, const std::string& name) {
    const std::size_t line = picture.rfind("<text", picture.find(">" + name + "</text>"));
    return std::stod(picture.substr(picture.find("y=\"", line) + 3));
  };
  const std::string close = report::table_svg(sample({100, 101}), "X");
  EXPECT_GE(y_of(close, "100 N") - y_of(close, "101 N"), 14.0);
}

}  // namespace
}  // namespace raceway::files

#include "files/table_file.h"

#include <cmath>

#include "record/units.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using bearing::SolveStatus;
using testing::HasSubstr;
using testing::StartsWith;

friction::StribeckTable example() {
  friction::StribeckTable t;
  t.axes = {{0.0, 1000 * rpm}, {100, 300}, {0}, {kelvin(20), kelvin(40)}};
  t.columns = {"load_Nmm", "inner_contact_angle_deg", "film_ratio"};
  for (std::size_t i = 0; i < t.axes.size(); ++i) {
    t.friction_moment.push_back(0.01 * static_cast<double>(i + 1));
    t.status.push_back(SolveStatus::converged);
    t.values.insert(t.values.end(), {0.001 * static_cast<double>(i), 15 * degree, 2.5});
  }
  t.friction_moment[3] = unset;
  t.status[3] = SolveStatus::no_equilibrium;
  for (std::size_t k = 0; k < 3; ++k) t.values[3 * 3 + k] = unset;
  return t;
}

TEST(TableFile, ATableComesBackAsItWasWritten) {
  const std::string model = "[bearing]  # Ø\n\nname = \"a, b\"\n";
  const auto table = example();
  const TableFile back = parse_table(table_text(table, "test", model), "t.csv");
  EXPECT_EQ(back.model_text, model);
  EXPECT_EQ(back.table.columns, table.columns);
  ASSERT_EQ(back.table.axes.size(), table.axes.size());
  EXPECT_NEAR(back.table.axes.speed[1], table.axes.speed[1], 1e-9);
  EXPECT_NEAR(back.table.axes.temperature[0], table.axes.temperature[0], 1e-9);
  for (std::size_t i = 0; i < table.axes.size(); ++i) {
    EXPECT_EQ(back.table.status[i], table.status[i]);
    if (i == 3) {
      EXPECT_TRUE(std::isnan(back.table.friction_moment[i]));
      continue;
    }
    EXPECT_NEAR(back.table.friction_moment[i], table.friction_moment[i], 1e-12);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back.table.row(i)[k], table.row(i)[k], 1e-11);
  }
}

TEST(TableFile, TheFileIsCommentsHeaderAndRowsInTheUnitsOfTheirNames) {
  const std::string text = table_text(example(), "test", "x = 1\r\n");
  EXPECT_THAT(text, StartsWith("# Stribeck table: test\n# raceway "));
  EXPECT_THAT(text, HasSubstr("\n#| x = 1\n"
                              "speed_rpm,axial_load_N,radial_load_N,temperature_C,"
                              "friction_torque_Nmm,load_Nmm,inner_contact_angle_deg,film_ratio,"
                              "status\n0,100,0,20,10,0,15,2.5,converged\n1000,100,0,20,20,"));
  EXPECT_THAT(text, HasSubstr("\n1000,300,0,20,,,,,no_equilibrium\n"));
}

const std::string table_header =
    "speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm\n";

std::string table_error(const std::string& text) {
  return tests::message_of([&] { (void)parse_table(text, "t.csv"); });
}

TEST(TableFile, RowsMayStandInAnyOrder) {
  const auto file = parse_table(table_header + "1000,5,0,40,2\n0,5,0,40,1\n", "t.csv");
  EXPECT_DOUBLE_EQ(file.table.friction_moment[0], 1e-3);
  EXPECT_DOUBLE_EQ(file.table.friction_moment[1], 2e-3);
  EXPECT_EQ(file.table.status[0], SolveStatus::converged);
  EXPECT_EQ(file.model_text, "");
}

TEST(TableFile, MissingAndDoublePointsAreNamed) {
  EXPECT_EQ(table_error(table_header + "0,5,0,40,1\n100,5,0,40,1\n0,9,0,40,1\n"),
            "t.csv: the grid is incomplete: 2 speeds x 2 axial loads x 1 radial loads x 1 "
            "temperatures are 4 points, but the file has 3; for example, speed_rpm 100, "
            "axial_load_N 9, radial_load_N 0, temperature_C 40 is missing");
  EXPECT_EQ(table_error(table_header + "0,5,0,40,1\n0,5,0,40,2\n"),
            "t.csv:3: the point speed_rpm 0, axial_load_N 5, radial_load_N 0, temperature_C 40 is "
            "already in line 2");
}

TEST(TableFile, WrongCellsAndColumnsAreNamed) {
  EXPECT_THAT(table_error(table_header + "0,5,0,40,x\n"),
              StartsWith("t.csv:2: friction_torque_Nmm = "));
  EXPECT_THAT(table_error("speed_rpm,axial_load_N\n0,5\n"),
              HasSubstr("column radial_load_N is missing"));
  EXPECT_THAT(table_error(table_header + "0,5,0,-300,1\n"), HasSubstr("temperature"));
}

}  // namespace
}  // namespace raceway::files

#include "files/column_map.h"

#include <fmt/format.h>

#include "files/data_file.h"
#include "files/model_file.h"
#include "files/subject.h"
#include "record/units.h"
#include "tests/support/message_of.h"
#include "tests/support/synthetic.h"

namespace raceway::files {
namespace {

using record::Record;
using testing::Contains;
using testing::HasSubstr;

std::shared_ptr<const model::ModelSubject> rig(double inertia = unset) {
  model::Model model = fit::synthetic_model();
  model.rig.axial_load = 100;
  model.rig.inertia = inertia;
  return make_subject(model);
}

Record read(const std::string& text, const std::string& map = "[columns]\n",
            bool drop_nan = false) {
  return read_record({"d.csv", text}, *rig(),
                     {.columns = parse_column_map(map, "map.toml"), .drop_nan = drop_nan});
}

std::string map_error(const std::string& text, const std::string& map) {
  return tests::message_of([&] { (void)read(text, map); });
}

TEST(ColumnUnits, AKnownUnitInTheNameIsReadAndTold) {
  const Record r = read(
      "speed_1_s,axial_load_kN,temperature_K,friction_torque_Nm,std_mNm\n100,0.5,313.15,0.2,1\n");
  EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 6000 * rpm);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 0), 500);
  EXPECT_DOUBLE_EQ(r.value(record::temperature, 0), 313.15);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.2);
  EXPECT_DOUBLE_EQ(r.value(record::torque_deviation, 0), 1e-3);
  EXPECT_THAT(texts(r.notes), Contains("column friction_torque_Nm is friction_torque_Nmm, "
                                       "converted from N m: 1 N m = 1000 N mm"));
  EXPECT_THAT(texts(r.notes),
              Contains("column temperature_K is temperature_C, converted from K: C = K - 273.15"));
}

TEST(ColumnUnits, RangesAreThoseOfTheFile) {
  const std::string error = map_error("speed_rad_s,friction_torque_Nm\n-1,1\n", "[columns]\n");
  EXPECT_THAT(error, HasSubstr("d.csv:2: speed_rad_s = -1: must be from 0 to 104719.7551 rad/s"));
}

TEST(ColumnUnits, OneQuantityInTwoColumnsIsAnError) {
  EXPECT_EQ(map_error("speed_rpm,friction_torque_Nm,friction_torque_Nmm\n1,1,1\n", "[columns]\n"),
            "d.csv:1: columns friction_torque_Nm and friction_torque_Nmm are both read as friction "
            "torque; keep "
            "one of them");
}

TEST(ColumnUnits, ARowOfUnitsMustNotContradictTheName) {
  const std::string names = "speed_rpm;friction_torque_Nmm\n";
  EXPECT_EQ(read(names + "1/min;N mm\n1;2\n").rows(), 1u);
  EXPECT_EQ(map_error(names + "1/min;Nm\n1;2\n", "[columns]\n"),
            "d.csv:1: column friction_torque_Nmm: its name and the row of units (N m) give "
            "different units; correct one of them");
}

TEST(ColumnMap, TakesTheirColumnsForOurs) {
  const Record r = read(
      "Prüfstand 3, Versuch 7\n\nDrehzahl;Moment;T Öl;Zeit\n1/min;Nm;°C;\n"
      "1000;0,25;40;12.03.2024 08:15:00\n2000;0,5;41;12.03.2024 08:16:30,5\n",
      R"([columns]
speed_rpm = "Drehzahl"
friction_torque_Nmm = "Moment"
temperature_C = { column = "T Öl" }
axial_load_kN = 0.4
time_s = "Zeit"
)");
  ASSERT_EQ(r.rows(), 2u);
  EXPECT_DOUBLE_EQ(r.value(record::speed, 1), 2000 * rpm);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.25);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 1), 400);
  EXPECT_DOUBLE_EQ(r.value(record::time, 1), 90.5);
  EXPECT_THAT(texts(r.notes), Contains("the program skips 1 line above the header (line 3)"));
  EXPECT_THAT(texts(r.notes), Contains("line 4 is a row of units"));
  EXPECT_THAT(texts(r.notes),
              Contains("axial_load_N: 400 N for all rows, from [columns] of map.toml"));
  EXPECT_THAT(texts(r.notes),
              Contains("column Zeit has dates: time_s is measured from 2024-03-12T08:15:00"));
}

TEST(ColumnMap, ANumberNeedsAColumnOfTheModel) {
  for (const std::string key : {"belt_force_N", "speed_to_rpm"})
    EXPECT_THAT(
        map_error("n,M\n1000,25\n",
                  "[columns]\nspeed_rpm = \"n\"\nfriction_torque_Nmm = \"M\"\n" + key + " = 3\n"),
        HasSubstr("[columns] of map.toml: " + key + " = 3: the model does not use this column"));
}

TEST(ColumnMap, UnitAndFactorOfARuleComeBeforeTheHeader) {
  const Record r =
      read("n,M [Nm]\n1000,-25\n",
           "[columns]\nspeed_rpm = {column = \"n\", unit = \"rad/s\"}\n"
           "friction_torque_Nmm = {column = \"M [Nm]\", unit = \"Ncm\", factor = -1}\n");
  EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 1000);
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 0.25);
}

constexpr const char* american = R"map([columns]
speed_rpm = "Speed (rad/sec)"
axial_load_N = "Load (lbs)"
temperature_C = "Temp (C)"
friction_torque_Nmm = "Torque (ozf·in)"
)map";

TEST(ColumnMap, UnitsInBracketsOfTheirHeadersAreRead) {
  const Record r =
      read("Speed (rad/sec);Load (lbs);Temp (C);Torque (ozf·in)\n62.8;45;30;16\n62.8;135;30;19\n",
           american);
  EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 62.8);
  EXPECT_NEAR(r.value(record::axial_load, 0), 45 * 4.4482216152605, 1e-9);
  EXPECT_NEAR(r.value(record::friction_torque, 0), 16 * 7.0615518e-3, 1e-8);
}

TEST(ColumnMap, AUnitThatIsNotKnownIsAnError) {
  EXPECT_EQ(map_error("n (bananas),M\n1,2\n",
                      "[columns]\nspeed_rpm = \"n (bananas)\"\nfriction_torque_Nmm = \"M\"\n"),
            "d.csv:1: column \"n (bananas)\": \"bananas\" is not a known unit of speed; known "
            "units: rpm, 1_s, rad_s, deg_s or krpm. Give the unit in [columns]: speed_rpm = { "
            "column = \"n (bananas)\", unit = \"...\" }");
  // Of another kind, in a row of units, and without a map.
  const std::string map =
      "[columns]\nspeed_rpm = \"n\"\nfriction_torque_Nmm = \"M [V]\"\naxial_load_N = \"F\"\n";
  EXPECT_THAT(map_error("n,M [V],F\n1,2,3\n", map), HasSubstr("\"V\" is not a known unit of"));
  EXPECT_THAT(map_error("n,M [V],F\nrpm,,stones\n1,2,3\n", map), HasSubstr("\"V\" is not a known"));
  EXPECT_THAT(map_error("n,M,F\nrpm,Nm,stones\n1,2,3\n",
                        "[columns]\nspeed_rpm = \"n\"\nfriction_torque_Nmm = \"M\"\n"
                        "axial_load_N = \"F\"\n"),
              HasSubstr("column \"F\": \"stones\" is not a known unit of axial load"));
  EXPECT_THAT(map_error("speed_rpm,axial load [lbz],friction_torque_Nmm\n1,2,3\n", "[columns]\n"),
              HasSubstr("\"lbz\" is not a known unit of axial load"));
}

TEST(ColumnMap, AStatedUnitAnswersForAHeader) {
  const Record r = read("n (bananas),M\n1000,2\n",
                        "[columns]\nspeed_rpm = {column = \"n (bananas)\", unit = \"rpm\"}\n"
                        "friction_torque_Nmm = \"M\"\n");
  EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 1000 * rpm);
}

TEST(ColumnMap, BracketsBehindDatesAreNoUnit) {
  const Record r = read(
      "Time (UTC),speed_rpm,friction_torque_Nmm\n2024-03-12T08:15:00,1,1\n"
      "2024-03-12T08:15:05,2,1\n",
      "[columns]\ntime_s = \"Time (UTC)\"\n");
  EXPECT_DOUBLE_EQ(r.value(record::time, 1), 5);
}

TEST(ColumnMap, DatesOfExcelAreDays) {
  const Record r = read("Zeit,speed_rpm,friction_torque_Nmm\n45363.34375,1,1\n45363.34381,2,1\n",
                        "[columns]\ntime_s = {column = \"Zeit\", unit = \"excel\"}\n");
  EXPECT_NEAR(r.value(record::time, 1), 5.184, 1e-3);
  EXPECT_THAT(texts(r.notes),
              Contains("column Zeit has Excel dates: time_s is measured from 2024-03-12T08:15:00"));
}

TEST(ColumnMap, AFileWithOurNamesNeedsNoRule) {
  const std::string map = "[columns]\nspeed_rpm = \"Drehzahl\"\nradial_load_N = 30\n";
  EXPECT_DOUBLE_EQ(read("speed_rpm,friction_torque_Nmm\n1000,5\n", map).value(record::speed, 0),
                   1000 * rpm);
  // A column comes before the number for missing ones.
  EXPECT_DOUBLE_EQ(read("speed_rpm,radial_load_N,friction_torque_Nmm\n1000,7,5\n", map)
                       .value(record::radial_load, 0),
                   7);
}

TEST(ColumnMap, OneOfSeveralHeadersIsEnough) {
  const std::string map =
      "[columns]\nfriction_torque_Nmm = [\"M\", { column = \"Moment\", unit = \"Nm\" }]\n"
      "speed_rpm = [\"n\", \"speed\"]\n";
  for (const std::string header : {"n,M", "speed,M"}) {
    const Record r = read(header + "\n100,5\n", map);
    EXPECT_DOUBLE_EQ(r.value(record::speed, 0), 100 * rpm);
    EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 0), 5e-3);
  }
  EXPECT_DOUBLE_EQ(read("n,Moment\n100,5\n", map).value(record::friction_torque, 0), 5);
  EXPECT_EQ(map_error("n,speed,M\n100,100,5\n", map),
            "d.csv:1: columns n and speed are both read as speed; keep one of them");
  EXPECT_THAT(
      map_error("n,T\n100,5\n", map),
      HasSubstr("d.csv:1: the column \"M\" or \"Moment\" is missing; map.toml:2 uses it for "
                "friction_torque_Nmm"));
  EXPECT_THAT(map_error("n,T\n100,5\n", "[columns]\naxial_load_N = [\"F\", 100]\n"),
              HasSubstr("a list may have only headers in quotes"));
}

TEST(ColumnMap, WhatIsWrongInItIsNamedWithItsLine) {
  const std::string data = "speed_rpm,friction_torque_Nmm\n1000,5\n";
  EXPECT_THAT(map_error(data, "[columns]\nspeed_rpn = \"n\"\n"),
              HasSubstr("map.toml:2: [columns] speed_rpn = \"n\": raceway has no column of this "
                        "name; did you mean speed_rpm?"));
  EXPECT_THAT(map_error(data, "[columns]\nspeed_rpm = {column = \"n\", unit = \"Nm\"}\n"),
              HasSubstr("unit = \"Nm\": must be rpm, 1_s, rad_s, deg_s or krpm"));
  EXPECT_THAT(map_error(data, "[columns]\naxial_load_N = 1e12\n"), HasSubstr("must be from 0 to"));
  EXPECT_THAT(map_error(data, "[columns]\nfriction_torque_Nmm = 3\n"),
              HasSubstr("one number for all rows is not possible"));
  EXPECT_THAT(map_error(data, "[columns]\nspeed_rpm = \"n\"\nspeed_rad_s = \"m\"\n"),
              HasSubstr("map.toml:3: [columns] speed_rpm and speed_rad_s are the same quantity"));
  EXPECT_THAT(
      map_error(data, "[bearing]\n"),
      HasSubstr(": a file for --columns may have only the tables [columns] and [transducers]"));
  EXPECT_THAT(map_error("n,friction_torque_Nmm\n1000,5\n", "[columns]\nspeed_rpm = \"N\"\n"),
              HasSubstr("d.csv:1: the column \"N\" is missing; map.toml:2 uses it for speed_rpm"));
}

TEST(ColumnMap, StandsInAModelToo) {
  const ModelFile file = parse_model(
      "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
      "viscosity_100C_mm2_s = 4.8\n[columns]\nspeed_rpm = \"Drehzahl [1/min]\"\n",
      "my.toml");
  ASSERT_EQ(file.columns.rules.size(), 1u);
  EXPECT_EQ(file.columns.rules[0].header, "Drehzahl [1/min]");
}

TEST(DropNan, KnowsTheWordsOfInstruments) {
  std::string text = "speed_rpm,friction_torque_Nmm\n0,5\n";
  for (const char* word : {"OVER", "OL", "Inf", "1.#QNAN", "-1.#IND", "NaT", "--", "<NA>", "#REF!",
                           "Bad Input", "-1.#INF"})
    text += fmt::format("1,{}\n{},2\n", word, word);
  EXPECT_EQ(read(text, "[columns]\n", true).rows(), 1u);
}

TEST(DropNan, AnErrorOfASpreadsheetInTheFirstCellIsNoComment) {
  const std::string text = "speed_rpm,friction_torque_Nmm\n#N/A,5\n2,6\n";
  EXPECT_THAT(tests::message_of([&] { (void)read(text); }),
              HasSubstr("d.csv:2: speed_rpm = \"#N/A\": is not a number"));
  EXPECT_EQ(read(text, "[columns]\n", true).rows(), 1u);
}

TEST(DropNan, RowsWithoutANumberAreLeftOutAndCounted) {
  const std::string text =
      "speed_rpm,friction_torque_Nmm,remark\n1,5,\n2,nan,x\n3,,\n4,#N/A,\n5,6,\n";
  EXPECT_THAT(tests::message_of([&] { (void)read(text); }), HasSubstr("3 invalid values"));
  const Record r = read(text, "[columns]\n", true);
  ASSERT_EQ(r.rows(), 2u);
  EXPECT_EQ(r.line(1), 6);
  EXPECT_THAT(texts(r.notes), Contains("3 of 5 rows have an empty cell or a cell without a number "
                                       "and are not used (lines 3, 4, 5)"));
  EXPECT_THAT(tests::message_of([&] {
                (void)read("speed_rpm,friction_torque_Nmm\n1,five\n", "[columns]\n", true);
              }),
              HasSubstr("is not a number"));
}

}  // namespace
}  // namespace raceway::files

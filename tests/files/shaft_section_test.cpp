// [arrangement] of a model file.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "files/model_file.h"
#include "tests/support/message_of.h"
#include "text/error.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string bearing_text = R"([bearing]
name = "7014"
ball_count = 20
ball_diameter_mm = 11.906
pitch_diameter_mm = 90.0
contact_angle_deg = 25.0
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 43000
)";
const std::string rest = R"(
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8

[friction]
f0 = 1.5
z = 0.001
y = 0.33
)";
// Its head stands in line 11.
const std::string shaft_sets = "[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\n";

ModelFile parsed(const std::string& arrangement, const std::string& bearing = bearing_text) {
  return parse_model(bearing + "\n" + arrangement + rest, "m.toml");
}

bearing::Arrangement arrangement(const std::string& text,
                                 const std::string& bearing = bearing_text) {
  return parsed(text, bearing).model.shaft.value().arrangement;
}

std::string section_error(const std::string& text, const std::string& bearing = bearing_text) {
  return tests::message_of([&] { (void)parsed(text, bearing); });
}

TEST(ShaftSection, ReadsEveryKeyIntoSi) {
  const ModelFile file = parsed(
      "[arrangement]\nlayout = \"X\"\nfront = 3\nrear = 2\nmounting = \"spring\"\n"
      "spring_rate_N_um = 40\npreload_N = 700\nexternal_load_N = -150\n"
      "shaft_stiffness_N_um = 500\nhousing_stiffness_N_um = 800\ndistance_mm = 180\n"
      "shaft_expansion_1e6_K = 12\nhousing_expansion_1e6_K = 10.5\nmounting_temperature_C = 22\n"
      "inner_ring_temperature_C = 40\nouter_ring_temperature_C = 36\nball_temperature_C = 39\n"
      "shaft_temperature_C = 41\nhousing_temperature_C = 33\n");
  const model::Shaft& shaft = *file.model.shaft;
  const bearing::ArrangementDesign& d = shaft.arrangement.design();
  EXPECT_EQ(d.layout, bearing::Layout::face_to_face);
  EXPECT_EQ(d.front.size(), 3u);
  EXPECT_EQ(d.rear.size(), 2u);
  EXPECT_EQ(d.mounting, bearing::Mounting::spring);
  EXPECT_DOUBLE_EQ(d.spring_rate, 40e6);
  EXPECT_EQ(shaft.arrangement.preload(), 700);
  EXPECT_EQ(shaft.external_load, -150);
  EXPECT_DOUBLE_EQ(d.shaft_stiffness, 500e6);
  EXPECT_DOUBLE_EQ(d.housing_stiffness, 800e6);
  EXPECT_DOUBLE_EQ(d.distance, 0.18);
  EXPECT_DOUBLE_EQ(d.shaft_expansion, 12e-6);
  EXPECT_DOUBLE_EQ(d.housing_expansion, 10.5e-6);
  EXPECT_DOUBLE_EQ(d.mounting_temperature, kelvin(22));
  EXPECT_DOUBLE_EQ(shaft.temperatures->inner_ring, kelvin(40));
  EXPECT_DOUBLE_EQ(shaft.temperatures->outer_ring, kelvin(36));
  EXPECT_DOUBLE_EQ(shaft.temperatures->balls, kelvin(39));
  EXPECT_DOUBLE_EQ(shaft.temperatures->shaft, kelvin(41));
  EXPECT_DOUBLE_EQ(shaft.temperatures->housing, kelvin(33));
  // All of a side share one bearing.
  EXPECT_EQ(d.front[0].bearing, d.rear[1].bearing);
}

TEST(ShaftSection, NamesItsDefaults) {
  const ModelFile file = parsed(shaft_sets + "preload_N = 600\n");
  EXPECT_FALSE(file.model.shaft->temperatures);
  EXPECT_THAT(lines(file.defaults), Contains("arrangement.mounting = \"rigid\" (default)"));
  EXPECT_THAT(lines(file.defaults), Contains("arrangement.external_load_N = 0 (default)"));
  EXPECT_THAT(lines(file.defaults), Not(Contains(HasSubstr("temperature_C = 20"))));
  // One temperature stands for what touches it; the rest is as mounted.
  const ModelFile warm = parsed(shaft_sets + "preload_N = 600\ninner_ring_temperature_C = 35\n");
  EXPECT_DOUBLE_EQ(warm.model.shaft->temperatures->shaft, kelvin(35));
  EXPECT_DOUBLE_EQ(warm.model.shaft->temperatures->housing, kelvin(20));
  EXPECT_DOUBLE_EQ(warm.model.shaft->temperatures->balls, kelvin(27.5));
  EXPECT_THAT(lines(warm.defaults), Contains("arrangement.shaft_temperature_C = 35 (default)"));
  EXPECT_THAT(lines(warm.defaults), Contains("arrangement.distance_mm = 0 (default)"));
}

TEST(ShaftSection, OneBearingOnARigHasNoShaft) { EXPECT_FALSE(parsed("").model.shaft); }

TEST(ShaftSection, BearingsThatDifferChangeWhatTheirTablesSay) {
  const auto a = arrangement(shaft_sets +
                             "preload_N = 600\n[arrangement.rear_bearing]\ncontact_angle_deg = 15\n"
                             "ball_material = \"silicon-nitride\"\n");
  const auto front = a.bearings()[0].bearing->geometry();
  const auto rear = a.bearings()[2].bearing->geometry();
  EXPECT_DOUBLE_EQ(rear.contact_angle, 15 * degree);
  EXPECT_EQ(rear.ball_diameter, front.ball_diameter);
  EXPECT_EQ(a.bearings()[2].bearing->balls().name, "silicon-nitride");
  EXPECT_EQ(a.bearings()[1].bearing->balls().name, "steel");
  // One table for each: the second is ground differently.
  const auto b = arrangement(shaft_sets +
                             "preload_N = 600\n[[arrangement.front_bearing]]\n"
                             "[[arrangement.front_bearing]]\nball_count = 18\n"
                             "offset_um = 0.5\n");
  EXPECT_EQ(b.bearings()[0].bearing->geometry().ball_count, 20);
  EXPECT_EQ(b.bearings()[1].bearing->geometry().ball_count, 18);
  EXPECT_DOUBLE_EQ(b.bearings()[1].offset, 0.5 * um);
  // A bearing of the catalogue is all its own.
  const auto c = arrangement(shaft_sets +
                             "preload_N = 600\n[arrangement.rear_bearing]\n"
                             "catalogue = \"S 6010 E\"\n");
  EXPECT_DOUBLE_EQ(c.bearings()[2].bearing->geometry().bore, 50 * mm);
}

TEST(ShaftSection, PreloadIsAForceAnOffsetOrAClass) {
  const auto by_force = arrangement(shaft_sets + "preload_N = 600\n");
  const double offset =
      by_force.displacement(bearing::Side::front) + by_force.displacement(bearing::Side::rear);
  const auto by_offset =
      arrangement(shaft_sets + fmt::format("preload_offset_um = {:.12g}\n", offset / um));
  EXPECT_NEAR(by_offset.preload(), 600, 1e-6);
  const std::string catalogue = "[bearing]\ncatalogue = \"S 6014 E\"\n";
  // 1200 N for a pair; two against one are preloaded more.
  EXPECT_NEAR(arrangement("[arrangement]\nlayout = \"O\"\nfront = 1\nrear = 1\n"
                          "preload_class = \"medium\"\n",
                          catalogue)
                  .preload(),
              1200, 1e-6);
  EXPECT_NEAR(arrangement(shaft_sets + "preload_class = \"medium\"\n", catalogue).preload() / 1200,
              1.35, 0.03);
}

TEST(ShaftSection, NamesOfTheTradeSayLayoutAndNumbers) {
  const auto read = [](const std::string& text) {
    return arrangement("[arrangement]\n" + text + "preload_N = 600\n");
  };
  const auto tbt = read("layout = \"TBT\"\n"), o = read("layout = \"O\"\nfront = 2\nrear = 1\n");
  EXPECT_EQ(tbt.bearings().size(), 3u);
  EXPECT_DOUBLE_EQ(tbt.preload(), o.preload());
  EXPECT_EQ(read("layout = \"QBC\"\n").bearings().size(), 4u);
  EXPECT_EQ(read("layout = \"DF\"\n").bearings().size(), 2u);
  EXPECT_EQ(read("layout = \"DT\"\nmounting = \"spring\"\n").bearings().size(), 2u);
  // The set may stand the other way round.
  EXPECT_EQ(read("layout = \"TBT\"\nfront = 1\nrear = 2\n").bearings().size(), 3u);
  EXPECT_THAT(section_error("[arrangement]\nlayout = \"DB\"\nfront = 2\npreload_N = 600\n"),
              HasSubstr("front = 2, rear = 1: layout = \"DB\" has sets of 1 and 1"));
}

TEST(ShaftSection, WrongKeysAndValuesAreNamed) {
  EXPECT_EQ(section_error("[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload = 600\n"),
            "m.toml:15: preload = 600: unknown key in [arrangement]; did you mean preload_N?");
  EXPECT_THAT(section_error("[arrangement]\nfront = 2\n"),
              StartsWith("m.toml:11: [arrangement] layout is missing: must be O, X, tandem, DB, "));
  EXPECT_THAT(section_error("[arrangement]\nlayout = \"o\"\n"),
              StartsWith("m.toml:12: layout = \"o\": must be O, X, tandem, DB, "));
  EXPECT_EQ(section_error("[arrangement]\nlayout = \"O\"\nfront = 0\nrear = 1\n"),
            "m.toml:13: front = 0: must be from 1 to 20");
  EXPECT_EQ(section_error("[arrangement]\nlayout = \"O\"\nfront = 2\n"),
            "m.toml:11: [arrangement] rear is missing: must be from 0 to 20");
  EXPECT_THAT(section_error("[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 0\n"),
              StartsWith("m.toml:14: rear = 0: must be from 1 to 20"));
  EXPECT_EQ(section_error(shaft_sets + "preload_N = -1\n"),
            "m.toml:15: preload_N = -1 N: must be from 0.001 to 100000000 N");
  EXPECT_EQ(section_error(shaft_sets),
            "m.toml:11: [arrangement] preload is missing: give exactly one of preload_N, "
            "preload_offset_um and preload_class");
  EXPECT_THAT(section_error(shaft_sets + "preload_N = 600\npreload_offset_um = 5\n"),
              HasSubstr("preload_N and preload_offset_um are given"));
  EXPECT_THAT(section_error(shaft_sets + "preload_class = \"medium\"\n"),
              StartsWith("m.toml:15: preload_class = \"medium\": 7014 is not in the catalogue, so "
                         "it has no preload class; give preload_N"));
  EXPECT_EQ(section_error(shaft_sets + "preload_N = 600\nspring_rate_N_um = 5\n"),
            "m.toml:16: spring_rate_N_um = 5: only possible with mounting = \"spring\"");
  EXPECT_THAT(section_error(shaft_sets + "mounting = \"spring\"\npreload_offset_um = 5\n"),
              StartsWith("m.toml:16: preload_offset_um: a spring needs a force; give preload_N"));
  EXPECT_THAT(section_error("[arrangement]\nlayout = \"tandem\"\nfront = 2\npreload_N = 600\n"),
              HasSubstr("write mounting = \"spring\""));
  EXPECT_THAT(
      section_error(shaft_sets + "preload_N = 600\n[[arrangement.rear_bearing]]\n"
                                 "[[arrangement.rear_bearing]]\n"),
      StartsWith("m.toml:16: the model has [[arrangement.rear_bearing]] 2 times, but rear = 1"));
  EXPECT_EQ(section_error(shaft_sets +
                          "preload_N = 600\n[arrangement.rear_bearing]\nball_diameter_mm = -1\n"),
            "m.toml:17: ball_diameter_mm = -1 mm: must be from 0.1 to 300 mm");
  EXPECT_THAT(
      section_error(shaft_sets + "preload_N = 600\n[arrangement.rear_bearing]\nball_cnt = 5\n"),
      HasSubstr("unknown key in [arrangement.rear_bearing]; did you mean ball_count?"));
  EXPECT_THAT(section_error(shaft_sets + "preload_N = 600\nrear_bearing = 3\n"),
              HasSubstr("rear_bearing = 3: must be a table"));
  EXPECT_THAT(
      section_error(shaft_sets +
                    "preload_N = 600\n[arrangement.rear_bearing]\ncontact_angle_deg = 0\n"),
      HasSubstr("m.toml:11: [arrangement] rear bearing 1: contact_angle = 0 deg: must be from 5 to "
                "65 deg"));
}

}  // namespace
}  // namespace raceway::files

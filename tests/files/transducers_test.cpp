#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "control/formats.h"
#include "correction/numbers.h"
#include "files/column_map.h"
#include "files/correction_file.h"
#include "files/new_correction.h"
#include "files/series_doubts.h"
#include "files/series_file.h"
#include "record/series_channel.h"
#include "text/error.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsNan;
using testing::ThrowsMessage;

const std::string nest =
    "[transducers]\n"
    "displacement_x_um = { x1_um = 1.25, x2_um = -0.25 }\n"
    "displacement_b_urad = { x1_um = -5, x2_um = 5 }\n";

const record::Channel& nest_x = *record::series_channel("displacement_x_um");
const record::Channel& nest_b = *record::series_channel("displacement_b_urad");

record::Record nest_record(const std::string& text, const std::string& map = nest) {
  return read_series({"r.csv", text}, {&nest_x, &nest_b}, {},
                     {.columns = parse_column_map(map, "nest.toml")});
}
auto nest_refused(const std::string& message) {
  return ThrowsMessage<text::InputError>(HasSubstr(message));
}
auto nest_map(const std::string& text) {
  return [text] { (void)parse_column_map(text, "nest.toml"); };
}

// A bar that is 2 um away and tilted by 10 urad: 2 um and 4 um, 0.2 m from each other.
TEST(Transducers, TogetherReadPositionAndAngle) {
  const record::Record r = nest_record("time_s,x1_um,x2_um\n0,0,0\n60,2,4\n");
  EXPECT_NEAR(r.value(nest_x, 1), 1.5e-6, 1e-18);
  EXPECT_NEAR(r.value(nest_b, 1), 10e-6, 1e-17);
  EXPECT_EQ(r.columns.size(), 3U) << "the transducers themselves are gone";
  EXPECT_THAT(r.notes, Contains(Field(
                           &record::Note::text,
                           HasSubstr("displacement_b_urad is calculated as -5 x1_um + 5 x2_um"))));
}

TEST(Transducers, MayBeInAnyUnitAndHaveAnyHeader) {
  const record::Record nm = nest_record("time_s,x1 [nm],x2_mm\n0,0,0\n60,2000,0.004\n");
  EXPECT_NEAR(nm.value(nest_b, 1), 10e-6, 1e-17);
  const record::Record theirs =
      nest_record("t [s],Kanal 3,Kanal 4\n0,0,0\n60,2,4\n",
                  nest +
                      "[columns]\ntime_s = \"t [s]\"\nx1_um = \"Kanal 3\"\nx2_um = { column = "
                      "\"Kanal 4\", factor = -1 }\n");
  EXPECT_NEAR(theirs.value(nest_b, 1), -30e-6, 1e-17);
}

TEST(Transducers, AReadingOfWhichOneIsMissingIsMissing) {
  const record::Record r = nest_record("time_s,x1_um,x2_um\n0,0,0\n60,2,\n120,3,3\n");
  EXPECT_THAT(r.value(nest_b, 1), IsNan());
  EXPECT_EQ(r.value(nest_b, 2), 0.0);
}

TEST(Transducers, AMissingOneIsNamed) {
  EXPECT_THAT([] { (void)nest_record("time_s,x1_um,y1_um\n0,0,0\n60,2,4\n"); },
              nest_refused("r.csv:1: column x2_um is missing, from which nest.toml:2 [transducers] "
                           "calculates displacement_x_um; the header has time_s, x1_um and y1_um"));
}

TEST(Transducers, OfARecordAreNamedWhereNoCombinationHasThem) {
  EXPECT_THAT(nest_record("time_s,x1_um,x2_um,y1_um\n0,0,0,0\n60,2,4,1\n").notes,
              Contains(Field(&record::Note::text, HasSubstr("not used by the model: y1_um"))));
}

TEST(Transducers, ARecordWithoutAnyHasItsDisplacementsAsTheyStand) {
  const record::Record r = nest_record("time_s,displacement_b [mrad]\n0,0\n60,0.01\n");
  EXPECT_NEAR(r.value(nest_b, 1), 10e-6, 1e-17);
  EXPECT_THAT(
      [] { (void)nest_record("time_s,x1_um,x2_um,displacement_b_urad\n0,0,0,0\n60,2,4,1\n"); },
      nest_refused("has a column displacement_b_urad, which nest.toml:3 [transducers] calculates "
                   "from other columns"));
}

TEST(Transducers, ARowThatFollowsFromOthersIsRefused) {
  EXPECT_THAT(
      nest_map(nest + "displacement_a_urad = { x1_um = 1, x2_um = 3 }\n"),
      nest_refused("nest.toml:4: [transducers] displacement_a_urad is a linear combination of "
                   "displacement_x_um and displacement_b_urad: the 2 transducers cannot "
                   "separate this displacement from the others"));
  EXPECT_THAT(nest_map("[transducers]\ndisplacement_z_um = { z_um = 1, z2_um = 0 }\n"),
              nest_refused("[transducers] z2_um: all factors of this transducer are 0"));
  EXPECT_THAT(nest_map("[transducers]\ndisplacement_z_um = { z_mm = 1 }\n"),
              nest_refused("z_mm: the name of a transducer must end in _um"));
  EXPECT_THAT(nest_map("[transducers]\nz_um = { z1_um = 1 }\n"),
              nest_refused("[transducers] z_um: must be a column displacement_NAME_um or"));
  EXPECT_THAT(nest_map("[transducers]\ndisplacement_z_um = { z1_um = \"1\" }\n"),
              nest_refused("must be a number from -1000000 to 1000000 um/um"));
}

TEST(Transducers, BeginAModelOfWhatTheyMake) {
  std::string text = "time_s,front_temperature_C,x1_um,x2_um\n";
  for (int k = 0; k < 60; ++k)
    text += fmt::format("{},{},{},{}\n", 60 * k, 20.0 + 0.1 * k, 0.2 * k, 0.5 * k);
  const std::string made =
      new_correction({"r.csv", text}, {.columns = parse_column_map(nest, "nest.toml")}).text;
  EXPECT_THAT(
      made, testing::AllOf(HasSubstr("displacement = \"displacement_b_urad\"\ntolerance_urad = 8."),
                           HasSubstr("displacement_b_urad = { x1_um = -5.0, x2_um = 5.0 }"),
                           testing::Not(HasSubstr("displacement_x1_um"))));
}

TEST(Transducers, AnOffsetOfAnAngleIsTakenOff) {
  const record::Record r =
      nest_record("time_s,x1_um,x2_um,offset_b_urad\n0,0,0,0\n60,2,4,4\n120,2,4,4\n");
  EXPECT_NEAR(r.value(nest_b, 1), 6e-6, 1e-17);
  EXPECT_THAT(r.notes, Contains(Field(&record::Note::text,
                                      HasSubstr("the offset of the control, offset_b_urad, is "
                                                "subtracted from displacement_b_urad"))));
}

const std::string angle_text =
    "[correction]\ndisplacement = \"displacement_b_urad\"\ntolerance_urad = 2\noffset_urad = -3\n"
    "measurement_std_urad = 0.5\n"
    "[[correction.channel]]\nname = \"head\"\ninput = \"front_temperature_C\"\n"
    "sections = [{ gain_urad_K = 5.0, time_constant_s = 5400 }]\n"
    "[[correction.channel]]\nname = \"power\"\ninput = \"spindle_power_W\"\n"
    "gain = { slope_urad_W = 0.1, offset_urad = 2 }\n"
    "time_constant = { slope_min_W = 0.01, offset_min = 20 }\n"
    "[correction.residual]\nrms_urad = 0.4\n"
    "[correction.trust]\nerror_urad = 0.4\nuncorrected_urad = 20\nduration_s = 90000\n"
    "course = \"returns\"\njudged_by = \"held-out\"\n";

TEST(Angle, HasKeysOfItsOwnUnit) {
  const CorrectionFile file = parse_correction(angle_text, "b.toml");
  const correction::Model& m = file.models.at(0);
  EXPECT_NEAR(m.tolerance, 2e-6, 1e-18);
  EXPECT_NEAR(m.offset, -3e-6, 1e-18);
  EXPECT_NEAR(m.channels[0].sections[0].gain, 5e-6, 1e-18);
  EXPECT_NEAR(m.left->rms, 0.4e-6, 1e-18);
  std::vector<std::string> units;
  for (const record::Parameter& p : correction::parameters(m)) units.push_back(p.unit);
  EXPECT_THAT(units, testing::ElementsAre("urad", "urad/K", "s", "1", "1"));
  std::vector<correction::Model> fitted = file.models;
  fitted[0].offset = 1e-6;
  fitted[0].channels[0].sections[0].gain = 6e-6;
  EXPECT_THAT(with_corrections(file, fitted),
              testing::AllOf(HasSubstr("offset_urad = 1"), HasSubstr("{ gain_urad_K = 6.0")));
  EXPECT_THAT(
      [] {
        std::string text = angle_text;
        (void)parse_correction(text.replace(text.find("gain_urad_K"), 11, "gain_um_K"), "b.toml");
      },
      nest_refused("gain_um_K = 5: unknown key in [sections]; it has gain_urad_K"));
}

TEST(Angle, HasLimitsAndAUnitOfItsOwnOnAControl) {
  const auto plan_of = [](const std::string& text) {
    const CorrectionFile file = parse_correction(text, "b.toml");
    return control::control_plan(file.models, file.control, "b.toml");
  };
  const control::ControlPlan usual = plan_of(angle_text);
  EXPECT_EQ(usual.axes[0].output, "offset_b_urad");
  EXPECT_EQ(usual.axes[0].letter, "b");
  EXPECT_THAT(control::control_csv(usual),
              testing::AllOf(HasSubstr(",gain,5,urad/K"), HasSubstr(",limit,100,urad"),
                             HasSubstr("Displacements whose names end in urad are angles: for "
                                       "these, read urad instead of um.")));
  const control::ControlPlan deg =
      plan_of(angle_text + "[export]\nunit_of_angles = \"deg\"\nlimit_urad = 40\n");
  EXPECT_EQ(deg.axes[0].output, "offset_b_deg");
  EXPECT_NEAR(deg.axes[0].unit_um, 1e6 * std::acos(-1.0) / 180.0, 1e-8);
  EXPECT_EQ(deg.axes[0].limit_um, 40.0);
  EXPECT_THAT([&] { (void)plan_of(angle_text + "[export]\nlimit_um = 40\n"); },
              nest_refused("limit_um: the model has no displacement that is a length"));
}

// 30 urad for 5 K.
TEST(Angle, IsAskedAboutWhereItsUnitIsImplausible) {
  const auto doubts = [](double per_urad) {
    std::string text = "time_s,front_temperature_C,displacement_b_urad\n";
    for (int k = 0; k < 60; ++k)
      text += std::to_string(60 * k) + "," + std::to_string(20.0 + 5.0 * k / 59) + "," +
              fmt::format("{:.9g}\n", per_urad * 30.0 * k / 59);
    return series_doubts(read_series({"r.csv", text}, {}, {}), std::vector<correction::Model>());
  };
  EXPECT_TRUE(doubts(1.0).empty());
  for (const auto& [per_urad, unit] :
       {std::pair{1e-3, "mrad"}, std::pair{1e-6, "rad"}, std::pair{1e-6 * 180 / 3.14159, "deg"}}) {
    const std::vector<Doubt> found = doubts(per_urad);
    ASSERT_EQ(found.size(), 1U) << unit;
    EXPECT_THAT(found[0].text, HasSubstr("displacement_b_urad changes by ")) << unit;
    EXPECT_THAT(found[0].text, HasSubstr(std::string("are the values in ") + unit + " (")) << unit;
  }
}

}  // namespace
}  // namespace raceway::files

#include "files/model_file.h"

#include "files/subject.h"
#include "model/base_laws.h"
#include "model/needs.h"
#include "model/prediction.h"
#include "session/solve_point.h"
#include "tests/roller/reference_cases.h"
#include "tests/support/message_of.h"

namespace raceway::roller {
namespace {

using testing::HasSubstr;
using tests::message_of;

std::string model_text(const std::string& bearing = "", const std::string& rest = "") {
  return R"([bearing]
type = "cylindrical-roller"
roller_count = 20
roller_diameter_mm = 8
roller_length_mm = 8
pitch_diameter_mm = 77.5
bore_mm = 60
outer_diameter_mm = 95
)" + bearing +
         R"(
[lubricant]
viscosity_40C_mm2_s = 20
viscosity_100C_mm2_s = 4.4
)" + rest;
}

files::ModelFile model(const std::string& bearing = "", const std::string& rest = "") {
  return files::parse_model(model_text(bearing, rest), "roller.toml");
}

TEST(RollerModel, ReadsItsKeysAndDefaults) {
  const files::ModelFile file = model("radial_clearance_um = -4\n");
  const bearing::RollerBearing& b = *file.model.bearing.rollers();
  EXPECT_EQ(b.geometry().roller_count, 20);
  EXPECT_NEAR(b.geometry().radial_clearance, -4 * um, 1e-18);
  EXPECT_EQ(file.model.f1_load, friction::F1Load::rollers);
  EXPECT_EQ(file.model.law_values, (std::vector{1.5, 0.0003}));
  EXPECT_EQ(files::make_subject(file.model)->free(), (std::vector<std::string>{"f0", "f1"}));
  EXPECT_THAT(files::lines(file.defaults),
              testing::Contains("bearing.profile = \"iso\" (default)"));
}

TEST(RollerModel, F0FollowsTheSupply) {
  for (const auto& [supply, f0] :
       {std::pair{"grease", 0.8}, {"oil-air", 1.5}, {"bath", 3.0}, {"jet", 6.0}})
    EXPECT_EQ(model("", std::string("supply = \"") + supply + "\"\n").model.law_values[0], f0);
}

TEST(RollerModel, SaysWhatIsWrongInAFile) {
  const auto why = [](const std::string& bearing, const std::string& rest = "") {
    return message_of([&] { (void)model(bearing, rest); });
  };
  EXPECT_EQ(why("ball_count = 20\n"),
            "roller.toml:9: ball_count = 20: this key is only for ball bearings, but the type is "
            "\"cylindrical-roller\"; use roller_count");
  EXPECT_THAT(why("contact_angle_deg = 15\n"), HasSubstr("this key is only for ball bearings"));
  EXPECT_THAT(why("", "[friction]\nz = 0.001\n"),
              HasSubstr("z = 0.001: this key is only for ball bearings; the load moment of "
                        "cylindrical rollers is f1 F d_m"));
  EXPECT_THAT(why("", "[friction]\nlaw = \"contact\"\n"),
              HasSubstr("law = \"contact\" is only for ball bearings"));
  EXPECT_THAT(
      why("", "[rig]\naxial_load_N = 100\n"),
      HasSubstr("axial_load_N = 100: must be 0, because a cylindrical roller bearing of type N"));
  EXPECT_THAT(why("", "[arrangement]\nlayout = \"O\"\n"),
              HasSubstr("is a single bearing on a rig"));
  EXPECT_THAT(why("radial_clearance_um = -101\n"),
              HasSubstr("radial_clearance_um = -101 um: must be from -100 to 1000 um"));
  EXPECT_THAT(why("width_mm = 7\n"), HasSubstr("width"));
  EXPECT_THAT(why("race_roughness_um = 0.05\n"), HasSubstr("this key is only for ball bearings"));
  EXPECT_THAT(
      why("", "[friction]\nmu_bl = 0.1\n"),
      HasSubstr("mu_bl = 0.1: this key is only for law = \"skf\", but the law is \"palmgren\""));
  EXPECT_THAT(why("", "[solver]\nrace_control = \"outer\"\n"),
              HasSubstr("race_control = \"outer\": this key is only for ball bearings"));
  EXPECT_THAT(why("", "[[effect]]\nid = \"spin-friction\"\n"),
              HasSubstr("needs a ball bearing, because cylindrical rollers do not spin"));
  EXPECT_THAT(
      message_of([] { (void)files::parse_model("[bearing]\nroller_count = 20\n", "ball.toml"); }),
      HasSubstr("roller_count = 20: this key is only for type = \"cylindrical-roller\""));
}

TEST(RollerModel, DataOfContactsAreNamedAsIgnored) {
  EXPECT_THAT(model("", "pressure_viscosity_1_GPa = 15\n").written,
              testing::Contains("pressure_viscosity_1_GPa"));
}

TEST(RollerModel, EachOfItsLawsIsTheOtherBaseOfTheOther) {
  const files::ModelFile file = model("", "[friction]\nf1_load = \"F_r\"\n");
  const auto others = files::make_subject(file.model)->other_bases();
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0].id, "law:skf");
  EXPECT_EQ(others[0].lacks, "");
  const model::Model skf = model::with_law(file.model, friction::FrictionLaw::roller_skf);
  const files::ModelFile read = files::parse_model(files::with_model(file, skf), "roller.toml");
  EXPECT_EQ(read.model.law, friction::FrictionLaw::roller_skf);
  EXPECT_EQ(read.model.law_values, skf.law_values);
  EXPECT_EQ(read.model.f1_load, friction::F1Load::F_r);
}

TEST(RollerModel, APointHasBalanceFrictionAndHeat) {
  const model::Model m = model().model;
  const bearing::OperatingPoint point{
      .speed = 4000 * rpm, .axial_load = 0.0, .radial_load = 2000.0, .temperature = kelvin(50)};
  const session::PointAnswer answer = session::solve_point(m, point);
  ASSERT_TRUE(answer.converged());
  EXPECT_NEAR(answer.friction.rollers->load[0], 2000.0, 1e-6);
  EXPECT_NEAR(answer.heat.inner + answer.heat.outer, answer.friction.power_loss, 1e-9);
  EXPECT_GT(answer.heat.outer, answer.heat.inner);
  EXPECT_THROW((void)m.bearing.geometry(), std::invalid_argument);
}

TEST(RollerModel, SaysWhatToWatch) {
  const auto notes = [](const files::ModelFile& file, double speed, double load) {
    const bearing::OperatingPoint point{.speed = speed, .axial_load = 0.0, .radial_load = load};
    const session::PointAnswer answer = session::solve_point(file.model, point);
    return texts(session::notes_on_point(file.model, point, answer));
  };
  using testing::ElementsAre;
  using testing::IsEmpty;
  EXPECT_THAT(notes(model("radial_clearance_um = 10\n"), 3000 * rpm, 0.0),
              ElementsAre(HasSubstr("loose")));
  EXPECT_THAT(notes(model("radial_clearance_um = 10\n"), 3000 * rpm, 300.0),
              ElementsAre(HasSubstr("rollers may skid")));
  EXPECT_THAT(notes(model("radial_clearance_um = -5\n"), 3000 * rpm, 300.0), IsEmpty());
  EXPECT_THAT(notes(model(), 0.0, 2e5), ElementsAre(HasSubstr("above 4 GPa")));
  EXPECT_THAT(notes(model(), 3000 * rpm, 3e4), ElementsAre(HasSubstr("above 2 GPa")));
}

}  // namespace
}  // namespace raceway::roller

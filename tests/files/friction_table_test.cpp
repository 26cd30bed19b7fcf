// Friction tables as files, and models that name one.

#include "files/friction_table.h"

#include <gmock/gmock.h>

#include <string>

#include "effects/catalogue.h"
#include "files/model_file.h"
#include "model/base_laws.h"
#include "model/needs.h"
#include "model/prediction.h"
#include "tests/support/model_text.h"
#include "text/error.h"

namespace raceway::files {
namespace {

using friction::FrictionLaw;
using testing::HasSubstr;
using testing::Not;

template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const text::InputError& e) {
    return e.what();
  }
  return {};
}

const std::string measured_table =
    "speed [1/min],axial_load_N,temperature_C,friction_torque_Nm,std_Nmm\n"
    "1000,100,30,0.090,2\n9000,100,30,0.150,4\n1000,400,30,0.140,2\n9000,400,30,0.260,4\n"
    "1000,100,60,0.050,2\n9000,100,60,0.080,4\n1000,400,60,0.090,2\n9000,400,60,0.140,4\n";

const std::string tabled_bearing =
    tests::model_text.substr(0, tests::model_text.find("\n[friction]"));
const std::string table_law = "\n[friction]\nlaw = \"table\"\nfile = \"rig/t.csv\"  # of May\n";

ModelFile tabled(const std::string& friction, const std::string& table = measured_table) {
  return parse_model(tabled_bearing + friction, "my.toml",
                     {{.name = "rig/t.csv", .path = "/home/rig/t.csv", .text = table}});
}

TEST(FrictionTableFile, IsReadInOtherUnitsWithItsBand) {
  const friction::TorqueTable t = parse_friction_table(measured_table, "t.csv");
  EXPECT_THAT(t.grid.axes.axial_load, testing::ElementsAre(100, 400));
  EXPECT_FALSE(t.has_radial_load);
  EXPECT_TRUE(t.has_band());
  friction::BearingState<> s;
  s.speed = 9000 * rpm, s.axial_load = 400, s.temperature = kelvin(60);
  EXPECT_NEAR(t.moment(s), 140 * N_mm, 1e-12);
  EXPECT_NEAR(t.half_width(s), 1.96 * 4 * N_mm, 1e-12);
  s.speed = 5000 * rpm, s.axial_load = 250, s.temperature = kelvin(45);
  EXPECT_NEAR(t.moment(s), 125 * N_mm, 1e-9);  // the mean of the eight
  EXPECT_NEAR(t.half_width(s), 1.96 * 3 * N_mm, 1e-12);
}

TEST(FrictionTableFile, KeepsThePartByTheLoad) {
  const friction::TorqueTable t =
      parse_friction_table("speed_rpm,friction_torque_Nmm,load_Nmm\n0,10,8\n1000,30,12\n", "t.csv");
  friction::BearingState<> s;
  s.speed = 500 * rpm;
  s.table = &t;
  const std::array scale{2.0};
  const auto m = friction::base_moments<double>(FrictionLaw::table, s, scale);
  EXPECT_NEAR(m.load, 2 * 10 * N_mm, 1e-12);
  EXPECT_NEAR(m.viscous, 2 * 10 * N_mm, 1e-12);
}

TEST(FrictionTableFile, RefusesWhatIsNoWholeGrid) {
  const auto message = [](const std::string& rows) {
    return refusal([&] {
      (void)parse_friction_table("speed_rpm,axial_load_N,friction_torque_Nmm\n" + rows, "t.csv");
    });
  };
  EXPECT_THAT(message("0,100,1\n10,100,2\n0,200,3\n"),
              HasSubstr("for example, speed_rpm 10, axial_load_N 200"));
  EXPECT_THAT(message("0,100,1\n0,100,2\n"), HasSubstr("t.csv:3: the point speed_rpm 0"));
  EXPECT_THAT(message("0,100,1\n10,100,\n"), HasSubstr("t.csv:3"));
  EXPECT_THAT(
      message("# slab 1/2: 2 of 4 points, grid 1f\n0,100,1\n10,100,2\n"),
      HasSubstr(
          ": the file is only one slab of a table; join all slabs with raceway table --merge"));
  EXPECT_THAT(refusal([] {
                (void)parse_friction_table(
                    "speed_rpm,friction_torque_Nmm,std_Nmm,friction_torque_band_Nmm\n0,1,1,2\n",
                    "t.csv");
              }),
              HasSubstr("both give the uncertainty of the torque; remove one"));
}

TEST(ModelWithTable, HasTheTorqueOfTheTable) {
  const ModelFile file = tabled(table_law + "scale = 1.1\n");
  EXPECT_EQ(file.model.law, FrictionLaw::table);
  ASSERT_EQ(file.files.size(), 1U);
  EXPECT_EQ(file.files[0].path, "/home/rig/t.csv");
  const model::FrictionPrediction p = model::predict_friction(
      file.model, {.speed = 9000 * rpm, .axial_load = 400, .temperature = kelvin(60)});
  EXPECT_NEAR(p.torque, 1.1 * 140 * N_mm, 1e-12);
  EXPECT_THAT(torque_parts(file.model), testing::ElementsAre("table"));
  EXPECT_THAT(moments_of_parts(file.model, p),
              testing::ElementsAre(testing::DoubleNear(1.1 * 140 * N_mm, 1e-12)));
  // A column that the table lacks is an assumption.
  EXPECT_TRUE(std::any_of(file.defaults.begin(), file.defaults.end(), [](const UsedDefault& d) {
    return d.table == "friction" && d.key == "radial_load_N" && d.value == "all";
  }));
}

TEST(ModelWithTable, NeedsAWholeFileOfOneBearing) {
  EXPECT_THAT(refusal([] { (void)tabled("\n[friction]\nlaw = \"table\"\n"); }),
              HasSubstr("[friction] file is missing: the law table needs a CSV with speed_rpm"));
  EXPECT_THAT(refusal([] { (void)tabled(table_law + "f0 = 2\n"); }),
              HasSubstr("f0 = 2: this key is only for law = \"palmgren\", \"powers\" or "
                        "\"contact-powers\", but the law is \"table\""));
  EXPECT_THAT(
      refusal([] { (void)tabled("\n[friction]\nf0 = 1\nz = 0.001\ny = 0.3\nscale = 2\n"); }),
      HasSubstr("scale = 2: this key is only for law = \"table\""));
  EXPECT_THAT(refusal([] {
                (void)tabled(table_law, "speed_rpm,friction_torque_Nmm,front_force_N\n0,1,300\n");
              }),
              HasSubstr("\": the table is for a whole shaft, but this key needs a table for one "
                        "bearing (from a model without [arrangement])"));
  EXPECT_THAT(refusal([] { (void)tabled(table_law, "speed_rpm\n0\n"); }),
              HasSubstr("my.toml:17: file = \"rig/t.csv\": rig/t.csv:1: column "
                        "friction_torque_Nmm is missing"));
}

TEST(ModelWithTable, RefusesEffectsOnTheViscousMoment) {
  for (const std::string id :
       {"film-self-heating", "shear-thinning", "viscous-exponent", "lubricant-viscosity"})
    EXPECT_THAT(refusal([&] { (void)tabled(table_law + "\n[[effect]]\nid = \"" + id + "\"\n"); }),
                HasSubstr("the program does not change the viscous moment of a friction table"))
        << id;
  EXPECT_NO_THROW((void)tabled(table_law + "\n[[effect]]\nid = \"seal-friction\"\n"));
}

TEST(ModelWithTable, ChangesItsLawAndBack) {
  const ModelFile file = tabled(
      "\n[friction]\nf0 = 1.5\nz = 0.001\ny = 0.33\nfile = \"rig/t.csv\"\n"
      "[calibration]\nfree = [\"f0\", \"z\"]\n");
  EXPECT_EQ(file.model.law, FrictionLaw::palmgren);
  EXPECT_EQ(lacks_for_law(file.model, FrictionLaw::table), "");
  const std::string text = with_model(file, with_law(file.model, FrictionLaw::table));
  EXPECT_THAT(text, HasSubstr("law = \"table\""));
  EXPECT_THAT(text, HasSubstr("scale = 1"));
  EXPECT_THAT(text, Not(HasSubstr("f0")));
  EXPECT_THAT(text, HasSubstr("file = \"rig/t.csv\""));
  const ModelFile read = parse_model(text, "my.toml", file.files);
  EXPECT_EQ(read.model.law, FrictionLaw::table);
  EXPECT_THAT(read.model.free, testing::ElementsAre("scale"));
  const ModelFile back =
      parse_model(with_model(read, with_law(read.model, FrictionLaw::skf)), "my.toml", file.files);
  EXPECT_EQ(back.model.law, FrictionLaw::skf);
  EXPECT_TRUE(back.model.table != nullptr);
  model::Model without = back.model;
  without.table = nullptr;
  EXPECT_EQ(lacks_for_law(without, FrictionLaw::table), "file under [friction]");
}

TEST(ModelWithTable, NamesItsFileFromWhereItIsWritten) {
  const ModelFile file = tabled(table_law);
  EXPECT_THAT(with_names_from(file.text, file.files, "/home/new/m.toml"),
              HasSubstr("file = \"../rig/t.csv\"  # of May"));
  EXPECT_THAT(with_names_from(file.text, file.files, ""), HasSubstr("file = \"/home/rig/t.csv\""));
}

}  // namespace
}  // namespace raceway::files

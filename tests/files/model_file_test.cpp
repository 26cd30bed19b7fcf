#include "files/model_file.h"

#include <fmt/format.h>

#include <fstream>
#include <random>
#include <stdexcept>

#include "effects/catalogue.h"
#include "model/parameters.h"
#include "record/units.h"
#include "tests/places.h"
#include "tests/support/message_of.h"
#include "text/input_file.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::StartsWith;

const std::string complete = R"([bearing]
name = "7014"
ball_count = 20
ball_diameter_mm = 11.906
pitch_diameter_mm = 90
contact_angle_deg = 25.0
inner_conformity = 0.52
outer_conformity = 0.53
static_load_rating_N = 43000
ball_material = "my-ball"
ring_material = "steel"

[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8

[friction]
f0 = 1.5
z = 0.001
y = 0.33

[rig]
inertia_kgm2 = 0.8489
bearings = 2
axial_load_N = 0
minimum_speed_rpm = 40

[solver]
race_control = "inner"
tilt = "free"

[material.my-ball]
elastic_modulus_GPa = 300
poisson_ratio = 0.25
density_kg_m3 = 3300
thermal_expansion_1e6_K = 3

[calibration]
free = ["z", "spin-friction.friction_coefficient"]

[[effect]]
id = "spin-friction"
friction_coefficient = 0.06
)";

/// `complete` with one piece of text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = complete;
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::logic_error(from + " is not in the model");
  return text.replace(at, from.size(), to);
}

std::string model_error(const std::string& text) {
  return tests::message_of([&] { (void)parse_model(text, "m.toml"); });
}

TEST(ModelFile, AnAngleInRadAndARatingInKilonewtonsAreAskedAbout) {
  EXPECT_EQ(model_error(changed("contact_angle_deg = 25.0", "contact_angle_deg = 0.4363")),
            "m.toml:6: contact_angle_deg = 0.4363: must be 0, or from 2 to 65 deg; is the value in "
            "rad?");
  EXPECT_EQ(
      model_error(changed("= 43000", "= 43")),
      "m.toml:9: static_load_rating_N = 43: 20 balls of 11.91 mm have a static load rating of "
      "about 39000 N; is the value in kN?");
}

TEST(ModelFile, AWholeNumberThatNoDoubleHoldsIsRefused) {
  for (const char* where : {"f0", "unknown_key", "free"})
    EXPECT_EQ(model_error(fmt::format("[bearing]\nname = \"x\"\n{} = 9007199254740993\n", where)),
              "m.toml:3: 9007199254740993: whole numbers above 9007199254740992 (2^53) may be "
              "inexact; write the number with a decimal point");
  EXPECT_THAT(model_error("[bearing]\nx = [1, -9223372036854775807]\n"),
              StartsWith("m.toml:2: -9223372036854775807: whole numbers above"));
  EXPECT_THAT(model_error("[bearing]\nx = 9007199254740992\n"), HasSubstr("unknown key"));
}

TEST(ModelFile, EveryKeyIsReadInSI) {
  const ModelFile file = parse_model(complete, "m.toml");
  const model::Model& m = file.model;
  const auto& g = m.bearing.geometry();
  EXPECT_EQ(m.name, "7014");
  EXPECT_EQ(g.ball_count, 20);
  EXPECT_DOUBLE_EQ(g.ball_diameter, 11.906e-3);
  EXPECT_DOUBLE_EQ(g.pitch_diameter, 0.09);
  EXPECT_DOUBLE_EQ(g.contact_angle, 25 * degree);
  EXPECT_DOUBLE_EQ(g.outer_conformity, 0.53);
  EXPECT_DOUBLE_EQ(g.static_load_rating, 43000);
  EXPECT_DOUBLE_EQ(m.bearing.balls().elastic_modulus, 300e9);
  EXPECT_DOUBLE_EQ(m.bearing.balls().thermal_expansion, 3e-6);
  EXPECT_EQ(m.bearing.rings().name, "steel");
  EXPECT_NEAR(m.lubricant.kinematic_viscosity(kelvin(40)), 22e-6, 1e-9);
  EXPECT_EQ(m.law, friction::FrictionLaw::palmgren);
  EXPECT_THAT(m.law_values, ElementsAre(1.5, 0.001, 0.33));
  EXPECT_DOUBLE_EQ(m.rig.inertia, 0.8489);
  EXPECT_EQ(m.rig.bearings, 2);
  EXPECT_DOUBLE_EQ(m.rig.axial_load, 0.0);
  EXPECT_DOUBLE_EQ(m.rig.minimum_speed, 40 * rpm);
  EXPECT_EQ(m.solver.race_control, bearing::RaceControl::inner);
  EXPECT_EQ(m.solver.tilt, bearing::Tilt::free);
  EXPECT_THAT(m.free, ElementsAre("z", "spin-friction.friction_coefficient"));
  ASSERT_EQ(m.effects.size(), 1u);
  EXPECT_EQ(m.effects[0].description->id, "spin-friction");
  EXPECT_THAT(m.effects[0].values, ElementsAre(0.06));
  EXPECT_EQ(file.text, complete);
}

TEST(ModelFile, EveryDefaultUsedIsNamed) {
  const ModelFile file = parse_model(
      complete.substr(0, complete.find("[rig]")).replace(complete.find("my-ball"), 7, "steel"),
      "m.toml");
  EXPECT_THAT(
      lines(file.defaults),
      IsSupersetOf({"solver.race_control = \"outer\" (default)",
                    "solver.tilt = \"locked\" (default)", "friction.law = \"palmgren\" (default)",
                    "rig.bearings = 1 (default)", "rig.temperature_C = 40 (default)",
                    "calibration.free = [\"f0\", \"z\"] (default)"}));
  EXPECT_THAT(lines(file.defaults), Contains(StartsWith("bearing.bore_mm = 72.141 (default: ")));
}

TEST(ModelFile, ValuesThatTheFileMarksAsGuessesAreAssumptions) {
  std::string text = changed("f0 = 1.5", "f0 = 1.5  # Assumed by others; estimated: 1 to 2");
  text.replace(text.find("[rig]"), 5, "[rig]   # assumed by the builder");
  const ModelFile file = parse_model(text, "m.toml");
  EXPECT_THAT(lines(file.defaults),
              IsSupersetOf({"friction.f0 = 1.5 (Assumed by others; estimated: 1 to 2)",
                            "rig.bearings = 2 (assumed by the builder)"}));
  EXPECT_THAT(lines(file.defaults), testing::Not(Contains(StartsWith("friction.z"))));
}

TEST(ModelFile, SkfTakesItsPublishedConstantsByDefault) {
  std::string text = changed("f0 = 1.5\nz = 0.001\ny = 0.33", "law = \"skf\"\nmu_bl = 0.12");
  text.replace(text.find("[\"z\""), 4, "[\"mu_bl\"");
  const ModelFile file = parse_model(text, "m.toml");
  EXPECT_EQ(file.model.law, friction::FrictionLaw::skf);
  EXPECT_EQ(file.model.law_values[0], 0.12);
  EXPECT_EQ(file.model.law_values[2], friction::parameters(file.model.law)[2].initial);
  EXPECT_THAT(lines(file.defaults), Contains(StartsWith("friction.K_rs = ")));
}

TEST(ModelFile, MisspeltKeysAreErrorsWithTheNearestName) {
  EXPECT_EQ(model_error(changed("ball_count", "ball_cuont")),
            "m.toml:3: ball_cuont = 20: unknown key in [bearing]; did you mean ball_count?");
  EXPECT_THAT(model_error(changed("[lubricant]", "[lubricants]")),
              StartsWith("m.toml:13: [lubricants]: unknown table; did you mean lubricant?"));
  EXPECT_THAT(model_error(changed("tilt = \"free\"", "tilt = \"fre\"")),
              StartsWith("m.toml:30: tilt = \"fre\": must be locked or free; did you mean free?"));
  EXPECT_THAT(model_error(changed("id = \"spin-friction\"", "id = \"spin-fricton\"")),
              HasSubstr("unknown effect; did you mean spin-friction?"));
  EXPECT_THAT(model_error(changed("free = [\"z\"", "free = [\"zz\"")),
              HasSubstr("no such parameter"));
  EXPECT_THAT(model_error(changed("\"my-ball\"\nring", "\"my-bal\"\nring")),
              HasSubstr("did you mean my-ball?"));
}

TEST(ModelFile, MissingKeysAndTablesAreNamedWithTheirRange) {
  EXPECT_EQ(model_error(changed("pitch_diameter_mm = 90\n", "")),
            "m.toml:1: [bearing] pitch_diameter_mm is missing: must be from 1 to 5000 mm");
  EXPECT_THAT(model_error(changed("ball_count = 20\n", "")),
              StartsWith("m.toml:1: [bearing] ball_count is missing"));
  EXPECT_THAT(model_error(changed("f0 = 1.5\n", "")),
              StartsWith("m.toml:17: [friction] f0 is missing: must be from"));
  EXPECT_THAT(model_error(changed("static_load_rating_N = 43000\n", "")),
              HasSubstr("static_load_rating_N is missing, which the friction law palmgren needs"));
  EXPECT_THAT(model_error("[lubricant]\nviscosity_40C_mm2_s = 22\nviscosity_100C_mm2_s = 5\n"),
              StartsWith("m.toml: table [bearing] is missing"));
  EXPECT_THAT(model_error(changed("density_kg_m3 = 3300\n", "")),
              HasSubstr("[material.my-ball] density_kg_m3 is missing"));
}

TEST(ModelFile, AllMissingKeysAreInOneMessage) {
  const std::string error = model_error("[bearing]\nball_count = 20\ncontact_angle_deg = 15\n");
  EXPECT_THAT(error, StartsWith("m.toml:1: [bearing] ball_diameter_mm is missing"));
  EXPECT_THAT(error, HasSubstr("In total, 10 keys are missing"));
  for (const char* line :
       {"[bearing] ball_diameter_mm: must be from 0.1 to 300 mm", "[bearing] static_load_rating_N",
        "[lubricant] viscosity_100C_mm2_s", "[friction] f0: must be from 0.01 to 30"})
    EXPECT_THAT(error, HasSubstr(line));
}

TEST(ModelFile, WrongTypesAreErrors) {
  EXPECT_EQ(
      model_error(changed("= 11.906", "= \"11.906\"")),
      "m.toml:4: ball_diameter_mm = \"11.906\": must be a number, not a text; must be from 0.1 "
      "to 300 mm");
  EXPECT_THAT(model_error(changed("= 20", "= 20.5")),
              StartsWith("m.toml:3: ball_count = 20.5: must be a whole number"));
  EXPECT_THAT(model_error(changed("ring_material = \"steel\"", "ring_material = 3")),
              HasSubstr("must be a text in quotes, not a number"));
  EXPECT_THAT(model_error(changed("[solver]", "[[solver]]")), HasSubstr("must be a table"));
  EXPECT_THAT(model_error(changed("[[effect]]", "[effect]")),
              HasSubstr("[[effect]] with two brackets"));
}

TEST(ModelFile, WholeNumbersServeAsNumbersAndTheOtherWayRound) {
  EXPECT_EQ(parse_model(changed("= 20", "= 20.0"), "m.toml").model.bearing.geometry().ball_count,
            20);
}

TEST(ModelFile, ImpossibleValuesNameKeyValueAndRange) {
  EXPECT_EQ(model_error(changed("= 11.906", "= -12")),
            "m.toml:4: ball_diameter_mm = -12 mm: must be from 0.1 to 300 mm");
  EXPECT_EQ(model_error(changed("= 11.906", "= nan")),
            "m.toml:4: ball_diameter_mm = nan mm: must be from 0.1 to 300 mm");
  EXPECT_EQ(model_error(changed("inner_conformity = 0.52", "inner_conformity = 0.5")),
            "m.toml:7: inner_conformity = 0.5: must be from 0.5005 to 0.7");
  EXPECT_EQ(model_error(changed("= 20", "= 0")), "m.toml:3: ball_count = 0: must be from 3 to 200");
  EXPECT_EQ(
      model_error(changed("= 20", "= 30")),
      "m.toml:3: ball_count = 30: at most 23 balls of 11.906 mm fit on a pitch circle of 90 mm");
  EXPECT_THAT(model_error(changed("z = 0.001", "z = -1")),
              StartsWith("m.toml:19: z = -1: must be from"));
  EXPECT_THAT(model_error(changed("= 4.8", "= 48")),
              StartsWith("m.toml:15: viscosity_100C_mm2_s = 48 mm2/s: must be below"));
  EXPECT_THAT(model_error(changed("friction_coefficient = 0.06", "friction_coefficient = inf")),
              HasSubstr("friction_coefficient = inf: must be from"));
  EXPECT_THAT(model_error(changed("inertia_kgm2 = 0.8489", "inertia_kgm2 = 0")),
              HasSubstr("inertia_kgm2 = 0 kg m2: must be from"));
}

TEST(ModelFile, TextThatIsNoTomlIsErrorWithLineAndColumn) {
  EXPECT_THAT(model_error("[bearing]\nball_count = = 3\n"), StartsWith("m.toml:2:14: "));
  EXPECT_THAT(model_error("[bearing]\nball_count = 3\nball_count = 4\n"), StartsWith("m.toml:3:"));
  EXPECT_THAT(model_error("ball_count = 3\n"),
              HasSubstr(": the key is not in a table; move it below [bearing] or another table"));
  // toml++ 3.3 asserts on this text.
  EXPECT_THAT(model_error("[a]\n[ = 1.5\nc = 2\n"), StartsWith("m.toml:2:"));
}

TEST(ModelFile, FactorsOfTheOtherLawAreRefused) {
  EXPECT_EQ(
      model_error(changed("y = 0.33", "y = 0.33\nmu_bl = 0.1")),
      "m.toml:21: mu_bl = 0.1: this key is only for law = \"skf\", but the law is \"palmgren\"");
}

TEST(ModelFile, TheLoadOfTheFactorIsP0UnlessTheFileSaysOtherwise) {
  const ModelFile file = parse_model(complete, "m.toml");
  EXPECT_EQ(file.model.f1_load, friction::F1Load::P0);
  EXPECT_THAT(lines(file.defaults), Contains("friction.f1_load = \"P0\" (default)"));
  const auto with = [](const std::string& value) {
    return changed("y = 0.33", "y = 0.33\nf1_load = " + value);
  };
  const ModelFile said = parse_model(with("\"F_b\""), "m.toml");
  EXPECT_EQ(said.model.f1_load, friction::F1Load::F_b);
  EXPECT_THAT(lines(said.defaults), testing::Not(Contains(StartsWith("friction.f1_load"))));
  EXPECT_EQ(parse_model(with("\"P0\""), "m.toml").model.f1_load, friction::F1Load::P0);
  EXPECT_EQ(model_error(with("\"F_a\"")),
            "m.toml:21: f1_load = \"F_a\": must be P0 or F_b; did you mean F_b?");
  EXPECT_EQ(model_error(with("1")),
            "m.toml:21: f1_load = 1: must be a text in quotes, not a number");
  EXPECT_EQ(model_error(changed("y = 0.33", "y = 0.33\nf1_laod = \"P0\"")),
            "m.toml:21: f1_laod = \"P0\": unknown key in [friction]; did you mean f1_load?");
  std::string skf = changed("f0 = 1.5\nz = 0.001\ny = 0.33", "law = \"skf\"\nf1_load = \"F_b\"");
  skf.replace(skf.find("[\"z\""), 4, "[\"mu_bl\"");
  EXPECT_EQ(model_error(skf),
            "m.toml:19: f1_load = \"F_b\": this key is only for law = \"palmgren\", \"powers\" or "
            "\"contact-powers\", but the law is \"skf\"");
  skf.erase(skf.find("f1_load = \"F_b\"\n"), 16);
  EXPECT_THAT(lines(parse_model(skf, "m.toml").defaults),
              testing::Not(Contains(StartsWith("friction.f1_load"))));
}

TEST(ModelFile, TheSupplyIsReadAndMayBeAbsent) {
  const std::string oil = "viscosity_100C_mm2_s = 4.8\n";
  const auto with = [&](const std::string& value) {
    return changed(oil, oil + "supply = " + value + "\n");
  };
  const ModelFile silent = parse_model(complete, "m.toml");
  EXPECT_EQ(silent.model.supply, std::nullopt);
  EXPECT_THAT(lines(silent.defaults), testing::Not(Contains(HasSubstr("supply"))));
  EXPECT_EQ(parse_model(with("\"oil-air\""), "m.toml").model.supply, friction::Supply::oil_air);
  EXPECT_EQ(parse_model(with("\"grease\""), "m.toml").model.supply, friction::Supply::grease);
  EXPECT_EQ(parse_model(with("\"jet\""), "m.toml").model.supply, friction::Supply::jet);
  EXPECT_EQ(parse_model(with("\"bath\""), "m.toml").model.supply, friction::Supply::bath);
  EXPECT_THAT(model_error(with("\"oil_air\"")),
              HasSubstr("supply = \"oil_air\": must be oil-air, grease, jet or bath; did you mean "
                        "oil-air?"));
  EXPECT_THAT(model_error(changed(oil, oil + "suply = \"jet\"\n")),
              HasSubstr("unknown key in [lubricant]; did you mean supply?"));
}

TEST(ModelFile, AnEffectThatTheSupplyRulesOutIsNotedAndStaysOn) {
  const std::string oil = "viscosity_100C_mm2_s = 4.8\n";
  const std::string churning = "\n[[effect]]\nid = \"churning\"\n";
  EXPECT_THAT(texts(parse_model(complete + churning, "m.toml").notes), testing::IsEmpty());
  const ModelFile file =
      parse_model(changed(oil, oil + "supply = \"oil-air\"\n") + churning, "m.toml");
  EXPECT_THAT(texts(file.notes),
              ElementsAre("effect churning: the bearing is lubricated by oil-air, but this effect "
                          "needs an oil bath; the model uses the effect nevertheless"));
  EXPECT_EQ(file.model.effects.size(), 2u);
}

TEST(ModelFile, EffectsAreCheckedLikeTheRest) {
  EXPECT_THAT(model_error(complete + "[[effect]]\nid = \"spin-friction\"\n"),
              HasSubstr("two tables have this effect"));
  EXPECT_THAT(model_error(complete + "[[effect]]\n"), HasSubstr("[[effect]] id is missing"));
  EXPECT_THAT(model_error(complete + "[[effect]]\nid = \"lubricant-drag\"\ntorque_Nmm = \"1\"\n"),
              HasSubstr("is the id of an effect in the catalogue; give your effect another id"));
  const ModelFile file = parse_model(changed("friction_coefficient = 0.06\n", ""), "m.toml");
  EXPECT_THAT(lines(file.defaults), Contains(StartsWith("effect[0].friction_coefficient = ")));
}

TEST(ModelFile, AnInertiaMayBeUnknownIfThatIsSaid) {
  const model::Rig rig =
      parse_model(changed("inertia_kgm2 = 0.8489", "inertia_kgm2 = \"unknown\""), "m.toml")
          .model.rig;
  EXPECT_TRUE(rig.unknown_inertia && rig.coasts_down());
  EXPECT_TRUE(std::isnan(rig.inertia));
  EXPECT_THAT(model_error(changed("inertia_kgm2 = 0.8489", "inertia_kgm2 = \"none\"")),
              HasSubstr("inertia_kgm2 = \"none\": must be from 1e-09 to 1000000 kg m2, or "
                        "\"unknown\""));
  EXPECT_THAT(model_error(changed("inertia_kgm2 = 0.8489", "inertia_kgm2 = true")),
              HasSubstr("inertia_kgm2 = true: must be a number, not true or false"));
}

const std::string windage = R"([[effect]]
id = "my-windage"
torque_Nmm = "c * (speed_rpm/1000)^2"
c = { value = 0.5, unit = "N mm", lower = 0.0 }
)";

TEST(ModelFile, AnEffectMayBeAFormula) {
  const model::Model m = parse_model(complete + windage, "m.toml").model;
  ASSERT_EQ(m.effects.size(), 2u);
  const effects::Description& d = *m.effects[1].description;
  EXPECT_EQ(d.id, "my-windage");
  EXPECT_EQ(d.formula, "c * (speed_rpm/1000)^2");
  ASSERT_EQ(d.parameters.size(), 1u);
  EXPECT_EQ(d.parameters[0].unit, "N mm");
  EXPECT_EQ(d.parameters[0].lower, 0.0);
  EXPECT_EQ(d.parameters[0].upper, std::numeric_limits<double>::infinity());
  EXPECT_THAT(m.effects[1].values, ElementsAre(0.5));
  const auto free =
      parse_model(changed("free = [\"z\"", "free = [\"my-windage.c\"") + windage, "m.toml");
  EXPECT_THAT(free.model.free, Contains("my-windage.c"));
}

TEST(ModelFile, AWrongFormulaIsShownWithItsPlace) {
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = windage;
    return model_error(complete + text.replace(text.find(from), from.size(), to));
  };
  const std::string unknown = with("speed_rpm", "spede_rpm");
  EXPECT_THAT(unknown,
              HasSubstr("m.toml:46:20: effect my-windage: torque_Nmm: \"spede_rpm\" is not "
                        "known; did you mean speed_rpm?"));
  EXPECT_THAT(unknown, HasSubstr("\n  c * (spede_rpm/1000)^2\n       ^"));
  EXPECT_THAT(with("1000)", "1000"), HasSubstr("m.toml:46:"));
  EXPECT_THAT(with("\"c * ", "\"k * "), HasSubstr("\"k\" is not known"));
  EXPECT_THAT(with("lower = 0.0", "lower = 1.0"), HasSubstr("value = 0.5 N mm: must be from 1"));
  EXPECT_THAT(with("value = 0.5, ", ""), HasSubstr("value is missing"));
  EXPECT_THAT(with("unit", "units"), HasSubstr("unknown key"));
  EXPECT_THAT(with("\nc =", "\nspeed_rpm ="), HasSubstr("a variable of formulas has this name"));
}

TEST(ModelFile, AnEffectsParameterMayBeFreeByItsNameAlone) {
  const auto file = parse_model(changed("spin-friction.friction", "friction"), "m.toml");
  EXPECT_THAT(file.model.free, ElementsAre("z", "spin-friction.friction_coefficient"));
}

TEST(ModelFile, ToleranceOfWhatIsPredictedIsReadInSI) {
  const auto with = [](const std::string& loop, const std::string& further = "") {
    return complete + "\n[loop]\n" + loop + "\n" + further;
  };
  const std::string sets = "[arrangement]\nlayout = \"O\"\nfront = 1\nrear = 1\npreload_N = 600\n";
  EXPECT_TRUE(parse_model(complete, "m.toml").model.tolerances.empty());
  const auto torque = parse_model(with("tolerance_Nmm = 2.5"), "m.toml").model.tolerances;
  ASSERT_EQ(torque.size(), 1u);
  EXPECT_EQ(torque[0].name, "friction_torque_Nmm");
  EXPECT_DOUBLE_EQ(torque[0].value, 2.5e-3);
  const auto position = parse_model(with("tolerance_um = 1", sets), "m.toml").model.tolerances;
  ASSERT_EQ(position.size(), 1u);
  EXPECT_EQ(position[0].name, "axial_displacement_um");
  EXPECT_DOUBLE_EQ(position[0].value, 1e-6);
  EXPECT_EQ(
      model_error(with("tolerance_um = 1")),
      "m.toml:46: tolerance_um = 1: this model predicts friction torque, but no quantity in um");
  EXPECT_EQ(model_error(with("tolerance_K = 0.5", sets)),
            "m.toml:46: tolerance_K = 0.5: this model predicts axial displacement and friction "
            "torque, but no quantity in K");
  EXPECT_EQ(model_error(with("tolerance_Nmm = 0")),
            "m.toml:46: tolerance_Nmm = 0 Nmm: must be above 0");
  EXPECT_THAT(model_error(with("tolerance_Nmm = -1")),
              HasSubstr("must be from 0 to 1000000000 Nmm"));
  EXPECT_THAT(model_error(with("tolerance_Nmm = 2e9")),
              HasSubstr("must be from 0 to 1000000000 Nmm"));
  EXPECT_THAT(model_error(with("tolerance_nmm = 2")), HasSubstr("did you mean tolerance_Nmm?"));
}

TEST(ModelFile, MutilatedModelsAreErrorsAndNothingElse) {
  std::mt19937 random(20);
  const std::string letters = "\n\r\"'[]{}.,=#0159e-_ \xc3\xbc";
  for (int i = 0; i < 3000; ++i) {
    std::string text = complete;
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = random() % text.size();
      const char letter = letters[random() % letters.size()];
      if (k == 0) text[at] = letter;
      if (k == 1) text.erase(at, 1 + random() % 5);
      if (k == 2) text.insert(at, 1, letter);
    }
    try {
      const ModelFile file = parse_model(text, "m.toml");
      const std::vector<KeyValue> change{{"friction.f0", 2.5}};
      EXPECT_EQ(parse_model(with_values(file.text, change), "m.toml").model.law_values[0], 2.5);
    } catch (const text::InputError& error) {
      EXPECT_THAT(error.what(), StartsWith("m.toml:"));
    }
  }
}

const std::string from_catalogue = R"([bearing]
catalogue = "GMN S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
)";

TEST(ModelFile, ACatalogueBearingNeedsNoMoreThanItsName) {
  const ModelFile file = parse_model(from_catalogue, "m.toml");
  const auto row = find_bearing(read_catalogues(), "S 6014 C");
  EXPECT_EQ(file.model.name, row.full_name());
  EXPECT_EQ(file.model.bearing.geometry().ball_count, row.geometry.ball_count);
  EXPECT_EQ(file.model.bearing.geometry().bore, row.geometry.bore);
  EXPECT_THAT(file.model.law_values, ElementsAre(1.5, 0.001, 0.33));
  EXPECT_THAT(lines(file.defaults), IsSupersetOf({"bearing.inner_conformity = 0.52 (default)",
                                                  "friction.f0 = 1.5 (default)"}));
}

TEST(ModelFile, OtherKeysOverrideTheCatalogue) {
  std::string text = from_catalogue;
  text.insert(text.find("[lubricant]"), "ball_count = 19\nouter_conformity = 0.53\n");
  const auto g = parse_model(text, "m.toml").model.bearing.geometry();
  EXPECT_EQ(g.ball_count, 19);
  EXPECT_DOUBLE_EQ(g.outer_conformity, 0.53);
  text.replace(text.find("= 19"), 4, "= 90");
  EXPECT_THAT(model_error(text), StartsWith("m.toml:3: ball_count = 90: at most"));
}

TEST(ModelFile, UnknownCatalogueBearingsAreAnsweredWithTheNearest) {
  std::string text = from_catalogue;
  text.replace(text.find("6014"), 4, "6O14");
  EXPECT_THAT(model_error(text), StartsWith("m.toml:2: bearing \"GMN S 6O14 C\" is not in the "
                                            "catalogue; similar designations: GMN S 6014 C TA"));
}

TEST(ModelFile, ANewModelReadsBackWithoutDefaultsExceptCommentedOnes) {
  for (const auto& row : read_catalogues()) {
    const ModelFile file = parse_model(new_model_text(row), "new.toml");
    for (const UsedDefault& one : file.defaults)
      EXPECT_EQ(one.origin, UsedDefault::Origin::marked) << row.full_name() << ": " << one.line();
    EXPECT_EQ(file.model.name, row.full_name());
    EXPECT_DOUBLE_EQ(file.model.bearing.geometry().ball_diameter, row.geometry.ball_diameter);
  }
}

TEST(ModelFile, ANewModelOfEachLawSaysWhatItTakes) {
  const auto row = read_catalogues().front();
  for (const auto law : {friction::FrictionLaw::palmgren, friction::FrictionLaw::skf,
                         friction::FrictionLaw::contact}) {
    const ModelFile file = parse_model(new_model_text(row, law), "new.toml");
    EXPECT_EQ(file.model.law, law);
    EXPECT_EQ(file.model.free, model::default_free(law));
    // Of the contact law what follows from the type of the oil stands there as remarks.
    EXPECT_EQ(std::count_if(
                  file.defaults.begin(), file.defaults.end(),
                  [](const UsedDefault& one) { return one.origin != UsedDefault::Origin::marked; }),
              law == friction::FrictionLaw::contact ? 5 : 0);
  }
}

TEST(ModelFile, TheFlywheelModelIsRead) {
  const ModelFile file = read_model(tests::source_dir() + "/data/measurements/flywheel.toml");
  EXPECT_GT(file.model.rig.inertia, 0.0);
}

std::string edited(const std::string& text, std::vector<KeyValue> changes) {
  return with_values(text, changes);
}

TEST(ModelEdit, OnlyTheValueChanges) {
  const std::string text =
      "# ü\n[friction]   # Reibung: µ\nf0   =  1_500.25e-3\t# viscous\nz=1 # load\n";
  EXPECT_EQ(edited(text, {{"friction.f0", 2.25}, {"friction.z", 0.0005}}),
            "# ü\n[friction]   # Reibung: µ\nf0   =  2.25\t# viscous\nz=0.0005 # load\n");
}

TEST(ModelEdit, ACommentReplacesTheOneBehindTheValue) {
  EXPECT_EQ(edited("[friction]\nf0 = 1     # guessed # twice\nz = 2\n",
                   {{"friction.f0", 1.5, "fitted"}, {"friction.z", 3, "too"}}),
            "[friction]\nf0 = 1.5     # fitted\nz = 3.0  # too\n");
  EXPECT_EQ(edited("[friction]\r\nf0 = 1\r\n", {{"friction.z", 0.5, "new"}}),
            "[friction]\r\nf0 = 1\r\nz = 0.5  # new\r\n");
  EXPECT_EQ(edited("friction = { f0 = 1 } # a\n", {{"friction.f0", 2, "not here"}}),
            "friction = { f0 = 2.0 } # a\n");
}

TEST(ModelEdit, ColumnsAreCodePointsNotBytes) {
  const std::string text = "friction = { \"Größe 😀\" = \"€\", f0 = 1.5, z = 2 } # ü\n";
  EXPECT_EQ(edited(text, {{"friction.f0", 3}}),
            "friction = { \"Größe 😀\" = \"€\", f0 = 3.0, z = 2 } # ü\n");
}

TEST(ModelEdit, AByteOrderMarkAndCarriageReturnsStay) {
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_EQ(edited(mark + "friction.f0 = 1 # a\r\n", {{"friction.f0", 2}}),
            mark + "friction.f0 = 2.0 # a\r\n");
  EXPECT_EQ(edited("[friction]\r\nf0 = 1\r\n", {{"friction.z", 0.5}}),
            "[friction]\r\nf0 = 1\r\nz = 0.5\r\n");
  const std::string path = testing::TempDir() + "marked.toml";
  std::ofstream(path, std::ios::binary) << mark << complete;
  EXPECT_EQ(read_model(path).text, mark + complete);
}

TEST(ModelEdit, AKeyLeftToItsDefaultIsAddedToItsTable) {
  EXPECT_EQ(edited("[friction]\n  f0 = 1 # a\n\n[rig]\n", {{"friction.z", 0.5}}),
            "[friction]\n  f0 = 1 # a\n  z = 0.5\n\n[rig]\n");
  EXPECT_EQ(edited("[friction]\n[rig]\nbearings = 1\n", {{"friction.z", 0.5}}),
            "[friction]\nz = 0.5\n[rig]\nbearings = 1\n");
  EXPECT_EQ(edited("[friction]", {{"friction.z", 0.5}}), "[friction]\nz = 0.5\n");
  EXPECT_EQ(edited("friction.f0 = 1\n", {{"friction.z", 0.5}}),
            "friction.f0 = 1\nfriction.z = 0.5\n");
  EXPECT_EQ(edited("friction = { f0 = 1 }\n", {{"friction.z", 0.5}}),
            "friction = { f0 = 1, z = 0.5 }\n");
  EXPECT_EQ(edited("friction = {}\n", {{"friction.z", 0.5}}), "friction = { z = 0.5 }\n");
  EXPECT_EQ(edited("[rig]\nbearings = 1\n", {{"friction.f0", 2}, {"friction.z", 0.5}}),
            "[rig]\nbearings = 1\n\n[friction]\nf0 = 2.0\nz = 0.5\n");
}

TEST(ModelEdit, EffectsAreEditedByTheirPlace) {
  const std::string text = "[[effect]]\nid = \"a\"\nx = 1\n[[effect]]\nid = \"b\" # second\n";
  EXPECT_EQ(edited(text, {{"effect.0.x", 0.25}, {"effect.1.y", 1e-9}}),
            "[[effect]]\nid = \"a\"\nx = 0.25\n[[effect]]\nid = \"b\" # second\ny = 1e-09\n");
  EXPECT_THAT(tests::message_of([&] {
                (void)edited(text, {{"effect.2.x", 1}});
              }),
              HasSubstr(": the model has no table of this name"));
}

TEST(ModelEdit, EveryValueReadsBackExactly) {
  for (const double value :
       {0.1, 1.0 / 3.0, -2.0, 1e22, 1.7976931348623157e308, 5e-324, 123456789.0}) {
    const std::string text = edited(complete, {{"friction.f0", value}});
    EXPECT_EQ(edited(text, {{"friction.f0", 1.5}}), complete);
  }
  EXPECT_THROW((void)edited(complete, {{"friction.f0", unset}}), std::invalid_argument);
}

TEST(ModelEdit, TheEditedModelHoldsTheNewValues) {
  const std::string text =
      edited(complete, {{"friction.f0", 2.125}, {"effect.0.friction_coefficient", 0.0625}});
  const model::Model m = parse_model(text, "m.toml").model;
  EXPECT_EQ(m.law_values[0], 2.125);
  EXPECT_EQ(m.effects[0].values[0], 0.0625);
}

TEST(ModelEdit, TheValueOfAFormulasParameterIsEditedInItsTable) {
  const std::string text = edited(complete + windage, {{"effect.1.c", 0.75}});
  EXPECT_THAT(text, HasSubstr("c = { value = 0.75, unit = \"N mm\", lower = 0.0 }"));
}

TEST(ModelEdit, AnAddedEffectReadsBackAsItIs) {
  std::string text = complete;
  effects::Effect drag;
  drag.description = effects::find("seal-friction");
  drag.values = {1.0 / 3.0, 0.005};
  text = with_effect(text, drag);
  text = with_effect(text, parse_model(complete + windage, "m.toml").model.effects[1]);
  EXPECT_TRUE(text.starts_with(complete));
  const model::Model m = parse_model(text, "m.toml").model;
  ASSERT_EQ(m.effects.size(), 3u);
  EXPECT_EQ(m.effects[1].description, drag.description);
  EXPECT_EQ(m.effects[1].values, drag.values);
  EXPECT_EQ(m.effects[2].description->formula, "c * (speed_rpm/1000)^2");
  EXPECT_EQ(m.effects[2].description->parameters[0].lower, 0.0);
}

TEST(ModelEdit, EveryEffectOfTheCatalogueReadsBack) {
  // torque-offset has a parameter torque_Nmm, which elsewhere is the formula of a user's effect.
  const std::string bearing = complete.substr(0, complete.find("[calibration]"));
  const std::string rig =
      std::string(bearing).replace(bearing.find("[rig]"), 5, "[rig]\nroom_temperature_C = 20");
  const std::string shaft =
      rig + "\n[arrangement]\nlayout = \"O\"\nfront = 2\nrear = 1\npreload_N = 600\n";
  for (const effects::Form form : {effects::Form::rig, effects::Form::shaft})
    for (const effects::Description& d : effects::catalogue(form)) {
      SCOPED_TRACE(d.id);
      const bool on_shaft = form == effects::Form::shaft;
      const effects::Effect effect{.description = &d, .values = effects::initial_values(d)};
      const std::string text = with_effect(on_shaft ? shaft : rig, effect);
      if (!d.belongs_to(form)) {
        EXPECT_THAT(
            model_error(text),
            HasSubstr(
                d.of_spindles_alone() ? "but this model has no [shaft] and [housing]"
                : on_shaft
                    ? "the effect acts on a bearing on a rig, but this model has an [arrangement]"
                    : "but this model has no [arrangement]"));
        continue;
      }
      const model::Model m = parse_model(text, "m.toml").model;
      ASSERT_EQ(m.effects.size(), 1u);
      EXPECT_EQ(m.effects[0].description, &d);
      EXPECT_EQ(m.effects[0].values, effect.values);
    }
}

TEST(ModelEdit, WrongDataIsPutRight) {
  ModelFile file = parse_model(complete.substr(0, complete.find("[calibration]")), "m.toml");
  file.model.rig.room_temperature = unset;
  model::Model found = file.model;
  const double at_40 = found.lubricant.viscosity_40C(), at_100 = found.lubricant.viscosity_100C();
  found.effects = {{.description = effects::find("viscosity-slope"), .values = {0.9}},
                   {.description = effects::find("temperature-gain"), .values = {0.6}}};
  found.rig.room_temperature = kelvin(23.5);
  const std::string text = with_model(file, found);
  // The oil card has the corrected number; the sensor is corrected by an effect with its room.
  const model::Model m = parse_model(text, "m.toml").model;
  EXPECT_DOUBLE_EQ(m.lubricant.viscosity_40C(), at_40);
  EXPECT_NEAR(m.lubricant.viscosity_100C(), 0.9 * at_100, 1e-14 * at_100);
  EXPECT_THAT(text, HasSubstr("entered value"));
  ASSERT_EQ(m.effects.size(), 1u);
  EXPECT_EQ(m.effects[0].description->id, "temperature-gain");
  EXPECT_NEAR(m.rig.room_temperature, kelvin(23.5), 1e-10);
}

TEST(ModelEdit, ASensorThatSeesAShareNeedsTheRoom) {
  const std::string bearing = complete.substr(0, complete.find("[calibration]"));
  const effects::Effect gain{.description = effects::find("temperature-gain"), .values = {0.6}};
  EXPECT_THAT(model_error(with_effect(bearing, gain)), HasSubstr("room_temperature_C"));
}

}  // namespace
}  // namespace raceway::files

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/friction_contact/contact_cases.h"

namespace raceway::tests {
namespace {

using friction::contact::contact_cases;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

/// A case of data/reference/contact_reference.json as the file that its user would write.
std::string model_of(const json& inputs, const std::string& balls) {
  const json& g = inputs.at("geometry");
  const auto number = [](double v) { return fmt::format("{:.12g}", v); };
  std::string text = "[bearing]\nball_material = \"" + balls + "\"\n";
  text += "ball_count = " + std::to_string(g.at("Z").get<int>()) + "\n";
  text += "ball_diameter_mm = " + number(1e3 * g.at("D").get<double>()) + "\n";
  text += "pitch_diameter_mm = " + number(1e3 * g.at("dm").get<double>()) + "\n";
  text += "contact_angle_deg = " + number(g.at("alpha0").get<double>()) + "\n";
  text += "inner_conformity = " + number(g.at("fi").get<double>()) + "\n";
  text += "outer_conformity = " + number(g.at("fo").get<double>()) + "\n";
  text += "\n[lubricant]\nviscosity_40C_mm2_s = " + number(inputs.at("nu40").get<double>());
  text += "\nviscosity_100C_mm2_s = " + number(inputs.at("nu100").get<double>()) + "\n";
  if (inputs.value("supply", "limited") == "flooded") text += "supply = \"bath\"\n";
  return text +
         "\n[friction]\nlaw = \"contact\"\nmu_boundary = " + number(inputs.value("mu_b", 0.1)) +
         "\n";
}

std::string flags_of(const json& inputs, double rpm) {
  return fmt::format("--speed {} --axial-load {} --radial-load {} --temperature {} --json", rpm,
                     inputs.at("Fa").get<double>(), inputs.value("Fr", 0.0),
                     inputs.at("T_C").get<double>());
}

class ContactLaw : public testing::Test {
 protected:
  [[nodiscard]] json solved(const std::string& model, const std::string& flags) const {
    return parsed(run("solve " + scratch_.write("my.toml", model) + " " + flags));
  }
  ScratchFolder scratch_;
};

void expect_near(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_LE(std::abs(value - expected), tolerance * std::abs(expected))
      << what << ": " << value << " against " << expected;
}

/// A part is held to 1 % above 1 N mm, and to 0.01 N mm below.
void expect_part(double value, double expected, const std::string& what) {
  EXPECT_NEAR(value, expected, 0.01 * std::max(std::abs(expected), 1.0)) << what;
}

/// What is said of one ball against what an independent program says of it.
void expect_contacts(const json& ball, const json& expected, const std::string& where) {
  for (const std::string race : {"inner", "outer"}) {
    const json& c = ball.at(race);
    const std::string at = where + " " + race;
    expect_near(c.at("film_um").at("minimum"), expected.at("h_min_" + race + "_um"), 1e-4, at);
    expect_near(c.at("lambda"), expected.at("lambda_" + race), 1e-4, at);
    expect_near(c.at("pressure_GPa"), expected.at("p_max_" + race + "_GPa"), 1e-5, at);
    expect_near(ball.at(race + "_load_N"), expected.at("Q_" + race), 1e-5, at);
    expect_near(ball.at(race + "_contact_angle_deg"), expected.at("angle_" + race + "_deg"), 1e-5,
                at);
  }
  const json& inner = ball.at("inner");
  expect_near(inner.at("spin_rad_s"), expected.at("spin_inner_rad_s"), 1e-4, where + " spin");
  expect_near(inner.at("mu_mean"), expected.at("mu_mean_inner"), 0.01, where + " mu");
  expect_near(inner.at("slip_m_s"), expected.at("slip_mean_inner_m_s"), 0.01, where + " slip");
}

TEST_F(ContactLaw, SaysOfABearingWhatAnIndependentProgramSays) {
  for (const json& c : contact_cases("bearing_")) {
    if (!c.at("outputs").contains("steel")) continue;
    for (const auto& [balls, expected] : c.at("outputs").items()) {
      if (!expected.is_object()) continue;
      const std::string where = c.at("id").get<std::string>() + " " + balls;
      const json& in = c.at("inputs");
      const json d = solved(model_of(in, balls == "steel" ? "steel" : "silicon-nitride"),
                            flags_of(in, in.at("rpm").get<double>()));
      expect_near(d.at("friction_torque_Nmm"), expected.at("torque_Nmm"), 0.005, where);
      for (const std::string part : {"sliding", "rolling", "hysteresis"})
        expect_part(d.at("friction").at(part + "_Nmm"),
                    expected.at(part + "_inner_Nmm").get<double>() +
                        expected.at(part + "_outer_Nmm").get<double>(),
                    where + " " + part);
      for (const std::string ring : {"inner", "outer"})
        expect_near(d.at(ring + "_ring_heat_W"), expected.at("heat_" + ring + "_W"), 0.01, where);
      const double heat =
          d.at("inner_ring_heat_W").get<double>() + d.at("outer_ring_heat_W").get<double>();
      expect_near(heat, d.at("power_loss_W"), 1e-9, where + " heat of the rings");
      expect_near(d.at("kappa"), expected.at("kappa"), 1e-6, where + " kappa");
      expect_near(d.at("holding_coefficient"), expected.at("holding_coefficient"), 1e-3, where);
      expect_contacts(d.at("balls").at(0), expected, where);
    }
  }
}

TEST_F(ContactLaw, TurnsBallsThatNoRaceHoldsAsTheIndependentProgramDoes) {
  for (const json& c : contact_cases("balanced_")) {
    const json &in = c.at("inputs"), &expected = c.at("outputs");
    const std::string where = c.at("id");
    const std::string model = model_of(in, in.at("ball") == "steel" ? "steel" : "silicon-nitride") +
                              "[solver]\nrace_control = \"balanced\"\n";
    const json d = solved(model, flags_of(in, in.at("rpm").get<double>()));
    EXPECT_EQ(d.at("race_control"), "balanced");
    EXPECT_NEAR(d.at("axial_displacement_um"), expected.at("displacement_um"), 0.01) << where;
    expect_near(d.at("friction_torque_Nmm"), expected.at("torque_Nmm"), 0.005, where);
    expect_part(d.at("friction").at("sliding_Nmm"), expected.at("sliding_Nmm"), where + " sliding");
    expect_near(d.at("cage_speed_rpm"),
                expected.at("cage_ratio").get<double>() * in.at("rpm").get<double>(), 1e-4,
                where + " cage");
    const json& ball = d.at("balls").at(0);
    expect_near(ball.at("pitch_angle_deg"), expected.at("beta_deg"), 5e-3, where + " pitch");
    for (const std::string race : {"inner", "outer"}) {
      expect_near(ball.at(race + "_load_N"), expected.at("Q_" + race), 1e-4, where + race);
      expect_near(ball.at(race + "_contact_angle_deg"), expected.at("angle_" + race + "_deg"), 1e-4,
                  where + race);
    }
    EXPECT_LE(d.at("holding_coefficient").get<double>(), 0.1) << where;
    const double heat =
        d.at("inner_ring_heat_W").get<double>() + d.at("outer_ring_heat_W").get<double>();
    expect_near(heat, d.at("power_loss_W"), 1e-9, where + " heat of the rings");
  }
}

TEST_F(ContactLaw, AloneCanTurnBallsByTraction) {
  const std::string model =
      scratch_.write("my.toml",
                     "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
                     "viscosity_100C_mm2_s = 4.8\n[solver]\nrace_control = \"balanced\"\n");
  const Result r = run("solve " + model + " --speed 1000 --axial-load 100");
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("my.toml:7"));
  EXPECT_THAT(r.err, HasSubstr("[friction] law = \"contact\""));
}

TEST_F(ContactLaw, AddsUpOverBallsThatDiffer) {
  const json c = contact_cases("bearing_combined").front();
  const json &in = c.at("inputs"), &expected = c.at("outputs");
  const json d = solved(model_of(in, "steel"), flags_of(in, in.at("rpm").get<double>()));
  expect_near(d.at("friction_torque_Nmm"), expected.at("torque_Nmm"), 0.005, "torque");
  for (const std::string part : {"sliding", "rolling", "hysteresis"})
    expect_part(d.at("friction").at(part + "_Nmm"), expected.at(part + "_Nmm"), part);
  double power = d.at("drag_W").get<double>();
  for (std::size_t k = 0; k < d.at("balls").size(); ++k) {
    const json& ball = d.at("balls")[k];
    expect_near(ball.at("inner_load_N"), expected.at("Q_inner")[k], 1e-5, "inner load");
    for (const std::string race : {"inner", "outer"})
      for (const std::string part : {"sliding_W", "rolling_W", "hysteresis_W"})
        power += ball.at(race).at(part).get<double>();
  }
  expect_near(power, d.at("power_loss_W"), 1e-9, "power of all contacts");
}

TEST_F(ContactLaw, MeetsACatalogueOfBallScrewBearingsAsFarAsTheIndependentProgramDoes) {
  for (const json& c : contact_cases("catalogue_"))
    for (const auto& [key, expected] : c.at("outputs").items()) {
      if (!expected.is_object()) continue;
      const double rpm = std::stod(key.substr(0, key.find('_')));
      const json d = solved(model_of(c.at("inputs"), "steel"), flags_of(c.at("inputs"), rpm));
      expect_near(d.at("friction_torque_Nmm"), expected.at("torque_Nmm"), 0.005, key);
      for (const std::string part : {"sliding", "rolling", "hysteresis"})
        expect_part(d.at("friction").at(part + "_Nmm"), expected.at(part + "_Nmm"), key + part);
    }
}

/// Life of ISO 281 and ISO/TS 16281 through the whole program.
TEST_F(ContactLaw, LivesAreThoseOfTheReference) {
  for (const json& c : contact_cases("life_7014_rotating"))
    for (const auto& [balls, expected] : c.at("outputs").items()) {
      json in = c.at("inputs");
      in["nu40"] = 22.0, in["nu100"] = 4.8, in["T_C"] = 40.0;
      const std::string model =
          model_of(in, balls == "steel" ? "steel" : "silicon-nitride") +
          fmt::format("[life]\ndynamic_load_rating_N = {:.12g}\n", in.at("C").get<double>());
      const json d = solved(model, flags_of(in, in.at("rpm").get<double>()));
      expect_near(d.at("life").at("reference_L10r_h"), expected.at("L10rh"), 1e-4, balls);
      expect_near(d.at("static_safety"), expected.at("static_safety_by_stress"), 1e-4, balls);
      EXPECT_EQ(d.at("life").at("Lnm_h").is_null(), balls != "steel")
          << "ISO 281 defines no a_ISO for other balls than steel";
    }
}

TEST_F(ContactLaw, TableHasItsPartsFilmHeatAndLife) {
  const json in = contact_cases("bearing_10000rpm").front().at("inputs");
  const std::string model = scratch_.write("my.toml", model_of(in, "steel"));
  const json rows =
      parsed(run("table " + model + " --speed 0,1000,10000 --axial-load 500 --json")).at("rows");
  for (const json& row : rows) {
    EXPECT_THAT(keys(row), IsSupersetOf({"rolling_Nmm", "sliding_Nmm", "hysteresis_Nmm", "drag_Nmm",
                                         "film_min_um", "lambda_min", "kappa", "pressure_max_GPa",
                                         "slip_mean_m_s", "inner_ring_heat_W", "outer_ring_heat_W",
                                         "life_h"}));
    EXPECT_FALSE(row.contains("load_Nmm"));
    EXPECT_EQ(row.at("status"), "converged");
  }
  EXPECT_EQ(rows[0].at("lambda_min"), 0.0) << "standstill";
  EXPECT_EQ(rows[0].at("rolling_Nmm"), 0.0);
  EXPECT_GT(rows[0].at("sliding_Nmm"), 1.0);
  EXPECT_NEAR(rows[2].at("lambda_min").get<double>(), 15.7373, 0.01) << "a ratio, no minutes";
}

TEST_F(ContactLaw, FlagsFactorsOfOtherLawsAndEffectsThatItHasItself) {
  const std::string model =
      model_of(contact_cases("bearing_10000rpm").front().at("inputs"), "steel");
  const auto error_of = [&](const std::string& text) {
    const Result r =
        run("solve " + scratch_.write("my.toml", text) + " --speed 1000 --axial-load 500");
    EXPECT_EQ(r.status, 1);
    return r.err;
  };
  EXPECT_THAT(error_of(model + "f0 = 1.5\n"),
              HasSubstr("f0 = 1.5: this key is only for law = \"palmgren\", \"powers\" or "
                        "\"contact-powers\", but the law is \"contact\""));
  EXPECT_THAT(error_of(model + "\n[[effect]]\nid = \"spin-friction\"\n"),
              HasSubstr("id = \"spin-friction\": the effect needs another base law, because the "
                        "contact law already "
                        "includes this effect as mu_boundary under [friction]"));
  EXPECT_THAT(error_of(model + "oil_fraction = 0.01\n\n[[effect]]\nid = \"lubricant-drag\"\n"),
              HasSubstr("needs oil_fraction = 0 under [friction]"));
  EXPECT_THAT(error_of(replaced(model, "[lubricant]", "[lubricant]\neyring_stress_MPa = 50")),
              HasSubstr("eyring_stress_MPa = 50 MPa: must be from 0.5 to 30 MPa"));
  EXPECT_THAT(error_of(replaced(model, "[lubricant]", "[lubricant]\ntype = \"pa0\"")),
              HasSubstr("type = \"pa0\""));
}

TEST_F(ContactLaw, OilDataOfAnotherLawAreNamedAsIgnored) {
  const Result r = run("solve " +
                       scratch_.write("my.toml", replaced(model_text, "[lubricant]",
                                                          "[lubricant]\ntype = \"ester\"")) +
                       " --speed 1000 --axial-load 500");
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, HasSubstr("the friction torque by palmgren does not depend on"));
  EXPECT_THAT(r.err, HasSubstr("type"));
}

TEST_F(ContactLaw, JudgesFilmAndFrictionInOneLine) {
  const json in = contact_cases("bearing_10000rpm").front().at("inputs");
  const std::string solve =
      "solve " + scratch_.write("my.toml", model_of(in, "steel")) + " --axial-load 500 --speed ";
  EXPECT_THAT(run(solve + "10000").out,
              HasSubstr("full film (smallest lambda 15.7); largest part of the friction torque: "
                        "rolling resistance of the oil, 98 %"));
  EXPECT_THAT(run(solve + "0").out,
              HasSubstr("boundary friction (smallest lambda 0); largest "
                        "part of the friction torque: sliding in the contacts,"));
  EXPECT_THAT(run(solve + "10000").err, HasSubstr("balls may skid"));
}

TEST_F(ContactLaw, HybridAndSteelDifferInTheTableAndItSaysWhy) {
  const json c = contact_cases("bearing_10000rpm").front();
  const auto table = [&](const std::string& balls) {
    return run("table " + scratch_.write(balls + ".toml", model_of(c.at("inputs"), balls)) +
               " --speed 1000,10000 --axial-load 500 --json");
  };
  const Result steel = table("steel"), hybrid = table("silicon-nitride");
  const auto torque = [](const Result& r) {
    return parsed(r).at("rows")[1].at("friction_torque_Nmm").get<double>();
  };
  expect_near(torque(hybrid) / torque(steel), c.at("outputs").at("ratio_nitride_steel"), 1e-3,
              "ratio");
  EXPECT_THAT(hybrid.err,
              HasSubstr("with silicon-nitride balls the torque is 0.92 times the torque with steel "
                        "balls at 10000 rpm and 500 N axial load: centrifugal force of a ball"));
  EXPECT_THAT(steel.err, Not(HasSubstr("times the torque with steel balls at")));
}

}  // namespace
}  // namespace raceway::tests

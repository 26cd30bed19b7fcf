#include "verdict/headline.h"

#include <gtest/gtest.h>

#include "record/units.h"
#include "verdict/verdict_text.h"

namespace raceway::fit {
namespace {

verdict::Diagnosis found(verdict::Verdict verdict, std::vector<std::vector<std::string>> sets) {
  verdict::Diagnosis d;
  d.verdict = verdict;
  d.sets = std::move(sets);
  d.channels.resize(1);
  d.channels[0].baseline.channel = &record::friction_torque;
  d.channels[0].rmse_before = 44.9 * N_mm;
  d.channels[0].rmse_after = 10.7 * N_mm;
  d.channels[0].noise.rms = 10.2 * N_mm;
  return d;
}

verdict::RankedEffect effect(const std::string& id, const std::string& parameter, double value,
                             const std::string& unit) {
  verdict::RankedEffect e;
  e.id = id;
  e.in_verdict = true;
  e.parameters.resize(1);
  e.parameters[0].name = parameter;
  e.parameters[0].value = value;
  e.parameters[0].unit = unit;
  return e;
}

TEST(Headline, NamesTheEffectItsSizeAndTheError) {
  verdict::Diagnosis d = found(verdict::Verdict::effect, {{"lubricant-drag"}});
  d.effects = {effect("lubricant-drag", "torque_at_10000_rpm_Nmm", 65.1, "N mm")};
  EXPECT_EQ(verdict::headline(d),
            "Lubricant drag is missing: 65 N mm at 10 000 rpm; error 44.9 -> 10.7 N mm");
  d.effects = {effect("spin-friction", "friction_coefficient", 0.0831, "1")};
  d.sets = {{"spin-friction"}};
  EXPECT_EQ(verdict::headline(d),
            "Spin friction is missing: friction coefficient 0.083; error 44.9 -> 10.7 N mm");
}

TEST(Headline, NamesAllOfSeveral) {
  verdict::Diagnosis d = found(verdict::Verdict::several_effects, {{"churning", "windage"}});
  d.effects = {effect("churning", "torque_at_10000_rpm_Nmm", 20.0, "N mm"),
               effect("windage", "torque_at_10000_rpm_Nmm", 8500.0, "N mm")};
  EXPECT_EQ(verdict::headline(d),
            "Churning and windage are missing: 20 N mm at 10 000 rpm and 8500 N mm at 10 000 rpm; "
            "error 44.9 -> 10.7 N mm");
}

TEST(Headline, NamesTheBaseLawThatExplainsTheData) {
  verdict::Diagnosis d = found(verdict::Verdict::not_in_catalogue, {});
  d.other_bases.push_back({.id = "law:skf", .words = "law = skf", .rmse = {11.5 * N_mm}});
  EXPECT_EQ(verdict::headline(d).find("law = skf"), std::string::npos);
  d.other_bases.front().explains = true;
  EXPECT_EQ(verdict::headline(d),
            "law = skf explains these data, but no effect does: error 44.9 -> 11.5 N mm");
}

TEST(Headline, DoesNotCallWrongDataAnEffect) {
  verdict::Diagnosis d = found(verdict::Verdict::effect, {{"lubricant-viscosity"}});
  d.effects = {effect("lubricant-viscosity", "factor", 1.4, "1")};
  d.effects[0].datum = "the oil card";
  d.effects[0].correction = "31 mm2/s at 40 C instead of the entered 22";
  EXPECT_EQ(
      verdict::headline(d),
      "Wrong data rather than missing physics: check the oil card, 31 mm2/s at 40 C instead of "
      "the entered 22; error 44.9 -> 10.7 N mm");
}

// A record of readings far apart: "noise nan K".
TEST(Headline, DoesNotTellANoiseThatIsNotKnown) {
  verdict::Diagnosis d = found(verdict::Verdict::not_in_catalogue, {});
  d.channels[0].noise.rms = unset;
  EXPECT_EQ(verdict::headline(d),
            "Something is missing that is not in the catalogue: error 44.9 N mm, "
            "noise not known");
}

TEST(Headline, SaysWhereItIsNotSure) {
  verdict::Diagnosis d =
      found(verdict::Verdict::ambiguous, {{"churning"}, {"windage", "seal-friction"}});
  EXPECT_EQ(verdict::headline(d),
            "Churning or windage with seal friction explains the misfit, but these data do not "
            "decide which; error 44.9 -> 10.7 N mm");
  d = found(verdict::Verdict::effect_like, {});
  d.effects = {effect("churning", "torque_at_10000_rpm_Nmm", 20.0, "N mm")};
  EXPECT_EQ(
      verdict::headline(d),
      "The misfit looks like churning, but the data do not confirm it: error 44.9 N mm, noise 10.2 "
      "N mm");
  EXPECT_EQ(verdict::headline(found(verdict::Verdict::not_in_catalogue, {})),
            "Something is missing that is not in the catalogue: error 44.9 N mm, noise "
            "10.2 N mm");
  EXPECT_EQ(verdict::headline(d, verdict::Inputs::miss_what_changes),
            "The cause is not an input of the model: error 44.9 N mm, noise 10.2 "
            "N mm");
}

TEST(Headline, DoubtsWhereEqualPointsReadDifferently) {
  verdict::Diagnosis d = found(verdict::Verdict::effect, {{"churning"}});
  d.effects = {effect("churning", "torque_at_10000_rpm_Nmm", 20.0, "N mm")};
  EXPECT_EQ(verdict::headline(d, verdict::Inputs::may_miss_something),
            "Churning is missing: 20 N mm at 10 000 rpm; error 44.9 -> 10.7 N mm; but rows at "
            "nearly equal operating points have different readings");
}

TEST(Headline, ClaimsNoMoreThanTheDataShow) {
  verdict::Diagnosis d = found(verdict::Verdict::nothing_missing, {});
  EXPECT_EQ(verdict::headline(d),
            "Nothing is missing that these data can show: error 44.9 N mm, noise 10.2 N mm");
  d.within_tolerance = true;
  EXPECT_EQ(verdict::headline(d),
            "Nothing is missing that matters: error 44.9 N mm, noise 10.2 N mm");
}

TEST(VerdictText, ValuesFarFromTheirRangeAreNamed) {
  record::Parameter z{.name = "z", .unit = "1", .value = 0.0065, .lower = 0.0, .upper = 0.02};
  z.plausible_lower = 0.00067;
  z.plausible_upper = 0.001;
  const std::vector<record::Note> said = verdict::unusual_values({&z, 1});
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front().text.substr(0, 51), "z = 0.0065 is far from the usual 0.00067 to 0.001: ");
  for (const double usual : {0.0009, 0.0029, 0.00023}) {
    z.value = usual;
    EXPECT_TRUE(verdict::unusual_values({&z, 1}).empty()) << usual;
  }
  // A size below its neutral value, as far as the range allows, and a small one.
  record::Parameter offset{.name = "load-offset.force_N", .unit = "N", .lower = -5e3, .upper = 5e3};
  offset.plausible_lower = -300.0;
  offset.plausible_upper = 300.0;
  offset.neutral = 0.0;
  for (const double usual : {-150.0, 1.0, 800.0}) {
    offset.value = usual;
    EXPECT_TRUE(verdict::unusual_values({&offset, 1}).empty()) << usual;
  }
  offset.value = -1000.0;
  EXPECT_EQ(verdict::unusual_values({&offset, 1}).size(), 1U);
}

TEST(VerdictText, PointsThatDoNotDecideAreSaidToBeSo) {
  verdict::Diagnosis d = found(verdict::Verdict::ambiguous, {{"windage"}, {"lubricant-drag"}});
  d.suggested_measurements.push_back({.point = {}, .words = "4160 rpm", .repeats = 6});
  d.predicted_separation = 3.0;
  d.separation_by_repetition = 2.0;
  EXPECT_FALSE(verdict::will_decide(d));
  EXPECT_NE(verdict::measure_text(d).find("A decision needs a difference of 6."),
            std::string::npos);
  d.predicted_separation = 24.0;
  EXPECT_TRUE(verdict::will_decide(d));
  EXPECT_EQ(verdict::measure_text(d).find("A decision"), std::string::npos);
}

}  // namespace
}  // namespace raceway::fit

// A fitted model written into the text of its file, and read back.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "files/model_file.h"
#include "model/base_laws.h"
#include "model/parameters.h"

namespace raceway::files {
namespace {

using record::Parameter;
using testing::HasSubstr;
using testing::Not;

const std::string bearing_of_edit = R"([bearing]
name = "7014"
ball_count = 20
ball_diameter_mm = 11.906
pitch_diameter_mm = 90
contact_angle_deg = 25.0        # as printed
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 43000

[lubricant]
viscosity_40C_mm2_s = 22.0
viscosity_100C_mm2_s = 4.8
)";

const std::string palmgren = "\n[friction]\nf0 = 1.5 # guessed\nz = 0.001\ny = 0.33\n";
const std::string skf_law = "\n[friction]\nlaw = \"skf\"   # its constants are left out\n";

const std::string rig_effects = R"(
[[effect]]
id = "seal-friction"

[[effect]]
id = "my-windage"
torque_Nmm = "c * (speed_rpm/1000)^2 + d"
c = { value = 0.5, unit = "N mm", lower = 0.0 }
d = 0.25

[[effect]]
id = "spin-friction"
friction_coefficient = 0.06
)";

const std::string edited_sets = R"(
[arrangement]
layout = "O"
front = 2
rear = 1
preload_N = 600.0   # of the drawing
)";

const std::string shaft_effects = R"(
[[effect]]
id = "centrifugal-ring-growth"

[[effect]]
id = "displacement-offset"
)";

ModelFile file_of(const std::string& text) { return parse_model(text, "m.toml"); }

/// Another value within the bounds.
double other_value(const Parameter& p) {
  const double step = 0.0123456789 * std::max(std::abs(p.value), 0.1 * p.scale);
  return p.value + step <= p.upper ? p.value + step : p.value - step;
}

/// To the 15 digits that are written.
void expect_same_numbers(const model::Model& read, const model::Model& wanted) {
  const std::vector<Parameter> got = model::parameters(read), want = model::parameters(wanted);
  ASSERT_EQ(got.size(), want.size());
  for (std::size_t k = 0; k < want.size(); ++k) {
    EXPECT_EQ(got[k].name, want[k].name);
    EXPECT_EQ(got[k].addresses, want[k].addresses);
    EXPECT_NEAR(got[k].value, want[k].value, 1e-14 * std::abs(want[k].value)) << want[k].name;
  }
  ASSERT_EQ(read.shaft.has_value(), wanted.shaft.has_value());
  if (!wanted.shaft) return;
  EXPECT_NEAR(read.shaft->arrangement.displacement(bearing::Side::rear),
              wanted.shaft->arrangement.displacement(bearing::Side::rear), 1e-15);
}

class EveryParameter : public testing::TestWithParam<std::string> {};

TEST_P(EveryParameter, AloneIsWrittenWhereItStands) {
  const ModelFile file = file_of(GetParam());
  for (const Parameter& p : model::parameters(file.model)) {
    SCOPED_TRACE(p.name);
    model::Model fitted = file.model;
    model::set(fitted, p, other_value(p));
    ASSERT_NE(model::get(fitted, p), p.value);
    const std::string text = with_model(file, fitted);
    expect_same_numbers(file_of(text).model, fitted);
    // Back again nothing but digits has changed: comments and order are the user's.
    EXPECT_THAT(text, HasSubstr("# as printed"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '#'),
              std::count(file.text.begin(), file.text.end(), '#'));
  }
}

TEST_P(EveryParameter, TogetherIsWrittenWhereItStands) {
  const ModelFile file = file_of(GetParam());
  model::Model fitted = file.model;
  for (const Parameter& p : model::parameters(file.model)) model::set(fitted, p, other_value(p));
  const ModelFile read = file_of(with_model(file, fitted));
  expect_same_numbers(read.model, fitted);
  EXPECT_EQ(with_model(read, read.model), read.text) << "nothing to change";
}

INSTANTIATE_TEST_SUITE_P(OfModels, EveryParameter,
                         testing::Values(bearing_of_edit + palmgren + rig_effects,
                                         bearing_of_edit + skf_law + rig_effects,
                                         bearing_of_edit + palmgren + edited_sets + shaft_effects,
                                         bearing_of_edit + skf_law + edited_sets));

effects::Effect initial(std::string_view id, effects::Form form) {
  const effects::Description& d = *effects::find(id, form);
  return {.description = &d, .values = effects::initial_values(d)};
}

TEST(WithModel, AppendsEffectsThatTheFileLacks) {
  const ModelFile file = file_of(bearing_of_edit + palmgren + rig_effects);
  model::Model fitted = file.model;
  fitted.law_values[0] = 2.0 / 3.0;
  fitted.effects.push_back(initial("lubricant-drag", effects::Form::rig));
  fitted.effects.back().values[0] = 1.0 / 3.0;
  const std::string text = with_model(file, fitted);
  expect_same_numbers(file_of(text).model, fitted);
  EXPECT_THAT(text, HasSubstr("f0 = 0.666666666666667 # guessed\n"));
  EXPECT_THAT(text, HasSubstr("\n[[effect]]\nid = \"lubricant-drag\"\n"));
  EXPECT_THAT(text, HasSubstr(" = 0.333333333333333\n"));
}

TEST(WithModel, AnEffectAddedToAShaftLeavesItsNumbersWhereTheyStand) {
  // They were once written under [friction], and the model could not be read back.
  const ModelFile file = file_of(bearing_of_edit + palmgren + edited_sets);
  model::Model fitted = file.model;
  fitted.effects.push_back(initial("centrifugal-ring-growth", effects::Form::shaft));
  for (const Parameter& p : model::parameters(fitted))
    if (p.name == "preload_N") model::set(fitted, p, 633.25);
  const std::string text = with_model(file, fitted);
  EXPECT_THAT(text, HasSubstr("preload_N = 633.25   # of the drawing\n"));
  EXPECT_THAT(text, HasSubstr(palmgren)) << "nothing new under [friction]";
  expect_same_numbers(file_of(text).model, fitted);
}

TEST(WithModel, TheLoadOfTheFactorStaysWithTheFactor) {
  const ModelFile file = file_of(bearing_of_edit + palmgren + "f1_load = \"F_b\" # of the rig\n");
  model::Model fitted = file.model;
  fitted.law_values[1] = 0.002;
  fitted.effects.push_back(initial("lubricant-drag", effects::Form::rig));
  const std::string text = with_model(file, fitted);
  EXPECT_THAT(text, HasSubstr("z = 0.002\ny = 0.33\nf1_load = \"F_b\" # of the rig\n"));
  EXPECT_EQ(file_of(text).model.f1_load, friction::F1Load::F_b);
}

TEST(WithModel, AnotherLawReadsBackAndLeavesAllElseAsItStood) {
  using friction::FrictionLaw;
  const std::string tail =
      "\n[calibration]\nfree = [\"{}\", \"seal-friction.torque_at_45_C_Nmm\"]  # mine\n"
      "\n[[effect]]\nid = \"seal-friction\"\n";
  const std::vector<std::pair<std::string, std::string>> laws{
      {palmgren + "f1_load = \"F_b\"\n", "f0"},
      {skf_law, "K_rs"},
      {"\n[friction]\nlaw = \"contact\"\ninlet_over_b = 1.5\n\n[solver]\nrace_control = "
       "\"balanced\"\n",
       "rolling_factor"}};
  for (const auto& [law, free] : laws)
    for (const FrictionLaw wanted : friction::all_friction_laws) {
      std::string text = bearing_of_edit + law + tail;
      text.replace(text.find("{}"), 2, free);
      const ModelFile file = parse_model(text, "my.toml");
      // The law of a table: friction_table_test.cpp.
      if (file.model.law == wanted || wanted == FrictionLaw::table) continue;
      const model::Model changed = model::with_law(file.model, wanted);
      const std::string written = with_model(file, changed);
      SCOPED_TRACE(written);
      const ModelFile read = parse_model(written, "my.toml");
      EXPECT_EQ(read.model.law, wanted);
      EXPECT_EQ(read.model.law_values, changed.law_values);
      EXPECT_EQ(read.model.free, changed.free);
      EXPECT_EQ(read.model.free.back(), "seal-friction.torque_at_45_C_Nmm");
      EXPECT_EQ(read.model.balanced_balls, false);
      // Every number stands there, so that another default changes nothing.
      for (const friction::Parameter& p : friction::parameters(wanted))
        if (!friction::of_the_lubricant(p)) {
          EXPECT_THAT(written, HasSubstr("\n" + std::string(p.name) + " = "));
        }
      EXPECT_THAT(written, HasSubstr("contact_angle_deg = 25.0        # as printed\n"));
      EXPECT_THAT(written, HasSubstr("# mine"));
      EXPECT_THAT(written,
                  HasSubstr(fmt::format("# it was \"{}\"", friction::name(file.model.law))));
    }
}

/// A number that was fitted is no guess any more; the mark of another one stays.
TEST(WithModel, AFittedNumberLosesItsMark) {
  const ModelFile file = file_of(bearing_of_edit + "\n[friction]\nf0 = 1.5  # assumed: oil-air\n" +
                                 "z = 0.001  # of load\ny = 0.33 # estimated\n");
  model::Model fitted = file.model;
  fitted.law_values[0] = 2.5;
  fitted.law_values[1] = 0.002;
  const std::string text = with_model(file, fitted);
  EXPECT_THAT(text, HasSubstr("f0 = 2.5\nz = 0.002  # of load\ny = 0.33 # estimated\n"));
}

TEST(WithModel, TheSupplyStays) {
  const ModelFile file = file_of(bearing_of_edit + "supply = \"jet\" # 2 l/min\n" + palmgren);
  model::Model fitted = file.model;
  fitted.law_values[0] = 2.5;
  fitted.effects.push_back(initial("lubricant-drag", effects::Form::rig));
  const std::string text = with_model(file, fitted);
  EXPECT_THAT(text, HasSubstr("supply = \"jet\" # 2 l/min\n"));
  EXPECT_EQ(file_of(text).model.supply, friction::Supply::jet);
}

TEST(WithModel, EqualGroovesStayEqual) {
  const ModelFile file = file_of(bearing_of_edit + palmgren + edited_sets);
  model::Model fitted = file.model;
  for (const Parameter& p : model::parameters(fitted))
    if (p.name == "conformity") model::set(fitted, p, 0.53);
  const std::string text = with_model(file, fitted);
  EXPECT_THAT(text, HasSubstr("inner_conformity = 0.53\nouter_conformity = 0.53\n"));
  EXPECT_THAT(text, Not(HasSubstr("[bearing]\nconformity")));
}

}  // namespace
}  // namespace raceway::files

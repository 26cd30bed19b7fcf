#include "effects/formula.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "tests/places.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::effects {
namespace {

UserMadeEffect windage(const std::string& formula) {
  return {.id = "my-windage",
          .title = "",
          .torque_Nmm = formula,
          .parameters = {{.name = "c", .unit = "N mm", .value = 2.0, .lower = 0.0}}};
}

FormulaError error_of(const std::string& formula) {
  try {
    (void)make_effect(windage(formula));
  } catch (const FormulaError& e) {
    return e;
  }
  return {"accepted", 0, ""};
}

TEST(Formula, AddsItsMomentInTheUnitsOfTheFiles) {
  model::Model model = fit::synthetic_model();
  model.effects.push_back(make_effect(windage("c * (speed_rpm/1000)^2")));
  const auto f = model::predict_friction(model, {.speed = 5000 * rpm, .axial_load = 600});
  EXPECT_NEAR(f.effects[0], 50.0 * N_mm, 1e-15);
  EXPECT_EQ(f.torque, f.load + f.viscous + f.effects[0]);
  EXPECT_EQ(model.effects[0].description->step(), "moment");
  EXPECT_EQ(model.effects[0].description->parameters[0].lower, 0.0);
  EXPECT_EQ(model.effects[0].description->parameters[0].upper, INFINITY);
}

TEST(Formula, OutlivesTheModelItWasReadWith) {
  model::Model copy = fit::synthetic_model();
  {
    model::Model model = fit::synthetic_model();
    model.effects.push_back(make_effect(windage("c * speed_rpm")));
    copy = model;
  }
  EXPECT_EQ(copy.effects[0].description->id, "my-windage");
  EXPECT_TRUE(model::predict_friction(copy, {.speed = 500, .axial_load = 100}).predicted());
}

TEST(Formula, KnowsEveryVariable) {
  fit::Row row;
  row.point = {.speed = 5000 * rpm, .axial_load = 600, .radial_load = 50};
  row.time = 60;
  row.inner_ring_temperature = kelvin(45);
  row.outer_ring_temperature = kelvin(41);
  const std::map<std::string_view, double> expected{{"speed_rpm", 5000},
                                                    {"axial_load_N", 600},
                                                    {"radial_load_N", 50},
                                                    {"temperature_C", 40},
                                                    {"viscosity_mm2_s", 22},
                                                    {"time_s", 60},
                                                    {"inner_ring_temperature_C", 45},
                                                    {"outer_ring_temperature_C", 41},
                                                    {"pitch_diameter_mm", 90},
                                                    {"ball_diameter_mm", 11.906},
                                                    {"ball_count", 20},
                                                    {"contact_angle_deg", 25},
                                                    {"static_load_rating_N", 43000},
                                                    {"preload_N", 250}};
  record::Record columns;
  columns.set(record::preload, {250});
  for (const Formula::Variable& v : Formula::variables()) {
    model::Model model = fit::synthetic_model();
    model.effects.push_back(make_effect(windage(std::string(v.name))));
    Record record = fit::record_of(row);
    record.rows = &columns;
    const auto f = model::predict_friction(model, row.point, false, record);
    const double value = v.name == "load_torque_Nmm"      ? f.load / N_mm
                         : v.name == "viscous_torque_Nmm" ? f.viscous / N_mm
                                                          : expected.at(v.name);
    EXPECT_NEAR(f.effects[0] / N_mm, value, 1e-9 * value) << v.name;
  }
}

TEST(Formula, MayUseEveryInputOfTheTable) {
  for (const record::Channel& channel : record::channels) {
    if (!channel.is_input()) continue;
    SCOPED_TRACE(std::string(channel.name));
    const auto is = [&](const Formula::Variable& v) { return v.name == channel.name; };
    const auto variables = Formula::variables();
    EXPECT_EQ(std::count_if(variables.begin(), variables.end(), is), 1);
  }
}

TEST(Formula, SaysWhichChannelsItNeeds) {
  const Effect preloaded = make_effect(windage("c * preload_N * time_s"));
  const Description& d = *preloaded.description;
  ASSERT_EQ(d.needs.size(), 1u);
  EXPECT_EQ(d.needs[0], Need::time);
  ASSERT_EQ(d.channels.size(), 1u);
  EXPECT_EQ(*d.channels[0], record::preload);
  EXPECT_EQ(text(*d.channels[0]), "preload_N of every row");
  EXPECT_TRUE(make_effect(windage("c * speed_rpm")).description->channels.empty());
}

TEST(Formula, SaysWhatIsWrongAndWhere) {
  FormulaError e = error_of("c * spede_rpm^2");
  EXPECT_EQ(e.unknown_name, "spede_rpm");
  EXPECT_EQ(e.position, 4U);
  e = error_of("c * (speed_rpm/1000");
  EXPECT_TRUE(e.unknown_name.empty());
  EXPECT_STRNE(e.what(), "accepted");
  EXPECT_GE(e.position, 4U);
  e = error_of("c * / 2");
  EXPECT_STRNE(e.what(), "accepted");
  EXPECT_EQ(e.position, 4U);
  EXPECT_STRNE(error_of("").what(), "accepted");
}

TEST(Formula, IsOneExpressionWithDecimalPoints) {
  // muParser takes the last of several expressions: 5 * speed_rpm.
  FormulaError e = error_of("1,5 * speed_rpm");
  EXPECT_STREQ(
      e.what(),
      "a comma may only separate the arguments of a function; write decimals with a point, 1.5");
  EXPECT_EQ(e.position, 1U);
  EXPECT_STRNE(error_of("c * (1,5)").what(), "accepted");
  EXPECT_STREQ(error_of("c * min(1.5, speed_rpm)").what(), "accepted");
}

TEST(Formula, AssignsNothing) {
  const std::string message = "a formula cannot assign a value with =; write == to compare";
  EXPECT_EQ(error_of("c = 3").what(), message);
  EXPECT_EQ(error_of("c * (speed_rpm = 0)").position, 15U);
  EXPECT_EQ(error_of("c += 3").what(), message);
  for (const char* compares : {"c * (speed_rpm == 0)", "speed_rpm >= 100 ? c : 0",
                               "speed_rpm <= 100 ? c : 0", "c * (speed_rpm != 0)"})
    EXPECT_STREQ(error_of(compares).what(), "accepted") << compares;
}

TEST(Formula, HasAPowerSignOfItsOwn) {
  const FormulaError e = error_of("c * speed_rpm**2");
  EXPECT_STREQ(e.what(), "** is not an operator in formulas; write a power as x^2");
  EXPECT_EQ(e.position, 13U);
}

TEST(Formula, HasItsVariablesInTheDocuments) {
  std::ifstream in(tests::source_dir() + "/docs/effects.md");
  std::set<std::string> shown, known;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    inside = line.starts_with("| variable |") || (inside && line.starts_with("|"));
    if (!inside) continue;
    const std::string names = line.substr(0, line.find('|', 1));
    for (std::size_t at = names.find('`'); at != names.npos; at = names.find('`', at + 1)) {
      const std::size_t end = names.find('`', at + 1);
      shown.insert(names.substr(at + 1, end - at - 1));
      at = end;
    }
  }
  for (const Formula::Variable& v : Formula::variables()) known.emplace(v.name);
  EXPECT_EQ(shown, known);
}

TEST(Formula, WithoutANumberThereIsNoPrediction) {
  model::Model model = fit::synthetic_model();
  model.effects.push_back(make_effect(windage("c * time_s")));
  EXPECT_FALSE(model::predict_friction(model, {.speed = 500, .axial_load = 100}).predicted());
  EXPECT_EQ(model.effects[0].description->needs.front(), Need::time);
  model.effects[0] = make_effect(windage("c * log(axial_load_N - 200)"));
  EXPECT_FALSE(model::predict_friction(model, {.speed = 500, .axial_load = 100}).predicted());
}

TEST(Formula, MayBeUsedByManyThreads) {
  model::Model model = fit::synthetic_model();
  model.effects.push_back(make_effect(windage("c * (speed_rpm/1000)^2")));
  tbb::parallel_for(1, 2000, [&](int n) {
    const auto f = model::predict_friction(model, {.speed = n * rpm, .axial_load = 600});
    EXPECT_NEAR(f.effects[0], 2e-6 * n * n * N_mm, 1e-12);
  });
}

TEST(Formula, IsFittedLikeTheOthers) {
  model::Model truth = fit::synthetic_model();
  truth.effects.push_back(make_effect(windage("c * (speed_rpm/1000)^2")));
  truth.effects[0].values = {0.7};
  fit::DataSet data = fit::factorial_plan({500, 3000, 8000, 12000}, {100, 600}, {25, 50});
  std::mt19937 random(2);
  fit::measure(truth, 0.0, random, data);
  model::Model model = truth;
  model.effects[0].values = {0.0};
  model.free = {"f0", "z", "my-windage.c"};
  const verdict::Calibration fit = fit::calibrate(model, data);
  ASSERT_TRUE(fit.converged());
  EXPECT_NEAR(fit::model_of(fit).effects[0].values[0], 0.7, 1e-8);
}

}  // namespace
}  // namespace raceway::effects

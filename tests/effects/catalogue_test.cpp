#include "effects/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bearing/hertz.h"
#include "effects/elastic_hysteresis.h"
#include "model/corrected_data.h"
#include "tests/support/bearing_data.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway {
namespace {

using effects::Description;
using effects::Form;
using effects::Need;

/// Forms that change the torque of a bearing on a rig.
std::vector<Description> torque_effects() {
  std::vector<Description> list;
  for (const Description& d : effects::catalogue())
    if (d.moves(Form::rig)) list.push_back(d);
  return list;
}

bool has_need(const Description& d, Need need) {
  return std::find(d.needs.begin(), d.needs.end(), need) != d.needs.end();
}

/// A model in which the effect can show: beside ball loads where it needs them.
model::Model model_with(const Description& d, const std::vector<double>& values) {
  model::Model model = fit::synthetic_model();
  model.rig.room_temperature = kelvin(20);
  if (has_need(d, Need::ball_load_law))
    model.effects.push_back({effects::find("spin-friction"), {0.06}, nullptr});
  model.effects.push_back({&d, values, nullptr});
  return model;
}

/// A rig that records all that effects can ask for.
fit::DataSet full_plan() {
  fit::DataSet data =
      fit::factorial_plan({300, 1000, 3000, 6000, 10000, 15000}, {150, 400, 1000}, {25, 40, 60});
  for (std::size_t i = 0; i < data.rows.size(); ++i) {
    fit::Row& row = data.rows[i];
    row.time = 1200.0 * static_cast<double>((i * 37) % data.rows.size());
    row.outer_ring_temperature = row.point.temperature - 1.0;
    row.inner_ring_temperature = row.point.temperature + 2.0 + static_cast<double>(i % 5);
    row.run = 0;
  }
  data.runs = {"0"};
  return data;
}

model::FrictionPrediction predicted(const model::Model& model, const fit::Row& row) {
  return model::predict_friction(model, row.point, false, fit::record_of(row));
}

double reading(const model::Model& model, const fit::Row& row) {
  return predicted(model, row).reading;
}

/// Sizes that a test may use where bounds are infinite or far beyond all reason.
std::pair<double, double> usual_range(const effects::Parameter& p) {
  return {p.plausible_lower, p.plausible_upper};
}

// As FrictionLaw.TakesInOfABearingWhatItSaysAndNothingElse; what looks at the balls may take in
// all.
TEST(Catalogue, EffectsTakeInOfABearingWhatTheySayAndNothingElse) {
  const fit::DataSet data = full_plan();
  for (const Description& d : torque_effects()) {
    if (d.needs_equilibrium || has_need(d, Need::ball_load_law)) continue;
    model::Model with = fit::synthetic_model();
    with.rig.room_temperature = kelvin(20);
    with.effects.push_back({&d, effects::initial_values(d), nullptr});
    const auto base = friction::bearing_data(with.law);
    const bearing::Bearing entered = with.bearing;
    for (const auto& [datum, changed] : tests::with_each_datum_changed(entered)) {
      if (std::find(base.begin(), base.end(), datum) != base.end()) continue;
      const auto readings = [&, &other = changed](model::Model model, bool change) {
        if (change) model.bearing = other;
        std::vector<double> all;
        for (const fit::Row& row : data.rows) all.push_back(reading(model, row));
        return all;
      };
      const bool said =
          std::find(d.bearing_data.begin(), d.bearing_data.end(), datum) != d.bearing_data.end();
      EXPECT_EQ(readings(with, true) != readings(with, false), said) << d.id << ", " << datum;
    }
  }
}

TEST(Catalogue, IsComplete) {
  const std::set<std::string_view> wanted{"lubricant-viscosity",
                                          "viscosity-slope",
                                          "temperature-offset",
                                          "temperature-gain",
                                          "viscous-exponent",
                                          "load-exponent",
                                          "spin-friction",
                                          "differential-slip",
                                          "elastic-hysteresis",
                                          "gyroscopic-slip",
                                          "inlet-shear-heating",
                                          "replenishment-starvation",
                                          "shear-thinning",
                                          "film-self-heating",
                                          "mixed-lubrication",
                                          "seal-friction",
                                          "load-calibration",
                                          "load-cell-drift",
                                          "set-preload",
                                          "support-bearings",
                                          "torque-creep",
                                          "speed-hysteresis",
                                          "preload-calibration",
                                          "load-offset",
                                          "lubricant-drag",
                                          "churning",
                                          "windage",
                                          "cage-friction",
                                          "thermal-preload",
                                          "thermal-ring-growth",
                                          "centrifugal-ring-growth",
                                          "interference-fit",
                                          "misalignment",
                                          "ball-material",
                                          "grease-churning",
                                          "torque-gain",
                                          "torque-offset",
                                          "torque-temperature-drift",
                                          "torque-time-drift",
                                          "rig-viscous-drag",
                                          "mounting",
                                          "shaft-contraction",
                                          "displacement-offset",
                                          "displacement-temperature-drift",
                                          "coolant",
                                          "seat-conductance",
                                          "motor-heat",
                                          "drive-heat",
                                          "convection-factor",
                                          "bearing-conductance",
                                          "preload-growth",
                                          "structure-temperature",
                                          "flange-conductance",
                                          "seal-heat",
                                          "front-bearing-heat",
                                          "rear-bearing-heat"};
  std::set<std::string_view> ids;
  for (const Description& d : effects::catalogue()) EXPECT_TRUE(ids.insert(d.id).second) << d.id;
  EXPECT_EQ(ids, wanted);
  EXPECT_EQ(effects::find("no-such-effect"), nullptr);

  std::set<std::string_view> names = ids;
  for (const auto law : {friction::FrictionLaw::palmgren, friction::FrictionLaw::skf})
    for (const auto& p : friction::parameters(law)) names.insert(p.name);
  names.insert({"preload_N", "contact_angle_deg", "conformity"});
  names.insert({"convection_factor", "lubricant_conductance_W_K", "outer_conductance_W_m2K",
                "flange_conductance_W_K"});
  for (const Description& d : effects::all_forms()) {
    SCOPED_TRACE(std::string(d.id));
    for (const auto text : {d.id, d.title, d.mechanism, d.formula, d.source})
      EXPECT_FALSE(text.empty());
    EXPECT_EQ(d.title.find('\n'), std::string_view::npos);
    EXPECT_FALSE(d.confused_with.empty());
    for (const auto other : d.confused_with) EXPECT_EQ(names.count(other), 1U) << other;
    for (const Need need : d.needs) EXPECT_FALSE(effects::text(need).empty());
    // What corrects an entry is a datum; loads and readings are corrected where they are. Each says
    // what it means in words, and what would show it.
    EXPECT_TRUE(d.entry == nullptr || !d.datum.empty());
    EXPECT_EQ(!d.datum.empty(), d.entry != nullptr || d.correction != nullptr);
    EXPECT_TRUE(d.datum.empty() || !d.settled_by.empty());
    EXPECT_EQ((d.entry != nullptr) + (d.condition != nullptr) + (d.lubricant != nullptr) +
                  d.has_moment() + (d.reading != nullptr) + (d.spindle != nullptr),
              1);
    EXPECT_TRUE(d.moves(Form::rig) || d.moves(Form::shaft) || d.moves(Form::spindle));
    EXPECT_EQ(d.spindle != nullptr, d.of_spindles_alone());
    ASSERT_FALSE(d.parameters.empty());
    EXPECT_FALSE(std::isnan(d.parameters[0].neutral)) << "the first parameter is the size";
    for (const auto& p : d.parameters) {
      EXPECT_FALSE(p.name.empty());
      EXPECT_FALSE(p.unit.empty());
      EXPECT_LE(p.lower, p.initial);
      EXPECT_LE(p.initial, p.upper);
      EXPECT_LE(p.lower, p.plausible_lower);
      EXPECT_LT(p.plausible_lower, p.plausible_upper);
      EXPECT_LE(p.plausible_upper, p.upper);
      if (!std::isnan(p.neutral)) {
        EXPECT_LE(p.lower, p.neutral);
        EXPECT_LE(p.neutral, p.upper);
      }
    }
  }
}

TEST(Catalogue, HasEveryIdOnceInEachForm) {
  std::set<std::string_view> two_forms;
  for (const Form form : effects::all_the_forms) {
    std::set<std::string_view> ids;
    for (const Description& d : effects::catalogue(form)) {
      SCOPED_TRACE(std::string(d.id));
      EXPECT_TRUE(ids.insert(d.id).second);
      EXPECT_EQ(effects::find(d.id, form), &d);
      for (const Form other_form : effects::all_the_forms) {
        const Description* const other = effects::find(d.id, other_form);
        ASSERT_NE(other, nullptr);
        // One that belongs nowhere there stands as its first form.
        if (d.parameters.data() == other->parameters.data() || !d.belongs_to(form) ||
            !other->belongs_to(other_form))
          continue;
        EXPECT_TRUE(d.moves(form));
        EXPECT_FALSE(other->belongs_to(form));
        two_forms.insert(d.id);
      }
    }
  }
  EXPECT_EQ(two_forms, (std::set<std::string_view>{"centrifugal-ring-growth", "thermal-preload",
                                                   "thermal-ring-growth"}));
}

TEST(Catalogue, SaysWhatMovesAShaft) {
  std::set<std::string_view> moving, friction;
  for (const Description& d : effects::catalogue(Form::shaft)) {
    if (d.moves(Form::shaft)) moving.insert(d.id);
    if (!d.moves(Form::shaft) && d.belongs_to(Form::shaft)) friction.insert(d.id);
  }
  EXPECT_EQ(moving, (std::set<std::string_view>{
                        "centrifugal-ring-growth", "thermal-ring-growth", "thermal-preload",
                        "preload-calibration", "shaft-contraction", "interference-fit", "mounting",
                        "ball-material", "displacement-offset", "displacement-temperature-drift"}));
  for (const auto* id : {"spin-friction", "viscous-exponent", "film-self-heating", "misalignment"})
    EXPECT_EQ(friction.count(id), 1u) << id;
  EXPECT_FALSE(effects::find("load-offset", Form::shaft)->belongs_to(Form::shaft));
  // Of the torque of its sets all but a displacement sensor.
  for (const auto* id : {"torque-offset", "torque-gain", "temperature-offset", "seal-friction",
                         "misalignment", "preload-calibration"}) {
    const Description* const d = effects::find(id, Form::shaft);
    EXPECT_TRUE(d->moves(Form::shaft, record::friction_torque)) << id;
  }
  EXPECT_FALSE(effects::find("displacement-offset", Form::shaft)
                   ->moves(Form::shaft, record::friction_torque));
  EXPECT_FALSE(effects::find("shaft-contraction")->belongs_to(Form::rig));
}

TEST(Catalogue, SaysWhatMovesASpindle) {
  std::set<std::string_view> alone, others;
  for (const Description& d : effects::catalogue(Form::spindle)) {
    SCOPED_TRACE(std::string(d.id));
    EXPECT_EQ(d.moves(Form::spindle), d.belongs_to(Form::spindle));
    if (d.moves(Form::spindle)) (d.of_spindles_alone() ? alone : others).insert(d.id);
    // Heat of friction moves all of a spindle.
    EXPECT_TRUE(d.moves(Form::spindle) || !(d.has_moment() || d.lubricant));
    // Of what was entered for a rig a spindle has the oil card alone.
    const bool of_a_rig = d.entry && d.id != "viscosity-slope";
    EXPECT_FALSE(d.moves(Form::spindle) && (d.reads(record::friction_torque) || of_a_rig));
    // In its sets an effect has the form of a shaft.
    if (!d.condition || !d.moves(Form::spindle)) continue;
    EXPECT_EQ(d.parameters.data(), effects::find(d.id, Form::shaft)->parameters.data());
  }
  EXPECT_EQ(alone,
            (std::set<std::string_view>{
                "coolant", "seat-conductance", "motor-heat", "drive-heat", "convection-factor",
                "bearing-conductance", "preload-growth", "structure-temperature",
                "flange-conductance", "seal-heat", "front-bearing-heat", "rear-bearing-heat"}));
  for (const char* id : {"spin-friction", "windage", "mounting", "displacement-offset",
                         "centrifugal-ring-growth", "shaft-contraction"})
    EXPECT_EQ(others.count(id), 1u) << id;
  // Its temperatures do that, or nobody reads it there.
  for (const char* id : {"thermal-preload", "thermal-ring-growth", "torque-offset", "torque-gain",
                         "load-offset", "rig-viscous-drag", "lubricant-viscosity"})
    EXPECT_FALSE(effects::find(id, Form::spindle)->belongs_to(Form::spindle)) << id;
  for (const auto id : alone)
    for (const Form form : {Form::rig, Form::shaft})
      EXPECT_FALSE(effects::find(id, form)->belongs_to(form)) << id;
}

TEST(Catalogue, SaysWithWhichSupplyAnEffectCanBeAtWork) {
  using friction::Supply;
  const std::map<std::string_view, std::set<Supply>> wanted{
      {"churning", {Supply::bath}},
      {"grease-churning", {Supply::grease}},
      {"lubricant-drag", {Supply::jet, Supply::bath}},
      {"replenishment-starvation", {Supply::oil_air, Supply::grease, Supply::jet}}};
  for (const Description& d : effects::all_forms()) {
    SCOPED_TRACE(std::string(d.id));
    EXPECT_TRUE(d.works_with(std::nullopt));
    const auto limited = wanted.find(d.id);
    for (const auto supply : {Supply::oil_air, Supply::grease, Supply::jet, Supply::bath})
      EXPECT_EQ(d.works_with(supply), limited == wanted.end() || limited->second.count(supply) > 0)
          << friction::name(supply);
  }
  EXPECT_EQ(effects::text(effects::find("lubricant-drag")->supplies), "an oil jet or an oil bath");
  EXPECT_EQ(effects::text(effects::find("replenishment-starvation")->supplies),
            "oil-air, grease or an oil jet");
}

TEST(Catalogue, MarksWhatNobodyShouldKnowByItsId) {
  std::set<std::string_view> base_law, spin;
  for (const Description& d : effects::all_forms()) {
    if (d.base_law) base_law.insert(d.id);
    if (d.spin) spin.insert(d.id);
  }
  EXPECT_EQ(base_law, (std::set<std::string_view>{"viscous-exponent", "load-exponent"}));
  EXPECT_EQ(spin, (std::set<std::string_view>{"spin-friction"}));
}

TEST(Catalogue, NeutralValuesChangeNothing) {
  for (const Description& d : torque_effects()) {
    SCOPED_TRACE(std::string(d.id));
    const model::Model with = model_with(d, effects::neutral_values(d));
    model::Model without = with;
    without.effects.pop_back();
    for (const fit::Row& row : full_plan().rows) {
      const double plain = reading(without, row);
      EXPECT_NEAR(reading(with, row), plain, 1e-13 * plain);
    }
  }
}

TEST(Catalogue, IsFiniteWithinBoundsAndTakesPowerWhereItIsFriction) {
  const fit::DataSet plan = full_plan();
  for (const Description& d : torque_effects()) {
    SCOPED_TRACE(std::string(d.id));
    for (std::size_t k = 0; k < d.parameters.size(); ++k) {
      const effects::Parameter& p = d.parameters[k];
      for (const double value : {p.lower, p.plausible_lower, p.plausible_upper, p.upper}) {
        std::vector<double> values = effects::initial_values(d);
        values[k] = value;
        const model::Model model = model_with(d, values);
        for (const fit::Row& row : plan.rows) {
          const model::FrictionPrediction f = predicted(model, row);
          EXPECT_TRUE(std::isfinite(f.reading))
              << p.name << " = " << value << " at " << row.point.speed / rpm << " rpm, "
              << row.point.axial_load << " N: " << bearing::name(f.report.status);
          EXPECT_GE(f.load, 0.0);
          EXPECT_GE(f.viscous, 0.0);
          // Exponents correct a moment and may lower it; every other moment is friction.
          if (d.has_moment() && !d.base_law) {
            EXPECT_GE(f.effects.back(), 0.0);
          }
          EXPECT_TRUE(d.reading || f.torque >= 0.0);
        }
      }
    }
  }
}

TEST(Catalogue, IsSmooth) {
  // A kink would show as a difference quotient that changes with its step.
  const fit::DataSet plan = full_plan();
  for (const Description& d : torque_effects())
    for (std::size_t k = 0; k < d.parameters.size(); ++k) {
      if (d.id == "interference-fit") continue;  // comes loose at a speed: a kink by its source
      const effects::Parameter& p = d.parameters[k];
      SCOPED_TRACE(std::string(d.id) + "." + std::string(p.name));
      const auto [lower, upper] = usual_range(p);
      const double centre = lower + 0.37 * (upper - lower), h = 1e-3 * (upper - lower);
      for (std::size_t i = 0; i < plan.rows.size(); i += 7) {
        const auto slope = [&](double step) {
          std::vector<double> values = effects::initial_values(d);
          values[k] = centre + step;
          const double above = reading(model_with(d, values), plan.rows[i]);
          values[k] = centre - step;
          return (above - reading(model_with(d, values), plan.rows[i])) / (2.0 * step);
        };
        const double coarse = slope(h), fine = slope(0.5 * h);
        const double size = reading(fit::synthetic_model(), plan.rows[i]) / (upper - lower);
        EXPECT_NEAR(coarse, fine, 1e-4 * std::abs(fine) + 1e-6 * size);
      }
    }
}

TEST(Catalogue, SizeMovesTheTorqueOneWay) {
  const std::set<std::string_view> lowers{"load-calibration", "film-self-heating",
                                          "inlet-shear-heating", "replenishment-starvation",
                                          "shear-thinning"};
  // Lighter balls lower the spin, stiffer ones the contact area, but the angle changes too; a
  // smaller contact angle raises ball loads and lowers spin; the exponents turn at their reference,
  // the slope of an oil at 40 C.
  const std::set<std::string_view> either{"ball-material",
                                          "interference-fit",
                                          "misalignment",
                                          "thermal-ring-growth",
                                          "viscous-exponent",
                                          "load-exponent",
                                          "torque-temperature-drift",
                                          "viscosity-slope"};
  const fit::DataSet plan = full_plan();
  for (const Description& d : torque_effects()) {
    if (either.count(d.id) > 0) continue;
    SCOPED_TRACE(std::string(d.id));
    const auto [lower, upper] = usual_range(d.parameters[0]);
    const double sign = lowers.count(d.id) > 0 ? -1.0 : 1.0;
    for (const fit::Row& row : plan.rows) {
      double last = -INFINITY;
      for (int step = 0; step <= 4; ++step) {
        std::vector<double> values = effects::initial_values(d);
        values[0] = lower + 0.25 * step * (upper - lower);
        const double now = sign * reading(model_with(d, values), row);
        EXPECT_GE(now, last - 1e-13 * std::abs(now));
        last = now;
      }
    }
  }
}

/// d ln M/d ln x of an added moment, by a factor 1.01 on speed, load or viscosity.
double exponent(const char* id, char of, bearing::OperatingPoint point) {
  const Description& d = *effects::find(id);
  const model::Model model = model_with(d, effects::initial_values(d));
  const auto moment = [&](const bearing::OperatingPoint& p) {
    const model::FrictionPrediction f = model::predict_friction(model, p);
    return d.reading ? f.reading - f.torque : f.effects.back();
  };
  const double before = moment(point);
  double change = std::log(1.01);
  if (of == 'n') point.speed *= 1.01;
  if (of == 'F') point.axial_load *= 1.01;
  if (of == 'v') {
    point.temperature += 0.3;
    change = std::log(model.lubricant.kinematic_viscosity(point.temperature) /
                      model.lubricant.kinematic_viscosity(point.temperature - 0.3));
  }
  return std::log(moment(point) / before) / change;
}

TEST(Catalogue, MomentsFollowSpeedLoadAndViscosityAsTheirSourcesSay) {
  const bearing::OperatingPoint p{.speed = 8000 * rpm, .axial_load = 600};
  struct Case {
    const char* id;
    double speed, viscosity;
  };
  for (const Case& c :
       {Case{"lubricant-drag", 2, 0}, Case{"windage", 1.8, 0}, Case{"churning", 0.621, 1.379},
        Case{"cage-friction", 1, 1}, Case{"rig-viscous-drag", 1, 0}}) {
    SCOPED_TRACE(c.id);
    EXPECT_NEAR(exponent(c.id, 'n', p), c.speed, 1e-9);
    EXPECT_NEAR(exponent(c.id, 'F', p), 0.0, 1e-9);
    EXPECT_NEAR(exponent(c.id, 'v', p), c.viscosity, 1e-9);
  }
  // At low speed ball loads are in proportion to the axial load, nearly: the angle opens a little.
  const bearing::OperatingPoint slow{.speed = 100 * rpm, .axial_load = 50};
  EXPECT_NEAR(exponent("differential-slip", 'F', slow), 5.0 / 3.0, 0.02);
  EXPECT_NEAR(exponent("elastic-hysteresis", 'F', slow), 1.33, 0.02);
  EXPECT_NEAR(exponent("mixed-lubrication", 'F', slow), 4.0 / 3.0, 1e-9);
  EXPECT_LT(exponent("mixed-lubrication", 'n', slow), 0.0);
  EXPECT_NEAR(exponent("gyroscopic-slip", 'n', slow), 2.0, 0.01);
  // Load opens the outer angle, and M_g goes with its sine.
  EXPECT_GT(exponent("gyroscopic-slip", 'F', p), 0.0);
  EXPECT_LT(exponent("gyroscopic-slip", 'F', p), 1.0);
  // Centrifugal force loads the outer race, most where the axial load is small.
  EXPECT_GT(exponent("elastic-hysteresis", 'n', {.speed = 15000 * rpm, .axial_load = 150}), 0.5);
  EXPECT_LT(exponent("elastic-hysteresis", 'n', {.speed = 1000 * rpm, .axial_load = 1000}), 0.05);
}

TEST(Catalogue, HasTheLimitsOfItsSources) {
  const bearing::OperatingPoint standstill{.speed = 0.0, .axial_load = 600};
  for (const char* id :
       {"lubricant-drag", "windage", "churning", "cage-friction", "gyroscopic-slip"}) {
    const Description& d = *effects::find(id);
    const auto f = model::predict_friction(model_with(d, effects::initial_values(d)), standstill);
    EXPECT_EQ(f.effects.back(), 0.0) << id;
  }
  // The SKF laws at strength 1 are the published factors.
  const bearing::OperatingPoint p{.speed = 12000 * rpm, .axial_load = 600};
  const model::Model plain = fit::synthetic_model();
  const auto& g = plain.bearing.geometry();
  const double bare = model::predict_friction(plain, p).viscous;
  const double viscosity = plain.lubricant.kinematic_viscosity(p.temperature);
  const auto left = [&](const char* id, double value) {
    return model::predict_friction(model_with(*effects::find(id), {value}), p).viscous / bare;
  };
  const friction::RingSize ring{g.bore, g.outer_diameter};
  EXPECT_NEAR(left("inlet-shear-heating", 1.0),
              friction::inlet_shear_factor(p.speed, viscosity, ring.mean_diameter()), 1e-14);
  EXPECT_NEAR(left("replenishment-starvation", 6e-8),
              friction::replenishment_factor(6e-8, p.speed, viscosity, ring, 4.4), 1e-14);
  // A film finds its temperature: R times its own power above the bulk.
  const model::Model heated = model_with(*effects::find("film-self-heating"), {20.0});
  const auto f = model::predict_friction(heated, p);
  const double rise = 20e-3 * f.viscous * p.speed;
  EXPECT_GT(rise, 1.0);
  EXPECT_NEAR(f.film.kinematic_viscosity, plain.lubricant.kinematic_viscosity(p.temperature + rise),
              1e-9 * viscosity);
  // Exponents are those of the law.
  model::Model y = plain;
  y.law_values[2] = 0.43;
  y.law_values[1] *= std::pow(200.0 / 43000.0, -0.1);
  EXPECT_NEAR(model::predict_friction(model_with(*effects::find("load-exponent"), {0.1}), p).torque,
              model::predict_friction(y, p).torque, 1e-14);
  model::Model one_load = model_with(*effects::find("load-exponent"), {0.1});
  one_load.f1_load = y.f1_load = friction::F1Load::F_b;
  y.law_values[1] = plain.law_values[1] * std::pow(1000.0 / 43000.0, -0.1);
  EXPECT_NEAR(model::predict_friction(one_load, p).torque, model::predict_friction(y, p).torque,
              1e-14);
}

/// 18 balls of 12.7 mm on 90 mm, 25 deg, grooves of 0.525 and 0.515.
bearing::BearingGeometry hysteresis_geometry() {
  return {.ball_count = 18,
          .ball_diameter = 12.7 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = 25 * degree,
          .inner_conformity = 0.525,
          .outer_conformity = 0.515,
          .static_load_rating = 43000};
}

TEST(ElasticHysteresis, TakesTheRatioOfRadiiOfTheCurvatures) {
  const double D = 12.7 * mm, d_m = 90 * mm, cosine = std::cos(25 * degree);
  const double inner_along = 2.0 / D + 2.0 * cosine / (d_m - D * cosine);
  const double outer_along = 2.0 / D - 2.0 * cosine / (d_m + D * cosine);
  const double inner = inner_along / (2.0 / D - 1.0 / (0.525 * D));
  const double outer = outer_along / (2.0 / D - 1.0 / (0.515 * D));
  const bearing::BearingGeometry g = hysteresis_geometry();
  EXPECT_NEAR(effects::radius_ratio(g, bearing::Race::inner), inner, 1e-13 * inner);
  EXPECT_NEAR(effects::radius_ratio(g, bearing::Race::outer), outer, 1e-13 * outer);
  // By a calculation apart from this code, to its last digits: 100 N on steel.
  const double steel = 0.5 * 208e9 / (1.0 - 0.3 * 0.3);
  EXPECT_NEAR(effects::hysteresis_moment(D, 100.0, 24.079533980757457, steel),
              6.154265542464125e-05, 1e-18);
  EXPECT_NEAR(effects::hysteresis_moment(D, 100.0, 30.440318049358993, steel),
              6.092524629653452e-05, 1e-18);
}

TEST(ElasticHysteresis, OfABearingIsThatOfItsContactsByThePowerOfRolling) {
  // Slow, under thrust: both races at one angle, so that a ball rolls with (1 ± g)/2 d_m/D of the
  // shaft, g = D cos a/d_m. Silicon nitride makes the same loads press a narrower contact.
  for (const bool hybrid : {false, true}) {
    const bearing::Material balls = hybrid ? bearing::silicon_nitride() : bearing::steel();
    model::Model model = fit::synthetic_model();
    model.bearing = bearing::Bearing(hysteresis_geometry(), balls, bearing::steel());
    model.effects.push_back({effects::find("elastic-hysteresis"), {1.0}, nullptr});
    const auto f =
        model::predict_friction(model, {.speed = 1 * rpm, .axial_load = 18 * 50.0}, true);
    const bearing::BallEquilibrium ball = f.equilibrium->balls[0];
    const double angle = ball.inner_contact_angle, g = 12.7 / 90.0 * std::cos(angle);
    const double load = 50.0 / std::sin(angle);
    const double by_load = std::pow(load / 100.0, 1.33);
    const double expected =
        18.0 * by_load * 90.0 / 12.7 * 0.5 *
        (6.154265542464125e-05 * (1.0 + g) + 6.092524629653452e-05 * (1.0 - g)) *
        (hybrid ? 0.9449377768475252 : 1.0);
    EXPECT_NEAR(f.effects.back(), expected, 1e-6 * expected);  // centrifugal force at 1 rpm
  }
}

TEST(ElasticHysteresis, EndsWhereItsApproximationEnds) {
  const double steel = 0.5 * 208e9 / (1.0 - 0.3 * 0.3);
  // As wide as it is long, the contact of two spheres: nothing is taken off.
  const double round = 7.48e-7 * std::pow(5e-3, 0.33) * std::pow(80.0, 1.33);
  EXPECT_NEAR(effects::hysteresis_moment(10 * mm, 80.0, 1.0, steel), round, 1e-15 * round);
  // The closest groove that a model may have has a ratio beyond 1000, where the bracket is spent.
  bearing::BearingGeometry close = hysteresis_geometry();
  close.inner_conformity = 0.5005;
  const double ratio = effects::radius_ratio(close, bearing::Race::inner);
  EXPECT_GT(ratio, 1105.2);
  EXPECT_EQ(effects::hysteresis_moment(10 * mm, 80.0, ratio, steel), 0.0);
  EXPECT_GT(effects::hysteresis_moment(10 * mm, 80.0, 1105.0, steel), 0.0);
  EXPECT_EQ(effects::hysteresis_moment(10 * mm, 0.0, 25.0, steel), 0.0);
}

/// Viscosity of the film that a model with this correction predicts [mm2/s].
double viscosity_with(const char* id, double value, double temperature) {
  const bearing::OperatingPoint p{
      .speed = 5000 * rpm, .axial_load = 400, .temperature = kelvin(temperature)};
  return model::predict_friction(model_with(*effects::find(id), {value}), p)
             .film.kinematic_viscosity /
         mm2_per_s;
}

TEST(WrongData, CorrectsWhatWasEnteredBeforeAnythingActs) {
  const friction::Lubricant& oil = fit::synthetic_model().lubricant;
  const auto at = [](const friction::Lubricant& o, double temperature) {
    return o.kinematic_viscosity(kelvin(temperature)) / mm2_per_s;
  };
  // An oil with these values on its card.
  const friction::Lubricant thick(1.4 * oil.viscosity_40C(), 1.4 * oil.viscosity_100C());
  const friction::Lubricant steep(oil.viscosity_40C(), 0.9 * oil.viscosity_100C());
  for (const double t : {25.0, 40.0, 70.0}) {
    EXPECT_NEAR(viscosity_with("lubricant-viscosity", 1.4, t), at(thick, t), 1e-12 * at(thick, t));
    EXPECT_NEAR(viscosity_with("viscosity-slope", 0.9, t), at(steep, t), 1e-12 * at(steep, t));
  }
  // A sensor that reads 5 K too little: the film is 5 K warmer.
  EXPECT_NEAR(viscosity_with("temperature-offset", -5.0, 40.0), at(oil, 45.0), 1e-12);
  // One that sees 60 % of a rise above 20 C: of 30 K in the film it shows 18.
  EXPECT_NEAR(viscosity_with("temperature-gain", 0.6, 38.0), at(oil, 50.0), 1e-12);
  EXPECT_NEAR(viscosity_with("temperature-gain", 0.6, 20.0), at(oil, 20.0), 1e-12);
}

TEST(GyroscopicSlip, SaysThatItIsEmpirical) {
  const Description& d = *effects::find("gyroscopic-slip");
  EXPECT_NE(d.title.find("empirical"), std::string_view::npos);
  EXPECT_NE(d.mechanism.find("does not brake the shaft"), std::string_view::npos);
  EXPECT_NE(d.source.find("without a source"), std::string_view::npos);
}

TEST(Catalogue, ConditionsGoThroughTheEquilibrium) {
  const bearing::OperatingPoint p{.speed = 12000 * rpm, .axial_load = 600};
  const auto with = [&](const char* id, double value) {
    return model::predict_friction(model_with(*effects::find(id), {value}), p, true);
  };
  const auto plain = model::predict_friction(fit::synthetic_model(), p, true);
  const auto& ball = plain.equilibrium->balls[0];
  // 100 N more are 100 N more for the solver.
  const auto more = with("load-offset", 100.0);
  bearing::OperatingPoint loaded = p;
  loaded.axial_load += 100.0;
  const auto direct = model::predict_friction(fit::synthetic_model(), loaded, true);
  EXPECT_NEAR(more.equilibrium->balls[0].inner_load, direct.equilibrium->balls[0].inner_load, 1e-6);
  EXPECT_NEAR(more.torque, direct.torque, 1e-12);
  // A load cell that reads 6/7 of the load.
  EXPECT_NEAR(with("load-calibration", 6.0 / 7.0).torque, direct.torque, 1e-12);
  EXPECT_EQ(
      model::correction_text(fit::synthetic_model(),
                             {.description = effects::find("load-calibration"), .values = {0.8}}),
      "the true axial loads are 1.25 times the recorded loads");
  // A preload of 900 N on springs: 900 N and 1500 N. z counts the sum of both load moments as that
  // of one bearing.
  const auto load_moment = [&](double load) {
    bearing::OperatingPoint alone = p;
    alone.axial_load = load;
    return model::predict_friction(fit::synthetic_model(), alone).load;
  };
  const auto pair_of = [&](double preload, double mounting) {
    return model::predict_friction(model_with(*effects::find("set-preload"), {preload, mounting}),
                                   p)
        .load;
  };
  EXPECT_NEAR(pair_of(900.0, 0.0), load_moment(900.0) + load_moment(1500.0),
              0.005 * pair_of(900.0, 0.0));
  EXPECT_EQ(pair_of(150.0, 1.0), plain.load);  // 600 N have lifted the other off
  // A rigid pair: the load relieves the second bearing, and the speed presses both.
  EXPECT_LT(pair_of(900.0, 1.0), pair_of(900.0, 0.0));
  EXPECT_GT(pair_of(900.0, 2.0), pair_of(900.0, 1.0));
  // The cell is right at 20 C, and 0.4 % per kelvin off from there.
  EXPECT_NEAR(with("load-cell-drift", 100.0 / 600.0 / 0.2).torque, direct.torque, 1e-12);
  EXPECT_EQ(
      model::correction_text(fit::synthetic_model(),
                             {.description = effects::find("load-cell-drift"), .values = {0.4}}),
      "the real load changes by +0.4 % per kelvin relative to the recorded load");
  // Ceramic balls press less on the outer race.
  const auto ceramic = with("ball-material", 1.0);
  EXPECT_NEAR(ceramic.equilibrium->balls[0].centrifugal_force / ball.centrifugal_force,
              3200.0 / 7800.0, 0.05);
  EXPECT_EQ(ceramic.load, plain.load);  // the base law sees the entered load only
  // A wider inner ring lowers the contact angle and raises the load of the balls.
  const auto wide = with("interference-fit", 10.0);
  EXPECT_LT(wide.equilibrium->balls[0].inner_contact_angle, ball.inner_contact_angle);
  EXPECT_GT(wide.equilibrium->balls[0].inner_load, ball.inner_load);
  // A tilted ring loads its balls unevenly, at the tilt that was asked for.
  const auto tilted = with("misalignment", 0.5);
  EXPECT_NEAR(tilted.equilibrium->displacement[4], 0.5 * mrad, 1e-10);
  EXPECT_NEAR(tilted.equilibrium->displacement[3], 0.0, 1e-10);
  double least = INFINITY, most = 0.0;
  for (const auto& b : tilted.equilibrium->balls) {
    least = std::min(least, b.inner_load);
    most = std::max(most, b.inner_load);
  }
  EXPECT_GT(most, 1.1 * least);
}

TEST(Catalogue, OrderInTheModelChangesNothing) {
  const fit::DataSet plan = full_plan();
  model::Model model = fit::synthetic_model();
  model.rig.room_temperature = kelvin(20);
  for (const Description& d : effects::catalogue())
    if (d.moves(Form::rig) && d.id != "misalignment")
      model.effects.push_back({&d, effects::initial_values(d), nullptr});
  model::Model reversed = model;
  std::reverse(reversed.effects.begin(), reversed.effects.end());
  for (std::size_t i = 0; i < plan.rows.size(); i += 5) {
    const double a = reading(model, plan.rows[i]);
    EXPECT_NEAR(reading(reversed, plan.rows[i]), a, 1e-10 * a);
  }
}

TEST(Catalogue, IsRecoveredFromItsOwnData) {
  const std::map<std::string_view, std::string_view> skipped{
      {"speed-hysteresis", "the rows of this plan are in random order"},
      {"torque-gain", "acts like a common factor on f0 and z"},
      {"load-calibration", "acts like a factor on z in pure thrust"}};
  for (const Description& d : torque_effects()) {
    if (skipped.count(d.id) > 0) continue;
    SCOPED_TRACE(std::string(d.id));
    std::vector<double> truth;
    for (const auto& p : d.parameters) {
      const auto [lower, upper] = usual_range(p);
      truth.push_back(lower + 0.4 * (upper - lower));
    }
    fit::DataSet data = full_plan();
    std::mt19937 random(1);
    model::Model model = model_with(d, truth);
    fit::measure(model, 0.0, random, data);
    model::Model start = model_with(d, effects::initial_values(d));
    start.law_values = {2.0, 0.0008, 0.33};
    start.free = {"f0", "z"};
    for (const auto& p : d.parameters)
      start.free.push_back(std::string(d.id) + "." + std::string(p.name));
    const verdict::Calibration fit = fit::calibrate(start, data);
    ASSERT_TRUE(fit.converged()) << fit::name(fit.status);
    EXPECT_TRUE(fit.rows_not_predicted.empty());
    for (std::size_t k = 0; k < truth.size(); ++k)
      EXPECT_NEAR(fit::model_of(fit).effects.back().values[k], truth[k], 1e-4 * std::abs(truth[k]))
          << d.parameters[k].name;
    EXPECT_NEAR(fit::model_of(fit).law_values[0], 1.5, 1.5e-4);
  }
}

TEST(Catalogue, ALoadCalibrationIsRecoveredBesideARadialLoad) {
  const Description& d = *effects::find("load-calibration");
  fit::DataSet data = full_plan();
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    data.rows[i].point.radial_load = i % 2 == 0 ? 300.0 : 800.0;
  std::mt19937 random(1);
  fit::measure(model_with(d, {0.9}), 0.0, random, data);
  model::Model start = model_with(d, {1.0});
  start.free = {"f0", "z", "load-calibration.share_read"};
  const verdict::Calibration fit = fit::calibrate(start, data);
  ASSERT_TRUE(fit.converged()) << fit::name(fit.status);
  EXPECT_NEAR(fit::model_of(fit).effects.back().values[0], 0.9, 1e-4);
}

TEST(Catalogue, WithoutWhatItNeedsThereIsNoNumber) {
  const bearing::OperatingPoint p{.speed = 8000 * rpm, .axial_load = 600};
  for (const Description& d : torque_effects()) {
    const bool asks = has_need(d, Need::time) || has_need(d, Need::ring_temperatures);
    const auto f = model::predict_friction(model_with(d, effects::initial_values(d)), p);
    EXPECT_EQ(std::isfinite(f.reading), !asks) << d.id;
  }
}

}  // namespace
}  // namespace raceway

// What the effects of the catalogue do to the displacement of a shaft, by other ways to the same.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "model/changed_bearing.h"
#include "shaft/displacement_rows.h"
#include "shaft/shaft_prediction.h"
#include "shaft/shaft_subject.h"
#include "tests/shaft/shaft_records.h"
#include "tests/support/loop.h"

namespace raceway::fit {
namespace {

using bearing::Arrangement;
using bearing::ArrangementCondition;
using bearing::ArrangementDesign;
using bearing::Mounting;
using effects::Description;
using effects::Form;

/// Effects that move a shaft.
std::vector<const Description*> moving() {
  std::vector<const Description*> list;
  for (const Description& d : effects::catalogue(Form::shaft))
    if (d.moves(Form::shaft)) list.push_back(&d);
  return list;
}

Model with(const Description& d, std::vector<double> values) {
  return with_effect(two_against_one(), d.id, std::move(values));
}

Model with(std::string_view id, double value) {
  return with_effect(two_against_one(), id, {value});
}

Model changed(Model model, const std::function<void(ArrangementDesign&)>& change) {
  ArrangementDesign design = model.shaft->arrangement.design();
  change(design);
  model.shaft->arrangement = Arrangement(std::move(design));
  return model;
}

std::vector<double> displacement(const Model& model, const DataSet& data) {
  return predict_displacement(model, data);
}

/// A size that is met in practice.
std::vector<double> usual(const Description& d, double share = 0.4) {
  std::vector<double> values;
  for (const effects::Parameter& p : d.parameters)
    values.push_back(p.plausible_lower + share * (p.plausible_upper - p.plausible_lower));
  return values;
}

/// Of 10 000 rpm.
double square_of_speed(const Row& row) { return std::pow(row.point.speed / (10000 * rpm), 2); }

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "row " << i;
}

TEST(ShaftEffects, AtTheirNeutralValueChangeNothing) {
  const DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  const std::vector<double> plain = displacement(two_against_one(), plan);
  for (const Description* d : moving()) {
    SCOPED_TRACE(std::string(d->id));
    expect_same(displacement(with(*d, effects::neutral_values(*d)), plan), plain, 1e-15);
  }
}

/// Of that size; the other parameters as the catalogue starts them.
Model sized(const Description& d, double size) {
  std::vector<double> values = effects::initial_values(d);
  values[0] = size;
  return with(d, values);
}

TEST(ShaftEffects, AreFiniteWithinTheirUsualRangeAndSmooth) {
  const DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  for (const Description* d : moving()) {
    SCOPED_TRACE(std::string(d->id));
    const effects::Parameter& p = d->parameters[0];
    const double range = p.plausible_upper - p.plausible_lower;
    for (const double value : {p.plausible_lower, p.plausible_upper})
      for (const double u : displacement(sized(*d, value), plan)) EXPECT_TRUE(std::isfinite(u));
    if (d->id == "interference-fit") continue;  // comes loose at a speed: a kink by its source
    const auto slope = [&](double h) {
      const double centre = p.plausible_lower + 0.37 * range;
      const auto above = displacement(sized(*d, centre + h * range), plan);
      const auto below = displacement(sized(*d, centre - h * range), plan);
      std::vector<double> s;
      for (std::size_t i = 0; i < above.size(); ++i) s.push_back((above[i] - below[i]) / (2.0 * h));
      return s;
    };
    expect_same(slope(1e-3), slope(5e-4), 1e-4 * um);
  }
}

TEST(ShaftEffects, ThatAreFrictionMoveNothing) {
  const DataSet plan = shaft_plan(ShaftPlan::sweep);
  const std::vector<double> plain = displacement(two_against_one(), plan);
  for (const Description& d : effects::catalogue(Form::shaft)) {
    if (d.moves(Form::shaft) || !d.belongs_to(Form::shaft)) continue;
    SCOPED_TRACE(std::string(d.id));
    expect_same(displacement(with(d, usual(d)), plan), plain, 0.0);
  }
}

TEST(ShaftEffects, OfEqualRingsDoNotMoveASymmetricSet) {
  Model symmetric = changed(two_against_one(), [](ArrangementDesign& d) {
    d.front.pop_back();
    d.distance = 0.0;
  });
  const DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  for (const char* id : {"centrifugal-ring-growth", "thermal-preload", "thermal-ring-growth",
                         "interference-fit", "ball-material"}) {
    SCOPED_TRACE(id);
    const Description& d = *effects::find(id, Form::shaft);
    for (const double u : displacement(with_effect(symmetric, id, usual(d)), plan))
      EXPECT_NEAR(u, 0.0, 1e-14);
  }
}

TEST(ShaftEffects, ContractionGoesWithTheSquareOfSpeedAgainstTheTool) {
  const DataSet plan = shaft_plan(ShaftPlan::sweep);
  const auto plain = displacement(two_against_one(), plan);
  const auto shorter = displacement(with("shaft-contraction", 2.5), plan);
  for (std::size_t i = 0; i < plain.size(); ++i)
    EXPECT_NEAR(shorter[i] - plain[i], -2.5 * um * square_of_speed(plan.rows[i]), 1e-18);
}

TEST(ShaftEffects, OfTheTransducerAreTheirDefinition) {
  const DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  const auto plain = displacement(two_against_one(), plan);
  const auto offset = displacement(with("displacement-offset", -1.5), plan);
  const auto drift = displacement(
      with_effect(two_against_one(), "displacement-temperature-drift", {2.0, 25.0}), plan);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR(offset[i] - plain[i], -1.5 * um, 1e-18);
    EXPECT_NEAR(drift[i] - plain[i], 0.2 * um * (celsius(plan.rows[i].point.temperature) - 25.0),
                1e-17);
  }
}

TEST(ShaftEffects, RingGrowthIsAShiftOfTheGroovesWithTheSquareOfSpeed) {
  const Model model = with("centrifugal-ring-growth", 4.0);
  const DataSet plan = shaft_plan(ShaftPlan::sweep);
  const auto u = displacement(model, plan);
  for (const std::size_t i : {9u, 19u, 39u}) {
    ArrangementCondition condition{.speed = plan.rows[i].point.speed};
    condition.shifts.assign(3, {.radial = 4.0 * um * square_of_speed(plan.rows[i])});
    EXPECT_NEAR(u[i], solve_arrangement(model.shaft->arrangement, condition).position, 1e-13);
  }
  EXPECT_GT(std::abs(u[39] - displacement(two_against_one(), plan)[39]), 0.1 * um);
}

TEST(ShaftEffects, HeatGrowsTheRingsByTheBaseLawAtThePreload) {
  const Model model = with("thermal-preload", 0.02);
  DataSet plan = shaft_plan(ShaftPlan::sweep);
  plan.rows.resize(3);
  plan.rows[1].preload = 900;
  plan.rows[2].point.temperature = kelvin(30);
  for (Row& row : plan.rows) row.point.speed = 9000 * rpm;
  const auto u = displacement(model, plan);
  const Model bare = synthetic_model();
  for (std::size_t i = 0; i < 3; ++i) {
    const double preload = i == 1 ? 900.0 : 600.0;
    const auto growth = [&](double load) {
      const auto friction = predict_friction(
          bare,
          {.speed = 9000 * rpm, .axial_load = load, .temperature = plan.rows[i].point.temperature});
      return 0.02 * um * friction.torque * 9000 * rpm;
    };
    ArrangementCondition condition{.speed = 9000 * rpm};
    condition.shifts.assign(2, {.radial = growth(preload / 2)});
    condition.shifts.push_back({.radial = growth(preload)});
    const Model set = changed(two_against_one(), [&](ArrangementDesign& d) {
      d.preload = bearing::PreloadForce{preload};
    });
    EXPECT_NEAR(u[i], solve_arrangement(set.shaft->arrangement, condition).position, 1e-13);
  }
  EXPECT_NE(u[0], u[2]) << "a colder lubricant makes more heat";
}

TEST(ShaftEffects, RingTemperaturesCountOnce) {
  DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  const Model free = two_against_one();
  const double lambda = free.bearing.rings().thermal_expansion;
  // As much against the free radial expansion as the two rings differ.
  const double held = -lambda * free.bearing.geometry().inner_groove_centre_radius();
  const auto u = displacement(with("thermal-ring-growth", held / um), plan);
  const Row& row = plan.rows[14];
  ArrangementCondition condition{.speed = row.point.speed};
  add_expansion(free.shaft->arrangement,
                {.inner_ring = row.inner_ring_temperature,
                 .outer_ring = row.outer_ring_temperature,
                 .shaft = row.inner_ring_temperature,
                 .housing = row.outer_ring_temperature},
                condition);
  for (bearing::RingShift& s : condition.shifts)
    s.radial += held * (row.inner_ring_temperature - row.outer_ring_temperature);
  const Model set =
      changed(free, [&](ArrangementDesign& d) { d.preload = bearing::PreloadForce{row.preload}; });
  EXPECT_NEAR(u[14], solve_arrangement(set.shaft->arrangement, condition).position, 1e-13);
  EXPECT_LT(std::abs(condition.shifts[0].radial), 0.1 * um) << "nothing of it is left";
  // Without temperatures there is no number.
  EXPECT_TRUE(
      std::isnan(displacement(with("thermal-ring-growth", 0.1), shaft_plan(ShaftPlan::sweep))[0]));
}

TEST(ShaftEffects, OtherBallsAreThoseOfTheOtherCatalogueCard) {
  const DataSet plan = shaft_plan(ShaftPlan::two_preloads);
  Model ceramic = synthetic_model();
  ceramic.bearing =
      bearing::Bearing(ceramic.bearing.geometry(), bearing::silicon_nitride(), bearing::steel());
  const auto truth = displacement(two_against_one(ceramic), plan);
  expect_same(displacement(with("ball-material", 1.0), plan), truth, 1e-9 * truth.back());
  // And back again.
  expect_same(displacement(with_effect(two_against_one(ceramic), "ball-material", {1.0}), plan),
              displacement(two_against_one(), plan), 1e-9 * truth.back());
}

TEST(ShaftEffects, MountingGoesFromRigidToSpringAndBack) {
  const auto on_spring = [](double rate) {
    return changed(two_against_one(), [&](ArrangementDesign& d) {
      d.mounting = Mounting::spring;
      d.spring_rate = rate;
    });
  };
  const DataSet plan = shaft_plan(ShaftPlan::up_and_down);
  const auto rigid = displacement(two_against_one(), plan);
  const auto loose = displacement(on_spring(0.0), plan);
  expect_same(displacement(with("mounting", 1.0), plan), loose, 1e-13);
  expect_same(displacement(with_effect(on_spring(0.0), "mounting", {1.0}), plan), rigid, 1e-13);
  expect_same(displacement(with_effect(on_spring(50 * N_per_um), "mounting", {1.0}), plan), rigid,
              1e-13);
  EXPECT_TRUE(std::isnan(lift_off(mounted_arrangement(with("mounting", 1.0))).rear))
      << "a spring follows";
  // Half relieved is a spring as stiff as the rear set.
  const Arrangement half = changed(two_against_one(), [](ArrangementDesign& d) {
                             d.other_mounting = 0.5;
                           }).shaft->arrangement;
  const auto stiffness = [](const Arrangement& a) {
    return solve_arrangement(a, {}).axial_stiffness;
  };
  const double front = stiffness(on_spring(0.0).shaft->arrangement);
  const double rear = stiffness(two_against_one().shaft->arrangement) - front;
  EXPECT_NEAR(stiffness(half), front + 0.5 * rear, 1e-9 * rear);
  expect_same(displacement(with("mounting", 0.5), shaft_plan(ShaftPlan::sweep)),
              displacement(on_spring(rear), shaft_plan(ShaftPlan::sweep)), 1e-13);
  // The response is well behaved: between its ends and one way, fast and slow.
  double last = rigid[14];
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    const double now = displacement(with("mounting", share), plan)[14];
    EXPECT_GT(now, last);
    EXPECT_LT(now - last, 0.45 * (loose[14] - rigid[14]));
    last = now;
  }
  EXPECT_THROW((void)changed(on_spring(0.0),
                             [](ArrangementDesign& d) {
                               d.layout = bearing::Layout::tandem;
                               d.rear.clear();
                               d.other_mounting = 0.5;
                             }),
               std::invalid_argument);
}

TEST(ShaftEffects, AFitIsPartOfTheMountedShaft) {
  const Model fitted = with("interference-fit", 8.0);
  const auto at = [](const Model& model, double speed) {
    const ShaftPoint point{.speed = speed};
    return predict_shaft(model, {&point, 1})[0];
  };
  // The force at standstill is the entered one, and nothing has moved.
  EXPECT_NEAR(at(fitted, 0.0).displacement, 0.0, 1e-15);
  EXPECT_NEAR(at(fitted, 0.0).equilibrium.front_force, 600.0, 1e-6);
  // At speed the balls stand as in a bearing of smaller angle, less what the ring has loosened.
  const Model alone = with_effect(synthetic_model(), "interference-fit", {8.0});
  const auto growth = [&](double speed) {
    return predict_friction(alone, {.speed = speed, .axial_load = 300}).condition.radial_growth;
  };
  Model narrow = synthetic_model();
  narrow.bearing = *changed_bearing(narrow.bearing, {.radial_growth = growth(0.0)});
  narrow = two_against_one(narrow);
  ArrangementCondition condition{.speed = 9000 * rpm};
  condition.shifts.assign(3, {.radial = growth(9000 * rpm) - growth(0.0)});
  EXPECT_LT(condition.shifts[0].radial, -0.1 * um);
  EXPECT_NEAR(at(fitted, 9000 * rpm).displacement,
              solve_arrangement(narrow.shaft->arrangement, condition).position, 1e-13);
  // Ground into free bearings, the gap is closed further by the fit: by how far the grooves of the
  // narrowed rings stand back, at both ends.
  const auto of_gap = [](const Model& model, double offset) {
    return changed(model,
                   [&](ArrangementDesign& d) { d.preload = bearing::PreloadOffset{offset}; });
  };
  const auto axial = [](const bearing::Bearing& b) {
    return b.geometry().groove_centre_distance() * std::sin(b.geometry().contact_angle);
  };
  const double closed = 2.0 * (axial(fitted.bearing) - axial(narrow.bearing));
  EXPECT_NEAR(at(of_gap(fitted, 10 * um), 0.0).equilibrium.front_force,
              of_gap(narrow, 10 * um + closed).shaft->arrangement.preload(), 1e-6);
  EXPECT_NEAR(mounted_arrangement(of_gap(fitted, 10 * um)).preload(),
              at(of_gap(fitted, 10 * um), 0.0).equilibrium.front_force, 1e-6);
  EXPECT_GT(at(of_gap(fitted, 10 * um), 0.0).equilibrium.front_force,
            1.2 * of_gap(two_against_one(), 10 * um).shaft->arrangement.preload());
}

TEST(ShaftEffects, FrictionIsThatOfTheBallsInTheSets) {
  const Model model = with_effect(with("thermal-preload", 0.02), "spin-friction", {0.06});
  const ShaftPoint point{.speed = 9000 * rpm};
  const ShaftPrediction p = predict_shaft(model, {&point, 1})[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const bearing::BallEquilibrium& set = p.equilibrium.bearings[i].ball;
    EXPECT_EQ(p.friction[i].equilibrium->balls[0].inner_contact_angle, set.inner_contact_angle);
    EXPECT_EQ(p.friction[i].equilibrium->balls[0].inner_load, set.inner_load);
  }
}

TEST(ShaftSubject, DoesNotDependOnWhatWasAskedBefore) {
  Model model = two_against_one();
  for (const Description* d : moving()) model = with_effect(model, d->id, usual(*d));
  const Record data = shaft_plan(ShaftPlan::up_and_down);
  std::vector<std::string> names{"contact_angle_deg", "conformity"};
  for (const Description* d : moving())
    names.push_back(std::string(d->id) + "." + std::string(d->parameters[0].name));
  const ShaftSubject subject(model);
  const std::vector<Parameter> parameters = find_parameters(subject, names);
  std::vector<double> x, remembered(data.rows());
  for (const Parameter& p : parameters) x.push_back(p.start);
  const auto predictor = subject.predictor(data, names, nullptr);
  for (std::size_t k = 0; k <= x.size(); ++k) {
    if (k > 0) x[k - 1] *= 1.03;
    predictor->readings(x, remembered);
    Model fresh = model;
    for (std::size_t j = 0; j < x.size(); ++j) set(fresh, parameters[j], x[j]);
    expect_same(remembered, predict_displacement(fresh, data), 1e-13);
  }
  // No arrangement has this angle.
  x[0] = 2.0;
  predictor->readings(x, remembered);
  EXPECT_THAT(remembered, testing::Each(testing::IsNan()));
  x[0] = 25.0;
  predictor->readings(x, remembered);
  EXPECT_THAT(remembered, testing::Each(testing::Not(testing::IsNan())));
}

TEST(ShaftSubject, FindsEveryEffectInItsOwnRecords) {
  for (const Description* d : moving()) {
    SCOPED_TRACE(std::string(d->id));
    const std::vector<double> truth = usual(*d);
    const DataSet data = shaft_records(with(*d, truth), ShaftPlan::up_and_down);
    Model start = with(*d, truth);
    const std::string name = std::string(d->id) + "." + std::string(d->parameters[0].name);
    start.free = {"contact_angle_deg", name};
    start.effects.back().values[0] = 0.5 * (truth[0] + effects::initial_values(*d)[0]);
    const verdict::Calibration c = calibrate(start, data);
    ASSERT_TRUE(c.converged()) << fit::name(c.status);
    EXPECT_TRUE(c.rows_not_predicted.empty());
    EXPECT_NEAR(c.parameters[1].value, truth[0], 1e-3 * std::abs(truth[0]));
    EXPECT_NEAR(c.parameters[0].value, 25.0, 1e-2);
  }
}

TEST(ShaftRecords, HaveTheNoiseThatWasAskedFor) {
  const Model model = two_against_one();
  const DataSet quiet = shaft_records(model, ShaftPlan::two_preloads);
  double square = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const DataSet data = shaft_records(model, ShaftPlan::two_preloads, 0.05 * um, 0.02, seed);
    for (std::size_t i = 0; i < data.rows.size(); ++i) {
      const double u = quiet.rows[i].measured;
      EXPECT_NEAR(data.rows[i].std, std::hypot(0.05 * um, 0.02 * u), 1e-18);
      square += std::pow((data.rows[i].measured - u) / data.rows[i].std, 2);
      ++count;
    }
  }
  EXPECT_NEAR(square / count, 1.0, 0.15);  // 1200 values: 4 standard deviations are 0.16
  EXPECT_EQ(shaft_records(model, ShaftPlan::sweep, 0.05 * um, 0.02, 3).rows[7].measured,
            shaft_records(model, ShaftPlan::sweep, 0.05 * um, 0.02, 3).rows[7].measured);
}

}  // namespace
}  // namespace raceway::fit

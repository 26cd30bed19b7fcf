#include "spindle/warm_sets.h"

#include "bearing/arrangement_equilibrium.h"
#include "tests/spindle/base_spindle.h"
#include "tests/spindle/case_bearing.h"
#include "tests/spindle/reference_cases.h"

namespace raceway::spindle {
namespace {

/// The sets of a case on the base spindle.
model::Model model_of(const ReferenceCase& c) {
  bearing::ArrangementDesign design;
  const auto bearing = case_bearing(c.inputs.at("bearing"));
  if (c.inputs.value("layout", "O") == "X") design.layout = bearing::Layout::face_to_face;
  design.front.assign(c.inputs.at("front"), {bearing});
  design.rear.assign(c.inputs.at("rear"), {bearing});
  design.preload = bearing::PreloadForce{c.in("preload_N")};
  design.distance = c.in("distance_mm", 215.0) * mm;
  design.shaft_expansion = design.housing_expansion = c.in("alpha");
  design.mounting_temperature = kelvin(c.in("mounting_C"));
  model::Model model = base_spindle();
  model.bearing = *bearing;
  model.shaft = model::Shaft{.arrangement = bearing::Arrangement(design)};
  return model;
}

// What the spindle feels of its rings, and what `raceway displacement` makes of one temperature for
// all.
TEST(WarmSets, OfOneTemperatureAreThoseOfTheReference) {
  for (const ReferenceCase& c : reference_cases("set_warm_")) {
    const model::Model model = model_of(c);
    const bearing::Arrangement& arrangement = model.shaft->arrangement;
    const std::size_t bearings = arrangement.bearings().size();
    WarmSets sets(model, {});
    ASSERT_TRUE(sets.set_inputs({.speed = c.in("rpm") * rpm}));
    ASSERT_TRUE(sets.solve({.inner_ring = std::vector<double>(bearings, kelvin(c.in("Ti_C"))),
                            .outer_ring = std::vector<double>(bearings, kelvin(c.in("To_C"))),
                            .elongation = c.in("alpha") * c.in("distance_mm") * mm *
                                          (c.in("shaft_C") - c.in("housing_C"))}));
    c.holds("x_um", (sets.sets().position - sets.rest()) / um);
    c.holds("front_N", sets.sets().front_force);
    c.holds("rear_N", sets.sets().rear_force);

    bearing::ArrangementCondition condition{.speed = c.in("rpm") * rpm};
    add_expansion(arrangement,
                  {.inner_ring = kelvin(c.in("Ti_C")),
                   .outer_ring = kelvin(c.in("To_C")),
                   .shaft = kelvin(c.in("shaft_C")),
                   .housing = kelvin(c.in("housing_C"))},
                  condition);
    const bearing::ArrangementEquilibrium one = solve_arrangement(arrangement, condition);
    ASSERT_TRUE(one.report.converged());
    c.holds("x_um", one.position / um);
    c.holds("front_N", one.front_force);
    c.holds("rear_N", one.rear_force);
  }
}

TEST(WarmSets, OfBearingsOfTheirOwnAreThoseOfTheReference) {
  for (const ReferenceCase& c : reference_cases("set_warm_each_")) {
    WarmSets sets(model_of(c), {});
    ASSERT_TRUE(sets.set_inputs({.speed = c.in("rpm") * rpm}));
    SetsAsked asked;
    asked.elongation = c.in("elongation_um") * um;
    for (const double t : numbers(c.inputs.at("Ti_C"))) asked.inner_ring.push_back(kelvin(t));
    for (const double t : numbers(c.inputs.at("To_C"))) asked.outer_ring.push_back(kelvin(t));
    ASSERT_TRUE(sets.solve(asked));
    c.holds("x_um", (sets.sets().position - sets.rest()) / um);
    const std::vector<double> forces = numbers(c.outputs.at("force_N"));
    ASSERT_EQ(forces.size(), sets.bearings());
    for (std::size_t k = 0; k < forces.size(); ++k)
      EXPECT_NEAR(sets.heat()[k].force, forces[k], c.tolerance * forces[k]) << c.id << ' ' << k;
  }
}

// A mean over bearings would have them all alike.
TEST(WarmSets, HeatFollowsTheTemperatureAndTheForceOfEachBearing) {
  const auto heat_at = [](std::vector<double> inner, std::vector<double> outer) {
    WarmSets sets(base_spindle(), {});
    EXPECT_TRUE(sets.set_inputs({.speed = 6000 * rpm}));
    EXPECT_TRUE(sets.solve({.inner_ring = std::move(inner), .outer_ring = std::move(outer)}));
    return std::vector<BearingHeat>(sets.heat().begin(), sets.heat().end());
  };
  const double warm = kelvin(30), hot = kelvin(36);
  const auto alike = heat_at({warm, warm, warm}, {warm, warm, warm});
  const auto second = heat_at({warm, hot, warm}, {warm, warm, warm});
  EXPECT_NEAR(alike[0].force, alike[1].force, 1e-6 * alike[0].force);
  // Hotter inside: the second one takes load from the first one beside it.
  EXPECT_GT(second[1].force, 1.2 * second[0].force);
  EXPECT_NEAR(second[0].force + second[1].force, second[2].force, 1e-6 * second[2].force);
  // Its oil alone thins.
  const auto thinner = heat_at({warm, kelvin(33), warm}, {warm, kelvin(33), warm});
  EXPECT_LT(thinner[1].power(), 0.97 * thinner[0].power());
}

}  // namespace
}  // namespace raceway::spindle

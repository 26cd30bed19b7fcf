#include <gtest/gtest.h>

#include <cmath>

#include "spindle/part_stress.h"
#include "spindle/press_fit.h"
#include "spindle/spindle.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

constexpr double wall_bore = 18 * mm, wall_surface = 35 * mm;
const model::SolidMaterial wall_steel = model::steel_of_shafts;

/// A wall whose temperature is a function of the radius, at `layers` + 1 places.
template <typename Temperature>
RoundPart heated_wall(int layers, const Temperature& at, double from = wall_bore,
                      double to = wall_surface) {
  RoundPart part{.material = wall_steel};
  for (int k = 0; k <= layers; ++k) {
    const double r = from + (to - from) * k / layers;
    part.profile.push_back({r, at(r)});
  }
  return part;
}

double through_a_wall(double r) {
  return kelvin(20) + 12.0 * std::log(wall_surface / r) / std::log(wall_surface / wall_bore);
}

/// ∫ σz r dr by Simpson's rule over pairs of layers.
double axial_resultant(const std::vector<Stress>& at) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 2 < at.size(); k += 2)
    sum += (at[k + 2].radius - at[k].radius) / 6.0 *
           (at[k].axial * at[k].radius + 4.0 * at[k + 1].axial * at[k + 1].radius +
            at[k + 2].axial * at[k + 2].radius);
  return sum;
}

TEST(PartStress, OfHeatThroughAWallIsTheClosedSolution) {
  // Timoshenko and Goodier: T = Ti ln(b/r)/ln(b/a) with free ends.
  const double nu = wall_steel.poissons_ratio, a = wall_bore, b = wall_surface, L = std::log(b / a);
  const double k =
      wall_steel.elastic_modulus * wall_steel.thermal_expansion * 12.0 / (2.0 * (1.0 - nu) * L);
  const double c = a * a / (b * b - a * a);
  for (const int layers : {1, 2, 7}) {
    for (const Stress& s : stresses_of(heated_wall(layers, through_a_wall))) {
      const double r = s.radius, l = std::log(b / r);
      EXPECT_NEAR(s.radial, k * (-l - c * (1.0 - b * b / (r * r)) * L), 1e-3);
      EXPECT_NEAR(s.hoop, k * (1.0 - l - c * (1.0 + b * b / (r * r)) * L), 1e-3);
      EXPECT_NEAR(s.axial, k * (1.0 - 2.0 * l - 2.0 * c * L), 1e-3);
    }
  }
}

TEST(PartStress, OfHeatThatArisesInTheWallConvergesByTheSquareOfTheLayers) {
  // T = -g r²: J(r) = -g (r⁴ - a⁴)/4.
  const double g = 2e4, a = wall_bore, b = wall_surface;
  const double k =
      wall_steel.elastic_modulus * wall_steel.thermal_expansion / (1.0 - wall_steel.poissons_ratio);
  const double mean = -0.5 * g * (b * b + a * a);
  const auto error = [&](int layers) {
    const auto at = stresses_of(heated_wall(layers, [&](double r) { return -g * r * r; }));
    const double hoop = k * (mean + g * a * a);  // of the bore
    const double axial = k * (mean + g * b * b);
    return std::hypot(at.front().hoop - hoop, at.back().axial - axial);
  };
  EXPECT_GT(error(4), 1e3);
  EXPECT_NEAR(error(4) / error(8), 4.0, 0.2);
  EXPECT_NEAR(error(8) / error(16), 4.0, 0.1);
}

TEST(PartStress, AnEvenTemperatureIsNone) {
  for (const double from : {0.0, wall_bore})
    for (const Stress& s : stresses_of(heated_wall(
             5, [](double) { return kelvin(80); }, from))) {
      EXPECT_EQ(s.radial, 0.0);
      EXPECT_EQ(s.hoop, 0.0);
      EXPECT_EQ(s.axial, 0.0);
      EXPECT_EQ(s.von_mises(), 0.0);
    }
}

TEST(PartStress, OfAPressFitIsLames) {
  RoundPart ring = heated_wall(4, [](double) { return 0.0; });
  ring.bore_pressure = 3 * MPa;
  const double a = wall_bore * wall_bore, b = wall_surface * wall_surface;
  const auto at = stresses_of(ring);
  EXPECT_NEAR(at.front().radial, -3 * MPa, 1e-6);
  EXPECT_NEAR(at.front().hoop, 3 * MPa * (b + a) / (b - a), 1e-6);
  EXPECT_NEAR(at.back().hoop, 3 * MPa * 2.0 * a / (b - a), 1e-6);
  EXPECT_NEAR(at.back().radial, 0.0, 1e-6);
  RoundPart shaft = heated_wall(
      4, [](double) { return 0.0; }, 0.0);
  shaft.surface_pressure = 3 * MPa;
  for (const Stress& s : stresses_of(shaft)) {
    EXPECT_NEAR(s.radial, -3 * MPa, 1e-6);
    EXPECT_NEAR(s.hoop, -3 * MPa, 1e-6);
    EXPECT_EQ(s.axial, 0.0);
  }
}

TEST(PartStress, OfALongTurningCylinderHasItsPublishedHoopAtTheBoreAndAtTheAxis) {
  // Free ends, plane sections: ρω²/(4 (1-ν)) ((3-2ν) b² + (1-2ν) a²) at the bore of a hollow
  // cylinder and ρω² b² (3-2ν)/(8 (1-ν)) on the axis of a full one.
  RoundPart part = heated_wall(4, [](double) { return 0.0; });
  part.speed = 15000 * rpm;
  const double nu = wall_steel.poissons_ratio, aa = wall_bore * wall_bore,
               bb = wall_surface * wall_surface;
  const double force = wall_steel.density * part.speed * part.speed / (1.0 - nu);
  const double bore = 0.25 * force * ((3.0 - 2.0 * nu) * bb + (1.0 - 2.0 * nu) * aa);
  EXPECT_NEAR(stresses_of(part).front().hoop, bore, 1e-9 * bore);
  RoundPart full = heated_wall(
      4, [](double) { return 0.0; }, 0.0);
  full.speed = part.speed;
  const Stress axis = stresses_of(full).front();
  const double middle = 0.125 * force * (3.0 - 2.0 * nu) * bb;
  EXPECT_NEAR(axis.hoop, middle, 1e-9 * middle);
  EXPECT_NEAR(axis.radial, middle, 1e-9 * middle);
}

TEST(PartStress, AllOfItHasNoAxialForceIsInBalanceAndGrowsAsThePressFitSays) {
  for (const double from : {0.0, 0.4 * wall_bore, wall_bore}) {
    RoundPart part = heated_wall(
        400, [](double r) { return kelvin(20) + 3e4 * r * r; }, from);
    part.bore_pressure = from > 0.0 ? 2 * MPa : 0.0;
    part.surface_pressure = 5 * MPa;
    part.speed = 15000 * rpm;
    const auto at = stresses_of(part);
    double largest = 0.0;
    for (const Stress& s : at) largest = std::max(largest, s.von_mises());
    EXPECT_NEAR(axial_resultant(at), 0.0, 1e-4 * largest * wall_surface * wall_surface);
    // dσr/dr = (σθ - σr)/r - ρ ω² r
    for (const std::size_t k : {std::size_t{40}, std::size_t{200}, std::size_t{360}}) {
      const double slope =
          (at[k + 1].radial - at[k - 1].radial) / (at[k + 1].radius - at[k - 1].radius);
      const double force = wall_steel.density * part.speed * part.speed * at[k].radius;
      EXPECT_NEAR(slope, (at[k].hoop - at[k].radial) / at[k].radius - force,
                  1e-3 * largest / wall_bore);
    }
    EXPECT_NEAR(at.back().radial, -5 * MPa, 1.0);
    const double strain =
        (at.back().hoop - wall_steel.poissons_ratio * (at.back().radial + at.back().axial)) /
            wall_steel.elastic_modulus +
        wall_steel.thermal_expansion * 3e4 * wall_surface * wall_surface;
    const double mean = 3e4 * 0.5 * (wall_surface * wall_surface + from * from);
    const double aa = from * from, bb = wall_surface * wall_surface;
    const double lame =
        (2.0 * part.bore_pressure * aa -
         part.surface_pressure * (aa + bb - wall_steel.poissons_ratio * (bb - aa))) /
        (bb - aa) / wall_steel.elastic_modulus;
    const double grown = growth_by_rotation(wall_steel, wall_surface, from, part.speed) +
                         wall_surface * (wall_steel.thermal_expansion * mean + lame);
    EXPECT_NEAR(strain * wall_surface, grown, 2e-5 * grown);
  }
}

TEST(PartStress, ARadiusThatDoesNotRiseIsRefused) {
  RoundPart part{.material = wall_steel, .profile = {{wall_surface, 0.0}, {wall_bore, 0.0}}};
  EXPECT_THROW(static_cast<void>(stresses_of(part)), std::invalid_argument);
  part.profile.resize(1);
  EXPECT_THROW(static_cast<void>(stresses_of(part)), std::invalid_argument);
}

std::vector<SectionStress> stresses_at(const model::Model& m, const Inputs& inputs) {
  Simulator simulator(m);
  Report report;
  static_cast<void>(simulator.steady(inputs, report));
  EXPECT_TRUE(report.converged()) << report.message;
  return simulator.stresses(inputs.speed);
}

const SectionStress& stress_section(const std::vector<SectionStress>& all, SectionStress::Part part,
                                    int bearing) {
  for (const SectionStress& s : all)
    if (s.part == part && s.bearing == bearing) return s;
  throw std::out_of_range("no such section");
}

using StressedPart = SectionStress::Part;

TEST(SpindleStress, AtRestAndColdOnlyTheFitsStrainShaftAndRings) {
  const model::Model m = base_spindle();
  model::Model cold = m;
  cold.spindle->coolant.reset();
  const auto all = stresses_at(cold, {});
  Simulator simulator(cold);
  Report report;
  static_cast<void>(simulator.steady({}, report));
  const double p = simulator.seats()[0].inner.pressure;
  ASSERT_GT(p, 0.5 * MPa);
  const Stress& bore_of_ring = stress_section(all, StressedPart::inner_ring, 0).at.front();
  EXPECT_NEAR(bore_of_ring.radial, -p, 1e-6 * p);
  EXPECT_NEAR(bore_of_ring.axial, 0.0, 1e-6 * p);
  EXPECT_NEAR(stress_section(all, StressedPart::shaft, 0).at.back().radial, -p, 1e-6 * p);
  for (const SectionStress& s : all)
    if (s.part == StressedPart::shaft && s.bearing < 0) {
      EXPECT_LT(s.largest().von_mises(), 1e-3 * p);
    }
}

TEST(SpindleStress, HeatThatFlowsThroughARingOfOneCellStrainsItAsItsGradientDoes) {
  model::Model m = base_spindle();
  m.spindle->cells = model::Cells::coarse;
  const auto all = stresses_at(m, {.speed = 6000 * rpm});
  const SectionStress& ring = stress_section(all, StressedPart::inner_ring, 0);
  ASSERT_EQ(ring.at.size(), 3U);
  // The raceway is warmer than the bore: it is pressed along the axis, the bore pulled.
  EXPECT_LT(ring.at.back().axial, -1 * MPa);
  EXPECT_GT(ring.at.front().axial, 1 * MPa);
}

TEST(SpindleStress, MoreCellsChangeTheLargestLittle) {
  double largest[2];
  for (const model::Cells cells : {model::Cells::medium, model::Cells::fine}) {
    model::Model m = base_spindle();
    m.spindle->cells = cells;
    double& most = largest[cells == model::Cells::fine ? 1 : 0] = 0.0;
    for (const SectionStress& s : stresses_at(m, {.speed = 6000 * rpm}))
      most = std::max(most, s.largest().von_mises());
  }
  EXPECT_NEAR(largest[0], largest[1], 0.05 * largest[1]);
}

}  // namespace
}  // namespace raceway::spindle

#include "friction/roller_friction.h"
#include "spindle/roller_clearance.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

// Friction warms the rings, which takes the clearance, which makes friction.
TEST(RollerReference, FrictionHeatClearanceAndLoadsAgreeInASteadyBearing) {
  const ReferenceCase c = reference_case("loop", "loop_into_preload");
  const bearing::RollerBearing b = steel_bearing(geometry(c));
  const friction::Lubricant oil(c.in("viscosity_40C_mm2_s") * mm2_per_s,
                                c.in("viscosity_100C_mm2_s") * mm2_per_s);
  model::SolidMaterial steel;
  steel.density = 7800;
  steel.thermal_expansion = 11.5 * per_million_K;
  steel.elastic_modulus = 208 * GPa;
  steel.poissons_ratio = 0.3;
  const spindle::RollerSeats seats{.shaft_bore = c.in("shaft_bore_mm") * mm,
                                   .inner_interference = c.in("inner_interference_um") * um,
                                   .shaft = steel};
  const double speed = c.in("speed_rpm") * rpm, load = c.in("radial_load_N");
  const double mounting = c.in("mounting_temperature_C"), ambient = c.in("ambient_temperature_C");
  const double to_room_inner = c.in("inner_to_ambient_W_K");
  const double to_room_outer = c.in("outer_to_ambient_W_K");
  double inner = ambient, outer = ambient, clearance = 0.0, conductance = 0.0, viscosity = 0.0;
  bearing::RollerEquilibrium e;
  friction::RollerState state;
  friction::BaseMoments<double> moments;
  friction::HeatSplit heat;
  for (int i = 0; i < 60; ++i) {
    clearance = spindle::operating_clearance(b, seats, speed,
                                             {.shaft = inner - mounting,
                                              .inner_ring = inner - mounting,
                                              .outer_ring = outer - mounting})
                    .clearance;
    e = solve_roller_bearing(b, {.speed = speed, .radial_load = load}, {.clearance = clearance});
    viscosity = oil.kinematic_viscosity(kelvin(0.5 * (inner + outer)));
    state = {.bearing = &b,
             .speed = speed,
             .radial_load = load,
             .inner_sum = e.inner_sum(),
             .outer_sum = e.outer_sum(),
             .kinematic_viscosity = viscosity};
    moments = roller_moments(friction::FrictionLaw::roller_palmgren, state,
                             std::array{c.in("f0"), c.in("f1")});
    heat = split_heat(state, moments);
    conductance = friction::roller_conductance(b, e, 45.0, 45.0);
    const double across = conductance + c.in("lubricant_conductance_W_K");
    // Two nodes: G (T - T_room) + across (T - T_other) = heat.
    const double a = to_room_inner + across, d = to_room_outer + across;
    const double rise_inner = (heat.inner * d + heat.outer * across) / (a * d - across * across);
    const double rise_outer = (heat.outer * a + heat.inner * across) / (a * d - across * across);
    inner = ambient + rise_inner;
    outer = ambient + rise_outer;
  }
  const auto& out = c.outputs();
  c.holds(out, "inner_ring_temperature_C", inner);
  c.holds(out, "outer_ring_temperature_C", outer);
  c.holds(out, "operating_clearance_um", clearance / um);
  c.holds(out, "sum_inner_N", state.inner_sum);
  c.holds(out, "sum_outer_N", state.outer_sum);
  c.holds(out, "load_Nmm", moments.load / N_mm);
  c.holds(out, "viscous_Nmm", moments.viscous / N_mm);
  c.holds(out, "inner_ring_heat_W", heat.inner);
  c.holds(out, "outer_ring_heat_W", heat.outer);
  c.holds(out, "viscosity_mm2_s", viscosity / mm2_per_s);
  c.holds(out, "conductance_of_rollers_W_K", conductance);
  c.holds(out, "stiffness_yy_N_um", e.stiffness(0, 0) * um);
}

}  // namespace
}  // namespace raceway::roller

#include <cmath>
#include <stdexcept>

#include "spindle/roller_clearance.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using nlohmann::json;

model::SolidMaterial reference_steel() {
  model::SolidMaterial s;
  s.density = 7800;
  s.thermal_expansion = 11.5 * per_million_K;
  s.elastic_modulus = 208 * GPa;
  s.poissons_ratio = 0.3;
  return s;
}

TEST(RollerReference, ClearanceFollowsFitSpeedAndTemperatures) {
  const ReferenceCase c = reference_case("clearance", "clearance_inner");
  for (const json& row : c.outputs().at("rows")) {
    bearing::RollerGeometry g = geometry(c);
    g.radial_clearance = row.at("radial_clearance_um").get<double>() * um;
    if (row.at("radial_clearance_of") == "free") g.clearance_state = bearing::ClearanceState::free;
    const auto number = [&](const char* key) { return row.at(key).get<double>(); };
    const spindle::OperatingClearance s =
        spindle::operating_clearance(steel_bearing(g),
                                     {.shaft_bore = c.in("shaft_bore_mm") * mm,
                                      .inner_interference = number("inner_interference_um") * um,
                                      .shaft = reference_steel()},
                                     number("speed_rpm") * rpm,
                                     {.shaft = number("shaft_rise_K"),
                                      .inner_ring = number("inner_ring_rise_K"),
                                      .outer_ring = number("outer_ring_rise_K"),
                                      .rollers = number("roller_rise_K")});
    c.holds(row, "operating_clearance_um", s.clearance / um);
    c.holds(row, "inner_raceway_radius_growth_um", s.inner_raceway_growth / um);
    c.holds(row, "seat_pressure_MPa", s.inner_seat.pressure / MPa);
  }
}

TEST(RollerReference, DriveUpOnATaperTakesClearance) {
  const ReferenceCase c = reference_case("clearance", "clearance_taper");
  bearing::RollerGeometry g = geometry(c);
  g.clearance_state = bearing::ClearanceState::free;
  g.taper = c.in("taper");
  const spindle::RollerSeats seats{.shaft_bore = c.in("shaft_bore_mm") * mm,
                                   .shaft = reference_steel()};
  for (const json& row : c.outputs().at("rows")) {
    const double wanted = row.at("mounted_clearance_um").get<double>() * um;
    const double interference = spindle::interference_for(steel_bearing(g), seats, wanted);
    c.holds(row, "inner_interference_um", interference / um);
    c.holds(row, "drive_up_mm", spindle::drive_up(g.taper, interference) / mm);
  }
  EXPECT_THROW((void)spindle::interference_for(steel_bearing(g), seats, 26 * um),
               std::invalid_argument);
}

// The housing squeezes the outer ring: its seat takes clearance as that of the shaft does.
TEST(RollerClearance, ATightHousingTakesClearance) {
  const bearing::RollerBearing b = steel_bearing(n1012());
  spindle::RollerSeats seats{.shaft_bore = 36 * mm,
                             .shaft = reference_steel(),
                             .housing_diameter = 140 * mm,
                             .outer_clearance = -8 * um,
                             .housing = reference_steel()};
  bearing::RollerGeometry g = n1012();
  g.clearance_state = bearing::ClearanceState::free;
  const auto tight = spindle::operating_clearance(steel_bearing(g), seats, 0.0, {});
  const auto fit = spindle::press_fit({85.5 * mm, 95 * mm, reference_steel(), 0.0},
                                      {95 * mm, 140 * mm, reference_steel(), 0.0}, 8 * um, 0.0);
  EXPECT_NEAR(tight.clearance, 2.0 * fit.inner_radius_growth, 1e-15);
  EXPECT_LT(tight.clearance, -4 * um);
  // Given as mounted, the same seats change nothing.
  EXPECT_NEAR(spindle::operating_clearance(b, seats, 0.0, {}).clearance, 0.0, 1e-15);
}

}  // namespace
}  // namespace raceway::roller

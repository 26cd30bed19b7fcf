#include "results/roller_results.h"

#include <cmath>
#include <utility>

#include "bearing/frequencies.h"
#include "bearing/roller_equilibrium.h"
#include "friction/roller_friction.h"
#include "model/bearing_life.h"
#include "record/units.h"
#include "results/detail/model_objects.h"

namespace raceway::results {
namespace {

text::json rollers_json(const bearing::RollerBearing& b, const bearing::RollerEquilibrium& e) {
  text::json list = text::json::array();
  const double length = b.lamina_length();
  for (const bearing::LoadedRoller& r : e.rollers) {
    double inner = 0.0, outer = 0.0;
    for (const double q : r.inner_laminae) inner = std::fmax(inner, q);
    for (const double q : r.outer_laminae) outer = std::fmax(outer, q);
    list.push_back({{"azimuth_deg", r.azimuth / degree},
                    {"inner_load_N", r.inner_load},
                    {"outer_load_N", r.outer_load},
                    {"inner_pressure_MPa",
                     b.contact().peak_pressure(bearing::Race::inner, inner / length) / MPa},
                    {"outer_pressure_MPa",
                     b.contact().peak_pressure(bearing::Race::outer, outer / length) / MPa},
                    {"tilt_mrad", r.tilt / mrad}});
  }
  return list;
}

}  // namespace

std::string roller_solve_json(const model::Model& model, const bearing::OperatingPoint& point,
                              const model::FrictionPrediction& friction,
                              const friction::HeatSplit& heat, const BandOfResult* band,
                              const model::Findings& findings) {
  const bearing::RollerBearing& b = *model.bearing.rollers();
  const bearing::RollerEquilibrium none;
  const bearing::RollerEquilibrium& e = friction.rollers ? *friction.rollers : none;
  const bool solved = e.report.converged();
  const bearing::ContactPressure pressure = largest_pressure(b, e);
  const auto& u = e.displacement;
  text::json matrix = text::json::array();
  for (int i = 0; i < 4; ++i) {
    text::json row = text::json::array();
    for (int j = 0; j < 4; ++j) row.push_back(e.stiffness(i, j));
    matrix.push_back(row);
  }
  text::json report = report_json(friction.rollers ? e.report : friction.report);
  if (friction.rollers) report["status"] = e.status();
  const auto if_solved = [&](double value) { return solved ? text::json(value) : text::json(); };
  text::json document = {{"bearing", model.name},
                         {"type", "cylindrical-roller"},
                         {"speed_rpm", point.speed / rpm},
                         {"radial_load_N", point.radial_load},
                         {"temperature_C", celsius(point.temperature)},
                         {"clearance_um", e.clearance / um},
                         {"radial_displacement_y_um", u[0] / um},
                         {"radial_displacement_z_um", u[1] / um},
                         {"tilt_y_mrad", u[2] / mrad},
                         {"tilt_z_mrad", u[3] / mrad},
                         {"moment_y_Nmm", e.load[2] / N_mm},
                         {"moment_z_Nmm", e.load[3] / N_mm},
                         {"loaded_rollers", solved ? text::json(e.loaded_rollers()) : text::json()},
                         {"centrifugal_force_N", e.centrifugal_force},
                         {"inner_load_sum_N", if_solved(e.inner_sum())},
                         {"outer_load_sum_N", if_solved(e.outer_sum())},
                         {"inner_contact_pressure_MPa", pressure.inner / MPa},
                         {"outer_contact_pressure_MPa", pressure.outer / MPa},
                         {"rollers", rollers_json(b, e)},
                         {"stiffness",
                          {{"radial_N_um", e.stiffness(0, 0) / N_per_um},
                           {"radial_z_N_um", e.stiffness(1, 1) / N_per_um},
                           {"tilt_y_Nm_rad", e.stiffness(2, 2)},
                           {"tilt_z_Nm_rad", e.stiffness(3, 3)},
                           {"matrix", matrix}}},
                         {"friction", friction_json(model, friction)},
                         {"friction_torque_Nmm", friction.torque / N_mm},
                         {"power_loss_W", friction.power_loss},
                         {"inner_ring_heat_W", heat.inner},
                         {"outer_ring_heat_W", heat.outer},
                         {"judgement", judgement_json(findings)},
                         {"report", report}};
  if (solved) {
    add_life(document, model, bearing_life(model, point, friction));
    document["life"]["C0_N"] = model.bearing.static_load_rating();
    add_frequencies(document, bearing::rolling_frequencies(model.bearing.rollers()->geometry()),
                    point.speed, "roller_spin");
  }
  add_band(document, band);
  return text::text(std::move(document));
}

}  // namespace raceway::results

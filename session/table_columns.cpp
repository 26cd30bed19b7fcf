#include "session/table_columns.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "bearing/contact_pressure.h"
#include "model/bearing_life.h"
#include "model/heat_split.h"
#include "model/prediction.h"
#include "results/shaft_results.h"
#include "session/operating_point.h"

namespace raceway::session {
namespace {

constexpr std::string_view lost_balls = "lost_balls", inner_pressure = "inner_contact_pressure_MPa",
                           outer_pressure = "outer_contact_pressure_MPa";

/// Beside those of every law; `life_h` is that of ISO/TS 16281.
constexpr std::array<std::string_view, 8> contact_columns{
    "film_min_um",       "lambda_min",        "kappa", "pressure_max_GPa", "slip_mean_m_s",
    "inner_ring_heat_W", "outer_ring_heat_W", "life_h"};

/// Of single states, behind all others.
constexpr std::array<std::string_view, 5> columns_of_a_state{
    "radial_displacement_z_um", "axial_stiffness_N_um", "radial_stiffness_N_um", "inner_load_max_N",
    "outer_load_max_N"};

std::array<double, columns_of_a_state.size()> state_values(const bearing::BearingEquilibrium& e) {
  double inner = 0.0, outer = 0.0;
  for (const bearing::BallEquilibrium& ball : e.balls.distinct()) {
    inner = std::fmax(inner, ball.inner_load);
    outer = std::fmax(outer, ball.outer_load);
  }
  return {e.displacement[2], e.stiffness(0, 0), e.stiffness(1, 1), inner, outer};
}

/// Of cylindrical rollers, behind the parts of the torque.
constexpr std::array<std::string_view, 18> roller_columns{"power_loss_W",
                                                          "inner_ring_heat_W",
                                                          "outer_ring_heat_W",
                                                          inner_pressure,
                                                          outer_pressure,
                                                          "loaded_rollers",
                                                          "radial_displacement_y_um",
                                                          "radial_displacement_z_um",
                                                          "radial_stiffness_N_um",
                                                          "radial_stiffness_z_N_um",
                                                          "inner_load_max_N",
                                                          "outer_load_max_N",
                                                          "inner_load_sum_N",
                                                          "outer_load_sum_N",
                                                          "clearance_um",
                                                          "kappa",
                                                          "life_h",
                                                          "static_safety"};

std::array<double, roller_columns.size()> roller_values(const model::Model& model,
                                                        const bearing::OperatingPoint& point,
                                                        const model::FrictionPrediction& p) {
  const bearing::RollerBearing& b = *model.bearing.rollers();
  const bearing::RollerEquilibrium& e = *p.rollers;
  double inner = 0.0, outer = 0.0;
  for (const bearing::LoadedRoller& r : e.rollers) {
    inner = std::fmax(inner, r.inner_load);
    outer = std::fmax(outer, r.outer_load);
  }
  const bearing::ContactPressure pressure = largest_pressure(b, e);
  const friction::HeatSplit heat = heat_split(model, point, p);
  const model::BearingLife life = bearing_life(model, point, p);
  return {p.power_loss,
          heat.inner,
          heat.outer,
          pressure.inner,
          pressure.outer,
          static_cast<double>(e.loaded_rollers()),
          e.displacement[0],
          e.displacement[1],
          e.stiffness(0, 0),
          e.stiffness(1, 1),
          inner,
          outer,
          e.inner_sum(),
          e.outer_sum(),
          e.clearance,
          life.viscosity_ratio,
          life.reference,
          life.static_safety};
}

std::vector<std::string> bearing_columns(const model::Model& model, Columns which) {
  std::vector<std::string> names;
  for (const std::string& part : torque_parts(model)) names.push_back(part + "_Nmm");
  if (model.bearing.rollers()) {
    names.insert(names.end(), roller_columns.begin(), roller_columns.end());
    return names;
  }
  for (const std::string_view name :
       {std::string_view("power_loss_W"), std::string_view("inner_contact_angle_min_deg"),
        std::string_view("inner_contact_angle_max_deg"),
        std::string_view("outer_contact_angle_min_deg"),
        std::string_view("outer_contact_angle_max_deg"), inner_pressure, outer_pressure, lost_balls,
        std::string_view("axial_displacement_um"), std::string_view("radial_displacement_y_um")})
    names.emplace_back(name);
  if (model.law == friction::FrictionLaw::contact)
    names.insert(names.end(), contact_columns.begin(), contact_columns.end());
  if (which == Columns::of_states)
    names.insert(names.end(), columns_of_a_state.begin(), columns_of_a_state.end());
  return names;
}

/// The columns of the contact law of a bearing in balance.
std::array<double, contact_columns.size()> contact_values(const model::Model& model,
                                                          const bearing::OperatingPoint& point,
                                                          const model::FrictionPrediction& p) {
  const bearing::Bearing& bearing = bearing_of(model, p);
  const model::ReferenceLife life = reference_life(model, point, p);
  const bearing::ContactPressure pressure = largest_pressure(bearing, *p.equilibrium);
  const friction::HeatSplit heat = heat_split(model, point, p);
  return {p.contacts->friction.smallest_film,
          p.contacts->friction.smallest_film_ratio,
          life.viscosity_ratio,
          std::fmax(pressure.inner, pressure.outer),
          p.contacts->mean_slip,
          heat.inner,
          heat.outer,
          life.reference};
}

std::vector<std::string> shaft_columns(const model::Model& model) {
  std::vector<std::string> names{"power_loss_W", "front_force_N", "rear_force_N",
                                 "axial_position_um"};
  const bearing::Arrangement& a = model.shaft->arrangement;
  for (std::size_t i = 0; i < a.bearings().size(); ++i)
    for (const std::string_view name :
         {std::string_view("axial_load_N"), std::string_view("friction_torque_Nmm"),
          std::string_view("inner_contact_angle_deg"), std::string_view("outer_contact_angle_deg"),
          inner_pressure, outer_pressure, lost_balls})
      names.push_back(fmt::format("{}_{}", results::bearing_place(a, i), name));
  names.emplace_back("axial_displacement_um");
  return names;
}

void fill_shaft_point(const model::Model& model, const shaft::ShaftPrediction& p,
                      friction::TablePoint& out) {
  const bearing::ArrangementEquilibrium& e = p.equilibrium;
  out.status = p.status();
  out.friction_moment = p.torque;
  std::size_t c = 0;
  for (const double v : {p.power_loss, e.front_force, e.rear_force, e.position})
    out.columns[c++] = v;
  for (std::size_t k = 0; k < e.bearings.size(); ++k) {
    const bearing::BearingInSet& b = e.bearings[k];
    const auto& mounted = model.shaft->arrangement.bearings()[k].bearing;
    for (const double v : {b.axial_load, p.friction[k].torque, b.ball.inner_contact_angle,
                           b.ball.outer_contact_angle, b.inner_pressure, b.outer_pressure,
                           b.lost() ? mounted->geometry().ball_count : 0.0})
      out.columns[c++] = v;
  }
  // Without balance the columns stay as they are, without a number.
  if (!e.bearings.empty()) out.columns[c] = p.displacement;
}

void fill_bearing_point(const model::Model& model, const bearing::OperatingPoint& point,
                        const model::FrictionPrediction& p, Columns which,
                        friction::TablePoint& out) {
  out.status = p.status();
  out.friction_moment = p.torque;
  std::size_t c = 0;
  for (const double moment : moments_of_parts(model, p)) out.columns[c++] = moment;
  if (model.bearing.rollers()) {
    if (p.rollers && p.rollers->report.converged())
      for (const double v : roller_values(model, point, p)) out.columns[c++] = v;
    return;
  }
  out.columns[c++] = p.power_loss;
  if (!p.equilibrium || !p.equilibrium->report.converged()) return;
  // NaN of lost balls must not spread: fmin and fmax pass over it.
  double inner_min = unset, inner_max = unset, outer_min = unset, outer_max = unset;
  for (const bearing::BallEquilibrium& b : p.equilibrium->balls.distinct()) {
    inner_min = std::fmin(inner_min, b.inner_contact_angle);
    inner_max = std::fmax(inner_max, b.inner_contact_angle);
    outer_min = std::fmin(outer_min, b.outer_contact_angle);
    outer_max = std::fmax(outer_max, b.outer_contact_angle);
  }
  const bearing::ContactPressure pressure = largest_pressure(bearing_of(model, p), *p.equilibrium);
  for (const double v : {inner_min, inner_max, outer_min, outer_max, pressure.inner, pressure.outer,
                         static_cast<double>(p.equilibrium->lost_balls()),
                         p.equilibrium->displacement[0], p.equilibrium->displacement[1]})
    out.columns[c++] = v;
  if (p.contacts)
    for (const double v : contact_values(model, point, p)) out.columns[c++] = v;
  if (which == Columns::of_states)
    for (const double v : state_values(*p.equilibrium)) out.columns[c++] = v;
}

}  // namespace

std::vector<std::string> table_columns(const model::Model& model, Columns which) {
  return model.shaft ? shaft_columns(model) : bearing_columns(model, which);
}

void fill_table_line(const model::Model& model, std::span<const bearing::OperatingPoint> points,
                     std::span<friction::TablePoint> out, Columns which) {
  if (model.shaft) {
    const auto predictions = shaft::predict_shaft(model, shaft_points(points));
    for (std::size_t i = 0; i < points.size(); ++i) fill_shaft_point(model, predictions[i], out[i]);
    return;
  }
  std::vector<model::FrictionPrediction> predictions(points.size());
  model::predict_sweep(model, points, predictions, true);
  for (std::size_t i = 0; i < points.size(); ++i)
    fill_bearing_point(model, points[i], predictions[i], which, out[i]);
}

void fill_state(const model::Model& model, const bearing::OperatingPoint& point,
                const model::FrictionPrediction& prediction, friction::TablePoint& out) {
  fill_bearing_point(model, point, prediction, Columns::of_states, out);
}

void fill_shaft_state(const model::Model& model, const shaft::ShaftPrediction& prediction,
                      friction::TablePoint& out) {
  fill_shaft_point(model, prediction, out);
}

}  // namespace raceway::session

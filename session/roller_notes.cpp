#include "session/roller_notes.h"

#include <fmt/format.h>

#include <cmath>

#include "bearing/roller_equilibrium.h"
#include "life/roller_life.h"
#include "model/judgement.h"

namespace raceway::session {
namespace {

/// Radial load over C below which unloaded rollers may skid [1]. From memory.
constexpr double least_load_share = 0.02;

}  // namespace

std::vector<std::string> notes_on_rollers(const model::Model& model,
                                          const bearing::OperatingPoint& point,
                                          const model::FrictionPrediction& prediction) {
  const bearing::RollerBearing& b = *model.bearing.rollers();
  return notes_on_rollers(b, *prediction.rollers,
                          std::isnan(model.life.dynamic_load_rating)
                              ? life::dynamic_load_rating(b.geometry())
                              : model.life.dynamic_load_rating,
                          point.speed, std::hypot(point.radial_load, point.radial_load_z));
}

std::vector<std::string> notes_on_rollers(const bearing::RollerBearing& b,
                                          const bearing::RollerEquilibrium& e, double C,
                                          double speed, double radial) {
  std::vector<std::string> notes;
  if (e.loose)
    notes.emplace_back(
        "the bearing has no load and a clearance: it is loose, and no roller touches the inner "
        "ring");
  else if (e.loaded_rollers() == 0)
    notes.emplace_back("no roller touches the inner ring");
  const double tilt = std::hypot(e.displacement[2], e.displacement[3]);
  if (tilt > bearing::usual_tilt_limit)
    notes.push_back(
        fmt::format("the inner ring is tilted by {:.3g} mrad; above about {:g} mrad the roller "
                    "ends are overloaded",
                    tilt / mrad, bearing::usual_tilt_limit / mrad));
  if (speed > 0.0 && !e.loose && e.clearance >= 0.0 && radial < least_load_share * C)
    notes.push_back(fmt::format(
        "the radial load of {:.4g} N is below the minimum load of {:.4g} N ({:g} "
        "times the dynamic load rating C), and the bearing has no preload: rollers may skid",
        radial, least_load_share * C, least_load_share));
  const bearing::ContactPressure pressure = largest_pressure(b, e);
  const double most = std::fmax(pressure.inner, pressure.outer);
  if (most > bearing::static_limit_pressure_of_lines)
    notes.push_back(fmt::format(
        "the contact pressure is {:.3g} GPa; above 4 GPa the rollers leave permanent dents",
        most / GPa));
  else if (speed > 0.0 && most > model::limits::running_pressure.value * GPa)
    notes.push_back(
        fmt::format("the contact pressure of the running bearing is {:.3g} GPa, above {:g} GPa: "
                    "the raceways can fatigue. Less load lowers the pressure",
                    most / GPa, model::limits::running_pressure.value));
  return notes;
}

}  // namespace raceway::session

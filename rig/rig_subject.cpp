#include "rig/rig_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "bearing/contact_pressure.h"
#include "fit/grid.h"
#include "model/candidates.h"
#include "model/prediction.h"
#include "model/row.h"
#include "model/torque_surface.h"
#include "rig/rig_predictor.h"

namespace raceway::rig {
namespace {

template <typename Value>
std::vector<double> by_row(const fit::Record& record, const Value& value) {
  std::vector<double> list;
  list.reserve(record.rows());
  for (const model::Row& row : model::rows_of(record)) list.push_back(value(row.point));
  return list;
}

/// The load that the bearing is made for.
const record::Channel& main_load(const model::Model& model) {
  return model.bearing.rollers() ? record::radial_load : record::axial_load;
}
std::vector<double> main_loads(const fit::Record& record, const model::Model& model) {
  const bool radial = model.bearing.rollers() != nullptr;
  return by_row(record, [&](const auto& p) { return radial ? p.radial_load : p.axial_load; });
}

/// Cylindrical rollers carry no axial load.
void require_no_axial_load(const fit::Record& record) {
  const std::span<const double> loads = record.values(record::axial_load);
  for (std::size_t i = 0; i < loads.size(); ++i)
    if (loads[i] != 0.0)
      throw std::invalid_argument(
          fmt::format("{}: axial_load_N = {:.6g}: must be 0, because a cylindrical roller bearing "
                      "of type N cannot carry an axial load",
                      record.place(i), loads[i]));
}

/// Levels of an axis within what was measured.
std::vector<double> levels(std::span<const double> values, int count) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values) {
    low = std::fmin(low, v);
    high = std::fmax(high, v);
  }
  return std::isfinite(high - low) ? fit::grid(low, high, count) : std::vector<double>();
}

}  // namespace

RigSubject::RigSubject(const model::Model& model) : ModelSubject(model) {
  if (model.shaft)
    throw std::invalid_argument("the model has an [arrangement]: it describes a shaft, not a rig");
}

RigSubject::RigSubject(const model::Model& model, std::vector<std::string> waiting)
    : ModelSubject(model, std::move(waiting)) {}

std::unique_ptr<model::ModelSubject> RigSubject::make(model::Model model,
                                                      std::vector<std::string> waiting) const {
  return std::unique_ptr<ModelSubject>(new RigSubject(model, std::move(waiting)));
}

std::vector<fit::Measured> RigSubject::measured() const { return {measured_torque()}; }

void RigSubject::require(const fit::Record& record) const {
  if (model().bearing.rollers()) require_no_axial_load(record);
  if (record.has(record::friction_torque)) return;
  if (record.has(record::axial_displacement))
    throw std::invalid_argument(record.source +
                                ": has axial displacement, which needs a model with an "
                                "[arrangement]; a single bearing needs measured friction torque");
  throw std::invalid_argument(record.source + ": has no column of friction torque");
}

std::shared_ptr<const void> RigSubject::prepare(const fit::Record& record) const {
  return std::make_shared<const EnteredBalances>(active(), record);
}

std::unique_ptr<fit::Predictor> RigSubject::predictor(
    const fit::Record& record, const std::vector<std::string>& names,
    const std::shared_ptr<const void>& prepared) const {
  return std::make_unique<RigPredictor>(active(), record, places(names),
                                        static_cast<const EnteredBalances*>(prepared.get()));
}

fit::Saturation RigSubject::saturation(const fit::Record& record) const {
  std::vector<model::TorqueLoad> further;
  if (!model().bearing.rollers() && record.varies(record::radial_load))
    further.push_back(
        {&record::radial_load,
         {model::logarithm(by_row(record, [](const auto& p) { return p.radial_load; })), 1e-3}});
  return torque_saturation(
      record, {&main_load(model()), {model::logarithm(main_loads(record, model())), 1e-3}},
      std::move(further));
}

std::vector<const record::Channel*> RigSubject::scattering(const fit::Record& record) const {
  return model::scattering_temperature(record);
}

std::vector<fit::Factor> RigSubject::factors(const fit::Record& record) const {
  return {{"speed", by_row(record, [](const auto& p) { return p.speed; })},
          {"load",
           by_row(record, [](const auto& p) { return std::hypot(p.axial_load, p.radial_load); })},
          {"viscosity", by_row(record, [&](const auto& p) {
             return model().lubricant.kinematic_viscosity(p.temperature);
           })}};
}

std::optional<fit::Formula> RigSubject::formula(const fit::Record& record) const {
  fit::Formula f{.key = "torque_Nmm", .unit = "N mm", .factor = rig_torque(model().rig, N_mm)};
  f.inputs = {{"speed_rpm", "a", by_row(record, [](const auto& p) { return p.speed / rpm; })},
              {std::string(main_load(model()).name), "b", main_loads(record, model())},
              {"viscosity_mm2_s", "d", by_row(record, [&](const auto& p) {
                 return model().lubricant.kinematic_viscosity(p.temperature) / mm2_per_s;
               })}};
  if (!model().bearing.rollers() && record.varies(record::radial_load))
    f.inputs.push_back(
        {"radial_load_N", "e", by_row(record, [](const auto& p) { return p.radial_load; })});
  return f;
}

std::vector<fit::Axis> RigSubject::axes(const fit::Record& record) const {
  std::vector<fit::Axis> list;
  const auto add = [&](const record::Channel& channel, int count, bool told) {
    fit::Axis axis{&channel, levels(record.values(channel), count), told};
    if (!axis.levels.empty()) list.push_back(std::move(axis));
  };
  add(record::speed, 7, true);
  add(main_load(model()), 5, true);
  if (!model().bearing.rollers()) add(record::radial_load, 3, record.varies(record::radial_load));
  add(record::temperature, 4, true);
  return list;
}

std::string RigSubject::words(std::span<const fit::Setting> point) const {
  constexpr std::array in_words{
      std::pair{&record::speed, "rpm"}, std::pair{&record::axial_load, "N"},
      std::pair{&record::temperature, "C"}, std::pair{&record::radial_load, "N radial load"}};
  std::string text;
  for (const auto& [channel, unit] : in_words)
    for (const fit::Setting& s : point)
      if (*s.channel == *channel && std::isfinite(s.value))
        text +=
            fmt::format("{}{:.0f} {}", text.empty() ? "" : ", ", channel->in_unit(s.value), unit);
  return text;
}

std::vector<std::string> RigSubject::records_needed(
    const fit::Record&, const std::vector<std::vector<std::string>>& rivals,
    const std::vector<std::string>&) const {
  return model::settling_records(model().form(), rivals);
}

std::vector<fit::OtherBase> RigSubject::other_bases() const { return other_laws(); }

std::string RigSubject::lacks(const std::string& id, const fit::Record& record) const {
  constexpr double thick_film = 2.0;  // film over roughness that no asperity reaches through
  constexpr double low_pressure = 1.2 * GPa;   // below which no film comes to its limit
  constexpr double high_pressure = 1.5 * GPa;  // of contacts that have enough of it
  if (id != "mu_boundary" && id != "limiting_traction") return ModelSubject::lacks(id, record);
  if (model().law != friction::FrictionLaw::contact) return {};
  double film_ratio = unset, pressure = unset;
  for (const model::FrictionPrediction& p : predict_rows(active(), record)) {
    if (!p.contacts || !p.equilibrium) continue;
    film_ratio = std::fmin(film_ratio, p.contacts->friction.smallest_film_ratio);
    const bearing::ContactPressure largest =
        largest_pressure(bearing_of(model(), p), *p.equilibrium);
    pressure = std::fmax(pressure, std::fmax(largest.inner, largest.outer));
  }
  if (id == "mu_boundary" && film_ratio >= thick_film)
    return fmt::format(
        "rows with a film ratio lambda < {:.0f}; the smallest lambda in this record is {:.3g}",
        thick_film, film_ratio);
  if (id == "limiting_traction" && pressure < high_pressure)
    return fmt::format(
        "rows with a contact pressure well above {0:.1f} GPa (below {0:.1f} GPa, the limiting "
        "traction changes the torque by less than 0.1 %); the largest pressure in this record is "
        "{1:.3g} GPa",
        low_pressure / GPa, pressure / GPa);
  return {};
}

model::Expected RigSubject::expected() const {
  const model::Rig& rig = model().rig;
  model::Expected e;
  e.defaults = {
      {&record::speed, unset, ""},
      {&record::axial_load, rig.axial_load, model().bearing.rollers() ? "[bearing] type" : "[rig]"},
      {&record::radial_load, rig.radial_load, "[rig]"},
      {&record::temperature, rig.temperature, "[rig]"}};
  e.measured = {&record::friction_torque, &record::axial_displacement};
  e.coast_down = rig.coasts_down();
  e.minimum_speed = rig.minimum_speed;
  return e;
}

}  // namespace raceway::rig

#include "fit/needs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/prediction.h"
#include "fit/quantity.h"

namespace raceway::fit {

namespace {

using effects::Need;

template <typename Value>
bool varies(const DataSet& data, double relative, double absolute, Value value) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Row& row : data.rows) {
    low = std::min(low, value(row));
    high = std::max(high, value(row));
  }
  return high - low > relative * std::abs(high) + absolute;
}

bool is_for_levels(Need need) {
  return need == Need::speed_levels || need == Need::load_levels || need == Need::preload_levels ||
         need == Need::viscosity_levels;
}

bool is_met(Need need, const Model& model, const DataSet& data) {
  const auto every_row = [&](auto has) {
    return std::all_of(data.rows.begin(), data.rows.end(), has);
  };
  const auto radial = [](const Row& r) {
    return std::hypot(r.point.radial_load, r.point.radial_load_z);
  };
  switch (need) {
    case Need::speed_levels:
      return varies(data, 0.01, 0.0, [](const Row& r) { return r.point.speed; });
    case Need::load_levels:
      return varies(data, 0.01, 0.0, [](const Row& r) { return r.point.axial_load; }) ||
             varies(data, 0.01, 0.0, radial);
    case Need::preload_levels:
      return varies(data, 0.01, 0.0, [](const Row& r) { return r.preload; });
    case Need::viscosity_levels:
      return varies(data, 0.0, 1.0, [](const Row& r) { return r.point.temperature; });
    case Need::time:
      return every_row([](const Row& r) { return std::isfinite(r.time); });
    case Need::ring_temperatures:
      return every_row([](const Row& r) {
        return std::isfinite(r.inner_ring_temperature) && std::isfinite(r.outer_ring_temperature);
      });
    case Need::loads:
      return model.shaft ||  // the sets load each other
             every_row([&](const Row& r) { return r.point.axial_load > 0.0 || radial(r) > 0.0; });
    case Need::ball_load_law:
      return model.shaft || needs_equilibrium(model);
    case Need::opposed_sets:
      return model.shaft && !model.shaft->arrangement.design().rear.empty();
    case Need::palmgren_law:
      return model.law == friction::FrictionLaw::palmgren;
    case Need::torque_standard:
      return false;
  }
  return true;
}

std::string first_unmet(const effects::Description& effect, const Model& model, const DataSet& data,
                        bool levels) {
  for (const Need need : effect.needs)
    if (is_for_levels(need) == levels && !is_met(need, model, data))
      return std::string(effects::text(need));
  return {};
}

}  // namespace

std::string missing_need(const effects::Description& effect, const Model& model,
                         const DataSet& data) {
  const effects::Subject measured = subject_of(data.quantity);
  if (!effect.moves(measured))
    return measured == effects::Subject::bearing
               ? "axial displacement of a shaft, on which alone it acts"
               : "friction torque, on which alone it acts";
  if (measured != model.subject()) return "a model of what was measured";
  return first_unmet(effect, model, data, false);
}

std::string missing_levels(const effects::Description& effect, const Model& model,
                           const DataSet& data) {
  return first_unmet(effect, model, data, true);
}

}  // namespace raceway::fit

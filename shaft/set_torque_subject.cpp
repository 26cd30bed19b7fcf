#include "shaft/set_torque_subject.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/candidates.h"
#include "model/fitted_model.h"
#include "model/torque_surface.h"
#include "shaft/torque_rows.h"

namespace raceway::shaft {
namespace {

class TorquePredictor : public fit::Predictor {
 public:
  TorquePredictor(const Model& model, const fit::Record& record,
                  std::vector<model::ParameterPlace> places)
      : rows_(model, record), fitted_(model, rows_.steps(), std::move(places)) {}

  void readings(std::span<const double> values, std::span<double> out) override {
    try {
      const model::Stage from = fitted_.set(values);
      rows_.predict(fitted_.model(), out, from);
    } catch (const std::invalid_argument&) {
      if (fitted_.as_entered()) throw;
      std::fill(out.begin(), out.end(), unset);
      return;
    }
    fitted_.keep(values);
  }

 private:
  TorqueRows rows_;
  model::FittedModel fitted_;
};

/// The preload at standstill [N].
double preload_of(const Model& model, const model::Row& row) {
  return std::isfinite(row.preload) ? row.preload : model.shaft->arrangement.preload();
}

double external_load_of(const Model& model, const model::Row& row) {
  return std::isfinite(row.point.axial_load) ? row.point.axial_load : model.shaft->external_load;
}

}  // namespace

SetTorqueSubject::SetTorqueSubject(const model::Model& model) : ShaftSubject(model) {}

SetTorqueSubject::SetTorqueSubject(const model::Model& model, std::vector<std::string> waiting)
    : ShaftSubject(model, std::move(waiting)) {}

std::unique_ptr<model::ModelSubject> SetTorqueSubject::make(
    model::Model model, std::vector<std::string> waiting) const {
  return std::unique_ptr<ModelSubject>(new SetTorqueSubject(model, std::move(waiting)));
}

std::vector<fit::Measured> SetTorqueSubject::measured() const { return {measured_torque()}; }

void SetTorqueSubject::require(const fit::Record& record) const {
  if (!record.has(record::friction_torque))
    throw std::invalid_argument(record.source + ": has no column of friction torque");
}

std::unique_ptr<fit::Predictor> SetTorqueSubject::predictor(
    const fit::Record& record, const std::vector<std::string>& names,
    const std::shared_ptr<const void>&) const {
  return std::make_unique<TorquePredictor>(active(), record, places(names));
}

fit::Saturation SetTorqueSubject::saturation(const fit::Record& record) const {
  std::vector<double> loads;
  for (const model::Row& row : model::rows_of(record))
    loads.push_back(external_load_of(model(), row) / preload_of(model(), row));
  fit::Saturation s =
      model::torque_saturation(record, {&record::axial_load, {std::move(loads), 1e-3}});
  s.proportional = false;  // a preload is not
  std::erase_if(s.levels, [&](const record::Channel* c) { return !record.complete(*c); });
  return s;
}

std::vector<const record::Channel*> SetTorqueSubject::scattering(const fit::Record& record) const {
  return model::scattering_temperature(record);
}

std::vector<fit::Factor> SetTorqueSubject::factors(const fit::Record& record) const {
  std::vector<fit::Factor> list{{"speed", {}}, {"load", {}}, {"viscosity", {}}};
  for (const model::Row& row : model::rows_of(record)) {
    list[0].values.push_back(row.point.speed);
    list[1].values.push_back(std::hypot(preload_of(model(), row), external_load_of(model(), row)));
    list[2].values.push_back(model().lubricant.kinematic_viscosity(row.point.temperature));
  }
  return list;
}

std::string SetTorqueSubject::doubt(const fit::Record&, std::span<const double>) const {
  return {};
}

std::vector<fit::OtherBase> SetTorqueSubject::other_bases() const { return other_laws(); }

std::vector<std::string> SetTorqueSubject::records_needed(
    const fit::Record&, const std::vector<std::vector<std::string>>& rivals,
    const std::vector<std::string>&) const {
  return model::settling_records(model().form(), rivals);
}

std::vector<std::string> SetTorqueSubject::usual_free() const {
  return model::default_free(model().law);
}

}  // namespace raceway::shaft

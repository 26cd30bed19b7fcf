#include "io/model_objects.h"

#include "io/units.h"
#include "model/band.h"
#include "record/units.h"

namespace raceway::io {

json report_json(const bearing::SolveReport& report) {
  return {{"status", bearing::name(report.status)},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"recovered_load_error", report.recovered_load_error}};
}

json band_json(const BandOfResult& band) {
  return {{"level", model::Band::level}, {"parameters", band.parameters}};
}

void add_band(json& row, const BandOfResult& band, std::size_t index) {
  for (std::size_t k = 0; k < band.names.size(); ++k)
    row[band.names[k]] =
        band.half_widths[index * band.names.size() + k] / column_unit(band.names[k]);
}

json friction_json(const model::Model& model, const model::FrictionPrediction& f) {
  json parts = json::object();
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, f);
  for (std::size_t i = 0; i < names.size(); ++i) parts[names[i] + "_Nmm"] = moments[i] / N_mm;
  return parts;
}

}  // namespace raceway::io

#include "results/detail/model_objects.h"

#include "model/band.h"
#include "record/units.h"
#include "text/units.h"

namespace raceway::results {

text::json report_json(const bearing::SolveReport& report) {
  return {{"status", bearing::name(report.status)},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"recovered_load_error", report.recovered_load_error}};
}

text::json band_json(const BandOfResult& band) {
  return {{"level", model::Band::level}, {"parameters", band.parameters}};
}

void add_band(text::json& row, const BandOfResult& band, std::size_t index) {
  for (std::size_t k = 0; k < band.names.size(); ++k)
    row[band.names[k]] =
        band.half_widths[index * band.names.size() + k] / text::column_unit(band.names[k]);
}

text::json friction_json(const model::Model& model, const model::FrictionPrediction& f) {
  text::json parts = text::json::object();
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, f);
  for (std::size_t i = 0; i < names.size(); ++i) parts[names[i] + "_Nmm"] = moments[i] / N_mm;
  return parts;
}

}  // namespace raceway::results

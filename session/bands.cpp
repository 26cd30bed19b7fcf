#include "session/bands.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/subject.h"
#include "model/heat_split.h"
#include "session/operating_point.h"
#include "session/shaft_answers.h"
#include "session/table_columns.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {
namespace {

/// Friction torque and loss of a bearing at every point.
std::vector<double> torques_and_losses(const model::Model& model,
                                       std::span<const bearing::OperatingPoint> points) {
  std::vector<model::FrictionPrediction> predictions(points.size());
  model::predict_sweep(model, points, predictions);
  std::vector<double> numbers;
  for (const model::FrictionPrediction& p : predictions) {
    numbers.push_back(p.torque);
    numbers.push_back(p.power_loss);
  }
  return numbers;
}

}  // namespace

model::Band band_of(const files::ModelFile& file, std::string_view asked_by,
                    std::string_view remedy) {
  if (!file.model.covariance)
    throw text::InputError(
        fmt::format(
            "{}: {} has no [calibration.covariance] for the present values of its parameters; {}",
            asked_by, file.source, remedy),
        {.file = file.source, .key = "calibration.covariance"});
  return model::Band(file.model);
}

std::string band_statement(const model::Band& band) {
  return fmt::format(
      "95 % band from the uncertainty of the fitted {} only; it does not include missing effects "
      "or noise",
      text::listed(band.fitted()));
}

std::vector<std::string> band_columns(const model::Model& model) {
  std::vector<std::string> names{"friction_torque_band_Nmm", "power_loss_band_W"};
  if (model.shaft) names.insert(names.begin(), "axial_displacement_band_um");
  return names;
}

void fill_band(const model::Model& model, const model::Band& band,
               std::span<const bearing::OperatingPoint> points,
               std::span<friction::TablePoint> out) {
  const std::vector<double> half_widths =
      model.shaft ? shaft_band(band, shaft_points(points)).half_widths
                  : band([&](const model::Model& m) { return torques_and_losses(m, points); });
  const std::size_t count = band_columns(model).size();
  for (std::size_t i = 0; i < points.size(); ++i)
    std::copy_n(half_widths.begin() + static_cast<std::ptrdiff_t>(i * count), count,
                out[i].columns.end() - static_cast<std::ptrdiff_t>(count));
}

results::BandOfResult point_band(const model::Band& band, const bearing::OperatingPoint& point) {
  results::BandOfResult result{.parameters = band.fitted(),
                               .names = {"friction_torque_band_Nmm", "power_loss_band_W",
                                         "inner_ring_heat_band_W", "outer_ring_heat_band_W"},
                               .half_widths = {}};
  result.half_widths = band([&](const model::Model& m) {
    const model::FrictionPrediction f = model::predict_friction(m, point, true);
    if (!f.report.converged()) return std::vector<double>(4, unset);
    const friction::HeatSplit heat = model::heat_split(m, point, f);
    return std::vector<double>{f.torque, f.power_loss, heat.inner, heat.outer};
  });
  return result;
}

std::vector<double> record_band(const model::Band& band, const record::Record& record) {
  return band(
      [&](const model::Model& m) { return fit::predict(*files::make_subject(m, record), record); });
}

}  // namespace raceway::session

#include "session/shaft_answers.h"

#include <fmt/format.h>

#include <cmath>

#include "results/shaft_results.h"
#include "shaft/lift_off.h"

namespace raceway::session {
namespace {

std::string places_of(const shaft::UnloadedRange& range, const bearing::Arrangement& a) {
  std::vector<std::string> places;
  for (const std::size_t i : range.bearings) places.push_back(results::bearing_place(a, i));
  return fmt::format("{}", fmt::join(places, ", "));
}

std::string speeds_of(const shaft::UnloadedRange& range) {
  return std::isnan(range.end)
             ? fmt::format("from {:.0f} rpm on", range.first.speed / rpm)
             : fmt::format("from {:.0f} to {:.0f} rpm", range.first.speed / rpm, range.end / rpm);
}

}  // namespace

std::vector<std::string> shaft_warnings(const model::Model& model,
                                        std::span<const shaft::ShaftPoint> points,
                                        std::span<const shaft::ShaftPrediction> predictions) {
  std::vector<std::string> lines;
  for (const shaft::UnloadedRange& r : shaft::unloaded_ranges(model, points, predictions)) {
    const std::string places = places_of(r, model.shaft->arrangement), speeds = speeds_of(r);
    lines.push_back(
        r.what == shaft::Unloaded::no_contact
            ? fmt::format("{}: no load, so the balls have no contact with the inner ring {}",
                          places, speeds)
            : fmt::format("{}: the load is below the minimum load {}: {:.4g} N instead of at least "
                          "{:.4g} N; balls may skid",
                          places, speeds, r.load, r.minimum_load));
  }
  return lines;
}

std::string shaft_problem(const model::Model& model, const shaft::ShaftPrediction& prediction) {
  for (const model::FrictionPrediction& f : prediction.friction)
    if (f.status() != bearing::SolveStatus::converged) return why_not_converged(model, f);
  switch (prediction.status()) {
    case bearing::SolveStatus::no_equilibrium:
      return "no_equilibrium: the solver found no shaft position at which the bearing sets are in "
             "equilibrium";
    case bearing::SolveStatus::singular:
      return "singular: both bearing sets are without load, so the shaft has no defined position";
    case bearing::SolveStatus::not_finite:
      return "not_finite: an effect needs data that are missing, such as ring temperatures";
    default:
      return std::string(bearing::name(prediction.status()));
  }
}

results::BandOfResult shaft_band(const model::Band& band,
                                 std::span<const shaft::ShaftPoint> points) {
  results::BandOfResult result{
      .parameters = band.fitted(),
      .names = {"axial_displacement_band_um", "friction_torque_band_Nmm", "power_loss_band_W"},
      .half_widths = {}};
  result.half_widths = band([&](const model::Model& m) {
    std::vector<double> numbers;
    for (const shaft::ShaftPrediction& p : shaft::predict_shaft(m, points)) {
      const bool found = p.equilibrium.report.converged();
      for (const double v : {p.displacement, p.torque, p.power_loss})
        numbers.push_back(found ? v : unset);
    }
    return numbers;
  });
  return result;
}

}  // namespace raceway::session

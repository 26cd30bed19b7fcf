#include "results/detail/model_objects.h"

#include "model/band.h"
#include "record/units.h"
#include "text/units.h"

namespace raceway::results {

text::json report_json(const bearing::SolveReport& report) {
  text::json json = {{"status", bearing::name(report.status)},
                     {"iterations", report.iterations},
                     {"residual", report.residual},
                     {"recovered_load_error", report.recovered_load_error}};
  if (report.status == bearing::SolveStatus::no_equilibrium) json["certain"] = report.certain;
  return json;
}

text::json judgement_json(const model::Findings& findings) {
  text::json list = text::json::array();
  for (const model::Finding& f : findings)
    list.push_back({{"limit", f.limit},
                    {"kind", f.is_warning ? "warning" : "note"},
                    {"place", f.place.empty() ? text::json(nullptr) : text::json(f.place)},
                    {"value", f.value},
                    {"allowed", f.allowed},
                    {"unit", f.unit},
                    {"speed_rpm", f.speed / rpm},
                    {"points", f.points},
                    {"text", f.text}});
  return list;
}

text::json band_json(const BandOfResult& band) {
  return {{"level", model::Band::level}, {"parameters", band.parameters}};
}

void add_band(text::json& row, const BandOfResult& band, std::size_t index) {
  for (std::size_t k = 0; k < band.names.size(); ++k)
    row[band.names[k]] =
        band.half_widths[index * band.names.size() + k] / text::column_unit(band.names[k]);
}

void add_band(text::json& document, const BandOfResult* band) {
  if (!band) return;
  add_band(document, *band, 0);
  document["band"] = band_json(*band);
}

void add_life(text::json& document, const model::Model& model, const model::BearingLife& life) {
  constexpr double hour = 3600.0;
  document["kappa"] = life.viscosity_ratio;
  document["life"] = {{"L10_h", life.basic / hour},
                      {"a_ISO", life.modification},
                      {"Lnm_h", life.modified / hour},
                      {"reference_L10r_h", life.reference / hour},
                      {model.bearing.rollers() ? "P_ref_N" : "P_N", life.equivalent_load},
                      {"C_N", life.load_rating},
                      {"C_u_N", life.fatigue_load},
                      {"reliability_percent", model.life.reliability},
                      {"contamination", model.life.contamination}};
  document["static_safety"] = life.static_safety;
}

void add_frequencies(text::json& document, const bearing::BearingFrequencies& turns, double speed,
                     std::string_view spin) {
  const double per_second = speed / (2.0 * pi);
  document["cage_speed_rpm"] = turns.cage * speed / rpm;
  document["frequencies_Hz"] = {{"cage", turns.cage * per_second},
                                {"outer_race", turns.outer_race * per_second},
                                {"inner_race", turns.inner_race * per_second},
                                {std::string(spin), turns.ball_spin * per_second}};
}

text::json friction_json(const model::Model& model, const model::FrictionPrediction& f) {
  text::json parts = text::json::object();
  const std::vector<std::string> names = torque_parts(model);
  const std::vector<double> moments = moments_of_parts(model, f);
  for (std::size_t i = 0; i < names.size(); ++i) parts[names[i] + "_Nmm"] = moments[i] / N_mm;
  return parts;
}

}  // namespace raceway::results

#include "io/diagnosis_results.h"

#include <nlohmann/json.hpp>

#include "fit/quantity.h"
#include "io/results.h"

namespace raceway::io {
namespace {

using json = nlohmann::ordered_json;

/// The document that `compare` gives.
json comparison(const std::string& model_file, const fit::Comparison& c, const fit::DataSet& data) {
  return json::parse(comparison_json({model_file}, {c}, data));
}

json parameters_json(const std::vector<fit::EffectSize>& sizes) {
  json parameters = json::object();
  for (const fit::EffectSize& p : sizes)
    parameters[p.name] = {{"value", p.value},
                          {"std", p.std},
                          {"from", p.interval.lower},
                          {"to", p.interval.upper},
                          {"unit", p.unit},
                          {"plausible", p.plausible},
                          {"plausible_from", p.plausible_lower},
                          {"plausible_to", p.plausible_upper},
                          {"at_bound", p.at_bound}};
  return parameters;
}

json base_json(const std::vector<fit::BaseShift>& shifts) {
  json parameters = json::object();
  for (const fit::BaseShift& b : shifts)
    parameters[b.name] = {
        {"before", b.before}, {"after", b.after}, {"std", b.std}, {"unit", b.unit}};
  return parameters;
}

json hold_out_json(const std::vector<fit::HoldOut>& hold_out, double unit) {
  json list = json::array();
  for (const fit::HoldOut& h : hold_out)
    list.push_back({{"left_out", h.variable},
                    {"rmse_before", h.rmse_before / unit},
                    {"rmse_after", h.rmse_after / unit},
                    {"improvement", h.improvement},
                    {"improvement_from", h.lower},
                    {"improvement_to", h.upper}});
  return list;
}

}  // namespace

std::string diagnosis_json(const std::string& model_file, const fit::DataSet& data,
                           const fit::Diagnosis& d) {
  const fit::QuantityText quantity = fit::text_of(data.quantity);
  const double unit = quantity.factor;
  json effects = json::array();
  for (const fit::RankedEffect& e : d.effects)
    effects.push_back({{"id", e.id},
                       {"in_verdict", e.in_verdict},
                       {"gain", e.gain},
                       {"rmse", e.rmse / unit},
                       {"rmse_cross_validated", e.rmse_cross_validated / unit},
                       {"parameters", parameters_json(e.parameters)},
                       {"base_parameters", base_json(e.base_shifts)},
                       {"indistinguishable_from", e.indistinguishable_from}});
  json detectable = json::array();
  for (const fit::DetectableSize& s : d.would_have_been_found)
    detectable.push_back({{"id", s.id},
                          {"parameter", s.parameter},
                          {"unit", s.unit},
                          {"size", s.size},
                          {"share_of_reading", s.share_of_reading},
                          {"most_alike", s.most_alike},
                          {"told_apart_from", s.told_apart_from}});
  json not_testable = json::array();
  for (const fit::NotTestable& n : d.not_testable)
    not_testable.push_back({{"id", n.id}, {"missing", n.reason}});
  json suggested = json::array();
  const bool shaft = data.quantity == fit::Quantity::axial_displacement;
  for (const fit::SuggestedMeasurement& m : d.suggested_measurements)
    suggested.push_back(
        {{"speed_rpm", m.point.speed / rpm},
         {"axial_load_N", m.point.axial_load},
         {shaft ? "preload_N" : "radial_load_N", shaft ? m.preload : m.point.radial_load},
         {"temperature_C", celsius(m.point.temperature)},
         {"repeats", m.repeats},
         {"separates", m.separates},
         {"difference_in_sigma", m.difference_in_sigma}});
  json document = {{"model", model_file},
                   {"data", data.source},
                   {"verdict", fit::name(d.verdict)},
                   {"sentence", d.sentence},
                   {"p_value", d.p_value},
                   {"remaining_p_value", d.remaining_p_value},
                   {"needed_gain", d.needed_gain},
                   {"candidates_tried", d.candidates_tried},
                   {"rows", d.rows},
                   {"unit", quantity.key_unit},
                   {"rmse_before", d.rmse_before / unit},
                   {"rmse_after", d.rmse_after / unit},
                   {"noise",
                    {{"rms", d.noise.rms / unit},
                     {"relative", d.noise.relative},
                     {"absolute", d.noise.absolute / unit},
                     {"correlation", d.noise.correlation},
                     {"run_share", d.noise.run_share}}},
                   {"baseline", comparison(model_file, d.baseline, data)},
                   {"effects", effects},
                   {"explanations", d.sets},
                   {"base_parameters", base_json(d.base_shifts)},
                   {"hold_out", hold_out_json(d.hold_out, unit)},
                   {"aliases", d.aliases},
                   {"would_have_been_found", detectable},
                   {"not_testable", not_testable},
                   {"suggested_measurements", suggested},
                   {"predicted_separation", d.predicted_separation},
                   {"separation_by_repetition", d.separation_by_repetition},
                   {"records_needed", d.records_needed},
                   {"outlier_lines", d.outlier_lines},
                   {"messages", d.messages}};
  if (d.shape)
    document["shape"] = {{"torque_Nmm", d.shape->formula},
                         {"coefficients", parameters_json(d.shape->coefficients)},
                         {"statement", d.shape->statement},
                         {"explained_share", d.shape->explained_share}};
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string add_json(const std::string& model_file, const fit::DataSet& data,
                     const fit::AddResult& r) {
  const fit::QuantityText quantity = fit::text_of(data.quantity);
  const double unit = quantity.factor;
  const json document = {{"model", model_file},
                         {"data", data.source},
                         {"refused", r.refused},
                         {"reason", r.reason},
                         {"unit", quantity.key_unit},
                         {"before", comparison(model_file, r.before, data)},
                         {"after", comparison(model_file, r.after, data)},
                         {"rmse_held_out_before", r.rmse_held_out_before / unit},
                         {"rmse_held_out_after", r.rmse_held_out_after / unit},
                         {"hold_out", hold_out_json(r.hold_out, unit)},
                         {"calibration", json::parse(calibration_json(r.calibration))},
                         {"messages", r.messages}};
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace raceway::io

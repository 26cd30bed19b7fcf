#include "results/correction_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "correction/numbers.h"
#include "fit/noise.h"
#include "record/digits.h"
#include "record/series_channel.h"
#include "results/detail/correction_objects.h"
#include "results/detail/fit_objects.h"
#include "text/detail/csv_text.h"
#include "text/detail/json_text.h"
#include "text/number_text.h"

namespace raceway::results {
namespace {

using correction::Identification;
using correction::Metrics;

text::json value_object(const Identification& found, const std::string& name) {
  for (const record::Parameter& p : found.parameters)
    if (p.name == name) return {{"value", p.value}, {"std", p.std}, {"unit", p.unit}};
  // What was not fitted stands in the model.
  for (const record::Parameter& p : correction::parameters(found.model))
    if (p.name == name) return {{"value", p.value}, {"std", nullptr}, {"unit", p.unit}};
  return nullptr;
}

text::json channel_of(const Identification& found, const correction::DrivenChannel& c) {
  text::json sections = text::json::array();
  for (std::size_t s = 0; s < c.sections.size(); ++s)
    sections.push_back({{"gain", value_object(found, fmt::format("{}.gain_{}", c.name, s + 1))},
                        {"time_constant_s",
                         value_object(found, fmt::format("{}.time_constant_{}", c.name, s + 1))}});
  text::json through = value_object(found, c.name + ".feedthrough");
  if (through.is_null())  // not fitted: as the file has it
    through = {{"value", c.feedthrough * c.input.factor() / um},
               {"std", nullptr},
               {"unit", correction::in_unit_of(found.model, "um/" + std::string(c.input.unit()))}};
  return {{"name", c.name},
          {"input", c.input.name},
          {"sections", std::move(sections)},
          {"feedthrough", std::move(through)}};
}

text::json trust_object(const correction::Trust& trust) {
  return {{"verdict", correction::name(trust.level)}, {"because", trust.because}};
}

text::json identified_object(const Identification& found) {
  text::json channels = text::json::array(), tried = text::json::array();
  for (const correction::DrivenChannel& c : found.model.channels)
    channels.push_back(channel_of(found, c));
  for (const correction::StructureTried& t : found.tried)
    tried.push_back({{"channels", t.channels},
                     {"order", t.orders},
                     {"rmse_held_out_um", t.rms_held_out / um},
                     {"rmse_um", t.rms / um},
                     {"taken", t.taken}});
  text::json result = {{"displacement", found.model.displacement->name},
                       {"channels", std::move(channels)},
                       {"offset_um", value_object(found, "offset")}};
  if (found.model.kinematic)
    result["kinematic"] = {{"A", value_object(found, "kinematic.A")},
                           {"B", value_object(found, "kinematic.B")},
                           {"C", value_object(found, "kinematic.C")}};
  result.update({{"order_tried", std::move(tried)},
                 {"rmse_held_out_um", found.rms_held_out / um},
                 {"condition", found.condition},
                 {"at_bound", found.at_bound},
                 {"metrics", metrics_object(found.metrics, *found.model.displacement)},
                 {"noise", {{"rms", found.noise / um}, {"source", fit::name(found.noise_source)}}},
                 {"tolerance_um", found.model.tolerance / um},
                 {"initial_state", name(found.model.initial_state)},
                 {"correlation_time_s", found.correlation_time},
                 {"whiteness_p_value", found.whiteness_p_value},
                 {"trust", trust_object(correction::trust_of(found.model))},
                 {"warnings", nullptr}});
  text::put_notes(result, "warnings", found.messages);
  const record::Channel& displacement = *found.model.displacement;
  if (!found.is_bank()) return in_unit_of(displacement, result);
  text::json ahead = text::json::array(), strengths = text::json::array();
  for (const correction::AheadError& e : found.ahead)
    ahead.push_back({{"from_s", e.from}, {"rmse_um", e.rms / um}});
  for (const correction::StrengthTried& t : found.strengths)
    strengths.push_back({{"strength", t.strength},
                         {"speed_weight", t.speed_weight},
                         {"rmse_ahead_um", t.rms_ahead / um},
                         {"share", t.share}});
  result.update({{"ahead", std::move(ahead)}, {"strengths", std::move(strengths)}});
  return in_unit_of(displacement, result);
}

text::json beyond_part(const correction::Beyond::Part& p, const record::Record& record) {
  const auto shown = [&](double v) { return p.column ? text::value_in_unit(*p.column, v) : v; };
  text::json result = {{"first_line", lines_of(record, {p.first}).at(0)},
                       {"first_time_s", record.value(record::time, p.first)},
                       {"rows", p.rows},
                       {"value", shown(p.value)},
                       {"farthest", shown(p.farthest)},
                       {"seen", {shown(p.lower), shown(p.upper)}}};
  if (!p.together()) {
    result["input"] = p.column ? p.name : p.name + " power_W";
    result["unit"] = p.column ? std::string(p.column->unit) : "W";
  } else {
    result["input"] = "together";
    result["unit"] = "1";
  }
  return result;
}

text::json validation_object(const Validation& v, const record::Channel& displacement) {
  text::json result = {{"data", v.data}};
  result.update(metrics_object(v.metrics, displacement));
  result[record::in_unit_of(displacement, "uncorrected_rmse_um")] = v.uncorrected / um;
  result["rows_beyond_range"] = v.rows_beyond_range;
  return result;
}

text::json arx_object(const record::Channel& displacement, const correction::ArxBaseline& a) {
  text::json fits = text::json::array();
  for (const correction::ArxFit& f : a.fits) {
    text::json poles = text::json::array();
    for (const std::complex<double>& pole : f.poles) poles.push_back({pole.real(), pole.imag()});
    fits.push_back({{"order", f.order},
                    {"one_step", metrics_object(f.one_step, displacement)},
                    {"simulated", metrics_object(f.simulated, displacement)},
                    {"simulated_second_half", metrics_object(f.second_half, displacement)},
                    {"poles", std::move(poles)},
                    {"time_constants_s", f.time_constants},
                    {"stable", f.stable}});
  }
  text::json result = {{"displacement", displacement.name},
                       {"sampling_s", a.sampling},
                       {"points", a.rows},
                       {"inputs", a.inputs},
                       {"fits", std::move(fits)}};
  text::put_notes(result, "warnings", a.messages);
  return result;
}

text::json band_object(const Corrected& c) {
  if (c.band.empty()) return nullptr;
  double narrowest = unset, widest = unset;
  for (const double b : c.band) {
    narrowest = std::fmin(narrowest, b);
    widest = std::fmax(widest, b);
  }
  return {{"level", 0.95},
          {"half_width_um", {narrowest / um, widest / um}},
          {"readings_within_percent", 100.0 * c.readings_in_band}};
}

text::json corrected_object(const Corrected& c, const record::Record& record) {
  const auto [low, high] = std::minmax_element(c.predicted.begin(), c.predicted.end());
  text::json result = {{"displacement", c.displacement->name},
                       {"initial_state", name(c.initial_state)},
                       {"predicted_range_um", {*low / um, *high / um}},
                       {"band", band_object(c)},
                       {"trust", trust_object(c.trust)},
                       {"metrics", metrics_object(c.metrics, *c.displacement)}};
  result.update(beyond_object(c.beyond, record));
  return in_unit_of(*c.displacement, result);
}

}  // namespace

text::json beyond_object(const correction::Beyond& beyond, const record::Record& record) {
  text::json parts = text::json::array();
  for (const correction::Beyond::Part& p : beyond.parts) parts.push_back(beyond_part(p, record));
  return {{"rows_beyond_range", beyond.known ? text::json(beyond.rows()) : text::json(nullptr)},
          {"beyond_range", std::move(parts)}};
}

namespace {

/// The first of a list at the top of a document, all of them in `axes` where there are several.
void add_axes(text::json& document, text::json axes) {
  document.update(axes.at(0));
  if (axes.size() > 1) document["axes"] = std::move(axes);
}

}  // namespace

Metrics metrics_of(const verdict::Comparison& c) {
  std::vector<double> measured, predicted;
  for (const verdict::RowError& e : c.errors) {
    measured.push_back(e.measured);
    predicted.push_back(e.predicted);
  }
  return correction::metrics(measured, predicted);
}

text::json in_unit_of(const record::Channel& displacement, const text::json& object) {
  if (!record::is_angle(displacement) || !object.is_structured()) return object;
  text::json result = object.is_array() ? text::json::array() : text::json::object();
  if (object.is_array()) {
    for (const text::json& one : object) result.push_back(in_unit_of(displacement, one));
    return result;
  }
  for (const auto& [key, value] : object.items())
    result[record::in_unit_of(displacement, key)] =
        key == "unit" && value.is_string()
            ? text::json(record::in_unit_of(displacement, value.get<std::string>()))
            : in_unit_of(displacement, value);
  return result;
}

text::json metrics_object(const Metrics& m, const record::Channel& channel) {
  const auto key = [unit = text::difference_unit(channel)](std::string_view name) {
    return fmt::format("{}_{}", name, unit);
  };
  return {{"readings", m.readings},
          {key("rmse"), m.rms / channel.factor},
          {key("mae"), m.mean_abs / channel.factor},
          {key("max_abs"), m.max_abs / channel.factor},
          {key("residue_min"), m.residue_min / channel.factor},
          {key("residue_max"), m.residue_max / channel.factor},
          {key("peak_to_peak"), m.peak_to_peak / channel.factor},
          {"fit_percent", m.fit_percent},
          {"reduction_of_max_percent", m.reduction_of_max_percent}};
}

std::string identification_json(const std::string& model_file, const record::Record& record,
                                const std::vector<Identification>& found,
                                const std::vector<Validation>& validations) {
  text::json document = {{"model", model_file}, {"data", data_of(record)}, {"rows", record.rows()}};
  text::json axes = text::json::array();
  for (std::size_t k = 0; k < found.size(); ++k) {
    axes.push_back(identified_object(found[k]));
    axes.back()["validation"] =
        k < validations.size() ? validation_object(validations[k], *found[k].model.displacement)
                               : text::json();
  }
  add_axes(document, std::move(axes));
  text::put_notes(document, "notes", record.notes);
  return text::text(document);
}

std::string arx_json(
    const std::string& model_file, const record::Record& record,
    const std::vector<std::pair<const record::Channel*, correction::ArxBaseline>>& found) {
  text::json document = {{"model", model_file},
                         {"data", data_of(record)},
                         {"rows", record.rows()},
                         {"baseline", "arx"}};
  text::json axes = text::json::array();
  for (const auto& [displacement, one] : found) axes.push_back(arx_object(*displacement, one));
  add_axes(document, std::move(axes));
  text::put_notes(document, "notes", record.notes);
  return text::text(document);
}

std::string corrected_text(const record::Record& record, const std::vector<Corrected>& corrected) {
  fmt::memory_buffer head;
  text::append_text(head, "time_s");
  const bool several = corrected.size() > 1;
  const auto name = [&](std::string_view column) {
    head.push_back(',');
    text::append_text(head, column);
  };
  for (const Corrected& c : corrected) {
    const auto of = [&](std::string_view what) {
      name(several ? fmt::format("{}_{}", what, c.displacement->name)
                   : fmt::format("{}_{}", what, c.displacement->unit));
    };
    of("predicted");
    if (!c.band.empty()) of("band_low"), of("band_high");
    for (const correction::Contribution& part : c.parts) {
      std::string column =
          part.name + "_" + std::string(several ? c.displacement->name : c.displacement->unit);
      std::replace(column.begin(), column.end(), ':', '_');
      name(column);
    }
    of("residual");
  }
  std::string result = fmt::to_string(head) + "\n";
  const std::span<const double> time = record.values(record::time);
  const auto cell = [&](double value) {
    result += ',';
    if (std::isfinite(value)) result += fmt::format("{}", record::with_digits(value / um, 9));
  };
  for (std::size_t row = 0; row < record.rows(); ++row) {
    result += fmt::format("{}", text::with_15_digits(time[row]));
    for (const Corrected& c : corrected) {
      cell(c.predicted[row]);
      if (!c.band.empty()) {
        cell(c.predicted[row] - c.band[row]);
        cell(c.predicted[row] + c.band[row]);
      }
      for (const correction::Contribution& part : c.parts) cell(part.displacement[row]);
      cell(record.value(*c.displacement, row) - c.predicted[row]);
    }
    result += '\n';
  }
  return result;
}

std::string corrected_json(const std::string& model_file, const record::Record& record,
                           const std::vector<Corrected>& corrected,
                           const std::vector<record::Note>& messages) {
  text::json document = {{"model", model_file}, {"data", data_of(record)}, {"rows", record.rows()}};
  text::json axes = text::json::array();
  for (const Corrected& c : corrected) axes.push_back(corrected_object(c, record));
  add_axes(document, std::move(axes));
  text::put_notes(document, "notes", record.notes);
  text::put_notes(document, "messages", messages);
  return text::text(document);
}

}  // namespace raceway::results

#include <algorithm>
#include <cmath>
#include <numeric>

#include "correction/metrics.h"
#include "fit/dwells.h"
#include "results/correction_results.h"
#include "results/detail/correction_objects.h"
#include "results/detail/fit_objects.h"
#include "results/results.h"
#include "text/number_text.h"

namespace raceway::results {
namespace {

text::json range_object(const verdict::ErrorRange& r, double factor) {
  text::json range = {{"variable", r.channel->variable}};
  if (r.is_run()) {
    range["from"] = range["to"] = r.run;
  } else {
    range["from"] = text::value_in_unit(*r.channel, r.from);
    range["to"] = text::value_in_unit(*r.channel, r.to);
  }
  range["unit"] = r.channel->unit;
  range["rows"] = r.rows;
  range["rmse"] = r.rmse / factor;
  range["bias"] = r.bias / factor;
  return range;
}

text::json worst_rows(const verdict::Comparison& c, const record::Record& record) {
  const double factor = c.channel->factor;
  text::json list = text::json::array();
  for (const verdict::RowError& r : c.worst) {
    list.push_back({{"line", r.line},
                    {"predicted", r.predicted / factor},
                    {"measured", r.measured / factor},
                    {"residual", r.residual / factor},
                    {"sigmas", r.sigmas}});
    if (!record.parts.empty()) list.back()["record"] = record.parts[record.part_of(r.row)].name;
  }
  return list;
}

/// The error of each of several records by itself.
text::json records_of(const verdict::Comparison& c, const record::Record& record) {
  text::json list = text::json::array();
  for (const verdict::ErrorRange& r : c.records)
    list.push_back({{"record", r.run},
                    {"data", record.parts.at(static_cast<std::size_t>(r.from)).source},
                    {"rows", r.rows},
                    {"rmse", r.rmse / c.channel->factor},
                    {"bias", r.bias / c.channel->factor}});
  return list;
}

/// What a comparison says of one channel.
text::json compared_channel(const verdict::Comparison& c, const record::Record& record) {
  const double factor = c.channel->factor;
  text::json noise = {{"rms", c.noise.rms / factor}, {"source", fit::name(c.noise.source)}};
  if (!std::isnan(c.estimated_noise)) noise["estimated_rms"] = c.estimated_noise / factor;
  text::json where = text::json::array();
  for (const verdict::ErrorRange& r : c.where) where.push_back(range_object(r, factor));
  text::json result = channel_object(*c.channel);
  result.update({{"rows", c.rows},
                 {"rows_not_predicted", lines_of(record, c.rows_not_predicted)},
                 {"rmse", c.rmse / factor},
                 {"mae", c.mae / factor},
                 {"max_abs", c.max_abs / factor},
                 {"bias", c.bias / factor},
                 {"fit_percent", c.fit_percent},
                 {"noise", noise},
                 {"lack_of_fit",
                  {{"statistic", c.lack_of_fit.statistic}, {"p_value", c.lack_of_fit.p_value}}}});
  const bool over_time = record::find_channel(c.channel->name) == nullptr;
  if (over_time) {
    result.update(metrics_object(metrics_of(c), *c.channel));
    result["initial_state"] = c.begins;
    result["correlation_time_s"] = c.correlation_time;
  }
  if (const bool known = !std::isnan(c.tolerance); known || over_time) {
    result[text::tolerance_key(*c.channel)] = c.tolerance / factor;
    result["within_tolerance"] = known ? text::json(c.rmse <= c.tolerance) : text::json();
  }
  result.update(
      {{"statement", c.statement}, {"where", where}, {"worst_rows", worst_rows(c, record)}});
  if (!c.records.empty()) result["records"] = records_of(c, record);
  return result;
}

text::json calibrated_parameters(const verdict::Calibration& c) {
  text::json parameters = text::json::object();
  for (const record::Parameter& p : c.parameters)
    parameters[p.name] = {{"value", p.value},
                          {"std", p.std},
                          {"unit", p.unit},
                          {"start", p.start},
                          {"lower", p.lower},
                          {"upper", p.upper},
                          {"at_bound", p.at_bound != record::Bound::none},
                          {"held", p.held},
                          {"identifiable", p.identifiable}};
  for (const record::Parameter& p : c.parameters)
    if (p.prior.is_known())
      parameters[p.name]["prior"] = {{"value", p.prior.value}, {"std", p.prior.std}};
  for (std::size_t k = 0; k < c.profile.size(); ++k) {
    const fit::ProfileInterval& of = c.profile[k];
    parameters[c.parameters[k].name]["profile"] = {{"from", of.lower},
                                                   {"to", of.upper},
                                                   {"open_from", of.open_lower},
                                                   {"open_to", of.open_upper}};
  }
  return parameters;
}

text::json calibrated_channel(const verdict::ChannelError& c) {
  text::json result = channel_object(*c.channel);
  result["rmse_before"] = c.rmse_before / c.channel->factor;
  result["rmse"] = c.rmse_after / c.channel->factor;
  result["readings"] = c.readings;
  return result;
}

/// What the intervals of the parameters are, and what they took.
text::json profile_object(const verdict::Calibration& c) {
  int refits = 0;
  for (const fit::ProfileInterval& of : c.profile) refits += of.refits;
  const double rise = fit::profile_rise * c.error_factor * c.error_factor;
  return {{"level", 0.95}, {"rise", rise}, {"refits", refits}};
}

text::json checked_channel(const loop::Check::MeasuredChannel& m) {
  text::json result = channel_object(*m.channel);
  result["rows"] = m.rows;
  result["noise"] = {{"rms", m.noise.rms / m.channel->factor},
                     {"source", fit::name(m.noise.source)}};
  if (!std::isnan(m.found_noise))
    result["noise"]["estimated_rms"] = m.found_noise / m.channel->factor;
  return result;
}

/// By which -2 ln L is more of readings in the units of a document than in SI.
double shift_of(const std::vector<ChannelCount>& channels) {
  double shift = 0.0;
  for (const ChannelCount& c : channels) shift -= 2.0 * c.readings * std::log(c.channel->factor);
  return shift;
}

}  // namespace

text::json channel_object(const record::Channel& channel) {
  return {{"quantity", channel.variable}, {"unit", channel.key_unit()}};
}

double log_determinant_in_units(const fit::Likelihood& likelihood,
                                const std::vector<ChannelCount>& channels) {
  return likelihood.log_determinant + shift_of(channels);
}

text::json likelihood_object(const fit::Likelihood& likelihood,
                             const std::vector<ChannelCount>& channels) {
  fit::Likelihood in_units = likelihood;
  in_units.deviance += shift_of(channels);
  text::json result = {{"chi_square", likelihood.chi_square},
                       {"degrees_of_freedom", nullptr},
                       {"aic", in_units.aic()},
                       {"bic", in_units.bic()}};
  if (likelihood.readings > 0) result["degrees_of_freedom"] = likelihood.degrees_of_freedom();
  return result;
}

text::json correlation_rows(const Eigen::MatrixXd& correlation) {
  text::json rows = text::json::array();
  for (Eigen::Index i = 0; i < correlation.rows(); ++i) {
    text::json row = text::json::array();
    for (Eigen::Index j = 0; j < correlation.cols(); ++j) row.push_back(correlation(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

void add_channels(text::json& document, text::json channels) {
  if (channels.size() > 1) document["channels"] = std::move(channels);
}

text::json lines_of(const record::Record& record, const std::vector<std::size_t>& rows) {
  text::json lines = text::json::array();
  for (const std::size_t row : rows)
    if (record.parts.empty())
      lines.push_back(record.line(row));
    else
      lines.push_back(
          {{"record", record.parts[record.part_of(row)].name}, {"line", record.line(row)}});
  return lines;
}

text::json data_of(const record::Record& record) {
  if (record.parts.empty()) return record.source;
  text::json list = text::json::array();
  for (const record::Part& part : record.parts) list.push_back(part.source);
  return list;
}

void add_notes(text::json& document, const record::Record& record) {
  text::put_notes(document, "notes", record.notes);
  const std::span<const double> rows = record.values(fit::dwell_rows);
  if (rows.empty()) return;
  text::json averaged = text::json::array();
  for (const record::Column& c : record.columns)
    if (c.channel->is_input() || c.channel->role == record::Role::time ||
        c.channel->role == record::Role::measured)
      averaged.push_back(c.channel->name);
  document["dwells"] = {
      {"rows", static_cast<int>(std::accumulate(rows.begin(), rows.end(), 0.0))},
      {"dwells", std::count_if(rows.begin(), rows.end(), [](double n) { return n > 1.0; })},
      {"averaged", std::move(averaged)}};
}

text::json hold_out_object(const std::vector<fit::HoldOut>& hold_out,
                           const std::vector<const record::Channel*>& channels) {
  text::json list = text::json::array();
  for (const fit::HoldOut& h : hold_out) {
    text::json errors = text::json::array();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      text::json error = channel_object(*channels[c]);
      error["rmse_before"] = h.rmse_before.at(c) / channels[c]->factor;
      error["rmse_after"] = h.rmse_after.at(c) / channels[c]->factor;
      errors.push_back(error);
    }
    text::json one = {{"left_out", h.variable},
                      {"rmse_before", errors[0]["rmse_before"]},
                      {"rmse_after", errors[0]["rmse_after"]},
                      {"improvement", h.improvement},
                      {"improvement_from", h.lower},
                      {"improvement_to", h.upper}};
    add_channels(one, std::move(errors));
    list.push_back(std::move(one));
  }
  return list;
}

text::json comparison_object(const std::string& model_file,
                             const std::vector<const verdict::Comparison*>& channels,
                             const record::Record& record) {
  text::json list = text::json::array();
  for (const verdict::Comparison* c : channels) list.push_back(compared_channel(*c, record));
  text::json document = {{"model", model_file}};
  document.update(list.at(0));
  document["data"] = data_of(record);
  add_channels(document, std::move(list));
  return document;
}

text::json calibration_object(const verdict::Calibration& c, const record::Record& record) {
  std::vector<ChannelCount> counts;
  for (const verdict::ChannelError& e : c.channels) counts.push_back({e.channel, e.readings});
  text::json document = {
      {"parameters", calibrated_parameters(c)},
      {"correlation", correlation_rows(c.correlation)},
      {"rows", c.rows},
      {"rows_not_predicted", lines_of(record, c.rows_not_predicted)},
      {"readings", nullptr},
      {"degrees_of_freedom", nullptr},
      {"chi_square", nullptr},
      {"reduced_chi_square", c.reduced_chi_square},
      {"noise", {{"log_determinant", log_determinant_in_units(c.likelihood, counts)}}}};
  document.update(likelihood_object(c.likelihood, counts));
  document["degrees_of_freedom"] = c.degrees_of_freedom;
  if (!c.profile.empty()) document["profile"] = profile_object(c);
  text::json channels = text::json::array();
  for (const verdict::ChannelError& e : c.channels) channels.push_back(calibrated_channel(e));
  if (!channels.empty()) document.update(channels[0]);
  document["readings"] = c.likelihood.readings;
  add_channels(document, std::move(channels));
  text::put_notes(document, "messages", c.messages);
  document["report"] = {{"status", fit::name(c.status)}, {"iterations", c.iterations}};
  return document;
}

std::string calibration_json(const verdict::Calibration& calibration,
                             const record::Record& record) {
  text::json document = calibration_object(calibration, record);
  add_notes(document, record);
  return text::text(std::move(document));
}

std::string comparison_json(const std::vector<std::string>& model_files,
                            const std::vector<std::vector<verdict::Comparison>>& comparisons,
                            const record::Record& record,
                            const std::vector<correction::Beyond>& beyond) {
  text::json documents = text::json::array();
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    std::vector<const verdict::Comparison*> channels;
    for (const verdict::Comparison& c : comparisons[i]) channels.push_back(&c);
    documents.push_back(comparison_object(model_files.at(i), channels, record));
    if (i < beyond.size()) documents.back().update(beyond_object(beyond[i], record));
  }
  text::json document = documents.size() == 1 ? documents[0] : text::json{{"models", documents}};
  add_notes(document, record);
  return text::text(std::move(document));
}

namespace {

text::json printed_object(const correction::RecordCheck::Printed& p) {
  text::json poles = text::json::array();
  for (const std::complex<double>& pole : p.check.poles)
    poles.push_back({pole.real(), pole.imag()});
  const double per_unit = um / p.factor;
  return {{"channel", p.channel},
          {"poles", std::move(poles)},
          {"time_constants_s", p.check.time_constants},
          {"dc_gain", p.check.dc_gain / per_unit},
          {"dc_gain_5_95_percent",
           {p.check.dc_gain_lower / per_unit, p.check.dc_gain_upper / per_unit}},
          {"unstable_percent", 100.0 * p.check.unstable_share},
          {"feedthrough", p.check.feedthrough / per_unit},
          {"step_per_quantum_um", std::abs(p.check.feedthrough * p.quantum) / um},
          {"warnings", p.check.warnings}};
}

/// Null where no reading was repeated.
text::json repeatability_object(const correction::RecordCheck& c) {
  const fit::Repeatability& r = c.repeatability;
  if (!r.known()) return nullptr;
  text::json stops = text::json::array();
  for (const fit::Stop& s : r.stops)
    stops.push_back({{"time_s", s.time},
                     {"readings", s.readings},
                     {"mean_um", s.mean / um},
                     {"two_sigma_um", 2.0 * s.std / um}});
  return {{"two_sigma_um", 2.0 * r.std / um},
          {"degrees_of_freedom", r.degrees_of_freedom},
          {"stops", std::move(stops)}};
}

text::json over_time_object(const correction::RecordCheck& c) {
  text::json quanta = text::json::object(), printed = text::json::array();
  for (const correction::RecordCheck::Quantum& q : c.quanta)
    quanta[std::string(q.column->name)] = q.step / q.column->factor;
  for (const correction::RecordCheck::Printed& p : c.printed)
    printed.push_back(in_unit_of(*c.displacement, printed_object(p)));
  text::json document = {{"sampling_s", c.sampling},
                         {"duration_s", c.duration},
                         {"readings", c.readings},
                         {"reading_interval_s", c.reading_interval},
                         {"repeatability", repeatability_object(c)},
                         {"noise_at_most_um", c.noise_at_most / um},
                         {"time_constants_visible_s", {c.shortest, c.longest}},
                         {"quanta", std::move(quanta)},
                         {"warnings", nullptr}};  // check_json() has them
  // The first at the top, as with channels.
  document = in_unit_of(*c.displacement, document);
  if (printed.empty()) return document;
  text::json first = printed.front();
  first.erase("warnings");
  document.update(first);
  document["polynomials"] = std::move(printed);
  return document;
}

}  // namespace

std::string model_check_json(const std::string& model_name,
                             const std::vector<files::UsedDefault>& defaults,
                             const std::vector<record::Note>& notes) {
  text::json document = {{"model", model_name}, {"defaults", files::lines(defaults)}};
  text::put_notes(document, "notes", notes);
  return text::text(document);
}

std::string check_json(const std::string& model_name, const loop::Check& check,
                       const std::vector<files::UsedDefault>& defaults,
                       const std::vector<record::Note>& notes,
                       const correction::RecordCheck* over_time) {
  text::json columns = text::json::array();
  for (const loop::Check::Column& c : check.columns)
    columns.push_back({{"name", c.channel->name},
                       {"from", text::value_in_unit(*c.channel, c.lower)},
                       {"to", text::value_in_unit(*c.channel, c.upper)},
                       {"levels", c.levels}});
  text::json effects = text::json::array();
  for (const loop::Check::Testable& t : check.catalogue)
    effects.push_back({{"id", t.id},
                       {"testable", t.missing.empty() && t.ruled_out.empty()},
                       {"missing", t.missing},
                       {"ruled_out", t.ruled_out},
                       {"hard_without", t.levels}});
  text::json parameters = text::json::array();
  for (const record::Parameter& p : check.free)
    parameters.push_back({{"name", p.name}, {"identifiable", p.identifiable}});
  text::json channels = text::json::array();
  for (const loop::Check::MeasuredChannel& m : check.measured)
    channels.push_back(checked_channel(m));
  const text::json first =
      check.measured.empty()
          ? text::json{{"quantity", nullptr}, {"unit", nullptr}, {"noise", nullptr}}
          : checked_channel(check.measured.front());
  text::json document = {{"model", model_name},   {"quantity", first["quantity"]},
                         {"rows", check.rows},    {"runs", check.runs},
                         {"unit", first["unit"]}, {"noise", first["noise"]},
                         {"columns", columns},    {"free_parameters", parameters},
                         {"effects", effects},    {"defaults", files::lines(defaults)}};
  text::put_notes(document, "notes", notes);
  add_channels(document, std::move(channels));
  if (over_time) {
    document.update(over_time_object(*over_time));
    text::put_notes(document, "warnings", over_time->warnings);
  }
  return text::text(std::move(document));
}

}  // namespace raceway::results

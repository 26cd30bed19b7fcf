#include "results/diagnosis_results.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "results/detail/fit_objects.h"
#include "text/number_text.h"

namespace raceway::results {
namespace {

using Channels = std::vector<const record::Channel*>;
using Counts = std::vector<ChannelCount>;

Counts counts_of(const verdict::Diagnosis& d) {
  Counts list;
  for (const verdict::ChannelDiagnosis& c : d.channels)
    list.push_back({&c.channel(), c.baseline.rows});
  return list;
}

Channels channels_of(const Counts& counts) {
  Channels list;
  for (const ChannelCount& c : counts) list.push_back(c.channel);
  return list;
}

/// `size`: which of them gives an effect its size.
text::json size_objects(const std::vector<record::Parameter>& sizes, std::size_t size) {
  text::json parameters = text::json::object();
  for (const record::Parameter& p : sizes)
    parameters[p.name] = {{"value", p.value},
                          {"std", p.std},
                          {"from", p.interval.lower},
                          {"to", p.interval.upper},
                          {"unit", p.unit},
                          {"plausible", p.plausible},
                          {"plausible_from", p.plausible_lower},
                          {"plausible_to", p.plausible_upper},
                          {"at_bound", p.at_bound != record::Bound::none},
                          {"is_size", &p == &sizes[size]}};
  return parameters;
}

/// Of a formula, in which none is more than another.
text::json coefficient_objects(const std::vector<record::Parameter>& coefficients) {
  text::json parameters = size_objects(coefficients, 0);
  for (text::json& p : parameters) p.erase("is_size");
  return parameters;
}

text::json base_objects(const std::vector<record::Parameter>& base) {
  text::json parameters = text::json::object();
  for (const record::Parameter& p : base)
    parameters[p.name] = {
        {"before", p.start}, {"after", p.value}, {"std", p.std}, {"unit", p.unit}};
  return parameters;
}

std::string held_out_key(const record::Channel& channel) {
  return "rmse_held_out_" + std::string(text::difference_unit(channel));
}

double in_unit(const std::vector<double>& errors, std::size_t c, const record::Channel& channel) {
  return c < errors.size() ? errors[c] / channel.factor : unset;
}

/// Ids as documents have them: where an effect acts is a field of its own.
class PlainIds {
 public:
  explicit PlainIds(const verdict::Diagnosis& d) {
    for (const verdict::RankedEffect& e : d.effects) plain_[e.id] = e.plain_id();
  }
  /// Each once.
  [[nodiscard]] std::vector<std::string> of(const std::vector<std::string>& ids) const {
    std::vector<std::string> list;
    for (const std::string& id : ids) {
      const auto found = plain_.find(id);
      const std::string& one = found == plain_.end() ? id : found->second;
      if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
    }
    return list;
  }

 private:
  std::map<std::string, std::string> plain_;
};

/// `limited`: a tolerance decides.
text::json effect_object(const verdict::RankedEffect& e, const Counts& counts,
                         const PlainIds& plain, bool limited) {
  const Channels channels = channels_of(counts);
  text::json errors = text::json::array();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    text::json error = channel_object(*channels[c]);
    error["rmse"] = in_unit(e.rmse, c, *channels[c]);
    error["rmse_cross_validated"] = in_unit(e.rmse_held_out, c, *channels[c]);
    errors.push_back(std::move(error));
  }
  text::json effect = {{"id", e.plain_id()}};
  for (const auto& [what, name] : e.acts_on) effect[what] = name;
  effect.update({{"kind", e.datum.empty() ? "physics" : "data"},
                 {"in_verdict", e.in_verdict},
                 {"gain", e.gain}});
  effect.update(likelihood_object(e.likelihood, counts));
  effect.update(
      {{"rmse", errors[0]["rmse"]}, {"rmse_cross_validated", errors[0]["rmse_cross_validated"]}});
  if (limited) effect[held_out_key(*channels[0])] = errors[0]["rmse_cross_validated"];
  effect.update({{"parameters", size_objects(e.parameters, e.size)},
                 {"base_parameters", base_objects(e.base)},
                 {"indistinguishable_from", plain.of(e.indistinguishable_from)}});
  add_channels(effect, std::move(errors));
  return effect;
}

text::json detectable_object(const verdict::DetectableSize& s) {
  return {{"id", s.id},
          {"parameter", s.parameter},
          {"unit", s.unit},
          {"size", s.size},
          {"share_of_reading", s.share_of_reading},
          {"most_alike", s.most_alike},
          {"told_apart_from", s.told_apart_from}};
}

/// The input values of a point by their columns, null where one stays as it is.
text::json suggested_object(const verdict::SuggestedMeasurement& m) {
  text::json point = text::json::object();
  for (const fit::Setting& s : m.point)
    point[std::string(s.channel->name)] = text::value_in_unit(*s.channel, s.value);
  point["repeats"] = m.repeats;
  point["separates"] = m.separates;
  point["difference_in_sigma"] = m.difference_in_sigma;
  return point;
}

text::json noise_object(const fit::NoiseModel& noise, double factor) {
  text::json result = {{"rms", noise.rms / factor},
                       {"relative", noise.relative},
                       {"absolute", noise.absolute / factor},
                       {"correlation", noise.correlation},
                       {"run_share", noise.run_share}};
  if (noise.growth > 0.0) result["growth"] = noise.growth;
  if (noise.state_share > 0.0) result["dwell_share"] = noise.state_share;
  if (!noise.records.empty()) result["records"] = noise.records;
  return result;
}

/// Error and noise of one channel, and its tolerance where there is one.
text::json diagnosed_channel(const verdict::ChannelDiagnosis& c) {
  const record::Channel& channel = c.channel();
  text::json result = channel_object(channel);
  result["rmse_before"] = c.rmse_before / channel.factor;
  result["rmse_after"] = c.rmse_after / channel.factor;
  result["noise"] = noise_object(c.noise, channel.factor);
  if (std::isnan(c.tolerance)) return result;
  result[text::tolerance_key(channel)] = c.tolerance / channel.factor;
  result[held_out_key(channel)] = c.rmse_held_out_before / channel.factor;
  return result;
}

text::json shape_object(const fit::Shape& shape) {
  return {{shape.key, shape.formula},
          {"coefficients", coefficient_objects(shape.coefficients)},
          {"statement", shape.statement},
          {"explained_share", shape.explained_share}};
}

text::json course_object(const verdict::Course& course) {
  text::json when = text::json::array();
  for (const auto& [from, to] : course.when) when.push_back({from, to});
  return {{"when", std::move(when)},
          {"period_s", course.period},
          {"time_constant_s", course.time_constant}};
}

text::json outlier_lines(const record::Record& record, std::vector<std::size_t> rows) {
  std::sort(rows.begin(), rows.end());
  return lines_of(record, rows);
}

/// A list of objects made of a list of results.
template <typename Result, typename Make>
text::json list_of(const std::vector<Result>& results, const Make& make) {
  text::json list = text::json::array();
  for (const Result& r : results) list.push_back(make(r));
  return list;
}

/// What stands beneath the verdict: errors and noise of the channels, first the leading one.
void add_errors(text::json& document, const std::string& model_file, const record::Record& record,
                const verdict::Diagnosis& d, const PlainIds& plain) {
  const text::json channels = list_of(d.channels, diagnosed_channel);
  text::json first = channels.at(0);
  first.erase("quantity");
  document.update(first);
  if (d.tolerance_limited()) {
    document["within_tolerance"] = d.within_tolerance;
    document["significant_but_immaterial"] = plain.of(d.significant_but_immaterial);
  }
  std::vector<const verdict::Comparison*> baselines;
  for (const verdict::ChannelDiagnosis& c : d.channels) baselines.push_back(&c.baseline);
  const Counts counts = counts_of(d);
  document["noise"]["log_determinant"] = log_determinant_in_units(d.likelihood, counts);
  document["baseline"] = comparison_object(model_file, baselines, record);
  document["baseline"].update(likelihood_object(d.likelihood, counts));
  add_channels(document, channels);
}

/// A set of effects at once, the error that of the leading channel.
text::json set_object(const verdict::SetFit& f, const Counts& counts) {
  text::json result = {{"gain", f.gain}};
  result.update(likelihood_object(f.likelihood, counts));
  result["rmse"] = in_unit(f.rmse, 0, *counts.front().channel);
  return result;
}

text::json other_base_object(const verdict::OtherBaseTried& b, const Counts& counts) {
  const record::Channel& first = *counts.front().channel;
  text::json result = {{"id", b.id}, {"words", b.words}, {"gain", b.gain}};
  result.update(likelihood_object(b.likelihood, counts));
  result.update({{"rmse", in_unit(b.rmse, 0, first)},
                 {"rmse_cross_validated", in_unit(b.rmse_held_out, 0, first)},
                 {"remaining_p_value", b.remaining_p_value},
                 {"explains", b.explains},
                 {"fitted_form", b.fitted_form},
                 {"parameters", base_objects(b.parameters)}});
  for (auto& [_, p] : result["parameters"].items()) {
    p["value"] = p["after"];
    p.erase("before");
    p.erase("after");
  }
  return result;
}

/// The verdict with another base model.
text::json given_object(const verdict::OtherBaseTried& base, const verdict::Diagnosis& d) {
  text::json effects = text::json::array();
  for (const verdict::RankedEffect& e : d.effects)
    if (e.in_verdict) effects.push_back(e.plain_id());
  return {{"id", base.id},          {"verdict", verdict::name(d.verdict)},
          {"headline", d.headline}, {"sentence", d.sentence},
          {"p_value", d.p_value},   {"effects", effects}};
}

text::json added_channel(const verdict::ChannelGain& c) {
  const record::Channel& channel = c.channel();
  text::json result = channel_object(channel);
  result["rmse_before"] = c.before.rmse / channel.factor;
  result["rmse_after"] = c.after.rmse / channel.factor;
  result["rmse_held_out_before"] = c.rmse_held_out_before / channel.factor;
  result["rmse_held_out_after"] = c.rmse_held_out_after / channel.factor;
  return result;
}

}  // namespace

std::string diagnosis_json(const std::string& model_file, const record::Record& record,
                           const verdict::Diagnosis& d) {
  const Counts counts = counts_of(d);
  const Channels channels = channels_of(counts);
  const bool limited = d.tolerance_limited();
  const PlainIds plain(d);
  text::json document = {{"model", model_file},
                         {"data", data_of(record)},
                         {"verdict", verdict::name(d.verdict)},
                         {"headline", d.headline},
                         {"sentence", d.sentence},
                         {"p_value", d.p_value},
                         {"remaining_p_value", d.remaining_p_value},
                         {"needed_gain", d.needed_gain},
                         {"candidates_tried", d.candidates_tried},
                         {"rows", d.rows},
                         {"readings", nullptr}};
  if (d.likelihood.readings > 0) document["readings"] = d.likelihood.readings;
  add_errors(document, model_file, record, d, plain);
  document.update(
      {{"effects",
        list_of(d.effects,
                [&](const auto& e) { return effect_object(e, counts, plain, limited); })},
       {"explanations", list_of(d.sets, [&](const auto& set) { return plain.of(set); })},
       {"explanation_fits",
        list_of(d.fits, [&](const verdict::SetFit& f) { return set_object(f, counts); })},
       {"base_parameters", base_objects(d.base)},
       {"correlation",
        {{"names", d.correlation.names}, {"rows", correlation_rows(d.correlation.matrix)}}},
       {"hold_out", hold_out_object(d.hold_out, channels)},
       {"aliases", d.aliases},
       {"would_have_been_found", list_of(d.would_have_been_found, detectable_object)},
       {"not_testable", list_of(d.not_testable,
                                [](const verdict::NotTestable& n) {
                                  return text::json{{"id", n.id}, {"missing", n.reason}};
                                })},
       {"suggested_measurements", list_of(d.suggested_measurements, suggested_object)},
       {"predicted_separation", d.predicted_separation},
       {"separation_by_repetition", d.separation_by_repetition},
       {"records_needed", d.records_needed},
       {"outlier_lines", outlier_lines(record, d.outliers)},
       {"messages", nullptr}});
  text::put_notes(document, "messages", d.messages);
  add_notes(document, record);
  if (!d.other_bases.empty())
    document["other_bases"] =
        list_of(d.other_bases, [&](const auto& b) { return other_base_object(b, counts); });
  if (d.given_other_base)
    document["given_other_base"] = given_object(d.other_bases.front(), *d.given_other_base);
  if (d.shape) document["shape"] = shape_object(*d.shape);
  if (d.course) document["shape"] = course_object(*d.course);
  return text::text(std::move(document));
}

std::string add_json(const std::string& model_file, const record::Record& record,
                     const verdict::AddResult& r) {
  const text::json list = list_of(r.channels, added_channel);
  const text::json& first = list.at(0);
  std::vector<const verdict::Comparison*> before, after;
  Channels channels;
  for (const verdict::ChannelGain& c : r.channels) {
    before.push_back(&c.before);
    after.push_back(&c.after);
    channels.push_back(&c.channel());
  }
  Counts counts;
  for (const verdict::ChannelGain& c : r.channels) counts.push_back({&c.channel(), c.before.rows});
  text::json document = {{"model", model_file},
                         {"data", data_of(record)},
                         {"refused", r.refused},
                         {"reason", r.reason},
                         {"gain", r.gain},
                         {"unit", first["unit"]},
                         {"before", comparison_object(model_file, before, record)},
                         {"after", comparison_object(model_file, after, record)},
                         {"rmse_held_out_before", first["rmse_held_out_before"]},
                         {"rmse_held_out_after", first["rmse_held_out_after"]},
                         {"hold_out", hold_out_object(r.hold_out, channels)},
                         {"calibration", calibration_object(r.calibration, record)},
                         {"messages", nullptr}};
  text::put_notes(document, "messages", r.messages);
  add_notes(document, record);
  document["before"].update(likelihood_object(r.before, counts));
  add_channels(document, list);
  return text::text(std::move(document));
}

}  // namespace raceway::results

#include "report/report.h"

#include <algorithm>
#include <cmath>

#include "model/model_changes.h"
#include "model/model_subject.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/detail/report_rows.h"
#include "results/diagnosis_results.h"
#include "results/results.h"
#include "shaft/shaft_balance.h"

namespace raceway::report {
namespace {

/// Measured channels that the page does not draw, in words.
template <typename Result, typename ChannelOf>
void add_others(Document& document, const std::vector<Result>& channels, ChannelOf channel_of) {
  text::json others = text::json::array();
  for (std::size_t c = 1; c < channels.size(); ++c) others.push_back(channel_of(channels[c]).words);
  if (!others.empty()) document.add("other_channels", std::move(others));
}

/// Standard deviation of every row of a page, as it is known beforehand or was estimated.
std::vector<double> std_of_rows(const verdict::Comparison& comparison, const record::Record& record,
                                const ReportRows& rows) {
  using fit::NoiseSource;
  const NoiseSource source = comparison.noise.source;
  if (source == NoiseSource::repeats)
    return std::vector<double>(rows.rows().size(), comparison.noise.rms);
  std::vector<double> std;
  if (source == NoiseSource::none) {
    for (const verdict::RowError& e : comparison.errors) std.push_back(e.std);
    return rows.by_row(comparison, std);
  }
  const record::Column* const declared = record.deviation_of(*comparison.channel);
  // Declared by the model, or found beside each other in time: one for all rows.
  if (!declared) return std::vector<double>(rows.rows().size(), comparison.noise.rms);
  const record::Column& deviation = *declared;
  for (const std::size_t row : rows.rows()) std.push_back(deviation.values[row]);
  return std;
}

/// The same from a noise model, which is in the order of the comparison.
std::vector<double> std_of_rows(const fit::NoiseModel& noise, const verdict::Comparison& comparison,
                                const ReportRows& rows) {
  const Eigen::VectorXd& std = noise.whitening.std();
  if (std.size() == 0) return std::vector<double>(rows.rows().size(), noise.rms);
  return rows.by_row(comparison, std::span(std.data(), static_cast<std::size_t>(std.size())));
}

/// A comparison with other predictions in the place of its own.
verdict::Comparison with_readings(verdict::Comparison comparison,
                                  std::span<const double> readings) {
  double square = 0.0;
  for (std::size_t i = 0; i < comparison.errors.size(); ++i) {
    verdict::RowError& e = comparison.errors[i];
    e.predicted = readings[i];
    e.residual = readings[i] - e.measured;
    square += e.residual * e.residual;
  }
  comparison.rmse = std::sqrt(square / static_cast<double>(comparison.errors.size()));
  const std::size_t most = comparison.worst.size();
  comparison.worst = comparison.errors;
  std::partial_sort(
      comparison.worst.begin(), comparison.worst.begin() + static_cast<std::ptrdiff_t>(most),
      comparison.worst.end(), [](const verdict::RowError& a, const verdict::RowError& b) {
        return std::abs(a.residual) > std::abs(b.residual);
      });
  comparison.worst.resize(most);
  return comparison;
}

std::string ids_of(const verdict::ExplainedReadings& explained) {
  std::string ids;
  for (const verdict::EffectShare& e : explained.effects)
    ids += (ids.empty() ? "" : " and ") + e.id;
  return ids;
}

/// True for an effect alone that stands in the explanation of the verdict already.
bool is_in_verdict(const verdict::ExplainedReadings& e, const verdict::Diagnosis& d) {
  if (!d.verdict_is_explained || &e == &d.explained.front()) return false;
  const std::vector<verdict::EffectShare>& verdict = d.explained.front().effects;
  return std::all_of(e.effects.begin(), e.effects.end(), [&](const verdict::EffectShare& one) {
    return std::any_of(verdict.begin(), verdict.end(),
                       [&](const verdict::EffectShare& v) { return v.id == one.id; });
  });
}

/// What an effect adds, without the rounding of the two readings whose difference it is.
std::vector<double> share_of(const verdict::EffectShare& share, const std::vector<double>& total) {
  constexpr double rounding = 1e-12;
  double largest = 0.0;
  for (const double v : total) largest = std::fmax(largest, std::abs(v));
  std::vector<double> result = share.readings;
  for (double& v : result)
    if (std::abs(v) < rounding * largest) v = 0.0;
  return result;
}

/// Columns of what each explanation is made of. Readings are those of the first channel, which
/// comes first in them.
text::json explanations_json(const verdict::Diagnosis& d, ReportRows& rows) {
  const verdict::Comparison& baseline = d.channels.front().baseline;
  text::json list = text::json::array();
  int effect = 0;
  for (const verdict::ExplainedReadings& e : d.explained) {
    if (is_in_verdict(e, d)) continue;
    text::json effects = text::json::array();
    for (const verdict::EffectShare& share : e.effects)
      effects.push_back(
          {{"id", share.id},
           {"column", rows.add_readings("effect_" + std::to_string(effect++),
                                        rows.by_row(baseline, share_of(share, e.total)))}});
    const std::string of = std::to_string(list.size());
    list.push_back({{"effects", effects},
                    {"base", rows.add_readings("base_" + of, rows.by_row(baseline, e.base))},
                    {"total", rows.add_readings("with_" + of, rows.by_row(baseline, e.total))}});
  }
  return list;
}

}  // namespace

std::string comparison_report(const std::vector<std::string>& model_files,
                              const std::vector<model::Model>& models,
                              const std::vector<std::vector<verdict::Comparison>>& comparisons,
                              const record::Record& record, const std::vector<ModelOfPage>& facts) {
  Document document("compare");
  document.add("assumed", model_facts(facts));
  document.add_text("results", results::comparison_json(model_files, comparisons, record));
  document.add("steps", changes_json(model::changes_between(models)));
  const verdict::Comparison& last = comparisons.back().front();
  ReportRows rows(record, *last.channel, rows_read(record, *last.channel));
  rows.add_std(std_of_rows(last, record, rows));
  for (std::size_t i = 0; i < comparisons.size(); ++i)
    rows.add_model(model_files[i], comparisons[i].front());
  rows.finish(document);
  add_others(document, comparisons.back(),
             [](const verdict::Comparison& c) -> const record::Channel& { return *c.channel; });
  return report_page(document.text());
}

std::string diagnosis_report(const std::string& model_file, const fit::Subject& subject,
                             const record::Record& record, const verdict::Diagnosis& d,
                             const std::vector<ModelOfPage>& facts) {
  Document document("diagnose");
  document.add("assumed", model_facts(facts));
  document.add_text("results", results::diagnosis_json(model_file, record, d));
  if (const auto* known = dynamic_cast<const model::ModelSubject*>(&subject))
    if (known->model().shaft)
      document.add("preload_N", shaft::mounted_arrangement(known->model()).preload());
  const verdict::ChannelDiagnosis& first = d.channels.front();
  // A diagnosis thins large records and leaves out what has no balance.
  ReportRows rows(record, first.channel(), rows_compared(first.baseline));
  rows.add_std(std_of_rows(first.noise, first.baseline, rows));
  rows.add_model("refitted, no effect added", first.baseline);
  if (d.verdict_is_explained) {
    const verdict::ExplainedReadings& verdict = d.explained.front();
    rows.add_model("with " + ids_of(verdict), with_readings(first.baseline, verdict.total));
  }
  document.add("explanations", explanations_json(d, rows));
  rows.finish(document);
  add_others(
      document, d.channels,
      [](const verdict::ChannelDiagnosis& c) -> const record::Channel& { return c.channel(); });
  return report_page(document.text());
}

std::string add_report(const std::string& model_file, const record::Record& record,
                       const verdict::AddResult& r, const std::vector<ModelOfPage>& facts) {
  Document document("add");
  document.add("assumed", model_facts(facts));
  document.add_text("results", results::add_json(model_file, record, r));
  const verdict::ChannelGain& first = r.channels.front();
  document.add("noise_rms", first.noise.rms / first.channel().factor);
  ReportRows rows(record, first.channel(), rows_compared(first.before));
  rows.add_std(std_of_rows(first.noise, first.before, rows));
  rows.add_model("before, refitted", first.before);
  rows.add_model("after", first.after);
  rows.finish(document);
  add_others(document, r.channels,
             [](const verdict::ChannelGain& c) -> const record::Channel& { return c.channel(); });
  return report_page(document.text());
}

}  // namespace raceway::report

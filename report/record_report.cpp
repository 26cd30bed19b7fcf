#include "report/record_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "correction/correction_subject.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "correction/step_response.h"
#include "record/digits.h"
#include "record/median.h"
#include "record/series_channel.h"
#include "report/detail/model_facts.h"
#include "report/detail/report_document.h"
#include "report/report.h"
#include "report/report_columns.h"
#include "results/diagnosis_results.h"
#include "text/number_text.h"

namespace raceway::report {
namespace {

constexpr double an_hour = 3600.0;
constexpr double far_apart = 10.0;     // of the usual time between rows: a gap
constexpr double between_runs = 0.02;  // of all time, where runs are drawn one after the other

/// When rows are drawn [s]. Runs whose clocks begin anew stand one after the other.
struct Axis {
  std::vector<double> time;
  std::vector<double> piece;  // number of the stretch without a gap that a row is in
  bool in_sequence = false;
};

Axis axis_of(const record::Record& record) {
  const correction::Series series(record);
  const std::span<const double> time = record.values(record::time);
  const std::vector<double>& steps = series.clock().steps;
  const std::vector<bool>& begins = series.clock().begins;
  Axis axis;
  std::vector<double> usual;
  double total = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (!begins[k]) usual.push_back(steps[k]);
    total += steps[k];
    axis.in_sequence = axis.in_sequence || (k > 0 && time[k] < time[k - 1]);
  }
  const double gap = usual.empty() ? 0.0 : far_apart * record::median(usual);
  double now = 0.0, piece = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double step = k == 0                          ? 0.0
                        : begins[k] && axis.in_sequence ? between_runs * total
                                                        : time[k] - time[k - 1];
    now += step;
    if (k > 0 && (begins[k] || step > gap)) piece += 1.0;
    axis.time.push_back(now);
    axis.piece.push_back(piece);
  }
  return axis;
}

/// The columns of a page, and what stands in which of them.
class Page {
 public:
  Page(Document& document, const record::Record& record)
      : document_(document), record_(record), axis_(axis_of(record)), columns_(record.rows()) {
    std::vector<double> lines, hours;
    for (std::size_t k = 0; k < record.rows(); ++k) {
      lines.push_back(record.line(k));
      hours.push_back(axis_.time[k] / an_hour);
    }
    columns_.add("line", std::move(lines));
    columns_.add("hours", std::move(hours));
    columns_.add("time_s", vector_of(record.values(record::time)));
    columns_.add("piece", axis_.piece);
    if (record.has(record::run)) columns_.add("run", vector_of(record.values(record::run)));
    add_inputs();
  }

  /// A correction with its displacement, or what else is predicted with each of its channels.
  void add(const DrawnModel& drawn) {
    if (dynamic_cast<const correction::CorrectionSubject*>(drawn.subject.get()))
      add_correction(drawn);
    else
      add_channels(drawn);
  }

  void finish() {
    document_.add("models", models_);
    document_.add("inputs", inputs_);
    document_.add("runs", record_.runs);
    document_.add("runs_in_sequence", axis_.in_sequence);
    document_.add_text("rows", columns_.json());
  }

 private:
  /// What pages say of one channel of a model. `channel_of_subject`: its place in measured().
  text::json channel_json(const DrawnModel& drawn, const record::Channel& channel,
                          std::size_t channel_of_subject, const std::vector<double>& predicted,
                          double tolerance) {
    const std::string number = std::to_string(models_.size());
    text::json one = {
        {"name", drawn.name},
        {"displacement", channel.name},
        {"in_words", channel.words},
        {"unit", channel.key_unit()},
        {"predicted", add_readings("predicted_" + number, channel, predicted)},
        {"tolerance", tolerance / channel.factor},
        {"defaults", files::short_lines(drawn.defaults)},
    };
    if (record_.has(channel)) {
      one["measured"] = measured(channel);
      columns_.keep_extremes(residual(channel, predicted));
      one["held_out_parts"] = held_out_parts(*drawn.subject);
    }
    if (text::json held = held_out(drawn, channel_of_subject, channel); !held.empty())
      one["held_out"] = std::move(held);
    return one;
  }

  void add_correction(const DrawnModel& drawn) {
    const correction::Model& model = correction::model_of(*drawn.subject);
    const std::string number = std::to_string(models_.size());
    text::json one = channel_json(drawn, *model.displacement, 0,
                                  fit::predict(*drawn.subject, record_), model.tolerance);
    one["initial_state"] = model.initial_state == correction::InitialState::free ? "free" : "rest";
    one["parts"] = parts(model, number);
    one["responses"] = responses(model);
    models_.push_back(std::move(one));
  }

  void add_channels(const DrawnModel& drawn) {
    const std::vector<double> all = fit::predict(*drawn.subject, record_);
    const std::vector<fit::Measured> measured = drawn.subject->measured();
    std::size_t read = 0;
    for (std::size_t c = 0; c < measured.size(); ++c) {
      if (!record_.has(*measured[c].channel)) continue;
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(c * record_.rows());
      const double tolerance = read < drawn.tolerances.size() ? drawn.tolerances[read] : unset;
      ++read;
      models_.push_back(channel_json(
          drawn, *measured[c].channel, c,
          std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(record_.rows())),
          tolerance));
    }
  }

  static std::vector<double> vector_of(std::span<const double> values) {
    return {values.begin(), values.end()};
  }

  std::string add_readings(const std::string& name, const record::Channel& channel,
                           std::vector<double> values) {
    for (double& v : values) v = channel.in_unit(v);
    const std::string column = fmt::format("{}_{}", name, channel.key_unit());
    columns_.add_course(column, std::move(values));
    return column;
  }

  void add_inputs() {
    for (const record::Column& c : record_.columns) {
      if (!c.channel->is_input()) continue;
      std::vector<double> values = c.values;
      for (double& v : values) v = text::value_in_unit(*c.channel, v);
      columns_.add_course(std::string(c.channel->name), std::move(values));
      inputs_.emplace_back(c.channel->name);
    }
  }

  std::string measured(const record::Channel& channel) {
    const std::string name = "measured_" + std::string(channel.name);
    if (std::find(measured_.begin(), measured_.end(), name) != measured_.end()) return name;
    measured_.push_back(name);
    std::vector<double> values = vector_of(record_.values(channel));
    for (double& v : values) v = channel.in_unit(v);
    columns_.add_course(name, std::move(values));
    return name;
  }

  [[nodiscard]] std::vector<double> residual(const record::Channel& channel,
                                             std::vector<double> predicted) const {
    for (std::size_t k = 0; k < predicted.size(); ++k) predicted[k] -= record_.value(channel, k);
    return predicted;
  }

  /// What drives a part, by its columns; the power of a friction table becomes one.
  text::json inputs_of_part(const correction::Input& input) {
    text::json names = text::json::array();
    for (const record::Channel* c : input.columns) names.push_back(c->name);
    if (input.reference) names.push_back(input.reference->name);
    return names;
  }

  text::json parts(const correction::Model& model, const std::string& number) {
    const correction::Series series(record_);
    text::json list = text::json::array();
    for (correction::Contribution& part : correction::contributions(model, series)) {
      text::json inputs = text::json::array();
      if (const auto* const c = correction::find_channel(model, part.name);
          c && !part.name.empty() && c->name == part.name)
        inputs =
            c->input.is_power() ? text::json::array({power(*c, series)}) : inputs_of_part(c->input);
      for (const correction::Effect& e : model.effects)
        if (correction::full_id(e) == part.name)
          inputs = inputs_of_part(correction::input_of(e, model));
      if (part.name == "kinematic" && inputs.empty()) inputs = {record::speed.name};
      const std::string column = fmt::format("part_{}_{}", number, list.size());
      list.push_back(
          {{"name", part.name},
           {"column", add_readings(column, *model.displacement, std::move(part.displacement))},
           {"inputs", std::move(inputs)}});
    }
    return list;
  }

  std::string power(const correction::DrivenChannel& c, const correction::Series& series) {
    const std::string name = "power_of_" + c.name + "_W";
    const bool known = std::find(inputs_.begin(), inputs_.end(), name) != inputs_.end();
    if (known) return name;
    columns_.add_course(name, *series.input(c.input));
    inputs_.push_back(name);
    return name;
  }

  /// In the unit of the displacement.
  [[nodiscard]] text::json responses(const correction::Model& model) const {
    const record::Channel& unit = *model.displacement;
    text::json list = text::json::array();
    for (const correction::StepResponse& r : correction::step_responses(model, record_)) {
      text::json parts = text::json::array(), sampled = text::json::array();
      for (const correction::StepResponse::Part& p : r.parts)
        parts.push_back({{"name", p.name},
                         {"gain", unit.in_unit(p.gain)},
                         {"time_constant_s", p.time_constant}});
      for (const double v : r.sampled) sampled.push_back(unit.in_unit(v));
      list.push_back({{"name", r.name},
                      {"input", r.input},
                      {"step", r.step},
                      {"unit", r.unit},
                      {"parts", std::move(parts)},
                      {"at_once", unit.in_unit(r.at_once)},
                      {"sensor_time_constant_s", r.sensor_time_constant},
                      {"sampled", std::move(sampled)},
                      {"sampling_s", r.sampling},
                      {"changed_by", r.changed_by}});
    }
    return list;
  }

  /// From when to when, in hours of the axis.
  [[nodiscard]] text::json held_out_parts(const fit::Subject& subject) const {
    text::json list = text::json::array();
    const std::vector<fit::Blocking> blockings = subject.blockings(record_);
    if (blockings.empty()) return list;
    const fit::Blocking& of = blockings.front();
    for (int part = 0; part < of.blocks; ++part) {
      double from = unset, to = unset;
      for (std::size_t k = 0; k < of.block.size(); ++k)
        if (of.block[k] == part) {
          from = std::fmin(from, axis_.time[k]);
          to = std::fmax(to, axis_.time[k]);
        }
      if (std::isfinite(from))
        list.push_back({{"part", part + 1}, {"from_h", from / an_hour}, {"to_h", to / an_hour}});
    }
    return list;
  }

  [[nodiscard]] text::json held_out(const DrawnModel& drawn, std::size_t channel_of_subject,
                                    const record::Channel& channel) const {
    text::json hours = text::json::array(), parts = text::json::array(),
               errors = text::json::array(), pieces = text::json::array();
    for (const fit::HeldOutReading& r : drawn.held_out) {
      if (r.channel != channel_of_subject) continue;
      hours.push_back(axis_.time[r.row] / an_hour);
      pieces.push_back(axis_.piece[r.row]);
      parts.push_back(r.part + 1);
      errors.push_back(record::with_digits(r.residual / channel.factor, 7));
    }
    if (hours.empty()) return {};
    return {{"hours", hours}, {"piece", pieces}, {"part", parts}, {"residual", errors}};
  }

  Document& document_;
  const record::Record& record_;
  Axis axis_;
  ReportColumns columns_;
  std::vector<std::string> inputs_, measured_;
  text::json models_ = text::json::array();
};

std::string joined_ids(const std::vector<std::string>& ids) {
  return fmt::format("{}", fmt::join(ids, " and "));
}

/// The refitted models of a fit: the first, and the others by another name.
template <typename Channels>
std::vector<DrawnModel> refitted(const std::vector<fit::Refit>& refits, const Channels& channels,
                                 const std::vector<files::UsedDefault>& defaults,
                                 const std::string& first, const std::string& others) {
  std::vector<double> tolerances;
  for (const auto& c : channels) tolerances.push_back(c.tolerance);
  std::vector<DrawnModel> models;
  for (const fit::Refit& refit : refits)
    models.push_back({.name = models.empty() ? first : others,
                      .subject = refit.subject,
                      .held_out = refit.held_out,
                      .defaults = defaults,
                      .tolerances = tolerances});
  return models;
}

}  // namespace

std::string record_report(const std::string& command, const std::string& results,
                          const record::Record& record, const std::vector<DrawnModel>& models,
                          const std::vector<ModelOfPage>& facts,
                          const std::vector<model::ModelChanges>& changes) {
  Document document("record");
  document.add("command", command);
  document.add("assumed", model_facts(facts));
  document.add("steps", changes_json(changes));
  document.add_text("results", results);
  Page page(document, record);
  for (const DrawnModel& one : models) page.add(one);
  page.finish();
  return report_page(document.text());
}

std::string record_diagnosis_report(const std::string& model_file, const record::Record& record,
                                    const verdict::Diagnosis& d,
                                    const std::vector<files::UsedDefault>& defaults,
                                    const std::vector<ModelOfPage>& facts) {
  return record_report("diagnose", results::diagnosis_json(model_file, record, d), record,
                       refitted(d.refits, d.channels, defaults, "refitted, no effect added",
                                d.sets.empty() ? "" : "with " + joined_ids(d.sets.front())),
                       facts);
}

std::string record_add_report(const std::string& model_file, const record::Record& record,
                              const verdict::AddResult& r,
                              const std::vector<files::UsedDefault>& defaults,
                              const std::vector<ModelOfPage>& facts) {
  return record_report("add", results::add_json(model_file, record, r), record,
                       refitted(r.refits, r.channels, defaults, "before, refitted", "after"),
                       facts);
}

}  // namespace raceway::report

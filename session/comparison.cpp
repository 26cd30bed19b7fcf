#include "session/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/calibrate.h"
#include "fit/several_records.h"
#include "io/error.h"
#include "io/results.h"
#include "io/subject.h"
#include "model/model_changes.h"
#include "model/row.h"
#include "rig/torque_sensor.h"
#include "session/open_input.h"

namespace raceway::session {
namespace {

/// What the rows lack is filled in from the first model; another rig would need other rows.
void note_other_rigs(Messages& messages, const std::vector<io::ModelFile>& files) {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const model::Rig& first = files[0].model.rig;
  for (const io::ModelFile& file : files) {
    const model::Rig& rig = file.model.rig;
    if (!same(rig.inertia, first.inertia) || !same(rig.axial_load, first.axial_load) ||
        !same(rig.radial_load, first.radial_load) || !same(rig.temperature, first.temperature) ||
        !same(rig.minimum_speed, first.minimum_speed))
      messages.warn(
          fmt::format("{}: its [rig] differs from that of {}, which is used for all models",
                      file.source, files[0].source));
    const auto& shaft = file.model.shaft;
    const auto& first_shaft = files[0].model.shaft;
    if (shaft && first_shaft && shaft->external_load != first_shaft->external_load)
      messages.warn(
          fmt::format("{}: its external_load_N differs from that of {}, which is used for all "
                      "models",
                      file.source, files[0].source));
  }
}

/// A model as it is compared.
struct Refitted {
  std::shared_ptr<const fit::Subject> subject;
  int fitted = 0;  // parameters
};

/// The model with the parameters that are named fitted to the data and everything else as it
/// stands.
Refitted refitted(Messages& messages, const model::Model& model,
                  const std::vector<std::string>& refit, const PerRecord& per_record,
                  const record::Record& data) {
  model::Model wanted = model;
  std::vector<std::string> names = refit;
  for (const std::string& own : per_record.names)
    if (std::find(names.begin(), names.end(), own) == names.end()) names.push_back(own);
  if (!names.empty()) wanted.free = names;
  auto subject = per_record.subject(wanted, data);
  if (names.empty()) return {std::move(subject)};
  const fit::Calibration calibration = fit::calibrate(*subject, data);
  if (!calibration.converged())
    throw std::invalid_argument("the refit of " + fmt::format("{}", fmt::join(names, ", ")) +
                                " does not converge");
  messages.warnings(calibration.messages);
  return {calibration.subject, static_cast<int>(calibration.parameters.size())};
}

/// Its numbers; as in the file where each record has its own.
const model::Model& model_of(const fit::Subject& subject) {
  const auto* const several = dynamic_cast<const fit::SeveralRecords*>(&subject);
  return model::model_of(several ? several->shared() : subject);
}

/// Why the model predicts nothing for a row.
std::string why_not_predicted(const model::Model& model, const record::Record& data,
                              std::size_t row) {
  if (model.spindle) return "the simulation ends there, without equilibrium or by thermal runaway";
  if (model.shaft) return "no equilibrium";
  const model::Row asked = model::rows_of(data)[row];
  const model::FrictionPrediction p =
      model::predict_friction(model, asked.point, false, asked.record);
  return p.status() == bearing::SolveStatus::no_equilibrium ? "no equilibrium"
                                                            : why_not_converged(model, p);
}

void tell_not_predicted(Messages& messages, const std::string& file, const model::Model& model,
                        const std::vector<fit::Comparison>& comparisons,
                        const record::Record& data) {
  for (const fit::Comparison& c : comparisons)
    if (const auto& missing = c.rows_not_predicted; !missing.empty())
      messages.warn(fmt::format(
          "{}: {} rows{} have no prediction and are left out, the first in {}: {}", file,
          missing.size(), comparisons.size() > 1 ? fmt::format(" of {}", c.channel->words) : "",
          data.place(missing.front()), why_not_predicted(model, data, missing.front())));
}

/// The records are read by the sensor of the first model, whatever the others say.
void warn_of_other_sensors(Messages& messages, const std::vector<io::ModelFile>& files) {
  const io::ModelFile& first = files.front();
  for (const io::ModelFile& file : files)
    if (file.sensor && !(first.sensor && rig::same_torques(*file.sensor, *first.sensor)))
      messages.warn(
          fmt::format("{}: its [torque_sensor] is not that of {}, by which the data are read",
                      file.source, first.source));
}

}  // namespace

std::string ComparedModels::json() const { return io::comparison_json(names, comparisons, data); }

std::string ComparedModels::page() const {
  if (subject->approximates())
    return io::record_report("compare", json(), data, drawn, facts, model::changes_between(models));
  return io::comparison_report(names, models, comparisons, data, facts);
}

std::vector<io::ModelFile> open_models(Messages& messages, const std::vector<Source>& models,
                                       const LoopOptions& options) {
  std::vector<io::ModelFile> files;
  for (const Source& source : models) {
    files.push_back(open_model(messages, source, Accepts::rig_or_shaft));
    if (options.amend) options.amend(files.back(), files.size() - 1);
    options.tolerance.set(files.back());
    if (!files.back().model.shaft) warn_of_ignored_data(messages, files.back());
  }
  note_other_rigs(messages, files);
  return files;
}

ComparedModels compare_models(Messages& messages, const std::vector<io::ModelFile>& files,
                              const std::vector<Source>& data,
                              const std::vector<std::string>& refit, const LoopOptions& options) {
  ComparedModels result;
  for (const io::ModelFile& file : files) {
    refuse_for_spindle(file.model, options.displacement.empty()
                                       ? std::vector<std::string>()
                                       : std::vector<std::string>{"--displacement"});
    if (file.model.spindle.has_value() != files.front().model.spindle.has_value())
      throw io::InputError(file.source + ": a spindle is compared with spindles alone",
                           {.file = file.source});
    result.names.push_back(file.source);
  }
  result.data =
      open_records(messages, data, result.names.front(), *io::make_subject(files.front().model),
                   options.reading.options(files.front()));
  warn_of_other_sensors(messages, files);
  for (const io::ModelFile& file : files) {
    try {
      const Refitted one = refitted(messages, file.model, refit, options.per_record, result.data);
      result.subject = one.subject;
      result.models.push_back(model_of(*one.subject));
      result.comparisons.push_back(fit::compare(*one.subject, result.data, one.fitted));
    } catch (const std::invalid_argument& e) {
      refuse_data(file.source, result.data, e);
    }
    result.drawn.push_back({.name = file.source, .subject = result.subject, .tolerances = {}});
    for (const fit::Comparison& c : result.comparisons.back())
      result.drawn.back().tolerances.push_back(c.tolerance);
    result.facts.push_back(of_page(file, result.models.back()));
    tell_not_predicted(messages, file.source, file.model, result.comparisons.back(), result.data);
  }
  // The noise is that of the data: one for all models, by the last.
  for (std::vector<fit::Comparison>& of_model : result.comparisons)
    fit::estimate_unknown_noise(*result.subject, result.data, of_model);
  if (!refit.empty())
    messages.note(fmt::format("{} refitted to {} in each model; all else as in the files",
                              fmt::join(refit, " and "), result.data.source));
  if (!options.per_record.names.empty())
    messages.note(fmt::format("{} refitted to each record by itself in each model",
                              fmt::join(options.per_record.names, " and ")));
  return result;
}

}  // namespace raceway::session

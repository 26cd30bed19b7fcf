#include "session/bearing_in_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "effects/formula.h"
#include "effects/oil_card.h"
#include "files/subject.h"
#include "files/suggest_columns.h"
#include "fit/several_records.h"
#include "model/corrected_data.h"
#include "model/parameters.h"
#include "model/row.h"
#include "report/record_report.h"
#include "rig/torque_sensor.h"
#include "spindle/spindle_subject.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {
namespace {

/// What of a covariance concerns one record, by the names of its model.
fit::Covariance of_record(const fit::Covariance& all, const fit::SeveralRecords& several,
                          std::size_t record) {
  fit::Covariance own;
  std::vector<Eigen::Index> rows;
  for (std::size_t k = 0; k < all.names.size(); ++k)
    if (std::string name = several.name_in(record, all.names[k]); !name.empty()) {
      own.names.push_back(std::move(name));
      rows.push_back(static_cast<Eigen::Index>(k));
    }
  own.values = all.values(rows);
  own.matrix = all.matrix(rows, rows);
  return own;
}

/// Names of the covariance that are no parameters of the model as it is written: data that are put
/// right where they stand.
std::vector<std::string> corrected(const model::Model& model) {
  const std::vector<record::Parameter> known = model::parameters(model::with_corrected_data(model));
  std::vector<std::string> names;
  for (const std::string& name : model.covariance->names)
    if (std::none_of(known.begin(), known.end(), [&](const auto& p) { return p.name == name; }))
      names.push_back(name);
  return names;
}

/// The model of one record as the fit has left it, with the covariance of what was fitted.
model::Model model_of_record(const verdict::Calibration& calibration, std::size_t record) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  model::Model model =
      of ? model::model_of(*of->model_of(record)) : model::model_of(*calibration.subject);
  model.covariance = verdict::covariance_of(calibration);
  if (model.covariance && of) model.covariance = of_record(*model.covariance, *of, record);
  return model;
}

bool is_own(const effects::Effect& effect) {
  const effects::OwnMoment* const moment = effect.description->user_made;
  return moment && !moment->stands_in_files();
}

/// Takes the effects out that no file can say; a covariance in which they have a part goes, too.
std::vector<FittedTexts::OwnEffect> take_own_effects(model::Model& model) {
  std::vector<FittedTexts::OwnEffect> own;
  for (const effects::Effect& effect : model.effects)
    if (is_own(effect)) own.push_back({std::string(effect.description->id), effect.values});
  std::erase_if(model.effects, is_own);
  const auto belongs = [&](const std::string& name) {
    return std::any_of(own.begin(), own.end(),
                       [&](const auto& effect) { return name.starts_with(effect.id + "."); });
  };
  if (model.covariance &&
      std::any_of(model.covariance->names.begin(), model.covariance->names.end(), belongs))
    model.covariance.reset();
  return own;
}

/// Its numbers; those of the file where each record has its own.
const model::Model& model_of(const fit::Subject& subject) {
  const auto* const several = dynamic_cast<const fit::SeveralRecords*>(&subject);
  return model::model_of(several ? several->shared() : subject);
}

/// Why the model predicts nothing for a row.
std::string why_not_predicted(const model::Model& model, const record::Record& data,
                              std::size_t row) {
  if (model.spindle)
    return "the simulation ends at this row, because the spindle has no equilibrium or heats up "
           "without limit";
  if (model.shaft) return "no equilibrium";
  const model::Row asked = model::rows_of(data)[row];
  const model::FrictionPrediction p =
      model::predict_friction(model, asked.point, false, asked.record);
  return p.status() == bearing::SolveStatus::no_equilibrium ? "no equilibrium"
                                                            : why_not_converged(model, p);
}

void tell_not_predicted(Messages& messages, const std::string& file, const model::Model& model,
                        const std::vector<verdict::Comparison>& comparisons,
                        const record::Record& data) {
  for (const verdict::Comparison& c : comparisons)
    if (const auto& missing = c.rows_not_predicted; !missing.empty())
      messages.say(record::note::no_prediction(
          fmt::format(
              "{}: no prediction for {} of {} rows{}, which are left out; the first is in {}: {}",
              file, missing.size(), data.rows(),
              comparisons.size() > 1 ? fmt::format(" of {}", c.channel->words) : "",
              data.place(missing.front()), why_not_predicted(model, data, missing.front())),
          {.file = file}));
}

/// The model with effects switched on of which a number is named and that it does not have, as the
/// oil of each record.
model::Model with_named(const model::Model& model, const fit::Subject& alone, const Names& own) {
  const std::vector<record::Parameter> known = alone.parameters();
  Names ids;
  for (const fit::Candidate& c : alone.candidates())
    if (std::any_of(c.parameters.begin(), c.parameters.end(), [&](const record::Parameter& p) {
          return std::find(own.begin(), own.end(), p.name) != own.end() &&
                 std::none_of(known.begin(), known.end(),
                              [&](const record::Parameter& k) { return k.name == p.name; });
        }))
      ids.push_back(c.id);
  return ids.empty() ? model : model::model_of(*alone.with_candidates(ids));
}

/// A model as the loop sees it: of one record, or of several that were joined. What is named has a
/// value in each of them and is free, whether or not it is in the model.
std::shared_ptr<const fit::Subject> subject_of(const model::Model& model,
                                               const record::Record& data, const Names& own) {
  const auto fail = [](const std::string& why) {
    throw text::InputError("--per-record" + why, {.key = "--per-record"});
  };
  // Runs of all records of a spindle are simulated by themselves.
  if (model.spindle && !own.empty())
    fail(
        ": a spindle has the same parameters for all records; calibrate it with each record "
        "separately");
  if (data.parts.empty() && !own.empty())
    fail(
        fmt::format(" {}: {} is the only record, but --per-record needs several records; name at "
                    "least two files of measurements",
                    fmt::join(own, ","), data.source));
  const std::shared_ptr<const fit::Subject> alone = files::make_subject(model, data);
  if (model.spindle || data.parts.empty()) return alone;
  // Free in the model too, so that an effect of which a number is named counts as one to be learnt.
  model::Model wanted = with_named(model, *alone, own);
  wanted.free = alone->free();
  for (const std::string& name : own)
    if (std::find(wanted.free.begin(), wanted.free.end(), name) == wanted.free.end())
      wanted.free.push_back(name);
  try {
    const std::shared_ptr<const fit::Subject> subject = files::make_subject(wanted, data);
    (void)fit::find_parameters(*subject, own);
    return std::make_shared<fit::SeveralRecords>(subject, data, own);
  } catch (const std::invalid_argument& e) {
    fail(fmt::format(": {}", e.what()));
    throw;
  }
}

/// Says which runs of a spindle begin warm.
std::vector<record::Note> tell_of_warm_starts(Messages& messages, const fit::Subject& subject,
                                              const record::Record& data) {
  const auto* const spindle = dynamic_cast<const spindle::SpindleSubject*>(&subject);
  if (!spindle) return {};
  std::vector<record::Note> notes =
      notes_of(record::note::assumed, spindle->warm_starts(data), {.file = data.source});
  messages.say(notes);
  return notes;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// The model of a file. Where that names no free numbers, they are those that are usual for a
/// record.
model::Model with_usual_free(const files::ModelFile& file) {
  model::Model model = file.model;
  if (std::any_of(file.defaults.begin(), file.defaults.end(), [](const files::UsedDefault& d) {
        return d.table == "calibration" && d.key == "free";
      }))
    model.free.clear();
  return model;
}

/// True of a file whose author has no data sheet of the oil.
bool assumes_viscosity_slope(const files::ModelFile& file) {
  return std::any_of(file.defaults.begin(), file.defaults.end(), [](const files::UsedDefault& d) {
    return d.origin == files::UsedDefault::Origin::marked && d.table == "lubricant" &&
           d.key == "viscosity_100C_mm2_s";
  });
}

/// True where a record determines a number well enough to replace a guess of it.
bool is_determined(const fit::Subject& subject, const record::Record& data,
                   const std::string& name) {
  // The viscosity indices 95 and 150 differ by 0.13. Our choice: the fit must know better.
  constexpr double largest_std = 0.05;
  try {
    const verdict::Calibration found = verdict::calibrate_by_noise(subject, data);
    const auto p = std::find_if(found.parameters.begin(), found.parameters.end(),
                                [&](const record::Parameter& one) { return one.name == name; });
    // An effect that is missing still widens the standard error; the verdict is without it.
    const double by_misfit = std::isnan(found.reduced_chi_square) ? 1.0 : found.error_factor;
    return found.converged() && p != found.parameters.end() && p->identifiable &&
           p->std / by_misfit <= largest_std;
  } catch (const std::invalid_argument&) {
    return false;  // too few rows
  }
}

class BearingInLoop final : public LoopModel {
 public:
  BearingInLoop(files::ModelFile file, Defaults defaults)
      : LoopModel({.source = file.source,
                   .name = file.model.name,
                   .defaults = file.defaults,
                   .notes = file.notes,
                   .files = file.files}),
        file_(std::move(file)),
        written_(files::make_subject(with_usual_free(file_))),
        defaults_(defaults) {}

  std::shared_ptr<const fit::Subject> as_written(const record::Record& data) const override {
    return files::make_subject(written_->model(), data);
  }

  record::Record read(Messages& messages, const std::vector<Source>& data, const Reading& reading,
                      const LoopModels&) const override {
    return open_records(messages, data, file_.source, *written_, reading.options(file_));
  }

  std::shared_ptr<const fit::Subject> for_fit(Messages& messages, record::Record& data,
                                              const Names& per_record) const override {
    append(data.notes, tell_of_warm_starts(messages, *written_, data));
    return subject_of(written_->model(), data, per_record);
  }

  std::shared_ptr<const fit::Subject> with_assumed_free(
      std::shared_ptr<const fit::Subject> prepared, const record::Record& data,
      const Names& per_record) const override {
    const std::string id(effects::ViscositySlope::id);
    const std::vector<fit::Candidate> known = written_->candidates();
    const bool possible = std::any_of(known.begin(), known.end(),
                                      [&](const fit::Candidate& c) { return c.id == id; });
    if (!assumes_viscosity_slope(file_) || written_->model().spindle || !possible ||
        !prepared->lacks(id, data).empty() || !prepared->lacks_levels(id, data).empty())
      return prepared;
    const std::string factor =
        fmt::format("{}.{}", id, effects::ViscositySlope::parameters.front().name);
    model::Model wanted = model::model_of(*written_->with_candidates(std::array{id}));
    wanted.free = prepared->free();
    wanted.free.push_back(factor);
    std::shared_ptr<const fit::Subject> subject = subject_of(wanted, data, per_record);
    return is_determined(*subject, data, factor) ? subject : prepared;
  }

  Names meant(const Names& effects, const record::Record&) const override { return effects; }

  void stand_beside(Messages& messages, const LoopModel& other) const override {
    if (!file_.model.shaft && defaults_ == Defaults::count) warn_of_ignored_data(messages, file_);
    const auto* const first = dynamic_cast<const BearingInLoop*>(&other);
    if (!first)
      throw text::InputError(file_.source +
                                 ": the model has no [correction]; a correction can only be "
                                 "compared with other corrections",
                             {.file = file_.source, .key = "correction"});
    if (file_.model.spindle.has_value() != first->file_.model.spindle.has_value())
      throw text::InputError(
          file_.source + ": the model cannot be compared: all models must be spindles, or none",
          {.file = file_.source});
    warn_of_other_rig(messages, first->file_);
  }

  ComparedModel compared(Messages& messages, const record::Record& data, const CompareOptions& how,
                         const Names& per_record) const override {
    if (how.zero != "mean")
      throw text::InputError("--zero is only for corrections; remove it for other models",
                             {.key = "--zero"});
    model::Model wanted = written_->model();
    Names names = how.refit;
    for (const std::string& own : per_record)
      if (std::find(names.begin(), names.end(), own) == names.end()) names.push_back(own);
    if (!names.empty()) wanted.free = names;
    (void)tell_of_warm_starts(messages, *written_, data);
    ComparedModel result{.subject = subject_of(wanted, data, per_record)};
    int fitted = 0;
    if (!names.empty()) {
      const verdict::Calibration calibration = refitted(messages, *result.subject, data, names);
      result.subject = calibration.subject;
      fitted = static_cast<int>(calibration.parameters.size());
    }
    result.errors = verdict::compare(*result.subject, data, fitted);
    result.facts = of_page(file_, model_of(*result.subject));
    result.drawn = {.name = file_.source, .subject = result.subject};
    for (const verdict::Comparison& c : result.errors)
      result.drawn.tolerances.push_back(c.tolerance);
    tell_not_predicted(messages, file_.source, file_.model, result.errors, data);
    return result;
  }

  std::optional<correction::RecordCheck> over_time(const record::Record&) const override {
    return std::nullopt;
  }

  std::string suggested_columns(const Source& data) const override {
    if (!data.beside.empty())
      throw text::InputError(
          "--suggest-columns proposes columns of several files only for a correction; propose a "
          "map for each file",
          {.key = "--beside"});
    return files::suggested_columns(data, *files::make_subject(file_.model));
  }

  std::string page(const record::Record& data, const verdict::Diagnosis& found) const override {
    if (written_->approximates())
      return report::record_diagnosis_report(file_.source, data, found, {},
                                             {of_page(file_, file_.model)});
    return report::diagnosis_report(file_.source, *written_, data, found,
                                    {of_page(file_, file_.model)});
  }

  std::string page(const record::Record& data, const verdict::AddResult& found) const override {
    const std::vector<report::ModelOfPage> used{
        of_page(file_, model_of(*found.calibration.subject))};
    if (written_->approximates())
      return report::record_add_report(file_.source, data, found, {}, used);
    return report::add_report(file_.source, data, found, used);
  }

  FittedTexts fitted_texts(const record::Record&,
                           const verdict::Calibration& found) const override {
    FittedTexts result{.records = records_apart(*found.subject)};
    files::ModelFile written = file_;
    (void)take_own_effects(written.model);
    for (std::size_t k = 0; k < std::max<std::size_t>(1, result.records.size()); ++k) {
      model::Model model = model_of_record(found, k);
      // What is left without them would be another covariance.
      if (model.covariance)
        if (Names data = corrected(model); !data.empty()) {
          model.covariance.reset();
          result.corrected_data = std::move(data);
        }
      result.own_effects.push_back(take_own_effects(model));
      result.texts.push_back(files::with_model(written, model));
    }
    return result;
  }

 private:
  /// What the rows lack is filled in from the first model; another rig would need other rows. They
  /// are read by its sensor, too.
  void warn_of_other_rig(Messages& messages, const files::ModelFile& first) const {
    const model::Rig& rig = file_.model.rig;
    const model::Rig& of_first = first.model.rig;
    const auto warn = [&](const std::string& what) {
      messages.say(record::note::other_rig(fmt::format("{}: its {}", file_.source, what),
                                           {.file = file_.source}));
    };
    if (!same(rig.inertia, of_first.inertia) || !same(rig.axial_load, of_first.axial_load) ||
        !same(rig.radial_load, of_first.radial_load) ||
        !same(rig.temperature, of_first.temperature) ||
        !same(rig.minimum_speed, of_first.minimum_speed))
      warn(fmt::format(
          "[rig] differs from [rig] of {0}; the comparison uses [rig] of {0} for all models",
          first.source));
    const auto& shaft = file_.model.shaft;
    if (shaft && first.model.shaft && shaft->external_load != first.model.shaft->external_load)
      warn(fmt::format(
          "external_load_N differs from external_load_N of {0}; the comparison uses the "
          "value of {0} for all models",
          first.source));
    if (file_.sensor && !(first.sensor && rig::same_torques(*file_.sensor, *first.sensor)))
      warn(
          fmt::format("[torque_sensor] differs from [torque_sensor] of {0}; the program converts "
                      "all torque signals with [torque_sensor] of {0}",
                      first.source));
  }

  files::ModelFile file_;
  std::shared_ptr<const model::ModelSubject> written_;
  Defaults defaults_;
};

}  // namespace

std::unique_ptr<LoopModel> open_bearing(Messages& messages, const Source& source,
                                        const LoopOptions& options, std::size_t place) {
  files::ModelFile file = open_model(messages, source, Accepts::rig_or_shaft, options.defaults);
  if (options.amend) options.amend(file, place);
  options.tolerance.set(file);
  Names known;
  for (const fit::Measured& m : files::measurable(file.model)) known.emplace_back(m.channel->name);
  if (!options.channel.empty() &&
      std::find(known.begin(), known.end(), options.channel) == known.end())
    throw text::InputError(
        fmt::format("--channel {}: {} does not predict this channel; it predicts {}",
                    options.channel, file.source, text::listed(known)),
        {.file = file.source, .key = "--channel"});
  return std::make_unique<BearingInLoop>(std::move(file), options.defaults);
}

}  // namespace raceway::session

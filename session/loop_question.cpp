#include "session/loop_question.h"

#include <algorithm>
#include <utility>

#include "effects/formula.h"
#include "fit/several_records.h"
#include "io/record_report.h"
#include "io/subject.h"
#include "model/corrected_data.h"
#include "model/parameters.h"
#include "session/open_input.h"

namespace raceway::session {

std::vector<io::ModelOfPage> LoopQuestion::facts() const { return {of_page(file, file.model)}; }

LoopQuestion ask(Messages& messages, const Source& model, const std::vector<Source>& data,
                 const LoopOptions& options) {
  io::ModelFile file = open_model(messages, model, Accepts::rig_or_shaft);
  refuse_for_spindle(file.model, options.displacement.empty()
                                     ? std::vector<std::string>()
                                     : std::vector<std::string>{"--displacement"});
  if (options.amend) options.amend(file, 0);
  options.tolerance.set(file);
  const auto written = io::make_subject(file.model);
  record::Record record =
      open_records(messages, data, model.name, *written, options.reading.options(file));
  auto subject = options.per_record.subject(file.model, record);
  return {.file = std::move(file),
          .data = std::move(record),
          .model = written,
          .subject = std::move(subject)};
}

std::string diagnosis_page(const LoopQuestion& asked, const fit::Diagnosis& diagnosis) {
  if (asked.subject->approximates())
    return io::record_diagnosis_report(asked.file.source, asked.data, diagnosis, {}, asked.facts());
  return io::diagnosis_report(asked.file.source, *asked.model, asked.data, diagnosis,
                              asked.facts());
}

std::string add_page(const LoopQuestion& asked, const fit::AddResult& result) {
  const std::vector<io::ModelOfPage> facts{of_page(asked.file, fitted_model(result.calibration))};
  if (asked.subject->approximates())
    return io::record_add_report(asked.file.source, asked.data, result, {}, facts);
  return io::add_report(asked.file.source, asked.data, result, facts);
}

namespace {

/// The subject where records have values of their own, else null.
const fit::SeveralRecords* several(const fit::Subject& subject) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(&subject);
  return of && !of->own().empty() ? of : nullptr;
}

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
model::Model model_of_record(const fit::Calibration& calibration, std::size_t record) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  model::Model model =
      of ? model::model_of(*of->model_of(record)) : model::model_of(*calibration.subject);
  model.covariance = fit::covariance_of(calibration);
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

}  // namespace

const model::Model& fitted_model(const fit::Calibration& calibration) {
  const auto* const of = dynamic_cast<const fit::SeveralRecords*>(calibration.subject.get());
  return model::model_of(of ? of->shared() : *calibration.subject);
}

std::vector<std::string> records_apart(const fit::Subject& subject) {
  const fit::SeveralRecords* const of = several(subject);
  if (!of) return {};
  return {of->records().begin(), of->records().end()};
}

FittedTexts fitted_texts(const io::ModelFile& file, const fit::Calibration& calibration) {
  FittedTexts result;
  result.records = records_apart(*calibration.subject);
  io::ModelFile written = file;
  (void)take_own_effects(written.model);
  for (std::size_t k = 0; k < std::max<std::size_t>(1, result.records.size()); ++k) {
    model::Model model = model_of_record(calibration, k);
    // What is left without them would be another covariance.
    if (model.covariance)
      if (std::vector<std::string> data = corrected(model); !data.empty()) {
        model.covariance.reset();
        result.corrected_data = std::move(data);
      }
    result.own_effects.push_back(take_own_effects(model));
    result.texts.push_back(io::with_model(written, model));
  }
  return result;
}

}  // namespace raceway::session

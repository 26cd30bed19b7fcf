#include "session/correction_in_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "correction/alignment.h"
#include "correction/correction_subject.h"
#include "correction/phases.h"
#include "correction/series.h"
#include "files/suggest_columns.h"
#include "report/record_report.h"
#include "session/correction_input.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::session {
namespace {

correction::Zero zero_of(const std::string& zero) {
  return zero == "first"  ? correction::Zero::first
         : zero == "none" ? correction::Zero::none
                          : correction::Zero::mean;
}

class CorrectionInLoop final : public LoopModel {
 public:
  /// `index`: of the model in the file.
  CorrectionInLoop(files::CorrectionFile file, std::size_t index)
      : LoopModel({.source = file.source,
                   .name = file.models[index].name,
                   .defaults = file.defaults,
                   .notes = file.notes,
                   .files = file.files}),
        file_(std::move(file)),
        index_(index) {}

  std::shared_ptr<const fit::Subject> as_written(const record::Record&) const override {
    return std::make_shared<correction::CorrectionSubject>(model());
  }

  record::Record read(Messages& messages, const std::vector<Source>& data, const Reading& reading,
                      const LoopModels& compared_with) const override {
    if (data.size() != 1)
      throw text::InputError(
          "a correction is compared with one record only. Put several runs of a machine into one "
          "file with a column run_id, and name further files of the same run with --beside",
          {.key = "DATA"});
    std::vector<correction::Model> models{model()};
    for (const auto& other : compared_with)
      if (const auto* const one = dynamic_cast<const CorrectionInLoop*>(other.get()); one != this)
        models.push_back(one->model());
    record::Record record =
        open_series(messages, data.front(), models, reading.options(file_.columns), reading.period);
    for (const correction::Model& one : models) require_readings(one, record);
    return record;
  }

  std::shared_ptr<const fit::Subject> for_fit(Messages& messages, record::Record& data,
                                              const Names& per_record) const override {
    refuse(per_record);
    prepare_fit(messages, model(), file_.source, data);
    return as_written(data);
  }

  Names meant(const Names& effects, const record::Record& data) const override {
    const auto informed = as_written(data)->informed_by(data);
    const auto& on_this_record = dynamic_cast<const correction::CorrectionSubject&>(*informed);
    Names list;
    for (const std::string& name : effects) list.push_back(on_this_record.meant_by(name));
    return list;
  }

  void stand_beside(Messages&, const LoopModel& first) const override {
    if (!dynamic_cast<const CorrectionInLoop*>(&first))
      throw text::InputError(first.about().source +
                                 ": the model has no [correction]; a correction can only be "
                                 "compared with other corrections",
                             {.file = first.about().source, .key = "correction"});
  }

  ComparedModel compared(Messages& messages, const record::Record& data, const CompareOptions& how,
                         const Names& per_record) const override {
    refuse(per_record);
    ComparedModel result;
    int fitted = 0;
    if (how.refit.empty()) {
      result.subject = correction::aligned(model(), data, zero_of(how.zero));
    } else {
      correction::Model wanted = model();
      wanted.free = how.refit;
      if (std::find(wanted.free.begin(), wanted.free.end(), "offset") == wanted.free.end())
        wanted.free.emplace_back("offset");
      const verdict::Calibration found =
          refitted(messages, correction::CorrectionSubject(wanted), data, how.refit);
      result.subject = found.subject;
      fitted = static_cast<int>(found.parameters.size());
    }
    messages.say(notes_of(record::note::assumed, fitted_start(model()), {.file = data.source}));
    result.errors = verdict::compare(*result.subject, data, fitted);
    for (verdict::Comparison& c : result.errors)
      verdict::add_groups(c, correction::phase, correction::phases(data, *c.channel));
    result.drawn = {.name = file_.source,
                    .subject = result.subject,
                    .held_out = {},
                    .defaults = file_.defaults};
    if (const std::string leaves = correction::beyond_element(model(), data); !leaves.empty())
      messages.say(record::note::no_prediction(
          fmt::format("{}: {}: the rows from this row on have no prediction and are not used",
                      file_.source, leaves),
          {.file = data.source}));
    const correction::Series series(data);
    result.beyond = correction::beyond_range(model(), series);
    messages.say(notes_of(record::note::beyond_range, range_notes(model(), series, *result.beyond),
                          {.file = data.source}));
    return result;
  }

  std::optional<correction::RecordCheck> over_time(const record::Record& data) const override {
    return correction::check_record(model(), data);
  }

  std::string suggested_columns(const Source& data) const override {
    return files::suggested_columns(data, file_.models);
  }

  std::string page(const record::Record& data, const verdict::Diagnosis& found) const override {
    return report::record_diagnosis_report(file_.source, data, found, file_.defaults);
  }

  std::string page(const record::Record& data, const verdict::AddResult& found) const override {
    return report::record_add_report(file_.source, data, found, file_.defaults);
  }

  FittedTexts fitted_texts(const record::Record& data,
                           const verdict::Calibration& found) const override {
    std::vector<correction::Model> models = file_.models;
    models[index_] = correction::trusted(found, data);
    return {.records = {},
            .texts = {files::with_corrections(file_, models)},
            .corrected_data = {},
            .own_effects = {{}}};
  }

 private:
  const correction::Model& model() const { return file_.models[index_]; }

  static void refuse(const Names& per_record) {
    if (!per_record.empty())
      throw text::InputError(
          "--per-record: a correction is compared with one record only; remove the flag",
          {.key = "--per-record"});
  }

  files::CorrectionFile file_;
  std::size_t index_;
};

}  // namespace

std::unique_ptr<LoopModel> open_correction(Messages& messages, const Source& source,
                                           const LoopOptions& options) {
  files::CorrectionFile file = open_corrections(messages, source, options.defaults);
  Names known;
  for (const correction::Model& m : file.models) known.emplace_back(m.displacement->name);
  if (options.channel.empty() && known.size() > 1)
    throw text::InputError(
        fmt::format("{}: the model has several [[correction]]; choose one with --channel {}",
                    file.source, fmt::join(known, " or ")),
        {.file = file.source, .key = "--channel"});
  const auto chosen = options.channel.empty()
                          ? known.begin()
                          : std::find(known.begin(), known.end(), options.channel);
  if (chosen == known.end())
    throw text::InputError(fmt::format("--channel {}: {} does not model this channel; it models {}",
                                       options.channel, file.source, text::listed(known)),
                           {.file = file.source, .key = "--channel"});
  const auto index = static_cast<std::size_t>(chosen - known.begin());
  options.tolerance.set(file.models[index], file.source);
  return std::make_unique<CorrectionInLoop>(std::move(file), index);
}

}  // namespace raceway::session

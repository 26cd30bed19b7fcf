#include "session/correction_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "correction/phases.h"
#include "correction/series.h"
#include "fit/calibrate.h"
#include "io/error.h"
#include "io/results.h"
#include "session/open_input.h"

namespace raceway::session {

CorrectionLoop ask_correction_loop(Messages& messages, const Source& model,
                                   const std::vector<Source>& data, const LoopOptions& options) {
  CorrectionLoop asked{
      ask_correction(messages, model, data, options.displacement, options.reading)};
  options.tolerance.set(asked.model, asked.file.source);
  prepare_fit(messages, asked.model, asked.file.source, asked.data);
  asked.subject = std::make_shared<correction::CorrectionSubject>(asked.model);
  return asked;
}

std::vector<std::string> meant(const CorrectionLoop& asked, const std::vector<std::string>& ids) {
  std::vector<std::string> list;
  try {
    const auto informed = asked.subject->informed_by(asked.data);
    const auto& on_this_record = dynamic_cast<const correction::CorrectionSubject&>(*informed);
    for (const std::string& id : ids) list.push_back(on_this_record.meant_by(id));
  } catch (const std::invalid_argument& e) {
    refuse_data(asked.file.source, asked.data, e);
  }
  return list;
}

std::string diagnosis_page(const CorrectionLoop& asked, const fit::Diagnosis& diagnosis) {
  return io::record_diagnosis_report(asked.file.source, asked.data, diagnosis, asked.file.defaults,
                                     {});
}

std::string add_page(const CorrectionLoop& asked, const fit::AddResult& result) {
  return io::record_add_report(asked.file.source, asked.data, result, asked.file.defaults);
}

std::string fitted_text(const CorrectionQuestion& asked, const fit::Calibration& found) {
  std::vector<correction::Model> models = asked.file.models;
  models[asked.index] = correction::trusted(found, asked.data);
  return io::with_corrections(asked.file, models);
}

namespace {

/// A correction as it is compared.
struct HeldAgainst {
  std::shared_ptr<const fit::Subject> subject;
  int fitted = 0;  // parameters
};

correction::Zero zero_of(const std::string& zero) {
  return zero == "first"  ? correction::Zero::first
         : zero == "none" ? correction::Zero::none
                          : correction::Zero::mean;
}

/// With the constant of each run, and what is to be fitted found from the record.
HeldAgainst held_against(Messages& messages, correction::Model model,
                         const std::vector<std::string>& refit, const std::string& zero,
                         const record::Record& data) {
  if (refit.empty()) return {correction::aligned(model, data, zero_of(zero))};
  model.free = refit;
  if (std::find(model.free.begin(), model.free.end(), "offset") == model.free.end())
    model.free.emplace_back("offset");
  const fit::Calibration found = fit::calibrate(correction::CorrectionSubject(model), data);
  messages.warnings(found.messages);
  return {found.subject, static_cast<int>(found.parameters.size())};
}

}  // namespace

std::string CheckedCorrection::json() const {
  std::vector<std::string> notes = asked.file.notes;
  notes.insert(notes.end(), asked.data.notes.begin(), asked.data.notes.end());
  return io::check_json(asked.model.name, check, asked.file.defaults, notes, &over_time);
}

CheckedCorrection check_correction(Messages& messages, const Source& model,
                                   const std::vector<Source>& data, const std::string& displacement,
                                   const Reading& reading) {
  CheckedCorrection result{.asked = ask_correction(messages, model, data, displacement, reading)};
  const CorrectionQuestion& asked = result.asked;
  try {
    const auto subject = correction::CorrectionSubject(asked.model).informed_by(asked.data);
    result.check = fit::check(*subject, asked.data);
  } catch (const std::invalid_argument& e) {
    refuse_data(asked.file.source, asked.data, e);
  }
  result.over_time = correction::check_record(asked.model, asked.data);
  if (!result.check.problem.empty()) messages.warn(result.check.problem);
  messages.warnings(result.over_time.warnings);
  return result;
}

std::string ComparedCorrections::json() const {
  return io::comparison_json(names, comparisons, data, beyond);
}

std::string ComparedCorrections::page() const {
  return io::record_report("compare", json(), data, drawn);
}

ComparedCorrections compare_corrections(Messages& messages, const std::vector<Source>& models,
                                        const std::vector<Source>& data,
                                        const std::vector<std::string>& refit,
                                        const std::string& zero, const LoopOptions& options) {
  if (!options.per_record.names.empty())
    throw io::InputError("--per-record: a correction is held against one record",
                         {.key = "--per-record"});
  ComparedCorrections result;
  for (const Source& source : models) {
    if (!source.text && !io::has_correction(source.name))
      throw io::InputError(
          source.name + ": has no [correction]: only corrections can be compared with one",
          {.file = source.name, .key = "correction"});
    CorrectionQuestion asked =
        ask_correction(messages, source, data, options.displacement, options.reading);
    const std::string& name = asked.file.source;
    options.tolerance.set(asked.model, name);
    try {
      const HeldAgainst one = held_against(messages, asked.model, refit, zero, asked.data);
      result.comparisons.push_back(fit::compare(*one.subject, asked.data, one.fitted));
      result.drawn.push_back(
          {.name = name, .subject = one.subject, .held_out = {}, .defaults = asked.file.defaults});
    } catch (const std::invalid_argument& e) {
      refuse_data(name, asked.data, e);
    }
    if (const std::string leaves = correction::power_beyond_element(asked.model, asked.data);
        !leaves.empty())
      messages.warn(fmt::format("{}: {}: rows from there on have no prediction and are left out",
                                name, leaves));
    for (fit::Comparison& c : result.comparisons.back())
      fit::add_groups(c, correction::phase, correction::phases(asked.data, *c.channel));
    result.names.push_back(name);
    const correction::Series series(asked.data);
    result.beyond.push_back(correction::beyond_range(asked.model, series));
    messages.warnings(range_notes(asked.model, series, result.beyond.back()));
    result.data = std::move(asked.data);
  }
  return result;
}

}  // namespace raceway::session

#include "python/engine/correction.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>

#include "correction/numbers.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "files/displacement_curve.h"
#include "python/engine/answer.h"
#include "session/control_export.h"
#include "session/correction_run.h"
#include "session/identification.h"
#include "session/law_fit.h"
#include "session/new_model.h"
#include "shaft/displacement_table.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::python {
namespace {

/// A record with the corrections of a file. `given`: columns, drop_nan, from, until.
session::SeriesQuestion ask(Heard& heard, const EngineCorrection& correction, const Data& data,
                            const session::Reading& reading) {
  return session::ask_series(heard, correction.source(), *data, reading, session::Defaults::keep);
}

EngineAnswer arx(const session::ArxModels& models) {
  EngineAnswer answer;
  for (const auto& [_, baseline] : models.found) append(answer.warnings, baseline.messages);
  answer.json = models.json();
  if (!models.stable()) return answer;
  session::ArxModels::Text written = models.text();
  answer.fitted.texts = {std::move(written.text)};
  append(answer.notes, std::move(written.notes));
  return answer;
}

/// Sections, a bank of lags or a regression, with the file of the models that were found.
EngineAnswer identified(const session::Identified& found) {
  EngineAnswer answer;
  for (const correction::Identification& one : found.found) append(answer.warnings, one.messages);
  append(answer.warnings, found.validation_warnings);
  answer.json = found.json();
  answer.fitted.texts = {found.text()};
  return answer;
}

EngineAnswer identify(const EngineCorrection& correction, const Data& data, const Data& validate,
                      const std::string& order, const std::vector<std::string>& inputs,
                      const std::vector<std::string>& lags, const std::string& baseline,
                      double time_limit_s, const py::object& progress_of_caller,
                      const py::kwargs& given) {
  const session::Reading reading = options_of(given).reading;
  std::atomic<bool> cancelled = false;
  Progress progress;
  session::IdentifyChoices choices{
      .order = order, .inputs = inputs, .lags = lags, .baseline = baseline};
  choices.cancelled = [&] { return cancelled.load(); };
  choices.progress = [&](double share, std::string_view step) { progress.set(share, step); };
  choices.check();
  return answered({time_limit_s, progress_of_caller}, cancelled, progress, [&](Heard& heard) {
    session::SeriesQuestion asked = ask(heard, correction, data, reading);
    if (baseline == "arx") return arx(session::identify_arx(std::move(asked), choices));
    session::Identified found = session::identify(heard, std::move(asked), choices);
    if (validate) found.validate(heard, *validate, reading);
    return identified(found);
  });
}

/// The record as it was understood, with what was predicted and what is left of each displacement.
/// `predicted(k)`: of the k-th [m].
template <typename Predicted>
NamedColumns course(const session::SeriesQuestion& asked, const Predicted& predicted) {
  NamedColumns columns = columns_of(asked.data);
  for (std::size_t k = 0; k < asked.file.models.size(); ++k) {
    const record::Channel& channel = *asked.file.models[k].displacement;
    const std::string name(channel.name);
    std::vector<double> values = in_unit(channel, predicted(k)), left = values;
    for (std::size_t row = 0; row < left.size(); ++row)
      left[row] = text::value_in_unit(channel, asked.data.value(channel, row)) - values[row];
    columns.emplace_back("predicted_" + name, std::move(values));
    if (asked.data.has(channel)) columns.emplace_back("residual_" + name, std::move(left));
  }
  return columns;
}

EngineAnswer correct(const EngineCorrection& correction, const Data& data,
                     const py::kwargs& given) {
  session::Reading reading = options_of(given).reading;
  reading.without_readings = true;
  return answered([&](Heard& heard) {
    const auto run = std::make_shared<const session::CorrectionRun>(
        session::correct(ask(heard, correction, data, reading)));
    EngineAnswer answer;
    answer.json = run->json();
    answer.warnings = run->warnings;
    answer.csv = [run] { return run->csv(); };
    answer.page = [run] { return run->page(); };
    answer.rows = [run] {
      return course(run->asked, [&](std::size_t k) { return run->corrected[k].predicted; });
    };
    return answer;
  });
}

EngineAnswer learn(const EngineCorrection& correction, const Data& data, const std::string& every,
                   const std::string& forget, const py::kwargs& given) {
  session::Reading reading = options_of(given).reading;
  reading.one_by_one = true;
  const session::LearningChoices choices{.every = every, .forget = forget};
  choices.check();
  return answered([&](Heard& heard) {
    const auto run = std::make_shared<const session::LearningRun>(
        session::learn(ask(heard, correction, data, reading), choices));
    EngineAnswer answer;
    answer.json = run->json();
    answer.notes = run->notes;
    answer.warnings = run->warnings;
    answer.fitted.texts = {run->text()};
    answer.csv = [run] { return run->csv(); };
    answer.rows = [run] {
      return course(run->asked, [&](std::size_t k) { return run->learnt[k].learning.predicted; });
    };
    return answer;
  });
}

/// The text, with what is to be known of it, and the lines of HAL that go with it. `record`: one or
/// none.
py::tuple export_correction(const EngineCorrection& correction, const std::string& format,
                            const std::string& output, const Data& record, bool accept_untrusted) {
  session::require_control_name(format, output);
  Heard heard;
  control::ControlPlan plan = session::open_plan(heard, correction.source(), record.get());
  if (!accept_untrusted) session::require_trust(plan);
  const session::ControlExport made = session::export_plan(std::move(plan), format, output);
  std::vector<record::Note> notes = notes_of(record::note::exported, made.plan.notes);
  append(notes, notes_of(record::note::polynomial, made.plan.warnings));
  return py::make_tuple(made.text, notes, made.hal, made.hal_shutdown);
}

EngineAnswer fit_law(const Data& curve, double at_rpm, const py::kwargs& given) {
  const session::Reading reading = options_of(given).reading;
  return answered([&](Heard& heard) {
    const auto found =
        std::make_shared<const session::LawFit>(session::fit_law(heard, *curve, reading, at_rpm));
    EngineAnswer answer;
    answer.json = found->json("-o FILE writes the table");
    answer.converged = found->fit.converged();
    answer.csv = [found] {
      return files::displacement_table_text(shaft::make_displacement_table(found->curve.points),
                                            found->curve.source);
    };
    return answer;
  });
}

}  // namespace

EngineCorrection::EngineCorrection(const std::string& source, const std::string& text,
                                   const HeldFiles& held)
    : file_(session::open_corrections(heard_, session::Source(source, text, named_files(held)),
                                      session::Defaults::keep)) {}

std::vector<record::Parameter> EngineCorrection::parameters() const {
  std::vector<record::Parameter> all;
  for (const correction::Model& model : file_.models)
    for (record::Parameter& p : correction::parameters(model)) {
      if (file_.models.size() > 1) p.name.insert(0, std::string(model.displacement->name) + ".");
      all.push_back(std::move(p));
    }
  return all;
}

py::dict EngineCorrection::trust() const {
  py::dict of;
  for (const correction::Model& model : file_.models)
    of[py::str(std::string(model.displacement->name))] =
        correction::line_of(correction::trust_of(model));
  return of;
}

py::list EngineCorrection::inputs() const {
  std::vector<std::string> names;
  for (const correction::Model& model : file_.models)
    for (const record::Channel* c : correction::inputs_of(model))
      if (std::find(names.begin(), names.end(), c->name) == names.end())
        names.emplace_back(c->name);
  return py::cast(names);
}

namespace {

/// The text of the sum, the files that it names, and what is to be known of it.
py::tuple joined(const std::vector<std::shared_ptr<EngineCorrection>>& parts) {
  Heard heard;
  std::vector<session::Source> sources;
  for (const std::shared_ptr<EngineCorrection>& part : parts) sources.push_back(part->source());
  const files::CorrectionFile sum = session::join(heard, sources, "");
  HeldFiles held;
  for (const files::NamedFile& file : sum.files) held.emplace_back(file.name, file.path, file.text);
  return py::make_tuple(sum.text, held, heard.notes);
}

}  // namespace

void bind_correction(py::module_& module) {
  py::class_<EngineCorrection, EngineFile, std::shared_ptr<EngineCorrection>>(module, "Correction")
      .def(py::init<const std::string&, const std::string&, const HeldFiles&>(), py::arg("source"),
           py::arg("text"), py::arg("files") = HeldFiles())
      .def_property_readonly("displacements",
                             [](const EngineCorrection& c) {
                               std::vector<std::string> names;
                               for (const correction::Model& m : c.file().models)
                                 names.emplace_back(m.displacement->name);
                               return names;
                             })
      .def_property_readonly("inputs", &EngineCorrection::inputs)
      .def("trust", &EngineCorrection::trust);
  module.def("joined", &joined);
  module.def("identify", &identify);
  module.def("correct", &correct);
  module.def("learn", &learn);
  module.def("export_correction", &export_correction);
  module.def("fit_law", &fit_law);
  module.def("new_correction", [](const Data& data, const py::kwargs& given) {
    Heard heard;
    std::string text = session::new_correction_text(heard, *data, options_of(given).reading);
    return py::make_tuple(text, heard.notes, heard.warnings);
  });
}

}  // namespace raceway::python

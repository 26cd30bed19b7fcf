#include <pybind11/stl.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "fit/add.h"
#include "fit/calibrate.h"
#include "fit/diagnose.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/number_text.h"
#include "io/results.h"
#include "io/subject.h"
#include "io/suggest_columns.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "session/comparison.h"
#include "session/loop_question.h"
#include "session/open_input.h"

namespace raceway::python {
namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;  // names with what they hold

/// What the loop found, as Python shows it.
struct EngineAnswer {
  std::string json{};
  std::function<std::string()> page{};
  std::vector<std::string> notes{}, warnings{};
  bool converged = true;
  std::string refused{};  ///< why an effect was not added; empty where it was
  session::FittedTexts fitted{};
  double error_sum = unset;  ///< of squared errors over the noise [1]
};

std::vector<session::Source> sources(const Texts& texts) {
  std::vector<session::Source> list;
  for (const auto& [name, text] : texts) list.emplace_back(name, text);
  return list;
}

/// What a question may ask for, as keyword arguments of Python.
session::LoopOptions loop_options(const std::vector<const EngineModel*>& models,
                                  const py::kwargs& given) {
  session::LoopOptions options;
  options.amend = [models](io::ModelFile& file, std::size_t place) { models[place]->amend(file); };
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (value.is_none()) continue;
    if (name == "columns")
      options.reading.columns_text = value.cast<std::string>();
    else if (name == "drop_nan")
      options.reading.drop_nan = value.cast<bool>();
    else if (name == "per_record")
      options.per_record.names = value.cast<std::vector<std::string>>();
    else if (name == "tolerance")
      options.tolerance.text = value.cast<std::string>();
    else
      throw py::type_error("unexpected option " + name);
  }
  return options;
}

session::Source source_of(const EngineModel& model) {
  return {model.file().source, model.file().text};
}

/// Runs `work` on a question and gives the answer what was said meanwhile.
template <typename Work>
EngineAnswer answered(const Waiting& waiting, std::atomic<bool>& cancelled,
                      const Progress& progress, const Work& work) {
  Heard heard;
  EngineAnswer answer = interruptible(cancelled, progress, waiting, [&] { return work(heard); });
  // The defaults are counted where the model is read.
  for (std::string& note : heard.note_lines)
    if (note.find(": raceway check ") == note.npos) answer.notes.push_back(std::move(note));
  answer.warnings.insert(answer.warnings.begin(), heard.warning_lines.begin(),
                         heard.warning_lines.end());
  return answer;
}

template <typename Work>
EngineAnswer answered(const Work& work) {
  std::atomic<bool> cancelled = false;
  return answered(Waiting(), cancelled, Progress(), work);
}

/// What the data do not allow, in the words of the command.
template <typename Ask>
auto with_data(const session::LoopQuestion& asked, const Ask& ask) {
  try {
    return ask();
  } catch (const std::invalid_argument& e) {
    session::refuse_data(asked.file.source, asked.data, e);
  }
}

EngineAnswer compare(const std::vector<std::shared_ptr<EngineModel>>& models, const Texts& data,
                     const std::vector<std::string>& refit, const py::kwargs& given) {
  std::vector<const EngineModel*> raw;
  for (const auto& model : models) raw.push_back(model.get());
  const session::LoopOptions options = loop_options(raw, given);
  return answered([&](Heard& heard) {
    std::vector<session::Source> texts;
    for (const auto& model : models) texts.push_back(source_of(*model));
    const auto compared = std::make_shared<session::ComparedModels>(session::compare_models(
        heard, session::open_models(heard, texts, options), sources(data), refit, options));
    EngineAnswer answer;
    answer.json = compared->json();
    answer.page = [compared] { return compared->page(); };
    return answer;
  });
}

EngineAnswer calibrate(const EngineModel& model, const Texts& data, const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  return answered([&](Heard& heard) {
    const session::LoopQuestion asked =
        session::ask(heard, source_of(model), sources(data), options);
    fit::Calibration found =
        with_data(asked, [&] { return fit::calibrate(*asked.subject, asked.data); });
    session::tell_of_scale(asked.data, found.messages);
    EngineAnswer answer;
    answer.json = io::calibration_json(found, asked.data);
    answer.warnings = found.messages;
    answer.converged = found.converged();
    if (answer.converged) answer.fitted = session::fitted_texts(asked.file, found);
    return answer;
  });
}

EngineAnswer diagnose(const EngineModel& model, const Texts& data, bool pairs, int tried_before,
                      double time_limit_s, const py::object& progress_of_caller,
                      const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  std::atomic<bool> cancelled = false;
  Progress progress;
  fit::DiagnoseOptions how;
  how.pairs = pairs;
  how.tried_before = tried_before;
  how.cancelled = &cancelled;
  how.progress = [&](double share, std::string_view step) { progress.set(share, step); };
  return answered({time_limit_s, progress_of_caller}, cancelled, progress, [&](Heard& heard) {
    const auto asked = std::make_shared<session::LoopQuestion>(
        session::ask(heard, source_of(model), sources(data), options));
    const auto found = std::make_shared<fit::Diagnosis>(
        with_data(*asked, [&] { return fit::diagnose(*asked->subject, asked->data, how); }));
    session::tell_of_scale(asked->data, found->messages);
    EngineAnswer answer;
    answer.json = io::diagnosis_json(asked->file.source, asked->data, *found);
    answer.warnings = found->messages;
    answer.page = [asked, found] { return session::diagnosis_page(*asked, *found); };
    return answer;
  });
}

EngineAnswer add(const EngineModel& model, const std::vector<std::string>& effects,
                 const Texts& data, const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  return answered([&](Heard& heard) {
    const auto asked = std::make_shared<session::LoopQuestion>(
        session::ask(heard, source_of(model), sources(data), options));
    const auto found = std::make_shared<fit::AddResult>(
        with_data(*asked, [&] { return fit::add(*asked->subject, effects, asked->data); }));
    session::tell_of_scale(asked->data, found->messages);
    EngineAnswer answer;
    answer.json = io::add_json(asked->file.source, asked->data, *found);
    answer.warnings = found->messages;
    answer.converged = found->calibration.converged();
    if (found->refused) answer.refused = found->reason;
    if (answer.converged) answer.fitted = session::fitted_texts(asked->file, found->calibration);
    answer.page = [asked, found] { return session::add_page(*asked, *found); };
    return answer;
  });
}

/// The record as it was understood, column by column in the units of files, with what the model
/// says of each measured channel.
py::dict predict(const EngineModel& model, const Texts& data, const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  Heard heard;
  std::optional<session::LoopQuestion> asked;
  std::vector<double> readings;
  {
    const py::gil_scoped_release others;
    asked = session::ask(heard, source_of(model), sources(data), options);
    with_data(*asked, [&] { asked->subject->require(asked->data); });
    readings = fit::predict(*asked->subject, asked->data);
  }
  const record::Record& record = asked->data;
  const std::vector<std::size_t> shape{record.rows()};
  const auto in_unit = [](const record::Channel& channel, std::span<const double> si) {
    std::vector<double> values;
    for (const double value : si) values.push_back(io::value_in_unit(channel, value));
    return values;
  };
  py::dict columns;
  for (const record::Column& column : record.columns)
    columns[py::str(std::string(column.channel->name))] =
        owned(in_unit(*column.channel, column.values), shape);
  std::size_t k = 0;
  for (const fit::Measured& m : asked->subject->measured()) {
    const auto of = std::span(readings).subspan(record.rows() * k++, record.rows());
    if (record.has(*m.channel))
      columns[py::str("predicted_" + std::string(m.channel->name))] =
          owned(in_unit(*m.channel, of), shape);
  }
  return columns;
}

}  // namespace

void bind_loop(py::module_& module) {
  py::class_<EngineAnswer>(module, "Answer")
      .def_readonly("json", &EngineAnswer::json)
      .def_readonly("notes", &EngineAnswer::notes)
      .def_readonly("warnings", &EngineAnswer::warnings)
      .def_readonly("converged", &EngineAnswer::converged)
      .def_readonly("refused", &EngineAnswer::refused)
      .def_property_readonly("records", [](const EngineAnswer& a) { return a.fitted.records; })
      .def_property_readonly("models", [](const EngineAnswer& a) { return a.fitted.texts; })
      .def_property_readonly("own_effects",
                             [](const EngineAnswer& a) {
                               py::list models;
                               for (const auto& own : a.fitted.own_effects) {
                                 py::dict of;
                                 for (const auto& [id, values] : own)
                                   of[py::str(id)] = py::cast(values);
                                 models.append(of);
                               }
                               return models;
                             })
      .def("page", [](const EngineAnswer& a) {
        if (!a.page) throw io::InputError("there is no page of a calibration: compare() has one");
        const py::gil_scoped_release others;
        return a.page();
      });
  module.def("compare", &compare);
  module.def("calibrate", &calibrate);
  module.def("diagnose", &diagnose);
  module.def("add", &add);
  module.def("predict", &predict);
  module.def("suggest_columns",
             [](const EngineModel& model, const std::string& name, const std::string& text) {
               return io::suggested_columns_of(text, name, *io::make_subject(model.file().model));
             });
}

}  // namespace raceway::python

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <atomic>
#include <memory>

#include "fit/add.h"
#include "fit/calibrate.h"
#include "fit/diagnose.h"
#include "io/diagnosis_results.h"
#include "io/error.h"
#include "io/number_text.h"
#include "io/results.h"
#include "io/subject.h"
#include "io/suggest_columns.h"
#include "python/engine/answer.h"
#include "python/engine/correction.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "session/bands.h"
#include "session/comparison.h"
#include "session/correction_loop.h"
#include "session/loop_question.h"
#include "session/open_input.h"

namespace raceway::python {
namespace {

template <typename Held>
session::Source source_of(const Held& model) {
  return {model.file().source, model.file().text};
}

/// What a question may ask for, as keyword arguments of Python.
session::LoopOptions loop_options(const std::vector<const EngineModel*>& models,
                                  const py::kwargs& given) {
  session::LoopOptions options = options_of(given);
  options.amend = [models](io::ModelFile& file, std::size_t place) { models[place]->amend(file); };
  return options;
}
session::LoopOptions loop_options(const EngineModel& model, const py::kwargs& given) {
  return loop_options(std::vector{&model}, given);
}
session::LoopOptions loop_options(const EngineCorrection&, const py::kwargs& given) {
  return options_of(given);
}

session::LoopQuestion ask(Heard& heard, const EngineModel& model, const Texts& data,
                          const session::LoopOptions& options) {
  return session::ask(heard, source_of(model), sources(data), options);
}
session::CorrectionLoop ask(Heard& heard, const EngineCorrection& model, const Texts& data,
                            const session::LoopOptions& options) {
  return session::ask_correction_loop(heard, source_of(model), sources(data), options);
}

/// As session::meant() of a correction, whose effects are named by what they act on.
const std::vector<std::string>& meant(const session::LoopQuestion&,
                                      const std::vector<std::string>& effects) {
  return effects;
}

session::FittedTexts fitted_texts(const session::LoopQuestion& asked,
                                  const fit::Calibration& found) {
  return session::fitted_texts(asked.file, found);
}
session::FittedTexts fitted_texts(const session::CorrectionLoop& asked,
                                  const fit::Calibration& found) {
  return {.records = {}, .texts = {session::fitted_text(asked, found)}, .own_effects = {{}}};
}

/// What the data do not allow, in the words of the command.
template <typename Question, typename Ask>
auto with_data(const Question& asked, const Ask& ask) {
  try {
    return ask();
  } catch (const std::invalid_argument& e) {
    session::refuse_data(asked.file.source, asked.data, e);
  }
}

/// A question for pages that are asked for later.
template <typename Question>
std::shared_ptr<const Question> shared(Question question) {
  return std::make_shared<const Question>(std::move(question));
}

EngineAnswer compare(const std::vector<std::shared_ptr<EngineModel>>& models, const Texts& data,
                     const std::vector<std::string>& refit, const py::kwargs& given) {
  std::vector<const EngineModel*> raw;
  for (const auto& model : models) raw.push_back(model.get());
  const session::LoopOptions options = loop_options(raw, given);
  return answered([&](Heard& heard) {
    std::vector<session::Source> texts;
    for (const auto& model : models) texts.push_back(source_of(*model));
    Heard opened;  // what is doubtful of a model was said when it was made
    const std::vector<io::ModelFile> files = session::open_models(opened, texts, options);
    heard.notes(opened.note_lines);
    const auto compared = std::make_shared<session::ComparedModels>(
        session::compare_models(heard, files, sources(data), refit, options));
    EngineAnswer answer;
    answer.json = compared->json();
    answer.page = [compared] { return compared->page(); };
    return answer;
  });
}

template <typename Held>
EngineAnswer calibrate(const Held& model, const Texts& data, bool profile,
                       const py::kwargs& given) {
  const session::LoopOptions options = loop_options(model, given);
  return answered([&](Heard& heard) {
    const auto asked = ask(heard, model, data, options);
    fit::Calibration found = with_data(
        asked, [&] { return fit::calibrate(*asked.subject, asked.data, {.profile = profile}); });
    session::tell_of_scale(asked.data, found.messages);
    EngineAnswer answer;
    answer.json = io::calibration_json(found, asked.data);
    answer.warnings = found.messages;
    answer.converged = found.converged();
    if (answer.converged) answer.fitted = fitted_texts(asked, found);
    return answer;
  });
}

template <typename Held>
EngineAnswer diagnose(const Held& model, const Texts& data, bool pairs, int tried_before,
                      double time_limit_s, const py::object& progress_of_caller,
                      const py::kwargs& given) {
  const session::LoopOptions options = loop_options(model, given);
  std::atomic<bool> cancelled = false;
  Progress progress;
  fit::DiagnoseOptions how;
  how.pairs = pairs;
  how.tried_before = tried_before;
  how.cancelled = &cancelled;
  how.progress = [&](double share, std::string_view step) { progress.set(share, step); };
  return answered({time_limit_s, progress_of_caller}, cancelled, progress, [&](Heard& heard) {
    const auto asked = shared(ask(heard, model, data, options));
    const auto found = std::make_shared<fit::Diagnosis>(
        with_data(*asked, [&] { return fit::diagnose(*asked->subject, asked->data, how); }));
    session::tell_of_scale(asked->data, found->messages);
    EngineAnswer answer;
    answer.json = io::diagnosis_json(asked->file.source, asked->data, *found);
    answer.warnings = found->messages;
    answer.page = [asked, found] { return diagnosis_page(*asked, *found); };
    return answer;
  });
}

template <typename Held>
EngineAnswer add(const Held& model, const std::vector<std::string>& effects, const Texts& data,
                 const py::kwargs& given) {
  const session::LoopOptions options = loop_options(model, given);
  return answered([&](Heard& heard) {
    const auto asked = shared(ask(heard, model, data, options));
    const std::vector<std::string> ids = meant(*asked, effects);
    const auto found = std::make_shared<fit::AddResult>(
        with_data(*asked, [&] { return fit::add(*asked->subject, ids, asked->data); }));
    session::tell_of_scale(asked->data, found->messages);
    EngineAnswer answer;
    answer.json = io::add_json(asked->file.source, asked->data, *found);
    answer.warnings = found->messages;
    answer.converged = found->calibration.converged();
    if (found->refused) answer.refused = found->reason;
    if (answer.converged) answer.fitted = fitted_texts(*asked, found->calibration);
    answer.page = [asked, found] { return add_page(*asked, *found); };
    return answer;
  });
}

/// The record as it was understood, and what a correction makes of it.
NamedColumns rows_of(const session::ComparedCorrections& compared) {
  NamedColumns columns = columns_of(compared.data);
  const fit::Comparison& first = compared.comparisons.front().front();
  const std::vector<double> none(compared.data.rows(), unset);
  std::vector<double> measured = none, predicted = none, error = none;
  for (const fit::RowError& row : first.errors) {
    measured[row.row] = row.measured / first.channel->factor;
    predicted[row.row] = row.predicted / first.channel->factor;
    error[row.row] = row.residual / first.channel->factor;
  }
  std::erase_if(columns, [&](const auto& c) { return c.first == first.channel->name; });
  columns.emplace_back("measured", std::move(measured));
  columns.emplace_back("predicted", std::move(predicted));
  columns.emplace_back("error", std::move(error));
  return columns;
}

EngineAnswer compare_corrections(const std::vector<std::shared_ptr<EngineCorrection>>& models,
                                 const Texts& data, const std::vector<std::string>& refit,
                                 const std::string& zero, const py::kwargs& given) {
  const session::LoopOptions options = options_of(given);
  return answered([&](Heard& heard) {
    std::vector<session::Source> texts;
    for (const auto& model : models) texts.push_back(source_of(*model));
    const auto compared =
        shared(session::compare_corrections(heard, texts, sources(data), refit, zero, options));
    EngineAnswer answer;
    answer.json = compared->json();
    answer.page = [compared] { return compared->page(); };
    answer.rows = [compared] { return rows_of(*compared); };
    return answer;
  });
}

/// The record as it was understood, column by column in the units of files, with what the model
/// says of each measured channel, with its band where that is wanted.
py::dict predict(const EngineModel& model, const Texts& data, bool with_band,
                 const py::kwargs& given) {
  const session::LoopOptions options = loop_options(model, given);
  const std::optional<model::Band> band = model.band(with_band);
  Heard heard;
  NamedColumns columns;
  {
    const py::gil_scoped_release others;
    const session::LoopQuestion asked = ask(heard, model, data, options);
    with_data(asked, [&] { asked.subject->require(asked.data); });
    const std::vector<double> readings = fit::predict(*asked.subject, asked.data);
    const std::vector<double> half_widths =
        band ? session::record_band(*band, asked.data) : std::vector<double>();
    columns = columns_of(asked.data);
    std::size_t first = 0;
    for (const fit::Measured& m : asked.subject->measured()) {
      const std::size_t rows = asked.data.rows();
      const auto of = [&](const std::vector<double>& all) {
        return std::span(all).subspan(first, rows);
      };
      const record::Channel& channel = *m.channel;
      if (asked.data.has(channel)) {
        columns.emplace_back("predicted_" + std::string(channel.name),
                             in_unit(channel, of(readings)));
        if (band) {
          std::vector<double> widths(of(half_widths).begin(), of(half_widths).end());
          for (double& width : widths) width /= channel.factor;
          columns.emplace_back(
              fmt::format("predicted_{}_band_{}", channel.variable, channel.key_unit()),
              std::move(widths));
        }
      }
      first += rows;
    }
  }
  return arrays_of(std::move(columns));
}

}  // namespace

void bind_loop(py::module_& module) {
  module.def("compare", &compare);
  module.def("compare_corrections", &compare_corrections);
  module.def("calibrate", &calibrate<EngineModel>);
  module.def("calibrate", &calibrate<EngineCorrection>);
  module.def("diagnose", &diagnose<EngineModel>);
  module.def("diagnose", &diagnose<EngineCorrection>);
  module.def("add", &add<EngineModel>);
  module.def("add", &add<EngineCorrection>);
  module.def("predict", &predict);
  module.def("suggest_columns",
             [](const EngineModel& model, const std::string& name, const std::string& text) {
               return io::suggested_columns_of(text, name, *io::make_subject(model.file().model));
             });
}

}  // namespace raceway::python

#include "session/loop.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <atomic>
#include <memory>

#include "files/subject.h"
#include "python/engine/answer.h"
#include "python/engine/file.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "session/bands.h"

namespace raceway::python {
namespace {

/// What a question may ask for, as keyword arguments of Python.
session::LoopOptions loop_options(const std::vector<const EngineFile*>& models,
                                  const py::kwargs& given) {
  session::LoopOptions options = options_of(given);
  options.part = models.front()->part();
  options.defaults = session::Defaults::keep;
  options.amend = [models](files::ModelFile& file, std::size_t place) {
    models[place]->amend(file);
  };
  return options;
}

/// A question for pages that are asked for later.
std::shared_ptr<const session::LoopQuestion> ask(Heard& heard, const EngineFile& model,
                                                 const std::vector<Data>& data,
                                                 const session::LoopOptions& options) {
  return std::make_shared<const session::LoopQuestion>(
      session::ask(heard, model.source(), sources(data), options));
}

/// The record as it was understood, with what the first model says of each measured channel.
NamedColumns rows_of(const session::ComparedModels& compared) {
  NamedColumns columns = columns_of(compared.data);
  for (const verdict::Comparison& c : compared.models.front().errors) {
    std::vector<double> predicted(compared.data.rows(), unset);
    for (const verdict::RowError& row : c.errors) predicted[row.row] = row.predicted;
    columns.emplace_back("predicted_" + std::string(c.channel->name),
                         in_unit(*c.channel, predicted));
  }
  return columns;
}

EngineAnswer compare(const std::vector<std::shared_ptr<EngineFile>>& models,
                     const std::vector<Data>& data, const std::vector<std::string>& refit,
                     const std::string& zero, const py::kwargs& given) {
  std::vector<const EngineFile*> files;
  for (const auto& model : models) files.push_back(model.get());
  const session::LoopOptions options = loop_options(files, given);
  return answered([&](Heard& heard) {
    std::vector<session::Source> texts;
    for (const EngineFile* const file : files) texts.push_back(file->source());
    const auto compared = std::make_shared<const session::ComparedModels>(
        session::compare(heard, texts, sources(data), {.refit = refit, .zero = zero}, options));
    EngineAnswer answer;
    answer.json = compared->json();
    answer.page = [compared] { return compared->page(); };
    answer.rows = [compared] { return rows_of(*compared); };
    return answer;
  });
}

EngineAnswer calibrate(const EngineFile& model, const std::vector<Data>& data, bool profile,
                       const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  return answered([&](Heard& heard) {
    const auto asked = ask(heard, model, data, options);
    const verdict::Calibration found = session::calibrate(*asked, {.profile = profile});
    EngineAnswer answer;
    answer.json = session::json(*asked, found);
    answer.warnings = found.messages;
    answer.converged = found.converged();
    if (answer.converged) answer.fitted = session::fitted_texts(*asked, found);
    return answer;
  });
}

EngineAnswer diagnose(const EngineFile& model, const std::vector<Data>& data, bool pairs,
                      int tried_before, double time_limit_s, const py::object& progress_of_caller,
                      const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  std::atomic<bool> cancelled = false;
  Progress progress;
  verdict::DiagnoseOptions how;
  how.pairs = pairs;
  how.tried_before = tried_before;
  how.cancelled = &cancelled;
  how.progress = [&](double share, std::string_view step) { progress.set(share, step); };
  return answered({time_limit_s, progress_of_caller}, cancelled, progress, [&](Heard& heard) {
    const auto asked = ask(heard, model, data, options);
    const auto found = std::make_shared<const verdict::Diagnosis>(session::diagnose(*asked, how));
    EngineAnswer answer;
    answer.json = session::json(*asked, *found);
    answer.warnings = found->messages;
    answer.page = [asked, found] { return session::page(*asked, *found); };
    return answer;
  });
}

EngineAnswer add(const EngineFile& model, const std::vector<std::string>& effects,
                 const std::vector<Data>& data, const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  return answered([&](Heard& heard) {
    const auto asked = ask(heard, model, data, options);
    const auto found = std::make_shared<const verdict::AddResult>(session::add(*asked, effects));
    EngineAnswer answer;
    answer.json = session::json(*asked, *found);
    answer.warnings = found->messages;
    answer.converged = found->calibration.converged();
    if (found->refused) answer.refused = found->reason;
    if (answer.converged) answer.fitted = session::fitted_texts(*asked, found->calibration);
    answer.page = [asked, found] { return session::page(*asked, *found); };
    return answer;
  });
}

EngineAnswer check(const EngineFile& model, const Data& data, const py::kwargs& given) {
  const session::LoopOptions options = loop_options({&model}, given);
  return answered([&](Heard& heard) {
    EngineAnswer answer;
    answer.json = session::check(heard, model.source(), *data, options).json();
    return answer;
  });
}

/// The record as it was understood, column by column in the units of files, with what the model
/// says of each measured channel, with its band where that is wanted.
py::dict predict(const EngineModel& model, const std::vector<Data>& data, bool with_band,
                 const py::kwargs& given) {
  session::LoopOptions options = loop_options({&model}, given);
  options.rows = true;  // a prediction of each
  const std::optional<model::Band> band = model.band(with_band);
  Heard heard;
  NamedColumns columns;
  {
    const py::gil_scoped_release others;
    const auto question = ask(heard, model, data, options);
    const session::LoopQuestion& asked = *question;
    const std::vector<double> readings = session::predict(asked);
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
  module.def("calibrate", &calibrate);
  module.def("diagnose", &diagnose);
  module.def("add", &add);
  module.def("check", &check);
  module.def("predict", &predict);
  module.def("suggest_columns", [](const EngineFile& model, const Data& data) {
    Heard heard;
    return session::suggested_columns(heard, model.source(), *data,
                                      {.part = model.part(), .defaults = session::Defaults::keep});
  });
}

}  // namespace raceway::python

#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "python/engine/heard.h"
#include "python/engine/interruptible.h"
#include "record/record.h"
#include "session/loop_model.h"
#include "session/source.h"

namespace raceway::python {

namespace py = pybind11;

/// Measurements that Python passes to a call; null if it passes none.
using Data = std::shared_ptr<session::Source>;

/// Name and values of each column. The values are in the units of record files.
using NamedColumns = std::vector<std::pair<std::string, std::vector<double>>>;

/// Result of a call: JSON document, HTML page, CSV table, columns and notes.
struct EngineAnswer {
  std::string json{};
  std::function<std::string()> page{};
  std::function<std::string()> csv{};
  std::function<NamedColumns()> rows{};
  std::vector<record::Note> notes{}, warnings{};
  bool converged = true;
  std::string refused{};  ///< reason why an effect was not added; empty otherwise
  session::FittedTexts fitted{};
};

inline std::vector<session::Source> sources(const std::vector<Data>& data) {
  std::vector<session::Source> list;
  for (const Data& one : data) list.push_back(*one);
  return list;
}

/// Returns the columns of a record as the program has read them.
[[nodiscard]] NamedColumns columns_of(const record::Record& record);
/// Converts values of a channel [SI] to the unit of this channel in files.
[[nodiscard]] std::vector<double> in_unit(const record::Channel& channel,
                                          std::span<const double> si);
/// Returns a dictionary of column names and NumPy arrays.
[[nodiscard]] py::dict arrays_of(NamedColumns columns);

/// Returns the options of calibrate, diagnose and similar functions from the keyword arguments
/// `columns`, `drop_nan`, `from`, `until`, `per_record`, `rows`, `channel` and `tolerance` of
/// Python. Throws TypeError for other keywords. An argument that is None has no effect.
[[nodiscard]] session::LoopOptions options_of(const py::kwargs& given);

/// Runs `work` for a call from Python and adds the messages of `work` to the answer. Python can
/// interrupt the call.
template <typename Work>
EngineAnswer answered(const Waiting& waiting, std::atomic<bool>& cancelled,
                      const Progress& progress, const Work& work) {
  Heard heard;
  EngineAnswer answer = interruptible(cancelled, progress, waiting, [&] { return work(heard); });
  append(answer.notes, std::move(heard.notes));
  append(heard.warnings, std::move(answer.warnings));
  answer.warnings = std::move(heard.warnings);
  return answer;
}

template <typename Work>
EngineAnswer answered(const Work& work) {
  std::atomic<bool> cancelled = false;
  return answered(Waiting(), cancelled, Progress(), work);
}

void bind_answer(py::module_& module);

}  // namespace raceway::python

#include "python/engine/own_effect.h"

#include <pybind11/stl.h>

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "python/engine/arrays.h"
#include "record/record.h"

namespace raceway::python {
namespace {

/// Calls a function of Python for all rows of a record at once and remembers what it gave for each:
/// models are asked row by row, from several threads, again and again.
class PythonMoment final : public effects::OwnMoment {
 public:
  explicit PythonMoment(py::object function)
      : function_(new py::object(std::move(function)), [](py::object* kept) {
          const py::gil_scoped_acquire lock;
          delete kept;
        }) {}

  [[nodiscard]] double moment(const effects::MomentInputs& inputs,
                              std::span<const double> values) const override {
    const std::vector<double> numbers(values.begin(), values.end());
    if (!inputs.record.rows) return called(point(inputs), inputs, numbers).front() * N_mm;
    const record::Record& record = *inputs.record.rows;
    const Key row = key(record, inputs.record.row);
    if (const double known = remembered(numbers, row); !std::isnan(known)) return known;
    const std::vector<double> torques = called(columns(record), inputs, numbers);
    const std::lock_guard lock(mutex_);
    if (known_.size() > most_remembered) known_.clear();
    Rows& rows = known_[numbers];
    for (std::size_t k = 0; k < torques.size(); ++k) rows[key(record, k)] = torques[k] * N_mm;
    return torques[inputs.record.row] * N_mm;
  }
  [[nodiscard]] bool stands_in_files() const override { return false; }

 private:
  using Key = std::vector<double>;  // of a row: all that was set or recorded
  using Rows = std::map<Key, double>;
  using Columns = std::vector<std::pair<std::string, std::vector<double>>>;
  static constexpr std::size_t most_remembered = 512;  // sets of numbers

  static Key key(const record::Record& record, std::size_t row) {
    Key numbers;
    for (const record::Column& column : record.columns)
      if (column.channel->is_input())
        numbers.push_back(std::isnan(column.values[row]) ? -1e300 : column.values[row]);
    return numbers;
  }
  [[nodiscard]] double remembered(const std::vector<double>& numbers, const Key& row) const {
    const std::lock_guard lock(mutex_);
    const auto rows = known_.find(numbers);
    if (rows == known_.end()) return unset;
    const auto found = rows->second.find(row);
    return found == rows->second.end() ? unset : found->second;
  }

  /// In the units of files; what was measured is not among them.
  static Columns columns(const record::Record& record) {
    Columns list;
    for (const record::Column& column : record.columns) {
      if (!column.channel->is_input()) continue;
      std::vector<double> values;
      for (const double si : column.values) values.push_back(column.channel->in_unit(si));
      list.emplace_back(column.channel->name, std::move(values));
    }
    return list;
  }
  static Columns point(const effects::MomentInputs& inputs) {
    return {{"speed_rpm", {inputs.state.speed / rpm}},
            {"axial_load_N", {inputs.state.axial_load}},
            {"radial_load_N", {inputs.state.radial_load}},
            {"temperature_C", {celsius(inputs.state.temperature)}}};
  }

  [[nodiscard]] std::vector<double> called(Columns columns, const effects::MomentInputs& inputs,
                                           const std::vector<double>& numbers) const {
    const py::gil_scoped_acquire lock;
    py::dict given;
    const std::size_t rows = columns.front().second.size();
    for (auto& [name, values] : columns) given[py::str(name)] = owned(std::move(values), {rows});
    given["pitch_diameter_mm"] = inputs.state.pitch_diameter() / mm;
    if (const bearing::Bearing* const balls = inputs.state.bearing) {
      const bearing::BearingGeometry& g = balls->geometry();
      given["ball_diameter_mm"] = g.ball_diameter / mm;
      given["ball_count"] = g.ball_count;
      given["contact_angle_deg"] = g.contact_angle / degree;
    }
    return (*function_)(given, numbers, rows).cast<std::vector<double>>();
  }

  std::shared_ptr<py::object> function_;
  mutable std::mutex mutex_;  // never held while the interpreter is waited for
  mutable std::map<std::vector<double>, Rows> known_;
};

}  // namespace

effects::Effect OwnEffect::effect() const {
  return effects::make_effect(described, std::make_unique<PythonMoment>(function));
}

std::vector<OwnEffect> own_effects(const py::list& given) {
  using Number = std::tuple<std::string, std::string, double, double, double>;
  std::vector<OwnEffect> list;
  for (const py::handle one : given) {
    const auto [id, title, numbers, function] =
        one.cast<std::tuple<std::string, std::string, std::vector<Number>, py::object>>();
    OwnEffect effect{.described = {.id = id,
                                   .title = title,
                                   .torque_Nmm = "a Python function",
                                   .parameters = {}},
                     .function = function};
    for (const auto& [name, unit, value, lower, upper] : numbers)
      effect.described.parameters.push_back(
          {.name = name, .unit = unit, .value = value, .lower = lower, .upper = upper});
    list.push_back(std::move(effect));
  }
  return list;
}

}  // namespace raceway::python

#include "python/engine/answer.h"

#include <pybind11/stl.h>

#include "python/engine/arrays.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::python {
namespace {

/// Keyword arguments of Python that name what a command has as a flag.
void take(session::LoopOptions& options, const std::string& name, const py::handle& value) {
  if (name == "columns")
    options.reading.columns_text = value.cast<std::string>();
  else if (name == "drop_nan")
    options.reading.drop_nan = value.cast<bool>();
  else if (name == "from")
    options.reading.period.from = value.cast<std::string>();
  else if (name == "until")
    options.reading.period.until = value.cast<std::string>();
  else if (name == "per_record")
    options.per_record = value.cast<std::vector<std::string>>();
  else if (name == "rows")
    options.rows = value.cast<bool>();
  else if (name == "channel")
    options.channel = value.cast<std::string>();
  else if (name == "tolerance")
    options.tolerance.text = value.cast<std::string>();
  else
    throw py::type_error("unexpected option " + name);
}

/// What an answer makes when it is asked for, without the lock of the interpreter.
template <typename Make>
auto made(const Make& make, const char* missing) {
  if (!make) throw text::InputError(missing);
  const py::gil_scoped_release others;
  return make();
}

/// Columns of numbers, or lists of text.
std::shared_ptr<session::Source> data_of_columns(const std::string& name, const py::dict& given) {
  std::vector<text::DataColumn> columns;
  for (const auto& [key, values] : given) {
    text::DataColumn column{.name = key.cast<std::string>()};
    if (py::isinstance<py::array>(values)) {
      const auto numbers =
          values.cast<py::array_t<double, py::array::c_style | py::array::forcecast>>();
      column.numbers.assign(numbers.data(), numbers.data() + numbers.size());
    } else {
      column.texts = values.cast<std::vector<std::string>>();
    }
    columns.push_back(std::move(column));
  }
  return std::make_shared<session::Source>(
      std::make_shared<const text::CsvTable>(text::table_of_columns(name, std::move(columns))));
}

py::list own_effects_of(const EngineAnswer& answer) {
  py::list models;
  for (const auto& own : answer.fitted.own_effects) {
    py::dict of;
    for (const auto& [id, values] : own) of[py::str(id)] = py::cast(values);
    models.append(of);
  }
  return models;
}

}  // namespace

session::LoopOptions options_of(const py::kwargs& given) {
  session::LoopOptions options;
  for (const auto& [key, value] : given)
    if (!value.is_none()) take(options, key.cast<std::string>(), value);
  return options;
}

std::vector<double> in_unit(const record::Channel& channel, std::span<const double> si) {
  std::vector<double> values;
  values.reserve(si.size());
  for (const double value : si) {
    const double in_unit_of_file = text::value_in_unit(channel, value);
    values.push_back(channel.role == record::Role::setting ? as_entered(in_unit_of_file)
                                                           : in_unit_of_file);
  }
  return values;
}

NamedColumns columns_of(const record::Record& record) {
  NamedColumns columns;
  for (const record::Column& column : record.columns)
    columns.emplace_back(column.channel->name, in_unit(*column.channel, column.values));
  return columns;
}

py::dict arrays_of(NamedColumns columns) {
  py::dict arrays;
  for (auto& [name, values] : columns) {
    const std::vector<std::size_t> shape{values.size()};
    arrays[py::str(name)] = owned(std::move(values), shape);
  }
  return arrays;
}

void bind_answer(py::module_& module) {
  py::class_<session::Source, std::shared_ptr<session::Source>>(module, "Data")
      .def(py::init<std::string, std::string>(), py::arg("name"), py::arg("text"))
      .def(py::init(&data_of_columns), py::arg("name"), py::arg("columns"))
      .def(
          "with_beside",
          [](const session::Source& data, const std::vector<Data>& others) {
            auto joined = std::make_shared<session::Source>(data);
            for (const Data& other : others) joined->beside.push_back(*other);
            return joined;
          },
          py::arg("others"));
  py::class_<EngineAnswer>(module, "Answer")
      .def_readonly("json", &EngineAnswer::json)
      .def_readonly("notes", &EngineAnswer::notes)
      .def_readonly("warnings", &EngineAnswer::warnings)
      .def_readonly("converged", &EngineAnswer::converged)
      .def_readonly("refused", &EngineAnswer::refused)
      .def_property_readonly("records", [](const EngineAnswer& a) { return a.fitted.records; })
      .def_property_readonly("models", [](const EngineAnswer& a) { return a.fitted.texts; })
      .def_property_readonly("own_effects", &own_effects_of)
      .def("page",
           [](const EngineAnswer& a) {
             return made(a.page, "this result has no HTML page; the result of compare() has one");
           })
      .def("csv", [](const EngineAnswer& a) { return made(a.csv, "this result has no rows"); })
      .def("rows", [](const EngineAnswer& a) {
        return arrays_of(made(a.rows, "this result has no rows"));
      });
}

}  // namespace raceway::python

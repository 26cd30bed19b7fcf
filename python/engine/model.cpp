#include "python/engine/model.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <map>

#include "effects/catalogue.h"
#include "python/engine/answer.h"
#include "python/engine/interruptible.h"
#include "session/bands.h"
#include "session/new_model.h"
#include "session/open_input.h"
#include "session/operating_point.h"
#include "session/solve_point.h"
#include "session/solve_states.h"
#include "text/csv_form.h"
#include "text/input_file.h"
#include "text/missing_cell.h"
#include "text/output_file.h"
#include "text/text_encoding.h"

namespace raceway::python {
namespace {

using Named = std::vector<std::pair<std::string, Doubles>>;

/// Arrays by name as the states that they stand for.
session::StateArrays state_arrays(const Named& given) {
  using States = session::StateArrays;
  static const std::map<std::string, session::NumberArray States::*> fields{
      {"speed_rpm", &States::speed_rpm},         {"axial_load_N", &States::axial_load_N},
      {"radial_load_N", &States::radial_load_N}, {"temperature_C", &States::temperature_C},
      {"moment_y_Nmm", &States::moment_y_Nmm},   {"moment_z_Nmm", &States::moment_z_Nmm}};
  States states;
  states.shape = broadcast_shape(given);
  for (const auto& [name, array] : given)
    states.*fields.at(name) = number_array(array, states.shape);
  return states;
}

Named named(const py::dict& given) {
  Named arrays;
  for (const auto& [name, array] : given)
    arrays.emplace_back(name.cast<std::string>(), array.cast<Doubles>());
  return arrays;
}

/// Columns as one array of [column, ...shape], and the status of each state by its number.
py::tuple solved_arrays(session::SolvedStates solved, const std::vector<std::size_t>& shape,
                        const Heard& heard) {
  std::vector<std::size_t> of_values = shape;
  of_values.insert(of_values.begin(), solved.columns.size());
  std::vector<std::uint8_t> status;
  status.reserve(solved.status.size());
  for (const bearing::SolveStatus s : solved.status) status.push_back(static_cast<std::uint8_t>(s));
  return py::make_tuple(solved.columns, owned(std::move(solved.values), of_values),
                        owned(std::move(status), shape), heard.notes, heard.warnings);
}

py::tuple solve(const EngineModel& model, const py::dict& given,
                const std::vector<std::string>& columns, bool with_band) {
  const Named arrays = named(given);  // keeps them alive
  const session::StateArrays states = state_arrays(arrays);
  Heard heard;
  std::atomic<bool> cancelled = false;
  const std::optional<model::Band> band = model.band(with_band);
  if (band) heard.say(record::note::band("band: " + session::band_statement(*band)));
  const auto work = [&] {
    return session::solve_states(heard, model.file(), states, columns, &cancelled,
                                 band ? &*band : nullptr);
  };
  const auto at_once = [&] {
    const py::gil_scoped_release others;
    return work();
  };
  if (states.size() == 1 && states.shape.empty() && columns.empty()) {
    const session::SolvedStates one = [&] {
      const py::gil_scoped_release others;
      return session::solve_state(heard, model.file(), states, band ? &*band : nullptr);
    }();
    return solved_arrays(one, states.shape, heard);
  }
  constexpr std::size_t few = 2000;  // over before anybody wants to interrupt
  session::SolvedStates solved =
      states.size() <= few ? at_once() : interruptible(cancelled, Progress(), Waiting(), work);
  return solved_arrays(std::move(solved), states.shape, heard);
}

/// Where the numbers of these arrays are read, and by what strides, as solve() does.
py::list views(const py::dict& given) {
  const Named arrays = named(given);
  const std::vector<std::size_t> shape = broadcast_shape(arrays);
  py::list result;
  for (const auto& [name, array] : arrays) {
    const session::NumberArray numbers = number_array(array, shape);
    result.append(
        py::make_tuple(name, reinterpret_cast<std::uintptr_t>(numbers.data), numbers.strides));
  }
  return result;
}

/// One state as the document of `raceway solve --json`.
std::string solve_document(const EngineModel& model, const py::dict& given, bool with_band) {
  const Named arrays = named(given);
  const session::StateArrays states = state_arrays(arrays);
  const std::optional<model::Band> band = model.band(with_band);
  const py::gil_scoped_release others;
  Heard said;  // with the state itself
  const bearing::OperatingPoint point = session::single_state(said, model.file(), states);
  const model::Model& m = model.file().model;
  return session::point_json(m, point, session::solve_point(m, point, band));
}

/// Python has UTF-8: what Excel writes of umlauts becomes that.
std::string read_text(const std::string& path) {
  std::string text = text::read_text(path);
  if (text::is_utf16(text)) return text::utf8_from_utf16(text, path);
  return text::is_utf8(text) ? text : text::utf8_from_latin1(text);
}

/// A table in any form that records have, as one with commas, decimal points and every text in
/// quotes: without titles and row of units, and nothing where no number was read.
std::string plain_csv(const std::string& name, const std::string& text) {
  const auto form = [](std::string_view lines) {
    return text::find_form(lines, [](std::string_view) { return false; });
  };
  const text::CsvTable table = text::parse_csv(text, name, false, form);
  std::string plain;
  const auto put = [&](std::size_t column, std::string_view cell, bool quote) {
    if (column > 0) plain += ',';
    if (!quote) return void(plain += cell);
    plain += '"';
    for (const char c : cell) plain += c == '"' ? std::string("\"\"") : std::string(1, c);
    plain += '"';
  };
  for (std::size_t c = 0; c < table.header.size(); ++c) put(c, table.header[c], true);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    plain += '\n';
    for (std::size_t c = 0; c < table.header.size(); ++c) {
      std::string cell(text::is_missing(table.cell(row, c)) ? "" : table.cell(row, c));
      const text::ParsedNumber number = table.parsed(row, c);
      if (number.problem.empty()) {
        const text::ParsedNumber as_written = text::parse_number(cell, true);
        if (as_written.value != number.value) cell = fmt::format("{}", number.value);
        std::replace(cell.begin(), cell.end(), ',', '.');
      }
      put(c, cell, !number.problem.empty() && !cell.empty());
    }
  }
  return plain + '\n';
}

}  // namespace

EngineModel::EngineModel(const std::string& source, const std::string& text, const py::list& own,
                         const HeldFiles& held)
    : own_(own_effects(own)),
      file_(session::open_model(heard_, session::Source(source, text, named_files(held)),
                                session::Accepts::rig_or_shaft, session::Defaults::keep)) {
  amend(file_);
  if (file_.model.shaft) return;
  Heard ignored;
  session::warn_of_ignored_data(ignored, file_);
  append(heard_.notes, std::move(ignored.warnings));
}

void EngineModel::amend(files::ModelFile& file) const {
  for (const OwnEffect& own : own_) {
    const std::string& id = own.described.id;
    const auto has_id = [&](const effects::Effect& e) { return e.description->id == id; };
    if (effects::find(id, file.model.form()) ||
        std::any_of(file.model.effects.begin(), file.model.effects.end(), has_id))
      throw text::InputError(id + ": an effect already has this name; choose another name",
                             {.key = id});
    file.model.effects.push_back(own.effect());
  }
}

std::optional<model::Band> EngineModel::band(bool wanted) const {
  if (!wanted) return std::nullopt;
  return session::band_of(
      file_, "band",
      "the models calibrate(record).model and add(...).model have [calibration.covariance]");
}

std::string EngineModel::kind() const {
  return file_.model.spindle ? "spindle" : file_.model.shaft ? "shaft" : "rig";
}

std::string EngineModel::with_values(const py::dict& values) const {
  std::vector<files::KeyValue> changes;
  const std::vector<record::Parameter> known = parameters();
  for (const auto& [key, value] : values) {
    const auto name = key.cast<std::string>();
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const record::Parameter& p) { return p.name == name; });
    if (found == known.end() && name.find('.') != name.npos) {  // [table] and key of the file
      changes.push_back({.key = name, .value = value.cast<double>(), .comment = {}});
      continue;
    }
    if (found == known.end())
      throw text::InputError(name + ": no such parameter of " + file_.source +
                                 "; name a number of the model file by its table and key, such as "
                                 "lubricant.viscosity_40C_mm2_s",
                             {.key = name});
    for (const std::string& address : found->addresses)
      changes.push_back({.key = address, .value = value.cast<double>(), .comment = {}});
  }
  return files::with_values(file_.text, changes);
}

void bind_model(py::module_& module) {
  py::class_<EngineFile, std::shared_ptr<EngineFile>>(module, "File")
      .def_property_readonly("source", [](const EngineFile& f) { return f.source().name; })
      .def_property_readonly("text", [](const EngineFile& f) { return *f.source().text; })
      .def_property_readonly("files",
                             [](const EngineFile& f) {
                               HeldFiles held;
                               for (const files::NamedFile& file : f.source().files)
                                 held.emplace_back(file.name, file.path, file.text);
                               return held;
                             })
      .def("text_for",
           [](const EngineFile& f, const std::string& path) {
             return files::with_names_from(*f.source().text, f.source().files, path);
           })
      .def_property_readonly("defaults", &EngineFile::defaults)
      .def_property_readonly("parameters",
                             [](const EngineFile& f) {
                               py::dict all;
                               for (const record::Parameter& p : f.parameters()) {
                                 py::dict of;
                                 of["value"] = p.value;
                                 of["unit"] = p.unit;
                                 of["lower"] = p.lower;
                                 of["upper"] = p.upper;
                                 all[py::str(p.name)] = of;
                               }
                               return all;
                             })
      .def_property_readonly("notes", [](const EngineFile& f) { return f.heard().notes; })
      .def_property_readonly("warnings", [](const EngineFile& f) { return f.heard().warnings; });
  py::class_<EngineModel, EngineFile, std::shared_ptr<EngineModel>>(module, "Model")
      .def(py::init<const std::string&, const std::string&, const py::list&, const HeldFiles&>(),
           py::arg("source"), py::arg("text"), py::arg("own") = py::list(),
           py::arg("files") = HeldFiles())
      .def_property_readonly("name", [](const EngineModel& m) { return m.file().model.name; })
      .def_property_readonly("kind", &EngineModel::kind)
      .def_property_readonly(
          "columns", [](const EngineModel& m) { return session::state_columns(m.file().model); })
      .def("with_values", &EngineModel::with_values)
      .def("solve", &solve)
      .def("solve_document", &solve_document);
  module.def("views", &views);
  module.def("read_text", &read_text);
  module.def("plain_csv", &plain_csv);
  module.def("write_files", [](const std::vector<std::pair<std::string, std::string>>& texts,
                               bool overwrite) {
    std::vector<text::OutputFile> files;
    for (const auto& [path, text] : texts) files.push_back({path, text});
    text::write_files(files, overwrite ? text::IfExists::replace : text::IfExists::refuse);
  });
  module.def(
      "new_model",
      [](const std::string& bearing, const std::string& law, const std::string& ball_material,
         double bore_mm, double outer_diameter_mm, double contact_angle_deg, int ball_count,
         bool spindle, const std::string& oil) {
        Heard heard;
        const session::NewModel wanted{.bearing = bearing,
                                       .outline = {.bore = bore_mm * mm,
                                                   .outer_diameter = outer_diameter_mm * mm,
                                                   .ball_count = ball_count,
                                                   .ball_material = ball_material},
                                       .contact_angle = contact_angle_deg,
                                       .law = law,
                                       .spindle = spindle,
                                       .oil = oil};
        std::string text = session::new_model_text(heard, wanted);
        return py::make_tuple(text, heard.notes);
      },
      py::arg("bearing"), py::arg("law"), py::arg("ball_material"), py::arg("bore_mm"),
      py::arg("outer_diameter_mm"), py::arg("contact_angle_deg"), py::arg("ball_count"),
      py::arg("spindle"), py::arg("oil"));
}

}  // namespace raceway::python

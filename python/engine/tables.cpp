#include <pybind11/stl.h>

#include <atomic>
#include <memory>
#include <optional>

#include "friction/stribeck_table.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "session/bands.h"
#include "session/operating_point.h"
#include "session/shaft_curve.h"
#include "session/table_question.h"
#include "text/units.h"

namespace raceway::python {
namespace {

/// A Stribeck table with the model that it is of.
class EngineTable {
 public:
  EngineTable(std::shared_ptr<const EngineModel> model, session::AskedAxes axes, bool with_band)
      : model_(std::move(model)) {
    const session::TableQuestion question{.axes = std::move(axes), .band = model_->band(with_band)};
    session::TablePlan plan = session::plan_table(heard_, file(), question);
    std::atomic<bool> cancelled = false;
    answer_ = interruptible(cancelled, Progress(), Waiting(), [&] {
      return session::make_table(file(), question, std::move(plan), {}, &cancelled);
    });
  }
  [[nodiscard]] const friction::StribeckTable& table() const { return answer_.table; }
  [[nodiscard]] std::string json() const { return answer_.json(file().model); }
  [[nodiscard]] const std::string& bearing() const { return file().model.name; }
  [[nodiscard]] std::string text(const std::string& format) const {
    return answer_.text(file(), format);
  }
  [[nodiscard]] std::vector<record::Note> notes() const {
    std::vector<record::Note> list = heard_.notes;
    if (answer_.band)
      list.push_back(record::note::band("band: " + session::band_statement(*answer_.band)));
    append(list, notes_of(record::note::load_limit, answer_.notes(file().model)));
    return list;
  }
  [[nodiscard]] std::vector<record::Note> warnings() const { return answer_.warnings(); }
  /// Names, numbers by point and column, status by point.
  [[nodiscard]] py::tuple columns() const {
    std::vector<std::string> names{"speed_rpm", "axial_load_N", "radial_load_N", "temperature_C",
                                   "friction_torque_Nmm"};
    const std::size_t points = table().points();
    names.insert(names.end(), table().columns.begin(), table().columns.end());
    std::vector<double> values(points * names.size());
    const auto put = [&](std::size_t column, std::size_t point, double value) {
      values[column * points + point] = value;
    };
    std::vector<double> units;
    for (const std::string& name : table().columns) units.push_back(text::column_unit(name));
    std::vector<std::string> status;
    for (std::size_t k = 0; k < points; ++k) {
      const bearing::OperatingPoint p = table().point(k);
      put(0, k, as_entered(p.speed / rpm));
      put(1, k, as_entered(p.axial_load));
      put(2, k, as_entered(p.radial_load));
      put(3, k, as_entered(celsius(p.temperature)));
      put(4, k, table().friction_moment[k] / N_mm);
      const auto row = table().row(k);
      for (std::size_t c = 0; c < row.size(); ++c) put(5 + c, k, row[c] / units[c]);
      status.emplace_back(bearing::name(table().status[k]));
    }
    const std::vector<std::size_t> shape{names.size(), points};
    return py::make_tuple(names, owned(std::move(values), shape), status);
  }

 private:
  [[nodiscard]] const files::ModelFile& file() const { return model_->file(); }

  std::shared_ptr<const EngineModel> model_;
  Heard heard_;
  session::TableAnswer answer_;
};

/// The position of a shaft over its speed.
class EngineDisplacement {
 public:
  EngineDisplacement(std::shared_ptr<const EngineModel> model, std::vector<double> speed_rpm,
                     double axial_load_N, double temperature_C, bool with_band)
      : model_(std::move(model)) {
    const session::CurveQuestion question{.speed_rpm = std::move(speed_rpm),
                                          .axial_load_N = axial_load_N,
                                          .temperature_C = temperature_C,
                                          .band = model_->band(with_band)};
    const py::gil_scoped_release others;
    curve_.emplace(heard_, model_->file(), question);
  }
  [[nodiscard]] std::string json() const { return curve_->json(); }
  [[nodiscard]] std::string csv() const { return curve_->csv(); }
  [[nodiscard]] std::vector<record::Note> warnings() const {
    std::vector<record::Note> list = heard_.notes;
    append(list, curve_->warnings());
    return list;
  }

 private:
  std::shared_ptr<const EngineModel> model_;
  Heard heard_;
  std::optional<session::ShaftCurve> curve_;
};

}  // namespace

void bind_tables(py::module_& module) {
  py::class_<EngineTable>(module, "Table")
      .def(py::init([](std::shared_ptr<EngineModel> model, bool band, std::vector<double> speed_rpm,
                       std::vector<double> axial_load_N, std::vector<double> radial_load_N,
                       std::vector<double> temperature_C) {
        return EngineTable(std::move(model),
                           {std::move(speed_rpm), std::move(axial_load_N), std::move(radial_load_N),
                            std::move(temperature_C)},
                           band);
      }))
      .def_property_readonly("notes", &EngineTable::notes)
      .def_property_readonly("warnings", &EngineTable::warnings)
      .def_property_readonly("bearing", &EngineTable::bearing)
      .def_property_readonly("points", [](const EngineTable& t) { return t.table().points(); })
      .def("json", &EngineTable::json)
      .def("text", &EngineTable::text)
      .def("columns", &EngineTable::columns);
  py::class_<EngineDisplacement>(module, "Displacement")
      .def(py::init<std::shared_ptr<EngineModel>, std::vector<double>, double, double, bool>())
      .def_property_readonly("warnings", &EngineDisplacement::warnings)
      .def("json", &EngineDisplacement::json)
      .def("csv", &EngineDisplacement::csv);
}

}  // namespace raceway::python

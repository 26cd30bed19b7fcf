#include <pybind11/stl.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <optional>

#include "fit/problem.h"
#include "friction/stribeck_table.h"
#include "io/number_range.h"
#include "io/number_text.h"
#include "io/plausible.h"
#include "io/results.h"
#include "io/shaft_results.h"
#include "io/table_exchange.h"
#include "io/table_file.h"
#include "io/units.h"
#include "python/engine/interruptible.h"
#include "python/engine/model.h"
#include "session/bands.h"
#include "session/shaft_answers.h"
#include "session/table_columns.h"
#include "shaft/shaft_prediction.h"

namespace raceway::python {
namespace {

/// Of the first temperature that looks like kelvin.
std::vector<std::string> kelvin_doubts(const std::vector<double>& temperatures_C) {
  for (const double value : temperatures_C)
    if (std::string doubt = io::looks_like_kelvin("temperature_C", value); !doubt.empty())
      return {std::move(doubt)};
  return {};
}

/// Axis by axis in the units of files, each rising.
struct Axes {
  std::vector<double> speed_rpm, axial_load_N, radial_load_N, temperature_C;
};

std::vector<double> in_SI(std::vector<double> values, const io::NumberRange& range,
                          const std::string& name, double unit, double offset) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    io::require_range(values[i], range, name + "[" + std::to_string(i) + "]");
    if (i > 0 && values[i] <= values[i - 1])
      throw io::InputError(name + ": the values of an axis of a table must rise, and " +
                               io::number(values[i]) + " follows " + io::number(values[i - 1]),
                           {.key = name});
  }
  for (double& value : values) value = value * unit + offset;
  return values;
}

friction::TableAxes table_axes(const EngineModel& model, const Axes& asked) {
  const model::Model& m = model.file().model;
  if (m.shaft && !asked.radial_load_N.empty())
    throw io::InputError("radial_load_N: " + model.file().source +
                             " has an [arrangement]: a shaft takes axial_load_N alone",
                         {.file = model.file().source, .key = "radial_load_N"});
  const double axial_load = m.shaft ? m.shaft->external_load : m.rig.axial_load;
  if (asked.axial_load_N.empty() && std::isnan(axial_load))
    throw io::InputError(
        "axial_load_N is missing, and " + model.file().source + " has no axial_load_N under [rig]",
        {.file = model.file().source, .key = "axial_load_N"});
  const auto given = [](const std::vector<double>& values, double otherwise) {
    return values.empty() ? std::vector<double>{otherwise} : values;
  };
  friction::TableAxes axes;
  axes.speed = in_SI(asked.speed_rpm, io::speed_range, "speed_rpm", rpm, 0.0);
  axes.axial_load = in_SI(given(asked.axial_load_N, axial_load),
                          m.shaft ? io::signed_load_range : io::load_range, "axial_load_N", 1, 0);
  axes.radial_load = in_SI(given(asked.radial_load_N, m.shaft ? 0.0 : m.rig.radial_load),
                           io::load_range, "radial_load_N", 1, 0);
  axes.temperature = in_SI(given(asked.temperature_C, celsius(m.rig.temperature)),
                           io::temperature_range, "temperature_C", 1, celsius_zero);
  if (axes.speed.empty()) throw io::InputError("speed_rpm is missing", {.key = "speed_rpm"});
  return axes;
}

/// A Stribeck table with the model that it is of.
class EngineTable {
 public:
  EngineTable(std::shared_ptr<const EngineModel> model, const Axes& axes, bool with_band)
      : model_(std::move(model)),
        band_(model_->band(with_band)),
        doubts_(kelvin_doubts(axes.temperature_C)) {
    const model::Model& m = model_->file().model;
    const friction::TableAxes grid = table_axes(*model_, axes);
    std::vector<std::string> columns = session::table_columns(m);
    if (band_)
      for (std::string& name : session::band_columns(m)) columns.push_back(std::move(name));
    std::atomic<bool> cancelled = false;
    table_ = interruptible(cancelled, Progress(), Waiting(), [&] {
      return friction::build_stribeck_table(grid, std::move(columns), [&](auto points, auto out) {
        if (cancelled) throw fit::Cancelled();
        session::fill_table_line(m, points, out);
        if (band_) session::fill_band(m, *band_, points, out);
      });
    });
  }
  [[nodiscard]] const friction::StribeckTable& table() const { return table_; }
  [[nodiscard]] std::string json() const {
    const io::BandOfResult of_band{
        .parameters = band_ ? band_->fitted() : std::vector<std::string>(),
        .names = {},
        .half_widths = {}};
    return io::table_json(model_->file().model, table_, band_ ? &of_band : nullptr);
  }
  [[nodiscard]] const std::string& bearing() const { return model_->file().model.name; }
  [[nodiscard]] std::string csv() const {
    return io::table_text(table_, model_->file().model.name, model_->file().text);
  }
  [[nodiscard]] std::string plain() const { return io::plain_table_text(table_); }
  [[nodiscard]] std::string modelica() const {
    return io::modelica_table_text(table_, model_->file().model.name);
  }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> lines = session::table_notes(model_->file().model, table_);
    lines.insert(lines.begin(), doubts_.begin(), doubts_.end());
    if (band_) lines.insert(lines.begin(), "band: " + session::band_statement(*band_));
    return lines;
  }
  /// Names, numbers by point and column, status by point.
  [[nodiscard]] py::tuple columns() const {
    std::vector<std::string> names{"speed_rpm", "axial_load_N", "radial_load_N", "temperature_C",
                                   "friction_torque_Nmm"};
    const std::size_t points = table_.points();
    names.insert(names.end(), table_.columns.begin(), table_.columns.end());
    std::vector<double> values(points * names.size());
    const auto put = [&](std::size_t column, std::size_t point, double value) {
      values[column * points + point] = value;
    };
    std::vector<double> units;
    for (const std::string& name : table_.columns) units.push_back(io::column_unit(name));
    std::vector<std::string> status;
    for (std::size_t k = 0; k < points; ++k) {
      const bearing::OperatingPoint p = table_.point(k);
      put(0, k, as_entered(p.speed / rpm));
      put(1, k, as_entered(p.axial_load));
      put(2, k, as_entered(p.radial_load));
      put(3, k, as_entered(celsius(p.temperature)));
      put(4, k, table_.friction_moment[k] / N_mm);
      const auto row = table_.row(k);
      for (std::size_t c = 0; c < row.size(); ++c) put(5 + c, k, row[c] / units[c]);
      status.emplace_back(bearing::name(table_.status[k]));
    }
    const std::vector<std::size_t> shape{names.size(), points};
    return py::make_tuple(names, owned(std::move(values), shape), status);
  }

 private:
  std::shared_ptr<const EngineModel> model_;
  std::optional<model::Band> band_;
  std::vector<std::string> doubts_;
  friction::StribeckTable table_;
};

/// The position of a shaft over its speed.
class EngineDisplacement {
 public:
  EngineDisplacement(std::shared_ptr<const EngineModel> model, const std::vector<double>& speed_rpm,
                     double axial_load_N, double temperature_C, bool with_band)
      : model_(std::move(model)) {
    const model::Model& m = model_->file().model;
    doubts_ = kelvin_doubts({temperature_C});
    if (!m.shaft)
      throw io::InputError(model_->file().source +
                               ": has no [arrangement]: a shaft position needs one, with layout, "
                               "front, rear and preload_N",
                           {.file = model_->file().source, .key = "arrangement"});
    for (std::size_t i = 0; i < speed_rpm.size(); ++i) {
      io::require_range(speed_rpm[i], io::speed_range, "speed_rpm[" + std::to_string(i) + "]");
      points_.push_back(
          {.speed = speed_rpm[i] * rpm,
           .external_load = std::isnan(axial_load_N) ? m.shaft->external_load : axial_load_N,
           .temperature = std::isnan(temperature_C) ? m.rig.temperature : kelvin(temperature_C)});
    }
    const std::optional<model::Band> band = model_->band(with_band);
    const py::gil_scoped_release others;
    predictions_ = shaft::predict_shaft(m, points_);
    if (band) band_ = session::shaft_band(*band, points_);
  }
  [[nodiscard]] std::string json() const {
    return io::displacement_json(model_->file().model, points_, predictions_, band());
  }
  [[nodiscard]] std::string csv() const {
    return io::displacement_text(model_->file().model, points_, predictions_, model_->file().text,
                                 band());
  }
  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> lines =
        session::shaft_warnings(model_->file().model, points_, predictions_);
    lines.insert(lines.begin(), doubts_.begin(), doubts_.end());
    return lines;
  }

 private:
  [[nodiscard]] const io::BandOfResult* band() const { return band_ ? &*band_ : nullptr; }

  std::shared_ptr<const EngineModel> model_;
  std::optional<io::BandOfResult> band_;
  std::vector<std::string> doubts_;
  std::vector<shaft::ShaftPoint> points_;
  std::vector<shaft::ShaftPrediction> predictions_;
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
      .def_property_readonly("bearing", &EngineTable::bearing)
      .def_property_readonly("points", [](const EngineTable& t) { return t.table().points(); })
      .def("json", &EngineTable::json)
      .def("csv", &EngineTable::csv)
      .def("plain", &EngineTable::plain)
      .def("modelica", &EngineTable::modelica)
      .def("columns", &EngineTable::columns);
  py::class_<EngineDisplacement>(module, "Displacement")
      .def(py::init<std::shared_ptr<EngineModel>, const std::vector<double>&, double, double,
                    bool>())
      .def_property_readonly("warnings", &EngineDisplacement::warnings)
      .def("json", &EngineDisplacement::json)
      .def("csv", &EngineDisplacement::csv);
}

}  // namespace raceway::python

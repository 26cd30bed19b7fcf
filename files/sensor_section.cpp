#include <Eigen/Core>
#include <filesystem>

#include "files/sensor_file.h"
#include "text/input_file.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/number_lists.h"
#include "files/detail/sensor_section.h"

namespace raceway::files {
namespace {

constexpr Key torque_sensor_keys[]{
    {"coefficients", a_list, is_required,
     "2 to 4 coefficients c_k of the curve signal = sum of c_k M^k (k from 0), signal in V and "
     "torque M in N m; written by calibrate-sensor"},
    {"units", a_list, is_required, "units of the coefficients, [\"V\", \"V/Nm\", ...]"},
    {"std", a_list, is_required, "standard errors of the coefficients"},
    {"correlation", a_list, is_required,
     "correlation of the coefficients: lower triangle, row by row"},
    {"residual_std_V", between(0, 1e6, "V"), is_required,
     "standard deviation of the signal of one reading about the curve"},
    {"torque_from_Nm", between(-1e9, 1e9, "Nm"), is_required,
     "lowest torque of the calibration; below it, the curve continues along its tangent"},
    {"torque_to_Nm", between(-1e9, 1e9, "Nm"), is_required,
     "highest torque of the calibration; above it, the curve continues along its tangent"},
    {"signal_from_V", between(-1e6, 1e6, "V"), is_required,
     "lowest signal of the calibration; a note gives the number of signals outside the "
     "calibration"},
    {"signal_to_V", between(-1e6, 1e6, "V"), is_required, "highest signal of the calibration"},
    {"readings", whole(1, 1e9), unset, "number of readings in the calibration, shown in messages"},
    {"source", a_text, unset, "source of the calibration, shown in messages"},
};
constexpr Key sensor_zero_keys[]{
    {"zero_V", between(-1e6, 1e6, "V"), "the first coefficient",
     "signal at zero torque on the day of the test"},
    {"zero_std_V", between(0, 1e6, "V"), "residual_std_V", "standard deviation of zero_V"},
    {"file", a_text, unset,
     "file with this table (path relative to the model); replaces all keys except zero_V and "
     "zero_std_V"},
};

/// The coefficients, each in its unit.
Eigen::VectorXd read_coefficients(const Section& s) {
  const toml::node& node = required_node(s, "coefficients");
  const std::size_t count = node.is_array() ? node.as_array()->size() : 0;
  if (count < 2 || count > std::size_t{rig::highest_sensor_degree + 1})
    s.fail("coefficients", fmt::format("coefficients = {}: must be a list of 2 to {} numbers, the "
                                       "coefficients of 1, M, M^2 ...",
                                       text::shown(node), rig::highest_sensor_degree + 1));
  const std::vector<double> list = numbers(s, "coefficients", node, count);
  const toml::node& units = required_node(s, "units");
  if (!units.is_array() || units.as_array()->size() != count) fail_count(s, "units", units, count);
  for (std::size_t k = 0; k < count; ++k) {
    const toml::node& unit = *units.as_array()->get(k);
    const std::string known = coefficient_unit(static_cast<int>(k));
    if (unit.value<std::string>() != known)
      throw text::InputError(
          fmt::format("{}: units = {}: the unit of coefficient {} must be \"{}\"", s.place(&unit),
                      text::shown(unit), k + 1, known),
          s.at("units", &unit));
  }
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(count));
}

void read_zero(const Section& s, rig::TorqueSensor& sensor) {
  if (const auto value = s.number("zero_V")) sensor.zero = *value;
  if (const auto value = s.number("zero_std_V")) {
    if (!sensor.zero)
      s.fail("zero_std_V", "zero_std_V is the standard deviation of zero_V, but zero_V is missing");
    sensor.zero_std = *value;
  }
}

void require_order(const Section& s, const char* from, double low, const char* to, double high) {
  if (!(low < high))
    s.fail(to, fmt::format("{} = {} {}: must be above {} = {}", to, high, s.key(to).form.unit, from,
                           low));
}

rig::TorqueSensor read_calibration(const Section& table) {
  const Section s = table.with({torque_sensor_keys, sensor_zero_keys});
  rig::TorqueSensor sensor{.coefficients = read_coefficients(s)};
  sensor.covariance = covariance_of(s, static_cast<std::size_t>(sensor.coefficients.size()));
  const auto number = [&](std::string_view key) {
    if (!s.find(key))
      s.fail(key, fmt::format("[{}] {} is missing: {}; raceway calibrate-sensor writes it",
                              s.name(), key, range(s.key(key))));
    return *s.number(key);
  };
  sensor.scatter = number("residual_std_V");
  sensor.lowest_torque = number("torque_from_Nm");
  sensor.highest_torque = number("torque_to_Nm");
  sensor.lowest_signal = number("signal_from_V");
  sensor.highest_signal = number("signal_to_V");
  (void)s.whole_number("readings");
  sensor.source = s.text("source").value_or("");
  require_order(s, "torque_from_Nm", sensor.lowest_torque, "torque_to_Nm", sensor.highest_torque);
  require_order(s, "signal_from_V", sensor.lowest_signal, "signal_to_V", sensor.highest_signal);
  if (const auto turn =
          rig::turning_torque(sensor.coefficients, sensor.lowest_torque, sensor.highest_torque))
    s.fail("coefficients",
           fmt::format("coefficients: the curve has a maximum or minimum at {:.4g} N m, between "
                       "torque_from_Nm and torque_to_Nm, so one signal belongs to two torques",
                       *turn));
  read_zero(s, sensor);
  return sensor;
}

/// A file with [torque_sensor] alone, or another model that has one.
rig::TorqueSensor read_file(const Section& by, const std::string& name, NamedFiles& files) {
  if (name.empty() || name == "-")
    by.fail("file", fmt::format("file = \"{}\": must be the name of a file", name));
  const std::string path = files.shown(name);
  const ModelTables tables(
      [&] {
        try {
          return files.read(name).text;
        } catch (const text::InputError& e) {
          by.fail("file", fmt::format("file = \"{}\": {} (names are relative to the model)", name,
                                      e.what()));
        }
      }(),
      path);
  const Section s = tables.section("torque_sensor");
  if (!s.given())
    throw text::InputError(path +
                               ": the file has no table [torque_sensor]; raceway calibrate-sensor "
                               "CSV -o FILE writes this table",
                           {.file = path, .key = "torque_sensor"});
  if (s.find("file"))
    s.fail("file",
           "file: a model names this file, so this file cannot name another file; write the "
           "calibration in this file");
  rig::TorqueSensor sensor = read_calibration(s);
  sensor.source = path;
  return sensor;
}

}  // namespace

std::vector<KeyTable> torque_sensor_tables() {
  return {{"torque_sensor", torque_sensor_keys}, {"torque_sensor", sensor_zero_keys}};
}

std::optional<rig::TorqueSensor> read_torque_sensor(ModelTables& tables) {
  const Section s = tables.section("torque_sensor");
  if (!s.given()) return std::nullopt;
  const auto file = s.part({sensor_zero_keys}).text("file");
  if (!file) return read_calibration(s);
  const Section zero = s.with({sensor_zero_keys});
  rig::TorqueSensor sensor = read_file(zero, *file, tables.files());
  read_zero(zero, sensor);
  return sensor;
}

}  // namespace raceway::files

#include <Eigen/Core>
#include <filesystem>

#include "io/input_file.h"
#include "io/sensor_file.h"

// Last: see io/toml_text.h.
#include "io/number_lists.h"
#include "io/sensor_section.h"

namespace raceway::io {
namespace {

constexpr Key residual_std{"residual_std_V", "V", 0, 1e6};
constexpr Key torque_from{"torque_from_Nm", "Nm", -1e9, 1e9};
constexpr Key torque_to{"torque_to_Nm", "Nm", -1e9, 1e9};
constexpr Key signal_from{"signal_from_V", "V", -1e6, 1e6};
constexpr Key signal_to{"signal_to_V", "V", -1e6, 1e6};
constexpr Key readings{"readings", "", 1, 1e9};
constexpr Key zero{"zero_V", "V", -1e6, 1e6};
constexpr Key zero_std{"zero_std_V", "V", 0, 1e6};

double required_number(const Section& s, const Key& key) {
  const auto value = s.number(key);
  if (!value)
    s.fail(key.name, fmt::format("[{}] {} is missing: {}; raceway calibrate-sensor writes it",
                                 s.name(), key.name, range(key)));
  return *value;
}

/// The coefficients, each in its unit.
Eigen::VectorXd read_coefficients(const Section& s) {
  const toml::node& node = required_node(s, "coefficients");
  const std::size_t count = node.is_array() ? node.as_array()->size() : 0;
  if (count < 2 || count > std::size_t{rig::highest_sensor_degree + 1})
    s.fail(
        "coefficients",
        fmt::format("coefficients = {}: must be a list of 2 to {} numbers: those of 1, M, M2 ...",
                    shown(node), rig::highest_sensor_degree + 1));
  const std::vector<double> list = numbers(s, "coefficients", node, count);
  const toml::node& units = required_node(s, "units");
  if (!units.is_array() || units.as_array()->size() != count) fail_count(s, "units", units, count);
  for (std::size_t k = 0; k < count; ++k) {
    const toml::node& unit = *units.as_array()->get(k);
    const std::string known = coefficient_unit(static_cast<int>(k));
    if (unit.value<std::string>() != known)
      throw InputError(fmt::format("{}: units = {}: coefficient {} is in \"{}\"", s.place(&unit),
                                   shown(unit), k + 1, known),
                       s.at("units", &unit));
  }
  return Eigen::Map<const Eigen::VectorXd>(list.data(), static_cast<Eigen::Index>(count));
}

void read_zero(const Section& s, rig::TorqueSensor& sensor) {
  if (const auto value = s.number(zero)) sensor.zero = *value;
  if (const auto value = s.number(zero_std)) {
    if (!sensor.zero)
      s.fail(zero_std.name, "zero_std_V without zero_V: it is the standard deviation of that");
    sensor.zero_std = *value;
  }
}

void require_order(const Section& s, const Key& from, double low, const Key& to, double high) {
  if (!(low < high))
    s.fail(to.name, fmt::format("{} = {} {}: must be above {} = {}", to.name, high, to.unit,
                                from.name, low));
}

rig::TorqueSensor read_calibration(const Section& s) {
  s.allow_only({"coefficients", "units", "std", "correlation", "residual_std_V", "torque_from_Nm",
                "torque_to_Nm", "signal_from_V", "signal_to_V", "readings", "source", "zero_V",
                "zero_std_V", "file"});
  rig::TorqueSensor sensor{.coefficients = read_coefficients(s)};
  sensor.covariance = covariance_of(s, static_cast<std::size_t>(sensor.coefficients.size()));
  sensor.scatter = required_number(s, residual_std);
  sensor.lowest_torque = required_number(s, torque_from);
  sensor.highest_torque = required_number(s, torque_to);
  sensor.lowest_signal = required_number(s, signal_from);
  sensor.highest_signal = required_number(s, signal_to);
  (void)s.whole_number(readings);
  sensor.source = s.text("source").value_or("");
  require_order(s, torque_from, sensor.lowest_torque, torque_to, sensor.highest_torque);
  require_order(s, signal_from, sensor.lowest_signal, signal_to, sensor.highest_signal);
  if (const auto turn =
          rig::turning_torque(sensor.coefficients, sensor.lowest_torque, sensor.highest_torque))
    s.fail("coefficients",
           fmt::format("coefficients: the signal turns at {:.4g} N m, within torque_from_Nm and "
                       "torque_to_Nm: one signal belongs to two torques",
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
        } catch (const InputError& e) {
          by.fail("file", fmt::format("file = \"{}\": {} (names are relative to the model)", name,
                                      e.what()));
        }
      }(),
      path);
  const Section s = tables.section("torque_sensor");
  if (!s.given())
    throw InputError(
        path + ": has no table [torque_sensor]; raceway calibrate-sensor CSV -o FILE writes one",
        {.file = path, .key = "torque_sensor"});
  if (s.find("file"))
    s.fail("file", "file: this is the file that a model names, and cannot name another one");
  rig::TorqueSensor sensor = read_calibration(s);
  sensor.source = path;
  return sensor;
}

}  // namespace

std::optional<rig::TorqueSensor> read_torque_sensor(ModelTables& tables) {
  const Section s = tables.section("torque_sensor");
  if (!s.given()) return std::nullopt;
  const auto file = s.text("file");
  if (!file) return read_calibration(s);
  s.allow_only({"file", "zero_V", "zero_std_V"});
  rig::TorqueSensor sensor = read_file(s, *file, tables.files());
  read_zero(s, sensor);
  return sensor;
}

}  // namespace raceway::io

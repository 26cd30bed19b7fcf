#include "session/operating_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/plausible.h"
#include "session/judged.h"
#include "text/error.h"
#include "text/number_range.h"
#include "text/number_text.h"

namespace raceway::session {
namespace {

double or_else(double asked, double of_model) { return std::isnan(asked) ? of_model : asked; }

/// The values of an axis [SI].
std::vector<double> axis_of(std::vector<double> values, double otherwise,
                            const text::NumberRange& range, const std::string& name, double unit,
                            double offset) {
  if (values.empty()) return {otherwise};
  for (std::size_t i = 0; i < values.size(); ++i) {
    text::require_range(values[i], range,
                        name.starts_with("--") ? name : fmt::format("{}[{}]", name, i));
    if (i > 0 && values[i] <= values[i - 1])
      throw text::InputError(
          fmt::format("{}: the values of a table axis must increase, but {} follows {}", name,
                      text::number(values[i]), text::number(values[i - 1])),
          {.key = name});
  }
  for (double& value : values) value = value * unit + offset;
  return values;
}

void tell_of_kelvin(Messages& messages, const std::vector<double>& temperatures_C,
                    const std::string& name) {
  for (const double value : temperatures_C)
    if (const std::string note = files::looks_like_kelvin(name, value); !note.empty())
      return messages.say(record::note::odd_value(note, {.key = name}));
}

const text::NumberRange& axial_range(const model::Model& model) {
  return model.shaft ? text::signed_load_range : text::load_range;
}

}  // namespace

bearing::OperatingPoint point_of(const model::Model& model) {
  return {.axial_load = model.shaft ? model.shaft->external_load : model.rig.axial_load,
          .radial_load = model.shaft ? 0.0 : model.rig.radial_load,
          .temperature = model.rig.temperature};
}

bearing::OperatingPoint point_of(const model::Model& model, const AskedPoint& asked) {
  bearing::OperatingPoint point = point_of(model);
  point.speed = asked.speed_rpm * rpm;
  point.axial_load = or_else(asked.axial_load_N, point.axial_load);
  point.radial_load = or_else(asked.radial_load_N, point.radial_load);
  point.temperature = or_else(kelvin(asked.temperature_C), point.temperature);
  point.moment_y = or_else(asked.moment_y_Nmm * N_mm, 0.0);
  point.moment_z = or_else(asked.moment_z_Nmm * N_mm, 0.0);
  return point;
}

void require_loads(Messages& messages, const files::ModelFile& file, const GivenLoads& given,
                   Wording wording) {
  const model::Model& model = file.model;
  const std::string axial = named(wording, "--axial-load", "axial_load_N");
  if (model.shaft && (given.radial_load || given.moments)) {
    const std::string other =
        given.radial_load ? named(wording, "--radial-load", "radial_load_N")
                          : named(wording, "--moment-y, --moment-z", "moment_y_Nmm, moment_z_Nmm");
    throw text::InputError(
        fmt::format("{}: {} has an [arrangement]; for a shaft, only {} is possible", other,
                    file.source, axial),
        {.file = file.source, .key = other});
  }
  if (!given.axial_load && std::isnan(point_of(model).axial_load))
    throw text::InputError(
        fmt::format("{} is missing, and {} has no axial_load_N under [rig]", axial, file.source),
        {.file = file.source, .key = axial});
  if (model.bearing.rollers() && given.acting_axial_load)
    throw text::InputError(fmt::format("{}: must be 0 for {}, because a cylindrical roller bearing "
                                       "of type N cannot carry an axial load",
                                       axial, file.source),
                           {.file = file.source, .key = axial});
  if (given.moments && model.solver.tilt == bearing::Tilt::locked)
    messages.say(record::note::ignored(
        fmt::format("{}: {} have no effect, because the tilt is locked; with [solver] tilt = "
                    "\"free\", the balls carry the moments",
                    file.source,
                    named(wording, "--moment-y and --moment-z", "moment_y_Nmm and moment_z_Nmm")),
        {.file = file.source}));
}

bearing::OperatingPoint operating_point(Messages& messages, const files::ModelFile& file,
                                        const AskedPoint& asked, Wording wording) {
  const auto given = [](double number) { return !std::isnan(number); };
  const auto acts = [&](double number) { return given(number) && number != 0.0; };
  const auto require = [&](double number, const text::NumberRange& range, const char* flag,
                           const char* argument) {
    if (given(number)) text::require_range(number, range, named(wording, flag, argument));
  };
  require_loads(messages, file,
                {.axial_load = given(asked.axial_load_N),
                 .acting_axial_load = acts(asked.axial_load_N),
                 .radial_load = acts(asked.radial_load_N),
                 .moments = acts(asked.moment_y_Nmm) || acts(asked.moment_z_Nmm)},
                wording);
  require(asked.speed_rpm, text::speed_range, "--speed", "speed_rpm");
  require(asked.axial_load_N, axial_range(file.model), "--axial-load", "axial_load_N");
  require(asked.radial_load_N, text::load_range, "--radial-load", "radial_load_N");
  require(asked.temperature_C, text::temperature_range, "--temperature", "temperature_C");
  require(asked.moment_y_Nmm, text::moment_range, "--moment-y", "moment_y_Nmm");
  require(asked.moment_z_Nmm, text::moment_range, "--moment-z", "moment_z_Nmm");
  const std::string temperature = named(wording, "--temperature", "temperature_C");
  tell_of_kelvin(messages, {asked.temperature_C}, temperature);
  const bearing::OperatingPoint point = point_of(file.model, asked);
  require_possible_speed(file.model, point.speed, named(wording, "--speed", "speed_rpm"));
  require_possible_temperature(
      file.model, point.temperature,
      given(asked.temperature_C) ? temperature : file.source + ": [rig] temperature_C");
  return point;
}

friction::TableAxes table_axes(Messages& messages, const files::ModelFile& file,
                               const AskedAxes& asked, Wording wording) {
  const std::string speed = named(wording, "--speed", "speed_rpm");
  if (asked.speed_rpm.empty()) throw text::InputError(speed + " is missing", {.key = speed});
  require_loads(
      messages, file,
      {.axial_load = !asked.axial_load_N.empty(),
       .acting_axial_load = std::any_of(asked.axial_load_N.begin(), asked.axial_load_N.end(),
                                        [](double load) { return load != 0.0; }),
       .radial_load = !asked.radial_load_N.empty(),
       .moments = false},
      wording);
  const bearing::OperatingPoint otherwise = point_of(file.model);
  const std::string temperature = named(wording, "--temperature", "temperature_C");
  tell_of_kelvin(messages, asked.temperature_C, temperature);
  friction::TableAxes axes{
      .speed = axis_of(asked.speed_rpm, unset, text::speed_range, speed, rpm, 0.0),
      .axial_load = axis_of(asked.axial_load_N, otherwise.axial_load, axial_range(file.model),
                            named(wording, "--axial-load", "axial_load_N"), 1.0, 0.0),
      .radial_load = axis_of(asked.radial_load_N, otherwise.radial_load, text::load_range,
                             named(wording, "--radial-load", "radial_load_N"), 1.0, 0.0),
      .temperature = axis_of(asked.temperature_C, otherwise.temperature, text::temperature_range,
                             temperature, 1.0, celsius_zero)};
  require_possible_speed(file.model, axes.speed.back(), speed);
  require_possible_temperature(
      file.model, axes.temperature.front(),
      asked.temperature_C.empty() ? file.source + ": [rig] temperature_C" : temperature);
  return axes;
}

std::vector<shaft::ShaftPoint> shaft_points(std::span<const bearing::OperatingPoint> points) {
  std::vector<shaft::ShaftPoint> asked;
  for (const bearing::OperatingPoint& p : points)
    asked.push_back(
        {.speed = p.speed, .external_load = p.axial_load, .temperature = p.temperature});
  return asked;
}

}  // namespace raceway::session

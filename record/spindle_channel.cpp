#include "record/spindle_channel.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <string>

#include "record/series_channel.h"

namespace raceway::record {
namespace {

constexpr std::string_view of_sensors = "_temperature_C";

/// A channel with the texts that its views are of.
struct OwnedSensor {
  std::string name, variable, words, place;
  Channel channel;
};

bool is_sensor_name(std::string_view text) {
  const auto ordinary = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !text.empty() && std::all_of(text.begin(), text.end(), ordinary);
}

}  // namespace

const Channel* spindle_channel(std::string_view name) {
  for (const Channel* fixed :
       {&time, &run, &speed, &axial_load, &radial_load, &nose_moment, &belt_force, &motor_heat,
        &motor_power, &axial_displacement, &displacement_deviation})
    if (fixed->name == name) return fixed;
  for (const std::string_view input : {"coolant_on", "ambient_temperature_C",
                                       "machine_temperature_C", "coolant_inlet_temperature_C"})
    if (input == name) return series_channel(name);
  if (!name.ends_with(of_sensors)) return nullptr;
  name.remove_suffix(of_sensors.size());
  return is_sensor_name(name) ? &sensor_channel(name) : nullptr;
}

const Channel& sensor_channel(std::string_view sensor) {
  static std::mutex mutex;
  static std::deque<OwnedSensor> made;  // addresses of its elements stay
  const std::scoped_lock lock(mutex);
  const std::string name = std::string(sensor) + std::string(of_sensors);
  for (const OwnedSensor& one : made)
    if (one.name == name) return one.channel;
  OwnedSensor& one = made.emplace_back();
  one.name = name;
  one.variable = name.substr(0, name.size() - 2);
  one.words = one.variable;
  std::replace(one.words.begin(), one.words.end(), '_', ' ');
  one.place = "C " + one.words;
  one.channel = {.name = one.name,
                 .variable = one.variable,
                 .words = one.words,
                 .unit = "C",
                 .offset = celsius_zero,
                 .lower = -273,
                 .upper = 500,
                 .role = Role::measured,
                 .step = 0.5,
                 .kind = "temperature",
                 .place = one.place};
  return one.channel;
}

}  // namespace raceway::record

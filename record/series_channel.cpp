#include "record/series_channel.h"

#include <array>
#include <cctype>
#include <deque>
#include <mutex>
#include <string>

namespace raceway::record {
namespace {

constexpr std::string_view position_kind = "position", angle_kind = "angle";
constexpr double urad = 1e-6;  // [rad]
static_assert(urad == um, "in_unit_of() changes the unit in a name, but not the value");

/// Columns of one kind: a name between `begin` and `end`, which ends in `unit`.
struct Family {
  std::string_view begin, end, unit;
  Channel like;  ///< all but the names
};

/// What a machine records beside temperatures, speeds and feeds, with its sign.
constexpr Channel recorded(std::string_view unit, double factor, std::string_view kind) {
  return {.name = {},
          .unit = unit,
          .factor = factor,
          .lower = -1e9,
          .upper = 1e9,
          .role = Role::recorded,
          .step = 5e-3,
          .ratio = true,
          .kind = kind};
}

constexpr std::array families{
    Family{"displacement_", "_um", "_um",
           Channel{.name = {},
                   .unit = "um",
                   .factor = um,
                   .lower = -1e6,
                   .upper = 1e6,
                   .role = Role::measured,
                   .direction = "positive towards the tool"}},
    Family{"displacement_", "_urad", "_urad",
           Channel{.name = {},
                   .unit = "urad",
                   .factor = urad,
                   .lower = -1e6,
                   .upper = 1e6,
                   .role = Role::measured,
                   .kind = angle_kind,
                   .direction = "right-handed about its axis"}},
    Family{"offset_", "_urad", "_urad",
           Channel{.name = {},
                   .unit = "urad",
                   .factor = urad,
                   .lower = -1e6,
                   .upper = 1e6,
                   .kind = offset_kind}},
    Family{"offset_", "_um", "_um",
           Channel{.name = {},
                   .unit = "um",
                   .factor = um,
                   .lower = -1e6,
                   .upper = 1e6,
                   .kind = offset_kind}},
    Family{"", "_temperature_C", "_C",
           Channel{.name = {},
                   .unit = "C",
                   .offset = celsius_zero,
                   .lower = -273,
                   .upper = 500,
                   .role = Role::recorded,
                   .step = 0.5,
                   .kind = "temperature"}},
    Family{"", "_feed_m_min", "_m_min",
           Channel{.name = {},
                   .unit = "m/min",
                   .factor = 1.0 / 60.0,
                   .lower = -1e4,
                   .upper = 1e4,
                   .step = 5e-3,
                   .ratio = true,
                   .kind = "feed"}},
    Family{"", "_speed_rpm", "_rpm",
           Channel{.name = {},
                   .unit = "rpm",
                   .factor = rpm,
                   .lower = -1e6,
                   .upper = 1e6,
                   .step = 5e-3,
                   .ratio = true,
                   .kind = "speed"}},
    Family{"", "_position_mm", "_mm", recorded("mm", mm, position_kind)},
    Family{"", "_current_A", "_A", recorded("A", 1.0, "current")},
    Family{"", "_voltage_V", "_V", recorded("V", 1.0, "voltage")},
    Family{"", "_W", "_W", recorded("W", 1.0, "power")},
    Family{"", "_N", "_N", recorded("N", 1.0, "load")},
    Family{"", "_Nm", "_Nm", recorded("N m", 1.0, "torque")},
    Family{"", "_l_min", "_l_min", recorded("l/min", 1.0 / 60000.0, "flow")},
    Family{"", "_bar", "_bar", recorded("bar", 1e5, "pressure")},
    Family{"", "_percent", "_percent", recorded("%", 0.01, "share")}};

constexpr Family transducers{"", "_um", "_um",
                             Channel{.name = {},
                                     .unit = "um",
                                     .factor = um,
                                     .lower = -1e6,
                                     .upper = 1e6,
                                     .role = Role::measured}};

constexpr Channel coolant{.name = "coolant_on",
                          .variable = "coolant",
                          .words = "coolant",
                          .lower = 0,
                          .upper = 1,
                          .step = 0.5};
constexpr Channel setup{
    .name = "setup_id", .variable = "setup", .words = "setup", .role = Role::run, .step = 0.5};

/// A channel with the texts that its views are of.
struct Owned {
  std::string name, variable, words, place;
  Channel channel;
};

std::string in_words(std::string_view variable) {
  std::string words(variable);
  for (char& c : words)
    if (c == '_') c = ' ';
  return words;
}

bool is_name(std::string_view text) {
  for (const char c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') return false;
  return !text.empty() && text.front() != '_';
}

bool has(const Family& family, std::string_view name) {
  return name.size() > family.begin.size() + family.end.size() && name.starts_with(family.begin) &&
         name.ends_with(family.end);
}

/// The channel of that name, made once; null for a name with other characters than a name has.
const Channel* channel_of(const Family& family, std::string_view name) {
  if (!is_name(
          name.substr(family.begin.size(), name.size() - family.begin.size() - family.end.size())))
    return nullptr;
  static std::mutex mutex;
  static std::deque<Owned> made;  // addresses of its elements stay
  const std::scoped_lock lock(mutex);
  for (const Owned& one : made)
    if (one.name == name) return &one.channel;
  Owned& one = made.emplace_back();
  one.name = name;
  one.variable = name.substr(0, name.size() - family.unit.size());
  one.words = in_words(one.variable);
  one.channel = family.like;
  one.place = std::string(family.like.unit) + " " + one.words;
  one.channel.name = one.name;
  one.channel.variable = one.variable;
  one.channel.words = one.words;
  one.channel.place = one.place;
  return &one.channel;
}

}  // namespace

const Channel* series_channel(std::string_view name) {
  for (const Channel* fixed : {&time, &speed, &run, &coolant, &setup})
    if (fixed->name == name) return fixed;
  for (const Family& family : families)
    if (has(family, name)) return channel_of(family, name);
  return nullptr;
}

const Channel* transducer_channel(std::string_view name) {
  return has(transducers, name) && !series_channel(name) ? channel_of(transducers, name) : nullptr;
}

bool is_angle(const Channel& channel) { return channel.kind == angle_kind; }

std::string in_unit_of(const Channel& displacement, std::string_view text) {
  constexpr std::string_view length = "um", angle = "urad";
  std::string result(text);
  if (!is_angle(displacement)) return result;
  const auto is_letter = [&](std::size_t at) {
    return at < result.size() && std::isalnum(static_cast<unsigned char>(result[at]));
  };
  for (std::size_t at = result.find(length); at != result.npos; at = result.find(length, at + 1))
    if (!is_letter(at - 1) && !is_letter(at + length.size()))
      result.replace(at, length.size(), angle);
  return result;
}

Course course_of(const Channel& channel) {
  return is_temperature(channel) ? Course::straight : Course::held;
}

bool is_temperature(const Channel& channel) { return channel.offset != 0.0; }

bool acts_by_amount(const Channel& channel) {
  return channel == speed || channel == coolant || channel.kind == "speed" ||
         channel.kind == "feed";
}

bool is_position(const Channel& channel) { return channel.kind == position_kind; }

bool is_ambient(const Channel& channel) {
  if (!is_temperature(channel)) return false;
  const std::string words = ' ' + in_words(channel.variable) + ' ';
  for (const std::string_view word : {" ambient ", " room ", " air "})
    if (words.find(word) != words.npos) return true;
  return false;
}

}  // namespace raceway::record

#include "record/series_channel.h"

#include <array>
#include <cctype>
#include <deque>
#include <mutex>
#include <string>

namespace raceway::record {
namespace {

/// Columns of one kind: a name between `begin` and `end`.
struct Family {
  std::string_view begin, end;
  Channel like;  ///< all but the names
};

constexpr std::array families{Family{"displacement_", "_um",
                                     Channel{.name = {},
                                             .unit = "um",
                                             .factor = um,
                                             .lower = -1e6,
                                             .upper = 1e6,
                                             .role = Role::measured,
                                             .direction = "positive towards the tool"}},
                              Family{"offset_", "_um",
                                     Channel{.name = {},
                                             .unit = "um",
                                             .factor = um,
                                             .lower = -1e6,
                                             .upper = 1e6,
                                             .kind = offset_kind}},
                              Family{"", "_temperature_C",
                                     Channel{.name = {},
                                             .unit = "C",
                                             .offset = celsius_zero,
                                             .lower = -273,
                                             .upper = 500,
                                             .role = Role::recorded,
                                             .step = 0.5,
                                             .kind = "temperature"}},
                              Family{"", "_feed_m_min",
                                     Channel{.name = {},
                                             .unit = "m/min",
                                             .factor = 1.0 / 60.0,
                                             .lower = -1e4,
                                             .upper = 1e4,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .kind = "feed"}},
                              Family{"", "_speed_rpm",
                                     Channel{.name = {},
                                             .unit = "rpm",
                                             .factor = rpm,
                                             .lower = -1e6,
                                             .upper = 1e6,
                                             .step = 5e-3,
                                             .ratio = true,
                                             .kind = "speed"}}};

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

}  // namespace

const Channel* series_channel(std::string_view name) {
  for (const Channel* fixed : {&time, &speed, &run, &coolant, &setup})
    if (fixed->name == name) return fixed;
  for (const Family& family : families) {
    if (name.size() <= family.begin.size() + family.end.size() || !name.starts_with(family.begin) ||
        !name.ends_with(family.end))
      continue;
    if (!is_name(name.substr(family.begin.size(),
                             name.size() - family.begin.size() - family.end.size())))
      return nullptr;
    static std::mutex mutex;
    static std::deque<Owned> made;  // addresses of its elements stay
    const std::scoped_lock lock(mutex);
    for (const Owned& one : made)
      if (one.name == name) return &one.channel;
    Owned& one = made.emplace_back();
    one.name = name;
    // The unit begins with the second underscore of "_feed_m_min", with the only one of "_um".
    const std::size_t second = family.end.find('_', 1);
    const std::size_t unit =
        second == family.end.npos ? family.end.size() : family.end.size() - second;
    one.variable = name.substr(0, name.size() - unit);
    one.words = in_words(one.variable);
    one.channel = family.like;
    one.place = std::string(family.like.unit) + " of " + one.words;
    one.channel.name = one.name;
    one.channel.variable = one.variable;
    one.channel.words = one.words;
    one.channel.place = one.place;
    return &one.channel;
  }
  return nullptr;
}

Course course_of(const Channel& channel) {
  return is_temperature(channel) ? Course::straight : Course::held;
}

bool is_temperature(const Channel& channel) { return channel.offset != 0.0; }

bool is_ambient(const Channel& channel) {
  if (!is_temperature(channel)) return false;
  const std::string words = ' ' + in_words(channel.variable) + ' ';
  for (const std::string_view word : {" ambient ", " room ", " air "})
    if (words.find(word) != words.npos) return true;
  return false;
}

}  // namespace raceway::record

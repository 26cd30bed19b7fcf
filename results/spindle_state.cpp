#include <fmt/format.h>

#include <cmath>

#include "record/units.h"
#include "results/spindle_results.h"
#include "text/detail/json_text.h"
#include "text/error.h"
#include "text/format_number.h"
#include "text/input_file.h"

namespace raceway::results {

std::string spindle_state_json(const model::Model& model, const spindle::State& state) {
  text::json temperatures = text::json::array();
  for (const double t : state.temperatures) temperatures.push_back(celsius(t));
  return text::text({{"spindle_state", model.spindle->name},
                     {"time_s", state.time},
                     {"structure_time_s", state.structure_time},
                     {"temperatures_C", std::move(temperatures)}});
}

spindle::State read_spindle_state(const std::string& path) {
  return parse_spindle_state(text::read_text(path), path);
}

spindle::State parse_spindle_state(const std::string& text, const std::string& source) {
  const auto fail = [&](const std::string& why) {
    throw text::InputError(fmt::format("{}: {}", source, why), {.file = source});
  };
  const text::json document = text::json::parse(text, nullptr, false);
  if (document.is_discarded()) fail("is not JSON; raceway spindle --end-state writes a state file");
  if (!document.is_object() || !document.contains("spindle_state"))
    fail("is not the state of a spindle; raceway spindle --end-state writes such a file");
  if (const text::json format = document.value("format", text::json(text::format_number));
      format != text::format_number)
    fail(fmt::format("format = {}: {}", format.dump(), text::other_format));
  const auto number = [&](const char* key) {
    if (!document.contains(key) || !document[key].is_number())
      fail(fmt::format("{} is missing or not a number", key));
    return document[key].get<double>();
  };
  spindle::State state{
      .time = number("time_s"), .structure_time = number("structure_time_s"), .temperatures = {}};
  const auto list = document.find("temperatures_C");
  if (list == document.end() || !list->is_array() || list->empty())
    fail("temperatures_C is missing or not a list");
  for (const text::json& one : *list) {
    constexpr double coldest = -273.15, hottest = 2000.0;
    if (!one.is_number() || !(one.get<double>() >= coldest && one.get<double>() <= hottest))
      fail(fmt::format("temperatures_C: entry {} is {}: must be a number from {} to {} C",
                       state.temperatures.size() + 1, one.dump(), coldest, hottest));
    state.temperatures.push_back(kelvin(one.get<double>()));
  }
  return state;
}

}  // namespace raceway::results

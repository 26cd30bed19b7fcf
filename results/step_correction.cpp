#include "results/step_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>

#include "correction/prior.h"
#include "files/correction_file.h"
#include "record/series_channel.h"
#include "text/format_number.h"
#include "text/names.h"
#include "text/number_text.h"
#include "text/output_file.h"

namespace raceway::results {
namespace {

using correction::Characteristic;
using spindle::LagAt;
using AtLoad = spindle::LagAt;
using spindle::one_minute;
using spindle::WhichLag;

constexpr int curve_pieces = 8;  // between two of its points
// Time constant of a part that follows at once: far below the time between two calls [s].
constexpr double short_time = 0.01;
constexpr const char* at_once_suffix = "_at_once";

/// A delay element, and its time constant at P = 0 [s]; NaN: not known.
struct StepElement {
  const char* name;
  WhichLag lag;
  double at_rest;
};

std::vector<StepElement> step_elements(const spindle::CoolDown& down, bool two) {
  if (!two) return {{"spindle", WhichLag::one, down.one}};
  return {{"fast", WhichLag::fast, down.fast}, {"slow", WhichLag::slow, down.slow}};
}

std::shared_ptr<const correction::FrictionTable> step_friction(
    const std::vector<PowerAtSpeed>& powers) {
  correction::FrictionTable table{.temperature = {0.0}};
  for (const PowerAtSpeed& p : powers) {
    table.speed.push_back(p.speed);
    table.torque.push_back(p.power / p.speed);
  }
  return std::make_shared<const correction::FrictionTable>(std::move(table));
}

/// Monotone cubics in straight pieces.
correction::DelayElement curves(const std::vector<LagAt>& points, double at_rest) {
  const spindle::MonotoneCurve gain = spindle::gain_curve(points);
  const spindle::MonotoneCurve time = spindle::time_curve(points, at_rest);
  Characteristic::Table gains, times;
  const auto add = [&](double x) {
    gains.input.push_back(x);
    gains.value.push_back(gain(x));
    times.value.push_back(time(x));
  };
  const std::vector<double>& at = gain.x();
  for (std::size_t k = 0; k + 1 < at.size(); ++k)
    for (int piece = 0; piece < curve_pieces; ++piece)
      add(at[k] + (at[k + 1] - at[k]) * piece / curve_pieces);
  add(at.back());
  times.input = gains.input;
  return {gains, times, gains.input.front() < 0.0};
}

correction::DelayElement step_element(const std::vector<LagAt>& points, double at_rest,
                                      StepLaw form) {
  if (form == StepLaw::curve) return curves(points, at_rest);
  const spindle::PowerLaws laws = spindle::fit_load_laws(points);
  if (form == StepLaw::power) {
    if (std::isnan(laws.gain_power.exponent))
      throw std::invalid_argument(
          "a power law needs gains of the same sign at two powers or loads above 0; use the law "
          "\"curve\"");
    return {Characteristic::Power{laws.gain_power.factor, laws.gain_power.exponent},
            Characteristic::Power{laws.time_power.factor, laws.time_power.exponent}};
  }
  if (std::isnan(laws.gain_line.slope))
    throw std::invalid_argument("a line needs two powers or loads; use the law \"curve\"");
  return {Characteristic::Line{laws.gain_line.slope, laws.gain_line.offset},
          Characteristic::Line{laws.time_line.slope, laws.time_line.offset}};
}

/// A curve is known from 0 W on; a power law is not, as its time constant ends nowhere there.
correction::SeenRange seen_powers(const std::vector<LagAt>& points, StepLaw law,
                                  const std::string& name) {
  const auto less = [](const LagAt& a, const LagAt& b) { return a.input < b.input; };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
  return {.name = name, .lower = law == StepLaw::power ? low->input : 0.0, .upper = high->input};
}

std::string step_table_path(const std::string& path, std::string_view name) {
  const std::filesystem::path model(path);
  return (model.parent_path() / fmt::format("{}_{}.csv", model.stem().string(), name)).string();
}

std::string quoted_name(const std::string& path) {
  return text::in_quotes(std::filesystem::path(path).filename().string());
}

std::string step_number(double value) { return text::toml_float(text::with_15_digits(value)); }

std::string step_friction_text(const correction::FrictionTable& table) {
  std::string text =
      "# Friction torque of all bearings together\n"
      "speed_rpm,friction_torque_Nmm\n";
  for (std::size_t k = 0; k < table.speed.size(); ++k)
    text += fmt::format("{:.12g},{:.12g}\n", table.speed[k] / rpm, table.torque[k] / N_mm);
  return text;
}

std::string step_curve_text(const std::string& input, const Characteristic::Table& gain,
                            const Characteristic::Table& time) {
  std::string text = fmt::format(
      "# Gain and time constant over the {}: monotone cubic curves through the step responses,\n# "
      "approximated by straight pieces\n{},gain_um,time_constant_min\n",
      input == "power_W" ? "power" : "load", input);
  for (std::size_t k = 0; k < gain.input.size(); ++k)
    text += fmt::format("{:.12g},{:.12g},{:.12g}\n", gain.input[k], gain.value[k] / um,
                        time.value[k] / one_minute);
  return text;
}

std::string step_law_text(const Characteristic& law, const char* unit_key, double unit,
                          std::string_view of_input) {
  if (const auto* const line = std::get_if<Characteristic::Line>(&law.form()))
    return fmt::format("{{ slope_{0}_{3} = {1}, offset_{0} = {2} }}", unit_key,
                       step_number(line->slope / unit), step_number(line->offset / unit), of_input);
  const auto& power = std::get<Characteristic::Power>(law.form());
  return fmt::format("{{ factor = {}, exponent = {} }}", step_number(power.factor / unit),
                     step_number(power.exponent));
}

const record::Channel* column_of(spindle::Stepped stepped) {
  return stepped == spindle::Stepped::radial_load ? &record::radial_load : &record::axial_load;
}

/// Displacements of a load that come at once, over the load.
std::vector<AtLoad> at_once_of(const spindle::LoadSteps& loads) {
  std::vector<AtLoad> points;
  for (const spindle::StepResponse& step : loads.steps)
    if (step.converged()) points.push_back({step.load, step.kinematic, short_time});
  return points;
}

/// A channel of a load in a window of the speed.
correction::DrivenChannel channel_of_load(std::string name, spindle::Stepped stepped,
                                          const std::array<double, 4>& speeds, bool of_input) {
  const record::Channel* const column = column_of(stepped);
  correction::DrivenChannel channel{.name = std::move(name)};
  channel.input.name = column->name;
  channel.input.columns = {column};
  channel.input.window =
      correction::Window{.column = &record::speed, .points = speeds, .of_input = of_input};
  return channel;
}

/// Adds two channels for each speed of a load. One is the displacement that comes at once; at rest
/// it is that at the lowest speed. The other is the delay element of the heat, zero at rest.
void add_load_channels(const std::vector<spindle::LoadSteps>& loads, spindle::Stepped stepped,
                       StepLaw law, correction::Model& model) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  std::vector<const spindle::LoadSteps*> at;
  for (const spindle::LoadSteps& one : loads)
    if (one.stepped == stepped && !at_loads(one).empty()) at.push_back(&one);
  if (at.empty()) return;
  std::sort(at.begin(), at.end(), [](const auto* a, const auto* b) { return a->speed < b->speed; });
  correction::SeenRange seen{.column = column_of(stepped),
                             .name = std::string(column_of(stepped)->name),
                             .lower = 0.0,
                             .upper = 0.0};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double speed = at[k]->speed;
    std::array<double, 4> window{k > 0 ? at[k - 1]->speed : 0.0, speed, nowhere, nowhere};
    if (k + 1 < at.size()) window[2] = speed, window[3] = at[k + 1]->speed;
    const std::string name = load_channel(stepped, speed);
    correction::DrivenChannel heats = channel_of_load(name, stepped, window, true);
    heats.element = step_element(at_loads(*at[k]), at[k]->unloaded, law);
    heats.element->both_signs = true;
    if (k == 0) window[0] = window[1] = -nowhere;
    correction::DrivenChannel bends =
        channel_of_load(name + at_once_suffix, stepped, window, false);
    const std::vector<AtLoad> points = at_once_of(*at[k]);
    double squares = 0.0, products = 0.0;
    for (const AtLoad& p : points) {
      squares += p.input * p.input;
      products += p.input * p.gain;
      seen.lower = std::min(seen.lower, p.input);
      seen.upper = std::max(seen.upper, p.input);
    }
    if (law == StepLaw::curve)
      bends.element = curves(points, short_time);
    else
      bends.feedthrough = products / squares;
    if (bends.element) bends.element->both_signs = true;
    model.channels.push_back(std::move(bends));
    model.channels.push_back(std::move(heats));
  }
  model.range.push_back(seen);
}

}  // namespace

std::string load_channel(spindle::Stepped stepped, double speed) {
  std::string name = fmt::format("{}_{:.6g}rpm", column_of(stepped)->variable, speed / rpm);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

correction::Model step_model(const spindle::StepResponses& responses,
                             const StepCorrectionParts& parts) {
  if (parts.power.empty())
    throw std::invalid_argument(
        "a correction needs the power at a speed above 0 rpm: give the load cases both columns, "
        "speed_rpm and power_W, or name a MODEL");
  correction::Model model;
  model.name = parts.name;
  model.displacement = record::series_channel("displacement_z_um");
  model.range.push_back({.column = &record::speed,
                         .name = std::string(record::speed.name),
                         .lower = 0.0,
                         .upper = parts.power.back().speed});
  const auto friction = step_friction(parts.power);
  for (const StepElement& element : step_elements(responses.cool_down, parts.two_lags)) {
    const std::vector<LagAt> points = at_powers(responses.steps, element.lag);
    if (points.empty())
      throw std::invalid_argument(parts.two_lags ? "no step response has two time constants"
                                                 : "no step response converged");
    correction::DrivenChannel channel{.name = element.name};
    channel.input.name = "power_W";
    channel.input.table = friction;
    channel.input.axial_load = channel.input.radial_load = channel.input.temperature = {0.0};
    channel.element = step_element(points, element.at_rest, parts.law);
    model.channels.push_back(std::move(channel));
    model.range.push_back(seen_powers(points, parts.law, element.name));
  }
  for (const auto stepped : {spindle::Stepped::axial_load, spindle::Stepped::radial_load})
    add_load_channels(responses.loads, stepped, parts.law, model);
  if (parts.kinematic)
    model.kinematic =
        correction::Kinematic{parts.kinematic->A, parts.kinematic->B, parts.kinematic->C};
  model.priors = correction::computed_priors(model);
  return model;
}

std::vector<std::string> step_correction_tables(const std::string& path,
                                                const std::vector<std::string>& load_channels) {
  std::vector<std::string> paths;
  for (const char* name : {"friction", "spindle", "fast", "slow"})
    paths.push_back(step_table_path(path, name));
  for (const std::string& name : load_channels)
    for (const std::string& of : {name, name + at_once_suffix})
      paths.push_back(step_table_path(path, of));
  return paths;
}

StepCorrection step_correction(const correction::Model& model, const std::string& path) {
  StepCorrection result;
  const std::string friction = step_table_path(path, "friction");
  result.tables.emplace_back(friction, step_friction_text(*model.channels.front().input.table));
  result.model = fmt::format(
      "# Delay elements from step responses: gain and time constant depend on the friction power "
      "of\n# all bearings at the speed.\n{}{}[correction]\nname = {}\ndisplacement = \"{}\"\n",
      model.channels.back().input.is_power() ? ""
                                             : "# Loads at the nose: immediate displacement, and "
                                               "displacement by the heat of the load.\n",
      text::format_line, text::in_quotes(model.name), model.displacement->name);
  for (const correction::DrivenChannel& channel : model.channels) {
    const correction::Input& input = channel.input;
    result.model += fmt::format("\n[[correction.channel]]\nname = \"{}\"\ninput = \"{}\"\n",
                                channel.name, input.name);
    if (input.is_power())
      result.model += fmt::format("friction_table = {}\n", quoted_name(friction));
    if (input.window) result.model += files::window_text(*input.window);
    if (!channel.element) {
      result.model += fmt::format("feedthrough_um_{} = {}\n", input.key_unit(),
                                  step_number(channel.feedthrough / um));
      continue;
    }
    const correction::DelayElement& element = *channel.element;
    std::string gain, time;
    if (const auto* const curve = std::get_if<Characteristic::Table>(&element.gain.form())) {
      const std::string table = step_table_path(path, channel.name);
      const auto& times = std::get<Characteristic::Table>(element.time_constant.form());
      result.tables.emplace_back(table, step_curve_text(input.name, *curve, times));
      gain = time = fmt::format("{{ table = {} }}", quoted_name(table));
    } else {
      gain = step_law_text(element.gain, "um", um, input.key_unit());
      time = step_law_text(element.time_constant, "min", one_minute, input.key_unit());
    }
    result.model += fmt::format("gain = {}\ntime_constant = {}\n", gain, time);
  }
  if (const auto& law = model.kinematic)
    result.model += fmt::format("\n[correction.kinematic]\nA = {}\nB = {}\nC = {}\n",
                                step_number(law->A), step_number(law->B), step_number(law->C));
  if (const std::string priors = files::prior_text(model); !priors.empty())
    result.model += "\n" + priors;
  result.model += "\n[correction.range]\n";
  for (const correction::SeenRange& range : model.range)
    result.model += range.column ? fmt::format("{} = [{}, {}]\n", range.name,
                                               step_number(range.column->in_unit(range.lower)),
                                               step_number(range.column->in_unit(range.upper)))
                                 : fmt::format("\"{} power_W\" = [{}, {}]\n", range.name,
                                               step_number(range.lower), step_number(range.upper));
  return result;
}

void write_step_correction(const StepCorrection& correction, const std::string& path,
                           bool replace) {
  std::vector<text::OutputFile> files;
  for (const auto& [table, text] : correction.tables) files.push_back({table, text});
  files.push_back({path, correction.model});
  text::write_files(files, replace ? text::IfExists::replace : text::IfExists::refuse);
}

}  // namespace raceway::results

#include "results/step_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
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
using spindle::AtPower;
using spindle::one_minute;
using spindle::WhichLag;

constexpr int curve_pieces = 8;  // between two of its points

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
  correction::FrictionTable table{.axial_load = {0.0}, .temperature = {0.0}};
  for (const PowerAtSpeed& p : powers) {
    table.speed.push_back(p.speed);
    table.torque.push_back(p.power / p.speed);
  }
  return std::make_shared<const correction::FrictionTable>(std::move(table));
}

/// Monotone cubics in straight pieces.
correction::DelayElement curves(const std::vector<AtPower>& points, double at_rest) {
  const spindle::MonotoneCurve gain = spindle::gain_curve(points);
  const spindle::MonotoneCurve time = spindle::time_curve(points, at_rest);
  Characteristic::Table gains, times;
  const auto add = [&](double P) {
    gains.power.push_back(P);
    gains.value.push_back(gain(P));
    times.value.push_back(time(P));
  };
  const std::vector<double>& at = gain.x();
  for (std::size_t k = 0; k + 1 < at.size(); ++k)
    for (int piece = 0; piece < curve_pieces; ++piece)
      add(at[k] + (at[k + 1] - at[k]) * piece / curve_pieces);
  add(at.back());
  times.power = gains.power;
  return {gains, times};
}

correction::DelayElement step_element(const std::vector<AtPower>& points, double at_rest,
                                      StepLaw form) {
  if (form == StepLaw::curve) return curves(points, at_rest);
  const spindle::PowerLaws laws = spindle::fit_power_laws(points);
  if (form == StepLaw::power) {
    if (std::isnan(laws.gain_power.exponent))
      throw std::invalid_argument(
          "a power law needs gains of one sign at two powers above 0 W; take the curve");
    return {Characteristic::Power{laws.gain_power.factor, laws.gain_power.exponent},
            Characteristic::Power{laws.time_power.factor, laws.time_power.exponent}};
  }
  if (std::isnan(laws.gain_line.slope))
    throw std::invalid_argument("a line needs two powers; take the curve");
  return {Characteristic::Line{laws.gain_line.slope, laws.gain_line.offset},
          Characteristic::Line{laws.time_line.slope, laws.time_line.offset}};
}

/// A curve is known from 0 W on; a power law is not, as its time constant ends nowhere there.
correction::SeenRange seen_powers(const std::vector<AtPower>& points, StepLaw law,
                                  const std::string& name) {
  const auto less = [](const AtPower& a, const AtPower& b) { return a.power < b.power; };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
  return {.name = name, .lower = law == StepLaw::power ? low->power : 0.0, .upper = high->power};
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

std::string step_curve_text(const Characteristic::Table& gain, const Characteristic::Table& time) {
  std::string text =
      "# Gain and time constant over the power: monotone cubics through the step responses, in\n"
      "# straight pieces\npower_W,gain_um,time_constant_min\n";
  for (std::size_t k = 0; k < gain.power.size(); ++k)
    text += fmt::format("{:.12g},{:.12g},{:.12g}\n", gain.power[k], gain.value[k] / um,
                        time.value[k] / one_minute);
  return text;
}

std::string step_law_text(const Characteristic& law, const char* unit_key, double unit) {
  if (const auto* const line = std::get_if<Characteristic::Line>(&law.form()))
    return fmt::format("{{ slope_{0}_W = {1}, offset_{0} = {2} }}", unit_key,
                       step_number(line->slope / unit), step_number(line->offset / unit));
  const auto& power = std::get<Characteristic::Power>(law.form());
  return fmt::format("{{ factor = {}, exponent = {} }}", step_number(power.factor / unit),
                     step_number(power.exponent));
}

}  // namespace

correction::Model step_model(const spindle::StepResponses& responses,
                             const StepCorrectionParts& parts) {
  if (parts.power.empty())
    throw std::invalid_argument(
        "a correction needs the power at a speed above 0 rpm: give load cases both columns, "
        "speed_rpm and power_W, or name the MODEL");
  correction::Model model;
  model.name = parts.name;
  model.displacement = record::series_channel("displacement_z_um");
  model.range.push_back({.column = &record::speed,
                         .name = std::string(record::speed.name),
                         .lower = 0.0,
                         .upper = parts.power.back().speed});
  const auto friction = step_friction(parts.power);
  for (const StepElement& element : step_elements(responses.cool_down, parts.two_lags)) {
    const std::vector<AtPower> points = at_powers(responses.steps, element.lag);
    if (points.empty())
      throw std::invalid_argument(parts.two_lags ? "no step response has two time constants"
                                                 : "there is no step response that converged");
    correction::DrivenChannel channel{.name = element.name};
    channel.input.name = "power_W";
    channel.input.table = friction;
    channel.input.axial_load = channel.input.temperature = 0.0;
    channel.element = step_element(points, element.at_rest, parts.law);
    model.channels.push_back(std::move(channel));
    model.range.push_back(seen_powers(points, parts.law, element.name));
  }
  if (parts.kinematic)
    model.kinematic =
        correction::Kinematic{parts.kinematic->A, parts.kinematic->B, parts.kinematic->C};
  model.priors = correction::computed_priors(model);
  return model;
}

std::vector<std::string> step_correction_tables(const std::string& path) {
  std::vector<std::string> paths;
  for (const char* name : {"friction", "spindle", "fast", "slow"})
    paths.push_back(step_table_path(path, name));
  return paths;
}

StepCorrection step_correction(const correction::Model& model, const std::string& path) {
  StepCorrection result;
  const std::string friction = step_table_path(path, "friction");
  result.tables.emplace_back(friction, step_friction_text(*model.channels.front().input.table));
  result.model = fmt::format(
      "# Delay elements by step responses: gain and time constant go with the friction power at "
      "the\n# speed; all bearings together.\n{}[correction]\nname = {}\ndisplacement = \"{}\"\n",
      text::format_line, text::in_quotes(model.name), model.displacement->name);
  for (const correction::DrivenChannel& channel : model.channels) {
    result.model += fmt::format(
        "\n[[correction.channel]]\nname = \"{}\"\ninput = \"power_W\"\nfriction_table = {}\n",
        channel.name, quoted_name(friction));
    const correction::DelayElement& element = *channel.element;
    std::string gain, time;
    if (const auto* const curve = std::get_if<Characteristic::Table>(&element.gain.form())) {
      const std::string table = step_table_path(path, channel.name);
      const auto& times = std::get<Characteristic::Table>(element.time_constant.form());
      result.tables.emplace_back(table, step_curve_text(*curve, times));
      gain = time = fmt::format("{{ table = {} }}", quoted_name(table));
    } else {
      gain = step_law_text(element.gain, "um", um);
      time = step_law_text(element.time_constant, "min", one_minute);
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

#include "io/step_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "io/names.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace raceway::io {
namespace {

using spindle::AtPower;
using spindle::WhichLag;

constexpr int curve_pieces = 8;  // of a curve between two of its points

/// A delay element of the model.
struct StepElement {
  const char* name;
  WhichLag lag;
  double at_rest;  ///< time constant at P = 0 [s]; NaN: not known
};

std::string step_table_path(const std::string& path, std::string_view name) {
  const std::filesystem::path model(path);
  return (model.parent_path() / fmt::format("{}_{}.csv", model.stem().string(), name)).string();
}

std::string file_name_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

std::string step_friction_text(const std::vector<PowerAtSpeed>& powers) {
  std::string text =
      "# Friction torque of all bearings at the end of a step to each speed\n"
      "speed_rpm,friction_torque_Nmm\n";
  for (const PowerAtSpeed& p : powers)
    text +=
        fmt::format("{:.12g},{:.12g}\n", with_15_digits(p.speed / rpm), p.power / p.speed / N_mm);
  return text;
}

std::string step_curve_text(const std::vector<AtPower>& points, double at_rest) {
  const spindle::MonotoneCurve gain = spindle::gain_curve(points);
  const spindle::MonotoneCurve time = spindle::time_curve(points, at_rest);
  std::string text =
      "# Gain and time constant over the power: monotone cubics through the step responses, in\n"
      "# straight curve_pieces\npower_W,gain_um,time_constant_min\n";
  const auto add = [&](double P) {
    text +=
        fmt::format("{:.12g},{:.12g},{:.12g}\n", P, gain(P) / um, time(P) / spindle::one_minute);
  };
  const std::vector<double>& at = gain.x();
  for (std::size_t k = 0; k + 1 < at.size(); ++k)
    for (int piece = 0; piece < curve_pieces; ++piece)
      add(at[k] + (at[k + 1] - at[k]) * piece / curve_pieces);
  add(at.back());
  return text;
}

std::string step_number(double value) { return toml_float(with_15_digits(value)); }

std::string step_law_text(const std::vector<AtPower>& points, StepLaw form) {
  const spindle::PowerLaws laws = spindle::fit_power_laws(points);
  if (form == StepLaw::power) {
    if (std::isnan(laws.gain_power.exponent))
      throw std::invalid_argument(
          "a power law needs gains of one sign at two powers above 0 W; take the curve");
    return fmt::format(
        "gain = {{ factor = {}, exponent = {} }}\ntime_constant = {{ factor = {}, exponent = {} "
        "}}\n",
        step_number(laws.gain_power.factor / um), step_number(laws.gain_power.exponent),
        step_number(laws.time_power.factor / spindle::one_minute),
        step_number(laws.time_power.exponent));
  }
  if (std::isnan(laws.gain_line.slope))
    throw std::invalid_argument("a line needs two powers; take the curve");
  return fmt::format(
      "gain = {{ slope_um_W = {}, offset_um = {} }}\ntime_constant = {{ slope_min_W = {}, "
      "offset_min = {} }}\n",
      step_number(laws.gain_line.slope / um), step_number(laws.gain_line.offset / um),
      step_number(laws.time_line.slope / spindle::one_minute),
      step_number(laws.time_line.offset / spindle::one_minute));
}

std::vector<StepElement> step_elements(const spindle::StepResponses& responses) {
  const spindle::CoolDown& down = responses.cool_down;
  if (!spindle::need_two(responses.steps)) return {{"spindle", WhichLag::one, down.one}};
  return {{"fast", WhichLag::fast, down.fast}, {"slow", WhichLag::slow, down.slow}};
}

/// Powers that were seen. A curve is known from 0 on; a power law is not, as its time constant ends
/// nowhere there.
std::pair<double, double> seen_powers(const std::vector<AtPower>& points, StepLaw law) {
  const auto less = [](const AtPower& a, const AtPower& b) { return a.power < b.power; };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
  return {law == StepLaw::power ? low->power : 0.0, high->power};
}

std::string step_kinematic_text(const shaft::KinematicLaw& law) {
  return fmt::format("\n[correction.kinematic]\nA = {}\nB = {}\nC = {}\n", step_number(law.A),
                     step_number(law.B), step_number(law.C));
}

}  // namespace

std::vector<std::string> step_correction_tables(const std::string& path) {
  std::vector<std::string> paths;
  for (const char* name : {"friction", "spindle", "fast", "slow"})
    paths.push_back(step_table_path(path, name));
  return paths;
}

StepCorrection step_correction(const spindle::StepResponses& responses,
                               const StepCorrectionParts& parts, const std::string& path) {
  if (parts.power.empty())
    throw std::invalid_argument(
        "a correction needs the power at a speed above 0 rpm: give load cases both columns, "
        "speed_rpm and power_W, or name the MODEL");
  StepCorrection result;
  const std::string friction = step_table_path(path, "friction");
  result.tables.emplace_back(friction, step_friction_text(parts.power));
  result.model = fmt::format(
      "# Delay elements by step responses: gain and time constant go with the friction power at "
      "the\n# speed; all bearings together.\n[correction]\nname = {}\ndisplacement = "
      "\"displacement_z_um\"\n",
      in_quotes(parts.name));
  std::string ranges = fmt::format("\n[correction.range]\nspeed_rpm = [0.0, {}]\n",
                                   step_number(parts.power.back().speed / rpm));
  for (const StepElement& element : step_elements(responses)) {
    const std::vector<AtPower> points = at_powers(responses.steps, element.lag);
    if (points.empty()) throw std::invalid_argument("there is no step response that converged");
    result.model += fmt::format(
        "\n[[correction.channel]]\nname = \"{}\"\ninput = \"power_W\"\nfriction_table = {}\n",
        element.name, in_quotes(file_name_of(friction)));
    if (parts.law == StepLaw::curve) {
      const std::string table = step_table_path(path, element.name);
      result.tables.emplace_back(table, step_curve_text(points, element.at_rest));
      const std::string file = in_quotes(file_name_of(table));
      result.model +=
          fmt::format("gain = {{ table = {0} }}\ntime_constant = {{ table = {0} }}\n", file);
    } else {
      result.model += step_law_text(points, parts.law);
    }
    const auto [low, high] = seen_powers(points, parts.law);
    ranges += fmt::format("\"{} power_W\" = [{}, {}]\n", element.name, step_number(low),
                          step_number(high));
  }
  if (parts.kinematic) result.model += step_kinematic_text(*parts.kinematic);
  result.model += ranges;
  return result;
}

void write_step_correction(const StepCorrection& correction, const std::string& path,
                           bool replace) {
  const auto if_exists = replace ? IfExists::replace : IfExists::refuse;
  for (const auto& [table, text] : correction.tables) write_text(table, text, if_exists);
  write_text(path, correction.model, if_exists);
}

}  // namespace raceway::io

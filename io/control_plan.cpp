#include "io/control_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "correction/catalogue.h"
#include "correction/numbers.h"
#include "correction/range.h"
#include "correction/simulation.h"
#include "io/error.h"
#include "io/number_text.h"
#include "record/series_channel.h"

namespace raceway::io {
namespace {

using correction::DrivenChannel;
using correction::Effect;
using correction::Input;
using correction::Model;
using record::Channel;

/// Values of a change of unit lose their last digits, gains carry all that they have.
double shown(double value) { return with_15_digits(value); }

class Planner {
 public:
  Planner(const std::vector<Model>& models, const std::string& source) : models_(models) {
    plan_.source = source;
  }

  ControlPlan plan() {
    for (const Model& m : models_)
      for (const Channel* c : correction::inputs_of(m)) (void)input(*c);
    plan_.speed = number_of("speed_rpm");
    plan_.coolant = number_of("coolant_on");
    for (const Model& m : models_) {
      add(m);
      if (m.together) add(*m.together);
    }
    note_unknown_ranges();
    return std::move(plan_);
  }

 private:
  void note(std::string text) {
    if (std::find(plan_.notes.begin(), plan_.notes.end(), text) == plan_.notes.end())
      plan_.notes.push_back(std::move(text));
  }

  std::string identifier(std::string_view column) {
    std::string name(column);
    std::replace(name.begin(), name.end(), '-', '_');
    if (name.front() >= '0' && name.front() <= '9') name.insert(0, "x");
    while (std::find(identifiers_.begin(), identifiers_.end(), name) != identifiers_.end())
      name.insert(0, "x");
    identifiers_.push_back(name);
    return name;
  }

  std::size_t number_of(std::string_view column) const {
    for (std::size_t k = 0; k < plan_.inputs.size(); ++k)
      if (plan_.inputs[k].column == column) return k;
    return nowhere;
  }

  std::size_t input(const Channel& c) {
    const std::size_t known = number_of(c.name);
    if (known != nowhere) return known;
    ControlInput in{.column = std::string(c.name),
                    .identifier = identifier(c.name),
                    .unit = std::string(c.unit.empty() ? "0 or 1" : c.unit),
                    .temperature = record::is_temperature(c)};
    // Of several models the narrower range: beyond it one of them is out of what it has seen.
    for (const Model& m : models_)
      for (const correction::SeenRange& r : m.range)
        if (r.column && *r.column == c) {
          double low = shown(value_in_unit(c, r.lower)), high = shown(value_in_unit(c, r.upper));
          // All but temperatures act by their size, and a spindle may turn the other way.
          if (!in.temperature && low < 0.0) {
            high = std::max(-low, high);
            low = 0.0;
          }
          in.lowest = std::isnan(in.lowest) ? low : std::max(in.lowest, low);
          in.highest = std::isnan(in.highest) ? high : std::min(in.highest, high);
        }
    plan_.inputs.push_back(std::move(in));
    return plan_.inputs.size() - 1;
  }

  void add(const correction::SeenTogether& seen) {
    ControlTogether made{.farthest = seen.farthest};
    const Eigen::MatrixXd weights = correction::Distance(seen).weights();
    for (Eigen::Index k = 0; k < weights.rows(); ++k) {
      const Channel& c = *seen.columns[static_cast<std::size_t>(k)];
      made.inputs.push_back(input(c));
      made.mean.push_back(shown(value_in_unit(c, seen.mean[k])));
      for (Eigen::Index j = 0; j <= k; ++j) {
        const Channel& of = *seen.columns[static_cast<std::size_t>(j)];
        made.weights.push_back(shown(weights(k, j) / seen.std[j] * of.factor));
      }
    }
    plan_.together.push_back(std::move(made));
  }

  void note_unknown_ranges() {
    std::string unknown;
    for (const ControlInput& in : plan_.inputs)
      if (std::isnan(in.lowest) && in.column != "coolant_on")
        unknown += (unknown.empty() ? "" : ", ") + in.column;
    if (!unknown.empty())
      note(
          fmt::format("[correction.range] has no {}: nothing will say when the machine goes "
                      "beyond what the model was found in",
                      unknown));
  }

  /// The torque at the load of the channel: between loads it is straight, so that nothing is lost.
  std::size_t table(const Input& in, const std::string& channel) {
    const correction::FrictionTable& t = *in.table;
    ControlTable made{.file = t.file, .axial_load_N = in.axial_load};
    for (const double n : t.speed) made.speed_rpm.push_back(shown(n / rpm));
    std::vector<double> temperatures = t.temperature;
    if (!in.temperature_column) temperatures = {in.temperature};
    for (const double T : temperatures) made.temperature_C.push_back(with_digits(celsius(T), 12));
    for (const double T : temperatures)
      for (const double n : t.speed) made.torque_Nmm.push_back(t(n, in.axial_load, T) / N_mm);
    if (!t.holds(t.speed.front(), in.axial_load,
                 in.temperature_column ? t.temperature.front() : in.temperature))
      note(fmt::format("channel {}: its load or temperature lies beyond {}; the edge holds",
                       channel, t.file));
    plan_.tables.push_back(std::move(made));
    return plan_.tables.size() - 1;
  }

  std::size_t drive(const Input& in, const Model& m, const std::string& channel) {
    ControlDrive d{.unit = std::string(in.unit())};
    if (in.is_power()) {
      d.kind = ControlDrive::Kind::power;
      d.table = table(in, channel);
      if (in.temperature_column)
        d.temperature = input(*in.temperature_column);
      else
        d.temperature_C = with_digits(celsius(in.temperature), 12);
      for (const correction::SeenRange& r : m.range)
        if (!r.column && r.name == channel) {
          d.lowest = r.lower;
          d.highest = r.upper;
        }
    } else {
      d.kind = in.course() == record::Course::straight ? ControlDrive::Kind::rise
                                                       : ControlDrive::Kind::size;
      d.exponent = in.exponent;
      for (const Channel* c : in.columns) d.inputs.push_back(input(*c));
      if (in.reference) d.reference = input(*in.reference);
    }
    plan_.drives.push_back(std::move(d));
    return plan_.drives.size() - 1;
  }

  static bool is_straight(const Input& in) { return in.course() == record::Course::straight; }

  static ControlCurve curve(const correction::Characteristic& of, double unit) {
    using Form = correction::Characteristic;
    ControlCurve c;
    if (const auto* const line = std::get_if<Form::Line>(&of.form())) {
      c.factor = shown(line->slope / unit);
      c.other = shown(line->offset / unit);
    } else if (const auto* const power = std::get_if<Form::Power>(&of.form())) {
      c.kind = ControlCurve::Kind::power_law;
      c.factor = shown(power->factor / unit);
      c.other = power->exponent;
    } else {
      const auto& t = std::get<Form::Table>(of.form());
      c.kind = ControlCurve::Kind::table;
      c.power_W = t.power;
      for (const double v : t.value) c.value.push_back(shown(v / unit));
    }
    return c;
  }

  void add_printed(const DrivenChannel& c, std::size_t drive, double to_um, ControlAxis& axis) {
    try {
      const correction::ParallelForm form = correction::parallel_form(*c.printed);
      for (const auto& lag : form.lags)
        axis.sections.push_back(
            {.channel = c.name,
             .drive = drive,
             .gain = shown(lag.gain * to_um),
             .time_constant_s = shown(-c.printed->sampling / std::log1p(-lag.rise))});
      if (form.through != 0.0)
        axis.feedthroughs.push_back({c.name, drive, shown(form.through * to_um)});
      note(fmt::format(
          "channel {}: its polynomials became {} section{} and a feedthrough; called every {:g} s "
          "they give the same, and at another rate what the same bodies give",
          c.name, form.lags.size(), form.lags.size() == 1 ? "" : "s", c.printed->sampling));
    } catch (const std::invalid_argument& e) {
      throw InputError(fmt::format("{}: channel {}: its polynomials cannot run beside sections: {}",
                                   plan_.source, c.name, e.what()),
                       {.file = plan_.source, .key = "denominator"});
    }
  }

  void add(const DrivenChannel& c, const Model& m, ControlAxis& axis) {
    const std::size_t of = drive(c.input, m, c.name);
    const double to_um = c.scale * c.input.factor() / um;
    if (c.element)
      axis.elements.push_back({.channel = c.name,
                               .drive = of,
                               .scale = c.scale,
                               .gain_um = curve(c.element->gain, um),
                               .time_constant_s = curve(c.element->time_constant, 1.0),
                               .power_limit_W = c.element->power_limit()});
    if (c.printed) add_printed(c, of, to_um, axis);
    if (c.feedthrough != 0.0)
      axis.feedthroughs.push_back({c.name, of, shown(c.feedthrough * to_um)});
    const correction::Answer answer = correction::answer_of(m, c);
    for (const correction::Section& s : c.sections)
      if (s.gain != 0.0)
        axis.sections.push_back({.channel = c.name,
                                 .drive = of,
                                 .gain = shown(s.gain * to_um),
                                 .time_constant_s = s.time_constant,
                                 .straight = is_straight(c.input),
                                 .direct = answer.sensor_time_constant / s.time_constant,
                                 .off_gain = answer.off_gain,
                                 .off_time_constant = answer.off_time_constant,
                                 .speed_factor = answer.speed_factor,
                                 .gain_power = answer.gain_power,
                                 .falling = answer.falling});
  }

  void add(const Effect& e, const Model& m, ControlAxis& axis) {
    if (e.own) {
      if (e.values.front() == 0.0) return;  // it waits to be added
      throw InputError(
          fmt::format("{}: effect {} is a formula of your own, which no control can be given: take "
                      "it out, or put what it follows into a column that drives a channel",
                      plan_.source, e.id),
          {.file = plan_.source, .key = e.id});
    }
    const correction::EffectCard& card = *correction::find_card(e.id);
    if (card.of_reading) {
      note(fmt::format("{}: is of the readings of one record, and is left out", full_id(e)));
      return;
    }
    if (card.of_channel || e.values.front() == 0.0) return;
    if (e.id == "kinematic-displacement") {
      axis.kinematics.push_back({e.values[0], e.values[1], e.values[2]});
      return;
    }
    const bool motor = e.id == "motor-heat" && e.columns.empty();
    const Input in = correction::input_of(e, m);
    std::size_t of = plan_.drives.size();
    if (motor)
      plan_.drives.push_back(
          {.kind = ControlDrive::Kind::motor, .decay_rpm = e.values[2], .unit = "1"});
    else
      of = drive(in, m, e.where);
    axis.sections.push_back({.channel = full_id(e),
                             .drive = of,
                             .gain = e.values[0],
                             .time_constant_s = e.values[1],
                             .straight = !motor && is_straight(in)});
  }

  void add(const Model& m) {
    ControlAxis axis{.column = std::string(m.displacement->name),
                     .identifier = identifier(m.displacement->name),
                     .name = m.name,
                     .offset_um = shown(m.offset / um)};
    for (const DrivenChannel& c : m.channels) add(c, m, axis);
    if (m.kinematic && m.kinematic->A != 0.0)
      axis.kinematics.push_back({m.kinematic->A, m.kinematic->B, m.kinematic->C});
    for (const Effect& e : m.effects) add(e, m, axis);
    if (m.initial_state == correction::InitialState::free)
      note(
          fmt::format("{}: initial_state = \"free\" needs readings; a control begins from rest, "
                      "as if the machine were cold",
                      axis.column));
    if (m.covariance) note(fmt::format("{}: the band of its numbers is not in it", axis.column));
    plan_.axes.push_back(std::move(axis));
  }

  const std::vector<Model>& models_;
  ControlPlan plan_;
  std::vector<std::string> identifiers_;
};

}  // namespace

ControlPlan control_plan(const std::vector<correction::Model>& models, const std::string& source) {
  return Planner(models, source).plan();
}

}  // namespace raceway::io

#include "control/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "correction/effect_kind.h"
#include "correction/numbers.h"
#include "correction/range.h"
#include "correction/simulation.h"
#include "correction/trust.h"
#include "record/digits.h"
#include "record/series_channel.h"
#include "text/error.h"
#include "text/number_text.h"
#include "text/units.h"

namespace raceway::control {
namespace {

using correction::DrivenChannel;
using correction::Effect;
using correction::Input;
using correction::Model;
using record::Channel;

/// Of the highest value that was seen: what goes beyond it is no speed or feed of that machine.
constexpr double far_beyond = 10.0;

/// Values of a change of unit lose their last digits, gains carry all that they have.
double as_printed(double value) { return text::with_15_digits(value); }

class Planner {
 public:
  Planner(const std::vector<Model>& models, const correction::ControlSettings& settings,
          const std::string& source)
      : models_(models), settings_(settings) {
    plan_.source = source;
    plan_.settings = settings;
  }

  ControlPlan plan() {
    for (const Model& m : models_)
      for (const Channel* c : correction::inputs_of(m)) (void)input(*c);
    plan_.speed = place_of(plan_, "speed_rpm");
    plan_.coolant = place_of(plan_, "coolant_on");
    for (const Model& m : models_) {
      add(m);
      if (m.together) add(*m.together);
    }
    note_unknown_ranges();
    in_order(plan_);
    return std::move(plan_);
  }

 private:
  void note(std::string text) {
    if (std::find(plan_.notes.begin(), plan_.notes.end(), text) == plan_.notes.end())
      plan_.notes.push_back(std::move(text));
  }

  std::size_t input(const Channel& c) {
    const std::size_t known = place_of(plan_, c.name);
    if (known != nowhere) return known;
    ControlInput in = input_of(c);
    double still_s = unset;
    // Of several models the narrower range: beyond it one of them is out of what it has seen.
    for (const Model& m : models_)
      for (const correction::SeenRange& r : m.range)
        if (r.column && *r.column == c) {
          double low = as_printed(text::value_in_unit(c, r.lower)),
                 high = as_printed(text::value_in_unit(c, r.upper));
          // A spindle may turn the other way.
          if (in.by_amount && low < 0.0) {
            high = std::max(-low, high);
            low = 0.0;
          }
          in.lowest = std::isnan(in.lowest) ? low : std::max(in.lowest, low);
          in.highest = std::isnan(in.highest) ? high : std::min(in.highest, high);
          still_s = std::fmax(still_s, r.still);
        }
    guard(in);
    if (std::string time = allow_to_stand(in, still_s, settings_, "the training record");
        !time.empty())
      note(std::move(time));
    plan_.inputs.push_back(std::move(in));
    return plan_.inputs.size() - 1;
  }

  /// What is asked of temperatures is asked of other inputs only where their column is named.
  void guard(ControlInput& in) const {
    const auto given = [&](const auto& by_column) {
      return in.temperature || by_column.names(in.column);
    };
    if (given(settings_.plausible)) {
      const correction::ControlLimits limits = settings_.plausible.of(in.column);
      in.plausible_low = limits.low;
      in.plausible_high = limits.high;
    } else if (in.by_amount && in.highest > 0.0 && in.column != "coolant_on") {
      in.plausible_low = 0.0;  // an amount
      in.plausible_high = far_beyond * in.highest;
    } else if (!in.temperature && !in.by_amount && in.highest > in.lowest) {
      in.plausible_high = far_beyond * std::max(std::abs(in.lowest), std::abs(in.highest));
      in.plausible_low = -in.plausible_high;
    }
    const auto asked = [&](const correction::ByColumn<double>& by_column) {
      const double value = given(by_column) ? by_column.of(in.column) : 0.0;
      return value > 0.0 ? value : unset;
    };
    in.fastest_per_s = asked(settings_.fastest_per_s);
    in.stuck_s = asked(settings_.stuck_s);
    in.smoothing_s = settings_.smoothing_s.of(in.column);
  }

  /// Names the output and its axis: z of displacement_z_um, b of displacement_b_urad.
  void hand_out(ControlAxis& axis, const Channel& displacement) const {
    constexpr std::string_view before = "displacement_";
    const std::string name(displacement.variable.substr(before.size()));
    axis.letter = settings_.axis.of(axis.column);
    axis.angle = record::is_angle(displacement);
    if (axis.letter.empty() && name.size() == 1 &&
        std::string_view(axis.angle ? "abc" : "xyzuvw").find(name.front()) !=
            std::string_view::npos)
      axis.letter = name;
    axis.sign = settings_.sign.of(axis.column);
    axis.limit_um = settings_.limit_um.of(axis.column);
    axis.slew_um_s = settings_.slew_um_s.of(axis.column);
    const std::string unit = settings_.unit.of(axis.column);
    axis.counts = unit == "counts";
    axis.unit_um = axis.counts ? settings_.count_um.of(axis.column)
                               : as_printed(text::find_unit(unit)->factor / displacement.factor);
    axis.output = fmt::format("offset_{}_{}", name, unit);
  }

  void add(const correction::SeenTogether& seen) {
    ControlTogether made{.farthest = seen.farthest};
    const Eigen::MatrixXd weights = correction::Distance(seen).weights();
    for (Eigen::Index k = 0; k < weights.rows(); ++k) {
      const Channel& c = *seen.columns[static_cast<std::size_t>(k)];
      made.inputs.push_back(input(c));
      made.mean.push_back(as_printed(text::value_in_unit(c, seen.mean[k])));
      for (Eigen::Index j = 0; j <= k; ++j) {
        const Channel& of = *seen.columns[static_cast<std::size_t>(j)];
        made.weights.push_back(as_printed(weights(k, j) / seen.std[j] * of.factor));
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
          fmt::format("[correction.range] has no range of {}, so the exported program cannot "
                      "detect values outside the training data",
                      unknown));
  }

  /// The table along the axes that an input reads; of the others their one value remains, and since
  /// the torque is straight between points nothing is lost.
  std::size_t table(const Input& in, const std::string& channel) {
    const correction::FrictionTable& t = *in.table;
    ControlTable made{.file = t.file};
    const auto points = [](const correction::TableCoordinate& at, const std::vector<double>& axis) {
      return at.column ? axis : std::vector{at.value};
    };
    const std::vector<double> temperatures = points(in.temperature, t.temperature);
    made.axial_load_N = points(in.axial_load, t.axial_load);
    made.radial_load_N = points(in.radial_load, t.radial_load);
    for (const double n : t.speed) made.speed_rpm.push_back(as_printed(n / rpm));
    for (const double T : temperatures)
      made.temperature_C.push_back(record::with_digits(celsius(T), 12));
    for (const double T : temperatures)
      for (const double radial : made.radial_load_N)
        for (const double axial : made.axial_load_N)
          for (const double n : t.speed) made.torque_Nmm.push_back(t({n, axial, radial, T}) / N_mm);
    if (!t.holds({t.speed.front(), made.axial_load_N.front(), made.radial_load_N.front(),
                  temperatures.front()}))
      note(
          fmt::format("channel {}: a load or temperature that is constant in the model is outside "
                      "the range of {}; the program uses the torque at the edge of the table",
                      channel, t.file));
    plan_.tables.push_back(std::move(made));
    return plan_.tables.size() - 1;
  }

  std::size_t drive(const Input& in, const Model& m, const std::string& channel) {
    ControlDrive d{.unit = std::string(in.unit())};
    if (in.is_power()) {
      d.kind = ControlDrive::Kind::power;
      d.table = table(in, channel);
      if (in.axial_load.column) d.axial_load = input(*in.axial_load.column);
      if (in.radial_load.column) d.radial_load = input(*in.radial_load.column);
      if (in.temperature.column)
        d.temperature = input(*in.temperature.column);
      else
        d.temperature_C = record::with_digits(celsius(in.temperature.value), 12);
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
    if (in.window) {
      constexpr double no_edge = 1e9;
      const correction::Window& w = *in.window;
      const auto point = [&](std::size_t k) {
        return std::clamp(as_printed(text::value_in_unit(*w.column, w.points[k])), -no_edge,
                          no_edge);
      };
      d.window = input(*w.column);
      d.window_from = point(0);
      d.window_full_from = point(1);
      d.window_full_to = point(2);
      d.window_to = point(3);
      d.window_of_drive = w.of_input;
    }
    plan_.drives.push_back(std::move(d));
    return plan_.drives.size() - 1;
  }

  static bool is_straight(const Input& in) { return in.course() == record::Course::straight; }

  static ControlCurve curve(const correction::Characteristic& of, double unit) {
    using Form = correction::Characteristic;
    ControlCurve c;
    if (const auto* const line = std::get_if<Form::Line>(&of.form())) {
      c.factor = as_printed(line->slope / unit);
      c.other = as_printed(line->offset / unit);
    } else if (const auto* const power = std::get_if<Form::Power>(&of.form())) {
      c.kind = ControlCurve::Kind::power_law;
      c.factor = as_printed(power->factor / unit);
      c.other = power->exponent;
    } else {
      const auto& t = std::get<Form::Table>(of.form());
      c.kind = ControlCurve::Kind::table;
      c.input = t.input;
      for (const double v : t.value) c.value.push_back(as_printed(v / unit));
    }
    return c;
  }

  /// As the difference equation that it is. `because`: reason why it is no sum of sections.
  void add_equation(const DrivenChannel& c, std::size_t drive, const std::string& because,
                    ControlAxis& axis) {
    const auto refused = [&](const std::string& problem) {
      return text::InputError(fmt::format("{}: channel {}: {}", plan_.source, c.name, problem),
                              {.file = plan_.source, .key = "denominator"});
    };
    if (correction::never_decays(*c.printed))
      throw refused(fmt::format("the polynomials cannot run in a control: {}",
                                correction::pole_warnings(*c.printed).front()));
    const correction::TransferFunction f = correction::direct_form(*c.printed, c.input.factor());
    if (const double other = sampling_of(plan_); !std::isnan(other) && other != f.sampling)
      throw refused(fmt::format(
          "the polynomials of this channel are for calls every {:g} s, but the polynomials of "
          "another channel are for calls every {:g} s; export each displacement to a separate file",
          f.sampling, other));
    note(
        fmt::format("channel {}: exported as a difference equation, because {}. The control must "
                    "call the program every {:g} s; after any other interval, the channel keeps "
                    "its value and the program sets a flag",
                    c.name, because, f.sampling));
    for (const std::string& meaning : correction::pole_warnings(*c.printed))
      plan_.warnings.push_back(fmt::format("channel {}: {}", c.name, meaning));
    if (const double gap = 1.5 * f.sampling; plan_.settings.longest_gap_s < gap) {
      note(
          fmt::format("longest_gap_s is set to {:g} s instead of {:g} s; otherwise the exported "
                      "program would report calls every {:g} s as late",
                      gap, plan_.settings.longest_gap_s, f.sampling));
      plan_.settings.longest_gap_s = gap;
      plan_.settings.clock_jump_s = std::max(plan_.settings.clock_jump_s, gap);
    }
    axis.equations.push_back({c.name, drive, c.scale, f.sampling, f.numerator, f.denominator});
  }

  void add_printed(const DrivenChannel& c, std::size_t drive, double to_um, ControlAxis& axis) {
    try {
      const correction::ParallelForm form = correction::parallel_form(*c.printed);
      for (const auto& lag : form.lags)
        axis.sections.push_back(
            {.channel = c.name,
             .drive = drive,
             .gain = as_printed(lag.gain * to_um),
             .time_constant_s = as_printed(-c.printed->sampling / std::log1p(-lag.rise))});
      if (form.through != 0.0)
        axis.feedthroughs.push_back({c.name, drive, as_printed(form.through * to_um)});
      note(fmt::format(
          "channel {}: the polynomials were converted to {} section{}{}; the exported channel "
          "gives the same result with calls every {:g} s, and is also valid at other intervals",
          c.name, form.lags.size(), form.lags.size() == 1 ? "" : "s",
          form.through != 0.0 ? " and a feedthrough" : "", c.printed->sampling));
    } catch (const std::invalid_argument& e) {
      add_equation(c, drive, e.what(), axis);
    }
  }

  void add(const DrivenChannel& c, const Model& m, ControlAxis& axis) {
    const std::size_t of = drive(c.input, m, c.name);
    const double to_um = c.scale * c.input.factor() / um;
    if (c.element) {
      constexpr double no_bound = 1e30;
      const correction::Interval takes = c.element->domain();
      axis.elements.push_back({.channel = c.name,
                               .drive = of,
                               .scale = c.scale,
                               .gain_um = curve(c.element->gain, um),
                               .time_constant_s = curve(c.element->time_constant, 1.0),
                               .from = std::max(takes.lower, -no_bound),
                               .limit = takes.upper});
    }
    if (c.printed) add_printed(c, of, to_um, axis);
    if (c.feedthrough != 0.0)
      axis.feedthroughs.push_back({c.name, of, as_printed(c.feedthrough * to_um)});
    const correction::Answer answer = correction::answer_of(m, c);
    for (const correction::Section& s : c.sections)
      if (s.gain != 0.0)
        axis.sections.push_back({.channel = c.name,
                                 .drive = of,
                                 .gain = as_printed(s.gain * to_um),
                                 .time_constant_s = s.time_constant,
                                 .straight = is_straight(c.input),
                                 .direct = answer.sensor_time_constant / s.time_constant,
                                 .off_gain = answer.off_gain,
                                 .off_time_constant = answer.off_time_constant,
                                 .speed_factor = answer.speed_factor,
                                 .gain_power = answer.gain_power,
                                 .falling = answer.falling});
  }

  /// A share of an effect, by its kind. What is of one record's readings never comes here.
  struct ShareAdder {
    Planner& planner;
    const Model& model;
    const Effect& effect;
    ControlAxis& axis;

    void operator()(const correction::DrivenShare& s) const {
      if (s.gain == 0.0) return;
      const std::size_t drive = planner.drive(s.input, model, effect.where);
      if (std::isnan(s.time_constant))
        axis.feedthroughs.push_back({full_id(effect), drive, s.gain});
      else
        section(drive, s.gain, s.time_constant, is_straight(s.input));
    }
    void operator()(const correction::MotorShare& s) const {
      if (s.gain == 0.0) return;
      planner.plan_.drives.push_back(
          {.kind = ControlDrive::Kind::motor, .decay_rpm = s.decay_speed, .unit = "1"});
      section(planner.plan_.drives.size() - 1, s.gain, s.time_constant, false);
    }
    void operator()(const correction::Kinematic& law) const {
      if (law.A != 0.0) axis.kinematics.push_back({law.A, law.B, law.C});
    }
    // These belong to one record, not to the machine.
    void operator()(const correction::SettlingShare&) const {}
    void operator()(const correction::JumpShare&) const {}
    void operator()(std::monostate) const {}

   private:
    void section(std::size_t drive, double gain, double time_constant, bool straight) const {
      axis.sections.push_back({.channel = full_id(effect),
                               .drive = drive,
                               .gain = gain,
                               .time_constant_s = time_constant,
                               .straight = straight});
    }
  };

  void add(const Effect& e, const Model& m, ControlAxis& axis) {
    if (e.own) {
      if (e.off) return;
      throw text::InputError(
          fmt::format(
              "{}: effect {} is a user-defined formula, which cannot be exported: remove "
              "the effect, or write its values into a column and use this column in a channel",
              plan_.source, e.id),
          {.file = plan_.source, .key = e.id});
    }
    if (correction::card_of(e).of_reading) {
      note(fmt::format(
          "{}: not exported, because this effect only removes a disturbance from one record",
          full_id(e)));
      return;
    }
    std::visit(ShareAdder{*this, m, e, axis}, correction::kind_of(e).share(e, m));
  }

  void add(const Model& m) {
    ControlAxis axis{.column = std::string(m.displacement->name),
                     .name = m.name,
                     .offset_um = as_printed(m.offset / um)};
    hand_out(axis, *m.displacement);
    if (const correction::Trust trust = correction::trust_of(m);
        trust.level == correction::TrustLevel::unknown) {
      note(fmt::format("{}: the trust in this correction is {}", axis.column,
                       correction::line_of(trust)));
    } else {
      axis.trust = correction::name(trust.level);
      axis.trust_because = trust.because;
    }
    for (const DrivenChannel& c : m.channels) add(c, m, axis);
    if (m.kinematic && m.kinematic->A != 0.0)
      axis.kinematics.push_back({m.kinematic->A, m.kinematic->B, m.kinematic->C});
    for (const Effect& e : m.effects) add(e, m, axis);
    if (m.initial_state == correction::InitialState::free)
      note(
          fmt::format("{}: initial_state = \"free\" needs readings, so the program starts from "
                      "rest, as if the machine were cold",
                      axis.column));
    if (m.covariance)
      note(fmt::format("{}: the exported program calculates no confidence band", axis.column));
    plan_.axes.push_back(std::move(axis));
  }

  const std::vector<Model>& models_;
  const correction::ControlSettings& settings_;
  ControlPlan plan_;
};

}  // namespace

ControlInput input_of(const Channel& channel) {
  return {.column = std::string(channel.name),
          .unit = std::string(channel.unit.empty() ? "0 or 1" : channel.unit),
          .temperature = record::is_temperature(channel),
          .by_amount = record::acts_by_amount(channel)};
}

std::size_t place_of(const ControlPlan& plan, std::string_view column) {
  for (std::size_t k = 0; k < plan.inputs.size(); ++k)
    if (plan.inputs[k].column == column) return k;
  return nowhere;
}

ControlPlan control_plan(const std::vector<correction::Model>& models,
                         const correction::ControlSettings& settings, const std::string& source) {
  return Planner(models, settings, source).plan();
}

namespace {

/// All that makes two drives different.
std::string key_of(const ControlDrive& d) {
  return fmt::format(
      "{} {} {} {} {} {} {:.17g} {} {:.17g} {:.17g} {:.17g} {:.17g} {} {} {:.17g} {:.17g} {:.17g} "
      "{:.17g} "
      "{}",
      static_cast<int>(d.kind), fmt::join(d.inputs, ","), d.reference, d.axial_load, d.radial_load,
      d.temperature, d.temperature_C, d.table, d.exponent, d.decay_rpm, d.lowest, d.highest, d.unit,
      d.window, d.window_from, d.window_full_from, d.window_full_to, d.window_to,
      d.window_of_drive);
}
std::string key_of(const ControlTable& t) {
  return fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}", t.file,
                     fmt::join(t.speed_rpm, ","), fmt::join(t.axial_load_N, ","),
                     fmt::join(t.radial_load_N, ","), fmt::join(t.temperature_C, ","),
                     fmt::join(t.torque_Nmm, ","));
}

/// Takes in what is new and says where it stands.
template <typename Thing>
std::size_t place_in(std::vector<Thing>& list, std::map<std::string, std::size_t>& known,
                     const Thing& thing) {
  const auto [found, fresh] = known.emplace(key_of(thing), list.size());
  if (fresh) list.push_back(thing);
  return found->second;
}

}  // namespace

void in_order(ControlPlan& plan) {
  std::vector<ControlDrive> drives;
  std::vector<ControlTable> tables;
  std::map<std::string, std::size_t> known_drives, known_tables;
  const auto move = [&](std::size_t& drive) {
    ControlDrive d = plan.drives[drive];
    if (d.table != nowhere) d.table = place_in(tables, known_tables, plan.tables[d.table]);
    drive = place_in(drives, known_drives, d);
  };
  for (ControlAxis& a : plan.axes) {
    for (ControlSection& s : a.sections) move(s.drive);
    for (ControlElement& e : a.elements) move(e.drive);
    for (ControlFeedthrough& f : a.feedthroughs) move(f.drive);
    for (ControlEquation& e : a.equations) move(e.drive);
  }
  plan.drives = std::move(drives);
  plan.tables = std::move(tables);
  std::set<std::string> taken;
  const auto identifier = [&](const std::string& column) {
    std::string name = column;
    std::replace(name.begin(), name.end(), '-', '_');
    if (name.front() >= '0' && name.front() <= '9') name.insert(0, "x");
    while (!taken.insert(name).second) name.insert(0, "x");
    return name;
  };
  for (ControlInput& in : plan.inputs) in.identifier = identifier(in.column);
  for (ControlAxis& a : plan.axes) a.identifier = identifier(a.column);
}

std::string allow_to_stand(ControlInput& in, double still_s,
                           const correction::ControlSettings& settings, const std::string& where) {
  constexpr double margin = 1.5, whole = 600.0, most_s = 86400.0;
  if (!in.temperature || settings.stuck_s.names(in.column) ||
      settings.stuck_s.all != correction::ControlSettings{}.stuck_s.all)
    return {};
  const double needed = std::min(std::ceil(margin * still_s / whole) * whole, most_s);
  if (!(needed > in.stuck_s)) return {};
  const double before = std::exchange(in.stuck_s, needed);
  return fmt::format(
      "{} did not change for {:.3g} min in {}, so the exported program reports it as stuck after "
      "{:.6g} s instead of {:.6g} s; set stuck_s in [export] to change this time",
      in.column, still_s / 60.0, where, needed, before);
}

std::string trust_line(const ControlAxis& axis) {
  using correction::TrustLevel;
  for (const TrustLevel level :
       {TrustLevel::good, TrustLevel::within_range, TrustLevel::do_not_use})
    if (axis.trust == correction::name(level))
      return correction::line_of({level, axis.trust_because});
  return {};
}

void count_in_whole_numbers(ControlPlan& plan) {
  for (ControlAxis& a : plan.axes) {
    if (a.counts) continue;
    a.counts = true;
    a.unit_um = plan.settings.count_um.of(a.column);
    a.output = a.output.substr(0, a.output.rfind('_')) + "_counts";
  }
}

double sampling_of(const ControlPlan& plan) {
  for (const ControlAxis& a : plan.axes)
    if (!a.equations.empty()) return a.equations.front().sampling_s;
  return unset;
}

std::vector<std::size_t> used_inputs(const ControlPlan& plan, const ControlAxis& axis) {
  std::set<std::size_t> used;
  const auto add_drive = [&](std::size_t index) {
    const ControlDrive& d = plan.drives[index];
    used.insert(d.inputs.begin(), d.inputs.end());
    used.insert({d.reference, d.axial_load, d.radial_load, d.temperature, d.window});
    if (d.kind == ControlDrive::Kind::power || d.kind == ControlDrive::Kind::motor)
      used.insert(plan.speed);
  };
  for (const ControlSection& s : axis.sections) {
    add_drive(s.drive);
    if (s.speed_factor != 0.0) used.insert(plan.speed);
    if (s.off_gain != 1.0 || s.off_time_constant != 1.0) used.insert(plan.coolant);
  }
  for (const ControlElement& e : axis.elements) add_drive(e.drive);
  for (const ControlFeedthrough& f : axis.feedthroughs) add_drive(f.drive);
  for (const ControlEquation& e : axis.equations) add_drive(e.drive);
  if (!axis.kinematics.empty()) used.insert(plan.speed);
  used.erase(nowhere);
  return {used.begin(), used.end()};
}

}  // namespace raceway::control

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "control/detail/programs.h"
#include "control/detail/text.h"
#include "control/formats.h"

namespace raceway::control {
namespace {

/// The numbers of a plan as C writes them.
class Numbers {
 public:
  Numbers(const ControlPlan& plan, std::string_view name) : plan_(plan), name_(name) {
    for (const ControlTogether& t : plan.together) add(t);
    for (const ControlDrive& d : plan.drives) add(d);
    for (std::size_t k = 0; k < plan.axes.size(); ++k) add(plan.axes[k], k);
  }

  [[nodiscard]] std::vector<Replacement> replacements() const {
    std::string input_names, output_names, lowest, highest, temperatures, amounts, offsets, uses;
    std::string low, high, fastest, stuck, smoothing, sign, limit, slew, unit, counts;
    bool smooths = false;
    for (std::size_t k = 0; k < plan_.inputs.size(); ++k) {
      const ControlInput& in = plan_.inputs[k];
      input_names += fmt::format("  {}_in_{} = {}, /* {}{} */\n", name_, in.identifier, k, in.unit,
                                 std::isnan(in.lowest)
                                     ? std::string()
                                     : fmt::format(", {:.15g} to {:.15g}", in.lowest, in.highest));
      lowest += real(std::isnan(in.lowest) ? -unbounded : in.lowest) + ", ";
      highest += real(std::isnan(in.highest) ? unbounded : in.highest) + ", ";
      temperatures += in.temperature ? "1, " : "0, ";
      amounts += in.by_amount ? "1, " : "0, ";
      low += real_or(in.plausible_low, -unbounded) + ", ";
      high += real_or(in.plausible_high, unbounded) + ", ";
      fastest += real_or(in.fastest_per_s, unbounded) + ", ";
      stuck += real_or(in.stuck_s, unbounded) + ", ";
      smoothing += real(in.smoothing_s) + ", ";
      smooths = smooths || in.smoothing_s > 0.0;
    }
    for (std::size_t k = 0; k < plan_.axes.size(); ++k) {
      const ControlAxis& a = plan_.axes[k];
      output_names += fmt::format("  {}_out_{} = {}, /* {}, {} */\n", name_, a.identifier, k,
                                  a.output, harmless(a.name));
      offsets += real(a.offset_um) + ", ";
      sign += real(a.sign) + ", ";
      limit += real(a.limit_um) + ", ";
      slew += real(a.slew_um_s) + ", ";
      unit += real(a.unit_um) + ", ";
      counts += a.counts ? "1, " : "0, ";
      const std::vector<std::size_t> used = used_inputs(plan_, a);
      for (std::size_t j = 0; j < plan_.inputs.size(); ++j)
        uses += std::binary_search(used.begin(), used.end(), j) ? "1, " : "0, ";
    }
    std::string check;
    for (const ControlCheck::Row& r : plan_.check.rows)
      check += fmt::format("  {{{}, {}}},\n", control_number(r.time_s, "0"),
                           control_numbers(joined(r.inputs, r.displacements_um)));
    const correction::ControlSettings& s = plan_.settings;
    std::string on_fault = s.on_fault;
    std::replace(on_fault.begin(), on_fault.end(), '-', '_');
    const auto yes = [](bool is_so) { return std::string(is_so ? "1" : "0"); };
    return {
        {"PLAUSIBLE_LOW", listed_or_zero(low)},
        {"PLAUSIBLE_HIGH", listed_or_zero(high)},
        {"FASTEST", listed_or_zero(fastest)},
        {"STUCK", listed_or_zero(stuck)},
        {"SMOOTHING", listed_or_zero(smoothing)},
        {"SMOOTHS", yes(smooths)},
        {"SIGN", sign},
        {"LIMIT", limit},
        {"SLEW", slew},
        {"UNIT", unit},
        {"COUNTS", counts},
        {"USES", listed_or_zero(uses)},
        {"LONGEST_GAP", control_number(s.longest_gap_s, "1e30")},
        {"CLOCK_JUMP", control_number(s.clock_jump_s, "1e30")},
        {"HOLD", control_number(s.hold_s, "1e30")},
        {"FADE", control_number(s.fade_s, "1e30")},
        {"ON_FAULT", on_fault},
        {"RESTART", s.restart},
        {"TOUCH_OFF_KEEPS", yes(s.touch_off == "keep")},
        {"DISABLED_TO_ZERO", yes(s.disabled == "zero")},
        {"HOLD_BEYOND", yes(s.beyond_range == "hold")},
        {"CHECK", check.empty() ? "  {0}\n" : check},
        {"CHECK_ROWS", std::to_string(plan_.check.rows.size())},
        {"TOLERANCE", control_tolerance},
        {"UM", units_of(plan_)},
        {"HEADING", "/*\n" + control_heading(plan_, " * ") + " */\n"},
        {"POWER", plan_.tables.empty() && element_count_ == 0 ? "0" : "1"},
        {"STAMP", fmt::format("{}.0", stamp(plan_))},
        {"INPUT_NAMES", input_names},
        {"OUTPUT_NAMES", output_names},
        {"INPUTS", std::to_string(plan_.inputs.size())},
        {"OUTPUTS", std::to_string(plan_.axes.size())},
        {"SPEED", place(plan_.speed)},
        {"COOLANT", place(plan_.coolant)},
        {"LOWEST", listed_or_zero(lowest)},
        {"HIGHEST", listed_or_zero(highest)},
        {"TEMPERATURES", listed_or_zero(temperatures)},
        {"AMOUNTS", listed_or_zero(amounts)},
        {"OFFSETS", listed_or_zero(offsets)},
        // Two numbers where there are none: a compiler follows an index of one to the second.
        {"POINTS", points_.empty() ? "  0, 0\n" : points_},
        {"DRIVE_INPUTS", listed_or_zero(drive_inputs_)},
        {"DRIVES_COUNT", std::to_string(plan_.drives.size())},
        {"DRIVES", rows(drives_, "{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, {0, 0, 0, 0}}")},
        {"TABLE_AXES", rows(table_axes_, "{0, 0, 0, 0}")},
        {"TOGETHER_COUNT", std::to_string(plan_.together.size())},
        {"TOGETHER_INPUTS", listed_or_zero(together_inputs_)},
        {"TOGETHER_MEAN", listed_or_zero(together_mean_)},
        {"TOGETHER_WEIGHTS", listed_or_zero(together_weights_)},
        {"TOGETHER", rows(together_, "{0, 0, 0, 0}")},
        {"SECTIONS_COUNT", std::to_string(section_count_)},
        {"SECTIONS", rows(sections_, "{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}")},
        {"ELEMENTS_COUNT", std::to_string(element_count_)},
        {"ELEMENTS", rows(elements_, "{0, 0, 0, 0, 0, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}}")},
        {"FEEDTHROUGHS_COUNT", std::to_string(feedthrough_count_)},
        {"FEEDTHROUGHS", rows(feedthroughs_, "{0, 0, 0}")},
        {"EQUATIONS_COUNT", std::to_string(equation_count_)},
        {"PAST_COUNT", std::to_string(coefficient_count_)},
        {"SAMPLING", control_number(sampling_of(plan_), "0")},
        {"INTERVAL_SHARE", control_number(interval_tolerance, "0")},
        {"NUMERATORS", listed_or_zero(numerators_)},
        {"DENOMINATORS", listed_or_zero(denominators_)},
        {"EQUATIONS", rows(equations_, "{0, 0, 0, 0, 0}")},
        {"KINEMATICS_COUNT", std::to_string(kinematic_count_)},
        {"KINEMATICS", rows(kinematics_, "{0, 0, 0, 0}")}};
  }

 private:
  static constexpr double unbounded = 1e30;  // of a float too

  [[nodiscard]] std::string real(double value) const {
    return fmt::format("{}_R({})", name_, control_number(value, "1e30"));
  }
  [[nodiscard]] std::string real_or(double value, double otherwise) const {
    return real(std::isnan(value) ? otherwise : value);
  }
  static std::vector<double> joined(std::vector<double> first, const std::vector<double>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }
  static std::string place(std::size_t index) {
    return index == nowhere ? "-1" : std::to_string(index);
  }
  // C has no empty arrays.
  static std::string listed_or_zero(const std::string& list) { return list.empty() ? "0" : list; }
  static std::string rows(const std::string& text, std::string_view instead) {
    return text.empty() ? fmt::format("  {}\n", instead) : text;
  }

  std::size_t add_points(const std::vector<double>& values, std::string_view what) {
    points_ += fmt::format("  /* {} */ ", what);
    for (const double v : values) points_ += real(v) + ", ";
    points_ += "\n";
    const std::size_t first = point_count_;
    point_count_ += values.size();
    return first;
  }

  void add(const ControlTogether& t) {
    together_ += fmt::format("  {{{}, {}, {}, {}}},\n", together_input_count_, t.inputs.size(),
                             together_weight_count_, real(t.farthest));
    for (const std::size_t k : t.inputs) together_inputs_ += fmt::format("{}, ", k);
    for (const double v : t.mean) together_mean_ += real(v) + ", ";
    for (const double v : t.weights) together_weights_ += real(v) + ", ";
    together_input_count_ += t.inputs.size();
    together_weight_count_ += t.weights.size();
  }

  void add(const ControlDrive& d) {
    constexpr std::string_view kinds[] = {"rise", "size", "power", "motor"};
    std::size_t torques = 0, axes = 0;
    const std::size_t first_axis = axis_count_;
    if (d.table != nowhere) {
      const ControlTable& t = plan_.tables[d.table];
      for (const TableAxis& axis : axes_of(plan_, d)) {
        table_axes_ += fmt::format(
            "  {{{}, {}, {}, {}}},\n", axis.input, axis.by_amount ? 1 : 0,
            add_points(axis.points,
                       axes == 0 ? fmt::format("{}{}: rpm", harmless(t.file), fixed_load(plan_, d))
                                 : plan_.inputs[axis.input].unit),
            axis.points.size());
        ++axes;
      }
      torques = add_points(t.torque_Nmm, "N mm, speed first");
      axis_count_ += axes;
    }
    const auto point = [&](double value) { return real(std::isnan(value) ? 0.0 : value); };
    drives_ += fmt::format(
        "  {{{}_{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {{{}, {}, {}, {}}}}},\n", name_,
        kinds[static_cast<std::size_t>(d.kind)], drive_input_count_, d.inputs.size(),
        place(d.reference), real(std::isnan(d.decay_rpm) ? 1.0 : d.decay_rpm),
        real(std::isnan(d.lowest) ? -unbounded : d.lowest),
        real(std::isnan(d.highest) ? unbounded : d.highest), first_axis, axes, torques,
        real(d.exponent), place(d.window), d.window_of_drive ? 1 : 0, point(d.window_from),
        point(d.window_full_from), point(d.window_full_to), point(d.window_to));
    for (const std::size_t k : d.inputs) drive_inputs_ += fmt::format("{}, ", k);
    drive_input_count_ += d.inputs.size();
  }

  std::string curve(const ControlCurve& c, std::string_view what, std::string_view of) {
    if (c.kind == ControlCurve::Kind::table) {
      const std::size_t inputs = add_points(c.input, of);
      const std::size_t values = add_points(c.value, what);
      return fmt::format("{{{}_table, {}, {}, {}, 0, 0}}", name_, inputs, values, c.value.size());
    }
    return fmt::format("{{{}_{}, 0, 0, 0, {}, {}}}", name_,
                       c.kind == ControlCurve::Kind::line ? "line" : "power_law", real(c.factor),
                       real(c.other));
  }

  void add(const ControlAxis& a, std::size_t output) {
    for (const ControlSection& s : a.sections)
      sections_ += fmt::format("  {{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}, /* {} */\n",
                               output, s.drive, s.straight ? 1 : 0, real(s.gain),
                               real(s.time_constant_s), real(s.direct), real(s.off_gain),
                               real(s.off_time_constant), real(s.speed_factor), real(s.gain_power),
                               real(s.falling), harmless(s.channel));
    for (const ControlElement& e : a.elements) {
      const std::string& of = plan_.drives[e.drive].unit;
      elements_ +=
          fmt::format("  {{{}, {}, {}, {}, {},\n   {},\n   {}}}, /* {} */\n", output, e.drive,
                      real(e.scale), real(e.from), real(e.limit), curve(e.gain_um, unit_of(a), of),
                      curve(e.time_constant_s, "s", of), harmless(e.channel));
    }
    for (const ControlFeedthrough& f : a.feedthroughs)
      feedthroughs_ += fmt::format("  {{{}, {}, {}}}, /* {} */\n", output, f.drive, real(f.gain),
                                   harmless(f.channel));
    for (const ControlEquation& e : a.equations) {
      equations_ +=
          fmt::format("  {{{}, {}, {}, {}, {}}}, /* {} */\n", output, e.drive, coefficient_count_,
                      e.numerator.size(), control_number(e.scale, "1"), harmless(e.channel));
      numerators_ += control_numbers(e.numerator) + ", ";
      denominators_ += control_numbers(e.denominator) + ", ";
      coefficient_count_ += e.numerator.size();
    }
    for (const ControlKinematic& k : a.kinematics)
      kinematics_ += fmt::format("  {{{}, {}, {}, {}}},\n", output, real(k.A_um), real(k.B),
                                 real(k.C_per_rpm));
    section_count_ += a.sections.size();
    element_count_ += a.elements.size();
    feedthrough_count_ += a.feedthroughs.size();
    equation_count_ += a.equations.size();
    kinematic_count_ += a.kinematics.size();
  }

  const ControlPlan& plan_;
  std::string name_;
  std::string together_, together_inputs_, together_mean_, together_weights_;
  std::size_t together_input_count_ = 0, together_weight_count_ = 0;
  std::string points_, table_axes_, drive_inputs_, drives_, sections_, elements_, feedthroughs_,
      kinematics_;
  std::string equations_, numerators_, denominators_;
  std::size_t point_count_ = 0, axis_count_ = 0, drive_input_count_ = 0, section_count_ = 0,
              element_count_ = 0, feedthrough_count_ = 0, kinematic_count_ = 0, equation_count_ = 0,
              coefficient_count_ = 0;
};

/// The program as of another name than "correction".
std::string with_name(std::string_view text, std::string_view name) {
  std::string capitals(name);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  const std::array renamed{
      std::pair<std::string_view, std::string>{"correction_", fmt::format("{}_", name)},
      std::pair<std::string_view, std::string>{"CORRECTION_", capitals + "_"}};
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto* const found = std::find_if(renamed.begin(), renamed.end(), [&](const auto& one) {
      return text.substr(at).starts_with(one.first);
    });
    result += found == renamed.end() ? std::string(1, text[at]) : found->second;
    at += found == renamed.end() ? 1 : found->first.size();
  }
  return result;
}

}  // namespace

std::string control_c(const ControlPlan& plan, std::string_view name) {
  return filled(with_name(c_program, name), Numbers(plan, name).replacements());
}

}  // namespace raceway::control

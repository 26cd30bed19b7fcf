#include <fmt/format.h>

#include <cmath>

#include "control/detail/programs.h"
#include "control/detail/text.h"
#include "control/formats.h"
#include "text/format_number.h"

namespace raceway::control {
namespace {

constexpr std::string_view by_hand =
    "#\n# To correct a record: python3 FILE RECORD.csv > corrected.csv\n"
    "# To check this file with its stored record: python3 FILE --check\n";

std::string number(double value) { return control_number(value, "None"); }
std::string place(std::size_t index) {
  return index == nowhere ? "None" : fmt::format("{}", index);
}
std::string list(const std::vector<double>& values) { return "[" + control_numbers(values) + "]"; }

std::string together_text(const ControlTogether& t) {
  std::string rows;
  for (std::size_t k = 0, at = 0; k < t.inputs.size(); at += ++k) {
    const auto from = t.weights.begin() + static_cast<std::ptrdiff_t>(at);
    rows += fmt::format("      {},\n",
                        list(std::vector(from, from + static_cast<std::ptrdiff_t>(k + 1))));
  }
  return fmt::format("    ([{}], {}, [\n{}     ], {}),\n", fmt::join(t.inputs, ", "), list(t.mean),
                     rows, number(t.farthest));
}

std::string plain_drive_text(const ControlDrive& d, const ControlPlan& plan) {
  switch (d.kind) {
    case ControlDrive::Kind::rise:
      return fmt::format(R"({{"kind": "rise", "inputs": [{}], "reference": {}}})",
                         fmt::join(d.inputs, ", "), place(d.reference));
    case ControlDrive::Kind::size:
      return fmt::format(R"({{"kind": "size", "inputs": [{}], "exponent": {}}})",
                         fmt::join(d.inputs, ", "), number(d.exponent));
    case ControlDrive::Kind::motor:
      return fmt::format(R"({{"kind": "motor", "decay_rpm": {}}})", number(d.decay_rpm));
    case ControlDrive::Kind::power:
      break;
  }
  const ControlTable& t = plan.tables[d.table];
  const auto speeds = static_cast<std::ptrdiff_t>(t.speed_rpm.size());
  std::string axes, rows;
  for (const TableAxis& axis : axes_of(plan, d))
    axes += fmt::format("{}({}, {})", axes.empty() ? "" : ",\n               ", axis.input,
                        list(axis.points));
  for (auto row = t.torque_Nmm.begin(); row != t.torque_Nmm.end(); row += speeds)
    rows += fmt::format("         {},\n", control_numbers(std::vector(row, row + speeds)));
  return fmt::format(
      "{{\"kind\": \"power\", \"lowest\": {}, \"highest\": {},\n"
      "     # of {}{}\n     \"table\": {{\n"
      "      \"axes\": [{}],\n      \"torque_Nmm\": [\n{}     ]}}}}",
      number(d.lowest), number(d.highest), harmless(t.file), fixed_load(plan, d), axes, rows);
}

std::string drive_text(const ControlDrive& d, const ControlPlan& plan) {
  std::string text = plain_drive_text(d, plan);
  if (d.window == nowhere) return text;
  text.insert(text.size() - 1,
              fmt::format(R"(, "window": ({}, {}, {}))", d.window,
                          list({d.window_from, d.window_full_from, d.window_full_to, d.window_to}),
                          d.window_of_drive ? "True" : "False"));
  return text;
}

std::string curve_text(const ControlCurve& c) {
  if (c.kind == ControlCurve::Kind::table)
    return fmt::format(R"(("table", [{}, {}]))", list(c.input), list(c.value));
  return fmt::format(R"(("{}", [{}, {}]))",
                     c.kind == ControlCurve::Kind::line ? "line" : "power law", number(c.factor),
                     number(c.other));
}

/// With what is otherwise than in a plain lag.
std::string section_text(const ControlSection& s) {
  std::string text = fmt::format("         section(drive={}, gain={}, time_constant={}", s.drive,
                                 number(s.gain), number(s.time_constant_s));
  const auto add = [&](std::string_view name, double value, double plain) {
    if (value != plain) text += fmt::format(", {}={}", name, number(value));
  };
  if (s.straight) text += ", straight=True";
  add("direct", s.direct, 0.0);
  add("off_gain", s.off_gain, 1.0);
  add("off_time_constant", s.off_time_constant, 1.0);
  add("speed_factor", s.speed_factor, 0.0);
  if (s.speed_factor != 0.0) add("gain_power", s.gain_power, 1.0);
  add("falling", s.falling, 1.0);
  return fmt::format("{}),  # {}\n", text, harmless(s.channel));
}

std::string guard_text(const ControlInput& in) {
  std::string text = "    guard(";
  const auto add = [&](std::string_view name, const std::string& value) {
    text += fmt::format("{}{}={}", text.back() == '(' ? "" : ", ", name, value);
  };
  if (!std::isnan(in.plausible_low))
    add("plausible", fmt::format("({}, {})", number(in.plausible_low), number(in.plausible_high)));
  if (!std::isnan(in.fastest_per_s)) add("fastest", number(in.fastest_per_s));
  if (!std::isnan(in.stuck_s)) add("stuck", number(in.stuck_s));
  if (in.smoothing_s != 0.0) add("smoothing", number(in.smoothing_s));
  return fmt::format("{}),  # {}\n", text, in.column);
}

std::string axis_text(const ControlPlan& plan, const ControlAxis& a) {
  std::string text = fmt::format(
      "    # {}\n    {{\"displacement\": \"{}\", \"output\": \"{}\", \"axis\": \"{}\",\n"
      "     \"inputs\": [{}],\n"
      "     \"sign\": {}, \"limit\": {}, \"slew\": {}, \"unit_um\": {}, \"counts\": {},\n"
      "     \"offset\": {},\n",
      harmless(a.name), a.column, a.output, a.letter, fmt::join(used_inputs(plan, a), ", "),
      number(a.sign), number(a.limit_um), number(a.slew_um_s), number(a.unit_um),
      a.counts ? "True" : "False", number(a.offset_um));
  if (a.angle) text += "     \"angle\": True,  # urad instead of um\n";
  text += "     \"sections\": [\n";
  for (const ControlSection& s : a.sections) text += section_text(s);
  text += "     ],\n     \"elements\": [\n";
  for (const ControlElement& e : a.elements)
    text += fmt::format(
        "         # {}; gain [{}] and time constant [s] as functions of the drive [{}]\n"
        "         {{\"drive\": {}, \"scale\": {}, \"from\": {}, \"limit\": {},\n"
        "          \"gain\": {},\n          \"time_constant\": {}}},\n",
        harmless(e.channel), unit_of(a), plan.drives[e.drive].unit, e.drive, number(e.scale),
        number(e.from), number(e.limit), curve_text(e.gain_um), curve_text(e.time_constant_s));
  text += "     ],\n     \"feedthroughs\": [\n";
  for (const ControlFeedthrough& f : a.feedthroughs)
    text += fmt::format("         {{\"drive\": {}, \"gain\": {}}},  # {}\n", f.drive,
                        number(f.gain), harmless(f.channel));
  text += "     ],\n     \"equations\": [\n";
  for (const ControlEquation& e : a.equations)
    text += fmt::format(
        "         # {}\n         {{\"drive\": {}, \"scale\": {},\n          \"numerator\": {},\n"
        "          \"denominator\": {}}},\n",
        harmless(e.channel), e.drive, number(e.scale), list(e.numerator), list(e.denominator));
  text += "     ],\n     \"kinematics\": [\n";
  for (const ControlKinematic& k : a.kinematics)
    text += fmt::format("         {{\"A\": {}, \"B\": {}, \"C\": {}}},  # {}, 1, 1/rpm\n",
                        number(k.A_um), number(k.B), number(k.C_per_rpm), unit_of(a));
  return text + "     ]},\n";
}

/// The program with what it does when it is started by hand.
std::string program_with(const ControlPlan& plan, std::string_view usage, std::string_view main) {
  std::string inputs, guards, together, drives, axes, check;
  for (const ControlInput& in : plan.inputs) {
    inputs += fmt::format("    (\"{}\", \"{}\", {}, {}),\n", in.column, in.unit, number(in.lowest),
                          number(in.highest));
    guards += guard_text(in);
  }
  for (const ControlTogether& t : plan.together) together += together_text(t);
  for (const ControlDrive& d : plan.drives) drives += "    " + drive_text(d, plan) + ",\n";
  for (const ControlAxis& a : plan.axes) axes += axis_text(plan, a);
  for (const ControlCheck::Row& r : plan.check.rows)
    check += fmt::format("{:.15g} {:.15g} {:.15g}\n", r.time_s, fmt::join(r.inputs, " "),
                         fmt::join(r.displacements_um, " "));
  const correction::ControlSettings& s = plan.settings;
  return filled(python_program, {{"UM", units_of(plan)},
                                 {"HEADING", control_heading(plan, "# ")},
                                 {"USAGE", std::string(usage)},
                                 {"GUARDS", guards},
                                 {"LONGEST_GAP", number(s.longest_gap_s)},
                                 {"CLOCK_JUMP", number(s.clock_jump_s)},
                                 {"ON_FAULT", s.on_fault},
                                 {"HOLD", number(s.hold_s)},
                                 {"FADE", number(s.fade_s)},
                                 {"RESTART", s.restart},
                                 {"TOUCH_OFF", s.touch_off},
                                 {"DISABLED", s.disabled},
                                 {"BEYOND", s.beyond_range},
                                 {"CHECK", check},
                                 {"TOLERANCE", control_tolerance},
                                 {"MAIN", std::string(main)},
                                 {"FORMAT", fmt::format("{}", text::format_number)},
                                 {"STAMP", fmt::format("{}", stamp(plan))},
                                 {"INPUTS", inputs},
                                 {"TOGETHER", together},
                                 {"DRIVES", drives},
                                 {"AXES", axes},
                                 {"SPEED", place(plan.speed)},
                                 {"COOLANT", place(plan.coolant)},
                                 {"SAMPLING", number(sampling_of(plan))},
                                 {"INTERVAL_SHARE", number(interval_tolerance)}});
}

}  // namespace

std::string control_python(const ControlPlan& plan) {
  return program_with(plan, by_hand, python_main);
}

std::string control_linuxcnc(const ControlPlan& plan) {
  return program_with(plan, by_hand, linuxcnc_main);
}

}  // namespace raceway::control

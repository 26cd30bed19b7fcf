#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "control/detail/table_fields.h"
#include "control/detail/text.h"
#include "control/formats.h"
#include "record/series_channel.h"
#include "text/detail/csv_text.h"

namespace raceway::control {
namespace {

using DriveKind = ControlDrive::Kind;

constexpr std::string_view formulas =
    R"(# One number per row. Displacements in um, temperatures in C, their rises in K, dt = time since the previous call in s.
# rise   u = mean of (T - T at the first call) over the inputs, minus (T - T at the first call) of the reference
# size   u = mean of the inputs x without sign; with an exponent, mean of x (x/1000)^(exponent - 1), above highest at most the tangent there
# power  u = torque of the friction table [N mm] / 1000 * speed [rpm] * pi/30; the torque is interpolated linearly in the
#        table, and outside the table it keeps the value at the edge
# motor  u = exp(-speed/decay_speed) while the speed is above 0, else 0
# section      s = s + (1 - exp(-dt/time_constant)) * (gain*u - s), with u of the previous call; s = 0 at the first call.
#              If course is straight, add weight * gain * (u now - u of the previous call), with
#              weight = 1 - (1 - exp(-dt/time_constant))/(dt/time_constant)
# feedthrough  gain * u now
# kinematic    A * n^(1 - B*exp(-C*n)), n = speed without sign [rpm]; 0 at n = 0
# displacement = offset + sum of its sections, elements, feedthroughs and kinematics
# If an input is outside lowest and highest, raise a flag. feedthrough and kinematic then use the value at the limit; for
#              speeds, feeds and power, only highest is a limit. motor limits the speed at both ends.
)";

constexpr std::string_view together_formulas =
    R"(# together     Raise a flag if sqrt(sum of z^2) is above farthest. Each input of the part has one z: the sum of
#              weight * (input now - mean) over the inputs that its rows "weight of INPUT" name; speeds and feeds without sign.
)";

constexpr std::string_view answer_formulas =
    R"(# Section with more numbers: f = 1/(1 + speed_factor*speed/10000), with the speed of the previous call.
#   Multiply gain by f^gain_power, and by off_gain if coolant_on was 0 at the previous call. Multiply time_constant by f,
#   by off_time_constant if coolant_on was 0 at the previous call, and by falling if (g - s)*gain < 0. Here g is gain
#   times the mean of u at the previous call and u now (if course is held: u at the previous call only).
#   The section adds s + direct*(gain*u now - s), with the gain of the table.
)";

constexpr std::string_view element_formulas =
    R"(# element      s = s + (1 - exp(-dt/T)) * (scale*K - s), with s = 0 at the first call. The gain K and the time constant T
#              are functions of u at the previous call, calculated from inputs within lowest and highest; K = 0 at u = 0.
#              If u is below `from` (default 0), or not below `limit`, s keeps its value. Each function is a line,
#              slope*u + value_at_0, a power law, factor*u^exponent, or a table, which is interpolated linearly and keeps
#              its end values.
)";

constexpr std::string_view schema =
    R"(# Columns: of: input or displacement to which the number belongs; channel: channel of the model; part; name; value; unit.
#          Parts: control, input, together N, displacement, section N, element N, feedthrough N, kinematic N, check.
#          The order of inputs and displacements is the order of their rows. Numbers have 15 digits; limit = none: no limit.
#          raceway export can read this table instead of a model, also after you have changed numbers.
# control  offset = sign * (displacement - displacement at the last touch-off) + offset at the last touch-off, from -limit to
#          limit. The offset changes by at most slew per second. Output: offset / unit, rounded if counts is 1. An input is
#          faulty if it is outside plausible, changes faster than fastest, or stays constant longer than stuck (docs/control.md).
# check    record, with inputs at most at the ends of their ranges, and the displacements that raceway correct predicts for it,
#          without limit, slew, sign and touch-off
)";

constexpr std::string_view sign_formulas =
    R"(# Inputs keep their sign, except inputs with the unit rpm, m/min or 0 or 1.
)";

constexpr std::string_view load_formulas =
    R"(# The friction table is read at axial_load_input and radial_load_input; if it has no loads below 0, without their sign.
)";

constexpr std::string_view window_formulas =
    R"(# window       factor from its input x: 0 outside window_from and window_to, 1 between window_full_from and window_full_to,
#              and linear between. If window_acts_on is input, multiply u by the factor; if it is displacement, multiply the
#              displacement of the part.
)";

constexpr std::string_view equation_formulas =
    R"(# equation     part "equation N": y = sum of numerator i * (u of i calls before) - sum of denominator i *
#              (y of i calls before), in double precision; the part adds scale * y. y changes only if dt equals sampling
#              within 5 %; otherwise y keeps its value, and a flag is raised.
)";

class Table {
 public:
  explicit Table(const ControlPlan& plan) : plan_(plan) {}

  std::string text() {
    part_ = "control";
    for (const auto& f : setting_numbers) number(f.name, plan_.settings.*f.number, f.unit);
    for (const auto& f : setting_texts) word(f.name, plan_.settings.*f.text);
    for (const ControlInput& in : plan_.inputs) add(in);
    for (std::size_t k = 0; k < plan_.together.size(); ++k) add(plan_.together[k], k + 1);
    for (const ControlAxis& a : plan_.axes) add(a);
    for (const ControlCheck::Row& r : plan_.check.rows) add(r);
    return fmt::to_string(out_);
  }

 private:
  void put(std::string_view name, std::string_view value, std::string_view unit) {
    const auto out = std::back_inserter(out_);
    text::append_text(out_, of_);
    out_.push_back(',');
    text::append_text(out_, channel_);
    fmt::format_to(out, ",{},{},{},{}\n", part_, name, value,
                   displacement_ ? record::in_unit_of(*displacement_, unit) : std::string(unit));
  }
  void word(std::string_view name, std::string_view value) {
    fmt::memory_buffer cell;
    text::append_text(cell, value);
    put(name, fmt::to_string(cell), "");
  }
  void number(std::string_view name, double value, std::string_view unit) {
    if (!std::isnan(value)) put(name, control_number(value, "none"), unit);
  }

  /// What is as a part has it anyway is left out, where it may be.
  template <typename Part, std::size_t count>
  void numbers(const Part& part, const std::array<NumberField<Part>, count>& fields,
               std::string_view unit = {}) {
    static const Part plain{};
    for (const auto& f : fields) {
      if (!f.required && part.*f.number == plain.*f.number) continue;
      const bool of_input = f.unit.starts_with("input");
      number(f.name, part.*f.number,
             f.unit == "u" ? std::string(unit)
             : of_input    ? std::string(unit) + std::string(f.unit.substr(5))
                           : std::string(f.unit));
    }
  }

  void add(const ControlInput& in) {
    of_ = in.column;
    channel_ = "";
    part_ = "input";
    if (std::isnan(in.lowest)) word("range", "not known");
    numbers(in, input_numbers, in.unit);
  }

  void add(const ControlTogether& t, std::size_t count) {
    part_ = fmt::format("together {}", count);
    channel_ = "";
    for (std::size_t k = 0, at = 0; k < t.inputs.size(); ++k) {
      of_ = plan_.inputs[t.inputs[k]].column;
      number("mean", t.mean[k], plan_.inputs[t.inputs[k]].unit);
      for (std::size_t j = 0; j <= k; ++j, ++at)
        number("weight of " + plan_.inputs[t.inputs[j]].column, t.weights[at], "");
    }
    of_ = "";
    number("farthest", t.farthest, "1");
  }

  void begin(const std::string& channel, std::string_view part, std::size_t count) {
    channel_ = channel;
    part_ = fmt::format("{} {}", part, count);
  }

  void add_drive(std::size_t index) {
    const ControlDrive& d = plan_.drives[index];
    word("u", drive_kinds[static_cast<std::size_t>(d.kind)]);
    for (const std::size_t k : d.inputs) word("input", plan_.inputs[k].column);
    if (d.reference != nowhere) word("reference", plan_.inputs[d.reference].column);
    if (d.axial_load != nowhere) word("axial_load_input", plan_.inputs[d.axial_load].column);
    if (d.radial_load != nowhere) word("radial_load_input", plan_.inputs[d.radial_load].column);
    if (d.temperature != nowhere) word("temperature", plan_.inputs[d.temperature].column);
    if (d.window != nowhere) {
      word("window", plan_.inputs[d.window].column);
      word("window_acts_on", d.window_of_drive ? "input" : "displacement");
    }
    numbers(d, drive_numbers, d.window == nowhere ? "" : plan_.inputs[d.window].unit);
    if (d.kind != DriveKind::power) return;
    const ControlTable& t = plan_.tables[d.table];
    word("friction_table", t.file);
    if (d.axial_load == nowhere) number("axial_load", t.axial_load_N.front(), "N");
    const auto load = [](std::size_t input, double at, std::string_view direction) {
      return input == nowhere ? std::string() : fmt::format(" {:.15g} N {}", at, direction);
    };
    std::size_t k = 0;
    for (const double temperature : t.temperature_C)
      for (const double radial : t.radial_load_N)
        for (const double axial : t.axial_load_N)
          for (const double speed : t.speed_rpm)
            number(fmt::format("torque at {:.15g} rpm{}{} {:.15g} C", speed,
                               load(d.axial_load, axial, "axial"),
                               load(d.radial_load, radial, "radial"), temperature),
                   t.torque_Nmm[k++], "N mm");
  }

  void add_curve(const std::string& name, const ControlCurve& c, const std::string& unit,
                 const std::string& of) {
    if (c.kind == ControlCurve::Kind::table) {
      for (std::size_t k = 0; k < c.value.size(); ++k)
        number(fmt::format("{} at {:.15g} {}", name, c.input[k], of), c.value[k], unit);
    } else if (c.kind == ControlCurve::Kind::line) {
      number(name + " slope", c.factor, unit + "/" + of);
      number(name + " value_at_0", c.other, unit);
    } else {
      number(name + " factor", c.factor, unit);
      number(name + " exponent", c.other, "1");
    }
  }

  [[nodiscard]] std::string gain_unit(std::size_t drive) const {
    const std::string& unit = plan_.drives[drive].unit;
    return unit == "1" || unit.empty() ? "um" : "um/" + unit;
  }

  void add(const ControlAxis& a) {
    of_ = a.column;
    channel_ = "";
    part_ = "displacement";
    displacement_ = record::series_channel(a.column);
    for (const auto& f : axis_texts)
      if (!(a.*f.text).empty()) word(f.name, a.*f.text);
    numbers(a, axis_numbers);
    number("counts", a.counts ? 1 : 0, "1");
    for (std::size_t k = 0; k < a.sections.size(); ++k) {
      const ControlSection& s = a.sections[k];
      begin(s.channel, "section", k + 1);
      add_drive(s.drive);
      word("course", s.straight ? "straight" : "held");
      numbers(s, section_numbers, gain_unit(s.drive));
    }
    for (std::size_t k = 0; k < a.elements.size(); ++k) {
      const ControlElement& e = a.elements[k];
      begin(e.channel, "element", k + 1);
      add_drive(e.drive);
      const std::string& of = plan_.drives[e.drive].unit;
      numbers(e, element_numbers, of);
      add_curve("gain", e.gain_um, "um", of);
      add_curve("time_constant", e.time_constant_s, "s", of);
    }
    for (std::size_t k = 0; k < a.feedthroughs.size(); ++k) {
      begin(a.feedthroughs[k].channel, "feedthrough", k + 1);
      add_drive(a.feedthroughs[k].drive);
      numbers(a.feedthroughs[k], feedthrough_numbers, gain_unit(a.feedthroughs[k].drive));
    }
    for (std::size_t k = 0; k < a.equations.size(); ++k) {
      const ControlEquation& e = a.equations[k];
      begin(e.channel, "equation", k + 1);
      add_drive(e.drive);
      numbers(e, equation_numbers);
      const std::string unit = gain_unit(e.drive);
      for (std::size_t i = 0; i < e.numerator.size(); ++i)
        number(fmt::format("numerator {}", i), e.numerator[i], unit);
      for (std::size_t i = 1; i < e.denominator.size(); ++i)
        number(fmt::format("denominator {}", i), e.denominator[i], "1");
    }
    for (std::size_t k = 0; k < a.kinematics.size(); ++k) {
      begin("", "kinematic", k + 1);
      numbers(a.kinematics[k], kinematic_numbers);
    }
    displacement_ = nullptr;
  }

  void add(const ControlCheck::Row& r) {
    part_ = "check";
    channel_ = "";
    const std::string name = fmt::format("at {:.15g} s", r.time_s);
    for (std::size_t k = 0; k < r.inputs.size(); ++k) {
      of_ = plan_.inputs[k].column;
      number(name, r.inputs[k], plan_.inputs[k].unit);
    }
    for (std::size_t k = 0; k < r.displacements_um.size(); ++k) {
      of_ = plan_.axes[k].column;
      number(name, r.displacements_um[k], unit_of(plan_.axes[k]));
    }
  }

  const ControlPlan& plan_;
  fmt::memory_buffer out_;
  const record::Channel* displacement_ = nullptr;  // whose units are written
  std::string of_, channel_, part_;                // of the rows that are written
};

}  // namespace

std::string control_csv(const ControlPlan& plan) {
  bool elements = false, answers = false, equations = false;
  for (const ControlAxis& a : plan.axes) {
    elements = elements || !a.elements.empty();
    equations = equations || !a.equations.empty();
    for (const ControlSection& s : a.sections)
      answers = answers || s.direct != 0.0 || s.off_gain != 1.0 || s.off_time_constant != 1.0 ||
                s.speed_factor != 0.0 || s.falling != 1.0;
  }
  std::string text = fmt::format("{}\n{}", table_mark, control_heading(plan, "# "));
  text += formulas;
  if (!plan.together.empty()) text += together_formulas;
  if (answers) text += answer_formulas;
  if (elements) text += element_formulas;
  if (equations) text += equation_formulas;
  if (std::any_of(plan.inputs.begin(), plan.inputs.end(),
                  [](const ControlInput& in) { return !in.by_amount && !in.temperature; }))
    text += sign_formulas;
  if (std::any_of(plan.drives.begin(), plan.drives.end(),
                  [](const ControlDrive& d) { return d.window != nowhere; }))
    text += window_formulas;
  if (std::any_of(plan.drives.begin(), plan.drives.end(), [](const ControlDrive& d) {
        return d.axial_load != nowhere || d.radial_load != nowhere;
      }))
    text += load_formulas;
  return fmt::format("{}{}{}\n{}", text, schema, table_header, Table(plan).text());
}

}  // namespace raceway::control

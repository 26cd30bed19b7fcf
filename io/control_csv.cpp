#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/control_files.h"
#include "io/control_text.h"
#include "io/csv_text.h"

namespace raceway::io {
namespace {

using Kind = ControlDrive::Kind;

constexpr std::string_view formulas =
    R"(# One number a row. Displacements in um; temperatures in C, their rises in K; dt in s as measured.
# rise   u = mean of (T - T at the first call) of the inputs, less the same of the reference
# size   u = mean of the inputs x without their sign; with an exponent of x (x/1000)^(exponent - 1), x held at its highest
# power  u = torque of the friction table [N mm] / 1000 * speed [rpm] * pi/30, table straight between points, edge held
# motor  u = exp(-speed/decay_speed) while the speed is above 0, else 0
# section      s = s + (1 - exp(-dt/time_constant)) * (gain*u - s), s = 0 at first, u as it was at the call before;
#              where the course is straight, add weight * gain * (u now - u before),
#              weight = 1 - (1 - exp(-dt/time_constant))/(dt/time_constant)
# feedthrough  gain * u now
# kinematic    A * n^(1 - B*exp(-C*n)), n = speed without its sign [rpm], 0 at n = 0
# displacement = offset + sum of all of its sections, elements, feedthroughs and kinematics
# Beyond lowest and highest of an input: raise a flag; feedthrough and kinematic take the input at its limit,
#              what acts by its size (speeds, feeds, power) at its highest alone; motor takes the speed within both.
)";

constexpr std::string_view together_formulas =
    R"(# together     raise a flag where sqrt(sum of the squares of z) is above farthest; z of each of its inputs the sum of
#              weight * (input now - mean) over the inputs whose weights it has, sizes without their sign
)";

constexpr std::string_view answer_formulas =
    R"(# Section with more numbers, where f = 1/(1 + speed_factor*speed/10000), speed of the call before:
#   gain*u takes the factors f^gain_power and, where coolant_on was 0, off_gain; time_constant the factors f and,
#   where coolant_on was 0, off_time_constant, and falling where gain*u, mean of both calls, is nearer 0 than s.
#   It adds s + direct*(gain*u now - s), here gain without factors.
)";

constexpr std::string_view element_formulas =
    R"(# element      a section with gain K(P), 0 at P = 0, and time constant T(P), P the power u of the call before; it stands
#              still where P is below 0 or not below its limit. A line is slope*P + value_at_0, a power law
#              factor*P^exponent, a table straight between points, ends held
)";

class Table {
 public:
  explicit Table(const ControlPlan& plan) : plan_(plan) {}

  std::string text() {
    for (const ControlInput& in : plan_.inputs) {
      row(in.column, "", "input", "lowest", in.lowest, in.unit);
      row(in.column, "", "input", "highest", in.highest, in.unit);
      if (std::isnan(in.lowest)) word(in.column, "", "input", "range", "not known");
    }
    for (std::size_t k = 0; k < plan_.together.size(); ++k)
      add(plan_.together[k], fmt::format("together {}", k + 1));
    for (const ControlAxis& a : plan_.axes) add(a);
    return fmt::to_string(out_);
  }

 private:
  void put(std::string_view of, std::string_view channel, std::string_view part,
           std::string_view name, std::string_view value, std::string_view unit) {
    const auto out = std::back_inserter(out_);
    fmt::format_to(out, "{},", of);
    append_text(out_, channel);
    fmt::format_to(out, ",{},{},{},{}\n", part, name, value, unit);
  }
  void word(std::string_view of, std::string_view channel, std::string_view part,
            std::string_view name, std::string_view value) {
    put(of, channel, part, name, value, "");
  }
  void row(std::string_view of, std::string_view channel, std::string_view part,
           std::string_view name, double value, std::string_view unit) {
    if (!std::isnan(value)) put(of, channel, part, name, control_number(value, "none"), unit);
  }

  void add(const ControlTogether& t, const std::string& part) {
    for (std::size_t k = 0, at = 0; k < t.inputs.size(); ++k) {
      const std::string& of = plan_.inputs[t.inputs[k]].column;
      row(of, "", part, "mean", t.mean[k], plan_.inputs[t.inputs[k]].unit);
      for (std::size_t j = 0; j <= k; ++j, ++at)
        row(of, "", part, "weight of " + plan_.inputs[t.inputs[j]].column, t.weights[at], "");
    }
    row("", "", part, "farthest", t.farthest, "1");
  }

  void add_drive(const ControlAxis& a, const std::string& channel, const std::string& part,
                 std::size_t index) {
    const ControlDrive& d = plan_.drives[index];
    const auto say = [&](std::string_view name, std::string_view value) {
      word(a.column, channel, part, name, value);
    };
    constexpr std::string_view kinds[] = {"rise", "size", "power", "motor"};
    say("u", kinds[static_cast<std::size_t>(d.kind)]);
    for (const std::size_t k : d.inputs) say("input", plan_.inputs[k].column);
    if (d.reference != nowhere) say("reference", plan_.inputs[d.reference].column);
    if (d.exponent != 1.0) row(a.column, channel, part, "exponent", d.exponent, "1");
    if (d.kind == Kind::motor) row(a.column, channel, part, "decay_speed", d.decay_rpm, "rpm");
    if (d.kind != Kind::power) return;
    if (d.temperature != nowhere) say("temperature", plan_.inputs[d.temperature].column);
    row(a.column, channel, part, "lowest_power", d.lowest, "W");
    row(a.column, channel, part, "highest_power", d.highest, "W");
    const ControlTable& t = plan_.tables[d.table];
    for (std::size_t j = 0; j < t.temperature_C.size(); ++j)
      for (std::size_t k = 0; k < t.speed_rpm.size(); ++k)
        row(a.column, channel, part,
            fmt::format("torque at {:.15g} rpm {:.15g} C", t.speed_rpm[k], t.temperature_C[j]),
            t.torque_Nmm[j * t.speed_rpm.size() + k], "N mm");
  }

  void add(const ControlAxis& a, const ControlSection& s, std::size_t number) {
    const std::string part = fmt::format("section {}", number);
    add_drive(a, s.channel, part, s.drive);
    const auto put_number = [&](std::string_view name, double value, std::string_view unit) {
      row(a.column, s.channel, part, name, value, unit);
    };
    word(a.column, s.channel, part, "course", s.straight ? "straight" : "held");
    put_number("gain", s.gain, gain_unit(s.drive));
    put_number("time_constant", s.time_constant_s, "s");
    if (s.direct != 0.0) put_number("direct", s.direct, "1");
    if (s.off_gain != 1.0 || s.off_time_constant != 1.0) {
      put_number("off_gain", s.off_gain, "1");
      put_number("off_time_constant", s.off_time_constant, "1");
    }
    if (s.speed_factor != 0.0) {
      put_number("speed_factor", s.speed_factor, "1");
      put_number("gain_power", s.gain_power, "1");
    }
    if (s.falling != 1.0) put_number("falling", s.falling, "1");
  }

  void add_curve(const ControlAxis& a, const ControlElement& e, const std::string& part,
                 const std::string& name, const ControlCurve& c, const std::string& unit) {
    if (c.kind == ControlCurve::Kind::table) {
      for (std::size_t k = 0; k < c.value.size(); ++k)
        row(a.column, e.channel, part, fmt::format("{} at {:.15g} W", name, c.power_W[k]),
            c.value[k], unit);
    } else if (c.kind == ControlCurve::Kind::line) {
      row(a.column, e.channel, part, name + " slope", c.factor, unit + "/W");
      row(a.column, e.channel, part, name + " value_at_0", c.other, unit);
    } else {
      row(a.column, e.channel, part, name + " factor", c.factor, unit);
      row(a.column, e.channel, part, name + " exponent", c.other, "1");
    }
  }

  [[nodiscard]] std::string gain_unit(std::size_t drive) const {
    const std::string& unit = plan_.drives[drive].unit;
    return unit == "1" || unit.empty() ? "um" : "um/" + unit;
  }

  void add(const ControlAxis& a) {
    row(a.column, "", "displacement", "offset", a.offset_um, "um");
    std::size_t number = 0;
    for (const ControlSection& s : a.sections) add(a, s, ++number);
    number = 0;
    for (const ControlElement& e : a.elements) {
      const std::string part = fmt::format("element {}", ++number);
      add_drive(a, e.channel, part, e.drive);
      row(a.column, e.channel, part, "scale", e.scale, "1");
      add_curve(a, e, part, "gain", e.gain_um, "um");
      add_curve(a, e, part, "time_constant", e.time_constant_s, "s");
      row(a.column, e.channel, part, "power_limit", e.power_limit_W, "W");
    }
    number = 0;
    for (const ControlFeedthrough& f : a.feedthroughs) {
      const std::string part = fmt::format("feedthrough {}", ++number);
      add_drive(a, f.channel, part, f.drive);
      row(a.column, f.channel, part, "gain", f.gain, gain_unit(f.drive));
    }
    number = 0;
    for (const ControlKinematic& k : a.kinematics) {
      const std::string part = fmt::format("kinematic {}", ++number);
      row(a.column, "", part, "A", k.A_um, "um");
      row(a.column, "", part, "B", k.B, "1");
      row(a.column, "", part, "C", k.C_per_rpm, "1/rpm");
    }
  }

  const ControlPlan& plan_;
  fmt::memory_buffer out_;
};

}  // namespace

std::string control_csv(const ControlPlan& plan) {
  bool elements = false, answers = false;
  for (const ControlAxis& a : plan.axes) {
    elements = elements || !a.elements.empty();
    for (const ControlSection& s : a.sections)
      answers = answers || s.direct != 0.0 || s.off_gain != 1.0 || s.off_time_constant != 1.0 ||
                s.speed_factor != 0.0 || s.falling != 1.0;
  }
  std::string text = control_heading(plan, "# ");
  text += formulas;
  if (!plan.together.empty()) text += together_formulas;
  if (answers) text += answer_formulas;
  if (elements) text += element_formulas;
  return text + "of,channel,part,name,value,unit\n" + Table(plan).text();
}

}  // namespace raceway::io

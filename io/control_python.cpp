#include <fmt/format.h>

#include "io/control_files.h"
#include "io/control_text.h"

namespace raceway::io {
namespace {

constexpr std::string_view program = R"py(#!/usr/bin/env python3
@HEADING@#
# As a part of a control, once a second or at any pace:
#
#     correction = Correction()
#     displacements = correction.update(time.time(), {"speed_rpm": 3000, ...})  # um, by column
#     if correction.status: ...    # what is not as it should be: the names below
#     correction.save("state.json")               # now and then; after a restart:
#     correction.load("state.json")               # goes on as if the time between were a gap
#
# By hand over a record: python3 FILE RECORD.csv > corrected.csv
# Python 2.7 or 3, standard library alone.
from __future__ import division

import json
import math
import os


def section(drive, gain, time_constant, straight=False, direct=0.0, off_gain=1.0,
            off_time_constant=1.0, speed_factor=0.0, gain_power=1.0, falling=1.0):
    """A lag of gain times what drives it [um], with how it differs from a plain one."""
    return dict(locals())


STAMP = @STAMP@  # of the numbers below; a state of other numbers is refused

# column, unit, lowest and highest value that the numbers were found in (None: not known)
INPUTS = [
@INPUTS@]
# What the models have seen of inputs at once: places in INPUTS, their mean, rows of weights (one number
# more in each), and how large |weights (x - mean)| was at most.
TOGETHER = [
@TOGETHER@]
# Columns by their place in INPUTS. Of a power: friction torque [N mm] over temperature, then speed.
DRIVES = [
@DRIVES@]
# Gains in um per unit of the drive, time constants in s.
AXES = [
@AXES@]
SPEED = @SPEED@
COOLANT = @COOLANT@

# Bits of status.
BEYOND_RANGE = 1     # an input, named in `beyond`: instant parts are held at its limit
NO_VALUE = 2         # an input is missing or no number: its last good value holds
BEYOND_TABLE = 4     # a friction table: its edge holds
BEYOND_ELEMENT = 8   # a power that a delay element cannot take: it stands still
CLOCK = 16           # time did not go on: nothing moves until it does
NOT_STARTED = 32     # no call yet in which all inputs had a value: displacements are 0
BEYOND_TOGETHER = 64 # the inputs stand together as the model has never seen them


def is_number(value):
    try:
        return value - value == 0
    except TypeError:
        return False


def within(value, low, high):
    if low is not None and value < low:
        return low
    if high is not None and value > high:
        return high
    return value


def place_on(axis, value):
    """The point of an axis below a value, how far it is to the next one, and if it is on it."""
    if len(axis) < 2:
        return 0, 0.0, True
    if value <= axis[0]:
        return 0, 0.0, value == axis[0]
    if value >= axis[-1]:
        return len(axis) - 2, 1.0, value == axis[-1]
    k = 0
    while axis[k + 1] <= value:
        k += 1
    return k, (value - axis[k]) / (axis[k + 1] - axis[k]), True


def line_between(low, high, share):
    if share == 0.0:
        return low
    return low + share * (high - low)


def torque_Nmm(table, speed, temperature):
    i, share, on_speed = place_on(table["speed_rpm"], speed)
    j, warm_share, on_temperature = place_on(table["temperature_C"], temperature)

    def at(row):
        torque = table["torque_Nmm"][row]
        return line_between(torque[i], torque[min(i + 1, len(torque) - 1)], share)

    cold = at(j)
    torque = cold if warm_share == 0.0 else line_between(cold, at(j + 1), warm_share)
    return torque, on_speed and on_temperature


def curve(kind, numbers, power):
    """A gain or a time constant at a power."""
    if kind == "line":
        return numbers[0] * power + numbers[1]
    if kind == "power law":
        if power == 0.0 and numbers[1] < 0.0:
            return float("inf")
        return numbers[0] * power ** numbers[1]
    powers, values = numbers
    k, share, _ = place_on(powers, power)
    return line_between(values[k], values[min(k + 1, len(values) - 1)], share)


def rise_of(ratio):
    return -math.expm1(-ratio)  # 1 - exp(-x) without loss of digits


def weight_of(ratio):
    """1 - (1 - exp(-x))/x: what a straight course adds to the step of a lag."""
    if ratio < 1e-2:
        return ratio * (1 / 2 - ratio * (1 / 6 - ratio * (1 / 24 - ratio * (
            1 / 120 - ratio * (1 / 720 - ratio / 5040)))))
    return 1.0 - rise_of(ratio) / ratio


class Correction(object):
    """Displacements [um] from what a control knows, with all that it remembers."""

    def __init__(self):
        self.reset()

    def reset(self):
        """From rest, as cold as at the next call."""
        self.time = None
        self.first = None   # inputs at the first call, from which temperatures count
        self.last = None    # inputs at the last call
        self.states = [[0.0] * (len(a["sections"]) + len(a["elements"])) for a in AXES]
        self.zero = [0.0] * len(AXES)
        self.absolute = [0.0] * len(AXES)
        self.status = NOT_STARTED
        self.beyond = []

    def update(self, time, inputs):
        """Displacements now, by their columns; time in s, inputs by their columns."""
        self.status = 0
        values = self._values(inputs)
        if values is None:
            self.status |= NOT_STARTED
            return dict((a["displacement"], 0.0) for a in AXES)
        seen = self._within_range(values)
        step = 0.0
        if self.first is None:
            self.first = values
            self.last = values
        elif is_number(time) and is_number(self.time) and time > self.time:
            step = time - self.time
        else:
            self.status |= CLOCK
        if is_number(time):
            self.time = time
        drives = [self._drive(d, values) for d in DRIVES]
        self._see_powers(drives)
        seen_drives = self._seen_drives(seen)
        if step > 0.0:
            self._step(step, drives)
        self.last = values
        for k, axis in enumerate(AXES):
            self.absolute[k] = self._sum(axis, self.states[k], drives, seen_drives, seen)
        return dict((a["displacement"], y - zero)
                    for a, y, zero in zip(AXES, self.absolute, self.zero))

    def set_zero(self):
        """Counts displacements from where they are now, as after a touch-off."""
        self.zero = list(self.absolute)

    def state(self):
        """All that it remembers, for json."""
        return {"stamp": STAMP, "time": self.time, "first": self.first, "last": self.last,
                "states": self.states, "zero": self.zero}

    def restore(self, state):
        if state.get("stamp") != STAMP:
            raise ValueError("the state is of another model")
        self.reset()
        for name in ("time", "first", "last", "states", "zero"):
            setattr(self, name, state[name])

    def save(self, path):
        """A whole file or none, also where the power fails."""
        with open(path + ".new", "w") as out:
            json.dump(self.state(), out)
            out.flush()
            os.fsync(out.fileno())
        getattr(os, "replace", os.rename)(path + ".new", path)

    def load(self, path):
        with open(path) as text:
            self.restore(json.load(text))

    def _values(self, inputs):
        values = []
        for k, (column, unit, _, _) in enumerate(INPUTS):
            value = inputs.get(column)
            if not is_number(value):
                self.status |= NO_VALUE
                if self.last is None:
                    return None
                value = self.last[k]
            values.append(float(value) if unit == "C" else abs(float(value)))
        return values

    def _within_range(self, values):
        # Rest is known: what acts by its size is held at its highest alone.
        seen = [within(v, low if unit == "C" else None, high)
                for v, (_, unit, low, high) in zip(values, INPUTS)]
        self.beyond = [i[0] for i, v in zip(INPUTS, values) if v != within(v, i[2], i[3])]
        if self.beyond:
            self.status |= BEYOND_RANGE
        for places, mean, weights, farthest in TOGETHER:
            apart = [values[k] - m for k, m in zip(places, mean)]
            distance = math.sqrt(sum(
                sum(w * x for w, x in zip(row, apart)) ** 2 for row in weights))
            if distance > farthest * 1.0001:
                self.status |= BEYOND_TOGETHER
        return seen

    def _drive(self, drive, values):
        kind = drive["kind"]
        if kind == "rise":
            first = self.first
            u = sum(values[k] - first[k] for k in drive["inputs"]) / len(drive["inputs"])
            reference = drive["reference"]
            return u if reference is None else u - (values[reference] - first[reference])
        if kind == "size":
            sizes = [values[k] for k in drive["inputs"]]
            if drive["exponent"] != 1.0:
                sizes = [within(x, None, INPUTS[k][3]) for x, k in zip(sizes, drive["inputs"])]
                sizes = [x * (x / 1000.0) ** (drive["exponent"] - 1.0) if x > 0.0 else 0.0
                         for x in sizes]
            return sum(sizes) / len(sizes)
        speed = values[SPEED]
        if kind == "motor":
            turning = within(speed, INPUTS[SPEED][2], INPUTS[SPEED][3])
            return math.exp(-turning / drive["decay_rpm"]) if speed > 0.0 else 0.0
        temperature = drive["temperature_C"] if drive["temperature"] is None \
            else values[drive["temperature"]]
        torque, on_table = torque_Nmm(drive["table"], speed, temperature)
        if not on_table:
            self.status |= BEYOND_TABLE
        return torque * 1e-3 * speed * (math.pi / 30)

    def _seen_drives(self, seen):
        """Of inputs within their range, a power within its own too."""
        held = []
        for d in DRIVES:
            u = self._drive(d, seen)
            if d["kind"] == "power":
                u = within(u, None, d["highest"])
            held.append(u)
        return held

    def _see_powers(self, drives):
        for d, u in zip(DRIVES, drives):
            if d["kind"] == "power" and u != within(u, d["lowest"], d["highest"]):
                self.status |= BEYOND_RANGE
                if "power_W" not in self.beyond:
                    self.beyond.append("power_W")

    def _step(self, step, drives):
        status, beyond = self.status, list(self.beyond)
        last_seen = self._within_range(self.last)
        before = [self._drive(d, self.last) for d in DRIVES]
        before_seen = self._seen_drives(last_seen)
        speed = 0.0 if SPEED is None else last_seen[SPEED]
        off = COOLANT is not None and self.last[COOLANT] < 0.5
        for axis, states in zip(AXES, self.states):
            sections = axis["sections"]
            for k, s in enumerate(sections):
                states[k] += self._section_step(s, states[k], step, before[s["drive"]],
                                                drives[s["drive"]], speed, off)
            for k, e in enumerate(axis["elements"], len(sections)):
                states[k] += self._element_step(e, states[k], step, before_seen[e["drive"]])
        self.status, self.beyond = status, beyond  # of now, not of the call before

    @staticmethod
    def _section_step(s, state, step, before, after, speed, off):
        f = 1.0 / (1.0 + s["speed_factor"] * speed / 10000.0)
        gain = s["gain"] * f ** s["gain_power"] * (s["off_gain"] if off else 1.0)
        old = gain * before
        new = gain * after if s["straight"] else old
        time_constant = s["time_constant"] * f * (s["off_time_constant"] if off else 1.0)
        if (0.5 * (old + new) - state) * s["gain"] < 0.0:
            time_constant *= s["falling"]
        ratio = step / time_constant
        return rise_of(ratio) * (old - state) + weight_of(ratio) * (new - old)

    @staticmethod
    def _element_step(e, state, step, power):
        if not (power >= 0.0 and (e["power_limit"] is None or power < e["power_limit"])):
            return 0.0
        target = e["scale"] * curve(e["gain"][0], e["gain"][1], power) if power > 0.0 else 0.0
        time_constant = curve(e["time_constant"][0], e["time_constant"][1], power)
        return rise_of(step / time_constant) * (target - state)

    def _sum(self, axis, states, drives, seen_drives, seen):
        y = axis["offset"]
        for s, state in zip(axis["sections"], states):
            y += state
            if s["direct"] != 0.0:
                y += s["direct"] * (s["gain"] * seen_drives[s["drive"]] - state)
        for e, state in zip(axis["elements"], states[len(axis["sections"]):]):
            y += state
            power = seen_drives[e["drive"]]
            if power < 0.0 or (e["power_limit"] is not None and power >= e["power_limit"]):
                self.status |= BEYOND_ELEMENT
        for f in axis["feedthroughs"]:
            y += f["gain"] * seen_drives[f["drive"]]
        for law in axis["kinematics"]:
            n = seen[SPEED]
            if n > 0.0:
                y += law["A"] * math.exp((1.0 - law["B"] * math.exp(-law["C"] * n)) * math.log(n))
        return y


def run(record, out):
    """A record with a header line, rows in commas, time_s; a new run_id begins from rest."""
    import csv
    rows = csv.reader(record)
    names = [name.strip() for name in next(rows)]
    out.write("time_s,%s,status\n" % ",".join(a["displacement"] for a in AXES))
    correction, run_before = Correction(), None
    for cells in rows:
        row = {}
        for name, cell in zip(names, cells):
            try:
                row[name] = float(cell)
            except ValueError:
                pass  # empty: no value
        if row.get("run_id") != run_before:
            correction.reset()
            run_before = row.get("run_id")
        y = correction.update(row.get("time_s"), row)
        out.write("%.15g,%s,%d\n" % (row.get("time_s", float("nan")), ",".join(
            "%.12g" % y[a["displacement"]] for a in AXES), correction.status))


if __name__ == "__main__":
    import sys
    if len(sys.argv) != 2:
        sys.exit("usage: python3 %s RECORD.csv" % sys.argv[0])
    with open(sys.argv[1]) as record_file:
        run(record_file, sys.stdout)
)py";

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

std::string drive_text(const ControlDrive& d, const ControlPlan& plan) {
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
  std::string rows;
  for (std::size_t j = 0; j < t.temperature_C.size(); ++j) {
    const auto from = t.torque_Nmm.begin() + static_cast<std::ptrdiff_t>(j * t.speed_rpm.size());
    rows += fmt::format(
        "         {},\n",
        list(std::vector(from, from + static_cast<std::ptrdiff_t>(t.speed_rpm.size()))));
  }
  return fmt::format(
      "{{\"kind\": \"power\", \"temperature\": {}, \"temperature_C\": {}, \"lowest\": {}, "
      "\"highest\": {},\n     # of {}, at {:g} N\n     \"table\": {{\"speed_rpm\": {},\n"
      "      \"temperature_C\": {},\n      \"torque_Nmm\": [\n{}     ]}}}}",
      place(d.temperature), number(d.temperature_C), number(d.lowest), number(d.highest),
      harmless(t.file), t.axial_load_N, list(t.speed_rpm), list(t.temperature_C), rows);
}

std::string curve_text(const ControlCurve& c) {
  if (c.kind == ControlCurve::Kind::table)
    return fmt::format(R"(("table", [{}, {}]))", list(c.power_W), list(c.value));
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

std::string axis_text(const ControlAxis& a) {
  std::string text = fmt::format("    # {}\n    {{\"displacement\": \"{}\", \"offset\": {},\n",
                                 harmless(a.name), a.column, number(a.offset_um));
  text += "     \"sections\": [\n";
  for (const ControlSection& s : a.sections) text += section_text(s);
  text += "     ],\n     \"elements\": [\n";
  for (const ControlElement& e : a.elements)
    text += fmt::format(
        "         # {}; of gain [um] and time constant [s] over the power [W]\n"
        "         {{\"drive\": {}, \"scale\": {}, \"power_limit\": {},\n          \"gain\": {},\n"
        "          \"time_constant\": {}}},\n",
        harmless(e.channel), e.drive, number(e.scale), number(e.power_limit_W),
        curve_text(e.gain_um), curve_text(e.time_constant_s));
  text += "     ],\n     \"feedthroughs\": [\n";
  for (const ControlFeedthrough& f : a.feedthroughs)
    text += fmt::format("         {{\"drive\": {}, \"gain\": {}}},  # {}\n", f.drive,
                        number(f.gain), harmless(f.channel));
  text += "     ],\n     \"kinematics\": [\n";
  for (const ControlKinematic& k : a.kinematics)
    text += fmt::format("         {{\"A\": {}, \"B\": {}, \"C\": {}}},  # um, 1, 1/rpm\n",
                        number(k.A_um), number(k.B), number(k.C_per_rpm));
  return text + "     ]},\n";
}

}  // namespace

std::string control_python(const ControlPlan& plan) {
  std::string inputs, together, drives, axes;
  for (const ControlInput& in : plan.inputs)
    inputs += fmt::format("    (\"{}\", \"{}\", {}, {}),\n", in.column, in.unit, number(in.lowest),
                          number(in.highest));
  for (const ControlTogether& t : plan.together) together += together_text(t);
  for (const ControlDrive& d : plan.drives) drives += "    " + drive_text(d, plan) + ",\n";
  for (const ControlAxis& a : plan.axes) axes += axis_text(a);
  return filled(program, {{"HEADING", control_heading(plan, "# ")},
                          {"STAMP", fmt::format("{}", stamp(plan))},
                          {"INPUTS", inputs},
                          {"TOGETHER", together},
                          {"DRIVES", drives},
                          {"AXES", axes},
                          {"SPEED", place(plan.speed)},
                          {"COOLANT", place(plan.coolant)}});
}

}  // namespace raceway::io

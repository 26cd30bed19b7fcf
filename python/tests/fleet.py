"""Machines that were made up, each with numbers of its own, and last night's record of each.

The displacement is that of two lags, written down here once more in plain numpy: what is
identified is held against the numbers that were drawn, not against the program.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy

import raceway

NOISE_UM = 0.3
#: What a control begins with, the same for all: an old identification of some machine.
START = raceway.Correction.from_text(
    """
[correction]
displacement = "displacement_z_um"
tolerance_um = 1.0
measurement_std_um = 0.3
[[correction.channel]]
name = "spindle"
input = "front_bearing_temperature_C"
sections = [{ gain_um_K = 3.0, time_constant_s = 2400 }]
[[correction.channel]]
name = "ambient"
input = "ambient_temperature_C"
sections = [{ gain_um_K = -1.0, time_constant_s = 6000 }]
[calibration]
free = ["gains", "time_constants", "offset"]
""",
    "fleet",
)


@dataclass(frozen=True)
class Machine:
    """One machine: what was drawn, by the names of `raceway.Correction.parameters`, and its record."""

    truth: dict[str, float]
    record: raceway.Record


def lag(time_s: numpy.ndarray, u: numpy.ndarray, tau_s: float) -> numpy.ndarray:
    """Answer of tau dx/dt = u - x from x = 0 to an input that is straight between the rows.

    Between two rows x(t) = u(t) - tau s + c exp(-t/tau), s the slope of u: the particular solution and
    what is left of the state before.
    """
    t, inputs, x = time_s.tolist(), u.tolist(), [0.0]
    for k in range(1, len(t)):
        step = t[k] - t[k - 1]
        slope = (inputs[k] - inputs[k - 1]) / step
        c = x[-1] - (inputs[k - 1] - tau_s * slope)
        x.append(inputs[k] - tau_s * slope + c * math.exp(-step / tau_s))
    return numpy.array(x)


def machine(number: int) -> Machine:
    """Machine `number`: a warm-up, a pause, a second and a third load within 10 h, a row every minute or so."""
    draw = numpy.random.default_rng([18, number])
    time_s = numpy.cumsum(draw.uniform(50.0, 70.0, 600))
    time_s = numpy.round(time_s - time_s[0], 2)
    hours = time_s / 3600.0
    # The bearing follows the power with a lag of its own.
    loads = draw.uniform(4.0, 16.0, 4)
    speed = numpy.select([hours < 2.5, hours < 4.0, hours < 7.5], [loads[0], 0.0, loads[1]], loads[2] * 0.3)
    heated_C = 22.0 + 1.5 * lag(time_s, speed, draw.uniform(600.0, 1200.0))
    # A thermometer that never stands still; the machine follows what it shows.
    bearing_C = numpy.round(heated_C + draw.normal(0.0, 0.01, len(time_s)), 3)
    # Its day, and a gate that stands open for an hour and a half.
    day_C = draw.uniform(1.0, 3.0) * numpy.sin(2.0 * numpy.pi * (hours / draw.uniform(5.0, 9.0) + draw.uniform()))
    opened = draw.uniform(1.0, 6.0)
    gate_C = numpy.where((hours > opened) & (hours < opened + 1.5), -draw.uniform(4.0, 8.0), 0.0)
    room_C = numpy.round(22.0 + day_C + lag(time_s, gate_C, 400.0), 3)
    truth = {
        "spindle.gain_1": draw.uniform(2.0, 8.0),
        "spindle.time_constant_1": draw.uniform(1500.0, 4500.0),
        "ambient.gain_1": -draw.uniform(1.5, 4.0),
        "ambient.time_constant_1": draw.uniform(3000.0, 9000.0),
    }
    moved_um = truth["spindle.gain_1"] * lag(time_s, bearing_C - bearing_C[0], truth["spindle.time_constant_1"])
    moved_um += truth["ambient.gain_1"] * lag(time_s, room_C - room_C[0], truth["ambient.time_constant_1"])
    moved_um += draw.normal(0.0, NOISE_UM, len(time_s))
    rows = ["time_s,front_bearing_temperature_C,ambient_temperature_C,displacement_z_um"]
    rows += [f"{t:.2f},{b:.3f},{r:.3f},{z:.3f}" for t, b, r, z in zip(time_s, bearing_C, room_C, moved_um)]
    return Machine(truth, raceway.Record(f"machine-{number:04d}", "\n".join(rows) + "\n"))


def identify(made: Machine) -> dict[str, float]:
    """What a night asks of a machine: its lags from its record, with standard errors."""
    found = START.identify(made.record, order=1)
    numbers = {}
    for name, number in found.parameters.items():
        numbers[name] = number["value"]
        numbers[f"{name} std"] = number["std"]
    return numbers

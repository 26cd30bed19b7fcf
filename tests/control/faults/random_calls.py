"""Calls with random faults, each answer judged."""
import collections
import decimal
import fractions
import json
import math
import os
import random
import sys
import tempfile
import time
import traceback

from judge import Broken, Judge
from sensor import Sensor
from values import INF, NAN, NEVER, NOTHING, ODD, Array, Hostile, Scalar


def number_text(value):
    try:
        value = float(value) if not isinstance(value, (str, bytes)) and value is not None else NAN
    except Exception:
        value = NAN
    return "%.17g" % value


class Script(object):
    """Calls and answers, a line each, as faults.c reads them."""

    def __init__(self, module, path):
        self.m = module
        self.out = sys.stdout if path == "-" else open(path, "w")

    def line(self, *words):
        self.out.write(" ".join(words) + "\n")

    def call(self, t, inputs, enable, offsets, status):
        self.line(
            "g",
            number_text(t),
            "1" if enable else "0",
            *([number_text(inputs.get(i[0])) for i in self.m.INPUTS] + ["%.17g" % offsets[a["displacement"]] for a in self.m.AXES] + [str(status)]),
        )


def random_run(m, ticks, seed, script=None):
    rng = random.Random(seed)
    counts = collections.Counter()
    judge = Judge(m, counts)
    out = Script(m, script) if script else None
    c = m.Correction()
    sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
    columns = [s.column for s in sensors]
    wall = 1.7e9 if rng.random() < 0.5 else 0.0
    guarded = all(g["plausible"][0] is not None for g in m.GUARDS)
    recovery = m.HOLD + m.FADE + max(2 * a["limit"] / a["slew"] for a in m.AXES) + 3 * m.LONGEST_GAP
    phase, phase_left, nominal, enable, victim = "calm", 0.0, 1.0, True, None
    wanted = None
    folder = tempfile.mkdtemp()
    state_path = os.path.join(folder, "state")
    tick = -1
    began = time.time()
    kinds = ["nothing", "never", "implausible", "spike", "step", "stuck", "either"]
    if not script:
        kinds.append("odd")
    if script:
        kinds.remove("either")
    try:
        for tick in range(ticks):
            if phase_left <= 0:
                phase = rng.choice(["calm", "few", "few", "storm", "long", "clocks"])
                slowest = 0.9 * m.LONGEST_GAP
                nominal = 10 ** rng.uniform(math.log10(min(slowest, recovery / 2000)), math.log10(slowest))
                if rng.random() < 0.1:
                    nominal = 10 ** rng.uniform(-3, -1)
                phase_left = rng.uniform(0.2, 1.5) * recovery
                if phase == "storm":
                    phase_left *= 0.3
                if phase == "long":
                    victim = rng.choice(sensors)
                    phase_left = recovery * 1.2
                    wanted = rng.choice(["nothing", "never", "implausible", "stuck"])
                phase_left = min(phase_left, 2500 * nominal)
                counts["phase: " + phase] += 1
            dt = nominal * rng.uniform(0.7, 1.3)
            dt = min(dt, m.LONGEST_GAP)
            phase_left -= dt
            rate = {"calm": 0.0, "few": 0.003, "storm": 0.15, "long": 0.0005, "clocks": 0.0}[phase]
            # The clock.
            wall += dt
            t = wall
            if rng.random() < {"calm": 0.0, "few": 0.002, "storm": 0.1, "long": 0.0005, "clocks": 0.3}[phase]:
                what = rng.choice(["stand", "back", "nan", "nan", "gap", "edge", "far", "set"])
                counts["clock event: " + what] += 1
                if what == "stand" and judge.time is not None:
                    t = wall = judge.time
                elif what == "back":
                    wall -= 10 ** rng.uniform(-3, 5)
                    t = wall
                elif what == "nan":
                    t = (
                        rng.choice([NAN, NAN, INF, -INF, None])
                        if script
                        else rng.choice(
                            [
                                NAN,
                                INF,
                                -INF,
                                None,
                                "12",
                                [],
                                1j,
                                10**400,
                                Hostile(),
                                Array(),
                                decimal.Decimal("sNaN"),
                                decimal.Decimal(repr(wall)),
                                fractions.Fraction(wall),
                                Scalar(wall),
                            ]
                        )
                    )
                    if script and judge.time is None:
                        t = wall
                elif what == "gap":
                    wall += rng.uniform(m.LONGEST_GAP, max(m.LONGEST_GAP, m.CLOCK_JUMP - m.LONGEST_GAP))
                    t = wall
                elif what == "edge" and judge.time is not None:
                    t = wall = judge.time + rng.choice([m.LONGEST_GAP, m.CLOCK_JUMP, m.LONGEST_GAP * (1 + 1e-9)])
                elif what == "far":
                    wall += m.CLOCK_JUMP * rng.uniform(1.01, 20)
                    t = wall
                elif what == "set" and not script:
                    t = wall = rng.choice([1e5, 1.7e9, -1e6, 1e12])
            # Inputs.
            if phase == "long" and victim.fault is None:
                victim.begin(wanted, 10**6)
            if phase != "long" and victim is not None:
                victim.fault = victim.stuck_at = victim = None
            inputs = {}
            for s in sensors:
                if s.fault is None and rng.random() < rate:
                    kind = rng.choice(kinds)
                    length = 1 if rng.random() < 0.6 else int(10 ** rng.uniform(0, 2.5))
                    if kind == "stuck":
                        length = int((s.guard["stuck"] or 100) / nominal * rng.uniform(0.5, 2)) + 1
                    s.begin(kind, length)
                    counts["event: " + kind] += 1
                value = s.read(dt)
                if value is None and rng.random() < 0.5:
                    continue
                if not guarded and not script and rng.random() < rate * 0.001:
                    value = rng.choice([1e308, 1e200, -1e308, 1e150])
                inputs[s.column] = value
            if rng.random() < rate:
                inputs["unknown_key"] = rng.choice(NOTHING + NEVER + ODD)
            if rng.random() < rate * 0.3 + 0.0005:
                enable = not enable
                counts["event: enable"] += 1
            offsets = c.update(t, inputs, enable)
            judge.judge(t, inputs, enable, offsets, c)
            if out:
                out.call(t, inputs, enable, offsets, c.status)
            # What the control does between calls.
            act = rng.random()
            if act < 0.0006 + rate * 0.02:
                counts["event: touch-off"] += 1
                some = None if rng.random() < 0.5 else rng.sample([a["displacement"] for a in m.AXES], 1)
                if judge.started:
                    c.touch_off(some)
                    for k, a in enumerate(m.AXES):
                        if some is None or a["displacement"] in some:
                            judge.touched(k, c)
                            if out:
                                out.line("t", str(k))
            elif act < 0.0016 + rate * 0.04:
                counts["event: restart"] += 1
                kept = json.dumps(c.state(), sort_keys=True)
                c.save(state_path)
                c = m.Correction()
                c.load(state_path)
                if json.dumps(c.state(), sort_keys=True) != kept:
                    judge.fail("the state after load() differs: %s and %s", json.dumps(c.state(), sort_keys=True), kept)
                judge.restarted = c.time is not None or not script
                if out:
                    out.line("r")
                if rng.random() < 0.5:
                    wall += rng.choice([0.1, 1.0, 20.0, 1e3, 1e5]) * rng.random()
                if rng.random() < 0.2:
                    counts["event: applied"] += 1
                    moved = {}
                    for k, a in enumerate(m.AXES):
                        size = a["limit"] * rng.choice([0.3, 0.3, 1.0, 1.2]) / a["unit_um"]
                        value = rng.uniform(-size, size)
                        if a["counts"]:
                            value = int(value)
                        if rng.random() < 0.2:
                            value = rng.choice(NOTHING + ([] if script else NEVER))
                        moved[a["displacement"]] = value
                        judge.applied(k, value)
                    c.applied(moved)
                    if out:
                        out.line("a", *[number_text(moved[a["displacement"]]) for a in m.AXES])
            elif act < 0.00165 or (judge.poisoned and act > 0.99):
                counts["event: from rest"] += 1
                c.reset()
                judge.begin()
                if out:
                    out.line("z")
    except Broken as broken:
        print("faults: %s: tick %d, seed %d: %s" % (os.path.basename(m.__file__), tick, seed, broken), file=sys.stderr)
        return 1
    except Exception as error:
        at = traceback.extract_tb(sys.exc_info()[2])[-1]
        print(
            "faults: %s: tick %d, seed %d: %s: %s escapes, in %s (line %d) of %s"
            % (os.path.basename(m.__file__), tick, seed, type(error).__name__, error, at.name, at.lineno, os.path.basename(at.filename)),
            file=sys.stderr,
        )
        print("  t %r inputs %r" % (t, inputs), file=sys.stderr)
        return 1
    finally:
        for name in os.listdir(folder):
            os.remove(os.path.join(folder, name))
        os.rmdir(folder)
    if out:
        out.out.flush()
    print(
        "faults: %s: %d ticks, seed %d, %.1f s; %s"
        % (os.path.basename(m.__file__), ticks, seed, time.time() - began, ", ".join("%s %d" % (k, counts[k]) for k in sorted(counts))),
        file=sys.stderr if script == "-" else sys.stdout,
    )
    return 0

"""An exported correction among faults, judged from outside: what a control may rely on, whatever it is given.

    faults.py PROGRAM.py TICKS SEED           random faults; the first broken promise ends it
        --script FILE                         writes the calls and their answers for faults.c (- is stdout)
    faults.py PROGRAM.py --steps              save() is killed at each of its steps, in pieces of bytes
    faults.py PROGRAM.py --kill TIMES SEED    a machine that ticks and saves is killed at any moment
    faults.py PROGRAM.py --odd                one odd value after the other, and what it leaves behind
    faults.py PROGRAM.py --speed              time of a call
    faults.py --models FOLDER                 writes model files that have all that an export may have

Status 1 and one line at the first promise that is broken. Standard library alone.
"""
from __future__ import print_function

import collections
import datetime
import decimal
import fractions
import importlib.util
import json
import math
import os
import random
import signal
import sys
import tempfile
import time

NAN, INF = float("nan"), float("inf")

class Broken(Exception):
    pass


def imported(path):
    spec = importlib.util.spec_from_file_location("exported", path)
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


def is_real(value):
    """What every control would call a number; the rest is a fault, but for ODD types, which may be either."""
    return isinstance(value, (int, float)) and -1e300 < value < 1e300


class Array(object):
    """As an array of numpy with two values: comparisons give arrays, which have no truth."""

    def __sub__(self, other):
        return Array()
    __rsub__ = __add__ = __mul__ = __sub__

    def __eq__(self, other):
        return Array()
    __lt__ = __gt__ = __le__ = __ge__ = __ne__ = __eq__
    __hash__ = None

    def __bool__(self):
        raise ValueError("the truth value of an array is ambiguous")
    __nonzero__ = __bool__


class Hostile(object):
    def __sub__(self, other):
        raise RuntimeError("no")
    __float__ = __sub__


class NoFloat(object):
    """Subtracts as a number, and is none."""

    def __sub__(self, other):
        return 0


class Scalar(object):
    """As a float32 of numpy: a number in all, which json does not know."""

    def __init__(self, value):
        self.value = value

    def __float__(self):
        return self.value

    def __sub__(self, other):
        return self.value - float(other)

    def __rsub__(self, other):
        return float(other) - self.value

    def __lt__(self, other):
        return self.value < other

    def __gt__(self, other):
        return self.value > other

    def __le__(self, other):
        return self.value <= other

    def __ge__(self, other):
        return self.value >= other

    def __mul__(self, other):
        return self.value * other


NOTHING = [None, NAN, INF, -INF]
NEVER = ["25.3", "", b"25", [], [25.0], {}, (1,), set(), datetime.datetime(2024, 1, 1), object(), float]
ODD = [1j, 25 + 0j, decimal.Decimal("NaN"), decimal.Decimal("sNaN"), decimal.Decimal("Infinity"), Array(),
       Hostile(), NoFloat(), 10 ** 400, -10 ** 400, fractions.Fraction(10 ** 400, 3)]
EITHER = [True, False, decimal.Decimal("25.3"), fractions.Fraction(51, 2), Scalar(25.25), -0.0, 0, 5e-324]


class Sensor(object):
    """An input as it truly is: slow, never still, within what it can be; and what a fault makes of it."""

    def __init__(self, rng, module, k):
        self.rng = rng
        self.column, self.unit, low, high = module.INPUTS[k]
        self.guard = module.GUARDS[k]
        plausible = self.guard["plausible"]
        low = 15.0 if low is None else low
        high = (45.0 if self.unit == "C" else 3000.0) if high is None else high
        if self.unit != "C":
            low = max(low, 0.0)
        if plausible[0] is not None:
            low, high = max(low, plausible[0]), min(high, plausible[1])
        self.low, self.high = low, high
        self.value = self.goal = rng.uniform(low, high)
        self.fault, self.left, self.shift, self.stuck_at = None, 0, 0.0, None
        self.switch = self.column == "coolant_on"

    def true(self, dt):
        rng, fastest = self.rng, self.guard["fastest"]
        if rng.random() < 0.01:
            self.goal = rng.uniform(self.low, self.high)
        if self.switch:
            self.value = 1.0 if self.goal > 0.5 * (self.low + self.high) else 0.0
            return self.value
        most = 0.05 * (self.high - self.low) * dt / 60 if self.unit == "C" else INF
        if fastest is not None:
            most = min(most, 0.2 * fastest * dt)
        self.value += max(-most, min(most, self.goal - self.value))
        dither = 1e-4 if self.unit == "C" or self.guard["stuck"] is not None else 0.0
        return self.value + self.shift + dither * rng.random()

    def begin(self, kind, ticks):
        self.fault, self.left = kind, ticks

    def read(self, dt):
        value = self.true(dt)
        if self.fault is None:
            return value
        self.left -= 1
        kind = self.fault
        if self.left <= 0:
            self.fault = None
        rng = self.rng
        if kind == "nothing":
            return rng.choice(NOTHING)
        if kind == "never":
            return rng.choice(NEVER)
        if kind == "odd":
            return rng.choice(ODD)
        if kind == "either":
            return rng.choice(EITHER)
        if kind == "implausible":
            p = self.guard["plausible"]
            if p[0] is None:
                return value
            if self.unit == "C":
                return rng.choice([p[0] - 1e-6, p[1] + 1e-6, p[0] - 1e4, p[1] * 3, 1e308, -1e308, 1e30, 850.0, 10 ** 12])
            return rng.choice([-1, 1]) * rng.choice([p[1] + 1e-6, p[1] * 3 + 1, 1e308, 1e30, 10 ** 12])
        if kind == "spike":
            return value + rng.choice([-1, 1]) * rng.choice([0.1, 1, 10, 30]) * (
                self.guard["fastest"] or 0.1 * (self.high - self.low))
        if kind == "step":
            self.shift = 0.0 if self.shift else rng.uniform(-8, 8) * (self.guard["fastest"] or 0.0)
            self.fault = None
            return value
        if kind == "stuck":
            if self.stuck_at is None:
                self.stuck_at = value
            stood = self.stuck_at
            if self.fault is None:
                self.stuck_at = None
            return stood
        if kind == "range":  # beyond what the model has seen, and no fault
            return value
        raise AssertionError(kind)


class Judge(object):
    """Own bookkeeping of what an offset may do, from the promises; knows of the program what it is asked alone."""

    def __init__(self, module, counts):
        self.m, self.counts = module, counts
        self.axes, self.inputs = module.AXES, module.INPUTS
        self.words = dict(module.WORDS)
        self.begin()

    def begin(self):
        n = len(self.axes)
        self.time = None            # last that was a number
        self.restarted = self.waits = False
        self.offset = [0.0] * n     # in units, as handed out last
        self.slack = [0.0] * n      # [um] of the next call: what was applied may differ by a count
        self.above = [0.0] * n      # [um] that the control has applied beyond the limit
        self.believed = [None] * len(self.inputs)
        self.since = [(0.0, 0.0)] * len(self.inputs)  # since it was believed, by the clock and at most a gap each
        self.raw = [None] * len(self.inputs)
        self.same = [(0.0, 0.0)] * len(self.inputs)   # for how long it has stood, at least and at most
        self.started = False
        self.untrusted, self.doubt = [0.0] * n, [0.0] * n
        self.reference = [(0.0, 0.0, 0.0)] * n  # displacement, offset, in how far that is known [um]
        self.safe = [None] * n      # offset [um] that good inputs gave last, None: not known
        self.bad = [0.0] * n        # for how long inputs of the axis have been at fault [s]
        self.poisoned = False       # a number without limits was believed

    def fail(self, text, *values):
        raise Broken(text % values)

    def clock(self, t, status):
        """What the call may move for [s], and what the clock showed."""
        m = self.m
        restarted, self.restarted = self.restarted, False
        if self.waits:  # for a clock, since a restart: whether it still is the first call is not promised
            restarted = bool(status & m.RESTARTED)
        real = is_real(t)
        odd = not real and not isinstance(t, (int, float, type(None), str))
        if odd and isinstance(t, (decimal.Decimal, fractions.Fraction, Scalar)) and not status & m.CLOCK:
            t, real = float(t), True
        expected = m.RESTARTED if restarted else 0
        self.waits = restarted and not real
        gap = 0.0
        step = 0.0
        if not real:
            expected |= m.CLOCK
        else:
            before, self.time = self.time, t
            if before is not None:
                step = t - before
                if step <= 0 or (step > m.CLOCK_JUMP and not restarted):
                    expected |= m.CLOCK
                    step = 0.0
                elif restarted:
                    expected |= m.OFF if step > m.LONGEST_GAP else 0
                else:
                    expected |= m.LATE if step > m.LONGEST_GAP else 0
                    gap = min(step, m.LONGEST_GAP)
        mask = m.CLOCK | m.LATE | m.OFF | m.RESTARTED
        if status & mask != expected:
            self.fail("the clock showed %r after %r: status %d, expected %d", t, self.time, status & mask, expected)
        for name in ("CLOCK", "LATE", "OFF", "RESTARTED"):
            if expected & getattr(m, name):
                self.counts["clock: " + self.words[getattr(m, name)]] += 1
        return gap, step, expected

    def inputs_of(self, inputs, faults, gap, step, clock):
        m = self.m
        bits = 0
        for column in faults:
            if column not in [i[0] for i in self.inputs]:
                self.fail("faults names %r, which is no input", column)
        for k, (column, unit, _, _) in enumerate(self.inputs):
            value, guard, said = inputs.get(column), m.GUARDS[k], faults.get(column)
            # Across a restart without a clock nobody knows for how long it was off.
            passed = 1e12 if clock & m.RESTARTED and clock & m.CLOCK else max(step, gap)
            since = self.since[k] = (self.since[k][0] + passed, self.since[k][1] + gap)
            same = self.same[k] = (self.same[k][0], self.same[k][1] + gap)
            real = is_real(value)
            either = any(value is e for e in EITHER) and not isinstance(value, (int, float))
            must, may = None, ()
            if either and said != self.words[m.NO_VALUE]:
                value, real = float(value), True
            huge = isinstance(value, (int, float)) and not real and value - value == 0
            if huge and isinstance(value, float):
                real = True
            if not real:
                must = m.NO_VALUE
                if huge:
                    must, may = None, (m.NO_VALUE, m.IMPLAUSIBLE)
            else:
                v = float(value) if unit == "C" else abs(float(value))
                if v == self.raw[k]:
                    same = self.same[k] = (same[0] + gap, same[1])
                else:
                    self.raw[k], self.same[k] = v, (0.0, 0.0)
                    same = self.same[k]
                if abs(v) > 1e9:  # may be taken, or not
                    may += (m.IMPLAUSIBLE,)
                low, high = guard["plausible"]
                good = self.believed[k]
                if low is not None and not low <= v <= high:
                    must = m.IMPLAUSIBLE
                elif guard["stuck"] is not None and same[0] >= guard["stuck"] + max(gap, 1e-9):
                    must = m.STUCK
                else:
                    if guard["stuck"] is not None and same[1] >= guard["stuck"] - 1e-6:
                        may += (m.STUCK,)
                    if guard["fastest"] is not None and good is not None and self.started:
                        change = abs(v - good)
                        if change > guard["fastest"] * (since[0] + 3.0) + 1e-9:
                            must = m.JUMPED
                            if m.STUCK in may and must:
                                must, may = None, may + (m.JUMPED,)
                        elif change > guard["fastest"] * since[1]:
                            may += (m.JUMPED,)
                    elif guard["fastest"] is not None:
                        may += (m.JUMPED,) if good is not None else ()
            if must and said != self.words[must]:
                self.fail("%s = %r (believed %r, %.6g s ago) is %s; faults say %r", column, value, self.believed[k],
                          since[0], self.words[must], said)
            if said and not must and said not in [self.words[b] for b in may]:
                self.fail("%s = %r (believed %r) is called %s, and is well", column, value, self.believed[k], said)
            if said:
                bit = [b for b, w in self.words.items() if w == said][0]
                bits |= bit
                self.counts["input: " + said] += 1
            else:
                self.believed[k], self.since[k] = v, (0.0, 0.0)
                if abs(v) > 1e9:
                    self.poisoned = True
                if isinstance(value, bool) or either:
                    self.counts["input: odd, taken as a number"] += 1
        if not self.started:
            if faults:
                self.believed = [None] * len(self.inputs)
            else:
                self.started = True  # all of them at once, for the first time
        return bits

    def judge(self, t, inputs, enable, offsets, correction):
        m, status = self.m, correction.status
        was_time = self.time
        gap, step, clock = self.clock(t, status)
        if clock & m.OFF and m.RESTART == "rest":  # all but offsets is forgotten
            kept = self.offset, self.above, self.time, self.slack
            self.begin()
            self.offset, self.above, self.time, self.slack = kept
        was_started = self.started
        bits = self.inputs_of(inputs, correction.faults, gap, step, clock)
        mask = m.NO_VALUE | m.IMPLAUSIBLE | m.JUMPED | m.STUCK
        if status & mask != bits:
            self.fail("status has faults %d, faults are %r", status & mask, correction.faults)
        if bool(status & m.NOT_STARTED) == self.started:
            self.fail("status %d: started is %r", status, self.started)
        if bool(status & m.DISABLED_NOW) == bool(enable):
            self.fail("status %d: enable is %r", status, enable)
        if correction.alarm != bool(status & m.ALARMS):
            self.fail("alarm is %r, status %d", correction.alarm, status)
        if (bits or clock & (m.CLOCK | m.LATE)) and not correction.alarm:
            self.fail("no alarm at status %d", status)
        if sorted(correction.status_words()) != sorted(w for b, w in self.words.items() if status & b):
            self.fail("words %r of status %d", correction.status_words(), status)
        if set(offsets) != set(a["displacement"] for a in self.axes):
            self.fail("offsets %r", offsets)
        must_doubt = may_doubt = limited = False
        any_above = any(self.above)
        for k, axis in enumerate(self.axes):
            now, before, unit = offsets[axis["displacement"]], self.offset[k], axis["unit_um"]
            count = unit if axis["counts"] else 0.0
            name = axis["displacement"]
            if not isinstance(now, (int, float)) or now - now != 0:
                self.fail("offset of %s is %r", name, now)
            if count and now != int(now):
                self.fail("offset of %s is %r counts", name, now)
            um, was = now * unit, before * unit
            fine = 1e-9 * (1.0 + abs(was))
            # The limit.
            beyond = abs(um) - axis["limit"] * (1 + 1e-14)  # 7 counts of 0.1 are 0.7000000000000001
            if beyond > 0 and abs(um) > max(self.above[k], 0.0) + fine:
                self.fail("offset of %s is %.17g um, limit %.17g um", name, um, axis["limit"])
            # The slew.
            reach = axis["slew"] * gap
            moved = abs(um - was)
            if gap == 0.0 and moved > self.slack[k] + (fine if self.above[k] else 0.0):
                self.fail("offset of %s moved from %.17g to %.17g um in a call without time", name, was, um)
            if moved > reach + (2 * count if self.above[k] else count) + fine + self.slack[k]:
                self.fail("offset of %s moved by %.9g um in %.9g s, slew %g um/s", name, moved, gap, axis["slew"])
            was_above = self.above[k]
            if was_above:
                self.above[k] = abs(um) + count if abs(um) > axis["limit"] - count else 0.0
            # Trust.
            at_fault = any(self.inputs[i][0] in correction.faults for i in axis["inputs"]) or self.poisoned
            if self.started:
                self.untrusted[k] = self.untrusted[k] + gap if at_fault else 0.0
                if at_fault and self.untrusted[k] > m.HOLD and m.ON_FAULT != "hold":
                    self.doubt[k] = min(1.0, self.doubt[k] + gap / m.FADE)
                elif not at_fault:
                    self.doubt[k] = max(0.0, self.doubt[k] - gap / m.FADE)
                must_doubt |= self.untrusted[k] > m.HOLD + 1e-6 or self.doubt[k] > 1e-6
                may_doubt |= self.untrusted[k] > m.HOLD - 1e-6 or self.doubt[k] > 0.0
            self.bad[k] = self.bad[k] + gap if at_fault and enable else 0.0
            trusted = not at_fault and self.doubt[k] == 0.0
            # Where it goes.
            displacement = correction.absolute[k]
            at, there, known = self.reference[k]
            asked = there + axis["sign"] * (displacement - at)
            target = max(-axis["limit"], min(axis["limit"], asked))
            limited |= abs(asked) > axis["limit"] - known - 1e-6
            tolerance = known + 1.5 * count + fine + self.slack[k]
            if not enable:
                if m.DISABLED == "zero" and not was_above and \
                        abs(um) > max(0.0, abs(was) - reach) + 1.5 * count + fine + self.slack[k]:
                    self.fail("disabled: offset of %s goes from %.9g to %.9g um in %.9g s (status %d)", name, was, um,
                              gap, status)
                if m.DISABLED == "freeze" and moved > fine + self.slack[k] and not was_above:
                    self.fail("frozen: offset of %s goes from %.9g to %.9g um", name, was, um)
            elif trusted and self.started and not self.poisoned:
                if abs(um - target) > max(0.0, abs(was - target) - reach) + tolerance:
                    self.fail("offset of %s is %.9g um, asked for %.9g um, was %.9g um, %.9g s (status %d)", name, um,
                              target, was, gap, status)
            if trusted and self.started:
                self.safe[k] = None if self.poisoned else target
            elif self.safe[k] is not None and enable and not self.poisoned and self.started:
                # All of its time to fade and to travel has passed.
                home = {"last-safe": self.safe[k], "zero": 0.0}.get(m.ON_FAULT)
                if home is not None and self.bad[k] > m.HOLD + m.FADE + 2 * axis["limit"] / axis["slew"] + 2 * m.LONGEST_GAP:
                    self.counts["faded out"] += 1
                    if abs(um - home) > known + count + fine + self.slack[k]:
                        self.fail("faded: offset of %s is %.9g um, should be %.9g um", name, um, home)
            self.offset[k], self.slack[k] = now, 0.0
        if not may_doubt and status & m.UNTRUSTED or must_doubt and not status & m.UNTRUSTED:
            self.fail("status %d: untrusted for %r s, doubt %r", status, self.untrusted, self.doubt)
        if status & m.LIMITED and not limited and not self.poisoned and not may_doubt and not any_above:
            self.fail("status %d: LIMITED, and nothing is at its limit", status)
        self.counts["status: alarm" if correction.alarm else "status: no alarm"] += 1
        if correction.alarm and not bits and not clock & (m.CLOCK | m.LATE) and not may_doubt and \
                not status & (m.LIMITED | m.BEYOND_ELEMENT):
            self.fail("alarm without cause: status %d %r", status, correction.status_words())
        if must_doubt:
            self.counts["untrusted"] += 1
        if limited:
            self.counts["at a limit"] += 1
        return was_time, was_started

    def touched(self, k, correction):
        """Offsets count from here."""
        keep = self.m.TOUCH_OFF == "keep"
        axis = self.axes[k]
        um, self.bad[k] = self.offset[k] * axis["unit_um"], 0.0
        self.reference[k] = (correction.absolute[k], um if keep else 0.0,
                             (axis["unit_um"] if axis["counts"] else 0.0) if keep else 0.0)
        self.safe[k] = max(-axis["limit"], min(axis["limit"], um)) if keep else 0.0

    def applied(self, k, value):
        axis = self.axes[k]
        if not is_real(value):
            return
        um, was = value * axis["unit_um"], self.offset[k] * axis["unit_um"]
        if axis["counts"]:
            self.slack[k] = 1.0 * axis["unit_um"]
            if abs(um - was) <= 1.6 * axis["unit_um"]:  # may be what was rounded
                self.slack[k] = abs(um - was) + axis["unit_um"]
        self.offset[k], self.bad[k] = value, 0.0
        self.above[k] = abs(um) * (1 + 1e-12) if abs(um) > axis["limit"] else 0.0


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
        self.line("g", number_text(t), "1" if enable else "0",
                  *([number_text(inputs.get(i[0])) for i in self.m.INPUTS] +
                    ["%.17g" % offsets[a["displacement"]] for a in self.m.AXES] + [str(status)]))


def random_run(path, ticks, seed, script=None):
    m = imported(path)
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
                    t = rng.choice([NAN, NAN, INF, -INF, None]) if script else rng.choice(
                        [NAN, INF, -INF, None, "12", [], 1j, 10 ** 400, Hostile(), Array(), decimal.Decimal("sNaN"),
                         decimal.Decimal(repr(wall)), fractions.Fraction(wall), Scalar(wall)])
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
                victim.begin(wanted, 10 ** 6)
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
        print("faults: %s: tick %d, seed %d: %s" % (os.path.basename(path), tick, seed, broken), file=sys.stderr)
        return 1
    except Exception as error:
        import traceback
        at = traceback.extract_tb(sys.exc_info()[2])[-1]
        print("faults: %s: tick %d, seed %d: %s: %s escapes, in %s (line %d) of %s" % (
            os.path.basename(path), tick, seed, type(error).__name__, error, at.name, at.lineno,
            os.path.basename(at.filename)), file=sys.stderr)
        print("  t %r inputs %r" % (t, inputs), file=sys.stderr)
        return 1
    finally:
        for name in os.listdir(folder):
            os.remove(os.path.join(folder, name))
        os.rmdir(folder)
    if out:
        out.out.flush()
    print("faults: %s: %d ticks, seed %d, %.1f s; %s" % (
        os.path.basename(path), ticks, seed, time.time() - began,
        ", ".join("%s %d" % (k, counts[k]) for k in sorted(counts))), file=sys.stderr if script == "-" else sys.stdout)
    return 0


# Stops of the power, or of the process.

class Steps(object):
    """Kills this process at its n-th step, or writes down which steps there are."""

    def __init__(self, last, trace):
        self.count, self.last, self.trace = 0, last, trace

    def step(self, name):
        self.count += 1
        if self.trace is not None:
            self.trace.append(name)
        if self.count == self.last:
            os.kill(os.getpid(), signal.SIGKILL)


class SteppedFile(object):
    def __init__(self, steps, source, piece):
        self.steps, self.source, self.piece = steps, source, piece

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.steps.step("before close")
        self.source.close()
        self.steps.step("close")

    def write(self, text):
        for at in range(0, len(text), self.piece):
            self.source.write(text[at:at + self.piece])
            self.source.flush()
            self.steps.step("write")

    def flush(self):
        self.source.flush()
        self.steps.step("flush")

    def close(self):
        self.source.close()
        self.steps.step("close")

    def fileno(self):
        return self.source.fileno()


class SteppedOs(object):
    """The module os, each call of which is a step, before and after it."""

    def __init__(self, steps):
        self.steps = steps
        self.path = os.path

    def __getattr__(self, name):
        thing = getattr(os, name)
        if not callable(thing):
            return thing

        def stepped(*arguments, **named):
            self.steps.step("before " + name)
            result = thing(*arguments, **named)
            self.steps.step(name)
            return result
        return stepped


def in_child(work):
    """Runs it in a process of its own: its status as of os.waitpid."""
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        try:
            work()
        finally:
            os._exit(0)
    return os.waitpid(child, 0)[1]


def some_inputs(m, rng, sensors):
    return dict((s.column, s.read(1.0)) for s in sensors)


def save_steps(path):
    m = imported(path)
    rng = random.Random(1)
    sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")

    def exported_open(steps, piece):
        def stepped(name, mode="r", *more):
            steps.step("before open")
            source = open(name, mode, *more)
            steps.step("open")
            return SteppedFile(steps, source, piece)
        return stepped

    c = m.Correction()
    for k in range(5):
        c.update(float(k), some_inputs(m, rng, sensors))
    c.save(state)
    with open(state) as source:
        old_text = source.read()
    old = json.dumps(c.state(), sort_keys=True)
    for k in range(5, 9):
        c.update(float(k), some_inputs(m, rng, sensors))
    new = json.dumps(c.state(), sort_keys=True)

    def save_with(steps, piece):
        m.os = SteppedOs(steps)
        m.open = exported_open(steps, piece)
        try:
            c.save(state)
        finally:
            m.os = os
            del m.open

    trace = []
    save_with(Steps(0, trace), 10 ** 9)
    steps = [s for s in trace if not s.startswith("before")]
    # What must be on the disk before the new name is: power may fail after any step.
    move = [k for k, s in enumerate(steps) if s in ("replace", "rename")]
    synced = [k for k, s in enumerate(steps) if s == "fsync"]
    written = [k for k, s in enumerate(steps) if s in ("write", "flush")]
    if not move or not synced or not max(written) < synced[0] < move[0]:
        print("faults: save() has the steps %s: the file is not on the disk before its name" % ", ".join(steps))
        return 1
    if not synced[-1] > move[0]:
        print("faults: save() has the steps %s: the folder is not synced" % ", ".join(steps))
        return 1
    done = was_old = was_new = 0
    for stale in (False, True):
        for first in (False, True):  # no state yet, an old one
            for piece in (7, 64, 10 ** 9):
                n = 0
                while True:
                    n += 1
                    for name in os.listdir(folder):
                        os.remove(os.path.join(folder, name))
                    if not first:
                        with open(state, "w") as target:
                            target.write(old_text)
                    if stale:
                        with open(state + ".new", "w") as target:
                            target.write("left behind" * 1000)
                    status = in_child(lambda: save_with(Steps(n, None), piece))
                    loaded = m.Correction()
                    try:
                        loaded.load(state)
                        got = json.dumps(loaded.state(), sort_keys=True)
                    except (IOError, OSError) as error:
                        if not first or os.path.exists(state):
                            print("faults: killed at step %d: load() raises %s" % (n, error))
                            return 1
                        got = old
                    except Exception as error:
                        print("faults: killed at step %d: load() raises %s" % (n, error))
                        return 1
                    if got not in (old, new):
                        print("faults: killed at step %d: neither the old state nor the new one" % n)
                        return 1
                    was_old, was_new, done = was_old + (got == old), was_new + (got == new), done + 1
                    after = m.Correction()  # the next save is not hindered by what was left
                    after.restore(json.loads(new))
                    after.save(state)
                    again = m.Correction()
                    again.load(state)
                    if json.dumps(again.state(), sort_keys=True) != new:
                        print("faults: after a stop at step %d save() and load() do not agree" % n)
                        return 1
                    if not os.WIFSIGNALED(status):
                        if got != new:
                            print("faults: save() returned and the old state is there")
                            return 1
                        break
    # A file that is damaged, byte by byte: refused, and nothing changes.
    with open(state, "rb") as source:
        whole = source.read()
    flips = 0
    for k in range(0, len(whole)):
        for damaged in (whole[:k], whole[:k] + bytes(bytearray([whole[k] ^ 1 << k % 8])) + whole[k + 1:]):
            with open(state, "wb") as target:
                target.write(damaged)
            loaded = m.Correction()
            before = json.dumps(loaded.state(), sort_keys=True)
            try:
                loaded.load(state)
                if json.dumps(loaded.state(), sort_keys=True) != new:
                    print("faults: byte %d damaged: another state is taken" % k)
                    return 1
            except ValueError:
                if json.dumps(loaded.state(), sort_keys=True) != before:
                    print("faults: byte %d damaged: load() raises and has changed something" % k)
                    return 1
            except Exception as error:
                print("faults: byte %d damaged: load() raises %s: %s" % (k, type(error).__name__, error))
                return 1
            flips += 1
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    os.rmdir(folder)
    print("faults: save() has the steps %s; %d stops: old state %d, new one %d; %d damaged files refused" % (
        ", ".join(steps), done, was_old, was_new, flips))
    return 0


def kill_runs(path, times, seed):
    """Machines that tick, save, and tell; killed at any moment."""
    m = imported(path)
    rng = random.Random(seed)
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")
    ticks = lost = first_steps = 0
    told = None  # time, offsets of the last call that was sent
    mid = 0
    for run in range(times):
        reading, writing = os.pipe()
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            try:
                os.close(reading)
                mine = random.Random(seed * 1000003 + run)
                sensors = [Sensor(mine, m, k) for k in range(len(m.INPUTS))]
                c = m.Correction()
                t = 0.0
                if run:
                    c.load(state)
                    t = c.time + mine.choice([0.5, 5.0, 60.0])
                while True:
                    offsets = c.update(t, some_inputs(m, mine, sensors))
                    c.save(state)  # before it is sent
                    os.write(writing, (json.dumps([t, [offsets[a["displacement"]] for a in m.AXES]]) + "\n").encode())
                    t += mine.uniform(0.1, 2.0)
            except BaseException as error:
                os.write(writing, ("error %s\n" % error).encode())
            finally:
                os._exit(3)
        os.close(writing)
        text = b""
        while b"\n" not in text:
            piece = os.read(reading, 65536)
            if not piece:
                break
            text += piece
        time.sleep(rng.uniform(0, 0.012))
        os.kill(child, signal.SIGKILL)
        while True:
            piece = os.read(reading, 65536)
            if not piece:
                break
            text += piece
        os.close(reading)
        os.waitpid(child, 0)
        if b"error" in text:
            print("faults: run %d, seed %d: %s" % (run, seed, text.decode().splitlines()[-1]))
            return 1
        lines = [json.loads(line) for line in text.decode().split("\n")[:-1] if line.endswith("]")]
        for t, offsets in lines:
            if told is not None:
                gap = min(t - told[0], m.LONGEST_GAP)
                for a, now, was in zip(m.AXES, offsets, told[1]):
                    apart = abs(now - was) * a["unit_um"]
                    if apart > a["slew"] * gap + (a["unit_um"] if a["counts"] else 0.0) + 1e-9:
                        print("faults: run %d, seed %d: offset of %s goes from %g to %g in %g s" % (
                            run, seed, a["displacement"], was, now, t - told[0]))
                        return 1
            told = (t, offsets)
        ticks += len(lines)
        c = m.Correction()
        try:
            c.load(state)
        except Exception as error:
            print("faults: run %d, seed %d: load() raises %s: %s" % (run, seed, type(error).__name__, error))
            return 1
        if c.time < told[0]:
            print("faults: run %d, seed %d: the state is of %r, sent was %r" % (run, seed, c.time, told[0]))
            return 1
        mid += c.time > told[0]
        if c.time == told[0]:
            offsets = c._offsets()
            for a, was in zip(m.AXES, told[1]):
                if offsets[a["displacement"]] != was:
                    print("faults: run %d, seed %d: the state has another offset than was sent" % (run, seed))
                    return 1
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    os.rmdir(folder)
    print("faults: %d kills in %d calls; %d between save() and sending; nothing lost, offsets within their slew" % (
        times, ticks, mid))
    return 0


def odd_values(path):
    """Every odd value in every input, the clock and applied(): no exception, finite, and over when it is over."""
    m = imported(path)
    problems = []
    again = 4 * int(m.HOLD + m.FADE)

    def machine():
        rng = random.Random(7)
        sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
        c = m.Correction()
        for k in range(30):
            c.update(1000.0 + k, some_inputs(m, rng, sensors))
        return c, rng, sensors

    def named(value):
        text = repr(value)
        return "%s %s" % (type(value).__name__, text if len(text) < 40 else text[:12] + "... (%d characters)" % len(text))

    def after(c, rng, sensors, what, t):
        """Well again within HOLD, FADE and slew; saved and loaded."""
        try:
            json.loads(json.dumps(c.state()))
        except Exception as error:
            problems.append("%s: the state cannot be saved: %s: %s" % (what, type(error).__name__, error))
            return
        # As a control that has it all right again: the clock goes on from where it last was good.
        c.update(t, some_inputs(m, rng, sensors))
        for k in range(again):
            t += 1.0
            offsets = c.update(t, some_inputs(m, rng, sensors))
        for name, value in offsets.items():
            if not (isinstance(value, (int, float)) and value - value == 0):
                problems.append("%s: offset of %s is %r afterwards" % (what, name, value))
        for k, y in enumerate(c.absolute):
            if not y - y == 0:
                problems.append("%s: the displacement of %s is %r, %d s afterwards" % (
                    what, m.AXES[k]["displacement"], y, again))
        alarm = c.status & (m.ALARMS & ~m.BEYOND_ELEMENT)
        plain = machine_alarm
        if alarm & ~plain:
            problems.append("%s: alarm %d s afterwards: %s" % (what, again, ", ".join(c.status_words())))

    c, rng, sensors = machine()
    for k in range(again):
        c.update(2000.0 + k, some_inputs(m, rng, sensors))
    machine_alarm = c.status & m.ALARMS
    tried = 0
    big = [1e308, -1e308, 1e200, 1e155, 1e100, 1e30, 10 ** 30]
    for value in NOTHING + NEVER + ODD + EITHER + big:
        for column in [i[0] for i in m.INPUTS]:
            c, rng, sensors = machine()
            inputs = some_inputs(m, rng, sensors)
            inputs[column] = value
            what = "%s = %s" % (column, named(value))
            tried += 1
            try:
                c.update(1031.0, inputs)
                offsets = c.update(1032.0, inputs)
                bad = [v for v in offsets.values() if not v - v == 0]
                if bad:
                    problems.append("%s: offsets %r" % (what, offsets))
            except Exception as error:
                problems.append("%s: update() raises %s: %s" % (what, type(error).__name__, error))
                continue
            after(c, rng, sensors, what, 1033.0)
        c, rng, sensors = machine()
        what = "time = %s" % named(value)
        tried += 1
        try:
            c.update(value, some_inputs(m, rng, sensors))
            c.update(1031.0, some_inputs(m, rng, sensors))
            c.update(1032.0, some_inputs(m, rng, sensors))
        except Exception as error:
            problems.append("%s: update() raises %s: %s" % (what, type(error).__name__, error))
            continue
        c, rng, sensors = machine()
        c.update(value, some_inputs(m, rng, sensors))
        after(c, rng, sensors, what, 1032.0)
        for axis in m.AXES:
            c, rng, sensors = machine()
            what = "applied %s = %s" % (axis["displacement"], named(value))
            tried += 1
            try:
                c.applied({axis["displacement"]: value, "unknown": value})
                offsets = c.update(1031.0, some_inputs(m, rng, sensors))
                if not offsets[axis["displacement"]] - offsets[axis["displacement"]] == 0:
                    problems.append("%s: offset %r" % (what, offsets[axis["displacement"]]))
            except Exception as error:
                problems.append("%s: raises %s: %s" % (what, type(error).__name__, error))
    # Of all inputs at once, on the first call, and a snapshot that must not change.
    c, rng, sensors = machine()
    snapshot = c.state()
    text = json.dumps(snapshot, sort_keys=True)
    c.update(1031.0, some_inputs(m, rng, sensors))
    c.update(1041.0, some_inputs(m, rng, sensors))
    if json.dumps(snapshot, sort_keys=True) != text:
        problems.append("state(): what was given changes with later calls")
    # Of a restart whose first call has no clock yet.
    c, rng, sensors = machine()
    other = m.Correction()
    other.restore(json.loads(json.dumps(c.state())))
    other.update(None, some_inputs(m, rng, sensors))
    other.update(1029.0 + 8 * 3600, some_inputs(m, rng, sensors))
    if other.status & m.CLOCK and 8 * 3600 > m.CLOCK_JUMP:
        problems.append("restart: the clock has no value at the first call, and 8 h that the machine was off are "
                        "then taken for a clock that was set")
    c, rng, sensors = machine()
    other = m.Correction()
    other.restore(json.loads(json.dumps(c.state())))
    other.update(1029.0 - 50.0, some_inputs(m, rng, sensors))
    # An old state without one of its parts.
    state = json.loads(json.dumps(c.state()))
    del state["trust"]
    other = m.Correction()
    other.update(5.0, some_inputs(m, rng, sensors))
    before = json.dumps(other.state(), sort_keys=True)
    try:
        other.restore(state)
        problems.append("restore(): takes a state that lacks a part")
    except Exception as error:
        if not isinstance(error, ValueError):
            problems.append("restore(): a state that lacks a part: %s, not ValueError" % type(error).__name__)
        if json.dumps(other.state(), sort_keys=True) != before:
            problems.append("restore(): a state that lacks a part is refused, and the old one is gone")
    seen = []
    for p in problems:
        if p not in seen:
            seen.append(p)
    for p in seen:
        print("faults: " + p)
    print("faults: %s: %d odd values, %d problems" % (os.path.basename(path), tried, len(seen)))
    return 1 if seen else 0


def speed(path):
    m = imported(path)
    rng = random.Random(3)
    sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
    rows = [some_inputs(m, rng, sensors) for _ in range(2000)]
    c = m.Correction()
    best = INF
    t = 0.0
    for _ in range(7):
        began = time.perf_counter()
        for row in rows:
            t += 1.0
            c.update(t, row)
        best = min(best, (time.perf_counter() - began) / len(rows))
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")
    began = time.perf_counter()
    for _ in range(200):
        c.save(state)
    saving = (time.perf_counter() - began) / 200
    os.remove(state)
    os.rmdir(folder)
    print("faults: %s: %.1f us a call, %.0f us a save(); %d inputs, %d axes, %d sections" % (
        os.path.basename(path), best * 1e6, saving * 1e6, len(m.INPUTS), len(m.AXES),
        sum(len(a["sections"]) for a in m.AXES)))
    return 0


# Models.

FRICTION = """speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm
0,400,20,90\n3000,400,20,210\n9000,400,20,420\n0,600,20,110\n3000,600,20,240
9000,600,20,470\n0,400,45,60\n3000,400,45,150\n9000,400,45,330\n0,600,45,75
3000,600,45,170\n9000,600,45,360
"""

FULL = """[[correction]]
displacement = "displacement_z_um"
offset_um = 3.25
[[correction.channel]]
name = "spindle"
input = ["front_temperature_C", "rear-left_temperature_C"]
reference = "base_temperature_C"
sections = [{ gain_um_K = 5.1, time_constant_s = 5400 }, { gain_um_K = -3.3, time_constant_s = 900 }]
feedthrough_um_K = 0.7
scale = 1.2
[[correction.channel]]
name = "losses"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 470
temperature_C = "front_temperature_C"
sections = [{ gain_um_W = 0.18, time_constant_s = 4000 }]
[[correction.channel]]
name = "line"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 550
temperature_C = 37
gain = { slope_um_W = 0.04817, offset_um = 1.03617 }
time_constant = { slope_min_W = -0.06298, offset_min = 135.245 }
[[correction.channel]]
name = "screw"
input = ["x_feed_m_min", "y_feed_m_min"]
sections = [{ gain_um_m_min = 0.8, time_constant_s = 2500 }]
[correction.kinematic]
A = 1.28e-3
B = 0.697
C = 5.3e-4
[[correction.effect]]
id = "ambient-drift"
input = "room_temperature_C"
gain_um_K = -2.5
time_constant_s = 8000
[[correction.effect]]
id = "motor-heat"
gain_um = 6.0
time_constant_s = 1800
decay_speed_rpm = 2500
[[correction.effect]]
id = "cooling-switch"
channel = "losses"
gain_ratio = 1.7
time_constant_ratio = 0.6
"""
SECOND = """[[correction]]
displacement = "displacement_y_um"
[[correction.channel]]
name = "sensor"
input = "front_temperature_C"
sections = [{ gain_um_K = 4.0, time_constant_s = 3000 }]
[[correction.channel]]
name = "speedy"
input = "rear-left_temperature_C"
sections = [{ gain_um_K = 2.0, time_constant_s = 6000 }]
[[correction.channel]]
name = "lazy"
input = "table_speed_rpm"
exponent = 1.5
sections = [{ gain_um_rpm = -0.02, time_constant_s = 2000 }]
[[correction.channel]]
name = "power-law"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 500
temperature_C = 30
gain = { factor = 0.4, exponent = 0.8 }
time_constant = { factor = 90, exponent = -0.2 }
[[correction.channel]]
name = "tabled"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 500
temperature_C = 30
gain = { table = "K.csv" }
time_constant = { table = "T.csv" }
scale = -0.5
[[correction.effect]]
id = "sensor-lag"
channel = "sensor"
sensor_time_constant_s = 240
[[correction.effect]]
id = "speed-dependent-time-constant"
channel = "speedy"
s = 2.5
g = 0.6
[[correction.effect]]
id = "thermal-asymmetry"
channel = "lazy"
ratio = 2.2
[[correction.effect]]
id = "second-time-constant"
channel = "lazy"
gain_um_rpm = 0.01
time_constant_s = 300
"""
RANGE = """[correction.range]
front_temperature_C = [10, 60]
rear-left_temperature_C = [10, 60]
base_temperature_C = [10, 60]
room_temperature_C = [10, 60]
speed_rpm = [0, 9000]
x_feed_m_min = [-30, 20]
y_feed_m_min = [0, 30]
table_speed_rpm = [0, 600]
"""
GUARDED = """plausible = { front_temperature_C = [-10, 120], rear-left_temperature_C = [-40, 150], base_temperature_C = [0, 80], \
room_temperature_C = [-5, 60], speed_rpm = [0, 20000], x_feed_m_min = [0, 60], y_feed_m_min = [0, 60], \
table_speed_rpm = [0, 1000], coolant_on = [0, 1] }
"""
SMALL = """[correction]
displacement = "displacement_z_um"
[[correction.channel]]
name = "spindle"
input = "front_temperature_C"
feedthrough_um_K = 1.5
sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]
"""


def six_channels():
    text = "[correction]\ndisplacement = \"displacement_z_um\"\n"
    for k, name in enumerate(["front", "rear", "motor", "head", "base", "room"]):
        text += ("[[correction.channel]]\nname = \"%s\"\ninput = \"%s_temperature_C\"\n"
                 "sections = [{ gain_um_K = %g, time_constant_s = %d }, { gain_um_K = %g, time_constant_s = %d }]\n" % (
                     name, name, 1.5 - 0.4 * k, 5400 + 100 * k, 0.7 + 0.1 * k, 700 + 10 * k))
    text += "[correction.range]\n"
    for name in ["front", "rear", "motor", "head", "base", "room"]:
        text += "%s_temperature_C = [15, 50]\n" % name
    return text


MODELS = {
    # All that there is, on two axes; a table in each way that [export] knows.
    "full": FULL + RANGE + SECOND + RANGE + """[export]
limit_um = { displacement_z_um = 60, displacement_y_um = 45.05 }
slew_um_s = { displacement_z_um = 0.5, displacement_y_um = 0.2 }
sign = { displacement_y_um = 1 }
unit = { displacement_z_um = "mm", displacement_y_um = "counts" }
count_um = { displacement_y_um = 0.1 }
fastest_per_s = { front_temperature_C = 0.5, speed_rpm = 2000, room_temperature_C = 0.1 }
stuck_s = { front_temperature_C = 300, rear-left_temperature_C = 500, base_temperature_C = 3600 }
smoothing_s = { front_temperature_C = 30, speed_rpm = 5 }
hold_s = 20
fade_s = 60
clock_jump_s = 600
""" + GUARDED,
    "zero": FULL + RANGE + SECOND + RANGE + """[export]
limit_um = 30
slew_um_s = 0.3
unit = { displacement_z_um = "um", displacement_y_um = "counts" }
count_um = { displacement_y_um = 0.7 }
stuck_s = 200
on_fault = "zero"
hold_s = 0
fade_s = 30
restart = "resume"
touch_off = "clear"
disabled = "freeze"
beyond_range = "hold"
longest_gap_s = 5
clock_jump_s = 5
""" + GUARDED,
    "hold": FULL + RANGE + SECOND + RANGE + """[export]
limit_um = { displacement_z_um = 12.3, displacement_y_um = 0.7 }
slew_um_s = 2
unit = "counts"
count_um = { displacement_z_um = 0.3, displacement_y_um = 0.1 }
fastest_per_s = 0.2
stuck_s = 100
smoothing_s = 12
on_fault = "hold"
hold_s = 15
restart = "rest"
longest_gap_s = 3
clock_jump_s = 100
""" + GUARDED,
    # Nothing is known of inputs, nothing is asked of them; together.
    "bare": FULL + SECOND + """[export]
plausible = { front_temperature_C = [-40, 150] }
fastest_per_s = 0
stuck_s = 0
hold_s = 5
fade_s = 20
""",
    "together": """[correction]
displacement = "displacement_z_um"
[[correction.channel]]
name = "spindle"
input = "front_temperature_C"
sections = [{ gain_um_K = 5.0, time_constant_s = 600 }]
[[correction.channel]]
name = "speed"
input = "speed_rpm"
exponent = 2.5
sections = [{ gain_um_rpm = 0.002, time_constant_s = 900 }]
[correction.together]
columns = ["front_temperature_C", "speed_rpm"]
mean = [30, 2000]
std = [5, 900]
correlation = [[1.0], [0.9, 1.0]]
farthest = 2.5
[export]
hold_s = 5
fade_s = 20
""",
    "small": SMALL + "[export]\nhold_s = 10\nfade_s = 30\nstuck_s = 120\n",
    "default": SMALL,
    "friction": """[correction]
displacement = "displacement_x_um"
[[correction.channel]]
name = "line"
input = "power_W"
friction_table = "friction.csv"
axial_load_N = 400
temperature_C = 20
gain = { slope_um_W = 0.5, offset_um = 10 }
time_constant = { slope_min_W = -0.6, offset_min = 60 }
[export]
hold_s = 10
fade_s = 30
limit_um = 40
unit = "counts"
plausible = { speed_rpm = [0, 12000] }
fastest_per_s = { speed_rpm = 3000 }
""",
    "six": six_channels(),
}


def write_models(folder):
    if not os.path.isdir(folder):
        os.makedirs(folder)
    files = {"friction.csv": FRICTION, "K.csv": "power_W,gain_um\n0,1\n40,9\n90,15\n200,20\n",
             "T.csv": "power_W,time_constant_min\n0,120\n100,70\n250,40\n"}
    files.update((name + ".toml", text) for name, text in MODELS.items())
    for name, text in files.items():
        with open(os.path.join(folder, name), "w") as out:
            out.write(text)
    print(" ".join(sorted(MODELS)))
    return 0


def main(words):
    if len(words) == 2 and words[0] == "--models":
        return write_models(words[1])
    if len(words) == 2 and words[1] in ("--steps", "--odd", "--speed"):
        return {"--steps": save_steps, "--odd": odd_values, "--speed": speed}[words[1]](words[0])
    if len(words) == 4 and words[1] == "--kill":
        return kill_runs(words[0], int(words[2]), int(words[3]))
    script, left = None, []
    words = list(words)
    while words:
        word = words.pop(0)
        if word == "--script":
            script = words.pop(0)
        else:
            left.append(word)
    if len(left) != 3:
        sys.stderr.write(__doc__)
        return 2
    return random_run(left[0], int(left[1]), int(left[2]), script)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""One odd value after the other, and what it leaves behind."""
import json
import os
import random

from sensor import Sensor, some_inputs
from values import EITHER, NEVER, NOTHING, ODD


def odd_values(m):
    """Every odd value in every input, the clock and applied(): no exception, finite, and over when it is over."""
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
                problems.append("%s: the displacement of %s is %r, %d s afterwards" % (what, m.AXES[k]["displacement"], y, again))
        alarm = c.status & (m.ALARMS & ~m.BEYOND_ELEMENT)
        plain = machine_alarm
        if alarm & ~plain:
            problems.append("%s: alarm %d s afterwards: %s" % (what, again, ", ".join(c.status_words())))

    c, rng, sensors = machine()
    for k in range(again):
        c.update(2000.0 + k, some_inputs(m, rng, sensors))
    machine_alarm = c.status & m.ALARMS
    tried = 0
    big = [1e308, -1e308, 1e200, 1e155, 1e100, 1e30, 10**30]
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
        problems.append(
            "restart: the clock has no value at the first call, and 8 h that the machine was off are " "then taken for a clock that was set"
        )
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
    print("faults: %s: %d odd values, %d problems" % (os.path.basename(m.__file__), tried, len(seen)))
    return 1 if seen else 0

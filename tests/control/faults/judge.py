"""What an offset may do, from the promises of docs/control.md."""
import decimal
import fractions

from values import EITHER, Scalar, is_real


class Broken(Exception):
    pass


class Judge(object):
    """Own bookkeeping of what an offset may do, from the promises; knows of the program what it is asked alone."""

    def __init__(self, module, counts):
        self.m, self.counts = module, counts
        self.axes, self.inputs = module.AXES, module.INPUTS
        self.words = dict(module.WORDS)
        self.begin()

    def begin(self):
        n = len(self.axes)
        self.time = None  # last that was a number
        self.restarted = self.waits = False
        self.offset = [0.0] * n  # in units, as handed out last
        self.slack = [0.0] * n  # [um] of the next call: what was applied may differ by a count
        self.above = [0.0] * n  # [um] that the control has applied beyond the limit
        self.believed = [None] * len(self.inputs)
        self.since = [(0.0, 0.0)] * len(self.inputs)  # since it was believed, by the clock and at most a gap each
        self.raw = [None] * len(self.inputs)
        self.same = [(0.0, 0.0)] * len(self.inputs)  # for how long it has stood, at least and at most
        self.started = False
        self.untrusted, self.doubt = [0.0] * n, [0.0] * n
        self.reference = [(0.0, 0.0, 0.0)] * n  # displacement, offset, in how far that is known [um]
        self.safe = [None] * n  # offset [um] that good inputs gave last, None: not known
        self.bad = [0.0] * n  # for how long inputs of the axis have been at fault [s]
        self.poisoned = False  # a number without limits was believed

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
                self.fail("%s = %r (believed %r, %.6g s ago) is %s; faults say %r", column, value, self.believed[k], since[0], self.words[must], said)
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
                if m.DISABLED == "zero" and not was_above and abs(um) > max(0.0, abs(was) - reach) + 1.5 * count + fine + self.slack[k]:
                    self.fail("disabled: offset of %s goes from %.9g to %.9g um in %.9g s (status %d)", name, was, um, gap, status)
                if m.DISABLED == "freeze" and moved > fine + self.slack[k] and not was_above:
                    self.fail("frozen: offset of %s goes from %.9g to %.9g um", name, was, um)
            elif trusted and self.started and not self.poisoned:
                if abs(um - target) > max(0.0, abs(was - target) - reach) + tolerance:
                    self.fail("offset of %s is %.9g um, asked for %.9g um, was %.9g um, %.9g s (status %d)", name, um, target, was, gap, status)
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
        if correction.alarm and not bits and not clock & (m.CLOCK | m.LATE) and not may_doubt and not status & (m.LIMITED | m.BEYOND_ELEMENT):
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
        self.reference[k] = (correction.absolute[k], um if keep else 0.0, (axis["unit_um"] if axis["counts"] else 0.0) if keep else 0.0)
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

"""Inputs of an exported correction, as a machine has them: true values, and what faults make of them."""
from values import EITHER, INF, NEVER, NOTHING, ODD


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
                return rng.choice([p[0] - 1e-6, p[1] + 1e-6, p[0] - 1e4, p[1] * 3, 1e308, -1e308, 1e30, 850.0, 10**12])
            return rng.choice([-1, 1]) * rng.choice([p[1] + 1e-6, p[1] * 3 + 1, 1e308, 1e30, 10**12])
        if kind == "spike":
            return value + rng.choice([-1, 1]) * rng.choice([0.1, 1, 10, 30]) * (self.guard["fastest"] or 0.1 * (self.high - self.low))
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


def some_inputs(m, rng, sensors):
    return dict((s.column, s.read(1.0)) for s in sensors)

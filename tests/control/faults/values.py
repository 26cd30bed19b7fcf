"""What an input may be handed: numbers, what is none, and what may be taken for either."""
import datetime
import decimal
import fractions

NAN, INF = float("nan"), float("inf")


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
ODD = [
    1j,
    25 + 0j,
    decimal.Decimal("NaN"),
    decimal.Decimal("sNaN"),
    decimal.Decimal("Infinity"),
    Array(),
    Hostile(),
    NoFloat(),
    10**400,
    -(10**400),
    fractions.Fraction(10**400, 3),
]
EITHER = [True, False, decimal.Decimal("25.3"), fractions.Fraction(51, 2), Scalar(25.25), -0.0, 0, 5e-324]

"""Effects that users write as Python functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy
from numpy.typing import ArrayLike

from ._errors import InputError


@dataclass(frozen=True)
class Number:
    """Parameter of an effect. A fit can determine the value.

    Attributes
    ----------
    value : float
        Start value. If the first number of an effect is 0, `diagnose` tests the effect.
    unit : str
        Unit of the value. ``"1"`` means no unit.
    lower, upper : float
        Bounds of the value. NaN means no bound.
    """

    value: float = 0.0
    unit: str = "1"
    lower: float = float("nan")
    upper: float = float("nan")


class State:
    """Inputs of the function `torque`. Each column of the record is an array with one value per row.

    The arrays are ``speed_rpm``, ``axial_load_N``, ``radial_load_N``, ``temperature_C``, ``time_s`` and all other
    recorded columns. The names end with the unit, if there is one. Measured columns are not included. The data of the bearing are single numbers:
    ``pitch_diameter_mm``, ``ball_diameter_mm``, ``ball_count``, ``contact_angle_deg``.
    """

    def __init__(self, columns: Mapping[str, Any]) -> None:
        self._columns = dict(columns)

    def __getattr__(self, name: str) -> Any:
        columns = self.__dict__.get("_columns", {})
        if name in columns:
            return columns[name]
        raise AttributeError(f"{name}: no such column in the record; the columns are {', '.join(columns)}")

    def __dir__(self) -> list[str]:
        return list(self._columns)


class Effect:
    """Friction torque that you define as a Python function. You can use this effect like an effect of the catalogue.

    Parameters
    ----------
    id : str
        Name without blanks, dots, commas, semicolons and quotes. The name must not begin with =, +, - or @.
    torque : callable
        Function ``torque(state, **numbers)`` that returns the additional torque of every row [N mm], as an array or
        one number. `State` describes the argument ``state``. The torque of a row must depend only on the inputs of
        this row. The torque must be 0 if the first number is 0. Several threads can call the function.
    numbers : mapping of str to Number, dict or float
        Parameters that a fit can determine. The first parameter is the size of the effect.
    title : str
        Title of the effect in reports. Default: the first line of the docstring of `torque`, or the name of this function.

    Examples
    --------
    >>> def fan(state, c):
    ...     return c * (state.speed_rpm / 1000) ** 2
    >>> effect = Effect("fan", fan, {"c": Number(0.0, "N mm", lower=0.0)})
    >>> import raceway
    >>> model = raceway.Model.new("S 6014 C").with_effect(effect)
    >>> model.parameters["fan.c"]["unit"]
    'N mm'
    """

    def __init__(
        self, id: str, torque: Callable[..., ArrayLike], numbers: Mapping[str, Number | Mapping[str, Any] | float], *, title: str = ""
    ) -> None:
        if not id or any(c in " .\t\n,;\"'" for c in id) or id[0] in "=+-@":
            raise InputError(f"id = {id!r}: must be a name without blanks, dots, commas, semicolons and quotes, and must not begin with =, +, - or @")
        if not callable(torque):
            raise TypeError(f"torque: must be a function of state and numbers, not {type(torque).__name__}")
        if not numbers:
            raise ValueError("numbers: an effect needs at least one number, its size")
        self.id = id
        self.torque = torque
        self.numbers = {str(name): _number(name, number) for name, number in numbers.items()}
        self.title = title or (torque.__doc__ or f"function {getattr(torque, '__name__', id)}").strip().splitlines()[0]

    def with_values(self, values: Sequence[float]) -> Effect:
        """Return a copy of the effect with new values, in the order of `numbers`."""
        numbers = {name: Number(float(value), n.unit, n.lower, n.upper) for (name, n), value in zip(self.numbers.items(), values, strict=True)}
        return Effect(self.id, self.torque, numbers, title=self.title)

    def _call(self, columns: Mapping[str, Any], values: Sequence[float], rows: int) -> list[float]:
        torque = numpy.asarray(self.torque(State(columns), **dict(zip(self.numbers, values))))
        if torque.dtype.kind not in "fiu" or torque.shape not in ((), (1,), (rows,)):
            raise InputError(
                f"effect {self.id}: torque(state) must give a number for each of {rows} rows, not an "
                f"array of {torque.dtype} of shape {torque.shape}"
            )
        return numpy.broadcast_to(torque.astype(float), (rows,)).tolist()

    def _for_engine(self) -> tuple[str, str, list[tuple[str, str, float, float, float]], Any]:
        numbers = [(name, n.unit, n.value, n.lower, n.upper) for name, n in self.numbers.items()]
        return self.id, self.title, numbers, self._call

    def __repr__(self) -> str:
        return f"<raceway.Effect {self.id}: {self.title}>"


def _number(name: str, given: Number | Mapping[str, Any] | float) -> Number:
    if isinstance(given, Number):
        return given
    if isinstance(given, Mapping):
        return Number(**given)
    if isinstance(given, (int, float)):
        return Number(float(given))
    raise TypeError(f"numbers[{name!r}]: must be a Number, a dict or a float, not {type(given).__name__}")

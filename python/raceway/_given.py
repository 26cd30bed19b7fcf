"""Functions that check arguments, convert them for the engine, and issue the warnings of the engine."""

from __future__ import annotations

import math
import numbers
import operator
import warnings
from collections.abc import Iterable
from typing import Any

import numpy
from numpy.typing import ArrayLike

from ._errors import Doubt


def warn(lines: Iterable[str]) -> None:
    for line in lines:
        warnings.warn(line, Doubt, stacklevel=3)


def arrays(**given: ArrayLike | None) -> dict[str, numpy.ndarray]:
    """Return the arguments as arrays of float64. Arrays that already have this type are not copied."""
    found = {}
    for name, value in given.items():
        if value is None:
            continue
        if numpy.ma.is_masked(value):
            raise ValueError(f"{name}: has masked values, which are not numbers; remove them or replace them by numbers")
        try:
            array = numpy.asarray(value)
        except ValueError:
            raise ValueError(f"{name}: the lists must have equal lengths") from None
        if array.dtype.kind not in "fiu":
            raise TypeError(f"{name}: must contain numbers, not {_kind(array)}")
        if array.dtype.byteorder == ">" or array.dtype != numpy.float64:
            array = array.astype(numpy.float64)
        found[name] = array
    return found


def text_of(argument: str, value: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{argument}: must be text, not {type(value).__name__}")
    return value


def tolerance_text(value: str) -> str:
    if not isinstance(value, str):
        words = 'must be an error with its unit, such as "2Nmm" or "2um"'
        raise TypeError(f"tolerance: {words}, not {value!r}")
    return value


def number_text(argument: str, value: Any) -> str:
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{argument}: must be a number, not {type(value).__name__}")
    return repr(float(value)).removesuffix(".0")


def seconds(argument: str, value: float | None) -> str:
    """Return a duration in the form of the command, such as "3600s"; "" for None."""
    return "" if value is None else number_text(argument, value) + "s"


def name_list(argument: str, given: str | Iterable[str]) -> list[str]:
    if isinstance(given, str):
        return [given]
    listed = list(given)
    for name in listed:
        if not isinstance(name, str):
            raise TypeError(f"{argument}: must contain names, not {type(name).__name__}")
    return listed


def value_of(name: str, value: float) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: must be a number, not {type(value).__name__}")
    return float(value)


def number_or_nan(name: str, value: float | None) -> float:
    """Return the number. Return NaN if the argument is None (not given)."""
    if value is None:
        return float("nan")
    if math.isnan(value_of(name, value)):
        raise ValueError(f"{name} = nan: must be a number")
    return float(value)


def time_limit(time_limit_s: float | None) -> float:
    return float("inf") if time_limit_s is None else number_or_nan("time_limit_s", time_limit_s)


def whole_number(name: str, value: int) -> int:
    try:
        if not isinstance(value, bool):
            return operator.index(value)
    except TypeError:
        pass
    raise TypeError(f"{name}: must be a whole number, not {type(value).__name__}")


def yes_or_no(name: str, value: bool) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name}: must be True or False, not {value!r}")
    return value


def _kind(array: numpy.ndarray) -> str:
    return {"U": "text", "S": "text", "b": "truth values", "c": "complex numbers"}.get(array.dtype.kind, f"objects ({array.dtype})")


def axis(name: str, values: ArrayLike | None) -> list[float]:
    if values is None:
        return []
    array = arrays(**{name: values})[name]
    if array.ndim > 1:
        raise ValueError(f"{name}: must be a list of numbers, not an array of shape {array.shape}")
    return [float(v) for v in numpy.atleast_1d(array)]

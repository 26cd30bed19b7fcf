"""Functions that check arguments for records over time and convert them for the engine."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from numbers import Integral
from typing import Any

from ._given import number_text
from ._record import Record


def one_record(record: Any) -> Record:
    if not isinstance(record, Record):
        raise TypeError(
            f"must be a raceway.Record, not {type(record).__name__}; use "
            "Record.read(path) or Record.from_pandas(frame); a correction is compared with one record only"
        )
    return record


def order_text(order: int | Sequence[int]) -> str:
    """Return the number of lags of a channel in the form of the command, such as "2" or "1:3"."""
    numbers = list(order) if isinstance(order, (list, tuple)) else [order]
    whole = all(isinstance(n, Integral) and not isinstance(n, bool) for n in numbers)
    if len(numbers) not in (1, 2) or not whole:
        raise TypeError(f"order: must be a number of sections, or the smallest and the largest number, not {order!r}")
    return ":".join(str(n) for n in numbers)


def lag_texts(lags_s: str | Iterable[float] | None) -> list[str]:
    """Return the time constants [s] or "auto" as a list of texts. The list is empty for None."""
    if lags_s is None or isinstance(lags_s, str):
        return [] if lags_s is None else [lags_s]
    if not isinstance(lags_s, Iterable):
        raise TypeError(f"lags_s: must be time constants such as [0, 600, 3600], not {lags_s!r}")
    lags = [number_text("lags_s", lag) for lag in lags_s]
    if not lags:
        raise ValueError('lags_s: no lag is given; "auto" chooses the lags from the length of the record')
    return lags

"""Functions that the plots of plot.py share: axes, line styles and markers, legends, and reading of data frames."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ._documents import label_of, split_column

# Colours of Okabe and Ito, which colour-blind people can distinguish. Black is only for axes, because dark styles invert it.
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
LINES: tuple[Any, ...] = ("-", "--", "-.", ":", (0, (8, 2)), (0, (4, 1, 1, 1, 1, 1)), (0, (2, 1)))
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<", ">")
MOST_MARKERS = 10  # largest number of markers of a curve; more markers hide the line style


def style(i: int) -> dict[str, Any]:
    """Return colour, line style and marker of the i-th curve. The cycles of 6, 7 and 9 values give 126 different combinations."""
    return {"color": COLOURS[i % len(COLOURS)], "linestyle": LINES[i % len(LINES)], "marker": MARKERS[i % len(MARKERS)]}


def markevery(points: int, curve: int) -> tuple[int, int] | None:
    """Return the argument `markevery` of a curve. A curve has few markers, and different curves have them at different points."""
    if points <= MOST_MARKERS + 2:
        return None
    step = -(-points // MOST_MARKERS)
    return (curve * 2) % step, step


def new_figure() -> Figure:
    """Return a new figure of pyplot. A notebook shows this figure."""
    from matplotlib import pyplot  # imported only here, because the import chooses a backend

    return pyplot.figure(layout="constrained")


def axes_for(ax: Axes | None, caller: str) -> tuple[Axes, bool]:
    """Return the axes for the plot, and True if the axes are in a new figure."""
    if ax is None:
        return new_figure().add_subplot(), True
    if not isinstance(ax, Axes):
        hint = "; give one element of it" if isinstance(ax, (Iterable, np.ndarray)) else ""
        raise TypeError(f"{caller}: ax is a {type(ax).__name__}, not a matplotlib Axes{hint}")
    return ax, False


def has_room(ax: Axes, own: bool) -> bool:
    """Return True if there is room next to the axes, as in a new figure and in a figure with a layout engine."""
    engine = getattr(ax.figure, "get_layout_engine", lambda: None)()
    return own or engine is not None


def place_legend(ax: Axes, own: bool, title: str | None = None, handles: Any = None, spacing: float = 0.5) -> None:
    """Place the legend next to the axes if there is room for it. Otherwise, place the legend at the best position inside the axes."""
    entries = handles if handles is not None else ax.get_legend_handles_labels()[0]
    beside = has_room(ax, own)
    where: dict[str, Any] = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0), "borderaxespad": 0.0} if beside else {"loc": "best"}
    # A line in the legend is long enough for one complete dash pattern.
    ax.legend(
        handles=entries,
        title=title,
        handlelength=3.2,
        frameon=not beside,
        labelspacing=spacing,
        ncols=1 + (len(entries) - 1) // 9,
        fontsize="small" if len(entries) > 6 else None,
        **where,
    )


def speed_axis(ax: Axes, own: bool) -> None:
    """Label the speed axis. A new figure has few ticks, because the legend leaves little room for numbers of five digits."""
    ax.set_xlabel(label_of("speed_rpm"))
    if own:
        ax.locator_params(axis="x", nbins=6)


def frame_of(source: object, caller: str, wanted: str) -> pd.DataFrame:
    """Return the rows of a result, a record or a DataFrame.

    Raises
    ------
    TypeError
        The source is not a DataFrame and has no method ``to_frame()``.
    ValueError
        The frame has no rows.
    """
    if isinstance(source, pd.DataFrame):
        frame = source
    elif isinstance(source, (list, tuple, dict)):
        raise TypeError(f"{caller} accepts a {wanted} or its DataFrame, not a {type(source).__name__}; call it for each element, with the same ax")
    elif callable(getattr(source, "to_frame", None)):
        frame = source.to_frame()  # type: ignore[attr-defined]
    else:
        raise TypeError(f"{caller} accepts a {wanted} or its DataFrame, not a {type(source).__name__!r}")
    if len(frame) == 0:
        raise ValueError(f"{caller}: no rows; give a {wanted} with at least one row")
    return frame


def require_columns(frame: pd.DataFrame, columns: Iterable[str], caller: str) -> None:
    """Raise ValueError for a missing column. The message lists the existing columns."""
    for column in columns:
        if column not in frame.columns:
            have = ", ".join(str(c) for c in frame.columns)
            raise ValueError(f"{caller}: no column {column!r}; the columns are {have}")


def numbers(frame: pd.DataFrame, column: str, caller: str) -> np.ndarray:
    """Return a column as an array of floats. Empty cells are NaN.

    Raises
    ------
    ValueError
        The column contains text.
    """
    try:
        return pd.to_numeric(frame[column]).to_numpy(dtype=float)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{caller}: column {column!r} contains text, not numbers") from error


def require_one_value(frame: pd.DataFrame, by: list[str], caller: str) -> None:
    """Raise ValueError if a setting that is neither the speed nor in `by` varies along a curve."""
    settings = ("axial_load_N", "radial_load_N", "moment_Nmm", "temperature_C", "preload_N", "external_load_N")
    for column in settings:
        if column in by or column not in frame.columns:
            continue
        values = sorted(frame[column].dropna().unique())
        if len(values) > 1:
            some = ", ".join(f"{v:g}" for v in values[:4]) + (", ..." if len(values) > 4 else "")
            more = "".join(f"{one!r}, " for one in [*by, column])[:-2]
            raise ValueError(
                f"{caller}: {column} also varies ({some}), but it must be constant along a curve; give "
                f"by=[{more}], or only the rows with one value, "
                f'table.to_frame().query("{column} == {values[0]:g}")'
            )


def groups_by(frame: pd.DataFrame, by: list[str]) -> list[tuple[tuple[Any, ...], pd.DataFrame]]:
    """Return a group of rows for each combination of values of these columns, in rising order. Without columns, return one group."""
    if not by:
        return [((), frame)]
    if len(by) == 1:
        return [((key,), rows) for key, rows in frame.groupby(by[0], sort=True)]
    return list(frame.groupby(by, sort=True))


def value_text(columns: list[str], values: tuple[Any, ...]) -> str:
    """Return the label of a curve in the legend, such as "300", or "300, 40" for two columns."""
    return ", ".join(f"{v:g}" if isinstance(v, (int, float, np.number)) else str(v) for _, v in zip(columns, values))


def unit_of(column: str) -> str:
    """Return the unit at the end of the name of a column."""
    return split_column(column)[1]

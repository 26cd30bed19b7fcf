"""Picture of a record: its columns over time or speed, with one axes for each unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes

from . import _draw as draw
from ._documents import label_of, quantity_text, split_column, unit_text


def record(source: Any, columns: Sequence[str] | None = None, *, ax: Axes | Sequence[Axes] | None = None) -> list[Axes]:
    """Draw a record over time, or over speed if it has no time, with one axes for each unit.

    Parameters
    ----------
    source : record, CorrectionRun or DataFrame
        Columns as in a CSV, with the unit at the end of the name. A run of a correction is drawn with
        measured and predicted values, and with the residual (``residual_...``) below. The unit of the time axis is s
        up to 10 min, min up to 3 h, and h for longer times. No line joins different runs (``run_id``).
    columns : sequence of str, optional
        Columns to draw. The default is every column of numbers except standard deviations.
    ax : matplotlib.axes.Axes or sequence of them, optional
        One axes for each unit, and one more for residuals. The default is a new figure.

    Returns
    -------
    list of matplotlib.axes.Axes
        Axes from top to bottom, with the units in the order of the columns.

    Raises
    ------
    TypeError
        The source is neither a record nor a DataFrame, or `columns` is a single text.
    ValueError
        There are no rows, a column is missing or contains text, the record has no time and no speed, or the
        number of axes differs from the number of units.

    Examples
    --------
    >>> import pandas as pd
    >>> rows = pd.DataFrame({"time_s": [0, 60, 120], "speed_rpm": [0, 5000, 5000],
    ...                      "front_bearing_temperature_C": [20.0, 22.1, 23.4],
    ...                      "housing_temperature_C": [20.0, 20.3, 20.8]})
    >>> [[line.get_label() for line in one.lines] for one in record(rows)]
    [['Speed'], ['Front bearing temperature', 'Housing temperature']]
    """
    caller = "record()"
    course = getattr(source, "course", None)
    frame = draw.frame_of(course() if callable(course) else source, caller, "record")
    if callable(course) and columns is None:
        columns = [c for c in frame.columns if f"predicted_{c}" in frame.columns or c.startswith(("predicted_", "residual_"))]
    x = next((c for c in ("time_s", "speed_rpm") if c in frame.columns), None)
    if x is None:
        raise ValueError(f"{caller}: neither time_s nor speed_rpm in this record; " "the plot needs one of these columns as abscissa")
    if isinstance(columns, str):
        raise TypeError(f"{caller}: columns must be a sequence, such as [{columns!r}]")
    if columns is None:
        columns = [c for c in frame.columns if c not in (x, "run_id") and "std_" not in c and pd.api.types.is_numeric_dtype(frame[c])]
    draw.require_columns(frame, columns, caller)
    if not columns:
        raise ValueError(f"{caller}: no column of numbers except {x}")
    panels: dict[tuple[str, bool], list[str]] = {}
    for column in columns:
        # The residual is much smaller than the displacement, so it has its own axes.
        panels.setdefault((draw.unit_of(column), column.startswith("residual_")), []).append(column)
    axes, own = _panels(ax, [unit for unit, _ in panels])
    if own and any(len(names) > 1 for names in panels.values()):
        axes[0].figure.set_figwidth(8.5)  # space for legends next to the axes
    across, label = _across(draw.numbers(frame, x, caller), x)
    for one, ((_, left), names) in zip(axes, panels.items()):
        _panel(one, own, frame, across, names, joined=x == "time_s")
        if left:
            one.axhline(0.0, color="0.5", linewidth=0.8, zorder=0.5)
    axes[-1].set_xlabel(label)
    if own:
        axes[0].figure.align_ylabels(axes)
    return axes


def _across(values: np.ndarray, x: str) -> tuple[np.ndarray, str]:
    """Return the values and the label of the abscissa. Time is in s, min or h, so that the numbers have few digits."""
    if x != "time_s":
        return values, label_of(x)
    span = np.nanmax(values) - np.nanmin(values)
    unit, size = ("h", 3600.0) if span > 10800.0 else ("min", 60.0) if span > 600.0 else ("s", 1.0)
    return values / size, f"Time in {unit}"


def _panels(ax: Axes | Sequence[Axes] | None, units: list[str]) -> tuple[list[Axes], bool]:
    """Return one axes per unit, one above the other with a common abscissa, or return the given axes. The second value is True for new axes."""
    count = len(units)
    if ax is None:
        figure = draw.new_figure()
        figure.set_figheight(0.8 + 1.8 * count if count > 1 else figure.get_figheight())
        return list(figure.subplots(count, 1, sharex=True, squeeze=False)[:, 0]), True
    given = list(np.ravel(ax)) if isinstance(ax, (list, tuple, np.ndarray)) else [ax]
    if len(given) != count:
        raise ValueError(
            f"record(): {count} units ({', '.join(unit_text(u) or 'none' for u in units)}) need "
            f"{count} axes, not {len(given)}; omit ax, or write fig, axes = plt.subplots({count}, "
            '1, sharex=True, layout="constrained") and give ax=axes'
        )
    return [draw.axes_for(one, "record()")[0] for one in given], False


def _panel(ax: Axes, own: bool, frame: pd.DataFrame, across: np.ndarray, columns: list[str], joined: bool) -> None:
    runs = frame["run_id"].to_numpy() if "run_id" in frame.columns else np.zeros(len(frame))
    starts = [0, *(np.flatnonzero(runs[1:] != runs[:-1]) + 1), len(frame)]
    for i, column in enumerate(columns):
        values = draw.numbers(frame, column, "record()")
        look = draw.style(i)
        here = np.isfinite(values)
        few = joined and 0 < here.sum() < len(values) / 2  # less than half of the rows have a reading
        if few:
            look["linestyle"] = "none"
        elif joined:
            look["markevery"] = draw.markevery(len(frame), i)
            if len(frame) > 4 * draw.MOST_MARKERS and len(columns) == 1:
                look["marker"] = None  # a single long curve needs no markers
        else:
            look["linestyle"] = "none"  # the rows of a test plan have no order
        for k, (begin, end) in enumerate(zip(starts[:-1], starts[1:])):
            ax.plot(across[begin:end], values[begin:end], markersize=4, **look, label=quantity_text(split_column(column)[0]) if k == 0 else None)
    quantity, unit = _common_words(columns), unit_text(draw.unit_of(columns[0]))
    break_ = "\n" if ax.get_subplotspec() and ax.get_subplotspec().get_gridspec().nrows > 1 else " "
    ax.set_ylabel(f"{quantity}{break_}in {unit}" if unit else quantity)  # two lines, because an axes is low
    if len(columns) > 1:
        draw.place_legend(ax, own)


def _common_words(columns: list[str]) -> str:
    """Return the name of one quantity, or the words with which all names end, such as "Temperature"."""
    words = [split_column(column)[0].removeprefix("predicted_").split("_") for column in columns]
    shared: list[str] = []
    for ends in zip(*(reversed(one) for one in words)):
        if len(set(ends)) > 1:
            break
        shared.insert(0, ends[0])
    # "displacement_ch1" and "displacement_ch2" differ at the end: take the first word.
    if not shared and len({one[0] for one in words}) == 1:
        shared = [words[0][0]]
    return quantity_text("_".join(shared)) if shared else "Value"

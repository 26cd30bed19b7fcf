"""Picture of the run of a spindle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from . import _draw as draw
from ._documents import document_of, number
from ._plot_record import _across

CALLER = "spindle_run()"
Row = dict[str, Any]


def _largest(*endings: str) -> Callable[[Row], float]:
    """Return a function that gives the largest value of the columns with these endings in a row; NaN without a value."""

    def of(row: Row) -> float:
        values = [v for key, v in row.items() if key.endswith(endings) and v is not None]
        return max(values, default=np.nan)

    return of


# Label of an axes, and function that returns its value in a row.
PANELS: tuple[tuple[str, Callable[[Row], float]], ...] = (
    ("Speed\nin rpm", _largest("speed_rpm")),
    ("Nose\nin µm", _largest("axial_displacement_um")),
    ("Front force\nin N", _largest("front_force_N")),
    ("Hottest ring\nin °C", _largest("_ring_temperature_C")),
)


def spindle_run(run: Any, *, ax: Sequence[Axes] | None = None) -> list[Axes]:
    """Draw speed, displacement of the nose, force of the front set and temperature of the hottest ring over time.

    Parameters
    ----------
    run : SpindleRun
        Result of `Model.simulate`.
    ax : sequence of matplotlib.axes.Axes, optional
        One axes for each of the four quantities. The default is a new figure.

    Returns
    -------
    list of matplotlib.axes.Axes
        Axes from top to bottom. A mark shows the highest front force, which may lie between two rows.
        A run that ended early has a dashed line at its last row.

    Raises
    ------
    TypeError
        `run` is not a SpindleRun.
    ValueError
        The run has no rows, its spindle is a network of bodies without bearing sets, or the number of
        axes is not four.

    Examples
    --------
    >>> rows = [{"time_s": 60.0 * k, "speed_rpm": 6000.0, "axial_displacement_um": 2.0 * k,
    ...          "front_force_N": 300.0 + 9.0 * k, "front_1_inner_ring_temperature_C": 20.0 + k}
    ...         for k in range(4)]
    >>> SpindleRun = type("SpindleRun", (), {"data": {
    ...     "rows": rows, "report": {"status": "converged"},
    ...     "highest_front_force": {"force_N": 327.0, "time_s": 180.0}}})
    >>> [one.get_ylabel().split(chr(10))[0] for one in spindle_run(SpindleRun())]
    ['Speed', 'Nose', 'Front force', 'Hottest ring']
    """
    data = document_of(run, ("SpindleRun",), CALLER)
    rows = data["rows"]
    if not rows:
        raise ValueError(f"{CALLER}: no row was reached, because the run ended with " f"{data['report']['status']}")
    curves = [np.array([of(row) for row in rows], dtype=float) for _, of in PANELS]
    if not np.isfinite(curves[2]).any():
        raise ValueError(f"{CALLER}: a model with [network] has no bearing sets; record(run) draws the temperatures of its nodes")
    axes, own = _axes(ax)
    seconds = np.array([row["time_s"] for row in rows], dtype=float)
    time, label = _across(seconds, "time_s")
    marker = "o" if len(rows) <= draw.MOST_MARKERS else None
    for k, (one, (words, _), values) in enumerate(zip(axes, PANELS, curves)):
        # The speed of a row applies from the time of the previous row.
        one.plot(time, values, color=draw.COLOURS[0], marker=marker, markersize=4, drawstyle="steps-pre" if k == 0 else "default")
        one.set_ylabel(words)
        one.yaxis.set_major_locator(MaxNLocator(nbins=4))
        if data["report"]["status"] != "converged":
            one.axvline(time[-1], color="0.4", linestyle="--", linewidth=0.9)
    highest = data["highest_front_force"]
    if highest["time_s"] is not None:
        at = _at(highest["time_s"], seconds, time)
        axes[2].plot([at], [highest["force_N"]], "^", color=draw.COLOURS[1], markersize=6)
        _name(axes[2], at, highest["force_N"])
    axes[-1].set_xlabel(label)
    if own:
        axes[0].figure.align_ylabels(axes)
    return axes


def _name(ax: Axes, at: float, force_N: float) -> None:
    """Label the mark of the highest force, within the axes."""
    ax.margins(y=0.25)  # space above the curve
    low, high = ax.get_xlim()
    share = (at - low) / (high - low)
    side = "left" if share < 0.2 else "right" if share > 0.8 else "center"
    ax.annotate(f"highest {number(force_N)} N", (at, force_N), xytext=(0, 6), textcoords="offset points", ha=side, va="bottom", fontsize="small")


def _at(time_s: float, seconds: np.ndarray, time: np.ndarray) -> float:
    """Return a time in the unit of the abscissa."""
    last = int(np.argmax(np.abs(seconds)))
    return time_s if seconds[last] == 0.0 else float(time_s * time[last] / seconds[last])


def _axes(ax: Sequence[Axes] | None) -> tuple[list[Axes], bool]:
    if ax is None:
        figure = draw.new_figure()
        figure.set_size_inches(7.0, 7.0)
        return list(figure.subplots(len(PANELS), 1, sharex=True)), True
    if isinstance(ax, Axes) or len(list(ax)) != len(PANELS):
        raise ValueError(
            f"{CALLER}: needs {len(PANELS)} axes; omit ax, or write fig, axes = " f"plt.subplots({len(PANELS)}, 1, sharex=True) and give ax=axes"
        )
    return [draw.axes_for(one, CALLER)[0] for one in ax], False

"""Plots of results for papers, as matplotlib axes with quantities and units.

Every function has an argument ``ax`` and returns the Axes of the plot. Without ``ax``, the function creates a new
figure of pyplot. A notebook shows this figure. ``ax.figure.savefig("name.pdf")`` writes the figure. Curves differ in
line style and marker, not only in colour. Figures have no titles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from . import _draw as draw
from ._documents import document_of, label_of
from ._plot_errors import ladder, residuals
from ._plot_record import record
from ._plot_spindle import spindle_run

__all__ = ["campbell", "contact_angles", "ladder", "record", "residuals", "spindle_run", "stribeck"]

NEAR = 0.1  # a reading has the marker of a curve if its setting differs by at most this share


def _columns(by: str | Sequence[str] | None) -> list[str]:
    return [] if by is None else [by] if isinstance(by, str) else list(by)


def _legend_title(by: list[str]) -> str:
    return ",\n".join(label_of(column) for column in by)


def stribeck(table: Any, *, by: str | Sequence[str] | None = "axial_load_N", measured: Any = None, ax: Axes | None = None) -> Axes:
    """Draw friction torque over speed, with one curve for each load.

    Parameters
    ----------
    table : Table or DataFrame
        One row per operating point, with ``speed_rpm`` [rpm], ``friction_torque_Nmm`` [N mm] and the settings.
        If the column ``friction_torque_band_Nmm`` [N mm] exists (half the width of the 95 % band), the band is
        drawn around the curve. The curve has a gap at points without a result.
    by : str or sequence of str, optional
        One or several settings. Each value of these settings has its own curve. None draws one curve of all rows.
    measured : record or DataFrame, optional
        Readings, drawn as markers without a line. A reading within 10 % of the setting of a curve has the marker
        of this curve. The marker of all other readings is a cross.
    ax : matplotlib.axes.Axes, optional
        Axes for the plot. The default is a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        ``lines`` contains the curves in the order of rising values, followed by the readings of each curve.

    Raises
    ------
    TypeError
        `table` is not a table, for example a list of tables.
    ValueError
        The table has no rows, a column is missing, no point has a torque, or a setting that is not in `by` varies.

    Examples
    --------
    >>> import pandas as pd
    >>> table = pd.DataFrame({"speed_rpm": [0, 6000, 0, 6000], "axial_load_N": [100, 100, 300, 300],
    ...                       "friction_torque_Nmm": [19.2, 285.2, 24.9, 290.8]})
    >>> ax = stribeck(table)
    >>> ax.get_ylabel(), [line.get_label() for line in ax.lines]
    ('Friction torque in N mm', ['100', '300'])
    """
    caller = "stribeck()"
    frame = draw.frame_of(table, caller, "Table")
    columns = _columns(by)
    draw.require_columns(frame, ["speed_rpm", "friction_torque_Nmm", *columns], caller)
    draw.require_one_value(frame, columns, caller)
    if not np.isfinite(draw.numbers(frame, "friction_torque_Nmm", caller)).any():
        raise ValueError(f"{caller}: no point of the table has a torque; the column status gives the reasons")
    readings = None if measured is None else draw.frame_of(measured, caller, "record")
    if readings is not None:
        draw.require_columns(readings, ["speed_rpm", "friction_torque_Nmm"], f"{caller} measured")
    ax, own = draw.axes_for(ax, caller)
    groups = draw.groups_by(frame, columns)
    for i, (values, rows) in enumerate(groups):
        rows = rows.sort_values("speed_rpm")
        look = draw.style(i)
        if readings is not None:
            look["marker"] = None  # markers are only for readings
        speed = draw.numbers(rows, "speed_rpm", caller)
        torque = draw.numbers(rows, "friction_torque_Nmm", caller)
        ax.plot(speed, torque, label=draw.value_text(columns, values) or "computed", markevery=draw.markevery(len(rows), i), **look)
        if "friction_torque_band_Nmm" in rows:
            half = draw.numbers(rows, "friction_torque_band_Nmm", caller)
            ax.fill_between(speed, torque - half, torque + half, color=look["color"], alpha=0.2, linewidth=0)
    if readings is not None:
        _readings(ax, readings, columns, [values for values, _ in groups])
    draw.speed_axis(ax, own)
    ax.set_ylabel(label_of("friction_torque_Nmm"))
    if len(ax.lines) > 1:
        draw.place_legend(ax, own, _legend_title(columns) or None)
    return ax


def _readings(ax: Axes, readings: pd.DataFrame, by: list[str], curves: list[tuple[Any, ...]]) -> None:
    """Draw readings with the marker of the nearest curve, or with a cross if no curve is near."""
    speed = draw.numbers(readings, "speed_rpm", "stribeck() measured")
    torque = draw.numbers(readings, "friction_torque_Nmm", "stribeck() measured")
    near = np.full(len(readings), -1)
    if by and all(column in readings.columns for column in by):
        settings = readings[by].to_numpy(dtype=float)
        distance = np.array(
            [np.max(np.abs(settings - np.array(c, dtype=float)) / np.maximum(np.abs(np.array(c, dtype=float)), 1e-9), axis=1) for c in curves]
        )
        closest = np.argmin(distance, axis=0)
        near = np.where(distance[closest, np.arange(len(readings))] <= NEAR, closest, -1)
    elif len(curves) == 1:
        near[:] = 0
    for i, values in enumerate(curves):
        here = near == i
        if here.any():
            text = draw.value_text(by, values)
            ax.plot(
                speed[here],
                torque[here],
                linestyle="none",
                marker=draw.style(i)["marker"],
                markersize=5,
                markerfacecolor="none",
                markeredgecolor=draw.style(i)["color"],
                label=f"{text}, measured" if text else "measured",
            )
    if (near == -1).any():
        ax.plot(
            speed[near == -1],
            torque[near == -1],
            linestyle="none",
            marker="x",
            markersize=5,
            color="0.5",
            label="measured, other" if (near >= 0).any() else "measured",
        )


def contact_angles(table: Any, *, by: str | Sequence[str] | None = None, ax: Axes | None = None) -> Axes:
    """Draw contact angles at the inner and the outer race over speed.

    Parameters
    ----------
    table : Table, Displacement or DataFrame
        For a Table, the plot shows a band that contains the angles of all balls, from
        ``inner_contact_angle_min_deg`` to ``inner_contact_angle_max_deg`` [deg]. For a shaft, every bearing has one
        angle, such as ``front_1_inner_contact_angle_deg``. Bearings with equal angles share one curve.
    by : str or sequence of str, optional
        Setting of a Table. Each value of this setting has its own pair of curves. The default is the axial load if
        it varies. Not available for a shaft.
    ax : matplotlib.axes.Axes, optional
        Axes for the plot. The default is a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        The lines of inner races are solid, and the lines of outer races are dashed. The line of the smallest angle
        comes before the line of the largest angle.

    Raises
    ------
    TypeError
        `table` is neither a table nor a displacement.
    ValueError
        The table has no rows, a column is missing, or a setting that is not in `by` varies.

    Examples
    --------
    >>> import pandas as pd
    >>> shaft = pd.DataFrame({"speed_rpm": [0, 5000],
    ...                       "front_1_inner_contact_angle_deg": [25.5, 29.9],
    ...                       "front_1_outer_contact_angle_deg": [25.5, 20.6]})
    >>> ax = contact_angles(shaft)
    >>> [line.get_label() for line in ax.lines]
    ['front 1, inner race', 'front 1, outer race']
    """
    caller = "contact_angles()"
    frame = draw.frame_of(table, caller, "Table or Displacement")
    draw.require_columns(frame, ["speed_rpm"], caller)
    ending = "_inner_contact_angle_deg"
    places = [c[: -len(ending)] for c in frame.columns if c.endswith(ending)]
    if places and by is not None:
        raise ValueError(f"{caller}: by is only possible for a Table; for a shaft, the plot has one curve for each of its bearings")
    columns = _columns(by)
    if not places:
        draw.require_columns(frame, [f"{race}_contact_angle_{end}_deg" for race in ("inner", "outer") for end in ("min", "max")], caller)
        if by is None and frame.get("axial_load_N", pd.Series(dtype=float)).nunique() > 1:
            columns = ["axial_load_N"]
        draw.require_columns(frame, columns, caller)
        draw.require_one_value(frame, columns, caller)
    ax, own = draw.axes_for(ax, caller)
    if places:
        names = _bearing_curves(ax, frame.sort_values("speed_rpm"), places)
        title = None
    else:
        names = _table_curves(ax, frame, columns)
        title = _legend_title(columns) or None
    draw.speed_axis(ax, own)
    ax.set_ylabel("Contact angle in °")
    _race_legend(ax, own, names, title)
    return ax


def _race_lines(ax: Axes, speed: np.ndarray, inner: np.ndarray, outer: np.ndarray, i: int, name: str) -> None:
    look = draw.style(i)
    for race, angle, line in (("inner", inner, "-"), ("outer", outer, "--")):
        ax.plot(
            speed,
            angle,
            color=look["color"],
            linestyle=line,
            marker=look["marker"],
            markerfacecolor=look["color"] if race == "inner" else "none",
            markevery=draw.markevery(len(speed), i),
            label=f"{name}, {race} race" if name else f"{race} race",
        )


def _bearing_curves(ax: Axes, frame: pd.DataFrame, places: list[str]) -> list[str]:
    """Draw a pair of curves for each group of bearings with equal angles. Return the names of the groups."""
    caller = "contact_angles()"
    speed = draw.numbers(frame, "speed_rpm", caller)
    alike: list[tuple[list[str], np.ndarray]] = []
    for place in places:
        both = np.array([draw.numbers(frame, f"{place}_{race}_contact_angle_deg", caller) for race in ("inner", "outer")])
        for shared, angles in alike:
            if np.allclose(angles, both, rtol=0.0, atol=1e-6, equal_nan=True):
                shared.append(place.replace("_", " "))
                break
        else:
            alike.append(([place.replace("_", " ")], both))
    names = [" and ".join(shared) for shared, _ in alike]
    for i, (_, (inner, outer)) in enumerate(alike):
        _race_lines(ax, speed, inner, outer, i, names[i])
    return names


def _table_curves(ax: Axes, frame: pd.DataFrame, by: list[str]) -> list[str]:
    """Draw a band from the smallest to the largest angle for each value of the settings. If both angles are equal, draw a line."""
    caller = "contact_angles()"
    names = []
    for i, (values, rows) in enumerate(draw.groups_by(frame, by)):
        rows = rows.sort_values("speed_rpm")
        speed = draw.numbers(rows, "speed_rpm", caller)
        names.append(draw.value_text(by, values))
        ends = {race: [draw.numbers(rows, f"{race}_contact_angle_{end}_deg", caller) for end in ("min", "max")] for race in ("inner", "outer")}
        _race_lines(ax, speed, ends["inner"][0], ends["outer"][0], i, names[-1])
        if any(np.nanmax(np.append(high - low, 0.0)) > 0.0 for low, high in ends.values()):
            _race_lines(ax, speed, ends["inner"][1], ends["outer"][1], i, "")
            for low, high in ends.values():
                ax.fill_between(speed, low, high, color=draw.style(i)["color"], linewidth=0, alpha=0.15)
    return names


def _race_legend(ax: Axes, own: bool, names: list[str], title: str | None) -> None:
    """Place a legend with the line style of each race and the marker of each group. This legend has fewer entries than a legend of all curves."""
    ink = mpl.rcParams["text.color"]
    races = [Line2D([], [], color=ink, linestyle="-", label="inner race"), Line2D([], [], color=ink, linestyle="--", label="outer race")]
    marks = [
        Line2D([], [], linestyle="none", marker=draw.style(i)["marker"], color=draw.style(i)["color"], label=name)
        for i, name in enumerate(names)
        if name
    ]
    if title and marks:
        marks.insert(0, Line2D([], [], linestyle="none", label=title))
    draw.place_legend(ax, own, None, races + marks)


def campbell(modes: Any, *, ax: Axes | None = None) -> Axes:
    """Draw the natural frequencies of the shaft over speed, with the line of one excitation per revolution.

    Parameters
    ----------
    modes : Modes
        Result of `Model.modes`. Its ``data`` contains ``rows`` with ``speed_rpm`` [rpm] and ``modes``. Each mode has ``frequency_Hz``
        [Hz] and ``whirl``: backward, forward, or standing (as at standstill).
    ax : matplotlib.axes.Axes, optional
        Axes for the plot. The default is a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        The lines of forward whirl are solid, the lines of backward whirl are dashed, and the lines of standing modes
        are dotted. One line connects the first mode of a whirl direction at all speeds. The next line connects the
        second mode. ``lines[-1]`` is the line of one excitation per revolution (1×).

    Raises
    ------
    TypeError
        `modes` has another type.
    ValueError
        No speed has modes.

    Examples
    --------
    >>> def at(n):
    ...     split = n / 1000.0
    ...     return {"speed_rpm": n, "modes": [
    ...         {"frequency_Hz": 900.0 - split, "whirl": "backward"},
    ...         {"frequency_Hz": 900.0 + split, "whirl": "forward"}]}
    >>> Modes = type("Modes", (), {"data": {"rows": [at(5000.0), at(10000.0)]}})
    >>> ax = campbell(Modes())
    >>> [float(f) for f in ax.lines[0].get_ydata()], ax.get_ylabel()
    ([905.0, 910.0], 'Frequency in Hz')
    """
    caller = "campbell()"
    data = document_of(modes, ("Modes",), caller)
    rows = sorted((row for row in data.get("rows", []) if row.get("modes")), key=lambda row: row["speed_rpm"])
    if not rows:
        raise ValueError(f"{caller}: no speed has modes; the key report of each row gives the reason")
    ax, own = draw.axes_for(ax, caller)
    speeds = np.array([row["speed_rpm"] for row in rows])
    # Backward whirl is drawn after forward whirl, so that its dashes are visible on a solid line nearby.
    looks = {"forward": ("-", "#0072B2", "forward whirl"), "backward": ("--", "#D55E00", "backward whirl"), "standing": (":", "#009E73", "standing")}
    for whirl, (line, colour, words) in looks.items():
        for i, branch in enumerate(_branches(rows, whirl)):
            ax.plot(
                speeds,
                branch,
                linestyle=line,
                color=colour,
                marker=draw.MARKERS[i % 9],
                markersize=4,
                markerfacecolor=colour if whirl == "forward" else "none",
                markevery=draw.markevery(len(speeds), i),
                label=words if i == 0 else None,
            )
    top = ax.get_ylim()[1]
    # The line 1× needs a length even if the only speed is 0.
    end = speeds[-1] if speeds[-1] > 0.0 else 1000.0
    ax.plot([0.0, end], [0.0, end / 60.0], color=mpl.rcParams["text.color"], linewidth=0.9, label="1×")
    ax.set_ylim(0.0, max(top, 1.05 * end / 60.0))
    ax.set_xlim(0.0, 1.02 * end)
    draw.speed_axis(ax, own)
    ax.set_ylabel("Frequency in Hz")
    draw.place_legend(ax, own)
    return ax


def _branches(rows: list[dict[str, Any]], whirl: str) -> list[np.ndarray]:
    """Return the frequencies of the first, second and further modes of this whirl direction at each speed. A missing mode is NaN.

    At standstill, modes come in pairs. The lower mode of a pair starts the backward branch.
    """
    found = []
    for row in rows:
        by_whirl = {w: sorted(m["frequency_Hz"] for m in row["modes"] if m["whirl"] == w) for w in ("backward", "forward", "standing")}
        if row["speed_rpm"] == 0.0 and len(rows) > 1:
            pairs = by_whirl.pop("standing")
            by_whirl = {"backward": pairs[0::2], "forward": pairs[1::2], "standing": []}
        found.append(by_whirl[whirl])
    count = max(len(one) for one in found)
    return [np.array([one[i] if i < len(one) else np.nan for one in found]) for i in range(count)]

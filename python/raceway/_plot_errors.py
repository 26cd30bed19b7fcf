"""Pictures of errors: the RMS errors of several models as bars, and the map of the errors of one model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from . import _draw as draw
from ._documents import Ladder, error_unit, kind_of, label_of, ladders_of, number, quantity_text

LARGEST_MARK = 260.0  # area of the mark of the largest error [points²]


def ladder(*results: Any, labels: Sequence[str] | None = None, ax: Axes | None = None) -> Axes:
    """Draw RMS errors of models as bars with their numbers, and below them the noise of the data.

    Parameters
    ----------
    *results : Comparison, Diagnosis, Addition or Calibration
        Results from top to bottom. A Diagnosis has bars without and with the named effects. An Addition
        also has bars on held-out rows. Only the first of several measured channels is drawn.
    labels : sequence of str, optional
        Labels of all bars except the noise. The default is the name of the model file, or "before" and "after".
    ax : matplotlib.axes.Axes, optional
        Axes for the picture. The default is a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        ``patches`` are the bars from top to bottom. The width of a bar is the error in the unit of the readings.

    Raises
    ------
    TypeError
        A result has another type, such as a list of comparisons. Give comparisons one by one.
    ValueError
        There is no result, the results have different units, or the numbers of labels and bars differ.

    Examples
    --------
    >>> Comparison = type("Comparison", (), {"data": {
    ...     "model": "my.toml", "quantity": "friction_torque", "unit": "Nmm", "rmse": 44.9,
    ...     "noise": {"rms": 10.1, "source": "declared"}}})
    >>> ax = ladder(Comparison())
    >>> [bar.get_width() for bar in ax.patches], ax.get_xlabel()
    ([44.9, 10.1], 'RMS error of friction torque in N mm')
    """
    caller = "ladder()"
    if not results:
        raise ValueError(f"{caller}: nothing to draw; give a Comparison, Diagnosis or Addition")
    ladders = []
    for result in results:
        found = ladders_of(result, caller)
        found = found[:1] if "channels" in result.data else found
        if len(results) > 1 and kind_of(result) != "Comparison":  # a bar label needs the name of the result
            for step in (step for one in found for step in one.steps):
                step.label += f" ({kind_of(result).lower()})"
        ladders += found
    unit, quantity = ladders[0].unit, ladders[0].quantity
    for one in ladders:
        if one.unit != unit:
            raise ValueError(f"{caller}: errors in {error_unit(unit)} and in " f"{error_unit(one.unit)} have no common axis; draw them one by one")
    bars = [(step.label, step.rmse, step.kind) for one in ladders for step in one.steps]
    if labels is not None:
        if isinstance(labels, str) or len(labels) != len(bars):
            raise ValueError(f"{caller}: labels must be a sequence of {len(bars)} texts, one for each bar")
        bars = [(label, rmse, kind) for label, (_, rmse, kind) in zip(labels, bars)]
    bars += _noise_bars(ladders)
    ax, own = draw.axes_for(ax, caller)
    _bars(ax, bars, own)
    tolerances = {one.tolerance for one in ladders if one.tolerance is not None}
    for allowed in tolerances:
        ax.axvline(allowed, color=mpl.rcParams["text.color"], linestyle=":")
        ax.annotate(
            f"tolerance {number(allowed)}", (allowed, 1.0), xytext=(0, 2), ha="center", xycoords=("data", "axes fraction"), textcoords="offset points"
        )
    words = f" of {quantity_text(quantity).lower()}" if quantity else ""
    ax.set_xlabel(f"RMS error{words} in {error_unit(unit)}")
    return ax


def _noise_bars(ladders: list[Ladder]) -> list[tuple[str, float, str]]:
    """Return one bar if all noise values agree within 1 % (a refit changes the last digits). Otherwise, return one bar for each value."""
    known = [(one.noise_words, one.noise) for one in ladders if one.noise is not None]
    if not known:
        return []
    sizes = [size for _, size in known]
    if max(sizes) <= 1.01 * min(sizes):
        return [(known[-1][0], known[-1][1], "noise")]
    return [(f"{words}, {one.steps[0].label}", one.noise, "noise") for one in ladders if one.noise is not None for words in [one.noise_words]]


def _bars(ax: Axes, bars: list[tuple[str, float, str]], own: bool) -> None:
    # The bars differ without colour: light, dark, and two hatches.
    looks = {
        "before": {"color": "0.72"},
        "model": {"color": "0.72"},
        "after": {"color": "#0072B2"},
        "held out": {"facecolor": "none", "edgecolor": "#0072B2", "hatch": "////"},
        "noise": {"facecolor": "none", "edgecolor": "0.45", "hatch": "...."},
    }
    largest = max([rmse for _, rmse, _ in bars if rmse is not None] + [0.0])
    for place, (_, rmse, kind) in enumerate(bars):
        width = float("nan") if rmse is None else rmse
        ax.barh(place, width, height=0.62, linewidth=0.8, **looks[kind])
        ax.annotate(
            number(rmse), (width if rmse is not None else 0.0, place), xytext=(4, 0), textcoords="offset points", va="center", annotation_clip=False
        )
    ax.set_yticks(range(len(bars)), [label for label, _, _ in bars])
    ax.set_ylim(len(bars) - 0.4, -0.6)
    ax.set_xlim(0.0, 1.16 * largest if largest > 0.0 else 1.0)  # space for the numbers next to the bars
    ax.tick_params(axis="y", length=0)
    ax.spines[["top", "right"]].set_visible(False)
    if own:
        ax.figure.set_figheight(max(1.6, 0.9 + 0.38 * len(bars)))


def residuals(comparison: Any, x: str = "speed_rpm", y: str | None = "axial_load_N", *, ax: Axes | None = None) -> Axes:
    """Draw residuals over one setting, or as a map over two settings.

    Parameters
    ----------
    comparison : Comparison or DataFrame
        One row per reading, with its settings and ``error``, the prediction minus the reading in the unit
        of the reading. Rows without a prediction are left out.
    x, y : str
        Columns of settings. With ``y=None`` the vertical axis shows the residuals, and the band of the noise if the noise is known.
    ax : matplotlib.axes.Axes, optional
        Axes for the picture. The default is a new figure.

    Returns
    -------
    matplotlib.axes.Axes
        A filled triangle that points up means that the prediction is too high. An open triangle that points down
        means that the prediction is too low. The area of a triangle grows with the residual.

    Raises
    ------
    TypeError
        The comparison has another type, such as a list.
    ValueError
        There are no rows, no row has a prediction, or a column is missing. The message lists the columns.

    Examples
    --------
    >>> import pandas as pd
    >>> rows = pd.DataFrame({"speed_rpm": [600, 9000], "axial_load_N": [250, 900],
    ...                      "measured": [80.0, 540.0], "predicted": [84.0, 520.0],
    ...                      "error": [4.0, -20.0]})
    >>> ax = residuals(rows)
    >>> ax.get_xlabel(), ax.get_ylabel()
    ('Speed in rpm', 'Axial load in N')
    """
    caller = "residuals()"
    frame = draw.frame_of(comparison, caller, "Comparison")
    draw.require_columns(frame, ["error", x] + ([y] if y else []), caller)
    used = [draw.numbers(frame, column, caller) for column in ("error", x, *([y] if y else []))]
    here = np.all(np.isfinite(used), axis=0)
    if not here.any():
        raise ValueError(f"{caller}: no row has a prediction and values of {x}" f"{' and ' + y if y else ''}")
    error, across, *up = [values[here] for values in used]
    data = getattr(comparison, "data", None) or {}
    unit = error_unit(getattr(comparison, "unit", None) or data.get("unit"))
    ax, own = draw.axes_for(ax, caller)
    if up:
        _error_map(ax, own, across, up[0], error, unit)
        ax.set_ylabel(label_of(y or ""))
    else:
        _errors_upright(ax, own, across, error, data)
        ax.set_ylabel("Prediction minus reading" + (f" in {unit}" if unit else ""))
    ax.set_xlabel(label_of(x))
    return ax


def _marks(error: np.ndarray) -> tuple[tuple[np.ndarray, str, str, str], ...]:
    return ((error > 0.0, "^", "#D55E00", "too much"), (error <= 0.0, "v", "none", "too little"))


def _error_map(ax: Axes, own: bool, x: np.ndarray, y: np.ndarray, error: np.ndarray, unit: str) -> None:
    largest = float(np.max(np.abs(error))) or 1.0
    area = LARGEST_MARK * np.abs(error) / largest
    for order, place in enumerate(np.argsort(-area, kind="stable")):
        up = error[place] > 0.0
        # Large marks are drawn first, each with a rim, so that small marks at the same point stay visible.
        ax.scatter(
            x[place],
            y[place],
            s=max(area[place], 4.0),
            marker="^" if up else "v",
            facecolor="#D55E00" if up else "none",
            edgecolor=ax.get_facecolor() if up else "#0072B2",
            linewidth=0.6 if up else 1.1,
            zorder=3 + order / len(area),
        )
    sizes = [largest, 0.5 * largest, 0.1 * largest]
    handles = []
    for up in (True, False):
        for size in sizes:
            handles.append(
                Line2D(
                    [],
                    [],
                    linestyle="none",
                    marker="^" if up else "v",
                    markersize=np.sqrt(LARGEST_MARK * size / largest),
                    markerfacecolor="#D55E00" if up else "none",
                    markeredgecolor="none" if up else "#0072B2",
                    label=f"{'+' if up else '−'}{number(size, 2)}",
                )
            )
    ax.margins(0.08)
    if not draw.has_room(ax, own):
        left, right = ax.get_xlim()  # space for the legend, which must not hide marks
        ax.set_xlim(left, right + 0.5 * (right - left))
    draw.place_legend(ax, own, "Prediction\nminus reading" + (f"\nin {unit}" if unit else ""), handles, spacing=0.9)


def _errors_upright(ax: Axes, own: bool, x: np.ndarray, error: np.ndarray, data: dict[str, Any]) -> None:
    ax.axhline(0.0, color=mpl.rcParams["axes.edgecolor"], linewidth=0.8)
    noise = data.get("noise", {}).get("rms")
    if noise is not None:
        ax.axhspan(-noise, noise, color="0.5", alpha=0.25, linewidth=0, label="± noise")
    for here, marker, face, words in _marks(error):
        if here.any():
            edge = "#D55E00" if marker == "^" else "#0072B2"
            ax.plot(x[here], error[here], linestyle="none", marker=marker, markerfacecolor=face, markeredgecolor=edge, markersize=5, label=words)
    draw.place_legend(ax, own)

"""Functions that read the JSON documents of results: kinds of results, names and units of columns, RMS errors.

The plots, the notebook representations and the reports use these functions. The functions read only the documents
that the command prints with ``--json``.
"""

from __future__ import annotations

import math
import os
import re
from dataclasses import dataclass, field
from typing import Any

KINDS = (
    "Solution",
    "Table",
    "Displacement",
    "Comparison",
    "Calibration",
    "Diagnosis",
    "Addition",
    "SteadyStates",
    "SpindleRun",
    "Modes",
    "Deflection",
    "StepResponses",
)

# Endings of column names. An ending that contains another ending comes first, such as N_um before um.
UNITS = {
    "N_um": "N/µm",
    "Nm_rad": "N m/rad",
    "N_rad": "N/rad",
    "rad_s": "rad/s",
    "mm2_s": "mm²/s",
    "kgm2": "kg m²",
    "Nmm": "N mm",
    "Nm": "N m",
    "MPa": "MPa",
    "GPa": "GPa",
    "rpm": "rpm",
    "mrad": "mrad",
    "urad": "µrad",
    "deg": "°",
    "um": "µm",
    "mm": "mm",
    "Hz": "Hz",
    "C": "°C",
    "K": "K",
    "N": "N",
    "W": "W",
    "V": "V",
    "s": "s",
    "percent": "%",
}


def kind_of(result: object) -> str:
    """Search the class hierarchy of a result, and return the first class name that is in KINDS; "" if there is none."""
    for one in type(result).__mro__:
        if one.__name__ in KINDS:
            return one.__name__
    return ""


def document_of(result: object, kinds: tuple[str, ...], caller: str) -> dict[str, Any]:
    """Return the document of a result, which must be of one of these kinds.

    Raises
    ------
    TypeError
        The result is of another kind. The message names the accepted kinds.
    """
    kind = kind_of(result)
    if kind in kinds and isinstance(getattr(result, "data", None), dict):
        return result.data  # type: ignore[attr-defined]
    wanted = " or ".join(kinds)
    if isinstance(result, (list, tuple)):
        raise TypeError(f"{caller} accepts a {wanted}, not a {type(result).__name__}; give its elements one by one")
    raise TypeError(f"{caller} accepts a {wanted}, not {kind or type(result).__name__!r}")


def split_column(column: str) -> tuple[str, str]:
    """Split the name of a column into quantity and unit key: "axial_load_N" gives ("axial_load", "N").

    >>> split_column("front_axial_N_um"), split_column("lost_balls")
    (('front_axial', 'N_um'), ('lost_balls', ''))
    """
    for unit in UNITS:
        if column.endswith("_" + unit):
            return column[: -len(unit) - 1], unit
    return column, ""


def unit_text(unit: str | None) -> str:
    """Return the printed form of a unit key from a document; "" for a number without unit.

    >>> unit_text("Nmm"), unit_text("1"), unit_text("um/W")
    ('N mm', '', 'µm/W')
    """
    if not unit or unit in ("1", "-"):
        return ""
    of, per, what = unit.partition("/")
    return UNITS.get(unit, UNITS.get(of, of) + per + what)


def in_unit_of(displacement: str, name: str) -> str:
    """Return the key of a number that belongs to a displacement. For an angle, "um" in the name is replaced by "urad".

    >>> in_unit_of("displacement_z_um", "rmse_um"), in_unit_of("displacement_b_urad", "rmse_um")
    ('rmse_um', 'rmse_urad')
    """
    return re.sub(r"(?<![^\W_])um(?![^\W_])", "urad", name) if displacement.endswith("_urad") else name


def error_unit(unit: str | None) -> str:
    """Return the unit of an error as the command prints it. For temperatures, the unit of an error is K.

    >>> error_unit("C"), error_unit("Nmm")
    ('K', 'N mm')
    """
    return "K" if unit == "C" else unit_text(unit)


def effect_name(effect: dict[str, Any]) -> str:
    """Return the id of an effect of a diagnosis, with the channel or the axis on which the effect acts.

    >>> effect_name({"id": "sensor-offset", "channel": "flange_temperature"})
    'sensor-offset (flange_temperature)'
    """
    where = [str(effect[key]) for key in ("channel", "axis") if effect.get(key)]
    return effect["id"] + (f" ({', '.join(where)})" if where else "")


def quantity_text(quantity: str) -> str:
    """Return the name of a quantity as text for the label of an axis.

    >>> quantity_text("inner_contact_angle_max")
    'Inner contact angle max'
    """
    words = quantity.replace("_", " ").strip()
    return words[:1].upper() + words[1:]


def label_of(column: str) -> str:
    """Return quantity and unit of a column as the label of an axis.

    >>> label_of("friction_torque_Nmm")
    'Friction torque in N mm'
    """
    quantity, unit = split_column(column)
    text = unit_text(unit)
    return quantity_text(quantity) + (f" in {text}" if text else "")


def number(value: float | None, digits: int = 3) -> str:
    """Return a number as the command prints it; "-" for None, NaN and infinity.

    >>> number(44.8967), number(None), number(1914.1), number(2.7e-59)
    ('44.9', '-', '1914', '2.7e-59')
    """
    if value is None or not math.isfinite(value):
        return "-"
    size = abs(value)
    if size != 0.0 and not 1e-4 <= size < 1e6:
        return f"{value:.{digits}g}"
    # All digits before the decimal point are printed: 1914, not 1.91e+03.
    before = int(math.floor(math.log10(size))) + 1 if size >= 1.0 else 0
    return f"{value:.{max(digits, before)}g}"


def name_of_file(path: str) -> str:
    """Return the last part of a path, for the label of a bar."""
    return os.path.basename(path.replace("\\", "/")) or path


def files_text(data: object) -> str:
    """Return the names of one or several data files, separated by commas."""
    if isinstance(data, (list, tuple)):
        return ", ".join(str(one) for one in data)
    return str(data) if data else ""


@dataclass
class Step:
    """RMS error of one model."""

    label: str
    rmse: float
    kind: str  # "before", "after", "model", "held out", "noise"


@dataclass
class Ladder:
    """RMS errors from the first to the last model, and the RMS of the noise, in one unit."""

    unit: str
    quantity: str = ""
    steps: list[Step] = field(default_factory=list)
    noise: float | None = None
    noise_words: str = "noise"
    tolerance: float | None = None


def noise_of(noise: dict[str, Any] | None) -> tuple[float | None, str]:
    """Return the RMS of the noise (None if it is unknown) and its label: "noise" or "noise, estimated"."""
    noise = noise or {}
    if noise.get("rms") is not None:
        return float(noise["rms"]), "noise"
    if noise.get("estimated_rms") is not None:
        return float(noise["estimated_rms"]), "noise, estimated"
    return None, "noise"


def _tolerance(part: dict[str, Any]) -> float | None:
    return part.get(f"tolerance_{part.get('unit')}")


def _of_comparison(part: dict[str, Any], model: str) -> Ladder:
    noise, words = noise_of(part.get("noise"))
    step = Step(name_of_file(model) or "model", part["rmse"], "model")
    return Ladder(part["unit"], part.get("quantity", ""), [step], noise, words, _tolerance(part))


def _of_fit(part: dict[str, Any], noise: dict[str, Any] | None, after: str) -> Ladder:
    size, words = noise_of(noise)
    # A document without noise does not state whether the noise is known.
    words = words if noise is not None else ""
    ladder = Ladder(part["unit"], part.get("quantity", ""), noise=size, noise_words=words, tolerance=_tolerance(part))
    ladder.steps = [Step("before", part["rmse_before"], "before"), Step("after", part[after], "after")]
    for word in ("before", "after"):
        held_out = part.get(f"rmse_held_out_{word}")
        if held_out is not None:
            ladder.steps.append(Step(f"{word}, held out", held_out, "held out"))
    return ladder


def ladders_of(result: object, caller: str = "ladder()") -> list[Ladder]:
    """Return the RMS errors of each model and measured channel of a Comparison, Calibration, Diagnosis or Addition."""
    data = document_of(result, ("Comparison", "Calibration", "Diagnosis", "Addition"), caller)
    kind = kind_of(result)
    if kind == "Calibration" and "rmse" not in data:
        raise ValueError(f"{caller}: this Calibration was not fitted to readings, so it has no RMS error")
    if kind == "Comparison":
        ladders = []
        for model in data.get("models", [data]):
            for part in model.get("channels", [model]):
                ladders.append(_of_comparison(part, str(model.get("model", ""))))
        return ladders
    if kind == "Calibration":
        return [_of_fit(part, None, "rmse") for part in data.get("channels", [data])]
    if kind == "Diagnosis":
        whole = {**data, "quantity": data.get("baseline", {}).get("quantity", "")}
        return [_of_fit(part, part.get("noise"), "rmse_after") for part in data.get("channels", [whole])]
    before = data["before"]
    whole = {
        **data,
        "quantity": before.get("quantity", ""),
        "rmse_before": before["rmse"],
        "rmse_after": data["after"]["rmse"],
        f"tolerance_{data['unit']}": before.get(f"tolerance_{data['unit']}"),
    }
    noises = [part.get("noise") for part in before.get("channels", [before])]
    return [_of_fit(part, noise, "rmse_after") for part, noise in zip(data.get("channels", [whole]), noises)]

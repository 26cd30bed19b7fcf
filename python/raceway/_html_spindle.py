"""Results of a spindle in a notebook, drawn with the functions of _html.py."""

from __future__ import annotations

import re
from typing import Any

from ._documents import number, split_column, unit_text
from ._html import _FAINT, heading, messages_html, paragraph, table, text

MOST_ROWS = 12  # speeds or steps that are shown; the document contains all

Row = dict[str, Any]


def _title(name: object, words: str) -> str:
    return paragraph(f"<b>{text(name)}</b> {text(words)}")


def _messages(result: Any) -> str:
    return messages_html({"messages": list(getattr(result, "warnings", [])), "notes": list(getattr(result, "notes", []))})


def _some(rows: list[Any]) -> tuple[list[Any], str]:
    """Return evenly spaced rows, including the first and the last row, and a note on the omitted rows."""
    if len(rows) <= MOST_ROWS:
        return rows, ""
    last = len(rows) - 1
    some = [rows[round(k * last / (MOST_ROWS - 1))] for k in range(MOST_ROWS)]
    return some, paragraph(f"{MOST_ROWS} of {len(rows)} rows; all are in data", _FAINT)


def _bearings(row: Row) -> list[str]:
    """Return the names of the bearings in the columns of a row: front_1, front_2, ..., roller bearings."""
    return [m[1] for m in (re.fullmatch(r"(.+)_inner_ring_temperature_C", key) for key in row) if m]


def _hottest_ring(row: Row) -> float | None:
    """Return the temperature of the hottest ring [C]; None without rings."""
    rings = [v for key, v in row.items() if key.endswith("_ring_temperature_C") and v is not None]
    return max(rings, default=None)


def _temperatures(row: Row) -> str:
    """Return tables of ring temperatures and forces, then of all other temperatures."""
    places = _bearings(row)
    out = ""
    if places:
        out = table(
            ["bearing", "inner ring in °C", "outer ring in °C", "axial force in N", "radial in N"],
            [
                [
                    text(p.replace("_", " ")),
                    number(row.get(f"{p}_inner_ring_temperature_C"), 3),
                    number(row.get(f"{p}_outer_ring_temperature_C"), 3),
                    number(row.get(f"{p}_force_N")),
                    number(row.get(f"{p}_radial_force_N")),
                ]
                for p in places
            ],
        )
    others = [key for key in row if key.endswith("_C") and "_ring_temperature" not in key]
    if others:
        out += table(
            ["sensor", "temperature in °C"],
            [[text(split_column(key)[0].removesuffix("_temperature").replace("_", " ")), number(row[key], 3)] for key in others],
        )
    return out


def _heat(row: Row) -> str:
    words = {
        "friction_power_W": "friction",
        "drive_heat_W": "drives",
        "heat_to_coolant_W": "to the coolant",
        "heat_to_air_W": "to the air",
        "heat_to_machine_W": "to the machine",
    }
    found = [f"{number(row[key])} W {name}" for key, name in words.items() if row.get(key) is not None]
    return paragraph(text("heat: " + ", ".join(found))) if found else ""


def _nose(row: Row) -> str:
    if row.get("axial_displacement_um") is None:
        return ""
    return paragraph(
        text(
            f"nose relative to flange {_rounded(row['axial_displacement_um'], 1.0, 4)} µm, of which the sets cause "
            f"{number(row['kinematic_displacement_um'])} µm; preload "
            f"{number(row['front_force_N'])} N front, {number(row['rear_force_N'])} N rear"
        )
    )


def _signed(value: float) -> str:
    return ("+" if value > 0.0 else "") + number(value, 2)


def _rounded(value: float | None, size: float, digits: int = 3) -> str:
    """Return a value as text. The text is zero if the value is only a rounding error of numbers of this size."""
    return number(0.0 if value is not None and abs(value) < 1e-9 * size else value, digits)


def _mesh(report: Row) -> str:
    mesh = report.get("mesh_estimate")
    cells = f"{report.get('cells')} cells"
    if mesh:
        cells += (
            f"; {mesh['other_cells']} give {_signed(-mesh['axial_displacement_um'])} µm, "
            f"{_signed(-mesh['inner_ring_temperature_K'])} K at the hottest inner ring and "
            f"{_signed(-mesh['front_force_N'])} N in the front set at the steady state at "
            f"{number(mesh['speed_rpm'], 5)} rpm"
        )
    return paragraph(text(cells), _FAINT)


def _steady(result: Any) -> str:
    data = result.data
    states = data["steady"]
    status = [s["report"]["status"] for s in states]
    if len(states) == 1:
        one = states[0]
        out = _title(data["spindle"], f"at {number(one['speed_rpm'], 5)} rpm: {status[0]}")
        if status[0] == "converged":
            out += _temperatures(one) + _nose(one) + _heat(one)
            if one.get("axial_stiffness_N_um") is not None:
                out += paragraph(text("axial stiffness of the warm sets " f"{number(one['axial_stiffness_N_um'])} N/µm"))
        return out + _mesh(one["report"]) + _messages(result)
    head = ["speed in rpm", "friction in W", "nose in µm", "front in N", "rear in N", "hottest ring in °C", ""]
    shown, left_out = _some(states)
    rows = [
        [
            number(s["speed_rpm"], 5),
            number(s["friction_power_W"] if s["report"]["status"] == "converged" else None),
            _rounded(s.get("axial_displacement_um"), 1.0),
            number(s.get("front_force_N")),
            number(s.get("rear_force_N")),
            number(_hottest_ring(s)),
            "" if s["report"]["status"] == "converged" else text(s["report"]["status"]),
        ]
        for s in shown
    ]
    return _title(data["spindle"], f"steady at {len(states)} speeds") + table(head, rows, left=0) + left_out + _messages(result)


def _run(result: Any) -> str:
    data = result.data
    rows, report = data["rows"], data["report"]
    out = _title(data["spindle"], f"{data['rows_reached']} of {data['rows_asked']} rows: {report['status']}")
    if not rows:
        return out + _messages(result)
    nose = [r for r in rows if r.get("axial_displacement_um") is not None]
    lines = []
    if nose:
        low = min(nose, key=lambda r: r["axial_displacement_um"])
        high = max(nose, key=lambda r: r["axial_displacement_um"])
        lines.append(
            [
                "nose relative to flange in µm",
                number(rows[-1]["axial_displacement_um"]),
                number(low["axial_displacement_um"]),
                _at(low["time_s"]),
                number(high["axial_displacement_um"]),
                _at(high["time_s"]),
            ]
        )
        highest = data["highest_front_force"]
        lines.append(
            [
                "force of the front set in N",
                number(rows[-1]["front_force_N"]),
                *_least(rows, "front_force_N"),
                number(highest["force_N"]),
                _at(highest["time_s"]),
            ]
        )
    power = "friction_power_W"
    most = max(rows, key=lambda r: r[power])
    lines.append(["friction in W", number(rows[-1][power]), *_least(rows, power), number(most[power]), _at(most["time_s"])])
    rings = [(h, r) for r in rows if (h := _hottest_ring(r)) is not None]
    if rings:
        most_ring, where = max(rings, key=lambda pair: pair[0])
        least_ring, first = min(rings, key=lambda pair: pair[0])
        lines.append(["hottest ring in °C", number(rings[-1][0]), number(least_ring), _at(first["time_s"]), number(most_ring), _at(where["time_s"])])
    out += table(["", "at the end", "smallest", "at", "largest", "at"], lines)
    out += heading(f"At the last row, {_at(rows[-1]['time_s'])}") + _temperatures(rows[-1])
    return out + _mesh(report) + _messages(result)


def _least(rows: list[Row], key: str) -> list[str]:
    least = min(rows, key=lambda r: r[key])
    return [number(least[key]), _at(least["time_s"])]


def _at(time_s: float | None) -> str:
    """Return a time of a run as text with few digits, in s, min or h."""
    if time_s is None:
        return "-"
    for size, unit in ((3600.0, "h"), (60.0, "min")):
        if time_s >= 3.0 * size:
            return f"{number(time_s / size)} {unit}"
    return f"{number(time_s)} s"


_LETTERS = {"backward": " b", "forward": " f"}


def _modes(result: Any) -> str:
    data = result.data
    shown, left_out = _some(data["rows"])
    count = max((len(r.get("modes") or []) for r in shown), default=0)
    rows = []
    for r in shown:
        found = r.get("modes") or []
        cells = [f"{m['frequency_Hz']:.1f}{_LETTERS.get(m['whirl'], '')}" for m in found]
        cells += ["-"] * (count - len(cells))
        rows.append([number(r["speed_rpm"], 5), number(r.get("front_force_N")), *map(text, cells)])
    head = ["speed in rpm", "front in N", *(f"f{k + 1} in Hz" for k in range(count))]
    return (
        paragraph(f"<b>{text(data['model'])}</b> natural frequencies, b backward, f forward " "whirl")
        + table(head, rows, left=0)
        + left_out
        + _messages(result)
    )


def _deflection(result: Any) -> str:
    data = result.data
    loads = [f"{number(data['force_N'])} N {data['direction']}"]
    if data["direction"] == "radial" and data.get("axial_force_N"):
        loads.append(f"{number(data['axial_force_N'])} N axial")
    if data.get("moment_Nm"):
        loads.append(f"{number(data['moment_Nm'])} N m")
    out = _title(
        data["model"], f"under {', '.join(loads)} at {number(data['at_mm'])} mm, " f"{number(data['speed_rpm'], 5)} rpm: {data['report']['status']}"
    )
    if data["displacement_um"] is None:
        return out + _messages(result)
    where = f"displacement at the load {number(data['displacement_um'], 4)} µm"
    if data["stiffness_N_um"] is not None:
        where += f", {number(data['stiffness_N_um'], 4)} N/µm"
    if data["direction"] == "radial":
        where += f"; nose {number(data['nose_displacement_um'], 4)} µm, slope " f"{number(data['nose_slope_urad'], 4)} µrad"
    out += paragraph(text(where))
    load = abs(data["force_N"]) + abs(data.get("moment_Nm") or 0.0)
    rows = [
        [
            text(b["place"].replace("_", " ")),
            _rounded(b["axial_load_N"], load),
            _rounded(b["radial_load_N"], load),
            number(b["largest_inner_load_N"]),
            text(b["lost_balls"]),
            number(b["axial_stiffness_N_um"]),
            number(b["radial_stiffness_N_um"]),
        ]
        for b in data["bearings"]
    ]
    head = ["bearing", "axial in N", "radial in N", "largest ball load in N", "lost balls", "axial N/µm", "radial N/µm"]
    return out + table(head, rows) + _messages(result)


def _steps(result: Any) -> str:
    data = result.data
    shown, left_out = _some(data["rows"])
    rows = [
        [
            text(r["load_case"]) if r.get("load_case") else f"{number(r['speed_rpm'], 5)} rpm",
            number(r["power_end_W"]),
            number(r["kinematic_um"]),
            number(r["K_um"]),
            number(r["T_min"]),
            number(r["fit_rms_um"], 2),
            "" if r["status"] == "converged" else text(r["status"]),
        ]
        for r in shown
    ]
    head = ["step", "power in W", "immediate in µm", "K in µm", "T in min", "residual in µm", ""]
    out = paragraph("thermal displacement after a step: K (1 - exp(-t/T)), power at its end")
    out += table(head, rows) + left_out
    for name, unit in (("K", "um"), ("T", "min")):
        line = data[f"{name}_of_P"]
        if line[f"slope_{unit}_W"] is not None:
            out += paragraph(
                text(f"{name} = {number(line[f'slope_{unit}_W'])} " f"{unit_text(unit)}/W P + {number(line[f'offset_{unit}'])} " f"{unit_text(unit)}")
            )
    return out + _messages(result)


WRITERS = {"SteadyStates": _steady, "SpindleRun": _run, "Modes": _modes, "Deflection": _deflection, "StepResponses": _steps}

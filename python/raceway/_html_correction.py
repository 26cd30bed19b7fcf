"""Corrections and their results in a notebook; see _html."""

from __future__ import annotations

from typing import Any

from ._documents import files_text, in_unit_of, number, unit_text
from ._html import _FAINT, heading, messages_html, paragraph, table, text

FEW = 24  # rows of a table that are shown


def _page(inner: str) -> str:
    return f'<div style="line-height:1.4;color:inherit">{inner}</div>'


def _axes(data: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the part of the document for each displacement."""
    return data.get("axes", [data])


def _unit(axis: dict[str, Any]) -> str:
    return unit_text(in_unit_of(axis["displacement"], "um"))


def _error(axis: dict[str, Any], of: dict[str, Any], name: str) -> str:
    """Return an error of a displacement from its document. `name` is the key for a length, which ends with um."""
    return number(of[in_unit_of(axis["displacement"], name)])


def _head(data: dict[str, Any], names: list[str]) -> list[str]:
    """Return the head of a table of displacements. The unit of the displacements replaces "*" in `names`."""
    units = sorted({_unit(axis) for axis in _axes(data)})
    return [name.replace("*", " or ".join(units)) for name in names]


def _said(data: dict[str, Any]) -> str:
    return messages_html({"messages": data.get("messages", []) + data.get("warnings", [])})


def _of(data: dict[str, Any]) -> str:
    return paragraph(f'{text(data.get("rows", ""))} rows of {text(files_text(data["data"]))} compared with ' f'{text(data["model"])}', _FAINT)


def parameters_table(parameters: dict[str, dict[str, Any]]) -> str:
    """Return the table of the first parameters with their errors."""
    rows = [
        [text(name), number(p["value"], 5)] + ([number(p["std"], 2)] if "std" in p else []) + [text(unit_text(p["unit"]).replace("um/", "µm/"))]
        for name, p in list(parameters.items())[:FEW]
    ]
    more = len(parameters) - len(rows)
    errors = ["std error"] if rows and len(rows[0]) == 4 else []
    return table(["parameter", "value", *errors, "unit"], rows) + (paragraph(f"and {more} more in parameters", _FAINT) if more > 0 else "")


def correction_html(correction: Any) -> str:
    """Return a correction as HTML: its displacements, its inputs and its parameters."""
    return _page(
        paragraph(f'<b>{text(", ".join(correction.displacements))}</b> of ' f'{text(", ".join(correction.inputs) or "no input")}')
        + parameters_table(correction.parameters)
        + paragraph(text(correction.source), _FAINT)
    )


def identification_html(found: Any) -> str:
    """Return held-out and in-sample errors of each displacement, then the parameters."""
    data, rows = found.data, []
    for axis in _axes(data):
        if "fits" in axis:
            rows += [
                [
                    text(axis["displacement"]),
                    f'ARX {text(f["order"])}',
                    _error(axis, f["simulated"], "rmse_um"),
                    _error(axis, f["one_step"], "rmse_um"),
                    "",
                ]
                for f in axis["fits"]
            ]
        else:
            rows.append(
                [
                    text(axis["displacement"]),
                    text(", ".join(c["name"] for c in axis["channels"][:6])),
                    _error(axis, axis, "rmse_held_out_um"),
                    _error(axis, axis["metrics"], "rmse_um"),
                    number(axis["noise"]["rms"]),
                ]
            )
    arx = any("fits" in axis for axis in _axes(data))
    head = _head(data, ["displacement", "of", *(["simulated, *", "one step, *", ""] if arx else ["held out, *", "RMS, *", "noise, *"])])
    out = table(head, rows, left=2)
    for axis in _axes(data):
        if (other := axis.get("validation")) is not None:
            out += paragraph(
                f'on {text(other["data"])}: {text(axis["displacement"])} RMS '
                f'{_error(axis, other, "rmse_um")} {_unit(axis)}, largest {_error(axis, other, "max_abs_um")} {_unit(axis)}'
            )
    if found.parameters:
        out += heading("Parameters") + parameters_table(found.parameters)
    warnings = [w for axis in _axes(data) for w in axis.get("warnings", [])]
    return _page(out + _said({"messages": warnings}))


def run_html(run: Any) -> str:
    """Return the residuals of each displacement. If the run learned, return the errors with and without learning."""
    data, rows = run.data, []
    learnt = "between_readings" in data
    for axis in _axes(data):
        if learnt:
            b = axis["between_readings"]
            rows.append(
                [
                    text(axis["displacement"]),
                    text(axis["readings_learnt"]),
                    _error(axis, b, "rmse_first_zero_um"),
                    _error(axis, b, "rmse_last_zero_um"),
                    _error(axis, b, "rmse_learnt_um"),
                ]
            )
        else:
            low, high = axis[in_unit_of(axis["displacement"], "predicted_range_um")]
            m = axis["metrics"]
            rows.append(
                [
                    text(axis["displacement"]),
                    f"{number(low)} to {number(high)}",
                    text(m["readings"]),
                    _error(axis, m, "rmse_um"),
                    _error(axis, m, "max_abs_um"),
                ]
            )
    head = _head(
        data,
        ["displacement", "learnt", "first zero, *", "last zero, *", "learning, *"]
        if learnt
        else ["displacement", "predicted, *", "readings", "RMS, *", "largest, *"],
    )
    words = "RMS of the readings that were not used for learning" if learnt else "RMS and largest error of the readings, minus one constant"
    return _page(table(head, rows) + paragraph(words, _FAINT) + _of(data) + _said(data))


def _testable(effect: dict[str, Any]) -> str:
    if effect["ruled_out"]:
        return f'not testable: {effect["ruled_out"]}'
    if effect["missing"]:
        return f'needs {effect["missing"]}'
    without = effect["hard_without"]
    return f"hard to distinguish without {without}" if without else "testable"


def check_html(check: Any) -> str:
    """Return the columns of a record, and the effects that can be tested with it."""
    data = check.data
    columns = [[text(c["name"]), number(c["from"], 5), number(c["to"], 5), text(c["levels"])] for c in data["columns"][:FEW]]
    effects = [[text(e["id"]), text(_testable(e))] for e in data["effects"]]
    return _page(
        paragraph(f'{text(data["rows"])} rows')
        + table(["column", "from", "to", "levels"], columns)
        + heading("Effects")
        + table([], effects, left=2)
        + _said(data)
    )


def law_html(law: Any) -> str:
    """Return the parameters of the law, and the errors of the law relative to the curve."""
    data = law.data
    return _page(
        parameters_table(law.parameters)
        + paragraph(f'mean absolute error {number(data["mae_um"])} µm, largest ' f'{number(data["max_abs_um"])} µm, {text(data["rows"])} rows')
    )

"""Results in a notebook, as HTML that has no scripts and uses the colours of the page.

All parts are drawn in ``currentColor`` and its shades, so they are readable in light and dark notebooks. Pictures are inline SVG. Every text of a
document is escaped, because users choose the names of files and effects.
"""

from __future__ import annotations

from html import escape
from typing import Any

from ._documents import Ladder, effect_name, error_unit, files_text, kind_of, label_of, ladders_of, number, quantity_text, split_column, unit_text

FIRST_ROWS = 6  # rows of a table that are shown
RANKED = 6  # effects that are shown in addition to the effects of the verdict
WORST = 5  # ranges with the largest errors that are shown
BAR = 220  # width of the longest bar [px]

_CELL = "padding:.15em .8em .15em 0;border:0;background:none;vertical-align:baseline;" "white-space:normal;"
_LEFT = f'style="{_CELL}text-align:left"'
_RIGHT = f'style="{_CELL}text-align:right;font-variant-numeric:tabular-nums"'
_FAINT = "opacity:.7"


def text(value: object) -> str:
    """Return a value as escaped text of a page."""
    return escape("-" if value is None else str(value), quote=True)


def paragraph(inner: str, style: str = "") -> str:
    return f'<p style="margin:.3em 0;max-width:60em;{style}">{inner}</p>'


def heading(words: str) -> str:
    return f'<div style="margin:.8em 0 .2em;font-weight:600">{text(words)}</div>'


def table(head: list[str], rows: list[list[str]], left: int = 1, units: int | None = None) -> str:
    """Return a table of escaped cells. The first `left` columns and the column `units` contain words and are aligned to the left."""

    def cells(tag: str, row: list[str]) -> str:
        return "".join(f"<{tag} {_LEFT if i < left or i == units else _RIGHT}>{cell}</{tag}>" for i, cell in enumerate(row))

    top = f'<tr style="background:none">{cells("th", [text(h) for h in head])}</tr>' if head else ""
    body = "".join(f'<tr style="background:none">{cells("td", row)}</tr>' for row in rows)
    # A wide table has its own scroll bar, so the text around the table stays visible.
    return (
        '<div style="overflow-x:auto">'
        '<table style="border-collapse:collapse;border:0;margin:.2em 0;'
        'color:inherit;font-size:inherit">'
        f"{'<thead>' + top + '</thead>' if top else ''}<tbody>{body}</tbody></table></div>"
    )


def bar(value: float, full: float, mark: float | None, kind: str) -> str:
    """Return the bar of one error of a ladder (`plot.ladder`), with a mark at the noise."""
    width = 0.0 if not full > 0.0 else BAR * max(0.0, min(value / full, 1.0))
    # The bar of held-out rows is hollow, as in plot.ladder().
    body = (
        f'<rect x="0.5" y="2.5" width="{width:.1f}" height="9" fill="none" ' 'stroke="currentColor" stroke-opacity=".6"/>'
        if kind == "held out"
        else f'<rect x="0" y="2" width="{width:.1f}" height="10" fill="currentColor" ' f'fill-opacity="{".75" if kind == "after" else ".4"}"/>'
    )
    line = ""
    if mark is not None and full > 0.0 and mark <= full:
        at = BAR * mark / full
        line = f'<line x1="{at:.1f}" y1="0" x2="{at:.1f}" y2="14" stroke="currentColor" ' 'stroke-width="1.5" stroke-dasharray="2 1.5"/>'
    return f'<svg width="{BAR + 2}" height="14" role="img" aria-label="{number(value)}" ' f'style="vertical-align:middle">{body}{line}</svg>'


def ladder_html(ladders: list[Ladder]) -> str:
    """Return the errors and the noise of one quantity as rows with bars."""
    first = ladders[0]
    steps = [step for one in ladders for step in one.steps if step.rmse is not None]
    full = max([step.rmse for step in steps] + [first.noise or 0.0], default=0.0)
    rows = [[text(step.label), number(step.rmse), bar(step.rmse, full, first.noise, step.kind)] for step in steps]
    known = first.noise is not None
    if first.noise_words:
        rows.append([text(first.noise_words + (" (dashed)" if known else "")), number(first.noise) if known else "not known", ""])
    if first.tolerance is not None:
        rows.append(["tolerance", number(first.tolerance), ""])
    words = quantity_text(first.quantity).lower()
    return heading(f"RMS error{' of ' + words if words else ''} in {error_unit(first.unit)}") + table([], rows)


def ladders_html(result: object) -> str:
    """Return one ladder of error bars (`plot.ladder`) for each quantity."""
    groups: dict[tuple[str, str], list[Ladder]] = {}
    for one in ladders_of(result, "html_of()"):
        groups.setdefault((one.quantity, one.unit), []).append(one)
    return "".join(ladder_html(group) for group in groups.values())


def messages_html(data: dict[str, Any]) -> str:
    """Return the messages as a list, followed by the notes in faint text."""
    items = [f"<li>{text(m)}</li>" for m in data.get("messages", [])]
    items += [f'<li style="{_FAINT}">{text(n)}</li>' for n in data.get("notes", [])]
    if not items:
        return ""
    return f'<ul style="margin:.4em 0 .2em;padding-left:1.4em;max-width:60em">{"".join(items)}</ul>'


def size_text(parameter: dict[str, Any]) -> str:
    """Return value, standard error and unit as text."""
    unit = unit_text(parameter.get("unit"))
    value = number(parameter.get("value"), 4)
    if parameter.get("std") is not None:
        value += f" ± {number(parameter['std'], 2)}"
    bound = " (at its bound)" if parameter.get("at_bound") else ""
    return value + (f" {unit}" if unit else "") + bound


def _gain(gain: float | None) -> str:
    """Return the decrease of -2 ln L as text; "0" for values below 0.001, which are rounding errors."""
    return number(gain) if gain is None or abs(gain) >= 1e-3 else "0"


def _ranking(data: dict[str, Any]) -> str:
    effects, unit = data["effects"], data["unit"]
    named = sum(bool(e.get("in_verdict")) for e in effects)
    rows = []
    for e in effects[: named + RANKED]:
        sizes = "; ".join(f"{name} = {size_text(p)}" if len(e["parameters"]) > 1 else size_text(p) for name, p in e.get("parameters", {}).items())
        name = text(effect_name(e))
        rows.append(
            [
                f"<b>{name}</b>" if e.get("in_verdict") else name,
                "yes" if e.get("in_verdict") else "",
                text(sizes),
                _gain(e.get("gain")),
                number(e.get("rmse")),
                number(e.get("rmse_cross_validated")),
            ]
        )
    head = ["effect", "in verdict", "size", "gain", f"RMS, {error_unit(unit)}", "held out"]
    if all(e.get("gain") is None for e in effects):  # records over time have held-out errors in place of gains
        head, rows = head[:3] + head[4:], [row[:3] + row[4:] for row in rows]
    more = len(effects) - len(rows)
    return (
        heading("Effects, best first")
        + table(head, rows, left=3)
        + (paragraph("gain, RMS and held out refer to all effects of the verdict together", _FAINT) if data["verdict"] == "several-effects" else "")
        + (paragraph(f"and {more} less likely effects", _FAINT) if more > 0 else "")
    )


def _next(data: dict[str, Any]) -> str:
    points = data.get("suggested_measurements", [])
    records = data.get("records_needed", [])
    if not points and not records:
        return ""
    out = heading("What to measure next")
    if points:
        fixed = ("repeats", "separates", "difference_in_sigma")
        settings = [key for key in points[0] if key not in fixed]
        rows = [[text(p.get("separates"))] + [number(p.get(key), 5) for key in settings] + [text(p.get("repeats"))] for p in points]
        out += table(["distinguishes", *map(label_of, settings), "times"], rows)
        separation = data.get("predicted_separation")
        if separation is not None:
            out += paragraph(
                f"expected difference of the gains: {number(separation)}; with repeated old points: "
                f"{number(data.get('separation_by_repetition'))}; a difference of 6 is enough",
                _FAINT,
            )
    if records:
        items = "".join(f"<li>{text(r)}</li>" for r in records)
        out += f'<ul style="margin:.2em 0;padding-left:1.4em">{items}</ul>'
    return out


def _against(part: dict[str, Any]) -> str:
    """Return the names of the compared data and model."""
    return f'{text(part["rows"])} rows of {text(files_text(part.get("data")))} compared with ' f'{text(part.get("model"))}'


def _diagnosis(result: Any) -> str:
    data = result.data
    out = '<div style="font-weight:600;font-size:1.1em;max-width:55em">' + f'{text(data["headline"])}</div>'
    out += paragraph(text(data["sentence"]))
    out += paragraph(f'verdict: <b>{text(data["verdict"])}</b>; {_against(data)}', _FAINT)
    out += ladders_html(result)
    if data.get("effects"):
        out += _ranking(data)
    shape = data.get("shape")
    if isinstance(shape, dict) and shape.get("statement"):
        out += heading("Shape of the misfit") + paragraph(text(shape["statement"]))
    return out + _next(data) + messages_html(data)


def _range(where: dict[str, Any]) -> str:
    unit = unit_text(where.get("unit"))
    low, high = where["from"], where["to"]
    if isinstance(low, str):
        return f"{where['variable']} {low}"
    span = number(low, 5) if low == high else f"{number(low, 5)} to {number(high, 5)}"
    words = quantity_text(where["variable"]).lower()
    return f"{words} {span}" + (f" {unit}" if unit else "")


def _where_html(part: dict[str, Any]) -> str:
    where = part.get("where", [])
    rows = [[text(_range(w)), text(w["rows"]), number(w["rmse"]), ("+" if w["bias"] > 0 else "") + number(w["bias"])] for w in where[:WORST]]
    out = paragraph(text(part.get("statement", "")))
    if rows:
        unit = error_unit(part["unit"])
        out += heading("Largest errors") + table(["range", "rows", f"RMS, {unit}", f"mean error, {unit}"], rows)
    return out


def _comparison(result: Any) -> str:
    data = result.data
    out = ladders_html(result)
    models = data.get("models", [data])
    for model in models:
        if len(models) > 1:
            out += heading(str(model.get("model")))
        out += paragraph(_against(model), _FAINT)
        for part in model.get("channels", [model]):
            out += _where_html(part)
    return out + messages_html(data)


def _ends(p: dict[str, Any]) -> list[str]:
    """Return the cells of the interval by profile likelihood. The list is empty if the parameter has no interval."""
    if "profile" not in p:
        return []
    return [number(p["profile"][end], 5) + (" (open)" if p["profile"][f"open_{end}"] else "") for end in ("from", "to")]


def parameters_html(calibration: dict[str, Any]) -> str:
    """Return the table of parameters with errors, and their correlation."""
    parameters = calibration.get("parameters", {})
    rows = []
    for name, p in parameters.items():
        doubt = (
            "held constant"
            if p.get("held")
            else "at its bound"
            if p.get("at_bound")
            else ""
            if p.get("identifiable", True)
            else "not determined by these data"
        )
        rows.append(
            [
                text(name),
                text(unit_text(p.get("unit"))),
                number(p.get("start"), 5),
                number(p.get("value"), 5),
                number(p.get("std"), 2),
                *_ends(p),
                text(doubt),
            ]
        )
    profile = ["95 % from", "to"] if "profile" in calibration else []
    out = heading("Parameters") + table(["parameter", "unit", "start", "value", "std error", *profile, ""], rows, left=2)
    matrix = calibration.get("correlation") or []
    if len(matrix) > 1:
        names = list(parameters)
        # The columns are numbered, because names of parameters of effects are too long.
        rows = [[str(i + 1), text(name)] + [number(r, 2) for r in matrix[i][: i + 1]] + [""] * (len(names) - i - 1) for i, name in enumerate(names)]
        out += heading("Correlation") + table(["", "", *(str(i + 1) for i in range(len(names)))], rows, left=2)
    return out


def _conformity(data: dict[str, Any]) -> str:
    """Return the result of a fit to catalogue rigidities: the conformity, and the preload classes from which it follows."""
    rows = [
        [text(c.get("class")), number(c.get("preload_N")), number(c.get("printed_N_um")), number(c.get("computed_N_um"))]
        for c in data.get("classes", [])
    ]
    return paragraph(f'<b>{text(data.get("bearing"))}</b>, groove conformity ' f'{text(size_text(data.get("conformity", {})))}') + table(
        ["class", "preload in N", "printed in N/µm", "computed in N/µm"], rows
    )


def _calibration(result: Any) -> str:
    data = result.data
    if "parameters" not in data:
        return _conformity(data)
    status = data.get("report", {}).get("status", "")
    chi = data.get("reduced_chi_square")
    freedom = text(data.get("degrees_of_freedom"))
    facts = (
        f'{text(data["rows"])} rows, {freedom} degrees of freedom, {text(status)}'
        + (f", chi²/dof = {number(chi)}" if chi is not None else "")
        + (f', AIC {number(data["aic"], 5)}, BIC {number(data["bic"], 5)}' if data.get("aic") is not None else "")
    )
    return ladders_html(result) + paragraph(facts, _FAINT) + parameters_html(data) + messages_html(data)


def _addition(result: Any) -> str:
    data = result.data
    out = ""
    if data.get("refused"):
        out = paragraph(f'<b>refused:</b> {text(data.get("reason"))}')
    out += paragraph(_against({**data, "rows": data["before"]["rows"]}), _FAINT)
    return out + ladders_html(result) + parameters_html(data["calibration"]) + messages_html(data)


def _rows_html(result: Any) -> str:
    """Return the first rows and columns of a table, and the numbers of all rows and columns."""
    frame = result.to_frame()
    columns = list(frame.columns)
    shown = columns[:8]
    rows = [
        [number(v, 5) if isinstance(v, (int, float)) and not isinstance(v, bool) else text(getattr(v, "item", lambda v=v: v)()) for v in row]
        for row in frame[shown].head(FIRST_ROWS).itertuples(index=False, name=None)
    ]
    count = f"{len(frame)} rows, {len(columns)} columns"
    if len(columns) > len(shown):
        count += f"; also {', '.join(map(str, columns[len(shown):len(shown) + 6]))}"
        count += ", ..." if len(columns) > len(shown) + 6 else ""
    data = result.data or {}
    name = data.get("bearing") or data.get("model") or ""
    return (
        (paragraph(f"<b>{text(name)}</b>") if name else "") + table([label_of(str(c)) for c in shown], rows, left=0) + paragraph(text(count), _FAINT)
    )


def _solution(result: Any) -> str:
    """Return the numbers of one operating point. For a list, such as the balls, only the length is shown. For several points, return the rows of the
    points."""
    if result.data is None:
        return _rows_html(result)
    rows = []
    for key, value in result.data.items():
        if isinstance(value, bool) or value is None or isinstance(value, (dict, str)):
            continue
        words = quantity_text(split_column(key)[0])
        if isinstance(value, list):
            rows.append([text(words), text(len(value)), "in data"])
        else:
            rows.append([text(words), number(value, 5), text(unit_text(split_column(key)[1]))])
    name = result.data.get("bearing", "")
    status = (result.data.get("report") or {}).get("status", "")
    return paragraph(f"<b>{text(name)}</b> {text(status)}") + table([], rows, units=2)


_WRITERS = {
    "Solution": _solution,
    "Table": _rows_html,
    "Displacement": _rows_html,
    "Comparison": _comparison,
    "Calibration": _calibration,
    "Diagnosis": _diagnosis,
    "Addition": _addition,
}


def html_of(result: Any) -> str:
    """Return a result as HTML, for ``_repr_html_``.

    Parameters
    ----------
    result : Diagnosis, Comparison, Calibration, Addition, Solution, Table, Displacement or a result of a spindle
        The attribute ``data`` contains the results as a dictionary. A Table and a Displacement also need ``to_frame()``.

    Returns
    -------
    str
        One ``<div>``. The text contains no scripts, no styles for the page and no parts from a network.

    Raises
    ------
    TypeError
        The result has another type.

    Examples
    --------
    >>> Comparison = type("Comparison", (), {"data": {
    ...     "model": "<b>.toml", "quantity": "friction_torque", "unit": "Nmm", "rows": 3,
    ...     "rmse": 44.9, "noise": {"rms": None}, "where": [], "data": "rig.csv"}})
    >>> "&lt;b&gt;.toml" in html_of(Comparison())
    True
    """
    from ._html_spindle import WRITERS as of_spindles  # imported here, because the module uses the functions above

    writers = {**_WRITERS, **of_spindles}
    writer = writers.get(kind_of(result))
    if writer is None:
        raise TypeError(f"html_of() takes a {', '.join(writers)}, not {type(result).__name__!r}")
    # A grid with one column has the width of the page, not of its widest line.
    return '<div style="display:grid;grid-template-columns:minmax(0,1fr);line-height:1.4;color:inherit">' f"{writer(result)}</div>"

"""Report of a fit as plain text, in the same order as the reports of lmfit and statsmodels."""

from __future__ import annotations

import math
import textwrap
from typing import TYPE_CHECKING, Any

from ._documents import document_of, effect_name, files_text, kind_of, number
from ._likelihood import RANKED, ranked

if TYPE_CHECKING:
    import pandas

WIDTH = 80
LEAST_CORRELATION = 0.1


def plain(value: object) -> str:
    """Return the value as text on one line. Control characters are replaced by "?", so that they do not affect the terminal."""
    return "".join(c if c.isprintable() else "?" for c in str(value))


def _unit(unit: str | None) -> str:
    return {"Nmm": "N mm", "1": "", None: ""}.get(unit, unit or "")


def _error(value: float | None, unit: str | None) -> str:
    """Return an error with its unit. For temperatures, the unit of an error is K."""
    return f"{number(value, 4)} {'K' if unit == 'C' else _unit(unit)}".rstrip()


def wrapped(words: str, indent: str = "    ", hanging: str | None = None) -> list[str]:
    """Return the text as lines with at most 80 columns."""
    return textwrap.wrap(
        plain(words), WIDTH, initial_indent=indent, subsequent_indent=indent if hanging is None else hanging, break_on_hyphens=False
    ) or [indent.rstrip()]


def _fact(name: str, value: object) -> list[str]:
    return wrapped(f"{name:<22}= {value}", hanging=" " * 28)


def _list(items: list[Any]) -> list[str]:
    return [line for item in items for line in wrapped(str(item), "    - ", "      ")]


def _header(data: dict[str, Any], whose: dict[str, Any]) -> list[str]:
    lines = _fact("model", whose["model"]) if whose.get("model") else []
    lines += _fact("data", files_text(whose["data"])) if whose.get("data") else []
    lines += _fact("rows", data["rows"])
    left_out = len(data.get("rows_not_predicted", []))
    return lines + (_fact("rows not predicted", left_out) if left_out else [])


def _pair(one: dict[str, Any]) -> str:
    return f"{one['aic']:.6g}, {one['bic']:.6g}"


def _moved(one: dict[str, Any], readings: int) -> int:
    """Return the number k of parameters that a fit varied, including parameters at a bound."""
    return readings - one["degrees_of_freedom"]


def _criteria(data: dict[str, Any]) -> list[str]:
    """Return the lines with AIC and BIC of a calibration, and with the formulas for both."""
    n, chi = data["readings"], data["chi_square"]
    if data["aic"] is None:
        why = (
            "additional scatter was fitted to the residual of this model"
            if chi is not None
            else "the noise of the readings is not known, or the readings are correlated"
        )
        return _fact("AIC, BIC", "-") + wrapped(f"AIC and BIC cannot be calculated, because {why}.")
    k = _moved(data, n)
    lines = _fact("AIC, BIC", _pair(data))
    if chi is None:
        return lines + wrapped(
            "AIC = -2 ln L + 2 k and BIC = -2 ln L + k ln N, with -2 ln L = N (1 + ln(2 pi RMS^2)) "
            f"for N = {n} readings with equal weights and k = {k} parameters that the fit varied. The "
            "size of the noise is not known, so the most likely size is used."
        )
    log_determinant = data["noise"]["log_determinant"]
    lines += wrapped(
        "AIC = -2 ln L + 2 k and BIC = -2 ln L + k ln N, with -2 ln L = chi2 + ln det(2 pi S) = "
        f"{chi:.6g} {'+' if log_determinant >= 0 else '-'} {abs(log_determinant):.6g}, where S is "
        f"the covariance matrix of the noise. The fit used N = {n} readings and varied k = {k} parameters, "
        "including parameters at a bound. Compare AIC and BIC only between models with the same rows and the same S."
    )
    if chi > 0.0:
        scaled = n * math.log(chi / n)
        lines += _fact("AIC, BIC as in lmfit", _pair({"aic": scaled + 2 * k, "bic": scaled + k * math.log(n)}))
        lines += wrapped("lmfit uses N ln(chi2/N) + 2 k and N ln(chi2/N) + k ln N, because it also fits the size " "of the noise.")
    return lines


def _statistics(data: dict[str, Any]) -> list[str]:
    chi = data["chi_square"]
    lines = _fact("chi-square", "-" if chi is None else f"{chi:.6g}")
    lines += _fact("reduced chi-square", number(data.get("reduced_chi_square"), 5))
    for part in data.get("channels", [data]):
        error = f"{_error(part['rmse'], part['unit'])}, before " f"{_error(part['rmse_before'], part['unit'])}"
        quantity = f" ({part['quantity']}, {part['readings']} readings)" if "channels" in data else ""
        lines += _fact("RMS error", error + quantity)
    return lines + _criteria(data)


def _bound(p: dict[str, Any]) -> str:
    if not p.get("at_bound"):
        return ""
    for side in ("lower", "upper"):
        if p.get(side) is not None and p.get("value") == p[side]:
            return f", at its {side} bound"
    return ", at its bound"


def _interval(p: dict[str, Any]) -> str:
    """Return the 95 % interval of a parameter. An end is marked as open if it is a bound of the parameter."""
    profile = p.get("profile") or {"from": p.get("from"), "to": p.get("to")}
    if profile["from"] is None and profile["to"] is None and not profile.get("open_from"):
        return ""

    def end(side: str) -> str:
        words = number(profile[side], 5)
        return f"{words} (open)" if profile.get(f"open_{side}") else words

    return f"95%: {end('from')} to {end('to')}"


def _parameter(name: str, p: dict[str, Any], start: float | None) -> list[str]:
    value, std = p.get("value"), p.get("std")
    error = "no stderr"
    if std is not None:
        error = f"+- {number(std, 4)}"
    words = f"{name}: {number(value, 7)} {error} {_unit(p.get('unit'))}".rstrip()
    if std is not None and value:
        words += f" ({100.0 * std / abs(value):.2f}%)"
    more = [] if start is None else [f"start {number(start, 6)}"]
    if p.get("lower") is not None and p.get("upper") is not None:
        more.append(f"bounds {number(p['lower'], 6)} to {number(p['upper'], 6)}")
    if interval := _interval(p):
        more.append(interval)
    doubt = ", held constant by the fit" if p.get("held") else "" if p.get("identifiable", True) else ", not determined by these data"
    return wrapped(words + (f" ({', '.join(more)})" if more else "") + _bound(p) + doubt, hanging=" " * 8)


def _correlations(names: list[str], matrix: list[list[float | None]]) -> list[str]:
    pairs = [
        (abs(r), names[j], names[i], r)
        for i, row in enumerate(matrix)
        for j, r in enumerate(row[:i])
        if r is not None and abs(r) >= LEAST_CORRELATION
    ]
    if not pairs:
        return []
    lines = [f"[[Correlations]] (below {LEAST_CORRELATION:g} not shown)"]
    for _, first, second, r in sorted(pairs, key=lambda pair: -pair[0]):
        lines += wrapped(f"C({first}, {second}) = {r:+.4f}", hanging=" " * 8)
    return lines


def _calibrated(data: dict[str, Any]) -> list[str]:
    lines = ["[[Parameters]]"]
    for name, p in data["parameters"].items():
        lines += _parameter(name, p, p.get("start"))
    if profile := data.get("profile"):
        lines += wrapped(
            "95%: interval by profile likelihood. At its ends, chi2 with all other parameters refitted is "
            f"{profile['rise']:.4g} above its minimum. open: the interval ends at the bound of the parameter."
        )
    return lines + _correlations(list(data["parameters"]), data.get("correlation") or [])


def _said(data: dict[str, Any]) -> list[str]:
    lines = []
    for title, key in (("Messages", "messages"), ("Notes", "notes")):
        if data.get(key):
            lines += [f"[[{title}]]", *_list(data[key])]
    return lines


def _fit_facts(data: dict[str, Any]) -> list[str]:
    report = data.get("report", {})
    lines = _fact("readings", data["readings"])
    lines += _fact("parameters", f"{len(data['parameters'])} free, {_moved(data, data['readings'])} varied")
    lines += _fact("degrees of freedom", data["degrees_of_freedom"])
    return lines + _fact("fit", f"{report.get('status', '-')}, iterations " f"{report.get('iterations', '-')}")


def _calibration(data: dict[str, Any]) -> list[str]:
    return [
        f"[[Calibration of {plain(data['quantity'])}]]",
        *_header(data, data),
        *_fit_facts(data),
        "[[Fit Statistics]]",
        *_statistics(data),
        *_calibrated(data),
        *_said(data),
    ]


def _addition(data: dict[str, Any]) -> list[str]:
    calibration, before = data["calibration"], data["before"]
    lines = [f"[[Effect added to the model of {plain(calibration['quantity'])}]]"]
    lines += _header(calibration, data) + _fit_facts(calibration)
    if data.get("refused"):
        lines += _fact("refused", data.get("reason"))
    lines += ["[[Fit Statistics]]", *_statistics(calibration)]
    if data["gain"] is not None:
        lines += _fact("chi-square before", f"{before['chi_square']:.6g}")
        lines += _fact("gain", number(data["gain"], 5))
        lines += _fact("dAIC, dBIC", _pair({key: calibration[key] - before[key] for key in ("aic", "bic")}))
        lines += wrapped(
            "dAIC, dBIC: value after minus value before, with the same noise. gain: decrease of -2 ln L, minus ln N "
            "for each free shape parameter of an effect."
        )
    lines += ["[[Rows held out]]"]
    for part in data.get("hold_out", []):
        lines += wrapped(
            f"by {part['left_out']}: RMS error " f"{_error(part['rmse_before'], data['unit'])} -> " f"{_error(part['rmse_after'], data['unit'])}"
        )
    return lines + _calibrated(calibration) + _said(data)


def _ranking(data: dict[str, Any]) -> list[str]:
    base, readings = data["baseline"], data["readings"]
    lines = ["[[Explanations compared with the model without effects]]"]
    lines.append(f"    {'':<30}{'k':>3}{'RMS':>9}{'gain':>9}{'dAIC':>10}{'dBIC':>10}")
    lines.append(f"    {'without':<30}{_moved(base, readings):>3}" f"{number(data['rmse_before'], 4):>9}{'0':>9}{'0':>10}{'0':>10}")
    for one in ranked(data):
        words, fit = plain(("<- " if one.in_verdict else "") + one.name), one.fit
        if len(words) > 29:
            lines, words = lines + wrapped(words), ""
        lines.append(
            f"    {words:<30}{_moved(fit, readings):>3}{number(fit['rmse'], 4):>9}"
            f"{number(fit['gain'], 4):>9}{fit['aic'] - base['aic']:>10.1f}"
            f"{fit['bic'] - base['bic']:>10.1f}"
        )
    return lines + wrapped(
        f"k: number of parameters that the fit varied. RMS in {_unit(data['unit'])}. gain: decrease of -2 ln L "
        "with the estimated noise, minus ln N for each free shape parameter of an effect; the verdict needs "
        f"{number(data.get('needed_gain'), 4)}. dAIC, dBIC: difference from the model without effects."
    )


def _held_out(data: dict[str, Any]) -> list[str]:
    """Return the lines with the error of each explanation, for a record over time. Such records have no likelihood."""
    lines = [
        "[[Explanations by their errors]]",
        f"    {'':<50}{'RMS':>12}{'held out':>12}",
        f"    {'without':<50}{number(data['rmse_before'], 4):>12}{'':>12}".rstrip(),
    ]
    named = sum(bool(e.get("in_verdict")) for e in data["effects"])
    for e in data["effects"][: named + RANKED]:
        words = plain(("<- " if e.get("in_verdict") else "") + effect_name(e))
        if len(words) > 49:
            lines, words = lines + wrapped(words), ""
        lines.append(f"    {words:<50}{number(e.get('rmse'), 4):>12}" f"{number(e.get('rmse_cross_validated'), 4):>12}")
    return lines + wrapped(
        "These fits have no likelihood (effects.gain is null), AIC or BIC, because the residuals of "
        "successive readings are correlated. The program judges effects by their error on "
        "held-out parts of the record."
    )


def _diagnosis(data: dict[str, Any]) -> list[str]:
    named = [e for e in data.get("effects", []) if e.get("in_verdict")]
    base, unit = data["baseline"], data["unit"]
    lines = [f"[[Diagnosis of {plain(base.get('quantity', 'the readings'))}]]"]
    lines += wrapped(data["headline"]) + _header(data, data)
    lines += _fact("parameters", f"{len(data['base_parameters'])} of the model without effects")
    if base["degrees_of_freedom"] is not None:
        lines += _fact("degrees of freedom", f"{base['degrees_of_freedom']} without effects")
    lines += _fact("candidates tried", data.get("candidates_tried", "-"))
    lines += _fact("verdict", data["verdict"]) + ["[[Fit Statistics]]"]
    lines += _fact("RMS error", f"{_error(data['rmse_after'], unit)}, before " f"{_error(data['rmse_before'], unit)}")
    lines += _fact("noise found", _error((data.get("noise") or {}).get("rms"), unit))
    if data.get("p_value") is not None:
        lines += _fact("p of the misfit", f"{number(data['p_value'], 2)}, of the remaining misfit " f"{number(data.get('remaining_p_value'), 2)}")
    if base["chi_square"] is not None:
        lines += _fact("chi-square", f"{base['chi_square']:.6g} without effects")
        lines += _fact("AIC, BIC", f"{_pair(base)} without effects") + _ranking(data)
    else:
        lines += _held_out(data)
    lines += ["[[Parameters]]"]
    for effect in named:
        for name, p in effect["parameters"].items():
            lines += _parameter(f"{effect_name(effect)}.{name}", p, None)
    # Without an explanation, both are the values of the model without an added effect.
    explained = bool(data.get("explanations"))
    for name, p in data["base_parameters"].items():
        lines += _parameter(name, {**p, "value": p["after"]}, p["before"] if explained else None)
    if explained:
        lines += wrapped("start: value fitted without effects. All other values are fitted with the first explanation.")
    else:
        lines += wrapped("All values are fitted without effects, because the verdict names no effect.")
    correlation = data["correlation"]
    return lines + _correlations(correlation["names"], correlation["rows"]) + _said(data)


def conf_interval(result: Any) -> pandas.DataFrame:
    """Return the 95 % intervals of a Calibration by profile likelihood, one row per parameter.

    Raises
    ------
    ValueError
        The document has no intervals, because `calibrate` was called without ``profile=True``.
    """
    import pandas

    data = document_of(result, ("Calibration",), "conf_interval()")
    if "profile" not in data:
        raise ValueError("conf_interval(): this Calibration has no profile intervals; ask for them " "with calibrate(record, profile=True)")
    rows = {}
    for name, p in data["parameters"].items():
        of = p["profile"]
        rows[name] = {
            "value": p["value"],
            "lower": of["from"],
            "upper": of["to"],
            "unit": p["unit"],
            "open_lower": of["open_from"],
            "open_upper": of["open_to"],
        }
    frame = pandas.DataFrame.from_dict(rows, orient="index")
    return frame.astype({"lower": float, "upper": float})


def fit_report(result: Any) -> str:
    """Return the report of a fit as text, in the form of lmfit and statsmodels.

    Parameters
    ----------
    result : Calibration, Addition or Diagnosis
        Result to report. The function reads the document ``data`` of the result.

    Returns
    -------
    str
        Plain text with at most 80 columns: header, chi-square, AIC and BIC with their formulas, parameters with
        standard errors and intervals, and correlations of at least 0.1.

    Raises
    ------
    TypeError
        `result` has another type.
    ValueError
        The Calibration is a fit to catalogue rigidities, so it has no readings.

    Examples
    --------
    >>> Calibration = type("Calibration", (), {"data": {
    ...     "parameters": {"f0": {"value": 1.5, "std": 0.03, "unit": "1", "start": 2.0,
    ...                           "lower": 0.01, "upper": 30.0, "at_bound": False,
    ...                           "held": False, "identifiable": True}},
    ...     "correlation": [[1.0]], "rows": 101, "rows_not_predicted": [], "readings": 101,
    ...     "degrees_of_freedom": 100, "chi_square": 110.0, "reduced_chi_square": 1.1,
    ...     "noise": {"log_determinant": 660.0}, "aic": 772.0, "bic": 774.6,
    ...     "quantity": "friction_torque", "unit": "Nmm", "rmse_before": 74.4, "rmse": 10.7,
    ...     "messages": [], "report": {"status": "converged", "iterations": 1}}})
    >>> print("\\n".join(fit_report(Calibration()).splitlines()[:9]))
    [[Calibration of friction_torque]]
        rows                  = 101
        readings              = 101
        parameters            = 1 free, 1 varied
        degrees of freedom    = 100
        fit                   = converged, iterations 1
    [[Fit Statistics]]
        chi-square            = 110
        reduced chi-square    = 1.1
    """
    data = document_of(result, ("Calibration", "Addition", "Diagnosis"), "fit_report()")
    if kind_of(result) == "Calibration" and "degrees_of_freedom" not in data:
        raise ValueError("fit_report(): this Calibration was not fitted to readings; the attribute data has its results")
    writer = {"Calibration": _calibration, "Addition": _addition, "Diagnosis": _diagnosis}
    return "\n".join(writer[kind_of(result)](data))

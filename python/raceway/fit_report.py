"""Report of a fit as plain text, in the order in which lmfit and statsmodels print theirs."""

from __future__ import annotations

import math
import textwrap
from typing import Any

from ._documents import document_of, effect_name, files_text, kind_of, number
from ._likelihood import RANKED, Explanation, Likelihood, likelihood_fall, likelihood_of, ranked

WIDTH = 80
LEAST_CORRELATION = 0.1


def plain(value: object) -> str:
    """Text of one line: control characters of a name cannot move a terminal's cursor."""
    return "".join(c if c.isprintable() else "?" for c in str(value))


def _unit(unit: str | None) -> str:
    return {"Nmm": "N mm", "1": "", None: ""}.get(unit, unit or "")


def _error(value: float | None, unit: str | None) -> str:
    """An error of readings, those of temperatures in K."""
    return f"{number(value, 4)} {'K' if unit == 'C' else _unit(unit)}".rstrip()


def wrapped(words: str, indent: str = "    ", hanging: str | None = None) -> list[str]:
    """Lines of 80 columns at most."""
    return textwrap.wrap(plain(words), WIDTH, initial_indent=indent,
                         subsequent_indent=indent if hanging is None else hanging,
                         break_on_hyphens=False) or [indent.rstrip()]


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


def _pair(values: tuple[float, float]) -> str:
    return f"{values[0]:.6g}, {values[1]:.6g}"


def _statistics(data: dict[str, Any], fit: Likelihood) -> list[str]:
    lines = _fact("chi-square", "-" if fit.chi_square is None else f"{fit.chi_square:.6g}")
    lines += _fact("reduced chi-square", number(data.get("reduced_chi_square"), 5))
    for part in data.get("channels", [data]):
        error = f"{_error(part['rmse'], part['unit'])}, before " \
            f"{_error(part['rmse_before'], part['unit'])}"
        quantity = f" ({part['quantity']})" if "channels" in data else ""
        lines += _fact("RMS error", error + quantity)
    known, scaled, error_only = fit.criteria(), fit.scaled_criteria(), fit.error_criteria()
    if known is not None and scaled is not None:
        lines += _fact("AIC, BIC", _pair(known)) + _fact("AIC, BIC as in lmfit", _pair(scaled))
        lines += wrapped(
            f"AIC = chi2 + 2 k and BIC = chi2 + k ln N, with N = {fit.readings} readings and k = "
            f"{fit.moved} parameters that the fit moved, those at a bound among them. chi2 is -2 "
            "ln L but for ln det(2 pi S), S the covariance of the noise, which the document lacks "
            "(field noise.log_determinant): it is the same for all models of the same rows under "
            "the same noise, and only such may be compared.")
        lines += wrapped("lmfit's are N ln(chi2/N) + 2 k and N ln(chi2/N) + k ln N: there the size "
                         "of the noise is fitted too.")
    elif error_only is not None:
        lines += _fact("AIC, BIC", _pair(error_only))
        lines += wrapped(
            f"AIC = N ln(RMS^2) + 2 k and BIC = N ln(RMS^2) + k ln N, with N = {fit.readings} "
            f"readings, k = {fit.moved} parameters that the fit moved and RMS in "
            f"{_unit(data['unit'])}: from the RMS error alone, since the noise is not known "
            "(reduced_chi_square is null). These are lmfit's, of readings that weigh alike and are "
            "independent, as those of a record over time are not.")
    else:
        lines += _fact("AIC, BIC", "-")
        lines += wrapped("not to be had: reduced_chi_square is null, and of several measured "
                         "columns the document lacks the number of readings of each "
                         "(channels.readings).")
    return lines


def _bound(p: dict[str, Any]) -> str:
    if not p.get("at_bound"):
        return ""
    for side in ("lower", "upper"):
        if p.get(side) is not None and p.get("value") == p[side]:
            return f", at its {side} bound"
    return ", at its bound"


def _parameter(name: str, p: dict[str, Any], start: float | None) -> list[str]:
    value, std = p.get("value"), p.get("std")
    error = "no stderr"
    if std is not None:
        error = f"+- {number(std, 4)}"
    words = f"{name}: {number(value, 7)} {error} {_unit(p.get('unit'))}".rstrip()
    if std is not None and value:
        words += f" ({100.0 * std / abs(value):.2f}%)"
    more = f" (start {number(start, 6)}" if start is not None else " ("
    if p.get("lower") is not None and p.get("upper") is not None:
        more += f", bounds {number(p['lower'], 6)} to {number(p['upper'], 6)}"
    if p.get("from") is not None and p.get("to") is not None:
        more += f"{', ' if start is not None else ''}95%: {number(p['from'], 5)} to " \
            f"{number(p['to'], 5)}"
    more = "" if more == " (" else more + ")"
    doubt = "" if p.get("identifiable", True) else ", not told by these data"
    return wrapped(words + more + _bound(p) + doubt, hanging=" " * 8)


def _calibrated(data: dict[str, Any]) -> list[str]:
    lines = ["[[Parameters]]"]
    for name, p in data["parameters"].items():
        lines += _parameter(name, p, p.get("start"))
    names, matrix = list(data["parameters"]), data.get("correlation") or []
    pairs = [(abs(r), names[j], names[i], r) for i, row in enumerate(matrix)
             for j, r in enumerate(row[:i]) if r is not None and abs(r) >= LEAST_CORRELATION]
    if pairs:
        lines.append(f"[[Correlations]] (below {LEAST_CORRELATION:g} not shown)")
        for _, first, second, r in sorted(pairs, key=lambda pair: -pair[0]):
            lines += wrapped(f"C({first}, {second}) = {r:+.4f}", hanging=" " * 8)
    return lines


def _said(data: dict[str, Any]) -> list[str]:
    lines = []
    for title, key in (("Messages", "messages"), ("Notes", "notes")):
        if data.get(key):
            lines += [f"[[{title}]]", *_list(data[key])]
    return lines


def _fit_facts(data: dict[str, Any], fit: Likelihood) -> list[str]:
    report = data.get("report", {})
    lines = _fact("parameters", f"{len(data['parameters'])} free, {fit.moved} moved")
    lines += _fact("degrees of freedom", data["degrees_of_freedom"])
    return lines + _fact("fit", f"{report.get('status', '-')}, iterations "
                                f"{report.get('iterations', '-')}")


def _calibration(data: dict[str, Any]) -> list[str]:
    fit = likelihood_of(data)
    return [f"[[Calibration of {plain(data['quantity'])}]]", *_header(data, data),
            *_fit_facts(data, fit), "[[Fit Statistics]]", *_statistics(data, fit),
            *_calibrated(data), *_said(data)]


def _addition(data: dict[str, Any]) -> list[str]:
    calibration = data["calibration"]
    fit = likelihood_of(calibration)
    lines = [f"[[Effect added to the model of {plain(calibration['quantity'])}]]"]
    lines += _header(calibration, data) + _fit_facts(calibration, fit)
    if data.get("refused"):
        lines += _fact("refused", data.get("reason"))
    lines += ["[[Fit Statistics]]", *_statistics(calibration, fit)]
    if data.get("gain") is not None:
        lines += _fact("gain", number(data["gain"], 5))
    else:
        lines += _fact("gain", "not in the document (field gain): ask diagnose")
    lines += _errors_alone(data, calibration, fit)
    lines += ["[[Rows held out]]"]
    for part in data.get("hold_out", []):
        lines += wrapped(f"by {part['left_out']}: RMS error "
                         f"{_error(part['rmse_before'], data['unit'])} -> "
                         f"{_error(part['rmse_after'], data['unit'])}")
    return lines + _calibrated(calibration) + _said(data)


def _errors_alone(data: dict[str, Any], calibration: dict[str, Any], fit: Likelihood) -> list[str]:
    """Before and after on one scale, of which the document has RMS errors only."""
    if "channels" in data:
        return []
    # Parameters of an effect carry its name before a point.
    added = sum("." in name for name in calibration["parameters"])
    before = Likelihood(fit.readings, fit.moved - added, None, data["before"]["rmse"])
    old, new = before.error_criteria(), fit.error_criteria()
    if old is None or new is None:
        return []
    return _fact("dAIC, dBIC", _pair((new[0] - old[0], new[1] - old[1]))) + wrapped(
        f"after less before, of N ln(RMS^2) + 2 k and N ln(RMS^2) + k ln N with k = {before.moved} "
        f"before and {fit.moved} after: from the RMS errors alone, as if all rows weighed alike, "
        "since the document lacks the chi-square before (field before.chi_square).")


def _explanation(one: Explanation, data: dict[str, Any], base: int) -> tuple[list[str], bool]:
    """Its line, and whether its criteria are known."""
    readings = data["rows"]
    gain, rmse = (one.lead["gain"], one.lead.get("rmse")) if one.lead else (None, None)
    fall = None if "channels" in data else likelihood_fall(gain, one.members, readings)
    k, aic, bic = "-", "-", "-"
    if fall is not None:
        k = str(base + fall[1])
        aic = f"{2.0 * fall[1] - fall[0]:.1f}"
        bic = f"{fall[1] * math.log(readings) - fall[0]:.1f}"
    words, lines = plain(("<- " if one.in_verdict else "") + one.name), []
    if len(words) > 29:
        lines, words = wrapped(words), ""
    lines.append(f"    {words:<30}{k:>3}{number(rmse, 4):>9}{number(gain, 4):>9}{aic:>10}{bic:>10}")
    return lines, fall is not None


def _ranking(data: dict[str, Any], base: int) -> list[str]:
    lines = ["[[Explanations against the model without them]]"]
    lines.append(f"    {'':<30}{'k':>3}{'RMS':>9}{'gain':>9}{'dAIC':>10}{'dBIC':>10}")
    lines.append(f"    {'without':<30}{base:>3}{number(data['rmse_before'], 4):>9}"
                 f"{'0':>9}{'0':>10}{'0':>10}")
    sure = True
    for one in ranked(data):
        words, known = _explanation(one, data, base)
        lines += words
        sure = sure and known
    lines += wrapped(f"k free parameters, RMS in {_unit(data['unit'])}. gain: fall of -2 ln L "
                     "under the noise found, less ln N for each free shape of an effect; needed "
                     f"{number(data.get('needed_gain'), 4)}. dAIC = 2 dk - fall, dBIC = dk ln N - "
                     f"fall of -2 ln L, with N = {data['rows']} rows; the constant of the noise "
                     "drops out.")
    if not sure:
        lines += wrapped("-: an effect of several parameters with one at its bound, a set without "
                         "effect of its own, or several measured columns: the document lacks which "
                         "parameter is the size (effects.parameters.is_size), what a set gains "
                         "(explanations.gain) or the number of readings (channels.readings).")
    return lines


def _held_out(data: dict[str, Any]) -> list[str]:
    """Of models of records over time, which have no likelihood: errors alone."""
    lines = ["[[Explanations by their errors]]", f"    {'':<50}{'RMS':>12}{'held out':>12}",
             f"    {'without':<50}{number(data['rmse_before'], 4):>12}{'':>12}".rstrip()]
    named = sum(bool(e.get("in_verdict")) for e in data["effects"])
    for e in data["effects"][: named + RANKED]:
        words = plain(("<- " if e.get("in_verdict") else "") + effect_name(e))
        if len(words) > 49:
            lines, words = lines + wrapped(words), ""
        lines.append(f"    {words:<50}{number(e.get('rmse'), 4):>12}"
                     f"{number(e.get('rmse_cross_validated'), 4):>12}")
    return lines + wrapped("These have no gain in the document (effects.gain is null), hence no "
                           "AIC and BIC: effects are judged on parts of the record that no fit "
                           "saw.")


def _diagnosis(data: dict[str, Any]) -> list[str]:
    named = [e for e in data.get("effects", []) if e.get("in_verdict")]
    # They stand where an effect is: where nothing is missing none is said to have been free.
    base = data.get("base_parameters") or \
        next((e["base_parameters"] for e in data.get("effects", [])), None)
    lines = [f"[[Diagnosis of {plain(data.get('baseline', {}).get('quantity', 'the readings'))}]]"]
    lines += wrapped(data["headline"]) + _header(data, data)
    if base is None:
        lines += _fact("parameters", "not in the document (field base_parameters is empty)")
    else:
        lines += _fact("parameters", f"{len(base)} of the model without effects")
        lines += _fact("degrees of freedom", "not in the document (field degrees_of_freedom)"
                       if "channels" in data else f"{data['rows'] - len(base)} without effects")
    lines += _fact("candidates tried", data.get("candidates_tried", "-"))
    lines += _fact("verdict", data["verdict"]) + ["[[Fit Statistics]]"]
    lines += _fact("RMS error", f"{_error(data['rmse_after'], data['unit'])}, before "
                                f"{_error(data['rmse_before'], data['unit'])}")
    lines += _fact("noise found", _error((data.get("noise") or {}).get("rms"), data["unit"]))
    if data.get("p_value") is not None:
        lines += _fact("p of the misfit", f"{number(data['p_value'], 2)}, of what remains "
                                          f"{number(data.get('remaining_p_value'), 2)}")
    lines += _fact("chi-square, AIC, BIC", "-")
    lines += wrapped("The document lacks the chi-square of the model without effects (field "
                     "baseline.chi_square) and ln det(2 pi S) of the noise "
                     "(noise.log_determinant). Differences between explanations need neither, "
                     "where they have a gain.")
    if base is not None:
        judged = any(e.get("gain") is not None for e in data["effects"])
        lines += _ranking(data, len(base)) if judged else _held_out(data)
    lines += ["[[Parameters]]"]
    for effect in named:
        for name, p in effect["parameters"].items():
            lines += _parameter(f"{effect_name(effect)}.{name}", p, None)
    # Without a verdict of one set every effect has base parameters of its own.
    for name, p in (data.get("base_parameters") or {}).items():
        lines += _parameter(name, {**p, "value": p["after"]}, p["before"])
    if not named and not data.get("base_parameters"):
        lines += wrapped("none: no effect is named, and the base parameters are those of calibrate")
    else:
        lines += wrapped("start: fitted without effects; value: with the first explanation. "
                         "Correlations are not in the document (field correlation): add has them.")
    return lines + _said(data)


def fit_report(result: Any) -> str:
    """Report of a fit, as those of lmfit and statsmodels read.

    Parameters
    ----------
    result : Calibration, Addition or Diagnosis
        Its document ``data`` is all that is used.

    Returns
    -------
    str
        Plain text of 80 columns: header, chi-square, AIC and BIC with their formulas, parameters
        with standard errors, correlations above 0.1. A fit against known noise has ``AIC = chi2 +
        2 k``, ``BIC = chi2 + k ln N`` with N readings and k parameters that moved; the constant of
        the noise is left out. Where the noise is not known both come from the RMS error. Numbers
        that a document lacks are named, with the field that would have to hold them.

    Raises
    ------
    TypeError
        Something else.
    ValueError
        A Calibration of catalogue rigidities, which is of no readings.

    Examples
    --------
    >>> Calibration = type("Calibration", (), {"data": {
    ...     "parameters": {"f0": {"value": 1.5, "std": 0.03, "unit": "1", "start": 2.0,
    ...                           "lower": 0.01, "upper": 30.0, "at_bound": False,
    ...                           "identifiable": True}},
    ...     "correlation": [[1.0]], "rows": 101, "rows_not_predicted": [],
    ...     "degrees_of_freedom": 100, "reduced_chi_square": 1.1, "quantity": "friction_torque",
    ...     "unit": "Nmm", "rmse_before": 74.4, "rmse": 10.7, "messages": [],
    ...     "report": {"status": "converged", "iterations": 1}}})
    >>> print("\\n".join(fit_report(Calibration()).splitlines()[:8]))
    [[Calibration of friction_torque]]
        rows                  = 101
        parameters            = 1 free, 1 moved
        degrees of freedom    = 100
        fit                   = converged, iterations 1
    [[Fit Statistics]]
        chi-square            = 110
        reduced chi-square    = 1.1
    """
    data = document_of(result, ("Calibration", "Addition", "Diagnosis"), "fit_report()")
    if kind_of(result) == "Calibration" and "degrees_of_freedom" not in data:
        raise ValueError("fit_report(): this Calibration is of no readings: see its data")
    writer = {"Calibration": _calibration, "Addition": _addition, "Diagnosis": _diagnosis}
    return "\n".join(writer[kind_of(result)](data))

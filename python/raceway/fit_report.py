"""Report of a fit as plain text, in the order in which lmfit and statsmodels print theirs."""

from __future__ import annotations

import math
import textwrap
from dataclasses import dataclass
from typing import Any

from ._documents import document_of, files_text, kind_of, number

WIDTH = 80
LEAST_CORRELATION = 0.1
RANKED = 6  # effects beside those of the verdict


@dataclass
class Likelihood:
    """What the information criteria of one fit are computed from."""

    readings: int  # N
    moved: int  # k, parameters that the fit moved
    chi_square: float | None  # against the noise of the data
    rmse: float | None  # in the unit of the reading

    def criteria(self) -> tuple[float, float] | None:
        """AIC and BIC with the noise as known, less the constant that all models share."""
        return None if self.chi_square is None else _criteria(self.chi_square, self)

    def scaled_criteria(self) -> tuple[float, float] | None:
        """AIC and BIC where the size of the noise is one more thing that the fit finds."""
        return None if not self.chi_square else _criteria(_log_mean(self.chi_square, self), self)

    def error_criteria(self) -> tuple[float, float] | None:
        """The same from the RMS error, as if all rows weighed alike."""
        if not self.rmse:
            return None
        return _criteria(_log_mean(self.readings * self.rmse**2, self), self)


def _log_mean(total: float, fit: Likelihood) -> float:
    return fit.readings * math.log(total / fit.readings)


def _criteria(deviance: float, fit: Likelihood) -> tuple[float, float]:
    return deviance + 2.0 * fit.moved, deviance + fit.moved * math.log(fit.readings)


def plain(value: object) -> str:
    """Text of one line: control characters of a name cannot move a terminal's cursor."""
    return "".join(c if c.isprintable() else "?" for c in str(value))


def _unit(unit: str | None) -> str:
    return {"Nmm": "N mm", "1": "", None: ""}.get(unit, unit or "")


def _with_unit(value: float | None, unit: str | None, digits: int = 5) -> str:
    return f"{number(value, digits)} {_unit(unit)}".rstrip()


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


def likelihood_of(data: dict[str, Any]) -> Likelihood:
    """Of the document of a calibration.

    A parameter that the data do not tell is held, which the document does not say of each: how many
    moved follows from rows and degrees of freedom. Of several measured columns it lacks the number
    of readings, and those that are identifiable count as moved.
    """
    freedom = data["degrees_of_freedom"]
    moved = data["rows"] - freedom
    if "channels" in data or not 0 <= moved <= len(data["parameters"]):
        moved = sum(bool(p.get("identifiable")) for p in data["parameters"].values())
    reduced = data.get("reduced_chi_square")
    return Likelihood(freedom + moved, moved, None if reduced is None else reduced * freedom,
                      None if "channels" in data else data.get("rmse"))


def _pair(values: tuple[float, float]) -> str:
    return f"{values[0]:.6g}, {values[1]:.6g}"


def _statistics(data: dict[str, Any], fit: Likelihood) -> list[str]:
    lines = _fact("chi-square", "-" if fit.chi_square is None else f"{fit.chi_square:.6g}")
    lines += _fact("reduced chi-square", number(data.get("reduced_chi_square"), 5))
    for part in data.get("channels", [data]):
        error = f"{_with_unit(part['rmse'], part['unit'], 4)}, before " \
            f"{_with_unit(part['rmse_before'], part['unit'], 4)}"
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
            "(reduced_chi_square is null). These are lmfit's, of rows that weigh alike.")
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
                         f"{_with_unit(part['rmse_before'], data['unit'], 4)} -> "
                         f"{_with_unit(part['rmse_after'], data['unit'], 4)}")
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


def _free_sizes(effect: dict[str, Any]) -> tuple[int, int] | None:
    """Parameters of an effect that moved, and shapes among them; nothing where that is not told.

    An effect has one size; which of several it is stands in no field, so that of several with one
    at a bound it cannot be said how many shapes moved.
    """
    at_bound = [bool(p.get("at_bound")) for p in effect["parameters"].values()]
    if len(at_bound) > 1 and any(at_bound):
        return None
    return len(at_bound), len(at_bound) - 1


def _likelihood_fall(gain: float | None, members: list[dict[str, Any]],
                     readings: int) -> tuple[float, int] | None:
    """Fall of -2 ln L, and parameters more: a gain is that fall less ln N of every free shape."""
    counts = [_free_sizes(effect) for effect in members]
    if None in counts or not counts or gain is None:
        return None
    shapes = sum(s for _, s in counts)  # type: ignore[misc]
    return gain + shapes * math.log(readings), sum(k for k, _ in counts)  # type: ignore[misc]


@dataclass
class Explanation:
    """One effect, or a set of them that is switched on at once."""

    name: str
    members: list[dict[str, Any]]
    lead: dict[str, Any] | None  # the effect whose gain and error are those of all members
    in_verdict: bool


def _ranked(data: dict[str, Any]) -> list[Explanation]:
    """The explanations, best first.

    An effect in a set has the gain and the error of the first set that it is in.
    """
    effects = [e for e in data.get("effects", []) if e.get("gain") is not None]
    rows: list[Explanation] = []
    if data["verdict"] == "several-effects":
        seen: list[str] = []
        for ids in data.get("explanations") or []:
            members = [e for e in effects if e.get("in_verdict") and e["id"] in ids]
            lead = next((e for e in members if e["id"] not in seen), None)
            rows.append(Explanation(" + ".join(ids), members, lead, True))
            seen += ids
        effects = [e for e in effects if e["id"] not in seen]
    named = sum(bool(e.get("in_verdict")) for e in effects)
    return rows + [Explanation(e["id"], [e], e, bool(e.get("in_verdict")))
                   for e in effects[: named + RANKED]]


def _explanation(one: Explanation, data: dict[str, Any], base: int) -> tuple[list[str], bool]:
    """Its line, and whether its criteria are known."""
    readings = data["rows"]
    gain, rmse = (one.lead["gain"], one.lead.get("rmse")) if one.lead else (None, None)
    fall = None if "channels" in data else _likelihood_fall(gain, one.members, readings)
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
    for one in _ranked(data):
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
        lines += _fact("degrees of freedom", f"{data['rows'] - len(base)} without effects")
    lines += _fact("candidates tried", data.get("candidates_tried", "-"))
    lines += _fact("verdict", data["verdict"]) + ["[[Fit Statistics]]"]
    lines += _fact("RMS error", f"{_with_unit(data['rmse_after'], data['unit'], 4)}, before "
                                f"{_with_unit(data['rmse_before'], data['unit'], 4)}")
    lines += _fact("noise found", _with_unit((data.get("noise") or {}).get("rms"), data["unit"], 4))
    lines += _fact("p of the misfit", f"{number(data.get('p_value'), 2)}, of what remains "
                                      f"{number(data.get('remaining_p_value'), 2)}")
    lines += _fact("chi-square, AIC, BIC", "-")
    lines += wrapped("The document lacks the chi-square of the model without effects (field "
                     "baseline.chi_square) and ln det(2 pi S) of the noise "
                     "(noise.log_determinant); differences between explanations need neither, "
                     "see below.")
    if base is not None:
        lines += _ranking(data, len(base))
    lines += ["[[Parameters]]"]
    for effect in named:
        for name, p in effect["parameters"].items():
            lines += _parameter(f"{effect['id']}.{name}", p, None)
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
    writer = {"Calibration": _calibration, "Addition": _addition, "Diagnosis": _diagnosis}
    return "\n".join(writer[kind_of(result)](data))

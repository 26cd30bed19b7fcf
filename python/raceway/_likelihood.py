"""Likelihoods of fits as documents tell them: information criteria, explanations ranked."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ._documents import effect_name

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


def _free_sizes(effect: dict[str, Any]) -> tuple[int, int] | None:
    """Parameters of an effect that moved, and shapes among them; nothing where that is not told.

    An effect has one size; which of several it is stands in no field, so that of several with one
    at a bound it cannot be said how many shapes moved.
    """
    at_bound = [bool(p.get("at_bound")) for p in effect["parameters"].values()]
    if len(at_bound) > 1 and any(at_bound):
        return None
    return len(at_bound), len(at_bound) - 1


def likelihood_fall(gain: float | None, members: list[dict[str, Any]],
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


def ranked(data: dict[str, Any]) -> list[Explanation]:
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
    return rows + [Explanation(effect_name(e), [e], e, bool(e.get("in_verdict")))
                   for e in effects[: named + RANKED]]

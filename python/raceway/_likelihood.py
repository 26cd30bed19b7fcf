"""Explanations of a diagnosis with their likelihoods. The best explanation is first."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ._documents import effect_name

RANKED = 6  # effects in addition to the effects of the verdict


@dataclass
class Explanation:
    """One effect, or a set of effects that are added to the model together."""

    name: str
    fit: dict[str, Any]  # with gain, chi_square, degrees_of_freedom, aic, bic, rmse
    in_verdict: bool


def ranked(data: dict[str, Any]) -> list[Explanation]:
    """Return the explanations in the verdict, followed by the next best single effects."""
    effects = [e for e in data.get("effects", []) if e.get("gain") is not None]
    rows: list[Explanation] = []
    if data["verdict"] == "several-effects":
        # An effect that is in several sets has the values of the first set.
        rows = [Explanation(" + ".join(ids), fit, True) for ids, fit in zip(data["explanations"], data["explanation_fits"])]
        named = {one for ids in data["explanations"] for one in ids}
        effects = [e for e in effects if e["id"] not in named]
    first = sum(bool(e.get("in_verdict")) for e in effects)
    return rows + [Explanation(effect_name(e), e, bool(e.get("in_verdict"))) for e in effects[: first + RANKED]]

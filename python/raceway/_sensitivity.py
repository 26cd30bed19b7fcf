"""Influence of each input value (datum) of a model on its predictions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from . import _engine
from ._given import axis, name_list, time_limit, value_of, warn, whole_number
from ._results import _Answer

if TYPE_CHECKING:
    import pandas

_FIRST = 15  # numbers that a report lists


class Sensitivity(_Answer):
    """Derivatives of predictions with respect to each varied datum of a model and, if requested, Sobol' indices.

    A datum is a number of the model, such as a dimension or a temperature. The spread of a datum is its possible
    error in both directions. ``change`` is the resulting change of the prediction. ``share`` is the square of this
    change divided by the sum of the squares of all changes.
    """

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per prediction, operating point and datum, with the largest change first.

        Sobol' indices add the columns ``first`` and ``total``, and half the width of the 95 % interval of each index.
        """
        import pandas

        rows = []
        for p in self.data["predictions"]:
            state = {k: v for k, v in p.items() if k not in _NO_STATE}
            for datum in p["data"]:
                row = {
                    "prediction": p["name"],
                    **state,
                    "predicted": p["value"],
                    **{"datum" if k == "name" else k: v for k, v in datum.items() if k != "global"},
                }
                rows.append(row | (datum.get("global") or {}))
        return pandas.DataFrame(rows)

    @property
    def does_not_enter(self) -> list[str]:
        """Names of the data that have no influence on any prediction."""
        return list(self.data["does_not_enter"])

    def text(self) -> str:
        """Return text with a table of the most influential data for each prediction and operating point."""
        blocks = [_block(p) for p in self.data["predictions"]]
        if self.does_not_enter:
            blocks.append("no influence: " + ", ".join(self.does_not_enter))
        blocks += [f"not varied: {n['name']}: {n['why']}" for n in self.data["not_varied"]]
        return "\n\n".join(blocks)

    def _repr_html_(self) -> str:
        from ._html import paragraph, table, text

        html = ""
        for p in self.data["predictions"]:
            html += paragraph(f"<b>{text(_title(p))}</b>")
            head, rows = _rows(p)
            html += table(head, [[text(cell) for cell in row] for row in rows])
        return html

    def __repr__(self) -> str:
        predictions = self.data["predictions"]
        names = list(dict.fromkeys(p["name"] for p in predictions))
        first = predictions[0]["data"]
        most = f"; largest influence on the first prediction: {first[0]['name']}" if first else ""
        return f"<raceway.Sensitivity of {', '.join(names)}{most}>"


_NO_STATE = ("name", "value", "mean", "std", "complete_samples", "cannot_tell", "data")


def _number(value: float | None, digits: int = 4) -> str:
    return "-" if value is None else f"{value:.{digits}g}"


def _title(p: dict[str, Any]) -> str:
    state = ", ".join(f"{k} {v:g}" for k, v in p.items() if k not in _NO_STATE)
    return f"{p['name']} = {_number(p['value'])} at {state}"


def _rows(p: dict[str, Any]) -> tuple[list[str], list[list[str]]]:
    head = ["datum", "value", "+-", "derivative", "% per %", "change", "share %"]
    sampled = any("global" in d for d in p["data"])
    if sampled:
        head += ["first order", "total"]
    rows = []
    for d in p["data"][:_FIRST]:
        row = [
            d["name"],
            _number(d["value"], 6),
            _number(d["spread"], 3),
            _number(d["derivative"]),
            _number(d["elasticity"], 3),
            _number(d["change"], 3),
            "-" if d["share"] is None else f"{100 * d['share']:.1f}",
        ]
        if sampled:
            row += [_index(d.get("global"), "first"), _index(d.get("global"), "total")]
        rows.append(row)
    return head, rows


def _index(index: dict[str, Any] | None, name: str) -> str:
    if not index or index[name] is None:
        return "-"
    return f"{index[name]:.3f} +-{_number(index[name + '_error'], 2)}"


def _block(p: dict[str, Any]) -> str:
    head, rows = _rows(p)
    widths = [max(len(row[k]) for row in [head, *rows]) for k in range(len(head))]
    lines = [_title(p), ""]
    for row in [head, *rows]:
        cells = [cell.ljust(w) if k == 0 else cell.rjust(w) for k, (cell, w) in enumerate(zip(row, widths))]
        lines.append("  ".join(cells).rstrip())
    if len(p["data"]) > _FIRST:
        lines.append(f"{len(p['data']) - _FIRST} more in the attribute data")
    return "\n".join(lines + list(p.get("cannot_tell", [])))


class SensitivityQuestion:
    """Sensitivity analysis of a `Model`."""

    _engine: _engine.Model

    def sensitivity(
        self,
        speed_rpm: ArrayLike,
        axial_load_N: ArrayLike | None = None,
        radial_load_N: ArrayLike | None = None,
        temperature_C: ArrayLike | None = None,
        *,
        of: str | Iterable[str] = (),
        spread: Mapping[str, float | str] | None = None,
        data: str | Iterable[str] = (),
        samples: int = 0,
        seed: int = 1,
        steady: bool = False,
        coolant: bool = True,
        time_limit_s: float | None = None,
        progress: Callable[[float, str], None] | None = None,
    ) -> Sensitivity:
        """Rank the data of the model by their influence on its prediction (docs/sensitivity.md).

        Parameters
        ----------
        speed_rpm, axial_load_N, radial_load_N, temperature_C : float or sequence of float
            Operating points. The method calculates all combinations of these values. The model supplies the values
            of omitted arguments. With `steady`, only `speed_rpm` is allowed.
        of : str or iterable of str
            Predictions to analyse: ``"torque"``, ``"heat"``, ``"displacement"``, ``"contact-angle"``,
            ``"stiffness"``, ``"pressure"``, ``"life"``, ``"preload"``, ``"temperature"``, or names of result columns.
            Each kind of model supports only some of these words. For an unsupported word, the InputError lists the
            supported words. Default: ``"torque"`` for a bearing, and ``"displacement"`` for a shaft or a spindle.
        spread : mapping
            Possible error of a datum in both directions, by the name of the datum: a number in the unit of the
            datum, or a percentage such as ``"10%"``. Default: 1 % of the value, 1 K for a temperature, 1 for a count,
            and sqrt(3) standard errors for a fitted number.
        data : str or iterable of str
            Names of the data to vary. The name of a table, such as ``"bearing"``, means all data of this table.
            Default: all data.
        samples : int
            Number of samples for the Sobol' indices, a power of two. 0 calculates only the derivatives.
        seed : int
            Random seed of the samples.
        steady : bool
            True analyses the steady state of the whole spindle at each speed.
        coolant : bool
            True if the coolant flows. This argument has an effect only with `steady`.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.
        progress : callable, optional
            Function that receives the completed share (0 to 1) and the name of the current step. The function is called at most 20 times per second.

        Raises
        ------
        InputError
            The model does not have a requested datum or prediction, or a spread is negative.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.

        Examples
        --------
        >>> import raceway
        >>> model = raceway.Model.read("tests/hidden_effect/rigs/dev-03/model.toml")
        >>> found = model.sensitivity(6000, 300, of="torque")
        >>> found.to_frame()[["datum", "elasticity"]].head(3).round(3)
                               datum  elasticity
        0  bearing.pitch_diameter_mm       2.959
        1          rig.temperature_C         NaN
        2                friction.f0       0.980
        """
        spreads = [(str(n), v if isinstance(v, str) else repr(value_of(f"spread of {n}", v))) for n, v in (spread or {}).items()]
        answer = _engine.sensitivity(
            self._engine,
            _split("of", of),
            [
                axis("speed_rpm", speed_rpm),
                axis("axial_load_N", axial_load_N),
                axis("radial_load_N", radial_load_N),
                axis("temperature_C", temperature_C),
            ],
            bool(steady),
            bool(coolant),
            spreads,
            _split("data", data),
            _count("samples", samples),
            _count("seed", seed),
            time_limit(time_limit_s),
            progress,
        )
        warn(answer.warnings)
        return Sensitivity(answer)


def _split(argument: str, names: str | Iterable[str]) -> list[str]:
    return [name for list_of_names in name_list(argument, names) for name in list_of_names.split(",")]


def _count(name: str, value: int) -> int:
    number = whole_number(name, value)
    if not 0 <= number < 2**63:
        raise ValueError(f"{name} = {number}: must be from 0 to 2**63 - 1")
    return number

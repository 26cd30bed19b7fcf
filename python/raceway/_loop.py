"""What every model can be asked with measurements."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

from . import _engine
from ._errors import NotConverged, in_python
from ._from_file import FromFile
from ._given import name_list, seconds, tolerance_text, warn
from ._record import Record
from ._results import Addition, Calibration, Check, Comparison, Diagnosis

Records: TypeAlias = "Record | Sequence[Record]"


def asked(
    record: Records,
    *,
    channel: str | None = None,
    per_record: Iterable[str] = (),
    rows: bool = False,
    tolerance: str | None = None,
    from_s: float | None = None,
    until_s: float | None = None,
) -> tuple[list[_engine.Data], dict[str, Any]]:
    """Records and options as the engine takes them."""
    records = list(record) if isinstance(record, (list, tuple)) else [record]
    for one in records:
        if not isinstance(one, Record):
            raise TypeError(f"a raceway.Record is wanted, not {type(one).__name__}: " "Record.read(path) or Record.from_pandas(frame)")
    if not records:
        raise ValueError("no record is given")
    maps = {r._columns for r in records}
    if len(maps) > 1:
        raise ValueError("columns: several records of one question are read by one map")
    options: dict[str, Any] = {
        "columns": maps.pop(),
        "drop_nan": any(r._drop_nan for r in records),
        "channel": channel,
        "per_record": name_list("per_record", per_record),
        "rows": bool(rows) or None,
        "tolerance": None if tolerance is None else tolerance_text(tolerance),
        "from": seconds("from_s", from_s),
        "until": seconds("until_s", until_s),
    }
    return [r._data for r in records], {name: value for name, value in options.items() if value not in (None, "", [])}


class LoopModel(FromFile):
    """The loop: how far a model is from records, which effect is missing, what adding it buys."""

    def _fitted(self, answer: _engine.Answer, fitted: str) -> dict[str, Any]:
        """Models that a fit found, by record; one without name where it holds for all."""
        raise NotImplementedError

    def suggest_columns(self, record: Record) -> str:
        """Propose which columns of a record are which of ours, by their words and units.

        Returns
        -------
        str
            A table ``[columns]`` (TOML) for the argument `columns` of `Record`; what was not found
            stands in it as a comment.
        """
        if not isinstance(record, Record):
            raise TypeError(f"a raceway.Record is wanted, not {type(record).__name__}")
        return in_python(_engine.suggest_columns(self._engine, record._data))

    def compare(
        self,
        record: Records,
        *others: LoopModel,
        refit: str | Iterable[str] = (),
        zero: str = "mean",
        channel: str | None = None,
        per_record: Iterable[str] = (),
        rows: bool = False,
        tolerance: str | None = None,
        from_s: float | None = None,
        until_s: float | None = None,
    ) -> Comparison:
        """Say how far the model is from a record, and where; with other models: the ladder.

        Parameters
        ----------
        record : Record or sequence of Record
        *others : models of the same kind
        refit : iterable of str
            Parameters that are fitted to the record before; of a correction also groups, ``"gains"``.
        zero : {"mean", "first", "none"}
            Of a correction, the constant taken off before: that which leaves least, the first reading
            of a run, none.
        channel : str, optional
            Of a file with several displacements, the column of one: ``"displacement_z_um"``.
        per_record : iterable of str
            Parameters that each of several records has for itself; not of a correction.
        rows : bool
            Keeps the rows of a logger apart. Otherwise consecutive rows at equal speed and load are
            averaged to dwells, which a note says.
        tolerance : str, optional
            Error below which nothing matters, such as ``"2Nmm"``.
        from_s, until_s : float, optional
            Of a correction, readings that count, by the time since the first row [s].
        """
        if zero not in ("mean", "first", "none"):
            raise ValueError(f"zero = {zero!r}: must be mean, first or none")
        for other in others:
            if not isinstance(other, type(self)):
                raise TypeError(f"a raceway.{type(self).__name__} is wanted, not {type(other).__name__}")
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        engines = [m._engine for m in (self, *others)]
        answer = _engine.compare(engines, data, name_list("refit", refit), zero, **options)
        warn(answer.warnings)
        return Comparison(answer)

    def calibrate(
        self,
        record: Records,
        *,
        profile: bool = False,
        channel: str | None = None,
        per_record: Iterable[str] = (),
        rows: bool = False,
        from_s: float | None = None,
        until_s: float | None = None,
    ) -> Calibration:
        """Re-fit the free numbers of the model.

        They are named by ``[calibration] free``; without it f0 and z of a bearing, gains, time constants
        and offset of a correction.

        Parameters
        ----------
        record : Record or sequence of Record
        profile : bool
            Also 95 % intervals by profile likelihood, for `Calibration.conf_interval`: some dozens
            of refits.
        channel, per_record, rows, from_s, until_s
            As in `compare`.

        Raises
        ------
        NotConverged
            Where the fit found no values.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, from_s=from_s, until_s=until_s)
        answer = _engine.calibrate(self._engine, data, bool(profile), **options)
        if not answer.converged:
            raise NotConverged("; ".join(["the calibration did not converge", *answer.warnings]))
        warn(answer.warnings)
        return Calibration(answer, self._fitted(answer, ", calibrated"))

    def diagnose(
        self,
        record: Records,
        *,
        pairs: bool = True,
        tried_before: int = 0,
        channel: str | None = None,
        per_record: Iterable[str] = (),
        rows: bool = False,
        tolerance: str | None = None,
        from_s: float | None = None,
        until_s: float | None = None,
        time_limit_s: float | None = None,
        progress: Callable[[float, str], None] | None = None,
    ) -> Diagnosis:
        """Say which physical effect is missing in the model, or what to measure to find out.

        A correction is judged by its error on parts held out, against the tolerance.

        Parameters
        ----------
        record : Record or sequence of Record
        pairs : bool
            Without: single effects only, for a quick look.
        tried_before : int
            Explanations of your own already tried on these data.
        channel, per_record, rows, tolerance, from_s, until_s
            As in `compare`.
        time_limit_s : float, optional
            After which it gives up with TimeoutError.
        progress : callable, optional
            Called with the share that is done and the step, some ten times a second.

        Raises
        ------
        InputError
            Data that carry no verdict, with the reason; a correction without a tolerance.
        KeyboardInterrupt
            Stops it; nothing is left half done.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        limit = float("inf") if time_limit_s is None else float(time_limit_s)
        answer = _engine.diagnose(self._engine, data, bool(pairs), int(tried_before), limit, progress, **options)
        warn(answer.warnings)
        return Diagnosis(answer)

    def add(
        self,
        effects: str | Iterable[str],
        record: Records,
        *,
        channel: str | None = None,
        per_record: Iterable[str] = (),
        rows: bool = False,
        tolerance: str | None = None,
        from_s: float | None = None,
        until_s: float | None = None,
    ) -> Addition:
        """Switch effects on, calibrate the model, and judge them on rows that the fit did not see.

        The other parameters are as in `compare`.

        Returns
        -------
        Addition
            `Addition.refused` says why an effect does not help; `Addition.model` has it all the same.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        ids = name_list("effects", effects)
        answer = _engine.add(self._engine, ids, data, **options)
        if not answer.converged:
            raise NotConverged("; ".join(["the fit did not converge", *answer.warnings]))
        warn(answer.warnings)
        return Addition(answer, self._fitted(answer, "".join(f" + {name}" for name in ids)))

    def check(self, record: Record, *, channel: str | None = None) -> Check:
        """Check what a record can show: levels, noise, fittable parameters, testable effects."""
        data, options = asked(record, channel=channel)
        if len(data) > 1:
            raise TypeError("check: one record is looked at at a time")
        answer = _engine.check(self._engine, data[0], **options)
        warn(answer.warnings)
        return Check(answer)

"""Questions that every model can answer with measurements."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

from . import _engine
from ._errors import NotConverged, in_python
from ._from_file import FromFile
from ._given import name_list, seconds, time_limit, tolerance_text, warn
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
    """Return records and options in the form of the engine."""
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
    """The loop: compare a model with records, find the missing effect, add it and see the error fall."""

    def _fitted(self, answer: _engine.Answer, fitted: str) -> dict[str, Any]:
        """Return the fitted models by record; a single model without a name if it holds for all records."""
        raise NotImplementedError

    def suggest_columns(self, record: Record) -> str:
        """Propose a map of the columns of a record, from their words and units.

        Returns
        -------
        str
            A table ``[columns]`` (TOML) for the argument `columns` of `Record`. Columns that were not
            found are comments in it.
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
        """Calculate the error of the model on a record and where it is largest. With other models, compare all.

        Parameters
        ----------
        record : Record or sequence of Record
        *others : models of the same kind
        refit : iterable of str
            Parameters to fit to the record first. For a correction, groups such as ``"gains"`` are allowed.
        zero : {"mean", "first", "none"}
            Constant that is subtracted first, for a correction: the mean difference, the first reading of
            a run, or nothing.
        channel : str, optional
            Column of one displacement, if a file has several: ``"displacement_z_um"``.
        per_record : iterable of str
            Parameters with a separate value for each of several records; not for a correction.
        rows : bool
            True keeps the rows of a logger separate. Otherwise, consecutive rows at equal speed and load
            are averaged to one dwell, and a note says so.
        tolerance : str, optional
            Smallest error that matters, such as ``"2Nmm"``.
        from_s, until_s : float, optional
            Time range of the readings that count, for a correction, since the first row [s].
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
        """Fit the free parameters of the model again.

        ``[calibration] free`` names them. The default is f0 and z of a bearing, or gains, time constants and
        offset of a correction.

        Parameters
        ----------
        record : Record or sequence of Record
        profile : bool
            True adds 95 % intervals by profile likelihood for `Calibration.conf_interval`. This takes some
            dozens of fits.
        channel, per_record, rows, from_s, until_s
            As in `compare`.

        Raises
        ------
        NotConverged
            The fit found no values.
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
        """Find the physical effect that the model lacks, or the measurements that would show it.

        A correction is judged by its held-out error relative to the tolerance.

        Parameters
        ----------
        record : Record or sequence of Record
        pairs : bool
            False tries single effects only, which is faster.
        tried_before : int
            Number of explanations that you have already tried on these data.
        channel, per_record, rows, tolerance, from_s, until_s
            As in `compare`.
        time_limit_s : float, optional
            Time after which TimeoutError is raised.
        progress : callable, optional
            Function that is called with the completed share and the step, some ten times a second.

        Raises
        ------
        InputError
            The data do not support a verdict (the message has the reason), or a correction has no tolerance.
        KeyboardInterrupt
            An interrupt stops the search. Nothing is left half done.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        answer = _engine.diagnose(self._engine, data, bool(pairs), int(tried_before), time_limit(time_limit_s), progress, **options)
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
        """Add effects, calibrate the model, and judge it on rows that the fit did not use.

        The other parameters are as in `compare`.

        Returns
        -------
        Addition
            `Addition.refused` gives the reason if an effect does not help. `Addition.model` has the effect
            anyway.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        ids = name_list("effects", effects)
        answer = _engine.add(self._engine, ids, data, **options)
        if not answer.converged:
            raise NotConverged("; ".join(["the fit did not converge", *answer.warnings]))
        warn(answer.warnings)
        return Addition(answer, self._fitted(answer, "".join(f" + {name}" for name in ids)))

    def check(self, record: Record, *, channel: str | None = None) -> Check:
        """Check what a record can show: levels, noise, parameters for a fit, and effects that can be tested."""
        data, options = asked(record, channel=channel)
        if len(data) > 1:
            raise TypeError("check: one record is looked at at a time")
        answer = _engine.check(self._engine, data[0], **options)
        warn(answer.warnings)
        return Check(answer)

"""Calculations with a model and measurements: compare, calibrate, diagnose, add and check."""

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
    """Return the records and the options in the form that the engine accepts."""
    records = list(record) if isinstance(record, (list, tuple)) else [record]
    for one in records:
        if not isinstance(one, Record):
            raise TypeError(f"must be a raceway.Record, not {type(one).__name__}; use " "Record.read(path) or Record.from_pandas(frame)")
    if not records:
        raise ValueError("no record is given")
    maps = {r._columns for r in records}
    if len(maps) > 1:
        raise ValueError("columns: all records of one call must have the same map of columns")
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
    """Methods that compare a model with records, find the missing effect, add this effect to the model and calculate the new error."""

    def _fitted(self, answer: _engine.Answer, fitted: str) -> dict[str, Any]:
        """Return the fitted models by the names of their records. A single model for all records has the name ""."""
        raise NotImplementedError

    def suggest_columns(self, record: Record) -> str:
        """Propose a map of the columns of a record. The proposal uses the words and units in the names of the columns.

        Returns
        -------
        str
            A table ``[columns]`` (TOML) for the argument `columns` of `Record`. Comments in the table list the
            columns that were not found.
        """
        if not isinstance(record, Record):
            raise TypeError(f"must be a raceway.Record, not {type(record).__name__}")
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
        """Calculate the error of the model on a record, and find the conditions with the largest error. If `others` are given, compare all models.

        Parameters
        ----------
        record : Record or sequence of Record
            Measurements.
        *others : Model or Correction
            Other models of the same class as this model.
        refit : iterable of str
            Parameters to fit to the record before the comparison. For a correction, groups such as ``"gains"`` are
            allowed.
        zero : {"mean", "first", "none"}
            Only for a correction: error that is subtracted from the predictions of each run. ``"mean"``: mean error,
            ``"first"``: error of the first reading, ``"none"``: nothing.
        channel : str, optional
            Column of the displacement to use if a file has several, such as ``"displacement_z_um"``.
        per_record : iterable of str
            Parameters that get a separate value for each record. Not available for a correction.
        rows : bool
            True uses every row. False averages consecutive rows at equal speed and load to one dwell, and a note
            reports this.
        tolerance : str, optional
            Largest acceptable RMS error, such as ``"2Nmm"``.
        from_s, until_s : float, optional
            Time range of the readings that are evaluated: start and end, measured from the first row [s]. Only for a
            correction.
        """
        if zero not in ("mean", "first", "none"):
            raise ValueError(f"zero = {zero!r}: must be mean, first or none")
        for other in others:
            if not isinstance(other, type(self)):
                raise TypeError(f"must be a raceway.{type(self).__name__}, not {type(other).__name__}")
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
        """Fit the free parameters of the model to a record.

        The key ``free`` in the table ``[calibration]`` of the model lists these parameters. The default for a bearing
        depends on its friction law, such as f0 and z for the law ``palmgren``. The default for a correction is gains, time
        constants and offset.

        Parameters
        ----------
        record : Record or sequence of Record
            Measurements.
        profile : bool
            True adds 95 % intervals by profile likelihood for `Calibration.conf_interval`. This needs dozens of
            additional fits.
        channel, per_record, rows, from_s, until_s
            These arguments have the same meaning as in `compare`.

        Raises
        ------
        NotConverged
            The fit did not converge.
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
        """Find the missing physical effect of the model, or the measurements that can identify it.

        The diagnosis of a correction compares the held-out error with the tolerance. If the model marks
        ``viscosity_100C_mm2_s`` as assumed, and the record determines this value, the fit also changes it. A warning
        then gives the fitted value.

        Parameters
        ----------
        record : Record or sequence of Record
            Measurements.
        pairs : bool
            True also tries combinations of effects. False tries only single effects and is faster.
        tried_before : int
            Number of explanations that you have already tried on these data. The threshold for a verdict rises with
            this number.
        channel, per_record, rows, tolerance, from_s, until_s
            These arguments have the same meaning as in `compare`.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.
        progress : callable, optional
            Function that receives the completed share (0 to 1) and the name of the current step. The function is called at most 20 times per second.

        Raises
        ------
        InputError
            The data do not support a verdict (the message gives the reason), or a correction has no tolerance.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.
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
        """Add effects to the model, calibrate the model, and test it on rows that the fit did not use.

        The argument `effects` gives the ids of the effects. The other arguments have the same meaning as in `compare`.

        Returns
        -------
        Addition
            If an effect does not improve the model, `Addition.refused` gives the reason. `Addition.model` always
            contains the effects.
        """
        data, options = asked(record, channel=channel, per_record=per_record, rows=rows, tolerance=tolerance, from_s=from_s, until_s=until_s)
        ids = name_list("effects", effects)
        answer = _engine.add(self._engine, ids, data, **options)
        if not answer.converged:
            raise NotConverged("; ".join(["the fit did not converge", *answer.warnings]))
        warn(answer.warnings)
        return Addition(answer, self._fitted(answer, "".join(f" + {name}" for name in ids)))

    def check(self, record: Record, *, channel: str | None = None) -> Check:
        """Report levels and noise of a record, the parameters that a fit can determine, and the effects that can be tested with the record."""
        data, options = asked(record, channel=channel)
        if len(data) > 1:
            raise TypeError("check: only one record is possible; call check for each record")
        answer = _engine.check(self._engine, data[0], **options)
        warn(answer.warnings)
        return Check(answer)

"""Corrections of machines: the displacement over hours, from what a control knows."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from . import _engine
from ._correction_results import CorrectionRun, Identification, Program
from ._errors import InputError
from ._given import name_list, seconds, text_of, time_limit, warn
from ._loop import LoopModel, asked
from ._model import Model, _only_corrects, _tables
from ._note import Note
from ._record import Record
from ._series import lag_texts, one_record, order_text

FORMATS = ("python", "c", "csv", "linuxcnc")


class Correction(LoopModel):
    """Model of the displacement of a machine: lags of temperatures, power, speed and feeds.

    One file may have several displacements, each with its model. A correction never changes: a
    fit returns another one. `read` and `from_text` make one.

    Examples
    --------
    >>> correction = Correction.from_text('''
    ... [correction]
    ... displacement = "displacement_z_um"
    ... [[correction.channel]]
    ... name = "spindle"
    ... input = "front_bearing_temperature_C"
    ... sections = [{ gain_um_K = 5.0, time_constant_s = 5400 }]
    ... ''')
    >>> correction.displacements, correction.inputs
    (['displacement_z_um'], ['front_bearing_temperature_C'])
    >>> correction.parameters["spindle.gain_1"]["value"]
    5.0
    """

    _called = "correction"
    _said: Sequence[Note] = ()  # when it was made

    def __init__(self, source: str, text: str, files: Sequence[tuple[str, str, str]] = ()) -> None:
        tables = _tables(text_of("text", text))
        if tables and "correction" not in tables:
            raise InputError(f"{source}: has no [correction]: raceway.Model.read takes models of bearings")
        self._engine = _engine.Correction(source, text, files)
        warn(self._engine.warnings)

    @classmethod
    def new(cls, record: Record) -> Correction:
        """Make a correction for the displacements of a record over time, for `identify` to begin with.

        It has a channel for each temperature, and its `text` marks each assumption. Columns whose names
        raceway does not know are proposed as ``[columns]``. A `Record` with a map of columns keeps this map.

        Warns
        -----
        Doubt
            Units look wrong.

        Raises
        ------
        InputError
            The record has no displacement.
        """
        data, options = asked(one_record(record))
        text, notes, doubts = _engine.new_correction(data[0], **options)
        warn(doubts)
        correction = cls(cls._called, text)
        correction._said = notes
        return correction

    @property
    def notes(self) -> list[Note]:
        """Notes on the correction, and on the record that `new` made it for."""
        return [*self._said, *self._engine.notes]

    @property
    def displacements(self) -> list[str]:
        """Columns that the correction predicts, such as ``"displacement_z_um"``, or ``"displacement_b_urad"`` for an angle."""
        return self._engine.displacements

    @property
    def inputs(self) -> list[str]:
        """Columns that a record needs as inputs."""
        return self._engine.inputs

    @property
    def trust(self) -> dict[str, str]:
        """Trust in each displacement, judged by readings that no fit used.

        ``"good"``, ``"only inside its range: ..."``, ``"do not use, because ..."``, or
        ``"not known: ..."`` if the file does not say it.
        """
        return self._engine.trust()

    def identify(
        self,
        record: Record,
        *,
        inputs: str | Iterable[str] | None = None,
        order: int | tuple[int, int] = (1, 3),
        lags_s: str | Iterable[float] | None = None,
        baseline: str | None = None,
        validate: Record | None = None,
        from_s: float | None = None,
        until_s: float | None = None,
        time_limit_s: float | None = None,
        progress: Callable[[float, str], None] | None = None,
    ) -> Identification:
        """Find the number of lags of each channel, with their gains and time constants, from a record over time.

        Parameters
        ----------
        record : Record
            With ``time_s``, the inputs and the displacement, whose cells may be empty.
        inputs : str or iterable of str, optional
            Columns that may become channels, or ``"all"``. A column is added as long as the
            held-out error falls.
        order : int or (int, int)
            Number of lags of each channel, from 1 to 6, or the smallest and the largest number.
        lags_s : "auto" or iterable of float, optional
            Fit a bank of lags for machines with many sensors: every input passes through each of these
            lags [s], and ridge regression finds the gains. 0 acts at once, ``"auto"`` follows the length of the record.
        baseline : {"regression", "arx"}, optional
            Method in place of lags. ``"regression"`` uses the inputs as they are. ``"arx"`` fits transfer functions
            by least squares of one step and shows them next to their simulation.
        validate : Record, optional
            Another record, which judges the result.
        from_s, until_s : float, optional
            Readings that count, by the time since the first row [s]. All rows drive the model.
        time_limit_s : float, optional
            Time after which the call raises TimeoutError.
        progress : callable, optional
            Function that is called with the finished share and the step, some ten times a second.

        Raises
        ------
        InputError
            An input is missing, the order or lags are wrong, or the record does not determine the numbers.
        KeyboardInterrupt
            Stops it; nothing is left half done.
        """
        if baseline not in (None, "regression", "arx"):
            raise ValueError(f"baseline = {baseline!r}: must be regression or arx")
        if lags_s is not None and (baseline is not None or order != (1, 3)):
            raise ValueError("lags_s: a bank has neither baseline nor order; take one of them")
        data, options = asked(one_record(record), from_s=from_s, until_s=until_s)
        answer = _engine.identify(
            self._engine,
            data[0],
            None if validate is None else one_record(validate)._data,
            order_text(order),
            [] if inputs is None else name_list("inputs", inputs),
            lag_texts(lags_s),
            baseline or "",
            time_limit(time_limit_s),
            progress,
            **options,
        )
        warn(answer.warnings)
        return Identification(answer, self._fitted(answer, ", identified").get(""))

    def correct(
        self,
        record: Record,
        *,
        learn: bool = False,
        every_s: float | None = None,
        forget_s: float | None = None,
        from_s: float | None = None,
        until_s: float | None = None,
    ) -> CorrectionRun:
        """Run the correction over a record and return predictions with their band, and the residuals.

        Parameters
        ----------
        record : Record
            Record with ``time_s`` and the inputs. Readings of the displacement may be missing.
        learn : bool
            Learn zero, states and gains from the readings in their order. A row is predicted only from
            earlier readings.
        every_s : float, optional
            Shortest time between two readings of `learn` [s]. The other readings judge the result.
        forget_s : float, optional
            Time in which learned gains return to the gains of the model [s], by default 7 days.
        from_s, until_s : float, optional
            Readings that count, by the time since the first row [s].
        """
        data, options = asked(one_record(record), from_s=from_s, until_s=until_s)
        if not learn:
            for argument, value in (("every_s", every_s), ("forget_s", forget_s)):
                if value is not None:
                    raise ValueError(f"{argument}: belongs to learn=True")
            answer = _engine.correct(self._engine, data[0], **options)
        else:
            durations = (seconds("every_s", every_s), seconds("forget_s", forget_s))
            answer = _engine.learn(self._engine, data[0], *durations, **options)
        warn(answer.warnings)
        return CorrectionRun(answer, self._fitted(answer, ", learnt").get(""))

    def join(self, *others: Correction) -> Correction:
        """Return the sum of this correction and `others`, which describe the same displacement.

        The sum keeps channels, laws and effects as written, and adds the offsets. Free parameters stay free, except for delay elements and laws of step responses.

        Raises
        ------
        InputError
            The displacements differ, two channels have one name, two laws of instant displacement exist,
            or the ranges have no common part.
        """
        text, files, _ = _engine.joined([self._engine, *(other._engine for other in others)])
        return Correction(" and ".join([self.source, *(other.source for other in others)]), text, files)

    def export(
        self,
        format: str,
        path: str | os.PathLike[str] | None = None,
        *,
        record: Record | None = None,
        accept_untrusted: bool = False,
        overwrite: bool = False,
    ) -> Program:
        """Return a program that runs on a control without this package, and write it to `path`.

        Parameters
        ----------
        format : {"python", "c", "csv", "linuxcnc"}
            ``"python"`` is one file that needs only the standard library, ``"c"`` one header of C99, ``"csv"`` a table of
            numbers with units, and ``"linuxcnc"`` a HAL component in Python with its HAL files.
        path : path, optional
            File to write. Its name is the prefix of C functions and the name of a component.
        record : Record, optional
            Record whose first run is stored in the file as a check. Without it the check record is synthetic.
        accept_untrusted : bool
            Export a correction even if `trust` says not to use it.

        Raises
        ------
        InputError
            The `trust` of a displacement is "do not use, because ...", and it is not accepted.
        """
        if format not in FORMATS:
            raise ValueError(f"format = {format!r}: must be python, c, csv or linuxcnc")
        output = "" if path is None else os.fspath(path)
        stored = None if record is None else record._data
        program = Program(format, *_engine.export_correction(self._engine, format, output, stored, accept_untrusted))
        if path is not None:
            program.save(path, overwrite=overwrite)
        return program

    def _fitted(self, answer: _engine.Answer, fitted: str) -> dict[str, Correction]:
        source = self.source if self.source.endswith(fitted) else self.source + fitted
        return {"": Correction(source, text, self._engine.files) for text in answer.models}

    def _repr_html_(self) -> str:
        from ._html_correction import correction_html

        return correction_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.source, self._engine.text, self._engine.files)

    def __repr__(self) -> str:
        return f"<raceway.Correction of {', '.join(self.displacements)} from {self.source}>"


def _restored(source: str, text: str, files: Sequence[tuple[str, str, str]]) -> Correction:
    """A correction in another process, which does not say again what makes it doubtful."""
    correction = Correction.__new__(Correction)
    correction._engine = _engine.Correction(source, text, files)
    return correction


def read(path: str | os.PathLike[str]) -> Model | Correction:
    """Read a model file of either kind, as a `Correction` if it has [correction] and no [bearing].

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     Model.new("S 6014 C").save(f"{folder}/my.toml")
    ...     read(f"{folder}/my.toml").kind
    'rig'
    """
    text = _engine.read_text(os.fspath(path))
    return (Correction if _only_corrects(text) else Model)(os.fspath(path), text)

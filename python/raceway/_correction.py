"""Corrections of machines. A correction calculates slow displacements of a machine from signals of the machine control."""

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
    """Model that calculates the displacement of a machine from temperatures, power, speed and feeds.

    The inputs act through thermal lags (first-order delays). One file can contain several displacements, each with its
    own model. A correction object never changes. A fit returns a new correction. Create a correction with `read`,
    `from_text` or `new`.

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
    _said: Sequence[Note] = ()  # notes from the creation of the correction

    def __init__(self, source: str, text: str, files: Sequence[tuple[str, str, str]] = ()) -> None:
        tables = _tables(text_of("text", text))
        if tables and "correction" not in tables:
            raise InputError(f"{source}: has no [correction]; use raceway.Model.read to read the model of a bearing")
        self._engine = _engine.Correction(source, text, files)
        warn(self._engine.warnings)

    @classmethod
    def new(cls, record: Record) -> Correction:
        """Create a correction for the displacements in a record over time. This correction is the starting point for `identify`.

        The correction has a channel for each temperature, and its `text` marks each assumption. If the name of a
        column is not a name of raceway, the table ``[columns]`` of the correction proposes a name. If `record` has a
        map of columns, the correction uses this map.

        Warns
        -----
        Doubt
            The values of a column suggest that its unit is wrong.

        Raises
        ------
        InputError
            The record has no column with a displacement.
        """
        data, options = asked(one_record(record))
        text, notes, doubts = _engine.new_correction(data[0], **options)
        warn(doubts)
        correction = cls(cls._called, text)
        correction._said = notes
        return correction

    @property
    def notes(self) -> list[Note]:
        """Notes on the correction, and on the record from which `new` created the correction."""
        return [*self._said, *self._engine.notes]

    @property
    def displacements(self) -> list[str]:
        """Names of the columns that the correction predicts: ``"displacement_z_um"``, or ``"displacement_b_urad"`` for an angle."""
        return self._engine.displacements

    @property
    def inputs(self) -> list[str]:
        """Names of the input columns that a record must contain."""
        return self._engine.inputs

    @property
    def trust(self) -> dict[str, str]:
        """Reliability of the prediction of each displacement, tested on readings that the fit did not use.

        The value is ``"good"``, ``"only inside its range: ..."``, ``"do not use, because ..."``, or ``"not known: ..."``
        if the file does not contain the result of this test.
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
        """Find the number of lags of each channel, and the gains and time constants of the lags, from a record over time.

        Parameters
        ----------
        record : Record
            Record with ``time_s``, the inputs and the displacement. Cells of the displacement can be empty.
        inputs : str or iterable of str, optional
            Columns that can become channels, or ``"all"``. The program uses a column only if the column reduces the
            held-out error by more than 5 %.
        order : int or (int, int)
            Number of lags of each channel, from 1 to 6. A pair gives the smallest and the largest number.
        lags_s : "auto" or iterable of float, optional
            Time constants of a bank of lags [s], for machines with many sensors. Every input passes through all of
            these lags, and ridge regression finds the gains. A lag of 0 has no delay. ``"auto"`` chooses the lags from
            the length of the record.
        baseline : {"regression", "arx"}, optional
            Simpler method to compare with the lags. ``"regression"`` fits the displacement to the inputs without a
            delay. ``"arx"`` fits transfer functions with the smallest prediction error one step ahead. The result
            contains this error, and the error of a simulation that starts from the first readings of each run.
        validate : Record, optional
            Another record, on which the program tests the result.
        from_s, until_s : float, optional
            Time range of the readings that are evaluated: start and end, measured from the first row [s]. The inputs
            of all rows are used.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.
        progress : callable, optional
            Function that receives the completed share (0 to 1) and the name of the current step. The function is called at most 20 times per second.

        Raises
        ------
        InputError
            An input is missing, the order or the lags are invalid, or the record does not determine the parameters.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.
        """
        if baseline not in (None, "regression", "arx"):
            raise ValueError(f"baseline = {baseline!r}: must be regression or arx")
        if lags_s is not None and (baseline is not None or order != (1, 3)):
            raise ValueError("lags_s: not possible together with baseline or order; give only one of the three")
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
        """Apply the correction to a record and return the predictions with their band, and the residuals.

        Parameters
        ----------
        record : Record
            Record with ``time_s`` and the inputs. Readings of the displacement are optional.
        learn : bool
            True updates the zero, the states of the lags and the gains with each reading, in the order of time. The prediction of a row uses only
            earlier readings.
        every_s : float, optional
            Shortest time between two readings that `learn` uses [s]. The other readings test the result.
        forget_s : float, optional
            Time constant of the return from learned gains to the gains of the model [s]. Default: 7 days.
        from_s, until_s : float, optional
            Time range of the readings that are evaluated: start and end, measured from the first row [s].
        """
        data, options = asked(one_record(record), from_s=from_s, until_s=until_s)
        if not learn:
            for argument, value in (("every_s", every_s), ("forget_s", forget_s)):
                if value is not None:
                    raise ValueError(f"{argument}: only possible with learn=True")
            answer = _engine.correct(self._engine, data[0], **options)
        else:
            durations = (seconds("every_s", every_s), seconds("forget_s", forget_s))
            answer = _engine.learn(self._engine, data[0], *durations, **options)
        warn(answer.warnings)
        return CorrectionRun(answer, self._fitted(answer, ", learnt").get(""))

    def join(self, *others: Correction) -> Correction:
        """Return the sum of this correction and `others`. All corrections must describe the same displacement.

        The sum contains the channels, laws and effects of all corrections without changes. The offsets are added.
        Free parameters stay free. Fitted parameters get a prior from their fit. Delay elements and laws of step
        responses get a prior with an assumed width, so they become free.

        Raises
        ------
        InputError
            The displacements differ, two channels have the same name, two corrections contain a law of immediate displacement, or the ranges do not
            overlap.
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
        """Return the correction as a program or a table for a control, independent of this package.

        If `path` is given, the method also writes the result to a file.

        Parameters
        ----------
        format : {"python", "c", "csv", "linuxcnc"}
            ``"python"`` is one file that needs only the standard library. ``"c"`` is one C99 header. ``"csv"`` is a table
            of numbers with units. ``"linuxcnc"`` is a HAL component in Python with its HAL files.
        path : path, optional
            File to write. The file name is also the prefix of the C functions, or the name of the HAL component.
        record : Record, optional
            The first run of this record is stored in the file as a check. Without `record`, the file contains a
            synthetic check record.
        accept_untrusted : bool
            True exports a correction even if its `trust` is "do not use, because ...", or if it has no channel and no
            effect.
        overwrite : bool
            True replaces an existing file.

        Raises
        ------
        InputError
            The correction needs `accept_untrusted`, but `accept_untrusted` is False.
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
    """Restore a correction in another process without repeating its warnings."""
    correction = Correction.__new__(Correction)
    correction._engine = _engine.Correction(source, text, files)
    return correction


def read(path: str | os.PathLike[str]) -> Model | Correction:
    """Read a model file. The result is a `Correction` if the file has a table [correction] and no [bearing], otherwise a `Model`.

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

"""Results of calculations for a spindle: steady states, runs, modes, deflections and step responses."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

from . import _engine
from ._note import Note
from ._record import Record
from ._results import _Answered, _frame, _write, write_files

if TYPE_CHECKING:
    import pandas


class _OfSpindle(_Answered):
    """Base class of the results for a spindle."""

    _answer: _engine.SpindleAnswer

    def _text(self) -> str:
        return self._answer.json()

    @property
    def converged(self) -> bool:
        """True if the calculation converged for every row of the result."""
        return self._answer.converged

    def to_frame(self) -> pandas.DataFrame:
        """Return the rows of the CSV file that the command writes with ``-o``. The column names include the units."""
        return _rows(self._answer.csv())

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the CSV of `to_frame` with the model in its header. True for `overwrite` replaces an existing file."""
        _write(path, self._answer.csv(), overwrite)


class _WithField(_OfSpindle):
    """Result that contains the temperature of every cell in the last state."""

    @property
    def end_state(self) -> str:
        """All temperatures of the last state as JSON. `Model.simulate` accepts this text as `start`.

        Raises
        ------
        ValueError
            The result has several speeds, or its single speed has no steady state.
        """
        return self._answer.end_state()

    def field(self) -> pandas.DataFrame:
        """Return the cells in the last state, with the columns ``position_mm, radius_mm, part, temperature_C``.

        Raises
        ------
        ValueError
            The result has several speeds, or its single speed has no steady state.
        """
        return _rows(self._answer.field())


class SteadyStates(_WithField):
    """Steady states of a spindle at one or several speeds. The values are NaN at a speed without a steady state."""

    @property
    def status(self) -> list[str]:
        """Status of the calculation at each speed: ``"converged"``, ``"thermal_runaway"``, ..."""
        return [row["report"]["status"] for row in self.data["steady"]]

    def __repr__(self) -> str:
        return f"<raceway.SteadyStates of {self.data['spindle']}: {_ended(self.status, 'speed')}>"


class SpindleRun(_WithField):
    """Simulation of a spindle through a speed programme, row by row.

    If the simulation stops early, the result contains the rows before the stop. `raceway.plot.spindle_run` draws
    the result.
    """

    @property
    def status(self) -> str:
        """``"converged"``, or the reason for an early stop.

        The reason is ``"thermal_runaway"``, ``"no_equilibrium"`` or ``"step_limit"``.
        """
        return self.data["report"]["status"]

    def __repr__(self) -> str:
        rows = f"{self.data['rows_reached']} of {self.data['rows_asked']} rows"
        return f"<raceway.SpindleRun of {self.data['spindle']}: {rows}, {self.status}>"


class Modes(_OfSpindle):
    """Natural frequencies of a shaft on its bearings as a function of speed. `raceway.plot.campbell` draws them."""

    @property
    def status(self) -> list[str]:
        """Status of the calculation at each speed: ``"converged"``, or the reason for a missing result."""
        return [row["report"]["status"] for row in self.data["rows"]]

    def shapes(self) -> pandas.DataFrame:
        """Return the mode shapes: ``speed_rpm, mode, frequency_Hz, whirl, position_mm, y_amplitude, z_amplitude``.

        Each mode shape is scaled to a largest amplitude of 1.
        """
        return _rows(self._answer.shapes())

    def __repr__(self) -> str:
        return f"<raceway.Modes of {self.data['model']}: {_ended(self.status, 'speed')}>"


class Deflection(_OfSpindle):
    """Deflection of a shaft under a force. For a radial force, `to_frame()` returns the bending line."""

    @property
    def status(self) -> str:
        """``"converged"``, or the reason why the calculation found no equilibrium."""
        return self.data["report"]["status"]

    @property
    def displacement_um(self) -> float | None:
        """Displacement of the point at which the force acts, in the direction of the force. None without an equilibrium."""
        return self.data["displacement_um"]

    @property
    def stiffness_N_um(self) -> float | None:
        """Force divided by `displacement_um`. None if several loads act together."""
        return self.data["stiffness_N_um"]

    def __repr__(self) -> str:
        size = self.displacement_um
        found = self.status if size is None else f"{size:.4g} um at the force"
        return f"<raceway.Deflection under {self.data['force_N']:g} N: {found}>"


class StepResponses(_OfSpindle):
    """Step responses of a spindle from rest: gain K and time constant T as functions of the friction power P."""

    _answer: _engine.StepAnswer

    @property
    def status(self) -> list[str]:
        """Status of each step. The load steps are at the end of the list."""
        return [row["status"] for row in self.data["rows"] + self.data.get("load_rows", [])]

    def save_correction(self, path: str | os.PathLike[str], *, law: str = "curve", lags: str = "auto", overwrite: bool = False) -> list[Note]:
        """Write the correction that follows from these step responses: the model file, and table files in the same folder.

        Parameters
        ----------
        path : path
            File of the correction (TOML). The names of the table files begin with the name of this file.
        law : {"curve", "power", "line"}
            Law that describes K and T as functions of P: a table through all steps (``"curve"``), a power of P
            (``"power"``), or a straight line (``"line"``).
        lags : {"auto", "one", "two"}
            Number of delay elements. ``"auto"`` uses one element if it fits all steps. Otherwise, ``"auto"`` uses two
            elements, unless one element has a smaller error in a simulation of changing speeds.
        overwrite : bool
            True replaces existing files.

        Returns
        -------
        list of Note
            Notes on the chosen law and delay elements.

        Raises
        ------
        InputError
            The step responses do not allow this correction. The message gives the reason.
        FileExistsError
            A file exists and `overwrite` is False. The method writes no file.
        """
        _one_of("law", law, ("curve", "power", "line"))
        _one_of("lags", lags, ("auto", "one", "two"))
        target = os.fspath(path)
        text, tables, notes = self._answer.correction(target, law, lags)
        folder = os.path.dirname(target)
        files = [(os.path.join(folder, name), table) for name, table in tables] + [(target, text)]
        write_files(files, overwrite)
        return notes

    def superposition(self, correction: str | os.PathLike[str], programme: Record) -> dict[str, Any]:
        """Compare the predictions of a correction with the complete simulation of a speed programme.

        Parameters
        ----------
        correction : path
            File that `save_correction` has written.
        programme : Record
            Record with the columns ``time_s`` and ``speed_rpm``. The columns ``axial_load_N`` and ``radial_load_N``
            are optional.

        Returns
        -------
        dict
            ``rms_um`` is the RMS error of the correction. ``largest_um`` is the largest error, at the time
            ``time_of_largest_s``. ``lowest_um`` and ``highest_um`` give the range of the simulated displacement.

        Raises
        ------
        InputError
            The file is not a correction, the record is not a speed programme, or the step responses come from another
            program.
        """
        if not isinstance(programme, Record):
            wrong = type(programme).__name__
            raise TypeError(f"programme: must be a raceway.Record, not {wrong}")
        text = self._answer.superposition(os.fspath(correction), programme._data)
        return json.loads(text)["superposition"]

    def __repr__(self) -> str:
        return f"<raceway.StepResponses: {_ended(self.status, 'step')}>"


def _rows(csv: str) -> pandas.DataFrame:
    return _frame(csv, comment="#")


def _ended(status: list[str], what: str) -> str:
    """Return the number of speeds or steps as text: "3 speeds", or "3 speeds, 1 of them without result"."""
    failed = sum(s != "converged" for s in status)
    words = f"{len(status)} {what}" + ("" if len(status) == 1 else "s")
    return words if failed == 0 else f"{words}, {failed} without result"


def _one_of(name: str, value: object, allowed: tuple[str, ...]) -> None:
    if value not in allowed:
        raise ValueError(f"{name} = {value!r}: must be {', '.join(allowed[:-1])} or {allowed[-1]}")


def start_of(start: Any) -> tuple[str, str] | None:
    """Return the name and the text of the initial state of a simulation. None if no initial state is given."""
    if start is None:
        return None
    if isinstance(start, _WithField):
        return "start", start.end_state
    if isinstance(start, str) and start.lstrip().startswith("{"):
        return "start", start
    if isinstance(start, (str, os.PathLike)):
        path = os.fspath(start)
        return path, _engine.read_text(path)
    wrong = type(start).__name__
    raise TypeError(f"start: must be the end_state of a result or the path of its file, not {wrong}")

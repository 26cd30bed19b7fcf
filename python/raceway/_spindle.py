"""Results of questions to a spindle: steady states, runs, modes, deflections and step responses."""

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
    """Result of the engine for a spindle."""

    _answer: _engine.SpindleAnswer

    def _text(self) -> str:
        return self._answer.json()

    @property
    def converged(self) -> bool:
        """True if all results were found."""
        return self._answer.converged

    def to_frame(self) -> pandas.DataFrame:
        """Return the rows of the CSV that the command writes with ``-o``; columns have their units."""
        return _rows(self._answer.csv())

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write this CSV with the model in its head. `overwrite` replaces an existing file."""
        _write(path, self._answer.csv(), overwrite)


class _WithField(_OfSpindle):
    """Result with the temperature of every cell at the end."""

    @property
    def end_state(self) -> str:
        """All temperatures at the end as JSON. `Model.simulate` accepts it as `start`.

        Raises
        ------
        ValueError
            The result has steady states at several speeds, or none.
        """
        return self._answer.end_state()

    def field(self) -> pandas.DataFrame:
        """Return the cells at the end: ``position_mm, radius_mm, part, temperature_C``.

        Raises
        ------
        ValueError
            Same as for `end_state`.
        """
        return _rows(self._answer.field())


class SteadyStates(_WithField):
    """Steady states of a spindle at one or several speeds. A speed without a steady state has NaN."""

    @property
    def status(self) -> list[str]:
        """Status of the search at each speed: ``"converged"``, ``"thermal_runaway"``, ..."""
        return [row["report"]["status"] for row in self.data["steady"]]

    def __repr__(self) -> str:
        return f"<raceway.SteadyStates of {self.data['spindle']}: {_ended(self.status, 'speed')}>"


class SpindleRun(_WithField):
    """Run of a spindle through a speed programme, row by row. A run that ends early has the rows before its end.

    `raceway.plot.spindle_run` draws it.
    """

    @property
    def status(self) -> str:
        """``"converged"``, or the reason for an early end.

        ``"thermal_runaway"``, ``"no_equilibrium"`` or ``"step_limit"``.
        """
        return self.data["report"]["status"]

    def __repr__(self) -> str:
        rows = f"{self.data['rows_reached']} of {self.data['rows_asked']} rows"
        return f"<raceway.SpindleRun of {self.data['spindle']}: {rows}, {self.status}>"


class Modes(_OfSpindle):
    """Natural frequencies of a shaft on its bearings over its speed; `raceway.plot.campbell` draws them."""

    @property
    def status(self) -> list[str]:
        """Status of the search at each speed."""
        return [row["report"]["status"] for row in self.data["rows"]]

    def shapes(self) -> pandas.DataFrame:
        """Return the shapes: ``speed_rpm, mode, frequency_Hz, whirl, position_mm, y_amplitude, z_amplitude``.

        The largest amplitude of a mode is 1.
        """
        return _rows(self._answer.shapes())

    def __repr__(self) -> str:
        return f"<raceway.Modes of {self.data['model']}: {_ended(self.status, 'speed')}>"


class Deflection(_OfSpindle):
    """Shaft under a force. For a radial force, `to_frame()` is the bending line."""

    @property
    def status(self) -> str:
        """``"converged"``, or the reason why there is no equilibrium."""
        return self.data["report"]["status"]

    @property
    def displacement_um(self) -> float | None:
        """Displacement at the place and in the direction of the force."""
        return self.data["displacement_um"]

    @property
    def stiffness_N_um(self) -> float | None:
        """Force divided by this displacement; None for several loads together."""
        return self.data["stiffness_N_um"]

    def __repr__(self) -> str:
        size = self.displacement_um
        found = self.status if size is None else f"{size:.4g} um where it acts"
        return f"<raceway.Deflection under {self.data['force_N']:g} N: {found}>"


class StepResponses(_OfSpindle):
    """Step responses of a spindle from rest: gain K and time constant T over the power P."""

    _answer: _engine.StepAnswer

    @property
    def status(self) -> list[str]:
        """Status of each step; load steps come last."""
        return [row["status"] for row in self.data["rows"] + self.data.get("load_rows", [])]

    def save_correction(self, path: str | os.PathLike[str], *, law: str = "curve", lags: str = "auto", overwrite: bool = False) -> list[Note]:
        """Write the correction of these steps with its tables into one folder.

        Parameters
        ----------
        path : path
            File of the correction (TOML). The names of its tables begin with this name.
        law : {"curve", "power", "line"}
            Law of K and T over P: a table through all steps, a power of P, or a chord.
        lags : {"auto", "one", "two"}
            Number of delay elements. ``"auto"`` tries both on a day of changing speeds.
        overwrite : bool

        Returns
        -------
        list of Note
            Notes on the chosen law and delay elements.

        Raises
        ------
        InputError
            The steps give no such correction.
        FileExistsError
            A file exists and `overwrite` is false. No file is written.
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
        """Compare a correction with the complete simulation over a speed programme.

        Parameters
        ----------
        correction : path
            File that `save_correction` wrote.
        programme : Record
            Columns ``time_s`` and ``speed_rpm``, and ``axial_load_N`` and ``radial_load_N`` for loads.

        Returns
        -------
        dict
            ``rms_um``, ``largest_um`` at ``time_of_largest_s``, and the range of the simulation from
            ``lowest_um`` to ``highest_um``.

        Raises
        ------
        InputError
            A file is no correction or no programme, or the step responses were not simulated.
        """
        if not isinstance(programme, Record):
            wrong = type(programme).__name__
            raise TypeError(f"programme: a raceway.Record is wanted, not {wrong}")
        text = self._answer.superposition(os.fspath(correction), programme._data)
        return json.loads(text)["superposition"]

    def __repr__(self) -> str:
        return f"<raceway.StepResponses: {_ended(self.status, 'step')}>"


def _rows(csv: str) -> pandas.DataFrame:
    return _frame(csv, comment="#")


def _ended(status: list[str], what: str) -> str:
    """Return "3 speeds", or "3 speeds, 1 of them without result"."""
    failed = sum(s != "converged" for s in status)
    words = f"{len(status)} {what}" + ("" if len(status) == 1 else "s")
    return words if failed == 0 else f"{words}, {failed} of them without result"


def _one_of(name: str, value: object, allowed: tuple[str, ...]) -> None:
    if value not in allowed:
        raise ValueError(f"{name} = {value!r}: must be {', '.join(allowed[:-1])} or {allowed[-1]}")


def start_of(start: Any) -> tuple[str, str] | None:
    """Return name and text of the initial state of a simulation."""
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
    raise TypeError(f"start: the end_state of a result or the path of one is wanted, not {wrong}")

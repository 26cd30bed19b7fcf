"""What a spindle answers: steady states, runs, modes, deflections, step responses."""

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
        """True if the whole answer was found."""
        return self._answer.converged

    def to_frame(self) -> pandas.DataFrame:
        """Return the rows of the CSV that the command writes with ``-o``; columns have their units."""
        return _rows(self._answer.csv())

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write that CSV, with the model in its head; an existing file only with `overwrite`."""
        _write(path, self._answer.csv(), overwrite)


class _WithField(_OfSpindle):
    """With the temperature of every cell at its end."""

    @property
    def end_state(self) -> str:
        """All temperatures at the end as JSON, which `Model.simulate` takes as `start`.

        Raises
        ------
        ValueError
            Of steady states: for several speeds, and where there is none.
        """
        return self._answer.end_state()

    def field(self) -> pandas.DataFrame:
        """Return the cells at the end: ``position_mm, radius_mm, part, temperature_C``.

        Raises
        ------
        ValueError
            As `end_state`.
        """
        return _rows(self._answer.field())


class SteadyStates(_WithField):
    """Steady state of a spindle, for one speed or several. For a speed without steady state the numbers are NaN."""

    @property
    def status(self) -> list[str]:
        """Status of the search at each speed: ``"converged"``, ``"thermal_runaway"``, ..."""
        return [row["report"]["status"] for row in self.data["steady"]]

    def __repr__(self) -> str:
        return f"<raceway.SteadyStates of {self.data['spindle']}: {_ended(self.status, 'speed')}>"


class SpindleRun(_WithField):
    """A spindle through a speed programme, row by row; where it ended early those before.

    `raceway.plot.spindle_run` draws it.
    """

    @property
    def status(self) -> str:
        """``"converged"``, or why it ended early.

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
    """A shaft under a force. `to_frame()` is its bending line, of a radial one."""

    @property
    def status(self) -> str:
        """``"converged"``, or why there is none."""
        return self.data["report"]["status"]

    @property
    def displacement_um(self) -> float | None:
        """Displacement at the force, in its direction."""
        return self.data["displacement_um"]

    @property
    def stiffness_N_um(self) -> float | None:
        """Force over displacement there; None of several loads together."""
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
        """Status of each step, those of loads last."""
        return [row["status"] for row in self.data["rows"] + self.data.get("load_rows", [])]

    def save_correction(self, path: str | os.PathLike[str], *, law: str = "curve", lags: str = "auto", overwrite: bool = False) -> list[Note]:
        """Write the correction of these steps, with its tables in the same folder.

        Parameters
        ----------
        path : path
            Of the model of the correction (TOML). Its tables have that name before theirs.
        law : {"curve", "power", "line"}
            How K and T depend on P: by a table through all steps, a power of P, or a chord.
        lags : {"auto", "one", "two"}
            Delay elements; ``"auto"`` tries both over a day of changing speeds.
        overwrite : bool

        Returns
        -------
        list of Note
            What was chosen.

        Raises
        ------
        InputError
            Steps that make no such correction.
        FileExistsError
            One of the files is there, and `overwrite` was not given; none is written then.
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
        """Hold a correction against the whole simulation, over a programme of speeds.

        Parameters
        ----------
        correction : path
            As `save_correction` wrote it.
        programme : Record
            ``time_s`` and ``speed_rpm``, and ``axial_load_N`` and ``radial_load_N`` where there are loads.

        Returns
        -------
        dict
            ``rms_um``, ``largest_um`` at ``time_of_largest_s``, and the travel of the simulation,
            ``lowest_um`` to ``highest_um``.

        Raises
        ------
        InputError
            For no correction, no programme, or step responses that were not simulated.
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
    """ "3 speeds", or "3 speeds, 1 of them without result"."""
    failed = sum(s != "converged" for s in status)
    words = f"{len(status)} {what}" + ("" if len(status) == 1 else "s")
    return words if failed == 0 else f"{words}, {failed} of them without result"


def _one_of(name: str, value: object, allowed: tuple[str, ...]) -> None:
    if value not in allowed:
        raise ValueError(f"{name} = {value!r}: must be {', '.join(allowed[:-1])} or {allowed[-1]}")


def start_of(start: Any) -> tuple[str, str] | None:
    """Name and text of the state that a simulation begins with."""
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

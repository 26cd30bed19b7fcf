"""Results of corrections."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from . import _engine
from ._documents import in_unit_of
from ._note import Note
from ._results import _Answer, _frame, _write, write_files

if TYPE_CHECKING:
    import pandas

    from ._correction import Correction


class Identification(_Answer):
    """Correction whose structure and parameters were identified from a record."""

    def __init__(self, answer: _engine.Answer, found: Correction | None) -> None:
        super().__init__(answer)
        self._found = found

    @property
    def correction(self) -> Correction:
        """Identified correction.

        Raises
        ------
        ValueError
            No order of the ARX model is stable.
        """
        if self._found is None:
            raise ValueError(
                "no order of the ARX model is stable, so its simulation grows without limit; "
                "sections (identify without baseline) are always stable"
            )
        return self._found

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """Value, standard error (or None) and unit of each parameter, with the same names as in `Correction.parameters`."""
        axes = self.data.get("axes", [self.data])
        found = {}
        for axis in axes:
            before = f"{axis['displacement']}." if len(axes) > 1 else ""
            for name, number in _numbers(axis):
                found[before + name] = number
        return found

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per parameter: ``parameter``, ``value``, ``std`` and ``unit``."""
        import pandas

        rows = [{"parameter": name, **number} for name, number in self.parameters.items()]
        return pandas.DataFrame(rows, columns=["parameter", "value", "std", "unit"])

    def _repr_html_(self) -> str:
        from ._html_correction import identification_html

        return identification_html(self)

    def __repr__(self) -> str:
        return f"<raceway.Identification on {self.data['data']}>"


class CorrectionRun(_Answer):
    """Predictions and residuals of a correction for a record."""

    def __init__(self, answer: _engine.Answer, learnt: Correction | None) -> None:
        super().__init__(answer)
        self._learnt = learnt

    @property
    def correction(self) -> Correction:
        """Correction with the zero and the gains that were learned until the end of the record.

        Raises
        ------
        ValueError
            The run did not learn, because `learn` was False.
        """
        if self._learnt is None:
            raise ValueError("nothing was learnt, because learn is False; call correct(record, learn=True)")
        return self._learnt

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per row of the record, with the columns that ``raceway correct -o`` writes. See also `course`."""
        return _frame(self._answer.csv())

    def course(self) -> pandas.DataFrame:
        """Return the record as the program reads it, with the predictions and the residuals.

        The additional columns are ``predicted_...`` and, for each measured displacement, ``residual_...`` (reading minus
        prediction).
        """
        import pandas

        rows = self._answer.rows()
        return pandas.DataFrame({"time_s": rows.pop("time_s")} | rows)

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the rows of `to_frame` as a CSV file. True for `overwrite` replaces an existing file."""
        _write(path, self._answer.csv(), overwrite)

    def _repr_html_(self) -> str:
        from ._html_correction import run_html

        return run_html(self)

    def __repr__(self) -> str:
        return f"<raceway.CorrectionRun over {self.data['data']}: {self.data['rows']} rows>"


class Program:
    """Program that calculates a correction without this package.

    Attributes
    ----------
    format : str
        Format of the program: ``"python"``, ``"c"``, ``"csv"`` or ``"linuxcnc"``.
    text : str
        Text of the program.
    notes : list of Note
        Notes on the program, for the user of the control.
    hal, hal_shutdown : str
        HAL files of LinuxCNC that start and stop the component. The texts are empty for other formats.
    """

    def __init__(self, format: str, text: str, notes: list[Note], hal: str = "", hal_shutdown: str = "") -> None:
        self.format = format
        self.text = text
        self.notes = notes
        self.hal = hal
        self.hal_shutdown = hal_shutdown

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the program to a file. For LinuxCNC, also write the HAL files. True for `overwrite` replaces existing files."""
        stem = os.path.splitext(os.fspath(path))[0]
        files = [(os.fspath(path), self.text)]
        if self.hal:
            files += [(stem + ".hal", self.hal), (stem + "_shutdown.hal", self.hal_shutdown)]
        write_files(files, overwrite)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<raceway.Program in {self.format}: {self.text.count(chr(10))} lines>"


def _numbers(axis: dict[str, Any]) -> list[tuple[str, dict[str, Any]]]:
    """Return the parameters from the document of one displacement, with the same names as in the model."""
    offset = axis.get(in_unit_of(axis["displacement"], "offset_um"))
    found = [("offset", offset)] if offset else []
    for channel in axis.get("channels", []):
        name = channel["name"]
        for k, section in enumerate(channel["sections"], 1):
            found.append((f"{name}.gain_{k}", section["gain"]))
            found.append((f"{name}.time_constant_{k}", section["time_constant_s"]))
        through = channel["feedthrough"]
        if through["value"] or through["std"] is not None:
            found.append((f"{name}.feedthrough", through))
    found += [(f"kinematic.{key}", number) for key, number in axis.get("kinematic", {}).items()]
    return [(name, number) for name, number in found if number]

"""Results of the calculations with a model."""

from __future__ import annotations

import io
import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy

from . import _engine
from ._note import Note

if TYPE_CHECKING:
    import pandas

    from ._correction import Correction
    from ._model import Model

#: Status of a state by its number.
STATUS = ("not_run", "converged", "no_equilibrium", "iteration_limit", "singular", "not_finite")


class Solution(Mapping[str, numpy.ndarray]):
    """States of a bearing or a shaft as a mapping from names to arrays. The names end with the units. Each array is also an attribute.

    Attributes
    ----------
    notes : list of Note
        Notes on the result.
    """

    def __init__(
        self,
        names: Sequence[str],
        values: numpy.ndarray,
        status: numpy.ndarray,
        given: Mapping[str, numpy.ndarray],
        notes: list[Note],
        document: Callable[[], str] | None,
    ) -> None:
        self._places = {name: place for place, name in enumerate(names)}
        self._values = values
        self._status = status
        self._given = dict(given)
        self.notes = notes
        self._document = document
        self._data: dict[str, Any] | None = None

    @property
    def data(self) -> dict[str, Any] | None:
        """Document of ``raceway solve --json`` if the solution is a single state, otherwise None."""
        if self._data is None and self._document is not None:
            self._data = json.loads(self._document())
        return self._data

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_data": self.data, "_document": None}

    def __getitem__(self, name: str) -> numpy.ndarray:
        try:
            return self._values[self._places[name]]
        except KeyError:
            raise KeyError(f"{name}: no such result; the results are {', '.join(self._places)}") from None

    def __getattr__(self, name: str) -> numpy.ndarray:
        places = self.__dict__.get("_places", {})
        if name in places:
            return self._values[places[name]]
        raise AttributeError(f"{name}: no such result; the results are {', '.join(places)}")

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._places]

    @property
    def converged(self) -> numpy.ndarray:
        """True for each state that converged."""
        return self._status == STATUS.index("converged")

    @property
    def status(self) -> numpy.ndarray:
        """Status of each state as text: ``"converged"``, or the reason for a missing result, such as ``"no_equilibrium"``."""
        return numpy.array(STATUS)[self._status]

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per state, with inputs, results and status."""
        import pandas

        shape = self._status.shape
        columns = {n: numpy.broadcast_to(a, shape).ravel() for n, a in self._given.items()}
        columns |= {n: self._values[k].ravel() for n, k in self._places.items()}
        return pandas.DataFrame(columns | {"status": numpy.atleast_1d(self.status).ravel()})

    def _repr_html_(self) -> str:
        from ._html import html_of

        return html_of(self)

    def __str__(self) -> str:
        """Return the inputs and results as text. For more than 6 states, the text contains the first and the last states."""

        def shown(values: numpy.ndarray) -> str:
            if values.size == 1:
                return f"{values.item():.5g}"
            flat = values.ravel().tolist()
            ends = flat if len(flat) <= 6 else [*flat[:3], None, *flat[-2:]]
            return "  ".join("..." if v is None else f"{v:.5g}" for v in ends)

        given = {name: numpy.broadcast_to(values, self._status.shape) for name, values in self._given.items()}
        rows = given | {name: self._values[place] for name, place in self._places.items()}
        width = max(len(name) for name in rows)
        failed = self._status.size - int(self.converged.sum())
        head = f"{self._status.size} state{'' if self._status.size == 1 else 's'}, {failed or 'all'} {'not ' if failed else ''}converged"
        return "\n".join([head, *(f"{name:<{width}}  {shown(values)}" for name, values in rows.items())])

    def __repr__(self) -> str:
        states = f"{self._status.size} state{'' if self._status.size == 1 else 's'}"
        return f"<raceway.Solution of {states}: {', '.join(self._places)}>"


class _Document:
    """Base class of results with a document, which the command prints with ``--json``."""

    _data: dict[str, Any] | None = None

    def _text(self) -> str:
        raise NotImplementedError

    @property
    def data(self) -> dict[str, Any]:
        """Document that the command prints with ``--json``. The keys include the units (docs/files.md)."""
        if self._data is None:
            self._data = json.loads(self._text())
        return self._data

    def _repr_html_(self) -> str:
        from ._html import html_of

        return html_of(self)


class Table(_Document):
    """Stribeck table: friction torque for combinations of speed, load and temperature."""

    def __init__(self, engine: _engine.Table) -> None:
        self._engine = engine

    def _text(self) -> str:
        return self._engine.json()

    @property
    def notes(self) -> list[Note]:
        """Notes on balls without inner contact, loads above the rating, pressures that cause dents, and the influence of ceramic balls."""
        return self._engine.notes

    @property
    def warnings(self) -> list[str]:
        """Warnings about operating limits of the bearing that points of the table exceed. ``data["judgement"]`` contains the numbers."""
        return self._engine.warnings

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per operating point, with the columns of ``raceway table --format plain``. The last column is the status."""
        import pandas

        names, values, status = self._engine.columns()
        return pandas.DataFrame(dict(zip(names, values)) | {"status": status})

    def save(self, path: str | os.PathLike[str], *, format: str = "csv", overwrite: bool = False) -> None:
        """Write the table to a file. The format is ``"csv"`` (includes the model), ``"plain"`` or ``"modelica"``."""
        if format not in ("csv", "plain", "modelica"):
            raise ValueError(f"format = {format!r}: must be csv, plain or modelica")
        _write(path, self._engine.text(format), overwrite)

    def __repr__(self) -> str:
        return f"<raceway.Table of {self._engine.bearing}: {self._engine.points} points>"


class Displacement(_Document):
    """Displacement of a shaft at each speed."""

    def __init__(self, engine: _engine.Displacement) -> None:
        self._engine = engine

    def _text(self) -> str:
        return self._engine.json()

    def to_frame(self) -> pandas.DataFrame:
        """Return one row per speed, with the columns of the CSV file that the command writes."""
        return _frame(self._engine.csv(), comment="#")

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the displacement at each speed as a CSV file. True for `overwrite` replaces an existing file."""
        _write(path, self._engine.csv(), overwrite)

    def __repr__(self) -> str:
        return f"<raceway.Displacement of {self.data['bearing']}: {len(self.data['rows'])} speeds>"


class _Answered(_Document):
    """Base class of results with notes, warnings and an HTML report."""

    def __init__(self, answer: Any) -> None:
        self._answer = answer

    @property
    def notes(self) -> list[Note]:
        """Notes on the data and the result."""
        return self._answer.notes

    @property
    def warnings(self) -> list[Note]:
        """Reasons to doubt the result, and reasons for missing results."""
        return self._answer.warnings

    def report(self, path: str | os.PathLike[str] | None = None, *, overwrite: bool = False) -> Page:
        """Return the report with its figures as one HTML page. A notebook shows the page in a frame.

        Parameters
        ----------
        path : path, optional
            File to which the page is also written.
        overwrite : bool
            True replaces an existing file.
        """
        page = Page(self._answer.page())
        if path is not None:
            _write(path, page.html, overwrite)
        return page


class _Answer(_Answered):
    """Base class of results that compare a model with a record, or analyse a model."""

    _answer: _engine.Answer

    def _text(self) -> str:
        return self._answer.json


class Page:
    """HTML page that works without a network connection."""

    def __init__(self, html: str) -> None:
        self.html = html

    def _repr_html_(self) -> str:
        from html import escape

        # In a frame, styles and scripts of the page do not affect the notebook.
        return f'<iframe srcdoc="{escape(self.html, quote=True)}" sandbox="allow-scripts" ' 'style="width:100%;height:40em;border:0"></iframe>'

    def __repr__(self) -> str:
        return f"<raceway report, {len(self.html) // 1000} kB>"


class Comparison(_Answer):
    """Errors of one or several models on a record."""

    @property
    def rmse(self) -> float:
        """RMS error of the first model, in the unit `unit`."""
        return _first(self.data)["rmse"]

    @property
    def unit(self) -> str:
        """Unit of the errors, such as ``"Nmm"``."""
        return _first(self.data)["unit"]

    def to_frame(self, measured: str | None = None) -> pandas.DataFrame:
        """Return the rows of the record with ``measured``, ``predicted`` and ``error`` of the first model.

        Parameters
        ----------
        measured : str, optional
            Name of the measured column, such as ``"axial_displacement_um"``. Default: the first measured column.
        """
        import pandas

        frame = pandas.DataFrame(self._answer.rows())
        known = [name.removeprefix("predicted_") for name in frame if name.startswith("predicted_")]
        measured = known[0] if measured is None else measured
        if measured not in known:
            raise ValueError(f"measured = {measured!r}: must be {' or '.join(known)}")
        predicted = f"predicted_{measured}"
        frame = frame.rename(columns={measured: "measured", predicted: "predicted"})
        frame["error"] = frame["predicted"] - frame["measured"]
        return frame

    def __repr__(self) -> str:
        return f"<raceway.Comparison: RMS error {self.rmse:.4g} {self.unit}>"


class Check(_Answer):
    """Report about the levels and the noise of a record, and about the effects that can be tested with the record."""

    def _repr_html_(self) -> str:
        from ._html_correction import check_html

        return check_html(self)


class _Report(_Answer):
    """Base class of results that a fit produced."""

    def fit_report(self) -> str:
        """Return the results of the fit as text: parameters, standard errors, correlations, chi-square, AIC and BIC."""
        from .fit_report import fit_report

        return fit_report(self)


class _Fitted(_Report):
    """Base class of results with fitted models."""

    def __init__(self, answer: _engine.Answer, models: Mapping[str, Model | Correction]) -> None:
        super().__init__(answer)
        self.models = models

    @property
    def model(self) -> Model | Correction:
        """Model with the fitted values."""
        if len(self.models) > 1:
            raise ValueError(f"each record has its own model; models has the entries {', '.join(self.models)}")
        return next(iter(self.models.values()))


class Calibration(_Fitted):
    """Fitted parameters of a model.

    Attributes
    ----------
    models : dict of str to Model
        With `per_record`, the dict contains one model for each record, and the key is the name of the record.
        Otherwise, the dict contains one model with the key ``""``.
    """

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """Fitted parameters by name, each with value, standard error, start value and unit."""
        return self.data["parameters"]

    def conf_interval(self) -> pandas.DataFrame:
        """Return 95 % intervals by profile likelihood, one row per parameter.

        Returns
        -------
        pandas.DataFrame
            Columns ``value``, ``lower`` and ``upper``, in the unit in the column ``unit``. ``open_lower`` or
            ``open_upper`` is True if this end of the interval is a bound of the parameter. For a parameter that the
            fit kept constant, both limits are NaN.

        Raises
        ------
        ValueError
            The intervals were not requested with ``calibrate(record, profile=True)``.

        Notes
        -----
        At the ends of an interval, chi-square is 3.84 above its minimum. At each end, all other parameters are fitted
        again. If the noise is unknown or the misfit exceeds the noise significantly, the value 3.84 is multiplied by the reduced chi-square
        (docs/files.md).

        Examples
        --------
        >>> import raceway
        >>> rig = "tests/hidden_effect/rigs/dev-01/"
        >>> record = raceway.Record.read(rig + "train.csv")
        >>> fit = raceway.Model.read(rig + "model.toml").calibrate(record, profile=True)
        >>> fit.conf_interval().loc[["f0"], ["lower", "value", "upper"]].round(3)
            lower  value  upper
        f0  1.496  1.505  1.514
        """
        from .fit_report import conf_interval

        return conf_interval(self)

    def __repr__(self) -> str:
        return f"<raceway.Calibration: {_values(self.data)}>"


class Diagnosis(_Report):
    """Verdict on the missing effects, or the measurements that can identify them."""

    @property
    def verdict(self) -> str:
        """Verdict as one word, as in the document of the command, such as ``"several-effects"``."""
        return self.data["verdict"]

    @property
    def headline(self) -> str:
        """Verdict in one line."""
        return self.data["headline"]

    @property
    def effects(self) -> list[str]:
        """Ids of the effects in the verdict. The list is empty if the verdict names no effect."""
        return [e["id"] for e in self.data["effects"] if e["in_verdict"]]

    def __repr__(self) -> str:
        return f"<raceway.Diagnosis: {self.headline}>"


class Addition(_Fitted):
    """Model with added effects, and the errors before and after the addition.

    Attributes
    ----------
    models : dict of str to Model
        Models with the added effects. The keys are the same as in `Calibration`.
    """

    @property
    def refused(self) -> str:
        """Reason why the effects do not improve the model; empty if they improve the model."""
        return self._answer.refused

    def __repr__(self) -> str:
        refused = "refused, " if self.refused else ""
        return f"<raceway.Addition: {refused}{_values(self.data['calibration'])}>"


def _values(calibration: dict[str, Any]) -> str:
    return ", ".join(f"{name} = {p['value']:.4g}" for name, p in calibration.get("parameters", {}).items())


def _first(document: dict[str, Any]) -> dict[str, Any]:
    return document["models"][0] if "models" in document else document


def _frame(csv: str, **how: Any) -> pandas.DataFrame:
    """Return CSV text of the library as a DataFrame, without the apostrophe that prevents a spreadsheet from reading a text as a formula."""
    import pandas

    def plain(cell: Any) -> Any:
        return re.sub("^'('*[-=+@])", r"\1", cell) if isinstance(cell, str) else cell

    frame = pandas.read_csv(io.StringIO(csv), **how).rename(columns=plain)
    for column in frame.columns[frame.dtypes == object]:
        frame[column] = frame[column].map(plain)
    return frame


def _write(path: str | os.PathLike[str], text: str, overwrite: bool) -> None:
    write_files([(path, text)], overwrite)


def write_files(files: Iterable[tuple[str | os.PathLike[str], str]], overwrite: bool) -> None:
    """Write either all files or no file. A number is not a valid path, because Python would interpret the number as an open file."""
    named = [(os.fsdecode(path), text) for path, text in files]
    for name, _ in named:
        if not overwrite and os.path.lexists(name):
            raise FileExistsError(f"{name} exists already; overwrite=True replaces it")
    _engine.write_files(named, overwrite)

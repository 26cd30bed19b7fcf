"""Models of bearings, shafts and spindles."""

from __future__ import annotations

import functools
import operator
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy
from numpy.typing import ArrayLike

from . import _engine
from ._effect import Effect
from ._errors import InputError
from ._given import arrays as _arrays
from ._given import axis as _axis
from ._given import name_list, text_of, value_of
from ._given import warn as _warn
from ._loop import LoopModel, Records, asked
from ._note import Note
from ._record import Record
from ._results import Displacement, Solution, Table
from ._sensitivity import SensitivityQuestion
from ._spindle_questions import SpindleQuestions


class Model(LoopModel, SpindleQuestions, SensitivityQuestion):
    """Model of a bearing on a rig, of the bearing sets on a shaft, or of a spindle.

    A model object never changes. A fit returns a new model. Create a model with `read`, `from_text` or `new`.

    Examples
    --------
    >>> model = Model.new("S 6014 C")
    >>> model.name
    'GMN S 6014 C TA'
    """

    _said: Sequence[Note] = ()  # notes from the creation of the model

    def __init__(self, source: str, text: str, effects: Iterable[Effect] = (), files: Sequence[tuple[str, str, str]] = ()) -> None:
        text_of("text", text)
        if _only_corrects(text):
            raise InputError(f"{source}: is a correction of a machine; use raceway.Correction.read to read it")
        self._effects = tuple(effects)
        self._engine = _engine.Model(source, text, [e._for_engine() for e in self._effects], files)
        _warn(self._engine.warnings)

    @classmethod
    def new(
        cls,
        bearing: str,
        *,
        law: str | None = None,
        ball_material: str = "steel",
        bore_mm: float | None = None,
        outer_diameter_mm: float | None = None,
        contact_angle_deg: float | None = None,
        ball_count: int | None = None,
        spindle: bool = False,
        oil: str | None = None,
    ) -> Model:
        """Create a model of a bearing from its designation, with the default values of the friction law.

        Parameters
        ----------
        bearing : str
            Designation in the catalogue, such as ``"S 6014 C"``. A designation that gives only the size, such as
            ``"7014 C"``, is also possible. A bearing with another name needs dimensions (see below). Without a
            catalogue entry, the program estimates the inner geometry, and `notes` contains a note about the
            estimate. ``"N1012 KTN/SP"`` is a cylindrical roller bearing with estimated rollers.
        law : {"contact", "palmgren", "skf"}, optional
            Friction law. The default is ``"palmgren"`` for spindles and cylindrical roller bearings, and
            ``"contact"`` for all other models. ``"contact"`` is not available for cylindrical roller bearings.
        ball_material : {"steel", "silicon-nitride"}
            Material of the balls or rollers.
        bore_mm, outer_diameter_mm, contact_angle_deg, ball_count
            Dimensions of a bearing that is not in the catalogue.
        spindle : bool
            True creates a template of a spindle with three of these bearings. You can use the template without
            changes. The `text` of the model marks each assumption.
        oil : str, optional
            ISO VG grade of a mineral oil with viscosity index 100, such as ``"VG 32"``. The default is a thin
            spindle oil. Give the oil of your bearing here.

        Raises
        ------
        InputError
            The bearing is unknown and no dimensions are given (the message lists the most similar names), or the arguments do not suit the bearing.

        Examples
        --------
        >>> Model.new("mine", bore_mm=70, outer_diameter_mm=110, ball_count=20).notes[0][:44]
        'mine is not in the catalogue: 70 x 110 mm, 1'
        """
        text_of("bearing", bearing)
        if law not in (None, "contact", "palmgren", "skf"):
            raise ValueError(f"law = {law!r}: must be contact, palmgren or skf")
        if ball_material not in ("steel", "silicon-nitride"):
            raise ValueError(f"ball_material = {ball_material!r}: must be steel or silicon-nitride")
        if ball_count is not None and operator.index(ball_count) < 3:
            raise ValueError(f"ball_count = {ball_count}: must be 3 or more")
        bore, outer, angle = (float("nan") if size is None else float(size) for size in (bore_mm, outer_diameter_mm, contact_angle_deg))
        text, notes = _engine.new_model(bearing, law or "", ball_material, bore, outer, angle, ball_count or 0, bool(spindle), oil or "")
        model = cls(bearing, text)
        model._said = notes
        return model

    @property
    def name(self) -> str:
        """Name of the bearing."""
        return self._engine.name

    @property
    def kind(self) -> str:
        """Kind of the model: ``"rig"``, ``"shaft"`` or ``"spindle"``."""
        return self._engine.kind

    @property
    def notes(self) -> list[Note]:
        """Notes on the model and on its creation."""
        return [*self._said, *self._engine.notes]

    @property
    def columns(self) -> list[str]:
        """Names of the result arrays of `solve`. A name ends with the unit of the result, unless the result has no unit."""
        return self._engine.columns

    def with_values(self, values: Mapping[str, float]) -> Model:
        """Return a copy of the model with new values. The rest of the file text, including the comments, does not change.

        Parameters
        ----------
        values : mapping of str to float
            New values. A name is a name from `parameters`, or the table and the key in the file, such as
            ``"lubricant.viscosity_40C_mm2_s"``. The unit is given in `parameters` or in the key.

        Examples
        --------
        >>> model = Model.new("S 6014 C")
        >>> thicker = model.with_values({"rolling_factor": 1.1, "lubricant.viscosity_40C_mm2_s": 32})
        """
        if not isinstance(values, Mapping):
            raise TypeError(f'values: must be a dict such as {{"f0": 1.2}}, not {type(values).__name__}')
        in_file = {text_of("values", name): value_of(name, value) for name, value in values.items()}
        effects = []
        for effect in self._effects:
            own = {n: in_file.pop(f"{effect.id}.{n}", v.value) for n, v in effect.numbers.items()}
            effects.append(effect.with_values(list(own.values())))
        return Model(self.source, self._engine.with_values(in_file), effects, self._engine.files)

    def with_effect(self, effect: Effect) -> Model:
        """Return the model with an effect that you have written. `diagnose` tries the effect, and `add` calibrates it.

        A model file cannot contain such an effect, so it is not in `text`. `effects` contains the effect with its numbers.
        """
        if not isinstance(effect, Effect):
            raise TypeError(f"must be a raceway.Effect, not {type(effect).__name__}")
        return Model(self.source, self._engine.text, (*self._effects, effect), self._engine.files)

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Effects that you have added as Python functions."""
        return self._effects

    def solve(
        self,
        speed_rpm: ArrayLike,
        axial_load_N: ArrayLike | None = None,
        radial_load_N: ArrayLike | None = None,
        temperature_C: ArrayLike | None = None,
        moment_y_Nmm: ArrayLike | None = None,
        moment_z_Nmm: ArrayLike | None = None,
        *,
        columns: Sequence[str] = (),
        band: bool = False,
    ) -> Solution:
        """Calculate contact angles, loads, displacement, stiffness, friction and heat.

        Parameters
        ----------
        speed_rpm, axial_load_N, radial_load_N, temperature_C, moment_y_Nmm, moment_z_Nmm
            Numbers or arrays. The arguments are combined by the broadcasting rules of numpy. Arrays of float64 are
            not copied. The model supplies the values of omitted arguments. For a shaft, `axial_load_N` is the
            external load, positive towards the tool.
        columns : sequence of str
            Names of the results to return, from `Model.columns`. An empty sequence returns all results.
        band : bool
            True adds half the width of the 95 % band of friction torque, power loss and (on a shaft) displacement, in columns such as
            ``friction_torque_band_Nmm``. The band includes only the uncertainty of the fitted parameters. Therefore, the model must come from
            `calibrate` or `add`.

        Returns
        -------
        Solution
            Arrays with the common shape of the arguments. If all arguments are single numbers, `Solution.data` is
            the document of ``raceway solve --json`` with all balls. For a state without equilibrium, results that need the equilibrium are NaN, and
            `Solution.status` gives the reason.

        Raises
        ------
        InputError
            A number is out of its range (the message gives its position in the array), or the shapes do not match.

        Notes
        -----
        The solver uses the Newton-Raphson method for ring and balls, with Hertz contact, centrifugal
        force and gyroscopic moment (docs/solver.md). The states of an array are distributed over all cores.

        Examples
        --------
        >>> model = Model.new("S 6014 C")
        >>> states = model.solve(speed_rpm=[[0.0], [12000.0]], axial_load_N=[100, 300, 900])
        >>> states.friction_torque_Nmm.round(1)
        array([[  2.7,  11.7,  50.5],
               [337.9, 384.7, 472.2]])
        """
        given = _arrays(
            speed_rpm=speed_rpm,
            axial_load_N=axial_load_N,
            radial_load_N=radial_load_N,
            temperature_C=temperature_C,
            moment_y_Nmm=moment_y_Nmm,
            moment_z_Nmm=moment_z_Nmm,
        )
        wanted = name_list("columns", columns)
        names, values, status, notes, doubts = self._engine.solve(given, wanted, bool(band))
        document = None
        if not columns and all(array.ndim == 0 for array in given.values()):
            alone = {name: array.copy() for name, array in given.items()}  # copies that later changes do not affect
            document = functools.partial(self._engine.solve_document, alone, bool(band))
        _warn(doubts)
        return Solution(names, values, status, given, notes, document)

    def table(
        self,
        speed_rpm: ArrayLike,
        axial_load_N: ArrayLike | None = None,
        radial_load_N: ArrayLike | None = None,
        temperature_C: ArrayLike | None = None,
        *,
        band: bool = False,
    ) -> Table:
        """Calculate a Stribeck table: friction torque and its components for all combinations of the values.

        The values of each argument must be in rising order. True for `band` adds half the width of the 95 % band of
        friction torque and power loss, as in `solve`.

        Examples
        --------
        >>> table = Model.new("S 6014 C").table([0, 6000, 12000], [100, 300])
        >>> table.to_frame()[["speed_rpm", "axial_load_N", "friction_torque_Nmm"]].round(1).tail(2)
           speed_rpm  axial_load_N  friction_torque_Nmm
        4     6000.0         300.0                293.7
        5    12000.0         300.0                384.7
        """
        axes = [
            _axis(n, v)
            for n, v in (("speed_rpm", speed_rpm), ("axial_load_N", axial_load_N), ("radial_load_N", radial_load_N), ("temperature_C", temperature_C))
        ]
        table = _engine.Table(self._engine, bool(band), *axes)
        _warn(table.warnings)
        return Table(table)

    def displacement(
        self, speed_rpm: ArrayLike, axial_load_N: float | None = None, temperature_C: float | None = None, *, band: bool = False
    ) -> Displacement:
        """Calculate the displacement of a shaft at each speed, relative to its position at standstill [um].

        True for `band` adds half the width of the 95 % band of displacement, friction torque and power loss, as in
        `solve`.

        Raises
        ------
        InputError
            The model has no table [arrangement].
        """
        nan = float("nan")
        curve = _engine.Displacement(
            self._engine,
            _axis("speed_rpm", speed_rpm),
            nan if axial_load_N is None else float(axial_load_N),
            nan if temperature_C is None else float(temperature_C),
            bool(band),
        )
        _warn(curve.warnings)
        return Displacement(curve)

    def predict(self, record: Records, *, band: bool = False) -> Any:
        """Return the predictions for all rows of a record as a pandas.DataFrame.

        The frame contains the columns that the program recognized in the record, with the names and units of
        raceway. The columns ``predicted_...`` follow. A row without a prediction contains NaN. True for `band` adds half
        the width of the 95 % band, such as ``predicted_friction_torque_band_Nmm``. The band includes only the uncertainty
        of the fitted parameters.
        """
        import pandas

        data, options = asked(record)
        return pandas.DataFrame(_engine.predict(self._engine, data, bool(band), **options))

    def _fitted(self, answer: _engine.Answer, fitted: str) -> dict[str, Model]:
        source = self.source if self.source.endswith(fitted) else self.source + fitted
        models = {}
        for record, text, own in zip(answer.records or [""], answer.models, answer.own_effects):
            effects = [e.with_values(own[e.id]) for e in self.effects]
            models[record] = Model(source, text, effects, self._engine.files)
        return models

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.source, self._engine.text, self._effects, list(self._said), self._engine.files)

    def __repr__(self) -> str:
        return f"<raceway.Model {self.name} ({self.kind}) from {self.source}>"


def _tables(text: str) -> set[str]:
    """Return the names of the tables in a model file. For an invalid file, the set is empty, and the library reports the error later."""
    try:
        return set(tomllib.loads(text))
    except tomllib.TOMLDecodeError:
        return set()


def _restored(source: str, text: str, effects: Sequence[Effect], said: Sequence[Note], files: Sequence[tuple[str, str, str]]) -> Model:
    """Restore a model in another process without repeating its warnings."""
    model = Model.__new__(Model)
    model._effects = tuple(effects)
    model._engine = _engine.Model(source, text, [e._for_engine() for e in effects], files)
    model._said = said
    return model


def _only_corrects(text: str) -> bool:
    tables = _tables(text)
    return "correction" in tables and "bearing" not in tables

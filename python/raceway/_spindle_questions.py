"""What a Model is asked as a spindle."""

from __future__ import annotations

import math
import numbers
import os

from numpy.typing import ArrayLike

from . import _engine
from ._given import axis, warn
from ._record import Record
from ._spindle import Deflection, Modes, SpindleRun, SteadyStates, StepResponses, _one_of, start_of

_NAN = float("nan")


class SpindleQuestions:
    """Questions to a model with [shaft] and [housing] in addition to [arrangement] (docs/spindle.md)."""

    _engine: _engine.Model

    def steady(
        self,
        speed_rpm: ArrayLike,
        *,
        coolant: bool = True,
        ambient_temperature_C: float | None = None,
        axial_load_N: float | None = None,
        radial_load_N: float = 0.0,
        moment_Nm: float = 0.0,
        belt_force_N: float | None = None,
        motor_power_W: float | None = None,
        assumptions: bool = False,
        time_limit_s: float | None = None,
    ) -> SteadyStates:
        """Find the steady state: temperatures, preload, displacement, heat at each speed.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Growing.
        coolant : bool
            Whether it flows.
        ambient_temperature_C : float, optional
            Of the room; default: the model.
        axial_load_N : float, optional
            At the nose, positive towards the tool; default: the model.
        radial_load_N, moment_Nm : float
            At the nose; the moment is positive as the radial load further in front.
        belt_force_N : float, optional
            Pull of the belt; default: the model.
        motor_power_W : float, optional
            That the motor takes, for formulas of heat that use it.
        assumptions : bool
            Whether ``data["assumptions"]`` names the five assumed numbers that move the nose most, at the
            last speed. It takes some fifty further states.
        time_limit_s : float, optional
            After which it gives up with TimeoutError.

        Returns
        -------
        SteadyStates
            A speed that has none is a warning of the kind `Doubt`, and `SteadyStates.status` says why.

        Raises
        ------
        InputError
            For a model that is no spindle, a speed out of its range.
        KeyboardInterrupt
            Stops it; nothing is left half done.

        Examples
        --------
        >>> import raceway
        >>> spindle = raceway.Model.read("data/spindles/small.toml")
        >>> state = spindle.steady(6000)
        >>> state.to_frame()[["speed_rpm", "axial_displacement_um", "front_force_N"]].round(1)
           speed_rpm  axial_displacement_um  front_force_N
        0       6000                   67.8          294.5
        """
        answer = _engine.steady(
            self._engine,
            axis("speed_rpm", speed_rpm),
            _yes_or_no("coolant", coolant),
            _number("ambient_temperature_C", ambient_temperature_C),
            _number("axial_load_N", axial_load_N),
            _number("radial_load_N", radial_load_N),
            _number("moment_Nm", moment_Nm),
            _number("belt_force_N", belt_force_N),
            _number("motor_power_W", motor_power_W),
            _yes_or_no("assumptions", assumptions),
            _limit(time_limit_s),
        )
        warn(answer.warnings)
        return SteadyStates(answer)

    def simulate(
        self,
        profile: Record,
        *,
        start: str | os.PathLike[str] | SteadyStates | SpindleRun | None = None,
        coolant: bool = True,
        ambient_temperature_C: float | None = None,
        assumptions: bool = False,
        time_limit_s: float | None = None,
    ) -> SpindleRun:
        """Simulate a spindle through a speed programme.

        Temperatures, preload, displacement and heat over time.

        Parameters
        ----------
        profile : Record
            Columns ``time_s`` and ``speed_rpm``, and where they are known ``coolant_on``,
            ``ambient_temperature_C``, ``machine_temperature_C``, ``coolant_inlet_temperature_C``,
            ``axial_load_N``, ``radial_load_N``, ``moment_Nm``, ``belt_force_N``, ``motor_heat_W``,
            ``motor_power_W``. A row's inputs hold from the row before it to its time.
        start : SteadyStates, SpindleRun, str or path, optional
            What to begin with: the end of another result, its `end_state`, or the path of one.
            Default: all as warm as the room.
        coolant : bool
            False: off in every row.
        ambient_temperature_C : float, optional
            In every row; default its column, else the model.
        assumptions : bool
            Whether ``data["assumptions"]`` names the five assumed numbers that move the nose most where
            all is steady at the highest speed.
        time_limit_s : float, optional
            After which it gives up with TimeoutError.

        Returns
        -------
        SpindleRun
            One that ends early has the rows before, a warning of the kind `Doubt` and why in
            `SpindleRun.status`.

        Raises
        ------
        InputError
            For a model that is no spindle, a profile without time or speed or of several runs, a state
            of another spindle.
        KeyboardInterrupt
            Stops it; nothing is left half done.

        Examples
        --------
        >>> import pandas, raceway
        >>> spindle = raceway.Model.read("data/spindles/externally_driven.toml")
        >>> jump = pandas.DataFrame({"time_s": [0, 7200], "speed_rpm": [0, 8000]})
        >>> run = spindle.simulate(raceway.Record.from_pandas(jump))
        >>> {name: round(value) for name, value in run.data["highest_front_force"].items()}
        {'force_N': 1194, 'time_s': 269}
        """
        if not isinstance(profile, Record):
            raise TypeError(f"profile: a raceway.Record is wanted, not {type(profile).__name__}: " "Record.read(path) or Record.from_pandas(frame)")
        answer = _engine.simulate(
            self._engine,
            profile._data,
            profile._columns,
            profile._drop_nan,
            start_of(start),
            _yes_or_no("coolant", coolant),
            _number("ambient_temperature_C", ambient_temperature_C),
            _yes_or_no("assumptions", assumptions),
            _limit(time_limit_s),
        )
        warn(answer.warnings)
        return SpindleRun(answer)

    def modes(
        self,
        speed_rpm: ArrayLike,
        *,
        warm: bool = False,
        coolant: bool = True,
        count: int = 6,
        damping_ratio: float | None = None,
        unbalance_gmm: float | None = None,
        unbalance_at_mm: float = 0.0,
    ) -> Modes:
        """Find the lowest natural frequencies of the shaft on its bearings, with gyroscopic effect.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Growing.
        warm : bool
            With the stiffness that the bearings have in the steady, warm spindle; else all is at the
            temperature of mounting.
        coolant : bool
            Of the warm spindle.
        count : int
            How many, 1 to 40.
        damping_ratio : float, optional
            Of every mode, as you state it, up to 1.
        unbalance_gmm, unbalance_at_mm : float
            An unbalance that turns with the shaft, which needs a damping ratio: each speed then has
            ``nose_amplitude_um`` and ``nose_lag_deg``.

        Returns
        -------
        Modes
            `raceway.plot.campbell` draws them. ``data["crossings"]`` says where once and twice per turn and
            the cage and races of each bearing meet a mode.

        Raises
        ------
        InputError
            For a model whose [shaft] has no segments.

        Examples
        --------
        >>> import raceway
        >>> modes = raceway.Model.read("data/spindles/small.toml").modes([0, 10000], count=2)
        >>> modes.to_frame()[["speed_rpm", "frequency_Hz", "whirl"]].round(1)
           speed_rpm  frequency_Hz     whirl
        0          0        1203.6  standing
        1          0        1203.6  standing
        2      10000         852.9  backward
        3      10000         856.3   forward
        """
        answer = _engine.modes(
            self._engine,
            axis("speed_rpm", speed_rpm),
            _yes_or_no("warm", warm),
            _yes_or_no("coolant", coolant),
            _count("count", count),
            _number("damping_ratio", damping_ratio),
            _number("unbalance_gmm", unbalance_gmm),
            _number("unbalance_at_mm", unbalance_at_mm),
        )
        warn(answer.warnings)
        return Modes(answer)

    def deflection(
        self,
        force_N: float = 0.0,
        *,
        direction: str = "radial",
        at_mm: float = 0.0,
        axial_force_N: float = 0.0,
        moment_Nm: float = 0.0,
        speed_rpm: float = 0.0,
        warm: bool = False,
        coolant: bool = True,
    ) -> Deflection:
        """Bend the shaft on its bearings, whose balls find their balance under the load.

        Parameters
        ----------
        force_N : float
            An axial one is positive towards the tool.
        direction : {"radial", "axial"}
        at_mm : float
            Where it acts, behind the nose face.
        axial_force_N, moment_Nm : float
            Beside a radial force, at the same place: positive towards the tool; positive as the force
            further in front.
        speed_rpm : float
        warm : bool
            With the preload that the steady, warm spindle has at this speed.
        coolant : bool
            Of the warm spindle.

        Raises
        ------
        InputError
            Where nothing pushes, loads do not go together, or the [shaft] has no segments.

        Examples
        --------
        >>> import raceway
        >>> spindle = raceway.Model.read("data/spindles/externally_driven.toml")
        >>> bent = spindle.deflection(1000, speed_rpm=8000, warm=True)
        >>> round(bent.displacement_um, 2), round(bent.stiffness_N_um)
        (5.21, 192)
        """
        _one_of("direction", direction, ("radial", "axial"))
        answer = _engine.deflection(
            self._engine,
            _number("force_N", force_N),
            direction == "axial",
            _number("axial_force_N", axial_force_N),
            _number("moment_Nm", moment_Nm),
            _number("at_mm", at_mm),
            _number("speed_rpm", speed_rpm),
            _yes_or_no("warm", warm),
            _yes_or_no("coolant", coolant),
        )
        warn(answer.warnings)
        return Deflection(answer)

    def step_response(
        self,
        speed_rpm: ArrayLike | None = None,
        *,
        axial_load_N: ArrayLike | None = None,
        radial_load_N: ArrayLike | None = None,
        load_speed_rpm: ArrayLike | None = None,
        duration_h: float = 4.0,
        coolant: bool = True,
        load_cases: Record | None = None,
        temperature_C: float | None = None,
        time_limit_s: float | None = None,
    ) -> StepResponses:
        """Find gain K and time constant T of the thermal displacement over the friction power.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Of the steps, each from rest; growing.
        axial_load_N, radial_load_N : float or sequence of float, optional
            Steps of a load at the nose of the spindle that has settled at each speed; growing. The
            axial one is positive towards the tool.
        load_speed_rpm : float or sequence of float, optional
            Speeds at which loads step; default: all of `speed_rpm`.
        duration_h : float
            Of each step.
        coolant : bool
        load_cases : Record, optional
            In place of speeds to simulate: step responses of another program, with ``time_s``,
            ``axial_displacement_um``, ``power_W`` or ``speed_rpm``, and ``load_case`` where several
            have one size. The model may then be any shaft.
        temperature_C : float, optional
            Of the lubricant, for the power of load cases with a speed alone; default: the model.
        time_limit_s : float, optional
            After which it gives up with TimeoutError.

        Raises
        ------
        InputError
            For a model that is no spindle, load cases that cannot be read or fitted.
        KeyboardInterrupt
            Stops it; nothing is left half done.

        Examples
        --------
        >>> import raceway
        >>> spindle = raceway.Model.read("data/spindles/externally_driven.toml")
        >>> steps = spindle.step_response([2000, 6000], duration_h=3)
        >>> steps.to_frame()[["speed_rpm", "power_end_W", "K_um", "T_min"]].round(1)
           speed_rpm  power_end_W  K_um  T_min
        0       2000         59.2   7.6   10.4
        1       6000        308.3  29.8    7.6
        """
        if (speed_rpm is None) == (load_cases is None):
            raise TypeError("speed_rpm simulates and load_cases reads step responses: give one of them")
        if load_cases is None:
            if temperature_C is not None:
                raise TypeError("temperature_C: belongs to load_cases; of steps it is simulated")
            answer = _engine.step_response(
                self._engine,
                axis("speed_rpm", speed_rpm),
                axis("axial_load_N", axial_load_N),
                axis("radial_load_N", radial_load_N),
                axis("load_speed_rpm", load_speed_rpm),
                _number("duration_h", duration_h),
                _yes_or_no("coolant", coolant),
                _limit(time_limit_s),
            )
        else:
            if not (axial_load_N is None and radial_load_N is None and load_speed_rpm is None):
                raise TypeError("axial_load_N, radial_load_N, load_speed_rpm: are simulated, and load_cases reads step responses")
            if not isinstance(load_cases, Record):
                raise TypeError(f"load_cases: a raceway.Record is wanted, not {type(load_cases).__name__}")
            if load_cases._columns is not None:
                raise ValueError("load_cases: columns are taken by their names alone, without a map")
            cases = (load_cases.name, load_cases.text)
            answer = _engine.imported_steps(self._engine, cases, _number("temperature_C", temperature_C))
        warn(answer.warnings)
        return StepResponses(answer)


def _number(name: str, value: float | None) -> float:
    """NaN for None."""
    if value is None:
        return _NAN
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(f"{name}: a number is wanted, not {type(value).__name__}")
    if math.isnan(value):
        raise ValueError(f"{name} = nan: must be a number")
    return float(value)


def _count(name: str, value: int) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise TypeError(f"{name}: a whole number is wanted, not {type(value).__name__}")
    return int(value)


def _yes_or_no(name: str, value: bool) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{name}: True or False is wanted, not {value!r}")
    return value


def _limit(time_limit_s: float | None) -> float:
    return float("inf") if time_limit_s is None else _number("time_limit_s", time_limit_s)

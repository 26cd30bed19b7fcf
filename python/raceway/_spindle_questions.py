"""Calculations for a model of a spindle."""

from __future__ import annotations

import os

from numpy.typing import ArrayLike

from . import _engine
from ._given import axis, number_or_nan, time_limit, warn, whole_number, yes_or_no
from ._record import Record
from ._spindle import Deflection, Modes, SpindleRun, SteadyStates, StepResponses, _one_of, start_of


class SpindleQuestions:
    """Calculations for a model with the tables [shaft], [housing] and [arrangement] (docs/spindle.md)."""

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
        """Calculate the steady state at each speed: temperatures, preload, displacement and heat.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Speeds in rising order.
        coolant : bool
            True if the coolant flows.
        ambient_temperature_C : float, optional
            Room temperature. Default: value of the model.
        axial_load_N : float, optional
            Axial load at the nose, positive towards the tool. Default: value of the model.
        radial_load_N, moment_Nm : float
            Loads at the nose. The moment is positive if it turns the shaft like a positive radial load in front of the nose.
        belt_force_N : float, optional
            Belt force. Default: value of the model.
        motor_power_W : float, optional
            Power of the motor. Only heat formulas that contain ``motor_power_W`` use this value.
        assumptions : bool
            True adds ``data["assumptions"]``: up to five assumed numbers with the largest influence on the
            displacement of the nose at the last speed. The calculation needs six additional steady states for each
            assumed number.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.

        Returns
        -------
        SteadyStates
            Steady states. The method warns with `Doubt` about a speed without a steady state.
            `SteadyStates.status` gives the reason.

        Raises
        ------
        InputError
            The model is not a model of a spindle, or a speed is out of range.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.

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
            yes_or_no("coolant", coolant),
            number_or_nan("ambient_temperature_C", ambient_temperature_C),
            number_or_nan("axial_load_N", axial_load_N),
            number_or_nan("radial_load_N", radial_load_N),
            number_or_nan("moment_Nm", moment_Nm),
            number_or_nan("belt_force_N", belt_force_N),
            number_or_nan("motor_power_W", motor_power_W),
            yes_or_no("assumptions", assumptions),
            time_limit(time_limit_s),
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

        The result contains temperatures, preload, displacement and heat over time.

        Parameters
        ----------
        profile : Record
            Record with the columns ``time_s`` and ``speed_rpm``. Optional columns: ``coolant_on``,
            ``ambient_temperature_C``, ``machine_temperature_C``, ``coolant_inlet_temperature_C``,
            ``axial_load_N``, ``radial_load_N``, ``moment_Nm``, ``belt_force_N``, ``motor_heat_W``,
            ``motor_power_W``. The inputs of a row apply from the time of the previous row to the
            time of this row.
        start : SteadyStates, SpindleRun, str or path, optional
            Initial state: another result, the `end_state` of another result, or a file with this text. Default: all
            parts have room temperature.
        coolant : bool
            False switches the coolant off in all rows.
        ambient_temperature_C : float, optional
            Room temperature for all rows. Default: the column of `profile`. Without this column, the value of the
            model is used.
        assumptions : bool
            True adds ``data["assumptions"]``: up to five assumed numbers with the largest influence on the
            displacement of the nose in the steady state at the highest speed.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.

        Returns
        -------
        SpindleRun
            Result of the simulation. If the simulation stops early, the result contains the rows before the stop, and
            the method warns with `Doubt`. `SpindleRun.status` gives the reason.

        Raises
        ------
        InputError
            The model is not a model of a spindle, `profile` is invalid, or the initial state belongs to another
            spindle. `profile` needs time and speed, must not begin before 0 s, and must be a single run.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.

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
            raise TypeError(f"profile: must be a raceway.Record, not {type(profile).__name__}; use " "Record.read(path) or Record.from_pandas(frame)")
        answer = _engine.simulate(
            self._engine,
            profile._data,
            profile._columns,
            profile._drop_nan,
            start_of(start),
            yes_or_no("coolant", coolant),
            number_or_nan("ambient_temperature_C", ambient_temperature_C),
            yes_or_no("assumptions", assumptions),
            time_limit(time_limit_s),
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
        """Calculate the lowest natural frequencies of the shaft on its bearings, with gyroscopic effect.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Speeds in rising order.
        warm : bool
            True uses the bearing stiffness of the warm spindle in its steady state. False uses the bearing stiffness at
            the mounting temperature.
        coolant : bool
            True if the coolant flows. This argument has an effect only with `warm`.
        count : int
            Number of modes, 1 to 40.
        damping_ratio : float, optional
            Damping ratio of all modes, up to 1.
        unbalance_gmm, unbalance_at_mm : float
            Unbalance of the shaft, and its position as a distance behind the nose face. A damping ratio is required. The result then
            contains ``nose_amplitude_um`` and ``nose_lag_deg`` for each speed.

        Returns
        -------
        Modes
            Natural frequencies. `raceway.plot.campbell` draws them. ``data["crossings"]`` lists the speeds at which an
            excitation frequency equals a natural frequency. The excitation frequencies are the speed, twice the speed,
            and the cage and race frequencies of each bearing.

        Raises
        ------
        InputError
            The table [shaft] of the model has no segments.

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
            yes_or_no("warm", warm),
            yes_or_no("coolant", coolant),
            whole_number("count", count),
            number_or_nan("damping_ratio", damping_ratio),
            number_or_nan("unbalance_gmm", unbalance_gmm),
            number_or_nan("unbalance_at_mm", unbalance_at_mm),
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
        """Calculate the deflection of the shaft on its bearings. The balls are in equilibrium under the load.

        Parameters
        ----------
        force_N : float
            Force in the given direction. An axial force is positive towards the tool.
        direction : {"radial", "axial"}
            Direction of the force.
        at_mm : float
            Position of the force, as a distance behind the nose face.
        axial_force_N, moment_Nm : float
            Loads at the same position, in addition to a radial force. The axial force is positive towards the tool. The moment is positive if it
            turns the shaft like a positive radial force in front of this position.
        speed_rpm : float
            Speed of the shaft.
        warm : bool
            True uses the preload of the warm spindle in its steady state at this speed.
        coolant : bool
            True if the coolant flows. This argument has an effect only with `warm`.

        Raises
        ------
        InputError
            No load is given, the loads cannot be combined, or the table [shaft] has no segments.

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
            number_or_nan("force_N", force_N),
            direction == "axial",
            number_or_nan("axial_force_N", axial_force_N),
            number_or_nan("moment_Nm", moment_Nm),
            number_or_nan("at_mm", at_mm),
            number_or_nan("speed_rpm", speed_rpm),
            yes_or_no("warm", warm),
            yes_or_no("coolant", coolant),
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
        """Calculate gain K and time constant T of the thermal displacement as functions of the friction power.

        Parameters
        ----------
        speed_rpm : float or sequence of float
            Speeds of the steps from rest, in rising order.
        axial_load_N, radial_load_N : float or sequence of float, optional
            Sizes of load steps at the nose, in rising order. Before a load step, the spindle is in its steady state at
            the speed. An axial load is positive towards the tool.
        load_speed_rpm : float or sequence of float, optional
            Speeds of the load steps. Default: all values of `speed_rpm`.
        duration_h : float
            Duration of each step.
        coolant : bool
            True if the coolant flows.
        load_cases : Record, optional
            Step responses from another program. These step responses replace the simulation. The columns are
            ``time_s``, ``axial_displacement_um``, ``power_W`` or ``speed_rpm``, and ``load_case`` if several steps
            have the same size. With `load_cases`, the model can be any model of a shaft.
        temperature_C : float, optional
            Lubricant temperature. With this temperature, the program calculates the power of load cases that give
            only a speed. Default: value of the model.
        time_limit_s : float, optional
            Time limit [s]. After this time, the call stops and raises TimeoutError.

        Raises
        ------
        InputError
            The model is not a model of a spindle, or the program cannot read or fit the load cases.
        KeyboardInterrupt
            The user pressed Ctrl+C. The call stops and returns no result.

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
            raise TypeError("speed_rpm simulates step responses, but load_cases reads them; give exactly one of the two")
        if load_cases is None:
            if temperature_C is not None:
                raise TypeError("temperature_C: only possible with load_cases; simulated steps calculate their temperatures")
            answer = _engine.step_response(
                self._engine,
                axis("speed_rpm", speed_rpm),
                axis("axial_load_N", axial_load_N),
                axis("radial_load_N", radial_load_N),
                axis("load_speed_rpm", load_speed_rpm),
                number_or_nan("duration_h", duration_h),
                yes_or_no("coolant", coolant),
                time_limit(time_limit_s),
            )
        else:
            if not (axial_load_N is None and radial_load_N is None and load_speed_rpm is None):
                raise TypeError("axial_load_N, radial_load_N, load_speed_rpm: only possible for simulated steps, without load_cases")
            if not isinstance(load_cases, Record):
                raise TypeError(f"load_cases: must be a raceway.Record, not {type(load_cases).__name__}")
            if load_cases._columns is not None:
                raise ValueError("load_cases: a map of columns is not possible; the columns must have the names of raceway")
            cases = (load_cases.name, load_cases.text)
            answer = _engine.imported_steps(self._engine, cases, number_or_nan("temperature_C", temperature_C))
        warn(answer.warnings)
        return StepResponses(answer)

"""Calculate friction, kinematics and heat of spindle bearings, and find the missing effect of a model.

A model is a TOML file, which the command ``raceway`` also uses. Names of arguments and results include the unit.
Results equal the results of the command. Messages are also the same, except that they name Python arguments instead
of flags of the command.

>>> import raceway
>>> model = raceway.Model.new("S 6014 C")
>>> model.solve(speed_rpm=[0, 6000, 12000], axial_load_N=300).friction_torque_Nmm.round(1)
array([ 11.7, 293.7, 384.7])

Models, records and results never change. Several threads can use the same object at the same time. Long calculations
release the global interpreter lock.
"""

from typing import Any as _Any

from ._engine import __version__
from ._correction import Correction, read
from ._correction_results import CorrectionRun, Identification, Program
from ._effect import Effect, Number, State
from ._errors import Doubt, InputError, NotConverged
from ._law import KinematicLaw, fit_law
from ._model import Model
from ._note import Note
from ._record import Record
from ._results import Addition, Calibration, Check, Comparison, Diagnosis, Displacement, Solution, Table
from ._sensitivity import Sensitivity
from ._spindle import Deflection, Modes, SpindleRun, SteadyStates, StepResponses


def __getattr__(name: str) -> _Any:
    # Loading matplotlib takes most of the import time, and many scripts neither draw nor sweep.
    if name in ("plot", "sweep"):
        import importlib

        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*__all__, "plot", "sweep"])


__all__ = [
    "Addition",
    "Calibration",
    "Check",
    "Comparison",
    "Correction",
    "CorrectionRun",
    "Diagnosis",
    "Deflection",
    "Displacement",
    "Doubt",
    "Effect",
    "Identification",
    "InputError",
    "KinematicLaw",
    "Model",
    "Modes",
    "NotConverged",
    "Note",
    "Number",
    "Program",
    "Record",
    "Sensitivity",
    "Solution",
    "SpindleRun",
    "State",
    "SteadyStates",
    "StepResponses",
    "Table",
    "__version__",
    "fit_law",
    "read",
]

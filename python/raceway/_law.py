"""Law of kinematic displacement."""

from __future__ import annotations

from typing import Any

from . import _engine
from ._errors import NotConverged
from ._given import warn
from ._loop import asked
from ._record import Record
from ._results import _Answer


class KinematicLaw(_Answer):
    """Law of kinematic displacement, fitted to a curve: u = A n^(1 - B exp(-C n)), with u in um and n in rpm."""

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """Parameters A, B and C, each with value, standard error and unit."""
        return self.data["parameters"]

    @property
    def table(self) -> str:
        """Monotone table of the curve as CSV. Use this table if the law does not fit the curve."""
        return self._answer.csv()

    def _repr_html_(self) -> str:
        from ._html_correction import law_html

        return law_html(self)

    def __repr__(self) -> str:
        numbers = ", ".join(f"{name} = {p['value']:.4g}" for name, p in self.parameters.items())
        return f"<raceway.KinematicLaw: {numbers}>"


def fit_law(curve: Record, *, at_rpm: float | None = None) -> KinematicLaw:
    """Fit the law of kinematic displacement to a curve of ``speed_rpm`` and ``axial_displacement_um``.

    Parameters
    ----------
    curve : Record
        Record with these two columns, and ``std_um`` if the scatter is known. `Displacement.to_frame` returns a frame
        with these two columns.
    at_rpm : float, optional
        Speed at which the result also contains the displacement and the slope of the law.

    Raises
    ------
    InputError
        The curve has too few speeds, or the law is not valid at `at_rpm`.
    NotConverged
        The fit did not converge.

    Examples
    --------
    >>> import pandas
    >>> speeds = [1000.0, 2000.0, 4000.0, 6000.0, 8000.0, 10000.0]
    >>> moved = [0.0993, 0.4125, 2.0097, 4.8855, 8.4087, 11.8716]
    >>> curve = pandas.DataFrame({"speed_rpm": speeds, "axial_displacement_um": moved})
    >>> law = fit_law(Record.from_pandas(curve))
    >>> sorted(law.parameters)
    ['A', 'B', 'C']
    """
    nan = float("nan")
    data, options = asked(curve)
    answer = _engine.fit_law(data[0], nan if at_rpm is None else float(at_rpm), **options)
    if not answer.converged:
        raise NotConverged("; ".join(["the fit of the law did not converge", *answer.warnings]))
    warn(answer.warnings)
    return KinematicLaw(answer)

"""Sweeps over many items, such as a fleet of corrections or samples of a model, in this process or on many machines.

One function computes the value of each item. The value does not depend on the worker, so a sweep over the workers of Dask or the tasks of Slurm gives
the same values as the serial sweep, to the last bit. If an item raises an exception, the sweep keeps the exception with the name of the item and
continues. docs/scale.md describes Dask and Slurm and their cost.

>>> import raceway
>>> from raceway import sweep
>>> model = raceway.Model.new("S 6014 C")
>>> def torque(factor):
...     return {"torque_Nmm": float(model.with_values({"rolling_factor": factor}).solve(6000.0, 300.0).friction_torque_Nmm)}
>>> found = sweep.run(torque, [0.9, 1.0, 1.1])
>>> found
<raceway.sweep.Sweep: 3 items>
>>> found.to_frame().round(1)
  name  torque_Nmm error
0    1       264.7  None
1    2       293.7  None
2    3       322.6  None

``python3 -m raceway.sweep --help`` describes job arrays.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import ArrayLike

from ._errors import Doubt, InputError
from ._given import arrays as _arrays
from ._given import warn as _warn
from ._model import Model
from ._note import Note
from ._results import Solution
from ._sweep_slabs import Outcome, Slab, cut, input_of, read_all, refuse_other_cut, slabs_there, storable, work_on, write_slab

if TYPE_CHECKING:
    import pandas

__all__ = ["Failure", "ItemDoubt", "Sweep", "load", "run", "solve", "workers"]

#: Slabs of a sweep of many items, and at least how many for each worker of Dask.
SLABS = 32
SLABS_PER_WORKER = 8


@dataclass(frozen=True)
class Failure:
    """Exception of an item.

    Attributes
    ----------
    name : str
        Name of the item.
    kind : str
        Class of the error, such as ``"InputError"``.
    message : str
        Text of the exception.
    traceback : str
        Traceback of the exception, as Python prints it.
    """

    name: str
    kind: str
    message: str
    traceback: str = field(compare=False, repr=False, default="")

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


@dataclass(frozen=True)
class ItemDoubt:
    """Warning of an item."""

    name: str
    message: str

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


class Sweep(Mapping[str, Any]):
    """Outcomes of all items, by name and in the order of the items.

    ``sweep[name]`` raises RuntimeError for an item that failed. `values` has None for this item.

    Attributes
    ----------
    names : list of str
        Names of the items.
    failures : list of Failure
        Items that raised an exception, in the order of the items.
    doubts : list of ItemDoubt
        Warnings in the order of the items.
    """

    def __init__(self, names: Sequence[str], outcomes: Sequence[Outcome]) -> None:
        self.names = list(names)
        self._values = [None if o.value is None else pickle.loads(o.value) for o in outcomes]
        self._failed = {n: Failure(n, *o.error) for n, o in zip(self.names, outcomes, strict=True) if o.error}
        self._places = {name: place for place, name in enumerate(self.names)}
        self.failures = list(self._failed.values())
        self.doubts = [ItemDoubt(n, text) for n, o in zip(self.names, outcomes, strict=True) for text in o.doubts]

    def values(self) -> list[Any]:  # type: ignore[override]
        """Return the values in the order of the items, with None for an item that failed."""
        return list(self._values)

    def items(self) -> list[tuple[str, Any]]:  # type: ignore[override]
        """Return pairs of name and value, with None as the value of an item that failed."""
        return list(zip(self.names, self._values, strict=True))

    def __getitem__(self, name: str) -> Any:
        if name not in self._places:
            raise KeyError(f"{name}: no such item")
        if name in self._failed:
            failure = self._failed[name]
            raise RuntimeError(f"{failure.name} has no value because of {failure.kind}: {failure.message}")
        return self._values[self._places[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def rows(self) -> list[dict[str, Any]]:
        """Return one dict per item: ``name``, the numbers and texts of its value, and ``error`` (None without an error).

        Raises
        ------
        InputError
            A value is not a number, a text, or a dict of numbers and texts.
        """
        rows = []
        for name, value in self.items():
            failure = self._failed.get(name)
            cells = value if isinstance(value, Mapping) else {} if failure else {"value": value}
            for key, cell in cells.items():
                if not isinstance(cell, (bool, int, float, str, numpy.bool_, numpy.number, type(None))):
                    raise InputError(f"{name}: {key} is a {type(cell).__name__}; a table contains only numbers and text; use values()")
            rows.append({"name": name, **cells, "error": failure and f"{failure.kind}: {failure.message}"})
        return rows

    def to_frame(self) -> pandas.DataFrame:
        """Return `rows` as a DataFrame, with ``error`` as the last column."""
        import pandas

        rows = self.rows()
        columns = [key for key in dict.fromkeys(key for row in rows for key in row) if key != "error"]
        return pandas.DataFrame(rows, columns=[*columns, "error"])

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failed" if self.failures else ""
        return f"<raceway.sweep.Sweep: {len(self)} item{'' if len(self) == 1 else 's'}{failed}>"


def run(
    function: Callable[[Any], Any],
    items: Iterable[Any] | Mapping[str, Any],
    *,
    names: Iterable[str] | None = None,
    client: Any = None,
    folder: str | os.PathLike[str] | None = None,
    slabs: int | None = None,
    threads: int | None = None,
    progress: Callable[[float, str], None] | None = None,
) -> Sweep:
    """Call a function for every item.

    Parameters
    ----------
    function : callable
        Function of one item that returns numbers, arrays, text, or lists and dicts of them. The function must return
        the same value for the same item, so derive random seeds from the item.
    items : iterable, or mapping of names to items
        Anything that can be pickled: models, corrections, records, numbers, paths.
    names : iterable of str, optional
        Names of the items, all different. The default is ``"1"``, ``"2"``, ...
    client : distributed.Client or str, optional
        Client of Dask workers, such as the result of `workers`, or the address of a Dask scheduler
        (``"tcp://10.0.0.1:8786"``). Without a client the sweep runs in this process. A worker process computes
        one item at a time, so start one process per core.
    folder : path, optional
        Folder that stores every finished slab as data: numbers, arrays, text, or lists and dicts of them.
        If you repeat an interrupted sweep, only the missing slabs are computed.
    slabs : int, optional
        Number of parts. Each part goes to one worker and one file. The default is the number in `folder`. For a new
        folder, the default is 32, or 8 per worker with more than four workers. There is at most one part per item.
    threads : int, optional
        Cores for one item. The default is all cores without Dask, and 1 in a worker of Dask.
    progress : callable, optional
        Function that receives the finished share and a few words. The function is called after each slab, or after each item
        without `client`.

    Returns
    -------
    Sweep
        Outcomes in the order of the items. A warning `raceway.Doubt` gives the number of items that failed or caused warnings.

    Raises
    ------
    InputError
        The folder has slabs of another input, no Dask scheduler answers at the address, or a worker has another
        version of raceway.
    ImportError
        `client` is given, but Dask is not installed.
    KeyboardInterrupt
        The sweep stops. Finished slabs are in `folder`.
    """
    names, items = _named(names, items)
    return _said(_run(function, names, items, client, folder, slabs, threads, progress))


def _run(
    function: Callable[[Any], Any],
    names: list[str],
    items: list[Any],
    client: Any,
    folder: str | os.PathLike[str] | None,
    slabs: int | None,
    threads: int | None,
    progress: Callable[[float, str], None] | None,
) -> Sweep:
    if not callable(function):
        raise TypeError(f"function: must be a function of one item, not {type(function).__name__}")
    if threads is not None and (isinstance(threads, bool) or not isinstance(threads, int) or threads < 1):
        raise ValueError(f"threads = {threads!r}: must be 1 or more")
    with contextlib.ExitStack() as stack:
        dask = None
        if client is not None:
            from ._sweep_dask import client_of, count_workers

            dask = stack.enter_context(client_of(client))
            several = max(SLABS, SLABS_PER_WORKER * count_workers(dask))
        else:
            several = SLABS
        made_from = "" if folder is None else input_of(function, names, items)
        there = {} if folder is None else slabs_there(folder, made_from, len(items))
        of = next((file.header["slabs"] for file in there.values()), min(several, max(1, len(items))))
        parts = cut(len(items), of if slabs is None else _number_of_slabs(slabs, len(items)))
        for file in there.values():
            refuse_other_cut(file.path, file.header, len(parts))
        outcomes = {number: file.outcomes for number, file in there.items()}
        left = [slab for slab in parts if slab.number not in outcomes]
        done = len(items) - sum(slab.last - slab.first for slab in left)

        def tell(extra: int = 0) -> None:
            if progress is not None:
                progress((done + extra) / max(1, len(items)), f"{done + extra} of {len(items)} items")

        def take(slab: Slab, found: list[Outcome]) -> None:
            nonlocal done
            if folder is not None:
                found = storable(found)
                write_slab(folder, slab, made_from, names[slab.first : slab.last], found, len(items))
            outcomes[slab.number] = found
            done += slab.last - slab.first
            if dask is not None:
                tell()

        tell()
        if dask is not None and left:
            from ._sweep_dask import run_on

            run_on(dask, function, items, left, 1 if threads is None else threads, take)
        elif dask is None:
            for slab in left:
                take(slab, work_on(function, items[slab.first : slab.last], threads, tell))
    return Sweep(names, [outcome for slab in parts for outcome in outcomes[slab.number]])


def solve(
    model: Model,
    speed_rpm: ArrayLike,
    axial_load_N: ArrayLike | None = None,
    radial_load_N: ArrayLike | None = None,
    temperature_C: ArrayLike | None = None,
    moment_y_Nmm: ArrayLike | None = None,
    moment_z_Nmm: ArrayLike | None = None,
    *,
    columns: Sequence[str] = (),
    states: int = 10_000,
    client: Any = None,
    folder: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    progress: Callable[[float, str], None] | None = None,
) -> Solution:
    """Solve any number of states in slabs. The results equal `raceway.Model.solve` to the last bit.

    Parameters
    ----------
    model : raceway.Model
        Model to solve.
    speed_rpm, axial_load_N, radial_load_N, temperature_C, moment_y_Nmm, moment_z_Nmm, columns
        See `raceway.Model.solve`.
    states : int
        Number of states in one slab (part). The results do not depend on this number.
    client, folder, threads, progress
        See `run`.

    Raises
    ------
    InputError
        The errors of `raceway.Model.solve`. The index in a message is the index within the slab.

    Examples
    --------
    >>> import numpy
    >>> model = Model.new("S 6014 C")
    >>> speeds = numpy.linspace(100.0, 12000.0, 50)
    >>> parted = solve(model, speeds, 300.0, states=7)
    >>> bool((parted.friction_torque_Nmm == model.solve(speeds, 300.0).friction_torque_Nmm).all())
    True
    """
    if not isinstance(model, Model):
        raise TypeError(f"model: must be a raceway.Model, not {type(model).__name__}")
    if states < 1:
        raise ValueError(f"states = {states}: must be 1 or more")
    given = _arrays(
        speed_rpm=speed_rpm,
        axial_load_N=axial_load_N,
        radial_load_N=radial_load_N,
        temperature_C=temperature_C,
        moment_y_Nmm=moment_y_Nmm,
        moment_z_Nmm=moment_z_Nmm,
    )
    try:
        shape = numpy.broadcast_shapes(*(array.shape for array in given.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in given.items())
        raise InputError(f"these arrays have different shapes, and no common shape fits all: {shapes}") from None
    flat = {n: a if a.ndim == 0 else numpy.broadcast_to(a, shape).reshape(-1) for n, a in given.items()}
    count = int(numpy.prod(shape))
    if count == 0 or not shape:
        return model.solve(**given, columns=columns)  # type: ignore[arg-type]
    firsts = range(0, count, states)
    items = [{n: a if a.ndim == 0 else a[first : first + states] for n, a in flat.items()} for first in firsts]
    ends = [min(first + states, count) for first in firsts]
    names = [f"states {first + 1} to {end}" for first, end in zip(firsts, ends)]
    work = _States(model, tuple(columns))
    found = _run(work, names, items, client, folder, len(items), threads, progress)
    if found.failures:
        raise InputError(str(found.failures[0]))
    _warn(dict.fromkeys(doubt.message for doubt in found.doubts))
    parts = found.values()
    values = numpy.concatenate([part["values"] for part in parts], axis=1)
    status = numpy.concatenate([part["status"] for part in parts])
    notes = [Note(*fields) for fields in dict.fromkeys(tuple(fields) for part in parts for fields in part["notes"])]
    return Solution(parts[0]["names"], values.reshape(-1, *shape), status.reshape(shape), given, notes, None)


def _fields(note: Note) -> list[str | int | None]:
    """Return a note as plain data, in the order of the arguments of `Note`. A folder of slabs stores plain data only."""
    return [str(note), note.kind, note.code, note.file, note.line, note.key]


@dataclass(frozen=True)
class _States:
    """Function that solves one slab of states with a model."""

    model: Model
    columns: tuple[str, ...]

    def __call__(self, given: Mapping[str, numpy.ndarray]) -> dict[str, Any]:
        found = self.model.solve(**given, columns=self.columns)  # type: ignore[arg-type]
        return {"names": list(found), "values": found._values, "status": found._status, "notes": [_fields(n) for n in found.notes]}


@contextlib.contextmanager
def workers(count: int | None = None, *, dashboard: bool = False) -> Iterator[Any]:
    """Start worker processes of Dask on this computer, for the argument `client` of `run` and `solve`. The processes end with the ``with`` block.

    Put the code of the script below ``if __name__ == "__main__":``, because each worker imports the script.
    The processes listen on the loopback interface only. If python3-cryptography is installed, the workers accept work from this process only (TLS
    with their own keys). The files of the workers are in a private folder.

    Parameters
    ----------
    count : int, optional
        Number of workers. The default is the number of cores of this process.
    dashboard : bool
        True shows the pages of the scheduler at ``client.dashboard_link``. Other users of this computer can read
        these pages.

    Raises
    ------
    ImportError
        Dask is not installed.

    Examples
    --------
    >>> with workers(2) as client:  # doctest: +SKIP
    ...     found = run(identify, machines, client=client)
    """
    if count is None:
        count = len(os.sched_getaffinity(0))
    if isinstance(count, bool) or not isinstance(count, int) or count < 1:
        raise ValueError(f"count = {count!r}: must be 1 or more")
    from ._sweep_dask import local_workers

    with local_workers(count, dashboard) as client:
        yield client


def load(folder: str | os.PathLike[str]) -> Sweep:
    """Join the slabs of a folder. Slabs contain data only, so reading them runs no code.

    Raises
    ------
    InputError
        A slab is missing, exists twice, is cut off, comes from another input than the first slab, or contains more than data.
    """
    slabs = read_all(folder)
    return Sweep([n for slab in slabs for n in slab.names], [o for slab in slabs for o in slab.outcomes])


def _named(names: Iterable[str] | None, items: Iterable[Any] | Mapping[str, Any]) -> tuple[list[str], list[Any]]:
    if isinstance(items, Mapping):
        if names is not None:
            raise ValueError("names: not possible, because items is a mapping, which already has names")
        names, items = list(items), list(items.values())
    if isinstance(items, (str, bytes)):
        raise TypeError(f"items: must be a list or a mapping, not {type(items).__name__}")
    found = list(items)
    called = [str(place + 1) for place in range(len(found))] if names is None else list(names)
    for name in called:
        if not isinstance(name, str):
            raise TypeError(f"names: must contain text, not {type(name).__name__}")
    if len(called) != len(found):
        raise ValueError(f"names: {len(called)} names are given for {len(found)} items")
    if len(set(called)) != len(called):
        seen: set[str] = set()
        twice = next(name for name in called if name in seen or seen.add(name))  # type: ignore[func-returns-value]
        raise ValueError(f"names: {twice} occurs twice")
    return called, found


def _number_of_slabs(slabs: int, items: int) -> int:
    if isinstance(slabs, bool) or not isinstance(slabs, int) or not 1 <= slabs <= max(1, items):
        raise ValueError(f"slabs = {slabs!r}: must be from 1 to {max(1, items)}, the number of items")
    return slabs


def _said(found: Sweep) -> Sweep:
    """Warn once about all failed items and once about all warnings, and return the sweep."""
    lists: list[tuple[str, str, Sequence[Failure | ItemDoubt]]] = [("failed", "failures", found.failures), ("have warnings", "doubts", found.doubts)]
    for kind, where, which in lists:
        if which:
            count = len({one.name for one in which})
            warnings.warn(f"{count} of {len(found)} items {kind} (the attribute {where} has all), the first {which[0]}", Doubt, stacklevel=3)
    return found


if __name__ == "__main__":
    import sys

    from raceway._sweep_command import main

    sys.exit(main())

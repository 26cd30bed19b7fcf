"""``python3 -m raceway.sweep``: computes slabs (parts) of a sweep as tasks of a job array, and merges the slabs."""

from __future__ import annotations

import argparse
import contextlib
import csv
import importlib.util
import io
import os
import pathlib
import re
import sys
import warnings
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

from . import _engine
from . import sweep
from ._errors import Doubt, InputError
from ._results import _write
from ._sweep_slabs import (
    CutOff,
    Slab,
    cut,
    input_of,
    path_of,
    read_header,
    read_slab,
    refuse_other_cut,
    refuse_other_input,
    slab_files,
    storable,
    work_on,
    write_slab,
)

JOB = """JOB is a Python file with two names:
  items   a list, or a mapping of names to items, or a function without arguments that returns one of these
  work    a function of one item that returns numbers and text, or a dict of numbers and text

A task of a Slurm array calculates one slab. It writes the complete slab or nothing. merge joins the slabs:
  #SBATCH --array=1-8
  python3 -m raceway.sweep run job.py --folder slabs --slab $SLURM_ARRAY_TASK_ID/8
  python3 -m raceway.sweep merge slabs -o result.csv
"""


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(
        prog="python3 -m raceway.sweep",
        description="Calculate many items on many machines, in slabs.",
        epilog=JOB,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=_engine.__version__)
    commands = parser.add_subparsers(dest="command", required=True)
    running = commands.add_parser("run", help="calculate one slab of a job, or all missing slabs")
    running.add_argument("job", metavar="JOB", help="Python file with items and work")
    running.add_argument("--folder", required=True, help="folder for the slabs")
    running.add_argument("--slab", metavar="K/N", help="calculate only slab K of N; default: all slabs that are not in the folder")
    running.add_argument("--slabs", type=int, metavar="N", help="without --slab: number of slabs; default 32")
    running.add_argument("--client", metavar="ADDRESS", help="without --slab: address of the Dask scheduler, tcp://HOST:PORT")
    running.add_argument("--workers", type=int, metavar="N", help="without --slab: use N Dask processes on this computer")
    running.add_argument("--threads", type=int, help="cores for one item; default: all, or 1 in a Dask worker")
    merging = commands.add_parser("merge", help="join slabs; all slabs must exist and come from the same input")
    merging.add_argument("folder", metavar="FOLDER")
    merging.add_argument("-o", "--output", required=True, metavar="FILE", help="CSV file to write, one row for each item; - for stdout")
    merging.add_argument("--force", action="store_true", help="overwrite FILE")
    asked = parser.parse_args(arguments)
    try:
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always", Doubt)
            try:
                said = _run(asked) if asked.command == "run" else _merge(asked)
            finally:
                for doubt in heard:
                    print(f"warning: {doubt.message}", file=sys.stderr)
    except (ValueError, TypeError, ImportError, OSError) as e:
        print(f"error: {e}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted; the completed slabs are kept", file=sys.stderr)
        return 130
    if said:
        print(said, file=sys.stderr)
    return 0


def _run(asked: argparse.Namespace) -> str:
    job = _job(asked.job)
    names, items = sweep._named(None, job.items() if callable(job.items) else job.items)
    if asked.slab is None:
        if asked.client is not None and asked.workers is not None:
            raise InputError("--client and --workers: give only one of the two")
        with contextlib.ExitStack() as stack:
            client = asked.client if asked.workers is None else stack.enter_context(sweep.workers(asked.workers))
            found = sweep.run(
                job.work, dict(zip(names, items, strict=True)), client=client, folder=asked.folder, slabs=asked.slabs, threads=asked.threads
            )
        return f"{asked.folder}: {len(found)} items"
    for flag in ("client", "workers", "slabs"):
        if getattr(asked, flag) is not None:
            raise InputError(f"--{flag}: not possible together with --slab, which calculates only one slab; remove --slab")
    if asked.threads is not None and asked.threads < 1:
        raise InputError(f"--threads {asked.threads}: must be 1 or more")
    slab = cut(len(items), *_of(asked.slab, len(items)))[_number(asked.slab) - 1]
    return _one_slab(asked, job.work, names, items, slab)


def _one_slab(asked: argparse.Namespace, work: Callable[[Any], Any], names: list[str], items: list[Any], slab: Slab) -> str:
    made_from = input_of(work, names, items)
    path = path_of(asked.folder, slab)
    for there in slab_files(asked.folder):
        try:
            header = read_header(there)
            refuse_other_input(there, header, made_from, len(items))
            refuse_other_cut(there, header, slab.of)
            if there == path:
                read_slab(there)
                return f"{path}: exists already, {slab.last - slab.first} items"
        except CutOff:
            pass  # this task computes its own slab again, and other tasks compute their slabs
    outcomes = storable(work_on(work, items[slab.first : slab.last], asked.threads))
    write_slab(asked.folder, slab, made_from, names[slab.first : slab.last], outcomes, len(items))
    sweep._said(sweep.Sweep(names[slab.first : slab.last], outcomes))
    return f"{path}: {slab.last - slab.first} items"


def _merge(asked: argparse.Namespace) -> str:
    found = sweep.load(asked.folder)
    sweep._said(found)
    rows = found.rows()
    columns = [key for key in dict.fromkeys(key for row in rows for key in row) if key != "error"]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([_guarded(column) for column in [*columns, "error"]])
    # csv writes enough digits of a float to read exactly the same number again.
    writer.writerows([_guarded(row.get(column)) for column in [*columns, "error"]] for row in rows)
    if asked.output == "-":
        sys.stdout.write(text.getvalue())
        return ""
    _write(asked.output, text.getvalue(), asked.force)
    return f"{asked.output}: {len(found)} items"


def _guarded(cell: Any) -> Any:
    """Return the cell, with an apostrophe in front if a spreadsheet would read its text as a formula. The library removes the apostrophe again."""
    return f"'{cell}" if isinstance(cell, str) and re.match("'*[-=+@]", cell) else cell


def _number(text: str) -> int:
    return int(text.partition("/")[0])


def _of(text: str, items: int) -> tuple[int]:
    number, _, of = text.partition("/")
    if not (number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of)):
        raise InputError(f"--slab {text}: must be K/N with K from 1 to N, such as 3/8")
    if int(of) > items:
        raise InputError(f"--slab {text}: N must be at most {items}, the number of items")
    return (int(of),)


def _job(path: str) -> ModuleType:
    if not os.path.isfile(path):
        raise InputError(f"{path}: no such file")
    name = pathlib.Path(path).stem
    spec = importlib.util.spec_from_file_location(name if name not in sys.modules else f"job_{name}", path)
    if spec is None or spec.loader is None:
        raise InputError(f"{path}: must be a Python file with the ending .py")
    job = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = job
    sys.path.insert(0, os.path.dirname(os.path.abspath(path)))
    try:
        spec.loader.exec_module(job)
    except (SyntaxError, NameError, AttributeError, RuntimeError, LookupError) as e:
        raise InputError(f"{path}: {type(e).__name__}: {e}") from e
    for wanted in ("items", "work"):
        if not hasattr(job, wanted):
            raise InputError(f"{path}: has no {wanted}; a job needs items and work")
    return job

"""Functions that compute the items of a sweep one after the other, and write and read the files of the slabs (parts) of the sweep."""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import hashlib
import json
import os
import pathlib
import pickle
import socket
import struct
import threading
import traceback
import types
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy

from . import _engine
from ._correction import Correction
from ._effect import Effect
from ._errors import Doubt, InputError
from ._model import Model
from ._record import Record
from ._sweep_data import KINDS, NoData, decode, encode

ENDING = ".sweep"
_FORM = 2
_LONGEST_HEADER = 65536


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Outcome of one item: its pickled value or its exception, and its warnings."""

    value: bytes | None  #: pickle, only for the processes of one sweep; slabs on disk contain data
    error: tuple[str, str, str] | None  #: kind, message, traceback
    doubts: tuple[str, ...]


@dataclasses.dataclass(frozen=True)
class Slab:
    """Part `number` of `of` parts, counted from 1: the items from `first` up to, but not including, `last`."""

    number: int
    of: int
    first: int
    last: int

    def __str__(self) -> str:
        return f"slab {self.number} of {self.of}"


def cut(items: int, of: int) -> list[Slab]:
    """Return slabs whose sizes differ by at most one item."""
    return [Slab(k + 1, of, items * k // of, items * (k + 1) // of) for k in range(of)]


# Warning filters and the number of threads apply to the whole process.
_one_at_a_time = threading.Lock()


@contextlib.contextmanager
def _limited(threads: int | None) -> Iterator[None]:
    if threads is None:
        yield
        return
    _engine.limit_threads(threads)
    try:
        yield
    finally:
        _engine.limit_threads(0)


def work_on(
    function: Callable[[Any], Any], items: Sequence[Any], threads: int | None, after_each: Callable[[int], None] | None = None
) -> list[Outcome]:
    """Call `function` for each item. The exception of an item is stored with this item. Items in one process are computed one at a time."""
    outcomes: list[Outcome] = []
    with _one_at_a_time, _limited(threads):
        for item in items:
            outcomes.append(_one(function, item))
            if after_each is not None:
                after_each(len(outcomes))
    return outcomes


def _one(function: Callable[[Any], Any], item: Any) -> Outcome:
    value, error = None, None
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        try:
            found = function(item)
        except (Exception, SystemExit) as e:
            error = (type(e).__name__, str(e) or repr(e), traceback.format_exc())
        else:
            try:
                value = pickle.dumps(found, 5)
            except Exception as e:
                what = (
                    f"the function returned a {type(found).__name__}, which cannot be sent to another process ({e}); "
                    "return numbers, arrays and text, or lists and dicts of these, such as .data"
                )
                error = ("TypeError", what, traceback.format_exc())
    doubts = dict.fromkeys(str(w.message) for w in heard)
    return Outcome(value, error, tuple(doubts))


def input_of(function: Callable[[Any], Any], names: Sequence[str], items: Sequence[Any]) -> str:
    """Return a fingerprint of the input of a sweep: function, names and items, as hexadecimal text."""
    hash_ = hashlib.sha256()
    _feed(hash_, function)
    for name, item in zip(names, items, strict=True):
        _feed(hash_, name)
        _feed(hash_, item)
    return hash_.hexdigest()


def _feed(hash_: Any, value: Any) -> None:
    """Hash a value by its content and not by its memory layout, so that all processes get the same hash."""

    def put(kind: str, content: bytes = b"") -> None:
        hash_.update(f"{kind} {len(content)};".encode())
        hash_.update(content)

    match value:
        case None | bool() | int():
            put("number", repr(value).encode())
        case float():
            put("float", struct.pack("<d", value))
        case str():
            put("text", value.encode("utf-8", "surrogatepass"))
        case bytes():
            put("bytes", value)
        case numpy.ndarray() if value.dtype.kind in "biufcUS":
            put(f"array {value.dtype.str} {value.shape}", numpy.ascontiguousarray(value).tobytes())
        case numpy.generic() if value.dtype.kind in "biufcUS":
            put(f"scalar {value.dtype.str}", value.tobytes())
        case pathlib.PurePath():
            put("path", str(value).encode())
            if isinstance(value, pathlib.Path) and value.is_file():
                put("file", hashlib.sha256(value.read_bytes()).digest())
        case Record():
            _feed(hash_, ("record", value.name, value.text, value._columns, value._drop_nan))
        case Model():
            _feed(hash_, ("model", value.source, value._engine.text, value._engine.files, value.effects))
        case Correction():
            _feed(hash_, ("correction", value.source, value._engine.text, value._engine.files))
        case Effect():
            _feed(hash_, ("effect", value.id, value.numbers, value.torque))
        case list() | tuple():
            put(f"{type(value).__name__} {len(value)}")
            for part in value:
                _feed(hash_, part)
        case set() | frozenset():
            parts = []
            for part in value:
                alone = hashlib.sha256()
                _feed(alone, part)
                parts.append(alone.digest())
            put("set", b"".join(sorted(parts)))
        case Mapping():
            put(f"mapping {len(value)}")
            for key, part in value.items():
                _feed(hash_, key)
                _feed(hash_, part)
        case functools.partial():
            put("partial")
            _feed(hash_, (value.func, value.args, value.keywords))
        case types.MethodType():
            put("method")
            _feed(hash_, (value.__func__, value.__self__))
        case types.FunctionType():
            _feed_function(hash_, value, set())
        case types.BuiltinFunctionType() | type() | types.ModuleType():
            put("name", f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', value.__name__)}".encode())
        case _ if dataclasses.is_dataclass(value):
            put("dataclass", type(value).__qualname__.encode())
            for field in dataclasses.fields(value):
                _feed(hash_, getattr(value, field.name))
        case _:
            put("pickle", pickle.dumps(value, 5))


def _feed_function(hash_: Any, function: types.FunctionType, seen: set[types.FunctionType]) -> None:
    """Hash a function: its code, defaults and closure, and the functions and values of its module that it uses."""
    if function in seen:
        return
    seen.add(function)
    _feed(hash_, (function.__defaults__, function.__kwdefaults__))
    for cell in function.__closure__ or ():
        if cell.cell_contents is not function:
            _feed(hash_, cell.cell_contents)
    codes = [function.__code__]
    while codes:
        code = codes.pop(0)
        _feed(hash_, (code.co_name, code.co_code, code.co_names, code.co_varnames))
        for part in code.co_consts:
            if isinstance(part, types.CodeType):
                codes.append(part)
            else:
                _feed(hash_, part)
        for name in code.co_names:
            known = function.__globals__.get(name)
            if isinstance(known, types.FunctionType) and known.__module__ == function.__module__:
                _feed_function(hash_, known, seen)
            elif isinstance(known, (bool, int, float, str, bytes, list, tuple, dict, numpy.ndarray)) or isinstance(
                known, (Model, Correction, Record)
            ):
                _feed(hash_, known)


def path_of(folder: str | os.PathLike[str], slab: Slab) -> pathlib.Path:
    return pathlib.Path(folder) / f"slab-{slab.number}-of-{slab.of}{ENDING}"


def storable(outcomes: Sequence[Outcome]) -> list[Outcome]:
    """Return the outcomes for a slab on disk. An error replaces a value that is not plain data."""
    return [_storable(outcome) for outcome in outcomes]


def _storable(outcome: Outcome) -> Outcome:
    if outcome.value is None:
        return outcome
    try:
        encode(pickle.loads(outcome.value))
    except NoData as e:
        error = ("TypeError", f"the returned value {e}, which a slab file cannot contain; return {KINDS}", "")
        return Outcome(None, error, outcome.doubts)
    return outcome


def write_slab(folder: str | os.PathLike[str], slab: Slab, made_from: str, names: Sequence[str], outcomes: Sequence[Outcome], items: int) -> None:
    """Write the file completely or not at all: write it under another name, then rename it."""
    parts = [(None if o.value is None else pickle.loads(o.value), o.error, o.doubts) for o in outcomes]
    content = encode((list(names), parts))
    header = {
        "raceway_sweep": _FORM,
        "version": _engine.__version__,
        "instruction_set": _engine.instruction_set(),
        "input": made_from,
        "slab": slab.number,
        "slabs": slab.of,
        "items": items,
        "sha256": hashlib.sha256(content).hexdigest(),
    }
    path = path_of(folder, slab)
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f"{path.name}.{socket.gethostname()}.{os.getpid()}.part")
    try:
        with open(part, "wb") as file:
            file.write(json.dumps(header).encode() + b"\n" + content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


@dataclasses.dataclass(frozen=True)
class SlabFile:
    """Slab on disk."""

    path: pathlib.Path
    header: dict[str, Any]
    names: list[str]
    outcomes: list[Outcome]


class CutOff(InputError):
    """Error for a file that ends too early or was changed."""


def _header(path: pathlib.Path, first: bytes) -> dict[str, Any]:
    try:
        header = json.loads(first)
        form, version = header["raceway_sweep"], header["version"]
    except (ValueError, KeyError, TypeError, RecursionError):
        raise CutOff(f"{path}: is not a slab of a sweep, or is incomplete") from None
    if version != _engine.__version__:
        raise InputError(f"{path}: was written by raceway {version}, but this is raceway {_engine.__version__}; calculate the slab again")
    if form != _FORM:
        raise InputError(f"{path}: has slab format {form}, but this version reads only format {_FORM}; calculate the slab again")
    numbers = all(type(header.get(name)) is int for name in ("slab", "slabs", "items"))
    texts = all(type(header.get(name)) is str for name in ("instruction_set", "input", "sha256"))
    if not (numbers and texts and 1 <= header["slab"] <= header["slabs"]):
        raise InputError(f"{path}: its header does not come from a sweep; remove the file")
    return header


def read_header(path: pathlib.Path) -> dict[str, Any]:
    with open(path, "rb") as file:
        return _header(path, file.readline(_LONGEST_HEADER))


def read_slab(path: pathlib.Path) -> SlabFile:
    """Read a slab from any source. A slab that contains more than plain data is rejected."""
    with open(path, "rb") as file:
        header = _header(path, file.readline(_LONGEST_HEADER))
        content = file.read()
    if hashlib.sha256(content).hexdigest() != header["sha256"]:
        raise CutOff(f"{path}: is incomplete or was changed after it was written; calculate the slab again")
    try:
        names, parts = decode(content)
        outcomes = [_outcome(*part) for part in parts]
        if not all(type(name) is str for name in names) or len(names) != len(outcomes):
            raise ValueError("the numbers of names and items differ")
    except (ValueError, TypeError) as e:
        raise InputError(f"{path}: cannot be read: {e}") from None
    return SlabFile(path, header, names, outcomes)


def _outcome(value: Any, error: Any, doubts: Any) -> Outcome:
    texts = [*(error or ()), *doubts]
    if not all(type(text) is str for text in texts) or (error is not None and len(error) != 3):
        raise ValueError("an item does not come from a sweep")
    if error:
        kind, message, trace = error
        return Outcome(None, (kind, message, trace), tuple(doubts))
    return Outcome(pickle.dumps(value, 5), None, tuple(doubts))


def slab_files(folder: str | os.PathLike[str]) -> list[pathlib.Path]:
    return sorted(pathlib.Path(folder).glob(f"*{ENDING}"))


def refuse_other_input(path: pathlib.Path, header: Mapping[str, Any], made_from: str, items: int) -> None:
    if header["input"] != made_from or header["items"] != items:
        raise InputError(
            f"{path}: comes from another input (another function, other items or other names); "
            "use another folder, or remove the slabs in this folder"
        )


def refuse_other_cut(path: pathlib.Path, header: Mapping[str, Any], of: int) -> None:
    if header["slabs"] != of:
        raise InputError(
            f"{path}: is one of {header['slabs']} slabs, but {of} slabs are requested; request {header['slabs']} slabs, or use another folder"
        )


def slabs_there(folder: str | os.PathLike[str], made_from: str, items: int) -> dict[int, SlabFile]:
    """Return the slabs of this input by number. Slabs of another input are rejected. Cut-off slabs are computed again."""
    there = {}
    for path in slab_files(folder):
        try:
            slab = read_slab(path)
        except CutOff as e:
            warnings.warn(f"{e}; the sweep calculates this slab again", Doubt, stacklevel=3)
            continue
        refuse_other_input(path, slab.header, made_from, items)
        there[slab.header["slab"]] = slab
    return there


def read_all(folder: str | os.PathLike[str]) -> list[SlabFile]:
    """Return all slabs of a folder in order, after a check that they are complete and come from one input.

    Raises
    ------
    InputError
        A slab is missing, exists twice, is cut off, or comes from another input than the first slab.
    """
    paths = slab_files(folder)
    if not paths:
        raise InputError(f"{os.fspath(folder)}: has no slabs (files *{ENDING})")
    found: dict[int, SlabFile] = {}
    for path in paths:
        slab = read_slab(path)
        if found:
            before = next(iter(found.values()))
            if slab.header["input"] != before.header["input"] or slab.header["items"] != before.header["items"]:
                raise InputError(f"{path}: comes from another input than {before.path}")
            if slab.header["slabs"] != before.header["slabs"]:
                raise InputError(f"{path}: is one of {slab.header['slabs']} slabs, but {before.path} is one of {before.header['slabs']}")
        number = slab.header["slab"]
        if number in found:
            raise InputError(f"{path}: is slab {number}, but {found[number].path} is also slab {number}; remove one")
        found[number] = slab
    header = next(iter(found.values())).header
    missing = [slab for slab in cut(header["items"], header["slabs"]) if slab.number not in found]
    if missing:
        numbers = ", ".join(str(slab.number) for slab in missing[:20]) + (", ..." if len(missing) > 20 else "")
        items = f"items {missing[0].first + 1} to {missing[0].last}" if len(missing) == 1 else "their items"
        raise InputError(
            f"{os.fspath(folder)}: slab{'s' if len(missing) > 1 else ''} {numbers} of {header['slabs']} "
            f"({items} of {header['items']}) {'are' if len(missing) > 1 else 'is'} missing; "
            f"run {'them' if len(missing) > 1 else 'it'} again"
        )
    slabs = [found[number] for number in sorted(found)]
    sets = sorted({slab.header["instruction_set"] for slab in slabs})
    if len(sets) > 1:
        warnings.warn(mixed_sets(sets), Doubt, stacklevel=2)
    return slabs


def mixed_sets(sets: Sequence[str]) -> str:
    return (
        f"machines with different instruction sets calculated these values ({', '.join(sets)}); " "the last digits of a value depend on the machine"
    )

"""Values of a sweep as data: JSON for their structure and npz for their arrays. Reading these values runs no code."""

from __future__ import annotations

import base64
import io
import json
import zipfile
from collections.abc import Sequence
from typing import Any

import numpy

#: Allowed parts of a value, for messages.
KINDS = "numbers, arrays and text, or lists and dicts of these, such as .data"


class NoData(TypeError):
    """Error for a value that is not plain data."""


def encode(value: Any) -> bytes:
    """Return the bytes of a value: its structure as one line of JSON, then its arrays as npz.

    Raises
    ------
    NoData
        A part of the value is something other than a number, a text, bytes, an array of these, a list, tuple, set or dict.
    """
    arrays: list[numpy.ndarray] = []
    try:
        line = json.dumps(_plain(value, arrays)).encode("ascii")
    except RecursionError:
        raise NoData("is nested too deeply") from None
    content = io.BytesIO()
    numpy.savez(content, **{f"a{place}": array for place, array in enumerate(arrays)})
    return line + b"\n" + content.getvalue()


def decode(content: bytes) -> Any:
    """Return the value from bytes that `encode` has written.

    Raises
    ------
    ValueError
        The bytes do not come from `encode`.
    """
    line, _, rest = content.partition(b"\n")
    try:
        return _value(json.loads(line.decode("ascii")), _arrays(rest))
    except (ValueError, TypeError, LookupError, RecursionError, EOFError, OSError, zipfile.BadZipFile, NotImplementedError) as e:
        raise ValueError(f"does not contain data of a sweep ({type(e).__name__}: {e})") from None


def _plain(value: Any, arrays: list[numpy.ndarray]) -> Any:
    """Return a value as JSON. A list remains a list. A type that JSON lacks becomes a dict with the name of the type."""
    kind = type(value)
    if value is None or kind in (bool, int, float, str):
        return value
    if kind is list:
        return [_plain(part, arrays) for part in value]
    if kind is tuple or kind is set or kind is frozenset:
        return {kind.__name__: [_plain(part, arrays) for part in value]}
    if kind is dict:
        return {"dict": [[_plain(key, arrays), _plain(part, arrays)] for key, part in value.items()]}
    if kind is bytes:
        return {"bytes": base64.b64encode(value).decode("ascii")}
    if kind is complex:
        return {"complex": [value.real, value.imag]}
    if (kind is numpy.ndarray or isinstance(value, numpy.generic)) and not value.dtype.hasobject:
        array = numpy.asarray(value)
        # The type of unpickled dates has metadata, which npz does not keep.
        arrays.append(array if array.dtype.metadata is None else array.astype(array.dtype.str))
        return {"array" if kind is numpy.ndarray else "scalar": len(arrays) - 1}
    raise NoData(f"is a {kind.__name__}")


def _value(plain: Any, arrays: Sequence[numpy.ndarray]) -> Any:
    if isinstance(plain, list):
        return [_value(part, arrays) for part in plain]
    if not isinstance(plain, dict):
        return plain
    ((kind, content),) = plain.items()
    if kind == "dict":
        return {_value(key, arrays): _value(part, arrays) for key, part in content}
    if kind in ("tuple", "set", "frozenset"):
        return {"tuple": tuple, "set": set, "frozenset": frozenset}[kind](_value(part, arrays) for part in content)
    if kind == "bytes":
        return base64.b64decode(content, validate=True)
    if kind == "complex":
        return complex(*content)
    if kind == "array":
        return arrays[content]
    if kind == "scalar":
        return arrays[content][()]
    raise ValueError(f"{kind} is not a known kind of value")


def _arrays(content: bytes) -> list[numpy.ndarray]:
    with zipfile.ZipFile(io.BytesIO(content)) as file:
        # Only arrays as savez writes them, because a compressed array could be larger than the memory.
        if any(part.compress_type != zipfile.ZIP_STORED for part in file.infolist()):
            raise ValueError("a compressed array")
    with numpy.load(io.BytesIO(content), allow_pickle=False) as file:
        return [file[f"a{place}"] for place in range(len(file.files))]

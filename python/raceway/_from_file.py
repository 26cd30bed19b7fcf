"""Common part of models and corrections: the file that they come from."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Self

from . import _engine
from ._note import Note
from ._results import _write


class FromFile:
    """A model with the contents of its file, and of the files that it names, as they were when it was read."""

    _engine: Any
    _called = "model"  # a text without a name

    if TYPE_CHECKING:

        def __init__(self, source: str, text: str) -> None:
            ...

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Self:
        """Read a file (TOML; keys with their units: ``raceway keys``).

        Raises
        ------
        InputError
            The file is wrong. The error has file, line, key, value and allowed range.
        """
        return cls(os.fspath(path), _engine.read_text(os.fspath(path)))

    @classmethod
    def from_text(cls, text: str, name: str | None = None) -> Self:
        """Read a model from the text of a file. Messages use `name`, and files that the text names are in the same folder."""
        return cls(cls._called if name is None else name, text)

    @property
    def source(self) -> str:
        """File of the model, and the fits since then."""
        return self._engine.source

    @property
    def text(self) -> str:
        """Text of the file, as `save` writes it. Names of further files are valid from any folder."""
        return self._engine.text_for("")

    @property
    def defaults(self) -> list[str]:
        """Assumptions of the model: defaults that it uses, and values marked as assumed in its file."""
        return self._engine.defaults

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """Numbers that a fit may change: value, unit, lower and upper bound.

        For a correction of several displacements, each name begins with its displacement:
        ``"displacement_ch1_um.offset"``.
        """
        return self._engine.parameters

    @property
    def notes(self) -> list[Note]:
        """Notes on the file."""
        return self._engine.notes

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the file, whose names of further files lead to them from there; an existing one only with `overwrite`."""
        _write(path, self._engine.text_for(os.fspath(path)), overwrite)

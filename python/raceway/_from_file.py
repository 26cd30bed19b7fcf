"""Base class of models and corrections. The class reads and writes model files and correction files."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Self

from . import _engine
from ._note import Note
from ._results import _write


class FromFile:
    """Base class that stores the contents of a model file, and of all files that the model file names, when the object is created."""

    _engine: Any
    _called = "model"  # name of a text that has no name

    if TYPE_CHECKING:

        def __init__(self, source: str, text: str) -> None:
            ...

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Self:
        """Read a TOML file. The command ``raceway keys`` lists the keys and their units.

        Raises
        ------
        InputError
            The file is invalid. The error gives file, line, key, value and allowed range.
        """
        return cls(os.fspath(path), _engine.read_text(os.fspath(path)))

    @classmethod
    def from_text(cls, text: str, name: str | None = None) -> Self:
        """Read a model from the text of a file. Messages contain `name`. Other files in the text are searched in the folder of `name`."""
        return cls(cls._called if name is None else name, text)

    @property
    def source(self) -> str:
        """Name of the file, followed by the fits that changed the model, such as ``", calibrated"``."""
        return self._engine.source

    @property
    def text(self) -> str:
        """Text of the file. Paths of other files in this text are valid from any folder."""
        return self._engine.text_for("")

    @property
    def defaults(self) -> list[str]:
        """Assumptions of the model: default values in use, and values that the file marks as assumed."""
        return self._engine.defaults

    @property
    def parameters(self) -> dict[str, dict[str, Any]]:
        """Parameters that a fit can change, each with value, unit, lower bound and upper bound.

        For a correction of several displacements, each name begins with the name of a displacement, such as
        ``"displacement_ch1_um.offset"``.
        """
        return self._engine.parameters

    @property
    def notes(self) -> list[Note]:
        """Notes on the file."""
        return self._engine.notes

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the file. Paths of other files in the text are adapted to the new folder. True for `overwrite` replaces an existing file."""
        _write(path, self._engine.text_for(os.fspath(path)), overwrite)

"""What models and corrections have of the file that they stand for."""

from __future__ import annotations

import os
from typing import Any

from ._results import _write


class FromFile:
    _engine: Any

    @property
    def source(self) -> str:
        """File that it was read from, and what was fitted since."""
        return self._engine.source

    @property
    def text(self) -> str:
        """The file, as `save` writes it."""
        return self._engine.text

    @property
    def defaults(self) -> list[str]:
        """Defaults that it rests on."""
        return self._engine.defaults

    @property
    def notes(self) -> list[str]:
        """What else is to be known of it."""
        return self._engine.notes

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Write the file; an existing one only with `overwrite`."""
        _write(path, self.text, overwrite)

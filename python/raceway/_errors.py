"""Errors and warnings of the package."""

from __future__ import annotations

import re

from ._note import Note


class InputError(ValueError):
    """Error for a wrong input, with the complete message of the command.

    Attributes
    ----------
    file : str or None
        File with the wrong input.
    line : int or None
        Line of the file, from 1.
    key : str or None
        Key of a model, column of a record, or argument.
    """

    file: str | None = None
    line: int | None = None
    key: str | None = None


class NotConverged(RuntimeError):
    """Error for a fit that found no values, or for a needed state without equilibrium."""


class Doubt(UserWarning):
    """Reason to doubt a result; the command prints it behind ``warning:``.

    Attributes
    ----------
    note : Note
        Text with kind, code and place.
    """

    @property
    def note(self) -> Note:
        text = self.args[0] if self.args else ""
        return text if isinstance(text, Note) else Note(text, "warning")


_ARGUMENTS = {
    "--bore": "bore_mm",
    "--outer-diameter": "outer_diameter_mm",
    "--contact-angle": "contact_angle_deg",
    "--balls": "ball_count",
    "--channel": "channel",
    "--per-record": "per_record",
    "--zero": "zero",
    "--accept-untrusted": "accept_untrusted=True",
}


def in_python(words: str) -> str:
    """A message of the command with the names that its flags have here."""
    for flag, argument in _ARGUMENTS.items():
        words = re.sub(rf"{flag}(?![\w-])", argument, words)
    words = words.replace("raceway new:", "Model.new():").replace("For --columns FILE", "For the argument columns of Record")
    return re.sub(r"raceway check MODEL .* --suggest-columns", "Model.suggest_columns(record)", words)

"""Errors and warnings of the package."""

from __future__ import annotations

import re

from ._note import Note


class InputError(ValueError):
    """Error for an invalid input. The message is the message of the command, with the names of arguments in place of flags.

    Attributes
    ----------
    file : str or None
        File with the invalid input.
    line : int or None
        Line of the file. The first line is 1.
    key : str or None
        Key of a model, column of a record, or argument with the invalid input.
    """

    file: str | None = None
    line: int | None = None
    key: str | None = None


class NotConverged(RuntimeError):
    """Error for a fit that did not converge, or for a required state without equilibrium."""


class Doubt(UserWarning):
    """Warning about a reason to doubt a result. The command prints the same text after ``warning:``.

    Attributes
    ----------
    note : Note
        Text of the warning, with its kind and code, and the file, line and key that it is about.
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
    """Return a message of the command with the names of Python arguments in place of flags."""
    for flag, argument in _ARGUMENTS.items():
        words = re.sub(rf"{flag}(?![\w-])", argument, words)
    words = words.replace("raceway new:", "Model.new():").replace("For --columns FILE", "For the argument columns of Record")
    return re.sub(r"raceway check MODEL .* --suggest-columns", "Model.suggest_columns(record)", words)

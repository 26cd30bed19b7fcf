"""What can be wrong with a question."""

from __future__ import annotations


class InputError(ValueError):
    """Something that was entered is wrong; the message is that of the command, complete.

    Attributes
    ----------
    file : str or None
        Where it stands.
    line : int or None
        Of the file, from 1.
    key : str or None
        Key of a model, column of a record, or argument.
    """

    file: str | None = None
    line: int | None = None
    key: str | None = None


class NotConverged(RuntimeError):
    """A fit that found no values, or a state without balance where one was needed."""


class Doubt(UserWarning):
    """What makes a result doubtful; the command says it behind ``warning:``."""

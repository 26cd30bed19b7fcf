"""Notes on a model or a result."""

from __future__ import annotations


class Note(str):
    """One line of `notes`, or the text of a `Doubt`. A note is a str whose attributes describe the subject of the note.

    Attributes
    ----------
    kind : str
        ``"note"`` (information), ``"doubt"`` (an input is possibly wrong) or ``"warning"`` (the result is doubtful).
    code : str
        Code of the subject, such as ``"left-out"``, ``"unit"`` or ``"at-bound"``. The documentation lists all codes.
        The text can change in later versions. The code does not change.
    file : str or None
        File that the note is about.
    line : int or None
        Line of the file, counted from 1.
    key : str or None
        Key of a model, column of a record, parameter or argument that the note is about.
    """

    kind: str
    code: str
    file: str | None
    line: int | None
    key: str | None

    def __new__(cls, text: str, kind: str = "note", code: str = "", file: str | None = None, line: int | None = None, key: str | None = None) -> Note:
        note = super().__new__(cls, text)
        note.kind, note.code, note.file, note.line, note.key = kind, code, file, line, key
        return note

"""Notes that come with an answer."""

from __future__ import annotations


class Note(str):
    """A line of `notes` or the text of a `Doubt`: a str with attributes that say what it is about.

    Attributes
    ----------
    kind : str
        ``"note"`` (good to know), ``"doubt"`` (an input that may be wrong) or ``"warning"`` (makes a result doubtful).
    code : str
        Subject from the documentation: ``"left-out"``, ``"unit"``, ``"at-bound"`` ... The text may change; the
        code does not.
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

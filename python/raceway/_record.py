"""Records of measurements."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import ArrayLike

from . import _engine
from ._errors import InputError

if TYPE_CHECKING:
    import pandas


class Record:
    """Measurements from a CSV file, a DataFrame or arrays. Each row contains settings and readings.

    The name of a column gives its meaning and unit (``speed_rpm``, ``friction_torque_Nm``). If the columns have other
    names, such as ``Drehzahl [1/min]``, the argument `columns` maps them to the names of raceway. `Model.suggest_columns`
    proposes this map. The program checks the contents of a record when a model uses it, because the model determines
    the measured columns and the optional columns.

    Parameters
    ----------
    name : str
        Name of the record in messages.
    text : str
        CSV text with a header, in any format that the command accepts.
    columns : mapping of str to str, float or sequence of str, or str, optional
        Map from raceway column names to the column names in the file, such as ``{"friction_torque_Nm": "Moment"}``; a
        number is the value of all rows, and of several names the file needs one. Or
        the text of a ``[columns]`` table, such as the result of `Model.suggest_columns`.
    drop_nan : bool
        True omits rows without a number in a column that the model uses.

    Examples
    --------
    >>> import pandas
    >>> frame = pandas.DataFrame({"n": [0.0, 3000.0], "M": [0.01, 0.21]})
    >>> record = Record.from_pandas(frame, columns={"speed_rpm": "n", "friction_torque_Nm": "M"})
    >>> print(record.text)
    n,M
    0.0,0.01
    3000.0,0.21
    <BLANKLINE>
    """

    def __init__(
        self, name: str, text: str, *, columns: Mapping[str, str | float | Sequence[str]] | str | None = None, drop_nan: bool = False
    ) -> None:
        if not isinstance(text, str):
            raise TypeError(f"text: must be a str with the content of a CSV file, not {type(text).__name__}")
        self._name = str(name)
        self._own: str | dict[str, numpy.ndarray | list[str]] = text
        self._data = _engine.Data(self._name, text=text)
        self._columns = _column_map(columns)
        self._drop_nan = bool(drop_nan)
        self._others: tuple[Record, ...] = ()

    @classmethod
    def _of(
        cls, name: str, own: dict[str, numpy.ndarray | list[str]], columns: Mapping[str, str | float | Sequence[str]] | str | None, drop_nan: bool
    ) -> Record:
        record = cls.__new__(cls)
        record.__setstate__((str(name), own, _column_map(columns), bool(drop_nan), ()))
        return record

    def __getstate__(self) -> tuple[Any, ...]:
        return self._name, self._own, self._columns, self._drop_nan, self._others

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        self._name, self._own, self._columns, self._drop_nan, self._others = state
        own = self._own
        self._data = _engine.Data(self._name, text=own) if isinstance(own, str) else _engine.Data(self._name, columns=own)
        if self._others:
            self._data = self._data.with_beside([other._data for other in self._others])

    def beside(self, *others: Record) -> Record:
        """Return this record over time, combined with other records of the same machine at the same time. Each record has its own `time_s`.

        At times between two rows, settings of a control keep their last value, and temperatures are interpolated
        linearly. The `notes` of a result report this. All records use the map of columns of this record.

        Examples
        --------
        >>> temperatures = Record.from_arrays({"time_s": [0.0, 60.0], "room_temperature_C": [20.0, 20.1]})
        >>> probe = Record.from_arrays({"time_s": [0.0, 25.0], "displacement_z_um": [0.0, 0.4]})
        >>> both = temperatures.beside(probe)
        """
        for other in others:
            if not isinstance(other, Record):
                raise TypeError(f"must be a raceway.Record, not {type(other).__name__}")
        record = Record.__new__(Record)
        record.__setstate__((self._name, self._own, self._columns, self._drop_nan, (*self._others, *others)))
        return record

    @classmethod
    def read(
        cls, path: str | os.PathLike[str], *, columns: Mapping[str, str | float | Sequence[str]] | str | None = None, drop_nan: bool = False
    ) -> Record:
        """Read a CSV file.

        Raises
        ------
        InputError
            The file cannot be read. The contents are checked later, when a model uses the record.
        """
        return cls(os.fspath(path), _engine.read_text(os.fspath(path)), columns=columns, drop_nan=drop_nan)

    @classmethod
    def from_pandas(
        cls,
        frame: pandas.DataFrame,
        *,
        columns: Mapping[str, str | float | Sequence[str]] | str | None = None,
        name: str = "DataFrame",
        drop_nan: bool = False,
    ) -> Record:
        """Create a record from the columns of a DataFrame. The index is not used.

        Parameters
        ----------
        frame : pandas.DataFrame
            One row per reading, with NaN for a missing reading.
        columns : mapping of str to str, float or sequence of str, optional
            Map from names of raceway, which give the unit of the numbers, to names of the frame.
        name : str
            Name of the record in messages.
        drop_nan : bool
            True omits rows without a number in a column that the model uses.

        Raises
        ------
        TypeError
            `frame` is not a DataFrame.
        InputError
            The DataFrame has no rows, or two columns have the same name.
        """
        import pandas

        if not isinstance(frame, pandas.DataFrame):
            raise TypeError(f"must be a pandas.DataFrame, not {type(frame).__name__}; " "for the path of a CSV file, use Record.read()")
        if frame.empty:
            raise InputError(f"{name}: the DataFrame has no rows")
        twice = frame.columns[frame.columns.duplicated()]
        if len(twice) > 0:
            raise InputError(f"{name}: two columns are named {twice[0]}")
        _refuse_decimal_commas(frame, name)
        return cls._of(name, {str(column): _frame_column(frame[column]) for column in frame}, columns, drop_nan)

    @classmethod
    def from_arrays(
        cls,
        arrays: Mapping[str, ArrayLike | Sequence[str]],
        *,
        columns: Mapping[str, str | float | Sequence[str]] | str | None = None,
        name: str = "arrays",
        drop_nan: bool = False,
    ) -> Record:
        """Create a record from arrays of equal length. The keys of the mapping are the names of the columns.

        Parameters
        ----------
        arrays : mapping of str to array
            Arrays of numbers. NaN or a mask marks missing readings. `run_id` and dates are arrays of text.
        columns, name, drop_nan
            These arguments have the same meaning as in `from_pandas`.

        Raises
        ------
        InputError
            There are no arrays, or their lengths differ.

        Examples
        --------
        >>> record = Record.from_arrays({"speed_rpm": numpy.array([0.0, 3000.0]), "friction_torque_Nm": [0.01, 0.21]})
        """
        own = {str(column): _array_column(str(column), values) for column, values in arrays.items()}
        lengths = {len(values) for values in own.values()}
        if len(lengths) != 1:
            raise InputError(f"{name}: the arrays must have equal lengths, but the lengths are {sorted(lengths)}")
        return cls._of(name, own, columns, drop_nan)

    @property
    def name(self) -> str:
        """Path of the file, or name of the record."""
        return self._name

    @property
    def text(self) -> str:
        """Text of the record as CSV."""
        if isinstance(self._own, str):
            return self._own
        import pandas

        return pandas.DataFrame(self._own).to_csv(index=False)

    def to_frame(self) -> pandas.DataFrame:
        """Return the columns with the names and units of the file.

        The frame does not contain title lines and a row of units. A cell without a number, such as ``#NV``, is NaN.
        `Model.predict` returns the recognized columns with the names of raceway.
        """
        import io

        import pandas

        return pandas.read_csv(io.StringIO(_engine.plain_csv(self._name, self.text)))

    def __repr__(self) -> str:
        return f"<raceway.Record {self._name}>"


def _numbers(values: numpy.ndarray) -> numpy.ndarray:
    """Return a copy as float64. The conversion of a single-precision number keeps its decimal digits, such as 0.1."""
    if values.dtype in (numpy.float32, numpy.float16):
        return numpy.array([float(str(value)) for value in values])
    return numpy.array(values)


def _array_column(name: str, values: ArrayLike | Sequence[str]) -> numpy.ndarray | list[str]:
    array = values if isinstance(values, numpy.ma.MaskedArray) else numpy.asarray(values)
    if array.ndim != 1:
        raise ValueError(f"{name}: must be a list of numbers, not an array of shape {array.shape}")
    if isinstance(array, numpy.ma.MaskedArray):
        array = numpy.ma.filled(array.astype(numpy.float64), numpy.nan)
    return _numbers(array) if array.dtype.kind in "fiu" else _texts(array.tolist() if array.dtype.kind != "M" else array.astype(str).tolist())


def _frame_column(series: pandas.Series[Any]) -> numpy.ndarray | list[str]:
    from pandas.api.types import is_bool_dtype, is_complex_dtype, is_integer_dtype, is_numeric_dtype

    if is_numeric_dtype(series) and not is_bool_dtype(series) and not is_complex_dtype(series):
        if isinstance(series.dtype, numpy.dtype):
            return _numbers(series.to_numpy())
        if is_integer_dtype(series) and not series.hasnans:
            return series.to_numpy(dtype=numpy.int64)
        return series.to_numpy(dtype=numpy.float64, na_value=numpy.nan)
    return _texts(series.where(series.notna(), None).astype(object).tolist())


def _texts(values: Sequence[Any]) -> list[str]:
    return ["" if value is None or value != value else str(value).strip() for value in values]


def _refuse_decimal_commas(frame: pandas.DataFrame, name: str) -> None:
    """Raise InputError for numbers that pandas has read as text because of a decimal comma."""
    from pandas.api.types import is_string_dtype

    for column in frame.columns:
        if not is_string_dtype(frame[column]):
            continue
        cells = frame[column].dropna().astype(str)
        commas = cells[cells.str.contains(",")]
        if len(commas) > 0 and cells.str.fullmatch(r"[+-]?\d+(,\d+)?").all():
            raise InputError(
                f'{name}: {column} has text with a decimal comma, such as "{commas.iloc[0]}"; ' 'use pandas.read_csv(path, sep=";", decimal=",")'
            )


def _column_map(columns: Mapping[str, str | float | Sequence[str]] | str | None) -> str | None:
    """Return the map as the text of a table [columns]. The library reads this text and checks it."""
    if columns is None or isinstance(columns, str):
        return columns
    if not isinstance(columns, Mapping):
        raise TypeError(
            "columns: must be a dict from the names of raceway to the names in your data, such as "
            f'{{"friction_torque_Nm": "Moment"}}, not {type(columns).__name__}'
        )
    lines = ["[columns]"]
    for ours, theirs in columns.items():
        if isinstance(theirs, (list, tuple)) and theirs and all(isinstance(one, str) for one in theirs):
            lines.append(f"{json.dumps(str(ours))} = {json.dumps(list(theirs))}")
            continue
        if isinstance(theirs, bool) or not isinstance(theirs, (str, Real)):
            raise TypeError(
                f"columns: {ours} must be the name of a column in your data, a list of such names, or one number for all rows, "
                f"not {type(theirs).__name__}"
            )
        # A JSON string is also a valid TOML string.
        value = json.dumps(theirs) if isinstance(theirs, str) else repr(float(theirs))
        lines.append(f"{json.dumps(str(ours))} = {value}")
    return "\n".join(lines) + "\n"

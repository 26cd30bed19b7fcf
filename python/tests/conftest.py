"""Real documents for the tests: made by the command, named in the environment variable
RACEWAY_PROGRAM, from the data of this repository."""

from __future__ import annotations

import io
import json
import os
import subprocess
from pathlib import Path
from typing import Any, Callable, Iterator

import matplotlib
import pandas as pd
import pytest

ROOT = Path(__file__).resolve().parents[2]
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

RIG = "tests/hidden_effect/rigs/dev-03"
KINDS = ("Solution", "Table", "Displacement", "Comparison", "Calibration", "Diagnosis", "Addition", "Modes")


class Plain:
    """A result as the functions of this package see it: a document and its rows."""

    def __init__(self, data: dict[str, Any], frame: pd.DataFrame | None = None):
        self.data = data
        self.unit = data.get("unit")
        self._frame = frame

    def to_frame(self) -> pd.DataFrame:
        assert self._frame is not None
        return self._frame


CLASSES = {name: type(name, (Plain,), {}) for name in KINDS}


@pytest.fixture(scope="session")
def make() -> Callable[..., Any]:
    """make("Table", document, frame): a result of that class."""
    return lambda kind, data, frame=None: CLASSES[kind](data, frame)


@pytest.fixture(autouse=True)
def no_figures_left() -> Iterator[None]:
    yield
    pyplot.close("all")


@pytest.fixture(scope="session")
def root() -> Path:
    """The top folder of the project."""
    return ROOT


@pytest.fixture(scope="session")
def program() -> str:
    name = os.environ.get("RACEWAY_PROGRAM", "")
    if not name:
        pytest.fail("RACEWAY_PROGRAM is not set: it names the raceway command that these tests run")
    path = Path(name).resolve()
    if not os.access(path, os.X_OK):
        pytest.fail(f"RACEWAY_PROGRAM = {name}: no program")
    return str(path)


@pytest.fixture(scope="session")
def run(program: str) -> Callable[..., str]:
    """Standard output of the command, run at the top of the repository."""
    kept: dict[tuple[str, ...], str] = {}

    def call(*arguments: str) -> str:
        if arguments not in kept:
            done = subprocess.run([program, *arguments], cwd=ROOT, capture_output=True, text=True)
            assert done.returncode == 0, done.stderr + done.stdout
            kept[arguments] = done.stdout
        return kept[arguments]

    return call


@pytest.fixture(scope="session")
def document(run: Callable[..., str]) -> Callable[..., dict[str, Any]]:
    """Document that the command prints; a new one for each call, which a test may change."""
    return lambda *arguments: json.loads(run(*arguments, "--json"))


@pytest.fixture(scope="session")
def csv(run: Callable[..., str]) -> Callable[..., pd.DataFrame]:
    """Rows that the command writes as CSV."""
    return lambda *arguments: pd.read_csv(io.StringIO(run(*arguments, "-o", "-")), comment="#")


@pytest.fixture(scope="session")
def train() -> pd.DataFrame:
    """The record of the rig."""
    return pd.read_csv(ROOT / RIG / "train.csv")


@pytest.fixture
def table(make, document, csv):
    arguments = ("table", "data/examples/7014.toml", "--speed", "0:12000:2000", "--axial-load", "100,300,900")
    return make("Table", document(*arguments), csv(*arguments, "--format", "plain"))


@pytest.fixture
def comparison(make, document, train):
    """With its worst rows, of which the document has all numbers, and their settings."""
    data = document("compare", f"{RIG}/model.toml", f"{RIG}/train.csv")
    worst = pd.DataFrame(data["worst_rows"])
    # Line 1 of the file is the header.
    rows = train.iloc[worst["line"] - 2].reset_index(drop=True)
    rows = rows.assign(measured=worst["measured"], predicted=worst["predicted"], error=worst["residual"])
    return make("Comparison", data, rows)


@pytest.fixture
def calibration(make, document):
    return make("Calibration", document("calibrate", f"{RIG}/model.toml", f"{RIG}/train.csv"))


@pytest.fixture
def diagnosis(make, document):
    return make("Diagnosis", document("diagnose", f"{RIG}/model.toml", f"{RIG}/train.csv"))


@pytest.fixture
def ambiguous(make, document):
    rig = "tests/hidden_effect/rigs/real-04"
    return make("Diagnosis", document("diagnose", f"{rig}/model.toml", f"{rig}/train.csv"))


@pytest.fixture
def addition(make, document):
    return make("Addition", document("add", f"{RIG}/model.toml", "lubricant-drag", "--data", f"{RIG}/train.csv"))


@pytest.fixture
def displacement(make, document, csv):
    arguments = ("displacement", "data/spindles/published_curve.toml", "--speed", "0:10000:2500")
    return make("Displacement", document(*arguments), csv(*arguments))


@pytest.fixture
def modes(make, document):
    return make("Modes", document("modes", "data/spindles/small.toml", "--speed", "0:20000:5000"))

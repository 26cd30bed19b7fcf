"""Where things stand; the command is given by the environment."""

import os
import pathlib

import pytest


@pytest.fixture(scope="session")
def root() -> pathlib.Path:
    """Return the top folder of the project."""
    return pathlib.Path(__file__).parents[2]


@pytest.fixture(scope="session")
def program() -> str:
    """Return the command, with which Python must agree."""
    assert "RACEWAY_PROGRAM" in os.environ, "RACEWAY_PROGRAM must name the command raceway"
    return os.environ["RACEWAY_PROGRAM"]

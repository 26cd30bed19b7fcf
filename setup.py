"""Builds the engine of the Python package and the command `raceway` with CMake; the rest is in pyproject.toml."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class Engine(build_ext):
    def build_extension(self, ext: Extension) -> None:
        # RACEWAY_BUILD=build/release pip install . uses a tree that is built already.
        tree = Path(os.environ.get("RACEWAY_BUILD") or self.build_temp).resolve()
        if not (tree / "CMakeCache.txt").exists():
            report = shutil.which("npm") is not None  # else without the pages of reports
            subprocess.run(
                [
                    "cmake",
                    "-S",
                    ROOT,
                    "-B",
                    tree,
                    "-G",
                    "Ninja",
                    "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_UNITY_BUILD=ON",
                    "-DRACEWAY_PYTHON=ON",
                    "-DRACEWAY_BUILD_CLI=ON",
                    "-DRACEWAY_C=OFF",
                    "-DRACEWAY_BUILD_BENCH=OFF",
                    f"-DRACEWAY_REPORT={'ON' if report else 'OFF'}",
                    f"-DPython_EXECUTABLE={sys.executable}",
                ],
                check=True,
            )
        subprocess.run(["cmake", "--build", tree, "--target", "engine", "raceway"], check=True)
        (built,) = (tree / "python/raceway").glob("_engine.*.so")
        place = Path(self.get_ext_fullpath(ext.name))
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(built, place)
        # bin/ of the environment: the command finds the data in share/raceway beside it.
        self.distribution.data_files.append(("bin", [str(tree / "raceway")]))


def data_files() -> list[tuple[str, list[str]]]:
    """The data of the project below share/raceway, where the engine looks for its catalogue."""
    folders: dict[str, list[str]] = {}
    for file in sorted((ROOT / "data").rglob("*")):
        if file.is_file():
            path = file.relative_to(ROOT)
            folders.setdefault(str("share/raceway" / path.parent.relative_to("data")), []).append(str(path))
    # The page of `raceway workbench`, where scripts/workbench has made it.
    page = Path("build/share/raceway/workbench.html")
    if (ROOT / page).is_file():
        folders.setdefault("share/raceway", []).append(str(page))
    return list(folders.items())


version = re.search(r"project\(raceway VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
assert version is not None
setup(version=version[1], ext_modules=[Extension("raceway._engine", [])], cmdclass={"build_ext": Engine}, data_files=data_files())

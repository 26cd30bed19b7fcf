"""Executes every notebook of examples/ from nothing, for scripts/notebooks.

Fails on an error, on words on stderr and on a cell that does not end. A cell with the tag `doubt` must
warn of a raceway.Doubt, and of nothing else. What came out is the notebook with its outputs, a
page of it and a picture per figure.
"""

import base64
import os
import re
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError
from nbconvert import HTMLExporter

CELL_LIMIT = 60  # s, of which none needs ten
# A warning as Python prints it: place, kind and words, then the line of code.
WARNING = re.compile(r"^\S+:\d+: (\w+): .*\n(?:  .*\n?)?", re.M)


def complaints(cell):
    """What is wrong with what a cell said on stderr."""
    stderr = "".join(o["text"] for o in cell.get("outputs", []) if o["output_type"] == "stream" and o["name"] == "stderr")
    expected = "doubt" in cell["metadata"].get("tags", [])
    kinds = WARNING.findall(stderr)
    rest = WARNING.sub("", stderr).strip()
    if rest or any(kind != "Doubt" for kind in kinds) or (kinds and not expected):
        return f"unexpected on stderr:\n{stderr}"
    if expected and not kinds:
        return "has the tag doubt and warns of nothing"
    return ""


def pictures(notebook):
    """Every PNG of the outputs, in their order."""
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            if "image/png" in output.get("data", {}):
                yield base64.b64decode(output["data"]["image/png"])


def executed(path, folder):
    """Runs one; returns what is wrong."""
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    client = NotebookClient(notebook, timeout=CELL_LIMIT, kernel_name="python3", resources={"metadata": {"path": str(path.parent)}})
    wrong = []
    begin = time.perf_counter()
    try:
        client.execute()
    except CellExecutionError as error:
        cell = max((c for c in notebook.cells if c.get("execution_count")), key=lambda c: c["execution_count"])
        wrong.append(f"{error.ename}: {error.evalue}\n{cell.source}")
    except (CellTimeoutError, DeadKernelError) as error:
        wrong.append(str(error))
    took = time.perf_counter() - begin
    for number, cell in enumerate(notebook.cells, 1):
        if not wrong and cell.cell_type == "code" and (said := complaints(cell)):
            wrong.append(f"cell {number}: {said}\n{cell.source}")
    nbformat.write(notebook, folder / path.name)
    # Nothing of a network; links as from build/notebooks.
    page, _ = HTMLExporter(require_js_url="", mathjax_url="").from_notebook_node(notebook)
    page = page.replace('<script src=""></script>', "").replace('href="../', 'href="../../').replace('.ipynb"', '.html"')
    (folder / f"{path.stem}.html").write_text(page, encoding="utf-8")
    count = 0
    for count, picture in enumerate(pictures(notebook), 1):
        (folder / f"{path.stem}-{count}.png").write_bytes(picture)
    print(f"{path.name}: {took:.1f} s, {count} pictures" + (", FAILED" if wrong else ""), flush=True)
    return [f"{path.name}: {words}" for words in wrong]


def main():
    examples, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for old in [*folder.glob("*.html"), *folder.glob("*.png"), *folder.glob("*.ipynb")]:
        old.unlink()
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # a debugger's word on stderr
    os.environ.pop("MPLBACKEND", None)  # pictures go into the notebook
    paths = sorted(examples.glob("*.ipynb"))
    wrong = [words for path in paths for words in executed(path, folder)]
    print(f"pages and pictures are in {folder}")
    if wrong or not paths:
        sys.exit("\n".join(wrong) or f"no notebooks in {examples}")


main()

"""The examples of docs/python.md and docs/scale.md print what they show."""

import contextlib
import io
import re
import warnings

import pytest

import raceway


def blocks(page):
    """Return pairs of Python code and the output that stands behind it."""
    return re.findall(r"```python\n(.*?)```\n\n```\n(.*?)```", page, re.S)


@pytest.mark.parametrize("name", ["docs/python.md", "docs/scale.md"])
def test_examples_print_what_they_show(name, root, tmp_path, monkeypatch):
    pages = blocks((root / name).read_text())
    assert pages
    for link in ("tests", "data"):
        (tmp_path / link).symlink_to(root / link)
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "__main__"}  # as a script
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", raceway.Doubt)
        for code, shown in pages:
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                exec(code, names)
            assert out.getvalue() == shown


def test_twelve_lines_lead_from_a_file_to_a_better_model(root):
    code, _ = blocks((root / "docs/python.md").read_text())[0]
    assert len(code.strip().splitlines()) <= 12

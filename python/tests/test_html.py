"""Notebook representations: the numbers of the documents, as text that stays text."""

from __future__ import annotations

import copy
import pathlib
import re
from html.parser import HTMLParser

import pandas as pd
import pytest

import raceway
from raceway._html import html_of

HOSTILE = "<script>alert('x')</script>\"&<img src=x onerror=y>"
EMPTY = {"rect", "line", "br", "img"}


class Tags(HTMLParser):
    """Tags and attributes of a page, and whether every one is closed."""

    def __init__(self, page: str):
        super().__init__()
        self.tags: list[str] = []
        self.attributes: list[tuple[str, str | None]] = []
        self.words: list[str] = []
        self._open: list[str] = []
        self.feed(page)
        assert self._open == []

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += attributes
        if tag not in EMPTY:
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += attributes

    def handle_endtag(self, tag):
        assert self._open.pop() == tag

    def handle_data(self, data):
        self.words.append(data)

    @property
    def text(self) -> str:
        return " ".join(self.words)


def with_hostile_texts(value):
    """Every text of a document replaced, and every name of what it holds by name."""
    if isinstance(value, str):
        return HOSTILE
    if isinstance(value, list):
        return [with_hostile_texts(one) for one in value]
    if isinstance(value, dict):
        return {
            key: {HOSTILE: one for one in part.values()} if key == "parameters" else with_hostile_texts(part) if key != "unit" else part
            for key, part in value.items()
        }
    return value


@pytest.fixture
def results(table, displacement, modes, comparison, calibration, diagnosis, ambiguous, addition, csv, make, document):
    modes._frame = csv("modes", "data/spindles/small.toml", "--speed", "0:20000:5000")
    solution = make("Solution", document("solve", "data/examples/7014.toml", "--speed", "6000", "--axial-load", "300"))
    return [table, displacement, modes, comparison, calibration, diagnosis, ambiguous, addition, solution]


def test_pages_are_whole_and_ask_for_nothing(results):
    for result in results:
        page = Tags(html_of(result))
        assert not {"script", "link", "style", "img", "iframe", "object"} & set(page.tags)
        for name, value in page.attributes:
            assert not name.startswith("on") and name not in ("src", "href", "xlink:href")
            assert "url(" not in (value or "") and "http" not in (value or "")


def test_colours_are_those_of_the_page(results):
    for result in results:
        page = html_of(result)
        assert not re.search(r"#[0-9a-fA-F]{3,6}\b|rgb\(|\b(black|white)\b(?!-)", page)
        assert "color:inherit" in page


def test_hostile_names_stay_text(results, make):
    for result in results:
        data = with_hostile_texts(copy.deepcopy(result.data))
        frame = None
        if result._frame is not None:
            frame = result._frame.assign(status=HOSTILE).rename(columns={"axial_load_N": HOSTILE})
            frame = frame[["status", *[c for c in frame if c != "status"]]]
        page = Tags(html_of(make(type(result).__name__, data, frame)))
        assert "script" not in page.tags and "img" not in page.tags
        assert any("<script>" in words for words in page.words), type(result).__name__


def test_a_diagnosis_says_what_and_what_next(diagnosis, ambiguous):
    page = Tags(html_of(diagnosis)).text
    for words in (diagnosis.data["headline"], diagnosis.data["sentence"], "lubricant-drag", "44.9", "10.7", "65.11 ± 1.5 N mm", "1794", "10.4"):
        assert words in page
    assert "What to measure next" not in page
    page = Tags(html_of(ambiguous)).text
    assert "What to measure next" in page
    for point in ambiguous.data["suggested_measurements"]:
        assert point["separates"] in page
    for words in ambiguous.data["records_needed"]:
        assert words in page


def test_bars_are_as_long_as_the_errors(diagnosis):
    data = diagnosis.data
    bars = [float(w) for w in re.findall(r'<rect [^>]*width="([0-9.]+)"', html_of(diagnosis))]
    assert bars[1] / bars[0] == pytest.approx(data["rmse_after"] / data["rmse_before"], abs=1e-3)
    mark = float(re.search(r'<line x1="([0-9.]+)"', html_of(diagnosis)).group(1))
    assert mark / bars[0] == pytest.approx(data["noise"]["rms"] / data["rmse_before"], abs=1e-3)


def test_a_comparison_says_where_it_errs(comparison):
    page = Tags(html_of(comparison)).text
    worst = comparison.data["where"][0]
    assert f"{worst['variable']} {worst['from']:g} to {worst['to']:g} °C" in page
    assert comparison.data["statement"] in page and "74.4" in page


def test_several_models_and_several_columns_have_their_pages(make, document):
    data = document(
        "compare",
        "tests/hidden_effect/rigs/dev-03/model.toml",
        "tests/hidden_effect/rigs/dev-01/model.toml",
        "tests/hidden_effect/rigs/dev-03/train.csv",
    )
    page = Tags(html_of(make("Comparison", data))).text
    for model in data["models"]:
        assert model["model"] in page and f"{model['rmse']:.3g}" in page


def test_a_calibration_has_errors_and_correlation(calibration):
    page = Tags(html_of(calibration)).text
    for words in ("f0", "1.6785", "0.017", "-0.52", calibration.data["messages"][0]):
        assert words in page


def test_a_refused_addition_says_why(make, document, addition):
    data = document(
        "add", "tests/hidden_effect/rigs/dev-03/model.toml", "seal-friction", "--data", "tests/hidden_effect/rigs/dev-03/train.csv", "--force"
    )
    data.update(refused=True, reason="of no use")
    assert "refused:" in Tags(html_of(make("Addition", data))).text
    assert "refused" not in Tags(html_of(addition)).text


def test_a_table_shows_first_rows_and_a_count(table):
    page = Tags(html_of(table))
    assert page.tags.count("tr") == 7
    assert f"{len(table.to_frame())} rows, 18 columns" in page.text
    assert "Friction torque in N mm" in page.text


def test_every_measured_column_has_its_ladder(make, document):
    spindle = "data/spindles/seats"
    data = document("compare", f"{spindle}/model.toml", f"{spindle}/train.csv")
    page = Tags(html_of(make("Comparison", data))).text
    for part in data["channels"]:
        unit = {"C": "K", "um": "µm"}[part["unit"]]
        assert f"RMS error of {part['quantity'].replace('_', ' ')} in {unit}" in page
        assert f"{part['rmse']:.3g}" in page


def test_a_conformity_of_the_catalogue_is_shown(make, document):
    data = document("calibrate", "S 6014 C")
    page = Tags(html_of(make("Calibration", data))).text
    assert "0.5203 ± 0.00063" in page and data["bearing"] in page
    assert f"{data['classes'][0]['printed_N_um']:g}" in page


def test_anything_else_is_refused():
    with pytest.raises(TypeError, match="not 'DataFrame'"):
        html_of(pd.DataFrame())


def test_states_show_themselves():
    model = raceway.Model.new("S 6014 C")
    one, several = model.solve(6000, 300), model.solve([0, 6000], 300)
    assert "Friction torque" in Tags(one._repr_html_()).text
    assert "2 rows" in Tags(several._repr_html_()).text
    assert repr(one).startswith("<raceway.Solution of 1 state:")


def test_fits_say_what_they_found():
    rig = "tests/hidden_effect/rigs/dev-03"
    root = pathlib.Path(__file__).parents[2]
    model = raceway.Model.read(root / rig / "model.toml")
    record = raceway.Record.read(root / rig / "train.csv")
    added = model.add("lubricant-drag", record)
    size = added.model.parameters["lubricant-drag.torque_at_10000_rpm_Nmm"]["value"]
    assert repr(added).endswith(f"lubricant-drag.torque_at_10000_rpm_Nmm = {size:.4g}>")
    assert repr(model.add("cage-friction", record)).startswith("<raceway.Addition: refused, f0 = ")


def test_a_calibration_says_nothing_of_the_size_of_a_noise_that_its_document_lacks(calibration):
    assert "rms" not in calibration.data["noise"] and "not known" not in html_of(calibration)


def test_a_gain_of_rounding_is_none(diagnosis):
    diagnosis.data["effects"][-1] |= {"in_verdict": True, "gain": 4.6e-10}
    diagnosis.data["effects"].insert(0, diagnosis.data["effects"].pop())
    assert "e-10" not in html_of(diagnosis)

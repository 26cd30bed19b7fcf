"""Effects of the user's own as functions of Python."""

import numpy
import pytest

import raceway
from raceway import Effect, Number

RIG = "tests/hidden_effect/rigs/dev-03"
FORMULA = """
[[effect]]
id = "fan"
torque_Nmm = "c * (speed_rpm / 1000)^2 * (axial_load_N / 1000)^p"
c = { value = 0.0, unit = "N mm", lower = 0.0 }
p = { value = 0.1, lower = 0.0, upper = 1.0 }
"""


def fan(state, c, p):
    """Drag of a fan."""
    return c * (state.speed_rpm / 1000) ** 2 * (state.axial_load_N / 1000) ** p


NUMBERS = {"c": Number(0.0, "N mm", lower=0.0), "p": {"value": 0.1, "lower": 0.0, "upper": 1.0}}


@pytest.fixture
def model(root):
    return raceway.Model.read(root / RIG / "model.toml")


@pytest.fixture
def train(root):
    return raceway.Record.read(root / RIG / "train.csv")


@pytest.mark.filterwarnings("ignore::raceway.Doubt")
def test_a_function_is_fitted_as_the_same_formula_is(model, train):
    by_function = model.with_effect(Effect("fan", fan, NUMBERS)).add("fan", train)
    by_formula = raceway.Model.from_text(model.text + FORMULA, model.source).add("fan", train)
    assert by_function.data["after"]["rmse"] == pytest.approx(by_formula.data["after"]["rmse"], rel=1e-9)
    for name in ("f0", "z", "fan.c", "fan.p"):
        found, expected = (a.model.parameters[name]["value"] for a in (by_function, by_formula))
        assert found == pytest.approx(expected, rel=1e-6), name
    assert by_function.model.effects[0].numbers["c"].value == by_function.model.parameters["fan.c"]["value"]


@pytest.mark.filterwarnings("ignore::raceway.Doubt")
def test_a_fitted_function_predicts(model, train, root):
    test = raceway.Record.read(root / RIG / "test.csv")
    better = model.with_effect(Effect("fan", fan, NUMBERS)).add("fan", train).model
    assert better.compare(test).rmse < 0.3 * model.compare(test).rmse
    without = raceway.Model.from_text(better.text, "without")
    speed, load = numpy.array([2000.0, 9000.0]), 600.0
    added = better.solve(speed, load).friction_torque_Nmm - without.solve(speed, load).friction_torque_Nmm
    numbers = {name: n.value for name, n in better.effects[0].numbers.items()}
    assert added == pytest.approx(numbers["c"] * (speed / 1000) ** 2 * 0.6 ** numbers["p"], rel=1e-9)


@pytest.mark.filterwarnings("ignore::raceway.Doubt")
def test_a_diagnosis_tries_it(model, train):
    found = model.with_effect(Effect("fan", lambda s, c: c * (s.speed_rpm / 1000) ** 2, {"c": 0.0})).diagnose(train)
    assert "fan" in [effect["id"] for effect in found.data["effects"]]


def test_a_function_sees_all_rows_at_once(model, train):
    seen = []

    def count(state, c):
        seen.append(len(state.speed_rpm))
        return 0.0 * state.speed_rpm + c

    model.with_effect(Effect("count", count, {"c": 1.0})).predict(train)
    # Questions about units look at 80 of the rows; threads may ask before the first answer is there.
    of_all = [rows for rows in seen if rows == len(train.to_frame())]
    assert set(seen) <= {80, len(train.to_frame())}
    assert 0 < len(of_all) <= 4


def test_what_was_measured_is_not_shown(model, train):
    def cheat(state, c):
        return c * state.friction_torque_Nmm

    with pytest.raises(AttributeError, match="no such column in the record; the columns are speed_rpm"):
        model.with_effect(Effect("cheat", cheat, {"c": 1.0})).predict(train)


@pytest.mark.parametrize(
    ("torque", "words"),
    [
        (lambda state, c: state.speed_rpm[:3], r"effect odd: torque\(state\) must give a number for each of 120 rows, not .* shape \(3,\)"),
        (lambda state, c: ["a"] * len(state.speed_rpm), "must give a number"),
        (lambda state, c: None, "must give a number"),
    ],
)
def test_wrong_answers(model, train, torque, words):
    with pytest.raises(raceway.InputError, match=words):
        model.with_effect(Effect("odd", torque, {"c": 1.0})).predict(train)


def test_what_a_function_raises_comes_through(model, train):
    def broken(state, c):
        raise ZeroDivisionError("by whom")

    with pytest.raises(ZeroDivisionError, match="by whom"):
        model.with_effect(Effect("broken", broken, {"c": 1.0})).predict(train)


def test_names(model):
    with pytest.raises(raceway.InputError, match="must be a name"):
        Effect("a b", fan, NUMBERS)
    with pytest.raises(raceway.InputError, match="windage: an effect already has this name"):
        model.with_effect(Effect("windage", fan, NUMBERS))
    with pytest.raises(TypeError, match="must be a raceway.Effect"):
        model.with_effect("fan")
    with pytest.raises(ValueError, match="at least one number"):
        Effect("fan", fan, {})

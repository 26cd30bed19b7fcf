"""How sure a prediction is, as far as fitted parameters go."""

import tomllib
import warnings

import numpy
import pytest

import raceway

RIG = "tests/hidden_effect/rigs/dev-03"


@pytest.fixture(autouse=True)
def in_root(root, monkeypatch):
    monkeypatch.chdir(root)
    warnings.simplefilter("ignore", raceway.Doubt)


@pytest.fixture
def record():
    return raceway.Record.read(f"{RIG}/train.csv")


@pytest.fixture
def fitted(record):
    return raceway.Model.read(f"{RIG}/model.toml").calibrate(record).model


def half_width(model, values_of):
    """1.96 sqrt(g' C g) by differences of models that are written anew, C from the text of the model."""
    fit = tomllib.loads(model.text)["calibration"]["covariance"]
    std = numpy.array(fit["std"])
    lower = numpy.array([row + [0.0] * (len(std) - len(row)) for row in fit["correlation"]])
    correlation = lower + numpy.tril(lower, -1).T
    slopes = []
    for name, value, step in zip(fit["parameters"], fit["values"], std):
        up, down = (values_of(model.with_values({name: value + s * step})) for s in (0.2, -0.2))
        slopes.append((up - down) / (0.4 * step))
    g = numpy.array(slopes)
    covariance = correlation * numpy.outer(std, std)
    return 1.959963985 * numpy.sqrt(numpy.einsum("i...,ij,j...->...", g, covariance, g))


def test_one_state_is_that_of_the_command(fitted, document, tmp_path):
    path = tmp_path / "fitted.toml"
    fitted.save(path)
    state = fitted.solve(8000, 300, band=True)
    expected = document("solve", str(path), "--speed", "8000", "--axial-load", "300", "--band")
    assert state.data == expected
    assert float(state.friction_torque_band_Nmm) == expected["friction_torque_band_Nmm"]
    assert state.notes[0] == "band: 95 % band from the uncertainty of the fitted f0 and z only; it does not include missing effects or noise"


def test_many_states_and_a_table_have_the_band_of_each(fitted):
    speeds, loads = [1000.0, 8000.0], [100.0, 300.0, 900.0]
    expected = half_width(fitted, lambda m: m.solve(speeds, numpy.array(loads)[:, None]).friction_torque_Nmm)
    states = fitted.solve(speeds, numpy.array(loads)[:, None], band=True)
    assert states.friction_torque_band_Nmm == pytest.approx(expected, rel=1e-6)
    assert list(fitted.solve(speeds, 100, columns=["power_loss_W"], band=True)) == ["power_loss_W", "friction_torque_band_Nmm", "power_loss_band_W"]
    table = fitted.table(speeds, loads, band=True)
    assert table.to_frame().friction_torque_band_Nmm.to_numpy().reshape(3, 2) == pytest.approx(expected, rel=1e-6)
    assert table.data["band"] == {"level": 0.95, "parameters": ["f0", "z"]}
    assert "friction_torque_band_Nmm" not in fitted.table(speeds, loads).to_frame()


def test_a_record_has_the_band_of_its_readings(fitted, record):
    frame = fitted.predict(record, band=True)
    expected = half_width(fitted, lambda m: m.predict(record).predicted_friction_torque_Nmm.to_numpy())
    assert frame.predicted_friction_torque_band_Nmm.to_numpy() == pytest.approx(expected, rel=1e-6)


def test_a_shaft_has_the_band_of_its_displacement():
    text = raceway.Model.read("data/spindles/published_curve.toml").text
    model = raceway.Model.from_text(
        text
        + """
[calibration.covariance]
parameters = ["preload_N"]
units = ["N"]
values = [300.0]
std = [10.0]
correlation = [[1.0]]
"""
    )
    preload = model.parameters["preload_N"]["value"]
    model = raceway.Model.from_text(model.text.replace("values = [300.0]", f"values = [{preload!r}]"))
    speeds = [4000.0, 12000.0]
    expected = half_width(model, lambda m: m.displacement(speeds).to_frame().axial_displacement_um.to_numpy())
    curve = model.displacement(speeds, band=True).to_frame()
    assert curve.axial_displacement_band_um.to_numpy() == pytest.approx(expected, rel=1e-3)
    assert model.solve(speeds, band=True).axial_displacement_band_um == pytest.approx(expected, rel=1e-3)


def test_a_model_that_nobody_fitted_has_none(record):
    model = raceway.Model.new("S 6014 C")
    for ask in (
        lambda: model.solve(1000, 100, band=True),
        lambda: model.solve([1000, 2000], 100, band=True),
        lambda: model.table([0, 1000], 100, band=True),
    ):
        with pytest.raises(raceway.InputError, match=r"band: S 6014 C has no \[calibration.covariance\]"):
            ask()

"""Which datum of a model matters: the same as the command says, in pandas and in words."""

import warnings

import pytest

import raceway

RIG = "tests/hidden_effect/rigs/dev-03/model.toml"


@pytest.fixture(autouse=True)
def in_root(root, monkeypatch):
    monkeypatch.chdir(root)
    warnings.simplefilter("ignore", raceway.Doubt)


@pytest.fixture
def model():
    return raceway.Model.read(RIG)


def test_the_document_is_that_of_the_command(model, document):
    found = model.sensitivity([4000, 8000], 300, of=["torque", "stiffness"], spread={"ball_diameter_mm": 0.01, "viscosity_40C_mm2_s": "10%"})
    assert found.data == document(
        "sensitivity",
        RIG,
        "--speed",
        "4000,8000",
        "--axial-load",
        "300",
        "--of",
        "torque,stiffness",
        "--spread",
        "ball_diameter_mm=0.01,viscosity_40C_mm2_s=10%",
    )


def test_indices_are_those_of_the_command(model, document):
    found = model.sensitivity(8000, 300, data="friction,lubricant", samples=256, seed=3)
    assert found.data == document(
        "sensitivity", RIG, "--speed", "8000", "--axial-load", "300", "--data", "friction,lubricant", "--global", "256", "--seed", "3"
    )
    frame = found.to_frame().set_index("datum")
    assert frame["total"].idxmax() == frame["share"].idxmax()
    # Nearly linear over 1 %: the shares of the derivatives are those of the variance.
    assert (frame["total"] - frame["share"]).abs().max() < 0.02


def test_derivatives_are_differences_of_models(model):
    frame = model.sensitivity(8000, 300, of="torque").to_frame().set_index("datum")
    for name, step in (("friction.f0", 1e-3), ("lubricant.viscosity_40C_mm2_s", 1e-2), ("bearing.pitch_diameter_mm", 1e-2)):
        value = frame["value"][name]
        up, down = (float(model.with_values({name: value + s}).solve(8000, 300).friction_torque_Nmm) for s in (step, -step))
        assert frame["derivative"][name] == pytest.approx((up - down) / (2 * step), rel=1e-5)


def test_numbers_of_the_catalogue_are_data_too():
    model = raceway.Model.from_text(
        """[bearing]
catalogue = "S 6014 C"
[lubricant]
viscosity_40C_mm2_s = 20.0
viscosity_100C_mm2_s = 4.4
"""
    )
    found = model.sensitivity(8000, 300, of="stiffness,torque").to_frame()
    for column, names in (
        ("axial_stiffness_N_um", ["ball_diameter_mm", "contact_angle_deg", "inner_conformity"]),
        ("friction_torque_Nmm", ["pitch_diameter_mm", "static_load_rating_N"]),
    ):
        frame = found[found.prediction == column].set_index("datum")
        assert frame["predicted"].iloc[0] == pytest.approx(float(model.solve(8000, 300)[column]), rel=1e-12)
        for name in names:
            key = f"bearing.{name}"
            assert frame["origin"][key] in ("catalogue", "default")
            step = 1e-4 * frame["value"][key]
            up, down = (float(model.with_values({key: frame["value"][key] + s}).solve(8000, 300)[column]) for s in (step, -step))
            assert frame["derivative"][key] == pytest.approx((up - down) / (2 * step), rel=1e-4), key


def test_a_report_names_the_first_and_what_does_not_enter(model):
    found = model.sensitivity(8000, 300)
    first = found.data["predictions"][0]["data"][0]["name"]
    text = found.text()
    assert text.splitlines()[0].startswith("friction_torque_Nmm = ")
    assert text.splitlines()[3].startswith(first)
    assert "no influence: " in text and "bearing.ball_count" in found.does_not_enter
    assert first in repr(found) and "<table" in found._repr_html_()


def test_a_spindle_is_asked_for_its_steady_state():
    spindle = raceway.Model.read("data/spindles/small.toml")
    frame = spindle.sensitivity(6000, steady=True, of="displacement,temperature", data=["ambient", "f0"]).to_frame()
    assert set(frame["prediction"]) == {"axial_displacement_um", "hottest_ring_temperature_C"}
    rise = frame[(frame.prediction == "hottest_ring_temperature_C") & (frame.datum == "ambient.temperature_C")]
    # A warmer room makes a warmer spindle; thinner oil takes a part of it back.
    assert 0.5 < rise["derivative"].iloc[0] < 1.0


def test_an_effect_in_python_is_part_of_every_variant(model):
    def drag(state, k):
        return k * state.speed_rpm

    own = model.with_effect(raceway.Effect("my-drag", drag, {"k": 0.01}))
    with_drag, without = (m.sensitivity(8000, 300, data="f0").to_frame() for m in (own, model))
    assert with_drag["predicted"].iloc[0] == pytest.approx(without["predicted"].iloc[0] + 80.0)
    assert with_drag["derivative"].iloc[0] == pytest.approx(without["derivative"].iloc[0], rel=1e-9)


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        ({"spread": {"bal_diameter_mm": 1}}, raceway.InputError, "ball_diameter_mm"),
        ({"spread": {"ball_diameter_mm": -1}}, raceway.InputError, "must be 0 or more"),
        ({"spread": {"ball_diameter_mm": None}}, TypeError, "spread of ball_diameter_mm: must be a number"),
        ({"samples": 1000}, raceway.InputError, "must be a power of two"),
        ({"samples": -1}, ValueError, "samples = -1"),
        ({"samples": 2.0}, TypeError, "samples: must be a whole number"),
        ({"of": "nonsense"}, raceway.InputError, "unknown prediction"),
        ({"steady": True}, raceway.InputError, "is not a spindle"),
    ],
)
def test_wrong_use_is_refused_in_words(model, given, error, words):
    with pytest.raises(error, match=words):
        model.sensitivity(8000, None if "steady" in given else 300, **given)
    with pytest.raises(raceway.InputError, match="axial_load_N is missing"):
        raceway.Model.new("S 6014 C").sensitivity(8000)

"""What a new user gives by mistake is refused in words that say what to do."""

import os
import signal
import threading
import time

import numpy
import pandas
import pytest

import raceway

RIG = "tests/hidden_effect/rigs/dev-03/"
SPINDLE = "data/measurements/spindle_thermal/"


@pytest.fixture(scope="module")
def rig():
    return raceway.Model.read(RIG + "model.toml")


@pytest.fixture(scope="module")
def frame():
    return pandas.read_csv(RIG + "train.csv", comment="#")


@pytest.fixture(scope="module")
def lag():
    """A poor correction, whose diagnosis takes seconds, and its record."""
    record = raceway.Record.read(SPINDLE + "record.csv")
    bare = raceway.Correction.read(SPINDLE + "bare3.toml")
    return bare.identify(record, inputs="speed_rpm", order=1, until_s=93600).correction, record


def test_a_frame_in_place_of_a_record(rig, frame):
    for asked in (rig.compare, rig.calibrate, rig.diagnose, rig.predict):
        with pytest.raises(TypeError, match=r"not DataFrame; .*from_pandas\(frame\)"):
            asked(frame)


def test_columns_that_are_none(frame):
    for theirs in (None, [3], [], True):
        with pytest.raises(TypeError, match="columns: speed_rpm must be the name of a column in your data"):
            raceway.Record.from_pandas(frame, columns={"speed_rpm": theirs})
    with pytest.raises(raceway.InputError, match="two columns are named speed_rpm"):
        raceway.Record.from_pandas(pandas.concat([frame, frame[["speed_rpm"]]], axis=1))


def test_one_of_several_names_of_a_column(rig, frame):
    named = raceway.Record.from_pandas(frame.rename(columns={"speed_rpm": "n"}), columns={"speed_rpm": ["rpm", "n"]})
    assert rig.compare(named).rmse == pytest.approx(rig.compare(raceway.Record.from_pandas(frame)).rmse)


def test_a_decimal_comma_that_pandas_read_as_text(rig, frame):
    text = frame["friction_torque_Nmm"].map(lambda x: str(x).replace(".", ","))
    with pytest.raises(raceway.InputError, match=r'friction_torque_Nmm has text .*decimal=","\)'):
        raceway.Record.from_pandas(frame.assign(friction_torque_Nmm=text))
    remarks = frame.assign(remark="3,5 turns", torque_words=frame["friction_torque_Nmm"].astype(str))
    assert rig.compare(raceway.Record.from_pandas(remarks)).rmse == pytest.approx(74.37, abs=0.01)


def test_numbers_that_are_none(rig):
    record = raceway.Record.read(RIG + "train.csv")
    for value in ("3", numpy.array([1.0, 2.0]), None, True):
        with pytest.raises(TypeError, match="f0: must be a number"):
            rig.with_values({"f0": value})
    with pytest.raises(TypeError, match="values: must be a dict such as"):
        rig.with_values(["f0", 3])
    with pytest.raises(TypeError, match='such as "2Nmm" or "2um", not 2'):
        rig.compare(record, tolerance=2)
    with pytest.raises(ValueError, match="speed_rpm: the lists must have equal lengths"):
        rig.solve([[1000], [2000, 3]], 300)
    with pytest.raises(TypeError, match="text: must be text, not NoneType"):
        raceway.Model.from_text(None)
    with pytest.raises(TypeError, match="text: must be text, not NoneType"):
        raceway.Correction.from_text(None)
    with pytest.raises(TypeError, match="bearing: must be text"):
        raceway.Model.new(None)


def test_one_column_may_stand_by_itself(rig):
    assert list(rig.solve(1000, 300, columns="power_loss_W")) == ["power_loss_W"]


def test_a_band_of_a_model_that_was_not_fitted(rig):
    for ask in (lambda: rig.solve(1000, 300, band=True), lambda: rig.table([0, 1000], band=True)):
        with pytest.raises(raceway.InputError, match=r"calibrate\(record\)\.model and add"):
            ask()


def test_kelvin_in_a_table_and_a_displacement(rig):
    assert any("the value is probably in kelvin" in note for note in rig.table([0, 1000], [300], temperature_C=313.15).notes)
    assert not any("kelvin" in note for note in rig.table([0, 1000], [300], temperature_C=40).notes)
    shaft = raceway.Model.read("data/spindles/small.toml")
    with pytest.warns(raceway.Doubt, match="temperature_C = 313.15 C: the value is probably in kelvin"):
        shaft.displacement([0, 1000], temperature_C=313.15)
    with pytest.raises(TypeError, match="temperature_C: only possible with load_cases"):
        shaft.step_response([2000], temperature_C=40)


def test_what_progress_raises_is_raised(lag):
    correction, record = lag

    def fails(share, step):
        raise ZeroDivisionError("of the caller")

    for until_h in (20, 26):
        with pytest.raises(ZeroDivisionError, match="of the caller"):
            correction.diagnose(record, until_s=3600 * until_h, progress=fails)


@pytest.mark.filterwarnings("ignore::raceway.Doubt")
def test_an_interrupt_is_one_whatever_the_fit_makes_of_it(lag):
    correction, record = lag
    for after_s in (0.1, 0.2, 0.4, 0.6):
        timer = threading.Timer(after_s, os.kill, (os.getpid(), signal.SIGINT))
        start = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            timer.start()
            correction.diagnose(record, until_s=93600)
            time.sleep(5)  # quicker than the timer
        assert time.perf_counter() - start < 4


def test_a_spindle_at_rest_is_within_its_friction_table(tmp_path):
    spindle = raceway.Model.read("data/spindles/externally_driven.toml")
    spindle.step_response([2000, 6000]).save_correction(tmp_path / "c.toml")
    correction = raceway.Correction.read(tmp_path / "c.toml")

    def said(*speeds):
        day = pandas.DataFrame({"time_s": 60.0 * numpy.arange(len(speeds)), "speed_rpm": speeds})
        return correction.correct(raceway.Record.from_pandas(day)).warnings

    assert said(0, 3000, 0) == []
    with pytest.warns(raceway.Doubt):
        assert any("25.0 % of the rows lie outside" in line for line in said(0, 3000, 0, 1000))

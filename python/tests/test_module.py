"""Arrays, wrong use, threads, interrupts."""

import gc
import os
import pickle
import resource
import signal
import subprocess
import sys
import threading
import time
import warnings

import numpy
import pandas
import pytest

import raceway
from raceway import _engine

RIG = "tests/hidden_effect/rigs/dev-03"


@pytest.fixture
def model():
    return raceway.Model.new("S 6014 C")


def test_dir_lists_what_a_user_needs_and_nothing_else():
    assert {"Record", "Model", "Correction", "plot", "sweep", "fit_law"} <= set(dir(raceway))
    assert not [name for name in dir(raceway) if name.startswith("_") and name != "__version__"]


def test_a_printed_solution_shows_its_values(model):
    one = str(model.solve(8000, 300))
    assert one.splitlines()[0] == "1 state, all converged"
    torque = model.solve(8000, 300).friction_torque_Nmm
    assert f"friction_torque_Nmm          {torque.item():.5g}" in one
    many = model.solve(numpy.arange(0.0, 9000.0, 1000.0), 300)
    assert "speed_rpm                    0  1000  2000  ...  7000  8000" in str(many)
    assert max(len(line) for line in str(many).splitlines()) <= 90


def test_inputs_are_read_where_they_stand():
    speeds = numpy.linspace(0.0, 12000.0, 11)[::2]
    loads = numpy.full((3, 1), 300.0)
    read = {name: (address, strides) for name, address, strides in _engine.views({"speed_rpm": speeds, "axial_load_N": loads})}
    assert read["speed_rpm"] == (speeds.ctypes.data, [0, speeds.strides[0]])
    assert read["axial_load_N"] == (loads.ctypes.data, [loads.strides[0], 0])


def test_strides_and_order_change_nothing(model):
    plain = numpy.array([[0.0, 3000.0, 9000.0], [100.0, 6000.0, 12000.0]])
    expected = model.solve(plain, 300.0).friction_torque_Nmm
    backwards = numpy.asfortranarray(plain)[::-1, ::-1][::-1, ::-1]
    big = numpy.zeros((4, 6))
    big[::2, ::2] = plain
    for same in (backwards, big[::2, ::2], plain.astype(">f8"), plain.astype(int)):
        assert (model.solve(same, 300.0).friction_torque_Nmm == expected).all()


def test_results_are_columns_of_one_block(model):
    states = model.solve([1000.0, 2000.0], 300.0)
    torque, loss = states["friction_torque_Nmm"], states["power_loss_W"]
    assert torque.base is loss.base
    assert torque.flags["C_CONTIGUOUS"]


def test_wanted_columns_alone(model):
    states = model.solve([1000.0, 2000.0], 300.0, columns=["power_loss_W"])
    assert list(states) == ["power_loss_W"]
    with pytest.raises(raceway.InputError, match="power: unknown result; must be one of friction_torque_Nmm"):
        model.solve(1000.0, 300.0, columns=["power"])


def test_no_states(model):
    states = model.solve(numpy.zeros((0, 3)), 300.0)
    assert states.friction_torque_Nmm.shape == (0, 3)
    assert states.status.shape == (0, 3)


def test_a_state_without_balance_says_so(model):
    states = model.solve([100.0, 100.0], [0.0, 100.0])
    assert states.status[0] != "converged" and states.status[1] == "converged"
    assert numpy.isnan(states.axial_displacement_um[0])


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        ({"speed_rpm": [1.0, -3.0]}, raceway.InputError, r"speed_rpm\[1\] = -3 rpm: must be from 0 to 1000000 rpm"),
        ({"speed_rpm": [[1.0], [float("nan")]]}, raceway.InputError, r"speed_rpm\[1, 0\] = nan"),
        ({"speed_rpm": [1.0, 2.0], "axial_load_N": [1.0, 2.0, 3.0]}, raceway.InputError, r"speed_rpm \(2,\), axial_load_N \(3,\)"),
        ({"speed_rpm": ["1000", "2000"]}, TypeError, "speed_rpm: must contain numbers, not text"),
        ({"speed_rpm": [True]}, TypeError, "truth values"),
        ({"speed_rpm": [1j]}, TypeError, "complex"),
        ({"speed_rpm": [None]}, TypeError, "objects"),
        ({"speed_rpm": 1000, "temperature_C": 1e4}, raceway.InputError, "temperature_C = 10000 C: must be from -100 to 400 C"),
    ],
)
def test_wrong_arrays(model, given, error, words):
    with pytest.raises(error, match=words):
        model.solve(**{"axial_load_N": 300.0} | given)


def test_kelvin_is_noticed(model):
    for speed in (1000, [1000]):
        notes = model.solve(speed, 300, temperature_C=313).notes
        assert any("the value is probably in kelvin" in note for note in notes)


def test_errors_have_their_place(root):
    with pytest.raises(raceway.InputError, match="no such file") as missing:
        raceway.Model.read("nowhere.toml")
    assert missing.value.file == "nowhere.toml"
    text = raceway.Model.new("S 6014 C").text.replace("ball_diameter_mm", "ball_diamter_mm", 1)
    with pytest.raises(raceway.InputError) as misspelt:
        raceway.Model.from_text(text, "mine")
    assert misspelt.value.line is not None and "mine:" in str(misspelt.value)
    assert isinstance(misspelt.value, ValueError)


def test_a_correction_is_refused_in_words(root):
    with pytest.raises(raceway.InputError, match="is a correction of a machine"):
        raceway.Model.read(root / "data/corrections/exact/correction.toml")


@pytest.mark.parametrize("wrong", [[1, 2], "train.csv", None])
def test_a_record_is_wanted(model, wrong):
    with pytest.raises(TypeError, match="Record|iterable"):
        model.compare(wrong)
    with pytest.raises(TypeError, match="DataFrame"):
        raceway.Record.from_pandas(wrong)


def test_a_closed_file_and_an_empty_frame():
    with open(os.devnull, encoding="utf-8") as file:
        pass
    with pytest.raises((TypeError, ValueError)):
        raceway.Record.read(file)
    with pytest.raises(raceway.InputError, match="no rows"):
        raceway.Record.from_pandas(pandas.DataFrame({"speed_rpm": []}))


def test_a_frame_with_german_headers(root):
    model = raceway.Model.read(f"{root}/{RIG}/model.toml")
    frame = raceway.Record.read(f"{root}/{RIG}/train.csv").to_frame()
    german = frame.rename(columns={"speed_rpm": "Drehzahl [1/min]", "axial_load_N": "Axialkraft [N]"})
    with pytest.raises(raceway.InputError, match="speed_rpm"):
        model.compare(raceway.Record.from_pandas(german))
    columns = {"speed_rpm": "Drehzahl [1/min]", "axial_load_N": "Axialkraft [N]"}
    same = model.compare(raceway.Record.from_pandas(german, columns=columns))
    assert same.rmse == pytest.approx(model.compare(raceway.Record.from_pandas(frame)).rmse, rel=1e-12)


def test_a_frame_and_its_file_are_one_record(root):
    model = raceway.Model.read(f"{root}/{RIG}/model.toml")
    record = raceway.Record.read(f"{root}/{RIG}/train.csv")
    from_frame = raceway.Record.from_pandas(record.to_frame())
    assert model.compare(from_frame).rmse == model.compare(record).rmse


def test_threads_on_one_model(model):
    speeds = numpy.linspace(100.0, 12000.0, 400)
    expected = model.solve(speeds, 300.0).friction_torque_Nmm
    wrong = []

    def ask():
        for _ in range(10):
            if not (model.solve(speeds, 300.0).friction_torque_Nmm == expected).all():
                wrong.append(1)

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_other_threads_run_while_states_are_solved(model):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    model.solve(numpy.linspace(100.0, 12000.0, 30000), 300.0, radial_load_N=100.0)
    end = time.monotonic()
    done.set()
    thread.join()
    assert sum(start < t < end for t in ticks) > 5


def slow_text(root):
    """Return a model of the contact law, whose diagnosis takes many seconds."""
    text = (root / RIG / "model.toml").read_text()
    head = text.split("[friction]")[0]
    return head + '[friction]\nlaw = "contact"\n'


INTERRUPTED = """
import signal, threading, os, raceway, warnings
warnings.simplefilter("ignore")
model = raceway.Model.read("{rig}/model.toml")
record = raceway.Record.read("{rig}/train.csv")
seen = []
def progress(share, step):
    seen.append(share)
    os.kill(os.getpid(), signal.SIGINT)
slow = raceway.Model.from_text({slow!r}, "slow")
try:
    slow.diagnose(record, progress=progress)
except KeyboardInterrupt:
    print("interrupted", len(seen) > 0)
print(raceway.Model.new("S 6014 C").solve(1000, 300).status)
"""


def test_an_interrupt_ends_a_diagnosis(root):
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTED.format(rig=RIG, slow=slow_text(root))], cwd=root, capture_output=True, text=True, timeout=120
    )
    assert done.stdout.split() == ["interrupted", "True", "converged"], done.stderr
    assert done.returncode == 0


def test_a_time_limit(root):
    slow = raceway.Model.from_text(slow_text(root), "slow")
    with pytest.raises(TimeoutError, match="time_limit_s"):
        slow.diagnose(raceway.Record.read(f"{root}/{RIG}/train.csv"), time_limit_s=0.2)


def test_an_import_loads_no_more_than_it_needs():
    code = "import sys, raceway; print([name for name in ('matplotlib', 'pandas', 'json.tool') if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_nothing_leaks(model):
    record = raceway.Record("tiny", "speed_rpm,axial_load_N\n")
    speeds = numpy.array([1000.0, 2000.0])

    def ask(times):
        for k in range(times):
            model.solve(speeds, 300.0)
            if k % 10 == 0:
                with pytest.raises(raceway.InputError):
                    model.compare(record)

    ask(2000)
    gc.collect()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    ask(int(os.environ.get("RACEWAY_LEAK_CALLS", "10000")))
    gc.collect()
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before  # [kB]
    assert grown < 4000


def test_a_model_is_not_overwritten(model, tmp_path):
    file = tmp_path / "m.toml"
    model.save(file)
    with pytest.raises(FileExistsError):
        model.save(file)
    model.with_values({"rolling_factor": 1.1}).save(file, overwrite=True)
    assert raceway.Model.read(file).parameters["rolling_factor"]["value"] == 1.1
    with pytest.raises(raceway.InputError, match="f00: no such parameter"):
        model.with_values({"f00": 1.0})


def test_settings_come_back_as_they_were_entered():
    # The way to SI and back moves the last digit of 750, 1500 and 3000 rpm, and of 20.3 C.
    speeds = numpy.arange(0, 14001, 250)
    frame = raceway.Model.new("S 6014 C").table(speeds, [100, 300], temperature_C=[20.3, 40.1]).to_frame()
    assert sorted(frame["speed_rpm"].unique()) == speeds.tolist()
    assert sorted(frame["temperature_C"].unique()) == [20.3, 40.1]
    rows = pandas.DataFrame({"speed_rpm": speeds, "axial_load_N": 300.0, "friction_torque_Nmm": 200.0})
    understood = raceway.Model.new("S 6014 C").predict(raceway.Record.from_pandas(rows))
    assert understood["speed_rpm"].tolist() == speeds.tolist()


def test_other_numbers_are_named_by_table_and_key():
    model = raceway.Model.new("S 6014 C")
    thicker = model.with_values({"lubricant.viscosity_40C_mm2_s": 32, "rolling_factor": 1.1})
    assert "viscosity_40C_mm2_s = 32.0" in thicker.text and "rolling_factor = 1.1" in thicker.text
    with pytest.raises(raceway.InputError, match="did you mean viscosity_40C_mm2_s"):
        model.with_values({"lubricant.viscosity_40C": 32})
    with pytest.raises(raceway.InputError, match="such as lubricant.viscosity_40C_mm2_s"):
        model.with_values({"viscosity_40C_mm2_s": 32})


def test_a_bearing_that_is_not_in_the_catalogue_is_described():
    model = raceway.Model.new("mine", bore_mm=70, outer_diameter_mm=110, contact_angle_deg=25, ball_count=20)
    assert "70 x 110 mm, 25 deg" in model.notes[0]
    assert model.solve(1000, 300).data["balls"][19]
    with pytest.raises(raceway.InputError, match="give bore_mm and outer_diameter_mm, and ball_count"):
        raceway.Model.new("mine")
    with pytest.raises(ValueError, match="ball_count = -4"):
        raceway.Model.new("mine", bore_mm=70, outer_diameter_mm=110, ball_count=-4)


def test_messages_name_what_python_has_in_place_of_flags():
    record = raceway.Record("rig.csv", "Drehzahl;Moment\n1000;0,2\n")
    with pytest.raises(raceway.InputError, match=r"Model\.suggest_columns\(record\) proposes"):
        raceway.Model.new("S 6014 C", law="palmgren").compare(record)
    assert "For the argument columns of Record" in raceway.Model.new("S 6014 C").suggest_columns(record)


def test_what_a_law_ignores_is_a_note_of_the_model_and_no_doubt_of_every_comparison(root):
    model = raceway.Model.read(root / RIG / "model.toml")
    assert any("palmgren does not depend on ball_count" in note for note in model.notes)
    with warnings.catch_warnings():
        warnings.simplefilter("error", raceway.Doubt)
        comparison = model.compare(raceway.Record.read(root / RIG / "test.csv"))
    assert not comparison.warnings


def test_notes_and_doubts_have_codes_and_places(root):
    model = raceway.Model.read(root / RIG / "model.toml")
    (note,) = [note for note in model.notes if note.code == "ignored"]
    assert "palmgren does not depend on ball_count" in note
    assert note.file == model.source and note.line is None
    again = pickle.loads(pickle.dumps(note))
    assert again == note and (again.kind, again.code, again.file) == (note.kind, note.code, note.file)
    with pytest.warns(raceway.Doubt, match="exceeds the noise") as told:
        model.calibrate(raceway.Record.read(root / RIG / "train.csv"))
    assert all(doubt.message.note.kind in ("doubt", "warning") for doubt in told)
    assert "misfit" in [doubt.message.note.code for doubt in told]


def test_fitted_models_say_what_was_fitted(root):
    model = raceway.Model.read(root / RIG / "model.toml")
    record = raceway.Record.read(root / RIG / "train.csv")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", raceway.Doubt)
        calibrated = model.calibrate(record).model.calibrate(record).model
        better = calibrated.add("lubricant-drag", record).model
    assert calibrated.source == model.source + ", calibrated"
    assert better.source == calibrated.source + " + lubricant-drag"
    names = [m["model"] for m in model.compare(record, calibrated, better).data["models"]]
    assert len(set(names)) == 3


def test_ranges_of_large_numbers_have_no_exponent(root):
    model = raceway.Model.new("S 6014 C", law="palmgren")
    path = root / "data/measurements/german_export.csv"
    columns = model.suggest_columns(raceway.Record.read(path))
    comparison = model.compare(raceway.Record.read(path, columns=columns, drop_nan=True))
    worst = comparison.data["where"][0]
    assert worst["variable"] == "speed" and worst["from"] > 10000
    assert comparison.data["statement"].endswith(f"at {worst['from']:.0f} to {worst['to']:.0f} rpm.")


def test_a_record_is_a_frame_in_whatever_form_it_was_written(root):
    frame = raceway.Record.read(root / "data/measurements/german_export.csv").to_frame()
    assert list(frame) == ["Zeit", "Drehzahl", "Axialkraft", "Temperatur Öl", "Reibmoment", "Bemerkung"]
    assert len(frame) == 72 and frame["Reibmoment"].isna().sum() == 1
    assert frame.loc[0, ["Drehzahl", "Axialkraft", "Reibmoment"]].tolist() == [12983, 0.15, 0.5205]
    odd = pandas.DataFrame({"n, rpm": [1, 2], "what": ['say "no"', "a;b"]})
    assert raceway.Record.from_pandas(odd).to_frame().equals(odd)


@pytest.mark.parametrize("path", [True, 1])
def test_a_number_is_no_file(model, path):
    with pytest.raises(TypeError):
        model.save(path)
    print("standard output is still open", flush=True)


def test_masked_values_are_refused(model):
    with pytest.raises(ValueError, match="speed_rpm: has masked values"):
        model.solve(numpy.ma.masked_greater([1000.0, 9000.0], 5000), 300)
    assert model.solve(numpy.ma.masked_greater([1000.0, 2000.0], 5000), 300).converged.all()


def test_a_file_that_cannot_be_written_leaves_what_was_there(model, tmp_path):
    (tmp_path / "m.toml").write_text("before")
    with pytest.raises(FileExistsError, match="overwrite=True"):
        model.save(tmp_path / "m.toml")
    with pytest.raises(raceway.InputError, match="this folder does not exist"):
        model.save(tmp_path / "none" / "m.toml")
    assert (tmp_path / "m.toml").read_text() == "before"


def test_arrays_frames_and_text_are_one_record(root):
    model = raceway.Model.read(root / RIG / "model.toml")
    text = raceway.Record.read(root / RIG / "train.csv")
    frame = text.to_frame()
    arrays = {name: frame[name].to_numpy() for name in frame}
    expected = model.compare(text).data
    for record in (
        raceway.Record.from_pandas(frame, name=text.name),
        raceway.Record.from_pandas(frame.convert_dtypes(), name=text.name),
        raceway.Record.from_arrays(arrays, name=text.name),
        pickle.loads(pickle.dumps(raceway.Record.from_arrays(arrays, name=text.name))),
    ):
        assert model.compare(record).data == expected
        assert record.to_frame().equals(frame)


def test_cells_without_a_number_are_named_by_their_row(model):
    given = {"speed_rpm": [1000.0, 2000.0, 3000.0], "axial_load_N": [100, 100, 100]}
    for torque in ([1.0, numpy.nan, 3.0], numpy.ma.masked_equal([1.0, 2.0, 3.0], 2.0)):
        record = raceway.Record.from_arrays({**given, "friction_torque_Nmm": torque}, name="mine")
        with pytest.raises(raceway.InputError, match='mine:3: friction_torque_Nmm = "": is empty') as e:
            model.compare(record)
        assert e.value.line == 3
        dropped = raceway.Record.from_arrays({**given, "friction_torque_Nmm": torque}, name="mine", drop_nan=True)
        assert len(model.predict(dropped)) == 2
    with pytest.raises(raceway.InputError, match="column b has 2 values, but column a has 1"):
        _engine.Data("mine", columns={"a": numpy.zeros(1), "b": numpy.zeros(2)})
    with pytest.raises(raceway.InputError, match="the arrays must have equal lengths"):
        raceway.Record.from_arrays({"speed_rpm": [1.0], "friction_torque_Nmm": [1.0, 2.0]})
    with pytest.raises(raceway.InputError, match="column speed_rpm is missing"):
        model.compare(raceway.Record.from_arrays({"friction_torque_Nmm": [1.0, 2.0]}))
    single = raceway.Record.from_arrays({k: numpy.float32(v) for k, v in {**given, "friction_torque_Nmm": [0.1, 0.2, 0.3]}.items()})
    assert model.predict(single)["friction_torque_Nmm"].tolist() == [0.1, 0.2, 0.3]


def test_runs_and_dates_of_a_frame(root):
    frame = pandas.DataFrame(
        {
            "time_s": pandas.date_range("2024-03-12 08:15", periods=40, freq="60s"),
            "front_bearing_temperature_C": numpy.linspace(20, 30, 40),
            "ambient_temperature_C": numpy.linspace(20, 21, 40),
            "displacement_z_um": numpy.linspace(0, 12, 40),
            "run_id": [1] * 40,
        }
    )
    correction = raceway.Correction.read(root / "data/corrections/exact/correction.toml")
    notes = correction.correct(raceway.Record.from_pandas(frame)).notes
    assert any("time_s is measured from 2024-03-12" in note for note in notes)

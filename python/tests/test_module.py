"""Arrays, wrong use, threads, interrupts."""

import gc
import os
import resource
import signal
import subprocess
import sys
import threading
import time

import numpy
import pandas
import pytest

import raceway
from raceway import _engine

RIG = "tests/hidden_effect/rigs/dev-03"


@pytest.fixture
def model():
    return raceway.Model.new("S 6014 C")


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
    with pytest.raises(raceway.InputError, match="power: no such result; there are friction_torque_Nmm"):
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
        ({"speed_rpm": ["1000", "2000"]}, TypeError, "speed_rpm: numbers are wanted, not text"),
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
        assert any("looks like kelvin" in note for note in notes)


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

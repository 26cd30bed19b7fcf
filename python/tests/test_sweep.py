"""Sweeps: the same numbers whoever worked on them, nothing lost."""

import functools
import hashlib
import io
import json
import math
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request
import warnings

import dask
import distributed
import fleet
import numpy
import psutil
import pytest

import raceway
from raceway import _sweep_slabs, sweep

PACKAGE = pathlib.Path(raceway.__file__).absolute().parents[1]


@pytest.fixture(scope="module")
def workers():
    """Two worker processes of their own behind TCP, as they would be on other machines."""
    # An item that ends its worker is tried once more, alone.
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}), sweep.workers(2) as client:
        assert isinstance(client.cluster, distributed.LocalCluster)
        assert len(set(client.run(os.getpid).values()) - {os.getpid()}) == 2
        assert client.scheduler.address.startswith("tls://127.0.0.1:")
        yield client


def test_workers_listen_on_the_loopback_alone_and_keep_their_files_to_themselves(workers):
    family = [psutil.Process(), *psutil.Process().children(recursive=True)]
    listening = {c.laddr.ip for process in family for c in process.connections() if c.status == psutil.CONN_LISTEN}
    assert listening == {"127.0.0.1"}
    folders = {pathlib.Path(folder) for folder in workers.run(lambda dask_worker: dask_worker.local_directory).values()}
    (private,) = {next(parent for parent in folder.parents if parent.name.startswith("raceway-")) for folder in folders}
    assert private.stat().st_mode & 0o077 == 0
    for page in ("status", "info/main/workers.html", "metrics"):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            urllib.request.urlopen(f"http://127.0.0.1:{workers.cluster.scheduler.http_server.port}/{page}", timeout=10)


def test_workers_take_no_work_from_a_stranger(workers):
    port = workers.scheduler.address.rpartition(":")[2]
    with pytest.raises(OSError):
        distributed.Client(f"tcp://127.0.0.1:{port}", timeout=3)
    stranger = distributed.security.Security.temporary()
    with pytest.raises(OSError):
        distributed.Client(workers.scheduler.address, security=stranger, timeout=3)


def test_the_address_of_a_scheduler_is_taken():
    with distributed.LocalCluster(1, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0") as cluster:
        assert sweep.run(math.sqrt, [4.0, 9.0], client=cluster.scheduler_address).values() == [2.0, 3.0]


def bits(found):
    """All that a sweep found, to compare to the last bit."""
    return found.names, [pickle.dumps(value) for value in found.values()], found.failures, found.doubts


def root_of(number):
    if number < 0:
        raise raceway.InputError(f"number = {number}: must be 0 or more")
    return math.sqrt(number)


def test_results_stand_in_the_order_of_the_items():
    found = sweep.run(root_of, {"four": 4.0, "two": 2.0, "nine": 9.0}, slabs=2)
    assert list(found) == ["four", "two", "nine"]
    assert found.values() == [2.0, math.sqrt(2.0), 3.0]
    assert found["nine"] == 3.0


def test_an_error_is_that_of_its_item():
    with pytest.warns(raceway.Doubt, match=r"1 of 4 items failed .the attribute failures has all., the first 3: number = -1"):
        found = sweep.run(root_of, [4.0, 9.0, -1.0, 16.0])
    assert found.values() == [2.0, 3.0, None, 4.0]
    (failure,) = found.failures
    assert (failure.name, failure.kind, failure.message) == ("3", "InputError", "number = -1.0: must be 0 or more")
    assert "root_of" in failure.traceback
    with pytest.raises(RuntimeError, match="3 has no value because of InputError: number = -1.0"):
        found["3"]
    assert found.to_frame()["error"].tolist() == [None, None, "InputError: number = -1.0: must be 0 or more", None]


def test_a_value_that_cannot_travel_is_an_error_of_its_item():
    with pytest.warns(raceway.Doubt):
        found = sweep.run(lambda item: threading.Lock() if item == 1 else item, [0, 1])
    assert found.values() == [0, None]
    assert found.failures[0].message.startswith("the function returned a lock, which cannot be sent to another process")


def test_warnings_are_kept_with_their_item():
    def doubtful(item):
        if item == 2:
            warnings.warn("too hot", raceway.Doubt)
        return item

    with pytest.warns(raceway.Doubt, match="1 of 3 items have warnings .*the first 2: too hot"):
        found = sweep.run(doubtful, [1, 2, 3])
    assert [(d.name, d.message) for d in found.doubts] == [("2", "too hot")]


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        ({"items": "abc"}, TypeError, "items: must be a list or a mapping, not str"),
        ({"items": [1, 2], "names": ["a"]}, ValueError, "names: 1 names are given for 2 items"),
        ({"items": [1, 2], "names": ["a", "a"]}, ValueError, "names: a occurs twice"),
        ({"items": [1, 2], "slabs": 3}, ValueError, "slabs = 3: must be from 1 to 2"),
        ({"items": [1], "threads": 0}, ValueError, "threads = 0: must be 1 or more"),
        ({"items": [1], "client": 8786}, TypeError, "client: must be a distributed.Client or the address"),
    ],
)
def test_wrong_use(given, error, words):
    with pytest.raises(error, match=words):
        sweep.run(root_of, **given)


def test_no_scheduler(monkeypatch):
    monkeypatch.setattr("raceway._sweep_dask.PATIENCE_S", 0.3)
    with pytest.raises(raceway.InputError, match="client = 'tcp://127.0.0.1:9': no scheduler at this address answers within 0.3 s"):
        sweep.run(root_of, [1.0], client="tcp://127.0.0.1:9")


def test_without_dask_the_packages_are_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ImportError, match="apt install python3-dask python3-distributed"):
        sweep.run(root_of, [1.0], client="tcp://127.0.0.1:8786")
    assert sweep.run(root_of, [1.0]).values() == [1.0]


def test_models_and_corrections_go_to_other_processes_as_they_are():
    model = raceway.Model.new("7014 C", ball_count=20).with_values({"rolling_factor": 1.1})
    there = pickle.loads(pickle.dumps(model))
    assert (there.text, there.source, there.notes) == (model.text, model.source, model.notes)
    assert (there.solve([100.0, 9000.0], 300.0)._values == model.solve([100.0, 9000.0], 300.0)._values).all()
    correction = pickle.loads(pickle.dumps(fleet.START))
    assert (correction.text, correction.parameters) == (fleet.START.text, fleet.START.parameters)


# --- slabs on disk


def test_a_sweep_goes_on_where_it_was_interrupted(tmp_path):
    asked = []

    def stop(share, words):
        if share >= 0.5:
            raise KeyboardInterrupt

    items = [float(k) for k in range(12)]
    with pytest.raises(KeyboardInterrupt):
        sweep.run(Divided(asked), items, folder=tmp_path, slabs=4, progress=stop)
    assert asked == items[:6]  # one slab is on disk, the second one was cut
    asked.clear()
    found = sweep.run(Divided(asked), items, folder=tmp_path)  # slabs as they are there
    assert asked == items[3:]
    assert bits(found) == bits(sweep.run(Divided([]), items))
    assert bits(sweep.load(tmp_path)) == bits(found)
    asked.clear()
    assert bits(sweep.run(Divided(asked), items, folder=tmp_path)) == bits(found)
    assert asked == []


class Divided:
    """Notes what it was asked; what is noted is no part of the input."""

    def __init__(self, asked):
        self._asked = asked

    def __call__(self, item):
        self._asked.append(item)
        return item / 7.0

    def __reduce__(self):
        return Divided, ([],)


def test_slabs_of_other_input_are_refused(tmp_path):
    sweep.run(root_of, [1.0, 2.0, 3.0], folder=tmp_path, slabs=3)
    for function, items, names in (
        (root_of, [1.0, 2.0, 3.5], None),
        (root_of, [1.0, 2.0, 3.0], ["a", "b", "c"]),
        (math.sqrt, [1.0, 2.0, 3.0], None),
        (lambda item: root_of(item), [1.0, 2.0, 3.0], None),
    ):
        with pytest.raises(raceway.InputError, match="slab-1-of-3.sweep: comes from another input"):
            sweep.run(function, items, names=names, folder=tmp_path)
    with pytest.raises(raceway.InputError, match="is one of 3 slabs, but 2 slabs are requested"):
        sweep.run(root_of, [1.0, 2.0, 3.0], folder=tmp_path, slabs=2)


def test_the_input_is_what_is_said_not_how_it_lies_in_memory(tmp_path):
    word = "lag"
    same = [
        ({"a": word, "b": word}, {"a": "lag", "b": "".join(["l", "ag"])}),
        (numpy.arange(6.0)[::2], numpy.array([0.0, 2.0, 4.0])),
        (raceway.Record("r", "a\n1\n"), raceway.Record("r", "a\n1\n")),
        ({"x", "y", "z"}, {"z", "y", "x"}),
    ]
    other = [
        (1, 1.0),
        (0.0, -0.0),
        ("1", 1),
        (["ab", "c"], ["a", "bc"]),
        ([[1], 2], [[1, 2]]),
        (numpy.arange(4), numpy.arange(4).reshape(2, 2)),
        (raceway.Record("r", "a\n1\n"), raceway.Record("r", "a\n2\n")),
        (raceway.Model.new("S 6014 C"), raceway.Model.new("S 6014 C").with_values({"rolling_factor": 1.1})),
    ]
    made_from = functools.partial(_sweep_slabs.input_of, root_of, ["item"])
    for a, b in same:
        assert made_from([a]) == made_from([b]), a
    for a, b in other:
        assert made_from([a]) != made_from([b]), a
    file = tmp_path / "record.csv"
    file.write_text("a")
    before = made_from([file])
    file.write_text("b")
    assert made_from([file]) != before


def test_the_input_is_the_same_in_another_process():
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); import fleet; from raceway._sweep_slabs import input_of;"
        "print(input_of(fleet.identify, ['m'], [fleet.machine(3)]), input_of(fleet.identify, ['m'], [{'b', 'a', 'c'}]))"
    )
    here = pathlib.Path(__file__).parent
    said = {
        subprocess.run(
            [sys.executable, "-c", code, str(here)],
            env=os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": str(PACKAGE)},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    mine = [_sweep_slabs.input_of(fleet.identify, ["m"], [item]) for item in (fleet.machine(3), {"a", "b", "c"})]
    assert said == {" ".join(mine) + "\n"}


def test_a_changed_helper_is_other_input():
    def namespace(factor):
        names = {"__name__": "job"}
        exec(f"def helper(x):\n    return {factor} * x\ndef work(x):\n    return helper(x)\n", names)
        return names["work"]

    first, again, other = (_sweep_slabs.input_of(namespace(f), ["a"], [1]) for f in ("2.0", "2.0", "3.0"))
    assert first == again != other


def test_what_was_cut_off_is_refused_or_made_again(tmp_path):
    items = [1.0, 2.0, 3.0, 4.0]
    whole = sweep.run(root_of, items, folder=tmp_path, slabs=2)
    file = tmp_path / "slab-2-of-2.sweep"
    content = file.read_bytes()
    for short in (content[:-1], content[:40], b""):
        file.write_bytes(short)
        with pytest.raises(raceway.InputError, match="slab-2-of-2.sweep: .*is incomplete"):
            sweep.load(tmp_path)
    with pytest.warns(raceway.Doubt, match="slab-2-of-2.sweep: .*the sweep calculates this slab again"):
        assert bits(sweep.run(root_of, items, folder=tmp_path, slabs=2)) == bits(whole)
    assert file.read_bytes() == content
    file.unlink()
    with pytest.raises(raceway.InputError, match=r"slab 2 of 2 \(items 3 to 4 of 4\) is missing; run it again"):
        sweep.load(tmp_path)
    (tmp_path / "copy.sweep").write_bytes((tmp_path / "slab-1-of-2.sweep").read_bytes())
    with pytest.raises(raceway.InputError, match="slab-1-of-2.sweep: is slab 1, but .*copy.sweep is also slab 1"):
        sweep.load(tmp_path)


class Opener:
    """Makes a file when it is unpickled."""

    def __init__(self, path):
        self.path = path

    def __reduce__(self):
        return open, (self.path, "w")


def test_a_slab_that_holds_code_is_refused_before_it_is_decoded(tmp_path):
    folder, opened = tmp_path / "slabs", tmp_path / "opened"
    sweep.run(root_of, [1.0, 2.0], folder=folder, slabs=1)
    file = folder / "slab-1-of-1.sweep"
    header = json.loads(file.read_bytes().partition(b"\n")[0])
    arrays = io.BytesIO()
    numpy.savez(arrays, a0=numpy.array([Opener(str(opened))], dtype=object))
    harmful = [
        pickle.dumps(Opener(str(opened))),
        pickle.dumps((["1", "2"], [(pickle.dumps(Opener(str(opened))), None, ())] * 2)),
        b'{"array": 0}\n' + arrays.getvalue(),
        b'[["1", "2"], [[{"array": 0}, null, []], [1.0, null, []]]]\n' + arrays.getvalue(),
    ]
    for content in harmful:
        made = {**header, "sha256": hashlib.sha256(content).hexdigest()}
        file.write_bytes(json.dumps(made).encode() + b"\n" + content)
        with pytest.raises(raceway.InputError, match="slab-1-of-1.sweep: cannot be read"):
            sweep.load(folder)
        with pytest.raises(raceway.InputError, match="slab-1-of-1.sweep: cannot be read"):
            sweep.run(root_of, [1.0, 2.0], folder=folder)
        assert not opened.exists()


def test_a_slab_of_an_older_form_is_not_read(tmp_path):
    sweep.run(root_of, [1.0], folder=tmp_path)
    file = tmp_path / "slab-1-of-1.sweep"
    first, _, content = file.read_bytes().partition(b"\n")
    file.write_bytes(json.dumps({**json.loads(first), "raceway_sweep": 1}).encode() + b"\n" + content)
    with pytest.raises(raceway.InputError, match="has slab format 1, but this version reads only format 2; calculate the slab again"):
        sweep.load(tmp_path)


def test_values_come_back_from_a_folder_as_they_were(tmp_path):
    values = [
        {"a": [1, -0.0, float("inf"), 10**40, None, True], 2: ("x", b"\0\xff", 1 + 2j), (1, 2): {}},
        {"grid": numpy.arange(6.0).reshape(2, 3), "texts": numpy.array(["a", "\u00fc"]), "times": numpy.array(["2024-03-12"], "M8[D]")},
        [numpy.float64(0.1), numpy.int32(7), numpy.bool_(True), "\ud800", {3, 1}, numpy.zeros((0, 2)), numpy.array(5.0)],
    ]
    found = sweep.run(lambda place: values[place], [0, 1, 2], folder=tmp_path, slabs=2)
    assert not found.failures
    assert repr(sweep.load(tmp_path).values()) == repr(values)
    assert [type(value) for value in sweep.load(tmp_path).values()[2][:3]] == [numpy.float64, numpy.int32, numpy.bool_]


def test_a_value_that_is_more_than_data_is_an_error_of_its_item_with_a_folder(tmp_path):
    def work(item):
        return pathlib.PurePosixPath("x") if item == 1 else item

    assert sweep.run(work, [0, 1]).values() == [0, pathlib.PurePosixPath("x")]
    with pytest.warns(raceway.Doubt, match="1 of 2 items failed"):
        found = sweep.run(work, [0, 1], folder=tmp_path)
    assert found.failures[0].message == (
        "the returned value is a PurePosixPath, which a slab file cannot contain; "
        "return numbers, arrays and text, or lists and dicts of these, such as .data"
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", raceway.Doubt)
        assert bits(sweep.load(tmp_path)) == bits(found)


# --- over Dask


def test_two_workers_find_what_one_process_finds(workers):
    items = {f"machine-{k}": fleet.machine(k) for k in range(24)}
    said = []
    serial = sweep.run(fleet.identify, items)
    for slabs in (None, 5, 24):
        assert bits(sweep.run(fleet.identify, items, client=workers, slabs=slabs)) == bits(serial)
    again = sweep.run(fleet.identify, items, client=workers, progress=lambda share, words: said.append((share, words)))
    assert bits(again) == bits(serial)
    assert said[0] == (0.0, "0 of 24 items") and said[-1] == (1.0, "24 of 24 items")
    assert [share for share, _ in said] == sorted(share for share, _ in said)


def test_errors_and_doubts_of_workers_are_those_of_the_serial_run(workers):
    def work(item):
        if item % 3 == 0:
            warnings.warn(f"{item} is a multiple of 3", raceway.Doubt)
        return root_of(5.0 - item)

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", raceway.Doubt)
        serial, parted = (sweep.run(work, range(10), slabs=4, client=client) for client in (None, workers))
    assert bits(parted) == bits(serial)
    assert [f.name for f in parted.failures] == ["7", "8", "9", "10"]
    assert [d.name for d in parted.doubts] == ["1", "4", "7", "10"]


def noted(folder, item):
    """Works for a while, and leaves a note of who began with which item."""
    with open(os.path.join(folder, f"{os.getpid()}.txt"), "a") as notes:
        notes.write(f"{item}\n")
    time.sleep(0.03)
    return {"third": item / 3.0, "sines": numpy.sin(numpy.arange(5.0) * item)}


def test_a_worker_is_killed_and_its_slab_is_done_again(workers, tmp_path):
    pids = workers.run(os.getpid)
    victim = sorted(pids.values())[0]

    def kill(share, words):
        if share >= 0.3:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass  # by now its nanny has made another

    work = functools.partial(noted, str(tmp_path))
    # No retry of Dask is left for a slab that was there; it comes back item by item.
    found = sweep.run(work, range(60), slabs=12, client=workers, progress=kill)
    begun = [int(line) for file in tmp_path.glob("*.txt") for line in file.read_text().split()]
    assert (tmp_path / f"{victim}.txt").exists()
    assert sorted(set(begun)) == list(range(60))
    assert len(begun) > 60  # what it had in hand was begun again
    assert victim not in workers.run(os.getpid).values()
    assert bits(found) == bits(sweep.run(work, range(60)))


def test_an_item_that_ends_every_worker_is_the_only_one_that_fails(workers):
    here = os.getpid()

    def work(item):
        if item == 7 and os.getpid() != here:
            os.kill(os.getpid(), signal.SIGKILL)
        return item / 3.0

    with pytest.warns(raceway.Doubt, match="1 of 16 items failed"):
        found = sweep.run(work, range(16), slabs=4, client=workers)
    assert [(f.name, f.kind) for f in found.failures] == [("8", "KilledWorker")]
    assert found.values() == [None if item == 7 else item / 3.0 for item in range(16)]


def test_an_interrupted_sweep_over_workers_goes_on_in_one_process(workers, tmp_path):
    def stop(share, words):
        if share >= 0.4:
            raise KeyboardInterrupt

    items = {f"machine-{k}": fleet.machine(k) for k in range(20)}
    with pytest.raises(KeyboardInterrupt):
        sweep.run(fleet.identify, items, client=workers, folder=tmp_path, slabs=10, progress=stop)
    there = {file: file.stat().st_mtime_ns for file in tmp_path.glob("*.sweep")}
    assert 4 <= len(there) < 10
    found = sweep.run(fleet.identify, items, folder=tmp_path)
    assert bits(found) == bits(sweep.run(fleet.identify, items))
    assert all(file.stat().st_mtime_ns == made for file, made in there.items())


def test_states_in_slabs_are_those_of_one_call(workers, tmp_path):
    model = raceway.Model.new("S 6014 C", law="palmgren")
    draw = numpy.random.default_rng(5)
    speeds, loads = draw.uniform(10.0, 14000.0, (41, 50)), draw.uniform(50.0, 900.0, (41, 1))
    radial = draw.uniform(0.0, 400.0, 50)
    whole = model.solve(speeds, loads, radial)
    for states, client, folder in ((1000, None, None), (333, workers, None), (7, None, tmp_path), (2050, workers, None)):
        parted = sweep.solve(model, speeds, loads, radial, states=states, client=client, folder=folder)
        assert list(parted) == list(whole)
        assert parted._values.tobytes() == whole._values.tobytes()
        assert (parted.status == whole.status).all()
        # Each slab counts its own states.
        assert {note.code for note in parted.notes} == {note.code for note in whole.notes} == {"load-limit"}
        assert states < whole.status.size or parted.notes == whole.notes
    wanted = sweep.solve(model, speeds, 300.0, columns=["friction_torque_Nmm"], states=100)
    assert list(wanted) == ["friction_torque_Nmm"] and wanted.friction_torque_Nmm.shape == (41, 50)
    with pytest.raises(raceway.InputError, match="states 1 to 2: speed_rpm.1. = -3 rpm"):
        sweep.solve(model, [1.0, -3.0], 300.0)


# --- a fleet


def test_a_fleet_of_1000_machines_is_identified_by_two_workers(workers):
    machines = [fleet.machine(k) for k in range(1000)]
    names = [made.record.name for made in machines]
    parted = sweep.run(fleet.identify, machines, names=names, client=workers)
    assert not parted.failures
    # Every tenth of them in this process, too.
    serial = sweep.run(fleet.identify, machines[::10], names=names[::10])
    assert [pickle.dumps(v) for v in parted.values()[::10]] == [pickle.dumps(v) for v in serial.values()]
    off = []
    for made, found in zip(machines, parted.values()):
        for name, truth in made.truth.items():
            assert found[f"{name} std"] > 0.0
            off.append((found[name] - truth) / found[f"{name} std"])
        assert abs(found["spindle.gain_1"] / made.truth["spindle.gain_1"] - 1.0) < 0.02, made.record.name
        assert abs(found["spindle.time_constant_1"] / made.truth["spindle.time_constant_1"] - 1.0) < 0.03
    # 4000 numbers of a standard normal distribution: their mean is known to 0.016, their square to 0.022.
    off = numpy.array(off)
    assert abs(off.mean()) < 0.08
    assert 0.9 < (off**2).mean() < 1.1
    assert abs(off).max() < 5.0


# --- the command


JOB = """
def items():
    return {f"bearing-{k}": 0.9 + 0.02 * k for k in range(10)}


def work(factor):
    import raceway

    if factor > 1.07:
        raise ValueError("too stiff, too far")
    model = raceway.Model.new("S 6014 C").with_values({"rolling_factor": factor})
    return {"factor": factor, "torque_Nmm": float(model.solve(6000.0, 300.0).friction_torque_Nmm)}
"""


@pytest.fixture
def job(tmp_path):
    (tmp_path / "job.py").write_text(JOB)

    def call(*arguments):
        return subprocess.run(
            [sys.executable, "-m", "raceway.sweep", *arguments],
            cwd=tmp_path,
            env=os.environ | {"PYTHONPATH": str(PACKAGE)},
            capture_output=True,
            text=True,
        )

    return call


def test_slabs_of_an_array_are_merged(job, tmp_path):
    for slab in ("2/3", "1/3"):
        done = job("run", "job.py", "--folder", "slabs", "--slab", slab)
        assert done.returncode == 0, done.stderr
    missing = job("merge", "slabs", "-o", "all.csv")
    assert missing.returncode == 1 and not (tmp_path / "all.csv").exists()
    assert missing.stderr == "error: slabs: slab 3 of 3 (items 7 to 10 of 10) is missing; run it again\n"
    third = job("run", "job.py", "--folder", "slabs", "--slab", "3/3")
    assert "1 of 4 items failed" in third.stderr and third.returncode == 0
    again = job("run", "job.py", "--folder", "slabs", "--slab", "3/3")
    assert again.stderr == "slabs/slab-3-of-3.sweep: exists already, 4 items\n"
    merged = job("merge", "slabs", "-o", "all.csv")
    assert merged.returncode == 0, merged.stderr
    rows = (tmp_path / "all.csv").read_text().splitlines()
    assert rows[0] == "name,factor,torque_Nmm,error" and rows[10] == 'bearing-9,,,"ValueError: too stiff, too far"'
    names = {"__name__": "job"}
    exec(JOB, names)
    for row, (name, factor) in list(zip(rows[1:], names["items"]().items()))[:9]:
        value = names["work"](factor)
        assert row == f"{name},{value['factor']!r},{value['torque_Nmm']!r},"
    assert job("merge", "slabs", "-o", "all.csv").returncode == 1  # is there
    parted = job("run", "job.py", "--folder", "dask", "--workers", "2", "--slabs", "4")
    assert parted.returncode == 0, parted.stderr
    assert job("merge", "dask", "-o", "-").stdout == (tmp_path / "all.csv").read_text()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "none.py", "--folder", "f", "--slab", "1/2"], "none.py: no such file"),
        (["run", "job.py", "--folder", "f", "--slab", "3/2"], "--slab 3/2: must be K/N with K from 1 to N, such as 3/8"),
        (["run", "job.py", "--folder", "f", "--slab", "1/11"], "--slab 1/11: N must be at most 10, the number of items"),
        (["run", "job.py", "--folder", "f", "--slab", "1/2", "--client", "tcp://h:1"], "--client: not possible together with --slab"),
        (["merge", "empty", "-o", "x.csv"], "empty: has no slabs (files *.sweep)"),
    ],
)
def test_the_command_says_what_is_wrong(job, arguments, words):
    done = job(*arguments)
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: {words}"), done.stderr


def test_a_slab_of_another_job_is_refused(job, tmp_path):
    assert job("run", "job.py", "--folder", "slabs", "--slab", "1/2").returncode == 0
    (tmp_path / "job.py").write_text(JOB.replace("6000.0", "7000.0"))
    done = job("run", "job.py", "--folder", "slabs", "--slab", "2/2")
    assert done.returncode == 1 and "slab-1-of-2.sweep: comes from another input" in done.stderr
    assert job("run", "job.py", "--folder", "slabs2", "--slab", "2/2").returncode == 0
    (tmp_path / "slabs2/slab-2-of-2.sweep").rename(tmp_path / "slabs/slab-2-of-2.sweep")
    merged = job("merge", "slabs", "-o", "all.csv")
    assert merged.returncode == 1 and "comes from another input than" in merged.stderr


def test_docs_scale_shows_what_the_command_does(job, root, tmp_path):
    page = (root / "docs/scale.md").read_text()
    code = page.split("```python\n# job.py\n")[1].split("```")[0]
    (tmp_path / "job.py").write_text(code)
    task = page.split("\npython3 -m raceway.sweep ")[1].split("\n")[0].split()
    said = page.split("$ python3 -m raceway.sweep merge slabs -o result.csv\n")[1].split("\n")[0]
    for number in "13":
        done = job(*[word.replace("$SLURM_ARRAY_TASK_ID", number) for word in task])
        assert done.returncode == 0, done.stderr
    assert job("merge", "slabs", "-o", "result.csv").stderr == said + "\n"
    job(*[word.replace("$SLURM_ARRAY_TASK_ID", "2") for word in task])
    assert job("merge", "slabs", "-o", "result.csv").returncode == 0
    rows = (tmp_path / "result.csv").read_text().splitlines()
    model = raceway.Model.new("S 6014 C", law="palmgren").with_values({"f0": 0.8})
    assert rows[1] == f"factor 0.8,0.8,{model.solve(6000, 300).data['friction_torque_Nmm']!r},"
    assert len(rows) == 6


def test_a_header_can_be_read_by_other_programs(tmp_path):
    sweep.run(root_of, [1.0, 4.0], folder=tmp_path, slabs=1)
    header = json.loads((tmp_path / "slab-1-of-1.sweep").read_bytes().split(b"\n", 1)[0])
    assert (header["slab"], header["slabs"], header["items"], header["version"]) == (1, 1, 2, raceway.__version__)
    assert [file.name for file in tmp_path.iterdir()] == ["slab-1-of-1.sweep"]


def test_texts_of_a_merged_table_are_no_formulas(tmp_path):
    from raceway._sweep_command import main

    names = ["=1+1", "@SUM(A1)", "plain"]
    sweep.run(lambda item: {"remark": "-x" if item else "'+y", "=n": -2.5}, [0, 1, 2], names=names, folder=tmp_path / "slabs")
    assert main(["merge", str(tmp_path / "slabs"), "-o", str(tmp_path / "all.csv")]) == 0
    assert (tmp_path / "all.csv").read_text().splitlines() == ["name,remark,'=n,error", "'=1+1,''+y,-2.5,", "'@SUM(A1),'-x,-2.5,", "plain,'-x,-2.5,"]

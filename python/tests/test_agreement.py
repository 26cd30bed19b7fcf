"""What Python says is what the command says."""

import json
import pickle
import math
import subprocess
import warnings

import numpy
import pytest

import raceway

RIG = "tests/hidden_effect/rigs/dev-03"
SHAFT = "data/spindles/small.toml"


@pytest.fixture
def command(program, root):
    """Run the command and take its document."""

    def run(*arguments):
        done = subprocess.run([program, *arguments, "--json", "--quiet"], cwd=root, capture_output=True, text=True)
        assert done.stdout, done.stderr
        return json.loads(done.stdout)

    return run


@pytest.fixture(autouse=True)
def in_root(root, monkeypatch):
    monkeypatch.chdir(root)
    warnings.simplefilter("ignore", raceway.Doubt)


def test_one_state(command):
    model = raceway.Model.read("data/examples/race-control.toml")
    expected = command("solve", model.source, "--speed", "10000", "--axial-load", "500")
    assert model.solve(10000, 500).data == expected


def test_values_of_one_state_are_those_of_its_document():
    model = raceway.Model.new("S 6014 C")
    state = model.solve(6000, 300)
    same = [name for name in state if isinstance(state.data.get(name), float)]
    assert {"friction_torque_Nmm", "power_loss_W", "axial_displacement_um", "kappa"} <= set(same)
    assert all(float(state[name]) == state.data[name] for name in same)
    assert float(state.axial_stiffness_N_um) == pytest.approx(state.data["stiffness"]["axial_N_um"], rel=1e-12)
    assert float(state.inner_load_max_N) == pytest.approx(max(ball["inner_load_N"] for ball in state.data["balls"]), rel=1e-12)


def test_many_states_are_the_single_ones():
    model = raceway.Model.new("S 6014 C")
    speeds, loads = numpy.meshgrid([0.0, 3000.0, 15000.0], [50.0, 800.0])
    many = model.solve(speeds, loads, radial_load_N=20.0)
    for place in numpy.ndindex(speeds.shape):
        one = model.solve(speeds[place], loads[place], 20.0)
        # Sliding is summed in single precision side by side (docs/speed.md).
        assert many.friction_torque_Nmm[place] == pytest.approx(float(one.friction_torque_Nmm), rel=1e-5)
        assert many.axial_displacement_um[place] == pytest.approx(float(one.axial_displacement_um), rel=1e-12)


def test_torque_of_sets(command, tmp_path):
    bearing = raceway.Model.new("S 6014 C", law="palmgren").text
    sets = bearing.replace('free = ["f0", "z"]', 'free = ["preload_N"]') + '\n[arrangement]\nlayout = "O"\nfront = 1\nrear = 1\npreload_N = {}\n'
    truth = raceway.Model.from_text(sets.replace("{}", "900"))
    frame = truth.table(range(1000, 16001, 3000), [0, 400, 1500]).to_frame()
    frame = frame[["speed_rpm", "axial_load_N", "temperature_C", "friction_torque_Nmm"]]
    record = raceway.Record.from_pandas(frame)
    model = raceway.Model.from_text(sets.replace("{}", "600"))
    found = model.calibrate(record)
    assert found.parameters["preload_N"]["value"] == pytest.approx(900, rel=1e-3)
    model.save(tmp_path / "my.toml")
    frame.to_csv(tmp_path / "rows.csv", index=False)
    assert found.data["parameters"] == command("calibrate", str(tmp_path / "my.toml"), str(tmp_path / "rows.csv"))["parameters"]


def test_table(command, tmp_path):
    model = raceway.Model.new("S 6014 C")
    file = tmp_path / "my.toml"
    model.save(file)
    table = model.table([0, 4000, 8000], [100, 300], temperature_C=[30, 60])
    expected = command("table", str(file), "--speed", "0,4000,8000", "--axial-load", "100,300", "--temperature", "30,60")
    assert table.data == expected
    frame = table.to_frame()
    assert len(frame) == 12
    for row, of_command in zip(frame.to_dict("records"), expected["rows"]):
        assert row.keys() == of_command.keys()
        for name, value in of_command.items():
            if value is None:  # no film at standstill, a life without end
                assert not math.isfinite(row[name]), name
            else:
                assert row[name] == value or math.isclose(row[name], value, rel_tol=1e-14), name


def test_displacement(command):
    model = raceway.Model.read(SHAFT)
    curve = model.displacement([0, 5000, 10000])
    assert curve.data == command("displacement", SHAFT, "--speed", "0,5000,10000")
    assert curve.to_frame()["axial_displacement_um"].tolist() == pytest.approx(
        [row["axial_displacement_um"] for row in curve.data["rows"]], rel=1e-11
    )


def test_speeds_without_a_position_are_doubts():
    text = raceway.Model.read("data/spindles/two_against_one.toml").text
    spring = raceway.Model.from_text(text.replace('mounting = "rigid"', 'mounting = "spring"'))
    with pytest.warns(raceway.Doubt, match="2 of 2 speeds have no value; the first is 0 rpm: no_equilibrium") as told:
        spring.displacement([0, 3000], axial_load_N=900)
    assert "no-prediction" in [doubt.message.note.code for doubt in told]


def test_compare(command):
    model = raceway.Model.read(f"{RIG}/model.toml")
    record = raceway.Record.read(f"{RIG}/test.csv")
    assert model.compare(record).data == command("compare", model.source, record.name)
    refitted = model.compare(record, refit=["f0", "z"])
    assert refitted.data == command("compare", model.source, record.name, "--refit", "f0,z")


def test_rows_of_a_comparison_have_its_error():
    model = raceway.Model.read(f"{RIG}/model.toml")
    comparison = model.compare(raceway.Record.read(f"{RIG}/test.csv"))
    error = comparison.to_frame()["error"]
    assert math.sqrt((error**2).mean()) == pytest.approx(comparison.rmse, rel=1e-12)
    assert comparison.unit == "Nmm"


def test_calibrate(command):
    model = raceway.Model.read(f"{RIG}/model.toml")
    record = raceway.Record.read(f"{RIG}/train.csv")
    found = model.calibrate(record)
    assert found.data == command("calibrate", model.source, record.name)
    assert found.model.parameters["f0"]["value"] == pytest.approx(found.parameters["f0"]["value"], rel=1e-14)


def test_diagnose_and_add(command, tmp_path):
    model = raceway.Model.read(f"{RIG}/model.toml")
    train, test = (raceway.Record.read(f"{RIG}/{name}.csv") for name in ("train", "test"))
    found = model.diagnose(train)
    assert found.data == command("diagnose", model.source, train.name)
    assert found.effects == ["lubricant-drag"]
    added = model.add(found.effects, train)
    assert added.data == command("add", model.source, "lubricant-drag", "--data", train.name)
    assert added.refused == ""
    assert added.model.compare(test).rmse < 0.2 * model.compare(test).rmse


def test_a_file_as_a_german_excel_writes_it():
    model = raceway.Model.new("S 6014 C", law="palmgren")
    path = "data/measurements/german_export.csv"
    with pytest.raises(raceway.InputError):
        model.diagnose(raceway.Record.read(path))
    columns = model.suggest_columns(raceway.Record.read(path))
    found = model.diagnose(raceway.Record.read(path, columns=columns, drop_nan=True))
    assert found.effects == ["lubricant-drag"]  # as README has it from the command
    assert "60.6 +- 0.61 N mm" in found.data["sentence"]


def test_a_page_is_that_of_the_command(program, root, tmp_path):
    model = raceway.Model.read(f"{RIG}/model.toml")
    record = raceway.Record.read(f"{RIG}/train.csv")
    file = tmp_path / "page.html"
    subprocess.run([program, "diagnose", model.source, record.name, "--quiet", "--report", str(file)], cwd=root, capture_output=True, check=True)
    assert model.diagnose(record).report().html == file.read_text()


def test_a_spindle_is_known_as_one():
    model = raceway.Model.read("data/spindles/small.toml")
    assert model.kind == "spindle"


def test_a_single_state_goes_to_other_processes():
    state = raceway.Model.new("S 6014 C").solve(6000, 300)
    again = pickle.loads(pickle.dumps(state))
    assert again.data == state.data and float(again.friction_torque_Nmm) == float(state.friction_torque_Nmm)

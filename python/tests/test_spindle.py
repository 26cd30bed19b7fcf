"""Spindles in Python say what the commands spindle, modes, deflection and step-response say, to the
digit, and wrong use is told in their words."""

from __future__ import annotations

import _thread
import io
import json
import pickle
import re
import subprocess
import threading
import time
import warnings

import numpy as np
import pandas as pd
import pytest
from matplotlib import pyplot as plt

import raceway
from raceway import plot

SMALL = "data/spindles/small.toml"
DRIVEN = "data/spindles/externally_driven.toml"
JUMP = pd.DataFrame({"time_s": [0, 600, 3600], "speed_rpm": [0, 8000, 8000]})
TOO_FAST = pd.DataFrame({"time_s": [0, 600, 700], "speed_rpm": [0, 3000, 60000]})


def record(frame: pd.DataFrame) -> raceway.Record:
    return raceway.Record.from_pandas(frame)


@pytest.fixture(scope="module")
def small(root):
    return raceway.Model.from_text((root / SMALL).read_text(), SMALL)


@pytest.fixture(scope="module")
def driven(root):
    return raceway.Model.from_text((root / DRIVEN).read_text(), DRIVEN)


@pytest.fixture(scope="module")
def jump(tmp_path_factory):
    path = tmp_path_factory.mktemp("spindle") / "jump.csv"
    JUMP.to_csv(path, index=False)
    return str(path)


@pytest.fixture(scope="module")
def run_of_jump(driven, jump):
    return driven.simulate(raceway.Record.read(jump))


def frame_of(text: str) -> pd.DataFrame:
    return pd.read_csv(io.StringIO(text), comment="#")


def test_steady_states_are_those_of_the_command(small, driven, document, csv):
    several = small.steady([0, 3000, 6000])
    assert several.data == document("spindle", SMALL, "--steady", "--speed", "0,3000,6000")
    asked = ("spindle", DRIVEN, "--steady", "--speed", "6000", "--coolant", "off", "--ambient", "25")
    off = driven.steady(6000, coolant=False, ambient_temperature_C=25)
    assert off.data == document(*asked)
    pd.testing.assert_frame_equal(off.to_frame(), csv(*asked), check_exact=True)
    assert off.converged and off.status == ["converged"]


CIRCUIT = """
[[coolant.circuit]]
name = "jacket"
flow_l_min = 4
inlet_temperature_C = 25
diameter_mm = 140
channel_width_mm = 10
channel_depth_mm = 4
pitch_mm = 14
start_mm = 190
end_mm = 300
"""


def test_circuits_surfaces_and_stress_are_those_of_the_command(root, tmp_path, document):
    text = (root / DRIVEN).read_text().replace("end_mm = 300.0", "end_mm = 180.0") + CIRCUIT
    path = tmp_path / "circuits.toml"
    path.write_text(text)
    states = raceway.Model.read(path).steady(6000)
    assert states.data == document("spindle", str(path), "--steady", "--speed", "6000")
    state = states.data["steady"][0]
    assert [c["name"] for c in state["circuits"]] == ["coolant", "jacket"]
    assert states.to_frame()["heat_to_jacket_W"][0] == pytest.approx(state["circuits"][1]["heat_W"], rel=1e-9)
    assert {"flange", "housing", "jacket"} < {s["name"] for s in state["surfaces"]}
    assert state["stress"]["largest"]["von_mises_MPa"] > 10


def test_a_clamping_force_is_that_of_the_command(root, tmp_path, document):
    text = (root / DRIVEN).read_text()
    path = tmp_path / "clamped.toml"
    path.write_text(text.replace("[seat]", "[seat]\ninner_clamping_force_N = 8000"))
    states = raceway.Model.read(path).steady(6000)
    assert states.data == document("spindle", str(path), "--steady", "--speed", "6000")
    faces = {s["name"]: s for s in states.data["steady"][0]["surfaces"]}
    assert faces["front_1_inner_front"]["pressure_MPa"] == pytest.approx(8000 / (np.pi / 4 * (82**2 - 70**2)), rel=1e-9)
    with pytest.raises(raceway.InputError, match="the clamping force acts on no face"):
        raceway.Model.from_text(text.replace("[seat]", "[seat]\nouter_clamping_force_N = 5000"), "m.toml")


def test_inlet_and_flow_of_a_circuit_are_parameters(root):
    text = (root / DRIVEN).read_text().replace("end_mm = 300.0", "end_mm = 180.0") + CIRCUIT
    model = raceway.Model.from_text(text, "circuits.toml")
    numbers = model.parameters
    assert numbers["jacket.inlet_temperature_C"]["value"] == pytest.approx(25)
    assert numbers["jacket.flow_l_min"]["value"] == pytest.approx(4)
    warmer = model.with_values({"jacket.inlet_temperature_C": 28})
    assert warmer.steady(6000).data["steady"][0]["circuits"][1]["inlet_temperature_C"] == pytest.approx(28)


def test_a_run_is_that_of_the_command(run_of_jump, driven, jump, document, csv):
    asked = ("spindle", DRIVEN, "--speed-profile", jump)
    assert run_of_jump.data == document(*asked)
    pd.testing.assert_frame_equal(run_of_jump.to_frame(), csv(*asked), check_exact=True)
    warm = driven.simulate(record(JUMP), coolant=False, ambient_temperature_C=30)
    assert warm.data == document(*asked, "--coolant", "off", "--ambient", "30")
    assert warm.data["rows"][0]["front_1_inner_ring_temperature_C"] == pytest.approx(30.0)


def test_end_state_and_field_are_those_of_the_command(run_of_jump, program, jump, root, tmp_path):
    files = [str(tmp_path / name) for name in ("end.json", "field.csv", "run.csv")]
    subprocess.run(
        [program, "spindle", DRIVEN, "--speed-profile", jump, "--end-state", files[0], "--field", files[1], "-o", files[2]],
        cwd=root,
        check=True,
        capture_output=True,
    )
    with open(files[0], encoding="utf-8") as end:
        assert run_of_jump.end_state == end.read()
    pd.testing.assert_frame_equal(run_of_jump.field(), pd.read_csv(files[1], comment="#"), check_exact=True)
    run_of_jump.save(tmp_path / "own.csv")
    assert (tmp_path / "own.csv").read_bytes() == (tmp_path / "run.csv").read_bytes()
    with pytest.raises(FileExistsError):
        run_of_jump.save(tmp_path / "own.csv")
    run_of_jump.save(tmp_path / "own.csv", overwrite=True)


def test_a_run_goes_on_from_the_end_of_another(driven, tmp_path):
    whole = pd.DataFrame({"time_s": [0, 1800, 3600], "speed_rpm": [0, 6000, 2000]})
    first = driven.simulate(record(whole[:2]))
    after = driven.simulate(record(whole[2:]), start=first)
    at_once = driven.simulate(record(whole))
    # The first run ends where the other changes its speed: the steps are the same.
    assert after.data["rows"][-1] == pytest.approx(at_once.data["rows"][-1], rel=1e-9, abs=1e-9)
    path = tmp_path / "end.json"
    path.write_text(first.end_state)
    for start in (first.end_state, path, str(path)):
        assert driven.simulate(record(whole[2:]), start=start).data == after.data
    steady = driven.steady(6000)
    on = pd.DataFrame({"time_s": [0, 600], "speed_rpm": [6000, 6000]})
    stays = driven.simulate(record(on), start=steady)
    nose = [row["axial_displacement_um"] for row in stays.data["rows"]]
    assert nose == pytest.approx([steady.data["steady"][0]["axial_displacement_um"]] * 2, abs=1e-3)


def test_a_run_that_ends_early_has_the_rows_before(small):
    with pytest.warns(raceway.Doubt, match="thermal runaway.*2 of 3"):
        run = small.simulate(record(TOO_FAST))
    assert not run.converged and run.status == "thermal_runaway"
    rows = run.data["rows"]
    assert 0 < len(rows) <= 3 and run.data["rows_asked"] == 3
    assert run.data["rows_reached"] < 3 and len(rows) - run.data["rows_reached"] <= 1
    assert len(run.to_frame()) == len(rows)
    assert json.loads(run.end_state)["time_s"] >= rows[-1]["time_s"]
    assert "thermal runaway" in run._repr_html_() and "thermal_runaway" in repr(run)
    axes = plot.spindle_run(run)
    # The highest force is between the last row and the end.
    assert axes[2].lines[-1].get_ydata()[0] == run.data["highest_front_force"]["force_N"]


def test_a_speed_without_steady_state_is_a_doubt(small):
    with pytest.warns(raceway.Doubt, match="60000 rpm: thermal_runaway"):
        states = small.steady([3000, 60000])
    assert states.status == ["converged", "thermal_runaway"] and not states.converged
    assert "thermal_runaway" in states._repr_html_()
    with pytest.raises(ValueError, match="need a single speed with a steady state"):
        states.end_state


def test_modes_and_shapes_are_those_of_the_command(small, driven, document, csv, run):
    asked = ("modes", SMALL, "--speed", "0:10000:5000")
    found = small.modes([0, 5000, 10000])
    assert found.data == document(*asked)
    pd.testing.assert_frame_equal(found.to_frame(), csv(*asked), check_exact=True)
    warm = ("modes", DRIVEN, "--speed", "4000,8000", "--warm", "--coolant", "off", "--modes", "3")
    of_warm = driven.modes([4000, 8000], warm=True, coolant=False, count=3)
    assert of_warm.data == document(*warm)
    pd.testing.assert_frame_equal(of_warm.shapes(), frame_of(run(*warm, "--shapes", "-")), check_exact=True)
    assert found.notes == ["the model does not include damping, so damping_ratio is empty; the model does not include the deflection of the housing"]
    ax = plot.campbell(found)
    assert list(ax.lines[0].get_xdata()) == [0, 5000, 10000]
    shaken = ("modes", SMALL, "--speed", "5000,10000", "--damping", "0.02", "--unbalance", "5", "--unbalance-at", "20")
    under = small.modes([5000, 10000], damping_ratio=0.02, unbalance_gmm=5, unbalance_at_mm=20)
    assert under.data == document(*shaken)
    assert under.data["rows"][1]["nose_amplitude_um"] > under.data["rows"][0]["nose_amplitude_um"] > 0
    assert under.data["crossings"] and under.data["rows"][0]["modes"][0]["damping_ratio"] == 0.02
    with pytest.raises(raceway.InputError, match="give a damping ratio as well"):
        small.modes([5000], unbalance_gmm=5)
    with pytest.warns(raceway.Doubt, match="110000 rpm: not_held"):
        small.modes([5000, 110000])
    with pytest.raises(raceway.InputError, match="speed_rpm = 200000 rpm: must be from 0 to 123197 rpm"):
        small.modes([5000, 200000])


def test_a_hot_spindle_is_doubted(driven, document):
    with pytest.warns(raceway.Doubt, match="times the mounted preload of 300 N"):
        hot = driven.steady(15000)
    assert [f["limit"] for f in hot.data["judgement"]] == ["ring_temperature", "preload_factor"]
    assert hot.data["judgement"] == document("spindle", DRIVEN, "--speed", "15000", "--steady")["judgement"]


@pytest.mark.parametrize(
    "flags, arguments",
    [
        (["--force", "1000", "--speed", "8000", "--warm"], {"force_N": 1000, "speed_rpm": 8000, "warm": True}),
        (
            ["--force", "1000", "--axial-force", "-300", "--moment", "100", "--at", "40", "--coolant", "off"],
            {"force_N": 1000, "axial_force_N": -300, "moment_Nm": 100, "at_mm": 40, "coolant": False},
        ),
        (["--force", "500", "--direction", "axial"], {"force_N": 500, "direction": "axial"}),
    ],
)
def test_deflections_are_those_of_the_command(driven, document, csv, flags, arguments):
    bent = driven.deflection(**arguments)
    assert bent.data == document("deflection", DRIVEN, *flags)
    pd.testing.assert_frame_equal(bent.to_frame(), csv("deflection", DRIVEN, *flags), check_exact=True)
    assert bent.displacement_um == bent.data["displacement_um"] and bent.status == "converged"


def test_step_responses_and_their_correction_are_those_of_the_command(driven, document, csv, program, root, tmp_path):
    asked = ("step-response", DRIVEN, "--speed", "2000:6000:2000", "--hours", "2")
    steps = driven.step_response([2000, 4000, 6000], duration_h=2)
    assert steps.data == document(*asked)
    pd.testing.assert_frame_equal(steps.to_frame(), csv(*asked), check_exact=True)
    (tmp_path / "cli").mkdir()
    (tmp_path / "own").mkdir()
    subprocess.run([program, *asked, "--correction", str(tmp_path / "cli" / "k.toml"), "--json"], cwd=root, check=True, capture_output=True)
    steps.save_correction(tmp_path / "own" / "k.toml")
    theirs = {p.name: p.read_text() for p in (tmp_path / "cli").iterdir()}
    assert {p.name: p.read_text() for p in (tmp_path / "own").iterdir()} == theirs and len(theirs) > 1
    day = "data/spindles/day.csv"
    found = steps.superposition(tmp_path / "own" / "k.toml", raceway.Record.read(root / day))
    held = ("--programme", day, "--force", "--correction", str(tmp_path / "cli" / "k.toml"))
    assert found == document(*asked, *held)["superposition"] and found["rms_um"] > 0.0
    with pytest.raises(FileExistsError, match="overwrite=True"):
        steps.save_correction(tmp_path / "own" / "k.toml")
    with pytest.raises(ValueError, match="law = 'cubic'"):
        steps.save_correction(tmp_path / "k.toml", law="cubic")


def test_steps_of_loads_are_those_of_the_command(driven, document, csv):
    asked = ("step-response", DRIVEN, "--speed", "4000", "--axial-load=-300,500", "--radial-load", "400", "--hours", "2")
    steps = driven.step_response([4000], axial_load_N=[-300, 500], radial_load_N=400, duration_h=2)
    assert steps.data == document(*asked)
    assert [row["axial_load_N"] for row in steps.data["load_rows"]] == [-300, 500, None]
    assert len(steps.status) == 4
    pd.testing.assert_frame_equal(steps.to_frame(), csv(*asked), check_exact=True)
    with pytest.raises(raceway.InputError, match="axial_load_N: the values must be in ascending order"):
        driven.step_response([4000], axial_load_N=[500, -300])
    with pytest.raises(raceway.InputError, match="load_speed_rpm"):
        driven.step_response([4000], load_speed_rpm=[4000])


def test_load_cases_of_another_program_are_fitted(small, document, tmp_path):
    hours = np.linspace(0.0, 3.0, 31)
    frame = pd.concat(
        [
            pd.DataFrame({"load_case": name, "time_s": 3600 * hours, "speed_rpm": speed, "axial_displacement_um": gain * (1 - np.exp(-hours / 0.5))})
            for name, speed, gain in (("slow", 3000.0, 12.0), ("fast", 6000.0, 30.0))
        ]
    )
    path = tmp_path / "cases.csv"
    frame.to_csv(path, index=False)
    steps = small.step_response(load_cases=raceway.Record.read(path), temperature_C=35)
    assert steps.data == document("step-response", SMALL, "--import", str(path), "--temperature", "35")
    assert [(r["K_um"], r["T_min"]) for r in steps.data["rows"]] == [pytest.approx((12.0, 30.0), rel=1e-4), pytest.approx((30.0, 30.0), rel=1e-4)]
    with pytest.raises(TypeError, match="give exactly one of the two"):
        small.step_response([3000], load_cases=raceway.Record.read(path))


@pytest.fixture(scope="module")
def results(small, driven, run_of_jump):
    return [
        driven.steady(6000),
        small.steady([0, 3000, 6000]),
        run_of_jump,
        small.modes([0, 5000]),
        driven.deflection(1000, moment_Nm=50),
        driven.step_response([2000, 4000], duration_h=2),
    ]


def test_results_show_themselves(results, tmp_path):
    for k, result in enumerate(results):
        html = result._repr_html_()
        assert html.startswith("<div") and html.count("<table") == html.count("</table>") >= 1
        assert "nan" not in html.lower() and "None" not in html
        page = result.report(tmp_path / f"{k}.html").html
        assert (tmp_path / f"{k}.html").read_text(encoding="utf-8") == page and page.startswith("<!")
        assert repr(result).startswith(f"<raceway.{type(result).__name__}")
    one, several, of_run = (r._repr_html_() for r in results[:3])
    state = results[0].data["steady"][0]
    for shown in (
        f"{state['front_force_N']:.0f} N front",
        f"{state['axial_displacement_um']:.4g} µm",
        f"{state['rear_1_inner_ring_temperature_C']:.3g}",
        "coolant outlet",
    ):
        assert shown in one
    # Rounding leaves a trace at standstill, which nobody wants to read.
    assert not re.search(r"\de-\d", several)
    assert f"{results[2].data['highest_front_force']['force_N']:.0f}" in of_run


def test_a_run_is_drawn_over_time(run_of_jump, driven):
    axes = plot.spindle_run(run_of_jump)
    assert [one.get_ylabel().replace("\n", " ") for one in axes] == ["Speed in rpm", "Nose in µm", "Front force in N", "Hottest ring in °C"]
    rows = run_of_jump.data["rows"]
    assert axes[-1].get_xlabel() == "Time in min"
    assert list(axes[1].lines[0].get_xdata()) == [row["time_s"] / 60 for row in rows]
    assert list(axes[1].lines[0].get_ydata()) == [row["axial_displacement_um"] for row in rows]
    rings = [max(v for key, v in row.items() if "_ring_temperature" in key) for row in rows]
    assert list(axes[3].lines[0].get_ydata()) == rings
    highest = run_of_jump.data["highest_front_force"]
    mark = axes[2].lines[-1].get_xydata()[0].tolist()
    assert mark == pytest.approx([highest["time_s"] / 60, highest["force_N"]])
    assert axes[0].lines[0].get_drawstyle() == "steps-pre"
    figure, given = plt.subplots(4, 1, sharex=True)
    assert plot.spindle_run(run_of_jump, ax=given) == list(given)
    with pytest.raises(ValueError, match="needs 4 axes"):
        plot.spindle_run(run_of_jump, ax=given[:2])
    with pytest.raises(TypeError, match="accepts a SpindleRun, not 'SteadyStates'"):
        plot.spindle_run(driven.steady(3000))


@pytest.mark.parametrize(
    "frame, words",
    [
        (pd.DataFrame({"speed_rpm": [0, 6000]}), "column time_s is missing"),
        (pd.DataFrame({"time_s": [0, 600]}), "column speed_rpm is missing"),
        (pd.DataFrame({"time_s": [-5, 600], "speed_rpm": [0, 6000]}), "a programme must begin at 0 s or later"),
        (pd.DataFrame({"time_s": [0, 600], "speed_rpm": [0, 2e7]}), "speed_rpm = 20000000: must be from"),
        (pd.DataFrame({"time_s": [0, 600], "speed_rpm": [0, 1], "run_id": [1, 2]}), "2 runs"),
    ],
)
def test_profiles_that_are_none_are_refused(small, frame, words):
    with pytest.raises(raceway.InputError, match=words):
        small.simulate(record(frame))


@pytest.mark.parametrize(
    "ask, error, words",
    [
        (lambda m: m.steady(-3), raceway.InputError, "speed_rpm = -3 rpm: must be from 0 to 1000000 rpm"),
        (lambda m: m.steady([5000, 3000]), raceway.InputError, "speed_rpm: the values must be in ascending order"),
        (lambda m: m.steady([]), raceway.InputError, "speed_rpm is missing"),
        (lambda m: m.steady(float("nan")), raceway.InputError, "speed_rpm = nan rpm"),
        (lambda m: m.steady("fast"), TypeError, "speed_rpm: must contain numbers, not text"),
        (lambda m: m.steady(6000, ambient_temperature_C=500), raceway.InputError, "must be from -100 to 400 C"),
        (lambda m: m.steady(6000, ambient_temperature_C="20"), TypeError, "ambient_temperature_C: must be a number"),
        (lambda m: m.steady(6000, coolant="off"), TypeError, "coolant: must be True or False, not 'off'"),
        (lambda m: m.simulate("day.csv"), TypeError, "must be a raceway.Record, not str"),
        (lambda m: m.simulate(record(JUMP), start="{warm"), raceway.InputError, "start: is not JSON"),
        (lambda m: m.simulate(record(JUMP), start="warm.json"), raceway.InputError, "warm.json: "),
        (lambda m: m.simulate(record(JUMP), start=20.0), TypeError, "start: must be the end_state of a result"),
        (lambda m: m.modes(0, count=41), raceway.InputError, "count = 41 modes: must be from 1 to 40"),
        (lambda m: m.modes(0, count=2.5), TypeError, "count: must be a whole number"),
        (lambda m: m.deflection(), raceway.InputError, "force_N = 0 N: give a force, or a moment with moment_Nm"),
        (lambda m: m.deflection(1, direction="up"), ValueError, "direction = 'up': must be radial or axial"),
        (lambda m: m.deflection(1, direction="axial", moment_Nm=3), raceway.InputError, "moment_Nm needs a radial force_N"),
        (lambda m: m.deflection(1, at_mm=-1), raceway.InputError, "at_mm = -1 mm: must be from 0"),
        (lambda m: m.step_response(0), raceway.InputError, "0 speeds above 0 rpm"),
        (lambda m: m.step_response(2000, duration_h=0.01), raceway.InputError, "duration_h = 0.01 h: must"),
    ],
)
def test_wrong_use_is_told(small, ask, error, words):
    with pytest.raises(error, match=words):
        ask(small)


def test_models_that_are_no_spindle_are_refused_as_the_command_does(root, program):
    for path in ("data/examples/7014.toml", "data/spindles/published_curve.toml"):
        model = raceway.Model.from_text((root / path).read_text(), path)
        done = subprocess.run([program, "spindle", path, "--steady", "--speed", "6000"], cwd=root, capture_output=True, text=True)
        for ask in (lambda: model.steady(6000), lambda: model.simulate(record(JUMP)), lambda: model.step_response(6000)):
            with pytest.raises(raceway.InputError) as told:
                ask()
            assert str(told.value) in done.stderr
        for ask in (lambda: model.modes(0), lambda: model.deflection(100)):
            with pytest.raises(raceway.InputError, match=r"has no \[shaft\] with segments"):
                ask()


def test_a_state_of_another_spindle_is_refused(small, driven):
    with pytest.raises(raceway.InputError, match="the saved state belongs to another spindle or another mesh"):
        small.simulate(record(JUMP), start=driven.steady(3000))


def test_kelvin_is_doubted(small):
    with pytest.warns(raceway.Doubt, match="ambient_temperature_C = 293.15 C: the value is probably in kelvin"):
        small.steady(100, ambient_temperature_C=293.15)
    with pytest.warns(raceway.Doubt) as told:
        small.simulate(record(JUMP.assign(ambient_temperature_C=293.15)))
    assert any("the value is probably in kelvin" in str(one.message) for one in told)


def long_programme(minutes: int) -> raceway.Record:
    """Every row a change of speed, which is a time step at least."""
    time_s = 60.0 * np.arange(minutes)
    return record(pd.DataFrame({"time_s": time_s, "speed_rpm": 3000.0 + 1000.0 * (np.arange(minutes) % 2)}))


def test_a_simulation_can_be_stopped(driven):
    programme = long_programme(200_000)
    threading.Timer(0.5, _thread.interrupt_main).start()
    begun = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        driven.simulate(programme)
    with pytest.raises(TimeoutError, match="allow more time with time_limit_s"):
        driven.simulate(programme, time_limit_s=0.3)
    assert time.perf_counter() - begun < 8.0
    speeds = np.linspace(0.0, 9000.0, 100_000)
    with pytest.raises(TimeoutError):
        driven.steady(speeds, time_limit_s=0.3)
    threading.Timer(0.5, _thread.interrupt_main).start()
    with pytest.raises(KeyboardInterrupt):
        driven.modes(speeds[::10], warm=True)
    with pytest.raises(TimeoutError):
        driven.step_response(np.linspace(10.0, 9000.0, 999), duration_h=1000, time_limit_s=0.3)
    # Nothing is left half done.
    assert driven.steady(3000).data == driven.steady(3000).data


def test_other_threads_go_on_meanwhile(driven):
    counted = 0
    done = threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    begun = time.perf_counter()
    driven.simulate(long_programme(1500))
    elapsed = time.perf_counter() - begun
    done.set()
    other.join()
    assert counted > 50 * elapsed


def test_several_threads_ask_one_result(run_of_jump):
    pages: list[str] = []

    def ask() -> None:
        pages.append(run_of_jump.report().html)

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(pages) == 4 and len(set(pages)) == 1


def test_loads_and_roller_bearings_are_those_of_the_command(root, document):
    path = "data/spindles/belt_driven.toml"
    model = raceway.Model.from_text((root / path).read_text(), path)
    state = model.steady(6000, radial_load_N=300, moment_Nm=-10, belt_force_N=1200)
    said = document("spindle", path, "--speed", "6000", "--steady", "--radial-load", "300", "--moment=-10", "--belt-force", "1200")
    assert state.data["steady"] == said["steady"]
    assert state.to_frame()["belt_end_radial_force_N"][0] > 800
    assert "belt end" in state._repr_html_()
    loads = pd.DataFrame({"time_s": [600, 1200], "speed_rpm": [6000, 6000], "belt_force_N": [0, 1500], "moment_Nm": [0, -5]})
    frame = model.simulate(record(loads)).to_frame()
    assert frame["belt_end_radial_force_N"].round(3)[0] == 0 and frame["belt_end_radial_force_N"][1] > 1000
    with pytest.raises(raceway.InputError, match="moment_Nm"):
        model.steady(6000, moment_Nm=1e9)


def test_what_is_found_gives_no_warning(driven):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        driven.steady(6000)
        driven.modes(6000)
        driven.deflection(100)


def test_a_spindle_of_a_template_runs():
    model = raceway.Model.new("S 6010 E", spindle=True)
    assert model.kind == "spindle"
    assert "assumed" in model.text
    assert model.steady(3000).data["steady"][0]["report"]["status"] == "converged"


def test_heat_at_a_place_and_the_assumptions_are_those_of_the_command(tmp_path, document):
    heated = tmp_path / "heated.toml"
    with open(SMALL, encoding="utf-8") as file:
        text = file.read()
    heated.write_text(text + '\n[[heat]]\nname = "belt"\nat = "rear_1"\nheat_W = "0.02*motor_power_W"\n', encoding="utf-8")
    model = raceway.Model.read(heated)
    state = model.steady(6000, motor_power_W=2000, assumptions=True)
    assert state.data == document("spindle", heated, "--speed", "6000", "--steady", "--motor-power", "2000", "--assumptions")
    assert state.data["steady"][0]["belt_heat_W"] == pytest.approx(40)
    assert len(state.data["assumptions"]["most"]) == 5
    with pytest.raises(raceway.InputError, match="motor_power_W, which is not given"):
        model.steady(6000)


def test_a_friction_table_heats_a_spindle(root, tmp_path):
    rig = raceway.Model.from_text((root / "data/examples/7014.toml").read_text(), "7014.toml")
    torque = rig.table([0, 2000, 4000, 6000, 8000], [50, 300, 600, 1500], temperature_C=[15, 30, 45, 70]).to_frame()
    axes = ["speed_rpm", "axial_load_N", "temperature_C", "friction_torque_Nmm"]
    torque[axes].assign(std_Nmm=2.0).to_csv(tmp_path / "torque.csv", index=False)
    text = (root / DRIVEN).read_text()
    begin, end = text.index("[friction]"), text.index("[", text.index("[friction]") + 1)
    text = text[:begin] + '[friction]\nlaw = "table"\nfile = "torque.csv"\n\n' + text[end:]
    (tmp_path / "spindle.toml").write_text(text)
    spindle = raceway.Model.read(tmp_path / "spindle.toml")
    hot = spindle.steady([6000]).to_frame()
    bearings = [name for name in hot if name.endswith("_friction_band_W")]
    expected = 1.96 * 2.0 * 1e-3 * 6000 * np.pi / 30
    assert bearings and hot[bearings].to_numpy() == pytest.approx(expected, rel=1e-6)
    assert hot["friction_power_band_W"][0] == pytest.approx(expected * len(bearings), rel=1e-6)
    (tmp_path / "torque.csv").unlink()  # it was read once
    (tmp_path / "other").mkdir()
    assert pickle.loads(pickle.dumps(spindle)).steady([6000]).to_frame().equals(hot)
    spindle.save(tmp_path / "other" / "spindle.toml")
    assert 'file = "../torque.csv"' in (tmp_path / "other" / "spindle.toml").read_text()

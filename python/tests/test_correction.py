"""Corrections of machines: what Python says is what the command says."""

import io
import json
import pickle
import subprocess
import sys
import threading
import time
import warnings

import numpy
import pandas
import pytest

import raceway
import raceway.plot

EXACT = "data/corrections/exact"
AMBIENT = "data/corrections/ambient"
POWER = "data/corrections/power"
SPINDLE = "data/measurements/spindle_thermal"
TWO = """
[[correction]]
displacement = "displacement_ch1_um"
tolerance_um = 2.0
[[correction]]
displacement = "displacement_ch2_um"
tolerance_um = 2.0
"""


@pytest.fixture(autouse=True)
def in_root(root, monkeypatch):
    monkeypatch.chdir(root)
    warnings.simplefilter("ignore", raceway.Doubt)


@pytest.fixture
def command(program, root):
    """Run the command and take what it prints."""

    def run(*arguments):
        done = subprocess.run([program, *arguments, "--quiet"], cwd=root, capture_output=True, text=True)
        assert done.stdout or done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture
def document(command):
    return lambda *arguments: json.loads(command(*arguments, "--json"))


def read(folder, record="train"):
    return raceway.Correction.read(f"{folder}/correction.toml"), raceway.Record.read(f"{folder}/{record}.csv")


@pytest.fixture(scope="session")
def spindle(root):
    """The first 10 h of a real spindle."""
    frame = pandas.read_csv(root / SPINDLE / "record.csv", comment="#")
    return raceway.Record.from_pandas(frame[frame["time_s"] <= 36000], name="spindle")


def test_what_it_is():
    correction = raceway.Correction.read(f"{POWER}/correction.toml")
    assert correction.displacements == ["displacement_z_um"]
    assert "speed_rpm" in correction.inputs
    assert all(p["lower"] <= p["value"] <= p["upper"] for p in correction.parameters.values())
    assert raceway.Correction.from_text(correction.text, correction.source).parameters == correction.parameters


@pytest.mark.parametrize(
    ("asked", "flags"),
    [
        ({}, []),
        ({"order": 1}, ["--order", "1"]),
        ({"order": (1, 2), "inputs": "all"}, ["--order", "1:2", "--inputs", "all"]),
        ({"baseline": "regression"}, ["--baseline", "regression"]),
        ({"baseline": "arx", "order": 1}, ["--baseline", "arx", "--order", "1"]),
        ({"until_s": 60000, "from_s": 3600}, ["--until", "60000s", "--from", "1h"]),
    ],
)
def test_identify(document, asked, flags):
    correction, record = read(EXACT)
    found = correction.identify(record, **asked)
    assert found.data == document("identify", correction.source, record.name, *flags)


def test_an_arx_model_is_written_as_transfer_functions(command, tmp_path):
    correction, record = read(EXACT)
    found = correction.identify(record, baseline="arx", order=1)
    file = tmp_path / "arx.toml"
    command("identify", correction.source, record.name, "--baseline", "arx", "--order", "1", "-o", str(file))
    assert found.correction.text == file.read_text()
    assert "denominator = [1" in found.correction.text
    # What a paper printed runs as it stands, at its own interval.
    printed = raceway.Correction.from_text(
        '[correction]\ndisplacement = "displacement_z_um"\nsampling_s = 1\n[[correction.channel]]\nname = "x"\n'
        'input = "spindle_power_W"\nnumerator = [0.000870091]\ndenominator = [1, 0.000296341, -0.9995287]\n',
        "printed.toml",
    )
    program = printed.export("python")
    assert '"denominator": [1, 0.000296341, -0.9995287]' in program.text
    assert any("negative real pole" in str(note) for note in program.notes)


def test_what_was_identified_is_the_file_of_the_command(command, tmp_path):
    correction, record = read(EXACT)
    other = raceway.Record.read(f"{EXACT}/test.csv")
    found = correction.identify(record, validate=other)
    file = tmp_path / "found.toml"
    expected = json.loads(command("identify", correction.source, record.name, "--validate", other.name, "-o", str(file), "--json"))
    assert found.correction.text == file.read_text()
    assert found.data == expected
    assert found.correction.parameters["spindle.gain_1"]["value"] == pytest.approx(found.parameters["spindle.gain_1"]["value"], rel=1e-9)
    assert correction.parameters["spindle.gain_1"]["value"] == 7.0  # as it was
    # Made with these numbers.
    made = {"spindle.gain_1": 5.0, "spindle.gain_2": 3.0, "ambient.gain_1": -2.5, "ambient.time_constant_1": 14000.0}
    for name, value in made.items():
        number = found.parameters[name]
        assert abs(number["value"] - value) < 4.0 * number["std"], name
    assert set(found.to_frame()["parameter"]) == set(found.parameters)


def test_a_bank_of_lags_on_a_real_spindle(document, spindle, tmp_path):
    bare = raceway.Correction.read(f"{SPINDLE}/bare3.toml")
    file = tmp_path / "spindle.csv"
    file.write_text(spindle.text)
    for lags, flag in (("auto", "auto"), ([0, 600, 3600.5], "0,600,3600.5")):
        found = bare.identify(spindle, lags_s=lags)
        expected = document("identify", bare.source, str(file), "--lags", flag)
        assert found.data.pop("data") == "spindle" and expected.pop("data") == str(file)
        for said in found.data["said"] + expected["said"]:
            assert said.pop("file", None) in (None, "spindle", str(file))
        assert found.data == expected
    assert {"speed.gain_1", "t16.gain_2"} <= set(found.parameters)


def test_correct(command, document, tmp_path):
    correction, record = read(EXACT, "test")
    found = correction.identify(raceway.Record.read(f"{EXACT}/train.csv")).correction
    file = tmp_path / "found.toml"
    found.save(file)
    run = found.correct(record)
    expected = document("correct", str(file), record.name)
    assert expected.pop("model") == str(file) and run.data.pop("model") == found.source
    assert run.data == expected
    rows = pandas.read_csv(io.StringIO(command("correct", str(file), record.name, "-o", "-")))
    pandas.testing.assert_frame_equal(run.to_frame(), rows)
    course = run.course()
    numpy.testing.assert_allclose(course["predicted_displacement_z_um"], rows["predicted_um"], atol=1e-6)
    numpy.testing.assert_array_equal(course["displacement_z_um"] - course["predicted_displacement_z_um"], course["residual_displacement_z_um"])
    with pytest.raises(ValueError, match="nothing was learnt"):
        _ = run.correction


def test_learning(command, document, tmp_path):
    correction, record = read(AMBIENT, "test")
    run = correction.correct(record, learn=True, every_s=7200, forget_s=3 * 86400)
    flags = ["--learn", "--every", "2h", "--forget", "3d"]
    assert run.data == document("correct", correction.source, record.name, *flags)
    file = tmp_path / "learnt.toml"
    rows = command("correct", correction.source, record.name, *flags, "-o", "-", "--save", str(file))
    assert run.correction.text == file.read_text()
    pandas.testing.assert_frame_equal(run.to_frame(), pandas.read_csv(io.StringIO(rows)))
    assert run.data["readings_learnt"] == 24 * 3600 / 7200
    # A row rests on readings before it alone.
    learnt = run.to_frame()
    later = record.to_frame()
    later.loc[later["time_s"] > 43200, "displacement_z_um"] += 30.0
    again = correction.correct(raceway.Record.from_pandas(later), learn=True, every_s=7200, forget_s=3 * 86400).to_frame()
    before = learnt["time_s"] <= 43200
    numpy.testing.assert_array_equal(again["predicted_um"][before], learnt["predicted_um"][before])
    assert (again["predicted_um"] != learnt["predicted_um"]).any()
    run.save(tmp_path / "rows.csv")
    assert (tmp_path / "rows.csv").read_text() == rows


def test_the_page_of_a_run_is_that_of_the_command(program, root, tmp_path):
    correction, record = read(EXACT, "test")
    file = tmp_path / "page.html"
    subprocess.run([program, "correct", correction.source, record.name, "--quiet", "--report", str(file)], cwd=root, check=True, capture_output=True)
    assert correction.correct(record).report().html == file.read_text()


def test_compare(document):
    correction, record = read(EXACT, "test")
    other = raceway.Correction.from_text(correction.text.replace("7.0", "5.0"), "other")
    assert correction.compare(record).data == document("compare", correction.source, record.name)
    for asked, flags in (
        ({"zero": "first"}, ["--zero", "first"]),
        ({"refit": "gains"}, ["--refit", "gains"]),
        ({"from_s": 3600}, ["--from", "3600s"]),
    ):
        assert correction.compare(record, **asked).data == document("compare", correction.source, record.name, *flags)
    ladder = correction.compare(record, other)
    assert [m["model"] for m in ladder.data["models"]] == [correction.source, "other"]
    error = ladder.to_frame()["error"]
    assert numpy.sqrt((error**2).mean()) == pytest.approx(ladder.rmse, rel=1e-12)
    assert ladder.unit == "um"


def test_calibrate(command, tmp_path):
    correction, record = read(EXACT)
    found = correction.calibrate(record)
    file = tmp_path / "fitted.toml"
    expected = json.loads(command("calibrate", correction.source, record.name, "-o", str(file), "--json"))
    assert found.data == expected
    assert isinstance(found.model, raceway.Correction)
    assert found.model.text == file.read_text()


def test_diagnose_and_add(command, document, tmp_path):
    correction, record = read(AMBIENT)
    found = correction.diagnose(record)
    assert found.data == document("diagnose", correction.source, record.name)
    assert found.effects == ["ambient-drift"]
    added = correction.add(found.effects, record)
    file = tmp_path / "better.toml"
    expected = json.loads(command("add", correction.source, "ambient-drift", "--data", record.name, "-o", str(file), "--json"))
    assert added.data == expected and added.refused == ""
    assert added.model.text == file.read_text()
    other = raceway.Record.read(f"{AMBIENT}/test.csv")
    assert added.model.compare(other).rmse < 0.2 * correction.compare(other).rmse


def test_check(document):
    correction, record = read(EXACT)
    assert correction.check(record).data == document("check", correction.source, record.name)


def test_recorded_columns_drive_a_correction(document, tmp_path):
    """A power by a lag in a window of a position, a load by a delay element: against the closed form."""
    model, record = tmp_path / "z.toml", tmp_path / "z.csv"
    model.write_text(
        '[correction]\ndisplacement = "displacement_z_um"\n[[correction.channel]]\nname = "power"\ninput = "spindle_power_W"\n'
        "sections = [{ gain_um_W = 0.02, time_constant_s = 900 }]\n"
        'window = { column = "x_position_mm", points = [0, 400, inf, inf] }\n'
        '[[correction.channel]]\nname = "axial"\ninput = "axial_load_N"\n'
        "gain = { slope_um_N = 0.01, offset_um = 0 }\ntime_constant = { slope_min_N = 0, offset_min = 20 }\n"
    )
    t = numpy.arange(0.0, 7200.0, 60.0)
    frame = pandas.DataFrame({"time_s": t, "spindle_power_W": 500.0, "axial_load_N": -300.0, "x_position_mm": 100.0 + t % 240.0})
    frame.to_csv(record, index=False)
    run = raceway.Correction.read(model).correct(raceway.Record.read(record))
    share = numpy.clip(frame.x_position_mm / 400.0, 0.0, 1.0)
    expected = 10.0 * share * -numpy.expm1(-t / 900.0) + 3.0 * numpy.expm1(-t / 1200.0)
    numpy.testing.assert_allclose(run.to_frame()["predicted_um"], expected, atol=1e-9)


@pytest.mark.parametrize("format", ["python", "c", "csv", "linuxcnc"])
def test_export(command, tmp_path, format):
    correction = raceway.Correction.read(f"{EXACT}/correction.toml")
    assert str(correction.export(format)) == command("export", correction.source, "--format", format)
    end = {"python": "py", "c": "h", "csv": "csv", "linuxcnc": "py"}[format]
    ours, theirs = tmp_path / "a" / f"thermal.{end}", tmp_path / f"thermal.{end}"
    ours.parent.mkdir()
    correction.export(format, ours)
    command("export", correction.source, "--format", format, "-o", str(theirs))
    for name in sorted(file.name for file in ours.parent.iterdir()):
        assert (ours.parent / name).read_text() == (tmp_path / name).read_text()
    assert (ours.parent / "thermal_shutdown.hal").exists() == (format == "linuxcnc")
    with pytest.raises(FileExistsError):
        correction.export(format, ours)


def test_suggest_columns():
    """Columns of a machine's own export for a correction."""
    correction = raceway.Correction.from_text('[correction]\ndisplacement = "displacement_z_um"\n')
    frame = pandas.DataFrame({"Zeit [min]": [0.0, 2.0, 4.0], "T Lager [°C]": [20.1, 21.4, 20.9], "Weg Z [mm]": [0.0, 1e-3, 2e-3]})
    columns = correction.suggest_columns(raceway.Record.from_pandas(frame, name="machine"))
    assert 'displacement_z_um = { column = "Weg Z [mm]", unit = "mm" }' in columns
    assert 'lager_temperature_C = { column = "T Lager [°C]", unit = "C" }' in columns
    assert 'time_s = { column = "Zeit [min]", unit = "min" }' in columns


def test_trust(command, tmp_path):
    """Of 4 h in which the machine warms up it is not exported, as the command says it."""
    correction, record = read(EXACT)
    assert correction.trust["displacement_z_um"].startswith("not known: ")
    found = correction.identify(record, until_s=4 * 3600, order=1)
    line = found.correction.trust["displacement_z_um"]
    assert found.data["trust"]["verdict"] == "do-not-use"
    assert line == "do not use, because " + found.data["trust"]["because"]
    model = tmp_path / "found.toml"
    model.write_text(found.correction.text)
    with pytest.raises(raceway.InputError, match=r"accept_untrusted=True to export it nevertheless") as refused:
        found.correction.export("csv")
    assert line.split("(identify")[0] in str(refused.value)
    table = str(found.correction.export("csv", accept_untrusted=True))
    assert "Trust in displacement_z_um: do not use" in table
    whole = correction.identify(record).correction
    assert whole.trust == {"displacement_z_um": "good"}
    assert whole.export("c").text


def test_export_with_a_record(tmp_path):
    correction, record = read(EXACT)
    program = correction.export("python", tmp_path / "z.py", record=record)
    assert "check: 1000 rows" in subprocess.run([sys.executable, tmp_path / "z.py", "--check"], capture_output=True, text=True, check=True).stdout
    assert str(correction.export("python")) != str(program)


def test_several_displacements(spindle):
    found = raceway.Correction.from_text(TWO).identify(spindle, inputs=["speed_rpm"], order=1)
    both = found.correction
    assert both.displacements == ["displacement_ch1_um", "displacement_ch2_um"]
    assert set(found.parameters) <= set(both.parameters)
    assert all(name.startswith("displacement_ch") for name in both.parameters)
    with pytest.raises(raceway.InputError, match="has several .* choose one with channel displacement_ch1_um or"):
        both.compare(spindle)
    first, second = (both.compare(spindle, channel=name) for name in both.displacements)
    assert first.data["quantity"] == "displacement_ch1" and second.data["quantity"] == "displacement_ch2"
    assert first.rmse != second.rmse
    calibrated = both.calibrate(spindle, channel="displacement_ch2_um").model
    assert calibrated.displacements == both.displacements
    assert {"predicted_displacement_ch1_um", "residual_displacement_ch2_um"} <= set(both.correct(spindle).to_frame())


def test_angles_and_positions_of_several_probes():
    folder = "data/corrections/nest"
    found = raceway.Correction.read(f"{folder}/correction.toml").identify(raceway.Record.read(f"{folder}/train.csv")).correction
    assert found.displacements[-1] == "displacement_b_urad"
    course = found.correct(raceway.Record.read(f"{folder}/test.csv")).course()
    # Probes of 0.1 um, 0.2 m apart: 0.7 urad.
    for axis, noise in {"x_um": 0.116, "y_um": 0.116, "z_um": 0.1, "a_urad": 0.707, "b_urad": 0.707}.items():
        left = course[f"residual_displacement_{axis}"]
        assert numpy.sqrt(numpy.nanmean(numpy.square(left))) < 1.1 * noise, axis


def test_a_friction_table_is_found_beside_its_file(document):
    correction, record = read(POWER, "test")
    assert correction.correct(record).data == document("correct", correction.source, record.name)


def test_a_frame_of_another_program():
    correction, record = read(EXACT, "test")
    frame = record.to_frame().rename(columns={"ambient_temperature_C": "Halle"})
    with pytest.raises(raceway.InputError, match="ambient_temperature_C"):
        correction.correct(raceway.Record.from_pandas(frame))
    named = raceway.Record.from_pandas(frame, columns={"ambient_temperature_C": "Halle"})
    pandas.testing.assert_frame_equal(correction.correct(named).to_frame(), correction.correct(record).to_frame())


def test_fit_law(program, root, tmp_path):
    file = tmp_path / "curve.csv"
    shaft = raceway.Model.read("data/spindles/two_against_one.toml")
    shaft.displacement(numpy.arange(0.0, 10001.0, 500.0)).save(file)
    law = raceway.fit_law(raceway.Record.read(file), at_rpm=5000)
    done = subprocess.run([program, "fit-law", str(file), "--at", "5000", "--json"], cwd=root, capture_output=True, text=True, check=True)
    assert law.data == json.loads(done.stdout)
    assert law.table == subprocess.run([program, "fit-law", str(file), "-o", "-"], cwd=root, capture_output=True, text=True, check=True).stdout
    with pytest.raises(raceway.InputError, match="rpm: the law is valid only within the speeds of the displacement curve,"):
        raceway.fit_law(raceway.Record.read(file), at_rpm=20000)


@pytest.mark.parametrize(
    ("asked", "error", "words"),
    [
        ({"order": 0}, raceway.InputError, "--order 0: must be a number of sections from 1 to 6"),
        ({"order": (3, 1)}, raceway.InputError, "--order 3:1: the first number must not be above the second"),
        ({"order": "two"}, TypeError, "order: must be a number of sections"),
        ({"order": (1, 2, 3)}, TypeError, "order: must be a number of sections"),
        ({"order": True}, TypeError, "order: must be a number of sections"),
        ({"order": (1, 2.5)}, TypeError, "order: must be a number of sections"),
        ({"inputs": "front_bearing_temperature"}, raceway.InputError, "does not have this input"),
        ({"inputs": [1]}, TypeError, "inputs: must contain names"),
        ({"lags_s": [-5.0]}, raceway.InputError, "--lags -5: must be auto, or time constants from 0"),
        ({"lags_s": [float("nan")]}, raceway.InputError, "--lags nan"),
        ({"lags_s": ["600"]}, TypeError, "lags_s: must be a number, not str"),
        ({"lags_s": "fast"}, raceway.InputError, "--lags fast: must be auto"),
        ({"lags_s": 600}, TypeError, "lags_s: must be time constants such as"),
        ({"lags_s": []}, ValueError, "no lag is given"),
        ({"lags_s": "auto", "order": 2}, ValueError, "give only one of the three"),
        ({"baseline": "lasso"}, ValueError, "must be regression or arx"),
        ({"from_s": 1e9}, raceway.InputError, "no reading from"),
        ({"validate": "test.csv"}, TypeError, "must be a raceway.Record"),
    ],
)
def test_wrong_questions(asked, error, words):
    correction, record = read(EXACT)
    with pytest.raises(error, match=words):
        correction.identify(record, **asked)


def test_wrong_records_and_models():
    correction, record = read(EXACT)
    rig = raceway.Record.read("tests/hidden_effect/rigs/dev-03/train.csv")
    bearing = raceway.Model.new("S 6014 C")
    for ask in (correction.identify, correction.correct, correction.compare, correction.diagnose, correction.check):
        with pytest.raises(raceway.InputError, match="column front_bearing_temperature_C is missing"):
            ask(rig)
        for wrong in ("train.csv", None):
            with pytest.raises(TypeError, match="must be a raceway.Record"):
                ask(wrong)
    for ask in (correction.identify, correction.correct):
        with pytest.raises(TypeError, match="must be a raceway.Record"):
            ask([record])
    for ask in (correction.compare, correction.diagnose):
        with pytest.raises(raceway.InputError, match="compared with one record"):
            ask([record, record])
    with pytest.raises(TypeError, match="must be a raceway.Correction, not Model"):
        correction.compare(record, bearing)
    with pytest.raises(TypeError, match="must be a raceway.Model, not Correction"):
        bearing.compare(rig, correction)
    with pytest.raises(raceway.InputError, match="use raceway.Correction.read to read it"):
        raceway.Model.read(correction.source)
    with pytest.raises(raceway.InputError, match="use raceway.Model.read to read the model of a bearing"):
        raceway.Correction.from_text(bearing.text)
    with pytest.raises(raceway.InputError, match="Error while parsing"):
        raceway.Correction.from_text("[correction")
    with pytest.raises(raceway.InputError, match="unknown effect .no-such."):
        correction.add("no-such", record)
    with pytest.raises(ValueError, match="every_s: only possible with learn=True"):
        correction.correct(record, every_s=60)
    with pytest.raises(raceway.InputError, match="must be above 0"):
        correction.correct(record, learn=True, every_s=-60)
    with pytest.raises(ValueError, match="must be python, c, csv or linuxcnc"):
        correction.export("java")
    with pytest.raises(raceway.InputError, match="wrong.py"):
        correction.export("linuxcnc", "wrong.txt")


def test_read_takes_either(tmp_path):
    raceway.Model.new("S 6014 C").save(tmp_path / "bearing.toml")
    assert isinstance(raceway.read(tmp_path / "bearing.toml"), raceway.Model)
    assert isinstance(raceway.read(f"{EXACT}/correction.toml"), raceway.Correction)


INTERRUPTED = """
import os, signal, time, warnings, raceway
warnings.simplefilter("ignore")
correction = raceway.Correction.read("{folder}/{file}")
record = raceway.Record.read("{folder}/record.csv")
before = correction.text
def progress(share, step):
    os.kill(os.getpid(), signal.SIGINT)
start = time.monotonic()
try:
    correction.{ask}, progress=progress)
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - start < 2.0, correction.text == before)
"""


@pytest.mark.parametrize(("file", "ask"), [("bare3.toml", 'identify(record, inputs="all"'), ("ch3.toml", "diagnose(record")])
def test_an_interrupt_ends_long_work(root, file, ask):
    code = INTERRUPTED.format(folder=SPINDLE, file=file, ask=ask)
    done = subprocess.run([sys.executable, "-c", code], cwd=root, capture_output=True, text=True, timeout=60)
    assert done.stdout.split() == ["interrupted", "True", "True"], done.stderr


def test_a_time_limit():
    correction = raceway.Correction.read(f"{SPINDLE}/bare3.toml")
    record = raceway.Record.read(f"{SPINDLE}/record.csv")
    with pytest.raises(TimeoutError, match="time_limit_s"):
        correction.identify(record, inputs="all", time_limit_s=0.2)


def test_other_threads_run_meanwhile():
    correction, record = read(EXACT)
    expected = correction.identify(record).data
    found, ticks = [], []
    threads = [threading.Thread(target=lambda: found.append(correction.identify(record).data)) for _ in range(2)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        ticks.append(time.monotonic())
        time.sleep(0.005)
    assert found == [expected, expected]
    assert len(ticks) > 10


def test_doubts_are_warnings():
    correction, record = read(EXACT)
    found = correction.identify(record).correction
    frame = raceway.Record.read(f"{EXACT}/test.csv").to_frame()
    frame.loc[frame["time_s"] > 30000, "ambient_temperature_C"] = 5.0
    with pytest.warns(raceway.Doubt, match="training data of 19.137 to 24.9"):
        run = found.correct(raceway.Record.from_pandas(frame))
    assert run.data["rows_beyond_range"] > 0


def test_notebooks_and_pictures(spindle):
    correction, record = read(EXACT, "test")
    found = correction.identify(raceway.Record.read(f"{EXACT}/train.csv"), validate=record)
    run = found.correction.correct(record)
    learnt = correction.correct(record, learn=True, every_s=7200)
    for result in (correction, found, run, learnt, correction.check(record), correction.compare(record), correction.calibrate(record)):
        html = result._repr_html_()
        assert html.startswith("<div") and "None" not in html and "nan" not in html, result
    assert "spindle.gain_2" in found._repr_html_()
    above, below = raceway.plot.record(run)
    assert [line.get_label() for line in above.lines] == ["Displacement z", "Predicted displacement z"]
    assert below.get_ylabel().startswith("Residual displacement z")
    numpy.testing.assert_array_equal(below.lines[0].get_ydata(), run.course()["residual_displacement_z_um"])
    both = raceway.Correction.from_text(TWO).identify(spindle, inputs="speed_rpm", order=1).correction
    above, below = raceway.plot.record(both.correct(spindle))
    assert above.get_ylabel() == "Displacement\nin µm" and len(below.lines) == 3  # with the line of zero
    assert raceway.plot.residuals(correction.compare(record), x="time_s", y=None).get_xlabel() == "Time in s"


@pytest.fixture
def moved(root, tmp_path):
    """A correction with a friction table, read from a folder of its own, and its record."""
    for name in ("correction.toml", "friction_table.csv"):
        (tmp_path / name).write_text((root / POWER / name).read_text())
    return raceway.Correction.read(tmp_path / "correction.toml"), raceway.Record.read(f"{POWER}/test.csv")


def test_files_that_a_model_names_are_read_once(moved, tmp_path, monkeypatch):
    correction, record = moved
    before = correction.correct(record).data
    text = (tmp_path / "friction_table.csv").read_text()
    (tmp_path / "friction_table.csv").write_text(text.replace(",110.59", ",210.59", 1))
    monkeypatch.chdir(tmp_path)
    assert correction.correct(record).data == before
    assert pickle.loads(pickle.dumps(correction)).correct(record).data == before
    assert correction.export("csv").text
    assert correction.calibrate(record).model.text.count('friction_table = "/') == 1


def test_a_model_saved_elsewhere_finds_its_files(moved, tmp_path):
    correction, record = moved
    before = correction.correct(record).to_frame()
    (tmp_path / "other").mkdir()
    correction.save(tmp_path / "other" / "z.toml")
    assert '"../friction_table.csv"' in (tmp_path / "other" / "z.toml").read_text()
    correction.save(tmp_path / "beside.toml")
    assert (tmp_path / "beside.toml").read_text() == (tmp_path / "correction.toml").read_text()
    for again in (raceway.Correction.read(tmp_path / "other" / "z.toml"), raceway.Correction.from_text(correction.text)):
        assert again.correct(record).to_frame().equals(before)


def test_options_that_mean_nothing_are_refused():
    correction, record = read(EXACT)
    with pytest.raises(raceway.InputError, match="per_record: a correction is compared with one record"):
        correction.calibrate(record, per_record=["front.gain_1"])
    with pytest.raises(raceway.InputError, match="channel displacement_y_um"):
        correction.compare(record, channel="displacement_y_um")


DRIFT = "tests/cli/everyday/over-time"


def refusal(program, *arguments):
    """The words by which the command refuses."""
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    assert done.returncode == 1, done.stderr
    return [line for line in done.stderr.splitlines() if not line.startswith("note: ")]


def test_a_unit_is_asked_about_in_the_words_of_the_command(program, tmp_path):
    frame = pandas.read_csv(f"{DRIFT}/train.csv")
    path = tmp_path / "mm.csv"
    frame.assign(displacement_z_um=(1e-3 * frame.displacement_z_um).round(6)).to_csv(path, index=False)
    model = raceway.Correction.read(f"{DRIFT}/model.toml")
    for name, ask in {"identify": model.identify, "calibrate": model.calibrate, "check": model.check, "compare": model.compare}.items():
        with pytest.raises(raceway.InputError) as asked:
            ask(raceway.Record.read(path))
        assert str(asked.value).splitlines() == refusal(program, name, f"{DRIFT}/model.toml", str(path))
        assert 'unit = "mm" }' in str(asked.value)
        assert asked.value.key == "displacement_z_um"
    answered = raceway.Record.read(path, columns='[columns]\ndisplacement_z_um = { column = "displacement_z_um", unit = "mm" }\n')
    assert model.identify(answered).data["channels"][0]["sections"][0]["gain"]["value"] == pytest.approx(5.0, abs=0.006)


def test_a_correction_begins_with_a_record():
    record = raceway.Record.read(f"{DRIFT}/train.csv")
    begun = raceway.Correction.new(record)
    assert begun.inputs == ["bearing_temperature_C", "room_temperature_C"]
    assert "# assumed" in begun.text
    found = begun.identify(record)
    assert found.data["channels"][0]["sections"][0]["gain"]["value"] == pytest.approx(5.0, abs=0.006)
    with pytest.raises(raceway.InputError, match="no column is a displacement"):
        raceway.Correction.new(raceway.Record.from_arrays({"time_s": [0.0, 60.0], "room_temperature_C": [20.0, 21.0]}))


def test_files_with_clocks_of_their_own_are_one_record():
    frame = pandas.read_csv(f"{DRIFT}/train.csv")
    temperatures = raceway.Record.from_pandas(frame[["time_s", "bearing_temperature_C", "room_temperature_C"]], name="temperatures")
    probe = raceway.Record.from_pandas(frame[["time_s", "displacement_z_um"]].assign(time_s=frame.time_s + 7.0)[:-1], name="probe")
    both = pickle.loads(pickle.dumps(temperatures.beside(probe)))
    model = raceway.Correction.read(f"{DRIFT}/model.toml")
    found = model.identify(both)
    assert found.data["rows"] == 1681
    assert any("temperatures and probe are joined into one record" in note for note in found.notes)
    assert found.data["channels"][0]["sections"][0]["gain"]["value"] == pytest.approx(5.0, abs=0.02)
    with pytest.raises(TypeError, match="must be a raceway.Record"):
        temperatures.beside(frame)


def test_heat_follows_recorded_loads(program, tmp_path):
    """Torque 40 + 0.01 n + 0.2 F_a + 0.05 F_r in N mm; a lag of 2000 s and 0.2 um/W."""

    def torque(speed, axial, radial):
        return 40 + 0.01 * speed + 0.2 * abs(axial) + 0.05 * radial

    points = [(n, a, r) for r in (0, 2000) for a in (0, 1000) for n in (0, 10000)]
    rows = "".join(f"{n},{a},{r},{torque(n, a, r)}\n" for n, a, r in points)
    (tmp_path / "friction.csv").write_text("speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm\n" + rows)
    (tmp_path / "z.toml").write_text(
        '[correction]\ndisplacement = "displacement_z_um"\n[[correction.channel]]\nname = "spindle"\ninput = "power_W"\n'
        'friction_table = "friction.csv"\naxial_load_N = "axial_load_N"\nradial_load_N = "cutting_N"\n'
        "sections = [{ gain_um_W = 0.2, time_constant_s = 2000 }]\n"
    )
    k = numpy.arange(300)
    speed, axial, radial = numpy.choose(k // 60 % 3, [0.0, 4000.0, 8000.0]), 600 * numpy.sin(k / 20), 900 + 800 * numpy.cos(k / 33)
    expected, at = numpy.zeros(300), 0.0
    for n in range(1, 300):
        power = torque(speed[n - 1], axial[n - 1], radial[n - 1]) * 1e-3 * speed[n - 1] * numpy.pi / 30
        at += (1 - numpy.exp(-60 / 2000)) * (0.2 * power - at)
        expected[n] = at
    frame = pandas.DataFrame({"time_s": 60.0 * k, "speed_rpm": speed, "axial_load_N": axial, "cutting_N": radial, "displacement_z_um": expected})
    correction, record = raceway.Correction.read(tmp_path / "z.toml"), raceway.Record.from_pandas(frame)
    numpy.testing.assert_allclose(correction.correct(record).to_frame()["predicted_um"], expected, atol=1e-9)
    out = correction.export("python", tmp_path / "z.py", record=record, accept_untrusted=True)
    assert (
        "largest difference" in subprocess.run([sys.executable, tmp_path / "z.py", "--check"], capture_output=True, text=True, check=True).stdout
    ), out

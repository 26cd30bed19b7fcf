"""Reports of fits agree with the documents and with each other."""

from __future__ import annotations

import copy
import math
import re

import pytest

import raceway
from raceway.fit_report import conf_interval, fit_report

RIG = "tests/hidden_effect/rigs/dev-03"


def fact(report: str, name: str) -> str:
    """What stands behind "name =", of one line."""
    return re.search(rf"^ +{re.escape(name)} += (.*)$", report, re.MULTILINE).group(1)


def pair(words: str) -> tuple[float, ...]:
    return tuple(float(word) for word in words.split(", "))


def line_of(report: str, name: str) -> list[str]:
    return next(line for line in report.splitlines() if name in line.split()).split()


def test_lines_have_80_columns_at_most(calibration, addition, diagnosis, ambiguous):
    for result in (calibration, addition, diagnosis, ambiguous):
        report = fit_report(result)
        assert max(map(len, report.splitlines())) <= 80
        assert report.isascii()


def test_chi_square_and_criteria_are_those_of_the_document(calibration):
    data, report = calibration.data, fit_report(calibration)
    chi, log_determinant = data["chi_square"], data["noise"]["log_determinant"]
    assert chi == pytest.approx(data["reduced_chi_square"] * data["degrees_of_freedom"], rel=1e-12)
    assert data["aic"] == pytest.approx(chi + log_determinant + 2 * 2, rel=1e-12)
    assert data["bic"] == pytest.approx(chi + log_determinant + 2 * math.log(120), rel=1e-12)
    assert float(fact(report, "chi-square")) == pytest.approx(chi, rel=1e-5)
    assert pair(fact(report, "AIC, BIC")) == pytest.approx((data["aic"], data["bic"]), rel=1e-5)
    aic, bic = pair(fact(report, "AIC, BIC as in lmfit"))
    assert aic == pytest.approx(120 * math.log(chi / 120) + 4, rel=1e-5)
    assert bic == pytest.approx(120 * math.log(chi / 120) + 2 * math.log(120), rel=1e-5)


def few_rows(train, path, **columns):
    train.iloc[:6].assign(**columns).to_csv(path, index=False)
    return str(path)


def test_the_likelihood_is_that_of_the_readings_in_their_unit(document, tmp_path, train):
    # Six rows are weighed by their declared deviations alone; these are far larger than the misfit.
    std = 200.0
    data = document("calibrate", f"{RIG}/model.toml", few_rows(train, tmp_path / "few.csv", std_Nmm=std))
    assert data["noise"]["log_determinant"] == pytest.approx(6 * math.log(2 * math.pi * std**2))
    assert data["chi_square"] == pytest.approx(6 * data["rmse"] ** 2 / std**2)


def test_scatter_fitted_to_the_misfit_has_no_criteria(make, document, tmp_path, train):
    data = document("calibrate", f"{RIG}/model.toml", few_rows(train, tmp_path / "few.csv", std_Nmm=0.01))
    assert data["aic"] is None and data["chi_square"] is not None
    report = fit_report(make("Calibration", data))
    assert fact(report, "AIC, BIC") == "-"
    assert "was fitted to the residual of this model" in " ".join(report.split())


def test_calibrate_add_and_diagnose_agree_on_how_much_better_the_effect_is(calibration, addition, diagnosis):
    # The same rows under the same noise, from three documents.
    before, after = calibration.data, addition.data["calibration"]
    effect, base = diagnosis.data["effects"][0], diagnosis.data["baseline"]
    assert effect["id"] == "lubricant-drag"
    for key in ("chi_square", "aic", "bic"):
        assert addition.data["before"][key] == pytest.approx(before[key], rel=1e-6)
        assert base[key] == pytest.approx(before[key], rel=1e-6)
        assert effect[key] == pytest.approx(after[key], rel=1e-6)
    # One parameter, which is the size.
    assert before["chi_square"] - after["chi_square"] == pytest.approx(effect["gain"], rel=1e-6)
    assert addition.data["gain"] == pytest.approx(effect["gain"], rel=1e-6)
    row = line_of(fit_report(diagnosis), "lubricant-drag")
    assert float(row[-2]) == pytest.approx(after["aic"] - before["aic"], abs=0.06)
    assert float(row[-1]) == pytest.approx(after["bic"] - before["bic"], abs=0.06)
    assert float(row[-3]) == pytest.approx(effect["gain"], rel=1e-3)


def test_a_diagnosis_correlates_its_estimates_as_add_does(addition, diagnosis):
    correlation = diagnosis.data["correlation"]
    assert correlation["names"] == list(addition.data["calibration"]["parameters"])
    for row, same in zip(correlation["rows"], addition.data["calibration"]["correlation"]):
        assert row == pytest.approx(same, abs=1e-6)
    assert "C(f0, z)" in fit_report(diagnosis)


def test_a_free_shape_counts_in_the_criteria_as_in_the_gain(ambiguous):
    # torque-temperature-drift has a size and a shape: its gain is less by ln N already.
    effect = next(e for e in ambiguous.data["effects"] if e["id"] == "torque-temperature-drift")
    assert [p["is_size"] for p in effect["parameters"].values()].count(True) == 1
    assert len(effect["parameters"]) == 2
    row = line_of(fit_report(ambiguous), "torque-temperature-drift")
    fall = effect["gain"] + math.log(120)
    assert ambiguous.data["baseline"]["chi_square"] - effect["chi_square"] == pytest.approx(fall)
    assert row[1] == "4"
    assert float(row[-2]) == pytest.approx(2 * 2 - fall, abs=0.06)
    assert float(row[-1]) == pytest.approx(2 * math.log(120) - fall, abs=0.06)


def test_a_set_of_effects_is_one_explanation(make, document):
    rig = "tests/hidden_effect/rigs/dev-06"
    data = document("diagnose", f"{rig}/model.toml", f"{rig}/train.csv")
    assert data["verdict"] == "several-effects"
    report = fit_report(make("Diagnosis", data))
    for names in data["explanations"]:
        assert " + ".join(names) in report
        parameters = sum(len(e["parameters"]) for e in data["effects"] if e["id"] in names)
        line = next(i for i, one in enumerate(report.splitlines()) if " + ".join(names) in one)
        numbers = report.splitlines()[line].split(names[-1])[-1].split() or report.splitlines()[line + 1].split()
        assert int(numbers[0]) == 2 + parameters
    # Of the first set each of its effects has the gain of all.
    first, fit = data["explanations"][0], data["explanation_fits"][0]
    assert len(data["explanation_fits"]) == len(data["explanations"])
    for effect in data["effects"]:
        if effect["id"] in first:
            assert effect["gain"] == fit["gain"] and effect["aic"] == fit["aic"]


def test_without_known_noise_its_size_is_fitted_too(make, document, tmp_path, train):
    data = document("calibrate", f"{RIG}/model.toml", few_rows(train, tmp_path / "few.csv"))
    assert data["reduced_chi_square"] is None and data["chi_square"] is None
    # As statsmodels has it of an ordinary regression: -2 llf + 2 k, the size not counted.
    deviance = 6 * (1 + math.log(2 * math.pi * data["rmse"] ** 2))
    assert data["aic"] == pytest.approx(deviance + 2 * 2)
    assert data["bic"] == pytest.approx(deviance + 2 * math.log(6))
    report = fit_report(make("Calibration", data))
    assert pair(fact(report, "AIC, BIC")) == pytest.approx((data["aic"], data["bic"]), rel=1e-5)
    assert "readings with equal weights" in " ".join(report.split())


def test_parameters_have_errors_starts_and_bounds(calibration, make, document):
    report = fit_report(calibration)
    assert "f0: 1.678514 +- 0.01694 (1.01%) (start 2, bounds 0.01 to 30)" in report
    assert "C(f0, z) = -0.5221" in report
    dyno = fit_report(make("Calibration", document("calibrate", "data/measurements/spindle_dyno.toml", "data/measurements/spindle_dyno.csv")))
    assert "f0: 0.01 no stderr (start 1.5, bounds 0.01 to 30), at its lower bound" in dyno
    assert "C(" not in dyno  # one of the two has no error


def test_small_correlations_are_left_out(make, addition):
    data = copy.deepcopy(addition.data)
    matrix = data["calibration"]["correlation"]
    matrix[0][1] = matrix[1][0] = 0.05
    assert "C(f0, z)" in fit_report(addition)
    assert "C(f0, z)" not in fit_report(make("Addition", data))


def test_a_diagnosis_has_the_95_percent_interval_of_its_document(diagnosis):
    p = diagnosis.data["effects"][0]["parameters"]["torque_at_10000_rpm_Nmm"]
    report = " ".join(fit_report(diagnosis).split())
    assert f"95%: {p['from']:.5g} to {p['to']:.5g}" in report
    assert f"(start {diagnosis.data['base_parameters']['f0']['before']:.6g})" in report
    assert diagnosis.data["headline"] in report


def test_no_report_says_that_a_document_lacks_something(calibration, addition, diagnosis, ambiguous):
    for result in (calibration, addition, diagnosis, ambiguous):
        report = " ".join(fit_report(result).split())
        assert "lacks" not in report and "not in the document" not in report


def test_an_addition_compares_before_and_after_under_one_noise(addition):
    before, after = addition.data["before"], addition.data["calibration"]
    aic, bic = pair(fact(fit_report(addition), "dAIC, dBIC"))
    assert aic == pytest.approx(after["aic"] - before["aic"], rel=1e-5)
    assert aic == pytest.approx(2 - addition.data["gain"], rel=1e-5)
    assert bic == pytest.approx(math.log(120) - addition.data["gain"], rel=1e-5)


@pytest.fixture(scope="module")
def profiled(root):
    record = raceway.Record.read(root / RIG / "train.csv")
    with pytest.warns(raceway.Doubt, match="exceeds the noise"):
        return raceway.Model.read(root / RIG / "model.toml").calibrate(record, profile=True)


def test_a_profile_of_a_linear_model_is_as_wide_as_its_errors(profiled):
    # Palmgren's law is linear in f0 and z. The rig lacks a drag: errors are widened, and so is this.
    data, intervals = profiled.data, profiled.conf_interval()
    assert list(intervals.index) == ["f0", "z"]
    rise = data["profile"]["rise"]
    assert rise == pytest.approx(1.959964**2 * data["reduced_chi_square"], rel=1e-6)
    for name, row in intervals.iterrows():
        half = 1.959964 * data["parameters"][name]["std"]
        assert row["upper"] - row["value"] == pytest.approx(half, rel=1e-4)
        assert row["value"] - row["lower"] == pytest.approx(half, rel=1e-4)
        assert not row["open_lower"] and not row["open_upper"]
    assert data["profile"]["refits"] <= 8


def test_profiles_stand_in_reports_and_notebooks_as_the_command_has_them(profiled, document):
    data = document("calibrate", f"{RIG}/model.toml", f"{RIG}/train.csv", "--profile")
    assert profiled.data == data
    p = data["parameters"]["f0"]["profile"]
    ends = f"{p['from']:.5g} to {p['to']:.5g}"
    assert f"95%: {ends}" in " ".join(profiled.fit_report().split())
    html = profiled._repr_html_()
    assert "95 % from" in html and f"{p['from']:.5g}" in html and f"{p['to']:.5g}" in html


def test_a_parameter_at_its_bound_has_an_interval_that_is_open_there(make, document):
    data = document("calibrate", "data/measurements/spindle_dyno.toml", "data/measurements/spindle_dyno.csv", "--profile")
    assert data["parameters"]["f0"]["at_bound"]
    row = conf_interval(make("Calibration", data)).loc["f0"]
    assert row["open_lower"] and row["lower"] == data["parameters"]["f0"]["lower"]
    assert row["upper"] > row["value"]
    assert "95%: 0.01 (open) to" in " ".join(fit_report(make("Calibration", data)).split())


def test_intervals_that_were_not_asked_for_are_refused(calibration, root):
    with pytest.raises(ValueError, match="profile=True"):
        conf_interval(calibration)
    spindle = root / "data/spindles/seats"
    with pytest.raises(raceway.InputError, match="profile likelihood"):
        raceway.Model.read(spindle / "model.toml").calibrate(raceway.Record.read(spindle / "train.csv"), profile=True)


def test_of_several_measured_columns_nothing_is_computed_that_the_document_cannot_tell(make, document):
    spindle = "data/spindles/seats"
    data = document("calibrate", f"{spindle}/model.toml", f"{spindle}/train.csv")
    assert data["readings"] == sum(c["readings"] for c in data["channels"])
    report = fit_report(make("Calibration", data))
    assert fact(report, "AIC, BIC") == "-" and "the readings are correlated" in " ".join(report.split())
    errors = re.findall(r"RMS error += ([0-9.]+) (um|K), before ([0-9.]+)", report)
    assert [float(after) for after, _, _ in errors] == pytest.approx([c["rmse"] for c in data["channels"]], rel=1e-3)
    assert [float(before) for _, _, before in errors] == pytest.approx([c["rmse_before"] for c in data["channels"]], rel=1e-3)
    # Errors of temperatures are differences.
    assert [unit for _, unit, _ in errors] == ["um"] + ["K"] * (len(data["channels"]) - 1)


def test_a_record_over_time_is_judged_by_rows_held_out(make, document):
    folder = "data/corrections/ambient"
    data = document("diagnose", f"{folder}/correction.toml", f"{folder}/train.csv")
    assert data["effects"][0]["gain"] is None and data["baseline"]["aic"] is None
    names, rows = data["correlation"]["names"], data["correlation"]["rows"]
    assert set(data["base_parameters"]) < set(names)
    assert all(row[k] in (1.0, None) for k, row in enumerate(rows))
    report = fit_report(make("Diagnosis", data))
    row = line_of(report, data["effects"][0]["id"])
    assert float(row[-1]) == pytest.approx(data["effects"][0]["rmse_cross_validated"], rel=1e-3)
    assert "dAIC" not in report and "effects.gain is null" in " ".join(report.split())


def test_a_calibration_without_readings_is_refused(make, document):
    data = document("calibrate", "S 6014 C")
    with pytest.raises(ValueError, match="not fitted to readings"):
        fit_report(make("Calibration", data))


def test_nothing_missing_is_a_report_too(make, document):
    rig = "tests/hidden_effect/rigs/dev-01"
    data = document("diagnose", f"{rig}/model.toml", f"{rig}/train.csv")
    assert data["verdict"] == "nothing-missing"
    report = fit_report(make("Diagnosis", data))
    assert "the verdict names no effect" in " ".join(report.split())
    # The parameters are those that calibrate finds.
    found = document("calibrate", f"{rig}/model.toml", f"{rig}/train.csv")["parameters"]
    assert list(data["base_parameters"]) == list(found)
    for name, p in data["base_parameters"].items():
        assert p["after"] == pytest.approx(found[name]["value"], rel=1e-6)
        assert p["std"] == pytest.approx(found[name]["std"], rel=1e-3)
        assert f"{name}: " in report


def test_control_characters_of_names_are_not_printed(make, diagnosis):
    data = copy.deepcopy(diagnosis.data)
    data["model"] = "a\x1b[2Jb\nc"
    data["effects"][0]["id"] = "drag\x1b[31m"
    assert all(c.isprintable() or c == "\n" for c in fit_report(make("Diagnosis", data)))
    assert "a?[2Jb?c" in fit_report(make("Diagnosis", data))


def test_anything_else_is_refused(comparison):
    with pytest.raises(TypeError, match="accepts a Calibration or Addition or Diagnosis"):
        fit_report(comparison)
    with pytest.raises(TypeError, match="one by one"):
        fit_report([comparison])

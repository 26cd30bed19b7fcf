"""Reports of fits agree with the documents and with each other."""

from __future__ import annotations

import copy
import math
import re

import pytest

from raceway._likelihood import likelihood_of
from raceway.fit_report import fit_report

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


def test_chi_square_is_the_reduced_one_by_degrees_of_freedom(calibration):
    data, report = calibration.data, fit_report(calibration)
    chi = data["reduced_chi_square"] * data["degrees_of_freedom"]
    assert float(fact(report, "chi-square")) == pytest.approx(chi, rel=1e-5)
    aic, bic = pair(fact(report, "AIC, BIC"))
    assert aic == pytest.approx(chi + 2 * 2, rel=1e-5)
    assert bic == pytest.approx(chi + 2 * math.log(120), rel=1e-5)
    aic, bic = pair(fact(report, "AIC, BIC as in lmfit"))
    assert aic == pytest.approx(120 * math.log(chi / 120) + 4, rel=1e-5)
    assert bic == pytest.approx(120 * math.log(chi / 120) + 2 * math.log(120), rel=1e-5)


def test_calibrate_add_and_diagnose_agree_on_how_much_better_the_effect_is(
        calibration, addition, diagnosis):
    # The same rows under the same noise: the fall of -2 ln L is the gain, from three documents.
    before, after = likelihood_of(calibration.data), likelihood_of(addition.data["calibration"])
    gain = diagnosis.data["effects"][0]["gain"]
    assert diagnosis.data["effects"][0]["id"] == "lubricant-drag"
    assert before.chi_square - after.chi_square == pytest.approx(gain, rel=1e-6)
    row = line_of(fit_report(diagnosis), "lubricant-drag")
    assert float(row[-2]) == pytest.approx(after.criteria()[0] - before.criteria()[0], abs=0.06)
    assert float(row[-1]) == pytest.approx(after.criteria()[1] - before.criteria()[1], abs=0.06)
    assert float(row[-3]) == pytest.approx(gain, rel=1e-3)


def test_a_free_shape_counts_in_the_criteria_as_in_the_gain(ambiguous):
    # torque-temperature-drift has a size and a shape: its gain is less by ln N already.
    effect = next(e for e in ambiguous.data["effects"] if e["id"] == "torque-temperature-drift")
    assert len(effect["parameters"]) == 2
    row = line_of(fit_report(ambiguous), "torque-temperature-drift")
    fall = effect["gain"] + math.log(120)
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
        numbers = report.splitlines()[line].split(names[-1])[-1].split() or \
            report.splitlines()[line + 1].split()
        assert int(numbers[0]) == 2 + parameters


def test_without_known_noise_the_criteria_come_from_the_rms_error(make, document, tmp_path, train):
    few = tmp_path / "few.csv"
    train.iloc[:12].to_csv(few, index=False)
    data = document("calibrate", f"{RIG}/model.toml", str(few))
    assert data["reduced_chi_square"] is None
    report = fit_report(make("Calibration", data))
    aic, bic = pair(fact(report, "AIC, BIC"))
    assert aic == pytest.approx(12 * math.log(data["rmse"] ** 2) + 2 * 2, rel=1e-5)
    assert bic == pytest.approx(12 * math.log(data["rmse"] ** 2) + 2 * math.log(12), rel=1e-5)
    assert "from the RMS error alone" in " ".join(report.split())


def test_parameters_have_errors_starts_and_bounds(calibration, make, document):
    report = fit_report(calibration)
    assert "f0: 1.678519 +- 0.01693 (1.01%) (start 2, bounds 0.01 to 30)" in report
    assert "C(f0, z) = -0.5220" in report
    dyno = fit_report(make("Calibration", document(
        "calibrate", "data/measurements/spindle_dyno.toml", "data/measurements/spindle_dyno.csv")))
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


def test_what_documents_lack_is_named(calibration, addition, diagnosis):
    assert "noise.log_determinant" in fit_report(calibration)
    assert "before.chi_square" in fit_report(addition)
    assert "field gain" in fit_report(addition)
    assert "baseline.chi_square" in fit_report(diagnosis)


def test_an_addition_compares_before_and_after_by_rms_error(addition):
    data = addition.data
    aic, bic = pair(fact(fit_report(addition), "dAIC, dBIC"))
    fall = 120 * math.log(data["after"]["rmse"] ** 2 / data["before"]["rmse"] ** 2)
    assert aic == pytest.approx(fall + 2, rel=1e-5)
    assert bic == pytest.approx(fall + math.log(120), rel=1e-5)


def test_of_several_measured_columns_nothing_is_computed_that_the_document_cannot_tell(
        make, document):
    spindle = "data/spindles/seats"
    data = document("calibrate", f"{spindle}/model.toml", f"{spindle}/train.csv")
    report = fit_report(make("Calibration", data))
    assert fact(report, "AIC, BIC") == "-" and "channels.readings" in report
    errors = re.findall(r"RMS error += ([0-9.]+) (um|K), before ([0-9.]+)", report)
    assert [float(after) for after, _, _ in errors] == pytest.approx(
        [c["rmse"] for c in data["channels"]], rel=1e-3)
    assert [float(before) for _, _, before in errors] == pytest.approx(
        [c["rmse_before"] for c in data["channels"]], rel=1e-3)
    # Errors of temperatures are differences.
    assert [unit for _, unit, _ in errors] == ["um"] + ["K"] * (len(data["channels"]) - 1)


def test_a_record_over_time_is_judged_by_rows_held_out(make, document):
    folder = "data/corrections/ambient"
    data = document("diagnose", f"{folder}/correction.toml", f"{folder}/train.csv")
    assert data["effects"][0]["gain"] is None
    report = fit_report(make("Diagnosis", data))
    row = line_of(report, data["effects"][0]["id"])
    assert float(row[-1]) == pytest.approx(data["effects"][0]["rmse_cross_validated"], rel=1e-3)
    assert "dAIC" not in report and "effects.gain is null" in " ".join(report.split())


def test_a_calibration_without_readings_is_refused(make, document):
    data = document("calibrate", "S 6014 C")
    with pytest.raises(ValueError, match="of no readings"):
        fit_report(make("Calibration", data))


def test_nothing_missing_is_a_report_too(make, document):
    rig = "tests/hidden_effect/rigs/dev-01"
    data = document("diagnose", f"{rig}/model.toml", f"{rig}/train.csv")
    assert data["verdict"] == "nothing-missing"
    report = fit_report(make("Diagnosis", data))
    assert "none: no effect is named" in " ".join(report.split())
    assert "not in the document" in fact(report, "parameters")


def test_control_characters_of_names_are_not_printed(make, diagnosis):
    data = copy.deepcopy(diagnosis.data)
    data["model"] = "a\x1b[2Jb\nc"
    data["effects"][0]["id"] = "drag\x1b[31m"
    assert all(c.isprintable() or c == "\n" for c in fit_report(make("Diagnosis", data)))
    assert "a?[2Jb?c" in fit_report(make("Diagnosis", data))


def test_anything_else_is_refused(comparison):
    with pytest.raises(TypeError, match="takes a Calibration or Addition or Diagnosis"):
        fit_report(comparison)
    with pytest.raises(TypeError, match="one by one"):
        fit_report([comparison])

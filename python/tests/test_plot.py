"""Pictures show the numbers of the documents, and leave nothing behind."""

from __future__ import annotations

import doctest
import io
import sys

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from raceway import plot

RIG = "tests/hidden_effect/rigs/dev-03"


def widths(ax) -> list[float]:
    return [bar.get_width() for bar in ax.patches]


def labels(ax) -> list[str]:
    return [one.get_text() for one in ax.get_yticklabels()]


@pytest.mark.parametrize("module", ["_documents", "_draw", "plot", "_plot_errors", "_plot_record", "_html", "_likelihood", "fit_report"])
def test_examples_of_the_docstrings_run(module):
    __import__(f"raceway.{module}")
    result = doctest.testmod(sys.modules[f"raceway.{module}"])
    assert result.failed == 0
    assert result.attempted > 0 or module in ("_draw", "_likelihood")


def test_every_public_function_has_an_example():
    for name in plot.__all__:
        assert ">>>" in getattr(plot, name).__doc__


def test_stribeck_has_a_curve_of_the_torques_of_each_load(table):
    ax = plot.stribeck(table)
    frame = table.to_frame()
    assert [line.get_label() for line in ax.lines] == ["100", "300", "900"]
    for line, load in zip(ax.lines, (100, 300, 900)):
        rows = frame[frame.axial_load_N == load]
        assert list(line.get_xdata()) == list(rows.speed_rpm)
        assert list(line.get_ydata()) == list(rows.friction_torque_Nmm)
    assert ax.get_xlabel() == "Speed in rpm"
    assert ax.get_ylabel() == "Friction torque in N mm"
    assert ax.get_legend().get_title().get_text() == "Axial load in N"
    assert ax.get_title() == ""


def test_curves_differ_in_line_and_marker(table):
    lines = plot.stribeck(table).lines
    assert len({(line.get_linestyle(), line.get_marker()) for line in lines}) == len(lines)
    assert len({line.get_linestyle() for line in lines}) == len(lines)
    assert len({line.get_marker() for line in lines}) == len(lines)


def test_stribeck_refuses_to_join_what_differs_in_another_setting(make, csv):
    frame = csv(
        "table", "data/examples/7014.toml", "--speed", "0:8000:4000", "--axial-load", "100,300", "--temperature", "20,60", "--format", "plain"
    )
    with pytest.raises(ValueError, match="temperature_C also varies .20, 60."):
        plot.stribeck(frame)
    ax = plot.stribeck(frame, by=["axial_load_N", "temperature_C"])
    assert [line.get_label() for line in ax.lines] == ["100, 20", "100, 60", "300, 20", "300, 60"]
    assert len(plot.stribeck(frame.query("temperature_C == 20")).lines) == 2


def test_readings_have_the_mark_of_their_curve_and_no_line(csv, train):
    frame = csv("table", f"{RIG}/model.toml", "--speed", "0:16000:4000", "--axial-load", "250,600", "--temperature", "45", "--format", "plain")
    warm = train[(train.temperature_C - 45).abs() < 2]
    ax = plot.stribeck(frame, measured=warm)
    by_label = {line.get_label(): line for line in ax.lines}
    here = warm[warm.axial_load_N == 250]
    assert len(here) > 0
    assert list(by_label["250, measured"].get_ydata()) == list(here.friction_torque_Nmm)
    assert by_label["250, measured"].get_linestyle() == "None"
    assert by_label["250"].get_marker() in (None, "None")
    others = by_label["measured, other"]
    assert len(others.get_xdata()) == (~warm.axial_load_N.isin([250, 600])).sum()


def test_the_band_of_a_table_is_drawn(csv, table):
    frame = table.to_frame().assign(friction_torque_band_Nmm=5.0)
    ax = plot.stribeck(frame)
    assert len(ax.collections) == 3
    top = ax.collections[0].get_paths()[0].vertices[:, 1].max()
    assert top == pytest.approx(frame[frame.axial_load_N == 100].friction_torque_Nmm.max() + 5.0)


def test_a_point_without_result_leaves_a_gap(table):
    frame = table.to_frame().copy()
    frame.loc[1, "friction_torque_Nmm"] = None
    assert np.isnan(plot.stribeck(frame).lines[0].get_ydata()[1])
    frame["friction_torque_Nmm"] = None
    with pytest.raises(ValueError, match="no point of the table has a torque"):
        plot.stribeck(frame)


def test_contact_angles_of_a_shaft_share_the_curve_of_equal_bearings(displacement):
    ax = plot.contact_angles(displacement)
    frame = displacement.to_frame()
    assert [line.get_label() for line in ax.lines] == [
        "front 1 and front 2, inner race",
        "front 1 and front 2, outer race",
        "rear 1, inner race",
        "rear 1, outer race",
    ]
    assert list(ax.lines[3].get_ydata()) == list(frame.rear_1_outer_contact_angle_deg)
    assert [line.get_linestyle() for line in ax.lines] == ["-", "--", "-", "--"]


def test_contact_angles_have_a_band_where_balls_differ(csv, table):
    assert len(plot.contact_angles(table).collections) == 0  # thrust alone: all balls alike
    frame = csv("table", "data/examples/7014.toml", "--speed", "2000,6000", "--axial-load", "900", "--radial-load", "400", "--format", "plain")
    ax = plot.contact_angles(frame)
    assert len(ax.collections) == 2
    inner = ax.collections[0].get_paths()[0].vertices[:, 1]
    assert inner.min() == pytest.approx(frame.inner_contact_angle_min_deg.min())
    assert inner.max() == pytest.approx(frame.inner_contact_angle_max_deg.max())


def test_bars_of_the_ladder_are_the_errors_of_the_document(diagnosis):
    data = diagnosis.data
    ax = plot.ladder(diagnosis)
    assert widths(ax) == [data["rmse_before"], data["rmse_after"], data["noise"]["rms"]]
    assert labels(ax) == ["before", "after", "noise"]
    assert [t.get_text() for t in ax.texts] == ["44.9", "10.7", "10.4"]
    assert ax.get_xlabel() == "RMS error of friction torque in N mm"


def test_the_ladder_of_an_addition_has_rows_held_out(addition):
    data = addition.data
    assert widths(plot.ladder(addition)) == [data["before"]["rmse"], data["after"]["rmse"], data["rmse_held_out_before"], data["rmse_held_out_after"]]


def test_before_and_after_say_whose_they_are_where_several_stand(diagnosis, comparison):
    assert labels(plot.ladder(comparison, diagnosis))[:3] == ["model.toml", "before (diagnosis)", "after (diagnosis)"]


def test_models_stand_in_one_ladder_over_one_noise(make, document, comparison):
    refit = make("Comparison", document("compare", f"{RIG}/model.toml", f"{RIG}/train.csv", "--refit", "f0,z"))
    ax = plot.ladder(comparison, refit, labels=["as it is", "refitted"])
    assert labels(ax) == ["as it is", "refitted", "noise, estimated"]
    assert widths(ax)[:2] == [comparison.data["rmse"], refit.data["rmse"]]
    assert widths(ax)[2] == pytest.approx(comparison.data["noise"]["estimated_rms"], rel=1e-6)


def test_several_models_in_one_document_are_steps_of_one_ladder(make, document):
    data = document("compare", f"{RIG}/model.toml", "tests/hidden_effect/rigs/dev-01/model.toml", f"{RIG}/train.csv")
    ax = plot.ladder(make("Comparison", data))
    assert widths(ax)[:2] == [model["rmse"] for model in data["models"]]


def test_the_tolerance_is_a_line_across_the_ladder(make, document):
    data = document("diagnose", f"{RIG}/model.toml", f"{RIG}/train.csv", "--tolerance", "20Nmm")
    ax = plot.ladder(make("Diagnosis", data))
    assert list(ax.lines[0].get_xdata()) == [20.0, 20.0]


def test_errors_of_different_units_have_no_common_ladder(make, document, comparison):
    shaft = make("Comparison", document("compare", "data/spindles/two_against_one.toml", "data/spindles/other_grooves.csv"))
    with pytest.raises(ValueError, match="N mm and in µm"):
        plot.ladder(comparison, shaft)
    assert plot.ladder(shaft).get_xlabel() == "RMS error of axial displacement in µm"


def test_of_several_measured_columns_the_ladder_is_of_the_first(make, document):
    spindle = "data/spindles/seats"
    data = document("compare", f"{spindle}/model.toml", f"{spindle}/train.csv")
    ax = plot.ladder(make("Comparison", data))
    assert widths(ax)[0] == data["rmse"] == data["channels"][0]["rmse"]
    # An error of temperatures is a difference.
    assert plot.ladder(make("Comparison", data["channels"][1])).get_xlabel().endswith("in K")


def test_the_map_tells_sign_by_shape_and_size_by_area(comparison):
    frame = comparison.to_frame()
    ax = plot.residuals(comparison)
    drawn = {tuple(c.get_offsets()[0]): c for c in ax.collections}
    assert len(ax.collections) == len(frame)
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("Speed in rpm", "Axial load in N")
    by_size = frame.reindex(frame.error.abs().sort_values(ascending=False).index)
    area = [c.get_sizes()[0] for c in ax.collections]
    assert area == pytest.approx(list(by_size.error.abs() / by_size.error.abs().max() * area[0]))
    assert set(drawn) == set(zip(frame.speed_rpm, frame.axial_load_N))
    assert ax.get_legend().get_title().get_text().endswith("in N mm")


def test_opposite_errors_have_different_shapes_and_fillings():
    rows = pd.DataFrame({"speed_rpm": [1.0, 2.0], "axial_load_N": [1.0, 2.0], "error": [5.0, -5.0]})
    up, down = plot.residuals(rows).collections
    assert up.get_paths()[0].vertices[0, 1] > 0 > down.get_paths()[0].vertices[0, 1]
    assert up.get_facecolor().size > 0 and down.get_facecolor().size == 0


def test_errors_over_one_setting_stand_around_the_known_noise(make, document):
    data = document("compare", "data/measurements/flywheel.toml", "data/measurements/flywheel_unloaded.csv")
    worst = pd.DataFrame(data["worst_rows"]).assign(speed_rpm=[5.0, 4.0, 3.0, 2.0, 1.0])
    ax = plot.residuals(make("Comparison", data, worst.rename(columns={"residual": "error"})), y=None)
    band = ax.patches[0].get_xy()[:, 1]
    assert band.max() == -band.min() == data["noise"]["rms"]
    assert sorted(v for line in ax.lines[1:] for v in line.get_ydata()) == sorted(r["residual"] for r in data["worst_rows"])
    assert ax.get_ylabel() == "Prediction minus reading in N mm"


def test_a_record_has_one_axes_for_each_unit(train):
    axes = plot.record(train)
    assert [ax.get_ylabel().replace("\n", " ") for ax in axes] == ["Speed in rpm", "Load in N", "Temperature in °C", "Friction torque in N mm"]
    assert axes[-1].get_xlabel() == "Time in h"
    drawn = np.concatenate([line.get_ydata() for line in axes[3].lines])
    assert list(drawn) == list(train.friction_torque_Nmm)
    hours = np.concatenate([line.get_xdata() for line in axes[3].lines])
    assert list(hours) == pytest.approx(list(train.time_s / 3600.0))


def test_runs_are_not_joined_by_a_line(train):
    assert len(plot.record(train, ["friction_torque_Nmm"])[0].lines) == train.run_id.nunique()


def test_a_record_without_time_is_drawn_over_speed_without_lines(train):
    (ax,) = plot.record(train.drop(columns="time_s"), ["friction_torque_Nmm"])
    assert ax.get_xlabel() == "Speed in rpm"
    assert {line.get_linestyle() for line in ax.lines} == {"None"}


def test_a_record_takes_as_many_axes_as_it_has_units(train):
    figure, axes = plt.subplots(2, 1)
    try:
        with pytest.raises(ValueError, match="4 units .rpm, N, °C, N mm. need 4 axes, not 2"):
            plot.record(train, ax=axes)
        assert plot.record(train, ["speed_rpm", "temperature_C"], ax=axes) == list(axes)
    finally:
        plt.close(figure)


def test_campbell_joins_the_modes_of_each_whirl(modes):
    ax = plot.campbell(modes)
    rows = modes.data["rows"]
    lowest = {whirl: [min(m["frequency_Hz"] for m in row["modes"] if m["whirl"] == whirl) for row in rows[1:]] for whirl in ("forward", "backward")}
    by_label = {line.get_label(): line for line in ax.lines}
    forward, backward = by_label["forward whirl"], by_label["backward whirl"]
    assert list(forward.get_ydata()[1:]) == lowest["forward"]
    assert list(backward.get_ydata()[1:]) == lowest["backward"]
    # At standstill both begin at the same standing mode.
    assert forward.get_ydata()[0] == backward.get_ydata()[0] == rows[0]["modes"][0]["frequency_Hz"]
    assert forward.get_linestyle() != backward.get_linestyle()
    once = by_label["1×"]
    assert once.get_ydata()[1] == once.get_xdata()[1] / 60.0


@pytest.mark.parametrize(
    "draw, wrong, error, words",
    [
        (plot.stribeck, [1, 2], TypeError, "call it for each"),
        (plot.stribeck, 3.0, TypeError, "accepts a Table"),
        (plot.stribeck, pd.DataFrame({"speed_rpm": []}), ValueError, "no rows"),
        (plot.stribeck, pd.DataFrame({"speed_rpm": [1]}), ValueError, "no column 'friction_torq"),
        (plot.contact_angles, pd.DataFrame({"speed_rpm": [1]}), ValueError, "no column 'inner_contact"),
        (plot.residuals, pd.DataFrame({"speed_rpm": [1]}), ValueError, "no column 'error'"),
        (plot.residuals, [], TypeError, "accepts a Comparison"),
        (plot.record, pd.DataFrame({"speed": [1]}), ValueError, "neither time_s nor speed_rpm"),
        (plot.record, {"time_s": [1]}, TypeError, "accepts a record"),
        (plot.campbell, pd.DataFrame(), TypeError, "accepts a Modes"),
        (plot.ladder, [], TypeError, "one by one"),
        (plot.ladder, None, TypeError, "accepts a Comparison"),
    ],
)
def test_wrong_use_is_told(draw, wrong, error, words):
    with pytest.raises(error, match=words):
        draw(wrong)


def test_more_wrong_use_is_told(table, diagnosis, displacement, modes, make, train):
    with pytest.raises(ValueError, match="no column 'load_N'; the columns are speed_rpm"):
        plot.stribeck(table, by="load_N")
    with pytest.raises(ValueError, match="nothing to draw"):
        plot.ladder()
    with pytest.raises(ValueError, match="a sequence of 2"):
        plot.ladder(diagnosis, labels=["one"])
    with pytest.raises(ValueError, match="its bearings"):
        plot.contact_angles(displacement, by="axial_load_N")
    with pytest.raises(TypeError, match="ndarray, not a matplotlib Axes; give one element of it"):
        plot.stribeck(table, ax=np.array([1, 2]))
    with pytest.raises(TypeError, match="must be a sequence"):
        plot.record(train, "speed_rpm")
    with pytest.raises(ValueError, match="contains text"):
        plot.record(train.assign(words="a"), ["words"])
    with pytest.raises(ValueError, match="no speed has modes"):
        plot.campbell(make("Modes", {"rows": [{"speed_rpm": 1.0, "modes": []}]}))
    with pytest.raises(ValueError, match="no row has a prediction"):
        plot.residuals(pd.DataFrame({"speed_rpm": [1.0], "axial_load_N": [1.0], "error": [None]}))


def every_picture(table, displacement, diagnosis, comparison, modes, train, ax=None):
    return [
        plot.stribeck(table, ax=ax),
        plot.contact_angles(table, ax=ax),
        plot.contact_angles(displacement, ax=ax),
        plot.ladder(diagnosis, ax=ax),
        plot.residuals(comparison, ax=ax),
        plot.residuals(comparison, y=None, ax=ax),
        plot.record(train, ["speed_rpm"], ax=ax)[0],
        plot.campbell(modes, ax=ax),
    ]


def test_new_figures_are_pyplots_and_given_ones_are_left_alone(table, displacement, diagnosis, comparison, modes, train):
    settings = dict(mpl.rcParams)
    pictures = every_picture(table, displacement, diagnosis, comparison, modes, train)
    assert dict(mpl.rcParams) == settings
    # A notebook shows the figures that pyplot knows.
    assert {ax.figure.number for ax in pictures} <= set(plt.get_fignums())
    plt.close("all")
    figure, (one, other) = plt.subplots(1, 2)
    try:
        plt.sca(other)
        for ax in every_picture(table, displacement, diagnosis, comparison, modes, train, ax=one):
            assert ax is one
        assert plt.gca() is other
        assert not other.has_data()
    finally:
        plt.close(figure)


def test_labels_and_legends_lie_inside_the_figure_and_off_the_axes(table, displacement, diagnosis, comparison, modes, train):
    pictures = every_picture(table, displacement, diagnosis, comparison, modes, train)
    for ax in [*pictures, *plot.record(train)]:
        figure = ax.figure
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        renderer = canvas.get_renderer()
        inside = figure.bbox.padded(1.0)
        low, high = sorted(ax.get_ylim())
        ticks = [one for one in ax.get_yticklabels() if low <= one.get_position()[1] <= high]
        words = [ax.xaxis.label, ax.yaxis.label, *ticks, *ax.texts]
        parts = [one for one in words if one.get_text()] + [ax.get_legend()]
        for part in [one for one in parts if one is not None]:
            box = part.get_window_extent(renderer)
            assert inside.contains(box.x0, box.y0) and inside.contains(box.x1, box.y1), part
        if ax.get_legend() is not None:
            assert ax.get_legend().get_window_extent(renderer).x0 >= ax.bbox.x1


def test_pictures_can_be_saved_for_papers(table):
    out = io.BytesIO()
    plot.stribeck(table).figure.savefig(out, format="pdf")
    assert out.getvalue().startswith(b"%PDF")

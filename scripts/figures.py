#!/usr/bin/env python3
"""Draws the figures of docs/ from numbers of the program.

    python3 scripts/figures.py [build/release/raceway]

writes docs/laws.svg, docs/race-control.svg, docs/spindle-day.svg, docs/case-study.svg and docs/chain-*.svg.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update(
    {
        "svg.fonttype": "none",  # text stays text
        "svg.hashsalt": "raceway",  # the same numbers give the same file
        "font.family": "sans-serif",
        "font.size": 9,
        "axes.titlesize": 9,
        "axes.titlelocation": "left",
        "axes.grid": True,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "grid.color": "#ddd",
    }
)
from matplotlib import pyplot

BLUE, RED, GREEN, VIOLET, ORANGE = "#1f5fa8", "#b5431d", "#2d7d46", "#6a3d9a", "#e8a33d"
BALLS = {"steel": "-", "silicon-nitride": "--"}


def line(points, colour, name=None, style="-"):
    """(x, y) points as a line; where y is None it has a gap."""
    return list(points), {"color": colour, "label": name, "linestyle": style}


def draw(target, charts, columns=2, width=4.6, height=3.2):
    """Writes an SVG picture to a file or stream: `charts` of (title, lines), beside each other in `columns`."""
    rows = -(-len(charts) // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(columns * width, rows * height + 0.4), layout="constrained", squeeze=False)
    legend = {}
    for axis, (title, lines) in zip(axes.flat, charts):
        for points, style in lines:
            x, y = zip(*[(x, float("nan") if y is None else y) for x, y in points])
            (handle,) = axis.plot(x, y, **style)
            if style["label"]:
                legend.setdefault(style["label"], handle)
        axis.set_title(title)
        axis.margins(x=0)
    if legend:
        figure.legend(legend.values(), legend.keys(), loc="upper center", bbox_to_anchor=(0.5, 0), ncols=min(4, len(legend)), frameon=False)
    figure.savefig(target, format="svg", bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)


def answer(program, text, *arguments):
    """The JSON document of a question about a model text."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        run = subprocess.run([program, arguments[0], file.name, "--json", *arguments[1:]], check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def with_balls(text, material):
    return text.replace('ball_material = "steel"', f'ball_material = "{material}"')


def laws(program):
    """Friction torque of one bearing by every law."""
    model = read("data/examples/7014.toml")
    spin = '\n[[effect]]\nid = "spin-friction"\nfriction_coefficient = 0.06\n'

    def by(law):
        return model.split("[friction]")[0] + f'[friction]\nlaw = "{law}"\n'

    models = {
        "palmgren": (BLUE, model),
        "palmgren + spin-friction": (RED, model + spin),
        "skf": (GREEN, by("skf")),
        "contact": (VIOLET, by("contact")),
    }

    def lines(key, *axes):
        for name, (colour, text) in models.items():
            for material, style in BALLS.items():
                rows = answer(program, with_balls(text, material), "table", *axes)["rows"]
                yield line([(row[key], row["friction_torque_Nmm"]) for row in rows], colour, f"{name}, {material}", style)

    draw(
        "docs/laws.svg",
        [
            ("friction torque [N mm] against speed [rpm], 300 N", list(lines("speed_rpm", "--speed", "0:12000:150", "--axial-load", "300"))),
            ("the same against axial load [N], 10000 rpm", list(lines("axial_load_N", "--speed", "10000", "--axial-load", "50:2000:50"))),
        ],
    )


def race_control(program):
    """Angles, displacement and torque of one bearing under each race control, over speed."""
    model = read("data/examples/race-control.toml")
    quantities = {
        "outer contact angle [deg]": lambda s: s["balls"][0]["outer_contact_angle_deg"],
        "axial displacement [um]": lambda s: s["axial_displacement_um"],
        "friction torque [N mm]": lambda s: s["friction_torque_Nmm"],
    }
    runs = []
    for control, colour in [("outer", BLUE), ("inner", RED), ("balanced", GREEN)]:
        for material, style in BALLS.items():
            text = with_balls(model.replace('race_control = "balanced"', f'race_control = "{control}"'), material)
            states = [answer(program, text, "solve", "--axial-load", "500", "--speed", str(n)) for n in [100, *range(500, 15001, 500)]]
            runs.append((states, colour, f"{control}, {material}", style))
    charts = [
        (f"{title} against speed [rpm]", [line([(s["speed_rpm"], number(s)) for s in states], *look) for states, *look in runs])
        for title, number in quantities.items()
    ]
    draw("docs/race-control.svg", charts, columns=3, width=3.6)


def spindle_day(program):
    """A spindle through eight hours, cooled and not."""

    def day(*flags):
        with tempfile.TemporaryDirectory() as folder:
            out = folder + "/run.csv"
            profile = ["--speed-profile", "data/spindles/day.csv"]
            subprocess.run(
                [program, "spindle", "data/spindles/externally_driven.toml", *profile, "-o", out, "--quiet", *flags], check=True, capture_output=True
            )
            return list(csv.DictReader(row for row in read(out).splitlines() if not row.startswith("#")))

    def over_hours(rows, column):
        return [(float(row["time_s"]) / 3600.0, float(row[column])) for row in rows]

    runs = [(day(), BLUE, "cooled"), (day("--coolant", "off"), RED, "coolant off")]
    charts = [("speed [rpm] over time [h]", [line(over_hours(runs[0][0], "speed_rpm"), "#222")])]
    for title, column in [("nose against flange [um]", "axial_displacement_um"), ("force of the front set [N]", "front_force_N")]:
        charts.append((title, [line(over_hours(rows, column), colour, name) for rows, colour, name in runs]))
    rings = [
        line(over_hours(rows, f"front_1_{ring}_ring_temperature_C"), colour, None, style)
        for rows, colour, _ in runs
        for ring, style in [("inner", "-"), ("outer", "--")]
    ]
    draw("docs/spindle-day.svg", charts + [("first bearing: inner ring, outer ring dashed [C]", rings)])


def rows_of(path):
    """Rows of a CSV by column, without its comments."""
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(row for row in file if not row.startswith("#")))


def case_study(program):
    """Table 1 of the case study with prediction and fit, and the shaft's displacement."""
    folder = "data/spindles/case_study/"

    def over_hours(rows, column):
        return [(float(row["time_s"]) / 3600.0, float(row[column])) for row in rows if row[column]]

    def points(values, colour, name, marker):
        return values, {"color": colour, "label": name, "linestyle": "none", "marker": marker}

    record = rows_of(folder + "record.csv")
    runs = []
    with tempfile.TemporaryDirectory() as scratch:
        fitted = scratch + "/fitted.toml"
        subprocess.run([program, "calibrate", folder + "model.toml", folder + "record.csv", "-o", fitted, "--quiet"], check=True, capture_output=True)
        for k, (model, colour, name) in enumerate([(folder + "model.toml", RED, "predicted"), (fitted, BLUE, "f0 fitted")]):
            out = f"{scratch}/{k}.csv"
            command = [program, "spindle", model, "--speed-profile", folder + "record.csv", "-o", out, "--quiet"]
            subprocess.run(command, check=True, capture_output=True)
            runs.append((rows_of(out), colour, name))
    changed = {"5500", "6500"}
    charts = []
    for place in ("front", "rear"):
        column = f"{place}_bearing_temperature_C"
        lines = [line(over_hours(rows, column), colour, name) for rows, colour, name in runs]
        lines.append(points(over_hours(record, column), "#222", "as read", "o"))
        if place == "rear":
            at = [row for row in record if row["speed_rpm"] in changed]
            lines.append(points([(float(row["time_s"]) / 3600.0, 20.0) for row in at], ORANGE, "misprinted", "x"))
        charts.append((f"{place} bearing [C] over time [h]", lines))
    text = read(folder + "model.toml")
    shaft = []
    for flags, colour, name in [(("8500",), GREEN, "8500 rpm, cooled"), (("4000", "--coolant", "off"), VIOLET, "4000 rpm, coolant off")]:
        places = answer(program, text, "spindle", "--steady", "--speed", *flags)["steady"][0]["shaft"]
        shaft.append(line([(p["position_mm"], p["axial_displacement_um"]) for p in places], colour, name))
    draw("docs/case-study.svg", charts + [("shaft against flange [um] over place behind the nose [mm]", shaft)], columns=3, width=3.6)


def chain(program):
    """The chain of docs/chain.md: the rig and the spindle, the parts of the sum over 45 h, what each link leaves."""
    program = os.path.abspath(program)
    data = os.path.abspath("data/chain") + "/"
    with tempfile.TemporaryDirectory() as folder:

        def raceway(*arguments):
            run = subprocess.run([program, *arguments], cwd=folder, check=True, capture_output=True, text=True)
            return json.loads(run.stdout) if "--json" in arguments else None

        def here(name):
            return os.path.join(folder, name)

        for name in ("rig.toml", "spindle.toml"):
            shutil.copy(data + name, folder)
        raceway("calibrate-sensor", data + "weights.csv", "-o", "sensor.toml")
        raceway("calibrate", "rig.toml", data + "signals.csv", "-o", "fitted.toml")
        raceway("check", "fitted.toml", data + "signals.csv", "-o", "torque.csv")
        axes = ["--speed", "0:10000:500", "--axial-load", "100:1500:100", "--temperature", "20:100:10"]
        raceway("table", "fitted.toml", *axes, "--band", "-o", "stribeck.csv")
        steps = raceway(
            "step-response",
            "spindle.toml",
            "--speed",
            "1000:10000:1000",
            "--coolant",
            "off",
            "--law",
            "line",
            "--lags",
            "one",
            "--correction",
            "spindle_part.toml",
            "--json",
        )
        raceway("identify", data + "machine.toml", data + "calibration.csv", "-o", "machine_part.toml")
        raceway("join", "spindle_part.toml", "machine_part.toml", "-o", "sum.toml")
        raceway("calibrate", "sum.toml", data + "verification.csv", "--until", "20h", "-o", "correction.toml")
        loads = ("100", "300", "500", "900")
        fitted = raceway("table", "fitted.toml", "--speed", "500:10000:250", "--axial-load", ",".join(loads), "--json")["rows"]
        measured = rows_of(here("torque.csv"))
        runs = {}
        for model in ("spindle_part", "machine_part", "sum", "correction"):
            raceway("correct", model + ".toml", data + "verification.csv", "-o", model + ".csv")
            runs[model] = rows_of(here(model + ".csv"))

    colours = dict(zip(loads, (BLUE, GREEN, ORANGE, RED)))

    def torque(rows, load):
        return [(float(row["speed_rpm"]), float(row["friction_torque_Nmm"])) for row in rows if float(row["axial_load_N"]) == float(load)]

    friction = [line(torque(fitted, load), colours[load], f"{load} N, fitted") for load in loads]
    for load in loads:
        points, style = line(torque(measured, load), colours[load], None, "")
        friction.append((points, {**style, "marker": ".", "label": "readings of the rig" if load == loads[0] else None}))
    gain, time = steps["K_of_P"], steps["T_of_P"]
    powers = [row["power_end_W"] for row in steps["rows"]]

    def law(of, unit):
        return [(P, of[f"slope_{unit}_W"] * P + of[f"offset_{unit}"]) for P in powers]

    def dots(key):
        points, style = line([(row["power_end_W"], row[key]) for row in steps["rows"]], BLUE, "step responses", "")
        return points, {**style, "marker": "o"}

    draw(
        "docs/chain-spindle.svg",
        [
            ("friction torque on the rig [N mm] against speed [rpm]", friction),
            ("gain K [um] against friction power [W]", [dots("K_um"), line(law(gain, "um"), RED, "as published, a line")]),
            ("time constant T [min] against friction power [W]", [dots("T_min"), line(law(time, "min"), RED, "as published, a line")]),
        ],
        columns=3,
        width=3.6,
    )

    def over(rows, of):
        hours = [(float(row["time_s"]) / 3600.0, of(row)) for row in rows]
        middle = sum(y for _, y in hours) / len(hours)
        return [(t, y - middle) for t, y in hours]

    def predicted(row):
        return float(row["predicted_um"])

    def left(row):
        return float(row["residual_um"])

    names = {"spindle_part": (VIOLET, "spindle"), "machine_part": (GREEN, "feed and room"), "sum": (RED, "both")}
    reading = line(over(runs["sum"], lambda row: predicted(row) + left(row)), "#222", "reading")
    draw(
        "docs/chain-parts.svg",
        [
            (
                "nose of the machine over time [h], a constant taken off [um]",
                [reading, *(line(over(runs[key], predicted), *names[key]) for key in names)],
            )
        ],
        columns=1,
        width=9.2,
    )
    final = {"spindle_part": (VIOLET, "spindle alone"), "sum": (RED, "both"), "correction": (BLUE, "both, after 20 h of readings")}
    draw(
        "docs/chain-error.svg",
        [("reading less correction over time [h], a constant taken off [um]", [line(over(runs[key], left), *final[key]) for key in final])],
        columns=1,
        width=9.2,
    )


if __name__ == "__main__":
    PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/release/raceway"
    for figure_of in (laws, race_control, spindle_day, case_study, chain):
        figure_of(PROGRAM)

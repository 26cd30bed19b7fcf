#!/usr/bin/env python3
"""Draws docs/laws.svg: the friction torque of one bearing by every law, steel and ceramic balls.

    python3 scripts/laws_plot.py [build/release/raceway] > docs/laws.svg
"""

import json
import subprocess
import sys
import tempfile

from svg_chart import panel, picture

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/release/raceway"
MODEL = open("data/examples/7014.toml", encoding="utf-8").read()
SPIN = '\n[[effect]]\nid = "spin-friction"\nfriction_coefficient = 0.06\n'


def by_law(name):
    """The model with another law."""
    return MODEL.split("[friction]")[0] + f'[friction]\nlaw = "{name}"\n'


LAWS = [
    ("palmgren", "#1f5fa8", MODEL),
    ("palmgren + spin-friction", "#b5431d", MODEL + SPIN),
    ("skf", "#2d7d46", by_law("skf")),
    ("contact", "#6a3d9a", by_law("contact")),
]
BALLS = [("steel", ""), ("silicon-nitride", ' stroke-dasharray="7 4"')]


def torque(text, key, axes):
    """Friction torque over `key`."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        run = subprocess.run([PROGRAM, "table", file.name, "--json", *axes], check=True, capture_output=True, text=True)
    return [(row[key], row["friction_torque_Nmm"]) for row in json.loads(run.stdout)["rows"]]


def lines(key, axes):
    """One for each law and material."""
    return [
        (torque(text.replace('ball_material = "steel"', f'ball_material = "{balls}"'), key, axes), colour, dash)
        for _, colour, text in LAWS
        for balls, dash in BALLS
    ]


def main():
    moments = list(range(0, 1401, 200))
    panels = [
        panel(
            0,
            "friction torque [N mm] against speed [rpm], 300 N",
            [0, 3000, 6000, 9000, 12000],
            moments,
            lines("speed_rpm", ["--speed", "0:12000:150", "--axial-load", "300"]),
        ),
        panel(
            1,
            "friction torque [N mm] against axial load [N], 10000 rpm",
            [0, 500, 1000, 1500, 2000],
            moments,
            lines("axial_load_N", ["--speed", "10000", "--axial-load", "50:2000:50"]),
        ),
    ]
    print(picture(panels, [(name, colour, "") for name, colour, _ in LAWS] + [(f"{name} balls", "#222", dash) for name, dash in BALLS]))


main()

#!/usr/bin/env python3
"""Draws docs/race-control.svg: angles, displacement and torque of one bearing under each race control.

    python3 scripts/race_control_plot.py [build/release/raceway] > docs/race-control.svg
"""

import json
import subprocess
import sys
import tempfile

from svg_chart import panel, picture

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/release/raceway"
MODEL = open("data/examples/race-control.toml", encoding="utf-8").read()
CONTROLS = [("outer", "#1f5fa8"), ("inner", "#b5431d"), ("balanced", "#2d7d46")]
BALLS = [("steel", ""), ("silicon-nitride", ' stroke-dasharray="7 4"')]
SPEEDS = [100] + list(range(500, 15001, 500))
TICKS = [0, 3000, 6000, 9000, 12000, 15000]
NARROW = 330


def states(control, balls):
    """One result at each speed."""
    text = MODEL.replace('race_control = "balanced"', f'race_control = "{control}"')
    found = []
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text.replace('ball_material = "steel"', f'ball_material = "{balls}"'))
        file.flush()
        for speed in SPEEDS:
            run = subprocess.run(
                [PROGRAM, "solve", file.name, "--json", "--axial-load", "500", "--speed", str(speed)], check=True, capture_output=True, text=True
            )
            found.append(json.loads(run.stdout))
    return found


def main():
    runs = [(states(control, balls), colour, dash) for control, colour in CONTROLS for balls, dash in BALLS]

    def lines(number):
        return [([(s["speed_rpm"], number(s)) for s in found], colour, dash) for found, colour, dash in runs]

    panels = [
        panel(
            0,
            "outer contact angle [deg] against speed [rpm]",
            TICKS,
            range(0, 31, 5),
            lines(lambda s: s["balls"][0]["outer_contact_angle_deg"]),
            width=NARROW,
        ),
        panel(1, "axial displacement [um]", TICKS, range(-40, 11, 10), lines(lambda s: s["axial_displacement_um"]), width=NARROW),
        panel(2, "friction torque [N mm]", TICKS, range(0, 501, 100), lines(lambda s: s["friction_torque_Nmm"]), width=NARROW),
    ]
    print(
        picture(
            panels,
            [(f"{control} control" if control != "balanced" else control, colour, "") for control, colour in CONTROLS]
            + [(f"{name} balls", "#222", dash) for name, dash in BALLS],
            width=NARROW,
        )
    )


main()

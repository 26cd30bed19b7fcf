#!/usr/bin/env python3
"""Draws docs/spindle-day.svg: a spindle through eight hours, cooled and not.

    python3 scripts/spindle_plot.py [build/release/raceway] > docs/spindle-day.svg
"""

import csv
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/release/raceway"
MODEL = "data/spindles/externally_driven.toml"
DAY = "data/spindles/day.csv"
WIDTH, HEIGHT, LEFT, TOP, GAP = 760, 120, 64, 40, 44
COOLED, UNCOOLED = "#1f5fa8", "#b5431d"


def run_day(*flags):
    """Columns of a run by name."""
    with tempfile.TemporaryDirectory() as folder:
        out = folder + "/run.csv"
        subprocess.run([PROGRAM, "spindle", MODEL, "--speed-profile", DAY, "-o", out, "--quiet", *flags], check=True, capture_output=True)
        with open(out, encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}


def panel(index, title, lines, top, step):
    """One chart over the hours."""
    y_end = TOP + index * (HEIGHT + GAP) + HEIGHT
    out = [f'<text x="{LEFT}" y="{y_end - HEIGHT - 10}">{title}</text>']
    for value in range(0, top + 1, step):
        y = y_end - HEIGHT * value / top
        out.append(f'<path stroke="#ddd" d="M {LEFT} {y:.1f} h {WIDTH}"/>')
        out.append(f'<text x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{value}</text>')
    for hour in range(0, 9):
        x = LEFT + WIDTH * hour / 8
        out.append(f'<text x="{x:.1f}" y="{y_end + 16}" text-anchor="middle">{hour} h</text>')
    for colour, times, values, dash in lines:
        points = " ".join(f"{LEFT + WIDTH * t / 28800:.1f} {y_end - HEIGHT * v / top:.1f}" for t, v in zip(times, values))
        out.append(f'<path fill="none" stroke="{colour}" stroke-width="1.6"{dash} d="M {points}"/>')
    return out


def main():
    runs = [(COOLED, run_day()), (UNCOOLED, run_day("--coolant", "off"))]
    total = TOP + 4 * (HEIGHT + GAP) + 24
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {LEFT + WIDTH + 30} {total}" ' f'font-family="sans-serif" font-size="12">',
        f'<rect width="{LEFT + WIDTH + 30}" height="{total}" fill="white"/>',
    ]
    day = runs[0][1]
    lines += panel(0, "speed [rpm]", [("#222", day["time_s"], day["speed_rpm"], "")], 12000, 4000)
    charts = [
        ("nose against flange [um]", ["axial_displacement_um"], 80, 20),
        ("force of the front set [N]", ["front_force_N"], 2000, 500),
        ("first bearing: inner ring, outer ring dashed [C]", ["front_1_inner_ring_temperature_C", "front_1_outer_ring_temperature_C"], 80, 20),
    ]
    for index, (title, keys, top, step) in enumerate(charts, 1):
        curves = [(colour, run["time_s"], run[key], ' stroke-dasharray="5 3"' if k else "") for colour, run in runs for k, key in enumerate(keys)]
        lines += panel(index, title, curves, top, step)
    y = total - 12
    for x, colour, words in [(LEFT, COOLED, "cooled"), (LEFT + 120, UNCOOLED, "coolant off")]:
        lines.append(f'<path stroke="{colour}" stroke-width="2" d="M {x} {y - 4} h 28"/>')
        lines.append(f'<text x="{x + 34}" y="{y}">{words}</text>')
    print("\n".join(lines + ["</svg>"]))


main()

#!/usr/bin/env python3
"""Draws docs/laws.svg: the friction torque of one bearing by every law, steel and ceramic balls.

    python3 scripts/laws_plot.py [build/release/raceway] > docs/laws.svg
"""

import json
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "build/release/raceway"
MODEL = open("data/examples/7014.toml", encoding="utf-8").read()
SKF = 'law = "skf"\n'
SPIN = '\n[[effect]]\nid = "spin-friction"\nfriction_coefficient = 0.06\n'
LAWS = [("palmgren", "#1f5fa8", lambda text: text),
        ("palmgren + spin-friction", "#b5431d", lambda text: text + SPIN),
        ("skf", "#2d7d46", lambda text: text.split("[friction]")[0] + "[friction]\n" + SKF)]
BALLS = [("steel", ""), ("silicon-nitride", ' stroke-dasharray="7 4"')]
WIDTH, HEIGHT, LEFT, TOP, GAP = 400, 300, 60, 50, 80


def torque(text, axes):
    """Rows of a table."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(text)
        file.flush()
        run = subprocess.run([PROGRAM, "table", file.name, "--json", *axes], check=True,
                             capture_output=True, text=True)
    return json.loads(run.stdout)["rows"]


def panel(left, title, key, axes, ticks, top, step):
    """One chart over `key`."""
    x_end = ticks[-1]

    def place(x, y):
        return left + WIDTH * x / x_end, TOP + HEIGHT * (1 - y / top)

    out = [f'<text x="{left}" y="{TOP - 16}">{title}</text>']
    for value in range(0, top + 1, step):
        y = place(0, value)[1]
        out.append(f'<path stroke="#ddd" d="M {left} {y:.1f} h {WIDTH}"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{value}</text>')
    for value in ticks:
        x = place(value, 0)[0]
        out.append(f'<text x="{x:.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">{value}</text>')
    for _, colour, law in LAWS:
        for balls, dash in BALLS:
            rows = torque(law(MODEL).replace('ball_material = "steel"', f'ball_material = "{balls}"'),
                          axes)
            points = " ".join("{:.1f} {:.1f}".format(*place(r[key], r["friction_torque_Nmm"]))
                              for r in rows if r["friction_torque_Nmm"] is not None)
            out.append(f'<path fill="none" stroke="{colour}" stroke-width="2"{dash} d="M {points}"/>')
    return out


def main():
    right = LEFT + WIDTH + GAP
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {right + WIDTH + 30} '
             f'{TOP + HEIGHT + 70}" font-family="sans-serif" font-size="13">',
             f'<rect width="{right + WIDTH + 30}" height="{TOP + HEIGHT + 70}" fill="white"/>']
    lines += panel(LEFT, "friction torque [N mm] against speed [rpm], 300 N", "speed_rpm",
                   ["--speed", "0:12000:150", "--axial-load", "300"],
                   [0, 3000, 6000, 9000, 12000], 1400, 200)
    lines += panel(right, "friction torque [N mm] against axial load [N], 10000 rpm", "axial_load_N",
                   ["--speed", "10000", "--axial-load", "50:2000:50"],
                   [0, 500, 1000, 1500, 2000], 1400, 200)
    x, y = LEFT, TOP + HEIGHT + 48
    for name, colour, _ in LAWS:
        lines.append(f'<path stroke="{colour}" stroke-width="2" d="M {x} {y - 4} h 28"/>')
        lines.append(f'<text x="{x + 34}" y="{y}">{name}</text>')
        x += 70 + 7 * len(name)
    for name, dash in BALLS:
        lines.append(f'<path stroke="#222" stroke-width="2"{dash} d="M {x} {y - 4} h 28"/>')
        lines.append(f'<text x="{x + 34}" y="{y}">{name} balls</text>')
        x += 110 + 7 * len(name)
    print("\n".join(lines + ["</svg>"]))


main()

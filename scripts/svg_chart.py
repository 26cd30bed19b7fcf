"""Charts of the pages in docs: numbers of the program as lines in an SVG picture."""

WIDTH, HEIGHT, LEFT, TOP, GAP = 400, 300, 60, 50, 80


def panel(number, title, x_ticks, y_ticks, lines, x_text="{:g}", width=WIDTH):
    """One of several charts side by side; `lines`: (points, colour, dash), a y of None is left out."""
    left = LEFT + number * (width + GAP)
    low, high = y_ticks[0], y_ticks[-1]

    def place(x, y):
        return (left + width * (x - x_ticks[0]) / (x_ticks[-1] - x_ticks[0]), TOP + HEIGHT * (high - y) / (high - low))

    out = [f'<text x="{left}" y="{TOP - 16}">{title}</text>']
    for value in y_ticks:
        y = place(x_ticks[0], value)[1]
        out.append(f'<path stroke="#ddd" d="M {left} {y:.1f} h {width}"/>')
        out.append(f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
    for value in x_ticks:
        x = place(value, low)[0]
        out.append(f'<text x="{x:.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">' f"{x_text.format(value)}</text>")
    for points, colour, dash in lines:
        path = " ".join("{:.1f} {:.1f}".format(*place(x, y)) for x, y in points if y is not None)
        out.append(f'<path fill="none" stroke="{colour}" stroke-width="2"{dash} d="M {path}"/>')
    return out


def picture(panels, legend, width=WIDTH):
    """The whole picture; `legend`: (name, colour, dash)."""
    right, bottom = LEFT + len(panels) * (width + GAP) - GAP + 30, TOP + HEIGHT + 70
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {right} {bottom}" ' 'font-family="sans-serif" font-size="13">',
        f'<rect width="{right}" height="{bottom}" fill="white"/>',
    ]
    for one in panels:
        lines += one
    x, y = LEFT, TOP + HEIGHT + 48
    for name, colour, dash in legend:
        lines.append(f'<path stroke="{colour}" stroke-width="2"{dash} d="M {x} {y - 4} h 28"/>')
        lines.append(f'<text x="{x + 34}" y="{y}">{name}</text>')
        x += 62 + 7 * len(name)
    return "\n".join(lines + ["</svg>"])

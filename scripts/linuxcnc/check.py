#!/usr/bin/env python3
"""Judges what scripts/try-linuxcnc has recorded, in the folder of its run; draws it.

    check.py record SOURCE.csv FROM UNTIL > record.csv    a part of a record, each second
    check.py page|unmoved|day|again                       ends with 1 and a line where something is not as it should be
    check.py plot > PICTURE.svg
"""

import bisect
import csv
import json
import math
import os
import sys
import zlib

COUNT_UM, SLEW_UM_S = 0.1, 0.35  # of the model of scripts/try-linuxcnc
EXACT_UM = 0.01
MOVING, DISABLED, NOT_FOLLOWED, IMPLAUSIBLE, NO_VALUE = 8192, 16384, 1 << 20, 128, 2
SPLINE = 4  # servo periods in which a joint goes through a change of its axis
AFTER_LATE = 20  # periods in which it is there for sure after several counts at once


def demand(true, words):
    if not true:
        sys.exit("linuxcnc: " + words)


def record(source, start, end):
    """Straight between its rows, the run-up of the spindle too."""
    names = ["speed_rpm", "front_bearing_temperature_C", "ambient_temperature_C"]
    with open(source, encoding="utf-8") as lines:
        rows = [[float(row[name]) for name in ["time_s"] + names] for row in csv.DictReader(lines)]
    times = [row[0] for row in rows]
    print("time_s," + ",".join(names))
    for time in range(start, end + 1):
        k = bisect.bisect_right(times, time) - 1
        low, high = rows[k], rows[min(k + 1, len(rows) - 1)]
        share = (time - low[0]) / max(high[0] - low[0], 1.0)
        print(f"{time - start}," + ",".join(f"{a + share * (b - a):.5f}" for a, b in zip(low[1:], high[1:])))


class Samples:
    """One row per servo period, offsets in um."""

    def __init__(self, part):
        self.seen = json.load(open(part + ".json", encoding="utf-8"))
        demand(self.seen.get("done"), f"{part}: the operator did not come to the end")
        rows = []
        with open(part + ".samples", encoding="utf-8") as lines:
            for line in lines:
                demand("overrun" not in line, f"{part}: halsampler lost samples")
                cells = line.split()
                if len(cells) == 12:  # the last may be cut
                    rows.append([float(cell) for cell in cells])
        demand(len(rows) > 1000, f"{part}: {len(rows)} samples")
        (tags, self.counts, eoffset, request, joint, self.axis, self.time, self.displacement, self.wanted, late, status, on) = map(list, zip(*rows))
        demand(all(b == a + 1 for a, b in zip(tags, tags[1:])), f"{part}: samples are missing")
        self.eoffset, self.request = [1000.0 * x for x in eoffset], [1000.0 * x for x in request]
        # A count that came between motion and the sampler is of the next period, as the request says.
        came, asked = list(self.counts), request
        for i in range(1, len(came) - 1):
            if came[i] != came[i - 1] and asked[i] == asked[i - 1] and asked[i + 1] != asked[i]:
                self.counts[i] = came[i - 1]
        self.late_ms = max(late) * 1e-6
        self.status, self.on = [int(s) for s in status], [bool(o) for o in on]
        # Offset of the joint. Where the axis moves, its command goes to the joint by the same spline.
        p = self.axis
        self.followed, self.moves = [0.0] * len(p), [False] * len(p)
        still = 0
        for i in range(SPLINE, len(p)):
            still = still + 1 if p[i] == p[i - 1] else 0
            self.moves[i] = still < SPLINE
            at = (p[i - 3] + 4.0 * p[i - 2] + p[i - 1]) / 6.0 if self.moves[i] else p[i]
            self.followed[i] = 1000.0 * (joint[i] - at)
        # What was asked for since the machine was switched on, and for how many samples that is.
        self.asked, self.since_on = [0.0] * len(p), [0] * len(p)
        base = self.counts[0]
        for i in range(1, len(p)):
            if not self.on[i] or not self.on[i - 1]:
                base = self.counts[i]
            else:
                self.since_on[i] = self.since_on[i - 1] + 1
            self.asked[i] = (self.counts[i] - base) * COUNT_UM

    def ticks(self):
        """Samples in which counts have changed, and in how many counts: 1 where the component's pace has arrived, else what has
        come, or is still on its way, since the servo thread was late."""
        late = -AFTER_LATE
        for i in range(AFTER_LATE, len(self.counts) - 1):
            if self.counts[i] != self.counts[i - 1] and self.since_on[i] > 2 * SPLINE and self.on[i + 1]:
                steps = [abs(self.counts[k] - self.counts[k - 1]) for k in range(i - AFTER_LATE + 1, i + 2)]
                if sum(steps[-SPLINE - 1 :]) > 1:
                    late = i
                yield i, 1 if i - late >= AFTER_LATE else sum(steps)


def follows(s, part):
    """The joint goes with the counts: one servo period later by all but the last count, and to the end of the spline."""
    ticks, late, most, most_moving, most_late = 0, 0, 0.0, 0.0, 0.0
    after = [SPLINE] * len(s.counts)  # of a change: servo periods until it is judged to have come through
    for i, counts in s.ticks():
        apart = abs(s.followed[i + 1] - s.asked[i + 1])
        if counts > 1:
            # Not the component's pace, but a servo thread that came late; the bar is then each count of its own.
            late += 1
            after[i] = AFTER_LATE
            most_late = max(most_late, apart - counts * COUNT_UM)
            continue
        ticks += 1
        if s.moves[i + 1]:
            most_moving = max(most_moving, apart)
        else:
            most = max(most, apart)
    settled, rest, last = 0, 0.0, 0
    for i in range(1, len(s.counts)):
        if s.counts[i] != s.counts[i - 1]:
            last = i
        if s.since_on[i] > 2 * SPLINE and i >= last + after[last]:
            settled += 1
            rest = max(rest, abs(s.followed[i] - s.asked[i]))
    print(
        f"{part}: {ticks} counts; one servo period later the joint is {max(most, most_moving):.4f} um from them at most "
        f"(Z at rest {most:.4f}), {SPLINE} later {rest:.4f} um in {settled} samples; "
        f"{late} more counts while the servo thread was late (at most {s.late_ms:.1f} ms)"
    )
    demand(max(most, most_moving) <= EXACT_UM + COUNT_UM, f"{part}: one servo period after a count the joint is not there")
    demand(rest <= EXACT_UM, f"{part}: {SPLINE} servo periods after a count the joint is not there")
    demand(most_late <= EXACT_UM, f"{part}: the joint did not follow several counts")
    demand(late <= 0.2 * ticks or late < 20, f"{part}: this machine is too busy to judge: {late} of {late + ticks} counts were late")
    return ticks


def column(path, name):
    with open(path, encoding="utf-8") as lines:
        return [float(row[name]) for row in csv.DictReader(line for line in lines if not line.startswith("#"))]


def replays(s):
    """Calls of the component against `raceway correct` over their inputs, pins against calls."""
    said, corrected = column("calls.csv", "displacement_z_um"), column("corrected.csv", "predicted_um")
    demand(len(said) == len(corrected) > 1000, f"day: {len(said)} calls, {len(corrected)} corrected")
    apart = max(abs(a - b) for a, b in zip(said, corrected))
    pins = sorted(set(s.displacement))
    missed = 0  # calls that no sample shows, as the servo thread stood meanwhile
    for value in said:
        k = bisect.bisect_left(pins, value)
        missed += min(abs(pin - value) for pin in pins[max(k - 1, 0) : k + 1]) > 1e-5
    kept = 0.0
    for i in range(100, len(s.time)):
        if (
            not s.status[i]
            and min(s.since_on[i], i) > 100
            and 0 <= s.time[i] < 2090
            and s.displacement[i] == s.displacement[i - 5]
            and s.wanted[i] == s.wanted[i - 5]
        ):
            kept = max(kept, abs(s.wanted[i] + s.displacement[i]))
    behind, moved = 0.0, 0
    for i in range(40, len(s.time)):
        if s.status[i] & MOVING:
            moved = i
        if min(s.since_on[i], i - moved) > 2000 and 0 <= s.time[i] < 2400 and len(set(s.wanted[i - 40 : i + 1])) == 1:
            behind = max(behind, abs(s.asked[i] - s.wanted[i]))
    print(
        f"day: {len(said)} calls; displacement is within {apart:.1e} um of `raceway correct`, its pin shows all but {missed} of "
        f"them, the wanted offset within {kept:.4f} um (half a count is {COUNT_UM / 2:g}), counts where they are wanted"
    )
    demand(apart <= 0.02 and missed <= 0.1 * len(said), "day: the displacement is not that of `raceway correct`")
    demand(kept <= COUNT_UM / 2 + 1e-5, "day: the offset is not that of the displacement")
    demand(behind <= 1e-3, f"day: counts stay {behind:.3f} um from what is wanted")


def page():
    """The model of docs/control.md at 3000 rpm: its kinematic law alone, in counts."""
    with open("page.json", encoding="utf-8") as source:
        seen = json.load(source)
    demand(seen.get("done"), "page: the operator did not come to the end")
    law = 1.28e-3 * 3000.0 ** (1.0 - 0.697 * math.exp(-5.3e-4 * 3000.0))
    demand(
        abs(seen["joint_um"] + law) <= COUNT_UM / 2 + EXACT_UM and not seen["alarm"],
        f"page: the joint is {seen['joint_um']:.3f} um away, should be {-law:.3f} um",
    )
    print(
        f"page: the five commands of docs/control.md end in a joint that M3 S3000 moves by {seen['joint_um']:.2f} um; the law " f"says {law:.2f} um"
    )


def day():
    s = Samples("day")
    demand(follows(s, "day") > 500, "day: too few counts")
    replays(s)
    demand(s.seen["broken"] & NO_VALUE and s.seen["far"] & IMPLAUSIBLE, f"day: sensors at fault: {s.seen}")
    demand(kept_state("thermal.state")["datum"][0] > 1.0, "day: the touch-off was missed")
    largest = max(map(abs, s.eoffset))
    demand(largest > 5.0, f"day: the largest offset is {largest:.2f} um")
    # What [HAL]SHUTDOWN has to do: the last offset goes to 0 while motion goes on.
    last = max(i for i in range(len(s.time)) if s.since_on[i] and abs(s.followed[i]) > COUNT_UM)
    before = max(range(last - 5000, last), key=lambda i: (abs(s.eoffset[i]), i))
    end = last + 2 * SPLINE
    demand(
        end < len(s.on) and s.on[end] and abs(s.eoffset[end]) < EXACT_UM and abs(s.followed[end]) < EXACT_UM,
        "day: the offset was not back at 0 when motion ended",
    )
    print(
        f"day: {largest:.1f} um at most; at the end back from {abs(s.eoffset[before]):.1f} um to 0 in "
        f"{(last - before) * 0.001:.2f} s, {(len(s.on) - end) * 0.001:.2f} s before motion ended"
    )
    print("day: halcmd show pin thermal")
    print(s.seen["pins"].rstrip())


def unmoved():
    s = Samples("unmoved")
    with open("unmoved.log", encoding="utf-8") as log:
        text = log.read()
    demand(s.seen["status"] & NOT_FOLLOWED, f"unmoved: status {s.seen['status']}")
    demand("OFFSET_AV_RATIO is missing" in text and "check OFFSET_AV_RATIO" in text, "unmoved: stderr does not say what is missing")
    demand(max(map(abs, s.request)) > COUNT_UM, "unmoved: nothing was asked for")
    demand(max(map(abs, s.eoffset)) == 0.0 and max(map(abs, s.followed)) < 1e-3, "unmoved: the joint moved")
    print(f"unmoved: without OFFSET_AV_RATIO alarm after {s.seen['alarm_s']:.1f} s, the joint stands, stderr says why")


def kept_state(path):
    with open(path, encoding="utf-8") as lines:
        check, _, text = lines.read().partition(" ")
    demand(int(check, 16) == zlib.crc32(text.rstrip("\n").encode()) & 0xFFFFFFFF, f"{path} is damaged")
    return json.loads(text)


def again():
    killed = Samples("killed")
    follows(killed, "killed")
    demand(killed.seen["stands"], "killed: the offset did not stand")
    state = kept_state("killed.state")
    s = Samples("again")
    follows(s, "again")
    kept = s.seen["displacement"] - state["absolute"][0]
    demand(
        abs(state["absolute"][0]) > 1.0 and abs(kept) < 0.2,
        f"again: the state was {state['absolute'][0]:.3f} um, it began with {s.seen['displacement']:.3f} um",
    )
    demand(s.seen["at_first"] == 0.0 and s.seen["off_and_on"] == 0.0, "again: an offset before there was a count")
    demand(not s.seen["status"] & NOT_FOLLOWED, "again: alarm after off and on between two calls")
    jump = max(abs(b - a) for a, b, n in zip(s.followed, s.followed[1:], s.since_on[1:]) if n > 2 * SPLINE)
    end = max(i for i, offset in enumerate(s.asked) if abs(offset) > 1.0)  # from there SHUTDOWN brings it back, faster
    # Calls are 1 s apart: one and a part of the next.
    slew = max(abs(s.asked[i] - s.asked[i - 1000]) for i in range(1000, end) if s.since_on[i] > 1000)
    demand(jump <= 2 * COUNT_UM, f"again: the joint jumped by {jump:.3f} um")
    demand(slew <= SLEW_UM_S * (1.0 + 1.0) + COUNT_UM, f"again: {slew:.2f} um in 1 s")
    print(
        f"again: killed at {abs(state['absolute'][0]):.2f} um; its state is loaded by a new LinuxCNC ({kept:+.3f} um from it), "
        f"the offset begins at 0 and goes by {slew:.2f} um in 1 s at most, {jump:.3f} um in a servo period; "
        "the same after off and on again between two calls"
    )


def plot():
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    from figures import BLUE, ORANGE, draw, line

    s = Samples("day")
    late = {k for i, counts in s.ticks() if counts > 1 for k in range(i, i + AFTER_LATE)}
    rows = [i for i in range(len(s.time)) if s.time[i] >= 0.0 and s.since_on[i] > 2 * SPLINE and i not in late]
    chunk = max(1, len(rows) // 800)
    asked, followed, apart = [], [], []
    for k in range(0, len(rows), chunk):
        part = rows[k : k + chunk]
        minutes = s.time[part[0]] / 60.0
        asked.append((minutes, s.asked[part[0]]))
        followed.append((minutes, s.followed[part[0]]))
        differences = [s.followed[i] - s.asked[i] for i in part]
        apart += [(minutes, min(differences)), (minutes, max(differences))]
    draw(
        sys.stdout,
        [
            (
                "offset of Z [um] over time of the record [min]",
                [line(asked, BLUE, "asked for by the component"), line(followed, ORANGE, "command of the joint less that of its axis", "--")],
            ),
            ("joint less what was asked for [um]", [line(apart, BLUE)]),
        ],
    )
    left_out = sum(counts > 1 for _, counts in s.ticks())
    print(f"plot: {left_out} counts while the servo thread was late are not in the picture", file=sys.stderr)


if __name__ == "__main__":
    if sys.argv[1] == "record":
        record(sys.argv[2], int(sys.argv[3]), int(sys.argv[4]))
    else:
        {"page": page, "day": day, "unmoved": unmoved, "again": again, "plot": plot}[sys.argv[1]]()

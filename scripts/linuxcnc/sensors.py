#!/usr/bin/env python3
"""Sensors of a machine, as a component of LinuxCNC's HAL: a record is played from its time FROM on.

    sensors.py RECORD FROM FASTER     from HAL, by loadusr

Its first row stands until the pin `go`; `time` [s] is that of the record since FROM, -1 before. While `broken`, the front
bearing has no number, while `far` one that cannot be.
"""

import bisect
import csv
import sys
import time

import hal

PAUSE = 0.002  # [s]


def main():
    record, start, faster = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
    with open(record, encoding="utf-8") as source:
        rows = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(source)]
    times = [row["time_s"] for row in rows]
    columns = [name for name in rows[0] if name != "time_s"]
    component = hal.component("sensors")
    for name in columns + ["time"]:
        component.newpin(name, hal.HAL_FLOAT, hal.HAL_OUT)
    for name in ("go", "broken", "far"):
        component.newpin(name, hal.HAL_BIT, hal.HAL_IN)

    def put(at):
        k = min(max(bisect.bisect_right(times, at), 1), len(rows) - 1)
        low, high = rows[k - 1], rows[k]
        share = min(max((at - times[k - 1]) / (times[k] - times[k - 1]), 0.0), 1.0)
        for name in columns:
            # A speed is what it is until the next row, a temperature goes straight.
            value = low[name] if name == "speed_rpm" and share < 1.0 else low[name] + share * (high[name] - low[name])
            if name == "front_bearing_temperature_C":
                value = float("nan") if component["broken"] else 200.0 if component["far"] else value
            component[name] = value

    put(start)
    component["time"] = -1.0
    component.ready()
    begun = None
    try:
        while True:
            if begun is None and component["go"]:
                begun = time.monotonic()
            passed = 0.0 if begun is None else faster * (time.monotonic() - begun)
            put(start + passed)
            if begun is not None:
                component["time"] = passed
            time.sleep(PAUSE)
    except KeyboardInterrupt:
        pass


main()

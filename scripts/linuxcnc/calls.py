#!/usr/bin/env python3
"""Writes each call of the correction to a CSV, as the state says it that is kept at every one, until it is terminated.

    calls.py STATE CALLS.csv     in the folder of thermal.py
"""

import json
import os
import sys
import time

import thermal


def main():
    before, start = 0, None
    columns = ["time_s"] + [i[0] for i in thermal.INPUTS] + [a["displacement"] for a in thermal.AXES]
    with open(sys.argv[2], "w", encoding="utf-8", buffering=1) as out:
        out.write(",".join(columns) + "\n")
        while True:
            time.sleep(0.002)
            try:
                with open(sys.argv[1], encoding="utf-8") as source:
                    written = os.fstat(source.fileno())
                    if (written.st_ino, written.st_mtime_ns) == before:
                        continue
                    before = written.st_ino, written.st_mtime_ns
                    state = json.loads(source.read().partition(" ")[2])
            except FileNotFoundError:
                continue
            start = state["time"] if start is None else start
            cells = [state["time"] - start] + state["last"] + state["absolute"]
            out.write(",".join(f"{cell:.12g}" for cell in cells) + "\n")


main()

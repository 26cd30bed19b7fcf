"""An exported correction among faults, judged from outside: what a control may rely on, whatever it is given.

    faults.py PROGRAM.py TICKS SEED           random faults; the first broken promise ends it
        --script FILE                         writes the calls and their answers for faults.c (- is stdout)
    faults.py PROGRAM.py --steps              save() is killed at each of its steps, in pieces of bytes
    faults.py PROGRAM.py --kill TIMES SEED    a machine that ticks and saves is killed at any moment
    faults.py PROGRAM.py --odd                one odd value after the other, and what it leaves behind
    faults.py PROGRAM.py --speed              time of a call
    faults.py --models FOLDER                 writes model files that have all that an export may have

Status 1 and one line at the first promise that is broken. Standard library alone.
"""

import argparse
import importlib.util
import os
import random
import sys
import tempfile
import time

from models import write_models
from odd_values import odd_values
from random_calls import random_run
from sensor import Sensor, some_inputs
from stops import kill_runs, save_steps
from values import INF


def imported(path):
    spec = importlib.util.spec_from_file_location("exported", path)
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module


def speed(m):
    rng = random.Random(3)
    sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
    rows = [some_inputs(m, rng, sensors) for _ in range(2000)]
    c = m.Correction()
    best = INF
    t = 0.0
    for _ in range(7):
        began = time.perf_counter()
        for row in rows:
            t += 1.0
            c.update(t, row)
        best = min(best, (time.perf_counter() - began) / len(rows))
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")
    began = time.perf_counter()
    for _ in range(200):
        c.save(state)
    saving = (time.perf_counter() - began) / 200
    os.remove(state)
    os.rmdir(folder)
    print(
        "faults: %s: %.1f us a call, %.0f us a save(); %d inputs, %d axes, %d sections"
        % (os.path.basename(m.__file__), best * 1e6, saving * 1e6, len(m.INPUTS), len(m.AXES), sum(len(a["sections"]) for a in m.AXES))
    )
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?")
    parser.add_argument("ticks", nargs="?", type=int)
    parser.add_argument("seed", nargs="?", type=int)
    parser.add_argument("--script")
    parser.add_argument("--kill", nargs=2, type=int)
    parser.add_argument("--models")
    for alone in ("--steps", "--odd", "--speed"):
        parser.add_argument(alone, action="store_true")
    given = parser.parse_args()
    if given.models:
        return write_models(given.models)
    if not given.program:
        parser.error("a program")
    m = imported(given.program)
    if given.kill:
        return kill_runs(m, *given.kill)
    for asked, work in ((given.steps, save_steps), (given.odd, odd_values), (given.speed, speed)):
        if asked:
            return work(m)
    if given.seed is None:
        parser.error("ticks and a seed")
    return random_run(m, given.ticks, given.seed, given.script)


if __name__ == "__main__":
    sys.exit(main())

"""What items of a sweep cost, and what spreading them over two workers adds; called by scripts/scale."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import sys
import time
from collections.abc import Callable
from typing import Any

import distributed
import fleet
import numpy

import raceway
from raceway import _engine, sweep

TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")
MACHINES = 1000


def processor_time_s(pids: list[int]) -> float:
    """Of these processes so far, in and for them."""
    total = 0
    for pid in pids:
        with open(f"/proc/{pid}/stat") as stat:
            total += sum(int(ticks) for ticks in stat.read().rpartition(")")[2].split()[11:13])
    return total * TICK_S


def timed(work: Callable[[], Any], pids: list[int]) -> tuple[float, float, Any]:
    """Wall clock, processor time of these processes, result."""
    wall, busy = time.perf_counter(), processor_time_s(pids)
    found = work()
    return time.perf_counter() - wall, processor_time_s(pids) - busy, found


def half(which: int) -> float:
    """Processor time of every second machine in a plain process [s]."""
    _engine.limit_threads(1)
    machines = [fleet.machine(k) for k in range(which, MACHINES, 2)]
    fleet.identify(machines[0])
    before = time.process_time()
    for made in machines:
        fleet.identify(made)
    return time.process_time() - before


def two_workers() -> None:
    machines = {made.record.name: made for made in map(fleet.machine, range(MACHINES))}
    here = [os.getpid()]
    plain = multiprocessing.get_context("spawn").Pool(2)
    with plain, sweep.workers(2) as client:
        pids = list(client.run(os.getpid).values())
        sweep.run(fleet.identify, dict(list(machines.items())[:20]), client=client)  # imports are not counted
        print(f"{MACHINES} machines, {len(os.sched_getaffinity(0))} cores, Dask {distributed.__version__}; by turns, s:")
        print("one process        two workers of Dask                 two plain processes")
        print("  wall  processor    wall  processor  client + scheduler         processor")
        rows = []
        for _ in range(4):
            wall, busy, serial = timed(lambda: sweep.run(fleet.identify, machines, threads=1), here)
            both = sum(plain.map(half, range(2), chunksize=1))
            client_before = processor_time_s(here)
            wall2, workers, parted = timed(lambda: sweep.run(fleet.identify, machines, client=client), pids)
            own = processor_time_s(here) - client_before
            assert [pickle.dumps(v) for v in parted.values()] == [pickle.dumps(v) for v in serial.values()]
            print(f"{wall:6.2f}  {busy:9.2f}  {wall2:6.2f}  {workers:9.2f}  {own:18.2f}  {both:16.2f}", flush=True)
            rows.append((wall, busy, wall2, workers + own, both))
        # What others do on the machine only adds.
        wall, busy, wall2, all_of_it, both = map(min, zip(*rows))
        print(f"over the serial sum: wall clock of both {2.0 * wall2 / wall - 1.0:+.1%}, processor {all_of_it / busy - 1.0:+.1%}")
        print(f"processor over two plain processes side by side: {all_of_it / both - 1.0:+.1%}")


def cost(what: str, items: int, work: Callable[[], Any]) -> None:
    """Processor time of an item, the least of five."""
    work()
    least = min(timed(work, [os.getpid()])[1] for _ in range(5)) / items
    words = f"{least * 1e6:8.2f} us" if least < 1e-3 else f"{least * 1e3:8.2f} ms"
    print(f"{what:72s} {words}  1e4: {least * 1e4 / 3600:9.2g} h  1e9: {least * 1e9 / 3600:9.2g} h")


def single_items() -> None:
    _engine.limit_threads(1)
    draw = numpy.random.default_rng(3)
    count = 100_000
    speeds, loads, radial = (draw.uniform(*ends, count) for ends in ((100, 12000), (100, 900), (0, 300)))
    print(f"one core ({_engine.instruction_set()}), processor time of one item, and core hours of many")
    contact = raceway.Model.new("S 6014 C")
    palmgren = raceway.Model.new("S 6014 C", law="palmgren")
    for model, law in ((palmgren, "palmgren"), (contact, "contact")):
        cost(f"state of a bearing, thrust, {law}", count, lambda: model.solve(speeds, loads))
        cost(f"state of a bearing, thrust and radial load, {law}", count, lambda: model.solve(speeds, loads, radial))
    axes = (numpy.linspace(100, 12000, 100), numpy.linspace(100, 900, 50), numpy.linspace(0, 300, 20))
    cost("row of a Stribeck table, contact", 100_000, lambda: contact.table(*axes))
    factors = draw.uniform(0.8, 1.2, 200)

    def samples() -> None:
        for factor in factors:
            contact.with_values({"rolling_factor": factor}).solve(6000.0, 300.0, columns=["friction_torque_Nmm"])

    cost("sample of a model: other numbers, one state", len(factors), samples)
    machines = [fleet.machine(k) for k in range(100)]
    cost("machine re-identified: two lags, 600 rows of a night", len(machines), lambda: [fleet.identify(made) for made in machines])
    cost("the same with the number of lags sought, one to three each", 10, lambda: [fleet.START.identify(made.record) for made in machines[:10]])
    correction = raceway.Correction.read("data/corrections/ambient/correction.toml")
    record = raceway.Record.read("data/corrections/ambient/train.csv")
    cost("diagnosis of a machine, 3360 rows, single effects", 1, lambda: correction.diagnose(record, pairs=False))
    rig = raceway.Model.read("tests/hidden_effect/rigs/dev-03/model.toml")
    train = raceway.Record.read("tests/hidden_effect/rigs/dev-03/train.csv")
    cost("diagnosis of a rig, 120 rows", 10, lambda: [rig.diagnose(train) for _ in range(10)])
    spindle = raceway.Model.read("data/spindles/externally_driven.toml")
    day = raceway.Record.read("data/spindles/day.csv")
    cost("spindle through a day of 8 h", 1, lambda: spindle.simulate(day))
    cost("spindle at rest of its temperatures", 10, lambda: [spindle.steady(6000.0) for _ in range(10)])


if __name__ == "__main__":
    if sys.argv[1:] in ([], ["fleet"]):
        two_workers()
    if sys.argv[1:] in ([], ["items"]):
        single_items()
    if sys.argv[1:] not in ([], ["fleet"], ["items"]):
        sys.exit("scripts/scale: takes fleet, items or nothing")

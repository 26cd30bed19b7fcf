"""Stops of the power, or of the process, while a state is written."""
import json
import os
import random
import signal
import sys
import tempfile
import time

from sensor import Sensor, some_inputs


class Steps(object):
    """Kills this process at its n-th step, or writes down which steps there are."""

    def __init__(self, last, trace):
        self.count, self.last, self.trace = 0, last, trace

    def step(self, name):
        self.count += 1
        if self.trace is not None:
            self.trace.append(name)
        if self.count == self.last:
            os.kill(os.getpid(), signal.SIGKILL)


class SteppedFile(object):
    def __init__(self, steps, source, piece):
        self.steps, self.source, self.piece = steps, source, piece

    def __enter__(self):
        return self

    def __exit__(self, *why):
        self.steps.step("before close")
        self.source.close()
        self.steps.step("close")

    def write(self, text):
        for at in range(0, len(text), self.piece):
            self.source.write(text[at : at + self.piece])
            self.source.flush()
            self.steps.step("write")

    def flush(self):
        self.source.flush()
        self.steps.step("flush")

    def close(self):
        self.source.close()
        self.steps.step("close")

    def fileno(self):
        return self.source.fileno()


class SteppedOs(object):
    """The module os, each call of which is a step, before and after it."""

    def __init__(self, steps):
        self.steps = steps
        self.path = os.path

    def __getattr__(self, name):
        thing = getattr(os, name)
        if not callable(thing):
            return thing

        def stepped(*arguments, **named):
            self.steps.step("before " + name)
            result = thing(*arguments, **named)
            self.steps.step(name)
            return result

        return stepped


def in_child(work):
    """Runs it in a process of its own: its status as of os.waitpid."""
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        try:
            work()
        finally:
            os._exit(0)
    return os.waitpid(child, 0)[1]


def save_steps(m):
    rng = random.Random(1)
    sensors = [Sensor(rng, m, k) for k in range(len(m.INPUTS))]
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")

    def exported_open(steps, piece):
        def stepped(name, mode="r", *more):
            steps.step("before open")
            source = open(name, mode, *more)
            steps.step("open")
            return SteppedFile(steps, source, piece)

        return stepped

    c = m.Correction()
    for k in range(5):
        c.update(float(k), some_inputs(m, rng, sensors))
    c.save(state)
    with open(state) as source:
        old_text = source.read()
    old = json.dumps(c.state(), sort_keys=True)
    for k in range(5, 9):
        c.update(float(k), some_inputs(m, rng, sensors))
    new = json.dumps(c.state(), sort_keys=True)

    def save_with(steps, piece):
        m.os = SteppedOs(steps)
        m.open = exported_open(steps, piece)
        try:
            c.save(state)
        finally:
            m.os = os
            del m.open

    trace = []
    save_with(Steps(0, trace), 10**9)
    steps = [s for s in trace if not s.startswith("before")]
    # What must be on the disk before the new name is: power may fail after any step.
    move = [k for k, s in enumerate(steps) if s in ("replace", "rename")]
    synced = [k for k, s in enumerate(steps) if s == "fsync"]
    written = [k for k, s in enumerate(steps) if s in ("write", "flush")]
    if not move or not synced or not max(written) < synced[0] < move[0]:
        print("faults: save() has the steps %s: the file is not on the disk before its name" % ", ".join(steps))
        return 1
    if not synced[-1] > move[0]:
        print("faults: save() has the steps %s: the folder is not synced" % ", ".join(steps))
        return 1
    done = was_old = was_new = 0
    for stale in (False, True):
        for first in (False, True):  # no state yet, an old one
            for piece in (7, 64, 10**9):
                n = 0
                while True:
                    n += 1
                    for name in os.listdir(folder):
                        os.remove(os.path.join(folder, name))
                    if not first:
                        with open(state, "w") as target:
                            target.write(old_text)
                    if stale:
                        with open(state + ".new", "w") as target:
                            target.write("left behind" * 1000)
                    status = in_child(lambda: save_with(Steps(n, None), piece))
                    loaded = m.Correction()
                    try:
                        loaded.load(state)
                        got = json.dumps(loaded.state(), sort_keys=True)
                    except (IOError, OSError) as error:
                        if not first or os.path.exists(state):
                            print("faults: killed at step %d: load() raises %s" % (n, error))
                            return 1
                        got = old
                    except Exception as error:
                        print("faults: killed at step %d: load() raises %s" % (n, error))
                        return 1
                    if got not in (old, new):
                        print("faults: killed at step %d: neither the old state nor the new one" % n)
                        return 1
                    was_old, was_new, done = was_old + (got == old), was_new + (got == new), done + 1
                    after = m.Correction()  # the next save is not hindered by what was left
                    after.restore(json.loads(new))
                    after.save(state)
                    again = m.Correction()
                    again.load(state)
                    if json.dumps(again.state(), sort_keys=True) != new:
                        print("faults: after a stop at step %d save() and load() do not agree" % n)
                        return 1
                    if not os.WIFSIGNALED(status):
                        if got != new:
                            print("faults: save() returned and the old state is there")
                            return 1
                        break
    # A file that is damaged, byte by byte: refused, and nothing changes.
    with open(state, "rb") as source:
        whole = source.read()
    flips = 0
    for k in range(0, len(whole)):
        for damaged in (whole[:k], whole[:k] + bytes(bytearray([whole[k] ^ 1 << k % 8])) + whole[k + 1 :]):
            with open(state, "wb") as target:
                target.write(damaged)
            loaded = m.Correction()
            before = json.dumps(loaded.state(), sort_keys=True)
            try:
                loaded.load(state)
                if json.dumps(loaded.state(), sort_keys=True) != new:
                    print("faults: byte %d damaged: another state is taken" % k)
                    return 1
            except ValueError:
                if json.dumps(loaded.state(), sort_keys=True) != before:
                    print("faults: byte %d damaged: load() raises and has changed something" % k)
                    return 1
            except Exception as error:
                print("faults: byte %d damaged: load() raises %s: %s" % (k, type(error).__name__, error))
                return 1
            flips += 1
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    os.rmdir(folder)
    print(
        "faults: save() has the steps %s; %d stops: old state %d, new one %d; %d damaged files refused"
        % (", ".join(steps), done, was_old, was_new, flips)
    )
    return 0


def kill_runs(m, times, seed):
    """Machines that tick, save, and tell; killed at any moment."""
    rng = random.Random(seed)
    folder = tempfile.mkdtemp()
    state = os.path.join(folder, "state")
    ticks = lost = first_steps = 0
    told = None  # time, offsets of the last call that was sent
    mid = 0
    for run in range(times):
        reading, writing = os.pipe()
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            try:
                os.close(reading)
                mine = random.Random(seed * 1000003 + run)
                sensors = [Sensor(mine, m, k) for k in range(len(m.INPUTS))]
                c = m.Correction()
                t = 0.0
                if run:
                    c.load(state)
                    t = c.time + mine.choice([0.5, 5.0, 60.0])
                while True:
                    offsets = c.update(t, some_inputs(m, mine, sensors))
                    c.save(state)  # before it is sent
                    os.write(writing, (json.dumps([t, [offsets[a["displacement"]] for a in m.AXES]]) + "\n").encode())
                    t += mine.uniform(0.1, 2.0)
            except BaseException as error:
                os.write(writing, ("error %s\n" % error).encode())
            finally:
                os._exit(3)
        os.close(writing)
        text = b""
        while b"\n" not in text:
            piece = os.read(reading, 65536)
            if not piece:
                break
            text += piece
        time.sleep(rng.uniform(0, 0.012))
        os.kill(child, signal.SIGKILL)
        while True:
            piece = os.read(reading, 65536)
            if not piece:
                break
            text += piece
        os.close(reading)
        os.waitpid(child, 0)
        if b"error" in text:
            print("faults: run %d, seed %d: %s" % (run, seed, text.decode().splitlines()[-1]))
            return 1
        lines = [json.loads(line) for line in text.decode().split("\n")[:-1] if line.endswith("]")]
        for t, offsets in lines:
            if told is not None:
                gap = min(t - told[0], m.LONGEST_GAP)
                for a, now, was in zip(m.AXES, offsets, told[1]):
                    apart = abs(now - was) * a["unit_um"]
                    if apart > a["slew"] * gap + (a["unit_um"] if a["counts"] else 0.0) + 1e-9:
                        print(
                            "faults: run %d, seed %d: offset of %s goes from %g to %g in %g s" % (run, seed, a["displacement"], was, now, t - told[0])
                        )
                        return 1
            told = (t, offsets)
        ticks += len(lines)
        c = m.Correction()
        try:
            c.load(state)
        except Exception as error:
            print("faults: run %d, seed %d: load() raises %s: %s" % (run, seed, type(error).__name__, error))
            return 1
        if c.time < told[0]:
            print("faults: run %d, seed %d: the state is of %r, sent was %r" % (run, seed, c.time, told[0]))
            return 1
        mid += c.time > told[0]
        if c.time == told[0]:
            offsets = c._offsets()
            for a, was in zip(m.AXES, told[1]):
                if offsets[a["displacement"]] != was:
                    print("faults: run %d, seed %d: the state has another offset than was sent" % (run, seed))
                    return 1
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    os.rmdir(folder)
    print("faults: %d kills in %d calls; %d between save() and sending; nothing lost, offsets within their slew" % (times, ticks, mid))
    return 0

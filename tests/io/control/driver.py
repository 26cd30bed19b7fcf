"""Runs an exported correction by a script: python3 driver.py FILE.py < script. Lines: see control_test.cpp."""
import importlib.util
import os
import sys

spec = importlib.util.spec_from_file_location("correction", sys.argv[1])
correction = importlib.util.module_from_spec(spec)
spec.loader.exec_module(correction)

machine = correction.Correction()
columns = [entry[0] for entry in correction.INPUTS]
for line in sys.stdin:
    words = line.split()
    if words[0] == "restart":
        state = sys.argv[1] + ".state"
        machine.save(state)
        machine = correction.Correction()
        machine.load(state)
        os.remove(state)
    elif words[0] == "reset":
        machine.reset()
    elif words[0] == "zero":
        machine.set_zero()
    else:
        inputs = dict(zip(columns, map(float, words[2:])))
        y = machine.update(float(words[1]), inputs)
        print(" ".join("%.17g" % y[a["displacement"]] for a in correction.AXES), machine.status)

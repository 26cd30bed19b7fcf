"""Runs an exported correction by a script: python3 driver.py FILE.py < script. Lines: see control_test.cpp."""
import importlib.util
import os
import sys

spec = importlib.util.spec_from_file_location("correction", sys.argv[1])
correction = importlib.util.module_from_spec(spec)
spec.loader.exec_module(correction)

machine = correction.Correction()
columns = [entry[0] for entry in correction.INPUTS]
outputs = [axis["displacement"] for axis in correction.AXES]
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
    elif words[0] == "touch-off":
        machine.touch_off()
    elif words[0] == "applied":
        machine.applied(dict(zip(outputs, map(float, words[1:]))))
    else:
        time, given = float(words[1]), words[2:]
        if words[0] == "u":
            y = machine.predict(time, dict(zip(columns, map(float, given))))
        else:
            y = machine.update(time, dict(zip(columns, map(float, given[1:]))), given[0] == "1")
        print(" ".join("%.17g" % y[column] for column in outputs), machine.status)

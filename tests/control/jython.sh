#!/bin/sh
# An exported correction under Python 2.7 (Jython): digit for digit what python3 gives, its state too.
#
#   jython.sh PROGRAM.py RECORD.csv
#
# apt-get install -y --no-install-recommends jython default-jre-headless
set -eu
command -v jython > /dev/null || { echo "jython.sh: no jython here"; exit 77; }
program=$(realpath "$1")
record=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cp "$program" exported.py
for python in python3 jython; do
  $python exported.py --check > "check.$python"
  $python exported.py "$record" > "out.$python"
done
cmp check.python3 check.jython
cmp out.python3 out.jython
cat > state.py << 'END'
from __future__ import print_function
import json, os, sys
import exported
record = exported.Correction()
for k in range(200):
    record.update(10.0 * k, dict((i[0], 20.0 + 0.01 * k + 0.1 * n) for n, i in enumerate(exported.INPUTS)))
if os.path.exists("state"):
    other = exported.Correction()
    other.load("state")  # of the other Python
    assert json.dumps(other.state(), sort_keys=True) == json.dumps(record.state(), sort_keys=True), "another state"
record.save("state")
record.save("state")  # in place of the old one
again = exported.Correction()
again.load("state")
assert again.state() == record.state()
with open("state") as source:
    text = source.read()
with open("damaged", "w") as out:
    out.write(text.replace("1", "2", 1))
try:
    again.load("damaged")
    raise AssertionError("a damaged state is taken")
except ValueError:
    pass
END
python3 state.py
cp state state.python3
jython state.py
cmp state.python3 state
python3 state.py
echo "jython.sh: $(basename "$program"): $(wc -l < out.jython) lines the same, state too"

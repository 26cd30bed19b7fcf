#!/usr/bin/python3
"""What an operator does, in place of LinuxCNC's display: started by it with -ini FILE PART, and when this ends, so does it.

Each part of the trial is a function; what it saw is written to PART.json for check.py.
"""

import json
import os
import signal
import subprocess
import sys
import time

import hal
import linuxcnc

seen = {}


def get(pin):
    return hal.get_value(pin)


def put(pin, value):
    hal.set_p(pin, str(value))


def wait(what, true, limit=20.0):
    """Until it is true; how long that took [s]."""
    start = time.monotonic()
    while not true():
        if time.monotonic() - start > limit:
            raise SystemExit(f"waited {limit:g} s for {what}")
        time.sleep(0.002)
    return time.monotonic() - start


class Machine:
    def __init__(self):
        self.command, self.stat = linuxcnc.command(), linuxcnc.stat()

    def is_so(self, what, true):
        def polled():
            self.stat.poll()
            return true(self.stat)

        wait(what, polled)

    def on(self):
        self.command.state(linuxcnc.STATE_ESTOP_RESET)
        self.is_so("estop to be reset", lambda s: s.task_state != linuxcnc.STATE_ESTOP)
        self.command.state(linuxcnc.STATE_ON)
        self.is_so("the machine to be on", lambda s: s.task_state == linuxcnc.STATE_ON)
        wait("motion", lambda: get("motion.motion-enabled"))

    def off(self):
        self.command.state(linuxcnc.STATE_OFF)
        wait("motion to be off", lambda: not get("motion.motion-enabled"))

    def home(self):
        self.command.mode(linuxcnc.MODE_MANUAL)
        self.command.wait_complete()
        self.command.home(-1)
        self.is_so("homing", lambda s: all(s.homed[:3]))
        self.command.teleop_enable(1)
        self.is_so("teleop", lambda s: s.motion_mode == linuxcnc.TRAJ_MODE_TELEOP)

    def go(self, *lines):
        self.command.mode(linuxcnc.MODE_MDI)
        self.command.wait_complete()
        for line in lines:
            self.command.mdi(line)
            if self.command.wait_complete(20) != linuxcnc.RCS_DONE:
                raise SystemExit(f"{line} did not end well: {linuxcnc.error_channel().poll()}")


def offset_um():
    return get("axis.z.eoffset") * 1000.0


def begin():
    """On, homed, thermal.enable, and then the record."""
    machine = Machine()
    machine.on()
    machine.home()
    put("thermal.enable", 1)
    wait("the first call of the correction", lambda: not get("thermal.status") & (32 | 16384))
    return machine


def until(record_time):
    wait(f"{record_time} s of the record", lambda: get("sensors.time") >= record_time, 120.0)


def page():
    """Those of docs/control.md are in another terminal."""
    machine = Machine()
    machine.on()
    machine.home()
    before = get("joint.2.pos-cmd")
    open("homed", "w", encoding="utf-8").close()
    wait("thermal.enable", lambda: get("thermal.enable"), 30.0)
    wait("the first call of the correction", lambda: not get("thermal.status") & (32 | 16384))
    machine.go("M3 S3000")
    wait("the speed", lambda: get("thermal.speed_rpm") == 3000)
    wait("a call with it", lambda: get("thermal.z-displacement") > 0)
    wait("the joint to be there", lambda: not get("thermal.status") & 8192)
    time.sleep(0.5)
    seen["joint_um"] = 1000.0 * (get("joint.2.pos-cmd") - before)
    seen["alarm"] = get("thermal.alarm")


def day():
    """The whole record, with what happens on a machine meanwhile. Times are those of the record [s]."""
    calls = subprocess.Popen([sys.executable, "calls.py", "thermal.state", "calls.csv"])
    machine = begin()
    put("sensors.go", 1)
    until(60)
    machine.go("G21 G90 G1 X20 Y10 F2400", "G1 Z-8", "G1 X0 Y5 Z-3", "G0 Z0")
    until(420)
    for k in range(8):
        machine.go(f"G1 X{k} Y{-k} Z{-1 - k % 3} F{600 + 600 * k}")
    until(820)
    put("thermal.touch-off", 1)  # for less than from one call to the next
    time.sleep(0.012)
    put("thermal.touch-off", 0)
    until(950)
    machine.off()
    until(970)
    machine.on()
    wait("the offset after off and on", lambda: not get("thermal.status") & 8192)
    until(1250)
    put("thermal.enable", 0)
    seen["disabled_s"] = wait("the offset to go to 0", lambda: abs(offset_um()) < 0.01)
    until(1400)
    put("thermal.enable", 1)
    until(1650)
    machine.go("G1 Z-20 F1200", "G1 Z-2 F3000")
    until(2090)
    calls.terminate()
    calls.wait()
    for name, bit, time_s in ("broken", 2, 2100), ("far", 128, 2200):
        until(time_s)
        wait("no alarm", lambda: not get("thermal.alarm"))
        put("sensors." + name, 1)
        wait(f"an alarm of bit {bit}", lambda: get("thermal.alarm") and get("thermal.status") & bit)
        seen[name] = get("thermal.status")
        until(time_s + 30)
        put("sensors." + name, 0)
        wait("the alarm to end", lambda: not get("thermal.alarm"))
    until(2400)
    seen["pins"] = subprocess.run(["halcmd", "show", "pin", "thermal"], check=True, capture_output=True, text=True).stdout


def unmoved():
    """An INI without OFFSET_AV_RATIO."""
    begin()
    put("sensors.go", 1)
    seen["alarm_s"] = wait("the alarm that nothing follows", lambda: get("thermal.alarm"), 10.0)
    seen["status"] = get("thermal.status")


def killed():
    """The component is killed in the middle."""
    begin()
    put("sensors.go", 1)
    wait("an offset", lambda: abs(offset_um()) > 1.0)
    seen["displacement"] = get("thermal.z-displacement")
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/cmdline", encoding="utf-8") as source:
                command = source.read().split("\0")
            ours = command[1:3] == ["thermal.py", "--hal"] and os.readlink(f"/proc/{entry}/cwd") == os.getcwd()
        except OSError:
            continue
        if ours:
            os.kill(int(entry), signal.SIGKILL)
    time.sleep(0.2)  # for the last count
    before = offset_um()
    time.sleep(1.5)  # calls that do not come
    seen["stands"] = abs(offset_um() - before) < 1e-6


def again():
    """LinuxCNC anew, after that; and off and on again between two calls."""
    seen["at_first"] = offset_um()
    machine = begin()
    seen["displacement"] = get("thermal.z-displacement")
    put("sensors.go", 1)
    wait("an offset", lambda: abs(offset_um()) > 1.0)
    machine.off()
    machine.on()
    seen["off_and_on"] = offset_um()
    wait("an offset once more", lambda: abs(offset_um()) > 1.0)
    seen["status"] = get("thermal.status")


def main():
    part = sys.argv[-1]
    signal.alarm(170)  # whatever happens
    component = hal.component("display")  # by which pins are set
    component.ready()
    start = time.monotonic()
    try:
        {"page": page, "day": day, "unmoved": unmoved, "killed": killed, "again": again}[part]()
        seen["done"] = True
    finally:
        seen["took_s"] = time.monotonic() - start
        with open(part + ".json", "w", encoding="utf-8") as out:
            json.dump(seen, out)


main()

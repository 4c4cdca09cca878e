#!/usr/bin/python3
"""The user interface of a headless LinuxCNC: homes, moves to the poses of commands.json, writes the joint positions to reached.json,
and what the motor of joint 0 is commanded to motor.json."""
import json
import sys
import time

import hal
import linuxcnc

command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def until(what, condition):
    for _ in range(1000):
        status.poll()
        if condition():
            return
        time.sleep(0.01)
    sys.exit(f"LinuxCNC: {what}: {errors.poll()}")


def settled():
    """Joint positions that are the same after a tenth of a second."""
    before = []
    for _ in range(100):
        status.poll()
        now = [status.joint[i]["output"] for i in range(status.joints)]
        # a search by Newton's method changes the last digits
        if before and max(abs(a - b) for a, b in zip(now, before)) < 1e-11:
            return now
        before = now
        time.sleep(0.1)
    sys.exit("LinuxCNC: the joints do not come to rest")


work = json.load(open("commands.json"))
# pins are read by a component
component = hal.component("drive")
component.ready()
time.sleep(0.5)
command.state(linuxcnc.STATE_ESTOP_RESET)
until("no reset", lambda: status.task_state >= linuxcnc.STATE_ESTOP_RESET)
command.state(linuxcnc.STATE_ON)
until("not on", lambda: status.task_state == linuxcnc.STATE_ON)
command.teleop_enable(0)
command.home(-1)
until("not homed", lambda: all(status.homed[: status.joints]))
command.mode(linuxcnc.MODE_MDI)
command.wait_complete()
reached, motor = [], []
for line in work:
    command.mdi(line)
    if command.wait_complete(20) != 1:
        sys.exit(f"LinuxCNC refused {line}: {errors.poll()}")
    until("still moving", lambda: status.inpos and status.interp_state == linuxcnc.INTERP_IDLE)
    reached.append(settled())
    motor.append(hal.get_value("joint.0.motor-pos-cmd"))
json.dump(reached, open("reached.json", "w"))
json.dump(motor, open("motor.json", "w"))

"""The peer of benches/arms.rs: direct kinematics and Jacobian of a seven-axis arm with Pinocchio (Python package pin).

usage: arms_pinocchio.py arm.csv joints.csv    (arm.csv: alpha, a, theta, d of each joint, modified Denavit-Hartenberg, rad and mm)
Prints the median time of a pose in seconds, calls from Python included, what the calls alone take (those of an arm with one joint),
and the sums of positions and of Jacobians.
"""

import sys
import time

import numpy as np
import pinocchio as pin


def turn(angle, axis):
    return pin.SE3(pin.AngleAxis(angle, np.eye(3)[axis]).matrix(), np.zeros(3))


def shift(by, axis):
    return pin.SE3(np.eye(3), by * np.eye(3)[axis])


def arm(rows):
    model, parent = pin.Model(), 0
    for i, (alpha, a, theta, d) in enumerate(rows):
        place = turn(alpha, 0) * shift(a, 0) * turn(theta, 2) * shift(d, 2)
        parent = model.addJoint(parent, pin.JointModelRZ(), place, f"q{i + 1}")
    return model, parent


def measured(model, joint, joints):
    data, times = model.createData(), []
    positions = jacobians = 0.0
    for k in range(7):
        clock = time.perf_counter()
        for q in joints:
            pin.computeJointJacobians(model, data, q)
            jacobian = pin.getJointJacobian(model, data, joint, pin.LOCAL_WORLD_ALIGNED)
            if k == 0:
                positions += data.oMi[joint].translation.sum()
                jacobians += jacobian[:3].sum()
        times.append((time.perf_counter() - clock) / len(joints))
    return np.median(times[1:]), positions, jacobians


rows, joints = np.loadtxt(sys.argv[1], delimiter=","), np.loadtxt(sys.argv[2], delimiter=",")
seconds, positions, jacobians = measured(*arm(rows), joints)
calls = measured(*arm(rows[:1]), np.ascontiguousarray(joints[:, :1]))[0]
print(seconds, calls, positions, jacobians)

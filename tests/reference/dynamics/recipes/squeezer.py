"""Andrews' squeezer by absolute coordinates of its seven bodies in the plane: checks that
places, masses and joints as the case has them give the published state at 0.03 s.

The second derivative of the constraints is integrated with a weak stabilization, by an
explicit method of eighth order.

    python squeezer.py
"""
import json
import pathlib

import numpy as np
from scipy.integrate import solve_ivp

data = json.loads((pathlib.Path(__file__).parent / "../squeezer.json").read_text())
A, B, C = (np.array(data["ground"][k]) for k in "ABC")
# A body is a bar along its own x axis; the length to its outer joint, its mass center,
# mass and inertia about that.
bodies = data["bodies"]
LENGTH = [body["length"] for body in bodies]
CENTER = [np.array(body["center"]) for body in bodies]
SPRING = data["spring"]


def turn(a):
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def attitudes(q):
    beta, theta, gamma, phi, delta, omega, epsilon = q
    half = np.pi / 2
    return np.array(
        [beta, beta + theta + np.pi, gamma - half, phi + delta - half, delta, omega + epsilon, epsilon - half]
    )


def roots(angle):
    """Inner ends of the bars: 0 crank, 1 coupler, 2 triangle, 3 to 6 arms."""
    tip = lambda k, root: root + turn(angle[k]) @ [LENGTH[k], 0]
    return [np.zeros(2), tip(0, np.zeros(2)), B, tip(4, A), A, tip(6, A), A]


def end(k):
    return np.array([LENGTH[k], 0]) - CENTER[k]


def root(k):
    return -CENTER[k]


JOINTS = [
    (0, root(0), None, np.zeros(2)),
    (0, end(0), 1, root(1)),
    (2, root(2), None, B),
    (4, root(4), None, A),
    (4, end(4), 3, root(3)),
    (6, root(6), None, A),
    (6, end(6), 5, root(5)),
    (1, end(1), 2, end(2)),
    (3, end(3), 2, end(2)),
    (5, end(5), 2, end(2)),
]
MASSES = np.concatenate([[body["mass"], body["mass"], body["inertia"]] for body in bodies])
STABILIZATION = 200.0


def rate(t, y):
    q, v = y[:21].reshape(7, 3), y[21:].reshape(7, 3)
    gradient, convective, gap, force = np.zeros((20, 21)), np.zeros(20), np.zeros(20), np.zeros(21)
    for i, (a, on_a, b, on_b) in enumerate(JOINTS):
        rows = slice(2 * i, 2 * i + 2)
        for k, point, sign in ((a, on_a, 1.0), (b, on_b, -1.0)):
            if k is None:
                gap[rows] -= point
                continue
            arm = turn(q[k, 2]) @ point
            gap[rows] += sign * (q[k, :2] + arm)
            gradient[rows, 3 * k : 3 * k + 2] = sign * np.eye(2)
            gradient[rows, 3 * k + 2] = sign * np.array([-arm[1], arm[0]])
            convective[rows] += sign * arm * v[k, 2] ** 2
    force[2] = data["moment"]
    arm = turn(q[2, 2]) @ (np.array(SPRING["on_triangle"]) - CENTER[2])
    reach = q[2, :2] + arm - C
    length = np.hypot(*reach)
    pull = -SPRING["stiffness"] * (length - SPRING["length"]) / length * reach
    force[6:8] += pull
    force[8] += arm[0] * pull[1] - arm[1] * pull[0]
    matrix = np.block([[np.diag(MASSES), gradient.T], [gradient, np.zeros((20, 20))]])
    drift = 2 * STABILIZATION * gradient @ y[21:] + STABILIZATION**2 * gap
    solution = np.linalg.solve(matrix, np.concatenate([force, convective - drift]))
    return np.concatenate([y[21:], solution[:21]])


angle = attitudes(data["start"])
places = [r + turn(a) @ c for r, a, c in zip(roots(angle), angle, CENTER)]
start = np.concatenate([np.column_stack([places, angle]).ravel(), np.zeros(21)])
done = solve_ivp(rate, (0, 0.03), start, "DOP853", rtol=1e-11, atol=1e-13)
final = done.y[:, -1]
print("angles off by", np.abs(final[:21].reshape(7, 3)[:, 2] - attitudes(data["published"]["angles"])).max())
rates = np.array(data["published"]["rates"])
pairs = np.array([rates[0], rates[0] + rates[1], rates[2], rates[3] + rates[4], rates[4], rates[5] + rates[6], rates[6]])
print("rates off by", np.abs(final[21:].reshape(7, 3)[:, 2] - pairs).max())

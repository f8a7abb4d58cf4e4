"""Reference of the slider-crank with a flexible rod.

The rod is a plane geometrically exact beam (Reissner), in space coordinates: nodes with
x, y and angle, quadratic shape functions, two Gauss points for the strain energy, three
for the kinetic energy. Its first node follows the crank, its last stays on the line of
the slider and carries its mass: ordinary differential equations, integrated by Radau IIA
of fifth order (scipy).

    python slider_crank.py ELEMENTS TOLERANCE > slider_crank.csv
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp

CRANK, ROD, SPEED, SLIDER = 0.15, 0.30, 150.0, 0.075552
E, NU, RHO, SIDE = 2e11, 0.3, 7870.0, 0.008
AREA, SECOND = SIDE**2, SIDE**4 / 12
EA, GA, EI = E * AREA, 5 / 6 * E / (2 + 2 * NU) * AREA, E * SECOND
END, ROWS = 0.06, 121

elements = int(sys.argv[1])
tolerance = float(sys.argv[2])
nodes = 2 * elements + 1
half = ROD / elements / 2


def shape(xi):
    n = np.array([xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2])
    d = np.array([xi - 0.5, -2 * xi, xi + 0.5]) / half
    return n, d


TWO = [(shape(s / np.sqrt(3)), half) for s in (-1, 1)]
THREE = [(shape(s), w * half) for s, w in ((-np.sqrt(0.6), 5 / 9), (0, 8 / 9), (np.sqrt(0.6), 5 / 9))]

mass = np.zeros((nodes, nodes))
for e in range(elements):
    on = slice(2 * e, 2 * e + 3)
    for (n, _), w in THREE:
        mass[on, on] += w * np.outer(n, n)
whole = np.zeros((3 * nodes, 3 * nodes))
for c, density in enumerate((RHO * AREA, RHO * AREA, RHO * SECOND)):
    whole[c::3, c::3] += density * mass
whole[-3, -3] += SLIDER
# x, y of the first node follow the crank, y of the last is zero.
held = [0, 1, 3 * nodes - 2]
free = [i for i in range(3 * nodes) if i not in held]
inverse = np.linalg.inv(whole[np.ix_(free, free)])
coupling = whole[np.ix_(free, held)]


def forces(q):
    """Internal forces and their derivative."""
    force = np.zeros(3 * nodes)
    stiffness = np.zeros((3 * nodes, 3 * nodes))
    for e in range(elements):
        at = 6 * e + np.arange(9)
        local = q[at].reshape(3, 3)
        for (n, d), w in TWO:
            x, y, curvature = d @ local
            angle = n @ local[:, 2]
            c, s = np.cos(angle), np.sin(angle)
            strain = np.array([x * c + y * s - 1, -x * s + y * c, curvature])
            section = np.array([EA, GA, EI]) * strain
            b = np.zeros((3, 9))
            b[0, 0::3], b[0, 1::3], b[0, 2::3] = c * d, s * d, (-x * s + y * c) * n
            b[1, 0::3], b[1, 1::3], b[1, 2::3] = -s * d, c * d, (-x * c - y * s) * n
            b[2, 2::3] = d
            force[at] += w * b.T @ section
            k = b.T @ (np.array([EA, GA, EI])[:, None] * b)
            rx = -s * section[0] - c * section[1]
            ry = c * section[0] - s * section[1]
            rr = section[0] * (-x * c - y * s) + section[1] * (x * s - y * c)
            dn = np.outer(d, n)
            k[0::3, 2::3] += rx * dn
            k[2::3, 0::3] += rx * dn.T
            k[1::3, 2::3] += ry * dn
            k[2::3, 1::3] += ry * dn.T
            k[2::3, 2::3] += rr * np.outer(n, n)
            stiffness[np.ix_(at, at)] += w * k
    return force, stiffness


def whole_q(t, q):
    full = np.zeros(3 * nodes)
    full[free] = q
    full[0], full[1] = CRANK * np.cos(SPEED * t), CRANK * np.sin(SPEED * t)
    return full


count = len(free)


def rate(t, y):
    force, _ = forces(whole_q(t, y[:count]))
    drive = -SPEED**2 * CRANK * np.array([np.cos(SPEED * t), np.sin(SPEED * t), 0])
    return np.concatenate([y[count:], -inverse @ (force[free] + coupling @ drive)])


def jacobian(t, y):
    _, k = forces(whole_q(t, y[:count]))
    out = np.zeros((2 * count, 2 * count))
    out[:count, count:] = np.eye(count)
    out[count:, :count] = -inverse @ k[np.ix_(free, free)]
    return out


# Start: in line, the rod undeformed and moving as a rigid body.
q = np.zeros((nodes, 3))
v = np.zeros((nodes, 3))
q[:, 0] = CRANK + np.linspace(0, ROD, nodes)
turn = -CRANK * SPEED / ROD
v[:, 1] = CRANK * SPEED + turn * np.linspace(0, ROD, nodes)
v[:, 2] = turn
start = np.concatenate([q.ravel()[free], v.ravel()[free]])
times = np.linspace(0, END, ROWS)
done = solve_ivp(rate, (0, END), start, "Radau", times, jac=jacobian, rtol=tolerance, atol=tolerance * 1e-3)
assert done.success, done.message
print("t,x_slider,x_mid,y_mid,deflection")
for t, y in zip(done.t, done.y.T):
    a = whole_q(t, y[:count]).reshape(nodes, 3)
    first, middle, last = a[0], a[elements], a[-1]
    chord = (last - first)[:2]
    chord /= np.hypot(*chord)
    off = (middle - first)[:2]
    print(f"{t:.4f},{last[0]:.9e},{middle[0]:.9e},{middle[1]:.9e},{chord[0] * off[1] - chord[1] * off[0]:.9e}")
print(f"{elements} elements, {done.t.size} rows, {done.nfev} evaluations", file=sys.stderr)

"""Reference of the free rigid body: Euler's equations about its mass center and the
kinematics of its attitude, by an explicit method of eighth order.

    python free_body.py > free_body.csv
"""
import numpy as np
from scipy.integrate import solve_ivp

MASS, OFFSET, INERTIA = 2.0, np.array([0.1, -0.05, 0.2]), np.array([1.0, 2.0, 3.0])
POSITION, VELOCITY, OMEGA = np.array([0.3, -0.2, 0.5]), np.array([1.0, 2.0, -0.5]), np.array([1.0, 2.0, 0.2])
ROTATION = np.radians([20.0, -30.0, 10.0])


def skew(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def exponential(v):
    a = np.linalg.norm(v)
    k = skew(v / a)
    return np.eye(3) + np.sin(a) * k + (1 - np.cos(a)) * k @ k


def rate(t, y):
    r, omega = y[:9].reshape(3, 3), y[9:]
    return np.concatenate([(r @ skew(omega)).ravel(), np.cross(INERTIA * omega, omega) / INERTIA])


start = exponential(ROTATION)
center = POSITION + start @ OFFSET
velocity = VELOCITY + np.cross(OMEGA, start @ OFFSET)
y = np.concatenate([start.ravel(), start.T @ OMEGA])
times = np.linspace(0, 10, 21)
done = solve_ivp(rate, (0, 10), y, "DOP853", times, rtol=1e-12, atol=1e-13)
print("t,x,y,z,omega_x,omega_y,omega_z")
for t, y in zip(done.t, done.y.T):
    r = y[:9].reshape(3, 3)
    place = center + velocity * t - r @ OFFSET
    print(f"{t:.1f}," + ",".join(f"{x:.10e}" for x in (*place, *(r @ y[9:]))))

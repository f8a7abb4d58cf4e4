"""Reference of the Bennett mechanism, driven at constant speed.

Four links of lengths A, B, A, B and twists ALPHA, BETA, ALPHA, BETA with
sin(ALPHA) / A = sin(BETA) / B: four parallel-free hinges that turn all the same. The
angles of neighboring hinges follow

    tan(theta1 / 2) tan(theta2 / 2) = sin((BETA + ALPHA) / 2) / sin((BETA - ALPHA) / 2)

(G. T. Bennett, Engineering 76, 1903). The moment of the drive is the growth of the
kinetic energy per angle, without gravity and friction.

    python bennett.py > bennett.csv
"""
import numpy as np

A, ALPHA, B, BETA = 0.5, np.radians(30.0), 1.0, np.radians(90.0)
SPEED = 2 * np.pi
RATIO = np.sin((BETA + ALPHA) / 2) / np.sin((BETA - ALPHA) / 2)
MASS = {A: 0.5, B: 1.0}
SMALL = 0.002


def about_z(a):
    c, s = np.cos(a), np.sin(a)
    m = np.eye(4)
    m[:2, :2] = [[c, -s], [s, c]]
    return m


def along_x(length, twist):
    c, s = np.cos(twist), np.sin(twist)
    m = np.eye(4)
    m[0, 3] = length
    m[1:3, 1:3] = [[c, -s], [s, c]]
    return m


def follower(theta):
    return 2 * np.arctan2(RATIO * np.cos(theta / 2), np.sin(theta / 2))


def links(theta):
    """Frames at the first end of the three moving links; the ground is the link of B
    from hinge 4 to hinge 1, whose last frame is the origin with z along hinge 1."""
    first = about_z(theta)
    second = first @ along_x(A, ALPHA) @ about_z(follower(theta))
    third = second @ along_x(B, BETA) @ about_z(2 * np.pi - theta)
    end = third @ along_x(A, ALPHA) @ about_z(2 * np.pi - follower(theta)) @ along_x(B, BETA)
    assert np.abs(end - np.eye(4)).max() < 1e-12
    return [first, second, third]


def energy(theta):
    step = 1e-5
    before, now, after = links(theta - step), links(theta), links(theta + step)
    total = 0.0
    for b, n, a, length in zip(before, now, after, (A, B, A)):
        mass = MASS[length]
        center = np.array([length / 2, 0, 0, 1])
        velocity = (a - b)[:3] @ center / (2 * step) * SPEED
        spin = n[:3, :3].T @ (a - b)[:3, :3] / (2 * step) * SPEED
        omega = np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        inertia = np.array([SMALL, mass * length**2 / 12 + SMALL, mass * length**2 / 12 + SMALL])
        total += mass * velocity @ velocity / 2 + omega @ (inertia * omega) / 2
    return total


# The energy is a smooth function of the angle with the period 2 pi: differentiated by
# its Fourier series.
n = 512
angles = 2 * np.pi * np.arange(n) / n
energies = np.array([energy(a) for a in angles])
spectrum = np.fft.rfft(energies)
slope = np.fft.irfft(1j * np.arange(n // 2 + 1) * spectrum * (np.arange(n // 2 + 1) < n // 2), n)
START = np.radians(50.0)
if __name__ == "__main__":
    import sys

    for frame in links(START):
        r = frame[:3, :3]
        angle = np.arccos((np.trace(r) - 1) / 2)
        axis = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]]) / (2 * np.sin(angle))
        print("position", frame[:3, 3].tolist(), "rotation vector", (axis * angle).tolist(), "x", r[:, 0].tolist(), "z", r[:, 2].tolist(), file=sys.stderr)
    print("t,theta,x2,y2,z2,x3,y3,z3,energy,moment")
    for i in range(0, n + 1, 16):
        t = i / n
        theta = START + SPEED * t
        second, third = [frame[:3, 3] for frame in links(theta)[1:]]
        at = theta / (2 * np.pi) * n
        # Both by their series, at any angle.
        k = np.arange(n // 2 + 1)
        weight = np.where((k == 0) | (k == n // 2), 1, 2) / n
        wave = np.exp(1j * k * theta)
        e = (weight * spectrum * wave).real.sum()
        m = (weight * 1j * k * spectrum * wave * (k < n // 2)).real.sum()
        numbers = [theta, *second, *third, e, m]
        print(f"{t:.6f}," + ",".join(f"{x:.10e}" for x in numbers))
    print(np.abs(spectrum[60:200]).max()/np.abs(spectrum[0]), file=sys.stderr)

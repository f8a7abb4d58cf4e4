"""A slice of a rectangular bar, one layer of bricks with 8 nodes, as a finite-element
program would give it away: stiffness and mass as Matrix Market files, and the nodes.

Plain Python: python3 bricks.py
"""

import math

WIDTH, HEIGHT, THICKNESS = 0.020, 0.010, 0.001
ACROSS, UP = 4, 3
YOUNG, POISSON, DENSITY = 70e9, 0.3, 2700.0

LAME = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
SHEAR = YOUNG / (2 * (1 + POISSON))
GAUSS = (-1 / math.sqrt(3), 1 / math.sqrt(3))
# corners of the reference brick: first the face at x = 0, then that at x = THICKNESS
FACE = ((-1, -1), (1, -1), (1, 1), (-1, 1))
CORNERS = [(x, y, z) for x in (-1, 1) for y, z in FACE]


def add(matrix, row, column, value):
    if row >= column and value != 0.0:
        matrix[row, column] = matrix.get((row, column), 0.0) + value


def brick(numbers, size, stiffness, mass):
    """Adds a brick of the given edges, at the nodes `numbers`."""
    volume = size[0] * size[1] * size[2] / 8
    for x in GAUSS:
        for y in GAUSS:
            for z in GAUSS:
                point(numbers, size, volume, (x, y, z), stiffness, mass)


def point(numbers, size, volume, at, stiffness, mass):
    shape, slope = [], []
    for corner in CORNERS:
        factors = [1 + c * p for c, p in zip(corner, at)]
        shape.append(factors[0] * factors[1] * factors[2] / 8)
        slope.append(
            [
                corner[0] * factors[1] * factors[2] / 4 / size[0],
                corner[1] * factors[0] * factors[2] / 4 / size[1],
                corner[2] * factors[0] * factors[1] / 4 / size[2],
            ]
        )
    for a, of_a in zip(numbers, range(8)):
        for b, of_b in zip(numbers, range(8)):
            g, h = slope[of_a], slope[of_b]
            dot = sum(p * q for p, q in zip(g, h))
            for i in range(3):
                for j in range(3):
                    # lambda div u div v + 2 mu eps(u) : eps(v)
                    value = LAME * g[i] * h[j] + SHEAR * g[j] * h[i]
                    value += SHEAR * dot if i == j else 0.0
                    add(stiffness, 3 * a + i, 3 * b + j, volume * value)
                value = DENSITY * shape[of_a] * shape[of_b] * volume
                add(mass, 3 * a + i, 3 * b + i, value)


def write(name, matrix, size):
    with open(name, "w", encoding="ascii") as file:
        file.write("%%MatrixMarket matrix coordinate real symmetric\n")
        file.write(f"{size} {size} {len(matrix)}\n")
        for (row, column), value in sorted(matrix.items()):
            file.write(f"{row + 1} {column + 1} {value!r}\n")


def main():
    columns, rows = ACROSS + 1, UP + 1
    edges = (THICKNESS, WIDTH / ACROSS, HEIGHT / UP)
    with open("nodes.csv", "w", encoding="ascii") as file:
        file.write("node,y,z\n")
        for k in range(rows):
            for j in range(columns):
                y, z = j * edges[1] - WIDTH / 2, k * edges[2] - HEIGHT / 2
                file.write(f"{k * columns + j + 1},{y!r},{z!r}\n")
    stiffness, mass = {}, {}
    behind = columns * rows
    for k in range(UP):
        for j in range(ACROSS):
            first = k * columns + j
            face = [first, first + 1, first + columns + 1, first + columns]
            brick(face + [node + behind for node in face], edges, stiffness, mass)
    write("stiffness.mtx", stiffness, 6 * behind)
    write("mass.mtx", mass, 6 * behind)


main()

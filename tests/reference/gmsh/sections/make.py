"""Makes the meshes of this folder with gmsh 4.15: python make.py

The geometry is that of the reference sections in ../../sections; boundaries and
physical groups are the same, cells are quadrilaterals or both shapes.
"""

import pathlib
import sys

import gmsh

HERE = pathlib.Path(__file__).parent
REFERENCE = HERE / "../../sections"
sys.path.insert(0, str(HERE / ".."))
import swap

SERENDIPITY, FULL = 1, 0


def recombine(surfaces):
    for tag in surfaces:
        gmsh.model.mesh.setRecombine(2, tag)


def all_surfaces():
    return [tag for _, tag in gmsh.model.getEntities(2)]


def blocks(xs, ys, cells_x, cells_y, holes=(), triangles=()):
    """Rectangles between the lines x = xs[i] and y = ys[j], without `holes`; cells are
    (number, ratio of neighbors) for each interval; `triangles` are not recombined."""
    geo = gmsh.model.geo
    kept = [
        (i, j)
        for i in range(len(xs) - 1)
        for j in range(len(ys) - 1)
        if (i, j) not in holes
    ]
    points, lines = {}, {}

    def point(i, j):
        if (i, j) not in points:
            points[i, j] = geo.addPoint(xs[i], ys[j], 0)
        return points[i, j]

    def line(a, b, cells):
        if (a, b) not in lines:
            lines[a, b] = geo.addLine(point(*a), point(*b))
            count, ratio = cells
            geo.mesh.setTransfiniteCurve(lines[a, b], count + 1, "Progression", ratio)
        return lines[a, b]

    surfaces = []
    for i, j in kept:
        bottom = line((i, j), (i + 1, j), cells_x[i])
        top = line((i, j + 1), (i + 1, j + 1), cells_x[i])
        left = line((i, j), (i, j + 1), cells_y[j])
        right = line((i + 1, j), (i + 1, j + 1), cells_y[j])
        loop = geo.addCurveLoop([bottom, right, -top, -left])
        surface = geo.addPlaneSurface([loop])
        geo.mesh.setTransfiniteSurface(surface, "AlternateLeft")
        surfaces.append(surface)
    geo.synchronize()
    gmsh.model.addPhysicalGroup(2, surfaces, 1, "sec")
    recombine(s for s, block in zip(surfaces, kept) if block not in triangles)


def iso_rect(mixed):
    halves = [(14, 1), (14, 1)]
    triangles = [(1, 0)] if mixed else []
    blocks([-0.1, 0, 0.1], [-0.05, 0.05], halves, [(14, 1)], triangles=triangles)


def iso_channel(mixed):
    # graded towards the inner corners, where the stress is singular
    xs = [0, 0.004, 0.027, 0.05]
    ys = [-0.05, -0.046, 0, 0.046, 0.05]
    inner, outer = 1.6, 1 / 1.6
    cells_x = [(7, outer), (11, inner), (8, 1)]
    cells_y = [(7, outer), (13, inner), (13, outer), (7, inner)]
    holes = [(1, 1), (1, 2), (2, 1), (2, 2)]
    triangles = [(2, 0), (2, 3), (0, 2)] if mixed else []
    blocks(xs, ys, cells_x, cells_y, holes, triangles)


def reference(name):
    gmsh.merge(str(REFERENCE / f"{name}.geo"))


def bimat_rect(mixed):
    reference("bimat_rect")
    for curve in range(1, 8):
        gmsh.model.mesh.setTransfiniteCurve(curve, 15)
    recombine([2] if mixed else [1, 2])


def box(mixed):
    reference("box_CUS_45_m45")
    # graded towards the corners
    for layer in range(7):
        for side, cells in zip((1, 2, 3, 4), (24, 16, 24, 16)):
            curve = 100 + 10 * layer + side
            gmsh.model.mesh.setTransfiniteCurve(curve, cells + 1, "Bump", 0.06)
    for surface in all_surfaces():
        gmsh.model.mesh.setTransfiniteSurface(surface, "AlternateLeft")
    recombine(s for s in all_surfaces() if not (mixed and s % 10 in (2, 4)))


MESHES = [
    ("iso_rect", iso_rect),
    ("bimat_rect", bimat_rect),
    ("iso_channel", iso_channel),
    ("box_CUS_45_m45", box),
]

# order of the middles, mixed, version, whether bytes are turned
KINDS = {
    "quad8": (SERENDIPITY, False, 4.1, False),
    "quad9": (FULL, False, 2.2, True),
    "mixed": (SERENDIPITY, True, 4.1, True),
}


def write(file, version, big):
    gmsh.option.setNumber("Mesh.MshFileVersion", version)
    gmsh.option.setNumber("Mesh.Binary", 1)
    gmsh.write(file)
    if big:
        swap.swap(file, file)


if __name__ == "__main__":
    for name, make in MESHES:
        for kind, (incomplete, mixed, version, big) in KINDS.items():
            gmsh.initialize()
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.option.setNumber("Mesh.SecondOrderLinear", 1)
            gmsh.option.setNumber("Mesh.SecondOrderIncomplete", incomplete)
            gmsh.model.add(name)
            make(mixed)
            gmsh.model.mesh.generate(2)
            gmsh.model.mesh.setOrder(2)
            write(f"{name}.{kind}.msh", version, big)
            gmsh.finalize()

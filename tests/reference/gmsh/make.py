"""Makes the meshes of this folder with gmsh 4.15: python make.py

Each mesh is written as NAME.22a.msh, NAME.22le.msh, NAME.41a.msh, NAME.41le.msh
(version; a: ascii, le: binary as written by a little-endian machine); swap.py then
writes NAME.22be.msh and NAME.41be.msh.
"""

import gmsh

import swap

LINEAR, SERENDIPITY, FULL = (1, 0), (2, 1), (2, 0)


def plate(recombine=(1, 2), cells=3):
    """Two unit squares side by side, surfaces 1 (left) and 2 (right)."""
    geo = gmsh.model.geo
    for tag, (x, y) in enumerate([(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)], 1):
        geo.addPoint(x, y, 0, tag=tag)
    for tag, (a, b) in enumerate([(1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 1), (2, 5)], 1):
        geo.addLine(a, b, tag)
        geo.mesh.setTransfiniteCurve(tag, cells + 1)
    geo.addCurveLoop([1, 7, 5, 6], 1)
    geo.addCurveLoop([2, 3, 4, -7], 2)
    for tag in (1, 2):
        geo.addPlaneSurface([tag], tag)
        geo.mesh.setTransfiniteSurface(tag)
        if tag in recombine:
            geo.mesh.setRecombine(2, tag)
    geo.synchronize()


def group(dim, entities, tag, name=""):
    gmsh.model.addPhysicalGroup(dim, entities, tag, name)


def mesh(order=LINEAR):
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", order[1])
    gmsh.model.mesh.generate(2)
    gmsh.model.mesh.setOrder(order[0])
    # multiples of 2^-10 have few digits: ascii files hold them exactly
    tags, places, _ = gmsh.model.mesh.getNodes()
    for i, tag in enumerate(tags):
        rounded = [round(1024 * x) / 1024 for x in places[3 * i : 3 * i + 3]]
        gmsh.model.mesh.setNode(tag, rounded, [])


def usual_groups():
    group(2, [1], 1, "left")
    group(2, [2], 2, "right side")
    group(1, [-4, -3], 7, "top to bottom")
    group(0, [3], 9)


def quads(order):
    def make():
        plate()
        usual_groups()
        mesh(order)

    return make


def triangles():
    plate(recombine=())
    usual_groups()
    mesh(SERENDIPITY)


def mixed(order):
    def make():
        plate(recombine=(2,))
        usual_groups()
        mesh(order)

    return make


def groups():
    plate(cells=2)
    group(2, [1, 2], 1, "all")
    group(2, [2], 2, "right")
    group(2, [-2], 5)
    group(1, [1, 2], 1, "bottom")
    group(1, [-2], 2, "back")
    group(1, [2, 3], 3, "round")
    group(0, [1, 2], 1, "p")
    group(0, [1], 2, "q")
    mesh(SERENDIPITY)


def save_all():
    plate(cells=2)
    group(2, [2], 2, "right")
    group(1, [-4], 7, "top")
    mesh(LINEAR)
    gmsh.option.setNumber("Mesh.SaveAll", 1)


def parametric():
    geo = gmsh.model.geo
    for tag, (x, y) in enumerate([(0, 0), (1, 0), (0, 1)], 1):
        geo.addPoint(x, y, 0, 0.5, tag)
    geo.addLine(1, 2, 1)
    geo.addCircleArc(2, 1, 3, 2)
    geo.addLine(3, 1, 3)
    geo.addPlaneSurface([geo.addCurveLoop([1, 2, 3])], 1)
    geo.synchronize()
    group(2, [1], 1, "quarter")
    group(1, [2], 2, "arc")
    mesh(FULL)
    gmsh.option.setNumber("Mesh.SaveParametric", 1)


def sparse():
    """Without the cells of the right surface but one: their nodes stay, unused, and
    the tags of the others are far apart."""
    plate(cells=2)
    usual_groups()
    mesh(LINEAR)
    _, tags, _ = gmsh.model.mesh.getElements(2, 2)
    gmsh.model.mesh.removeElements(2, 2, tags[0][1:])
    old, _, _ = gmsh.model.mesh.getNodes()
    gmsh.model.mesh.renumberNodes(old, [1000 * int(tag) + 7 for tag in old])
    _, old, _ = gmsh.model.mesh.getElements()
    old = [int(tag) for some in old for tag in some]
    gmsh.model.mesh.renumberElements(old, [2**20 + 11 * tag for tag in old])


def other_sections():
    """Periodic boundaries and a field on the nodes: sections that are passed over."""
    plate(cells=2)
    usual_groups()
    shift = [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    gmsh.model.mesh.setPeriodic(1, [3], [6], shift)
    mesh(LINEAR)
    tags, places, _ = gmsh.model.mesh.getNodes()
    view = gmsh.view.add("height")
    values = [[y] for y in places[1::3]]
    gmsh.view.addModelData(view, 0, "", "NodeData", tags, values)


def standing():
    """In the x-z plane."""
    plate(cells=1)
    gmsh.model.geo.rotate([(2, 1), (2, 2)], 0, 0, 0, 1, 0, 0, 1.5707963267948966)
    gmsh.model.geo.synchronize()
    usual_groups()
    mesh(LINEAR)


MESHES = {
    "quads4": quads(LINEAR),
    "quads8": quads(SERENDIPITY),
    "quads9": quads(FULL),
    "triangles6": triangles,
    "mixed3_4": mixed(LINEAR),
    "mixed6_8": mixed(SERENDIPITY),
    "mixed6_9": mixed(FULL),
    "groups": groups,
    "save_all": save_all,
    "parametric": parametric,
    "sparse": sparse,
    "other_sections": other_sections,
    "standing": standing,
}


def write(name):
    for version in (2.2, 4.1):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            file = f"{name}.{round(10 * version)}{['a', 'le'][binary]}.msh"
            gmsh.write(file)
            for view in gmsh.view.getTags():
                gmsh.view.write(view, file, True)
        swap.swap(f"{name}.{round(10 * version)}le.msh", f"{name}.{round(10 * version)}be.msh")


if __name__ == "__main__":
    for name, make in MESHES.items():
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("PostProcessing.SaveMesh", 0)
        gmsh.model.add(name)
        make()
        write(name)
        gmsh.finalize()

use super::read;
use crate::gmsh;
use crate::mesh::{CellKind, LineKind, Mesh};

/// Two triangles of 6 nodes, a quadrilateral of 8 nodes and two lines, by gmsh.
const GMSH: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
2 1 \"web\"
2 2 \"skin\"
1 1 \"top\"
$EndPhysicalNames
$Nodes
14
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0.5 0 0
6 1 0.5 0
7 0.5 1 0
8 0 0.5 0
9 0.5 0.5 0
10 2 0 0
11 2 1 0
12 1.5 0 0
13 2 0.5 0
14 1.5 1 0
$EndNodes
$Elements
5
1 9 2 1 1 1 2 3 5 6 9
2 9 2 1 1 1 3 4 9 7 8
3 16 2 2 1 2 10 11 3 12 13 14 6
4 8 2 1 1 4 3 7
5 8 2 1 1 3 11 14
$EndElements
";

const ABAQUS: &str = "\
*HEADING
 a section
** comment
*PART, NAME=a
*Node
1, 0., 0.
2, 1., 0., 0.0D0
3, 1., 1.
4, 0., 1.
5, .5, 0.
6, 1., .5
7, .5, 1.
8, 0., .5
9, 5.E-1, .5
10, 2., 0.
11, 2., 1.
12, 1.5, 0.
13, 2., .5
14, 1.5, 1.
*Element, type=CPS6,
 elset=web
1, 1, 2, 3, 5,
 6, 9
2, 1, 3, 4, 9, 7, 8
*Element, TYPE = S8R
3, 2, 10, 11, 3, 12, 13, 14, 6
*ELEMENT, TYPE=B32, ELSET=first
4, 4, 7, 3
5, 3, 14, 11
*Elset, elset=skin, generate
 3, 3, 1
*Elset, elset=top
 First,
*End Part
*Assembly, name=whole
*Instance, name=a-1, part=a
 0., 0., 0.
*End Instance
*Node
1, 7., 7., 0.
*End Assembly
*Material, name=steel
*Elastic
210000., 0.3
";

const VTK: &str = "\
# vtk DataFile Version 3.0
a section
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 14 double
0 0 0 1 0 0 1 1 0 0 1 0 0.5 0 0
1 0.5 0 0.5 1 0 0 0.5 0 0.5 0.5 0
2 0 0 2 1 0 1.5 0 0 2 0.5 0 1.5 1 0
CELLS 5 31
6 0 1 2 4 5 8
6 0 2 3 8 6 7
8 1 9 10 2 11 12 13 5
3 3 2 6
3 2 10 13
CELL_TYPES 5
22 22 23 21 21
CELL_DATA 5
SCALARS quality float 1
LOOKUP_TABLE default
0.5 0.5 0.25 1.5 1
SCALARS group int
LOOKUP_TABLE default
1 1 2 1 1
POINT_DATA 14
VECTORS u float
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
";

fn good(text: &str, file: &str) -> Mesh {
    read(text.as_bytes(), file).unwrap_or_else(|problems| panic!("{problems}"))
}

fn bad(text: &str, file: &str) -> String {
    read(text.as_bytes(), file).unwrap_err().to_string()
}

/// The names of the groups of each element, without names their numbers.
fn labels(mesh: &Mesh) -> Vec<Vec<String>> {
    let of = |groups: &crate::mesh::GroupSet| -> Vec<String> {
        groups
            .iter()
            .map(|group| mesh.groups[group].label())
            .collect()
    };
    let cells = mesh.cells.iter().map(|cell| of(&cell.groups));
    cells
        .chain(mesh.lines.iter().map(|line| of(&line.groups)))
        .collect()
}

/// Nodes, cells and lines of both files equal those in gmsh's file, and so do the groups of
/// Abaqus; its set "first" is a further group of the lines. Middle nodes of its lines are
/// listed second.
#[test]
fn the_same_mesh_in_three_formats() {
    let expected = gmsh::read(GMSH, "a.msh").unwrap();
    let abaqus = good(ABAQUS, "a.INP");
    let vtk = good(VTK, "a.vtk");
    assert_eq!(vtk, good(VTK, "a.dat"));
    for mesh in [&abaqus, &vtk] {
        assert_eq!(mesh.nodes, expected.nodes);
        for (found, cell) in mesh.cells.iter().zip(&expected.cells) {
            assert_eq!((found.tag, found.kind), (cell.tag, cell.kind));
            assert_eq!(found.nodes(), cell.nodes());
        }
        for (found, line) in mesh.lines.iter().zip(&expected.lines) {
            assert_eq!((found.tag, found.kind), (line.tag, LineKind::Line3));
            assert_eq!(found.nodes(), line.nodes());
        }
        assert_eq!((mesh.cells.len(), mesh.lines.len()), (3, 2));
    }
    assert_eq!(
        labels(&expected),
        [["web"], ["web"], ["skin"], ["top"], ["top"]]
    );
    let top = ["first", "top"].map(str::to_owned).to_vec();
    let found = labels(&abaqus);
    assert_eq!(found[..3], labels(&expected)[..3]);
    assert_eq!(found[3..], [top.clone(), top]);
    assert_eq!(labels(&vtk), [["1"], ["1"], ["2"], ["1"], ["1"]]);
}

#[test]
fn the_newer_list_of_cells_and_fields_of_vtk() {
    let cells = VTK.find("CELLS 5").unwrap()..VTK.find("CELL_TYPES").unwrap();
    let newer = "CELLS 6 26\nOFFSETS vtktypeint64\n0 6 12 20 23 26\nCONNECTIVITY vtktypeint64\n\
        0 1 2 4 5 8 0 2 3 8 6 7 1 9 10 2 11 12 13 5 3 2 6 2 10 13\n";
    let mut text = VTK.to_owned();
    text.replace_range(cells, newer);
    let data = text.find("CELL_DATA").unwrap();
    text.truncate(data);
    text += "CELL_DATA 5\nFIELD FieldData 2\nname 1 5 float\n0.5 1 2 3 4\nMETADATA\nINFORMATION 0\n\n\
        gmsh:physical 1 5 int\n1 1 2 1 1\n";
    assert_eq!(good(&text, "a.vtk"), good(VTK, "a.vtk"));
}

#[test]
fn kinds_of_abaqus_and_of_vtk() {
    for (name, kind) in [
        ("CPS3", CellKind::Triangle3),
        ("CPE6H", CellKind::Triangle6),
        ("STRI65", CellKind::Triangle6),
        ("M3D4R", CellKind::Quadrilateral4),
        ("S4R5", CellKind::Quadrilateral4),
        ("CPE8R", CellKind::Quadrilateral8),
        ("S9R5", CellKind::Quadrilateral9),
    ] {
        let count = kind.node_count();
        let nodes: String = (1..=count)
            .map(|i| format!("{i}, {i}, {}\n", i * i))
            .collect();
        let row: String = (1..=count).map(|i| format!(", {i}")).collect();
        let text = format!("*node\n{nodes}*element, type={name}, elset=a\n4{row}\n");
        let mesh = good(&text, "a.inp");
        assert_eq!((mesh.cells[0].kind, mesh.cells[0].tag), (kind, 4), "{name}");
    }
    // the corners of a pixel are listed by rows
    let pixel = "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n\
        0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n";
    assert_eq!(good(pixel, "a.vtk").cells[0].nodes(), [0, 1, 3, 2]);
}

#[test]
fn problems_of_abaqus_are_reported_with_their_lines() {
    let text = "*node\n1, 0, 0\n1, 1, 0\n2, x, 0\n3, 1\n*element, type=C3D8\n\
        *element, type=CPS3, elset=a\n1, 1, 2, 9\n1, 1, 1, 1\n2, 1, 1\n*elset, elset=b\n7\nnone\n\
        *elset, elset=c, generate\n1, 2, 0\n*include, input=more.inp\n";
    let shown = bad(text, "a.inp");
    for expected in [
        "a.inp:3: node 1 is listed twice",
        "a.inp:4: coordinate \"x\" cannot be read, expected a finite number",
        "a.inp:5: 2 numbers in a row of node 3, expected its number and 2 or 3 coordinates",
        "a.inp:6: elements of type C3D8, expected plane cells",
        "a.inp:8: element 1 refers to node 9, which does not exist",
        "a.inp:9: element 1 is listed twice",
        "a.inp:10: 3 numbers in a row of element 2, expected its number and 3 nodes",
        "a.inp:12: set \"b\" contains element 7, which does not exist",
        "a.inp:13: set \"b\" contains \"none\", which is neither a number nor an earlier set",
        "a.inp:15: 3 numbers in a row of the range of set \"c\", expected first, last and step",
        "a.inp:16: *INCLUDE changes the mesh and is not read",
    ] {
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    let moved = "*node\n1, 0, 0\n*instance, name=a\n1., 0., 0.\n";
    assert!(bad(moved, "a.inp").contains("a.inp:4: the instance is moved"));
    assert!(bad("", "a.inp").contains("ends before the first *NODE"));
}

#[test]
fn problems_of_vtk_are_reported_with_their_lines() {
    let with = |from: &str, to: &str| {
        assert!(VTK.contains(from), "{from}");
        bad(&VTK.replacen(from, to, 1), "a.vtk")
    };
    for (from, to, expected) in [
        (
            "ASCII",
            "BINARY",
            "a.vtk:3: the file is BINARY, expected ASCII\n  help: save",
        ),
        (
            "UNSTRUCTURED_GRID",
            "POLYDATA",
            "a.vtk:4: the data are \"POLYDATA\", expected",
        ),
        (
            "1.5 1 0\n",
            "1.5 x 0\n",
            "a.vtk:8: coordinate \"x\" cannot be read",
        ),
        (
            "3 2 10 13",
            "3 2 10 99",
            "a.vtk:14: element 5 refers to node 100",
        ),
        (
            "22 22 23",
            "22 22 12",
            "a.vtk:12: elements of type 12, expected plane cells",
        ),
        (
            "22 22 23",
            "22 22 9",
            "a.vtk:12: 8 numbers in a row of cell 3 of type 9, expected 4",
        ),
        (
            "CELL_TYPES 5\n22 ",
            "CELL_TYPES 4\n",
            "4 values of CELL_TYPES follow, expected 5",
        ),
        (
            "1 1 2 1 1\nPOINT_DATA",
            "1 1\nPOINT_DATA",
            "a value \"POINT_DATA\" cannot be read",
        ),
        (
            "0.5 0.5 0.25 1.5 1\nSCALARS group",
            "5 5 2 1 1\nSCALARS other",
            "2 arrays of whole numbers by cell could be groups: quality, other",
        ),
    ] {
        let shown = with(from, to);
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    let cut = &VTK[..VTK.find("CELL_TYPES").unwrap() - 5];
    assert!(bad(cut, "a.vtk").contains("ends before a point of a cell"));
}

/// No text of half the file, and no changed byte, is a reason to panic.
#[test]
fn mutilated_files_are_refused_or_read() {
    for (text, file) in [(ABAQUS, "a.inp"), (VTK, "a.vtk")] {
        for end in 0..text.len() {
            let _ = read(&text.as_bytes()[..end], file);
            let mut bytes = text.as_bytes().to_vec();
            for other in [b'9', b'*', b' ', b'\n', 0xff] {
                bytes[end] = other;
                let _ = read(&bytes, file);
            }
        }
    }
}

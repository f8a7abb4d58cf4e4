use super::{BECAS_FILES, Model, ModelLaw, read, read_becas, read_point_values, read_vabs};
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

const ABAQUS: &str = include_str!("../../../fuzz/corpus/mesh_file/section.inp");

const VTK: &str = include_str!("../../../fuzz/corpus/mesh_file/section.vtk");

const VABS: &str = include_str!("../../../fuzz/corpus/mesh_file/section.sg");
const OLD_VABS: &str = include_str!("../../../fuzz/corpus/mesh_file/old_format.dat");
const BECAS: &str = include_str!("../../../fuzz/corpus/becas/section.txt");

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
            "4 values of the types of the cells follow, expected 5",
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
    for (text, file) in [
        (ABAQUS, "a.inp"),
        (VTK, "a.vtk"),
        (VABS, "a.sg"),
        (OLD_VABS, "a.dat"),
    ] {
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

/// The mesh in the seven files of VTK and meshio has the nodes and cells of gmsh's; groups
/// have the names of the file, if it has some, and cells its numbers.
#[test]
fn grids_of_vtk_and_meshio_in_every_encoding() {
    let expected = gmsh::read(GMSH, "a.msh").unwrap();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz/corpus/mesh_file/");
    for (name, are_named) in [
        ("ascii.vtu", true),
        ("inline.vtu", true),
        ("inline_zlib.vtu", true),
        ("appended_raw.vtu", true),
        ("appended_raw_zlib.vtu", true),
        ("appended_base64.vtu", true),
        ("meshio.vtu", false),
    ] {
        let bytes = std::fs::read(folder.to_owned() + name).unwrap();
        let mesh = read(&bytes, name).unwrap_or_else(|problems| panic!("{problems}"));
        assert_eq!(mesh, read(&bytes, "without ending").unwrap());
        assert_eq!(mesh.nodes, expected.nodes, "{name}");
        let first = if are_named { 11 } else { 1 };
        for (tag, (found, cell)) in (first..).zip(mesh.cells.iter().zip(&expected.cells)) {
            assert_eq!((found.tag, found.kind), (tag, cell.kind), "{name}");
            assert_eq!(found.nodes(), cell.nodes(), "{name}");
        }
        for (found, line) in mesh.lines.iter().zip(&expected.lines) {
            assert_eq!(found.nodes(), line.nodes(), "{name}");
        }
        assert_eq!((mesh.cells.len(), mesh.lines.len()), (3, 2), "{name}");
        if are_named {
            assert_eq!(labels(&mesh), labels(&expected), "{name}")
        } else {
            assert_eq!(labels(&mesh), [["0"], ["0"], ["1"], ["2"], ["2"]])
        }
    }
}

/// A field file of Helicoid, with its section in the plane x = 0.
#[test]
fn a_field_file_of_helicoid_is_a_mesh() {
    use crate::vtk::{Cell, FieldFile};
    let points = [
        [0.0, 0.0],
        [1.0, 0.0],
        [2.0, 0.0],
        [0.0, 1.0],
        [1.0, 1.0],
        [2.0, 1.0],
    ];
    let mut file = FieldFile::new(points.map(|[y, z]| [0.0, y, z]));
    for cell in [[0, 1, 4, 3], [1, 2, 5, 4]] {
        file.add_cell(Cell::Section(CellKind::Quadrilateral4), cell);
    }
    file.cell_numbers("region", vec![1, 0]);
    file.cell_numbers("material", vec![0, 0]);
    file.cell_numbers("tag", vec![40, 30]);
    file.field_number("region web & cap", 0);
    file.field_number("region skin", 1);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    file.write(&path).unwrap();
    let mesh = read(&std::fs::read(&path).unwrap(), "a.vtu").unwrap();
    assert_eq!(labels(&mesh), [["skin"], ["web & cap"]]);
    let tags: Vec<_> = mesh.cells.iter().map(|cell| cell.tag).collect();
    assert_eq!(tags, [40, 30]);
    for (node, [y, z]) in mesh.nodes.iter().zip(points) {
        assert_eq!(node.position, nalgebra::Vector3::new(y, z, 0.0));
    }
}

#[test]
fn two_pieces_of_a_grid_are_one_mesh() {
    let piece = |shift: f64, region: i32| {
        format!(
            "<Piece NumberOfPoints='3' NumberOfCells='1'><CellData><DataArray type='Int32' \
             Name='group'>{region}</DataArray></CellData><Points><DataArray type='Float64' \
             NumberOfComponents='3'>{shift} 0 0 {} 0 0 {shift} 1 0</DataArray></Points><Cells>\
             <DataArray type='Int32' Name='connectivity'>0 1 2</DataArray><DataArray \
             type='Int32' Name='offsets'>3</DataArray><DataArray type='UInt8' Name='types'>5\
             </DataArray></Cells></Piece>",
            shift + 1.0
        )
    };
    let text = format!(
        "<VTKFile type='UnstructuredGrid'><UnstructuredGrid>{}{}</UnstructuredGrid></VTKFile>",
        piece(0.0, 1),
        piece(2.0, 2)
    );
    let mesh = good(&text, "a.vtu");
    assert_eq!(mesh.cells[1].nodes(), [3, 4, 5]);
    assert_eq!(labels(&mesh), [["1"], ["2"]]);
    assert_eq!(mesh.nodes[4].position.x, 3.0);
}

#[test]
fn problems_of_xml_grids_are_reported_with_their_lines() {
    let ascii = include_str!("../../../fuzz/corpus/mesh_file/ascii.vtu");
    let zlib = include_str!("../../../fuzz/corpus/mesh_file/inline_zlib.vtu");
    let with = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        bad(&text.replacen(from, to, 1), "a.vtu")
    };
    for (text, from, to, expected) in [
        (
            ascii,
            "\"UnstructuredGrid\"",
            "\"PolyData\"",
            "a.vtu:2: the data are \"PolyData\"",
        ),
        (
            ascii,
            "format=\"ascii\"",
            "format=\"other\"",
            "a.vtu:5: an array has the format",
        ),
        (
            zlib,
            "vtkZLib",
            "vtkLZ4",
            "a.vtu:2: the arrays are compressed by vtkLZ4DataCompressor, \
         expected vtkZLibDataCompressor or none\n  help: save without compression",
        ),
        (zlib, "eF5", "eF6", "cannot be uncompressed"),
        (
            zlib,
            "AQAAAEAAAAAUAAAAFgAAAA==",
            "AQAA?",
            "the base 64 of an array has an error",
        ),
        (
            ascii,
            "Name=\"offsets\"",
            "Name=\"other\"",
            "the file ends before offsets",
        ),
    ] {
        // field data are names only: an array of cells is damaged
        let at = if from == "eF5" || from.starts_with("AQAA") {
            "<CellData>"
        } else {
            ""
        };
        let (head, tail) = text.split_at(text.find(at).unwrap_or(0));
        let shown = match at {
            "" => with(text, from, to),
            _ => bad(&(head.to_owned() + &tail.replacen(from, to, 1)), "a.vtu"),
        };
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    assert!(bad("<?xml version='1.0'?>", "a.vtu").contains("ends before the first Piece"));
    assert!(bad("<VTKFile", "a.vtu").contains("ends before the \">\" of an element"));
}

fn vabs(text: &str) -> Model {
    read_vabs(text.as_bytes(), "a.sg").unwrap_or_else(|problems| panic!("{problems}"))
}

/// The four texts of a folder of BECAS, as they are listed in a seed.
fn becas_of(text: &str) -> [(&str, &str); 4] {
    let mut texts = text.split("====\n");
    BECAS_FILES.map(|name| (name, texts.next().unwrap_or("")))
}

/// The same section in the new and in the old format of VABS, and in BECAS': nodes and cells
/// of gmsh's mesh, materials in Helicoid's order, angles by cell.
#[test]
fn the_same_section_in_three_formats() {
    let expected = gmsh::read(GMSH, "a.msh").unwrap();
    let (new, old) = (vabs(VABS), vabs(OLD_VABS));
    let becas = read_becas(becas_of(BECAS)).unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(good(VABS, "a.dat"), new.mesh);
    for model in [&new, &old, &becas] {
        let at = |mesh: &Mesh| {
            mesh.nodes
                .iter()
                .map(|node| node.position)
                .collect::<Vec<_>>()
        };
        assert_eq!(at(&model.mesh), at(&expected));
        for (found, cell) in model.mesh.cells.iter().zip(&expected.cells) {
            assert_eq!((found.tag, found.kind), (cell.tag, cell.kind));
            assert_eq!(found.nodes(), cell.nodes());
        }
        let angles = model
            .cells
            .iter()
            .map(|cell| (cell.fiber_angle, cell.plane_angle));
        let angles: Vec<_> = angles.collect();
        assert_eq!(angles, [(25.0, 40.0), (-35.0, 200.0), (15.0, -70.0)]);
        let groups: Vec<_> = labels(&model.mesh).concat();
        assert_eq!(groups, ["m1 at 25 deg", "m1 at -35 deg", "m2 at 15 deg"]);
        let constants = [140.0, 10.0, 9.0, 5.0, 4.0, 3.0, 0.3, 0.25, 0.4];
        assert_eq!(model.materials[0].law, ModelLaw::Orthotropic(constants));
        assert_eq!(model.materials[0].density, 1.6);
        assert!(model.notes.is_empty());
    }
    assert_eq!(new.curvature, Some([0.1, 0.0, -0.2]));
    assert_eq!(new.slope, Some([0.8, 0.6, 0.0]));
    assert_eq!((old.curvature, old.slope), (None, None));
    let ModelLaw::Full(rows) = &new.materials[1].law else {
        panic!("{:?}", new.materials[1]);
    };
    // the terms of the file are 11 to 66 of the order 11, 12, 13, 22, 23, 33
    let expected = [
        [11.0, 1.4, 1.6, 1.5, 1.3, 1.2],
        [1.4, 44.0, 4.6, 4.5, 3.4, 2.4],
        [1.6, 4.6, 66.0, 5.6, 3.6, 2.6],
        [1.5, 4.5, 5.6, 55.0, 3.5, 2.5],
        [1.3, 3.4, 3.6, 3.5, 33.0, 2.3],
        [1.2, 2.4, 2.6, 2.5, 2.3, 22.0],
    ];
    assert_eq!(**rows, expected);
}

#[test]
fn angles_of_nodes_have_a_mean() {
    let from = "2 1 -35 200 540 0 0 0 0 0 0 0";
    assert!(OLD_VABS.contains(from));
    // the fourth slot has no node; 359 and 1 are one degree from 0
    let to = "2 1 -35 359 1 0 77 359 1 0 88 99";
    let model = vabs(&OLD_VABS.replacen(from, to, 1));
    let angle = model.cells[1].plane_angle.rem_euclid(360.0);
    assert!(angle.min(360.0 - angle) < 1e-12, "{angle}");
    assert!(
        model.notes[0].contains("by up to 1.000 deg"),
        "{:?}",
        model.notes
    );
}

/// An element with two of its four middle nodes, one without any, and a collapsed one:
/// all become quadratic, with one node on each side.
#[test]
fn absent_middle_nodes_are_added() {
    let text = "1 1\n1 0 0\n0 0 0 0\n8 3 1\n1 0 0\n2 2 0\n3 2 2\n4 0 2\n5 1 0\n7 1 2\n9 4 0\n\
        10 4 2\n1 1 2 3 4 5 0 7 0 0\n2 2 9 10 3 0 0 0 0 0\n3 9 10 10 9 0 0 0 0 0\n\
        1 1 0\n2 1 0\n3 1 0\n1 1 0\n1 0\n1 0.3\n1\n";
    let shown = read_vabs(text.as_bytes(), "a.sg").unwrap_err().to_string();
    assert!(
        shown.contains("a.sg:15: 2 numbers in a row of element 3, expected three or four"),
        "{shown}"
    );
    let model = vabs(&text.replace("3 9 10 10 9", "3 9 10 10 3"));
    let kinds: Vec<_> = model.mesh.cells.iter().map(|cell| cell.kind).collect();
    let quadrilateral = CellKind::Quadrilateral8;
    assert_eq!(kinds, [quadrilateral, quadrilateral, CellKind::Triangle6]);
    // 2-3, 4-1, 2-9, 9-10, 10-3 and the diagonal 3-9
    assert_eq!(model.mesh.nodes.len(), 14);
    assert!(
        model.notes[0].contains("6 nodes were added"),
        "{:?}",
        model.notes
    );
    for cell in &model.mesh.cells {
        for ([a, b], middle) in cell.kind.sides(cell.nodes()) {
            let at = |node: u32| model.mesh.nodes[node as usize].position;
            assert_eq!(at(middle.unwrap()), 0.5 * (at(a) + at(b)));
        }
    }
}

/// Many fiber angles of a material are one region.
#[test]
fn many_fiber_angles_are_left_to_a_table() {
    let mut files = becas_of(BECAS).map(|(_, text)| text.to_owned());
    for tag in 4..=30 {
        files[1] += &format!("{tag} 1 2 3 4\n");
        files[2] += &format!("{tag} 1 {tag} 0\n");
    }
    let texts = std::array::from_fn(|i| (BECAS_FILES[i], files[i].as_str()));
    let model = read_becas(texts).unwrap();
    assert_eq!(model.regions.len(), 2);
    assert_eq!(model.regions[0].group, "m1");
    assert_eq!(
        (model.regions[0].fiber_angle, model.regions[0].plane_angle),
        (None, None)
    );
    assert_eq!(model.regions[1].fiber_angle, Some(15.0));
}

/// Changes of the files of VABS, and their problems.
const BAD_VABS: [(&str, &str, &str, &str); 12] = [
    (
        VABS,
        "1 3 ",
        "7 3 ",
        "a.sg:2: the flag \"format\" is 7, expected 0 or 1",
    ),
    (
        VABS,
        "1 0 0\n",
        "1 0 3\n",
        "a.sg:3: the flag \"thermal\" is 3, expected 0",
    ),
    (
        VABS,
        "0.8 0.6",
        "0.8 0.7",
        "the cosines are 0.8 and 0.7, expected",
    ),
    (
        VABS,
        "\n14 1.5",
        "\n13 1.5",
        "node 13 is listed twice\n  help: remove",
    ),
    (
        VABS,
        "\n2 1 3 4 0",
        "\n2 1 99 4 0",
        "element 2 refers to node 99, which does not exist",
    ),
    (
        VABS,
        "\n3 3 -70",
        "\n3 9 -70",
        "element 3 refers to layer 9, which does not exist\n  help",
    ),
    (
        VABS,
        "\n3 3 -70",
        "\n2 3 -70",
        "element 2 has 2 rows of its layup, expected one",
    ),
    (
        VABS,
        "3 2 15",
        "3 5 15",
        "the layup of element 3 refers to material 5",
    ),
    (
        VABS,
        "2 2\n11 ",
        "2 4\n11 ",
        "the flag \"kind of a material\" is 4, expected 0, 1 or 2",
    ),
    (
        VABS,
        "0.4\n",
        "0.4 7\n",
        "4 numbers in a row of the last constants of a material",
    ),
    (
        OLD_VABS,
        "540 0 0 0 0 0 0 0\n",
        "540\n",
        "numbers in a row of the layup of element 1",
    ),
    (
        OLD_VABS,
        "2 1 -35",
        "2 1 x",
        "theta3 \"x\" cannot be read, expected a finite number",
    ),
];

#[test]
fn problems_of_vabs_are_reported_with_their_lines() {
    for (text, from, to, expected) in BAD_VABS {
        assert!(text.contains(from), "{from}");
        let shown = read_vabs(text.replacen(from, to, 1).as_bytes(), "a.sg");
        let shown = shown.unwrap_err().to_string();
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    let cut = &VABS[..VABS.find("0.4\n").unwrap()];
    assert!(bad(cut, "a.sg").contains("ends before the constants of a material"));
}

#[test]
fn problems_of_becas_are_reported_with_their_lines() {
    for (from, to, expected) in [
        (
            "14 1.5 1",
            "14 1.5",
            "N2D.in:15: 2 numbers in a row of a node, expected its number, x",
        ),
        (
            "3 2 10 11 3 12 13 14 6",
            "3 2 10",
            "E2D.in:4: 3 numbers in a row of an element",
        ),
        (
            "3.0e+00 2 15 -70",
            "3 4 15 -70",
            "EMAT.in:3: the layup of element 3 refers to material 4",
        ),
        (
            "3.0e+00 2 15 -70",
            "5 2 15 -70",
            "EMAT.in:3: a layup refers to element 5",
        ),
        (
            "0.4 1.6",
            "0.4",
            "MATPROPS.in:2: 9 numbers in a row of a material, expected 9 elastic",
        ),
    ] {
        assert!(BECAS.contains(from), "{from}");
        let text = BECAS.replacen(from, to, 1);
        let shown = read_becas(becas_of(&text)).unwrap_err().to_string();
        assert!(shown.contains(expected), "{expected}\n{shown}");
    }
    let shown = read_becas(BECAS_FILES.map(|name| (name, "")))
        .unwrap_err()
        .to_string();
    assert!(
        shown.contains("E2D.in:1: the file ends before the first row"),
        "{shown}"
    );
    // of one empty table the layups that refer to it are no further problems
    let mut files = becas_of(BECAS);
    files[3].1 = "";
    let shown = read_becas(files).unwrap_err().to_string();
    assert!(shown.starts_with("error: MATPROPS.in:1: the file ends before"));
    assert_eq!(shown.matches("error: ").count(), 1, "{shown}");
}

/// 300 values of all sizes are read with all their bits; an array that is missing is named, and
/// an array that has been cut off is refused.
#[test]
fn values_at_points_are_read_as_they_were_written() {
    let mut state = 3_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        f64::from_bits(state)
    };
    let finite = std::iter::repeat_with(&mut random).filter(|value| value.is_finite());
    let values: Vec<f64> = finite.take(300).collect();
    let mut file = crate::vtk::FieldFile::new([[0.0; 3]; 100]);
    file.point_values("a < b", 3, values.clone());
    file.point_values("c", 1, vec![1.0; 100]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vtu");
    file.write(&path).unwrap();
    let content = std::fs::read(&path).unwrap();
    let named = |names: &[&str]| {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        read_point_values(&content, "a.vtu", &names)
    };
    assert_eq!(named(&["c", "a < b"]).unwrap(), [vec![1.0; 100], values]);
    let problem = named(&["c", "d"]).unwrap_err().to_string();
    assert!(
        problem.contains("a.vtu:1: the points have no array \"d\""),
        "{problem}"
    );
    let cut = &content[..content.len() / 4];
    assert!(read_point_values(cut, "a.vtu", &["a < b".to_owned()]).is_err());
}

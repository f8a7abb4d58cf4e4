//! Results of the readers for valid files.
//!
//! The two files below describe the same mesh, the 2 x 1 rectangle of `Plane Surface(1)`
//! in one biquadratic cell, with `Physical Curve("the skin") = {-1, 2}`; they are output
//! of gmsh 4.15.2 for versions 2.2 and 4.1; the node tags of the 2.2 file were replaced
//! by hand by the tags of the other to make them sparse.

use super::*;
use crate::error::Diagnostics;
use crate::mesh::{CellKind, LineKind};

pub(super) const V22: &str = r#"$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
0 3 "p q"
1 7 "the skin"
2 1 "a"
$EndPhysicalNames
$Nodes
9
10 0 0 0
2 2 0 0
3 2 1 0
4 0 1 0
5 1 0 0
6 2 0.5 0
7 1.000000000002661 1 0
8 0 5e-1 0
900000000000 1 0.5 0
$EndNodes
$Elements
4
1 15 2 3 1 10
2 8 2 7 1 2 10 5
3 8 2 8 2 2 3 6
4 10 2 1 1 10 2 3 4 5 6 7 8 900000000000
$EndElements
"#;

pub(super) const V41: &str = r#"$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
0 3 "p q"
1 7 "the skin"
2 1 "a"
$EndPhysicalNames
$Entities
5 4 1 0
1 0 0 0 1 3 
2 2 0 0 0 
3 2 1 0 0 
4 0 1 0 0 
9 5 5 0 0 
1 0 0 0 2 0 0 1 -7 2 1 -2 
2 2 0 0 2 1 0 1 8 2 2 -3 
3 0 1 0 2 1 0 0 2 3 -4 
4 0 0 0 0 1 0 0 2 4 -1 
1 0 0 0 2 1 0 1 1 4 1 2 3 4 
$EndEntities
$Nodes
4 9 2 900000000000
0 1 0 1
10
0 0 0
0 2 0 3
2
3
4
2 0 0
2 1 0
0 1 0
1 1 1 4
5
6
7
8
1 0 0 0.5
2 0.5 0 0.5
1.000000000002661 1 0 0.5
0 0.5 0 0.5
2 1 1 1
900000000000
1 0.5 0 0.5 0.5
$EndNodes
$Elements
4 4 1 4
0 1 15 1
1 10 
1 1 8 1
2 10 2 5 
1 2 8 1
3 2 3 6 
2 1 10 1
4 10 2 3 4 5 6 7 8 900000000000 
$EndElements
"#;

pub(super) fn parsed(text: &str) -> Mesh {
    read(text, "test.msh").unwrap_or_else(|problems| panic!("{problems}"))
}

pub(super) fn refused(text: &str) -> Diagnostics {
    read(text, "test.msh").expect_err("the file has a problem")
}

#[test]
fn both_versions_give_the_same_mesh() {
    let mesh = parsed(V22);
    assert_eq!(mesh, parsed(V41));

    let tags: Vec<u64> = mesh.nodes.iter().map(|node| node.tag).collect();
    assert_eq!(tags, [10, 2, 3, 4, 5, 6, 7, 8, 900_000_000_000]);
    assert_eq!(mesh.nodes[6].position.x, 1.000000000002661);
    assert_eq!(mesh.nodes[7].position.y, 0.5);

    let cell = &mesh.cells[0];
    assert_eq!(
        (cell.tag, cell.kind, cell.entity, cell.groups.as_slice()),
        (4, CellKind::Quadrilateral9, 1, &[2][..])
    );
    assert_eq!(cell.nodes(), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(mesh.points[0].node, 0);
    assert_eq!(mesh.points[0].groups.as_slice(), [0]);
}

#[test]
fn a_reversed_curve_runs_on_into_the_next_one() {
    // {-1, 2}: gmsh itself reverses the line when it writes 2.2, and not in 4.1
    for text in [V22, V41] {
        let mesh = parsed(text);
        assert_eq!(mesh.lines[0].kind, LineKind::Line3);
        assert_eq!(mesh.lines[0].nodes(), [1, 0, 4]);
        assert_eq!(mesh.lines[0].groups.as_slice(), [1]);
    }
}

#[test]
fn a_group_without_a_name_has_its_tag_as_label() {
    for text in [V22, V41] {
        let mesh = parsed(text);
        let group = mesh.lines[1].groups.first().unwrap();
        assert_eq!((group, mesh.groups[group].name.as_ref()), (3, None));
        assert_eq!(mesh.groups[group].label(), "8");
        assert_eq!(mesh.groups[1].label(), "the skin");
    }
}

#[test]
fn each_element_type_is_read() {
    let nodes: String = (1..=9).map(|i| format!("{i} {i} {} 0\n", i * i)).collect();
    let types = [
        (15, 1),
        (1, 2),
        (8, 3),
        (2, 3),
        (9, 6),
        (3, 4),
        (16, 8),
        (10, 9),
    ];
    let elements: String = types
        .iter()
        .enumerate()
        .map(|(i, (number, count))| {
            // shifted, so that no two cells have the same corners
            let nodes: Vec<String> = (0..*count).map(|n| ((n + i) % 9 + 1).to_string()).collect();
            format!("{} {number} 2 0 0 {}\n", i + 1, nodes.join(" "))
        })
        .collect();
    let mesh = parsed(&format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n{nodes}$EndNodes\n\
         $Elements\n8\n{elements}$EndElements"
    ));
    let kinds: Vec<CellKind> = mesh.cells.iter().map(|cell| cell.kind).collect();
    assert_eq!(kinds, CellKind::ALL);
    let counts: Vec<usize> = mesh.lines.iter().map(|line| line.nodes().len()).collect();
    assert_eq!(counts, [2, 3]);
    assert_eq!(mesh.points.len(), 1);
    // physical tag 0 is no group
    assert!(mesh.groups.is_empty() && mesh.cells.iter().all(|cell| cell.groups.is_empty()));
}

#[test]
fn other_sections_blank_lines_and_foreign_line_ends_are_passed_over() {
    for text in [V22, V41] {
        let commented = format!("$Comments\nby hand, $5\n1 2 3\n$EndComments\n\n{text}");
        let trailing = "$Periodic\n1\n1 2 3\n$EndPeriodic\n$NodeData\n1\n\"u\"\n$EndNodeData\n";
        let all = format!("{commented}{trailing}");
        assert_eq!(parsed(&all), parsed(text));
        assert_eq!(parsed(&all.replace('\n', "\r\n")), parsed(text));
        assert_eq!(parsed(&all.replace('\n', "\n\n")), parsed(text));
        assert_eq!(parsed(text.trim_end()), parsed(text));
    }
}

#[test]
fn parametric_nodes_of_both_versions_are_read() {
    // 2.2 keeps them in a separate section: tag x y z dimension entity parameters
    let text = V22
        .replace("Nodes\n", "ParametricNodes\n")
        .replace("5 1 0 0\n", "5 1 0 0 1 1 0.5\n");
    assert_eq!(parsed(&text), parsed(V22));
    // 4.1 has parameters after the coordinates (in V41 above), or none
    let text = V41
        .replace("1 1 1 4\n", "1 1 0 4\n")
        .replace(" 0 0.5\n", " 0\n");
    assert_eq!(parsed(&text), parsed(V41));
}

#[test]
fn a_4_1_file_without_entities_has_no_groups_but_is_read() {
    let (before, rest) = V41.split_once("$Entities").unwrap();
    let (_, after) = rest.split_once("$EndEntities\n").unwrap();
    let mesh = parsed(&format!("{before}{after}"));
    assert_eq!(mesh.cells.len(), 1);
    assert!(mesh.cells[0].groups.is_empty());
    // not reversed, since nothing indicates it
    assert_eq!(mesh.lines[0].nodes(), [0, 1, 4]);
}

#[test]
fn nodes_that_no_element_uses_are_kept() {
    let text = V22
        .replace("4 10 2 1 1", "4 9 2 1 1")
        .replace(" 7 8 900000000000", "");
    let text = text.replace("10 2 3 4 5 6\n", "10 2 3 5 6 7\n");
    let mesh = parsed(&text);
    assert_eq!((mesh.nodes.len(), mesh.cells[0].nodes().len()), (9, 6));
}

#[test]
fn files_are_read_from_disk() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mesh.msh");
    std::fs::write(&path, V41).unwrap();
    assert_eq!(read_file(&path).unwrap(), parsed(V41));
    let missing = read_file(&folder.path().join("no.msh")).unwrap_err();
    assert!(missing.to_string().contains("cannot be read"), "{missing}");
}

#[test]
fn a_large_mesh_is_read_in_one_pass() {
    // 400 x 375 nodes: a pass of quadratic time would take minutes
    let (columns, rows) = (400, 375);
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        columns * rows
    );
    let tag = |i: usize, j: usize| j * columns + i + 1;
    for j in 0..rows {
        for i in 0..columns {
            let (x, y) = (i as f64 / 7.0, j as f64 / 3.0);
            text.push_str(&format!("{} {x} {y} 0\n", tag(i, j)));
        }
    }
    let cells = (columns - 1) * (rows - 1);
    text.push_str(&format!("$EndNodes\n$Elements\n{cells}\n"));
    for j in 0..rows - 1 {
        for i in 0..columns - 1 {
            let (a, b, c, d) = (tag(i, j), tag(i + 1, j), tag(i + 1, j + 1), tag(i, j + 1));
            text.push_str(&format!("{a} 3 2 1 1 {a} {b} {c} {d}\n"));
        }
    }
    text.push_str("$EndElements\n");
    let begin = std::time::Instant::now();
    let mesh = parsed(&text);
    let elapsed = begin.elapsed();
    assert_eq!((mesh.nodes.len(), mesh.cells.len()), (150_000, cells));
    // about 0.2 s here in a test build; the bound leaves a margin for slow machines
    assert!(elapsed.as_secs_f64() < 10.0, "{elapsed:?}");
}

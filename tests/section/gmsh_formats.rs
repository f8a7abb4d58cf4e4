//! Meshes written by gmsh in every supported format: version 2.2 and 4.1, ascii and binary
//! of either byte order.
//!
//! Source: `tests/reference/gmsh/README.md`. The six files of a mesh contain the same mesh,
//! with coordinates that are exact in ascii files, so that reading them must give equal
//! meshes, to the last bit.

#![allow(clippy::unwrap_used, reason = "a failed unwrap fails the test")]

use std::path::PathBuf;

use section_analyzer::input;
use section_analyzer::mesh::SectionMesh;
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, GroupSet, Mesh};

use crate::record;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/gmsh");

const AREAS: &str = "Exact areas";

const NEW: [&str; 3] = ["41a", "41le", "41be"];
const OLD: [&str; 3] = ["22a", "22le", "22be"];

/// Cells of each kind.
type Counts = &'static [(CellKind, usize)];

fn path(name: &str, format: &str) -> PathBuf {
    [FOLDER, &format!("{name}.{format}.msh")].iter().collect()
}

fn read(name: &str, format: &str) -> Mesh {
    gmsh::read_file(&path(name, format)).unwrap_or_else(|problems| panic!("{problems}"))
}

/// The mesh of all files of a version.
fn common(name: &str, formats: [&str; 3]) -> Mesh {
    let [text, little, big] = formats.map(|format| read(name, format));
    assert_eq!(text, little, "{name}: little-endian");
    assert_eq!(text, big, "{name}: big-endian");
    text
}

/// The mesh with tags from one, as renumbered by gmsh for version 2.2.
fn renumbered(mut mesh: Mesh) -> Mesh {
    let mut tags = 1..;
    let mut next = || tags.next().unwrap_or(0);
    mesh.points.iter_mut().for_each(|point| point.tag = next());
    mesh.lines.iter_mut().for_each(|line| line.tag = next());
    mesh.cells.iter_mut().for_each(|cell| cell.tag = next());
    let nodes = mesh.nodes.iter_mut().zip(1..);
    nodes.for_each(|(node, tag)| node.tag = tag);
    mesh
}

/// Checks the number of cells of each kind of a mesh, and their area.
fn measures(mesh: &Mesh, expected_area: f64, expected_kinds: &[(CellKind, usize)]) {
    let (area, kinds) = measured(mesh);
    assert_eq!(kinds, expected_kinds);
    // a sum of a few hundred numbers below one
    let error = (area - expected_area).abs();
    record::largest(AREAS, "meshes of gmsh in all formats", "area", error, 1e-14);
    assert!(error < 1e-14, "area {area}");
}

/// Area of a plane mesh, and the number of cells of each kind that it has.
fn measured(mesh: &Mesh) -> (f64, Vec<(CellKind, usize)>) {
    let (section, _) = SectionMesh::from_mesh(mesh, 1.0, &SourceLocation::file("test"))
        .unwrap_or_else(|problems| panic!("{problems}"));
    let mut area = 0.0;
    for cell in &section.cells {
        for point in cell.kind.rule() {
            let shape = cell.kind.shape(point.r, point.s);
            let (mut dr, mut ds) = ([0.0; 2], [0.0; 2]);
            for (i, &node) in cell.nodes().iter().enumerate() {
                for axis in 0..2 {
                    dr[axis] += shape.dr[i] * section.nodes[node as usize][axis];
                    ds[axis] += shape.ds[i] * section.nodes[node as usize][axis];
                }
            }
            area += point.weight * (dr[0] * ds[1] - dr[1] * ds[0]);
        }
    }
    let count = |kind| {
        section
            .cells
            .iter()
            .filter(|cell| cell.kind == kind)
            .count()
    };
    let kinds = CellKind::ALL.map(|kind| (kind, count(kind)));
    let kinds = kinds.into_iter().filter(|(_, count)| *count > 0);
    (area, kinds.collect())
}

#[test]
fn all_formats_give_the_same_mesh() {
    use CellKind::{Quadrilateral4, Quadrilateral8, Quadrilateral9, Triangle3, Triangle6};
    // two unit squares of 3 x 3 quadrilaterals or twice as many triangles; the cells of the
    // left square
    let plates: [(&str, Counts, usize); 7] = [
        ("quads4", &[(Quadrilateral4, 18)], 9),
        ("quads8", &[(Quadrilateral8, 18)], 9),
        ("quads9", &[(Quadrilateral9, 18)], 9),
        ("triangles6", &[(Triangle6, 36)], 18),
        ("mixed3_4", &[(Triangle3, 18), (Quadrilateral4, 9)], 18),
        ("mixed6_8", &[(Triangle6, 18), (Quadrilateral8, 9)], 18),
        ("mixed6_9", &[(Triangle6, 18), (Quadrilateral9, 9)], 18),
    ];
    for (name, kinds, left) in plates {
        let mesh = common(name, NEW);
        assert_eq!(mesh, common(name, OLD), "{name}: versions");
        measures(&mesh, 2.0, kinds);

        let labels: Vec<_> = mesh.groups.iter().map(|group| group.label()).collect();
        assert_eq!(labels, ["top to bottom", "left", "right side", "9"]);
        let of_left = mesh.cells.iter().filter(|c| c.groups == GroupSet::from(1));
        assert_eq!(of_left.count(), left, "{name}");
        assert_eq!(mesh.lines.len(), 6, "{name}");
        assert_eq!(mesh.points[0].groups, GroupSet::from(3), "{name}");
        // curves -4 and -3: from the left end of the top to the bottom
        let first = mesh.nodes[mesh.lines[0].nodes()[1] as usize].position;
        assert_eq!([first.x, first.y], [2.0, 0.0], "{name}");
    }
}

#[test]
fn an_element_is_in_several_groups() {
    // version 2.2 lists it once for each
    let [new, old] = [NEW, OLD].map(|formats| common("groups", formats));
    assert_eq!(renumbered(new.clone()), renumbered(old.clone()));
    let listed = std::fs::read_to_string(path("groups", "22a")).unwrap();
    let elements = new.points.len() + new.lines.len() + new.cells.len();
    let (_, listed) = listed.split_once("$Elements\n").unwrap();
    let (listed, _) = listed.split_once('\n').unwrap();
    // one cell more for "right" and "5" each of the 4 on the right, a line more for
    // "round" on curve 2, a point more for "q"
    assert_eq!(listed.parse(), Ok(elements + 2 * 4 + 2 + 1));

    for mesh in [&new, &old] {
        let labels = |groups: &GroupSet| -> Vec<String> {
            groups
                .iter()
                .map(|group| mesh.groups[group].label())
                .collect()
        };
        let mut cells: Vec<_> = mesh.cells.iter().map(|cell| labels(&cell.groups)).collect();
        cells.dedup();
        assert_eq!(cells, [vec!["all"], vec!["all", "right", "5"]]);
        // curve 2 runs along in "bottom" and "round", against in "back"
        let on_two = mesh.lines.iter().filter(|line| line.entity == 2);
        let mut on_two: Vec<_> = on_two.collect();
        on_two.sort_by_key(|line| labels(&line.groups));
        let lines: Vec<_> = on_two.iter().map(|line| labels(&line.groups)).collect();
        assert_eq!(lines[0], ["back"]);
        assert_eq!(lines[2], ["bottom", "round"]);
        assert_eq!(on_two[0].nodes(), on_two[2].reversed().nodes());
        let points: Vec<_> = mesh.points.iter().map(|p| labels(&p.groups)).collect();
        assert_eq!(points, [vec!["p", "q"], vec!["p"]]);
        measures(mesh, 2.0, &[(CellKind::Quadrilateral8, 8)]);
    }
    assert_eq!(gmsh::read(&gmsh::write(&new), "again").unwrap(), new);
}

#[test]
fn elements_may_be_in_no_group() {
    // Mesh.SaveAll = 1: groups of some elements in 4.1, of none in 2.2
    let [new, old] = [NEW, OLD].map(|formats| common("save_all", formats));
    let right = GroupSet::from(new.group(2, "right").unwrap());
    let free = |mesh: &Mesh| mesh.cells.iter().filter(|c| c.groups.is_empty()).count();
    assert_eq!((new.cells.len(), free(&new)), (8, 4));
    assert_eq!(new.cells.iter().filter(|c| c.groups == right).count(), 4);
    assert_eq!((old.cells.len(), free(&old)), (8, 8));
    assert_eq!([new.lines.len(), old.lines.len()], [14; 2]);
    assert_eq!(measured(&new), measured(&old));
}

#[test]
fn parameters_of_nodes_are_passed_over() {
    let mesh = common("parametric", NEW);
    assert_eq!(mesh, common("parametric", OLD));
    let (area, kinds) = measured(&mesh);
    assert_eq!(kinds, [(CellKind::Triangle6, mesh.cells.len())]);
    // a quarter of the unit circle; its nodes are rounded to 2^-10, half of which
    // times the arc bounds the error of the area
    let bound = 0.5 / 1024.0 * std::f64::consts::FRAC_PI_2;
    let exact = std::f64::consts::FRAC_PI_4;
    let error = (area - exact).abs();
    record::value(
        AREAS,
        "quarter of a circle",
        "area",
        [area, exact],
        error,
        bound,
    );
    assert!(error < bound, "{area}");
}

#[test]
fn tags_may_be_sparse_and_nodes_unused() {
    let [new, old] = [NEW, OLD].map(|formats| common("sparse", formats));
    assert_eq!(renumbered(new.clone()), renumbered(old));
    let tags = new.nodes.iter().map(|node| node.tag);
    assert!(tags.eq((1..=15).map(|i| 1000 * i + 7)));
    assert_eq!(new.cells[0].tag, (1 << 20) + 66);
    let (section, report) =
        SectionMesh::from_mesh(&new, 1.0, &SourceLocation::file("test")).unwrap();
    // 3 x 3 nodes on the left, two more of the cell on the right
    assert_eq!((section.nodes.len(), report.unused_nodes), (11, 4));
    measures(&new, 1.25, &[(CellKind::Quadrilateral4, 5)]);
}

#[test]
fn sections_of_other_things_are_passed_over() {
    let mesh = common("other_sections", NEW);
    assert_eq!(mesh, common("other_sections", OLD));
    measures(&mesh, 2.0, &[(CellKind::Quadrilateral4, 8)]);
    for format in ["41a", "41be"] {
        let bytes = std::fs::read(path("other_sections", format)).unwrap();
        for section in ["$Periodic\n", "$NodeData\n", "$InterpolationScheme\n"] {
            let found = bytes
                .windows(section.len())
                .any(|w| w == section.as_bytes());
            assert!(found, "{format} {section}");
        }
    }
}

#[test]
fn a_mesh_that_is_upright_is_refused_with_the_way_out() {
    for formats in [NEW, OLD] {
        let mesh = common("standing", formats);
        let problems = SectionMesh::from_mesh(&mesh, 1.0, &SourceLocation::file("test"));
        assert_eq!(
            problems.unwrap_err().to_string(),
            "error: test: the mesh lies in the plane y = 0, expected a plane z = constant\n  \
             help: rotate it by -90 degrees about the mesh axis x into the x-y plane (in gmsh, \
             Rotate), where x is the section axis y and y is the section axis z"
        );
    }
}

/// Reads a section of steel in these groups of the mesh of a format.
fn with_regions(mesh: &str, format: &str, groups: &[&str]) -> Result<input::Input, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(path(mesh, format), folder.path().join("a.msh")).unwrap();
    let mut text = "mesh = \"a.msh\"\nunits = \"SI\"\n\
         [material.steel]\nyoung = 210e9\npoisson = 0.3\ndensity = 7850\n"
        .to_owned();
    for group in groups {
        text += &format!("[[region]]\ngroup = \"{group}\"\nmaterial = \"steel\"\n");
    }
    let file = folder.path().join("a.section.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file)
}

#[test]
fn a_cell_belongs_to_the_region_of_one_of_its_groups() {
    for format in [NEW, OLD].concat() {
        let of = |groups: &[&str]| with_regions("groups", format, groups);
        let whole = of(&["all"]).unwrap();
        assert_eq!(whole.section.mesh.groups, ["all"], "{format}");
        assert_eq!(whole.summary.areas.regions[0].cells, 8);

        // the left cells are in no other group than "all"
        let problems = of(&["5"]).unwrap_err().to_string();
        let expected = "physical surface \"all\" (4 cells) has no region";
        assert!(problems.contains(expected), "{problems}");

        let problems = of(&["right", "all"]).unwrap_err().to_string();
        let example = read("groups", format).cells[4].tag;
        let expected = format!(
            "a.section.toml:10: regions \"right\" (line 7) and \"all\" both contain 4 cells (cell \
             {example} for example), expected every cell in one region\n  help: a cell has one \
             material"
        );
        assert!(problems.contains(&expected), "{problems}");
        assert_eq!(problems.matches("error:").count(), 1, "{problems}");
    }
}

//! Meshes of Abaqus and VTK: the sections of the cases, written in their formats.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use nalgebra::Matrix6;
use section_analyzer::analysis::analyze;
use section_analyzer::input;
use shared_geom::gmsh;
use shared_geom::mesh::{GroupSet, Mesh, PhysicalGroup};

/// Sections of cases without tables by cell, whose numbers VTK does not store: cells whose
/// angles follow curves, and lines with laminates.
const CASES: [&str; 3] = ["composite_box", "box_of_lines", "channel"];

/// The mesh and the text of the section file of a case.
fn case(name: &str) -> (Mesh, String) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../cases/section");
    let file = |ending: &str| root.join(name).join(format!("{name}.{ending}"));
    let mesh = gmsh::read_file(&file("msh")).unwrap();
    (mesh, std::fs::read_to_string(file("section.toml")).unwrap())
}

/// The elements of a mesh: number, type in Abaqus, type in VTK, nodes and groups.
type Element<'a> = (u64, String, u32, &'a [u32], &'a GroupSet);

fn elements(mesh: &Mesh) -> Vec<Element<'_>> {
    let types = |count: usize| match count {
        3 => 5,
        4 => 9,
        6 => 22,
        8 => 23,
        _ => 28,
    };
    let cells = mesh.cells.iter().map(|cell| {
        let count = cell.nodes().len();
        let name = if count == 9 {
            "S9R5".to_owned()
        } else {
            format!("CPE{count}")
        };
        (cell.tag, name, types(count), cell.nodes(), &cell.groups)
    });
    let lines = mesh.lines.iter().map(|line| {
        let count = line.nodes().len();
        let vtk = if count == 2 { 3 } else { 21 };
        (
            line.tag,
            format!("T3D{count}"),
            vtk,
            line.nodes(),
            &line.groups,
        )
    });
    cells.chain(lines).collect()
}

fn abaqus(mesh: &Mesh) -> String {
    let mut text = "*HEADING\n*NODE\n".to_owned();
    for node in &mesh.nodes {
        let at = node.position;
        writeln!(text, "{}, {:?}, {:?}, {:?}", node.tag, at.x, at.y, at.z).unwrap();
    }
    for (tag, kind, _, nodes, _) in elements(mesh) {
        write!(text, "*ELEMENT, TYPE={kind}\n{tag}").unwrap();
        for &node in nodes {
            write!(text, ", {}", mesh.nodes[node as usize].tag).unwrap();
        }
        text.push('\n');
    }
    for (index, group) in mesh.groups.iter().enumerate() {
        writeln!(text, "*ELSET, ELSET={}", group.label()).unwrap();
        for (tag, ..) in elements(mesh)
            .iter()
            .filter(|element| element.4.contains(index))
        {
            writeln!(text, "{tag}").unwrap();
        }
    }
    text
}

fn vtk(mesh: &Mesh) -> String {
    let count = mesh.nodes.len();
    let mut text = format!(
        "# vtk DataFile Version 3.0\nsection\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {count} \
         double\n"
    );
    for node in &mesh.nodes {
        let at = node.position;
        writeln!(text, "{:?} {:?} {:?}", at.x, at.y, at.z).unwrap();
    }
    let all = elements(mesh);
    let size: usize = all.iter().map(|element| 1 + element.3.len()).sum();
    writeln!(text, "CELLS {} {size}", all.len()).unwrap();
    for (_, _, _, nodes, _) in &all {
        let nodes_text: String = nodes.iter().map(|node| format!(" {node}")).collect();
        writeln!(text, "{}{nodes_text}", nodes.len()).unwrap();
    }
    writeln!(text, "CELL_TYPES {}", all.len()).unwrap();
    for (_, _, kind, _, _) in &all {
        writeln!(text, "{kind}").unwrap();
    }
    writeln!(
        text,
        "CELL_DATA {}\nSCALARS group int\nLOOKUP_TABLE default",
        all.len()
    )
    .unwrap();
    for (.., groups) in &all {
        let tag = groups.first().map_or(0, |group| mesh.groups[group].tag);
        writeln!(text, "{tag}").unwrap();
    }
    text
}

/// The section file with the number of each group in place of its name.
fn by_number(text: &str, groups: &[PhysicalGroup]) -> String {
    let mut text = text.to_owned();
    for group in groups {
        let name = group.label();
        for key in ["group = ", "curve = ", "follow = "] {
            let number = match key {
                "follow = " => format!("\"{}\"", group.tag),
                _ => group.tag.to_string(),
            };
            let is_of = match key {
                "group = " => group.dimension == 2,
                _ => group.dimension == 1,
            };
            if is_of {
                text = text.replace(&format!("{key}\"{name}\""), &format!("{key}{number}"));
            }
        }
    }
    text
}

fn stiffness(folder: &Path, text: &str) -> [Matrix6<f64>; 2] {
    let file = folder.join("a.section.toml");
    std::fs::write(&file, text).unwrap();
    let read = input::read(&file).unwrap_or_else(|problems| panic!("{problems}"));
    let solution = analyze(&read.section).unwrap();
    [solution.stiffness, solution.mass]
}

/// The same nodes, cells and groups in another file: the same stiffness and mass, relative
/// to the diagonal. The order of the cells may differ, and with it round-off.
#[test]
fn sections_in_other_formats_are_the_same() {
    for name in CASES {
        let (mesh, text) = case(name);
        let folder = tempfile::tempdir().unwrap();
        let of = |file: &str, content: &str, text: &str| {
            std::fs::write(folder.path().join(file), content).unwrap();
            let old = format!("mesh = \"{name}.msh\"");
            assert!(text.contains(&old), "{name}");
            stiffness(
                folder.path(),
                &text.replace(&old, &format!("mesh = \"{file}\"")),
            )
        };
        let expected = of("a.msh", &gmsh::write(&mesh), &text);
        let numbered = by_number(&text, &mesh.groups);
        assert_ne!(numbered, text);
        for found in [
            of("a.inp", &abaqus(&mesh), &text),
            of("a.vtk", &vtk(&mesh), &numbered),
        ] {
            for (found, expected) in found.iter().zip(&expected) {
                let scale = expected.diagonal().map(f64::sqrt);
                for i in 0..6 {
                    for j in 0..6 {
                        let error = (found[(i, j)] - expected[(i, j)]).abs();
                        let error = error / (scale[i] * scale[j]);
                        assert!(error < 1e-12, "{name} ({i}, {j}): {error:e}");
                    }
                }
            }
        }
    }
}

/// The field file of the warping is a mesh with the names of the regions, in meters.
#[test]
fn a_result_of_the_program_is_a_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let section = "[units]\nlength = \"mm\"\nforce = \"N\"\n[material.a]\nyoung = 7e4\n\
        poisson = 0.3\ndensity = 0\n[[region]]\ngroup = \"section\"\nmaterial = \"a\"\n";
    let text = format!("mesh = \"a.msh\"\n{section}");
    let run = |words: &[&str]| {
        let words = words.iter().map(|word| std::ffi::OsString::from(*word));
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = section_analyzer::cli::run(words, &mut out, &mut err);
        assert_eq!(code, 0, "{}", String::from_utf8_lossy(&err));
    };
    let (mesh, file) = (at("a.msh"), at("a.section.toml"));
    let mesh = mesh.to_str().unwrap();
    let ellipse = [
        "x", "mesh", "ellipse", "--semi-y", "30", "--semi-z", "10", "--cells", "2",
    ];
    run(&[&ellipse[..], &["--out", mesh]].concat());
    let expected = stiffness(folder.path(), &text);
    let results = at("results");
    let results = results.to_str().unwrap();
    run(&[
        "x",
        "analyze",
        file.to_str().unwrap(),
        "--no-figures",
        "--out",
        results,
    ]);
    let text = text.replace("a.msh", "results/a.warping.vtu");
    let text = text.replace("\"mm\"", "\"m\"").replace("7e4", "7e10");
    let found = stiffness(folder.path(), &text);
    let scale = expected[0].diagonal().map(f64::sqrt);
    for i in 0..6 {
        for j in 0..6 {
            let error = found[0][(i, j)] - expected[0][(i, j)];
            assert!(
                error.abs() < 1e-12 * scale[i] * scale[j],
                "({i}, {j}) {error:e}"
            );
        }
    }
}

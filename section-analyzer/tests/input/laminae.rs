//! Laminates in section files.

use std::path::Path;

use section_analyzer::analysis::analyze;
use section_analyzer::input::{self, Input, InputWarning};
use section_analyzer::mesh::generate::Rectangle;
use shared_geom::gmsh;
use shared_geom::mesh::{CellKind, Line, LineKind, Mesh, Node, PhysicalGroup};

const SOUND: &str = r#"
mesh = "a.msh"
[units]
length = "mm"
[material.foam]
young = "1 GPa"
poisson = 0.3
density = "100 kg/m^3"
[material.glass]
e1 = "40 GPa"
e2 = "10 GPa"
e3 = "10 GPa"
g12 = "4 GPa"
g13 = "4 GPa"
g23 = "3.5 GPa"
nu12 = 0.3
nu13 = 0.3
nu23 = 0.4
density = "1900 kg/m^3"
[[region]]
group = "core"
material = "foam"
[[lamina]]
curve = "top"
plies = [
  { material = "glass", thickness = 1.0, fiber_angle = 45 },
  { material = "glass", thickness = "0.5 mm" },
]
[[lamina]]
curve = "bottom"
name = "lower"
material = "glass"
thickness = 2
"#;

fn core() -> Mesh {
    let rectangle = Rectangle {
        width: 100.0,
        height: 20.0,
        cells_y: 10,
        cells_z: 2,
        kind: CellKind::Quadrilateral8,
        name: "core".into(),
    };
    rectangle.generate().unwrap()
}

fn read(folder: &Path, mesh: &Mesh, text: &str) -> Result<Input, String> {
    std::fs::write(folder.join("a.msh"), gmsh::write(mesh)).unwrap();
    let file = folder.join("a.section.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file).map_err(|problems| {
        let folder = format!("{}/", folder.display());
        problems.to_string().replace(&folder, "")
    })
}

#[test]
fn plies_become_regions_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let input = read(folder.path(), &core(), SOUND).unwrap();
    let regions = &input.summary.regions;
    let names: Vec<_> = regions.iter().map(|region| region.group.as_str()).collect();
    assert_eq!(names, ["core", "top/1", "top/2", "lower"]);
    assert_eq!(regions[1].fiber_angle.to_string(), "45 deg");
    assert_eq!(regions[1].plane_angle.to_string(), "along top");
    assert_eq!(input.section.mesh.groups, names);
    let areas = input.summary.areas.regions.iter().map(|region| region.area);
    for (found, expected) in areas.zip([2000e-6, 100e-6, 50e-6, 200e-6]) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{found}");
    }
    assert_eq!(input.summary.warnings, []);
    // the bottom runs against y: its wall direction is pi, its normal is down
    let last = input.section.cells.last().unwrap();
    assert!((last.plane_angle.abs() - std::f64::consts::PI).abs() < 1e-12);
    analyze(&input.section).unwrap();
}

/// The name of a laminate stands for all its plies, in initial strains and in loads.
#[test]
fn the_name_of_a_laminate_is_that_of_its_plies() {
    let strain = "strain = [1e-3, 0, 0, 0, 0, 0]\n";
    let region = format!("[[initial_strain.cure.region]]\n{strain}");
    let volume = "[[load.own.volume]]\nforce = [0, 0, 1]\n";
    let text = |names: &[&str]| {
        let parts = names
            .iter()
            .map(|name| format!("{region}group = \"{name}\"\n{volume}region = \"{name}\"\n"));
        let parts: String = parts.collect();
        format!("{SOUND}[initial_strain.cure]\n[load.own]\n{parts}")
    };
    let folder = tempfile::tempdir().unwrap();
    let of = |names: &[&str]| read(folder.path(), &core(), &text(names));
    let (whole, plies) = (of(&["top"]).unwrap(), of(&["top/1", "top/2"]).unwrap());
    assert_eq!(whole.imposed, plies.imposed);
    assert_eq!(whole.distributed, plies.distributed);
    assert_eq!(whole.distributed[0].parts.len(), 2);
    let told = of(&["top", "top/2"]).unwrap_err();
    assert!(
        told.contains("initial strain \"cure\" has region \"top/2\" twice"),
        "{told}"
    );
}

/// A closed square of lines, of two or three nodes each.
fn square(is_quadratic: bool) -> Mesh {
    let mut mesh = Mesh::default();
    let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let cells = 4;
    for side in 0..4 {
        for step in 0..2 * cells {
            let part = step as f64 / (2 * cells) as f64;
            let (a, b): ([f64; 2], [f64; 2]) = (corners[side], corners[(side + 1) % 4]);
            let [x, y] = [0, 1].map(|i| 100.0 * (a[i] + part * (b[i] - a[i])));
            let tag = mesh.nodes.len() as u64 + 1;
            let position = [x, y, 0.0].into();
            mesh.nodes.push(Node { tag, position });
        }
    }
    let count = mesh.nodes.len();
    let kind = if is_quadratic {
        LineKind::Line3
    } else {
        LineKind::Line2
    };
    for i in 0..count / 2 {
        let node = |local: usize| ((2 * i + [0, 2, 1][local]) % count) as u32;
        let mut line = Line::new(i as u64 + 1, kind, 1, node);
        line.groups = 0.into();
        mesh.lines.push(line);
    }
    mesh.groups.push(PhysicalGroup {
        dimension: 1,
        tag: 7,
        name: None,
    });
    mesh
}

/// A mesh of lines only; its area is the length times the thickness, and no word is lost
/// about nodes in the middle of the wall.
#[test]
fn a_section_of_lines_only_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let (head, _) = SOUND.split_once("[[region]]").unwrap();
    let text = format!("{head}[[lamina]]\ncurve = 7\nmaterial = \"glass\"\nthickness = 4\n");
    for is_quadratic in [false, true] {
        let input = read(folder.path(), &square(is_quadratic), &text).unwrap();
        let area = input.summary.areas.total.area;
        assert!((area / 1600e-6 - 1.0).abs() < 1e-12, "{area}");
        let unused = |warning: &&InputWarning| matches!(warning, InputWarning::UnusedNodes { .. });
        // middles of sides that lines of two nodes do not have
        let found = input.summary.warnings.iter().find(unused);
        assert_eq!(found.is_none(), is_quadratic, "{found:?}");
        analyze(&input.section).unwrap();
    }
    // without the lamina it has no cells
    let told = read(folder.path(), &square(true), head).unwrap_err();
    assert!(
        told.contains("the mesh has no triangles or quadrilaterals"),
        "{told}"
    );
}

/// What is changed in the sound file, to what, and what is told.
const WRONG: &[[&str; 3]] = &[
    [
        "curve = \"top\"",
        "curve = \"tip\"",
        "error: a.section.toml:24: the mesh has no physical curve \"tip\"\n  \
         help: did you mean \"top\"? physical curves of the mesh: \"bottom\", \"right\", \
         \"top\", \"left\"",
    ],
    [
        "curve = \"top\"",
        "curve = \"core\"",
        "error: a.section.toml:24: the mesh has no physical curve \"core\"\n  \
         help: physical curves of the mesh: \"bottom\", \"right\", \"top\", \"left\"",
    ],
    [
        "thickness = 2",
        "thickness = 0",
        "error: a.section.toml:33: \"thickness\" is 0, expected a length greater than zero",
    ],
    [
        "thickness = \"0.5 mm\"",
        "thickness = \"-1 mm\"",
        "error: a.section.toml:27: \"thickness\" is the text \"-1 mm\", expected a length \
         greater than zero",
    ],
    [
        "material = \"glass\", thickness = 1.0",
        "material = \"glas\", thickness = 1.0",
        "error: a.section.toml:26: unknown material \"glas\" in region \"top/1\"\n  \
         help: did you mean \"glass\"?",
    ],
    [
        "name = \"lower\"",
        "side = \"centre\"",
        "error: a.section.toml:31: \"side\" is \"centre\", expected one of \"left\", \"right\", \
         \"center\"\n  help: did you mean \"center\"?",
    ],
    [
        "name = \"lower\"",
        "side = \"right\"",
        "error: a.section.toml:30: side = \"right\" puts the laminate of curve \"bottom\" \
         into the cells beside line 1 at (45, -10)\n  help: leave \"side\" out: on the \
         border of cells the laminate then lies on the other side",
    ],
    [
        "name = \"lower\"",
        "name = \"core\"",
        "error: a.section.toml:31: the name \"core\" of a lamina is taken by a surface or \
         another lamina\n  help: tables and reports go by it: give the lamina a \"name\" of \
         its own",
    ],
    [
        "name = \"lower\"",
        "plies = []",
        "error: a.section.toml:32: a lamina has \"plies\" and \"material\", expected one of \
         them",
    ],
    [
        "material = \"glass\"\nthickness = 2",
        "",
        "error: a.section.toml:29: a lamina has no plies\n  help: give \"material\" and \
         \"thickness\", or plies = [{ material = ..., thickness = ... }, ...]",
    ],
    [
        "material = \"glass\"\nthickness = 2",
        "plies = []",
        "error: a.section.toml:32: \"plies\" is an array of 0, expected at least one ply",
    ],
    [
        "curve = \"bottom\"",
        "curve = \"top\"",
        "error: a.section.toml:30: curve \"top\" has two laminates on one side of line 13 at \
         (-45, 10)\n  help: one [[lamina]] lists all its plies",
    ],
];

#[test]
fn wrong_laminae_are_told_with_line_and_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = core();
    for [from, to, expected] in WRONG {
        let text = SOUND.replacen(from, to, 1);
        assert_ne!(text, SOUND, "{from}");
        let told = read(folder.path(), &mesh, &text).unwrap_err();
        assert_eq!(told, *expected, "{to}");
    }
}

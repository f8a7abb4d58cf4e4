//! Laminates in section files.

use std::path::Path;

use section_analyzer::analysis::{Analysis, analyze};
use section_analyzer::input::{self, Input, InputWarning};
use section_analyzer::mesh::Bank;
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::section::Action;
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
    // the bottom has the direction -y: its wall direction is pi, its normal is down
    let last = input.section.cells.last().unwrap();
    assert!((last.plane_angle.abs() - std::f64::consts::PI).abs() < 1e-12);
    analyze(&input.section).unwrap();
}

/// The name of a laminate represents all its plies, in initial strains and in loads.
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
    let reported = of(&["top", "top/2"]).unwrap_err();
    assert!(
        reported.contains("initial strain \"cure\" has region \"top/2\" twice"),
        "{reported}"
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

/// A mesh of lines only; its area is the length times the thickness, and nodes in the
/// middle of the wall are not reported.
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
    let reported = read(folder.path(), &square(true), head).unwrap_err();
    assert!(
        reported.contains(
            "the mesh has no triangles or quadrilaterals, expected at least one\n  help: mesh the \
             surfaces (gmsh -2) and put them in a physical surface; or, for thin walls along the \
             curves \"7\", give their plies by [[lamina]]"
        ),
        "{reported}"
    );
}

/// Changed text of the sound file, its replacement, and the message.
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
         help: \"core\" is a physical surface; give a physical curve",
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
        "error: a.section.toml:30: side = \"right\" puts the laminate of curve \"bottom\" into \
         the cells next to line 1 at (45, -10)\n  help: give side = \"left\", the one without \
         cells",
    ],
    [
        "name = \"lower\"",
        "name = \"core\"",
        "error: a.section.toml:31: the name \"core\" of a lamina is already the name of a surface \
         or another lamina\n  help: tables and reports use it: give the lamina its own \"name\"",
    ],
    [
        // neither has a curve: they have no names that could be equal
        "curve = \"top\"\nplies",
        "plies",
        "error: a.section.toml:23: [[lamina]] number 1 has no \"curve\", expected the name of a \
         physical curve",
    ],
    [
        "curve = \"bottom\"\nname = \"lower\"\n",
        "curve = \"core\"\n",
        "error: a.section.toml:30: the mesh has no physical curve \"core\"\n  \
         help: \"core\" is a physical surface; give a physical curve",
    ],
    [
        "curve = \"top\"",
        "curve = [\"top\"]",
        "error: a.section.toml:24: \"curve\" is an array of 1, expected the name of a physical \
         curve",
    ],
    [
        "group = \"core\"",
        "group = \"top\"",
        "error: a.section.toml:2: physical surface \"core\" (20 cells) has no region\n  \
         help: add [[region]] with group = \"core\" and its material\n\
         error: a.section.toml:21: the mesh has no physical surface \"top\"\n  help: \"top\" is a \
         physical curve; give a physical surface, or put plies along the curve by [[lamina]]",
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
fn wrong_laminae_are_reported_with_line_and_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = core();
    for [from, to, expected] in WRONG {
        let text = SOUND.replacen(from, to, 1);
        assert_ne!(text, SOUND, "{from}");
        let reported = read(folder.path(), &mesh, &text).unwrap_err();
        assert_eq!(reported, *expected, "{to}");
    }
}

/// Sides and cells of a traction of the first load, if they lie on the surface.
fn free_sides(input: &Input) -> usize {
    let Action::Traction { sides, .. } = &input.distributed[0].parts[0].action else {
        panic!("a traction")
    };
    assert!(sides.iter().all(|side| side.bank != Bank::Both));
    sides.len()
}

/// The outer face of facings and both faces of a centered wall accept a pressure; the
/// force of a pressure on one face is the pressure times its length.
#[test]
fn faces_of_laminae_take_a_pressure() {
    let folder = tempfile::tempdir().unwrap();
    let pressed = |curve: &str| {
        format!("[load.p]\n[[load.p.traction]]\ncurve = \"{curve}\"\npressure = \"1 MPa\"\n")
    };
    for (curve, force) in [("top/outer", -1e5), ("lower/outer", 1e5)] {
        let text = format!("{SOUND}{}", pressed(curve));
        let input = read(folder.path(), &core(), &text).unwrap();
        assert_eq!(free_sides(&input), 10);
        let analysis = Analysis::new(&input.section).unwrap();
        let state = analysis.distributed(&[&input.distributed[0]]).unwrap();
        let found = state[0].force_per_length;
        // 1 MPa on a face of 0.1 m
        assert!((found[2] / force - 1.0).abs() < 1e-12, "{found}");
        assert!(found[1].abs() < 1e-12 * found[2].abs(), "{found}");
    }
    let (head, _) = SOUND.split_once("[[region]]").unwrap();
    let wall = format!("{head}[[lamina]]\ncurve = 7\nname = \"w\"\nmaterial = \"glass\"\n");
    // clockwise: the left is outside; pressures on it are in equilibrium
    for (side, names) in [
        ("center", ["w/left", "w/right"]),
        ("left", ["w/outer", "7"]),
    ] {
        for name in names {
            let text = format!("{wall}thickness = 4\nside = \"{side}\"\n{}", pressed(name));
            let input = read(folder.path(), &square(true), &text).unwrap();
            assert_eq!(free_sides(&input), 16);
        }
    }
    // the line itself is inside, or not a side at all
    let reported = read(
        folder.path(),
        &core(),
        &format!("{SOUND}{}", pressed("top")),
    )
    .unwrap_err();
    assert_eq!(
        reported,
        "error: a.section.toml:36: curve \"top\" has cells on both sides of line 13, \
         expected a pressure on a surface\n  help: the curve has a laminate: give its face, \
         \"top/outer\""
    );
    let text = format!("{wall}thickness = 4\n{}", pressed("7"));
    let reported = read(folder.path(), &square(true), &text).unwrap_err();
    assert!(
        reported
            .ends_with("help: the curve has a laminate: give its faces, \"w/left\" or \"w/right\""),
        "{reported}"
    );
}

/// A lamina that cannot be made does not hide other problems: an unknown curve and an
/// unknown region are reported; faces and plies of the laminae are not reported as
/// unknown.
#[test]
fn wrong_laminae_hide_no_other_error() {
    let folder = tempfile::tempdir().unwrap();
    let loads = "[load.p]\n[[load.p.traction]]\ncurve = \"topp\"\npressure = 1\n\
                 [[load.p.traction]]\ncurve = \"lower/outer\"\npressure = 1\n\
                 [[load.p.volume]]\nregion = \"top/1\"\nforce = [1, 0, 0]\n\
                 [[load.p.volume]]\nregion = \"coore\"\nforce = [1, 0, 0]\n";
    let sound = format!("{SOUND}{loads}");
    let own = "name = \"lower\"";
    let thick = "expected a length greater than zero";
    let mut tilted = core();
    tilted.nodes[0].position.z = 5.0;
    for (mesh, from, to, reported_too) in [
        (
            core(),
            own,
            "name = \"lower\"\nside = \"right\"",
            "puts the laminate",
        ),
        (core(), "thickness = 2", "thickness = 0", thick),
        (
            core(),
            "\"bottom\"",
            "\"botom\"",
            "no physical curve \"botom\"",
        ),
        (
            core(),
            "\"bottom\"",
            "\"left\"",
            "layers cannot be joined one by one",
        ),
        (tilted, own, own, "the mesh is not plane"),
    ] {
        let reported = read(folder.path(), &mesh, &sound.replacen(from, to, 1)).unwrap_err();
        let unknown = [
            "physical curve \"topp\"",
            "physical surface \"coore\"",
            reported_too,
        ];
        assert!(
            unknown.iter().all(|text| reported.contains(text)),
            "{reported}"
        );
        let errors = reported.lines().filter(|line| line.starts_with("error"));
        assert_eq!(errors.count(), 3, "{reported}");
    }
    // the face of a lamina that cannot be made may be followed
    let follows = SOUND
        .replacen("thickness = 2", "thickness = 0", 1)
        .replacen(
            "material = \"foam\"",
            "material = \"foam\"\nplane_angle = { follow = \"lower/outer\" }",
            1,
        );
    let reported = read(folder.path(), &core(), &follows).unwrap_err();
    let errors = reported.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 1, "{reported}");
}

/// The rows of a table of temperature rises: the tags of the cells of the mesh, and for
/// plies the tag of their line, or their own.
#[test]
fn a_line_represents_its_plies_in_tables_of_rises() {
    let folder = tempfile::tempdir().unwrap();
    let glass = "nu23 = 0.4\n";
    let text = SOUND.replacen(glass, "nu23 = 0.4\nexpansion = \"1e-5 1/K\"\n", 1);
    let text = format!("{text}[temperature.hot]\ntable = \"rises.csv\"\n");
    let mesh = core();
    let mut rows = "cell,rise\n".to_owned();
    for cell in &mesh.cells {
        rows += &format!("{},1\n", cell.tag);
    }
    let without_lines = rows.clone();
    let is_wall = |name: &str, line: &Line| line.groups.contains(mesh.group(1, name).unwrap());
    let walls = mesh
        .lines
        .iter()
        .filter(|l| is_wall("top", l) || is_wall("bottom", l));
    for line in walls.clone() {
        rows += &format!("{},{}\n", line.tag, 100 + line.tag);
    }
    std::fs::write(folder.path().join("rises.csv"), &rows).unwrap();
    let input = read(folder.path(), &mesh, &text).unwrap();
    let found = input.imposed[0].cells.iter().zip(&input.section.mesh.cells);
    let mut plies = 0;
    for (strain, cell) in found.skip(mesh.cells.len()) {
        let [y, z] = input.section.mesh.middle(cell);
        let mut lines = walls.clone();
        let line = lines.find(|line| {
            let middle = mesh.nodes[line.nodes()[2] as usize].position * 1e-3;
            (middle.x - y).abs() < 1e-9 && middle.y * z > 0.0
        });
        let rise = 100.0 + line.unwrap().tag as f64;
        assert!((strain.at_origin[0] / (1e-5 * rise) - 1.0).abs() < 1e-12);
        plies += 1;
    }
    assert_eq!(plies, 30);
    // the row of a ply cell has priority over the row of its line, which is also allowed
    let cells = input.section.mesh.cells.iter().skip(mesh.cells.len());
    let own: String = cells.map(|cell| format!("{},7\n", cell.tag)).collect();
    std::fs::write(folder.path().join("rises.csv"), format!("{rows}{own}")).unwrap();
    let input = read(folder.path(), &mesh, &text).unwrap();
    for strain in &input.imposed[0].cells[mesh.cells.len()..] {
        assert!((strain.at_origin[0] / 7e-5 - 1.0).abs() < 1e-12);
    }
    // one line is missing, one is not in the walls
    let rows = format!("{without_lines}1,5\n");
    std::fs::write(folder.path().join("rises.csv"), rows).unwrap();
    let reported = read(folder.path(), &mesh, &text).unwrap_err();
    assert!(
        reported.contains(
            "rise table \"rises.csv\" has 21 rows, expected 40, one for each cell of the mesh and \
             each line with plies; no rise for cells or lines 2, 3, 4, 5, 6 and 14 more"
        ),
        "{reported}"
    );
}

/// Laminates without enough space are reported by their curves and lines: the tags of
/// their cells are in no file.
#[test]
fn cells_of_plies_are_reported_by_their_lines() {
    let folder = tempfile::tempdir().unwrap();
    let (head, _) = SOUND.split_once("[[region]]").unwrap();
    // two walls, closer than their thickness, joined by a third
    let mut mesh = Mesh::default();
    for (x, y) in [
        (0.0, 0.0),
        (10.0, 0.0),
        (20.0, 0.0),
        (20.0, 10.0),
        (10.0, 2.0),
        (0.0, 2.0),
    ] {
        let tag = mesh.nodes.len() as u64 + 1;
        let position = [x, y, 0.0].into();
        mesh.nodes.push(Node { tag, position });
    }
    for i in 0..5_u32 {
        let mut line = Line::new(u64::from(i) + 1, LineKind::Line2, 1, |local| {
            i + local as u32
        });
        line.groups = 0.into();
        mesh.lines.push(line);
    }
    mesh.groups.push(PhysicalGroup {
        dimension: 1,
        tag: 7,
        name: Some("wall".into()),
    });
    let text = format!("{head}[[lamina]]\ncurve = \"wall\"\nmaterial = \"glass\"\nthickness = 3\n");
    let reported = read(folder.path(), &mesh, &text).unwrap_err();
    println!("{reported}");
    assert!(
        reported.starts_with(
            "error: a.section.toml:21: the laminate of curve \"wall\" overlaps itself at "
        ),
        "{reported}"
    );
}

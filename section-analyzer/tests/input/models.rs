//! Models of VABS and BECAS, converted by the program: the stiffness of materials turned by
//! the definitions of these tools, and published results.

use std::ffi::OsString;
use std::fmt::Write;
use std::path::Path;

use nalgebra::{Matrix3, Matrix6, Rotation3, Vector3};
use section_analyzer::analysis::analyze;
use section_analyzer::{cli, input};
use shared_geom::gmsh;
use shared_geom::mesh::{GroupSet, PhysicalGroup};
use shared_geom::mesh_file::{self, BECAS_FILES};

const FUZZ: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/corpus");

/// The program's exit code and its two outputs.
fn run(arguments: &[&OsString]) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let program = OsString::from("section-analyzer");
    let all = std::iter::once(program).chain(arguments.iter().map(|&word| word.clone()));
    let code = cli::run(all, &mut out, &mut err);
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (code, text(out), text(err))
}

/// Stiffness and mass of a section file.
fn matrices(file: &Path) -> [Matrix6<f64>; 2] {
    let read = input::read(file).unwrap_or_else(|problems| panic!("{problems}"));
    let solution = analyze(&read.section).unwrap();
    [solution.stiffness, solution.mass]
}

/// Stiffness and mass of the section that `convert` makes of a model, and its output.
fn converted(model: &Path) -> ([Matrix6<f64>; 2], String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("made.section.toml");
    let words = ["convert".into(), model.into(), file.clone().into()];
    let (code, out, err) = run(&words.each_ref());
    assert_eq!((code, err.as_str()), (0, ""));
    (matrices(&file), out)
}

/// The largest difference of two matrices, relative to the diagonal of the second.
fn difference(found: &Matrix6<f64>, expected: &Matrix6<f64>) -> f64 {
    let scale = expected.diagonal().map(f64::sqrt);
    let difference = found - expected;
    let relative = difference.map_with_location(|i, j, value| value / (scale[i] * scale[j]));
    relative.amax()
}

/// Components of the order 11, 22, 33, 23, 13, 12.
const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];

/// A stiffness in axes turned by `axes`, whose columns are the material axes: the sum over
/// all components of the tensor.
fn turned(stiffness: &Matrix6<f64>, axes: &Matrix3<f64>) -> Matrix6<f64> {
    let at = |i: usize, j: usize| {
        let pair = (i.min(j), i.max(j));
        PAIRS.iter().position(|known| *known == pair).unwrap()
    };
    Matrix6::from_fn(|row, column| {
        let ((i, j), (k, l)) = (PAIRS[row], PAIRS[column]);
        let mut sum = 0.0;
        for a in 0..3 {
            for b in 0..3 {
                for c in 0..3 {
                    for d in 0..3 {
                        let turn = axes[(i, a)] * axes[(j, b)] * axes[(k, c)] * axes[(l, d)];
                        sum += turn * stiffness[(at(a, b), at(c, d))];
                    }
                }
            }
        }
        sum
    })
}

/// The stiffness of E1, E2, E3, G12, G13, G23, nu12, nu13, nu23.
fn orthotropic([e1, e2, e3, g12, g13, g23, nu12, nu13, nu23]: [f64; 9]) -> Matrix6<f64> {
    let mut compliance = Matrix6::zeros();
    let diagonal = [e1, e2, e3, g23, g13, g12];
    for (index, modulus) in diagonal.into_iter().enumerate() {
        compliance[(index, index)] = 1.0 / modulus;
    }
    for (i, j, value) in [(0, 1, nu12 / e1), (0, 2, nu13 / e1), (1, 2, nu23 / e2)] {
        compliance[(i, j)] = -value;
        compliance[(j, i)] = -value;
    }
    compliance.try_inverse().unwrap()
}

/// The materials of the three cells of the seeds, in material axes, and the angles of the
/// fiber and of the plane \[deg\].
const FIRST: [f64; 9] = [140.0, 10.0, 9.0, 5.0, 4.0, 3.0, 0.3, 0.25, 0.4];
const ANGLES: [[f64; 2]; 3] = [[25.0, 40.0], [-35.0, 200.0], [15.0, -70.0]];

/// A native section of the mesh of the seeds, each cell with a full stiffness in section
/// axes and without angles; `head` goes before the materials.
fn native(folder: &Path, head: &str, cells: [(Matrix6<f64>, f64); 3]) -> [Matrix6<f64>; 2] {
    let seed = std::fs::read(format!("{FUZZ}/mesh_file/section.sg")).unwrap();
    let mut mesh = mesh_file::read(&seed, "a.sg").unwrap();
    mesh.groups.clear();
    let mut text = format!("mesh = \"a.msh\"\nunits = \"SI\"\n{head}\n");
    for (index, (stiffness, density)) in cells.into_iter().enumerate() {
        let name = format!("c{index}");
        let rows = stiffness.row_iter().map(|row| {
            let row: Vec<f64> = row.iter().copied().collect();
            format!("{row:?}")
        });
        let rows: Vec<_> = rows.collect();
        writeln!(
            text,
            "[material.{name}]\nstiffness = [{}]\ndensity = {density:?}\n[[region]]\ngroup = \
             \"{name}\"\nmaterial = \"{name}\"",
            rows.join(",")
        )
        .unwrap();
        mesh.cells[index].groups = GroupSet::from(index);
        mesh.groups.push(PhysicalGroup {
            dimension: 2,
            tag: index as i32 + 1,
            name: Some(name),
        });
    }
    std::fs::write(folder.join("a.msh"), gmsh::write(&mesh)).unwrap();
    std::fs::write(folder.join("a.section.toml"), text).unwrap();
    matrices(&folder.join("a.section.toml"))
}

/// VABS turns the wall about x1 by theta1, then the material about the new y3 by theta3, and
/// lists the full stiffness in the order 11, 12, 13, 22, 23, 33; the beam is curved and
/// oblique. The tensors are turned here, without Helicoid's angles: equal to round-off.
#[test]
fn materials_of_vabs_are_turned_as_vabs_does() {
    let folder = tempfile::tempdir().unwrap();
    let axes = |[fiber, plane]: [f64; 2]| {
        let plane = Rotation3::from_axis_angle(&Vector3::x_axis(), plane.to_radians());
        let fiber = Rotation3::from_axis_angle(&Vector3::z_axis(), fiber.to_radians());
        (plane * fiber).into_inner()
    };
    // the terms of the seed: 11 to 66 on the diagonal, 1.2 and so on beside it
    let of_vabs = Matrix6::from_fn(|i, j| {
        let (row, column) = (i.min(j) + 1, i.max(j) + 1);
        if i == j {
            11.0 * row as f64
        } else {
            row as f64 + 0.1 * column as f64
        }
    });
    let order = [0, 3, 5, 4, 2, 1];
    let second = Matrix6::from_fn(|i, j| of_vabs[(order[i], order[j])]);
    let first = orthotropic(FIRST);
    let cells = [(first, 1.6), (first, 1.6), (second, 1.2)];
    let head = "[initial_curvature]\ncurvature = [\"0.1 rad/m\", 0, \"-0.2 rad/m\"]\n\
        slope = [0.8, 0.6, 0]\n";
    let cells = std::array::from_fn(|i| (turned(&cells[i].0, &axes(ANGLES[i])), cells[i].1));
    let expected = native(folder.path(), head, cells);
    let (found, out) = converted(Path::new(&format!("{FUZZ}/mesh_file/section.sg")));
    for (found, expected) in found.iter().zip(&expected) {
        assert!(difference(found, expected) < 1e-10, "{found}{expected}");
    }
    assert!(out.contains("2 materials, 3 regions"), "{out}");
}

/// BECAS, with z along the beam, turns the directions of the material about y by the fiber
/// angle, then about z by the plane angle: the fiber is z, its transverse x, the normal y at
/// first. Helicoid's axes are BECAS' z, x, y.
#[test]
fn materials_of_becas_are_turned_as_becas_does() {
    let folder = tempfile::tempdir().unwrap();
    let to_ours = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    let axes = |[fiber, plane]: [f64; 2]| {
        let plane = Rotation3::from_axis_angle(&Vector3::z_axis(), plane.to_radians());
        let fiber = Rotation3::from_axis_angle(&Vector3::y_axis(), fiber.to_radians());
        let directions = Matrix3::from_columns(&[Vector3::z(), Vector3::x(), Vector3::y()]);
        to_ours * (plane * fiber).into_inner() * directions
    };
    let second = [70.0, 70.0, 70.0, 27.0, 27.0, 27.0, 0.3, 0.3, 0.3];
    let cells = [(FIRST, 1.6), (FIRST, 1.6), (second, 2.7)];
    let cells = std::array::from_fn(|i| {
        let (constants, density) = cells[i];
        (turned(&orthotropic(constants), &axes(ANGLES[i])), density)
    });
    let expected = native(folder.path(), "", cells);
    let text = std::fs::read_to_string(format!("{FUZZ}/becas/section.txt")).unwrap();
    for (name, part) in BECAS_FILES.iter().zip(text.split("====\n")) {
        std::fs::write(folder.path().join(name), part).unwrap();
    }
    let (found, _) = converted(folder.path());
    for (found, expected) in found.iter().zip(&expected) {
        assert!(difference(found, expected) < 1e-10, "{found}{expected}");
    }
}

/// The box CAS1 of the examples of VABS, as VABS' input in the old format: 50 x 6 elements
/// with middle nodes on two of their four sides, [15]6 in the caps and [15/-15]3 in the
/// webs.
fn cas1() -> String {
    let corner = |ring: usize, corner: usize| {
        let (y, z) = (0.4465 + 0.005 * ring as f64, 0.235 + 0.005 * ring as f64);
        [[y, z], [y, -z], [-y, -z], [-y, z]][corner % 4]
    };
    // nodes on each wall: right, lower, left, upper; clockwise from the upper right corner
    let walls = [(0, 20), (20, 50), (50, 70), (70, 100)];
    let wall_of = |at: usize| walls.iter().position(|wall| at < wall.1).unwrap();
    let mut text = "0 0\n1 0 0\n1 0 0 0\n0 0 0\n700 300 1\n".to_owned();
    for ring in 0..7 {
        for at in 0..100 {
            let wall = wall_of(at);
            let (first, last) = walls[wall];
            let part = (at - first) as f64 / (last - first) as f64;
            let [from, to] = [corner(ring, wall), corner(ring, wall + 1)];
            let [y, z] = [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]));
            writeln!(text, "{} {y:.10} {z:.10}", 100 * ring + at + 1).unwrap();
        }
    }
    let mut layups = String::new();
    for station in 0..50 {
        for ring in 0..6 {
            let node = |ring: usize, at: usize| 100 * ring + at % 100 + 1;
            let at = 2 * station;
            let tag = 6 * station + ring + 1;
            writeln!(
                text,
                "{tag} {} {} {} {} {} 0 {} 0 0",
                node(ring, at),
                node(ring, at + 2),
                node(ring + 1, at + 2),
                node(ring + 1, at),
                node(ring, at + 1),
                node(ring + 1, at + 1)
            )
            .unwrap();
            let turns = if ring % 2 == 0 { 1 } else { -1 };
            let (theta3, theta1) = match wall_of(at) {
                0 => (15 * turns, 270),
                1 => (15, 180),
                2 => (-15 * turns, 90),
                _ => (-15, 0),
            };
            let nine = format!(" {theta1}").repeat(9);
            writeln!(layups, "{tag} 1 {theta3}{nine}").unwrap();
        }
    }
    text + &layups + "1 1\n20.59e6 1.42e6 1.42e6\n.87e6 .87e6 .696e6\n.42 .42 .42\n1.0\n"
}

/// Results of VABS 4.1 for CAS1, published by the authors of sgio as a test of their reader.
/// VABS' elements are linear through the ply and quadratic along the wall; here they are
/// quadratic both ways, which makes the section a little softer.
#[test]
fn the_box_cas1_of_vabs() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cas1.dat");
    std::fs::write(&file, cas1()).unwrap();
    let ([stiffness, mass], out) = converted(&file);
    assert!(out.contains("300 nodes were added"), "{out}");
    let mut expected = Matrix6::zeros();
    for (row, column, value) in [
        (0, 0, 1.368_174_318_4e6),
        (0, 1, -1.841_930_822_7e5),
        (0, 2, -1.436_940_745_4e2),
        (1, 1, 8.856_220_750_5e4),
        (1, 2, 7.838_101_246_8e1),
        (2, 2, 3.877_794_286_2e4),
        (3, 3, 1.695_927_446_3e4),
        (3, 4, 1.761_192_962_4e4),
        (3, 5, -3.506_024_315_5e2),
        (4, 4, 5.912_476_688_1e4),
        (4, 5, -3.704_527_490_8e2),
        (5, 5, 1.414_715_284_8e5),
    ] {
        expected[(row, column)] = value;
        expected[(column, row)] = value;
    }
    let error = difference(&stiffness, &expected);
    // 2.0e-4, the bending stiffness about z
    assert!(error < 2.5e-4, "{error:e}\n{stiffness}");
    let inertia = [
        0.08538,
        0.08538,
        0.08538,
        1.443_298_383_5e-2,
        4.097_153_5e-3,
        1.033_583_033_5e-2,
    ];
    for (index, value) in inertia.into_iter().enumerate() {
        assert!((mass[(index, index)] / value - 1.0).abs() < 1e-9, "{mass}");
    }
}

/// A square of side 0.1 in 10 x 10 elements with 4 nodes; `layup` returns the material, the
/// fiber angle and the plane angle of an element by its column.
fn square(folder: &Path, materials: &str, layup: impl Fn(usize) -> String) {
    let mut texts = [(); 3].map(|()| String::new());
    for row in 0..=10 {
        for column in 0..=10 {
            let at = [column, row].map(|step| 0.01 * step as f64 - 0.05);
            writeln!(texts[0], "{} {} {}", 11 * row + column + 1, at[0], at[1]).unwrap();
        }
    }
    for row in 0..10 {
        for column in 0..10 {
            let (tag, node) = (10 * row + column + 1, 11 * row + column + 1);
            writeln!(
                texts[1],
                "{tag} {node} {} {} {}",
                node + 1,
                node + 12,
                node + 11
            )
            .unwrap();
            writeln!(texts[2], "{tag} {}", layup(column)).unwrap();
        }
    }
    let [nodes, elements, layups] = texts;
    let texts = [nodes.as_str(), &elements, &layups, materials];
    for (name, text) in BECAS_FILES.iter().zip(texts) {
        std::fs::write(folder.join(name), text).unwrap();
    }
}

/// The folder of BECAS, and its file of nodes, as the mesh of a section file: the stiffness of the
/// section that `convert` makes. A missing file is named.
#[test]
fn models_of_becas_are_meshes_of_section_files() {
    let folder = tempfile::tempdir().unwrap();
    let becas = folder.path().join("becas");
    std::fs::create_dir(&becas).unwrap();
    let ply = "480 120 120 60 50 60 0.19 0.26 0.19 1\n";
    square(&becas, &ply.repeat(2), |column| {
        format!("{} 30 0", 1 + column / 5)
    });
    let file = folder.path().join("made.section.toml");
    let words = ["convert".into(), becas.clone().into(), file.clone().into()];
    assert_eq!(run(&words.each_ref()).0, 0);
    let [expected, _] = matrices(&file);
    let text = std::fs::read_to_string(&file).unwrap();
    for mesh in ["becas", "becas/N2D.in", "becas/EMAT.in"] {
        let text = text.replace("\"made.msh\"", &format!("{mesh:?}"));
        assert!(text.contains(mesh));
        std::fs::write(&file, text).unwrap();
        assert!(difference(&matrices(&file)[0], &expected) < 1e-12, "{mesh}");
    }
    std::fs::remove_file(becas.join("E2D.in")).unwrap();
    let problems = input::read(&file).expect_err("a missing file").to_string();
    assert!(
        problems.contains("E2D.in") && problems.contains("no such file"),
        "{problems}"
    );
}

/// A model with an element whose nodes go around the other way is converted, and a remark names the element: its section
/// cannot be analyzed. Without it there is no remark.
#[test]
fn an_inverted_element_of_a_model_is_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let becas = folder.path().join("becas");
    std::fs::create_dir(&becas).unwrap();
    square(&becas, "480 120 120 60 50 60 0.19 0.26 0.19 1\n", |_| {
        "1 0 0".to_owned()
    });
    let convert = |name: &str| {
        let file = folder.path().join(name);
        let words = ["convert".into(), becas.clone().into(), file.clone().into()];
        (run(&words.each_ref()), file)
    };
    let ((code, out, err), _) = convert("good.section.toml");
    assert_eq!(
        (code, err.as_str(), out.contains("remark")),
        (0, "", false),
        "{out}"
    );
    let elements = becas.join("E2D.in");
    let text = std::fs::read_to_string(&elements).unwrap();
    let (good, inverted) = ("\n23 25 26 37 36\n", "\n23 25 36 37 26\n");
    assert!(text.contains(good));
    std::fs::write(&elements, text.replace(good, inverted)).unwrap();
    let ((code, out, err), file) = convert("bad.section.toml");
    let shown = out + &err;
    assert_eq!(code, 0, "{shown}");
    assert!(
        shown.contains("the section cannot be analyzed: cell 23"),
        "{shown}"
    );
    let problems = input::read(&file)
        .expect_err("an inverted cell")
        .to_string();
    assert!(problems.contains("cell 23"), "{problems}");
}

/// Sections S2 and S3 of the users' guide of BECAS, on its meshes of 10 x 10 elements with 4
/// nodes: the published digits. Rows in BECAS' order: shear x, shear y, axial, bending x,
/// bending y, torsion; the fiber of S3 is along the beam, and across it along x.
#[test]
fn squares_of_the_guide_of_becas() {
    const OURS: [usize; 6] = [1, 2, 0, 4, 5, 3];
    let isotropic = "100 100 100 41.6666666666667 41.6666666666667 41.6666666666667 0.2 0.2 0.2 1\n\
        10 10 10 4.16666666666667 4.16666666666667 4.16666666666667 0.2 0.2 0.2 1\n";
    let ply = "480 120 120 60 50 60 0.19 0.26 0.19 1\n";
    let s2 = |column: usize| format!("{} 0 0", 1 + column / 5);
    type Values<'a> = &'a [(usize, usize, f64, f64)];
    let s2_values: Values = &[
        (0, 0, 0.128, 5e-4),
        (1, 1, 0.192, 5e-4),
        (2, 2, 0.55, 5e-3),
        (3, 3, 4.59e-4, 5e-7),
        (4, 4, 4.59e-4, 5e-7),
        (5, 5, 2.77e-4, 5e-7),
        (1, 5, -3.93e-3, 5e-6),
        (2, 4, 1.13e-2, 5.001e-5),
    ];
    let along: Values = &[
        (0, 0, 0.5039, 5e-5),
        (1, 1, 0.4201, 5e-5),
        (2, 2, 4.8, 5e-2),
        (3, 3, 4.001e-3, 5e-7),
        (4, 4, 4.001e-3, 5e-7),
        (5, 5, 7.737e-4, 5e-8),
    ];
    let across: Values = &[
        (0, 0, 0.50202, 5e-6),
        (1, 1, 0.50406, 5e-6),
        (2, 2, 1.2, 5e-2),
        (3, 3, 1.0004e-3, 5e-8),
        (4, 4, 1.0002e-3, 5e-8),
        (5, 5, 8.5081e-4, 5e-9),
    ];
    let s3 = |angle: u32| move |_: usize| format!("1 {angle} 0");
    type Layup = Box<dyn Fn(usize) -> String>;
    let layups: [(&str, Layup, Values); 3] = [
        (isotropic, Box::new(s2), s2_values),
        (ply, Box::new(s3(0)), along),
        (ply, Box::new(s3(90)), across),
    ];
    for (materials, layup, values) in layups {
        let folder = tempfile::tempdir().unwrap();
        square(folder.path(), materials, layup);
        let ([stiffness, _], _) = converted(folder.path());
        for &(row, column, published, half_digit) in values {
            let found = stiffness[(OURS[row], OURS[column])];
            assert!(
                (found - published).abs() <= half_digit,
                "K[{row},{column}] = {found}, published {published}"
            );
        }
    }
}

#[test]
fn models_that_cannot_be_converted_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| OsString::from(folder.path().join(name));
    let words = |model: &str, more: &[&str]| {
        let mut words = vec!["convert".into(), path(model), path("a.section.toml")];
        words.extend(more.iter().map(OsString::from));
        run(&words.iter().collect::<Vec<_>>())
    };
    std::fs::write(
        folder.path().join("bad.sg"),
        "1 1\n1 0 0\n0 0 0 0\n3 1 1\n1 0 0\n",
    )
    .unwrap();
    let (code, _, err) = words("bad.sg", &[]);
    assert_eq!(code, 2);
    assert!(
        err.contains("bad.sg:5: the file ends before the last node\n  help: "),
        "{err}"
    );
    std::fs::create_dir(folder.path().join("becas")).unwrap();
    let (code, _, err) = words("becas", &[]);
    assert_eq!(code, 2);
    for name in BECAS_FILES {
        assert!(
            err.contains(&format!("{name}: cannot be read: no such file")),
            "{err}"
        );
    }
    let (code, _, err) = words("bad.sg", &["--length", "N"]);
    assert_eq!(code, 2);
    assert!(err.contains("--length"), "{err}");
    std::fs::write(folder.path().join("a.msh"), "").unwrap();
    std::fs::copy(
        format!("{FUZZ}/mesh_file/section.sg"),
        folder.path().join("good.sg"),
    )
    .unwrap();
    let (code, _, err) = words("good.sg", &[]);
    assert_eq!(code, 2);
    assert!(
        err.contains("a.msh\" exists already, expected the name of a new"),
        "{err}"
    );
    assert!(!folder.path().join("a.section.toml").exists());
    std::fs::remove_file(folder.path().join("a.msh")).unwrap();
    assert_eq!(words("good.sg", &["--length", "in", "--force", "lbf"]).0, 0);
    let text = std::fs::read_to_string(folder.path().join("a.section.toml")).unwrap();
    assert!(
        text.contains("length = \"in\"\nforce = \"lbf\"\n"),
        "{text}"
    );
}

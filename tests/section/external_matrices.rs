//! Sections given by their matrices: the blocks, or the stiffness of a slice of the beam
//! by three-dimensional elements, against the analysis of the same cells.
//!
//! The matrices are summed here from the shape functions, cell by cell, and are passed
//! through Matrix Market files with all their digits. Products of matrices replace
//! integrals of stresses: equal to the round-off of a section of order one, 1e-10.

use std::fmt::Write;
use std::path::Path;

use nalgebra::{DMatrix, Matrix6};
use section_analyzer::analysis::{
    Analysis, ExternalAnalysis, ExternalWarning, analyze, analyze_matrices,
};
use section_analyzer::element::{Line, NO_COLUMNS, cell_points, strain_at};
use section_analyzer::failure::Failure;
use section_analyzer::input::external;
use section_analyzer::material::{EngineeringConstants, section_stiffness};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::section::Section;
use section_analyzer::solution::SectionSolution;
use shared_geom::error::Explain;
use shared_geom::mesh::CellKind;

use crate::record;
use crate::sections::{isotropic, orthotropic, scaled_error, solved, uniform};

/// The source as named on the validation page.
const SELF: &str = "The same section by its cells";

const TOLERANCE: f64 = 1e-10;

const PLY: EngineeringConstants = EngineeringConstants {
    e1: 142.0,
    e2: 9.8,
    e3: 9.1,
    g12: 6.0,
    g13: 5.5,
    g23: 4.8,
    nu12: 0.3,
    nu13: 0.34,
    nu23: 0.42,
};

/// Plies at an angle, off the origin: every block is full.
fn bar(kind: CellKind) -> Section {
    let mesh = Rectangle {
        width: 1.0,
        height: 0.4,
        cells_y: 4,
        cells_z: 2,
        kind,
        name: "bar".into(),
    };
    let mesh = mesh.generate().expect("sound measures");
    let mut section = uniform(&mesh, orthotropic(PLY), 0.4);
    section.materials[0].density = 2.0;
    for [y, z] in &mut section.mesh.nodes {
        (*y, *z) = (*y + 0.3, *z - 0.1);
    }
    section
}

/// B1 and B0 of a cell at a point, 6 x 3 nodes, and the volume of the point.
struct Operators {
    b1: DMatrix<f64>,
    b0: DMatrix<f64>,
    volume: f64,
    /// Shape functions.
    n: Vec<f64>,
}

fn operators(section: &Section, cell: usize) -> Vec<Operators> {
    let line = Line::through(&section.initial_curvature, [0.0; 2], 1.0);
    let mesh = &section.mesh;
    let positions: Vec<_> = mesh.positions(&mesh.cells[cell]).collect();
    let points = cell_points(mesh.cells[cell].kind, &positions).map(|point| {
        let (mut b1, mut b0) = (
            DMatrix::zeros(6, 3 * positions.len()),
            DMatrix::zeros(6, 3 * positions.len()),
        );
        for node in 0..positions.len() {
            let mut unit = NO_COLUMNS;
            unit[node].fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
            let still = Matrix6::zeros();
            let of_rate = strain_at(&line, &point, Some(&unit), None, &still);
            let of_position = strain_at(&line, &point, None, Some(&unit), &still);
            b1.columns_mut(3 * node, 3)
                .copy_from(&of_rate.columns(0, 3));
            b0.columns_mut(3 * node, 3)
                .copy_from(&of_position.columns(0, 3));
        }
        Operators {
            b1,
            b0,
            volume: point.area * line.metric(point.y, point.z).volume,
            n: point.n[..positions.len()].to_vec(),
        }
    });
    points.collect()
}

/// The law of a cell, order yz yy zz xx xy xz.
fn law(section: &Section, cell: usize) -> Matrix6<f64> {
    let made_of = &section.cells[cell];
    let stiffness = section.materials[made_of.material].law.stiffness();
    section_stiffness(&stiffness, made_of.fiber_angle, made_of.plane_angle)
}

fn add(sum: &mut DMatrix<f64>, section: &Section, cell: usize, part: &DMatrix<f64>) {
    let n = 3 * section.mesh.nodes.len();
    let nodes = section.mesh.cells[cell].nodes();
    let own = 3 * nodes.len();
    // the unknowns of one face, or of two
    let index = |i: usize| n * (i / own) + 3 * nodes[i % own / 3] as usize + i % 3;
    for i in 0..part.nrows() {
        for j in 0..part.ncols() {
            sum[(index(i), index(j))] += part[(i, j)];
        }
    }
}

/// M, C, E.
fn blocks(section: &Section) -> [DMatrix<f64>; 3] {
    let n = 3 * section.mesh.nodes.len();
    let mut sums = [(); 3].map(|()| DMatrix::zeros(n, n));
    for cell in 0..section.mesh.cells.len() {
        let d = law(section, cell);
        for Operators { b1, b0, volume, .. } in operators(section, cell) {
            for (sum, (left, right)) in sums.iter_mut().zip([(&b1, &b1), (&b1, &b0), (&b0, &b0)]) {
                add(sum, section, cell, &(volume * left.transpose() * d * right));
            }
        }
    }
    sums
}

/// Stiffness and mass of a slice of the straight beam: each cell times a linear element
/// through the thickness, with two points of Gauss through it, or one.
fn slice(section: &Section, thickness: f64, points: usize) -> [DMatrix<f64>; 2] {
    let n = 6 * section.mesh.nodes.len();
    let (mut stiffness, mut mass) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    for cell in 0..section.mesh.cells.len() {
        let d = law(section, cell);
        let density = section.materials[section.cells[cell].material].density;
        for Operators { b1, b0, volume, n } in operators(section, cell) {
            for &(xi, weight) in shared_geom::quadrature::line(points) {
                let (one, two) = (0.5 * (1.0 - xi), 0.5 * (1.0 + xi));
                let volume = volume * weight * 0.5 * thickness;
                let columns = b1.ncols();
                let mut b = DMatrix::zeros(6, 2 * columns);
                b.columns_mut(0, columns)
                    .copy_from(&(one * &b0 - &b1 / thickness));
                b.columns_mut(columns, columns)
                    .copy_from(&(two * &b0 + &b1 / thickness));
                add(
                    &mut stiffness,
                    section,
                    cell,
                    &(volume * b.transpose() * d * &b),
                );
                let mut shape = DMatrix::zeros(3, 2 * columns);
                for (node, value) in n.iter().enumerate() {
                    for axis in 0..3 {
                        shape[(axis, 3 * node + axis)] = one * value;
                        shape[(axis, columns + 3 * node + axis)] = two * value;
                    }
                }
                add(
                    &mut mass,
                    section,
                    cell,
                    &(density * volume * shape.transpose() * &shape),
                );
            }
        }
    }
    [stiffness, mass]
}

/// The text of a Matrix Market file, in units of `unit`, with all digits.
fn market(matrix: &DMatrix<f64>, unit: f64) -> String {
    market_of(matrix, unit, 17)
}

/// As [`market`], with `digits` digits.
fn market_of(matrix: &DMatrix<f64>, unit: f64, digits: usize) -> String {
    let mut text = String::from("%%MatrixMarket matrix coordinate real general\n");
    let mut entries = String::new();
    let mut count = 0;
    for j in 0..matrix.ncols() {
        for i in 0..matrix.nrows() {
            if matrix[(i, j)] != 0.0 {
                let value = matrix[(i, j)] / unit;
                writeln!(entries, "{} {} {value:.*e}", i + 1, j + 1, digits - 1).expect("text");
                count += 1;
            }
        }
    }
    writeln!(text, "{} {} {count}", matrix.nrows(), matrix.ncols()).expect("text");
    text + &entries
}

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).expect("a folder to write to");
}

fn write_nodes(folder: &Path, section: &Section, unit: f64) {
    let mut text = String::from("node,y,z\n");
    for (tag, [y, z]) in section.mesh.node_tags.iter().zip(&section.mesh.nodes) {
        writeln!(text, "{tag},{:e},{:e}", y / unit, z / unit).expect("text");
    }
    write(folder, "nodes.csv", &text);
}

fn solved_from(folder: &Path, text: &str) -> Result<SectionSolution, Failure> {
    write(folder, "bar.matrices.toml", text);
    let input = external::read(&folder.join("bar.matrices.toml"));
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    analyze_matrices(&input.section)
}

/// Blocks of straight and of curved beams.
#[test]
fn blocks_give_the_section_of_their_cells() {
    for curvature in [[0.0; 3], [0.3, -0.2, 0.4]] {
        let mut section = bar(CellKind::Quadrilateral8);
        section.initial_curvature.curvature = curvature.into();
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path();
        write_nodes(path, &section, 1.0);
        for (name, block) in ["m.mtx", "c.mtx", "e.mtx"]
            .into_iter()
            .zip(blocks(&section))
        {
            write(path, name, &market(&block, 1.0));
        }
        let written = curvature.map(|k: f64| format!("{k} rad/m"));
        let text = format!(
            "units = \"SI\"\nnodes = \"nodes.csv\"\n[initial_curvature]\ncurvature = {written:?}\n\
             [matrices]\nm = \"m.mtx\"\nc = \"c.mtx\"\ne = \"e.mtx\"\n"
        );
        let found = solved_from(path, &text).expect("sound blocks");
        let expected = analyze(&section).expect("a sound section");
        let error = scaled_error(&found.stiffness, &expected.stiffness);
        let case = if curvature == [0.0; 3] {
            "straight"
        } else {
            "curved"
        };
        println!("blocks, {case}: {error:.1e}");
        record::largest(
            SELF,
            &format!("blocks, {case}"),
            "stiffness",
            error,
            TOLERANCE,
        );
        assert!(error < TOLERANCE, "{error:e}");
        // the warping too, and the centers
        let warping = (&found.warping - &expected.warping).amax() / expected.warping.amax();
        assert!(warping < TOLERANCE, "{warping:e}");
        for axis in 0..2 {
            let one = found.centers.shear[axis] - expected.centers.shear[axis];
            assert!(one.abs() < TOLERANCE, "{one:e}");
        }
    }
}

/// A slice of linear elements, fully integrated, of any thickness; and one with a single
/// point through it. In millimeters and newtons, to test the units. Its mass gives the mass
/// of the section.
#[test]
fn slices_give_the_section_of_their_cells() {
    let section = bar(CellKind::Quadrilateral9);
    let expected = solved(&section);
    for (thickness, points, through) in
        [(0.02, 2, "linear"), (1.0, 2, "linear"), (0.1, 1, "middle")]
    {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path();
        let [stiffness, mass] = slice(&section, thickness, points);
        write_nodes(path, &section, 1e-3);
        write(path, "k.mtx", &market(&stiffness, 1e3));
        // mm, N and s: mass in tonnes
        write(path, "mass.mtx", &market(&mass, 1e3));
        let text = format!(
            "nodes = \"nodes.csv\"\n[units]\nlength = \"mm\"\nforce = \"N\"\n\
             [slice]\nstiffness = \"k.mtx\"\nmass = \"mass.mtx\"\nthickness = \"{thickness} m\"\n\
             through = \"{through}\"\n"
        );
        let found = solved_from(path, &text).expect("a sound slice");
        for (name, found, expected) in [
            ("stiffness", &found.stiffness, &expected.stiffness),
            ("mass", &found.mass, &expected.mass),
        ] {
            let error = scaled_error(found, expected);
            let case = format!("slice {thickness} thick, {through}");
            println!("{case}, {name}: {error:.1e}");
            record::largest(SELF, &case, name, error, TOLERANCE);
            assert!(error < TOLERANCE, "{case} {name}: {error:e}");
        }
    }
}

/// The command writes the property file of the beam program, and the warping of the nodes.
#[test]
fn the_command_writes_a_property_file() {
    let section = bar(CellKind::Quadrilateral4);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path();
    let [stiffness, _] = slice(&section, 0.05, 2);
    write_nodes(path, &section, 1.0);
    write(path, "k.mtx", &market(&stiffness, 1.0));
    let text = "units = \"SI\"\nname = \"bar\"\nnodes = \"nodes.csv\"\n\
                [slice]\nstiffness = \"k.mtx\"\nthickness = 0.05\n";
    write(path, "bar.matrices.toml", text);
    let text = format!("end_effects = 2\n{text}");
    write(path, "bar.matrices.toml", &text);
    let file = path.join("bar.matrices.toml").into_os_string();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let arguments = ["section-analyzer".into(), "matrices".into(), file];
    let code = section_analyzer::cli::run(arguments, &mut out, &mut err);
    assert_eq!((code, String::from_utf8_lossy(&err).as_ref()), (0, ""));
    let text = String::from_utf8_lossy(&out).into_owned();
    for words in [
        "Section \"bar\"",
        "Stiffness",
        "Checks of this run",
        "bar.warping.csv",
        "bar.warping.vtu",
        "End effects fall to 1/e",
        "remark: no mass is given",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let results = path.join("results");
    let read = shared_geom::section::read(&results.join("bar.properties.json"));
    let read = read.unwrap_or_else(|problems| panic!("{problems}"));
    let expected = solved(&section);
    assert!(scaled_error(&read.stiffness, &expected.stiffness) < TOLERANCE);
    // the warping of the first node under a torque, in the column of its name
    let table = std::fs::read_to_string(results.join("bar.warping.csv")).expect("written");
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let heading = lines.next().expect("a heading");
    let column = heading
        .iter()
        .position(|name| *name == "ux Mx [1/N]")
        .expect("its name");
    let row = lines.next().expect("a node");
    let found: f64 = row[column].parse().expect("a number");
    assert!((found - expected.warping[(0, 3)]).abs() < 1e-10 * expected.warping.amax());
}

/// Inconsistent matrices: the error lists each violated identity with its error, and no
/// other.
#[test]
fn matrices_that_do_not_belong_together_are_refused() {
    let section = bar(CellKind::Quadrilateral4);
    let [m, c, e] = blocks(&section);
    let mut h = DMatrix::zeros(m.nrows(), 6);
    for (node, [y, z]) in section.mesh.nodes.iter().enumerate() {
        let at_node = section_analyzer::element::rigid_displacement(1.0, *y, *z);
        h.fixed_view_mut::<3, 6>(3 * node, 0).copy_from(&at_node);
    }
    let l = &m * &h;
    let (r, a) = (c.transpose() * &h, l.transpose() * &h);
    let broken =
        |m: &DMatrix<f64>, c: &DMatrix<f64>, e: &DMatrix<f64>, [l, r, a]: [&DMatrix<f64>; 3]| {
            let folder = tempfile::tempdir().expect("a folder");
            let path = folder.path();
            write_nodes(path, &section, 1.0);
            let files = [("m", m), ("c", c), ("e", e), ("l", l), ("r", r), ("a", a)];
            let mut text = String::from("units = \"SI\"\nnodes = \"nodes.csv\"\n[matrices]\n");
            for (name, matrix) in files {
                write(path, &format!("{name}.mtx"), &market(matrix, 1.0));
                writeln!(text, "{name} = \"{name}.mtx\"").expect("text");
            }
            match solved_from(path, &text) {
                Ok(_) => Vec::new(),
                Err(Failure::Matrices { broken, .. }) => broken,
                Err(other) => panic!("{other}"),
            }
        };
    let names = |found: Vec<(&'static str, f64)>| -> Vec<&str> {
        found.into_iter().map(|(name, _)| name).collect()
    };
    let own = [&l, &r, &a];
    assert_eq!(broken(&m, &c, &e, own), []);
    // C with its rows and columns exchanged
    assert_eq!(
        names(broken(&m, &c.transpose(), &e, own))[..2],
        ["C H = L T", "E H = R T"]
    );
    // a scaled M is detected by its size: a thousandth more
    let found = broken(&(1.001 * &m), &c, &e, own);
    let of = |name: &str| {
        found
            .iter()
            .find(|(known, _)| *known == name)
            .expect(name)
            .1
    };
    assert!((of("M H = L") - 1e-3).abs() < 1e-5, "{found:?}");
    let mut skew = e.clone();
    skew[(0, 4)] += 1e-3 * e.amax();
    assert_eq!(names(broken(&m, &c, &skew, own))[0], "E = E'");
    let off = |matrix: &DMatrix<f64>| {
        let mut wrong = matrix.clone();
        wrong[(5, 2)] += 1e-3 * matrix.amax();
        wrong
    };
    assert_eq!(names(broken(&m, &c, &e, [&off(&l), &r, &a])), ["M H = L"]);
    assert_eq!(names(broken(&m, &c, &e, [&l, &off(&r), &a])), ["C' H = R"]);
    assert_eq!(names(broken(&m, &c, &e, [&l, &r, &off(&a)])), ["L' H = A"]);
}

/// A flat strip, 40 by 1, of cells ten times as wide as high.
fn strip() -> Section {
    let mesh = Rectangle {
        width: 40.0,
        height: 1.0,
        cells_y: 20,
        cells_z: 2,
        kind: CellKind::Quadrilateral4,
        name: "strip".into(),
    };
    uniform(
        &mesh.generate().expect("sound measures"),
        isotropic(70.0, 0.3),
        0.0,
    )
}

fn analyzed(
    path: &Path,
    section: &Section,
    [thickness, points]: [f64; 2],
    (through, digits): (&str, usize),
) -> Result<ExternalAnalysis, Failure> {
    let [stiffness, _] = slice(section, thickness, points as usize);
    write_nodes(path, section, 1.0);
    write(path, "k.mtx", &market_of(&stiffness, 1.0, digits));
    let text = format!(
        "units = \"SI\"\nnodes = \"nodes.csv\"\n[slice]\nstiffness = \"k.mtx\"\n\
         thickness = {thickness}\nthrough = \"{through}\"\n"
    );
    write(path, "bar.matrices.toml", &text);
    let input = external::read(&path.join("bar.matrices.toml"));
    let input = input.unwrap_or_else(|problems| panic!("{problems}"));
    ExternalAnalysis::new(&input.section)
}

/// Files of few digits: a result without warning is accurate to a thousandth, a result with
/// a warning to a tenth, and others are refused. Rounding is random and the condition a
/// bound from below: the error may be up to 30 times the estimate of a warning.
#[test]
fn digits_of_files_are_watched() {
    let section = strip();
    let expected = solved(&section).stiffness;
    let mut outcomes = [0; 3];
    for thickness in [5.0, 1.0, 0.2] {
        for digits in 6..=12 {
            let folder = tempfile::tempdir().expect("a folder");
            let kind = ("linear", digits);
            let case = format!("{digits} digits, slice {thickness} thick");
            match analyzed(folder.path(), &section, [thickness, 2.0], kind) {
                Ok(analysis) => {
                    let off = scaled_error(&analysis.solution().stiffness, &expected);
                    let reported = analysis
                        .warnings()
                        .iter()
                        .find_map(|warning| match warning {
                            ExternalWarning::Digits { error, .. } => Some(*error),
                            _ => None,
                        });
                    println!("{case}: error {off:.1e}, reported {reported:?}");
                    match reported {
                        Some(reported) => {
                            assert!(
                                off < 0.1 && off < 30.0 * reported,
                                "{case}: {off:e}, {reported:e}"
                            );
                            outcomes[1] += 1;
                        }
                        None => {
                            assert!(off < 1e-3, "{case}: {off:e}");
                            outcomes[2] += 1;
                        }
                    }
                }
                Err(failure) => {
                    println!("{case}: {failure}");
                    assert!(
                        failure.help().expect("help").contains("15 digits"),
                        "{failure}"
                    );
                    outcomes[0] += 1;
                }
            }
        }
    }
    assert!(outcomes.iter().all(|&count| count > 2), "{outcomes:?}");
}

/// Slices as thick as the width of their cells, read with the wrong `through`.
#[test]
fn through_the_slice_is_watched() {
    let section = bar(CellKind::Quadrilateral4);
    let folder = tempfile::tempdir().expect("a folder");
    let read =
        |slice: [f64; 2], through: &str| analyzed(folder.path(), &section, slice, (through, 17));
    let thick = 0.25;
    let failure = read([thick, 1.0], "linear").expect_err("M below zero");
    assert!(matches!(failure, Failure::NotPositive { .. }), "{failure}");
    assert!(failure.help().expect("help").contains("\"through\""));
    let is_reported = |slice: [f64; 2], through: &str| {
        let analysis = read(slice, through).unwrap_or_else(|failure| panic!("{failure}"));
        let mut warnings = analysis.warnings().iter();
        warnings.any(|warning| matches!(warning, ExternalWarning::Through { .. }))
    };
    assert!(is_reported([thick, 2.0], "middle"));
    assert!(!is_reported([thick, 1.0], "middle"));
    assert!(!is_reported([thick, 2.0], "linear"));
    assert!(!is_reported([0.02, 1.0], "middle"));
}

/// Matrices of wrong size or sign are refused as wrong input, with a message about
/// matrices.
#[test]
fn wrong_matrices_are_reported_as_such() {
    let section = bar(CellKind::Quadrilateral4);
    let failed = |change: fn(&mut [DMatrix<f64>; 3])| {
        let mut blocks = blocks(&section);
        change(&mut blocks);
        let folder = tempfile::tempdir().expect("a folder");
        write_nodes(folder.path(), &section, 1.0);
        for (name, block) in ["m.mtx", "c.mtx", "e.mtx"].into_iter().zip(&blocks) {
            write(folder.path(), name, &market(block, 1.0));
        }
        let text = "units = \"SI\"\nnodes = \"nodes.csv\"\n[matrices]\nm = \"m.mtx\"\n\
                    c = \"c.mtx\"\ne = \"e.mtx\"\n";
        solved_from(folder.path(), text)
            .expect_err("wrong")
            .to_string()
    };
    type Change = fn(&mut [DMatrix<f64>; 3]);
    let cases: [(Change, &str); 3] = [
        (
            |blocks| blocks[0] *= 0.0,
            "M, the stiffness against the rate",
        ),
        (
            |blocks| blocks.iter_mut().for_each(|b| *b *= 0.0),
            "E, the stiffness against",
        ),
        (
            |blocks| blocks.iter_mut().for_each(|b| *b *= -1.0),
            "M, the stiffness",
        ),
    ];
    for (change, words) in cases {
        let reported = failed(change);
        assert!(reported.contains(words), "{words}: {reported}");
    }
}

/// End effects agree with the analysis of the cells.
#[test]
fn end_effects_of_given_matrices() {
    let section = bar(CellKind::Quadrilateral4);
    let folder = tempfile::tempdir().expect("a folder");
    let slice = [0.05, 2.0];
    let analysis = analyzed(folder.path(), &section, slice, ("linear", 17)).expect("sound");
    let found = analysis.end_effects(3).expect("end effects");
    let cells = Analysis::new(&section).expect("sound");
    let expected = cells.end_effects(3).expect("end effects");
    assert_eq!(found.modes.len(), expected.modes.len());
    for (found, expected) in found.modes.iter().zip(&expected.modes) {
        // the search ends at 1e-9
        let error = (found.rate - expected.rate).abs() / expected.rate;
        assert!(error < 1e-7, "{error:e}");
        record::largest(SELF, "end effects", "rates", error, 1e-7);
    }
}

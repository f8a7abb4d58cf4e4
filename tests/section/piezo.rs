//! Piezoelectric sections against closed forms.
//!
//! # References
//! - The constants and the prototype's numbers: `tests/reference/theory/piezo.json`.
//! - [Masarati], section 9.1: the coupled section.
//! - IEEE Std 176-1987: coupling factors and the two forms of the law.

use nalgebra::{Matrix3, Matrix3x6, Matrix6};
use section_analyzer::material::{ElasticLaw, ElectricLaw, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::section::{Circuit, Electrode, ElectrodeShape, Section};
use section_analyzer::solution::{PiezoSolution, SectionSolution};
use serde::Deserialize;
use shared_geom::mesh::{CellKind, Mesh};

use crate::record;
use crate::sections::{solved, uniform};

const SOURCE: &str = "Piezoelectric sections";
const FILE: &str = "tests/reference/theory/piezo.json";

#[derive(Deserialize)]
struct Reference {
    material: Constants,
}

#[derive(Deserialize)]
#[expect(non_snake_case, reason = "names of the file")]
struct Constants {
    s: [[f64; 6]; 6],
    d: [[f64; 6]; 3],
    epsT: [[f64; 3]; 3],
}

/// Constants of a piezoelectric material in its own axes, poled along 3.
#[derive(Clone, Copy)]
struct Pzt {
    s: Matrix6<f64>,
    d: Matrix3x6<f64>,
    at_stress: Matrix3<f64>,
}

/// PZT-5H-like.
fn pzt() -> Pzt {
    let text = std::fs::read_to_string(FILE).unwrap();
    let Constants { s, d, epsT } = serde_json::from_str::<Reference>(&text).unwrap().material;
    Pzt {
        s: Matrix6::from_fn(|i, j| s[i][j]),
        d: Matrix3x6::from_fn(|i, j| d[i][j]),
        at_stress: Matrix3::from_fn(|i, j| epsT[i][j]),
    }
}

impl Pzt {
    /// The same with its axes 1 2 3 called 2 3 1: poled along the fiber.
    fn poled_along_1(&self) -> Self {
        let axis = |i: usize| (i + 2) % 3;
        let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let entry = |i: usize| {
            let (a, b) = (axis(pairs[i].0), axis(pairs[i].1));
            pairs
                .iter()
                .position(|&pair| pair == (a.min(b), a.max(b)))
                .unwrap()
        };
        Self {
            s: Matrix6::from_fn(|i, j| self.s[(entry(i), entry(j))]),
            d: Matrix3x6::from_fn(|i, j| self.d[(axis(i), entry(j))]),
            at_stress: Matrix3::from_fn(|i, j| self.at_stress[(axis(i), axis(j))]),
        }
    }

    fn material(&self) -> Material {
        let c = self.s.try_inverse().unwrap();
        let c = 0.5 * (c + c.transpose());
        Material {
            name: "pzt".into(),
            electric: Some(ElectricLaw::of_strains(&self.d, &self.at_stress, &c)),
            law: ElasticLaw::Full(c),
            density: 7500.0,
            expansion: None,
        }
    }
}

fn rectangle(width: f64, height: f64, cells: [usize; 2]) -> Mesh {
    Rectangle {
        width,
        height,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "bar".into(),
    }
    .generate()
    .unwrap()
}

/// A conductor on the nodes at the places that `is_there` takes.
fn conductor(
    section: &Section,
    name: &str,
    circuit: Circuit,
    is_there: impl Fn([f64; 2]) -> bool,
) -> Electrode {
    let nodes = (0..section.mesh.nodes.len() as u32)
        .filter(|&node| is_there(section.mesh.nodes[node as usize]));
    Electrode {
        name: name.into(),
        circuit,
        shape: ElectrodeShape::Conductor {
            nodes: nodes.collect(),
        },
    }
}

/// Conductors at heights z, the first of them ground.
fn at_heights(section: &mut Section, heights: &[f64]) {
    let size = heights.iter().fold(0.0, |sum: f64, z| sum.max(z.abs()));
    for (number, &height) in heights.iter().enumerate() {
        let circuit = if number == 0 {
            Circuit::Ground
        } else {
            Circuit::Driven
        };
        let name = format!("e{number}");
        let electrode = conductor(section, &name, circuit, |[_, z]| {
            (z - height).abs() < 1e-9 * size
        });
        section.electrodes.push(electrode);
    }
}

fn piezo(solution: &SectionSolution) -> &PiezoSolution {
    solution.piezo.as_ref().unwrap()
}

/// Records and compares a number with its closed form.
fn close(case: &str, quantity: &str, [found, expected]: [f64; 2], tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    println!("{case}, {quantity}: {found:e} {expected:e} {error:e}");
    record::value(SOURCE, case, quantity, [found, expected], error, tolerance);
    assert!(
        error < tolerance,
        "{case}, {quantity}: {found:e}, expected {expected:e}"
    );
}

/// The layers of a plate are uniform along its width but for round-off of a few hundred
/// nodes.
const EXACT: f64 = 1e-11;

#[test]
fn a_layer_poled_and_driven_through_its_thickness() {
    let (b, h) = (0.002, 0.001);
    let pzt = pzt();
    let mut section = uniform(&rectangle(b, h, [4, 3]), pzt.material(), 0.0);
    at_heights(&mut section, &[-0.5 * h, 0.5 * h]);
    let solution = solved(&section);
    let piezo = piezo(&solution);
    let (s11, d31, eps) = (pzt.s[(0, 0)], pzt.d[(2, 0)], pzt.at_stress[(2, 2)]);
    let k31 = d31 * d31 / (s11 * eps);
    let k = &solution.stiffness;
    let top = &piezo.electrodes[1];
    for (quantity, found, expected) in [
        ("EA", k[(0, 0)], b * h / s11),
        ("EIy", k[(4, 4)], b * h.powi(3) / 12.0 / s11 / (1.0 - k31)),
        ("EIz", k[(5, 5)], h * b.powi(3) / 12.0 / s11),
        ("Theta of N", top.coupling[0], b * d31 / s11),
        ("free strain", top.free_strain[0], -d31 / h),
        (
            "free capacitance",
            piezo.free_capacitance[(1, 1)],
            eps * b / h,
        ),
        (
            "capacitance",
            piezo.capacitance[(1, 1)],
            (eps - d31 * d31 / s11) * b / h,
        ),
    ] {
        close("layer", quantity, [found, expected], EXACT);
    }
    println!("{:?}", piezo.checks);
}

#[test]
fn a_shear_actuator() {
    let (b, h) = (0.002, 0.001);
    let pzt = pzt();
    let section = pzt.poled_along_1();
    let mut section = uniform(&rectangle(b, h, [4, 3]), section.material(), 0.0);
    at_heights(&mut section, &[-0.5 * h, 0.5 * h]);
    let solution = solved(&section);
    let piezo = piezo(&solution);
    let (d15, eps) = (pzt.d[(0, 4)], pzt.at_stress[(0, 0)]);
    let top = &piezo.electrodes[1];
    println!("{}", top.free_strain);
    close(
        "shear actuator",
        "free strain",
        [top.free_strain[2], -d15 / h],
        EXACT,
    );
    let expected = eps * b / h;
    close(
        "shear actuator",
        "free capacitance",
        [piezo.free_capacitance[(1, 1)], expected],
        EXACT,
    );
}

//! Piezoelectric sections against closed forms.
//!
//! # References
//! - The constants and the numbers of the prototype: `tests/reference/theory/piezo.json`.
//! - [Masarati], section 9.1: the coupled section.
//! - [Ieee1987]: coupling factors and the two forms of the law.

#![allow(clippy::unwrap_used, reason = "a test that cannot continue fails")]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use nalgebra::{Matrix3, Matrix3x6, Matrix6, Vector3};
use section_analyzer::analysis::analyze;
use section_analyzer::material::{ElasticLaw, ElectricLaw, Material};
use section_analyzer::mesh::generate::{Rectangle, Tube};
use section_analyzer::section::{Circuit, Electrode, ElectrodeShape, FingeredCell, Section};
use section_analyzer::solution::{PiezoSolution, SectionSolution};
use serde::Deserialize;
use shared_geom::mesh::{CellKind, Mesh};

use crate::curved_lines::curved;
use crate::record;
use crate::sections::{isotropic, solved, uniform};

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

/// Constants of a piezoelectric material in its axes, poled along 3.
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
    /// The same with its axes 1 2 3 renamed 2 3 1: poled along the fiber.
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

/// A conductor on the nodes at the positions that `is_there` accepts.
pub fn conductor(
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

/// The electrodes of a solution, after checks: voltages common to all conductors have no
/// effect, the capacitance is symmetric, and the strains agree with the work: round-off
/// times the slenderness of the section, up to 100.
fn piezo(solution: &SectionSolution) -> &PiezoSolution {
    let piezo = solution.piezo.as_ref().unwrap();
    let checks = &piezo.checks;
    for error in [checks.work, checks.asymmetry, checks.common] {
        assert!(error < 1e-11, "{checks:?}");
    }
    piezo
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

/// The layers of a plate are uniform along its width, up to round-off of a few hundred
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

/// Two layers of the same poling, electrodes at the bottom, between them, and on top.
fn bimorph(b: f64, t: f64, cells: [usize; 2]) -> (Section, SectionSolution) {
    let mut section = uniform(&rectangle(b, 2.0 * t, cells), pzt().material(), 0.0);
    at_heights(&mut section, &[-t, 0.0, t]);
    let solution = solved(&section);
    (section, solution)
}

/// Sections tend to the one-dimensional beam, `EI = b t^3/s11 (1/2 + 1/(6 (1 - k31^2)))` and
/// `kappa EI = b t d31 V/s11`, with decreasing width: the layers restrain each other across
/// the width within a few widths of their joint, so that the difference decreases as b/t.
/// The bounds are the errors of the prototype on its mesh.
#[test]
fn bimorphs_tend_to_the_beam_of_one_dimension() {
    let pzt = pzt();
    let (s11, d31, eps) = (pzt.s[(0, 0)], pzt.d[(2, 0)], pzt.at_stress[(2, 2)]);
    let k31 = d31 * d31 / (s11 * eps);
    let t = 1e-3;
    let mut errors = Vec::new();
    for (b, cells, [of_ei, of_kappa]) in [
        (0.2 * t, [4, 40], [1.6e-3, 1.4e-2]),
        (0.01 * t, [2, 400], [2e-4, 1.8e-3]),
    ] {
        let (_, solution) = bimorph(b, t, cells);
        let ei = b * t.powi(3) / s11 * (0.5 + 1.0 / (6.0 * (1.0 - k31)));
        let kappa = b * t * d31 / s11 / ei;
        let middle = &piezo(&solution).electrodes[1];
        let case = format!("bimorph, b/t = {}", b / t);
        close(&case, "EI", [solution.stiffness[(4, 4)], ei], of_ei);
        close(
            &case,
            "curvature per volt",
            [middle.free_strain[4], kappa],
            of_kappa,
        );
        errors.push(1.0 - middle.free_strain[4] / kappa);
    }
    // a twentieth of the width, a twentieth of the difference: to a fifth, as b/t = 0.2 is
    // not yet asymptotic
    let fall = errors[0] / errors[1];
    assert!((fall / 20.0 - 1.0).abs() < 0.2, "{fall}");
}

#[derive(Deserialize)]
struct Bimorph {
    #[serde(rename = "K")]
    stiffness: [[f64; 6]; 6],
    #[serde(rename = "Theta")]
    coupling: [[f64; 6]; 3],
    eps_const_psi: [[f64; 3]; 3],
}

/// The wide bimorph of the prototype on an unknown mesh: its numbers lie between the
/// results of 16 x 8 and 32 x 16 cells, which differ by 6e-4.
#[test]
fn a_wide_bimorph_is_that_of_the_prototype() {
    let text = std::fs::read_to_string(FILE).unwrap();
    let cases: serde_json::Value = serde_json::from_str(&text).unwrap();
    let known: Bimorph = serde_json::from_value(cases["cases"][2].clone()).unwrap();
    let (_, solution) = bimorph(0.002, 0.0005, [32, 16]);
    let piezo = piezo(&solution);
    let mut worst = 0.0_f64;
    let k = |i: usize, j: usize| known.stiffness[i][j];
    for i in 0..6 {
        for j in 0..6 {
            let error = solution.stiffness[(i, j)] - k(i, j);
            worst = worst.max(error.abs() / (k(i, i) * k(j, j)).sqrt());
        }
    }
    for e in 0..3 {
        let cap = known.eps_const_psi[e][e];
        for i in 0..6 {
            let error = piezo.electrodes[e].coupling[i] - known.coupling[e][i];
            worst = worst.max(error.abs() / (k(i, i) * cap).sqrt());
        }
        for f in 0..3 {
            let error = piezo.capacitance[(e, f)] - known.eps_const_psi[e][f];
            worst = worst.max(error.abs() / cap);
        }
    }
    println!("{worst:e}");
    record::largest(
        SOURCE,
        "bimorph 2 mm x 1 mm",
        "K, Theta, capacitance",
        worst,
        6e-4,
    );
    assert!(worst < 6e-4, "{worst:e}");
}

/// A tube poled through its wall, with different strains per field along and across the
/// fiber, wound at 45 degrees; inner and outer face are electrodes.
fn wound_tube(thickness: f64, around: usize) -> Section {
    let (young, poisson) = (70e9, 0.3);
    let tube = Tube {
        outer_radius: 1.0,
        thickness,
        cells_around: around,
        cells_through: 1,
        kind: CellKind::Quadrilateral9,
        curved: true,
    };
    let law = ElasticLaw::Isotropic { young, poisson };
    let mut d = Matrix3x6::zeros();
    (d[(2, 0)], d[(2, 1)]) = (1e-10, -5e-11);
    let electric = ElectricLaw::of_strains(&d, &(Matrix3::identity() * 1e-8), &law.stiffness());
    let mut poled = isotropic(young, poisson);
    poled.electric = Some(electric);
    let mut section = uniform(&tube.generate().unwrap(), poled, FRAC_PI_4);
    for (cell, made_of) in section.mesh.cells.iter().zip(&mut section.cells) {
        let corners = &cell.nodes()[..4];
        let mean = |axis: usize| -> f64 {
            let positions = corners
                .iter()
                .map(|&n| section.mesh.nodes[n as usize][axis]);
            positions.sum::<f64>() / 4.0
        };
        // clockwise, so that the normal points outward
        made_of.plane_angle = mean(1).atan2(mean(0)) - FRAC_PI_2;
    }
    let radius = |[y, z]: [f64; 2]| y.hypot(z);
    section.electrodes = vec![
        conductor(&section, "inner", Circuit::Ground, |p| {
            radius(p) < 1.0 - 0.99 * thickness
        }),
        conductor(&section, "outer", Circuit::Driven, |p| {
            radius(p) > 1.0 - 0.01 * thickness
        }),
    ];
    section
}

/// Twist of a thin wall, `(d31 - d32) E / R`: the field -1/t per volt shears the wall by
/// -1.5e-10/t from x towards s, which runs clockwise. The bounds are the errors of the
/// prototype, of order t/R for the finite thickness of the wall, and the error of a
/// constant direction in each cell.
#[test]
fn tubes_wound_at_45_degrees_twist() {
    for (thickness, bound) in [(0.1, 6e-3), (0.01, 1.5e-3)] {
        let solution = solved(&wound_tube(thickness, 64));
        let outer = &piezo(&solution).electrodes[1];
        let expected = 1.5e-10 / (thickness * (1.0 - 0.5 * thickness));
        let case = format!("tube, t/R = {thickness}");
        close(
            &case,
            "twist per volt",
            [outer.free_strain[3], expected],
            bound,
        );
    }
}

/// The same tube in a frame that twists along it: the difference is the difference of two
/// meshes, as the mesh turns along the tube in one of them only.
#[test]
fn a_twisting_frame_sees_the_same_tube() {
    let difference = |around: usize| {
        let section = wound_tube(0.1, around);
        let straight = solved(&section);
        let twisted = solved(&curved(&section, [0.2, 0.0, 0.0]));
        let (straight, twisted) = (piezo(&straight), piezo(&twisted));
        let (theta, seen) = (
            &straight.electrodes[1].coupling,
            &twisted.electrodes[1].coupling,
        );
        let of_theta = (theta - seen).amax() / theta.amax();
        let ratio = straight.capacitance[(1, 1)] / twisted.capacitance[(1, 1)];
        println!("{of_theta:e} {:e}", ratio - 1.0);
        [of_theta, (ratio - 1.0).abs()]
    };
    let (coarse, fine) = (difference(32), difference(64));
    // the errors of the prototype, whose mesh of 32 x 1 cells is not documented
    for (quantity, error, bound) in [("Theta", fine[0], 2.6e-6), ("capacitance", fine[1], 1.9e-5)] {
        record::largest(SOURCE, "tube, twisting frame", quantity, error, bound);
        assert!(error < bound, "{quantity}: {error:e}");
    }
    assert!(coarse[0] < 3e-6 && coarse[1] < 4e-5, "{coarse:?}");
}

/// Fingers across a bar poled along its fiber: strain, force and charge of the field V/d in
/// a free and in a restrained bar, and the stiffness with open fingers. Strain per volt,
/// charge per volt and charge per strain are checked independently.
#[test]
fn interdigitated_fibers_are_stacks_of_capacitors() {
    let (b, t, spacing) = (0.003, 0.0002, 0.0005);
    let pzt = pzt();
    let mut section = uniform(
        &rectangle(b, t, [6, 1]),
        pzt.poled_along_1().material(),
        0.0,
    );
    fingers(&mut section, 1.0 / spacing);
    let solution = solved(&section);
    let piezo = piezo(&solution);
    let (s33, d33, eps) = (pzt.s[(2, 2)], pzt.d[(2, 2)], pzt.at_stress[(2, 2)]);
    let k33 = d33 * d33 / (s33 * eps);
    let fingers = &piezo.electrodes[0];
    let open = piezo
        .in_circuit(&solution.stiffness, |_| Circuit::Floating)
        .unwrap();
    // 1/d capacitors of the area b t at the distance d in a unit of length
    let capacitors = b * t / (spacing * spacing);
    for (quantity, found, expected) in [
        ("EA", solution.stiffness[(0, 0)], b * t / s33),
        (
            "EA, open",
            open.stiffness[(0, 0)],
            b * t / (s33 * (1.0 - k33)),
        ),
        ("free strain", fingers.free_strain[0], d33 / spacing),
        (
            "Theta of N",
            fingers.coupling[0],
            -b * t * d33 / (s33 * spacing),
        ),
        (
            "free capacitance",
            piezo.free_capacitance[(0, 0)],
            eps * capacitors,
        ),
        (
            "capacitance",
            piezo.capacitance[(0, 0)],
            (1.0 - k33) * eps * capacitors,
        ),
    ] {
        close("interdigitated bar", quantity, [found, expected], EXACT);
    }
}

/// Fingers across all cells of a section, with the given field per volt along the fiber.
fn fingers(section: &mut Section, field: f64) {
    let cells = (0..section.mesh.cells.len() as u32).map(|cell| FingeredCell {
        cell,
        field: Vector3::new(field, 0.0, 0.0),
    });
    section.electrodes.push(Electrode {
        name: "fingers".into(),
        circuit: Circuit::Driven,
        shape: ElectrodeShape::Interdigitated {
            cells: cells.collect(),
        },
    });
}

/// Another model of the field along the fiber: a fictitious material whose response to a
/// voltage through the wall equals its response to the field along the fiber,
/// `e_3j <- e_1j t/d` and `eps_33 <- eps_11 (t/d)^2`, with potentials as unknowns and the
/// capacitance from the electric displacement at a conductor. In a wall the strain is
/// constant through the thickness, to the order t/R, and the two models agree to the same
/// order; a tube wound at 45 degrees.
#[test]
fn interdigitated_fibers_are_a_made_up_field_through_the_wall() {
    let ratio = 0.7;
    for thickness in [0.04, 0.01] {
        let spacing = thickness / ratio;
        let mut poled = pzt().poled_along_1().material();
        let mut by_fingers = wound_tube(thickness, 48);
        by_fingers.materials = vec![poled.clone()];
        by_fingers.electrodes.clear();
        fingers(&mut by_fingers, 1.0 / spacing);
        let known = poled.electric.unwrap();
        let mut made_up = ElectricLaw {
            coupling: Matrix3x6::zeros(),
            // no field in the plane of the wall
            permittivity: known.permittivity,
        };
        for j in 0..6 {
            made_up.coupling[(2, j)] = ratio * known.coupling[(0, j)];
        }
        made_up.permittivity[(2, 2)] = ratio * ratio * known.permittivity[(0, 0)];
        poled.electric = Some(made_up);
        let mut through_wall = wound_tube(thickness, 48);
        through_wall.materials = vec![poled];

        let (by_fingers, through_wall) = (solved(&by_fingers), solved(&through_wall));
        let (fingers, wall) = (piezo(&by_fingers), piezo(&through_wall));
        let one = &fingers.electrodes[0];
        // V at the outer face is a gradient of V/t, a field against it
        let other = &wall.electrodes[1];
        let bound = thickness;
        for (quantity, found, expected) in [
            ("twist", one.free_strain[3], -other.free_strain[3]),
            ("Theta of Mx", one.coupling[3], -other.coupling[3]),
            ("Theta of N", one.coupling[0], -other.coupling[0]),
            (
                "capacitance",
                fingers.capacitance[(0, 0)],
                wall.capacitance[(1, 1)],
            ),
            (
                "free",
                fingers.free_capacitance[(0, 0)],
                wall.free_capacitance[(1, 1)],
            ),
        ] {
            let case = format!("interdigitated tube, t/R = {thickness}");
            close(&case, quantity, [found, expected], bound);
        }
    }
}

/// A layer without stiffness, e.g. air, between the patch and one electrode: two capacitors
/// in series, which reduces the field in the patch. The patch may strain freely, so that
/// both layers have their field at zero stress.
#[test]
fn dielectrics_without_stiffness_take_their_part_of_the_voltage() {
    let (b, h) = (0.002, 0.001);
    let pzt = pzt();
    let gap = 2e-9;
    let mut section = uniform(&rectangle(b, h, [4, 4]), pzt.material(), 0.0);
    section.materials.push(Material {
        name: "gap".into(),
        law: ElasticLaw::Absent,
        density: 0.0,
        expansion: None,
        electric: Some(ElectricLaw::dielectric(Matrix3::identity() * gap)),
    });
    for (cell, made_of) in section.mesh.cells.iter().zip(&mut section.cells) {
        let z: f64 = cell
            .nodes()
            .iter()
            .map(|&n| section.mesh.nodes[n as usize][1])
            .sum();
        made_of.material = usize::from(z > 0.0);
    }
    at_heights(&mut section, &[-0.5 * h, 0.5 * h]);
    let solution = analyze(&section).unwrap();
    let piezo = piezo(&solution);
    let half = 0.5 * h;
    let (own, behind) = (pzt.at_stress[(2, 2)] * b / half, gap * b / half);
    let both = own * behind / (own + behind);
    let field = -behind / (own + behind) / half;
    let top = &piezo.electrodes[1];
    // with the gap a patch in tension keeps some charge: E = -d31 sigma / (epsT + gap)
    let (s11, d31, eps) = (pzt.s[(0, 0)], pzt.d[(2, 0)], pzt.at_stress[(2, 2)]);
    let pulled = s11 - d31 * d31 / (eps + gap);
    for (quantity, found, expected) in [
        ("EA", solution.stiffness[(0, 0)], b * half / pulled),
        ("free capacitance", piezo.free_capacitance[(1, 1)], both),
        ("free strain", top.free_strain[0], field * pzt.d[(2, 0)]),
    ] {
        close(
            "layer in series with a gap",
            quantity,
            [found, expected],
            EXACT,
        );
    }
}

/// A floating electrode has the voltage between two others, and open electrodes increase
/// the stiffness of the layer: `EA/(1 - k31^2)`.
#[test]
fn floating_electrodes_have_no_charge() {
    let (b, h) = (0.002, 0.001);
    let pzt = pzt();
    let mut section = uniform(&rectangle(b, h, [4, 4]), pzt.material(), 0.0);
    at_heights(&mut section, &[-0.5 * h, 0.0, 0.5 * h]);
    section.electrodes[1].circuit = Circuit::Floating;
    let solution = solved(&section);
    let piezo = piezo(&solution);
    let none = nalgebra::Vector6::zeros();
    let voltages = piezo
        .voltages(&solution.compliance, &none, &[0.0, 0.0, 2.0])
        .unwrap();
    assert!((voltages[1] - 1.0).abs() < EXACT, "{voltages:?}");
    let (s11, d31, eps) = (pzt.s[(0, 0)], pzt.d[(2, 0)], pzt.at_stress[(2, 2)]);
    let k31 = d31 * d31 / (s11 * eps);
    let all_open = |electrode: usize| match electrode {
        0 => Circuit::Ground,
        _ => Circuit::Floating,
    };
    let open = piezo.in_circuit(&solution.stiffness, all_open).unwrap();
    assert!(open.electrodes.is_empty());
    close(
        "layer, open",
        "EA",
        [open.stiffness[(0, 0)], b * h / (s11 * (1.0 - k31))],
        EXACT,
    );
    // the floating electrode in the middle has no effect
    let driven = piezo
        .in_circuit(&solution.stiffness, |e| piezo.electrodes[e].circuit)
        .unwrap();
    assert_eq!(driven.electrodes, [2]);
    close(
        "layer, floating",
        "Theta of N",
        [driven.coupling[(0, 0)], b * d31 / s11],
        EXACT,
    );
    let capacitance = (eps - d31 * d31 / s11) * b / h;
    close(
        "layer, floating",
        "capacitance",
        [driven.capacitance[(0, 0)], capacitance],
        EXACT,
    );
}

//! Stress and electric field of piezoelectric sections under forces and voltages.
//!
//! # References
//! - The constants: `tests/reference/theory/piezo.json`.
//! - IEEE Std 176-1987: the two forms of the law; the closed forms below follow from it in
//!   one line each.

use nalgebra::{Matrix3, Matrix3x6, Matrix6, Matrix6xX, Vector3, Vector6};
use section_analyzer::failure::Failure;
use section_analyzer::material::{ElasticLaw, ElectricLaw, Material};
use section_analyzer::mesh::generate::Rectangle;
use section_analyzer::recovery::{LoadCase, Recoverer, Recovery};
use section_analyzer::section::{Circuit, Electrode, ElectrodeShape, FingeredCell, Section};
use section_analyzer::solution::SectionSolution;
use serde::Deserialize;
use shared_geom::error::Explain;
use shared_geom::mesh::CellKind;
use shared_geom::section::InitialCurvature;

use crate::piezo::conductor;
use crate::record;
use crate::sections::{solved, uniform};

const SOURCE: &str = "Piezoelectric sections: recovery";

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

fn constants() -> Constants {
    let text = std::fs::read_to_string("tests/reference/theory/piezo.json").expect("stored");
    serde_json::from_str::<Reference>(&text)
        .expect("constants")
        .material
}

/// PZT-5H-like, poled along 3.
fn pzt() -> Material {
    let Constants { s, d, epsT } = constants();
    let c = Matrix6::from_fn(|i, j| s[i][j])
        .try_inverse()
        .expect("regular");
    let c = 0.5 * (c + c.transpose());
    let d = Matrix3x6::from_fn(|i, j| d[i][j]);
    let at_stress = Matrix3::from_fn(|i, j| epsT[i][j]);
    Material {
        name: "pzt".into(),
        electric: Some(ElectricLaw::of_strains(&d, &at_stress, &c)),
        law: ElasticLaw::Full(c),
        density: 7500.0,
        expansion: None,
    }
}

const WIDTH: f64 = 0.002;
const HEIGHT: f64 = 0.001;

/// A bar with a conductor at its lower face, ground, and one at its upper face, "top".
fn layer(cells: [usize; 2]) -> Section {
    let mesh = Rectangle {
        width: WIDTH,
        height: HEIGHT,
        cells_y: cells[0],
        cells_z: cells[1],
        kind: CellKind::Quadrilateral9,
        name: "layer".into(),
    };
    let mut section = uniform(&mesh.generate().expect("sound measures"), pzt(), 0.0);
    for (name, circuit, z) in [
        ("bottom", Circuit::Ground, -0.5 * HEIGHT),
        ("top", Circuit::Driven, 0.5 * HEIGHT),
    ] {
        let there = |position: [f64; 2]| (position[1] - z).abs() < 1e-9 * HEIGHT;
        let electrode = conductor(&section, name, circuit, there);
        section.electrodes.push(electrode);
    }
    section
}

/// The layer of skew plies, away from the origin: everything is coupled.
fn skew(curvature: InitialCurvature) -> Section {
    let mut section = layer([3, 2]);
    for [y, z] in &mut section.mesh.nodes {
        (*y, *z) = (*y + 0.2 * *z + 3e-4, *z + 0.3 * *y - 2e-4);
    }
    for (cell, made_of) in section.cells.iter_mut().enumerate() {
        made_of.fiber_angle = 0.4 - 0.3 * cell as f64;
        made_of.plane_angle = 0.2 + 0.1 * cell as f64;
    }
    section.initial_curvature = curvature;
    section
}

fn curved() -> InitialCurvature {
    InitialCurvature {
        curvature: Vector3::new(60.0, -40.0, 50.0),
        slope: Vector3::new(0.95, 0.1, -0.05),
    }
}

fn load(force: Vector6<f64>, voltages: &[(&str, f64)]) -> LoadCase {
    LoadCase {
        voltages: voltages.iter().map(|(n, v)| ((*n).into(), *v)).collect(),
        ..LoadCase::at_point("load", &force, [0.0; 2])
    }
}

fn recovered(section: &Section, solution: &SectionSolution, load: &LoadCase) -> Recovery {
    let recoverer = Recoverer::new(section, solution);
    let found = recoverer.recover(load);
    found.unwrap_or_else(|failure| panic!("{failure}"))
}

/// Compares values at all points with a closed form of their position, and records the
/// largest error relative to `scale`.
fn all_points(
    (case, quantity): (&str, &str),
    recovery: &Recovery,
    value: impl Fn(usize) -> f64,
    expected: impl Fn([f64; 2]) -> f64,
    scale: f64,
) {
    let points = recovery.points.iter().enumerate();
    let pairs = points.map(|(k, point)| [value(k), expected(point.position)]);
    let worst = pairs.max_by(|a, b| (a[0] - a[1]).abs().total_cmp(&(b[0] - b[1]).abs()));
    let [found, expected] = worst.expect("points");
    let error = ((found - expected) / scale).abs();
    println!("{case}, {quantity}: {found:e} {expected:e} {error:e}");
    record::value(SOURCE, case, quantity, [found, expected], error, EXACT);
    assert!(error < EXACT, "{case}, {quantity}: {found:e} {expected:e}");
}

/// Fields that the cells represent exactly: round-off times a condition of about 1e3.
const EXACT: f64 = 1e-11;

/// Without d15 and d24 a field across the poling has no stress, and its round-off is no error.
#[test]
fn a_field_across_the_poling_strains_nothing() {
    let (mut section, Constants { d, epsT, .. }) = (layer([4, 3]), constants());
    let d = Matrix3x6::from_fn(|i, j| if i == 2 && j < 3 { d[i][j] } else { 0.0 });
    let ElasticLaw::Full(c) = section.materials[0].law.clone() else {
        panic!("a full law");
    };
    let along = d.norm() * c.norm() * 150.0 / HEIGHT;
    let electric = ElectricLaw::of_strains(&d, &Matrix3::from_fn(|i, j| epsT[i][j]), &c);
    section.materials[0].electric = Some(electric);
    for cell in &mut section.cells {
        cell.plane_angle = std::f64::consts::FRAC_PI_2;
    }
    let load = load(Vector6::zeros(), &[("top", 150.0)]);
    let points = recovered(&section, &solved(&section), &load).points;
    let sizes = points.iter().map(|point| point.tensors.stress.amax());
    let stress = sizes.fold(0.0, f64::max);
    assert!(stress < EXACT * along, "{stress:e} {along:e}");
}

/// The field is V/h, and the stress is zero.
#[test]
fn a_free_layer_under_voltage() {
    let (section, volts) = (layer([4, 3]), 150.0);
    let solution = solved(&section);
    let Constants { s, d, epsT } = constants();
    let (s11, d31, eps) = (s[0][0], d[2][0], epsT[2][2]);
    let field = -volts / HEIGHT;

    let free = recovered(
        &section,
        &solution,
        &load(Vector6::zeros(), &[("top", volts)]),
    );
    let electric = free.electric.as_ref().unwrap();
    let at = |k: usize| free.points[k].tensors;
    let held = d31 / s11 * field;
    let case = "free layer";
    all_points(
        (case, "Ez"),
        &free,
        |k| electric.points[k].field.z,
        |_| field,
        field,
    );
    all_points(
        (case, "stress"),
        &free,
        |k| at(k).stress.amax(),
        |_| 0.0,
        held,
    );
    let strain = d31 * field;
    all_points(
        (case, "strain"),
        &free,
        |k| at(k).strain[0],
        |_| strain,
        strain,
    );
    assert!((free.generalized_strain[0] / strain - 1.0).abs() < EXACT);
    let charge = electric.charges.as_ref().unwrap();
    let expected = eps * WIDTH / HEIGHT * volts;
    assert!((charge[1] / expected - 1.0).abs() < EXACT);
    assert!((charge[0] / expected + 1.0).abs() < EXACT);
}

/// `sigma = -d31/s11 E`, since the sides are free, and `D = (epsT - d31^2/s11) E`.
#[test]
fn a_held_layer_under_voltage() {
    let (section, volts) = (layer([4, 3]), 150.0);
    let solution = solved(&section);
    let Constants { s, d, epsT } = constants();
    let (s11, d31, eps) = (s[0][0], d[2][0], epsT[2][2]);
    let field = -volts / HEIGHT;
    let (held, strain) = (d31 / s11 * field, d31 * field);
    let force = volts * solution.piezo.as_ref().unwrap().electrodes[1].coupling;
    let clamped = recovered(&section, &solution, &load(force, &[("top", volts)]));
    let electric = clamped.electric.as_ref().unwrap();
    let at = |k: usize| clamped.points[k].tensors;
    let case = "held layer";
    all_points(
        (case, "stress"),
        &clamped,
        |k| at(k).stress[0],
        |_| -held,
        held,
    );
    all_points(
        (case, "strain"),
        &clamped,
        |k| at(k).strain[0],
        |_| 0.0,
        strain,
    );
    let flux = (eps - d31 * d31 / s11) * field;
    let found = |k: usize| electric.points[k].displacement.z;
    all_points((case, "Dz"), &clamped, found, |_| flux, flux);
    assert!(clamped.generalized_strain.amax() < EXACT * strain / HEIGHT);
}

/// Bent with both sides at zero volt, `D = d31/s11 kappa z + epsT (1 - k31^2) E` is the
/// same at all z, so that E is linear and V a parabola; `sigma = M z / I` as usual.
#[test]
fn the_potential_inside_of_a_bent_layer_is_a_parabola() {
    let (section, moment) = (layer([4, 3]), 0.2);
    let solution = solved(&section);
    let Constants { s, d, epsT } = constants();
    let (s11, d31, eps) = (s[0][0], d[2][0], epsT[2][2]);
    let k31 = d31 * d31 / (s11 * eps);
    let inertia = WIDTH * HEIGHT.powi(3) / 12.0;
    let curvature = moment * s11 * (1.0 - k31) / inertia;
    let slope = d31 / s11 * curvature / (eps * (1.0 - k31));

    let bent = recovered(&section, &solution, &load(Vector6::ith(4, moment), &[]));
    let electric = bent.electric.as_ref().unwrap();
    let case = "bent layer, short circuit";
    let field = |k: usize| electric.points[k].field.z;
    all_points(
        (case, "Ez"),
        &bent,
        field,
        |[_, z]| -slope * z,
        0.5 * slope * HEIGHT,
    );
    let stress = |k: usize| bent.points[k].tensors.stress[0];
    let largest = 0.5 * moment * HEIGHT / inertia;
    all_points(
        (case, "stress"),
        &bent,
        stress,
        |[_, z]| moment * z / inertia,
        largest,
    );
    let deepest = slope * HEIGHT * HEIGHT / 8.0;
    for ([_, z], found) in section.mesh.nodes.iter().zip(electric.potential.iter()) {
        let expected = 0.5 * slope * (z * z - 0.25 * HEIGHT * HEIGHT);
        assert!(
            (found - expected).abs() < EXACT * deepest.abs(),
            "{found:e} {expected:e}"
        );
    }
    let middle = electric.potential[electric.potential.iamax()];
    let error = (middle / -deepest - 1.0).abs();
    record::value(
        SOURCE,
        case,
        "V in the middle",
        [middle, -deepest],
        error,
        EXACT,
    );
    // means of cells and smoothed nodes reproduce linear fields
    for (state, field) in bent.nodes.iter().zip(&electric.nodes) {
        let z = section.mesh.nodes[state.node][1];
        assert!((field.field.z + slope * z).abs() < EXACT * (slope * HEIGHT).abs());
    }
    for (state, field) in bent.cells.iter().zip(&electric.cells) {
        let error = field.field.z + slope * state.centroid[1];
        assert!(error.abs() < EXACT * (slope * HEIGHT).abs());
    }
    assert!(electric.has_field.iter().all(|has| *has));
}

/// A layer in tension with its upper face open: no charge, so `E = -d31/epsT sigma`.
#[test]
fn an_open_electrode_takes_the_voltage_of_no_charge() {
    let mut section = layer([4, 3]);
    section.electrodes[1].circuit = Circuit::Floating;
    let solution = solved(&section);
    let Constants { d, epsT, .. } = constants();
    let stress = 5.0 / (WIDTH * HEIGHT);
    let field = -d[2][0] / epsT[2][2] * stress;
    let force = Vector6::ith(0, 5.0);
    let pulled = recovered(&section, &solution, &load(force, &[]));
    let electric = pulled.electric.as_ref().unwrap();
    let case = "pulled layer, open circuit";
    all_points(
        (case, "Ez"),
        &pulled,
        |k| electric.points[k].field.z,
        |_| field,
        field,
    );
    let found = |k: usize| pulled.points[k].tensors.stress[0];
    all_points((case, "stress"), &pulled, found, |_| stress, stress);
    assert!((electric.voltages[1] / (-field * HEIGHT) - 1.0).abs() < EXACT);
    let charges = electric.charges.as_ref().unwrap();
    let scale = electric.voltages[1] * epsT[2][2] * WIDTH / HEIGHT;
    assert!((charges[1] / scale).abs() < EXACT);
    let psi = &pulled.generalized_strain;
    let points = &pulled.points;
    assert!((psi[0] - points[0].tensors.strain[0]).abs() < EXACT * psi[0].abs());
}

/// The layer poled along the beam, with fingers of the given spacing over all of it.
fn fingered(spacing: f64) -> Section {
    let mut section = layer([4, 3]);
    // the poled direction 3 along the beam: axes 1 2 3 renamed 2 3 1
    let Constants { s, d, epsT } = constants();
    let axis = |i: usize| (i + 2) % 3;
    let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
    let entry = |i: usize| {
        let (a, b) = (axis(pairs[i].0), axis(pairs[i].1));
        let pair = (a.min(b), a.max(b));
        pairs
            .iter()
            .position(|known| *known == pair)
            .expect("a pair")
    };
    let c = Matrix6::from_fn(|i, j| s[entry(i)][entry(j)]);
    let c = c.try_inverse().expect("regular");
    let strains = Matrix3x6::from_fn(|i, j| d[axis(i)][entry(j)]);
    let at_stress = Matrix3::from_fn(|i, j| epsT[axis(i)][axis(j)]);
    let c = 0.5 * (c + c.transpose());
    section.materials[0].electric = Some(ElectricLaw::of_strains(&strains, &at_stress, &c));
    section.materials[0].law = ElasticLaw::Full(c);
    let cells = 0..section.cells.len() as u32;
    let fingered = cells.map(|cell| FingeredCell {
        cell,
        field: Vector3::new(1.0 / spacing, 0.0, 0.0),
    });
    section.electrodes = vec![Electrode {
        name: "fingers".into(),
        circuit: Circuit::Driven,
        shape: ElectrodeShape::Interdigitated {
            cells: fingered.collect(),
        },
    }];
    section
}

/// Fingers whose field runs along fiber and poling: free `eps = d33 E` without stress, and
/// held `sigma = -d33/s33 E`, `D = epsT E + d33 sigma`.
#[test]
fn a_field_along_the_fiber_between_fingers() {
    let (spacing, volts) = (3e-4, 200.0);
    let section = fingered(spacing);
    let Constants { s, d, epsT } = constants();
    let solution = solved(&section);
    let (s33, d33, eps) = (s[2][2], d[2][2], epsT[2][2]);
    let field = volts / spacing;
    let driven = [("fingers", volts)];

    let free = recovered(&section, &solution, &load(Vector6::zeros(), &driven));
    let case = "fingers, free";
    let electric = free.electric.as_ref().unwrap();
    let held = d33 / s33 * field;
    let strain = d33 * field;
    all_points(
        (case, "Ex"),
        &free,
        |k| electric.points[k].field.x,
        |_| field,
        field,
    );
    let stress = |k: usize| free.points[k].tensors.stress.amax();
    all_points((case, "stress"), &free, stress, |_| 0.0, held);
    let found = |k: usize| free.points[k].tensors.strain[0];
    all_points((case, "strain"), &free, found, |_| strain, strain);
    let found = |k: usize| electric.points[k].material_displacement.x;
    all_points((case, "D1"), &free, found, |_| eps * field, eps * field);
    let charge = electric.charges.as_ref().unwrap()[0];
    let expected = eps * WIDTH * HEIGHT / spacing.powi(2) * volts;
    assert!((charge / expected - 1.0).abs() < EXACT);

    let force = volts * solution.piezo.as_ref().unwrap().electrodes[0].coupling;
    let clamped = recovered(&section, &solution, &load(force, &driven));
    let case = "fingers, held";
    let electric = clamped.electric.as_ref().unwrap();
    let found = |k: usize| clamped.points[k].tensors.stress[0];
    all_points((case, "stress"), &clamped, found, |_| -held, held);
    let flux = (eps - d33 * d33 / s33) * field;
    let found = |k: usize| electric.points[k].displacement.x;
    all_points((case, "D1"), &clamped, found, |_| flux, flux);
}

/// Stresses under forces and voltages have the forces as resultants and satisfy the law at
/// each point, and `at` an integration point gives its state: skew plies, straight and
/// curved, with driven and open electrodes. Round-off of a condition of about 1e4.
#[test]
fn stresses_of_skew_plies_add_up_and_obey_their_law() {
    let straight = InitialCurvature::STRAIGHT;
    for (curvature, circuit) in [
        (straight, Circuit::Driven),
        (curved(), Circuit::Driven),
        (curved(), Circuit::Floating),
    ] {
        let mut section = skew(curvature);
        section.electrodes[1].circuit = circuit;
        let solution = solved(&section);
        let force = Vector6::new(3.0, -2.0, 1.5, 4e-4, -3e-4, 5e-4);
        let volts = match circuit {
            Circuit::Driven => vec![("top", 70.0)],
            _ => Vec::new(),
        };
        let load = load(force, &volts);
        let found = recovered(&section, &solution, &load);
        println!("resultants {:e}", found.resultant_error);
        assert!(found.resultant_error < 1e-10, "{:e}", found.resultant_error);

        let electric = found.electric.as_ref().unwrap();
        let law = section.materials[0].law.stiffness();
        let own = section.materials[0].electric.unwrap();
        let recoverer = Recoverer::new(&section, &solution);
        for (point, state) in found.points.iter().zip(&electric.points) {
            let t = &point.tensors;
            let stress = law * t.material_strain - own.coupling.transpose() * state.material_field;
            let scale = (law * t.material_strain).amax();
            assert!((stress - t.material_stress).amax() < 1e-12 * scale);
            let flux = own.coupling * t.material_strain + own.permittivity * state.material_field;
            let scale = (own.permittivity * state.material_field).amax();
            assert!((flux - state.material_displacement).amax() < 1e-11 * scale);
            assert!((state.field.norm() / state.material_field.norm() - 1.0).abs() < 1e-13);

            let (_, there) = recoverer.at(&load, point.position).unwrap();
            assert!((there.stress - t.stress).amax() < 1e-9 * t.stress.amax());
            let (_, there) = recoverer.electric_at(&load, point.position).unwrap();
            assert!((there.field - state.field).amax() < 1e-9 * state.field.amax());
        }
        // many forces at once, by a different product
        let mut seen = 0;
        let forces = Matrix6xX::from_columns(&[force, 2.0 * force]);
        let bare = recovered(&section, &solution, &self::load(force, &[]));
        recoverer.each_stress(&forces, |block| {
            for (row, point) in block.points().enumerate() {
                let expected = bare.points[point].tensors.stress;
                let stress = block.stress().fixed_view::<6, 1>(6 * row, 1).into_owned();
                assert!((0.5 * stress - expected).amax() < 1e-11 * expected.amax());
                seen += 1;
            }
        });
        assert_eq!(seen, found.points.len());
    }
}

/// The field is minus the slope of the potential at the nodes, by differences along y and z
/// within a cell and, along the beam, by the potential of the force at a neighboring
/// section: `theta' = -k x F, -l x F - k x M`. The step of 1e-6 of a cell has an error of
/// 1e-10 by the truncated second difference and round-off of 1e-16 / 1e-6.
#[test]
fn fields_are_slopes_of_the_potential() {
    for curvature in [InitialCurvature::STRAIGHT, curved()] {
        let section = skew(curvature);
        let solution = solved(&section);
        let force = Vector6::new(3.0, -2.0, 1.5, 4e-4, -3e-4, 5e-4);
        let (f, m) = (force.fixed_rows::<3>(0), force.fixed_rows::<3>(3));
        let (k, l) = (&curvature.curvature, &curvature.slope);
        let along = [-k.cross(&f), -l.cross(&f) - k.cross(&m)];
        let along = Vector6::from_iterator(along.iter().flat_map(|v| v.iter().copied()));
        let case = load(force, &[("top", 70.0)]);
        let here = recovered(&section, &solution, &case).electric.unwrap();
        let next = recovered(&section, &solution, &load(along, &[]))
            .electric
            .unwrap();
        let recoverer = Recoverer::new(&section, &solution);
        let mut checked = 0;
        for cell in &section.mesh.cells {
            let at = |values: &[f64], [r, s]: [f64; 2]| -> f64 {
                let shape = cell.kind.shape(r, s);
                let nodes = cell.nodes().iter().enumerate();
                nodes.map(|(i, &n)| shape.n[i] * values[n as usize]).sum()
            };
            let y: Vec<f64> = section.mesh.nodes.iter().map(|node| node[0]).collect();
            let z: Vec<f64> = section.mesh.nodes.iter().map(|node| node[1]).collect();
            let (r, step) = ([0.3, -0.2], 1e-6);
            let slope = |values: &[f64]| {
                let by = |a: f64, b: f64| {
                    let there = at(values, [r[0] + a * step, r[1] + b * step]);
                    (there - at(values, [r[0] - a * step, r[1] - b * step])) / (2.0 * step)
                };
                nalgebra::Vector2::new(by(1.0, 0.0), by(0.0, 1.0))
            };
            let v = here.potential.as_slice();
            let (dy, dz) = (slope(&y), slope(&z));
            let jacobian = nalgebra::Matrix2::from_rows(&[
                nalgebra::RowVector2::new(dy.x, dz.x),
                nalgebra::RowVector2::new(dy.y, dz.y),
            ]);
            let gradient = jacobian.try_inverse().unwrap() * slope(v);
            let position = [at(&y, r), at(&z, r)];
            let volume = l.x + k.y * position[1] - k.z * position[0];
            let tilt = [l.y - k.x * position[1], l.z + k.x * position[0]];
            let rate = at(next.potential.as_slice(), r);
            let axial = (rate - tilt[0] * gradient.x - tilt[1] * gradient.y) / volume;
            let expected = -Vector3::new(axial, gradient.x, gradient.y);
            let (_, found) = recoverer.electric_at(&case, position).unwrap();
            let error = (found.field - expected).amax() / expected.amax();
            assert!(error < 1e-8, "{error:e}");
            checked += 1;
        }
        assert_eq!(checked, section.cells.len());
    }
}

/// Work of one state on another, `int (eps2 sigma1 - E2 D1) J dA = psi2 theta1 - V2 q1`, of
/// states that are constant along the beam: charges and displacements are consistent with
/// the stresses. Round-off relative to the parts of the integral.
#[test]
fn work_of_the_stresses_on_the_voltages_is_that_of_the_charges() {
    for curvature in [
        InitialCurvature::STRAIGHT,
        // a helix, whose axial force and torque do not change along it
        InitialCurvature {
            curvature: Vector3::new(80.0, 0.0, 0.0),
            slope: Vector3::new(1.0, 0.0, 0.0),
        },
    ] {
        let section = skew(curvature);
        let solution = solved(&section);
        let force = Vector6::new(3.0, 0.0, 0.0, 4e-4, 0.0, 0.0);
        let states = [load(force, &[]), load(Vector6::zeros(), &[("top", 70.0)])]
            .map(|load| recovered(&section, &solution, &load));
        for (one, other) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let (one, other) = (&states[one], &states[other]);
            let fields = [one, other].map(|state| state.electric.as_ref().unwrap());
            let (mut work, mut size) = (0.0, 0.0);
            for (k, point) in one.points.iter().enumerate() {
                let strain = other.points[k].tensors.strain;
                let flux = fields[0].points[k].displacement;
                let parts = [
                    strain.dot(&point.tensors.stress),
                    -fields[1].points[k].field.dot(&flux),
                ];
                work += point.area * (parts[0] + parts[1]);
                size += point.area * (parts[0].abs() + parts[1].abs());
            }
            let charges = fields[0].charges.as_ref().unwrap();
            let voltages = fields[1].voltages.iter().zip(charges);
            let electric: f64 = voltages.map(|(v, q)| v * q).sum();
            let expected = other.generalized_strain.dot(&one.load.force) - electric;
            let error = (work - expected).abs() / size;
            println!("work {work:e} {expected:e} {error:e}");
            assert!(error < 1e-11, "{work:e} {expected:e}");
        }
    }
}

/// Two layers of width `b` and height `t` with opposite poling, their common face ground.
fn bimorph(b: f64, t: f64) -> Section {
    let mesh = Rectangle {
        width: b,
        height: 2.0 * t,
        cells_y: 2,
        cells_z: 40,
        kind: CellKind::Quadrilateral9,
        name: "bimorph".into(),
    };
    let mut section = uniform(&mesh.generate().expect("sound measures"), pzt(), 0.0);
    let mut turned = pzt();
    let electric = turned.electric.as_mut().expect("electric");
    electric.coupling = -electric.coupling;
    section.materials.push(turned);
    for cell in 0..section.cells.len() {
        let above = section.mesh.middle(&section.mesh.cells[cell])[1] > 0.0;
        section.cells[cell].material = usize::from(above);
    }
    // the outer faces at V, the middle at ground: opposite fields, and with opposite poling
    // equal strains; with one of the faces at -V opposite strains
    for (name, circuit, z) in [
        ("middle", Circuit::Ground, 0.0),
        ("top", Circuit::Driven, t),
        ("bottom", Circuit::Driven, -t),
    ] {
        let there = |position: [f64; 2]| (position[1] - z).abs() < 1e-9 * t;
        let electrode = conductor(&section, name, circuit, there);
        section.electrodes.push(electrode);
    }
    section
}

/// Two layers with opposite poling, their common face ground: the narrow bimorph bends, and
/// its layers carry no force; the field is V/t. The bending under voltage differs from the
/// 1-D form `kappa = M / EI` by a few tenths of a percent, since the layers restrain each
/// other across the width near their common face, over a height of about the width.
#[test]
fn a_bimorph_under_voltage_bends_without_force() {
    let (b, t, volts) = (1e-5, 1e-3, 100.0);
    let section = bimorph(b, t);
    let solution = solved(&section);
    let Constants { s, d, epsT } = constants();
    let (s11, d31) = (s[0][0], d[2][0]);
    let k31 = d31 * d31 / (s11 * epsT[2][2]);
    let driven = [("top", volts), ("bottom", -volts)];
    let bent = recovered(&section, &solution, &load(Vector6::zeros(), &driven));
    let electric = bent.electric.as_ref().unwrap();
    let stiffness = b * t.powi(3) / s11 * (0.5 + 1.0 / (6.0 * (1.0 - k31)));
    let moment = b * t * d31 * volts / s11;
    let found = bent.generalized_strain[4];
    let expected = (moment / stiffness).abs();
    let error = (found.abs() / expected - 1.0).abs();
    record::value(
        SOURCE,
        "bimorph",
        "kappa",
        [found.abs(), expected],
        error,
        5e-3,
    );
    assert!(error < 5e-3, "{found:e} {expected:e}");
    assert!(bent.resultant_error < 1e-10);
    // the mean field of each layer is V/t for any stress
    let upper = (bent.points.iter().zip(&electric.points)).filter(|(p, _)| p.position[1] > 0.0);
    let (sum, area) = upper.fold((0.0, 0.0), |(sum, area), (point, state)| {
        (sum + point.area * state.field.z, area + point.area)
    });
    assert!(
        (sum / area / (-volts / t) - 1.0).abs() < 1e-6,
        "{}",
        sum / area
    );
}

/// Voltages for unknown electrodes and for ground, and open electrodes without a reference
/// voltage.
#[test]
fn wrong_voltages_are_reported_with_the_nearest_name() {
    let section = layer([2, 2]);
    let solution = solved(&section);
    let recoverer = Recoverer::new(&section, &solution);
    let failure = |name: &str| {
        let load = load(Vector6::zeros(), &[(name, 1.0)]);
        recoverer.recover(&load).unwrap_err()
    };
    let found = failure("topp");
    assert_eq!(
        found.to_string(),
        "load \"load\" has a voltage for \"topp\", which is not an electrode of the section"
    );
    assert_eq!(found.help().unwrap(), "did you mean \"top\"?");
    assert!(matches!(failure("bottom"), Failure::NotDriven { .. }));
    let wrong = load(Vector6::zeros(), &[("topp", 1.0)]);
    assert_eq!(recoverer.at(&wrong, [0.0; 2]), None);

    let mut open = layer([2, 2]);
    for electrode in &mut open.electrodes {
        electrode.circuit = Circuit::Floating;
    }
    let solution = solved(&open);
    let found = Recoverer::new(&open, &solution).recover(&load(Vector6::ith(0, 1.0), &[]));
    assert_eq!(
        found.unwrap_err().to_string(),
        "the voltages of the open electrodes bottom, top are not determined"
    );

    let mut elastic = layer([2, 2]);
    elastic.electrodes.clear();
    let solution = solved(&elastic);
    let load = load(Vector6::zeros(), &[("top", 1.0)]);
    let found = Recoverer::new(&elastic, &solution).recover(&load);
    assert!(matches!(
        found,
        Err(Failure::UnknownElectrode { nearest: None, .. })
    ));
}

//! Large deflections of beams against exact solutions.
//!
//! Sources: `tests/reference/dynamics/beam_static.json` and `exact_static_beams.json`
//! (shooting on the same rod at round-off; elliptic integrals), see the README there.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use beam_dynamics::analysis::statics::{PathEnd, StaticFailure, statics};
use beam_dynamics::elements::beams::Formulation;
use beam_dynamics::elements::loads::{ImposedMotion, NodalForce, Turning};
use nalgebra::{Matrix3, Rotation3, Vector3, Vector6};
use serde_json::Value;

use crate::chain::{Chain, DEAD, FREE, VOLUMES, up_to};
use crate::record;

const EXACT: &str = "shooting on the same rod, exact_static_beams.json";
const SCRIPT: &str = "same elements in an independent script, beam_static.json";

fn reference(name: &str) -> Value {
    let folder = env!("CARGO_MANIFEST_DIR");
    let file = format!("{folder}/tests/reference/dynamics/{name}");
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_fn(|i, _| value[i].as_f64().unwrap_or(0.0))
}

/// Records and checks a vector, its error relative to its length.
fn check(source: &str, case: &str, [found, expected]: [Vector3<f64>; 2], tolerance: f64) {
    let error = (found - expected).norm() / expected.norm();
    let sizes = [found.norm(), expected.norm()];
    record::value(source, case, "tip", sizes, error, tolerance);
    assert!(error < tolerance, "{case}: {found} {expected} {error:e}");
}

/// A beam along x from a clamped root, and its tip.
pub fn cantilever(elements: usize, length: f64, stiffness: &Vector6<f64>) -> (Chain, usize) {
    cantilever_by(Formulation::Variational, elements, length, stiffness)
}

/// The same in a formulation.
fn cantilever_by(
    formulation: Formulation,
    elements: usize,
    length: f64,
    stiffness: &Vector6<f64>,
) -> (Chain, usize) {
    let mut chain = Chain {
        formulation,
        ..Chain::new()
    };
    let ends = [Vector3::zeros(), Vector3::x() * length];
    let on = chain.straight(None, elements, stiffness, ends, Vector3::z());
    chain.clamp(0);
    (chain, on[2 * elements])
}

/// A section as stiff in bending as in torsion.
pub const ROLLED: Vector6<f64> = Vector6::new(1e4, 1e4, 1e4, 1.0, 1.0, 1.0);

/// Tip of a beam bent by the moment `moment` about z, and its angle.
pub fn rolled(elements: usize, moment: f64, turning: Turning) -> (Vector3<f64>, f64) {
    rolled_by(Formulation::Variational, elements, moment, turning)
}

fn rolled_by(
    formulation: Formulation,
    elements: usize,
    moment: f64,
    turning: Turning,
) -> (Vector3<f64>, f64) {
    let (mut chain, tip) = cantilever_by(formulation, elements, 1.0, &ROLLED);
    let load = NodalForce {
        moment: Vector3::z() * moment,
        turning,
        ..DEAD
    };
    chain.load(tip, load);
    let last = chain.last();
    let axes: Matrix3<f64> = last.rotations[tip];
    (last.positions[tip], axes[(1, 0)].atan2(axes[(0, 0)]))
}

/// Finite volumes. Digits of the file: six; dead and follower moments in the plane are equal.
#[test]
fn a_beam_of_volumes_rolls_up_under_a_tip_moment() {
    let file = &reference("beam_static.json")["roll_up"];
    for elements in [2, 4, 8] {
        let expected = vector(&file["tip_full_circle"][elements.to_string()]);
        let (found, _) = rolled_by(VOLUMES, elements, 2.0 * PI, Turning::Dead);
        let case = format!("full circle, {elements} elements");
        check(SCRIPT, &case, [found, expected], 1e-4);
    }
    let exact = Vector3::new(2.0 / PI, 2.0 / PI, 0.0);
    let mut errors = Vec::new();
    for elements in [2, 4, 8] {
        let (tip, angle) = rolled_by(VOLUMES, elements, FRAC_PI_2, Turning::Follower);
        let error = tip - exact;
        let name = elements.to_string();
        let expected = vector(&file["tip_error_quarter"][&name]);
        assert!((error - expected).norm() < 1e-3 * expected.norm());
        let turned = file["rotation_error_quarter"][&name].as_f64().unwrap();
        assert!((angle - FRAC_PI_2 - turned).abs() < 1e-3 * turned);
        errors.push(error.norm());
    }
    fourth_order("quarter circle", &errors);
}

/// Errors of meshes, each twice as fine as the one before.
fn fourth_order(case: &str, errors: &[f64]) {
    for pair in errors.windows(2) {
        let slope = (pair[0] / pair[1]).log2();
        let error = (slope - 4.0).abs();
        record::value("theory: order 4", case, "slope", [slope, 4.0], error, 0.15);
        assert!(error < 0.15, "{case}: slope {slope}");
    }
}

/// The 45-degree bend of Bathe and Bolourchi: tip under a force along z. `shear` and
/// `twist` are GA and the torsion constant of the unit square.
fn bent(
    formulation: Formulation,
    elements: usize,
    force: f64,
    [shear, twist]: [f64; 2],
) -> Vector3<f64> {
    let stiffness = Vector6::new(1e7, shear, shear, 5e6 * twist, 1e7 / 12.0, 1e7 / 12.0);
    let mut chain = Chain {
        formulation,
        ..Chain::new()
    };
    let on = chain.line(None, elements, &stiffness, |part| {
        let angle = FRAC_PI_4 * part;
        let position = 100.0 * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0);
        let axes = Rotation3::from_axis_angle(&Vector3::z_axis(), angle);
        (position, *axes.matrix())
    });
    let tip = on[2 * elements];
    chain.clamp(0);
    let force = Vector3::z() * force;
    chain.load(tip, NodalForce { force, ..DEAD });
    chain.last().positions[tip]
}

/// Finite volumes to the digits of the script's values, seven, with 1e-6 for the last of them.
/// Sixteen variational elements within 1e-4 of the exact rod, as required by `models.md` of the
/// reference; order 4.
#[test]
fn the_bend_of_45_degrees() {
    let script = &reference("beam_static.json")["bend45"];
    let exact = &reference("exact_static_beams.json")["bathe45"]["results"];
    let square = [5e6, 1.0 / 6.0];
    for force in [300.0, 600.0] {
        let expected = vector(&exact[format!("J=1/6,ks=1,P={force}")]["tip"]);
        let mut errors = Vec::new();
        for elements in [1, 2, 4, 8] {
            let found = bent(VOLUMES, elements, force, square);
            let listed = vector(&script[format!("tip_{force}")][elements.to_string()]);
            let case = format!("45-degree bend, {force} lb, {elements} elements");
            check(SCRIPT, &case, [found, listed], 1e-6);
            if elements > 2 {
                errors.push((found - expected).norm());
            }
        }
        fourth_order(&format!("45-degree bend, {force} lb"), &errors);
    }
    for (key, [shear, twist]) in [
        ("J=1/6,ks=1", square),
        ("J=0.1406,ks=5/6", [5e6 * 5.0 / 6.0, 0.140_577]),
    ] {
        for force in [300, 450, 600] {
            let expected = vector(&exact[format!("{key},P={force}")]["tip"]);
            let found = bent(
                Formulation::Variational,
                16,
                f64::from(force),
                [shear, twist],
            );
            let case = format!("45-degree bend, {key}, {force} lb, 16 elements");
            check(EXACT, &case, [found, expected], 1e-4);
        }
    }
}

/// The Princeton beam: a strip under a tip load at angles to its principal axes, 21 cases.
#[test]
fn the_princeton_beam() {
    let file = &reference("exact_static_beams.json")["princeton"];
    let props = |key: &str| file["props"][key].as_f64().unwrap();
    let stiffness = ["EA", "GA2", "GA3", "GJ", "EIw", "EIs"].map(props);
    for (name, load) in [("P1", 4.448), ("P2", 8.896), ("P3", 13.345)] {
        for degrees in [0, 15, 30, 45, 60, 75, 90] {
            let exact = &file["results"][format!("{name},theta={degrees}")];
            let (mut chain, tip) = cantilever(8, props("L"), &Vector6::from(stiffness));
            let angle = f64::from(degrees).to_radians();
            let force = load * Vector3::new(0.0, angle.cos(), angle.sin());
            chain.load(tip, NodalForce { force, ..DEAD });
            let last = chain.last();
            let found = last.positions[tip] - Vector3::x() * props("L");
            let case = format!("Princeton beam, {load} N at {degrees} deg");
            // Required: 1e-5 of the largest component.
            check(EXACT, &case, [found, vector(&exact["u"])], 1e-5);
            let axes = last.rotations[tip];
            let twist = axes[(2, 1)].atan2(axes[(1, 1)]);
            let expected = exact["twist_atan2_R32_R22"].as_f64().unwrap();
            // Twist relative to the largest of all cases, 0.061.
            let error = (twist - expected).abs() / 0.061;
            record::value(EXACT, &case, "twist", [twist, expected], error, 1e-5);
            assert!(error < 1e-5, "{case}: {twist} {expected}");
        }
    }
}

/// A column beyond its critical load, with a lateral force of 1e-6 of it to choose the side; it
/// moves the tip by about as much. Four elements: 5e-4 of the length.
#[test]
fn the_elastica_past_buckling() {
    let file = &reference("exact_static_beams.json")["elastica_clamped_free"];
    let critical = PI * PI / 4.0;
    for (name, factor) in [("P/Pcr=1.5", 1.5), ("P/Pcr=2", 2.0)] {
        let stiffness = Vector6::new(1e7, 1e7, 1e7, 1.0, 1.0, 1.0);
        let (mut chain, tip) = cantilever(4, 1.0, &stiffness);
        let force = factor * critical * Vector3::new(-1.0, 0.0, 1e-6);
        chain.load(tip, NodalForce { force, ..DEAD });
        let found = chain.last().positions[tip];
        let value = |key: &str| file[name][key].as_f64().unwrap();
        let expected = Vector3::new(value("x/L"), 0.0, value("w/L"));
        let error = (found - expected).norm();
        let (source, sizes) = ("elliptic integrals", [found.norm(), expected.norm()]);
        let case = format!("elastica, {name}, 4 elements");
        record::value(source, &case, "tip", sizes, error, 5e-4);
        assert!(error < 5e-4, "{case}: {found} {expected}");
    }
}

/// Two bars, half of them by symmetry: a bar of length L from the foot of an arch to its apex at
/// height h, which is pushed down. Exact for bars that stay straight: `P = EA (1 - l / L) h / l`,
/// greatest at `l^3 = L b^2` (Mises truss; derived).
struct TwoBars {
    base: f64,
    height: f64,
    length: f64,
}

impl TwoBars {
    const EA: f64 = 1e4;

    fn new() -> Self {
        let (base, height) = (1.0_f64, 0.2);
        Self {
            base,
            height,
            length: base.hypot(height),
        }
    }

    fn load(&self, height: f64) -> f64 {
        let length = self.base.hypot(height);
        Self::EA * (1.0 - length / self.length) * height / length
    }

    fn limit(&self) -> f64 {
        let length = (self.length * self.base * self.base).cbrt();
        self.load((length * length - self.base * self.base).sqrt())
    }

    /// The bar as a beam of one element on pins, with the limit load at the factor one.
    fn chain(&self) -> (Chain, usize) {
        let stiffness = Vector6::new(Self::EA, 1e6, 1e6, 1e3, 1e3, 1e3);
        let mut chain = Chain::new();
        let apex = Vector3::new(self.base, 0.0, self.height);
        let on = chain.straight(None, 1, &stiffness, [Vector3::zeros(), apex], Vector3::z());
        let pin = |x, z| ImposedMotion {
            displacement: [x, Some(0.0), z],
            rotation: [Some(0.0), None, Some(0.0)],
            ..FREE
        };
        chain.impose(on[0], pin(Some(0.0), Some(0.0)));
        chain.impose(on[2], pin(Some(0.0), None));
        let force = -self.limit() * Vector3::z();
        chain.load(on[2], NodalForce { force, ..DEAD });
        (chain, on[2])
    }
}

#[test]
fn a_limit_point_is_reported_without_arc_length() {
    for to in [1.2, 5.0] {
        let outcome = statics(&TwoBars::new().chain().0.model(), &up_to(to));
        let Some(failure) = outcome.failure else {
            panic!(
                "the limit point was passed: {:?}",
                outcome.result.steps.last()
            );
        };
        let last = outcome.result.last().unwrap().factor;
        assert!((0.99..=1.0 + 1e-9).contains(&last), "{last}");
        let reported = failure.to_string();
        assert!(
            reported.starts_with("limit point near the load factor"),
            "{reported}"
        );
        assert!(failure.remedy().contains("arc_length = true"));
        let StaticFailure::Path(PathEnd::LimitPoint { factor, .. }) = failure else {
            panic!("{reported}");
        };
        let error = (factor - 1.0).abs();
        let source = "Mises truss, closed form";
        record::value(
            source,
            "two bars",
            "limit point predicted",
            [factor, 1.0],
            error,
            1e-3,
        );
        assert!(error < 1e-3, "{reported}");
    }
}

/// Every state on the path over the limit point, back to negative loads and up again lies on the
/// closed form; 1e-8 follows from the error of 1e-9 of the iteration in the displacements.
#[test]
fn limit_points_are_passed_by_arc_length() {
    let truss = TwoBars::new();
    let (chain, apex) = truss.chain();
    let mut settings = up_to(1.5);
    settings.arc_length = true;
    let outcome = statics(&chain.model(), &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let steps = &outcome.result.steps;
    let mut worst = 0.0_f64;
    for step in steps {
        let expected = truss.load(step.positions[apex].z) / truss.limit();
        worst = worst.max((step.factor - expected).abs());
    }
    let source = "Mises truss, closed form";
    record::value(
        source,
        "two bars",
        "load on the path",
        [worst, 0.0],
        worst,
        1e-8,
    );
    assert!(worst < 1e-8, "{worst:e}");
    assert_eq!(outcome.result.last().unwrap().factor, 1.5);
    let lowest = steps.iter().map(|step| step.factor).fold(1.0, f64::min);
    assert!(lowest < -0.95, "{lowest}");
    assert_eq!(
        outcome.result.remarks.len(),
        2,
        "{:?}",
        outcome.result.remarks
    );
}

/// Under a pure moment all forces are round-off, under pure tension all moments are: the reported
/// residual is round-off, not a quotient of it. The tolerance follows from the iteration, whose
/// last correction is below 1e-9 and whose error is the square of it; the error of slender elements
/// is 1e-10.
#[test]
fn residuals_of_pure_bending_and_tension_are_round_off() {
    let force = Vector3::x() * 1e3;
    let moment = Vector3::z() * 0.5;
    for load in [NodalForce { moment, ..DEAD }, NodalForce { force, ..DEAD }] {
        let (mut chain, tip) = cantilever(4, 1.0, &ROLLED);
        chain.load(tip, load);
        let result = chain.solve();
        for step in &result.steps {
            println!("{} {:e}", step.factor, step.residual);
            assert!(step.residual < 1e-9, "{}: {:e}", step.factor, step.residual);
        }
    }
}

/// A straight column remains in equilibrium beyond its critical load `pi^2 EI / 4 L^2`, with EI 1e4
/// and L 2 at 6.1685 kN, where both directions buckle; with steps of 2.5 kN the point is predicted
/// up to the curvature of the stiffness over one step.
#[test]
fn an_unstable_equilibrium_is_reported() {
    let column = |to: f64| {
        let stiffness = Vector6::new(1e8, 1e8, 1e8, 1e4, 1e4, 1e4);
        let (mut chain, tip) = cantilever(4, 2.0, &stiffness);
        let force = -1e3 * Vector3::x();
        chain.load(tip, NodalForce { force, ..DEAD });
        let mut settings = up_to(to);
        settings.steps = Some(4);
        let outcome = statics(&chain.model(), &settings);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        outcome.result.remarks
    };
    assert_eq!(column(6.1), [""; 0]);
    let reported = column(10.0);
    assert_eq!(reported.len(), 1, "{reported:?}");
    assert!(reported[0].contains("unstable"));
    let mut words = reported[0].split(' ');
    let factor = words.find_map(|word| word.trim_end_matches(',').parse::<f64>().ok());
    let factor = factor.unwrap();
    let critical = 10.0 * PI * PI / 16.0;
    let error = (factor / critical - 1.0).abs();
    let sizes = [factor, critical];
    record::value(
        "closed form",
        "column",
        "stability lost",
        sizes,
        error,
        0.02,
    );
    assert!(error < 0.02, "{reported:?}");
}

/// The last equilibrium before a limit point is kept although it is not at a requested step.
#[test]
fn the_last_equilibrium_before_a_limit_point_is_kept() {
    let mut settings = up_to(3.0);
    settings.steps = Some(2);
    let outcome = statics(&TwoBars::new().chain().0.model(), &settings);
    assert!(outcome.failure.is_some());
    let factors: Vec<_> = outcome
        .result
        .steps
        .iter()
        .map(|step| step.factor)
        .collect();
    assert_eq!(factors.len(), 2, "{factors:?}");
    assert!((0.99..=1.0 + 1e-9).contains(&factors[1]), "{factors:?}");
}

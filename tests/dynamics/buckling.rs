//! Critical loads by linearized prestress against closed forms.
//!
//! Sources: `tests/reference/dynamics/beam_static.json`; S. P. Timoshenko, J. M. Gere,
//! *Theory of Elastic Stability* ([TimoshenkoGere] of the book).

use std::f64::consts::PI;

use beam_dynamics::analysis::buckling::{BucklingFailure, buckling};
use beam_dynamics::analysis::modes::modes;
use beam_dynamics::case::{BucklingSettings, ModesSettings};
use beam_dynamics::elements::beams::Formulation;
use beam_dynamics::elements::loads::{ImposedMotion, NodalForce, Turning};
use nalgebra::{Vector3, Vector6};

use crate::chain::{Chain, DEAD, FREE, VOLUMES};
use crate::record;

const CLOSED: &str = "closed form, Timoshenko and Gere";

fn factors(chain: Chain, count: usize) -> Vec<f64> {
    let settings = BucklingSettings { speed: 0.0, count };
    let outcome = buckling(&chain.model(), &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    assert_eq!(outcome.result.modes.len(), count);
    for mode in &outcome.result.modes {
        let largest = mode.displacements.iter().map(|d| d.norm());
        assert!((largest.fold(0.0, f64::max) - 1.0).abs() < 1e-12);
        // Above 1e-5 a remark reports lost digits.
        assert!(mode.residual < 1e-5, "{}", mode.residual);
    }
    outcome
        .result
        .modes
        .iter()
        .map(|mode| mode.factor)
        .collect()
}

fn check(source: &str, case: &str, [found, expected]: [f64; 2], tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    record::value(
        source,
        case,
        "critical load",
        [found, expected],
        error,
        tolerance,
    );
    assert!(error < tolerance, "{case}: {found} {expected} {error:e}");
}

/// Shear stiffness of the columns.
const SHEAR: f64 = 1e6;

/// A column along x under the tip force `sign` along x.
fn column(elements: usize, sign: f64) -> Chain {
    column_by(Formulation::Variational, elements, sign)
}

fn column_by(formulation: Formulation, elements: usize, sign: f64) -> Chain {
    let stiffness = Vector6::new(1e7, SHEAR, SHEAR, 1.0, 1.0, 1.0);
    let mut chain = Chain {
        formulation,
        ..Chain::new()
    };
    let ends = [Vector3::zeros(), Vector3::x()];
    let on = chain.straight(None, elements, &stiffness, ends, Vector3::z());
    chain.clamp(0);
    let force = sign * Vector3::x();
    chain.load(on[2 * elements], NodalForce { force, ..DEAD });
    chain
}

/// The load of a column without shear from the load of a column with shear: the section force turns
/// with the section, so that `P (1 + P / GA)` replaces P everywhere.
fn without_shear(load: f64) -> f64 {
    load * (1.0 + load / SHEAR)
}

/// One element has `6 (5 -+ sqrt 21) EI / L^2` in both formulations, derived by hand: round-off,
/// 1e-9. Two and four finite volumes agree with an independent script, whose prestress is computed
/// by difference quotients: six digits. Two and four variational elements have the errors listed in
/// `variational_beam`, to three digits; four are within 1e-4 of `pi^2 EI / 4 L^2`. Both bending
/// directions buckle at the same load.
#[test]
fn a_clamped_column_of_few_elements() {
    let root = 21.0_f64.sqrt();
    let script = "same elements in an independent script, beam_static.json";
    let formula = "one element, 6 (5 -+ sqrt 21)";
    let one = [6.0 * (5.0 - root), 6.0 * (5.0 + root)];
    for (formulation, elements, source, tolerance, expected) in [
        (Formulation::Variational, 1, formula, 1e-9, one),
        (VOLUMES, 1, formula, 1e-9, one),
        (VOLUMES, 2, script, 1e-6, [2.469_922, 23.767_537]),
        (VOLUMES, 4, script, 2e-6, [2.467_559, 22.317_134]),
    ] {
        let found = factors(column_by(formulation, elements, -1.0), 4);
        for (pair, expected) in found.chunks(2).zip(expected) {
            let case = format!("column of {elements} elements, {expected:.3}");
            for &load in pair {
                check(source, &case, [without_shear(load), expected], tolerance);
            }
        }
    }
    for (elements, listed) in [(2, 1.020_986_957e-3), (4, 6.547_605_6e-5)] {
        let load = without_shear(factors(column(elements, -1.0), 1)[0]);
        let expected = PI * PI / 4.0 * (1.0 + listed);
        let case = format!("column of {elements} variational elements");
        check("variational_beam", &case, [load, expected], 1e-2 * listed);
    }
    let load = without_shear(factors(column(4, -1.0), 1)[0]);
    check(CLOSED, "column of 4 elements", [load, PI * PI / 4.0], 1e-4);
}

/// Under tension the same column buckles at the negative factor.
#[test]
fn a_load_turned_round_has_the_negative_factor() {
    let (pushed, pulled) = (factors(column(2, -1.0), 2), factors(column(2, 1.0), 2));
    for (pushed, pulled) in pushed.iter().zip(&pulled) {
        assert!((pushed + pulled).abs() < 1e-9 * pushed.abs());
    }
}

/// Euler's column on pins, which are imposed displacements: four elements of order four per half
/// wave, as eight per clamped column.
#[test]
fn a_column_on_pins() {
    let stiffness = Vector6::new(1e7, SHEAR, SHEAR, 1.0, 2.0, 1.0);
    let mut chain = Chain::new();
    let ends = [Vector3::zeros(), Vector3::x()];
    let on = chain.straight(None, 8, &stiffness, ends, Vector3::z());
    let pin = |x| ImposedMotion {
        displacement: [x, Some(0.0), Some(0.0)],
        rotation: [x, None, None],
        ..FREE
    };
    chain.impose(on[0], pin(Some(0.0)));
    chain.impose(on[16], pin(None));
    let force = -Vector3::x();
    chain.load(on[16], NodalForce { force, ..DEAD });
    let found = factors(chain, 2);
    let euler = PI * PI;
    check(
        CLOSED,
        "pinned column, soft side",
        [without_shear(found[0]), euler],
        1e-4,
    );
    check(
        CLOSED,
        "pinned column, stiff side",
        [without_shear(found[1]), 2.0 * euler],
        1e-4,
    );
}

/// A portal on hinged feet, all members equal, a load on each column: it sways where `k h tan(k h)
/// = 6`, k^2 = P / EI (a column with the end stiffness 6 EI / b of the beam bent into an S). Solved
/// here by bisection. Four elements per member.
#[test]
fn a_portal_frame_sways() {
    let (mut low, mut high) = (1.0_f64, 1.5_f64);
    while high - low > 1e-14 {
        let middle = 0.5 * (low + high);
        if middle * middle.tan() < 6.0 {
            low = middle
        } else {
            high = middle
        }
    }
    // Stiff out of the plane, so that the frame buckles in its plane.
    let stiffness = Vector6::new(1e7, SHEAR, SHEAR, 1e3, 1.0, 1e3);
    let [a, b] = [Vector3::zeros(), Vector3::z()];
    let [c, d] = [Vector3::new(1.0, 0.0, 1.0), Vector3::x()];
    let mut chain = Chain::new();
    // The second section axis of all members is normal to the frame.
    let left = chain.straight(None, 4, &stiffness, [a, b], -Vector3::x());
    let beam = chain.straight(Some(left[8]), 4, &stiffness, [b, c], Vector3::z());
    let right = chain.straight(Some(beam[8]), 4, &stiffness, [c, d], Vector3::x());
    for foot in [left[0], right[8]] {
        let hinge = ImposedMotion {
            displacement: [Some(0.0); 3],
            rotation: [Some(0.0), None, Some(0.0)],
            ..FREE
        };
        chain.impose(foot, hinge);
    }
    for top in [left[8], beam[8]] {
        let force = -Vector3::z();
        chain.load(top, NodalForce { force, ..DEAD });
    }
    let found = without_shear(factors(chain, 1)[0]);
    // Order four, as the clamped column of the same elements with 6.4e-5.
    check(CLOSED, "portal frame on hinges", [found, low * low], 2e-4);
}

/// A strip clamped at one end, with a force in its plane at the other, tips over at `4.0126 sqrt(EI
/// GJ) / L^2`, for both signs of the force (Prandtl, Michell). The strip is 1e6 times stiffer in
/// its plane. The constant has five digits.
#[test]
fn a_strip_tips_over() {
    let stiffness = Vector6::new(1e8, 1e8, 1e8, 2.0, 1e6, 0.5);
    let mut chain = Chain::new();
    let ends = [Vector3::zeros(), Vector3::x()];
    let on = chain.straight(None, 16, &stiffness, ends, Vector3::z());
    chain.clamp(0);
    let force = Vector3::z();
    chain.load(on[32], NodalForce { force, ..DEAD });
    let found = factors(chain, 2);
    assert!(
        (found[0] + found[1]).abs() < 1e-6 * found[0].abs(),
        "{found:?}"
    );
    check(
        CLOSED,
        "strip tipping over",
        [found[0].abs(), 4.012_6],
        1e-4,
    );
}

/// At the critical load of a turning blade pushed along its span the lowest frequency is zero: two
/// methods for the same load. The frequency is the root of a quantity that vanishes there.
#[test]
fn the_lowest_frequency_of_a_turning_blade_vanishes_at_its_critical_load() {
    use crate::uniform_beam::{Inertia, UniformBeam};
    let speed = 2.0;
    let model = |load: f64| {
        let beam = UniformBeam::slender(6, Inertia::Consistent);
        let nodes = beam.nodes();
        let mut elements = beam.elements(&nodes);
        let force = -load * Vector3::x();
        let load = NodalForce { force, ..DEAD };
        let load = beam_dynamics::elements::loads::NodalLoad::new("load", 12, &nodes[12], load);
        elements.push(Box::new(load));
        beam_dynamics::case::Model::new(
            "blade",
            beam_dynamics::assembly::System::new(nodes, elements),
        )
    };
    let settings = BucklingSettings { speed, count: 1 };
    let outcome = buckling(&model(1.0), &settings);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let critical = outcome.result.modes[0].factor;
    // Turning stiffens.
    assert!(critical > PI * PI / 4.0 && critical < 4.0, "{critical}");
    let squares = [0.98, 0.99].map(|part| {
        let outcome = modes(&model(part * critical), &ModesSettings::new(vec![speed], 1));
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        (2.0 * PI * outcome.table.at_speed(0)[0].1.frequency).powi(2)
    });
    // The square of the frequency falls linearly to zero at the critical load; the error is the
    // curvature over a hundredth of it.
    let at = 0.99 + 0.01 * squares[1] / (squares[0] - squares[1]);
    let source = "modes about the loaded equilibrium";
    check(
        source,
        "turning blade pushed along its span",
        [1.0, at],
        1e-3,
    );
}

/// Loads that do not grow, and bending alone, have no critical load.
#[test]
fn no_load_and_no_prestress_are_reported() {
    let stiffness = Vector6::new(1e7, 1e6, 1e6, 1.0, 1.0, 1.0);
    let mut chain = Chain::new();
    let ends = [Vector3::zeros(), Vector3::x()];
    chain.straight(None, 1, &stiffness, ends, Vector3::z());
    chain.clamp(0);
    let settings = BucklingSettings {
        speed: 0.0,
        count: 1,
    };
    let outcome = buckling(&chain.model(), &settings);
    assert!(matches!(outcome.failure, Some(BucklingFailure::NoLoad)));
}

/// A column under a force that follows its tip has no equilibrium other than the straight one
/// (Beck; Timoshenko and Gere, section 2.21): it flutters, which statics does not show.
#[test]
fn a_follower_load_has_no_real_factor() {
    let mut chain = Chain::new();
    let stiffness = Vector6::new(1e7, SHEAR, SHEAR, 1.0, 1.0, 1.0);
    let ends = [Vector3::zeros(), Vector3::x()];
    let on = chain.straight(None, 4, &stiffness, ends, Vector3::z());
    chain.clamp(0);
    let load = NodalForce {
        force: -Vector3::x(),
        turning: Turning::Follower,
        ..DEAD
    };
    chain.load(on[8], load);
    let settings = BucklingSettings {
        speed: 0.0,
        count: 2,
    };
    let failure = buckling(&chain.model(), &settings).failure.unwrap();
    assert!(
        matches!(failure, BucklingFailure::NoRealFactor),
        "{failure}"
    );
    assert!(failure.to_string().contains("flutter"), "{failure}");
    assert!(failure.remedy().contains("[modes]"));
}

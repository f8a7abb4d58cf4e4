//! Two slender links on spherical joints (models.md, C).

use super::models::{Kept, bipendulum, run, states};
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::case::TransientSettings;
use beam_dynamics::integrator::{Jacobians, Scheme, StepControl, Stepping};
use beam_dynamics::model::State;

/// Largest spin of a link about its own axis \[rad/s\].
fn spin(states: &[State]) -> f64 {
    let nodes = states.iter().flat_map(|state| &state.nodes);
    let spins = nodes.map(|node| (node.rotation.transpose() * node.angular_velocity).y.abs());
    spins.fold(0.0, f64::max)
}

/// Positions of the two centers, and forces of the ground on the first link and of the
/// first on the second: the rows of a spherical joint are `p_b - p_a`, along the axes of the
/// model here, and `-lambda` is the force on b, the first link or the second.
fn row(state: &State) -> [f64; 12] {
    let mut row = [0.0; 12];
    for i in 0..3 {
        row[i] = state.nodes[0].position[i];
        row[3 + i] = state.nodes[1].position[i];
        row[6 + i] = -state.multipliers[i];
        row[9 + i] = -state.multipliers[3 + i];
    }
    row
}

// tests/reference/dynamics/bipendulum.csv, an independent ODE at 1e-11, at t = 0.6.
const AT_06: [f64; 12] = [
    -0.376648187114,
    0.295858808244,
    -0.14353992033,
    -1.20046975222,
    0.81239944966,
    -0.25053536738,
    19.1495730627,
    -16.9390515182,
    14.0442107294,
    18.948598411,
    -11.5848437135,
    0.916720985563,
];

fn errors(radius: f64, h: f64) -> (f64, f64, f64) {
    let mut settings = TransientSettings::new(0.6, h);
    settings.scheme = Scheme::TwoStep { radius };
    let (kept, outcome) = run(&bipendulum(), &settings);
    if outcome.failure.is_some() {
        return (f64::NAN, f64::NAN, spin(&kept.states));
    }
    let found = row(kept.states.last().unwrap());
    let off = |range: std::ops::Range<usize>| {
        let differences = range.map(|i| (found[i] - AT_06[i]).abs());
        differences.fold(0.0, f64::max)
    };
    (off(0..6), off(6..12), spin(&kept.states))
}

// Prototype, dynamics theory 5, radius 0.6: 1.7e-4, 4.3e-5, 1.1e-5 m and, for the reactions,
// 1.8e-2, 4.6e-3, 1.1e-3 N at h = 2, 1, 0.5 ms, second order in both.
#[test]
fn positions_and_reactions_are_of_second_order() {
    let found = [0.002, 0.001, 0.0005].map(|h| errors(0.6, h));
    let [coarse, fine, finest] = found;
    assert!(fine.0 < 5e-5 && fine.1 < 5e-3, "{fine:?}");
    assert!(finest.0 < 1.2e-5 && finest.1 < 1.2e-3, "{finest:?}");
    for (two, one) in [(coarse, fine), (fine, finest)] {
        for order in [(two.0 / one.0).log2(), (two.1 / one.1).log2()] {
            assert!((order - 2.0).abs() < 0.05, "{order}");
        }
    }
}

// No moment turns a link about its axis, of which the moment of inertia is 1/308 of the
// others: the spin is round-off, also where a step turns a link by 0.1 rad. With the angular
// momentum integrated in space it is 0.14 rad/s at 2 ms, and the run fails at 3 ms (0.6) or
// at 0.5 ms (0.9).
#[test]
fn slender_links_do_not_spin_at_large_steps() {
    for radius in [0.0, 0.3, 0.6, 0.9] {
        let [fine, coarse] = [0.003, 0.005].map(|h| errors(radius, h));
        for found in [fine, coarse] {
            assert!(found.2 < 1e-8, "{radius}: {found:?}");
        }
        let order = (coarse.0 / fine.0).ln() / (5.0_f64 / 3.0).ln();
        assert!((order - 2.0).abs() < 0.1, "{radius}: {order}");
    }
}

// At the start the ground pulls by 14.608 N along y, and by 3.7396 N along z. Afterwards the force
// grows with the square of the time, by 1.162 N in 25 ms (ODE): this is negligible in the first
// steps, which must not oscillate by more than the error of the scheme.
#[test]
fn the_first_reactions_do_not_oscillate() {
    let found = states(&bipendulum(), &TransientSettings::new(0.01, 0.001));
    let start = row(&found[0]);
    for (i, state) in found.iter().enumerate() {
        let t = 0.001 * i as f64;
        let smooth = 14.608 + 1.162 * (t / 0.025).powi(2);
        let now = row(state)[7];
        assert!((now - smooth).abs() < 0.005, "{i}: {now} {smooth}");
    }
    assert!((start[7] - 14.608).abs() < 1e-9);
    assert!((start[8] - 3.739630073).abs() < 1e-8);
}

// The reference sizes of steps and errors, and the long axes of the links, belong to the model and
// not to the state at which a run is continued: both parts are identical to the last bit for any
// time of continuation, with equal and with variable steps.
#[test]
fn a_continued_run_of_slender_links_is_the_same_to_the_last_bit() {
    let model = bipendulum();
    let control = StepControl {
        first: 1e-3,
        least: 1e-8,
        most: 0.02,
        tolerance: 1e-5,
    };
    for (stepping, jacobians) in [
        (Stepping::Constant { step: 0.005 }, Jacobians::Full),
        (Stepping::Variable(control), Jacobians::Full),
        (Stepping::Variable(control), Jacobians::Modified),
    ] {
        let mut settings = TransientSettings::new(0.4, 0.005);
        settings.stepping = stepping;
        settings.newton.jacobians = jacobians;
        for at in [3, 17, 29] {
            let mut whole = Kept {
                wanted: Some(at),
                ..Kept::default()
            };
            let outcome = transient(&model, &settings, None, &mut whole, &|| 0.0);
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            let snapshot = whole.snapshot.take().unwrap();
            let mut rest = Kept::default();
            transient(&model, &settings, Some(&snapshot), &mut rest, &|| 0.0);
            assert!(!rest.times.is_empty());
            assert_eq!(whole.times[at + 1..], rest.times, "{stepping:?} {at}");
            assert_eq!(whole.states[at + 1..], rest.states, "{stepping:?} {at}");
        }
    }
}

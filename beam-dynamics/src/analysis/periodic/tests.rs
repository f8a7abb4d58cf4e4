//! The linearized period against differences of the period.

#![allow(
    clippy::unwrap_used,
    reason = "tests end when a model cannot be analyzed"
)]

use super::flow::Flow;
use super::sizes::{seen, sizes};
use crate::analysis::transient::start;
use crate::case::PeriodicSettings;
use crate::input::parse;
use crate::model::State;

/// A driven shaft with two bars on hinges, a spring with damping between them, gravity across the
/// shaft, and a lag of the motion that acts back.
const CARDS: &str = "
[units]
angle = \"rad\"
rotation_speed = \"rad/s\"
[[node]]
name = \"shaft\"
position = [0, 0, 0]
angular_velocity = [0, 0, 3]
[[node]]
name = \"first\"
position = [0.5, 0, 0.1]
velocity = [0, 1.5, 0.4]
angular_velocity = [0, -0.8, 3]
[[node]]
name = \"second\"
position = [1.1, 0.2, 0.1]
velocity = [-0.6, 3.3, 0.7]
angular_velocity = [0.3, -0.8, 3.4]
[[body]]
name = \"shaft\"
node = \"shaft\"
mass = 3
inertia = [1, 1, 1]
[[body]]
name = \"first\"
node = \"first\"
mass = 2
inertia = [0.05, 0.3, 0.4]
[[body]]
name = \"second\"
node = \"second\"
mass = 1
inertia = [0.2, 0.1, 0.15]
[[joint]]
name = \"drive\"
kind = \"revolute\"
nodes = [\"shaft\"]
axis = [0, 0, 1]
angle = \"= 3*t + 0.2*sin(3*t)\"
[[joint]]
name = \"flap\"
kind = \"revolute\"
nodes = [\"shaft\", \"first\"]
at = [0.1, 0, 0]
axis = [0, 1, 0]
[[joint]]
name = \"ball\"
kind = \"spherical\"
nodes = [\"first\", \"second\"]
at = [0.8, 0.1, 0.1]
[[spring]]
name = \"spring\"
nodes = [\"first\", \"second\"]
at = [0.8, 0.1, 0.1]
rotational_stiffness = [3, 4, 5]
rotational_damping = [0.1, 0.2, 0.3]
[sensors.height]
quantity = \"position\"
of = \"second\"
component = \"z\"
unit = \"m\"
[[state_space]]
name = \"lag\"
inputs = [\"height\"]
outputs = [\"push\"]
numerator = [3]
denominator = [0.2, 1]
[[load]]
node = \"second\"
force = [0, 0, -1]
drive = \"= push\"
[gravity]
acceleration = [0, -9.81, 0]
[periodic]
period = 2
";

/// Pseudorandom numbers between -1 and 1.
fn scattered(count: usize, seed: usize) -> Vec<f64> {
    (0..count)
        .map(|i| (1.0 + 12.9898 * (i + 1) as f64 + 78.233 * seed as f64).sin() * 43758.5453)
        .map(|x| 2.0 * (x - x.floor()) - 1.0)
        .collect()
}

// Fourth-order central differences of three steps: errors are below 1e-9 with the tolerance 1e-12 of
// the iteration divided by the difference 1e-3, times a few.
#[test]
fn the_map_is_the_derivative_of_the_steps() {
    const SMALL: f64 = 1e-3;
    let input = parse(CARDS, "model.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    let model = &input.model;
    for three_stages in [true, false] {
        let settings = PeriodicSettings {
            three_stages,
            ..PeriodicSettings::new(0.06, 3)
        };
        let state = start(model, &settings.start).unwrap().state;
        let mut flow = Flow::new(model, &settings, 3, &state);
        let (end, map) = flow.linearized(&state).unwrap();
        let map = map.unwrap();
        let conditions = model.conditions_at(0.0);
        let sizes = sizes(model, (&state, &conditions), map.algebraic(), 1.0);
        for seed in 0..20 {
            let scaled = scattered(map.size(), seed).into_iter().zip(&sizes);
            let d: Vec<_> = scaled
                .zip(map.algebraic())
                .map(|((x, size), is)| if *is { 0.0 } else { 0.3 * x * size })
                .collect();
            let mut after = |factor: f64| {
                let moved: Vec<_> = d.iter().map(|d| factor * SMALL * d).collect();
                let mut begun: State = state.clone();
                begun.correct(&moved);
                let later = flow.run(&begun, &mut |_| true).unwrap();
                seen(&later, &end, map.algebraic())
            };
            let [a, b, c, e] = [1.0, -1.0, 2.0, -2.0].map(&mut after);
            let mut found = d.clone();
            map.apply(&mut found).unwrap();
            let largest = found
                .iter()
                .zip(&sizes)
                .map(|(f, s)| (f / s).abs())
                .fold(0.0, f64::max);
            for i in 0..found.len() {
                let difference = (8.0 * (a[i] - b[i]) - (c[i] - e[i])) / (12.0 * SMALL);
                let off = (difference - found[i]).abs() / sizes[i];
                assert!(
                    off < 1e-8 * largest.max(1.0),
                    "{seed} {i}: {difference} {}",
                    found[i]
                );
            }
        }
    }
}

// Three bodies have 18 freedoms, and 6 + 5 + 3 constraints, the drive among them, leave four: eight
// states, with the lag nine, as many as two steps leave of 37 unknowns with a rate.
#[test]
fn two_steps_leave_the_independent_states() {
    let text = CARDS.to_owned() + "[periodic.floquet]\ncount = 30\nerror_estimate = false\n";
    let input = parse(&text, "model.dynamics.toml").unwrap_or_else(|problems| panic!("{problems}"));
    let model = &input.model;
    let settings = PeriodicSettings::new(0.06, 3);
    let state = start(model, &settings.start).unwrap().state;
    let mut flow = Flow::new(model, &settings, 3, &state);
    let (_, map) = flow.linearized(&state).unwrap();
    let map = map.unwrap();
    let sizes = vec![1.0; map.size()];
    let monodromy = super::floquet::Monodromy {
        map: &map,
        sizes: &sizes,
        held: &[],
    };
    let found = super::floquet::multipliers(&monodromy, 40).unwrap();
    assert_eq!(found.dimension, Some(9), "{:?}", found.pairs);
}

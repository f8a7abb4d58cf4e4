//! A rotating beam that flaps about its equilibrium, by steps in time.
//!
//! Source: `tests/reference/dynamics/rotating_beam_in_time.json`: a beam of two finite-volume
//! elements, clamped to a hub that is driven at eta = 6, from its equilibrium with the velocity of
//! the first flap mode; the frequency fitted to the motion of the tip, and the frequency of the
//! modes.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::case::ModesSettings;
use beam_dynamics::integrator::Stepping;
use nalgebra::Vector3;

use crate::in_time::{Run, json};
use crate::record;

const SOURCE: &str = "the same elements in an independent script";
const CASE: &str = "rotating beam, eta = 6, 2 elements";
/// Speed of the hub \[rad/s\].
pub const SPEED: f64 = 6.0;
/// Error of a frequency w by the two-step formula of radius 0.6 with beta = 1/3, over (w h)^2: its
/// constant 0.132 by 1 + beta.
const OF_FORMULA: f64 = 0.099;
/// Largest displacement of the tip.
const AMPLITUDE: f64 = 1e-3;
/// Three periods, 0.855 s each.
const TO: f64 = 2.6;

/// The beam, with a place for cards of its hub.
pub const BEAM: &str = r#"name = "rotating beam"
units = { length = "m", force = "N", angle = "rad", rotation_speed = "rad/s" }

[properties.beam]
ea = 1e5
gay = 1e4
gaz = 1e4
gj = 1
eiy = 1
eiz = 1
m = 1
iy = 5e-4
iz = 5e-4

[hub]
axis = [0, 0, 1]
HUB

[[blade]]
name = "beam"
hub_radius = 0
properties = "beam"
formulation = "finite-volume"

[[blade.piece]]
length = 1
elements = 2
"#;

/// The hub as a driven body on a bearing.
const TURNED: &str = r#"mass = 1
inertia = [1, 1, 1]
support = { torsion = 0 }

[[joint]]
name = "drive"
kind = "spin"
nodes = ["hub"]
axis = [0, 0, 1]
angle = "= 6 * t"

[transient]
to = 2.6
step = 0.005
start = "rotating"
speed = "6 rad/s"
"#;

fn file(folder: &tempfile::TempDir, hub: &str) -> std::path::PathBuf {
    let path = folder.path().join("a.dynamics.toml");
    std::fs::write(&path, BEAM.replace("HUB", hub)).unwrap();
    path
}

/// Motion of a node in a mode with a tip displacement of one.
struct Part {
    node: String,
    displacement: Vector3<f64>,
    rotation: Vector3<f64>,
}

/// Frequency of the first flap mode \[rad/s\], and the mode.
fn first_flap() -> (f64, Vec<Part>) {
    let folder = tempfile::tempdir().unwrap();
    let input = beam_dynamics::input::read(&file(&folder, "")).unwrap();
    let mut settings = ModesSettings::new(vec![SPEED], 4);
    settings.shapes = vec![SPEED];
    let outcome = modes(&input.model, &settings);
    let branches = outcome.table.branches.into_iter();
    let mut flap = branches.filter(|branch| branch.name == "flap 1");
    let point = flap.next().unwrap().points.remove(0).unwrap();
    let shape = point.shape.unwrap();
    let tip = shape.displacements.last().unwrap()[2].re;
    let real = |v: &[nalgebra::Complex<f64>; 3]| Vector3::from(v.map(|part| part.re / tip));
    let nodes = input.model.system.nodes().iter();
    let moves = shape.displacements.iter().zip(&shape.rotations);
    let parts = nodes.zip(moves).map(|(node, (u, turn))| Part {
        node: node.label.clone(),
        displacement: real(u),
        rotation: real(turn),
    });
    (std::f64::consts::TAU * point.frequency, parts.collect())
}

/// Height of the tip step by step.
fn heights(step: f64, frequency: f64, mode: &[Part]) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    let input = beam_dynamics::input::read(&file(&folder, TURNED)).unwrap();
    let mut settings = input.transient.unwrap();
    settings.to = TO;
    settings.stepping = Stepping::Constant { step };
    let mut model = input.model;
    for (node, initial) in model.system.nodes().iter().zip(&mut model.initial) {
        if let Some(part) = mode.iter().find(|part| part.node == node.label) {
            initial.velocity = Some(AMPLITUDE * frequency * part.displacement);
            initial.angular_velocity = Some(AMPLITUDE * frequency * part.rotation);
        }
    }
    let run = Run::of(model, &settings, 1);
    run.check_end();
    let tip = run.node("beam/tip");
    let height = |state: &beam_dynamics::model::State| state.nodes[tip].position.z;
    run.instants
        .iter()
        .map(|(_, state)| height(state))
        .collect()
}

/// Growth s and frequency w of numbers at equal distances of time: the numbers of a sine that grows
/// fulfill `z(t + d) = a z(t) - b z(t - d)` with `a = 2 e^(s d) cos(w d)` and `b = e^(2 s d)`, here
/// in the mean of squares and with d a sixth of the period.
pub fn fitted(heights: &[f64], step: f64, near: f64) -> [f64; 2] {
    let lag = (std::f64::consts::PI / (3.0 * near * step)).round() as usize;
    let mut sums = [0.0; 5];
    for i in lag..heights.len() - lag {
        let [before, now, after] = [i - lag, i, i + lag].map(|i| heights[i]);
        let terms = [
            now * now,
            now * before,
            before * before,
            now * after,
            before * after,
        ];
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| *sum += term);
    }
    let [aa, ab, bb, right_a, right_b] = sums;
    let det = aa * bb - ab * ab;
    let a = (bb * right_a - ab * right_b) / det;
    let b = (ab * right_a - aa * right_b) / det;
    let time = lag as f64 * step;
    [b.ln() / (2.0 * time), (a / (2.0 * b.sqrt())).acos() / time]
}

/// The frequency of the modes to the digits of different iterations; the fitted one, here in axes that
/// turn with the beam and in the script in space, to the error of the formula for an oscillator; second
/// order to the modal value.
#[test]
fn a_rotating_beam_flaps_with_the_frequency_of_its_mode() {
    let data = json("rotating_beam_in_time.json");
    let (frequency, mode) = first_flap();
    let modal = data["modal_flap1"].as_f64().unwrap();
    let error = (frequency / modal - 1.0).abs();
    record::value(
        SOURCE,
        CASE,
        "first flap, modes",
        [frequency, modal],
        error,
        1e-6,
    );
    assert!(error < 1e-6, "{frequency} {modal}");
    let off = [0.01, 0.005].map(|step| {
        let [_, found] = fitted(&heights(step, frequency, &mode), step, frequency);
        let expected = data["fitted_flap1"][step.to_string()].as_f64().unwrap();
        let quantity = format!("first flap, steps of {step}");
        let of_formula = OF_FORMULA * (frequency * step).powi(2);
        let in_space = (expected / modal - 1.0).abs();
        let error = (found / modal - 1.0).abs();
        record::value(SOURCE, CASE, &quantity, [found, modal], error, of_formula);
        assert!(
            error.max(in_space) < of_formula,
            "{step}: {found} {expected}"
        );
        error
    });
    let order = (off[0] / off[1]).log2();
    record::order(SOURCE, CASE, "order of the frequency", order, 1.9);
    assert!(order > 1.9, "{off:?}");
}

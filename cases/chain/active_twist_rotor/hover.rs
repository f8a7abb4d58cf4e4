//! Hover and frequencies: equilibria of the turning rotor, and modes of a blade in vacuum.

use std::f64::consts::TAU;
use std::path::Path;

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::elements::RotorAir;
use beam_dynamics::input::Input;
use beam_dynamics::result::StaticResult;
use shared_geom::rotation::vector;

use super::Result;
use super::motion::read;

/// Speed of the rotor \[rad/s\].
pub const SPEED: f64 = 22.25;

/// Names of the modes of Table 13.6 and of ours.
pub const MODES: [[&str; 2]; 6] = [
    ["1st flap", "flap 1"],
    ["2nd flap", "flap 2"],
    ["3rd flap", "flap 3"],
    ["4th flap", "flap 4"],
    ["1st twist", "torsion 1"],
    ["2nd twist", "torsion 2"],
];

/// Frequencies of [`MODES`] with a set of properties, per revolution; not a number if there is none.
///
/// # Errors
/// A file that cannot be read, or modes that are not found.
pub fn frequencies(case: &Path, set: &str) -> Result<[f64; 6]> {
    let input = read(&case.join("frequencies.dynamics.toml"), set, &[])?;
    let settings = input.modes.as_ref().ok_or("[modes] is absent")?;
    let outcome = modes(&input.model, settings);
    if let Some(failure) = outcome.failure {
        return Err(failure.to_string());
    }
    let found = outcome.table.at_speed(0);
    Ok(MODES.map(|[_, name]| {
        let mode = found.iter().find(|(branch, _)| branch.stem() == name);
        mode.map_or(f64::NAN, |(_, point)| point.frequency * TAU / SPEED)
    }))
}

/// Blade 1 and the thrust in hover.
#[derive(Debug, Clone, Copy)]
pub struct Hover {
    /// Height of the tip above the hub \[m\].
    pub tip: f64,
    /// Angle of the flap hinge \[rad\].
    pub flap: f64,
    /// Pitch of the root section against the plane of the disk \[rad\].
    pub pitch: f64,
    /// Elastic twist from root to tip, nose up \[rad\].
    pub twist: f64,
    /// Thrust \[N\].
    pub thrust: f64,
}

/// Hover with a set of properties and values of parameters, as `collective` \[deg\] and `volts`.
///
/// # Errors
/// A file that cannot be read, or no equilibrium.
pub fn hover(case: &Path, set: &str, given: &[(&str, f64)]) -> Result<Hover> {
    let input = read(&case.join("hover.dynamics.toml"), set, given)?;
    let Input {
        model,
        statics: settings,
        ..
    } = input;
    let settings = settings.ok_or("[static] is absent")?;
    let outcome = statics(&model, &settings);
    match outcome.failure {
        None => reading(&outcome.result),
        Some(failure) => Err(failure.to_string()),
    }
}

fn reading(result: &StaticResult) -> Result<Hover> {
    let step = result.last().ok_or("no equilibrium")?;
    let air = RotorAir::of(&step.air).ok_or("no strips")?;
    let number = |name: &str| {
        let found = result.nodes.iter().position(|node| node.label == name);
        found.ok_or_else(|| format!("no node \"{name}\""))
    };
    let (root, tip) = (number("main 1/root")?, number("main 1/tip")?);
    let span = step.rotations[root].column(0).into_owned();
    let chord = step.rotations[root].column(1).into_owned();
    let before = result.nodes[root]
        .rotation
        .tr_mul(&result.nodes[tip].rotation);
    let after = step.rotations[root].tr_mul(&step.rotations[tip]);
    Ok(Hover {
        tip: step.positions[tip].z,
        flap: span.z.atan2(span.x),
        pitch: chord.z.atan2(chord.x.hypot(chord.y)),
        twist: vector::from_rotation(&(after * before.transpose())).x,
        thrust: air.thrust,
    })
}

//! A start displaced by the shape of a mode about the equilibrium.
//!
//! With the shape u of the mode, complex in turning axes, its eigenvalue s, and the largest
//! component c of the displacement of a node, the start is the motion of this mode alone at the
//! instant at which that component is largest:
//!
//! ```text
//! x = x_0 + Re( u a / c ),      x' = Re( s u a / c )
//! ```

use nalgebra::{Complex, Vector3};
use shared_geom::rotation::vector;

use super::failure::TransientFailure;
use crate::analysis::modes::modes;
use crate::case::{Model, ModesSettings, StartShape};
use crate::model::State;
use crate::result::ModePoint;

/// Adds the shape to `state`, an equilibrium at `speed` \[rad/s\] at rest in its axes; `model` has
/// the gravity of this equilibrium.
pub(super) fn add(
    model: &Model,
    (shape, speed): (StartShape, f64),
    state: &mut State,
) -> Result<(), TransientFailure> {
    let point = mode(model, shape, speed)?;
    let motions = point.shape.iter().flat_map(|own| {
        let moves = own.displacements.iter().zip(&own.rotations);
        moves.zip(0..)
    });
    let mut largest = Complex::new(0.0, 0.0);
    for ((displacement, _), _) in motions.clone() {
        for component in displacement {
            if component.norm() > largest.norm() {
                largest = *component;
            }
        }
    }
    let factor = shape.displacement / largest;
    if !(factor.re.is_finite() && factor.im.is_finite()) {
        let reason = "it displaces no node".to_owned();
        return Err(TransientFailure::NoShape { reason });
    }
    let rate = Complex::new(point.growth, std::f64::consts::TAU * point.frequency);
    let real = |of: &[Complex<f64>; 3], by: Complex<f64>| Vector3::from(of.map(|v| (v * by).re));
    for ((displacement, rotation), i) in motions {
        let node: usize = i;
        let Some(node) = state.nodes.get_mut(node) else {
            continue;
        };
        node.position += real(displacement, factor);
        node.rotation = vector::to_rotation(&real(rotation, factor)) * node.rotation;
        node.velocity += real(displacement, rate * factor);
        node.angular_velocity += real(rotation, rate * factor);
    }
    Ok(())
}

/// The mode of the given number, by ascending frequency.
fn mode(model: &Model, shape: StartShape, speed: f64) -> Result<ModePoint, TransientFailure> {
    let mut settings = ModesSettings::new(vec![speed], shape.mode);
    settings.shapes = vec![speed];
    let outcome = modes(model, &settings);
    if let Some(failure) = outcome.failure {
        let reason = failure.to_string();
        return Err(TransientFailure::NoShape { reason });
    }
    let branches = outcome.table.branches.into_iter();
    let points = branches.flat_map(|branch| branch.points.into_iter().flatten());
    let mut points: Vec<_> = points.collect();
    points.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    let found = points.len();
    let point = points.into_iter().nth(shape.mode.saturating_sub(1));
    point.ok_or_else(|| TransientFailure::NoShape {
        reason: format!("mode {} was requested, and {found} modes exist", shape.mode),
    })
}

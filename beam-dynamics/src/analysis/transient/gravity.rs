//! Gravity across the axis of a rotating start.
//!
//! In axes that turn with the model, the part of gravity across the axis turns backward once per
//! revolution. Its mean is zero, so that the steady rotation is an equilibrium under the axial
//! part alone. About it, the response once per revolution is periodic; to first order it is
//!
//! ```text
//! g(t) = g_a + Re( c e^(i W t) ),   c = g_c + i a x g_c                         (D-310)
//! ( F_y + i W F_y' ) y_1 = - F_g c,     y(t) = y_0 + Re( y_1 e^(i W t) )         (D-311)
//! ```
//!
//! with the axis a, the speed W, and the axial and crosswise parts of gravity at the start.

use faer::c64;
use nalgebra::Vector3;

use crate::assembly::System;
use crate::case::Model;
use crate::model::{Conditions, NODE_UNKNOWNS, State};
use crate::solver::LinearSolver;

/// Crosswise part of gravity below which it is round-off, relative to gravity.
const ROUND_OFF: f64 = 1e-9;
/// Largest rotation of a node \[rad\], and displacement as a part of the size of the model, up to
/// which the response is accepted: its relative error is of the order of the rotation.
const SMALL: f64 = 0.3;

/// Parts of a gravity \[m/s^2\].
pub(super) struct Parts {
    /// Along the axis of rotation.
    pub axial: Vector3<f64>,
    /// Across it; exactly zero if it is round-off.
    pub across: Vector3<f64>,
}

/// The parts of `gravity` \[m/s^2\] along a unit vector `axis` and across it.
pub(super) fn parts(gravity: &Vector3<f64>, axis: &Vector3<f64>) -> Parts {
    let axial = axis.dot(gravity) * axis;
    let across = gravity - axial;
    if across.norm() > ROUND_OFF * gravity.norm() {
        Parts { axial, across }
    } else {
        Parts {
            axial: *gravity,
            across: Vector3::zeros(),
        }
    }
}

/// Adds to the steady rotation `state`, at rest in the turning axes of `conditions`, its periodic
/// response to the part of gravity `across` the axis \[m/s^2\]; returns a remark. Momenta and
/// multipliers follow from the motion later and are not changed.
pub(super) fn add_response(
    model: &Model,
    solver: &LinearSolver,
    (state, conditions): (&mut State, &Conditions),
    across: &Vector3<f64>,
) -> String {
    let size = across.norm();
    let head = format!("gravity has {size:.4} m/s^2 across the axis of rotation: the start is ");
    let system = &model.system;
    let response = response(system, solver, (state, conditions), across);
    let swing = response.as_deref().map(|y| swing(y, state.nodes.len()));
    let is_small = |swing: &[f64; 2]| swing[0] <= SMALL * system.size() && swing[1] <= SMALL;
    match (response, swing.filter(is_small)) {
        (Some(response), Some([moved, turned])) => {
            apply(state, &response, conditions);
            format!(
                "{head}the steady rotation under its axial part, with the periodic response to \
                 the rest (to first order): once per revolution, up to {moved:.3e} m and \
                 {:.3e} deg",
                turned.to_degrees()
            )
        }
        _ => format!(
            "{head}the steady rotation without this part, whose response is too large to be \
             found in advance (a motion near the rotor speed, or no stiffness): the run begins \
             with a transient; a \"drive\" of [gravity] that grows from zero makes it smaller"
        ),
    }
}

/// The remark on gravity that is zero at the start, and acts across the axis later.
pub(super) fn later() -> String {
    "gravity acts across the axis of rotation, and is zero at the start: the start is the steady \
     rotation without it, and its growth causes a transient unless it takes some revolutions"
        .to_owned()
}

/// The complex amplitudes of all unknowns at one per revolution; `None` if the matrix is singular.
fn response(
    system: &System,
    solver: &LinearSolver,
    (state, conditions): (&State, &Conditions),
    across: &Vector3<f64>,
) -> Option<Vec<c64>> {
    let omega = conditions.frame.angular_velocity;
    let speed = omega.norm();
    let tangent = system.tangent(state, conditions);
    let frequency = c64::new(0.0, speed);
    let matrix = solver.factorize_complex(&tangent.by_unknowns, frequency, &tangent.by_rates)?;
    // The residual is linear in gravity.
    let without = system.residual(state, conditions).values;
    let by = |gravity: Vector3<f64>| {
        let mut with = *conditions;
        with.loading.gravity += gravity;
        let residual = system.residual(state, &with).values;
        residual.into_iter().zip(&without).map(|(a, b)| a - b)
    };
    let (cosine, sine) = (by(*across), by(omega.cross(across) / speed));
    let mut amplitudes: Vec<_> = cosine.zip(sine).map(|(c, s)| -c64::new(c, s)).collect();
    matrix.solve(&mut amplitudes)?;
    Some(amplitudes)
}

/// The largest amplitudes of the displacement \[m\] and of the rotation \[rad\] of `nodes` nodes.
fn swing(response: &[c64], nodes: usize) -> [f64; 2] {
    let of_nodes = response[..NODE_UNKNOWNS * nodes].chunks(NODE_UNKNOWNS);
    of_nodes.fold([0.0, 0.0], |largest, values| {
        let size = |first: usize| {
            let squares = values[first..first + 3]
                .iter()
                .map(|value| value.norm_sqr());
            squares.sum::<f64>().sqrt()
        };
        [largest[0].max(size(0)), largest[1].max(size(3))]
    })
}

/// Adds positions, rotations, scalars, and their rates in the turning axes.
fn apply(state: &mut State, response: &[c64], conditions: &Conditions) {
    let speed = conditions.frame.angular_velocity.norm();
    let now: Vec<_> = response.iter().map(|value| value.re).collect();
    let rates: Vec<_> = response.iter().map(|value| -speed * value.im).collect();
    state.correct(&now);
    let of_nodes = rates.chunks(NODE_UNKNOWNS);
    for (node, rate) in state.nodes.iter_mut().zip(of_nodes) {
        node.velocity += Vector3::new(rate[0], rate[1], rate[2]);
        node.angular_velocity += Vector3::new(rate[3], rate[4], rate[5]);
    }
    let scalars = rates.len() - state.scalar_rates.len();
    for (rate, value) in state.scalar_rates.iter_mut().zip(&rates[scalars..]) {
        *rate += value;
    }
}

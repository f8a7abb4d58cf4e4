//! Derivatives of the energies of elements, from their terms in the balances of nodes.
//!
//! With F and M the force and the moment of an element on a node, `-beta` and `-gamma` its
//! contributions to the momenta there, v and omega the velocities in space:
//!
//! ```text
//! T = 1/2 sum ( v . beta + omega . gamma )
//! dT = 1/2 sum ( beta . dv + gamma . d omega + v . d beta + omega . d gamma )
//! dU = - sum ( F . dx + M . theta )        F, M without rates and multipliers, the frame at rest
//! ```

use nalgebra::Vector3;

use super::{
    Element, EnergyPart, EnergySlope, Local, LocalResidual, LocalSize, Queries, Reading, ReadingRow,
};
use crate::model::Equation::{AngularMomentum, Force, Moment, Momentum};
use crate::model::{NodeMotion, Scalars, TurningFrame, Variable};

/// Adds the derivatives of a part of the energy of an element at a state; `acting` is its residual
/// there, the derivatives of which are known to `row`.
pub(super) fn add_slope(
    element: &dyn Element,
    part: EnergyPart,
    (at, acting): (&Local<'_>, &LocalResidual),
    row: &mut ReadingRow<'_>,
) {
    let slope = element.energetic().map(|own| own.slope());
    let Some(slope) = slope.filter(|slope| slope.has(part)) else {
        return;
    };
    match slope {
        EnergySlope::Momenta => {
            if part != EnergyPart::Gravity {
                add_kinetic(at, acting, row);
            }
            if part != EnergyPart::Kinetic {
                add_potential(element, at, row);
            }
        }
        EnergySlope::Forces => add_potential(element, at, row),
        EnergySlope::Read => {
            element.read(&Reading::Energy(part), at, Some(row));
        }
        EnergySlope::Zero | EnergySlope::Unknown => {}
    }
}

fn add_kinetic(at: &Local<'_>, acting: &LocalResidual, row: &mut ReadingRow<'_>) {
    for (i, node) in at.nodes.iter().enumerate() {
        let [beta, gamma] = [Momentum, AngularMomentum].map(|of| -0.5 * acting.of(i, of));
        row.by_node(i, Variable::Velocity, &beta);
        let by_position = beta.cross(&at.frame.angular_velocity);
        row.by_node(i, Variable::Position, &by_position);
        row.by_node(i, Variable::AngularVelocity, &gamma);
        let v = node.velocity_in_space(at.frame);
        row.by_equation(i, Momentum, &(-0.5 * v));
        let omega = node.angular_velocity_in_space(at.frame);
        row.by_equation(i, AngularMomentum, &(-0.5 * omega));
    }
}

fn add_potential(element: &dyn Element, at: &Local<'_>, row: &mut ReadingRow<'_>) {
    let still = |node: &NodeMotion| NodeMotion {
        velocity: Vector3::zeros(),
        angular_velocity: Vector3::zeros(),
        ..*node
    };
    let nodes: Vec<_> = at.nodes.iter().map(still).collect();
    let (zero, rates) = (
        vec![0.0; at.multipliers.len()],
        vec![0.0; at.scalars.rates.len()],
    );
    let still = Local {
        nodes: &nodes,
        multipliers: &zero,
        scalars: Scalars {
            rates: &rates,
            ..at.scalars
        },
        frame: &TurningFrame::at_rest(),
        ..*at
    };
    let mut forces = LocalResidual::new(LocalSize::of(element));
    element.residual(&still, &mut forces);
    for i in 0..nodes.len() {
        row.by_node(i, Variable::Position, &-forces.of(i, Force));
        row.by_node(i, Variable::Rotation, &-forces.of(i, Moment));
    }
}

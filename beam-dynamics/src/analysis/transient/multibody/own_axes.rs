//! Angular momentum as the formulas see it: in axes that follow the long axis of a body.
//!
//! The formulas integrate components, and a vector that is constant in one set of axes is
//! not constant in another. A slender body that no moment turns about its long axis e keeps `e . gamma`,
//! but its components in space change all the time: the error of the formula, of the size
//! of the large moment of inertia, is divided by the small one, the spin drifts, and grows
//! without bound where a step turns the body by about half the root of the ratio of the
//! two. In axes E that follow e without turning about it, from the latest accepted
//! attitude `R_1` on,
//!
//! ```text
//! u = e_1 x e,  c = e_1 . e,   g = 2 u / (1 + c),   E = R(g) R_1,   omega_E = P omega
//!
//! p     = E^T gamma - E_1^T gamma_1        p'     = E^T (gamma' - omega_E x gamma)
//! gamma = E (E_1^T gamma_1 + p)            gamma' = E p' + omega_E x gamma
//! ```
//!
//! that component is a number of its own, and the spin stays to the last digit. With
//! `theta_E = P theta` and `d omega_E = P d omega + L theta`,
//!
//! ```text
//! d gamma  = E dp - [gamma]x theta_E
//! d gamma' = E dp' - [E p']x theta_E + [omega_E]x d gamma - [gamma]x d omega_E
//! ```
//!
//! `P = -G(g) A [e]x` with `A = dg/de`. Bodies that are not slender, and free ones, keep
//! components in space.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{gibbs, skew};

use crate::assembly::{Combination, Pattern, System, Tangent, Variation};
use crate::elements::Queries;
use crate::model::{Equation, NODE_UNKNOWNS, NodeMotion, Variable};

/// A body is slender when its smallest moment of inertia is below this part of the
/// largest.
const SLENDER: f64 = 0.1;

/// Indices of a block of a matrix in the pattern, column by column.
type Block = [usize; 9];

/// A node whose angular momentum is integrated in axes that follow its long axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct OwnAxes {
    /// The long axis, in the axes of the node [-].
    axis: Vector3<f64>,
    definition_by_rotation: Block,
    definition_by_momentum: Block,
    balance_by_rotation: Block,
    balance_by_momentum: Block,
}

/// The axes E at an attitude of a node.
#[derive(Debug, Clone, Copy)]
pub(super) struct Following {
    /// E [-].
    pub axes: Matrix3<f64>,
    /// Their angular velocity [rad/s].
    pub angular_velocity: Vector3<f64>,
}

/// How the axes E change with the attitude of a node.
struct Derivatives {
    /// P [-].
    turn: Matrix3<f64>,
    /// L [1/s].
    angular_velocity_by_turn: Matrix3<f64>,
}

/// The rotation that takes the long axis from the latest accepted attitude to another one.
struct Bend {
    /// The long axis, at both attitudes [-].
    e_1: Vector3<f64>,
    e: Vector3<f64>,
    /// u, and `1 + c` [-].
    u: Vector3<f64>,
    d: f64,
    /// g, and its rate [1/s].
    g: Vector3<f64>,
    g_rate: Vector3<f64>,
    /// e' [1/s].
    rate: Vector3<f64>,
}

/// The nodes that are integrated in such axes: slender ones that other nodes, joints or
/// springs act on; `None` for all others. `nodes` and `tangent` describe the model at
/// rest.
pub(super) fn find(
    system: &System,
    nodes: &[NodeMotion],
    tangent: &Tangent,
) -> Vec<Option<Box<OwnAxes>>> {
    let mut held = vec![false; nodes.len()];
    for element in system.elements() {
        let holds =
            element.multipliers() > 0 || element.nodes().len() > 1 || !element.motions().is_empty();
        if holds {
            element.nodes().iter().for_each(|&node| held[node] = true);
        }
    }
    let nodes = held.into_iter().zip(nodes).enumerate();
    let of = |(i, (held, node)): (usize, (bool, &NodeMotion))| {
        let axis = held.then(|| long_axis(node, i, tangent)).flatten()?;
        OwnAxes::new(system.pattern(), i, axis).map(Box::new)
    };
    nodes.map(of).collect()
}

/// The axis of least inertia of a slender node, in its own axes.
fn long_axis(node: &NodeMotion, number: usize, tangent: &Tangent) -> Option<Vector3<f64>> {
    let first = NODE_UNKNOWNS * number + Equation::AngularMomentum.row();
    let entry = |i: usize, j: usize| -tangent.by_rates.entry(first + i, first + j);
    let inertia = Matrix3::from_fn(|i, j| 0.5 * (entry(i, j) + entry(j, i)));
    let parts = inertia.symmetric_eigen();
    let least = parts.eigenvalues.imin();
    let is_slender = parts.eigenvalues[least] < SLENDER * parts.eigenvalues.max();
    is_slender.then(|| node.rotation.transpose() * parts.eigenvectors.column(least))
}

impl OwnAxes {
    fn new(pattern: &Pattern, node: usize, axis: Vector3<f64>) -> Option<Self> {
        let first = NODE_UNKNOWNS * node;
        let block = |row: Equation, column: Variable| -> Option<Block> {
            let mut block = [0; 9];
            for (i, index) in block.iter_mut().enumerate() {
                let (row, column) = (first + row.row() + i % 3, first + column.column() + i / 3);
                *index = pattern.index(row, column)?;
            }
            Some(block)
        };
        let (rotation, momentum) = (Variable::Rotation, Variable::AngularMomentum);
        Some(Self {
            axis,
            definition_by_rotation: block(Equation::AngularMomentum, rotation)?,
            definition_by_momentum: block(Equation::AngularMomentum, momentum)?,
            balance_by_rotation: block(Equation::Moment, rotation)?,
            balance_by_momentum: block(Equation::Moment, momentum)?,
        })
    }

    fn bend(&self, origin: &Matrix3<f64>, rotation: &Matrix3<f64>, omega: &Vector3<f64>) -> Bend {
        let (e_1, e) = (origin * self.axis, rotation * self.axis);
        let (u, d) = (e_1.cross(&e), 1.0 + e_1.dot(&e));
        let rate = omega.cross(&e);
        Bend {
            g: 2.0 / d * u,
            g_rate: 2.0 / d * e_1.cross(&rate) - 2.0 * e_1.dot(&rate) / (d * d) * u,
            e_1,
            e,
            u,
            d,
            rate,
        }
    }

    /// The axes E that follow the long axis from the attitude `origin` to a node's attitude.
    pub fn at(
        &self,
        origin: &Matrix3<f64>,
        rotation: &Matrix3<f64>,
        omega: &Vector3<f64>,
    ) -> Following {
        self.bend(origin, rotation, omega).following(origin)
    }

    /// The same at the attitude where they begin.
    pub fn at_origin(&self, origin: &Matrix3<f64>, omega: &Vector3<f64>) -> Following {
        let e = origin * self.axis;
        Following {
            axes: *origin,
            angular_velocity: omega - omega.dot(&e) * e,
        }
    }

    fn derivatives(bend: &Bend, omega: &Vector3<f64>) -> Derivatives {
        let Bend {
            e_1, u, d, g, rate, ..
        } = bend;
        let tangent = gibbs::tangent(g);
        // dg = A de
        let by_axis = 2.0 / d * skew(e_1) - 2.0 / (d * d) * u * e_1.transpose();
        // d(A e') at constant e'
        let along = e_1.dot(rate);
        let by_axis_again = -2.0 / (d * d)
            * (e_1.cross(rate) * e_1.transpose() + along * skew(e_1))
            + 4.0 * along / (d * d * d) * u * e_1.transpose();
        let de = -skew(&bend.e);
        let g_by_turn = by_axis * de;
        let g_rate_by_turn = (by_axis * skew(omega) + by_axis_again) * de;
        Derivatives {
            turn: tangent * g_by_turn,
            angular_velocity_by_turn: gibbs::tangent_derivative(g, &bend.g_rate) * g_by_turn
                + tangent * g_rate_by_turn,
        }
    }

    /// Rewrites the derivatives of a node, which are by the components in space: only the
    /// balance of the node itself knows its angular momentum, as `gamma` in its definition
    /// and as `-gamma'` in the balance of moments.
    pub fn rewrite(
        &self,
        node: &NodeMotion,
        origin: &Matrix3<f64>,
        by: &Variation,
        sum: &mut Combination<'_>,
    ) {
        let (a, b) = (sum.by_unknowns, sum.by_rates);
        let bend = self.bend(origin, &node.rotation, &node.angular_velocity);
        let Following {
            axes,
            angular_velocity,
        } = bend.following(origin);
        let omega = skew(&angular_velocity);
        let gamma = skew(&node.angular_momentum);
        let rate = node.angular_momentum_rate - angular_velocity.cross(&node.angular_momentum);
        let Derivatives {
            turn: p,
            angular_velocity_by_turn,
        } = Self::derivatives(&bend, &node.angular_velocity);
        let turn = a * p * by.turn;
        let angular_velocity =
            p * (b * by.turn + a * by.rate_by_turn) + a * angular_velocity_by_turn * by.turn;
        let values = sum.matrix.values_mut();
        set(values, &self.definition_by_momentum, &(a * axes));
        set(
            values,
            &self.balance_by_momentum,
            &-(b * axes + a * omega * axes),
        );
        add(values, &self.definition_by_rotation, &-(gamma * turn));
        let of_balance = (skew(&rate) + omega * gamma) * turn + gamma * angular_velocity;
        add(values, &self.balance_by_rotation, &of_balance);
    }
}

impl Bend {
    /// The axes E that follow the long axis from the attitude `origin`.
    fn following(&self, origin: &Matrix3<f64>) -> Following {
        Following {
            axes: gibbs::to_rotation(&self.g) * origin,
            angular_velocity: gibbs::tangent(&self.g) * self.g_rate,
        }
    }
}

fn set(values: &mut [f64], block: &Block, new: &Matrix3<f64>) {
    for (index, value) in block.iter().zip(new.iter()) {
        values[*index] = *value;
    }
}

fn add(values: &mut [f64], block: &Block, more: &Matrix3<f64>) {
    for (index, value) in block.iter().zip(more.iter()) {
        values[*index] += *value;
    }
}

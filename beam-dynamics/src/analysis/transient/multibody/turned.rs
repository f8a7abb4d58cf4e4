//! A Jacobian that is kept over steps turns with the nodes.
//!
//! A node and its surroundings turn by Q = R R_held^T between the prediction at which the Jacobian J
//! was computed and the present one. The derivatives between parts that turn together are the same
//! in axes that turn with them, so that with the turns Q of all vectors on the diagonal of T
//!
//! ```text
//! J ~ T J_held T^T ,        dy = -T J_held^-1 T^T F                                  (D-156)
//! ```
//!
//! Vectors are the four equations and the four unknowns of a node; three components of a constraint
//! along fixed axes E, by E^T Q E with the Q of the node that it holds; and two scalars across a
//! shaft n, by the angle
//!
//! ```text
//! atan2( n . axial(Q) , (tr Q - 1) / 2 )
//! ```
//!
//! Angular momenta in axes that follow a node turn with it already, and other scalars do not turn.

use nalgebra::{Matrix3, Vector3};

use super::own_axes::OwnAxes;
use crate::assembly::System;
use crate::elements::{FixedVector, Queries};
use crate::model::{NODE_UNKNOWNS, NodeMotion, State, Variable};

/// A vector of an element.
#[derive(Debug)]
enum OfElement {
    Constraints {
        first: usize,
        axes: Matrix3<f64>,
    },
    Scalars {
        both: [usize; 2],
        shaft: Vector3<f64>,
    },
}

/// The vectors of the elements of a system, each with the node with which it turns.
#[derive(Debug)]
pub(super) struct Turned {
    vectors: Vec<(usize, OfElement)>,
}

impl Turned {
    pub fn new(system: &System) -> Self {
        let numbering = system.numbering();
        let mut vectors = Vec::new();
        for (index, element) in system.elements().enumerate() {
            let [first_node, last_node] = match *element.nodes() {
                [] => continue,
                [only] => [only, only],
                [first, .., last] => [first, last],
            };
            let multiplier = numbering.first_multiplier_of(index);
            let scalars = numbering.scalars_of(index);
            let scalar = |i: usize| numbering.first_scalar() + scalars[i];
            let own = element.fixed_vectors().into_iter();
            vectors.extend(own.map(|vector| match vector {
                FixedVector::Constraints { first, axes } => {
                    let first = multiplier + first;
                    (last_node, OfElement::Constraints { first, axes })
                }
                FixedVector::Scalars { first, shaft } => {
                    let both = [scalar(first), scalar(first + 1)];
                    (first_node, OfElement::Scalars { both, shaft })
                }
            }));
        }
        Self { vectors }
    }

    /// Turns equations at `nodes` back to the attitudes `held`.
    pub fn back(&self, nodes: &[NodeMotion], held: &[Matrix3<f64>], equations: &mut [f64]) {
        let turn = |node: usize| held[node] * nodes[node].rotation.transpose();
        self.turn_all(nodes, (turn, turn), |_| NODE_UNKNOWNS, equations);
    }

    /// Turns unknowns at the attitudes that are held, in space and in the turning axes of the nodes, to
    /// the ones at `nodes`, of which some have their angular momentum in own axes.
    pub fn forth(
        &self,
        (nodes, own_axes): (&[NodeMotion], &[Option<Box<OwnAxes>>]),
        (axes, [in_space, in_axes]): (&[Matrix3<f64>], &[Vec<Matrix3<f64>>; 2]),
        unknowns: &mut [f64],
    ) {
        let turn = |node: usize| nodes[node].rotation * in_space[node].transpose();
        let in_axes =
            |node: usize| axes[node].tr_mul(&nodes[node].rotation) * in_axes[node].transpose();
        let count = |node: usize| match own_axes[node] {
            None => NODE_UNKNOWNS,
            Some(_) => Variable::AngularMomentum.column(),
        };
        self.turn_all(nodes, (in_axes, turn), count, unknowns);
    }

    /// Turns the multipliers of the prediction `base`, equal to the ones of the latest accepted state,
    /// with the nodes since that state.
    pub fn predict(&self, latest: &State, base: &mut State) {
        let first_multiplier = NODE_UNKNOWNS * base.nodes.len();
        for (node, vector) in &self.vectors {
            let OfElement::Constraints { first, axes } = vector else {
                continue;
            };
            let turn = base.nodes[*node].rotation * latest.nodes[*node].rotation.transpose();
            rotate_along(
                axes,
                &turn,
                &mut base.multipliers[first - first_multiplier..],
            );
        }
    }

    /// Turns the first `count` numbers of each node, and the vectors of elements, by two turns.
    fn turn_all(
        &self,
        nodes: &[NodeMotion],
        (turn, of_elements): (
            impl Fn(usize) -> Matrix3<f64>,
            impl Fn(usize) -> Matrix3<f64>,
        ),
        count: impl Fn(usize) -> usize,
        numbers: &mut [f64],
    ) {
        let (of_nodes, _) = numbers.split_at_mut(NODE_UNKNOWNS * nodes.len());
        for (node, own) in of_nodes.chunks_exact_mut(NODE_UNKNOWNS).enumerate() {
            let turn = turn(node);
            let vectors = own[..count(node)].chunks_exact_mut(3);
            vectors.for_each(|vector| rotate(&turn, vector));
        }
        self.turn_own(nodes, of_elements, numbers);
    }

    fn turn_own(
        &self,
        nodes: &[NodeMotion],
        turn: impl Fn(usize) -> Matrix3<f64>,
        numbers: &mut [f64],
    ) {
        for (node, vector) in &self.vectors {
            let turn = turn(*node);
            match vector {
                OfElement::Constraints { first, axes } => {
                    rotate_along(axes, &turn, &mut numbers[*first..]);
                }
                OfElement::Scalars {
                    both: [i, j],
                    shaft,
                } => {
                    let (sin, cos) = angle(&turn, &(nodes[*node].rotation * shaft)).sin_cos();
                    let (x, y) = (numbers[*i], numbers[*j]);
                    (numbers[*i], numbers[*j]) = (cos * x - sin * y, sin * x + cos * y);
                }
            }
        }
    }
}

/// The angle by which a rotation turns about an axis \[rad\].
fn angle(turn: &Matrix3<f64>, axis: &Vector3<f64>) -> f64 {
    let axial = 0.5 * (turn - turn.transpose());
    let axial = Vector3::new(axial.m32, axial.m13, axial.m21);
    axis.dot(&axial).atan2(0.5 * (turn.trace() - 1.0))
}

/// Turns the vector of which the first three numbers are the components along axes.
fn rotate_along(axes: &Matrix3<f64>, turn: &Matrix3<f64>, numbers: &mut [f64]) {
    rotate(&axes.tr_mul(&(turn * axes)), &mut numbers[..3]);
}

fn rotate(turn: &Matrix3<f64>, vector: &mut [f64]) {
    let turned = turn * Vector3::from_column_slice(vector);
    vector.copy_from_slice(turned.as_slice());
}

#[cfg(test)]
mod tests;

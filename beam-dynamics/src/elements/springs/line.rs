//! Two points, each on a node or in the frame, and a force along the line between them.
//!
//! ```text
//! p_i = x_i + f_i,  f_i = R_i f~_i       d = p_2 - p_1       l = |d|       n = d / l
//! P   = T n             on the first end + P, f_1 x P;  on the second - P, - f_2 x P
//! ```
//!
//! with the tension T. Variations, with the signs s_1 = -1, s_2 = 1 of the ends in d:
//!
//! ```text
//! d d   = sum s_i ( d x_i - [f_i]x theta_i )
//! d d'  = sum s_i ( d v_i - [f_i]x d omega_i - [omega_i]x [f_i]x theta_i )
//! d (f_i x P) = [f_i]x d P + [P]x [f_i]x theta_i
//! ```
//!
//! References: [Masarati], forces between points of two nodes.

use nalgebra::{Matrix3, Rotation3, Unit, Vector3};
use shared_geom::rotation::skew;

use crate::elements::{LocalJacobian, LocalResidual};
use crate::model::Equation::{Force, Moment};
use crate::model::{NodeMotion, Variable};

/// Position of an end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// At a point that moves with a node.
    Node {
        /// Index of the node.
        node: usize,
        /// Of the point from the node, in the node's axes [m].
        offset: Vector3<f64>,
    },
    /// At a point of the frame.
    Frame {
        /// The point, model's frame [m].
        position: Vector3<f64>,
    },
}

/// Signs of the ends in `d`.
const SIGNS: [f64; 2] = [-1.0, 1.0];

/// The line between two ends, as an element holds it.
#[derive(Debug, Clone)]
pub(in crate::elements) struct Line {
    ends: [End; 2],
    nodes: Vec<usize>,
}

/// An end at a state.
#[derive(Debug, Clone, Copy)]
struct EndState {
    /// Index of its node among the nodes of the element; `None` in the frame.
    local: Option<usize>,
    p: Vector3<f64>,
    velocity: Vector3<f64>,
    f: Vector3<f64>,
    omega: Vector3<f64>,
}

/// The line at a state.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements) struct LineState {
    ends: [EndState; 2],
    /// Rate of d [m/s].
    pub d_rate: Vector3<f64>,
    /// Length of d [m], and its direction.
    pub length: f64,
    pub n: Vector3<f64>,
}

/// Derivatives of the force on the first end by d and by its rate.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements) struct PullVariation {
    pub by_d: Matrix3<f64>,
    /// `None` if always zero.
    pub by_rate: Option<Matrix3<f64>>,
}

impl Line {
    pub fn new(ends: [End; 2]) -> Self {
        let node = |end: &End| match end {
            End::Node { node, .. } => Some(*node),
            End::Frame { .. } => None,
        };
        Self {
            nodes: ends.iter().filter_map(node).collect(),
            ends,
        }
    }

    /// Nodes of the ends, without ends in the frame.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The longest arm from a node to its end \[m\].
    pub fn reach(&self) -> f64 {
        let arms = self.ends.iter().map(|end| match end {
            End::Node { offset, .. } => offset.norm(),
            End::Frame { .. } => 0.0,
        });
        arms.fold(0.0, f64::max)
    }

    pub fn state(&self, nodes: &[NodeMotion]) -> LineState {
        let mut next = 0;
        let ends = self.ends.map(|end| match end {
            End::Frame { position } => EndState {
                local: None,
                p: position,
                velocity: Vector3::zeros(),
                f: Vector3::zeros(),
                omega: Vector3::zeros(),
            },
            End::Node { offset, .. } => {
                let node = &nodes[next];
                next += 1;
                let f = node.rotation * offset;
                EndState {
                    local: Some(next - 1),
                    p: node.position + f,
                    velocity: node.velocity + node.angular_velocity.cross(&f),
                    f,
                    omega: node.angular_velocity,
                }
            }
        });
        let d = ends[1].p - ends[0].p;
        let length = d.norm();
        LineState {
            ends,
            d_rate: ends[1].velocity - ends[0].velocity,
            length,
            n: d / length,
        }
    }
}

impl LineState {
    /// Rate of the length [m/s].
    pub fn length_rate(&self) -> f64 {
        self.n.dot(&self.d_rate)
    }

    /// Axes (columns) with the first along the line.
    pub fn axes(&self) -> Matrix3<f64> {
        let x = Vector3::x();
        let turn = Rotation3::rotation_between(&x, &self.n);
        let half =
            || Rotation3::from_axis_angle(&Unit::new_unchecked(Vector3::z()), std::f64::consts::PI);
        turn.unwrap_or_else(half).into_inner()
    }

    /// `(I - n n^T) / l`: derivative of n by d.
    pub fn turning(&self) -> Matrix3<f64> {
        (Matrix3::identity() - self.n * self.n.transpose()) / self.length
    }

    /// The elongation as a linear form of displacement and rotation of each node.
    pub fn form(&self) -> Vec<[Vector3<f64>; 2]> {
        let of_end = |(end, sign): (&EndState, f64)| {
            end.local
                .map(|_| [sign * self.n, sign * end.f.cross(&self.n)])
        };
        self.ends.iter().zip(SIGNS).filter_map(of_end).collect()
    }

    /// Growth of d along a small motion of the nodes.
    pub fn growth(&self, along: &[[Vector3<f64>; 2]]) -> Vector3<f64> {
        let of_end = |(end, sign): (&EndState, f64)| match end.local {
            Some(local) => {
                let [displacement, rotation] = &along[local];
                sign * (displacement + rotation.cross(&end.f))
            }
            None => Vector3::zeros(),
        };
        self.ends.iter().zip(SIGNS).map(of_end).sum()
    }

    /// Force and moment of a tension on the node of each end, by its index; none for an end in the
    /// frame.
    pub fn pulls(&self, tension: f64) -> impl Iterator<Item = (usize, [Vector3<f64>; 2])> {
        let of_end = move |(end, sign): (&EndState, f64)| {
            let force = -sign * tension * self.n;
            end.local.map(|local| (local, [force, end.f.cross(&force)]))
        };
        self.ends.iter().zip(SIGNS).filter_map(of_end)
    }

    /// Adds the forces and moments of a tension.
    pub fn add_pull(&self, tension: f64, out: &mut LocalResidual) {
        for (local, [force, moment]) in self.pulls(tension) {
            out.add(local, Force, &force);
            out.add(local, Moment, &moment);
        }
    }

    /// Adds their variation.
    pub fn add_variation(&self, tension: f64, by: &PullVariation, out: &mut LocalJacobian) {
        let pull = skew(&(tension * self.n));
        for (row_end, row_sign) in self.ends.iter().zip(SIGNS) {
            let Some(row) = row_end.local else { continue };
            let arm = -row_sign * skew(&row_end.f);
            for (end, sign) in self.ends.iter().zip(SIGNS) {
                let Some(column) = end.local else { continue };
                let f = skew(&end.f);
                let rate = by.by_rate.unwrap_or_else(Matrix3::zeros);
                let by_rotation = -sign * (by.by_d + rate * skew(&end.omega)) * f;
                let mut add = |variable: Variable, by: &Matrix3<f64>, lever: &Matrix3<f64>| {
                    out.add((row, Force), (column, variable), &(-row_sign * by));
                    out.add((row, Moment), (column, variable), &(arm * by + lever));
                };
                let lever = if row == column {
                    -row_sign * pull * f
                } else {
                    Matrix3::zeros()
                };
                let zero = Matrix3::zeros();
                add(Variable::Position, &(sign * by.by_d), &zero);
                add(Variable::Rotation, &by_rotation, &lever);
                if by.by_rate.is_some() {
                    add(Variable::Velocity, &(sign * rate), &zero);
                    add(Variable::AngularVelocity, &(-sign * rate * f), &zero);
                }
            }
        }
    }
}

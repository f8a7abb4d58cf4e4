//! Forces between two nodes, equal and opposite.
//!
//! *Along the line* between two points (see [`crate::elements::springs`]): a tension T,
//! which pulls them together.
//!
//! *In the axes of the first node* a: with `r = x_b + f_b - x_a` and the factor q,
//!
//! ```text
//! F = q R_a F~,  M = q R_a M~          on b:   F    f_b x F + M
//!                                      on a: - F  - r x F - M
//! ```
//!
//! Both act at `x_b + f_b` of the second, so that they balance exactly. Variations:
//!
//! ```text
//! d F = -[F]x theta_a        d M = -[M]x theta_a
//! d (f_b x F) = [f_b]x d F + [F]x [f_b]x theta_b
//! d (r x F)   = [r]x d F - [F]x (d x_b - [f_b]x theta_b - d x_a)
//! ```
//!
//! References: [Masarati], forces between nodes.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::skew;

use super::factor::LoadFactor;
use super::load::{Add, Head, Load};
use crate::elements::springs::End;
use crate::elements::springs::line::{Line, PullVariation};
use crate::elements::{Local, LocalJacobian, Signal};
use crate::model::Equation::{Force, Moment};
use crate::model::{Node, NodeMotion, Variable};

/// Kinds of forces between two nodes.
#[derive(Debug, Clone, PartialEq)]
pub enum Between {
    /// A force along the line between two points on nodes, positive if it pulls them together.
    Line {
        /// The points.
        ends: [End; 2],
        /// The force for the factor and the signal one [N].
        tension: f64,
    },
    /// A force and a moment on the second node that turn with the first.
    Axes {
        /// Indices of the nodes.
        nodes: [usize; 2],
        /// Position on the second node, in its axes [m].
        offset: Vector3<f64>,
        /// Force on the second node, undeformed, model's axes [N].
        force: Vector3<f64>,
        /// Moment on it, undeformed, model's axes [N m].
        moment: Vector3<f64>,
    },
}

/// A force between two nodes.
#[derive(Debug, Clone)]
pub struct InternalForce {
    /// Its nodes: the two.
    head: Head,
    acting: Acting,
}

#[derive(Debug, Clone)]
enum Acting {
    Line { line: Line, tension: f64 },
    Axes(Axes),
}

/// A force and a moment in the axes of the first node.
#[derive(Debug, Clone)]
struct Axes {
    offset: Vector3<f64>,
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

/// Force and moment of the axes of the first node at a state.
struct Pair {
    /// Arms of the force from each node.
    arms: [Vector3<f64>; 2],
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

/// Signs on the first and on the second node.
const SIGNS: [f64; 2] = [-1.0, 1.0];

impl InternalForce {
    /// The force `between` two of the `nodes` of the model.
    pub fn new(
        label: impl Into<String>,
        nodes: &[Node],
        between: Between,
        factor: LoadFactor,
        signal: Signal,
    ) -> Self {
        let (on, acting) = match between {
            Between::Line { ends, tension } => {
                let line = Line::new(ends);
                (line.nodes().to_vec(), Acting::Line { line, tension })
            }
            Between::Axes {
                nodes: [a, b],
                offset,
                force,
                moment,
            } => {
                let into_first = nodes[a].rotation.transpose();
                let axes = Axes {
                    offset,
                    force: into_first * force,
                    moment: into_first * moment,
                };
                (vec![a, b], Acting::Axes(axes))
            }
        };
        let mut head = Head::new(label, on, factor);
        head.drive(signal);
        Self { head, acting }
    }

    /// Passes force and moment on each of the nodes to `add`, for the factor and the signal one.
    fn wrenches(&self, nodes: &[NodeMotion], mut add: impl FnMut(usize, [Vector3<f64>; 2])) {
        match &self.acting {
            Acting::Line { line, tension } => {
                let state = line.state(nodes);
                let pulls = state.pulls(*tension);
                pulls.for_each(|(node, wrench)| add(node, wrench));
            }
            Acting::Axes(axes) => {
                let pair = axes.pair(1.0, nodes);
                for (node, sign) in SIGNS.into_iter().enumerate() {
                    let moment = pair.moment + pair.arms[node].cross(&pair.force);
                    add(node, [sign * pair.force, sign * moment]);
                }
            }
        }
    }
}

impl Load for InternalForce {
    fn head(&self) -> &Head {
        &self.head
    }

    fn arm(&self) -> f64 {
        match &self.acting {
            Acting::Line { line, .. } => line.reach(),
            Acting::Axes(axes) => axes.offset.norm(),
        }
    }

    fn add(&self, size: f64, at: &Local<'_>, add: &mut Add<'_>) {
        self.wrenches(at.nodes, |node, [force, moment]| {
            add(node, Force, &(size * force));
            add(node, Moment, &(size * moment));
        });
    }

    fn add_variation(&self, size: f64, at: &Local<'_>, out: &mut LocalJacobian) {
        match &self.acting {
            Acting::Line { line, tension } => {
                let state = line.state(at.nodes);
                let by = PullVariation {
                    by_d: size * tension * state.turning(),
                    by_rate: None,
                };
                state.add_variation(size * tension, &by, out);
            }
            Acting::Axes(axes) => axes.pair(size, at.nodes).add_variation(out),
        }
    }
}

impl Axes {
    fn pair(&self, size: f64, nodes: &[NodeMotion]) -> Pair {
        let (a, b) = (&nodes[0], &nodes[1]);
        let f = b.rotation * self.offset;
        Pair {
            arms: [b.position + f - a.position, f],
            force: size * (a.rotation * self.force),
            moment: size * (a.rotation * self.moment),
        }
    }
}

impl Pair {
    fn add_variation(&self, out: &mut LocalJacobian) {
        let (force, moment) = (skew(&self.force), skew(&self.moment));
        let [r, f] = self.arms.map(|arm| skew(&arm));
        let turned = |arm: &Matrix3<f64>| -(arm * force) - moment;
        out.add((0, Force), (0, Variable::Rotation), &force);
        out.add((0, Moment), (0, Variable::Rotation), &-turned(&r));
        out.add((1, Force), (0, Variable::Rotation), &-force);
        out.add((1, Moment), (0, Variable::Rotation), &turned(&f));
        out.add((1, Moment), (1, Variable::Rotation), &(force * f));
        out.add((0, Moment), (0, Variable::Position), &-force);
        out.add((0, Moment), (1, Variable::Position), &force);
        out.add((0, Moment), (1, Variable::Rotation), &-(force * f));
    }
}

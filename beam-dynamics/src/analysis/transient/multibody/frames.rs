//! Turning axes in which the formulas integrate the nodes of a turning part.
//!
//! The formulas integrate components, and a steady rotation changes all components in space: in a
//! step h at the angular velocity w their error is a power of `w h` times the centrifugal forces,
//! and appears in the reactions at the end of the step. From the latest accepted state, at tau = 0,
//! the axes of a turning part turn steadily with the part about a center c that moves with the
//! velocity V of its support,
//!
//! ```text
//! U   = exp(tau [w]x)                  c = c_1 + tau V              d = x - c
//! x   = c + U (d_1 + xi)               v = V + w x d + U xi'
//! R   = U R(g) R_1                     omega = w + U G(g) g'
//! beta  = m V + U (b_1 + b)            beta'  = w x (beta - m V) + U b'      b_1 = beta_1 - m V
//! gamma = U (gamma_1 + p)              gamma' = w x gamma + U p'              (D-285)
//! ```
//!
//! with the mass m of the node, which moves with V. The numbers of the formulas are xi, g, b, p,
//! which are zero in a steady rotation: it is exact for any step. The choice of w, c and V does not
//! change the equations, only the error of the formula. With the corrections of a trial state in
//! axes in space, `U du`, the variations of the unknowns and of their rates are
//!
//! ```text
//! dx = U dxi       dv = U dxi' + [w]x U dxi           and the same for beta, gamma
//! ```
//!
//! A turning part is a set of nodes, connected by elements, that turn nearly alike, with the nodes of
//! a blade among them. They have the angular velocity of the node whose velocity differs least from
//! the velocity of a node of another part, or of the ground, to which it is connected, as of a hub on
//! its shaft; V is the latter velocity. All other nodes keep components in space, in which the formulas keep the momenta of free
//! bodies exactly, and in which a uniform velocity changes nothing.

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::{skew, vector};

use crate::assembly::Tangent;
use crate::case::Model;
use crate::elements::Queries;
use crate::model::{NODE_UNKNOWNS, NodeMotion};

/// Nodes turn alike if their angular velocities differ by at most this part of the larger.
const ALIKE: f64 = 0.25;
/// Rotation in a step above which the axes of a part turn with it \[rad\].
const LEAST_TURN: f64 = 5e-3;

/// The axes of a node in a step.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Frame {
    /// w; zero if the axes do not turn [rad/s].
    pub angular_velocity: Vector3<f64>,
    /// c at the latest accepted state [m].
    center: Vector3<f64>,
    /// V [m/s].
    velocity: Vector3<f64>,
    /// m V [kg m/s].
    momentum: Vector3<f64>,
}

impl Frame {
    fn turns(&self) -> bool {
        self.angular_velocity != Vector3::zeros()
    }

    /// U at the time `tau` after the latest accepted state.
    pub fn turn(&self, tau: f64) -> Matrix3<f64> {
        if self.turns() {
            vector::to_rotation(&(tau * self.angular_velocity))
        } else {
            Matrix3::identity()
        }
    }

    /// A node at rest in these axes, a time `tau` after it was at `node`, where U is `turn`.
    pub fn carried(&self, node: &NodeMotion, (tau, turn): (f64, &Matrix3<f64>)) -> NodeMotion {
        let w = &self.angular_velocity;
        if !self.turns() {
            let still = Vector3::zeros();
            return NodeMotion {
                velocity: still,
                angular_velocity: still,
                momentum_rate: still,
                angular_momentum_rate: still,
                ..*node
            };
        }
        let arm = turn * (node.position - self.center);
        let momentum = turn * (node.momentum - self.momentum);
        let angular_momentum = turn * node.angular_momentum;
        NodeMotion {
            position: self.center + tau * self.velocity + arm,
            rotation: turn * node.rotation,
            momentum: self.momentum + momentum,
            angular_momentum,
            velocity: self.velocity + w.cross(&arm),
            angular_velocity: *w,
            momentum_rate: w.cross(&momentum),
            angular_momentum_rate: w.cross(&angular_momentum),
        }
    }

    /// A node at the time `tau` as these axes see it: as it would be at the latest accepted state,
    /// with rates relative to the axes.
    pub fn seen(&self, node: &NodeMotion, tau: f64) -> NodeMotion {
        if !self.turns() {
            return *node;
        }
        let (w, back) = (&self.angular_velocity, self.turn(-tau));
        let arm = node.position - self.center - tau * self.velocity;
        let momentum = node.momentum - self.momentum;
        NodeMotion {
            position: self.center + back * arm,
            rotation: back * node.rotation,
            momentum: self.momentum + back * momentum,
            angular_momentum: back * node.angular_momentum,
            velocity: back * (node.velocity - self.velocity - w.cross(&arm)),
            angular_velocity: back * (node.angular_velocity - w),
            momentum_rate: back * (node.momentum_rate - w.cross(&momentum)),
            angular_momentum_rate: back
                * (node.angular_momentum_rate - w.cross(&node.angular_momentum)),
        }
    }

    /// Changes of a node and of its rates in axes in space, from these numbers in the turning axes,
    /// where U is `turn`; of the first `count` variables.
    pub fn lifted(
        &self,
        turn: &Matrix3<f64>,
        count: usize,
        (y, rates): (&[f64], &[f64]),
    ) -> [[f64; NODE_UNKNOWNS]; 2] {
        let mut out = [[0.0; NODE_UNKNOWNS]; 2];
        out[0].copy_from_slice(y);
        out[1].copy_from_slice(rates);
        if !self.turns() {
            return out;
        }
        let [y, rates] = &mut out;
        let vectors = y.chunks_exact_mut(3).zip(rates.chunks_exact_mut(3));
        for (variable, (y, rate)) in vectors.take(count).enumerate() {
            let change = turn * Vector3::from_column_slice(y);
            let mut slope = turn * Vector3::from_column_slice(rate);
            // The rotation has w in its reference, see `corrected`.
            if variable != 1 {
                slope += self.angular_velocity.cross(&change);
            }
            y.copy_from_slice(change.as_slice());
            rate.copy_from_slice(slope.as_slice());
        }
        out
    }

    /// U and `[w]x U` of the variations, where U is `turn`; `None` if the axes do not turn.
    pub fn variation(&self, turn: &Matrix3<f64>) -> Option<[Matrix3<f64>; 2]> {
        self.turns()
            .then(|| [*turn, skew(&self.angular_velocity) * turn])
    }
}

/// The node that determines the axes of a part: how fast it moves relative to its support, and the
/// velocity of that.
#[derive(Debug, Clone, Copy)]
struct Support {
    slip: f64,
    node: usize,
    velocity: Vector3<f64>,
}

/// Sums over the nodes of a part.
#[derive(Debug, Clone, Copy, Default)]
struct Part {
    nodes: f64,
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    angular_velocity: Vector3<f64>,
    has_blades: bool,
    support: Option<Support>,
}

/// The axes of all nodes.
#[derive(Debug)]
pub(super) struct Frames {
    /// Nodes of blades.
    blades: Vec<usize>,
    /// Pairs of nodes of one element.
    edges: Vec<[usize; 2]>,
    /// Nodes that an element holds alone.
    grounded: Vec<usize>,
    /// Masses of the nodes [kg].
    masses: Vec<f64>,
    /// A node of the same part, nearer to the first one of the part.
    parents: Vec<usize>,
    parts: Vec<Part>,
    of_nodes: Vec<Frame>,
    /// Whether the axes stay the same, and the time of their centers [s].
    kept: Option<f64>,
}

impl Frames {
    /// For the parts of a model that have blades; `tangent` describes the model at rest.
    pub fn new(model: &Model, tangent: &Tangent) -> Self {
        let system = &model.system;
        let count = system.nodes().len();
        let blades = model
            .blades
            .iter()
            .flat_map(|blade| &blade.nodes)
            .copied()
            .collect();
        let (mut edges, mut grounded) = (Vec::new(), Vec::new());
        for element in system.elements() {
            match element.nodes() {
                [only] if element.multipliers() > 0 => grounded.push(*only),
                nodes => edges.extend(nodes.windows(2).map(|pair| [pair[0], pair[1]])),
            }
        }
        edges.sort_unstable();
        edges.dedup();
        let mut masses = vec![0.0; count];
        for (row, column, value) in tangent.by_rates.triplets() {
            let is_along_x = row % NODE_UNKNOWNS == 0 && column % NODE_UNKNOWNS == 0;
            if is_along_x && row.max(column) < NODE_UNKNOWNS * count {
                masses[row / NODE_UNKNOWNS] -= value;
            }
        }
        Self {
            blades,
            edges,
            grounded,
            masses,
            parents: vec![0; count],
            parts: vec![Part::default(); count],
            of_nodes: vec![Frame::default(); count],
            kept: None,
        }
    }

    /// The axes of each node.
    pub fn of_nodes(&self) -> &[Frame] {
        &self.of_nodes
    }

    /// In all later steps the axes turn as the nodes do now, at `time` \[s\].
    pub fn keep(&mut self, nodes: &[NodeMotion], time: f64) {
        self.kept = None;
        self.begin(nodes, 0.0);
        self.kept = Some(time);
    }

    /// Moves axes that turn as always to the beginning of a step at `time` \[s\].
    pub fn move_to(&mut self, time: f64) {
        if let Some(since) = &mut self.kept {
            let passed = time - std::mem::replace(since, time);
            for frame in &mut self.of_nodes {
                frame.center += passed * frame.velocity;
            }
        }
    }

    /// Begins a step after one of `length`, zero if there was none \[s\].
    pub fn begin(&mut self, nodes: &[NodeMotion], length: f64) {
        if self.kept.is_some() || self.blades.is_empty() {
            return;
        }
        self.find_parts(nodes);
        for node in 0..nodes.len() {
            let part = &self.parts[self.root(node)];
            self.of_nodes[node] = part.frame(nodes, self.masses[node], length);
        }
    }

    fn root(&self, mut node: usize) -> usize {
        while self.parents[node] != node {
            node = self.parents[node];
        }
        node
    }

    fn find_parts(&mut self, nodes: &[NodeMotion]) {
        for (i, parent) in self.parents.iter_mut().enumerate() {
            *parent = i;
        }
        let alike = |[i, j]: [usize; 2]| {
            let [a, b] = [i, j].map(|node| nodes[node].angular_velocity);
            (a - b).norm_squared() <= ALIKE * ALIKE * a.norm_squared().max(b.norm_squared())
        };
        for &edge in &self.edges {
            if alike(edge) {
                let [i, j] = edge.map(|node| self.root(node));
                self.parents[i.max(j)] = i.min(j);
            }
        }
        self.parts.fill(Part::default());
        for (i, node) in nodes.iter().enumerate() {
            // Shorter ways for the next search.
            let root = self.root(i);
            self.parents[i] = root;
            let part = &mut self.parts[root];
            part.nodes += 1.0;
            part.position += node.position;
            part.velocity += node.velocity;
            part.angular_velocity += node.angular_velocity;
        }
        for &node in &self.blades {
            self.parts[self.parents[node]].has_blades = true;
        }
        for &node in &self.grounded {
            let support = Support {
                slip: nodes[node].velocity.norm(),
                node,
                velocity: Vector3::zeros(),
            };
            self.parts[self.parents[node]].hold(support);
        }
        for &[i, j] in &self.edges {
            if self.parents[i] == self.parents[j] {
                continue;
            }
            let slip = (nodes[i].velocity - nodes[j].velocity).norm();
            for [node, other] in [[i, j], [j, i]] {
                let velocity = nodes[other].velocity;
                self.parts[self.parents[node]].hold(Support {
                    slip,
                    node,
                    velocity,
                });
            }
        }
    }
}

impl Part {
    fn hold(&mut self, support: Support) {
        let is_nearer = self.support.is_none_or(|held| support.slip < held.slip);
        if is_nearer {
            self.support = Some(support);
        }
    }

    /// The axes of a node of `mass` \[kg\] of the part.
    fn frame(&self, nodes: &[NodeMotion], mass: f64, length: f64) -> Frame {
        let (w, center, velocity) = match &self.support {
            Some(support) => {
                let node = &nodes[support.node];
                let (w, slip) = (node.angular_velocity, node.velocity - support.velocity);
                let square = w.norm_squared().max(f64::MIN_POSITIVE);
                (w, node.position + w.cross(&slip) / square, support.velocity)
            }
            None => {
                let mean = |sum: Vector3<f64>| sum / self.nodes;
                let w = mean(self.angular_velocity);
                (w, mean(self.position), mean(self.velocity))
            }
        };
        let turns =
            self.has_blades && w.norm() > 0.0 && (length == 0.0 || w.norm() * length > LEAST_TURN);
        if !turns {
            return Frame::default();
        }
        Frame {
            angular_velocity: w,
            center,
            velocity,
            momentum: mass * velocity,
        }
    }
}

//! Chains of beams, each with the axes of its first node.
//!
//! From the roots on, a chain follows the beams and the joints. At a branch it continues along the beam
//! that leads straight on, and every other beam begins a chain of its own. So does a beam behind a joint
//! that does not lead straight on, as an arm on the plate that holds another one. Nodes without beams,
//! as bodies at a tip, belong to the chain that holds them.

use std::collections::VecDeque;

use nalgebra::{Matrix3, Vector3};

use super::links::{Link, Links};

/// Cosine of the angle up to which a beam leads straight on: 45 degrees.
const STRAIGHT: f64 = 0.707;

/// A node that a chain has reached.
#[derive(Debug, Clone, Copy)]
struct Reached {
    node: usize,
    chain: usize,
    /// Direction of the last beam on the way.
    along: Option<Vector3<f64>>,
    /// Whether the way ends with a beam.
    by_beam: bool,
}

/// Axes of nodes by the chains that they lie on.
pub(super) struct Chains<'a> {
    links: &'a Links,
    /// Axes for a span that begins at a node.
    axes_of: &'a dyn Fn(&Vector3<f64>, usize) -> Matrix3<f64>,
    /// Axes of each chain; `None` before its first beam.
    chains: Vec<Option<Matrix3<f64>>>,
    /// Chain of each node.
    of: Vec<Option<usize>>,
    /// Nodes that belong to no chain.
    outside: &'a [bool],
}

impl<'a> Chains<'a> {
    /// No chains yet; nodes `outside` belong to none.
    pub fn new(
        links: &'a Links,
        outside: &'a [bool],
        axes_of: &'a dyn Fn(&Vector3<f64>, usize) -> Matrix3<f64>,
    ) -> Self {
        Self {
            links,
            axes_of,
            chains: Vec::new(),
            of: vec![None; outside.len()],
            outside,
        }
    }

    /// Whether a node is still without a chain.
    pub fn is_open(&self, node: usize) -> bool {
        !self.outside[node] && self.of[node].is_none()
    }

    /// Axes of a node; `None` if no beam is on its chain.
    pub fn axes(&self, node: usize) -> Option<Matrix3<f64>> {
        self.chains[self.of[node]?]
    }

    /// Follows the chains from all `roots` at once, so that each node belongs to the nearest.
    pub fn follow(&mut self, roots: &[usize]) {
        let mut queue = VecDeque::new();
        for &node in roots.iter() {
            if self.is_open(node) {
                let chain = self.begin(None);
                self.of[node] = Some(chain);
                queue.push_back(Reached {
                    node,
                    chain,
                    along: None,
                    by_beam: false,
                });
            }
        }
        while let Some(reached) = queue.pop_front() {
            let links = self.links.of(reached.node).iter();
            let next: Vec<_> = links.filter(|link| self.is_open(link.to)).collect();
            let beams = next.iter().filter_map(|link| Some((link.to, link.span?)));
            let beams: Vec<_> = beams.collect();
            let straight = self.straight_on(&beams, &reached);
            for link in next {
                if self.is_open(link.to) {
                    let found = self.step(reached, link, straight == Some(link.to));
                    if found.chain != reached.chain && !reached.by_beam && beams.len() == 1 {
                        // The first node of an arm behind a joint.
                        self.of[reached.node] = Some(found.chain);
                    }
                    queue.push_back(found);
                }
            }
        }
    }

    /// The node to which the chain continues from `reached`: along the only beam after a beam, or else
    /// along the straightest; the first of its beams if it has none before.
    fn straight_on(&self, beams: &[(usize, Vector3<f64>)], reached: &Reached) -> Option<usize> {
        match (beams, reached.along) {
            ([only], Some(_)) if reached.by_beam => Some(only.0),
            (_, None) => {
                let first = beams
                    .first()
                    .filter(|_| self.chains[reached.chain].is_none());
                first.map(|beam| beam.0)
            }
            (_, Some(along)) => {
                let straightness = beams.iter().map(|beam| (beam.1.dot(&along), beam.0));
                let best = straightness.max_by(|a, b| a.0.total_cmp(&b.0))?;
                (best.0 >= STRAIGHT).then_some(best.1)
            }
        }
    }

    /// Goes along `link`, of a beam on the same chain only if it is `straight` on.
    fn step(&mut self, from: Reached, link: &Link, straight: bool) -> Reached {
        let axes = link.span.map(|span| (self.axes_of)(&span, from.node));
        let chain = if axes.is_none() || straight {
            self.chains[from.chain] = self.chains[from.chain].or(axes);
            from.chain
        } else {
            self.begin(axes)
        };
        self.of[link.to] = Some(chain);
        Reached {
            node: link.to,
            chain,
            along: link.span.or(from.along),
            by_beam: link.span.is_some(),
        }
    }

    fn begin(&mut self, axes: Option<Matrix3<f64>>) -> usize {
        self.chains.push(axes);
        self.chains.len() - 1
    }
}

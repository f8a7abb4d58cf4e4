//! The six unknowns that are held to remove the rigid motions (S-21).
//!
//! ```text
//!      c (ux)
//!      o-----------o         a: ux, uy, uz
//!      |           |         b: ux, and uy or uz, the one most normal to ab
//!      |  section  |         c: ux
//!      o-----------o
//!      a           b
//! ```
//!
//! Strains, and with them all results, do not depend on the choice; a wide triangle keeps
//! the displacements and their round-off small.

use crate::assembly::Model;
use crate::failure::Failure;

/// Least distance of the third node from the line of the first two, relative to their
/// distance. Below it the nodes are on one line, to the accuracy of a mesh file.
const LEAST_WIDTH: f64 = 1e-9;

/// Held unknowns, in ascending order: six (numbered 3 node + axis) that remove the rigid
/// motions, and those held by the model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pins {
    unknowns: Vec<usize>,
}

impl Pins {
    /// Chooses pins among the nodes of `model` that have stiffness, and adds the unknowns
    /// held by the model.
    ///
    /// # Errors
    /// [`Failure::NodesOnOneLine`].
    pub fn of_model(model: &impl Model) -> Result<Self, Failure> {
        let nodes = model.nodes();
        let structural: Vec<usize> = (0..nodes.len())
            .filter(|&node| model.is_structural(node))
            .collect();
        let positions: Vec<[f64; 2]> = structural.iter().map(|&node| nodes[node]).collect();
        let chosen = triangle(&positions).ok_or(Failure::NodesOnOneLine)?;
        Ok(Self::at(nodes, chosen.map(|node| structural[node])).with(model.held()))
    }

    /// These pins and `unknowns`.
    pub fn with(mut self, unknowns: Vec<usize>) -> Self {
        self.unknowns.extend(unknowns);
        self.unknowns.sort_unstable();
        self.unknowns.dedup();
        self
    }

    /// Chooses pins among `nodes`, positions (y, z) from their centroid.
    ///
    /// Node a is the farthest from the centroid, b the farthest from a, c the
    /// farthest from the line ab; the first of equals.
    ///
    /// # Errors
    /// [`Failure::NodesOnOneLine`].
    pub fn choose(nodes: &[[f64; 2]]) -> Result<Self, Failure> {
        triangle(nodes)
            .map(|triangle| Self::at(nodes, triangle))
            .ok_or(Failure::NodesOnOneLine)
    }

    /// The pins at the nodes a, b, c of `nodes`, which do not lie on one line.
    pub fn at(nodes: &[[f64; 2]], [a, b, c]: [usize; 3]) -> Self {
        let ab = [nodes[b][0] - nodes[a][0], nodes[b][1] - nodes[a][1]];
        let normal = if ab[0].abs() > ab[1].abs() { 2 } else { 1 };
        let mut unknowns = vec![3 * a, 3 * a + 1, 3 * a + 2, 3 * b, 3 * b + normal, 3 * c];
        unknowns.sort_unstable();
        Self { unknowns }
    }

    /// The held unknowns, in ascending order.
    pub fn unknowns(&self) -> &[usize] {
        &self.unknowns
    }
}

/// The nodes a, b, c of the widest triangle; `None` if all nodes are on one line.
fn triangle(nodes: &[[f64; 2]]) -> Option<[usize; 3]> {
    let a = farthest(nodes, |p| p[0].hypot(p[1]));
    let corner = nodes.get(a)?;
    let from_a = |p: &[f64; 2]| [p[0] - corner[0], p[1] - corner[1]];
    let b = farthest(nodes, |p| {
        let [y, z] = from_a(p);
        y.hypot(z)
    });
    let ab = from_a(&nodes[b]);
    let cross = |p: &[f64; 2]| {
        let [y, z] = from_a(p);
        (ab[0] * z - ab[1] * y).abs()
    };
    let c = farthest(nodes, cross);
    // written such that NaN is refused too
    let is_wide = cross(&nodes[c]) > LEAST_WIDTH * (ab[0] * ab[0] + ab[1] * ab[1]);
    is_wide.then_some([a, b, c])
}

/// Index of the node with the largest `measure`, the first of equals.
fn farthest(nodes: &[[f64; 2]], measure: impl Fn(&[f64; 2]) -> f64) -> usize {
    let mut best = (0, f64::NEG_INFINITY);
    for (index, node) in nodes.iter().enumerate() {
        let value = measure(node);
        if value > best.1 {
            best = (index, value);
        }
    }
    best.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pins_span_the_section() {
        // a wide rectangle: a is corner 0, b the opposite corner 2, c corner 1
        let nodes = [
            [-2.0, -1.0],
            [2.0, -1.0],
            [2.0, 1.0],
            [-2.0, 1.0],
            [0.0, 0.0],
        ];
        let pins = Pins::choose(&nodes).expect("wide");
        // ab runs mainly along y: uz (axis 2) is held at b
        assert_eq!(pins.unknowns(), &[0, 1, 2, 3, 6, 8]);
    }

    #[test]
    fn upright_sections_hold_uy_at_the_second_node() {
        let nodes = [[0.0, -2.0], [0.0, 2.0], [0.5, 0.0]];
        let pins = Pins::choose(&nodes).expect("wide");
        assert_eq!(pins.unknowns(), &[0, 1, 2, 3, 4, 6]);
    }

    #[test]
    fn nodes_on_one_line_are_refused() {
        let nodes = [[-1.0, -1.0], [0.0, 0.0], [0.5, 0.5], [1.0, 1.0]];
        assert_eq!(Pins::choose(&nodes), Err(Failure::NodesOnOneLine));
        assert_eq!(Pins::choose(&nodes[..1]), Err(Failure::NodesOnOneLine));
    }
}

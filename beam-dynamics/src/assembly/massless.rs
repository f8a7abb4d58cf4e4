//! Undetermined motions of nodes: without mass, stiffness, damping and joint.
//!
//! With M the mass of a node, as its momentum depends on its velocities, and A the derivatives of
//! all forces, moments and constraints by its position, its rotation and their rates, a motion r is
//! undetermined if
//!
//! ```text
//! M r = 0,   A r = 0,   r /= 0
//! ```
//!
//! Rotations are scaled by the size of the model.

use nalgebra::{DMatrix, DVector, Matrix6, Vector6};
use shared_geom::error::Explain;

use super::mechanism::finite;
use super::{System, Tangent};
use crate::model::{Conditions, Equation, MOTION_WORDS, NODE_UNKNOWNS, Variable};

/// A mass below this fraction of the largest of its node is zero.
const NO_MASS: f64 = 1e-15;
/// Derivatives below this fraction of the largest of their row are round-off.
const ROUND_OFF: f64 = 1e-12;
/// Singular values below this fraction of one are zero.
const ZERO: f64 = 1e-9;
/// Unknowns of the motion of a node.
pub(super) const MOTION: usize = 6;

/// A node with a motion that no mass, stiffness, damping or joint determines.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("node \"{node}\" has no {}, and nothing holds it: {}", self.lack(), .motions.join(", "))]
pub struct MasslessNode {
    /// The node.
    pub node: String,
    /// Its undetermined motions as text.
    pub motions: Vec<String>,
}

impl MasslessNode {
    /// The missing property.
    fn lack(&self) -> &'static str {
        let turns = |motion: &String| motion.starts_with("rotation");
        if self.motions.iter().all(turns) {
            "inertia"
        } else {
            "mass"
        }
    }
}

impl Explain for MasslessNode {
    fn help(&self) -> Option<String> {
        let text = "give the node mass and inertia by a [[body]], or make it part of a [[beam]], \
                    or hold it by a joint or a spring";
        Some(text.to_owned())
    }
}

/// For each node, an orthonormal basis of the motions that move no mass (columns:
/// displacement [m], rotation times the size of the model [m]).
pub fn without_mass(system: &System, tangent: &Tangent, size: f64) -> Vec<DMatrix<f64>> {
    let scale = scale(size);
    let masses = (0..system.nodes().len()).map(|node| {
        let first = NODE_UNKNOWNS * node;
        let entry = |i: usize, j: usize| -tangent.by_rates.entry(first + i, first + j);
        let mass = Matrix6::from_fn(|i, j| scale[i] * entry(i, j) * scale[j]);
        0.5 * (mass + mass.transpose())
    });
    masses.map(|mass| null(&mass)).collect()
}

/// The motions without mass; the masses of each node are compared among themselves only, so that a
/// heavy node does not make another one massless.
fn null(mass: &Matrix6<f64>) -> DMatrix<f64> {
    let largest = mass.amax();
    let parts = mass.map(finite).symmetric_eigen();
    let found: Vec<DVector<f64>> = parts
        .eigenvalues
        .iter()
        .zip(parts.eigenvectors.column_iter())
        .filter(|(value, _)| value.abs() <= NO_MASS * largest)
        .map(|(_, column)| DVector::from_column_slice(column.into_owned().as_slice()))
        .collect();
    columns(&found)
}

fn columns(found: &[DVector<f64>]) -> DMatrix<f64> {
    if found.is_empty() {
        DMatrix::zeros(MOTION, 0)
    } else {
        DMatrix::from_columns(found)
    }
}

/// Meters of motion by meters and radians.
pub(super) fn scale(size: f64) -> Vector6<f64> {
    let turn = 1.0 / size;
    Vector6::new(1.0, 1.0, 1.0, turn, turn, turn)
}

/// Nodes of the undeformed model with undetermined motions.
pub fn find(system: &System) -> Vec<MasslessNode> {
    let rest = system.rest();
    let tangent = system.tangent(&rest, &Conditions::at_rest());
    let size = system.size();
    let motions = without_mass(system, &tangent, size);
    if motions.iter().all(|basis| basis.ncols() == 0) {
        return Vec::new();
    }
    let mut rows = resisting(system, &tangent, size);
    let nodes = motions.iter().zip(&mut rows).enumerate();
    nodes
        .filter_map(|(node, (basis, rows))| {
            let free = undetermined(basis, rows);
            (free.ncols() > 0).then(|| MasslessNode {
                node: system.nodes()[node].label.clone(),
                motions: words(&free),
            })
        })
        .collect()
}

/// A row of derivatives by the six motions of a node.
type Row = Vector6<f64>;

/// Rows of forces, moments and constraints by the motion of each node that has a motion without
/// mass, each with a largest entry of one.
fn resisting(system: &System, tangent: &Tangent, size: f64) -> Vec<Vec<Row>> {
    let nodes = system.nodes().len();
    let scale = scale(size);
    let is_balance =
        |row: usize| row < NODE_UNKNOWNS * nodes && row % NODE_UNKNOWNS < Equation::Force.row();
    let mut rows = vec![Vec::new(); nodes];
    for matrix in [&tangent.by_unknowns, &tangent.by_rates] {
        let mut largest = vec![0.0_f64; matrix.pattern().size()];
        for (row, _, value) in matrix.triplets() {
            largest[row] = largest[row].max(value.abs());
        }
        let mut of_node: Vec<std::collections::BTreeMap<usize, Row>> =
            vec![std::collections::BTreeMap::new(); nodes];
        for (row, column, value) in matrix.triplets() {
            let (node, index) = (column / NODE_UNKNOWNS, column % NODE_UNKNOWNS);
            let is_motion = node < nodes && index < Variable::Momentum.column();
            if is_motion && !is_balance(row) && value.abs() > ROUND_OFF * largest[row] {
                of_node[node].entry(row).or_default()[index] = value * scale[index];
            }
        }
        for (rows, found) in rows.iter_mut().zip(of_node) {
            rows.extend(found.into_values().map(|row| row / row.amax()));
        }
    }
    rows
}

/// The part of the space of `basis` on which all rows are zero.
fn undetermined(basis: &DMatrix<f64>, rows: &[Row]) -> DMatrix<f64> {
    if basis.ncols() == 0 {
        return DMatrix::zeros(MOTION, 0);
    }
    let mut seen = DMatrix::zeros(rows.len().max(MOTION), basis.ncols());
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in basis.column_iter().enumerate() {
            seen[(i, j)] = row.dot(&column);
        }
    }
    let parts = seen.map(finite).svd(false, true);
    let Some(v_t) = parts.v_t else {
        return DMatrix::zeros(MOTION, 0);
    };
    let values = parts.singular_values.iter().enumerate();
    let free: Vec<_> = values
        .filter(|(_, value)| **value <= ZERO)
        .map(|(i, _)| basis * v_t.row(i).transpose())
        .collect();
    columns(&free)
}

fn words(free: &DMatrix<f64>) -> Vec<String> {
    let parts = free.row_iter().zip(MOTION_WORDS);
    parts
        .filter(|(row, _)| row.norm() > 1e-6)
        .map(|(_, word)| word.to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::Element;
    use crate::elements::bodies::{RigidBody, RigidInertia};
    use crate::elements::joints::{clamped, rigid_connection};
    use crate::model::Node;
    use nalgebra::{Matrix3, Vector3};

    fn node(label: &str, x: f64) -> Node {
        Node {
            label: label.to_owned(),
            position: Vector3::new(x, 0.0, 0.0),
            rotation: Matrix3::identity(),
        }
    }

    fn body(node: usize, inertia: &Matrix3<f64>) -> Box<dyn Element> {
        let inertia = RigidInertia::about_node(2.0, &Vector3::zeros(), inertia);
        Box::new(RigidBody::new("body", node, inertia))
    }

    #[test]
    fn a_node_that_nothing_determines_is_named_and_one_that_is_held_is_not() {
        let nodes = vec![node("held", 0.0), node("arm", 1.0), node("loose", 2.0)];
        let arm = rigid_connection("arm", [0, 1], [&nodes[0], &nodes[1]]);
        let elements = || {
            vec![
                clamp_of(&nodes[0]),
                Box::new(arm.clone()) as Box<dyn Element>,
            ]
        };
        let found = find(&System::new(nodes.clone(), elements()));
        assert_eq!(found.len(), 1);
        assert_eq!(
            (found[0].node.as_str(), found[0].motions.len()),
            ("loose", 6)
        );
        // With a body nothing remains; a point mass can still turn.
        let mut with_body = elements();
        with_body.push(body(2, &Matrix3::identity()));
        assert_eq!(find(&System::new(nodes.clone(), with_body)), []);
        let mut with_point = elements();
        with_point.push(body(2, &Matrix3::zeros()));
        let found = find(&System::new(nodes.clone(), with_point));
        let turns = ["rotation about x", "rotation about y", "rotation about z"];
        assert_eq!(found[0].motions, turns);
        assert_eq!(
            found[0].to_string(),
            "node \"loose\" has no inertia, and nothing holds it: rotation about x, rotation about \
             y, rotation about z"
        );
    }

    // One of two bodies is 1e16 times as heavy: both have mass.
    #[test]
    fn a_node_has_mass_however_heavy_another_one_is() {
        let nodes = vec![node("light", 0.0), node("heavy", 1.0)];
        let heavy = RigidInertia::about_node(
            2e16,
            &Vector3::zeros(),
            &(1e16 * Matrix3::<f64>::identity()),
        );
        let mut elements = vec![body(0, &Matrix3::identity())];
        elements.push(Box::new(RigidBody::new("heavy", 1, heavy)));
        assert_eq!(find(&System::new(nodes, elements)), []);
    }

    fn clamp_of(node: &Node) -> Box<dyn Element> {
        Box::new(clamped("clamp", 0, node))
    }
}

//! Free mechanisms: motions that nothing resists.
//!
//! Nodes joined by elastic elements move together as a rigid part when no strain
//! arises. With H the six rigid motions of each part and `Phi_y` the derivatives of
//! the constraints at the undeformed state, a motion is free when
//!
//! ```text
//! Phi_y H r = 0,   r /= 0
//! ```
//!
//! so that the mechanisms are the null space of a small matrix, whatever the
//! stiffness of the beams. Rotations are scaled by the size of the part.
//!
//! Motions that elements resist by springs are further rows. Those that hinges leave
//! free on purpose are no mechanisms: what is free also with these rows (all hinges
//! locked) has been forgotten; what is free only without them is the freedom of hinges.

use nalgebra::{DMatrix, DVector, RowDVector, Vector3};
use shared_geom::error::Explain;

use super::System;
use crate::elements::Queries;
use crate::model::{Conditions, NODE_UNKNOWNS, Variable};

/// Singular values below this part of the largest count as zero: the entries are of
/// order one, their round-off is 1e-16.
const ZERO: f64 = 1e-9;
/// Part of a unit motion of the model that counts as moving.
const VISIBLE: f64 = 1e-6;

/// A part of the model that can move freely.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("free mechanism: node \"{node}\"{} can move without resistance: {}", others(.nodes), .motions.join(", "))]
pub struct Mechanism {
    /// The node that moves most.
    pub node: String,
    /// Number of nodes in the part.
    pub nodes: usize,
    /// The free motions in words.
    pub motions: Vec<String>,
}

fn others(nodes: &usize) -> String {
    match nodes {
        0 | 1 => String::new(),
        2 => " and 1 node connected to it".to_owned(),
        n => format!(" and {} nodes connected to it", n - 1),
    }
}

impl Explain for Mechanism {
    fn help(&self) -> Option<String> {
        Some(
            "hold it with a [[clamp]], or connect it by a [[beam]] to a part that is held"
                .to_owned(),
        )
    }
}

/// How a model can move without resistance, undeformed and unloaded.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mobility {
    /// Motions that nothing resists and no hinge allows; none in a sound model.
    pub mechanisms: Vec<Mechanism>,
    /// Names of the hinges and other joints that can move.
    pub free_hinges: Vec<String>,
}

/// A rigid part: its nodes, a point near their middle and its size.
struct Part {
    nodes: Vec<usize>,
    center: Vector3<f64>,
    /// Largest distance of a node from the center, or one [m].
    size: f64,
}

/// How the undeformed, unloaded model can move.
pub fn find(system: &System) -> Mobility {
    let parts = rigid_parts(system);
    if parts.is_empty() {
        return Mobility::default();
    }
    let mut rows = constraints_by_rigid_motions(system, &parts);
    let mut free = Vec::new();
    for element in system.elements() {
        for motion in element.motions() {
            let row = row_of(system, &parts, (element.nodes(), &motion.form));
            match motion.is_resisted {
                true => rows.push(row),
                false => free.push((element.label(), row)),
            }
        }
    }
    let unlocked = null_space(&rows, 6 * parts.len());
    if unlocked.ncols() == 0 {
        return Mobility::default();
    }
    let turns = |row: &RowDVector<f64>| (row * &unlocked).amax() > VISIBLE;
    let free_hinges = free.iter().filter(|(_, row)| turns(row));
    let mut free_hinges: Vec<_> = free_hinges.map(|(label, _)| (*label).to_owned()).collect();
    free_hinges.dedup();
    rows.extend(free.into_iter().map(|(_, row)| row));
    let forgotten = null_space(&rows, 6 * parts.len());
    let mechanisms = parts.iter().enumerate().filter_map(|(i, part)| {
        let motions = forgotten.rows(6 * i, 6).into_owned();
        let moves = motions.ncols() > 0 && motions.amax() > VISIBLE;
        moves.then(|| describe(system, part, &motions))
    });
    Mobility {
        mechanisms: mechanisms.collect(),
        free_hinges,
    }
}

/// Nodes connected through elements that resist all their relative motions.
fn rigid_parts(system: &System) -> Vec<Part> {
    let count = system.nodes().len();
    let mut part_of: Vec<usize> = (0..count).collect();
    for element in system.elements().filter(|e| e.joins_nodes()) {
        for pair in element.nodes().windows(2) {
            let (a, b) = (part_of[pair[0]], part_of[pair[1]]);
            part_of.iter_mut().filter(|p| **p == b).for_each(|p| *p = a);
        }
    }
    let mut names = part_of.clone();
    names.sort_unstable();
    names.dedup();
    let part = |name: usize| {
        let nodes: Vec<_> = (0..count).filter(|&node| part_of[node] == name).collect();
        let position = |node: &usize| system.nodes()[*node].position;
        let center = nodes.iter().map(position).sum::<Vector3<f64>>() / nodes.len() as f64;
        let reach = nodes.iter().map(|node| (position(node) - center).norm());
        let size = reach.fold(0.0, f64::max);
        Part {
            nodes,
            center,
            size: if size > 0.0 { size } else { 1.0 },
        }
    };
    names.into_iter().map(part).collect()
}

/// Rigid motion number `motion` of a part at a node: displacement, in units of the
/// size of the part, and rotation.
fn rigid_motion(part: &Part, motion: usize, position: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let mut axis = Vector3::zeros();
    axis[motion % 3] = 1.0;
    if motion < 3 {
        [axis, Vector3::zeros()]
    } else {
        [axis.cross(&(position - part.center)) / part.size, axis]
    }
}

/// `Phi_y H`: a row a constraint, six columns a part, each row scaled to one.
fn constraints_by_rigid_motions(system: &System, parts: &[Part]) -> Vec<RowDVector<f64>> {
    let numbering = system.numbering();
    let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
    let first = NODE_UNKNOWNS * numbering.nodes();
    let part_of = part_of_nodes(numbering.nodes(), parts);
    let mut rows = vec![RowDVector::zeros(6 * parts.len()); numbering.multipliers()];
    for (row, column, value) in tangent.by_unknowns.triplets() {
        let is_constraint = (first..numbering.first_scalar()).contains(&row);
        if !is_constraint || column >= first {
            continue;
        }
        let (node, place) = (column / NODE_UNKNOWNS, column % NODE_UNKNOWNS);
        let mut form = [Vector3::zeros(); 2];
        if place < Variable::Momentum.column() {
            form[place / 3][place % 3] = value;
            let position = &system.nodes()[node].position;
            let part = part_of[node];
            add_form(
                &mut rows[row - first],
                (part, &parts[part]),
                position,
                &form,
            );
        }
    }
    rows.iter_mut().for_each(scale_to_one);
    rows
}

/// Number of the part of each node.
fn part_of_nodes(nodes: usize, parts: &[Part]) -> Vec<usize> {
    let mut part_of = vec![0; nodes];
    for (i, part) in parts.iter().enumerate() {
        part.nodes.iter().for_each(|&node| part_of[node] = i);
    }
    part_of
}

/// A linear form of the motions of `nodes`, by the rigid motions of the parts.
fn row_of(
    system: &System,
    parts: &[Part],
    (nodes, form): (&[usize], &[[Vector3<f64>; 2]]),
) -> RowDVector<f64> {
    let part_of = part_of_nodes(system.nodes().len(), parts);
    let mut row = RowDVector::zeros(6 * parts.len());
    for (&node, form) in nodes.iter().zip(form) {
        let (part, position) = (part_of[node], &system.nodes()[node].position);
        add_form(&mut row, (part, &parts[part]), position, form);
    }
    scale_to_one(&mut row);
    row
}

/// Adds `d . u + r . theta` of a node at `position` in part number `part.0`.
fn add_form(
    row: &mut RowDVector<f64>,
    (number, part): (usize, &Part),
    position: &Vector3<f64>,
    [d, r]: &[Vector3<f64>; 2],
) {
    for motion in 0..6 {
        let [displacement, rotation] = rigid_motion(part, motion, position);
        row[6 * number + motion] += part.size * d.dot(&displacement) + r.dot(&rotation);
    }
}

fn scale_to_one(row: &mut RowDVector<f64>) {
    row.apply(|value| *value = finite(*value));
    let size = row.amax();
    if size > 0.0 {
        *row /= size;
    }
}

/// The number; zero for one that is not finite, on which decompositions do not end.
pub(super) fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// Orthonormal basis of the null space of rows of `columns` numbers, one column each.
fn null_space(rows: &[RowDVector<f64>], columns: usize) -> DMatrix<f64> {
    // At least as many rows as columns, so that the decomposition shows the null space.
    let mut matrix = DMatrix::zeros(rows.len().max(columns), columns);
    for (i, row) in rows.iter().enumerate() {
        matrix.set_row(i, row);
    }
    let decomposition = matrix.map(finite).svd(false, true);
    let largest = decomposition.singular_values.amax();
    let Some(v_t) = decomposition.v_t else {
        return DMatrix::zeros(columns, 0);
    };
    let values = decomposition.singular_values.iter().enumerate();
    let free: Vec<DVector<f64>> = values
        .filter(|(_, value)| **value <= ZERO * largest.max(1.0))
        .map(|(i, _)| v_t.row(i).transpose())
        .collect();
    match free.is_empty() {
        true => DMatrix::zeros(columns, 0),
        false => DMatrix::from_columns(&free),
    }
}

/// The free motions of one part in words. Unit motions that lie in the null space
/// are named by their axis, others by their components.
fn describe(system: &System, part: &Part, motions: &DMatrix<f64>) -> Mechanism {
    const WORDS: [&str; 6] = [
        "translation along x",
        "translation along y",
        "translation along z",
        "rotation about x",
        "rotation about y",
        "rotation about z",
    ];
    // A unit motion is free when its projection on the null space has length one.
    let pure: Vec<_> = (0..6)
        .filter(|&i| (motions.row(i).norm() - 1.0).abs() < 1e-6)
        .collect();
    let mut words: Vec<_> = pure.iter().map(|&i| WORDS[i].to_owned()).collect();
    let mixed = motions.column_iter().filter(|column| {
        let inside: f64 = pure.iter().map(|&i| column[i] * column[i]).sum();
        column.norm_squared() - inside > 1e-6
    });
    if let Some(column) = mixed.max_by(|a, b| a.norm().total_cmp(&b.norm())) {
        let largest = column.amax();
        let terms = (0..6).filter(|&i| column[i].abs() > 1e-3 * largest && !pure.contains(&i));
        let terms: Vec<_> = terms
            .map(|i| format!("{:+.3} {}", column[i] / largest, WORDS[i]))
            .collect();
        words.push(format!("together {}", terms.join(" ")));
    }
    let movement = |node: &usize| {
        let position = &system.nodes()[*node].position;
        let displacement = motions.column_iter().map(|column| {
            let moved: Vector3<f64> = (0..6)
                .map(|i| column[i] * rigid_motion(part, i, position)[0])
                .sum();
            moved.norm_squared()
        });
        displacement.sum::<f64>()
    };
    let most = part
        .nodes
        .iter()
        .max_by(|a, b| movement(a).total_cmp(&movement(b)));
    Mechanism {
        node: most.map_or_else(String::new, |&node| system.nodes()[node].label.clone()),
        nodes: part.nodes.len(),
        motions: words,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::Element;
    use crate::elements::beams::{Beam, BeamGeometry, BeamNode};
    use crate::elements::joints::{Hinge, HingeSpring, clamped};
    use crate::elements::springs::{Stand, SupportLaw, SupportSpring};
    use crate::model::Node;
    use nalgebra::{Matrix3, Matrix6};

    fn node(label: &str, x: f64) -> Node {
        Node {
            label: label.to_owned(),
            position: Vector3::new(x, 0.0, 0.0),
            rotation: Matrix3::identity(),
        }
    }

    fn beam(nodes: &[Node]) -> Box<dyn Element> {
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
        let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
        let stiffness = [Matrix6::identity() * 1e9; 2];
        Box::new(Beam::elastic(
            "beam",
            [0, 1, 2],
            geometry,
            undeformed,
            stiffness,
        ))
    }

    #[test]
    fn a_clamped_beam_is_sound_and_a_free_one_moves_in_six_ways() {
        let nodes = vec![node("root", 0.0), node("mid", 1.0), node("tip", 2.0)];
        let clamp: Box<dyn Element> = Box::new(clamped("clamp", 0, &nodes[0]));
        let held = System::new(nodes.clone(), vec![beam(&nodes), clamp]);
        assert_eq!(find(&held), Mobility::default());
        let free = System::new(nodes.clone(), vec![beam(&nodes)]);
        let found = find(&free).mechanisms;
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].motions.len(), 6);
        assert_eq!(found[0].nodes, 3);
    }

    #[test]
    fn a_loose_node_is_named() {
        let nodes = vec![
            node("root", 0.0),
            node("mid", 1.0),
            node("tip", 2.0),
            node("loose", 5.0),
        ];
        let clamp: Box<dyn Element> = Box::new(clamped("clamp", 0, &nodes[0]));
        let system = System::new(nodes.clone(), vec![beam(&nodes), clamp]);
        let found = find(&system).mechanisms;
        assert_eq!(found.len(), 1);
        let shown = found[0].to_string();
        assert!(
            shown.starts_with("free mechanism: node \"loose\" can move"),
            "{shown}"
        );
        assert!(shown.contains("translation along x"), "{shown}");
    }

    fn hinge(nodes: &[Node], stiffness: f64) -> Box<dyn Element> {
        let spring = HingeSpring {
            stiffness,
            ..HingeSpring::default()
        };
        let (on, ends) = ([0, 1], [&nodes[0], &nodes[1]]);
        let place = nodes[1].position;
        Box::new(Hinge::new("flap", on, ends, &place, &Vector3::y(), spring))
    }

    #[test]
    fn a_hinge_may_turn_and_a_forgotten_clamp_is_told_beside_it() {
        let nodes = vec![node("hub", 0.0), node("blade", 1.0)];
        let clamp = || -> Box<dyn Element> { Box::new(clamped("clamp", 0, &nodes[0])) };
        let free = find(&System::new(
            nodes.clone(),
            vec![clamp(), hinge(&nodes, 0.0)],
        ));
        assert_eq!(free.mechanisms, []);
        assert_eq!(free.free_hinges, ["flap"]);
        let held = find(&System::new(
            nodes.clone(),
            vec![clamp(), hinge(&nodes, 2.0)],
        ));
        assert_eq!(held, Mobility::default());
        let loose = find(&System::new(nodes.clone(), vec![hinge(&nodes, 0.0)]));
        assert_eq!(loose.mechanisms.len(), 2, "both parts move, as one");
        assert!(loose.mechanisms.iter().all(|part| !part.motions.is_empty()));
        assert_eq!(loose.free_hinges, ["flap"]);
    }

    #[test]
    fn springs_resist_in_their_directions() {
        let nodes = vec![node("mass", 3.0)];
        let law = |stiffness: [f64; 6]| {
            let axes = Matrix3::identity();
            SupportLaw::along(&axes, &stiffness, &[1.0; 6])
        };
        let found = |stiffness: [f64; 6]| {
            let law = law(stiffness);
            let spring = SupportSpring::new("spring", 0, &nodes[0], law, Stand::Frame);
            find(&System::new(nodes.clone(), vec![Box::new(spring)]))
        };
        assert_eq!(found([1.0, 1e-3, 1e6, 2.0, 3.0, 4.0]), Mobility::default());
        let free = found([1.0, 0.0, 1.0, 2.0, 0.0, 4.0]);
        let expected = ["translation along y", "rotation about y"];
        assert_eq!(free.mechanisms[0].motions, expected);
    }
}

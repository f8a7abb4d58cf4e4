//! Free mechanisms: motions without resistance.
//!
//! Nodes joined by elastic elements move as a rigid part if there is no strain. With H the six
//! rigid motions of each part and `Phi_y` the derivatives of the constraints at the undeformed
//! state, a motion is free if
//!
//! ```text
//! Phi_y H r = 0,   r /= 0
//! ```
//!
//! so that the mechanisms are the null space of a sparse matrix, for any stiffness of the beams.
//! Rotations are scaled by the size of the part.
//!
//! Motions that springs resist are further rows. Intended free motions of hinges are not
//! mechanisms: a motion that is free even with their rows (all hinges locked) is a mechanism; a
//! motion that is free only without them is a freedom of hinges. A hinge can move if it moves in a
//! vector of the null space whose free numbers have no pattern.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector, Vector3};
use shared_geom::error::Explain;

use super::System;
use super::elimination::{Echelon, SparseRow};
use crate::elements::Queries;
use crate::model::{Conditions, NODE_UNKNOWNS, Variable};

/// Remainder of rows of size one below which it is zero: their round-off is 1e-16.
const ZERO: f64 = 1e-9;
/// Fraction of a unit motion of the model above which a part moves.
const VISIBLE: f64 = 1e-6;

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A part of the model that can move freely.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("free mechanism: node \"{node}\"{} can move without resistance: {}", others(.nodes), .motions.join(", "))]
pub struct Mechanism {
    /// The node that moves most.
    pub node: String,
    /// Number of nodes in the part.
    pub nodes: usize,
    /// The free motions as text.
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
            "hold it with a [[clamp]], or connect it by a [[beam]] to a part that is held; for the \
             modes of a free body set free = true in [modes]"
                .to_owned(),
        )
    }
}

/// Motions of a model without resistance, undeformed and unloaded.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mobility {
    /// Motions that no element resists and no hinge permits; empty in a sound model.
    pub mechanisms: Vec<Mechanism>,
    /// Names of the hinges and other joints that can move.
    pub free_hinges: Vec<String>,
}

/// A linear form of the motions of parts, by columns.
type Form = BTreeMap<usize, f64>;

/// A rigid part: its nodes, a point near their middle and its size.
struct Part {
    nodes: Vec<usize>,
    center: Vector3<f64>,
    /// Largest distance of a node from the center, or one [m].
    size: f64,
}

/// The motions of the undeformed, unloaded model without resistance.
pub fn find(system: &System) -> Mobility {
    let parts = rigid_parts(system);
    if parts.is_empty() {
        return Mobility::default();
    }
    let part_of = part_of_nodes(system.nodes().len(), &parts);
    let parts_of = (&parts[..], &part_of[..]);
    let mut rows = constraints_by_rigid_motions(system, parts_of);
    let mut free = Vec::new();
    for element in system.elements() {
        for motion in element.motions() {
            let row = row_of(system, parts_of, (element.nodes(), &motion.form));
            if motion.is_resisted {
                rows.push(row)
            } else {
                free.push((element.label(), row))
            }
        }
    }
    let columns = 6 * parts.len();
    let unlocked = Echelon::of(rows.clone(), columns, ZERO);
    if unlocked.free().is_empty() {
        return Mobility::default();
    }
    let mut free_hinges = moving(&unlocked, columns, &free);
    free_hinges.dedup();
    rows.extend(free.into_iter().map(|(_, row)| row));
    Mobility {
        mechanisms: mechanisms(system, &parts, rows),
        free_hinges,
    }
}

/// Names of the hinges whose motions, given with them, are in the null space.
fn moving(unlocked: &Echelon, columns: usize, free: &[(&str, SparseRow)]) -> Vec<String> {
    let mut motion = vec![0.0; columns];
    for (i, &column) in unlocked.free().iter().enumerate() {
        // Numbers between 0.5 and 1, all different.
        motion[column] = 0.5 + 0.5 * (GOLDEN * (i + 1) as f64).fract();
    }
    unlocked.complete(&mut motion);
    let turns = |row: &SparseRow| {
        let parts = || row.iter().map(|(column, value)| value * motion[*column]);
        let size = parts().map(f64::abs).fold(0.0, f64::max);
        parts().sum::<f64>().abs() > VISIBLE * size
    };
    let free = free.iter().filter(|(_, row)| turns(row));
    free.map(|(label, _)| (*label).to_owned()).collect()
}

/// The parts that move if all hinges are locked, in each group of parts that rows connect.
fn mechanisms(system: &System, parts: &[Part], rows: Vec<SparseRow>) -> Vec<Mechanism> {
    let mut groups = Groups::new(parts.len());
    for row in &rows {
        for pair in row.windows(2) {
            groups.join(pair[0].0 / 6, pair[1].0 / 6);
        }
    }
    let forgotten = Echelon::of(rows, 6 * parts.len(), ZERO);
    if forgotten.free().is_empty() {
        return Vec::new();
    }
    let split = forgotten.split(|column| groups.of(column / 6));
    let members = groups.members();
    let mut motion = vec![0.0; 6 * parts.len()];
    let mut found = Vec::new();
    for (group, forgotten) in split {
        let own = &members[&group];
        let columns = || own.iter().flat_map(|part| 6 * part..6 * part + 6);
        let vectors = forgotten.free().iter().map(|&free| {
            columns().for_each(|column| motion[column] = 0.0);
            motion[free] = 1.0;
            forgotten.complete(&mut motion);
            DVector::from_iterator(6 * own.len(), columns().map(|column| motion[column]))
        });
        let vectors: Vec<_> = vectors.collect();
        if vectors.is_empty() {
            continue;
        }
        let basis = DMatrix::from_columns(&vectors).qr().q();
        for (index, &part) in own.iter().enumerate() {
            let motions = basis.rows(6 * index, 6).into_owned();
            if motions.amax() > VISIBLE {
                found.push((part, describe(system, &parts[part], &motions)));
            }
        }
    }
    found.sort_by_key(|(part, _)| *part);
    found.into_iter().map(|(_, mechanism)| mechanism).collect()
}

/// Nodes connected through elements that resist all their relative motions.
fn rigid_parts(system: &System) -> Vec<Part> {
    let mut groups = Groups::new(system.nodes().len());
    for element in system.elements().filter(|e| e.joins_nodes()) {
        for pair in element.nodes().windows(2) {
            groups.join(pair[0], pair[1]);
        }
    }
    let part = |nodes: Vec<usize>| {
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
    groups.members().into_values().map(part).collect()
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

/// `Phi_y H`: one row per constraint, six columns per part, each row scaled to one.
fn constraints_by_rigid_motions(
    system: &System,
    (parts, part_of): (&[Part], &[usize]),
) -> Vec<SparseRow> {
    let numbering = system.numbering();
    let tangent = system.tangent(&system.rest(), &Conditions::at_rest());
    let first = NODE_UNKNOWNS * numbering.nodes();
    let mut rows = vec![Form::new(); numbering.multipliers()];
    for (row, column, value) in tangent.by_unknowns.triplets() {
        let is_constraint = (first..numbering.first_scalar()).contains(&row);
        if !is_constraint || column >= first {
            continue;
        }
        let (node, index) = (column / NODE_UNKNOWNS, column % NODE_UNKNOWNS);
        let mut form = [Vector3::zeros(); 2];
        if index < Variable::Momentum.column() {
            form[index / 3][index % 3] = value;
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
    rows.into_iter().map(scaled_to_one).collect()
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
    (parts, part_of): (&[Part], &[usize]),
    (nodes, form): (&[usize], &[[Vector3<f64>; 2]]),
) -> SparseRow {
    let mut row = Form::new();
    for (&node, form) in nodes.iter().zip(form) {
        let (part, position) = (part_of[node], &system.nodes()[node].position);
        add_form(&mut row, (part, &parts[part]), position, form);
    }
    scaled_to_one(row)
}

/// Adds `d . u + r . theta` of a node at `position` in part number `part.0`.
fn add_form(
    row: &mut Form,
    (number, part): (usize, &Part),
    position: &Vector3<f64>,
    [d, r]: &[Vector3<f64>; 2],
) {
    for motion in 0..6 {
        let [displacement, rotation] = rigid_motion(part, motion, position);
        *row.entry(6 * number + motion).or_default() +=
            part.size * d.dot(&displacement) + r.dot(&rotation);
    }
}

fn scaled_to_one(row: Form) -> SparseRow {
    let size = row.values().map(|value| finite(*value).abs());
    let size = size.fold(0.0, f64::max);
    let entries = row
        .into_iter()
        .map(|(column, value)| (column, finite(value) / size));
    entries
        .filter(|entry| size > 0.0 && entry.1 != 0.0)
        .collect()
}

/// The number; zero if it is not finite, since decompositions of such numbers do not end.
pub(super) fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// Items that are joined in pairs.
struct Groups(Vec<usize>);

impl Groups {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// The group of an item: its first member.
    fn of(&mut self, one: usize) -> usize {
        let mut at = one;
        while self.0[at] != at {
            self.0[at] = self.0[self.0[at]];
            at = self.0[at];
        }
        at
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b)] = a.min(b);
    }

    /// The members of each group.
    fn members(mut self) -> BTreeMap<usize, Vec<usize>> {
        let mut members = BTreeMap::new();
        for one in 0..self.0.len() {
            let group = self.of(one);
            members.entry(group).or_insert_with(Vec::new).push(one);
        }
        members
    }
}

/// The free motions of one part as text. Unit motions in the null space are named by their axis,
/// others by their components.
fn describe(system: &System, part: &Part, motions: &DMatrix<f64>) -> Mechanism {
    const WORDS: [&str; 6] = [
        "translation along x",
        "translation along y",
        "translation along z",
        "rotation about x",
        "rotation about y",
        "rotation about z",
    ];
    // A unit motion is free if its projection on the null space has length one.
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
    use crate::elements::springs::{SupportFrame, SupportLaw, SupportSpring};
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
        let position = nodes[1].position;
        Box::new(Hinge::new(
            "flap",
            on,
            ends,
            &position,
            &Vector3::y(),
            spring,
        ))
    }

    #[test]
    fn a_hinge_may_turn_and_a_forgotten_clamp_is_reported_beside_it() {
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
            let spring = SupportSpring::new("spring", 0, &nodes[0], law, SupportFrame::Frame);
            find(&System::new(nodes.clone(), vec![Box::new(spring)]))
        };
        assert_eq!(found([1.0, 1e-3, 1e6, 2.0, 3.0, 4.0]), Mobility::default());
        let free = found([1.0, 0.0, 1.0, 2.0, 0.0, 4.0]);
        let expected = ["translation along y", "rotation about y"];
        assert_eq!(free.mechanisms[0].motions, expected);
    }
}

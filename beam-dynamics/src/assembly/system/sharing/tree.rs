//! The loads that balance each other in a loop, from a tree of its joints.
//!
//! Joints that close no ring form a tree: each holds one of its two nodes, the outer one, and its
//! constraints on it are independent. All other joints are cut. Each unit force in the constraints
//! of the cuts loads the nodes, and from the ends of the tree to its root each joint carries the
//! part of the load l of its outer node that its constraints can balance,
//!
//! ```text
//! A_o^T = Q R ,    mu = -R^-1 Q^T l                                                   (D-280)
//! ```
//!
//! with A_o its rows in the columns of that node, and transfers A_i^T mu to the inner one. The
//! remainder, l - Q Q^T l, must vanish, and the whole load at a root: the combinations of the unit
//! forces for which they do are the loads that balance each other. A ring thus has as many unknowns
//! as the closing joint has constraints, and the work is linear in the number of joints.

use nalgebra::DMatrix;

use super::basis;
use super::member::{MOTION, Member};

/// Least length of a row after orthogonalization to the others of its joint, as a fraction of its
/// length before; if a joint of the tree has a shorter row, all constraints are treated together.
const LEAST: f64 = 1e-3;

/// A joint of the tree.
#[derive(Debug, Clone)]
struct Branch {
    member: usize,
    /// Which node of the member is the outer one.
    outer: usize,
}

/// The joints of a loop as a tree, and its cuts.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    /// From the ends to the roots.
    branches: Vec<Branch>,
    /// Members that are cut.
    cuts: Vec<usize>,
    /// Load of the nodes, a row for each constraint of the cuts; then the remainder.
    left: DMatrix<f64>,
    /// Forces in the constraints of the loop, a column for each of the cuts.
    forces: DMatrix<f64>,
    /// Projection on the combinations without a remainder.
    balanced: DMatrix<f64>,
}

impl Tree {
    /// The tree of members on `nodes` nodes: it contains joints between two nodes, or a node and
    /// the frame, with at most six constraints, as near to the frame as possible.
    pub fn new(members: &[Member], nodes: usize) -> Self {
        let frame = nodes;
        let mut beside = vec![Vec::new(); nodes + 1];
        for (number, member) in members.iter().enumerate() {
            if let Some([a, b]) = ends(member, frame) {
                beside[a].push((number, b));
                beside[b].push((number, a));
            }
        }
        let mut reached = vec![false; nodes + 1];
        let mut is_cut = vec![true; members.len()];
        let mut branches = Vec::new();
        for root in (0..=nodes).rev() {
            if std::mem::replace(&mut reached[root], true) {
                continue;
            }
            let mut queue = std::collections::VecDeque::from([root]);
            while let Some(vertex) = queue.pop_front() {
                for &(member, other) in &beside[vertex] {
                    if std::mem::replace(&mut reached[other], true) {
                        continue;
                    }
                    is_cut[member] = false;
                    let own = members[member].nodes.iter();
                    let outer = own.take_while(|node| **node != other).count();
                    branches.push(Branch { member, outer });
                    queue.push_back(other);
                }
            }
        }
        branches.reverse();
        let cuts: Vec<_> = (0..members.len()).filter(|i| is_cut[*i]).collect();
        let units = cuts.iter().map(|cut| members[*cut].constraints().len());
        let units = units.sum();
        let count = members.last().map_or(0, |last| last.constraints().end);
        Self {
            branches,
            cuts,
            left: DMatrix::zeros(units, MOTION * nodes),
            forces: DMatrix::zeros(count, units),
            balanced: DMatrix::zeros(units, units),
        }
    }

    /// Writes an orthonormal basis of the loads that balance each other, as many as `out` has
    /// columns; returns whether this number exists, and all joints of the tree are regular.
    pub fn find(&mut self, members: &[Member], out: &mut DMatrix<f64>) -> bool {
        let (units, wanted) = (self.balanced.ncols(), out.ncols());
        if units < wanted {
            return false;
        }
        self.load(members);
        for Branch { member, outer } in &self.branches {
            let member = &members[*member];
            let loads = (&mut self.left, &mut self.forces);
            if carry(member, *outer, loads).is_none() {
                return false;
            }
        }
        let found = basis::gather(&mut self.left, units - wanted);
        basis::beside(&self.left, found, &mut self.balanced);
        if basis::gather(&mut self.balanced, wanted) < wanted {
            return false;
        }
        out.fill(0.0);
        for (k, mut column) in out.column_iter_mut().enumerate() {
            for (part, forces) in self
                .balanced
                .column(k)
                .iter()
                .zip(self.forces.column_iter())
            {
                column.axpy(*part, &forces, 1.0);
            }
        }
        basis::gather(out, wanted) == wanted
    }

    /// Unit forces in the constraints of the cuts, and their loads on the nodes.
    fn load(&mut self, members: &[Member]) {
        self.left.fill(0.0);
        self.forces.fill(0.0);
        let mut unit = 0;
        for cut in &self.cuts {
            let member = &members[*cut];
            for (row, constraint) in member.constraints().enumerate() {
                self.forces[(constraint, unit)] = 1.0;
                for (index, node) in member.nodes.iter().enumerate() {
                    for i in 0..MOTION {
                        let entry = member.rows[(row, MOTION * index + i)];
                        self.left[(unit, MOTION * node + i)] += entry;
                    }
                }
                unit += 1;
            }
        }
    }
}

/// The two ends of a joint that can be in the tree.
fn ends(member: &Member, frame: usize) -> Option<[usize; 2]> {
    let ends = match member.nodes[..] {
        [node] => [node, frame],
        [a, b] => [a, b],
        _ => return None,
    };
    let fits = (1..=MOTION).contains(&member.constraints().len());
    (fits && ends[0] != ends[1]).then_some(ends)
}

/// A square matrix of the motions of a node.
type Square = [[f64; MOTION]; MOTION];

/// Rows of a joint on its outer node, as an orthonormal basis q with `row_i = sum_j r_ij q_j`,
/// j up to i; `None` if one of them nearly follows from the others.
fn factors(member: &Member, outer: usize) -> Option<[Square; 2]> {
    let (mut q, mut r) = (Square::default(), Square::default());
    for i in 0..member.constraints().len() {
        let row = member.rows.row(i);
        for (k, value) in q[i].iter_mut().enumerate() {
            *value = row[MOTION * outer + k];
        }
        for _ in 0..2 {
            for j in 0..i {
                let (before, own) = q.split_at_mut(i);
                let along = dot(&before[j], &own[0]);
                r[i][j] += along;
                for (value, other) in own[0].iter_mut().zip(&before[j]) {
                    *value -= along * other;
                }
            }
        }
        r[i][i] = dot(&q[i], &q[i]).sqrt();
        let is_sound = r[i][i] > LEAST * row.norm();
        if !is_sound {
            return None;
        }
        q[i] = q[i].map(|value| value / r[i][i]);
    }
    Some([q, r])
}

fn dot(a: &[f64; MOTION], b: &[f64; MOTION]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The part of the loads of its outer node that a joint carries, for each unit force, and transfers
/// to the inner one (D-280).
fn carry(
    member: &Member,
    outer: usize,
    (loads, forces): (&mut DMatrix<f64>, &mut DMatrix<f64>),
) -> Option<()> {
    let [q, r] = factors(member, outer)?;
    let (first, count) = (member.constraints().start, member.constraints().len());
    let on_outer = MOTION * member.nodes[outer];
    // A joint on the frame has no inner node.
    let inner = (0..member.nodes.len()).find(|index| *index != outer);
    for unit in 0..loads.nrows() {
        let mut load = [0.0; MOTION];
        for (k, value) in load.iter_mut().enumerate() {
            *value = loads[(unit, on_outer + k)];
        }
        let mut taken = [0.0; MOTION];
        for i in 0..count {
            taken[i] = dot(&q[i], &load);
            for (value, along) in load.iter_mut().zip(&q[i]) {
                *value -= taken[i] * along;
            }
        }
        for (k, value) in load.iter().enumerate() {
            loads[(unit, on_outer + k)] = *value;
        }
        for i in (0..count).rev() {
            let later: f64 = (i + 1..count).map(|j| r[j][i] * taken[j]).sum();
            taken[i] = -(taken[i] + later) / r[i][i];
            forces[(first + i, unit)] = taken[i];
        }
        let Some(inner) = inner else { continue };
        let on_inner = MOTION * member.nodes[inner];
        for k in 0..MOTION {
            let sum: f64 = (0..count)
                .map(|i| member.rows[(i, MOTION * inner + k)] * taken[i])
                .sum();
            loads[(unit, on_inner + k)] += sum;
        }
    }
    Some(())
}

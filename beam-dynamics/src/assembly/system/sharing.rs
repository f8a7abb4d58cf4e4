//! How constraints that say the same share a load.
//!
//! Where constraints follow from others, the motion does not tell their multipliers apart
//! from those of other loads that balance each other. With A the rows of `Phi_y` in a closed
//! loop, each scaled to a unit displacement, and mu the forces along these displacements,
//! the smallest are taken:
//!
//! ```text
//! minimize mu^T mu   with A^T mu given:      P mu = 0,    P = I - Q Q^T          (D-170)
//! ```
//!
//! with Q an orthonormal basis of the columns of A. All constraints are kept, and
//!
//! ```text
//! Phi + s P mu = 0                                                               (D-171)
//! ```
//!
//! stands in their place: since `P Phi` vanishes where the other constraints are fulfilled,
//! both do. P is that of the places that a step predicts; as the rank of A is that of the
//! start, it goes continuously with the motion.

use nalgebra::DMatrix;

use super::{Residual, System, Workspace};
use crate::assembly::{Combination, Sparse};
use crate::elements::{Level, Queries};
use crate::model::{Conditions, NODE_UNKNOWNS, State};

/// Unknowns of the motion of a node.
const MOTION: usize = 6;
/// What is left of a column of A, beside the largest, counts as zero below this.
const ZERO: f64 = 1e-10;

/// Part of a constraint that is left to the loads that balance each other, below which it has
/// no part in them.
const NO_PART: f64 = 1e-12;

/// What a constraint of a loop gives way by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// The number of its multiplier.
    pub constraint: usize,
    /// What it gives way by [unit of the constraint].
    pub value: f64,
    /// The same as a part of the size of the model, or as an angle [-].
    pub part: f64,
}

/// What a constraint of a loop is driven by otherwise than the others allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contradiction {
    /// The number of its multiplier.
    pub constraint: usize,
    /// What it is off by [unit of the constraint/s].
    pub value: f64,
    /// The largest rate by which the loop is driven [unit of the constraint/s].
    pub size: f64,
}

/// The constraints of all loops at one state.
#[derive(Debug, Clone)]
pub struct Sharing {
    parts: Vec<Part>,
    /// Compliance s \[m/N\].
    compliance: f64,
    /// By which rotations are scaled \[m\].
    size: f64,
}

/// An element of a loop.
#[derive(Debug, Clone)]
struct Member {
    element: usize,
    /// Its first constraint among those of the loop.
    first: usize,
    levels: Vec<Level>,
    /// First column of each of its nodes.
    columns: Vec<usize>,
}

/// The constraints of one loop.
#[derive(Debug, Clone)]
struct Part {
    members: Vec<Member>,
    /// Numbers of the multipliers.
    constraints: Vec<usize>,
    /// Entries of the pattern, column by column.
    places: Vec<usize>,
    /// Rank of A at most.
    rank: usize,
    /// A, and in its first columns Q.
    rows: DMatrix<f64>,
    /// Force along a unit displacement by the multiplier of each constraint [-, 1/m].
    forces: Vec<f64>,
    /// P.
    shares: DMatrix<f64>,
    work: Vec<f64>,
}

impl Sharing {
    /// That of a system at the places of `state`.
    pub fn new(system: &System, state: &State, conditions: &Conditions) -> Self {
        let mut sharing = Self {
            parts: (system.loops.iter())
                .map(|of| Part::new(system, of))
                .collect(),
            compliance: system.compliance,
            size: system.size(),
        };
        sharing.update(system, state, conditions, &mut system.workspace());
        sharing
    }

    /// Finds P at the places of `state`.
    pub fn update(
        &mut self,
        system: &System,
        state: &State,
        conditions: &Conditions,
        work: &mut Workspace,
    ) {
        for part in &mut self.parts {
            part.read(system, (state, conditions), self.size, work);
            part.decompose();
        }
    }

    /// Takes from multipliers the part that balances itself, `P mu`: it is no load, and no
    /// element sees it. It stays known until the next call.
    pub fn take_surplus(&mut self, multipliers: &mut [f64]) {
        for part in &mut self.parts {
            part.multiply(multipliers);
            let numbers = part.constraints.iter().zip(&part.work).zip(&part.forces);
            for ((&constraint, surplus), force) in numbers {
                multipliers[constraint] -= surplus / force;
            }
        }
    }

    /// Adds `s P mu` to the constraints of a residual, the first of which has the given number.
    pub fn add_residual(&self, first: usize, out: &mut Residual) {
        for slack in self.slack() {
            out.values[first + slack.constraint] += slack.value;
        }
    }

    /// What each constraint of the loops gives way by, `s P mu` of the multipliers of
    /// [`Self::take_surplus`]: next to nothing, as long as those that followed from others do.
    pub fn slack(&self) -> impl Iterator<Item = Slack> + '_ {
        let (compliance, size) = (self.compliance, self.size);
        self.parts.iter().flat_map(move |part| {
            let numbers = part.constraints.iter().zip(&part.work).zip(&part.forces);
            numbers.map(move |((&constraint, surplus), force)| Slack {
                constraint,
                value: compliance * force * surplus,
                part: compliance * surplus / size,
            })
        })
    }

    /// How the constraints of the loops are driven otherwise than the others allow, by their
    /// own rates `Phi_t` \[unit of the constraint/s\], if all others come as near as they can:
    ///
    /// ```text
    /// mu^T A = 0  =>  mu^T Phi_t/s = 0,     off_i = s_i (P Phi_t/s)_i / P_ii         (D-172)
    /// ```
    pub fn contradictions<'a>(
        &'a mut self,
        rates: &'a [f64],
    ) -> impl Iterator<Item = Contradiction> + 'a {
        self.parts.iter_mut().flat_map(move |part| {
            part.project(|constraint, force| rates[constraint] / force);
            let part = &*part;
            let scaled = part.constraints.iter().zip(&part.forces);
            let scaled = scaled.map(|(&constraint, force)| (rates[constraint] / force).abs());
            let largest = scaled.fold(0.0, f64::max);
            let numbers = part.constraints.iter().enumerate();
            numbers.filter_map(move |(i, &constraint)| {
                let own = part.shares[(i, i)];
                (own > NO_PART).then(|| Contradiction {
                    constraint,
                    value: (part.forces[i] * part.work[i] / own).abs(),
                    size: part.forces[i] * largest,
                })
            })
        })
    }

    /// Adds the derivatives of [`Self::add_residual`], P being kept.
    pub fn add_jacobian(&self, out: &mut [Combination<'_>]) {
        for sum in out.iter_mut() {
            self.add_to(sum.by_algebraic, sum.matrix);
        }
    }

    fn add_to(&self, weight: f64, matrix: &mut Sparse) {
        for part in &self.parts {
            let count = part.constraints.len();
            for (entry, (&place, share)) in part.places.iter().zip(part.shares.iter()).enumerate() {
                let forces = part.forces[entry % count] * part.forces[entry / count];
                matrix.values_mut()[place] += weight * self.compliance * forces * share;
            }
        }
    }
}

impl Part {
    fn new(system: &System, of: &super::Loop) -> Self {
        let mut nodes: Vec<usize> = Vec::new();
        let mut constraints = Vec::new();
        let members = of.elements.iter().map(|&index| {
            let element = &system.elements[index];
            let columns = element.nodes().iter().map(|node| {
                let known = nodes.iter().position(|other| other == node);
                known.unwrap_or_else(|| {
                    nodes.push(*node);
                    nodes.len() - 1
                })
            });
            let columns = columns.map(|node| MOTION * node).collect();
            let first = constraints.len();
            constraints.extend(system.numbering.multipliers_of(index));
            let levels = (0..element.multipliers()).map(|i| element.level(i));
            Member {
                element: index,
                first,
                levels: levels.collect(),
                columns,
            }
        });
        let members = members.collect();
        let count = constraints.len();
        Self {
            members,
            places: system.shared_places(&constraints),
            rank: count - of.redundant.len().min(count),
            rows: DMatrix::zeros(count, MOTION * nodes.len()),
            forces: vec![1.0; count],
            shares: DMatrix::zeros(count, count),
            work: vec![0.0; count],
            constraints,
        }
    }

    /// Writes A.
    fn read(
        &mut self,
        system: &System,
        (state, conditions): (&State, &Conditions),
        size: f64,
        work: &mut Workspace,
    ) {
        self.rows.fill(0.0);
        for member in &self.members {
            let local = system.local_jacobian(member.element, state, conditions, work);
            let below = NODE_UNKNOWNS * member.columns.len();
            for (number, level) in member.levels.iter().enumerate() {
                let from = match level {
                    Level::Position => local.by_unknowns(),
                    Level::Velocity => local.by_rates(),
                };
                let row = member.first + number;
                let (mut along, mut about) = (0.0_f64, 0.0_f64);
                for (node, &column) in member.columns.iter().enumerate() {
                    let entry = |i: usize| from[(below + number, NODE_UNKNOWNS * node + i)];
                    let norm = |i: usize| entry(i).hypot(entry(i + 1)).hypot(entry(i + 2));
                    (along, about) = (along.max(norm(0)), about.max(norm(3)));
                    for i in 0..3 {
                        self.rows[(row, column + i)] += entry(i);
                        self.rows[(row, column + 3 + i)] += entry(3 + i) / size;
                    }
                }
                let force = if along > 0.0 { along } else { about / size };
                self.forces[row] = if force > 0.0 { force } else { 1.0 };
                let scale = 1.0 / self.forces[row];
                self.rows.row_mut(row).scale_mut(scale);
            }
        }
    }

    /// Q by the method of Gram and Schmidt, each time from the longest of the columns that
    /// are left and twice over; then P.
    fn decompose(&mut self) {
        let (count, columns) = self.rows.shape();
        let longest = |rows: &DMatrix<f64>, from: usize| {
            let norms = (from..columns).map(|j| (j, rows.column(j).norm_squared()));
            norms.fold((from, -1.0), |a, b| if b.1 > a.1 { b } else { a })
        };
        let all = longest(&self.rows, 0).1;
        let mut found = 0;
        while found < self.rank.min(columns) {
            let (column, norm) = longest(&self.rows, found);
            if norm <= ZERO * ZERO * all || !norm.is_finite() {
                break;
            }
            self.rows.swap_columns(found, column);
            self.take_from(found, 0..found);
            let norm = self.rows.column(found).norm();
            self.rows.column_mut(found).unscale_mut(norm);
            for other in found + 1..columns {
                self.take_from(other, found..found + 1);
            }
            found += 1;
        }
        let basis = self.rows.columns(0, found);
        self.shares.fill_with_identity();
        for j in 0..count {
            for i in 0..count {
                self.shares[(i, j)] -= basis.row(i).dot(&basis.row(j));
            }
        }
    }

    /// Makes a column orthogonal to others of length one.
    fn take_from(&mut self, column: usize, others: std::ops::Range<usize>) {
        for other in others {
            let along = self.rows.column(other).dot(&self.rows.column(column));
            for i in 0..self.rows.nrows() {
                self.rows[(i, column)] -= along * self.rows[(i, other)];
            }
        }
    }

    /// `P mu`, in `work`.
    fn multiply(&mut self, multipliers: &[f64]) {
        self.project(|constraint, force| force * multipliers[constraint]);
    }

    /// P times the numbers `of` each constraint, by its number and its force along a unit
    /// displacement; in `work`.
    fn project(&mut self, of: impl Fn(usize, f64) -> f64) {
        self.work.fill(0.0);
        for (column, &constraint) in self.constraints.iter().enumerate() {
            let number = of(constraint, self.forces[column]);
            for (sum, share) in self.work.iter_mut().zip(self.shares.column(column).iter()) {
                *sum += share * number;
            }
        }
    }
}

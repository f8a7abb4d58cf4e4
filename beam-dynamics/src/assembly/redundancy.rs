//! Redundant constraints: constraints that follow from others.
//!
//! With `Phi_y` the derivatives of the constraints at a state by displacements and rotations
//! (by velocities, for constraints of these), constraint i is redundant if
//!
//! ```text
//! Phi_y,i = sum_{k before i} c_k Phi_y,k
//! ```
//!
//! Its multiplier and the others' then share a load in no unique way, and the equations are
//! singular. Rotations are scaled by the size of the model, and each row to one. In the order of
//! the elements, each row is reduced by the rows before it, as the columns of `Phi_y^T` in a sparse
//! LU decomposition with partial pivoting (pivots of at least `PIVOT` of the largest entry, in the
//! column with fewest entries, which keeps it sparse): only round-off remains of a redundant one.
//! Work and memory follow the fill: linear for chains and trees of any size, at worst cubic in the
//! constraints of a closed net.
//!
//! The residual of a redundant constraint shows whether it currently agrees with the others. If it
//! is driven at a rate other than the constraints from which it follows imply, it contradicts them:
//!
//! ```text
//! Phi_t,i - sum_k c_k Phi_t,k != 0
//! ```

use std::collections::BTreeSet;

use nalgebra::Vector3;
use shared_geom::error::{Explain, joined};

use super::System;
use super::elimination::Echelon;
use crate::elements::{Element, Level, Queries};
use crate::model::{Conditions, NODE_UNKNOWNS, State, Variable};

/// Remainder of a row of size one below which it is zero: the entries have the tolerance of the
/// assembly of positions, 1e-10 and less.
const ZERO: f64 = 1e-8;
/// Rows are independent if, in any order, this multiple of [`ZERO`] remains of each.
const MARGIN: f64 = 10.0;
/// Least pivot as a fraction of the largest entry.
const PIVOT: f64 = 0.3;
/// Fraction of the largest coefficient above which a constraint is listed among the constraints
/// from which another follows.
const SHARE: f64 = 1e-6;

/// Fraction of the rates that is round-off.
const UNLIKE: f64 = 1e-6;
/// Rates below this are round-off of differences \[m/s or rad/s\].
const STILL: f64 = 1e-8;

/// A constraint that follows from others.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("constraint {number} ({direction}) of \"{joint}\" follows from {}", sources(.joint, .from))]
pub struct Redundant {
    /// The index of its multiplier in the system.
    pub constraint: usize,
    /// Name of the element.
    pub joint: String,
    /// Its number among the constraints of the element, from one.
    pub number: usize,
    /// Constrained direction as text: `along z`.
    pub direction: String,
    /// Names of the elements from whose constraints it follows, each once.
    pub from: Vec<String>,
    /// The constraints from which it follows, with the coefficients of the sum [-].
    combination: Vec<(usize, f64)>,
}

impl Redundant {
    /// The constraint, and the constraints from which it follows.
    pub fn group(&self) -> Vec<usize> {
        let parts = || self.combination.iter();
        let largest = parts().map(|part| part.1.abs()).fold(0.0, f64::max);
        let from = parts().filter(|part| part.1.abs() > SHARE * largest);
        std::iter::once(self.constraint)
            .chain(from.map(|part| part.0))
            .collect()
    }

    /// Difference between its driven rate and the rate implied by the constraints from which it
    /// follows, if they contradict; `rates` are the constraints' own, `Phi_t` \[m/s or rad/s\].
    pub fn contradiction(&self, rates: &[f64]) -> Option<f64> {
        let own = rates[self.constraint];
        let (mut off, mut size) = (own, own.abs());
        for &(source, coefficient) in &self.combination {
            off -= coefficient * rates[source];
            size += (coefficient * rates[source]).abs();
        }
        (off.abs() > UNLIKE * size && off.abs() > STILL).then_some(off.abs())
    }

    /// Whether it, or a constraint from which it follows, is driven at rates `Phi_t` \[m/s or
    /// rad/s\].
    pub fn is_driven(&self, rates: &[f64]) -> bool {
        let mut group = self.group().into_iter();
        group.any(|constraint| rates[constraint].abs() > STILL)
    }

    /// A contradiction as text.
    pub fn contradicting(&self, off: f64) -> String {
        let unit = if self.direction.starts_with("rotation") {
            "rad/s"
        } else {
            "m/s"
        };
        let off = format!("{off:.6e}").parse().unwrap_or(off);
        format!(
            "constraint {} ({}) of \"{}\" contradicts {}, by {off} {unit}",
            self.number,
            self.direction,
            self.joint,
            sources(&self.joint, &self.from)
        )
    }
}

fn sources(joint: &str, from: &[String]) -> String {
    let others: Vec<_> = from.iter().filter(|name| *name != joint).collect();
    let mut words: Vec<_> = others.iter().map(|name| format!("\"{name}\"")).collect();
    if others.len() < from.len() {
        words.push("its other constraints".to_owned());
    }
    match &words[..] {
        [] => "nothing: its derivatives are zero".to_owned(),
        words => joined(words),
    }
}

impl Explain for Redundant {
    fn help(&self) -> Option<String> {
        let help = "use a joint of fewer constraints, or set redundant = \"remove\" in \
            [transient]: the motion is the same, and the joints share the loads";
        Some(help.to_owned())
    }
}

/// A constraint by its derivatives.
struct Row {
    /// Entries (column, value), by ascending column, the largest of size one.
    entries: Vec<(usize, f64)>,
    /// Divisor of the entries.
    scale: f64,
    element: usize,
    number: usize,
}

/// A reduced row with its origin: `reduced = row - sum factor pivot`.
struct Reduced {
    constraint: usize,
    column: usize,
    entries: Vec<(usize, f64)>,
    /// Entry in the pivot column.
    pivot: f64,
    /// The pivots that were subtracted, with their factors.
    made_with: Vec<(usize, f64)>,
}

/// The redundant constraints of a system at a state, in order.
pub fn find(system: &System, state: &State, conditions: &Conditions) -> Vec<Redundant> {
    let rows = rows(system, state, conditions);
    if are_independent(&rows, system.numbering().unknowns()) {
        return Vec::new();
    }
    let mut search = Search::new(&rows, system.numbering().unknowns());
    let mut found = Vec::new();
    for (constraint, row) in rows.iter().enumerate() {
        let made_with = search.reduce(&row.entries);
        if search.take(constraint, &made_with) {
            continue;
        }
        let sources = search.sources(made_with);
        found.push(describe(system, &rows, constraint, &sources));
    }
    found
}

/// Whether no row follows from others by a margin: determined in an order that keeps chains of any
/// length sparse.
fn are_independent(rows: &[Row], columns: usize) -> bool {
    let entries = rows.iter().map(|row| row.entries.clone()).collect();
    Echelon::of(entries, columns, MARGIN * ZERO).rank() == rows.len()
}

/// The rows of `Phi_y`, scaled; empty if the constraint was removed.
fn rows(system: &System, state: &State, conditions: &Conditions) -> Vec<Row> {
    let mut rows: Vec<_> = system
        .elements()
        .enumerate()
        .flat_map(|(element, of)| (0..of.multipliers()).map(move |number| (element, number)))
        .map(|(element, number)| Row {
            entries: Vec::new(),
            scale: 1.0,
            element,
            number,
        })
        .collect();
    let tangent = system.tangent(state, conditions);
    let entries = system.constraint_rows(&tangent, &[Level::Position, Level::Velocity]);
    for (constraint, column, value) in entries {
        if value != 0.0 {
            rows[constraint].entries.push((column, value));
        }
    }
    let lever = system.size();
    for row in &mut rows {
        let turns = row.entries.iter_mut().filter(|entry| is_turn(entry.0));
        turns.for_each(|entry| entry.1 /= lever);
    }
    rows.iter_mut()
        .for_each(|row| row.scale = scale_to_one(&mut row.entries));
    rows
}

/// Whether an unknown of a node belongs to its rotation.
fn is_turn(column: usize) -> bool {
    column % NODE_UNKNOWNS >= Variable::Rotation.column()
}

/// Divisor that makes the largest entry of size one.
fn scale_to_one(entries: &mut [(usize, f64)]) -> f64 {
    let largest = entries
        .iter()
        .map(|entry| entry.1.abs())
        .fold(0.0, f64::max);
    if largest == 0.0 {
        return 1.0;
    }
    entries.iter_mut().for_each(|entry| entry.1 /= largest);
    largest
}

/// The decomposition so far.
struct Search {
    pivots: Vec<Reduced>,
    /// The pivot of each column.
    pivot_of: Vec<Option<usize>>,
    /// Number of constraints with an entry in each column.
    counts: Vec<usize>,
    /// The row to be reduced, and the columns where it may have entries.
    work: Vec<f64>,
    filled: BTreeSet<usize>,
}

impl Search {
    fn new(rows: &[Row], columns: usize) -> Self {
        let mut counts = vec![0; columns];
        for row in rows {
            row.entries.iter().for_each(|entry| counts[entry.0] += 1);
        }
        Self {
            pivots: Vec::new(),
            pivot_of: vec![None; columns],
            counts,
            work: vec![0.0; columns],
            filled: BTreeSet::new(),
        }
    }

    /// Subtracts the pivots from a row, which remains in `work`; returns the pivots with their
    /// factors.
    fn reduce(&mut self, entries: &[(usize, f64)]) -> Vec<(usize, f64)> {
        let mut waiting = BTreeSet::new();
        for &(column, value) in entries {
            self.work[column] = value;
            self.filled.insert(column);
            waiting.extend(self.pivot_of[column]);
        }
        // A pivot row has no entries in the columns of the previous pivots.
        let mut made_with = Vec::new();
        while let Some(number) = waiting.pop_first() {
            let pivot = &self.pivots[number];
            let factor = self.work[pivot.column] / pivot.pivot;
            if factor == 0.0 {
                continue;
            }
            for &(column, value) in &pivot.entries {
                self.work[column] -= factor * value;
                if self.filled.insert(column) {
                    let later = self.pivot_of[column].filter(|later| *later > number);
                    waiting.extend(later);
                }
            }
            self.work[pivot.column] = 0.0;
            made_with.push((number, factor));
        }
        made_with
    }

    /// Makes a pivot of the row in `work`, unless nothing remains of it.
    fn take(&mut self, constraint: usize, made_with: &[(usize, f64)]) -> bool {
        let left: Vec<_> = std::mem::take(&mut self.filled)
            .into_iter()
            .map(|column| (column, std::mem::take(&mut self.work[column])))
            .filter(|entry| entry.1 != 0.0)
            .collect();
        let largest = left.iter().map(|entry| entry.1.abs()).fold(0.0, f64::max);
        if largest <= ZERO {
            return false;
        }
        let fit = left.iter().filter(|entry| entry.1.abs() >= PIVOT * largest);
        let Some(&(column, pivot)) = fit.min_by_key(|entry| self.counts[entry.0]) else {
            return false;
        };
        self.pivot_of[column] = Some(self.pivots.len());
        self.pivots.push(Reduced {
            constraint,
            column,
            // Smaller ones are round-off.
            entries: left
                .into_iter()
                .filter(|entry| entry.1.abs() > 1e-14)
                .collect(),
            pivot,
            made_with: made_with.to_vec(),
        });
        true
    }

    /// The constraints, with their coefficients, in a sum of pivots.
    fn sources(&self, made_with: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
        let mut factors = std::collections::BTreeMap::from_iter(made_with);
        let mut found = Vec::new();
        while let Some((number, factor)) = factors.pop_last() {
            let pivot = &self.pivots[number];
            found.push((pivot.constraint, factor));
            for &(earlier, part) in &pivot.made_with {
                *factors.entry(earlier).or_insert(0.0) -= factor * part;
            }
        }
        found
    }
}

fn describe(
    system: &System,
    rows: &[Row],
    constraint: usize,
    sources: &[(usize, f64)],
) -> Redundant {
    let elements: Vec<_> = system.elements().collect();
    let row = &rows[constraint];
    let largest = sources
        .iter()
        .map(|source| source.1.abs())
        .fold(0.0, f64::max);
    let from = sources
        .iter()
        .filter(|source| source.1.abs() > SHARE * largest);
    let of: BTreeSet<_> = from.map(|source| rows[source.0].element).collect();
    Redundant {
        constraint,
        joint: elements[row.element].label().to_owned(),
        number: row.number + 1,
        direction: direction(row, elements[row.element]),
        from: of
            .into_iter()
            .map(|of| elements[of].label().to_owned())
            .collect(),
        combination: sources
            .iter()
            .map(|&(source, part)| (source, part * row.scale / rows[source].scale))
            .collect(),
    }
}

/// Constrained direction as text: the direction of the constraint's force on the last node of the
/// element, or of its moment.
fn direction(row: &Row, element: &dyn Element) -> String {
    let last = element.nodes().last().copied().unwrap_or(0);
    let part = |variable: Variable| {
        let first = NODE_UNKNOWNS * last + variable.column();
        let entries = row.entries.iter();
        entries.fold(
            Vector3::zeros(),
            |mut sum: Vector3<f64>, &(column, value)| {
                if (first..first + 3).contains(&column) {
                    sum[column - first] = value;
                }
                sum
            },
        )
    };
    let (along, about) = (part(Variable::Position), part(Variable::Rotation));
    if along.amax() > ZERO {
        format!("along {}", in_words(&along))
    } else {
        format!("rotation about {}", in_words(&about))
    }
}

/// `x`, or the components of the unit vector.
fn in_words(direction: &Vector3<f64>) -> String {
    let norm = direction.norm();
    if norm == 0.0 {
        return "nothing".to_owned();
    }
    let unit = direction / norm;
    let largest = unit.iamax();
    if (unit[largest].abs() - 1.0).abs() < 1e-9 {
        return ["x", "y", "z"][largest].to_owned();
    }
    let unit = unit * unit[largest].signum();
    let number = |value: f64| format!("{value:.3}").replace("-0.000", "0.000");
    format!(
        "({}, {}, {})",
        number(unit.x),
        number(unit.y),
        number(unit.z)
    )
}

#[cfg(test)]
mod tests;

//! Parts of a system that are summed in parallel: ranges of unknowns, each with the elements that
//! add to it.
//!
//! An element at the border of two parts is evaluated in both, and each part takes its own entries.
//! Every sum therefore has the same terms in the same order for any number of parts.

use std::ops::Range;

use super::kind::Kind;
use super::layout::{Buffers, Layout, Part, Within, Workspace};
use super::{Residual, System};
use crate::assembly::{Combination, Variation};
use crate::elements::LocalJacobian;
use crate::model::{Conditions, NODE_UNKNOWNS, State};

/// Number of unknowns from which a system has parts: 400 beams of three nodes.
const LARGE: usize = 800 * NODE_UNKNOWNS;

impl Workspace {
    /// Buffers for a system; a large system has as many parts as rayon has threads.
    pub(super) fn of(system: &System) -> Self {
        // Threads are started on request.
        let count = if system.numbering.unknowns() >= LARGE {
            rayon::current_num_threads()
        } else {
            1
        };
        Self::in_parts(system, count)
    }

    /// Buffers for a system in a number of parts.
    pub(super) fn in_parts(system: &System, count: usize) -> Self {
        let nodes = system.nodes.len();
        let border = |part: usize| {
            if part == count {
                system.numbering.unknowns()
            } else {
                NODE_UNKNOWNS * (nodes * part / count)
            }
        };
        let part = |k: usize| {
            let unknowns = border(k)..border(k + 1);
            let elements = (count > 1).then(|| elements(system, &unknowns));
            Part {
                unknowns,
                elements,
                buffers: Buffers::new(&system.kinds),
            }
        };
        Self {
            parts: (0..count).map(part).collect(),
            buffers: Buffers::new(&system.kinds),
        }
    }
}

/// Elements with unknowns in a range, and whether all their unknowns are in it.
fn elements(system: &System, unknowns: &Range<usize>) -> Vec<(u32, bool)> {
    let layouts = system.layouts.iter().enumerate();
    let found = layouts.filter_map(|(index, layout)| {
        let inside = layout.rows.iter().filter(|row| unknowns.contains(row));
        let count = inside.count();
        (count > 0).then_some((index as u32, count == layout.rows.len()))
    });
    found.collect()
}

/// The sums to be made, and their range.
#[derive(Debug, Clone, Copy)]
pub(super) struct Task<'a> {
    pub at: (&'a State, &'a Conditions),
    /// Rotations of the nodes by the unknowns of a formula, for its derivatives; empty if the
    /// derivatives are by the spatial variations; `None` for the residual alone.
    pub derivatives: Option<&'a [Variation]>,
}

/// Destination of the sums of derivatives.
pub(super) trait Sums {
    /// Adds the Jacobian of an element; `is_whole` if all its entries are present.
    fn add(&mut self, layout: &Layout, of: (&Kind, &LocalJacobian), is_whole: bool);
}

impl Sums for [Combination<'_>] {
    fn add(&mut self, layout: &Layout, (kind, local): (&Kind, &LocalJacobian), is_whole: bool) {
        let within = Within { first: 0, is_whole };
        for sum in self {
            let weights = sum.weights();
            layout.add_weighted(kind, local, weights, (within, sum.matrix.values_mut()));
        }
    }
}

/// The part of a sum of derivatives.
struct Share<'a> {
    weights: [f64; 3],
    /// Index of the first entry in the whole.
    first: usize,
    values: &'a mut [f64],
}

impl Sums for [Share<'_>] {
    fn add(&mut self, layout: &Layout, (kind, local): (&Kind, &LocalJacobian), is_whole: bool) {
        for share in self {
            let within = Within {
                first: share.first,
                is_whole,
            };
            layout.add_weighted(kind, local, share.weights, (within, &mut *share.values));
        }
    }
}

/// Splits the first `count` numbers off `rest`.
fn taken<'a>(rest: &mut &'a mut [f64], count: usize) -> &'a mut [f64] {
    let (first, others) = std::mem::take(rest).split_at_mut(count);
    *rest = others;
    first
}

impl System {
    /// Adds all elements to the sums, the parts in parallel.
    pub(super) fn sum(
        &self,
        task: &Task<'_>,
        out: &mut [Combination<'_>],
        residual: Option<&mut Residual>,
        work: &mut Workspace,
    ) {
        if let [part] = &mut work.parts[..] {
            let residual = residual.map(|it| [&mut it.values[..], &mut it.sizes[..]]);
            return self.sum_part(task, part, out, residual);
        }
        let starts = self.pattern.column_starts();
        let mut matrices: Vec<_> = out
            .iter_mut()
            .map(|sum| (sum.weights(), sum.matrix.values_mut()))
            .collect();
        let mut residual = residual.map(|it| [&mut it.values[..], &mut it.sizes[..]]);
        // The calling thread sums the last part, while the others wake.
        let last = work.parts.len() - 1;
        rayon::in_place_scope(|scope| {
            for (number, part) in work.parts.iter_mut().enumerate() {
                let entries = starts[part.unknowns.start]..starts[part.unknowns.end];
                let mut shares = Vec::with_capacity(matrices.len());
                for (weights, rest) in &mut matrices {
                    shares.push(Share {
                        weights: *weights,
                        first: entries.start,
                        values: taken(rest, entries.len()),
                    });
                }
                let own = part.unknowns.len();
                let residual = residual.as_mut();
                let residual =
                    residual.map(|[values, sizes]| [taken(values, own), taken(sizes, own)]);
                let sum = move || self.sum_part(task, part, &mut shares[..], residual);
                if number == last {
                    sum()
                } else {
                    scope.spawn(move |_| sum())
                }
            }
        });
    }
}

#[cfg(test)]
mod tests;

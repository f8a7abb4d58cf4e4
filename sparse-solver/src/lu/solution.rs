//! Solution with the factors: `L y = b`, then `U x = y`, in the order of elimination.
//!
//! Branches are solved in parallel, each in its own rows of b. The terms that a branch
//! subtracts from the rows of the trunk are summed separately, and these sums are added in the
//! order of the branches: the values are the same on any number of threads.

use pulp::{Arch, Simd, WithSimd};

use super::numbers::Numbers;
use super::structure::{Panel, Part, Strip, Structure};
use crate::number::{LANES, Number, Row};

/// Size of the buffer of [`solve`]: the numbers of b and the workspace after them.
pub(super) fn buffer_len(structure: &Structure) -> usize {
    let trunk = &structure.trunk.columns;
    trunk.end + structure.branches.len() * trunk.len()
}

/// Replaces b by x; `all` is b followed by the workspace (see [`buffer_len`]).
pub(super) fn solve<T: Number, R: Row<T>>(
    structure: &Structure,
    numbers: &Numbers<T>,
    all: &mut [R],
) {
    let (branches, trunk) = (&structure.branches[..], &structure.trunk);
    let (b, sums) = all.split_at_mut(trunk.columns.end);
    let given = (structure, numbers);
    sums.fill(R::NONE);
    side_by_side(given, Pass::Forward, branches, (b, 0), sums);
    if !branches.is_empty() {
        for sums in sums.chunks_exact(trunk.columns.len().max(1)) {
            for (b, sum) in b[trunk.columns.start..].iter_mut().zip(sums) {
                *b = b.plus(T::ONE, sum);
            }
        }
    }
    pass(given, Pass::Forward, trunk, (b, 0), &mut []);
    pass(given, Pass::Backward, trunk, (b, 0), &mut []);
    side_by_side(given, Pass::Backward, branches, (b, 0), sums);
}

/// `L y = b`, or `U x = y`.
#[derive(Debug, Clone, Copy)]
enum Pass {
    Forward,
    Backward,
}

/// A pass through independent parts: the rows from number `first` on, and for each part the
/// sums for the rows of the trunk.
fn side_by_side<T: Number, R: Row<T>>(
    given: (&Structure, &Numbers<T>),
    way: Pass,
    parts: &[Part],
    (b, first): (&mut [R], usize),
    sums: &mut [R],
) {
    match parts {
        [] => {}
        [part] => pass(given, way, part, (b, first), sums),
        _ => {
            let half = parts.len() / 2;
            let count = sums.len() / parts.len() * half;
            let (parts, later) = parts.split_at(half);
            let (sums, later_sums) = sums.split_at_mut(count);
            let begin = later[0].columns.start;
            let (b, later_b) = b.split_at_mut(begin - first);
            rayon::join(
                || side_by_side(given, way, parts, (b, first), sums),
                || side_by_side(given, way, later, (later_b, begin), later_sums),
            );
        }
    }
}

/// A pass through a part.
fn pass<T: Number, R: Row<T>>(
    (structure, numbers): (&Structure, &Numbers<T>),
    way: Pass,
    part: &Part,
    (b, first): (&mut [R], usize),
    sums: &mut [R],
) {
    Arch::new().dispatch(Solution {
        structure,
        numbers,
        way,
        part,
        rows: Rows {
            b,
            first,
            sums,
            trunk: structure.trunk.columns.start,
        },
    });
}

/// The rows of b that a pass through a part changes.
struct Rows<'a, R> {
    /// Rows of the part, or all rows, from number `first` on.
    b: &'a mut [R],
    first: usize,
    /// Terms that the part subtracts from the rows of the trunk, if these are not its own.
    sums: &'a mut [R],
    /// The first row of the trunk.
    trunk: usize,
}

/// A pass, compiled for each width of registers; the rounding is the same for all.
struct Solution<'a, T: Number, R> {
    structure: &'a Structure,
    numbers: &'a Numbers<T>,
    way: Pass,
    part: &'a Part,
    rows: Rows<'a, R>,
}

impl<T: Number, R: Row<T>> WithSimd for Solution<'_, T, R> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, _: S) {
        let (panels, strips) = (&self.structure.panels, &self.structure.strips);
        let part = self.part;
        match (self.way, self.rows.sums.is_empty()) {
            (Pass::Forward, true) => {
                let panels = panels[part.panels.clone()].iter();
                panels.for_each(|panel| self.forward::<true>(panel));
            }
            (Pass::Forward, false) => {
                let panels = panels[part.panels.clone()].iter();
                panels.for_each(|panel| self.forward::<false>(panel));
            }
            (Pass::Backward, _) => {
                // `for_each` of a reversed iterator is a function of its own, which is compiled
                // without the registers of this one.
                for strip in strips[part.strips.clone()].iter().rev() {
                    self.backward(strip);
                }
            }
        }
    }
}

/// `sum_j l_j y_j`.
#[inline(always)]
fn product<T: Number, R: Row<T>>(factors: &[T], known: &[R]) -> R {
    let pairs = factors.iter().zip(known);
    pairs.fold(R::NONE, |sum, (l, y)| sum.plus(*l, y))
}

impl<T: Number, R: Row<T>> Solution<'_, T, R> {
    /// `y_r = b_r - sum_j l_rj y_j` for the columns j of a panel; `WHOLE` if all rows are
    /// available.
    #[inline(always)]
    fn forward<const WHOLE: bool>(&mut self, panel: &Panel) {
        let Rows {
            b,
            first: before,
            sums,
            trunk,
        } = &mut self.rows;
        let (first, end) = panel.columns();
        let width = end - first;
        let rows = self.structure.rows_of(panel);
        let values = &self.numbers.lower[panel.values..panel.values + rows.len() * width];
        let (of_diagonal, below) = values.split_at(width * width);
        let (done, rest) = b.split_at_mut(end - *before);
        let known = &mut done[first - *before..];
        for (p, row) in of_diagonal.chunks_exact(width).enumerate() {
            known[p] = known[p].minus(product(row, &known[..p]));
        }
        for (&row, values) in rows[width..].iter().zip(below.chunks_exact(width)) {
            let row = row as usize;
            let b = if WHOLE || row < *trunk {
                &mut rest[row - end]
            } else {
                &mut sums[row - *trunk]
            };
            *b = b.minus(product(values, known));
        }
    }

    /// `x_d = (y_d - sum_{j > d} u_dj x_j) / u_dd` in a strip, and its terms in the rows above.
    #[inline(always)]
    fn backward(&mut self, strip: &Strip) {
        let (structure, numbers) = (self.structure, self.numbers);
        let (b, before) = (&mut *self.rows.b, self.rows.first);
        let panel = &structure.panels[strip.panel()];
        let (first, end) = panel.columns();
        let width = end - first;
        let (begin, end) = strip.columns();
        let (from, count) = (begin - first, end - begin);
        let mut x = [R::NONE; LANES];
        for d in (0..count).rev() {
            let at = panel.values + (from + d) * width + from;
            let row = &numbers.lower[at + d + 1..at + count];
            let k = begin + d;
            let sum = product(row, &x[d + 1..]);
            let own = &mut b[k - before];
            x[d] = own.minus(sum).times(numbers.inverse_pivots[k]);
            *own = x[d];
        }
        for segment in structure.segments_of(strip) {
            let (from, to) = segment.rows();
            let rows = &numbers.upper[segment.values()..segment.values() + to - from];
            for (y, row) in b[from - before..to - before].iter_mut().zip(rows) {
                let lanes = x.iter().enumerate();
                let sum = lanes.fold(R::NONE, |sum, (lane, x)| sum.plus(T::lane(row, lane), x));
                *y = y.minus(sum);
            }
        }
    }
}

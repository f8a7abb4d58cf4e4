//! Solution with the factors: `L y = b`, then `U x = y`, in the order of elimination.

use pulp::{Arch, Simd, WithSimd};

use super::number::{LANES, Number, Row};
use super::numbers::Numbers;
use super::structure::{Panel, Strip, Structure};

/// Replaces b by x.
pub(super) fn solve<T: Number, R: Row<T>>(
    structure: &Structure,
    numbers: &Numbers<T>,
    b: &mut [R],
) {
    Arch::new().dispatch(Solution {
        structure,
        numbers,
        b,
    });
}

/// Both passes, compiled for each width of registers; the rounding is the same for all.
struct Solution<'a, T: Number, R> {
    structure: &'a Structure,
    numbers: &'a Numbers<T>,
    b: &'a mut [R],
}

impl<T: Number, R: Row<T>> WithSimd for Solution<'_, T, R> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for panel in &self.structure.panels {
            forward(panel, self.numbers, self.b);
        }
        for strip in self.structure.strips.iter().rev() {
            backward(self.structure, strip, self.numbers, self.b);
        }
    }
}

/// `sum_j l_j y_j`.
#[inline(always)]
fn product<T: Number, R: Row<T>>(factors: &[T], known: &[R]) -> R {
    let pairs = factors.iter().zip(known);
    pairs.fold(R::NONE, |sum, (l, y)| sum.plus(*l, y))
}

/// `y_r = b_r - sum_j l_rj y_j` for the columns j of a panel.
#[inline(always)]
fn forward<T: Number, R: Row<T>>(panel: &Panel, numbers: &Numbers<T>, b: &mut [R]) {
    let (first, end) = panel.columns;
    let width = end - first;
    let values = &numbers.lower[panel.values..panel.values + panel.rows.len() * width];
    let (of_diagonal, below) = values.split_at(width * width);
    for (p, row) in of_diagonal.chunks_exact(width).enumerate() {
        b[first + p] = b[first + p].minus(product(row, &b[first..first + p]));
    }
    let rows = panel.rows[width..].iter().zip(below.chunks_exact(width));
    for (&row, values) in rows {
        b[row as usize] = b[row as usize].minus(product(values, &b[first..end]));
    }
}

/// `x_d = (y_d - sum_{j > d} u_dj x_j) / u_dd` in a strip, and what its x take from the
/// rows above.
#[inline(always)]
fn backward<T: Number, R: Row<T>>(
    structure: &Structure,
    strip: &Strip,
    numbers: &Numbers<T>,
    b: &mut [R],
) {
    let panel = &structure.panels[strip.panel];
    let (first, end) = panel.columns;
    let width = end - first;
    let (from, count) = (strip.columns.0 - first, strip.columns.1 - strip.columns.0);
    let mut x = [R::NONE; LANES];
    for d in (0..count).rev() {
        let at = panel.values + (from + d) * width + from;
        let row = &numbers.lower[at + d + 1..at + count];
        let k = strip.columns.0 + d;
        let sum = product(row, &x[d + 1..]);
        x[d] = b[k].minus(sum).times(numbers.inverse_pivots[k]);
        b[k] = x[d];
    }
    for segment in &strip.segments {
        let (from, to) = segment.rows;
        let rows = &numbers.upper[segment.values..segment.values + to - from];
        for (y, row) in b[from..to].iter_mut().zip(rows) {
            let lanes = x.iter().enumerate();
            let sum = lanes.fold(R::NONE, |sum, (lane, x)| sum.plus(T::lane(row, lane), x));
            *y = y.minus(sum);
        }
    }
}

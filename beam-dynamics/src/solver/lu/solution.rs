//! Solution with the factors: `L y = b`, then `U x = y`, in the order of elimination.

use super::numbers::Numbers;
use super::structure::{LANES, Panel, Strip, Structure};

/// Replaces b by x.
pub(super) fn solve(structure: &Structure, numbers: &Numbers, b: &mut [f64]) {
    for panel in &structure.panels {
        forward(panel, numbers, b);
    }
    for strip in structure.strips.iter().rev() {
        backward(structure, strip, numbers, b);
    }
}

/// `y_r = b_r - sum_j l_rj y_j` for the columns j of a panel.
fn forward(panel: &Panel, numbers: &Numbers, b: &mut [f64]) {
    let (first, end) = panel.columns;
    let width = end - first;
    let values = &numbers.lower[panel.values..panel.values + panel.rows.len() * width];
    let (of_diagonal, below) = values.split_at(width * width);
    for (p, row) in of_diagonal.chunks_exact(width).enumerate() {
        let known = &b[first..first + p];
        let sum: f64 = row.iter().zip(known).map(|(l, y)| l * y).sum();
        b[first + p] -= sum;
    }
    let rows = panel.rows[width..].iter().zip(below.chunks_exact(width));
    for (&row, values) in rows {
        let known = &b[first..end];
        let sum: f64 = values.iter().zip(known).map(|(l, y)| l * y).sum();
        b[row as usize] -= sum;
    }
}

/// `x_d = (y_d - sum_{j > d} u_dj x_j) / u_dd` in a strip, and what its x take from the
/// rows above.
fn backward(structure: &Structure, strip: &Strip, numbers: &Numbers, b: &mut [f64]) {
    let panel = &structure.panels[strip.panel];
    let (first, end) = panel.columns;
    let width = end - first;
    let (from, count) = (strip.columns.0 - first, strip.columns.1 - strip.columns.0);
    let mut x = [0.0; LANES];
    for d in (0..count).rev() {
        let at = panel.values + (from + d) * width + from;
        let row = &numbers.lower[at + d + 1..at + count];
        let sum: f64 = row.iter().zip(&x[d + 1..]).map(|(u, x)| u * x).sum();
        let k = strip.columns.0 + d;
        x[d] = (b[k] - sum) * numbers.inverse_pivots[k];
        b[k] = x[d];
    }
    for segment in &strip.segments {
        let (from, to) = segment.rows;
        let rows = &numbers.upper[segment.values..segment.values + to - from];
        for (y, row) in b[from..to].iter_mut().zip(rows) {
            let sum: f64 = row.iter().zip(&x).map(|(u, x)| u * x).sum();
            *y -= sum;
        }
    }
}

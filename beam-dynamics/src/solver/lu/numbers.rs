//! The numbers of the factors: `A = L U` on a known pattern, without pivoting.
//!
//! Strip after strip of columns, with x the columns of the strip, first those of A:
//!
//! ```text
//! above:     u_p = x_p - sum_{j < p} l_pj u_j           rows p of the segments
//!            x_r <- x_r - sum_j l_rj u_j                rows r below them    (D-133)
//! diagonal:  u_dd = x_d,  l_rd = x_r / u_dd             in the panel of the strip
//! ```
//!
//! The numbers of a row of x lie side by side, so that each is one instruction or two;
//! the rows of L are read as they are stored.

use pulp::{Arch, Simd, WithSimd};

use super::number::{Fused, LANES, Number, Plain, Product};
use super::structure::{Panel, Strip, Structure};

/// Rows that are computed at once.
const ROWS: usize = 4;

/// A size for each column of a strip.
type Sizes = [f64; LANES];

/// Numbers of the factors, and what tells how large they grow.
#[derive(Debug, Clone)]
pub(super) struct Numbers<T: Number> {
    /// Values of the panels, row by row.
    pub lower: Vec<T>,
    /// Values of the segments.
    pub upper: Vec<T::Lanes>,
    /// `1/u_dd` [-].
    pub inverse_pivots: Vec<T>,
    /// x, zero between strips.
    columns: Vec<T::Lanes>,
    growth: Growth,
}

/// Largest numbers of a factorization.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Growth {
    /// Of the matrix [-].
    pub matrix: f64,
    /// Of L [-].
    pub lower: f64,
    /// Of U [-].
    pub upper: f64,
    /// Least pivot [-].
    pub least_pivot: f64,
}

impl Growth {
    /// By how much the rounding of the factors exceeds that of the matrix [-]:
    /// `max|L| max|U| / max|A|` (D-134).
    pub fn factor(&self) -> f64 {
        self.lower.max(1.0) * self.upper / self.matrix
    }

    /// Least pivot relative to the matrix [-].
    pub fn least(&self) -> f64 {
        self.least_pivot / self.matrix
    }
}

/// A matrix that is to be factorized: values in the order of its pattern, scales in the
/// order of elimination.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scaled<'a, T> {
    pub values: &'a [T],
    pub row_scales: &'a [f64],
    pub column_scales: &'a [f64],
}

impl<T: Number> Numbers<T> {
    pub fn new(structure: &Structure) -> Self {
        let n = structure.panels.last().map_or(0, |panel| panel.columns.1);
        Self {
            lower: vec![T::ZERO; structure.panel_values],
            upper: vec![T::NONE; structure.segment_values],
            inverse_pivots: vec![T::ZERO; n],
            columns: vec![T::NONE; n],
            growth: Growth::default(),
        }
    }

    /// Computes the factors; `None` when a pivot is zero, or a number not finite.
    pub fn factorize(&mut self, structure: &Structure, matrix: Scaled<'_, T>) -> Option<Growth> {
        self.growth = Growth {
            least_pivot: f64::INFINITY,
            ..Growth::default()
        };
        let regular = Arch::new().dispatch(Elimination {
            numbers: self,
            structure,
            matrix,
        });
        if !regular {
            self.columns.fill(T::NONE);
        }
        regular.then_some(self.growth)
    }
}

/// All strips in turn, compiled for each width of registers.
struct Elimination<'a, T: Number> {
    numbers: &'a mut Numbers<T>,
    structure: &'a Structure,
    matrix: Scaled<'a, T>,
}

impl<T: Number> WithSimd for Elimination<'_, T> {
    type Output = bool;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> bool {
        // Registers of four numbers and more come with fused products, and so does ARM.
        match size_of::<S::f64s>() >= 32 || cfg!(target_arch = "aarch64") {
            true => self.run::<Fused>(),
            false => self.run::<Plain>(),
        }
    }
}

/// `x_r <- x_r - sum_j l_rj u_j` for some rows at once, which share the loads of u.
#[inline(always)]
fn below_segment<T: Number, P: Product, const N: usize>(
    columns: &mut [T::Lanes],
    rows: [usize; N],
    lower: [&[T]; N],
    upper: &[T::Lanes],
) {
    let lower = lower.map(|row| &row[..upper.len()]);
    let mut sums = rows.map(|row| columns[row]);
    for (j, u) in upper.iter().enumerate() {
        for (sum, row) in sums.iter_mut().zip(&lower) {
            T::take::<P>(sum, row[j], u);
        }
    }
    for (row, sum) in rows.into_iter().zip(sums) {
        columns[row] = sum;
    }
}

#[inline(always)]
fn enlarge(largest: &mut Sizes, sizes: &Sizes) {
    for lane in 0..LANES {
        largest[lane] = greater(largest[lane], sizes[lane]);
    }
}

/// The greater of two numbers, the first where the second is none: one instruction.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

fn largest(of: &Sizes) -> f64 {
    of.iter().fold(0.0, |a, b| a.max(*b))
}

impl<T: Number> Elimination<'_, T> {
    #[inline(always)]
    fn run<P: Product>(self) -> bool {
        let mut sizes = [[0.0; LANES]; 2];
        let mut loaded = [[0.0; LANES]; 2];
        for strip in &self.structure.strips {
            self.numbers
                .load(self.structure, strip, self.matrix, &mut loaded);
            self.numbers
                .above::<P>(self.structure, strip, &mut sizes[0]);
            let panel = &self.structure.panels[strip.panel];
            if !self.numbers.diagonal::<P>(panel, strip, &mut sizes) {
                return false;
            }
        }
        self.numbers.growth.matrix = largest(&loaded[0]);
        self.numbers.growth.upper = largest(&sizes[0]);
        self.numbers.growth.lower = largest(&sizes[1]);
        // Numbers that are infinite or none have left none there.
        loaded[1] == [0.0; LANES]
    }
}

impl<T: Number> Numbers<T> {
    /// The columns of the matrix; `sums` are zero as long as all its numbers are finite.
    #[inline(always)]
    fn load(
        &mut self,
        structure: &Structure,
        strip: &Strip,
        matrix: Scaled<'_, T>,
        [sizes, sums]: &mut [Sizes; 2],
    ) {
        let (first, end) = strip.columns;
        let scales = &matrix.column_scales[first..end];
        for (lane, (column, scale)) in strip.entries.iter().zip(scales).enumerate() {
            let [place, first, count] =
                [column.place, column.first, column.count].map(|number| number as usize);
            let values = &matrix.values[place..place + count];
            let rows = &structure.rows[first..first + count];
            let (values, last_values) = values.as_chunks::<LANES>();
            let (rows, last_rows) = rows.as_chunks::<LANES>();
            for (values, rows) in values.iter().zip(rows) {
                let rows = rows.map(|row| row as usize);
                let scaled: [T; LANES] =
                    std::array::from_fn(|i| values[i] * *scale * matrix.row_scales[rows[i]]);
                enlarge(sizes, &scaled.map(T::size));
                for i in 0..LANES {
                    sums[i] += 0.0 * values[i].size();
                    T::set_lane(&mut self.columns[rows[i]], lane, scaled[i]);
                }
            }
            for (value, row) in last_values.iter().zip(last_rows) {
                let row = *row as usize;
                let scaled = *value * *scale * matrix.row_scales[row];
                sizes[0] = greater(sizes[0], scaled.size());
                sums[0] += 0.0 * value.size();
                T::set_lane(&mut self.columns[row], lane, scaled);
            }
        }
    }

    /// Rows of U above the strip, and what they take from the rows below.
    #[inline(always)]
    fn above<P: Product>(&mut self, structure: &Structure, strip: &Strip, size: &mut Sizes) {
        for segment in &strip.segments {
            let panel = &structure.panels[segment.panel];
            let (first, end) = panel.columns;
            let width = end - first;
            let (from, to) = (segment.rows.0 - first, segment.rows.1 - first);
            let lower = &self.lower[panel.values..panel.values + panel.rows.len() * width];
            let upper = &mut self.upper[segment.values..segment.values + to - from];
            let own = &mut self.columns[segment.rows.0..segment.rows.1];
            for (p, x) in own.iter_mut().enumerate() {
                let mut sum = std::mem::replace(x, T::NONE);
                let at = (from + p) * width + from;
                for (l, u) in lower[at..at + p].iter().zip(upper.iter()) {
                    T::take::<P>(&mut sum, *l, u);
                }
                enlarge(size, &T::sizes(&sum));
                upper[p] = sum;
            }
            let below = &lower[to * width..];
            let rows = &panel.rows[to..];
            let quads = rows.chunks_exact(ROWS);
            let rest = quads.remainder();
            let (of_quads, of_rest) = below.split_at((rows.len() - rest.len()) * width);
            for (rows, values) in quads.zip(of_quads.chunks_exact(ROWS * width)) {
                let rows = std::array::from_fn(|i| rows[i] as usize);
                let first: [_; ROWS] =
                    std::array::from_fn(|i| &values[i * width + from..i * width + to]);
                below_segment::<T, P, ROWS>(&mut self.columns, rows, first, upper);
            }
            for (row, values) in rest.iter().zip(of_rest.chunks_exact(width)) {
                let row = [*row as usize];
                below_segment::<T, P, 1>(&mut self.columns, row, [&values[from..to]], upper);
            }
        }
    }

    /// The diagonal block of the strip and the rows below; `false` where a pivot is zero
    /// or not finite.
    #[inline(always)]
    fn diagonal<P: Product>(
        &mut self,
        panel: &Panel,
        strip: &Strip,
        [upper_size, lower_size]: &mut [Sizes; 2],
    ) -> bool {
        let (first, end) = panel.columns;
        let width = end - first;
        let (from, count) = (strip.columns.0 - first, strip.columns.1 - strip.columns.0);
        let lower = &mut self.lower[panel.values..panel.values + panel.rows.len() * width];
        // Rows of U right of the diagonal, and inverse pivots; zero where there are none.
        let (mut upper, mut inverse) = ([T::NONE; LANES], [T::ZERO; LANES]);
        let (of_diagonal, below) = lower[from * width..].split_at_mut(count * width);
        let (rows, rows_below) = panel.rows[from..].split_at(count);
        for (d, (row, values)) in rows
            .iter()
            .zip(of_diagonal.chunks_exact_mut(width))
            .enumerate()
        {
            let mut x = std::mem::replace(&mut self.columns[*row as usize], T::NONE);
            for j in 0..d {
                divide::<T, P>(&mut x, j, &inverse, &upper, lower_size);
            }
            store::<T>(&mut values[from..from + count], &x);
            let pivot = T::lane(&x, d);
            let size = pivot.size();
            if size == 0.0 || !size.is_finite() {
                return false;
            }
            self.growth.least_pivot = self.growth.least_pivot.min(size);
            inverse[d] = T::ONE / pivot;
            self.inverse_pivots[strip.columns.0 + d] = inverse[d];
            upper_size[d] = greater(upper_size[d], size);
            for lane in d + 1..count {
                let value = T::lane(&x, lane);
                upper_size[d] = greater(upper_size[d], value.size());
                T::set_lane(&mut upper[d], lane, value);
            }
        }
        for (row, values) in rows_below.iter().zip(below.chunks_exact_mut(width)) {
            let mut x = std::mem::replace(&mut self.columns[*row as usize], T::NONE);
            // Where the strip has fewer columns, all that belongs to the others is zero.
            for j in 0..LANES {
                divide::<T, P>(&mut x, j, &inverse, &upper, lower_size);
            }
            match count == LANES {
                true => store::<T>(&mut values[from..from + LANES], &x),
                false => store::<T>(&mut values[from..from + count], &x),
            }
        }
        true
    }
}

/// Stores the numbers of a row in the columns of a strip.
#[inline(always)]
fn store<T: Number>(values: &mut [T], x: &T::Lanes) {
    for (lane, value) in values.iter_mut().enumerate() {
        *value = T::lane(x, lane);
    }
}

/// `l_j = x_j / u_jj`, and what it takes from the columns after j.
#[inline(always)]
fn divide<T: Number, P: Product>(
    x: &mut T::Lanes,
    j: usize,
    inverse: &[T; LANES],
    upper: &[T::Lanes; LANES],
    size: &mut Sizes,
) {
    let factor = T::lane(x, j) * inverse[j];
    T::set_lane(x, j, factor);
    size[j] = greater(size[j], factor.size());
    T::take::<P>(x, factor, &upper[j]);
}

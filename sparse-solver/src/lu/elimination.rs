//! The elimination: `A = L U` on a known pattern, without pivoting.
//!
//! One strip of columns after another, with x the columns of the strip, initially the columns
//! of A:
//!
//! ```text
//! above:     u_p = x_p - sum_{j < p} l_pj u_j           rows p of the segments
//!            x_r <- x_r - sum_j l_rj u_j                rows r below them    (D-133)
//! diagonal:  u_dd = x_d,  l_rd = x_r / u_dd             in the panel of the strip
//! ```
//!
//! The numbers of a row of x are contiguous, so that each operation is one instruction or two;
//! the rows of L are read in the order of storage.

use pulp::{Arch, Simd, WithSimd};

use super::structure::{Panel, Part, Strip, Structure};
use crate::number::{Fused, LANES, Number, Plain, Product};

/// Number of rows computed at once.
const ROWS: usize = 4;

/// A size for each column of a strip.
pub(super) type Sizes = [f64; LANES];

/// Largest entry of a part of the matrix, and its least pivot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extremes {
    pub matrix: f64,
    pub least_pivot: f64,
}

impl Extremes {
    /// The extremes of an empty part.
    pub const NONE: Self = Self {
        matrix: 0.0,
        least_pivot: f64::INFINITY,
    };

    pub fn and(self, other: Self) -> Self {
        Self {
            matrix: self.matrix.max(other.matrix),
            least_pivot: self.least_pivot.min(other.least_pivot),
        }
    }
}

/// A matrix to be factorized: values in the order of its pattern, scales in the order of
/// elimination.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scaled<'a, T> {
    pub values: &'a [T],
    pub row_scales: &'a [f64],
    pub column_scales: &'a [f64],
}

/// The values of the factors that an elimination writes and reads, or the values of some parts.
#[derive(Debug)]
pub(super) struct Area<'a, T: Number, R = &'a mut [<T as Number>::Lanes]> {
    pub lower: &'a mut [T],
    pub upper: &'a mut [T::Lanes],
    pub inverse_pivots: &'a mut [T],
    pub sizes: &'a mut [[Sizes; 2]],
    /// Rows of the strip being computed, zero between strips.
    pub columns: R,
    /// Index of the first value of each in the whole; columns begin where the pivots do.
    pub first: [usize; 4],
}

impl<'a, T: Number> Area<'a, T> {
    /// Reborrows the same values.
    pub fn again(&mut self) -> Area<'_, T> {
        Area {
            lower: self.lower,
            upper: self.upper,
            inverse_pivots: self.inverse_pivots,
            sizes: self.sizes,
            columns: self.columns,
            first: self.first,
        }
    }

    /// The values of the parts before `at`, and the others.
    pub fn split(self, at: &Part) -> (Self, Self) {
        let starts = [&at.lower, &at.upper, &at.columns, &at.panels].map(|range| range.start);
        let count = |i: usize| starts[i] - self.first[i];
        let lower = self.lower.split_at_mut(count(0));
        let upper = self.upper.split_at_mut(count(1));
        let inverse_pivots = self.inverse_pivots.split_at_mut(count(2));
        let sizes = self.sizes.split_at_mut(count(3));
        let columns = self.columns.split_at_mut(count(2));
        let before = Self {
            lower: lower.0,
            upper: upper.0,
            inverse_pivots: inverse_pivots.0,
            sizes: sizes.0,
            columns: columns.0,
            first: self.first,
        };
        let after = Self {
            lower: lower.1,
            upper: upper.1,
            inverse_pivots: inverse_pivots.1,
            sizes: sizes.1,
            columns: columns.1,
            first: starts,
        };
        (before, after)
    }
}

/// Computes the values of a part; `None` if a pivot is zero, or a value not finite. The rows of
/// the trunk in the columns of a branch are written to `beyond`, which is `None` for the trunk
/// itself.
pub(super) fn eliminate<T: Number>(
    (structure, matrix): (&Structure, Scaled<'_, T>),
    part: &Part,
    area: Area<'_, T>,
    beyond: Option<&mut [T::Lanes]>,
) -> Option<Extremes> {
    let given = (structure, matrix, part);
    let Some(beyond) = beyond else {
        return computed(given, area);
    };
    let columns = OfBranch {
        own: area.columns,
        first: area.first[2],
        end: structure.columns().len() - beyond.len(),
        beyond,
    };
    let area = Area {
        columns,
        lower: area.lower,
        upper: area.upper,
        inverse_pivots: area.inverse_pivots,
        sizes: area.sizes,
        first: area.first,
    };
    computed(given, area)
}

fn computed<T: Number, R: Rows<T::Lanes>>(
    (structure, matrix, part): (&Structure, Scaled<'_, T>, &Part),
    area: Area<'_, T, R>,
) -> Option<Extremes> {
    Arch::new().dispatch(Elimination {
        structure,
        matrix,
        part,
        area,
        least_pivot: f64::INFINITY,
    })
}

/// Rows of the strip being computed, zero before and after.
trait Rows<L> {
    /// One row.
    fn at(&mut self, row: usize) -> &mut L;

    /// Consecutive rows of the part itself.
    fn own(&mut self, range: (usize, usize)) -> &mut [L];
}

/// All rows, for the trunk.
impl<L> Rows<L> for &mut [L] {
    #[inline(always)]
    fn at(&mut self, row: usize) -> &mut L {
        &mut self[row]
    }

    #[inline(always)]
    fn own(&mut self, (from, to): (usize, usize)) -> &mut [L] {
        &mut self[from..to]
    }
}

/// Rows of a branch.
struct OfBranch<'a, L> {
    own: &'a mut [L],
    /// First own row.
    first: usize,
    /// First row of the trunk.
    end: usize,
    /// Rows of the trunk.
    beyond: &'a mut [L],
}

impl<L> Rows<L> for OfBranch<'_, L> {
    #[inline(always)]
    fn at(&mut self, row: usize) -> &mut L {
        if row < self.end {
            &mut self.own[row - self.first]
        } else {
            &mut self.beyond[row - self.end]
        }
    }

    #[inline(always)]
    fn own(&mut self, (from, to): (usize, usize)) -> &mut [L] {
        &mut self.own[from - self.first..to - self.first]
    }
}

/// All strips of a part in turn, compiled for each width of registers.
struct Elimination<'a, T: Number, R> {
    structure: &'a Structure,
    matrix: Scaled<'a, T>,
    part: &'a Part,
    area: Area<'a, T, R>,
    least_pivot: f64,
}

impl<T: Number, R: Rows<T::Lanes>> WithSimd for Elimination<'_, T, R> {
    type Output = Option<Extremes>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        // Registers of four numbers and more have fused products, and so has ARM.
        if size_of::<S::f64s>() >= 32 || cfg!(target_arch = "aarch64") {
            self.run::<Fused>()
        } else {
            self.run::<Plain>()
        }
    }
}

/// `x_r <- x_r - sum_j l_rj u_j` for several rows at once, which share the loads of u.
#[inline(always)]
fn below_segment<T: Number, P: Product, const N: usize>(
    columns: &mut impl Rows<T::Lanes>,
    rows: [usize; N],
    lower: [&[T]; N],
    upper: &[T::Lanes],
) {
    let lower = lower.map(|row| &row[..upper.len()]);
    let mut sums = rows.map(|row| *columns.at(row));
    for (j, u) in upper.iter().enumerate() {
        for (sum, row) in sums.iter_mut().zip(&lower) {
            T::take::<P>(sum, row[j], u);
        }
    }
    for (row, sum) in rows.into_iter().zip(sums) {
        *columns.at(row) = sum;
    }
}

#[inline(always)]
fn enlarge(largest: &mut Sizes, sizes: &Sizes) {
    for lane in 0..LANES {
        largest[lane] = greater(largest[lane], sizes[lane]);
    }
}

/// The greater of two numbers, the first if the second is NaN: one instruction.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

impl<T: Number, R: Rows<T::Lanes>> Elimination<'_, T, R> {
    #[inline(always)]
    fn run<P: Product>(mut self) -> Option<Extremes> {
        let mut loaded = [[0.0; LANES]; 2];
        let structure = self.structure;
        for strip in &structure.strips[self.part.strips.clone()] {
            let panel = &structure.panels[strip.panel()];
            if strip.columns().0 == panel.columns().0 {
                self.area.sizes[strip.panel() - self.area.first[3]] = [[0.0; LANES]; 2];
            }
            self.load(strip, &mut loaded);
            self.above::<P>(strip);
            if !self.diagonal::<P>(panel, strip) {
                return None;
            }
        }
        // Numbers that are infinite or none have left none there.
        (loaded[1] == [0.0; LANES]).then(|| Extremes {
            matrix: loaded[0].iter().fold(0.0, |a, b| a.max(*b)),
            least_pivot: self.least_pivot,
        })
    }

    /// Loads the columns of the matrix; `sums` are zero as long as all its values are finite.
    #[inline(always)]
    fn load(&mut self, strip: &Strip, [sizes, sums]: &mut [Sizes; 2]) {
        let Self {
            structure, matrix, ..
        } = *self;
        let (first, end) = strip.columns();
        for (lane, k) in (first..end).enumerate() {
            let scale = &matrix.column_scales[k];
            let entries = structure.entries(k);
            let rows = &structure.pattern.rows()[entries.clone()];
            let values = &matrix.values[entries];
            let (values, last_values) = values.as_chunks::<LANES>();
            let (rows, last_rows) = rows.as_chunks::<LANES>();
            for (values, rows) in values.iter().zip(rows) {
                let rows = rows.map(|row| structure.row_indices[row as usize] as usize);
                let scaled: [T; LANES] =
                    std::array::from_fn(|i| values[i] * *scale * matrix.row_scales[rows[i]]);
                enlarge(sizes, &scaled.map(T::size));
                for i in 0..LANES {
                    sums[i] += 0.0 * values[i].size();
                    T::set_lane(self.area.columns.at(rows[i]), lane, scaled[i]);
                }
            }
            for (value, row) in last_values.iter().zip(last_rows) {
                let row = structure.row_indices[*row as usize] as usize;
                let scaled = *value * *scale * matrix.row_scales[row];
                sizes[0] = greater(sizes[0], scaled.size());
                sums[0] += 0.0 * value.size();
                T::set_lane(self.area.columns.at(row), lane, scaled);
            }
        }
    }

    /// Rows of U above the strip, and their terms in the rows below.
    #[inline(always)]
    fn above<P: Product>(&mut self, strip: &Strip) {
        let structure = self.structure;
        let [first_lower, first_upper, _, first_size] = self.area.first;
        for segment in structure.segments_of(strip) {
            let panel = &structure.panels[segment.panel()];
            let (first, end) = panel.columns();
            let width = end - first;
            let own = segment.rows();
            let (from, to) = (own.0 - first, own.1 - first);
            let rows = structure.rows_of(panel);
            let at = panel.values - first_lower;
            let lower = &self.area.lower[at..at + rows.len() * width];
            let at = segment.values() - first_upper;
            let upper = &mut self.area.upper[at..at + to - from];
            let of_panel = &mut self.area.sizes[segment.panel() - first_size][1];
            let mut size = *of_panel;
            let own = self.area.columns.own(own);
            for (p, x) in own.iter_mut().enumerate() {
                let mut sum = std::mem::replace(x, T::NONE);
                let at = (from + p) * width + from;
                for (l, u) in lower[at..at + p].iter().zip(upper.iter()) {
                    T::take::<P>(&mut sum, *l, u);
                }
                enlarge(&mut size, &T::sizes(&sum));
                upper[p] = sum;
            }
            *of_panel = size;
            let below = &lower[to * width..];
            let rows = &rows[to..];
            let quads = rows.chunks_exact(ROWS);
            let rest = quads.remainder();
            let (of_quads, of_rest) = below.split_at((rows.len() - rest.len()) * width);
            for (rows, values) in quads.zip(of_quads.chunks_exact(ROWS * width)) {
                let rows = std::array::from_fn(|i| rows[i] as usize);
                let first: [_; ROWS] =
                    std::array::from_fn(|i| &values[i * width + from..i * width + to]);
                below_segment::<T, P, ROWS>(&mut self.area.columns, rows, first, upper);
            }
            for (row, values) in rest.iter().zip(of_rest.chunks_exact(width)) {
                let row = [*row as usize];
                below_segment::<T, P, 1>(&mut self.area.columns, row, [&values[from..to]], upper);
            }
        }
    }

    /// The diagonal block of the strip and the rows below; `false` if a pivot is zero or not
    /// finite.
    #[inline(always)]
    fn diagonal<P: Product>(&mut self, panel: &Panel, strip: &Strip) -> bool {
        let (first, end) = panel.columns();
        let width = end - first;
        let (begin, end) = strip.columns();
        let (from, count) = (begin - first, end - begin);
        let rows = self.structure.rows_of(panel);
        let [first_lower, _, first_pivot, first_size] = self.area.first;
        let [mut lower_size, mut upper_size] = self.area.sizes[strip.panel() - first_size];
        let at = panel.values - first_lower;
        let lower = &mut self.area.lower[at..at + rows.len() * width];
        // Rows of U right of the diagonal, and inverse pivots; zero for missing columns.
        let (mut upper, mut inverse) = ([T::NONE; LANES], [T::ZERO; LANES]);
        let (of_diagonal, below) = lower[from * width..].split_at_mut(count * width);
        let (rows, rows_below) = rows[from..].split_at(count);
        for (d, (row, values)) in rows
            .iter()
            .zip(of_diagonal.chunks_exact_mut(width))
            .enumerate()
        {
            let mut x = std::mem::replace(self.area.columns.at(*row as usize), T::NONE);
            for j in 0..d {
                divide::<T, P>(&mut x, j, &inverse, &upper, &mut lower_size);
            }
            store::<T>(&mut values[from..from + count], &x);
            let pivot = T::lane(&x, d);
            let size = pivot.size();
            if size == 0.0 || !size.is_finite() {
                return false;
            }
            self.least_pivot = self.least_pivot.min(size);
            inverse[d] = T::ONE / pivot;
            self.area.inverse_pivots[begin + d - first_pivot] = inverse[d];
            upper_size[d] = greater(upper_size[d], size);
            for lane in d + 1..count {
                let value = T::lane(&x, lane);
                upper_size[d] = greater(upper_size[d], value.size());
                T::set_lane(&mut upper[d], lane, value);
            }
        }
        for (row, values) in rows_below.iter().zip(below.chunks_exact_mut(width)) {
            let mut x = std::mem::replace(self.area.columns.at(*row as usize), T::NONE);
            // If the strip has fewer columns, all values of the others are zero.
            for j in 0..LANES {
                divide::<T, P>(&mut x, j, &inverse, &upper, &mut lower_size);
            }
            if count == LANES {
                store::<T>(&mut values[from..from + LANES], &x)
            } else {
                store::<T>(&mut values[from..from + count], &x)
            }
        }
        self.area.sizes[strip.panel() - first_size] = [lower_size, upper_size];
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

/// `l_j = x_j / u_jj`, and its terms in the columns after j.
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

//! Elimination of the unknowns without rates (D-334).

use faer::Mat;

use super::ranked::{Ranked, ranked, split};
use super::scaled::Scaled;
use super::system::NotMinimal;

/// Part of the largest pivot below which a combination of unknowns has no rate.
const NO_RATE: f64 = 1e-12;
/// Pivots below this, of rows and columns of the size of one, are zero.
const ZERO: f64 = 1e-10;
/// Part of a constraint, relative to its other terms, from which on it depends on an input.
const MOVED: f64 = 1e-9;
/// Derivatives of constraints: more have no mechanical origin.
const DERIVATIVES: usize = 5;

/// The unknowns x1 with rates, and the remaining ones l without:
///
/// ```text
/// x1' = A x1 + N l + B u,   0 = G x1 + L l + H u,   x2 = Z_1 x1 + Z_l l + Z_u u
/// ```
pub(super) struct Elimination {
    /// The factors of E.
    rates: Ranked,
    pub a: Mat<f64>,
    n: Mat<f64>,
    pub b: Mat<f64>,
    g: Mat<f64>,
    l: Mat<f64>,
    h: Mat<f64>,
    z: [Mat<f64>; 3],
    /// Constraints of x1, a row each.
    pub constraints: Mat<f64>,
}

impl Elimination {
    /// The system with all unknowns without rates.
    pub fn new(scaled: &Scaled) -> Self {
        let rates = ranked(scaled.by_rates.as_ref(), (NO_RATE, None));
        let rank = rates.rank;
        let [mut k1, mut k2] = split(&rates.ordered(&scaled.by_unknowns), rank);
        let inputs = scaled.by_inputs.ncols();
        // The unknowns with rates are combinations of independent columns of E.
        let dependent = rates.dependent();
        k2 -= &k1 * &dependent;
        let [above, below] = rates.rows(&k1);
        let [right, rest] = rates.rows(&k2);
        let [force, fixed] = rates.rows(&scaled.by_inputs);
        k1 = above;
        let [a, n, b] = [k1, right, force].map(|matrix| -rates.solved(matrix));
        let count = rest.ncols();
        Self {
            constraints: Mat::zeros(0, rank),
            z: [
                Mat::zeros(count, rank),
                Mat::identity(count, count),
                Mat::zeros(count, inputs),
            ],
            rates,
            a,
            n,
            b,
            g: below,
            l: rest,
            h: fixed,
        }
    }

    /// All unknowns without rates eliminated.
    pub fn finished(mut self) -> Result<Self, NotMinimal> {
        for _ in 0..=DERIVATIVES {
            self.scale_rows()?;
            self.eliminate();
            if self.g.nrows() == 0 {
                return Ok(self);
            }
            self.scale_rows()?;
            self.differentiate()?;
        }
        Err(NotMinimal::Undetermined(self.most(0)))
    }

    /// Scales the rows of the constraints to a largest entry of one.
    fn scale_rows(&mut self) -> Result<(), NotMinimal> {
        for i in 0..self.g.nrows() {
            let largest = |matrix: &Mat<f64>| {
                let entries = (0..matrix.ncols()).map(|j| matrix[(i, j)].abs());
                entries.fold(0.0, f64::max)
            };
            let size = largest(&self.g).max(largest(&self.l));
            if !(size > 0.0 && size.is_finite()) {
                return Err(NotMinimal::Undetermined(self.most(i)));
            }
            for matrix in [&mut self.g, &mut self.l, &mut self.h] {
                (0..matrix.ncols()).for_each(|j| matrix[(i, j)] /= size);
            }
        }
        Ok(())
    }

    /// Eliminates as many unknowns without rates as the constraints determine.
    fn eliminate(&mut self) {
        let own = ranked(self.l.as_ref(), (ZERO, Some(1.0)));
        let rank = own.rank;
        let dependent = own.dependent();
        let [g, left] = own.rows(&self.g);
        let [h, fixed] = own.rows(&self.h);
        let (g, h) = (own.solved(g), own.solved(h));
        // The first l are -g x1 - dependent (others) - h u.
        let reduced = |by: &Mat<f64>, [x, u]: [&mut Mat<f64>; 2]| {
            let [first, mut others] = split(&own.ordered(by), rank);
            others -= &first * &dependent;
            *x -= &first * &g;
            *u -= &first * &h;
            others
        };
        self.n = reduced(&self.n, [&mut self.a, &mut self.b]);
        let [of_x, of_l, of_u] = &mut self.z;
        *of_l = reduced(of_l, [of_x, of_u]);
        let rest = left.nrows();
        (self.g, self.h, self.l) = (left, fixed, Mat::zeros(rest, rest));
    }

    /// Keeps the constraints, which have no unknowns without rates, and replaces them by their rates.
    fn differentiate(&mut self) -> Result<(), NotMinimal> {
        for k in 0..self.h.ncols() {
            if (0..self.h.nrows()).any(|i| self.h[(i, k)].abs() > MOVED) {
                return Err(NotMinimal::Prescribed(k));
            }
        }
        let kept = self.constraints.nrows();
        let all = Mat::from_fn(kept + self.g.nrows(), self.g.ncols(), |i, j| {
            match i.checked_sub(kept) {
                None => self.constraints[(i, j)],
                Some(i) => self.g[(i, j)],
            }
        });
        self.constraints = all;
        for j in 0..self.n.ncols() {
            let size = self.n.col(j).norm_l2();
            if !(size > 0.0 && size.is_finite()) {
                return Err(NotMinimal::Undetermined(self.most(j)));
            }
            (0..self.n.nrows()).for_each(|i| self.n[(i, j)] /= size);
            (0..self.z[1].nrows()).for_each(|i| self.z[1][(i, j)] /= size);
        }
        self.l = &self.g * &self.n;
        self.h = &self.g * &self.b;
        self.g = &self.g * &self.a;
        Ok(())
    }

    /// The unknown with the largest part in the remaining unknown `j` without rate.
    fn most(&self, j: usize) -> usize {
        let parts = &self.z[1];
        if j >= parts.ncols() {
            return 0;
        }
        let part = |i: &usize| parts[(*i, j)].abs();
        let most = (0..parts.nrows()).max_by(|a, b| part(a).total_cmp(&part(b)));
        most.map_or(0, |i| self.rates.order[self.rates.rank + i])
    }

    /// The unknown of the system that belongs to an x1.
    pub fn unknown(&self, index: usize) -> usize {
        self.rates.order.get(index).copied().unwrap_or(0)
    }

    /// Whether unknowns without rates have a part in the unknown of an x1.
    pub fn is_part(&self, index: usize) -> bool {
        let row = self.rates.r.row(index);
        let parts = (self.rates.rank..row.ncols()).map(|j| row[j].abs());
        parts.fold(0.0, f64::max) > NO_RATE * row.norm_max()
    }

    /// All unknowns of the system by the x1, which are `by_free` combinations, and by the inputs.
    pub fn whole(&self, by_free: &Mat<f64>) -> [Mat<f64>; 2] {
        let [of_x, _, of_u] = &self.z;
        let dependent = self.rates.dependent();
        let without = of_x * by_free;
        let with = by_free - &dependent * &without;
        let by_inputs = -(&dependent * of_u);
        let rank = self.rates.rank;
        let placed = |with: &Mat<f64>, without: &Mat<f64>| {
            let mut whole = Mat::zeros(rank + without.nrows(), with.ncols());
            for (i, &unknown) in self.rates.order.iter().enumerate() {
                let (from, i) = match i.checked_sub(rank) {
                    None => (with, i),
                    Some(i) => (without, i),
                };
                (0..with.ncols()).for_each(|j| whole[(unknown, j)] = from[(i, j)]);
            }
            whole
        };
        [placed(&with, &without), placed(&by_inputs, of_u)]
    }
}

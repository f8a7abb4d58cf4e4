//! Elimination of the unknowns without rates (D-334).
//!
//! Constraints are not differentiated: the unknowns with rates that they bind are replaced by the free ones, in
//! the equations and in their rates, and the equations without rates are sought again. So no reciprocal masses
//! appear in the equations of the reactions, which light sections would fill with a few large ones.

use faer::Mat;

use super::free::Free;
use super::ranked::{ranked, split};
use super::scaled::Scaled;
use super::system::NotMinimal;

/// Part of the largest pivot below which a combination of unknowns has no rate.
const NO_RATE: f64 = 1e-12;
/// Pivots below this, of rows and columns of the size of one, are zero.
const ZERO: f64 = 1e-10;
/// Part of a constraint, relative to its other terms, from which on it depends on an input.
const MOVED: f64 = 1e-9;
/// Replacements of bound unknowns: more have no mechanical origin.
const REPLACEMENTS: usize = 5;

/// Equations of fewer unknowns, by which all unknowns are known:
///
/// ```text
/// E x' + K x + F u = 0 ,   whole = X x + Y u
/// ```
struct Equations {
    by_rates: Mat<f64>,
    by_unknowns: Mat<f64>,
    by_inputs: Mat<f64>,
    x: Mat<f64>,
    y: Mat<f64>,
    /// The unknown of the system that each x is, and whether it is without a part of others.
    names: Vec<(usize, bool)>,
}

/// The states: `x' = A x + B u`, and all unknowns by them, `whole = X x + Y u`.
pub(super) struct Elimination {
    pub a: Mat<f64>,
    pub b: Mat<f64>,
    pub x: Mat<f64>,
    pub y: Mat<f64>,
    /// The unknown of the system that each state is, and whether it is without the part of others.
    pub names: Vec<(usize, bool)>,
}

/// Equations in which the unknowns with rates, x1, are parted from the others, x2:
///
/// ```text
/// R x1' + K1 x1 + K2 x2 + F u = 0 ,   0 = G x1 + L x2 + H u ,   whole = X1 x1 + X2 x2 + Y u
/// ```
struct Parted {
    r: Mat<f64>,
    k: [Mat<f64>; 2],
    f: Mat<f64>,
    g: Mat<f64>,
    l: Mat<f64>,
    h: Mat<f64>,
    x: [Mat<f64>; 2],
    y: Mat<f64>,
    names: [Vec<(usize, bool)>; 2],
}

impl Elimination {
    /// The states of a system.
    pub fn new(scaled: &Scaled) -> Result<Self, NotMinimal> {
        let n = scaled.by_unknowns.ncols();
        let mut equations = Equations {
            by_rates: scaled.by_rates.clone(),
            by_unknowns: scaled.by_unknowns.clone(),
            by_inputs: scaled.by_inputs.clone(),
            x: Mat::identity(n, n),
            y: Mat::zeros(n, scaled.by_inputs.ncols()),
            names: (0..n).map(|unknown| (unknown, false)).collect(),
        };
        for _ in 0..=REPLACEMENTS {
            let mut parted = equations.parted();
            parted.scale_rows()?;
            parted.eliminate();
            if parted.g.nrows() == 0 {
                return parted.finished();
            }
            parted.scale_rows()?;
            equations = parted.freed()?;
        }
        Err(NotMinimal::Undetermined(equations.most(0)))
    }
}

impl Equations {
    /// The unknowns with rates are combinations of independent columns of E.
    fn parted(&self) -> Parted {
        let rates = ranked(self.by_rates.as_ref(), (NO_RATE, None));
        let rank = rates.rank;
        let dependent = rates.dependent();
        let split_rates = |matrix: &Mat<f64>| {
            let [first, mut others] = split(&rates.ordered(matrix), rank);
            others -= &first * &dependent;
            [first, others]
        };
        let [k1, k2] = split_rates(&self.by_unknowns);
        let [above, below] = rates.rows(&k1);
        let [right, rest] = rates.rows(&k2);
        let [force, fixed] = rates.rows(&self.by_inputs);
        let is_part = |index: usize| {
            let row = rates.r.row(index);
            let parts = (rank..row.ncols()).map(|j| row[j].abs());
            parts.fold(0.0, f64::max) > NO_RATE * row.norm_max()
        };
        let names = rates.order.iter().enumerate().map(|(index, &own)| {
            let (unknown, was_part) = self.names[own];
            (unknown, was_part || (index < rank && is_part(index)))
        });
        let names: Vec<_> = names.collect();
        Parted {
            r: rates.r.get(.., ..rank).to_owned(),
            k: [above, right],
            f: force,
            g: below,
            l: rest,
            h: fixed,
            x: split_rates(&self.x),
            y: self.y.clone(),
            names: [names[..rank].to_vec(), names[rank..].to_vec()],
        }
    }

    /// The unknown of the system that is an x.
    fn most(&self, index: usize) -> usize {
        self.names.get(index).map_or(0, |own| own.0)
    }
}

impl Parted {
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
        // The first x2 are -g x1 - dependent (others) - h u.
        let reduced = |[by_x, by_l]: &mut [Mat<f64>; 2], by_u: &mut Mat<f64>| {
            let [first, mut others] = split(&own.ordered(by_l), rank);
            others -= &first * &dependent;
            *by_x -= &first * &g;
            *by_u -= &first * &h;
            *by_l = others;
        };
        reduced(&mut self.k, &mut self.f);
        reduced(&mut self.x, &mut self.y);
        let names = own.order[rank..].iter().map(|&index| self.names[1][index]);
        self.names[1] = names.collect();
        let rest = left.nrows();
        (self.g, self.h, self.l) = (left, fixed, Mat::zeros(rest, self.names[1].len()));
    }

    /// The equations of the unknowns that the constraints leave free.
    fn freed(self) -> Result<Equations, NotMinimal> {
        for k in 0..self.h.ncols() {
            if (0..self.h.nrows()).any(|i| self.h[(i, k)].abs() > MOVED) {
                return Err(NotMinimal::Prescribed(k));
            }
        }
        let [with, without] = &self.names;
        let free = Free::new(&self.g, |index| with[index].0);
        let joined = |matrix: Mat<f64>, others: &Mat<f64>| {
            let count = matrix.ncols();
            Mat::from_fn(matrix.nrows(), count + others.ncols(), |i, j| {
                match j.checked_sub(count) {
                    None => matrix[(i, j)],
                    Some(j) => others[(i, j)],
                }
            })
        };
        let none = Mat::zeros(self.r.nrows(), without.len());
        let own = free.indices.iter().map(|index| with[*index]);
        Ok(Equations {
            by_rates: joined(&self.r * &free.all, &none),
            by_unknowns: joined(&self.k[0] * &free.all, &self.k[1]),
            by_inputs: self.f,
            x: joined(&self.x[0] * &free.all, &self.x[1]),
            y: self.y,
            names: own.chain(without.iter().copied()).collect(),
        })
    }

    /// The states, if no unknown without rates is left, by ascending unknowns.
    fn finished(self) -> Result<Elimination, NotMinimal> {
        if let Some((unknown, _)) = self.names[1].first() {
            return Err(NotMinimal::Undetermined(*unknown));
        }
        let [k, _] = &self.k;
        let solved = |mut matrix: Mat<f64>| {
            if matrix.nrows() > 0 && matrix.ncols() > 0 {
                self.r.as_ref().solve_upper_triangular_in_place(&mut matrix);
            }
            -matrix
        };
        let (a, b) = (solved(k.clone()), solved(self.f.clone()));
        let names = &self.names[0];
        let mut order: Vec<_> = (0..names.len()).collect();
        order.sort_by_key(|index| names[*index].0);
        let rows = |matrix: &Mat<f64>| {
            Mat::from_fn(order.len(), matrix.ncols(), |i, j| matrix[(order[i], j)])
        };
        let columns = |matrix: &Mat<f64>| {
            Mat::from_fn(matrix.nrows(), order.len(), |i, j| matrix[(i, order[j])])
        };
        Ok(Elimination {
            a: columns(&rows(&a)),
            b: rows(&b),
            x: columns(&self.x[0]),
            y: self.y.clone(),
            names: order.iter().map(|index| names[*index]).collect(),
        })
    }

    /// The unknown with the largest part in an equation without rates.
    fn most(&self, row: usize) -> usize {
        let name = |part: usize, by: &Mat<f64>| {
            let entry = |j: &usize| by[(row, *j)].abs();
            let most = (0..by.ncols()).max_by(|a, b| entry(a).total_cmp(&entry(b)))?;
            self.names[part].get(most).map(|own| own.0)
        };
        let found = name(1, &self.l).or_else(|| name(0, &self.g));
        found.unwrap_or(0)
    }
}

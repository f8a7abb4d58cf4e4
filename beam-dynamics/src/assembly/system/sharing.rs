//! Minimum-norm multipliers of redundant constraints.
//!
//! If constraints follow from others, the motion determines their multipliers only up to loads that
//! balance each other. With A the rows of `Phi_y` in a closed loop, each scaled to a unit
//! displacement, and mu the forces along these displacements, the smallest are chosen:
//!
//! ```text
//! minimize mu^T mu   with A^T mu given:      P mu = 0,    P = N N^T              (D-170)
//! ```
//!
//! with N an orthonormal basis of the loads that balance each other, `A^T N = 0`. All constraints
//! are kept, and
//!
//! ```text
//! Phi + s P mu = 0                                                               (D-171)
//! ```
//!
//! replaces them: since `P Phi` vanishes if the other constraints are fulfilled, both terms vanish.
//! N is computed at the predicted positions of a step; as the rank of A is kept from the start, P
//! varies continuously with the motion.
//!
//! N has few columns, one for each constraint that follows from others, but P is dense. In the
//! matrix of a step the amplitudes w of these loads are therefore further unknowns, after all
//! others,
//!
//! ```text
//! Phi + s N w = 0 ,    w - N^T mu = 0                                            (D-281)
//! ```
//!
//! which is (D-171), the residual of the second being zero.

use super::{Residual, System, Workspace};
use crate::assembly::{Combination, Sparse};
use crate::model::{Conditions, State};

mod basis;
mod member;
mod part;
mod tree;

use part::Part;

/// Part of a constraint in the loads that balance each other, below which it is ignored.
const NO_PART: f64 = 1e-12;

/// Violation of a redundant constraint of a closed loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// The index of its multiplier.
    pub constraint: usize,
    /// The violation [unit of the constraint].
    pub value: f64,
    /// The violation as a fraction of the size of the model, or as an angle [-].
    pub part: f64,
}

/// Incompatible driven rate of a constraint of a closed loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contradiction {
    /// The index of its multiplier.
    pub constraint: usize,
    /// Deviation from the rate that the other constraints allow [unit of the constraint/s].
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
    /// Scale of rotations \[m\].
    size: f64,
}

impl Sharing {
    /// The constraints of the loops of a system at the positions of `state`.
    pub fn new(system: &System, state: &State, conditions: &Conditions) -> Self {
        let mut next = system.numbering.unknowns();
        let parts = system.loops.iter().map(|of| {
            let surplus = next;
            next += of.redundant.len();
            Part::new(system, of, surplus)
        });
        let mut sharing = Self {
            parts: parts.collect(),
            compliance: system.compliance,
            size: system.size(),
        };
        sharing.update(system, state, conditions, &mut system.workspace());
        sharing
    }

    /// Computes N at the positions of `state`.
    pub fn update(
        &mut self,
        system: &System,
        state: &State,
        conditions: &Conditions,
        work: &mut Workspace,
    ) {
        for part in &mut self.parts {
            part.update(system, (state, conditions), self.size, work);
        }
    }

    /// Removes from multipliers the part that balances itself, `P mu`: it is not a load, and no
    /// element receives it. It is kept until the next call.
    pub fn take_surplus(&mut self, multipliers: &mut [f64]) {
        for part in &mut self.parts {
            part.project(|constraint, force| force * multipliers[constraint]);
            let numbers = part.constraints.iter().zip(&part.found).zip(&part.forces);
            for ((&constraint, surplus), force) in numbers {
                multipliers[constraint] -= surplus / force;
            }
        }
    }

    /// Adds `s P mu` to the constraints of a residual; the first constraint has the index `first`.
    pub fn add_residual(&self, first: usize, out: &mut Residual) {
        for slack in self.slack() {
            out.values[first + slack.constraint] += slack.value;
        }
    }

    /// Violation of each constraint of the loops, `s P mu` with the multipliers of
    /// [`Self::take_surplus`]: negligible as long as the redundant constraints follow from the
    /// others.
    pub fn slack(&self) -> impl Iterator<Item = Slack> + '_ {
        let (compliance, size) = (self.compliance, self.size);
        self.parts.iter().flat_map(move |part| {
            let numbers = part.constraints.iter().zip(&part.found).zip(&part.forces);
            numbers.map(move |((&constraint, surplus), force)| Slack {
                constraint,
                value: compliance * force * surplus,
                part: compliance * surplus / size,
            })
        })
    }

    /// Deviations of the driven rates of the constraints of the loops from the rates that the
    /// others allow, from their own rates `Phi_t` \[unit of the constraint/s\], with the least
    /// deviation of the others:
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
                let own = part.own_share(i);
                (own > NO_PART).then(|| Contradiction {
                    constraint,
                    value: (part.forces[i] * part.found[i] / own).abs(),
                    size: part.forces[i] * largest,
                })
            })
        })
    }

    /// Adds the derivatives of [`Self::add_residual`] as (D-281), with N kept constant.
    pub fn add_jacobian(&self, out: &mut [Combination<'_>]) {
        for sum in out.iter_mut() {
            self.add_to(sum.by_algebraic, sum.matrix);
        }
    }

    fn add_to(&self, weight: f64, matrix: &mut Sparse) {
        for part in &self.parts {
            part.add_to(weight, self.compliance, matrix.values_mut());
        }
    }
}

#[cfg(test)]
mod tests;

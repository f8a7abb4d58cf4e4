//! Laws that are written as expressions.
//!
//! With the strains, their rates and the time in the units of the expression,
//!
//! ```text
//! f_i = c_i E_i( eps_1/a_1, ..., eps_N/a_N, eps_1' b/a_1, ..., eps_N' b/a_N, t/b )
//! ```
//!
//! and the derivatives of E_i by each variable, exact by the rules of differentiation.

use std::sync::Arc;

use nalgebra::SVector;
use shared_geom::expression::{Expression, Jet};

use super::Response;

/// An expression for each component of a force; a component without one has no force.
///
/// Variables 0 to N-1 are the strains, N to 2N-1 their rates, 2N is the time.
#[derive(Debug, Clone, PartialEq)]
pub struct ExpressionLaw<const N: usize> {
    /// The expressions.
    pub components: [Option<Arc<Expression>>; N],
    /// Unit of each strain in the expressions, `a` [unit of strain].
    pub strain_units: SVector<f64, N>,
    /// Unit of each force, `c` [unit of force].
    pub force_units: SVector<f64, N>,
    /// Unit of time, `b` \[s\].
    pub time_unit: f64,
}

impl<const N: usize> ExpressionLaw<N> {
    /// Whether an expression contains a rate of strain.
    pub(super) fn is_viscous(&self) -> bool {
        let uses_rate = |expression: &Arc<Expression>| (N..2 * N).any(|k| expression.uses(k));
        self.components.iter().flatten().any(uses_rate)
    }

    /// Adds force and derivatives.
    pub(super) fn add(
        &self,
        strain: &SVector<f64, N>,
        rate: &SVector<f64, N>,
        time: f64,
        out: &mut Response<N>,
    ) {
        let variable = |k: usize| match k {
            k if k < N => strain[k] / self.strain_units[k],
            k if k < 2 * N => rate[k - N] * self.time_unit / self.strain_units[k - N],
            _ => time / self.time_unit,
        };
        for (i, expression) in self.components.iter().enumerate() {
            let Some(expression) = expression else {
                continue;
            };
            let unit = self.force_units[i];
            out.force[i] += unit * expression.at(|k| Jet::constant(variable(k))).value;
            for by in (0..2 * N).filter(|&by| expression.uses(by)) {
                let seeded = |k: usize| {
                    if k == by {
                        Jet::variable(variable(k))
                    } else {
                        Jet::constant(variable(k))
                    }
                };
                let slope = unit * expression.at(seeded).first / self.strain_units[by % N];
                if by < N {
                    out.by_strain[(i, by)] += slope
                } else {
                    out.by_rate[(i, by - N)] += slope * self.time_unit
                }
            }
        }
    }
}

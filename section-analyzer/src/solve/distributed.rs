//! Effects of distributed loads on the section, in addition to its internal force.
//!
//! A load of f(x) at the nodes, with derivatives f_j at the section, gives
//!
//! ```text
//! theta' = T' theta - H' f      Q = P' + f                                        (S-103)
//! u = X theta + w      psi = Y theta + y                                          (S-104)
//! ```
//!
//! where w, y belong to the load alone: they are found for the derivatives of the load
//! from the highest down, each from the ones above it, by the system of steady states,
//! on straight and on curved lines alike. With `s_j = H' f_j` the state of derivative j
//! and its rates along the beam are
//!
//! ```text
//! w_j' = w_(j+1) - X s_j      w_j'' = w_(j+2) - X (T' s_j + s_(j+1))
//! y_j' = y_(j+1) - Y s_j                                                          (S-105)
//!
//! C' w_j' + E w_j + R y_j = f_j + M w_j'' + C w_j' + L y_j'
//! L' w_j' + R' w_j + A y_j = 0                                                    (S-106)
//! ```
//!
//! since the central solutions carry the internal force that the load causes along the
//! beam. Each w_j is decoupled, as X is, and so are the rates.
//!
//! # References
//! - [Masarati], appendix E.4: polynomial loads.

use super::decouple::Decoupled;
use super::particular::{Load, ParticularSolution};
use super::system::CentralSystem;
use crate::assembly::{Model, Rate, SectionForces, State, resultant};
use nalgebra::{DMatrix, Matrix6};

/// States that up to six loads add to the central solutions at the section, decoupled.
#[derive(Debug, Clone)]
pub struct DistributedSolution {
    /// w: warping of the unknowns, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// w': its rate along the beam, n x 6, for zero internal force at the section, in the
    /// units of the domain \[-\].
    pub rate: DMatrix<f64>,
    /// y: generalized strain, a column for each load, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// `H' f`: force and moment per length about the origin of the domain, a column for
    /// each load, in its units \[-\].
    pub resultant: Matrix6<f64>,
}

impl DistributedSolution {
    /// The state under `loads`, f_0, f_1, ..., n x 6 each; `central` are the central
    /// solutions of the section. `None` if memory is insufficient.
    pub fn solve(
        model: &impl Model,
        system: &CentralSystem<f64>,
        central: &Decoupled,
        loads: &[DMatrix<f64>],
    ) -> Option<Self> {
        let n = model.unknowns();
        let tt = model.line().equilibrium();
        let none = || (DMatrix::zeros(n, 6), Matrix6::zeros());
        // w_(j+1) with y_(j+1), w_(j+2), s_(j+1)
        let ((mut next, mut next_y), (mut second, mut next_s)) = (none(), none());
        let mut rate = DMatrix::zeros(n, 6);
        let mut forces = SectionForces::none(model);
        for load in loads.iter().rev() {
            let s = resultant(model, load);
            rate.copy_from(&next);
            rate.gemm(-1.0, &central.x, &s, 1.0);
            second.gemm(-1.0, &central.x, &(tt * s + next_s), 1.0);
            let along = State {
                rate: Rate::Given(&second),
                warping: Some(&rate),
                strain: &(next_y - central.y * s),
            };
            model.measure(along, &mut forces);
            forces.face += load;
            let requested = Load {
                within: &forces.face,
                resultant: &Matrix6::zeros(),
                rate: Rate::Given(&rate),
            };
            let found = ParticularSolution::solve(model, system, &central.face, &requested)?;
            second = std::mem::replace(&mut next, found.x);
            (next_y, next_s) = (found.y, s);
        }
        Some(Self {
            x: next,
            rate,
            y: next_y,
            resultant: next_s,
        })
    }
}

//! Particular solutions: effects of forces within the section, with or without internal
//! forces, in states that are steady along the beam.
//!
//! ```text
//! C' u' + E x + R y = q      L' u' + R' x + A y = theta       u' given            (S-76)
//! ```
//!
//! The factored steady system gives the state, the imbalance of its stresses the
//! corrections. As (u, psi) and (u + H r, psi - r' - T r) have the same strains (S-16), the
//! split between warping and generalized strain is a choice here too; as with the central
//! solutions it is made such that the stresses on the face do no work on the warping
//! (S-25): otherwise the shears of psi would depend on the pinned unknowns.
//!
//! ```text
//! r = -Ph' x      x <- x + H r      y <- y - T r                                  (S-77)
//! ```
//!
//! # References
//! - [Masarati], section 5.3.6: decoupling of warping and rigid section motion.

use super::decouple::work;
use super::system::CentralSystem;
use crate::assembly::{Model, Rate, SectionForces, State, add_rigid_motions, largest};
use nalgebra::{DMatrix, Matrix6, Matrix6xX};

/// Maximum number of corrections; the first gives the state.
const CORRECTIONS: usize = 6;

/// Size of a correction, relative to the state, after which the next would be below
/// round-off.
const SMALL_CORRECTION: f64 = 1e-8;

/// Up to six cases of given forces, in the units of the domain.
#[derive(Debug, Clone, Copy)]
pub struct Load<'a> {
    /// q: at the unknowns within the section, n x 6 \[-\].
    pub within: &'a DMatrix<f64>,
    /// theta: internal force, a column for each case \[-\].
    pub resultant: &'a Matrix6<f64>,
    /// u': rate of the warping along the beam, of decoupled solutions.
    pub rate: Rate<'a>,
}

impl Load<'_> {
    /// Number of cases up to the last one that is not zero.
    fn cases(&self) -> usize {
        let is_something = |&case: &usize| {
            self.resultant.column(case).amax() != 0.0 || self.within.column(case).amax() != 0.0
        };
        match self.rate {
            Rate::Zero => (0..6).rev().find(is_something).map_or(1, |last| last + 1),
            Rate::Central | Rate::Given(_) => 6,
        }
    }
}

/// Warping and generalized strain under up to six cases of given forces, decoupled.
#[derive(Debug, Clone)]
pub struct ParticularSolution {
    /// Warping of the unknowns, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// Generalized strain, a column for each case, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// Forces on the face before the last correction, n x 6 \[-\].
    pub face: DMatrix<f64>,
    /// Last correction, relative to the solution \[-\].
    pub correction: f64,
}

impl ParticularSolution {
    /// Finds the state of `load` with the factored `system` of steady states; `face` (Ph, n
    /// x 6) are the forces on the face of the central solutions. `None` if memory is
    /// insufficient.
    pub fn solve(
        model: &impl Model,
        system: &CentralSystem<f64>,
        face: &DMatrix<f64>,
        load: &Load<'_>,
    ) -> Option<Self> {
        let mut solution = Self {
            x: DMatrix::zeros(model.unknowns(), 6),
            y: Matrix6::zeros(),
            face: DMatrix::zeros(0, 0),
            correction: 1.0,
        };
        let mut forces = SectionForces::none(model);
        for round in 0..CORRECTIONS {
            let state = State {
                rate: load.rate,
                warping: Some(&solution.x),
                strain: &solution.y,
            };
            // the start state has no forces
            if round > 0 || !matches!(load.rate, Rate::Zero) {
                model.measure(state, &mut forces);
            }
            let before = solution.correction;
            solution.correct(system, load, &mut forces)?;
            let is_open = solution.correction > SMALL_CORRECTION && solution.correction <= before;
            if !is_open {
                break;
            }
        }
        solution.face = forces.face;
        solution.decouple(model, face);
        Some(solution)
    }

    /// Adds the changes of state that correct the imbalance.
    fn correct(
        &mut self,
        system: &CentralSystem<f64>,
        load: &Load<'_>,
        forces: &mut SectionForces,
    ) -> Option<()> {
        let cases = load.cases();
        forces.within.neg_mut();
        forces.within += load.within;
        let missing = load.resultant - forces.resultant;
        let mut dy: Matrix6xX<f64> = missing.columns(0, cases).into_owned();
        let entries = cases * forces.within.nrows();
        let (dq, none) = forces.within.as_mut_slice().split_at_mut(entries);
        system.correct(dq, &mut dy)?;
        none.fill(0.0);
        self.x += &forces.within;
        let mut y = self.y.columns_mut(0, cases);
        y += &dy;
        let change = largest(forces.within.amax(), dy.amax());
        let state = largest(self.x.amax(), self.y.amax());
        self.correction = if change == 0.0 { 0.0 } else { change / state };
        Some(())
    }

    /// (S-77).
    fn decouple(&mut self, model: &impl Model, face: &DMatrix<f64>) {
        let r = -work(model, face, &self.x);
        add_rigid_motions(model, &r, &mut self.x);
        self.y -= model.line().equilibrium().transpose() * r;
    }
}

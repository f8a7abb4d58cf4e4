//! The two nested central solutions (de Saint-Venant).
//!
//! An unloaded beam carries `theta' = T' theta`: shears constant, bendings linear. With
//! `u = X theta`, `psi = Y theta` (S-17) and T' nilpotent (its square is zero) the
//! equilibrium of the section (S-12), which is then (S-18), splits into two steps, (S-19)
//! and (S-20):
//!
//! ```text
//! linear    (F1, M1, M2, M3)   E x + R y = 0,                        R' x + A y = e_j
//! constant  (F2, F3)           C' u' + E x + R y = C u' + L psi',    L' u' + R' x + A y = e_j
//!                              u' = X T' e_j,  psi' = Y T' e_j  from the linear step:
//!                              T' e_F2 = -e_M3,  T' e_F3 = e_M2
//! ```
//!
//! The imbalance of a state is computed from its stresses ([`SectionForces`]), exact to the
//! round-off of the strains, and the factored matrix gives the correction; the solution is
//! therefore accurate even if the matrix is so badly conditioned that one solution keeps
//! only half of the digits. Both steps are corrected together: one integration of the
//! stresses serves all six columns.
//!
//! On a curved beam the moments are the linear step and the forces the constant one: the
//! moments are independent, and the forces depend on them ([`CentralSystems`]).
//!
//! # References
//! - Giavotto et al. 1983: central solutions.
//! - Masarati 1999, section 5.3.5.

use std::ops::Range;

use super::columns::CentralSystems;
use crate::assembly::{Model, Rate, SectionForces, State, largest};
use crate::element::Line;
use nalgebra::{DMatrix, Matrix6, Matrix6xX};

/// The internal forces of the two steps.
#[derive(Debug, Clone)]
struct Steps {
    /// Internal forces whose solution does not depend on others: it is constant along a
    /// straight beam.
    linear: &'static [usize],
    /// Internal forces whose solution depends on the linear step: shears.
    constant: Range<usize>,
}

impl Steps {
    fn along(line: &Line) -> Self {
        if line.is_straight() {
            Self {
                linear: &[0, 3, 4, 5],
                constant: 1..3,
            }
        } else {
            Self {
                linear: &[3, 4, 5],
                constant: 0..3,
            }
        }
    }
}

/// Maximum number of corrections. Two are usual; more indicate a section near the limit of
/// accuracy.
const CORRECTIONS: usize = 12;

/// Largest ratio of a correction to the previous one: above it further corrections have no
/// use, and the checks of the solution decide.
const SLOW: f64 = 0.5;

/// Size of a correction, relative to the state, after which the iteration stops: the next
/// correction would be smaller by the same ratio, below round-off.
const SMALL_CORRECTION: f64 = 1e-8;

/// Warping and generalized strain per unit internal force, of some choice of
/// rigid motions, with the forces of their stresses.
#[derive(Debug, Clone)]
pub struct CentralSolution {
    /// X: warping of the unknowns, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// Y: generalized strain, 6 x 6, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// Ph: forces on the face per unit internal force, n x 6 \[-\].
    pub face: DMatrix<f64>,
    /// Internal force of the stresses: the unit matrix, up to the error \[-\].
    pub resultant: Matrix6<f64>,
    /// Work of the stresses of each solution on the strains of each: the
    /// compliance, in the units of the domain \[-\].
    pub work: Matrix6<f64>,
    /// Largest of the last corrections of the two steps, relative to the
    /// solution \[-\].
    pub correction: f64,
    /// Largest of the first corrections of the two steps, relative to the solution: the
    /// error of a single solution with the factored systems \[-\].
    pub first_correction: f64,
}

impl CentralSolution {
    /// Solves both steps; `None` if memory is insufficient.
    pub fn solve(model: &impl Model, systems: &CentralSystems) -> Option<Self> {
        let mut iteration = Iteration::start(model, systems);
        for round in 0..CORRECTIONS {
            iteration.measure(model);
            iteration.correct(systems)?;
            // the linear step was solved before, the constant one is in the first round
            if let Some(&first) = iteration.last.get(round) {
                iteration.first = largest(iteration.first, first);
            }
            if iteration.is_done(round) {
                break;
            }
        }
        iteration.measure(model);
        Some(Self {
            correction: largest(iteration.last[0], iteration.last[1]),
            first_correction: iteration.first,
            x: iteration.x,
            y: iteration.y,
            face: iteration.forces.face,
            resultant: iteration.forces.resultant,
            work: iteration.forces.work,
        })
    }
}

/// The current iterate. Sizes of corrections are given for the linear and for the constant
/// step.
#[derive(Debug)]
struct Iteration {
    steps: Steps,
    /// T', of a line other than a straight beam's.
    along: Option<Matrix6<f64>>,
    x: DMatrix<f64>,
    y: Matrix6<f64>,
    forces: SectionForces,
    last: [f64; 2],
    before: [f64; 2],
    /// The largest of the first corrections.
    first: f64,
}

impl Iteration {
    /// The linear step solved once, the constant step at zero.
    fn start(model: &impl Model, systems: &CentralSystems) -> Self {
        let steps = Steps::along(model.line());
        let mut theta = Matrix6::zeros();
        for &force in steps.linear {
            theta[(force, force)] = 1.0;
        }
        let (x, y) = systems.balance_of(&theta);
        let line = model.line();
        Self {
            steps,
            along: (!line.is_straight()).then(|| line.equilibrium()),
            x,
            y,
            forces: SectionForces::none(model),
            last: [1.0, f64::INFINITY],
            before: [f64::INFINITY; 2],
            first: 0.0,
        }
    }

    /// Computes the forces of the present state.
    fn measure(&mut self, model: &impl Model) {
        let state = State {
            rate: Rate::Central,
            warping: Some(&self.x),
            strain: &self.y,
        };
        model.measure(state, &mut self.forces);
    }

    /// Corrects the columns that are not yet accurate by the imbalance of the forces. The
    /// corrections overwrite the forces within the section.
    fn correct(&mut self, systems: &CentralSystems) -> Option<()> {
        let only_constant = self.last[0] <= SMALL_CORRECTION;
        let columns = if only_constant {
            self.steps.constant.clone()
        } else {
            0..6
        };
        let mut dtheta = self.imbalance(columns.clone());
        let n = self.x.nrows();
        let dq = &mut self.forces.within.as_mut_slice()[columns.start * n..columns.end * n];
        systems.correct(dq, &mut dtheta)?;
        for (k, column) in columns.clone().enumerate() {
            let mut x = self.x.column_mut(column);
            x += self.forces.within.column(column);
            let mut y = self.y.column_mut(column);
            y += dtheta.column(k);
        }
        self.before = self.last;
        let mut sizes = [0.0; 2];
        for (k, column) in columns.enumerate() {
            let size = &mut sizes[usize::from(self.steps.constant.contains(&column))];
            *size = largest(*size, self.relative_size(column, &dtheta, k));
        }
        self.last[1] = sizes[1];
        if !only_constant {
            self.last[0] = sizes[0];
        }
        Some(())
    }

    /// The imbalance of the stresses in some of the six solutions: returns the imbalance of
    /// the internal force, and overwrites Q by its imbalance.
    ///
    /// ```text
    /// dQ = P' - Q      P' = Ph T': of a straight beam -Ph of M3 for F2, Ph of M2 for F3
    /// ```
    fn imbalance(&mut self, columns: Range<usize>) -> Matrix6xX<f64> {
        let mut dtheta = Matrix6xX::zeros(columns.len());
        for (k, column) in columns.enumerate() {
            dtheta[(column, k)] = 1.0;
            let mut dtheta = dtheta.column_mut(k);
            dtheta -= self.forces.resultant.column(column);
            let mut dq = self.forces.within.column_mut(column);
            dq.neg_mut();
            match (&self.along, column) {
                (Some(along), _) => dq.gemv(1.0, &self.forces.face, &along.column(column), 1.0),
                (None, 1) => dq -= self.forces.face.column(5),
                (None, 2) => dq += self.forces.face.column(4),
                (None, _) => {}
            }
        }
        dtheta
    }

    /// Size of the correction of one column, the `k`-th corrected, relative to the
    /// state.
    ///
    /// In the units of the domain a warping of 1 and a generalized strain of 1 are
    /// displacements of the same size, so the larger of the two is the size.
    fn relative_size(&self, column: usize, dy: &Matrix6xX<f64>, k: usize) -> f64 {
        let dx = self.forces.within.column(column).amax();
        let change = largest(dx, dy.column(k).amax());
        let state = self.x.column(column).amax();
        change / state.max(self.y.column(column).amax())
    }

    /// Whether the corrections of both steps are finished, after `round`.
    fn is_done(&self, round: usize) -> bool {
        // written such that NaN also ends the iteration
        let is_open = |step: usize| {
            self.last[step] > SMALL_CORRECTION && self.last[step] < SLOW * self.before[step]
        };
        // the first round is the first solution of the constant step
        round > 0 && !is_open(0) && !is_open(1)
    }
}

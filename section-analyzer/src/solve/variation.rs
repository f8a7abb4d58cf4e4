//! Changes of the central solutions with the section: one solution per change.
//!
//! A change dM .. dA of the section matrices causes forces on the central state,
//!
//! ```text
//! q = dC' X T' + dE X + dR Y      t = dL' X T' + dR' X + dA Y      p = dM X T' + dC X + dL Y
//! ```
//!
//! and the central solutions follow, with the same factored systems,
//!
//! ```text
//! C' dX T' + E dX + R dY = dPh T' - q      L' dX T' + R' dX + A dY = -t          (S-114)
//! dPh = M dX T' + C dX + L dY + p
//! ```
//!
//! # References
//! - Giavotto et al. 1983: the equations that are differentiated here.

use super::columns::CentralSystems;
use crate::assembly::{Domain, Rate, SectionForces, State, largest};
use nalgebra::{DMatrix, Matrix6, Matrix6xX};

/// Maximum number of corrections; the first two give the state.
const CORRECTIONS: usize = 12;

/// Size of a correction, relative to the state, after which the next would be below
/// round-off.
const SMALL_CORRECTION: f64 = 1e-8;

/// Changes of the central solutions with a parameter of the section.
#[derive(Debug, Clone)]
pub struct Variation {
    /// dX: of the warping, n x 6, in the units of the domain \[-\].
    pub x: DMatrix<f64>,
    /// dY: of the generalized strain, in the units of the domain \[-\].
    pub y: Matrix6<f64>,
    /// dPh: of the forces on the face, n x 6 \[-\].
    pub face: DMatrix<f64>,
}

impl Variation {
    /// Finds the change of the solutions whose forces change by `given` (q within, p on the
    /// face, t as resultant) at constant state. `None` if memory is insufficient.
    pub fn solve(domain: &Domain, systems: &CentralSystems, given: &SectionForces) -> Option<Self> {
        let along = domain.line.equilibrium();
        let mut x = DMatrix::zeros(domain.unknowns(), 6);
        let mut y = Matrix6::zeros();
        let mut forces = SectionForces::none(domain);
        let mut last = f64::INFINITY;
        for round in 0..CORRECTIONS {
            forces.measure(domain, central_state(&x, &y));
            let mut dq = -(&forces.within + &given.within);
            dq.gemm(1.0, &(&forces.face + &given.face), &along, 1.0);
            let missing = -(forces.resultant + given.resultant);
            let mut dy: Matrix6xX<f64> = missing.columns(0, 6).into_owned();
            systems.correct(dq.as_mut_slice(), &mut dy)?;
            x += &dq;
            y += dy.fixed_columns::<6>(0);
            let change = largest(dq.amax(), dy.amax());
            let state = largest(x.amax(), y.amax());
            let size = if change == 0.0 { 0.0 } else { change / state };
            // the shear forces follow the moments one round later
            let is_open = size > SMALL_CORRECTION && (round < 2 || size < last);
            if !is_open {
                break;
            }
            last = size;
        }
        forces.measure(domain, central_state(&x, &y));
        Some(Self {
            x,
            y,
            face: forces.face + &given.face,
        })
    }
}

fn central_state<'a>(x: &'a DMatrix<f64>, y: &'a Matrix6<f64>) -> State<'a> {
    State {
        rate: Rate::Central,
        warping: Some(x),
        strain: y,
    }
}

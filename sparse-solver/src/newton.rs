//! Newton's method with a status that gives the reason of a failure.

/// The interface of a system of equations for Newton's method.
pub trait Equations {
    /// The residual in order of the equations, and its largest entry relative to the terms of
    /// its kind with the index of that entry.
    fn residual(&mut self) -> (Vec<f64>, Worst);

    /// The correction `-J^-1 residual` with the Jacobian at the present state, or with the
    /// Jacobian of the last correction; `None` if the Jacobian is singular.
    fn correction(&mut self, residual: &[f64], jacobian: Jacobian) -> Option<Vec<f64>>;

    /// Size of a correction relative to the size of the system [-].
    fn size(&self, correction: &[f64]) -> f64;

    /// Applies a correction.
    fn correct(&mut self, correction: &[f64]);
}

/// The Jacobian used for a correction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Jacobian {
    /// The Jacobian at the present state.
    Own,
    /// The Jacobian of the last correction.
    Kept,
}

/// The worst equation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Worst {
    /// Residual relative to the largest term of its kind [-].
    pub relative: f64,
    /// Index of the equation.
    pub index: usize,
    /// The largest term of its kind [unit of the equation].
    pub scale: f64,
}

/// Limits of the iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newton {
    /// Size of the last correction [-]. The convergence is quadratic: the remaining error is
    /// about its square.
    pub correction: f64,
    /// Maximum number of iterations.
    pub iterations: usize,
    /// Size above which a correction does not lead to the solution sought, but possibly to
    /// another one [-].
    pub largest: f64,
}

impl Default for Newton {
    fn default() -> Self {
        Self {
            correction: 1e-9,
            iterations: 30,
            largest: BEYOND_REASON,
        }
    }
}

/// One iteration, for the history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Iteration {
    /// Worst equation before the correction.
    pub worst: Worst,
    /// Size of the correction [-].
    pub correction: f64,
}

/// End of the iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NewtonStatus {
    /// The last correction is small enough.
    Converged,
    /// Too many iterations, or corrections that grow too much.
    NotConverged,
    /// The Jacobian is singular.
    Singular,
}

/// End and history of an iteration.
#[derive(Debug, Clone, PartialEq)]
pub struct NewtonReport {
    /// Reason of the end.
    pub status: NewtonStatus,
    /// The iterations.
    pub history: Vec<Iteration>,
    /// Worst equation at the end.
    pub worst: Worst,
}

/// Size above which a correction leads to another solution [parts of the system, or rad].
const BEYOND_REASON: f64 = 10.0;

/// Size of a correction after which the next one keeps the Jacobian: the Jacobian changes in
/// about this proportion, so that the correction after next is as small as with a new one.
const NEAR: f64 = 1e-3;
/// Ratio to the limit below which the last correction must be with a kept Jacobian.
const OF_KEPT: f64 = 1e-2;
/// Least factor by which corrections with a kept Jacobian must decrease; otherwise it is
/// replaced.
const SHRINKS: f64 = 0.1;

/// Solves `equations` from their present state.
///
/// Once corrections are small, the Jacobian is kept: the error after the last one is its size
/// times the size of the correction at which the Jacobian was computed.
pub fn solve(equations: &mut impl Equations, limits: &Newton) -> NewtonReport {
    let mut history = Vec::new();
    let (mut residual, mut worst) = equations.residual();
    let mut status = NewtonStatus::NotConverged;
    let mut last = f64::INFINITY;
    while history.len() < limits.iterations {
        let kept = (last <= NEAR).then(|| equations.correction(&residual, Jacobian::Kept));
        let shrinks = |correction: &Vec<f64>| equations.size(correction) <= SHRINKS * last;
        let kept = kept.flatten().filter(shrinks);
        let is_kept = kept.is_some();
        let own = || equations.correction(&residual, Jacobian::Own);
        let Some(correction) = kept.or_else(own) else {
            status = NewtonStatus::Singular;
            break;
        };
        let size = equations.size(&correction);
        // The rate at which corrections with a kept Jacobian decrease is unknown: corrections
        // of slender beams do not show the remaining error in their stiff directions.
        let limit = if is_kept {
            OF_KEPT * limits.correction
        } else {
            limits.correction
        };
        last = size;
        history.push(Iteration {
            worst,
            correction: size,
        });
        if !size.is_finite() || size > limits.largest {
            break;
        }
        equations.correct(&correction);
        (residual, worst) = equations.residual();
        if size <= limit {
            status = NewtonStatus::Converged;
            break;
        }
    }
    NewtonReport {
        status,
        history,
        worst,
    }
}

//! Newton's method with a status that says what stood in the way.

/// A system of equations as Newton's method sees it.
pub trait Equations {
    /// The residual in order of the equations, and its largest entry relative to the
    /// terms of its kind with the place of that entry.
    fn residual(&mut self) -> (Vec<f64>, Worst);

    /// The correction `-J^-1 residual`; `None` when the Jacobian is singular.
    fn correction(&mut self, residual: &[f64]) -> Option<Vec<f64>>;

    /// Size of a correction relative to the size of the system [-].
    fn size(&self, correction: &[f64]) -> f64;

    /// Applies a correction.
    fn correct(&mut self, correction: &[f64]);
}

/// The worst equation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Worst {
    /// Residual relative to the largest term of its kind [-].
    pub relative: f64,
    /// Place of the equation.
    pub place: usize,
    /// The largest term of its kind [unit of the equation].
    pub scale: f64,
}

/// Limits of the iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Newton {
    /// Size of the last correction [-]. The convergence being quadratic, the error
    /// left is about its square.
    pub correction: f64,
    /// Iterations at most.
    pub iterations: usize,
    /// Size of a correction that is no way to the solution sought, but may be one to
    /// another [-].
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

/// How the iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NewtonStatus {
    /// The last correction is small enough.
    Converged,
    /// Too many iterations, or corrections that grow beyond reason.
    NotConverged,
    /// The Jacobian is singular.
    Singular,
}

/// End and history of an iteration.
#[derive(Debug, Clone, PartialEq)]
pub struct NewtonReport {
    /// How it ended.
    pub status: NewtonStatus,
    /// What happened.
    pub history: Vec<Iteration>,
    /// Worst equation at the end.
    pub worst: Worst,
}

/// A correction of this size, in parts of the system or radians, leads elsewhere.
const BEYOND_REASON: f64 = 10.0;

/// Solves `equations` from their present state.
pub fn solve(equations: &mut impl Equations, limits: &Newton) -> NewtonReport {
    let mut history = Vec::new();
    let (mut residual, mut worst) = equations.residual();
    let mut status = NewtonStatus::NotConverged;
    while history.len() < limits.iterations {
        let Some(correction) = equations.correction(&residual) else {
            status = NewtonStatus::Singular;
            break;
        };
        let size = equations.size(&correction);
        history.push(Iteration {
            worst,
            correction: size,
        });
        if !size.is_finite() || size > limits.largest {
            break;
        }
        equations.correct(&correction);
        (residual, worst) = equations.residual();
        if size <= limits.correction {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// `x^2 = a`.
    struct Root {
        a: f64,
        x: f64,
    }

    impl Equations for Root {
        fn residual(&mut self) -> (Vec<f64>, Worst) {
            let residual = self.x * self.x - self.a;
            let scale = self.a.abs();
            let worst = Worst {
                relative: residual.abs() / scale,
                place: 0,
                scale,
            };
            (vec![residual], worst)
        }

        fn correction(&mut self, residual: &[f64]) -> Option<Vec<f64>> {
            let slope = 2.0 * self.x;
            (slope != 0.0).then(|| vec![-residual[0] / slope])
        }

        fn size(&self, correction: &[f64]) -> f64 {
            correction[0].abs()
        }

        fn correct(&mut self, correction: &[f64]) {
            self.x += correction[0];
        }
    }

    #[test]
    fn a_root_is_found_quadratically() {
        let mut root = Root { a: 2.0, x: 1.0 };
        let report = solve(&mut root, &Newton::default());
        assert_eq!(report.status, NewtonStatus::Converged);
        assert!((root.x - 2.0_f64.sqrt()).abs() < 1e-15);
        // Corrections of x^2 = 2 from 1: .5, .083, 2.5e-3, 2.1e-6, 1.6e-12.
        assert_eq!(report.history.len(), 5);
    }

    #[test]
    fn no_root_and_no_slope_are_told_apart() {
        let mut none = Root { a: -1.0, x: 0.7 };
        assert_eq!(
            solve(&mut none, &Newton::default()).status,
            NewtonStatus::NotConverged
        );
        let mut flat = Root { a: 1.0, x: 0.0 };
        assert_eq!(
            solve(&mut flat, &Newton::default()).status,
            NewtonStatus::Singular
        );
    }
}

//! Newton's iteration for a square root.

use sparse_solver::{Equations, Jacobian, Newton, NewtonStatus, Worst, solve};

/// `x^2 = a`.
struct Root {
    a: f64,
    x: f64,
    slope: f64,
}

impl Root {
    fn from(x: f64, a: f64) -> Self {
        Self { a, x, slope: 0.0 }
    }
}

impl Equations for Root {
    fn residual(&mut self) -> (Vec<f64>, Worst) {
        let residual = self.x * self.x - self.a;
        let scale = self.a.abs();
        let worst = Worst {
            relative: residual.abs() / scale,
            index: 0,
            scale,
        };
        (vec![residual], worst)
    }

    fn correction(&mut self, residual: &[f64], jacobian: Jacobian) -> Option<Vec<f64>> {
        if jacobian == Jacobian::Own {
            self.slope = 2.0 * self.x;
        }
        (self.slope != 0.0).then(|| vec![-residual[0] / self.slope])
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
    let mut root = Root::from(1.0, 2.0);
    let report = solve(&mut root, &Newton::default());
    assert_eq!(report.status, NewtonStatus::Converged);
    assert!((root.x - 2.0_f64.sqrt()).abs() < 1e-15);
    // Corrections of x^2 = 2 from 1: .5, .083, 2.5e-3, 2.1e-6, and 1.6e-12 by the slope of
    // the last one.
    assert_eq!(report.history.len(), 5);
}

#[test]
fn no_root_and_no_slope_are_distinguished() {
    let mut none = Root::from(0.7, -1.0);
    assert_eq!(
        solve(&mut none, &Newton::default()).status,
        NewtonStatus::NotConverged
    );
    let mut flat = Root::from(0.0, 1.0);
    assert_eq!(
        solve(&mut flat, &Newton::default()).status,
        NewtonStatus::Singular
    );
}

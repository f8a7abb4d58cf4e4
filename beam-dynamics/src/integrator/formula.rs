//! Coefficients of the integration formulas.
//!
//! All are of one form. In a step of length h that ends at t_n, stage s is at `t_n + xi_s h`; the
//! last one is the end, xi = 0. With the ratio r of the step to the previous one,
//!
//! ```text
//! y_s = (1 - beta) y_{n-1} + beta y_{n-2}
//!     + h ( e1_s y'_{n-1} + e2_s y'_{n-2} + sum_t a_st y'_t )                      (D-100)
//! ```
//!
//! and the system is fulfilled at each stage, `F(y_s, y'_s, t_s) = 0`.
//!
//! # References
//!
//! [Masarati], sections 4.1 and 4.2 and appendix B; [HairerWanner1996] for Radau IIA.

/// Largest number of stages of a formula.
pub const STAGES: usize = 3;

/// Coefficients of a formula for one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Formula {
    /// Number of stages.
    pub stages: usize,
    /// Position xi of each stage, in steps from the end [-].
    pub positions: [f64; STAGES],
    /// beta: weight of the previous state [-].
    pub before: f64,
    /// e1: weights of the rates of the latest state [-].
    pub latest_rates: [f64; STAGES],
    /// e2: weights of the rates of the previous state [-].
    pub rates_before: [f64; STAGES],
    /// a: weights of the rates of the stages; one row per stage [-].
    pub weights: [[f64; STAGES]; STAGES],
    /// Order of convergence p for ordinary differential equations.
    pub order: usize,
    /// C of the local error `y(t_n) - y_n = C h^(p+1) d^(p+1)y/dt^(p+1)` [-].
    pub error: f64,
}

/// Least constant assumed for a local error, the constant of the fourth-order formula: errors of
/// formulas of an order higher than the estimate's are measured as if one time derivative were one
/// step.
const LEAST_CONSTANT: f64 = 1.0 / 720.0;

/// Least |zeta|: the weights of cubic and parabolic formulas grow as 1/zeta and cancel, so that
/// 1e-3 loses three digits to round-off.
const LEAST_ZETA: f64 = 1e-3;

/// Distance from zeta = -2/3 within which the parabolic formula is of third order.
const OPTIMAL: f64 = 1e-9;

impl Formula {
    /// The weights of the rates of the stages, times the length of a step \[s\].
    pub(super) fn step_weights(&self, length: f64) -> [[f64; STAGES]; STAGES] {
        self.weights.map(|row| row.map(|weight| length * weight))
    }

    /// The constant C of the local error, at least [`LEAST_CONSTANT`].
    pub(super) fn counted_constant(&self) -> f64 {
        if self.error.abs() < LEAST_CONSTANT {
            LEAST_CONSTANT
        } else {
            self.error
        }
    }

    /// One stage, at the end.
    fn one_stage(weight: f64, order: usize, error: f64) -> Self {
        let mut weights = [[0.0; STAGES]; STAGES];
        weights[0][0] = weight;
        Self {
            stages: 1,
            positions: [0.0; STAGES],
            before: 0.0,
            latest_rates: [0.0; STAGES],
            rates_before: [0.0; STAGES],
            weights,
            order,
            error,
        }
    }

    /// `y_n = y_{n-1} + h y'_n`.
    pub fn implicit_euler() -> Self {
        Self::one_stage(1.0, 1, -0.5)
    }

    /// `y_n = y_{n-1} + h/2 ( y'_n + y'_{n-1} )`.
    pub fn crank_nicolson() -> Self {
        let mut formula = Self::one_stage(0.5, 2, -1.0 / 12.0);
        formula.latest_rates[0] = 0.5;
        formula
    }

    /// Whether it is the trapezoid rule, with which constrained quantities alternate from step to
    /// step without damping.
    pub fn alternates(&self) -> bool {
        let is_of_one_step = self.before == 0.0 && self.rates_before[0] == 0.0;
        self.stages == 1 && is_of_one_step && self.latest_rates[0] == self.weights[0][0]
    }

    /// Two steps of the ratio r with the asymptotic radius rho; 0 is BDF2:
    ///
    /// ```text
    /// D    = 2 (1 + r) - (1 - rho)^2
    /// b0   = (1 + r) / D ,   b1 = 2 rho b0 ,   b2 = rho^2 b0
    /// beta = r ( r (rho^2 + 2 rho - 1) + 2 rho^2 ) / D                              (D-101)
    /// ```
    pub fn two_step(radius: f64, ratio: f64) -> Self {
        let (rho, r) = (radius, ratio);
        let denominator = 2.0 * (1.0 + r) - (1.0 - rho).powi(2);
        let b0 = (1.0 + r) / denominator;
        let b2 = rho * rho * b0;
        let beta = r * (r * (rho * rho + 2.0 * rho - 1.0) + 2.0 * rho * rho) / denominator;
        // The formula on y = t^3 / 6 with t_{n-1} = 0, t_n = 1, t_{n-2} = -1/r.
        let found = -beta / (6.0 * r.powi(3)) + 0.5 * (b0 + b2 / (r * r));
        let mut formula = Self::one_stage(b0, 2, 1.0 / 6.0 - found);
        formula.before = beta;
        formula.latest_rates[0] = 2.0 * rho * b0;
        formula.rates_before[0] = b2;
        formula
    }

    /// The largest ratio r at which the two-step formula is zero-stable, |beta| <= 1:
    ///
    /// ```text
    /// (rho^2 + 2 rho - 1) r^2 - 2 (1 - rho^2) r - (1 + 2 rho - rho^2) = 0   (beta =  1)
    /// (rho^2 + 2 rho - 1) r^2 + 2 (1 + rho^2) r + (1 + 2 rho - rho^2) = 0   (beta = -1)   (D-103)
    /// ```
    pub fn largest_ratio(radius: f64) -> f64 {
        let rho = radius;
        let a = rho * rho + 2.0 * rho - 1.0;
        let c = 1.0 + 2.0 * rho - rho * rho;
        if a.abs() < f64::EPSILON {
            return f64::INFINITY;
        }
        let b = if a > 0.0 {
            1.0 - rho * rho
        } else {
            1.0 + rho * rho
        };
        (b + (b * b + a.abs() * c).sqrt()) / a.abs()
    }

    /// Cubic interpolation, with the inner stage at zeta = -rho / (1 + rho).
    ///
    /// The limit rho = 0 weights the second derivative of y and is taken as
    /// zeta = -1e-3: it differs by an asymptotic radius of 1e-3.
    pub fn cubic(radius: f64) -> Self {
        let z = -(radius / (1.0 + radius)).max(LEAST_ZETA);
        let end = [
            (2.0 + 3.0 * z) / (6.0 * (1.0 + z)),
            -1.0 / (6.0 * z * (1.0 + z)),
            (1.0 + 3.0 * z) / (6.0 * z),
        ];
        // Of fourth order at zeta = -1/2, to round-off of zeta.
        let error = (1.0 + 2.0 * z) / 72.0;
        let order = if error.abs() < OPTIMAL { 4 } else { 3 };
        Self::two_stages(z, &cubic(z), end, (order, error))
    }

    /// Parabolic interpolation, with the inner stage at zeta; -2/3 is Radau IIA, -1/2 the
    /// parabola at Gauss' one point.
    pub fn parabolic(zeta: f64) -> Self {
        let z = zeta.clamp(-1.0 + LEAST_ZETA, -LEAST_ZETA);
        let end = [0.0, -1.0 / (2.0 * z), (1.0 + 2.0 * z) / (2.0 * z)];
        let shape = Shape {
            end: 1.0 - z * z,
            end_rate: z * (1.0 + z),
            latest_rate: 0.0,
        };
        let off = (2.0 + 3.0 * z) / 12.0;
        let of_order = if off.abs() < OPTIMAL {
            (3, 1.0 / 72.0)
        } else {
            (2, off)
        };
        Self::two_stages(z, &shape, end, of_order)
    }

    /// An inner stage on an interpolation through the end, and an end with weights of the rates of
    /// the latest state, the inner stage and the end:
    ///
    /// ```text
    /// y_n    = y_{n-1} + h ( w1 y'_{n-1} + wz y'_zeta + w0 y'_n )
    /// y_zeta = m0 y_n + m1 y_{n-1} + h ( n0 y'_n + n1 y'_{n-1} )                       (D-105)
    /// ```
    fn two_stages(zeta: f64, at: &Shape, end: [f64; 3], of_order: (usize, f64)) -> Self {
        let [w1, wz, w0] = end;
        let mut formula = Self::one_stage(0.0, of_order.0, of_order.1);
        formula.stages = 2;
        formula.positions[0] = zeta;
        formula.latest_rates = [at.end * w1 + at.latest_rate, w1, 0.0];
        formula.weights[0] = [at.end * wz, at.end * w0 + at.end_rate, 0.0];
        formula.weights[1] = [wz, w0, 0.0];
        formula
    }

    /// Cubic interpolation weighted at Gauss' two points, [Masarati] B.3.1.
    pub fn cubic_gauss() -> Self {
        let off = 0.5 / 3.0_f64.sqrt();
        let positions = [-0.5 - off, -0.5 + off, 0.0];
        let mut formula = Self::one_stage(0.0, 4, 0.0);
        formula.stages = 3;
        formula.positions = positions;
        for stage in 0..2 {
            let at = cubic(positions[stage]);
            formula.latest_rates[stage] = at.latest_rate;
            formula.weights[stage] = [0.5 * at.end, 0.5 * at.end, at.end_rate];
        }
        formula.weights[2] = [0.5, 0.5, 0.0];
        formula
    }

    /// Radau IIA with three stages: fifth order, without the rates of the latest state.
    pub fn radau_three() -> Self {
        let s = 6.0_f64.sqrt();
        let mut formula = Self::one_stage(0.0, 5, 0.0);
        formula.stages = 3;
        formula.positions = [-(6.0 + s) / 10.0, -(6.0 - s) / 10.0, 0.0];
        formula.weights = [
            [
                (88.0 - 7.0 * s) / 360.0,
                (296.0 - 169.0 * s) / 1800.0,
                (-2.0 + 3.0 * s) / 225.0,
            ],
            [
                (296.0 + 169.0 * s) / 1800.0,
                (88.0 + 7.0 * s) / 360.0,
                (-2.0 - 3.0 * s) / 225.0,
            ],
            [(16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0],
        ];
        formula
    }
}

/// Shape functions of an interpolation from the latest state to the end, at one position.
struct Shape {
    /// m0: of the value at the end; m1 = 1 - m0 is of the latest state.
    end: f64,
    /// n0: of the rate at the end, over h.
    end_rate: f64,
    /// n1: of the rate of the latest state, over h.
    latest_rate: f64,
}

/// The cubic interpolation at xi:
///
/// ```text
/// m0 = 1 - xi^2 (3 + 2 xi) ,  n0 = xi (1 + xi)^2 ,  n1 = xi^2 (1 + xi)             (D-106)
/// ```
fn cubic(xi: f64) -> Shape {
    Shape {
        end: 1.0 - xi * xi * (3.0 + 2.0 * xi),
        end_rate: xi * (1.0 + xi).powi(2),
        latest_rate: xi * xi * (1.0 + xi),
    }
}

//! One mode: an eigenvalue of the linearized system and its vector.

use faer::c64;

/// An eigenvalue `s` [1/s] and its vector: twelve entries a node.
#[derive(Debug, Clone)]
pub struct Eigenpair {
    /// Real part of s: growth [1/s].
    pub growth: f64,
    /// Imaginary part of s: angular frequency [rad/s].
    pub angular_frequency: f64,
    /// Real parts of the vector [unit of each unknown].
    pub real: Vec<f64>,
    /// Imaginary parts of the vector [unit of each unknown].
    pub imaginary: Vec<f64>,
    /// Error of the pair in the inverted problem, relative [-].
    pub residual: f64,
}

impl Eigenpair {
    /// The pair of an eigenvalue and a vector.
    pub(super) fn new(s: c64, vector: &[c64], residual: f64) -> Self {
        Self {
            growth: s.re,
            angular_frequency: s.im,
            real: vector.iter().map(|v| v.re).collect(),
            imaginary: vector.iter().map(|v| v.im).collect(),
            residual,
        }
    }

    /// The eigenvalue [1/s].
    pub(super) fn value(&self) -> c64 {
        c64::new(self.growth, self.angular_frequency)
    }

    /// The vector [unit of each unknown].
    pub(super) fn vector(&self) -> Vec<c64> {
        let parts = self.real.iter().zip(&self.imaginary);
        parts.map(|(re, im)| c64::new(*re, *im)).collect()
    }
}

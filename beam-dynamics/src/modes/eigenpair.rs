//! One mode: an eigenvalue of the linearized system and its vector.

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

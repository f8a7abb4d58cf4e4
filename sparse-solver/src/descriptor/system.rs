//! A descriptor system, its minimal form, and the reasons why it has none.

use faer::{Mat, c64};

/// The linear descriptor system `E x' + K x + F u = 0`.
#[derive(Debug, Clone)]
pub struct Descriptor {
    /// E: equations by rates of unknowns [any unit].
    pub by_rates: Mat<f64>,
    /// K: equations by unknowns [any unit].
    pub by_unknowns: Mat<f64>,
    /// F: equations by inputs [any unit].
    pub by_inputs: Mat<f64>,
}

/// A state: an unknown of the descriptor system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DescriptorState {
    /// Index of the unknown.
    pub unknown: usize,
    /// Whether the state is the unknown without its part that has no rate.
    pub is_part: bool,
}

/// The minimal form `x' = A x + B u` of a descriptor system.
#[derive(Debug, Clone)]
pub struct Minimal {
    /// The states, by ascending unknowns.
    pub states: Vec<DescriptorState>,
    /// Rates of the states by the states [1/s, any unit].
    pub a: Mat<f64>,
    /// Rates of the states by the inputs [any unit].
    pub b: Mat<f64>,
    /// Eigenvalues of A by ascending size, with the digits of the scaled system [1/s].
    pub eigenvalues: Vec<c64>,
    /// All unknowns by the states [any unit].
    pub by_states: Mat<f64>,
    /// All unknowns by the inputs [any unit].
    pub by_inputs: Mat<f64>,
    /// Largest remainder of an equation of the descriptor system for the motions of the minimal form,
    /// relative to its terms [-].
    pub residual: f64,
}

/// Why a descriptor system has no minimal form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NotMinimal {
    /// A constraint depends on an input: its index.
    Prescribed(usize),
    /// The equations do not determine an unknown, or contradict each other: the unknown that takes
    /// part most.
    Undetermined(usize),
    /// A number that is not finite.
    NotFinite,
}

//! Results of the identification of frequencies and damping from samples.

/// A method of identification.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IdentificationMethod {
    /// Sum of damped oscillations, by the matrix pencil.
    Prony,
    /// Amplitude and phase in a window that moves along the record.
    MovingBlock,
    /// Amplitude of the extremes.
    Decrement,
}

impl IdentificationMethod {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Prony => "Prony",
            Self::MovingBlock => "moving block",
            Self::Decrement => "decrement",
        }
    }
}

/// A damped oscillation by one of the methods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdentifiedMode {
    /// Method.
    pub method: IdentificationMethod,
    /// Frequency \[rad/s\].
    pub frequency: f64,
    /// Growth, negative for a decay \[1/s\].
    pub growth: f64,
    /// Amplitude at the beginning of the record \[unit of the column\]; of Prony's modes only.
    pub amplitude: Option<f64>,
    /// Root of the mean square of its part of the record over the one of the record without its
    /// constant \[-\]; of Prony's modes only.
    pub share: Option<f64>,
    /// Largest difference of the logarithm of the amplitude from a straight line \[-\]; not of
    /// Prony's modes.
    pub scatter: Option<f64>,
}

impl IdentifiedMode {
    /// Ratio of critical damping \[-\].
    pub fn damping(&self) -> f64 {
        -self.growth / self.frequency.hypot(self.growth)
    }
}

/// The modes of a column.
#[derive(Debug, Clone, PartialEq)]
pub struct Identification {
    /// Path of the table.
    pub file: String,
    /// Name of the column.
    pub column: String,
    /// Unit of the column.
    pub unit: String,
    /// First and last time \[s\].
    pub times: [f64; 2],
    /// Number of samples.
    pub samples: usize,
    /// Prony's modes, the largest first, then the others' in the same order.
    pub modes: Vec<IdentifiedMode>,
    /// Root of the mean square of the rest of Prony's sum over the one of the record without its
    /// constant \[-\].
    pub residual: f64,
}

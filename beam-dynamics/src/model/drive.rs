//! Numbers that change with time.

/// A number that changes with time, with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DriveValue {
    /// The number [its unit].
    pub value: f64,
    /// Its first derivative [its unit/s].
    pub rate: f64,
    /// Its second derivative [its unit/s^2].
    pub acceleration: f64,
}

/// A given function of time.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Always the same.
    Constant(f64),
}

impl Drive {
    /// The value at `time` \[s\]; at a corner that after it.
    pub fn at(&self, _time: f64) -> DriveValue {
        match self {
            Self::Constant(value) => DriveValue {
                value: *value,
                ..DriveValue::default()
            },
        }
    }

    /// The first time after `time` at which the drive or its first derivative jumps \[s\];
    /// infinite when there is none.
    pub fn next_corner(&self, _time: f64) -> f64 {
        match self {
            Self::Constant(_) => f64::INFINITY,
        }
    }
}

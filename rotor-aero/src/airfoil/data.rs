//! The content of an airfoil table, as files and formulas give it.

use crate::real::Real;

/// A coefficient over the angle of attack, at one Mach number, Reynolds number and deflection.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Mach number; absent if the table does not depend on it \[-\].
    pub mach: Option<f64>,
    /// Reynolds number of the chord; absent if the table does not depend on it \[-\].
    pub reynolds: Option<f64>,
    /// Deflection of the flap, trailing edge down positive; absent if there is no flap \[rad\].
    pub flap: Option<f64>,
    /// Angles of attack, ascending, from -pi or more to pi or less \[rad\].
    pub alpha: Vec<f64>,
    /// The coefficient at these angles \[-\].
    pub values: Vec<f64>,
}

/// An airfoil as its source gives it: each coefficient has grids of its own.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AirfoilData {
    /// Name.
    pub name: String,
    /// Thickness over chord, if known \[-\].
    pub thickness: Option<f64>,
    /// Lift coefficient.
    pub lift: Vec<Curve>,
    /// Drag coefficient.
    pub drag: Vec<Curve>,
    /// Moment coefficient about the quarter chord, nose up positive.
    pub moment: Vec<Curve>,
}

/// The flow at a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow<T> {
    /// Angle of attack, any number of turns \[rad\].
    pub alpha: T,
    /// Mach number \[-\].
    pub mach: T,
    /// Reynolds number of the chord \[-\].
    pub reynolds: T,
    /// Deflection of the flap, trailing edge down positive \[rad\].
    pub flap: T,
}

/// Coefficients of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients<T> {
    /// Lift, normal to the flow \[-\].
    pub lift: T,
    /// Drag, along the flow \[-\].
    pub drag: T,
    /// Moment about the quarter chord, nose up positive \[-\].
    pub moment: T,
}

impl<T: Real> Coefficients<T> {
    /// All times a factor.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self {
            lift: self.lift * factor,
            drag: self.drag * factor,
            moment: self.moment * factor,
        }
    }
}

//! Fatigue of materials: slopes of their S-N lines.

/// Smallest and largest slope \[-\]: beyond all materials.
pub const SLOPES: (f64, f64) = (1.0, 50.0);

/// Slopes m of S-N lines, `N = (S / S_a)^m` cycles of the amplitude `S_a` \[-\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slopes {
    /// Along the fiber, of all stresses of an isotropic material; without it they have no damage
    /// along the fiber \[-\].
    pub fiber: Option<f64>,
    /// Across the fiber and in shear \[-\].
    pub matrix: f64,
}

/// Slopes of the S-N lines that begin at the limits of a material.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Fatigue {
    /// Of stresses, if known.
    pub stress: Option<Slopes>,
    /// Of strains, if known.
    pub strain: Option<Slopes>,
}

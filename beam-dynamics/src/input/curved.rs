//! Sections that were solved for a curved and twisted beam, on the beams of a model.
//!
//! The undeformed line of a beam carries its curvature in kinematics and equilibrium
//! (D-21), the matrices of the section what it does inside of the section. Nothing is
//! added to either, and both must be those of one beam:
//!
//! ```text
//! k = axial( R_0^T dR_0/ds )        l = R_0^T dp_0/ds                        (D-230)
//! ```
//!
//! of the line are compared with the curvature and the slope of the property file.

use nalgebra::Matrix6;
use shared_geom::section::{CurvatureMismatch, InitialCurvature, SectionProperties};

/// A length of the slope that differs from one by less is that of digits.
const DIGITS: f64 = 1e-6;

/// What a section was solved for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Curved {
    /// Name of the properties.
    pub name: String,
    /// Curvature and slope by arc length.
    pub initial: InitialCurvature,
    /// 6x6 stiffness \[N, N m, N m^2\].
    pub stiffness: Matrix6<f64>,
    /// Length of the line per unit of the parameter of the file: c of (D-231) \[-\].
    stretch: f64,
}

impl Curved {
    /// Of the properties of a file; `None` for those of a straight beam.
    pub fn of(name: &str, properties: &SectionProperties) -> Option<Self> {
        let initial = properties.initial_curvature?;
        let stretch = initial.slope.norm();
        (!initial.is_straight()).then(|| Self {
            name: name.to_owned(),
            initial: initial.per_arc_length(),
            stiffness: properties.stiffness * stretch,
            stretch,
        })
    }

    /// That the matrices of the file were those of another parameter, in words; `None`
    /// where it was the arc length.
    pub fn conversion(&self) -> Option<String> {
        ((self.stretch - 1.0).abs() > DIGITS).then(|| {
            format!(
                "the line of the section is {:.6} long per unit of the parameter of its \
                 matrices: stiffness times that and mass divided by it are those per arc length",
                self.stretch
            )
        })
    }

    /// A small difference from the line of the beam that uses the properties, in words.
    pub fn remark(&self, user: &str, mismatch: &CurvatureMismatch) -> String {
        format!(
            "{user}, properties \"{}\": {mismatch}; {}; the matrices are used as given",
            self.name,
            mismatch.size()
        )
    }
}

//! Centers and principal axes in a property file.

use nalgebra::Vector2;
use serde::{Deserialize, Serialize};

use crate::section::{Centers, PrincipalAxes};

/// Centers relative to the reference point [m].
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FileCenters {
    tension: [f64; 2],
    shear: [f64; 2],
    mass: [f64; 2],
}

/// Principal axes of bending and of inertia.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FileAxes {
    bending_angle: f64,
    bending_stiffness: [f64; 2],
    inertia_angle: f64,
    inertia: [f64; 2],
}

impl FileCenters {
    /// The content.
    pub(super) fn centers(&self) -> Centers {
        Centers {
            tension: Vector2::from(self.tension),
            shear: Vector2::from(self.shear),
            mass: Vector2::from(self.mass),
        }
    }
}

impl FileAxes {
    /// The content.
    pub(super) fn axes(&self) -> PrincipalAxes {
        PrincipalAxes {
            bending_angle: self.bending_angle,
            bending_stiffness: self.bending_stiffness,
            inertia_angle: self.inertia_angle,
            inertia: self.inertia,
        }
    }
}

impl From<&Centers> for FileCenters {
    fn from(centers: &Centers) -> Self {
        Self {
            tension: centers.tension.into(),
            shear: centers.shear.into(),
            mass: centers.mass.into(),
        }
    }
}

impl From<&PrincipalAxes> for FileAxes {
    fn from(axes: &PrincipalAxes) -> Self {
        Self {
            bending_angle: axes.bending_angle,
            bending_stiffness: axes.bending_stiffness,
            inertia_angle: axes.inertia_angle,
            inertia: axes.inertia,
        }
    }
}

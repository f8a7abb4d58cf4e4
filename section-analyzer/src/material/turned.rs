//! Materials whose constants are given in axes of the data, other than the material axes:
//! orientation of these axes in the material axes, and the constants there.
//!
//! # Symbols
//!
//! | symbol | meaning | shape |
//! | --- | --- | --- |
//! | `Q` | axes of the data in material axes: columns 1', 2', 3' | 3x3 |
//! | `T` | strain in axes of the data from strain in material axes, engineering shears | 6x6 |
//!
//! A strain is `eps' = Q' eps Q` as a tensor, an electric field `E' = Q' E`. The work of
//! stress and of electric displacement is the same in both axes, so that
//!
//! ```text
//! c = T' c' T        e = Q e' T        epsS = Q epsS' Q'
//! ```
//!
//! `T` is computed from the tensors of the six unit strains, without an explicit
//! transformation matrix.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::error::Explain;

use super::elastic::{ElasticLaw, Material};
use super::electric::ElectricLaw;
use super::orientation::MATERIAL_ORDER;

/// Largest deviation of two axes from a right angle \[deg\]: more than the rounding of
/// written directions.
const LARGEST_DEVIATION: f64 = 0.01;

/// Reasons for which two directions are not axes.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum AxesProblem {
    /// A direction of zero length.
    #[error("\"{key}\" has no length, expected a direction")]
    NoDirection {
        /// `poling` or `across`.
        key: &'static str,
    },
    /// Directions that are not at a right angle.
    #[error("\"poling\" and \"across\" are at {angle:.3} deg, expected a right angle")]
    NotOrthogonal {
        /// The angle between them \[deg\].
        angle: f64,
    },
    /// A direction that leaves the rotation of the material about it undetermined.
    #[error("\"poling\" is along none of the material axes and without \"across\", expected both")]
    NoAcross,
    /// Expansions that are not along the material axes.
    #[error(
        "rotated by \"poling\", the expansion has a shear {shear:.3e} 1/K in material axes, \
         expected axes without shear"
    )]
    ShearedExpansion {
        /// The largest one, a component of the tensor \[1/K\].
        shear: f64,
    },
}

impl Explain for AxesProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::NoDirection { .. } => "give 1, 2 or 3 for a material axis, or three components",
            Self::NotOrthogonal { .. } => {
                "\"poling\" is the axis 3 of the constants and \"across\" their axis 1: give a \
                 direction normal to the poling"
            }
            Self::NoAcross => {
                "\"across\" is the direction of axis 1 of the constants, at a right angle to \
                 \"poling\"; for a ceramic, isotropic across the poling, any direction works"
            }
            Self::ShearedExpansion { .. } => {
                "rotate the material by the angles of its regions, or make the expansion one number"
            }
        };
        Some(text.to_owned())
    }
}

/// The axes of data whose axis 3 is along `poling` and axis 1 along `across`, both in
/// material axes: columns 1', 2', 3' \[-\].
///
/// Without `across`, a `poling` along material axis 1, 2 or 3, in either direction, has
/// the next of them (2, 3, 1) as axis 1'.
///
/// # Errors
/// [`AxesProblem`] for directions that are not axes.
pub fn data_axes(
    poling: &Vector3<f64>,
    across: Option<&Vector3<f64>>,
) -> Result<Matrix3<f64>, AxesProblem> {
    let unit = |key, v: &Vector3<f64>| {
        let v = v / v.amax();
        let unit = v
            .try_normalize(0.0)
            .filter(|v| v.iter().all(|x| x.is_finite()));
        unit.ok_or(AxesProblem::NoDirection { key })
    };
    let third = unit("poling", poling)?;
    let first = match across {
        Some(across) => unit("across", across)?,
        None => {
            let along = (0..3).find(|&axis| third[axis].abs() == 1.0);
            let along = along.ok_or(AxesProblem::NoAcross)?;
            Matrix3::identity().column((along + 1) % 3).into()
        }
    };
    let angle = third.dot(&first).clamp(-1.0, 1.0).acos().to_degrees();
    if (angle - 90.0).abs() > LARGEST_DEVIATION {
        return Err(AxesProblem::NotOrthogonal { angle });
    }
    let first = (first - third * third.dot(&first)).normalize();
    Ok(Matrix3::from_columns(&[first, third.cross(&first), third]))
}

/// Strain in axes of the data from strain in material axes, both in the order 11 22 33 23
/// 13 12 with engineering shears \[-\].
fn strain_in_data_axes(q: &Matrix3<f64>) -> Matrix6<f64> {
    let columns = MATERIAL_ORDER.map(|(i, j)| {
        let mut strain = Matrix3::zeros();
        strain[(i, j)] += 0.5;
        strain[(j, i)] += 0.5;
        let turned = q.transpose() * strain * q;
        Vector6::from_fn(|row, _| {
            let (k, l) = MATERIAL_ORDER[row];
            if k == l {
                turned[(k, l)]
            } else {
                2.0 * turned[(k, l)]
            }
        })
    });
    Matrix6::from_columns(&columns)
}

impl ElasticLaw {
    /// The law whose data are in the axes `q`, in material axes; an isotropic law is
    /// unchanged.
    pub fn turned(&self, q: &Matrix3<f64>) -> Self {
        match self {
            Self::Isotropic { .. } | Self::Absent => self.clone(),
            Self::Orthotropic(_) | Self::Full(_) => {
                let t = strain_in_data_axes(q);
                let c = t.transpose() * self.stiffness() * t;
                Self::Full(0.5 * (c + c.transpose()))
            }
        }
    }
}

impl ElectricLaw {
    /// The law whose data are in the axes `q`, in material axes.
    pub fn turned(&self, q: &Matrix3<f64>) -> Self {
        let permittivity = q * self.permittivity * q.transpose();
        Self {
            coupling: q * self.coupling * strain_in_data_axes(q),
            permittivity: 0.5 * (permittivity + permittivity.transpose()),
        }
    }
}

impl Material {
    /// The material whose data are in the axes `q`, in material axes.
    ///
    /// # Errors
    /// [`AxesProblem::ShearedExpansion`].
    pub fn turned(&self, q: &Matrix3<f64>) -> Result<Self, AxesProblem> {
        if *q == Matrix3::identity() {
            return Ok(self.clone());
        }
        let expansion = self.expansion.map(|along| turned_expansion(along, q));
        Ok(Self {
            law: self.law.turned(q),
            electric: self.electric.map(|law| law.turned(q)),
            expansion: expansion.transpose()?,
            ..self.clone()
        })
    }
}

/// Expansions along axes `q` of the data, along the material axes \[1/K\].
fn turned_expansion(along: [f64; 3], q: &Matrix3<f64>) -> Result<[f64; 3], AxesProblem> {
    let [a1, a2, a3] = along;
    if a1 == a2 && a2 == a3 {
        return Ok(along);
    }
    let tensor = q * Matrix3::from_diagonal(&Vector3::from(along)) * q.transpose();
    let shears = [tensor[(1, 2)], tensor[(0, 2)], tensor[(0, 1)]];
    let shear = shears
        .into_iter()
        .fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
    if shear.abs() > 1e-9 * tensor.amax() {
        Err(AxesProblem::ShearedExpansion { shear })
    } else {
        Ok([0, 1, 2].map(|axis| tensor[(axis, axis)]))
    }
}

#[cfg(test)]
#[path = "turned_tests.rs"]
mod tests;

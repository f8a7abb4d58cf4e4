//! Strains that the material would have without any constraint: temperature, cure,
//! swelling.
//!
//! ```text
//! eps_p(y, z) = e + y e_y + z e_z                          in material axes
//! of a rise of temperature T = T0 + y T_y + z T_z:   e = alpha T0,  e_y = alpha T_y,  e_z = alpha T_z
//! ```
//!
//! The stress follows from the rest of the strain (S-90).

use nalgebra::Vector6;

use super::{CellMaterial, Section};
use crate::material::Material;

/// Free strain of one cell, linear over it; material axes, order 11 22 33 23 13 12 with
/// engineering shear strains.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FreeStrain {
    /// At the reference point, the origin of the mesh \[-\].
    pub at_origin: Vector6<f64>,
    /// Per length along y \[1/m\].
    pub by_y: Vector6<f64>,
    /// Per length along z \[1/m\].
    pub by_z: Vector6<f64>,
}

impl FreeStrain {
    /// A constant strain in the cell \[-\].
    pub fn constant(strain: Vector6<f64>) -> Self {
        Self {
            at_origin: strain,
            ..Self::default()
        }
    }

    /// The strain at the point (y, z) \[m\], material axes \[-\].
    pub fn at(&self, [y, z]: [f64; 2]) -> Vector6<f64> {
        self.at_origin + self.by_y * y + self.by_z * z
    }
}

/// A temperature rise that is linear in the section.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TemperatureField {
    /// Rise at the reference point, the origin of the mesh \[K\].
    pub rise: f64,
    /// Gradient along y and along z \[K/m\].
    pub gradient: [f64; 2],
}

impl TemperatureField {
    /// The free strain of `material` under this temperature.
    fn strain(&self, material: &Material) -> FreeStrain {
        let [a1, a2, a3] = material.expansion.unwrap_or([0.0; 3]);
        let expansion = Vector6::new(a1, a2, a3, 0.0, 0.0, 0.0);
        FreeStrain {
            at_origin: expansion * self.rise,
            by_y: expansion * self.gradient[0],
            by_z: expansion * self.gradient[1],
        }
    }
}

/// A named state of imposed strain.
#[derive(Debug, Clone, PartialEq)]
pub struct ImposedStrain {
    /// Name, as given in the input.
    pub name: String,
    /// Free strain of each cell, parallel to the cells of the mesh.
    pub cells: Vec<FreeStrain>,
}

impl ImposedStrain {
    /// The state of `section` under `temperature`.
    pub fn of_temperature(
        name: impl Into<String>,
        section: &Section,
        temperature: &TemperatureField,
    ) -> Self {
        let strain = |cell: &CellMaterial| temperature.strain(&section.materials[cell.material]);
        Self {
            name: name.into(),
            cells: section.cells.iter().map(strain).collect(),
        }
    }

    /// The state of `section` under the given temperature rises, one for each cell in the
    /// order of the mesh \[K\].
    pub fn of_rises(name: impl Into<String>, section: &Section, rises: &[f64]) -> Self {
        let strain = |(cell, &rise): (&CellMaterial, &f64)| {
            let temperature = TemperatureField {
                rise,
                ..TemperatureField::default()
            };
            temperature.strain(&section.materials[cell.material])
        };
        Self {
            name: name.into(),
            cells: section.cells.iter().zip(rises).map(strain).collect(),
        }
    }
}

impl Section {
    /// Whether the material of any cell expands when heated.
    pub fn expands(&self) -> bool {
        let mut cells = self.cells.iter();
        cells.any(|cell| self.materials[cell.material].expansion.is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::samples::coupled_rectangle;
    use shared_geom::mesh::CellKind;

    #[test]
    fn temperature_is_linear_and_follows_the_expansion() {
        let mut section = coupled_rectangle(CellKind::Quadrilateral8);
        assert!(!section.expands());
        section.materials[0].expansion = Some([1e-6, 2e-5, 3e-5]);
        assert!(section.expands());
        let temperature = TemperatureField {
            rise: 10.0,
            gradient: [100.0, -50.0],
        };
        let imposed = ImposedStrain::of_temperature("hot", &section, &temperature);
        assert_eq!(imposed.cells.len(), section.cells.len());
        // 10 + 100 * 0.5 - 50 * 0.2 = 50 K
        let strain = imposed.cells[3].at([0.5, 0.2]);
        let expected = Vector6::new(5e-5, 1e-3, 1.5e-3, 0.0, 0.0, 0.0);
        assert!((strain - expected).amax() < 1e-18, "{strain}");

        let rises: Vec<_> = (0..section.cells.len()).map(|cell| cell as f64).collect();
        let imposed = ImposedStrain::of_rises("rows", &section, &rises);
        assert_eq!(imposed.cells[4].at([7.0, 7.0])[1], 4.0 * 2e-5);
    }
}

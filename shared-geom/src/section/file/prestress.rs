//! The cubic table in the property file: rows `[i, j, k, value]`.
//!
//! The indices are the indices of the six components, from one: 1 axial, 4 torsion, 5
//! bending y, 6 bending z. Changes of the stiffness by heat and imposed states are 4x4
//! matrices over the same four components.

use nalgebra::Matrix4;
use serde::{Deserialize, Serialize};

use crate::section::prestress::{CubicTable, PRESTRESS_COMPONENTS, Prestress, StrainMeasure};

/// The field as written.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FilePrestress {
    strain_measure: FileMeasure,
    third_derivatives: Vec<(usize, usize, usize, f64)>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stiffness_per_kelvin: Option<[[f64; 4]; 4]>,
}

pub(super) fn rows4(matrix: &Matrix4<f64>) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]))
}

pub(super) fn matrix4(rows: &[[f64; 4]; 4]) -> Matrix4<f64> {
    Matrix4::from_fn(|i, j| rows[i][j])
}

#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum FileMeasure {
    Biot,
    Green,
}

impl From<&Prestress> for FilePrestress {
    fn from(prestress: &Prestress) -> Self {
        let entries = prestress.third.entries();
        let rows = entries.map(|(indices, value)| {
            let [i, j, k] = indices.map(|index| PRESTRESS_COMPONENTS[index] + 1);
            (i, j, k, value)
        });
        Self {
            strain_measure: match prestress.strain_measure {
                StrainMeasure::Biot => FileMeasure::Biot,
                StrainMeasure::Green => FileMeasure::Green,
            },
            third_derivatives: rows.collect(),
            stiffness_per_kelvin: prestress.per_kelvin.as_ref().map(rows4),
        }
    }
}

impl FilePrestress {
    /// The content; invalid rows are omitted, and `note` receives a message.
    pub(super) fn prestress(&self, mut note: impl FnMut(String)) -> Prestress {
        let mut seen = Vec::new();
        for &(i, j, k, value) in &self.third_derivatives {
            let row = format!("the row [{i}, {j}, {k}, {value:e}] of \"third_derivatives\"");
            let number = |component: usize| {
                let mut known = PRESTRESS_COMPONENTS.into_iter();
                known.position(|index| index + 1 == component)
            };
            let found = (number(i), number(j), number(k));
            let (Some(first), Some(second), Some(third)) = found else {
                note(format!(
                    "{row} has another index than 1 (axial), 4 (torsion), 5 (bending y) and 6 \
                     (bending z)"
                ));
                continue;
            };
            let mut indices = [first, second, third];
            indices.sort_unstable();
            if seen.iter().any(|(known, _)| *known == indices) {
                note(format!(
                    "{row} gives an entry that another row gives already"
                ));
            }
            seen.push((indices, value));
        }
        let value = |indices: [usize; 3]| {
            let found = seen.iter().find(|(known, _)| *known == indices);
            found.map_or(0.0, |(_, value)| *value)
        };
        Prestress {
            strain_measure: match self.strain_measure {
                FileMeasure::Biot => StrainMeasure::Biot,
                FileMeasure::Green => StrainMeasure::Green,
            },
            third: CubicTable::from_fn(value),
            per_kelvin: self.stiffness_per_kelvin.as_ref().map(matrix4),
        }
    }
}

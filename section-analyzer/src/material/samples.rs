//! A piezoelectric ceramic for the unit tests of this crate.

use nalgebra::{DMatrix, Matrix3, Matrix3x6, Matrix6};
use serde_json::Value;

use super::{ElasticLaw, ElectricLaw, Material};

/// Constants of a ceramic like PZT-5H, as given in its source.
pub(crate) struct Ceramic {
    /// Compliance at constant field, order 11 22 33 23 13 12 \[1/Pa\].
    pub s: Matrix6<f64>,
    /// Strain per field \[m/V\].
    pub d: Matrix3x6<f64>,
    /// Permittivity at constant stress \[F/m\].
    pub at_stress: Matrix3<f64>,
    /// Stress per field \[C/m^2\].
    pub e: Matrix3x6<f64>,
    /// Permittivity at constant strain \[F/m\].
    pub at_strain: Matrix3<f64>,
}

/// The constants of `tests/reference/theory/piezo.json`.
pub(crate) fn ceramic() -> Ceramic {
    let text = include_str!("../../../tests/reference/theory/piezo.json");
    let file: Value = serde_json::from_str(text).expect("a file in JSON");
    let matrix = |key: &str, columns: usize| {
        let rows = file["material"][key].as_array().expect("rows");
        let numbers = rows.iter().flat_map(|row| row.as_array().expect("a row"));
        let numbers: Vec<f64> = numbers.map(|n| n.as_f64().expect("a number")).collect();
        DMatrix::from_row_slice(rows.len(), columns, &numbers)
    };
    Ceramic {
        s: matrix("s", 6).fixed_view::<6, 6>(0, 0).into(),
        d: matrix("d", 6).fixed_view::<3, 6>(0, 0).into(),
        at_stress: matrix("epsT", 3).fixed_view::<3, 3>(0, 0).into(),
        e: matrix("e", 6).fixed_view::<3, 6>(0, 0).into(),
        at_strain: matrix("epsS", 3).fixed_view::<3, 3>(0, 0).into(),
    }
}

/// The ceramic, poled along axis 3.
pub(crate) fn pzt_5h() -> Material {
    let Ceramic {
        s, d, at_stress, ..
    } = ceramic();
    let c = s.try_inverse().expect("a compliance");
    Material {
        name: "pzt".into(),
        law: ElasticLaw::Full(0.5 * (c + c.transpose())),
        density: 7500.0,
        expansion: None,
        electric: Some(ElectricLaw::of_strains(&d, &at_stress, &c)),
    }
}

//! Electric laws as written: `[material.NAME.electric]`.
//!
//! All constants of the material are in the axes of the data, whose axis 3 is the poled
//! one. `poling` and `across` give the orientation of these axes in the axes of the
//! material, which regions rotate.

use nalgebra::{Matrix3, Matrix3x6, Vector3};
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use crate::material::{
    Coupling, ElasticLaw, ElectricLaw, MaterialLimits, MeasuredAt, StrainLimit, Strength,
    VACUUM_PERMITTIVITY, data_axes,
};

mod problem;
mod warning;

pub use problem::ElectricDataProblem;
pub use warning::ElectricWarning;

use problem::ElectricDataProblem as Problem;

/// Names of the constants of a coupling: `d` or `e` before the components of field and
/// strain or stress.
const COMPONENTS: [[&str; 6]; 3] = [
    ["11", "12", "13", "14", "15", "16"],
    ["21", "22", "23", "24", "25", "26"],
    ["31", "32", "33", "34", "35", "36"],
];

/// Constants that are equal if all directions normal to the poling are equivalent.
const PARTNERS: [[(usize, usize); 2]; 2] = [[(2, 0), (2, 1)], [(0, 4), (1, 3)]];

/// The electric part of a material as far as it could be read.
#[derive(Debug, Clone)]
pub(super) struct WrittenElectric {
    /// Line of its table.
    pub line: usize,
    /// The law in the axes of the data. If it has a problem, which has been noted, it is
    /// replaced by one that suits every electrode.
    pub law: ElectricLaw,
    /// The axes of the data, in material axes.
    pub axes: Matrix3<f64>,
    /// Constants that are given without their partner: `d31` and `d32`.
    pub alone: Vec<[String; 2]>,
}

/// Reads the table of a material whose law is `law`, if it has one; notes problems.
pub(super) fn read(
    material: &str,
    table: &Table<'_>,
    law: Option<&ElasticLaw>,
) -> Option<WrittenElectric> {
    if !table.has("electric") {
        if law == Some(&ElasticLaw::Absent) {
            table.note(
                "stiffness",
                &Problem::NothingAtAll {
                    material: material.into(),
                },
            );
        }
        return None;
    }
    let line = table.line_of("electric");
    let mut written = WrittenElectric {
        line,
        law: open_law(),
        axes: Matrix3::identity(),
        alone: Vec::new(),
    };
    if let Some(table) = table.table("electric") {
        let data = Data {
            material,
            table: &table,
        };
        if let Some(axes) = data.axes() {
            written.axes = axes;
        }
        if let Some(found) = data.law(law, &mut written.alone) {
            written.law = found;
        }
        table.finish();
    }
    Some(written)
}

/// A substitute for a law that could not be read.
fn open_law() -> ElectricLaw {
    ElectricLaw {
        coupling: Matrix3x6::repeat(1.0),
        permittivity: Matrix3::identity() * VACUUM_PERMITTIVITY,
    }
}

/// Notes strengths along other axes than the axes of the other constants.
pub(super) fn check_limits(
    material: &str,
    table: &Table<'_>,
    limits: &MaterialLimits,
    electric: Option<&WrittenElectric>,
) {
    let is_turned = electric.is_some_and(|electric| electric.axes != Matrix3::identity());
    let has_ply = matches!(limits.strength, Some(Strength::Ply { .. }));
    let has_strains = matches!(limits.strain, Some(StrainLimit::Ply(_)));
    for (key, is_there) in [("strength", has_ply), ("strain_limit", has_strains)] {
        if is_turned && is_there {
            let material = material.to_owned();
            table.note(key, &Problem::LimitsTurned { material, key });
        }
    }
}

/// Notes keys that have no effect in a material without stiffness.
pub(super) fn check_absent(material: &str, table: &Table<'_>) {
    for key in ["expansion", "strength", "strain_limit"] {
        if table.has(key) {
            let material = material.to_owned();
            table.note(key, &Problem::NothingToStrain { material, key });
        }
    }
}

/// The table and its material.
struct Data<'a> {
    material: &'a str,
    table: &'a Table<'a>,
}

impl Data<'_> {
    fn note(&self, key: &str, problem: impl FnOnce(String) -> Problem) {
        self.table.note(key, &problem(self.material.to_owned()));
    }

    /// The law in the axes of the data.
    fn law(&self, law: Option<&ElasticLaw>, alone: &mut Vec<[String; 2]>) -> Option<ElectricLaw> {
        // All keys are read before the first wrong one ends the reading.
        let coupling = self.coupling(alone);
        let permittivity = self.permittivity();
        let at = self.at();
        let (coupling, permittivity, at) = (coupling?, permittivity?, at?);
        let key = coupling.as_ref().map(key_of);
        match (key, at, law) {
            (None, Some(_), _) => {
                self.note("at", |material| Problem::AtAlone { material });
                return None;
            }
            (Some(key), _, Some(ElasticLaw::Absent)) => {
                self.note(key, |material| Problem::NothingToCouple { material, key });
                return None;
            }
            _ => {}
        }
        let by_form = match coupling {
            Some(Coupling::Strains(_)) => MeasuredAt::Stress,
            _ => MeasuredAt::Strain,
        };
        let law = law.filter(|law| law.check().is_empty())?;
        let measured = (&permittivity, at.unwrap_or(by_form));
        match ElectricLaw::checked(coupling.as_ref(), measured, &law.stiffness()) {
            Ok(law) => Some(law),
            Err(problems) => {
                for problem in problems {
                    let key = problem::key_of(&problem, self.permittivity_key(), key);
                    self.note(key, |material| Problem::Law { material, problem });
                }
                None
            }
        }
    }

    fn permittivity_key(&self) -> &'static str {
        match self.table.has("permittivity") {
            true => "permittivity",
            false => "relative_permittivity",
        }
    }

    /// The coupling, if given; `None` if it is wrong.
    fn coupling(&self, alone: &mut Vec<[String; 2]>) -> Option<Option<Coupling>> {
        let (has_d, has_e) = (self.table.has("d"), self.table.has("e"));
        match (has_d, has_e) {
            (false, false) => Some(None),
            (true, true) => {
                self.note("e", |material| Problem::TwoCouplings { material });
                None
            }
            (true, false) => {
                let d = self.components("d", Dimension::STRAIN_PER_FIELD, alone)?;
                Some(Some(Coupling::Strains(d)))
            }
            (false, true) => {
                let e = self.components("e", Dimension::CHARGE_PER_AREA, alone)?;
                Some(Some(Coupling::Stresses(e)))
            }
        }
    }

    /// The components under `key`: three rows, or a table with some of them by name.
    fn components(
        &self,
        key: &'static str,
        dimension: Dimension,
        alone: &mut Vec<[String; 2]>,
    ) -> Option<Matrix3x6<f64>> {
        let found = match self.table.is_table(key) {
            true => constants(&self.table.table(key)?, key, dimension, alone)?,
            false => {
                let rows = self.table.rows_of(key, [3, 6], dimension)?;
                Matrix3x6::from_fn(|i, j| rows[i][j])
            }
        };
        if found == Matrix3x6::zeros() {
            self.note(key, |material| Problem::ZeroCoupling { material, key });
            return None;
        }
        Some(found)
    }

    /// Permittivity \[F/m\]: one number, three, or three rows.
    fn permittivity(&self) -> Option<Matrix3<f64>> {
        // Both keys are read, so that neither is reported as unknown.
        let has = ["permittivity", "relative_permittivity"].map(|key| self.table.has(key));
        let (key, dimension, unit) = match has {
            [true, false] => ("permittivity", Dimension::PERMITTIVITY, 1.0),
            [false, true] => (
                "relative_permittivity",
                Dimension::NUMBER,
                VACUUM_PERMITTIVITY,
            ),
            [true, true] => {
                let problem = |material| Problem::TwoPermittivities { material };
                self.note("relative_permittivity", problem);
                return None;
            }
            [false, false] => {
                self.note("", |material| Problem::NoPermittivity { material });
                return None;
            }
        };
        if self.table.is_nested(key) {
            let rows = self.table.rows_of(key, [3, 3], dimension)?;
            return Some(Matrix3::from_fn(|i, j| unit * rows[i][j]));
        }
        let found = self.table.quantities(key, dimension)?;
        match found[..] {
            [all] if !self.table.is_list(key) => Some(Matrix3::identity() * all * unit),
            [a, b, c] => Some(Matrix3::from_diagonal(&Vector3::new(a, b, c)) * unit),
            _ => {
                let expected =
                    format!("{dimension}, an array of 3, one for each axis, or 3 rows of 3");
                self.table.wrong(key, &expected);
                None
            }
        }
    }

    /// The state at which the permittivity was measured, if given.
    fn at(&self) -> Option<Option<MeasuredAt>> {
        if !self.table.has("at") {
            return Some(None);
        }
        let word = self.table.word("at", &["stress", "strain"])?;
        Some(Some([MeasuredAt::Stress, MeasuredAt::Strain][word]))
    }

    /// The axes of the data in the axes of the material.
    fn axes(&self) -> Option<Matrix3<f64>> {
        let [poling, across] = ["poling", "across"].map(|key| match self.table.has(key) {
            true => direction(self.table, key).map(Some),
            false => Some(None),
        });
        let poling = poling?.unwrap_or_else(Vector3::z);
        let found = data_axes(&poling, across?.as_ref());
        let key = if self.table.has("across") {
            "across"
        } else {
            "poling"
        };
        let note = |problem| self.note(key, |material| Problem::Axes { material, problem });
        found.map_err(note).ok()
    }
}

fn key_of(coupling: &Coupling) -> &'static str {
    match coupling {
        Coupling::Strains(_) => "d",
        Coupling::Stresses(_) => "e",
    }
}

/// Constants by name, zero where not given.
fn constants(
    table: &Table<'_>,
    letter: &str,
    dimension: Dimension,
    alone: &mut Vec<[String; 2]>,
) -> Option<Matrix3x6<f64>> {
    let name = |row: usize, column: usize| format!("{letter}{}", COMPONENTS[row][column]);
    let mut found = Matrix3x6::zeros();
    let mut is_sound = true;
    for row in 0..3 {
        for column in 0..6 {
            let key = name(row, column);
            if table.has(&key) {
                let value = table.quantity(&key, dimension);
                is_sound &= value.is_some();
                found[(row, column)] = value.unwrap_or(0.0);
            }
        }
    }
    for pair in PARTNERS {
        let [first, second] = pair.map(|(row, column)| name(row, column));
        match (table.has(&first), table.has(&second)) {
            (true, false) => alone.push([first, second]),
            (false, true) => alone.push([second, first]),
            _ => {}
        }
    }
    table.finish();
    is_sound.then_some(found)
}

/// A material axis by its number, with a minus for the opposite direction, or three components.
fn direction(table: &Table<'_>, key: &str) -> Option<Vector3<f64>> {
    if table.is_list(key) {
        return table.vector(key, Dimension::NUMBER);
    }
    let number = table.quantity(key, Dimension::NUMBER)?;
    let axis = [1.0, 2.0, 3.0]
        .iter()
        .position(|axis| *axis == number.abs());
    let Some(axis) = axis else {
        let expected = "1, 2 or 3 for a material axis, with a minus for the opposite direction, \
                        or an array of 3, its components along them";
        table.wrong(key, expected);
        return None;
    };
    let mut direction = Vector3::zeros();
    direction[axis] = number.signum();
    Some(direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_in_their_order() {
        for (row, names) in COMPONENTS.iter().enumerate() {
            for (column, name) in names.iter().enumerate() {
                assert_eq!(*name, format!("{}{}", row + 1, column + 1));
            }
        }
    }
}

//! Electric laws as written: `[material.NAME.electric]`.
//!
//! All constants of the material are in the axes of the data, whose axis 3 is the poled
//! one. `poling` and `across` give the orientation of these axes in the axes of the
//! material, which regions rotate.

use nalgebra::{Matrix3, Matrix3x6, Vector3};
use shared_geom::document::schema::ValueKind::{Quantity, Rows, Table as OneTable, Vector, Word};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{Declared, Key, Nested, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::material::{
    Coupling, ElasticLaw, ElectricLaw, MaterialLimits, MeasuredAt, StrainLimit, Strength,
    VACUUM_PERMITTIVITY, data_axes,
};

mod constants;
mod problem;
mod warning;

pub use problem::ElectricDataProblem;
pub use warning::ElectricWarning;

use constants::{Constants, D, E};
use problem::ElectricDataProblem as Problem;

keys! {
    /// The electric law of a dielectric; without it the material is not part of the electric
    /// problem.
    pub(super) ELECTRIC: Nested = "electric", [OneTable(&LAW)], optional, "";
    /// The electric law, without coupling.
    pub(super) DIELECTRIC: Nested = "electric", [OneTable(&PLAIN)], required, "";
    /// Direction of axis 3 of all constants of the material, elastic ones and expansion too, in
    /// the axes of the material: one of them (1 along the fiber, 2 across it in the ply, 3 through
    /// the thickness; with a minus for the opposite direction), or its components.
    POLING: Direction = "poling", [Quantity(Dimension::NUMBER), Vector(3, Dimension::NUMBER)],
        or "3" = Direction(Vector3::z()), "3";
    /// Direction of axis 1 of the constants in the axes of the material, at a right angle to the
    /// poling; required if the poling is along none of them.
    ACROSS: Option<Direction> = "across",
        [Quantity(Dimension::NUMBER), Vector(3, Dimension::NUMBER)],
        or "the axis after the poling, of 1, 2, 3, 1", "1";
    /// Permittivity: one number, three along the axes of the constants, or a symmetric matrix;
    /// plain numbers in the declared force per square of the voltage (F/m in SI).
    PERMITTIVITY: Permittivity = "permittivity",
        [Quantity(Dimension::PERMITTIVITY), Vector(3, Dimension::PERMITTIVITY), Rows(3, 3)],
        required, "[\"2.77e-8 F/m\", \"2.77e-8 F/m\", \"3.01e-8 F/m\"]";
    /// Permittivity in units of the vacuum permittivity, 8.8541878128e-12 F/m: one number, three,
    /// or a symmetric matrix.
    RELATIVE: Permittivity = "relative_permittivity",
        [Quantity(Dimension::NUMBER), Vector(3, Dimension::NUMBER), Rows(3, 3)], required,
        "[3130, 3130, 3400]";
    /// Quantity that was constant when the permittivity was measured.
    AT_OF_D: usize = "at", [Word(&["stress", "strain"])], or "\"stress\"" = 0, "\"stress\"";
    /// Quantity that was constant when the permittivity was measured.
    AT_OF_E: usize = "at", [Word(&["stress", "strain"])], or "\"strain\"" = 1, "\"strain\"";
}

/// The states at which a permittivity is measured, parallel to the words of `at`.
const MEASURED_AT: [MeasuredAt; 2] = [MeasuredAt::Stress, MeasuredAt::Strain];

const LAW: TableSchema = TableSchema {
    title: "[material.NAME.electric]",
    meaning: "Electric law of a material. The stiffness of the material is the stiffness at \
              constant electric field (short circuit).",
    keys: &[POLING.schema, ACROSS.schema],
    families: &[
        Family {
            name: "dielectric",
            meaning: "Not piezoelectric.",
            keys: &[PERMITTIVITY.schema],
        },
        Family {
            name: "dielectric, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[RELATIVE.schema],
        },
        Family {
            name: "d",
            meaning: "Piezoelectric, by strains per field.",
            keys: &[D.schema, PERMITTIVITY.schema, AT_OF_D.schema],
        },
        Family {
            name: "d, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[D.schema, RELATIVE.schema, AT_OF_D.schema],
        },
        Family {
            name: "e",
            meaning: "Piezoelectric, by stresses per field.",
            keys: &[E.schema, PERMITTIVITY.schema, AT_OF_E.schema],
        },
        Family {
            name: "e, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[E.schema, RELATIVE.schema, AT_OF_E.schema],
        },
    ],
};

const PLAIN: TableSchema = TableSchema {
    title: "[material.NAME.electric], no stiffness",
    meaning: "The permittivity of a material without stiffness.",
    keys: &[POLING.schema, ACROSS.schema],
    families: &[
        Family {
            name: "dielectric",
            meaning: "In F/m.",
            keys: &[PERMITTIVITY.schema],
        },
        Family {
            name: "dielectric, relative",
            meaning: "In units of the permittivity of vacuum.",
            keys: &[RELATIVE.schema],
        },
    ],
};

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
    if !table.has(&ELECTRIC) {
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
    let line = table.line_of(&ELECTRIC);
    let mut written = WrittenElectric {
        line,
        law: open_law(),
        axes: Matrix3::identity(),
        alone: Vec::new(),
    };
    if let Some(table) = table.table(&ELECTRIC) {
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
        let at = self.table.get(if self.table.has(&D) {
            &AT_OF_D
        } else {
            &AT_OF_E
        });
        let (coupling, permittivity, at) = (coupling?, permittivity?, at?);
        let key = coupling.as_ref().map(key_of);
        match (key, self.table.has(&AT_OF_E), law) {
            (None, true, _) => {
                self.note(AT_OF_E.name(), |material| Problem::AtAlone { material });
                return None;
            }
            (Some(key), _, Some(ElasticLaw::Absent)) => {
                self.note(key, |material| Problem::NothingToCouple { material, key });
                return None;
            }
            _ => {}
        }
        let law = law.filter(|law| law.check().is_empty())?;
        let measured = (&permittivity, MEASURED_AT[at]);
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
        if self.table.has(&PERMITTIVITY) {
            PERMITTIVITY.name()
        } else {
            RELATIVE.name()
        }
    }

    /// The coupling, if given; `None` if it is wrong.
    fn coupling(&self, alone: &mut Vec<[String; 2]>) -> Option<Option<Coupling>> {
        match (self.table.has(&D), self.table.has(&E)) {
            (false, false) => Some(None),
            (true, true) => {
                self.note(E.name(), |material| Problem::TwoCouplings { material });
                None
            }
            (true, false) => Some(Some(Coupling::Strains(self.components(&D, alone)?))),
            (false, true) => Some(Some(Coupling::Stresses(self.components(&E, alone)?))),
        }
    }

    /// The components under a key: three rows, or a table with some of them by name.
    fn components(
        &self,
        key: &Key<Constants>,
        alone: &mut Vec<[String; 2]>,
    ) -> Option<Matrix3x6<f64>> {
        let found = self.table.get(key)?;
        alone.extend(found.alone);
        if found.values == Matrix3x6::zeros() {
            let key = key.name();
            self.note(key, |material| Problem::ZeroCoupling { material, key });
            return None;
        }
        Some(found.values)
    }

    /// Permittivity \[F/m\], under one of both keys.
    fn permittivity(&self) -> Option<Matrix3<f64>> {
        let has = [&PERMITTIVITY, &RELATIVE].map(|key| self.table.has(key));
        let key = match has {
            [true, false] => &PERMITTIVITY,
            [false, true] => &RELATIVE,
            [true, true] => {
                let problem = |material| Problem::TwoPermittivities { material };
                self.note(RELATIVE.name(), problem);
                return None;
            }
            [false, false] => {
                self.note("", |material| Problem::NoPermittivity { material });
                return None;
            }
        };
        self.table.get(key).map(|found| found.0)
    }

    /// The axes of the data in the axes of the material.
    fn axes(&self) -> Option<Matrix3<f64>> {
        let (poling, across) = (self.table.get(&POLING), self.table.get(&ACROSS));
        let across = across?.map(|direction| direction.0);
        let found = data_axes(&poling?.0, across.as_ref());
        let key = match across {
            Some(_) => ACROSS.name(),
            None => POLING.name(),
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

/// Permittivity \[F/m\]: one number, three, or three rows; pure numbers are in units of the
/// vacuum permittivity.
#[derive(Debug)]
struct Permittivity(Matrix3<f64>);

impl Declared for Permittivity {}

impl Value for Permittivity {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let dimension = key.dimension();
        let unit = match dimension {
            Dimension::NUMBER => VACUUM_PERMITTIVITY,
            _ => 1.0,
        };
        if table.is_nested(key) {
            let rows = table.rows_of(key.name, [3, 3], dimension)?;
            return Some(Self(Matrix3::from_fn(|i, j| unit * rows[i][j])));
        }
        let found = table.quantities(key.name, dimension)?;
        match found[..] {
            [all] if !table.is_list(key) => Some(Self(Matrix3::identity() * all * unit)),
            [a, b, c] => {
                let diagonal = Vector3::new(a, b, c);
                Some(Self(Matrix3::from_diagonal(&diagonal) * unit))
            }
            _ => {
                let expected =
                    format!("{dimension}, an array of 3, one for each axis, or 3 rows of 3");
                table.wrong(key, &expected);
                None
            }
        }
    }
}

/// A direction in the axes of the material, of any length.
#[derive(Debug)]
struct Direction(Vector3<f64>);

impl Declared for Direction {}

/// A material axis by its number, with a minus for the opposite direction, or three components.
impl Value for Direction {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        if table.is_list(key) {
            return table.vector(key.name, Dimension::NUMBER).map(Self);
        }
        let number = table.quantity(key.name, Dimension::NUMBER)?;
        let axis = [1.0, 2.0, 3.0]
            .iter()
            .position(|axis| *axis == number.abs());
        let Some(axis) = axis else {
            let expected = "1, 2 or 3 for a material axis, with a minus for the opposite \
                            direction, or an array of 3, its components along them";
            table.wrong(key, expected);
            return None;
        };
        let mut direction = Vector3::zeros();
        direction[axis] = number.signum();
        Some(Self(direction))
    }
}

//! The constants of a coupling: `d`, strains per electric field, and `e`, stresses.

use nalgebra::Matrix3x6;
use shared_geom::document::schema::ValueKind::{Quantity, Rows, Table as OneTable};
use shared_geom::document::schema::{KeySchema, Need, TableSchema, ValueKind, key};
use shared_geom::document::{Declared, Key, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

/// Constants that are equal if all directions normal to the poling are equivalent: their
/// numbers in the list of constants, row by row.
const PARTNERS: [[usize; 2]; 2] = [[12, 13], [4, 9]];

keys! {
    /// Strain per electric field without stress: constants by name, or 3 rows (field 1, 2, 3) of
    /// 6 (strain 11, 22, 33, 23, 13, 12, engineering shears); plain numbers in the declared length
    /// per voltage.
    pub(super) D: Constants = "d", [OneTable(&STRAINS), Rows(3, 6)], required,
        "[[0, 0, 0, 0, 741e-12, 0], [0, 0, 0, 741e-12, 0, 0], [-274e-12, -274e-12, 593e-12, 0, 0, 0]]";
    /// Stress per electric field without strain, with the sign sigma = c eps - e' E: constants by
    /// name, or 3 rows of 6; plain numbers in the declared force per length and voltage (C/m^2 in
    /// SI).
    pub(super) E: Constants = "e", [OneTable(&STRESSES), Rows(3, 6)], required,
        "[[0, 0, 0, 0, 17, 0], [0, 0, 0, 17, 0, 0], [-6.6, -6.6, 23.2, 0, 0, 0]]";
}

const STRAIN: &[ValueKind] = &[Quantity(Dimension::STRAIN_PER_FIELD)];
const STRESS: &[ValueKind] = &[Quantity(Dimension::CHARGE_PER_AREA)];

/// A strain per field, zero if not given.
const fn strain(name: &'static str, example: &'static str, meaning: &'static str) -> KeySchema {
    key(name, STRAIN, Need::Default("0"), example, meaning)
}

/// A stress per field, zero if not given.
const fn stress(name: &'static str, example: &'static str, meaning: &'static str) -> KeySchema {
    key(name, STRESS, Need::Default("0"), example, meaning)
}

const STRAINS: TableSchema = TableSchema {
    title: "d = { ... }",
    meaning: "Strains per electric field by name: first the component of the field, then of the \
              strain, 1 to 6 for 11, 22, 33, 23, 13, 12.",
    keys: &[
        strain("d11", "\"10 pC/N\"", "Strain 11 of field 1."),
        strain("d12", "\"10 pC/N\"", "Strain 22 of field 1."),
        strain("d13", "\"10 pC/N\"", "Strain 33 of field 1."),
        strain("d14", "\"10 pC/N\"", "Shear strain 23 of field 1."),
        strain("d15", "\"741 pC/N\"", "Shear strain 13 of field 1."),
        strain("d16", "\"10 pC/N\"", "Shear strain 12 of field 1."),
        strain("d21", "\"10 pC/N\"", "Strain 11 of field 2."),
        strain("d22", "\"10 pC/N\"", "Strain 22 of field 2."),
        strain("d23", "\"10 pC/N\"", "Strain 33 of field 2."),
        strain("d24", "\"741 pC/N\"", "Shear strain 23 of field 2."),
        strain("d25", "\"10 pC/N\"", "Shear strain 13 of field 2."),
        strain("d26", "\"10 pC/N\"", "Shear strain 12 of field 2."),
        strain("d31", "\"-274 pC/N\"", "Strain 11 of field 3."),
        strain("d32", "\"-274 pC/N\"", "Strain 22 of field 3."),
        strain("d33", "\"593 pC/N\"", "Strain 33 of field 3."),
        strain("d34", "\"10 pC/N\"", "Shear strain 23 of field 3."),
        strain("d35", "\"10 pC/N\"", "Shear strain 13 of field 3."),
        strain("d36", "\"10 pC/N\"", "Shear strain 12 of field 3."),
    ],
    families: &[],
};

const STRESSES: TableSchema = TableSchema {
    title: "e = { ... }",
    meaning: "Stresses per electric field by name: first the component of the field, then of the \
              stress, 1 to 6 for 11, 22, 33, 23, 13, 12.",
    keys: &[
        stress("e11", "\"0.1 C/m^2\"", "Stress 11 of field 1."),
        stress("e12", "\"0.1 C/m^2\"", "Stress 22 of field 1."),
        stress("e13", "\"0.1 C/m^2\"", "Stress 33 of field 1."),
        stress("e14", "\"0.1 C/m^2\"", "Shear stress 23 of field 1."),
        stress("e15", "\"17 C/m^2\"", "Shear stress 13 of field 1."),
        stress("e16", "\"0.1 C/m^2\"", "Shear stress 12 of field 1."),
        stress("e21", "\"0.1 C/m^2\"", "Stress 11 of field 2."),
        stress("e22", "\"0.1 C/m^2\"", "Stress 22 of field 2."),
        stress("e23", "\"0.1 C/m^2\"", "Stress 33 of field 2."),
        stress("e24", "\"17 C/m^2\"", "Shear stress 23 of field 2."),
        stress("e25", "\"0.1 C/m^2\"", "Shear stress 13 of field 2."),
        stress("e26", "\"0.1 C/m^2\"", "Shear stress 12 of field 2."),
        stress("e31", "\"-6.6 C/m^2\"", "Stress 11 of field 3."),
        stress("e32", "\"-6.6 C/m^2\"", "Stress 22 of field 3."),
        stress("e33", "\"23.2 C/m^2\"", "Stress 33 of field 3."),
        stress("e34", "\"0.1 C/m^2\"", "Shear stress 23 of field 3."),
        stress("e35", "\"0.1 C/m^2\"", "Shear stress 13 of field 3."),
        stress("e36", "\"0.1 C/m^2\"", "Shear stress 12 of field 3."),
    ],
    families: &[],
};

/// The constants of a coupling as written.
#[derive(Debug)]
pub(super) struct Constants {
    /// Rows of the components of the field \[m/V\] or \[C/m^2\].
    pub values: Matrix3x6<f64>,
    /// Constants that are given without their partner: `d31` and `d32`.
    pub alone: Vec<[String; 2]>,
}

impl Declared for Constants {}

/// Three rows, or a table with some of the constants by name.
impl Value for Constants {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let known = key.kinds[0].table()?.keys;
        if table.is_table(key) {
            return by_name(&table.table(key)?, known);
        }
        let rows = table.rows_of(key.name, [3, 6], known[0].dimension())?;
        Some(Self {
            values: Matrix3x6::from_fn(|i, j| rows[i][j]),
            alone: Vec::new(),
        })
    }
}

/// Constants by name, zero if not given; the `known` ones are in the order of the rows.
fn by_name(table: &Table<'_>, known: &[KeySchema]) -> Option<Constants> {
    let read = known
        .iter()
        .map(|key| table.get(&Key::<Option<f64>>::new(*key, None)));
    let read: Vec<_> = read.collect();
    let mut alone = Vec::new();
    for pair in PARTNERS {
        let [first, second] = pair.map(|number| known[number].name.to_owned());
        match (table.has(&first), table.has(&second)) {
            (true, false) => alone.push([first, second]),
            (false, true) => alone.push([second, first]),
            _ => {}
        }
    }
    table.finish();
    let values: Vec<f64> = read
        .into_iter()
        .map(|one| Some(one?.unwrap_or(0.0)))
        .collect::<Option<_>>()?;
    Some(Constants {
        values: Matrix3x6::from_row_slice(&values),
        alone,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_are_in_their_order() {
        for table in [&STRAINS, &STRESSES] {
            for (number, key) in table.keys.iter().enumerate() {
                let components = format!("{}{}", number / 6 + 1, number % 6 + 1);
                assert_eq!(key.name[1..], components);
            }
        }
        let partners = PARTNERS.map(|pair| pair.map(|number| STRAINS.keys[number].name));
        assert_eq!(partners, [["d31", "d32"], ["d15", "d24"]]);
    }
}

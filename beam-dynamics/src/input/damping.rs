//! Internal damping of a section: `damping = { time = ... }` or `{ matrix = [...] }`, of a blade file also
//! `{ times = [...] }`.

use nalgebra::Matrix6;
use shared_geom::document::schema::ValueKind::{NotNegative, Rows, Table as OneTable, Vector};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{ByHand, Content, Key, Table};
use shared_geom::keys;
use shared_geom::section::Damping;
use shared_geom::units::Dimension;

use super::problem::InputProblem;

/// Internal damping.
pub(super) const DAMPING: TableSchema = TableSchema {
    title: "damping = { ... }",
    meaning: "Internal damping, an internal force per rate of strain.",
    keys: &[],
    families: &[
        Family {
            name: "proportional",
            meaning: "Proportional to the stiffness.",
            keys: &[TIME.schema],
        },
        Family {
            name: "viscous",
            meaning: "By its matrix.",
            keys: &[MATRIX.schema],
        },
    ],
};

/// Internal damping of a blade from a file.
pub(super) const OF_FILE: TableSchema = TableSchema {
    title: "damping = { ... } of a blade file",
    meaning: "Internal damping of all stations, an internal force per rate of strain.",
    keys: &[],
    families: &[
        DAMPING.families[0],
        DAMPING.families[1],
        Family {
            name: "times",
            meaning: "Proportional to each of the six stiffnesses.",
            keys: &[TIMES.schema],
        },
    ],
};

keys! {
    /// Ratio of damping to stiffness; a mode of angular frequency w has the damping ratio
    /// `time` w / 2.
    TIME: f64 = "time", [NotNegative(Dimension::TIME)], required, "1e-3";
    /// Symmetric matrix of six rows, in the units of the file.
    MATRIX: [[f64; 6]; 6] = "matrix", [Rows(6, 6)], required,
        "[[9, 0, 0, 0, 0, 0], [0, 9, 0, 0, 0, 0], [0, 0, 9, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]";
    /// Ratio of damping to stiffness of extension, shears along y and z, torsion, and bending about y (flap)
    /// and z (edge), at the point and in the axes of the stations.
    TIMES: [f64; 6] = "times", [Vector(6, Dimension::TIME)], required,
        "[0, 0, 0, 3e-4, 3e-3, 2e-3]";
    /// Internal damping; of a file it replaces the damping in the file.
    pub(super) KEY: ByHand = "damping", [OneTable(&DAMPING)], optional, "";
    /// Internal damping, which replaces the damping in the file.
    pub(super) KEY_OF_FILE: ByHand = "damping", [OneTable(&OF_FILE)], optional, "";
}

/// The keys of which one is expected, of a section and of a blade file.
const ONE: &str = "\"time\" and \"matrix\"";
const ONE_OF_FILE: &str = "\"time\", \"times\" and \"matrix\"";

/// Damping of a blade file.
pub(super) enum OfFile {
    /// The same as of a section.
    Section(Box<Damping>),
    /// Ratios of damping to stiffness for the six components \[s\].
    Times([f64; 6]),
}

/// The damping of a blade from a file, as [`read`].
pub(super) fn read_of_file(table: &Table<'_>) -> Option<Option<OfFile>> {
    let Some(inner) = opened(table, &KEY_OF_FILE, ONE_OF_FILE)? else {
        return Some(None);
    };
    if inner.has(&TIMES) {
        return times(table, &inner).map(|times| Some(OfFile::Times(times)));
    }
    of_section(table, &inner, ONE_OF_FILE).map(|own| Some(OfFile::Section(Box::new(own))))
}

/// The damping of a blade from a file as it is written, with its key, for a card of the blade.
pub(super) fn copied(table: &Table<'_>) -> Option<(&'static str, Content)> {
    let key = KEY_OF_FILE.name();
    Some((key, table.copied(key)?))
}

/// The damping of a table of properties: `None` if it is wrong, `Some(None)` if there is
/// none.
pub(super) fn read(table: &Table<'_>) -> Option<Option<Damping>> {
    let Some(inner) = opened(table, &KEY, ONE)? else {
        return Some(None);
    };
    of_section(table, &inner, ONE).map(Some)
}

/// The table of the damping; `None` if it is no table, `Some(None)` if there is none.
fn opened<'a>(
    table: &'a Table<'_>,
    key: &Key<ByHand>,
    one: &'static str,
) -> Option<Option<Table<'a>>> {
    if !table.has(key) {
        return Some(None);
    }
    if !table.is_table(key) {
        table.wrong(
            key,
            &format!("a table with one of {one}, as in {{ time = 1e-3 }}"),
        );
        return None;
    }
    table.table(key).map(Some)
}

fn times(table: &Table<'_>, inner: &Table<'_>) -> Option<[f64; 6]> {
    let times = inner.get(&TIMES);
    if inner.has(&TIME) || inner.has(&MATRIX) {
        table.note(&KEY_OF_FILE, &InputProblem::OneDamping(ONE_OF_FILE));
        return None;
    }
    inner.finish();
    let times = times?;
    if times.iter().any(|time| *time < 0.0) {
        inner.wrong(&TIMES, "six times, zero or more");
        return None;
    }
    Some(times)
}

fn of_section(table: &Table<'_>, inner: &Table<'_>, one: &'static str) -> Option<Damping> {
    let damping = match [inner.has(&TIME), inner.has(&MATRIX)] {
        [true, false] => inner.get(&TIME).map(Damping::StiffnessProportional),
        [false, true] => matrix(inner).map(Damping::Viscous),
        _ => {
            table.note(&KEY, &InputProblem::OneDamping(one));
            None
        }
    };
    inner.finish();
    damping
}

/// The 6x6 matrix in SI units: N s for forces and shears, N m^2 s for moments and
/// curvatures, N m s between them.
fn matrix(table: &Table<'_>) -> Option<Matrix6<f64>> {
    let rows = table.get(&MATRIX)?;
    let factors = [
        Dimension::FORCE_TIME,
        Dimension::TURNING_DAMPER,
        Dimension::BENDING_TIME,
    ];
    let factors = factors.map(|dimension| table.document().factor(dimension));
    Some(Matrix6::from_fn(|i, j| rows[i][j] * factors[i / 3 + j / 3]))
}

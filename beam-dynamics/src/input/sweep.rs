//! Values of a parameter: the keys that all analyses over a parameter share.

use shared_geom::document::schema::ValueKind::{Count, Quantities, Quantity, Text};
use shared_geom::document::schema::{KeySchema, TableSchema};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::error::{Explain, nearest_name};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::case::Sweep;

/// Largest number of values.
const MOST: usize = 100_000;

/// Values of a parameter, each trimmed from the solution before.
pub(super) const TRIM_SWEEP: TableSchema = TableSchema {
    title: "[trim.sweep]",
    meaning: "Values of a parameter, each trimmed from the solution before.",
    keys: &SWEEP_KEYS,
    families: &[],
};

/// Values of a parameter, at each of which the equilibrium is found from the one before.
pub(super) const STATIC_SWEEP: TableSchema = TableSchema {
    title: "[static.sweep]",
    meaning: "Values of a parameter, at each of which the equilibrium is found from the one before.",
    keys: &SWEEP_KEYS,
    families: &[],
};

/// The keys of a sweep.
const SWEEP_KEYS: [KeySchema; 5] = [
    PARAMETER.schema,
    VALUES.schema,
    FROM.schema,
    TO.schema,
    STEPS.schema,
];

keys! {
    /// One of the `[parameters]`.
    pub(super) PARAMETER: String = "parameter", [Text], required, "\"advance_ratio\"";
    /// The values, in this order. Without values: the rows of a table of `[parameters]` over it.
    pub(super) VALUES: Option<Vec<f64>> = "values", [Quantities(Dimension::NUMBER)], optional,
        "[0, 0.1, 0.2]";
    /// First value.
    pub(super) FROM: Option<f64> = "from", [Quantity(Dimension::NUMBER)], optional, "0";
    /// Last value.
    pub(super) TO: Option<f64> = "to", [Quantity(Dimension::NUMBER)], optional, "0.35";
    /// Number of values, both ends included.
    pub(super) STEPS: Option<usize> = "steps", [Count(MOST)], optional, "8";
}

/// A problem of the values of a parameter.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SweepProblem {
    /// A name that is no parameter.
    #[error("\"{name}\" is not one of the [parameters]")]
    NoParameter {
        /// The name.
        name: String,
        /// The names of the parameters.
        known: Vec<String>,
    },
    /// A parameter without effect.
    #[error(
        "no expression uses the parameter \"{name}\", so that all points of the sweep are the same"
    )]
    Unused {
        /// The name.
        name: String,
    },
    /// The values are not given, or twice.
    #[error(
        "the values of the sweep are given by {found}, expected \"values\", or \"from\", \"to\" \
         and at least 2 \"steps\""
    )]
    Ways {
        /// The keys found, as text.
        found: &'static str,
    },
}

impl Explain for SweepProblem {
    fn help(&self) -> Option<String> {
        Some(match self {
            Self::NoParameter { name, known } => {
                match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(nearest) => format!("did you mean \"{nearest}\"?"),
                    None => "add it to [parameters], and use it in expressions of other numbers"
                        .to_owned(),
                }
            }
            Self::Unused { name } => {
                format!("use it, as in speed = \"= {name}\", or remove the sweep")
            }
            Self::Ways { .. } => "write values = [0, 0.1, 0.2]".to_owned(),
        })
    }
}

/// Reads the table of a sweep under `key`; `Some(None)` without it.
pub(super) fn under(table: &Table<'_>, key: &Key<ByHand>) -> Option<Option<Sweep>> {
    if !table.has(key) {
        return Some(None);
    }
    let table = table.table(key)?;
    let found = read(&table);
    table.finish();
    found.map(Some)
}

/// Reads the parameter and its values from their keys in a table.
pub(super) fn read(table: &Table<'_>) -> Option<Sweep> {
    let parameter = table.get(&PARAMETER);
    let values = values(table, parameter.as_deref());
    let parameter = parameter?;
    let parameters = table.document().parameters().clone();
    if !parameters.iter().any(|own| own.0 == parameter) {
        let problem = SweepProblem::NoParameter {
            name: parameter,
            known: parameters.into_iter().map(|own| own.0).collect(),
        };
        table.note(&PARAMETER, &problem);
        return None;
    }
    if !table.document().uses_parameter(&parameter) {
        let name = parameter;
        table.note(&PARAMETER, &SweepProblem::Unused { name });
        return None;
    }
    Some(Sweep {
        parameter,
        values: values?,
    })
}

fn values(table: &Table<'_>, parameter: Option<&str>) -> Option<Vec<f64>> {
    let (values, steps) = (table.get(&VALUES), table.get(&STEPS));
    let (from, to) = (table.get(&FROM), table.get(&TO));
    let found = match (values?, from?, to?, steps?) {
        (Some(values), None, None, None) if !values.is_empty() => return Some(values),
        (None, Some(from), Some(to), Some(steps)) if steps > 1 => {
            let last = (steps - 1) as f64;
            let value = |k: usize| from + (to - from) * k as f64 / last;
            return Some((0..steps).map(value).collect());
        }
        (Some(_), None, None, None) => "an empty list",
        (Some(_), ..) => "\"values\" beside \"from\", \"to\" or \"steps\"",
        (None, Some(_), Some(_), Some(_)) => "\"from\", \"to\" and fewer than 2 \"steps\"",
        (None, None, None, None) => {
            let rows = parameter.map(|name| table.document().rows_over(name));
            match rows.filter(|rows| rows.len() > 1) {
                Some(rows) => return Some(rows),
                None => "nothing",
            }
        }
        _ => "only a part of \"from\", \"to\" and \"steps\"",
    };
    table.note("", &SweepProblem::Ways { found });
    None
}

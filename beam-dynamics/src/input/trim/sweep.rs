//! The sweep of a trim: `[trim.sweep]`.

use shared_geom::document::Table;

use super::keys::{FROM, PARAMETER, STEPS, SWEEP, TO, VALUES};
use super::problem::TrimProblem;
use crate::case::TrimSweep;

/// Reads the sweep; `Some(None)` without it.
pub(super) fn read(table: &Table<'_>) -> Option<Option<TrimSweep>> {
    if !table.has(&SWEEP) {
        return Some(None);
    }
    let table = table.table(&SWEEP)?;
    let parameter = table.get(&PARAMETER);
    let values = values(&table);
    table.finish();
    let parameter = parameter?;
    let parameters = table.document().parameters().clone();
    if !parameters.iter().any(|own| own.0 == parameter) {
        let problem = TrimProblem::NoParameter {
            name: parameter,
            known: parameters.into_iter().map(|own| own.0).collect(),
        };
        table.note(&PARAMETER, &problem);
        return None;
    }
    Some(Some(TrimSweep {
        parameter,
        values: values?,
    }))
}

fn values(table: &Table<'_>) -> Option<Vec<f64>> {
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
        (Some(_), ..) => "both ways",
        (None, Some(_), Some(_), Some(_)) => "fewer than 2 \"steps\"",
        (None, None, None, None) => "nothing",
        _ => "a part of \"from\", \"to\" and \"steps\"",
    };
    table.note("", &TrimProblem::Ways { found });
    None
}

//! The kinds of laws, each with its keys.

use std::sync::Arc;

use shared_geom::document::Table;
use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::expression::{Names, written};
use shared_geom::units::Dimension;

use super::Components;
use super::keys::{
    COEFFICIENT, COLUMNS, CUBIC, FILE, FIRST_STIFFNESS, INTERPOLATION, KIND, LIMIT, OUTSIDE,
    QUADRATIC, SECOND_STIFFNESS, SECTION, STIFFNESS, TIME, VISCOSITY,
};
use super::numbers::{each, each_positive, matrix, slope};
use super::problem::LawProblem;
use crate::elements::laws::{
    Between, Bilinear, Cubic, Curve, ExpressionLaw, Extrapolation, LawKind,
};
use crate::input::drives::from_file;

/// Whether the kind of a term is known; otherwise its keys are not checked.
pub(super) fn is_known(table: &Table<'_>) -> bool {
    table.has_choice(&SECTION, KIND[0])
}

/// The function of a term.
pub(super) fn read<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    match table.choice(&SECTION, KIND[0])? {
        "linear" => Some(LawKind::Linear {
            stiffness: matrix(table, STIFFNESS.name(), of, 0)?,
        }),
        "viscous" => Some(LawKind::Viscous {
            viscosity: matrix(table, VISCOSITY.name(), of, 1)?,
        }),
        "viscoelastic" => viscoelastic(table, of),
        "cubic" => cubic(table, of),
        "bilinear" => bilinear(table, of),
        "table" => curves(table, of),
        "expression" => expressions(table, of),
        _ => section(table, of),
    }
}

fn viscoelastic<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    let stiffness = matrix(table, STIFFNESS.name(), of, 0);
    let viscosity = match [table.has(&VISCOSITY), table.has(&TIME)] {
        [true, false] => matrix(table, VISCOSITY.name(), of, 1),
        [false, true] => {
            let time = table.get(&TIME).flatten();
            time.and_then(|time| Some(time * stiffness?))
        }
        _ => {
            table.note(KIND[0], &LawProblem::OneViscosity);
            None
        }
    };
    Some(LawKind::Viscoelastic {
        stiffness: stiffness?,
        viscosity: viscosity?,
    })
}

/// `force / strain^power` of each component.
fn slopes<const N: usize>(of: &Components<N>, power: i8) -> [Dimension; N] {
    std::array::from_fn(|i| slope(of.force[i], of.strain[i], power, 0))
}

fn cubic<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    let first = each(table, COEFFICIENT.name(), &slopes(of, 1));
    let second = each(table, QUADRATIC.name(), &slopes(of, 2));
    let third = each(table, CUBIC.name(), &slopes(of, 3));
    let mut keys = [&COEFFICIENT, &QUADRATIC, &CUBIC].into_iter();
    if !keys.any(|key| table.has(key)) {
        table.note(KIND[0], &LawProblem::NoCoefficient);
        return None;
    }
    let (first, second, third) = (first?, second?, third?);
    Some(LawKind::Cubic(std::array::from_fn(|i| Cubic {
        first: first[i],
        second: second[i],
        third: third[i],
    })))
}

fn bilinear<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    const KEYS: [&str; 3] = [
        FIRST_STIFFNESS.name(),
        SECOND_STIFFNESS.name(),
        LIMIT.name(),
    ];
    let first = each(table, KEYS[0], &slopes(of, 1));
    let second = each(table, KEYS[1], &slopes(of, 1));
    let limit = each_positive(table, KEYS[2], &of.strain);
    let missing = KEYS.into_iter().filter(|key| !table.has(key));
    let mut is_whole = true;
    for key in missing {
        is_whole = false;
        let _ = table.require_text(key, "a number, or one number per component");
    }
    let (first, second, limit) = (first?, second?, limit?);
    let of_component = |i: usize| Bilinear {
        first: first[i],
        second: second[i],
        limit: limit[i],
    };
    is_whole.then(|| LawKind::Bilinear(std::array::from_fn(of_component)))
}

/// Calls `user` with the table and key of each component under `key`: the key itself for
/// one component, and for several a table of them by name. `None` for omitted ones.
fn by_component<const N: usize, T>(
    table: &Table<'_>,
    key: &'static str,
    of: &Components<N>,
    user: impl Fn(&Table<'_>, &'static str, usize) -> Option<T>,
) -> Option<[Option<T>; N]> {
    if N == 1 {
        let only = user(table, key, 0)?;
        let mut only = Some(only);
        return Some(std::array::from_fn(|_| only.take()));
    }
    let inner = table.require_table(key, &format!("a table of {}", of.names.join(", ")))?;
    let mut is_sound = true;
    let found = std::array::from_fn(|i| {
        if !inner.has(of.names[i]) {
            return None;
        }
        let found = user(&inner, of.names[i], i);
        is_sound &= found.is_some();
        found
    });
    inner.finish();
    if found.iter().all(Option::is_none) && is_sound {
        let names = of.names.join(", ");
        table.note(key, &LawProblem::NoComponent { key, names });
        return None;
    }
    is_sound.then_some(found)
}

fn curves<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    let (between, extrapolation) = (table.get(&INTERPOLATION), table.get(&OUTSIDE));
    let points = by_component(table, "points", of, |table, key, i| {
        points(table, key, [of.strain[i], of.force[i]])
    });
    let between = [Between::Linear, Between::Spline][between?];
    let extrapolation = [
        Extrapolation::Extend,
        Extrapolation::Hold,
        Extrapolation::Error,
    ][extrapolation?];
    let has_rest = |[strain, _]: &[Vec<f64>; 2]| {
        let ends = [strain.first(), strain.last()];
        matches!(ends, [Some(first), Some(last)] if *first <= 0.0 && *last >= 0.0)
    };
    let points = points?;
    if extrapolation == Extrapolation::Error && !points.iter().flatten().all(has_rest) {
        table.note(&OUTSIDE, &LawProblem::NoRest);
        return None;
    }
    let curve =
        |[strain, force]: [Vec<f64>; 2]| Curve::new(&strain, &force, between, extrapolation);
    Some(LawKind::Table(points.map(|points| points.map(curve))))
}

/// Rows of a strain and a force, by increasing strain, in declared units: in the card, or
/// from a CSV file in a table with `file` and `columns`.
fn points(
    table: &Table<'_>,
    key: &'static str,
    dimensions: [Dimension; 2],
) -> Option<[Vec<f64>; 2]> {
    let expected = "rows [strain, force], at least two";
    if !table.has(key) {
        let _ = table.require_text(key, expected);
        return None;
    }
    if table.is_table(key) {
        return points_of_file(&table.table(key)?, dimensions);
    }
    let count = match table.row_count(key) {
        Some(count) if count >= 2 => count,
        _ => {
            table.wrong(key, expected);
            return None;
        }
    };
    let rows = table.rows(key, count, 2)?;
    if let Some(i) = (1..count).find(|&i| rows[i][0] <= rows[i - 1][0]) {
        let (before, found) = (rows[i - 1][0], rows[i][0]);
        table.note(key, &LawProblem::NotAscending { before, found });
        return None;
    }
    Some(in_units(table, &rows, dimensions))
}

/// Columns of rows in declared units, converted to SI units.
fn in_units<R: std::ops::Index<usize, Output = f64>>(
    table: &Table<'_>,
    rows: &[R],
    dimensions: [Dimension; 2],
) -> [Vec<f64>; 2] {
    let factors = dimensions.map(|dimension| table.document().factor(dimension));
    [0, 1].map(|k| rows.iter().map(|row| row[k] * factors[k]).collect())
}

fn points_of_file(table: &Table<'_>, dimensions: [Dimension; 2]) -> Option<[Vec<f64>; 2]> {
    let written = table.get(&FILE)?;
    let of = ["strains", "forces"];
    let found = from_file(table, (FILE.name(), written), &COLUMNS, of);
    table.finish();
    let (file, rows) = found?;
    let reported = |line: usize, problem: &LawProblem| {
        let problems = Diagnostics::one(SourceLocation::line(&file, line), problem);
        let _ = table.document().keep::<()>(Err(problems));
    };
    if rows.len() < 2 {
        let found = rows.len();
        reported(
            rows.first().map_or(1, |row| row.0),
            &LawProblem::FewPoints { found },
        );
        return None;
    }
    if let Some(pair) = rows.windows(2).find(|pair| pair[1].1[0] <= pair[0].1[0]) {
        let (before, found) = (pair[0].1[0], pair[1].1[0]);
        reported(pair[1].0, &LawProblem::NotAscending { before, found });
        return None;
    }
    let rows: Vec<_> = rows.iter().map(|row| row.1).collect();
    Some(in_units(table, &rows, dimensions))
}

fn expressions<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    let rates = of.names.map(|name| format!("{name}_rate"));
    let variables = of.names.iter().copied();
    let variables = variables
        .chain(rates.iter().map(String::as_str))
        .chain(["t"]);
    let variables: Vec<_> = variables.collect();
    let document = table.document();
    let constants = document.parameters();
    let names = Names {
        variables: &variables,
        constants: &constants,
    };
    let components = by_component(table, "force", of, |table, key, _| {
        let text = table.require_text(key, "an expression, in quotes")?;
        let text = written(&text).unwrap_or(&text);
        let found = document.expression(key, table.line_of(key), text, &names);
        found.map(Arc::new)
    });
    let unit = |dimension: Dimension| document.factor(dimension);
    Some(LawKind::Expression(ExpressionLaw {
        components: components?,
        strain_units: of.strain.map(unit).into(),
        force_units: of.force.map(unit).into(),
        time_unit: unit(Dimension::TIME),
    }))
}

fn section<const N: usize>(table: &Table<'_>, of: &Components<N>) -> Option<LawKind<N>> {
    let Some(stiffness) = of.section else {
        table.note(KIND[0], &LawProblem::NoSection);
        return None;
    };
    Some(LawKind::Linear { stiffness })
}

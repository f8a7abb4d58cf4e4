//! Version 1: `elastic_properties_mb.six_x_six`.

use nalgebra::Matrix6;

use super::super::problem::{ExchangeProblem, Problems};
use super::super::text::from_upper;
use super::assemble::{Matrices, Tables};
use super::fields::{self, required};
use crate::exchange::yaml::{Node, Value};

/// Numbers of an upper triangle.
const UPPER: usize = 21;

/// The tables of the blade of version 1.
pub(super) fn tables(root: &Node, problems: &mut Problems) -> Option<Tables> {
    let components = required(root, "the file", "components", problems)?;
    let blade = required(components, "components", "blade", problems)?;
    let properties = required(blade, "components.blade", "elastic_properties_mb", problems)?;
    let six = required(properties, "elastic_properties_mb", "six_x_six", problems)?;
    let line = six.entry("reference_axis");
    let line = line.or_else(|| blade.path(&["outer_shape_bem", "reference_axis"]));
    let axis = match line {
        Some(node) => fields::axis(node, problems),
        None => {
            required(six, "six_x_six", "reference_axis", problems);
            None
        }
    };
    let twist = required(six, "six_x_six", "twist", problems);
    let twist = twist.and_then(|node| fields::column(node, "twist", problems));
    let stiffness = matrices(six, "stiff_matrix", problems);
    let inertia = matrices(six, "inertia_matrix", problems);
    Some(Tables {
        version: 1,
        axis: axis?,
        twist: twist?,
        stiffness: stiffness?,
        inertia: inertia?,
        times: None,
        remarks: Vec::new(),
    })
}

fn matrices(six: &Node, key: &str, problems: &mut Problems) -> Option<Matrices> {
    let node = required(six, "six_x_six", key, problems)?;
    let grid = fields::grid(node, key, problems);
    let values = required(node, key, "values", problems)?;
    let Value::List(rows) = &values.value else {
        problems.push(
            values.line,
            &fields::not_a_list(values, &format!("values of {key}")),
        );
        return None;
    };
    let what = format!("a station of {key}");
    let rows = rows.iter().map(|row| triangle(row, &what, problems));
    // All are read, so that all problems are reported.
    let rows: Vec<_> = rows.collect();
    let matrices: Vec<_> = rows.into_iter().collect::<Option<_>>()?;
    let grid = grid?;
    fields::same_length(values.line, key, &grid, matrices.len(), problems)?;
    Some(Matrices { grid, matrices })
}

fn triangle(row: &Node, what: &str, problems: &mut Problems) -> Option<Matrix6<f64>> {
    let numbers = fields::numbers(row, what, problems)?;
    if numbers.len() != UPPER {
        let (what, found) = (format!("{what}, an upper triangle"), numbers.len());
        let problem = ExchangeProblem::Count {
            what,
            expected: UPPER,
            found,
            separator: "commas",
        };
        problems.push(row.line, &problem);
        return None;
    }
    Some(from_upper(&numbers))
}

//! What is written of critical loads: a table for people, and factors and shapes for
//! programs.

use std::path::Path;

use shared_geom::files::{OutputProblem, make_folder};

use super::Written;
use super::folder::Results;
use super::rows::{csv_text, number, numbers};
use super::text::RPM;
use crate::input::short_number;
use crate::result::{BucklingMode, BucklingResult};

const TEXT: &str = "buckling.txt";
const TABLE: &str = "buckling.csv";
const HEADING: &str = "mode,factor,node,x_m,y_m,z_m,displacement_x,displacement_y,\
    displacement_z,rotation_x,rotation_y,rotation_z";
/// Digits of the table for people.
const DIGITS: usize = 7;

/// What the table means.
pub const BUCKLING_CONVENTION: &str = "\
Conventions
  factor          of the proportional loads; negative where they must be turned round
  moves most      node of the largest displacement of the shape
  direction       of that displacement, axes of the model
";

/// Factors, what moves most, remarks; see [`BUCKLING_CONVENTION`].
pub fn buckling_text(result: &BucklingResult) -> String {
    let at_speed = match result.speed {
        0.0 => String::new(),
        speed => format!(" at {} rpm", short_number(speed * RPM, DIGITS)),
    };
    let mut text = format!("{}\n\nCritical loads{at_speed}\n\n", result.name);
    text.push_str("  mode          factor  moves most    direction\n");
    for (index, mode) in result.modes.iter().enumerate() {
        let (node, moved) = moves_most(mode);
        let label = result.nodes.get(node).map_or("", |node| &node.label);
        let direction = moved.map(|value| format!("{value:.3}")).join(", ");
        let factor = short_number(mode.factor, DIGITS);
        text.push_str(&format!(
            "  {:>4}  {factor:>14}  {label:<12}  ({direction})\n",
            index + 1
        ));
    }
    if !result.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        for remark in &result.remarks {
            text.push_str(&format!("  {remark}\n"));
        }
    }
    text
}

/// Number of the node that moves most, and its displacement.
fn moves_most(mode: &BucklingMode) -> (usize, [f64; 3]) {
    let moved = mode.displacements.iter().enumerate();
    let most = moved.max_by(|a, b| a.1.norm().total_cmp(&b.1.norm()));
    most.map_or((0, [0.0; 3]), |(node, moved)| (node, (*moved).into()))
}

/// A row a critical load and node: factor, undeformed place, and the shape.
pub fn buckling_csv(result: &BucklingResult) -> String {
    let rows = result.modes.iter().enumerate().flat_map(|(index, mode)| {
        result.nodes.iter().enumerate().map(move |(k, node)| {
            let mut row = vec![
                (index + 1).to_string(),
                number(mode.factor),
                node.label.clone(),
            ];
            row.extend(numbers(&node.position));
            row.extend(numbers(&mode.displacements[k]));
            row.extend(numbers(&mode.rotations[k]));
            row
        })
    });
    csv_text(HEADING, rows)
}

/// Writes `NAME.buckling.txt` and `NAME.buckling.csv` into `folder`, which is made when
/// it does not exist.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write_buckling(
    result: &BucklingResult,
    folder: &Path,
    name: &str,
) -> Result<Written, OutputProblem> {
    make_folder(folder)?;
    let mut results = Results::new(folder, name);
    results.remove([TEXT, TABLE]);
    let text = format!("{}\n{BUCKLING_CONVENTION}", buckling_text(result));
    results.text(TEXT, &text)?;
    results.text(TABLE, &buckling_csv(result))?;
    Ok(results.written)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn factors_and_shapes_are_told() {
        let text = buckling_text(&samples::column());
        assert!(text.contains("Critical loads"), "{text}");
        let table = buckling_csv(&samples::column());
        assert!(table.starts_with("mode,factor,node,"), "{table}");
        let nodes = samples::column().nodes.len();
        let modes = samples::column().modes.len();
        assert_eq!(table.lines().count(), 1 + nodes * modes);
    }
}

//! Critical loads as tables for people and for programs.

use crate::input::short_number;
use crate::output::rows::{csv_text, number, numbers};
use crate::output::text::{RPM, aligned};
use crate::result::{BucklingMode, BucklingResult};

/// Digits of factors.
const DIGITS: usize = 7;
const HEADING: &str = "mode,factor [-],node,x [m],y [m],z [m],displacement x [-],displacement y [-],\
    displacement z [-],rotation x [1/m],rotation y [1/m],rotation z [1/m]";

/// Meaning of the columns of the table.
pub const BUCKLING_CONVENTION: &str = "\
Convention
  factor      of the proportional loads at which the model buckles; negative if their sign
              must be reversed; constant loads and rotation act in full
  moves most  node of the largest displacement of the shape, which is scaled to one, and its
              direction in the axes of the model; (turns): no node is displaced, as in
              torsion, and the largest rotation is scaled to one, about the axes of the model
  residual    error of factor and shape in the equations, relative
";

/// Factors, node of the largest displacement, remarks; see [`BUCKLING_CONVENTION`].
pub fn buckling_text(result: &BucklingResult) -> String {
    let at_speed = match result.speed {
        0.0 => String::new(),
        speed => format!(" at {} rpm", short_number(speed * RPM, DIGITS)),
    };
    let mut text = format!("{}\n\nCritical loads{at_speed}\n\n", result.name);
    if result.modes.is_empty() {
        text.push_str("  none was found\n")
    } else {
        text.push_str(&aligned(&rows(result)))
    }
    if !result.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        for remark in &result.remarks {
            text.push_str(&format!("  {remark}\n"));
        }
    }
    text
}

fn rows(result: &BucklingResult) -> Vec<Vec<String>> {
    let cells = |cells: [&str; 7]| cells.map(str::to_owned).to_vec();
    let mut rows = vec![cells([
        "mode",
        "factor",
        "moves most",
        "along x",
        "y",
        "z",
        "residual",
    ])];
    for (index, mode) in result.modes.iter().enumerate() {
        let (node, moved) = moves_most(mode);
        let label = result.nodes.get(node).map_or("", |node| &node.label);
        let mut row = vec![(index + 1).to_string(), short_number(mode.factor, DIGITS)];
        row.push(if mode.is_rotation() {
            format!("{label} (turns)")
        } else {
            label.to_owned()
        });
        // Adding zero removes the sign of a negative zero.
        let rounded = moved.map(|value| (1e3 * value).round() / 1e3 + 0.0);
        row.extend(rounded.map(|value| format!("{value:.3}")));
        row.push(format!("{:.1e}", mode.residual));
        rows.push(row);
    }
    rows
}

/// Index of the node of the largest displacement, the first of equal ones, and this displacement;
/// if no node is displaced, the node of the largest rotation, and this rotation.
fn moves_most(mode: &BucklingMode) -> (usize, [f64; 3]) {
    let vectors = if mode.is_rotation() {
        &mode.rotations
    } else {
        &mode.displacements
    };
    let moved = vectors.iter().enumerate().rev();
    let most = moved.max_by(|a, b| a.1.norm().total_cmp(&b.1.norm()));
    most.map_or((0, [0.0; 3]), |(node, moved)| (node, (*moved).into()))
}

/// One row per critical load and node: factor, undeformed position, and the shape in the axes of
/// the model.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples;

    #[test]
    fn the_table_has_a_row_a_critical_load() {
        let mut result = samples::column();
        result.remarks.push("made up".to_owned());
        let expected = "\
column

Critical loads

mode   factor  moves most  along x      y      z  residual
1      2.4674          n8    0.000  0.000  1.000   1.0e-12
2     -9.8696          n8    0.000  1.000  0.000   1.0e-12
3     22.2066          n5    0.000  0.000  1.000   1.0e-12
4     39.4784          n5    0.000  1.000  0.000   1.0e-12

Remarks
  made up
";
        assert_eq!(buckling_text(&result), expected);
        assert!(BUCKLING_CONVENTION.lines().all(|line| line.len() <= 96));
        result.modes.clear();
        assert!(buckling_text(&result).contains("none was found"));
    }

    /// Torsion is shown as the rotation, since displacements are zero.
    #[test]
    fn a_shape_without_displacement_is_reported_by_its_rotation() {
        let mut result = samples::column();
        result.modes = vec![samples::torsion(&result.modes[0])];
        let text = buckling_text(&result);
        assert!(text.contains("n8 (turns)    1.000  0.000  0.000"), "{text}");
    }

    #[test]
    fn shapes_have_a_row_a_node() {
        let text = buckling_csv(&samples::column());
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines.len(), 1 + 4 * 10);
        assert_eq!(lines[0].split(',').count(), 12);
        assert_eq!(lines[9], "1,2.4674,n8,10,0,0,0,0,1,0,0,0");
    }
}

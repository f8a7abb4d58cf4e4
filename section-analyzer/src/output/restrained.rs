//! Restrained warping, in the report and as a table.

use super::text::{ZERO, coordinate, csv, number, table};
use crate::properties::{AreaTable, NoRestrainedWarping, RestrainedWarping};
use crate::solution::SectionSolution;

/// The part of the report, or the reason why it is not given. A warping that is round-off
/// compared with the area is shown as zero.
pub(super) fn restrained_warping(
    restrained: &Result<RestrainedWarping, NoRestrainedWarping>,
    solution: &SectionSolution,
    areas: &AreaTable,
) -> String {
    let warping = match restrained {
        Ok(warping) => warping,
        Err(reason) => {
            return format!("Restrained warping\n  not given: {reason}\n");
        }
    };
    let area = areas.total.area;
    // sqrt(E Gamma / E A) is the mean warping per unit twist
    let mean = (warping.stiffness / solution.stiffness[(0, 0)]).sqrt();
    let shown = |value: f64| number(if mean <= ZERO * area { 0.0 } else { value });
    let row = |name: &str, value: String, unit: &str, meaning: &str| {
        [name, &value, unit, meaning].map(str::to_owned).to_vec()
    };
    let [y, z] = warping.center.map(|value| coordinate(value, area.sqrt()));
    let mut rows = vec![
        row(
            "shear-flow center",
            format!("{y}, {z}"),
            "m",
            "(y, z): pole without resultants of the stress",
        ),
        row(
            "E Gamma",
            shown(warping.stiffness),
            "N m^4",
            "warping stiffness",
        ),
    ];
    if let Some(constant) = warping.constant {
        let constant = shown(constant);
        rows.push(row("Gamma", constant, "m^6", "Vlasov's warping constant"));
    }
    rows.push(row(
        "decay length",
        shown(warping.decay_length),
        "m",
        "sqrt(E Gamma / G J)",
    ));
    format!(
        "Restrained warping (Vlasov), for torsion with an end held plane\n{}",
        table(&rows, "lrll")
    )
}

/// Rows `quantity,value,unit` of the constants of restrained warping, as CSV.
pub fn constants_csv(warping: &RestrainedWarping) -> String {
    let [y, z] = warping.center;
    let mut columns = vec![
        ("shear_flow_center_y [m]", y),
        ("shear_flow_center_z [m]", z),
        ("warping_stiffness [N m^4]", warping.stiffness),
    ];
    let constant = warping.constant;
    columns.extend(constant.map(|gamma| ("warping_constant [m^6]", gamma)));
    columns.push(("torsional_stiffness [N m^2]", warping.torsional_stiffness));
    columns.push(("decay_length [m]", warping.decay_length));
    let names = columns.iter().map(|(name, _)| (*name).to_owned());
    let values = columns.iter().map(|(_, value)| format!("{value:e}"));
    csv([names.collect(), values.collect()])
}

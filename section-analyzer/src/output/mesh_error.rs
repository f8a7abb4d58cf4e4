//! Discretization error of the stiffness, as a file and in the report.

use serde_json::json;
use shared_geom::wrench::COMPONENTS;

use super::text::{ZERO, rows, table};
use crate::solution::{DiscretizationError, SectionSolution};

/// The estimate as JSON, in SI about the origin of the mesh; `input_hash` is the fingerprint
/// of the input.
pub fn mesh_error_json(
    name: &str,
    solution: &SectionSolution,
    error: &DiscretizationError,
    input_hash: &str,
) -> String {
    let stiffness = &solution.stiffness;
    let file = json!({
        "format": "helicoid section mesh error",
        "version": 1,
        "section": name,
        "program": format!("{} {}", env!("CARGO_PKG_NAME"), env!("CARGO_PKG_VERSION")),
        "input": input_hash,
        "units": "SI",
        "reference_point": [0.0, 0.0],
        "order": COMPONENTS,
        "unknowns": [solution.unknowns, error.unknowns],
        "stiffness": rows(stiffness),
        "error": rows(&error.stiffness),
        "relative_error": rows(&error.relative(stiffness)),
        "weak_coupling": DiscretizationError::WEAK,
    });
    // strings, numbers and lists always have a JSON form
    serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
}

/// The part of the report: relative errors, of weak couplings in parentheses.
pub fn mesh_error_table(solution: &SectionSolution, error: &DiscretizationError) -> String {
    let relative = error.relative(&solution.stiffness);
    let heading = std::iter::once("").chain(COMPONENTS).map(str::to_owned);
    let mut lines = vec![heading.collect::<Vec<_>>()];
    for i in 0..6 {
        let entries = (0..6).map(|j| {
            let value = match relative[(i, j)] {
                small if small <= ZERO => "0".to_owned(),
                value => format!("{value:.1e}"),
            };
            if DiscretizationError::is_of_entry(&solution.stiffness, (i, j)) {
                format!("{value} ")
            } else {
                format!("({value})")
            }
        });
        let name = std::iter::once(COMPONENTS[i].to_owned());
        lines.push(name.chain(entries).collect());
    }
    format!(
        "Discretization error of the stiffness, estimated by a second analysis with richer cells\n  \
         ({} unknowns, {:.1} times as many)\n\
         {}  (relative to the entry; in parentheses, for couplings up to {:e} of sqrt(Kii Kjj),\n  \
         relative to this root; without errors of straight sides for curved ones and of angles)\n",
        error.unknowns,
        error.unknowns as f64 / solution.unknowns as f64,
        table(&lines, "lr"),
        DiscretizationError::WEAK,
    )
}

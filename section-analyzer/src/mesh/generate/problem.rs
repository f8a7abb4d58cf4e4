//! What can be wrong with the measures of a generated mesh.

use shared_geom::error::Explain;

/// Cells of a generated mesh at most: some hundred bytes each, and far beyond
/// what a section needs.
pub(super) const MOST_CELLS: usize = 4_000_000;

/// A measure that gives no mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GenerateProblem {
    /// A length that is zero, negative or no finite number.
    #[error("{what}: expected a positive length, found {found}")]
    NotPositive {
        /// Name of the length.
        what: &'static str,
        /// Its value, in the unit of the mesh.
        found: f64,
    },
    /// A wall that leaves no hole.
    #[error(
        "thickness {thickness}: expected less than the outer radius {outer_radius}, \
         since nothing is left of the hole"
    )]
    NoHole {
        /// Thickness of the wall, in the unit of the mesh.
        thickness: f64,
        /// Outer radius, in the unit of the mesh.
        outer_radius: f64,
    },
    /// Too few cells in a direction.
    #[error("{what}: expected at least {least}, found {found}")]
    TooFewCells {
        /// Name of the number of cells.
        what: &'static str,
        /// The smallest number that gives a mesh.
        least: usize,
        /// The number found.
        found: usize,
    },
    /// More cells than can be of use.
    #[error("expected at most {MOST_CELLS} cells in all, found {}", cells(*.found))]
    TooManyCells {
        /// The number of cells found; `None` if it is beyond all numbers.
        found: Option<usize>,
    },
}

fn cells(count: Option<usize>) -> String {
    count.map_or("far more".into(), |count| count.to_string())
}

impl Explain for GenerateProblem {
    fn help(&self) -> Option<String> {
        let help = match self {
            Self::NoHole { .. } => {
                "a full disk is an ellipse with both semi-axes equal to the radius"
            }
            Self::TooManyCells { .. } => "quadratic cells reach the same accuracy with far fewer",
            _ => return None,
        };
        Some(help.into())
    }
}

/// Notes a length that is not positive and finite.
pub(super) fn check_length(what: &'static str, found: f64, problems: &mut Vec<GenerateProblem>) {
    if !(found > 0.0 && found.is_finite()) {
        problems.push(GenerateProblem::NotPositive { what, found });
    }
}

/// Notes a number of cells below `least`.
pub(super) fn check_cells(
    what: &'static str,
    found: usize,
    least: usize,
    problems: &mut Vec<GenerateProblem>,
) {
    if found < least {
        problems.push(GenerateProblem::TooFewCells { what, least, found });
    }
}

/// Notes a number of cells, the product of `factors`, beyond the limit.
pub(super) fn check_total(factors: &[usize], problems: &mut Vec<GenerateProblem>) {
    let found = factors
        .iter()
        .try_fold(1_usize, |product, &factor| product.checked_mul(factor));
    if found.is_none_or(|count| count > MOST_CELLS) {
        problems.push(GenerateProblem::TooManyCells { found });
    }
}

/// `Ok` when no problem was found.
pub(super) fn outcome(problems: Vec<GenerateProblem>) -> Result<(), Vec<GenerateProblem>> {
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}

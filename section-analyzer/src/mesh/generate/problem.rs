//! Problems of the dimensions of a generated mesh.

use shared_geom::error::Explain;

/// Largest number of cells of a generated mesh: some hundred bytes each, and far beyond
/// any need of a section.
pub(super) const MOST_CELLS: usize = 4_000_000;

/// Smallest and largest length, in the unit of the mesh: their fourth powers are numbers.
const LENGTHS: [f64; 2] = [1e-15, 1e15];

/// An invalid dimension.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum GenerateProblem {
    /// A length that is zero, negative or not finite.
    #[error("{what}: expected a positive length, found {found}")]
    NotPositive {
        /// Name of the length.
        what: &'static str,
        /// Its value, in the unit of the mesh.
        found: f64,
    },
    /// A length of no section.
    #[error("{what}: expected {:e} to {:e}, found {found:e}", LENGTHS[0], LENGTHS[1])]
    Extreme {
        /// Name of the length.
        what: &'static str,
        /// Its value, in the unit of the mesh.
        found: f64,
    },
    /// A wall that fills the hole.
    #[error(
        "thickness {thickness}: expected less than the outer radius {outer_radius}, since \
         otherwise the tube has no hole"
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
        /// The smallest valid number.
        least: usize,
        /// The number found.
        found: usize,
    },
    /// More cells than allowed.
    #[error("expected at most {MOST_CELLS} cells in all, found {}", cells(*.found))]
    TooManyCells {
        /// The number of cells found; `None` if it is beyond the range of integers.
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

/// Notes a length that is not positive and finite, or beyond the limits.
pub(super) fn check_length(what: &'static str, found: f64, problems: &mut Vec<GenerateProblem>) {
    if !(found > 0.0 && found.is_finite()) {
        problems.push(GenerateProblem::NotPositive { what, found });
    } else if !(LENGTHS[0]..=LENGTHS[1]).contains(&found) {
        problems.push(GenerateProblem::Extreme { what, found });
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

/// `Ok` if no problem was found.
pub(super) fn outcome(problems: Vec<GenerateProblem>) -> Result<(), Vec<GenerateProblem>> {
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}

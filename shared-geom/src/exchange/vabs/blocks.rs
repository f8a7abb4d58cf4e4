//! The titled blocks of an output, read.

use nalgebra::Matrix6;

use crate::error::Diagnostics;
use crate::exchange::problem::{ExchangeProblem, Problems};
use crate::exchange::stations::symmetric;
use crate::exchange::text::{Line, lines};

pub(super) const MASS: &str = "The 6X6 Mass Matrix";
pub(super) const STIFFNESS: &str = "Timoshenko Stiffness Matrix";

/// Whether `text` is an output of VABS.
pub fn recognize(text: &str) -> bool {
    text.lines()
        .any(|line| begins(line, MASS) || begins(line, STIFFNESS))
}

/// Whether a line is exactly the title, in upper or lower case.
fn begins(line: &str, title: &str) -> bool {
    let line = line.trim();
    let head = line.get(..title.len());
    head.is_some_and(|head| head.eq_ignore_ascii_case(title))
        && !line.to_lowercase().contains(" at the ")
        && !line.to_lowercase().contains(" at shear")
}

/// Stiffness and mass of the section of an output, shown as `file` in messages.
///
/// # Errors
/// All errors of the text.
pub fn section(text: &str, file: &str) -> Result<(Matrix6<f64>, Matrix6<f64>), Diagnostics> {
    let mut problems = Problems::new(file);
    let lines = lines(text);
    let stiffness = block(&lines, STIFFNESS, &mut problems);
    let mass = block(&lines, MASS, &mut problems);
    problems.finish(stiffness.zip(mass))
}

/// The matrix below a title.
fn block(lines: &[Line<'_>], title: &str, problems: &mut Problems) -> Option<Matrix6<f64>> {
    let Some(at) = lines.iter().position(|line| begins(line.text, title)) else {
        problems.push(
            0,
            &ExchangeProblem::Missing {
                what: format!("the block \"{title}\""),
                help: "run VABS with the Timoshenko model switched on (timoshenko flag 1)"
                    .to_owned(),
            },
        );
        return None;
    };
    let body = lines.get(at + 1..).unwrap_or_default();
    let ruled = body
        .iter()
        .take_while(|line| line.text.starts_with('='))
        .count();
    let mut rows = Vec::with_capacity(6);
    for i in 0..6 {
        let Some(line) = body.get(ruled + i) else {
            let problem = ExchangeProblem::CutShort {
                what: format!("the block \"{title}\", after {i} of 6 rows"),
                expected: "rows of six numbers".to_owned(),
            };
            problems.push(lines.last().map_or(0, |line| line.number), &problem);
            return None;
        };
        rows.push(line.numbers::<6>(&format!("{title}, row {}", i + 1), problems));
    }
    let rows: Vec<[f64; 6]> = rows.into_iter().collect::<Option<_>>()?;
    let matrix = Matrix6::from_fn(|i, j| rows[i][j]);
    Some(symmetric(&matrix, title, lines[at].number, problems))
}

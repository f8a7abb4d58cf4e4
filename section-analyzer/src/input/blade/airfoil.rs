//! Files of airfoil coordinates.
//!
//! Rows of x/c and z/c from the trailing edge over the upper surface to the nose and back
//! over the lower one; a first line of text is the title. Columns may have names (`x`,
//! and `z` or `y`), separated by blanks or commas. A first row of two whole numbers above
//! one announces the other common form: both surfaces from the nose on, the upper first.

use shared_geom::error::{Diagnostics, SourceLocation};

use super::BladeFileProblem;

/// Number of bad rows that are reported one by one.
const MOST_REPORTED: usize = 5;

/// The points of a file, in the order of the contour.
///
/// # Errors
/// All problems of its rows.
pub(in crate::input) fn parse(text: &str, file: &str) -> Result<Vec<[f64; 2]>, Diagnostics> {
    let mut problems = Diagnostics::new();
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut columns = [0, 1];
    let mut is_first = true;
    let mut reported = 0;
    for (index, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default().trim();
        if line.is_empty() {
            continue;
        }
        let words: Vec<&str> = line
            .split(|letter: char| letter.is_whitespace() || letter == ',' || letter == ';')
            .filter(|word| !word.is_empty())
            .collect();
        match row(&words, columns) {
            Some(point) => points.push(point),
            None if is_first || points.is_empty() => match heading(&words) {
                Some(Some(found)) => columns = found,
                Some(None) => {
                    let found = line.to_owned();
                    let location = SourceLocation::line(file, index + 1);
                    problems.push(location, &BladeFileProblem::Heading { found });
                }
                None if is_first => {}
                None => reported += report(&mut problems, file, index, line, reported),
            },
            None => reported += report(&mut problems, file, index, line, reported),
        }
        is_first = false;
    }
    if problems.is_empty() {
        match ordered(points) {
            Ok(points) => return Ok(points),
            Err(problem) => problems.push(SourceLocation::file(file), &problem),
        }
    }
    problems.into_result(Vec::new())
}

fn report(
    problems: &mut Diagnostics,
    file: &str,
    index: usize,
    line: &str,
    reported: usize,
) -> usize {
    if reported < MOST_REPORTED {
        let found = line.chars().take(60).collect();
        problems.push(
            SourceLocation::line(file, index + 1),
            &BladeFileProblem::Row { found },
        );
    }
    1
}

fn row(words: &[&str], columns: [usize; 2]) -> Option<[f64; 2]> {
    let number = |column: usize| -> Option<f64> {
        let number: f64 = words.get(column)?.parse().ok()?;
        number.is_finite().then_some(number)
    };
    if columns == [0, 1] && words.len() != 2 {
        return None;
    }
    Some([number(columns[0])?, number(columns[1])?])
}

/// The columns of x and z, if the words are names of columns; `Some(None)` if one of the
/// two is missing.
fn heading(words: &[&str]) -> Option<Option<[usize; 2]>> {
    let at = |names: &[&str]| {
        let is_one = |word: &&str| names.contains(&word.to_lowercase().as_str());
        words.iter().position(is_one)
    };
    let x = at(&["x", "x/c"]);
    let z = at(&["z", "z/c"]).or(at(&["y", "y/c"]));
    match (x, z) {
        // a title of one word
        _ if words.len() < 2 => None,
        (None, None) => None,
        (Some(x), Some(z)) => Some(Some([x, z])),
        _ => Some(None),
    }
}

/// Points in the order of the contour.
fn ordered(points: Vec<[f64; 2]>) -> Result<Vec<[f64; 2]>, BladeFileProblem> {
    let Some(&[upper, lower]) = points.first() else {
        return Err(BladeFileProblem::NoPoints);
    };
    let is_count = |number: f64| number > 1.5 && number.fract() == 0.0 && number < 1e6;
    if !(is_count(upper) && is_count(lower)) {
        return Ok(points);
    }
    let (upper, lower) = (upper as usize, lower as usize);
    let points = &points[1..];
    if points.len() != upper + lower {
        return Err(BladeFileProblem::Announced {
            upper,
            lower,
            found: points.len(),
        });
    }
    let mut turned: Vec<[f64; 2]> = points[..upper].iter().rev().copied().collect();
    let mut rest = &points[upper..];
    if rest.first() == turned.last() {
        rest = &rest[1..];
    }
    turned.extend(rest);
    Ok(turned)
}

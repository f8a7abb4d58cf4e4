//! Matrices in the Matrix Market format: coordinate and array, real and integer,
//! general, symmetric and skew-symmetric.
//!
//! ```text
//! %%MatrixMarket matrix coordinate real general
//! % comments
//! rows columns entries
//! row column value            one line per entry, counted from one
//! ```
//!
//! Exponents may be in Fortran notation, `1.0D+05`. An array lists all values column by
//! column; a symmetric one its lower triangle. The reader of the crate sprs has no line
//! numbers and no arrays, and does not detect the end of a file that stops after its
//! heading.
//!
//! # References
//! - R. F. Boisvert, R. Pozo, K. A. Remington, *The Matrix Market exchange formats:
//!   initial design*, NISTIR 5935, 1996.

use shared_geom::error::{Diagnostics, SourceLocation};
use sprs::{CsMat, TriMat};

use super::problem::MatrixProblem;

/// Number of problems of one file that are reported one by one.
const SHOWN: usize = 10;

/// Largest number of rows and columns: far beyond any section.
const LARGEST: usize = 100_000_000;

/// Relation of the entries below the diagonal to the entries above.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Symmetry {
    General,
    Symmetric,
    Skew,
}

/// The matrix in `text`, the content of `file`; duplicate entries are added.
///
/// # Errors
/// All wrong lines, the first ones in full.
pub(super) fn parse(text: &str, file: &str) -> Result<CsMat<f64>, Diagnostics> {
    let mut problems = Diagnostics::new();
    let mut lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
    let heading = lines.next().map_or("", |(_, line)| line);
    let Some((is_array, symmetry)) = heading_of(heading) else {
        let found = shortened(heading);
        return Err(Diagnostics::one(
            SourceLocation::line(file, 1),
            &MatrixProblem::Heading { found },
        ));
    };
    let mut lines = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('%'));
    let sizes = lines.next();
    let expected = if is_array { 2 } else { 3 };
    let Some([rows, columns, entries]) = sizes.and_then(|(_, line)| sizes_of(line, expected))
    else {
        let (line, found) = sizes.map_or((1, String::new()), |(at, line)| (at, shortened(line)));
        let problem = MatrixProblem::Sizes { found, expected };
        return Err(Diagnostics::one(SourceLocation::line(file, line), &problem));
    };
    let mut reader = Reader {
        rows,
        columns,
        symmetry,
        triangle: None,
        matrix: TriMat::new((rows, columns)),
    };
    let mut position = reader.first();
    let (mut count, mut wrong, mut last) = (0, 0, 1);
    for (line, text) in lines {
        let read = if is_array {
            reader.value(text, &mut position)
        } else {
            reader.entry(text)
        };
        if let Err(problem) = read {
            wrong += 1;
            if wrong <= SHOWN {
                problems.push(SourceLocation::line(file, line), &problem);
            }
        }
        (count, last) = (count + 1, line);
    }
    if wrong > SHOWN {
        let count = wrong - SHOWN;
        problems.push(
            SourceLocation::line(file, last),
            &MatrixProblem::More { count },
        );
    }
    let expected = if is_array { reader.values() } else { entries };
    if count != expected {
        let problem = MatrixProblem::Count {
            found: count,
            expected,
        };
        problems.push(SourceLocation::line(file, last), &problem);
    }
    problems.into_result(reader.matrix.to_csr())
}

/// Whether it is an array, and its symmetry.
fn heading_of(line: &str) -> Option<(bool, Symmetry)> {
    let line = line.to_lowercase();
    let words: Vec<_> = line.split_whitespace().collect();
    let [magic, "matrix", form, "real" | "integer", symmetry] = words[..] else {
        return None;
    };
    let is_array = match form {
        "array" => true,
        "coordinate" => false,
        _ => return None,
    };
    let symmetry = match symmetry {
        "general" => Symmetry::General,
        "symmetric" => Symmetry::Symmetric,
        "skew-symmetric" => Symmetry::Skew,
        _ => return None,
    };
    (magic == "%%matrixmarket").then_some((is_array, symmetry))
}

/// Rows, columns and entries; an array has no third number.
fn sizes_of(line: &str, expected: usize) -> Option<[usize; 3]> {
    let numbers: Option<Vec<usize>> = line
        .split_whitespace()
        .map(|word| word.parse().ok())
        .collect();
    let numbers = numbers.filter(|numbers| numbers.len() == expected)?;
    let entries = numbers.get(2).copied().unwrap_or(0);
    let fits = |n: usize| (1..=LARGEST).contains(&n);
    (fits(numbers[0]) && fits(numbers[1])).then_some([numbers[0], numbers[1], entries])
}

struct Reader {
    rows: usize,
    columns: usize,
    symmetry: Symmetry,
    /// Whether the entries of a symmetric matrix are below the diagonal, from its first
    /// such entry.
    triangle: Option<bool>,
    matrix: TriMat<f64>,
}

impl Reader {
    /// Index of the first value of an array.
    fn first(&self) -> [usize; 2] {
        [usize::from(self.symmetry == Symmetry::Skew), 0]
    }

    /// Number of values of an array.
    fn values(&self) -> usize {
        let (n, product) = (self.rows, self.rows.saturating_mul(self.columns));
        match self.symmetry {
            Symmetry::General => product,
            Symmetry::Symmetric => product.saturating_add(n) / 2,
            Symmetry::Skew => product.saturating_sub(n) / 2,
        }
    }

    /// Reads `row column value`.
    fn entry(&mut self, text: &str) -> Result<(), MatrixProblem> {
        let wrong = || MatrixProblem::Entry {
            found: shortened(text),
        };
        let words: Vec<_> = text.split_whitespace().collect();
        let [row, column, value] = words[..] else {
            return Err(wrong());
        };
        let index = |word: &str| word.parse::<usize>().map_err(|_| wrong());
        let (row, column) = (index(row)?, index(column)?);
        let value = number(value).ok_or_else(wrong)?;
        let inside = (1..=self.rows).contains(&row) && (1..=self.columns).contains(&column);
        if !inside {
            return Err(MatrixProblem::Index {
                row,
                column,
                rows: self.rows,
                columns: self.columns,
            });
        }
        let is_below = row > column;
        if self.symmetry != Symmetry::General
            && row != column
            && *self.triangle.get_or_insert(is_below) != is_below
        {
            return Err(MatrixProblem::BothTriangles { row, column });
        }
        self.add([row - 1, column - 1], value);
        Ok(())
    }

    /// Reads the value at `index` and advances to the next index.
    fn value(&mut self, text: &str, index: &mut [usize; 2]) -> Result<(), MatrixProblem> {
        let value = number(text.trim()).ok_or_else(|| MatrixProblem::Value {
            found: shortened(text),
        })?;
        // values beyond the last are counted and reported as surplus
        if index[0] < self.rows && index[1] < self.columns {
            self.add(*index, value);
        }
        index[0] += 1;
        if index[0] >= self.rows {
            let next = index[1] + 1;
            let first = match self.symmetry {
                Symmetry::General => 0,
                Symmetry::Symmetric => next,
                Symmetry::Skew => next + 1,
            };
            *index = [first, next];
        }
        Ok(())
    }

    fn add(&mut self, [row, column]: [usize; 2], value: f64) {
        self.matrix.add_triplet(row, column, value);
        let mirrored = match self.symmetry {
            Symmetry::Symmetric => value,
            Symmetry::Skew => -value,
            Symmetry::General => return,
        };
        if row != column && row < self.columns && column < self.rows {
            self.matrix.add_triplet(column, row, mirrored);
        }
    }
}

/// A finite number; its exponent may have the D of Fortran.
fn number(word: &str) -> Option<f64> {
    let value: f64 = match word.parse() {
        Ok(value) => value,
        Err(_) => word.replace(['d', 'D'], "e").parse().ok()?,
    };
    value.is_finite().then_some(value)
}

/// Excerpt of a line for a message.
fn shortened(line: &str) -> String {
    let line = line.trim();
    match line.char_indices().nth(60) {
        Some((at, _)) => format!("{} ...", &line[..at]),
        None => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dense(text: &str) -> Vec<Vec<f64>> {
        let matrix = parse(text, "m.mtx").unwrap_or_else(|problems| panic!("{problems}"));
        let entry = |i, j| matrix.get(i, j).copied().unwrap_or(0.0);
        let row = |i| (0..matrix.cols()).map(|j| entry(i, j)).collect();
        (0..matrix.rows()).map(row).collect()
    }

    #[test]
    fn all_forms_are_read() {
        let text = "%%MatrixMarket matrix coordinate real general\n% a comment\n\n2 3 3\n1 1 1.5\n2 3 -2e1\n2 3 1\n";
        assert_eq!(dense(text), [[1.5, 0.0, 0.0], [0.0, 0.0, -19.0]]);
        let text = "%%MatrixMarket matrix coordinate integer symmetric\n2 2 2\n1 1 3\n2 1 4\n";
        assert_eq!(dense(text), [[3.0, 4.0], [4.0, 0.0]]);
        let text = "%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n";
        assert_eq!(dense(text), [[1.0, 3.0], [2.0, 4.0]]);
        let text = "%%MatrixMarket matrix array real symmetric\n2 2\n1\n2\n4\n";
        assert_eq!(dense(text), [[1.0, 2.0], [2.0, 4.0]]);
        let text = "%%MatrixMarket matrix array real skew-symmetric\n3 3\n1\n2\n3\n";
        let skew = [[0.0, -1.0, -2.0], [1.0, 0.0, -3.0], [2.0, 3.0, 0.0]];
        assert_eq!(dense(text), skew);
    }

    #[test]
    fn exponents_of_fortran_are_read() {
        let text = "%%MatrixMarket matrix array real general\n2 1\n1.5D+02\n-2d-1\n";
        assert_eq!(dense(text), [[150.0], [-0.2]]);
    }

    fn refused(text: &str) -> String {
        parse(text, "m.mtx").expect_err(text).to_string()
    }

    #[test]
    fn files_that_count_from_zero() {
        let entries: String = (0..20).map(|i| format!("{i} 0 1.0\n")).collect();
        let head = "%%MatrixMarket matrix coordinate real general\n20 20 20\n";
        let reported = refused(&format!("{head}{entries}"));
        assert_eq!(
            reported.matches("an entry at row").count(),
            SHOWN,
            "{reported}"
        );
        assert!(
            reported.contains("rows and columns count from one"),
            "{reported}"
        );
        assert!(
            reported.contains("m.mtx:22: and 10 more lines are wrong"),
            "{reported}"
        );
    }

    #[test]
    fn symmetric_files_list_one_triangle() {
        let head = "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n";
        let reported = refused(&format!("{head}1 1 1.0\n2 1 2.0\n1 2 2.0\n"));
        assert!(
            reported.contains("m.mtx:5: an entry at row 1, column 2"),
            "{reported}"
        );
        let upper = dense(&format!("{head}1 1 1.0\n1 2 2.0\n2 2 1.0\n"));
        assert_eq!(upper, [[1.0, 2.0], [2.0, 1.0]]);
    }

    #[test]
    fn sizes_have_a_range() {
        for sizes in ["0 0 0", "99999999999 99999999999 1"] {
            let head = "%%MatrixMarket matrix coordinate real general\n";
            let reported = refused(&format!("{head}{sizes}\n"));
            assert!(reported.contains("from 1 to 100000000"), "{reported}");
        }
    }

    #[test]
    fn every_wrong_line_is_reported() {
        let head = "%%MatrixMarket matrix coordinate real general\n";
        for (text, words) in [
            ("", "m.mtx:1"),
            ("1 2 3\n", "%%MatrixMarket"),
            (
                "%%MatrixMarket matrix coordinate complex general\n1 1 0\n",
                "real",
            ),
            (head, "three whole numbers"),
            (
                "%%MatrixMarket matrix array real general\n1 1 1\n",
                "two whole numbers",
            ),
        ] {
            let problems = parse(text, "m.mtx").expect_err(text).to_string();
            assert!(problems.contains(words), "{text}: {problems}");
        }
        let text = format!("{head}2 2 4\n3 1 1.0\n0 1 1.0\n1 1 x\n1 1\n");
        let problems = parse(&text, "m.mtx").expect_err("wrong").to_string();
        for words in ["m.mtx:3", "m.mtx:4", "m.mtx:5", "m.mtx:6", "2 x 2"] {
            assert!(problems.contains(words), "{words}: {problems}");
        }
        let text = format!("{head}2 2 5\n1 1 1.0\n");
        let problems = parse(&text, "m.mtx").expect_err("short").to_string();
        assert!(
            problems.contains("1 entry") || problems.contains('5'),
            "{problems}"
        );
    }
}

//! Lines of a text file with their numbers, and numbers written with all their digits.

use nalgebra::Matrix6;

use super::problem::{ExchangeProblem, Problems};
use crate::error::shortened;

/// A line that is not blank.
#[derive(Debug, Clone, Copy)]
pub struct Line<'a> {
    /// Counted from one.
    pub number: usize,
    /// Without the blanks around it.
    pub text: &'a str,
}

impl<'a> Line<'a> {
    /// Its words.
    pub fn words(&self) -> impl Iterator<Item = &'a str> {
        self.text.split_whitespace()
    }

    /// Its first word.
    pub fn first(&self) -> &'a str {
        self.words().next().unwrap_or_default()
    }

    /// Exactly `N` numbers separated by blanks or commas; notes problems.
    pub fn numbers<const N: usize>(&self, what: &str, problems: &mut Problems) -> Option<[f64; N]> {
        let list = self.list(what, Some(N), problems)?;
        list.try_into().ok()
    }

    /// The numbers of the line, `expected` of them if given; notes problems.
    pub fn list(
        &self,
        what: &str,
        expected: Option<usize>,
        problems: &mut Problems,
    ) -> Option<Vec<f64>> {
        let separator = |letter: char| letter == ',' || letter.is_whitespace();
        let words = self.text.split(separator).filter(|word| !word.is_empty());
        let words: Vec<_> = words.collect();
        if let Some(expected) = expected.filter(|&expected| expected != words.len()) {
            let (what, found) = (what.to_owned(), words.len());
            let separator = if self.text.contains(',') {
                "commas"
            } else {
                "blanks"
            };
            problems.push(
                self.number,
                &ExchangeProblem::Count {
                    what,
                    expected,
                    found,
                    separator,
                },
            );
            return None;
        }
        let numbers = words.into_iter().map(|word| {
            let value = number(word);
            if value.is_none() {
                problems.push(self.number, &not_a_number(what, word));
            }
            value
        });
        // All words are read, so that all problems are reported.
        let numbers: Vec<_> = numbers.collect();
        numbers.into_iter().collect()
    }
}

/// The problem that `word` is not a number.
pub fn not_a_number(what: &str, word: &str) -> ExchangeProblem {
    ExchangeProblem::NotANumber {
        what: what.to_owned(),
        found: shortened(word),
    }
}

/// The lines of `text` that are not blank.
pub fn lines(text: &str) -> Vec<Line<'_>> {
    let all = text.lines().enumerate().map(|(i, text)| Line {
        number: i + 1,
        text: text.trim(),
    });
    all.filter(|line| !line.text.is_empty()).collect()
}

/// A finite number, also with the exponent letter `d` of Fortran.
pub fn number(word: &str) -> Option<f64> {
    let plain = word.replace(['d', 'D'], "e");
    let value: f64 = plain.parse().ok()?;
    value.is_finite().then_some(value)
}

/// A number with 17 significant digits, in a field of equal width.
pub fn digits(value: f64) -> String {
    format!("{value:24.16e}")
}

/// The lines of a 6x6 matrix.
pub fn matrix_lines(matrix: &Matrix6<f64>) -> String {
    let row = |i: usize| {
        let entries = (0..6).map(|j| digits(matrix[(i, j)]));
        entries.collect::<Vec<_>>().join(" ") + "\n"
    };
    (0..6).map(row).collect()
}

/// The matrix whose upper triangle is `upper`, row by row.
pub fn from_upper(upper: &[f64]) -> Matrix6<f64> {
    let mut matrix = Matrix6::zeros();
    let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    for ((i, j), &value) in pairs.zip(upper) {
        matrix[(i, j)] = value;
        matrix[(j, i)] = value;
    }
    matrix
}

/// The upper triangle of `matrix`, row by row.
pub fn upper(matrix: &Matrix6<f64>) -> [f64; 21] {
    let mut values = [0.0; 21];
    let pairs = (0..6).flat_map(|i| (i..6).map(move |j| (i, j)));
    for (value, pair) in values.iter_mut().zip(pairs) {
        *value = matrix[pair];
    }
    values
}

//! Comparisons of a case with a source: each is recorded for the book, and has a tolerance.

use crate::record;

/// A source and a case that is compared with it.
pub struct Compared<'a> {
    /// Document or program.
    pub source: &'a str,
    /// Name of the case.
    pub case: &'a str,
}

impl Compared<'_> {
    /// A number, relative to the expected one.
    pub fn relative(&self, quantity: &str, numbers: [f64; 2], tolerance: f64) {
        let error = (numbers[0] / numbers[1] - 1.0).abs();
        self.number(quantity, numbers, error, tolerance);
    }

    /// A number, by its difference from the expected one.
    pub fn absolute(&self, quantity: &str, numbers: [f64; 2], tolerance: f64) {
        let error = (numbers[0] - numbers[1]).abs();
        self.number(quantity, numbers, error, tolerance);
    }

    fn number(&self, quantity: &str, numbers: [f64; 2], error: f64, tolerance: f64) {
        record::value(self.source, self.case, quantity, numbers, error, tolerance);
        let case = self.case;
        assert!(error < tolerance, "{case}, {quantity}: {numbers:?}");
    }

    /// The largest error of many numbers.
    pub fn largest(&self, quantity: &str, errors: impl IntoIterator<Item = f64>, tolerance: f64) {
        let size = |error: f64| {
            if error.is_nan() {
                f64::INFINITY
            } else {
                error.abs()
            }
        };
        let error = errors.into_iter().map(size).fold(0.0, f64::max);
        record::largest(self.source, self.case, quantity, error, tolerance);
        let case = self.case;
        assert!(error < tolerance, "{case}, {quantity}: {error:e}");
    }
}

//! The table of ratios, and the ratios beyond their limits.

/// A ratio within this run, and its limit.
pub struct Row {
    pub name: String,
    /// The ratio, and the largest that passes [-].
    pub ratio: f64,
    pub limit: f64,
    /// Meaning of the ratio, as text.
    pub meaning: &'static str,
    /// Time on this machine, as text.
    pub time: String,
    /// Accuracy of the result to which the time belongs, as text.
    pub accuracy: String,
}

impl Row {
    fn is_within(&self) -> bool {
        self.ratio <= self.limit
    }
}

pub fn print(rows: &[Row]) {
    println!(
        "{:<34} {:>6} {:>5}  {:<33} {:<33} accuracy",
        "case", "ratio", "limit", "of", "processor time"
    );
    for row in rows {
        println!(
            "{:<34} {:>6.3} {:>5}  {:<33} {:<33} {}",
            row.name, row.ratio, row.limit, row.meaning, row.time, row.accuracy
        );
    }
}

/// Rows beyond their limits, as text.
pub fn breaches(rows: &[Row]) -> Vec<String> {
    let beyond = rows.iter().filter(|row| !row.is_within());
    let words = |row: &Row| {
        format!(
            "{}: {:.3} is beyond its limit of {}",
            row.name, row.ratio, row.limit
        )
    };
    beyond.map(words).collect()
}

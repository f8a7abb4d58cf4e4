//! Files and random numbers for the tests of the readers.

use std::path::{Path, PathBuf};

/// The path of a reference file.
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/reference")
        .join(name)
}

/// The text of a reference file.
pub fn text(name: &str) -> String {
    std::fs::read_to_string(path(name)).expect("a reference file")
}

/// The numbers of the lines of a reference file that have only numbers, separated by commas.
pub fn rows(name: &str) -> Vec<Vec<f64>> {
    let all = text(name);
    let lines = all.lines().map(|line| {
        line.split(',')
            .map(str::parse)
            .collect::<Result<Vec<f64>, _>>()
    });
    lines.filter_map(Result::ok).collect()
}

/// Random numbers from a fixed seed (the multiplier of Knuth's MMIX generator).
pub struct Random(pub u64);

impl Random {
    /// A number from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        ((self.unit() * end as f64) as usize).min(end.saturating_sub(1))
    }
}

/// A text with a few random faults: cut, changed, doubled, exchanged or deleted lines and letters.
pub fn mutated(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    for _ in 0..=random.below(3) {
        text = one_fault(&text, random);
    }
    text
}

fn one_fault(text: &str, random: &mut Random) -> String {
    const LETTERS: [char; 16] = [
        '-', '.', '0', '9', 'e', ' ', '\t', ',', '\n', '!', '"', ':', '[', 'N', '\0', '\u{fffd}',
    ];
    let mut lines: Vec<&str> = text.lines().collect();
    let line = random.below(lines.len().max(1));
    let letters: Vec<char> = text.chars().collect();
    let at = random.below(letters.len().max(1));
    match random.below(7) {
        0 => letters[..at].iter().collect(),
        1 | 2 if !letters.is_empty() => {
            let mut letters = letters;
            letters[at] = LETTERS[random.below(LETTERS.len())];
            letters.into_iter().collect()
        }
        3 if !lines.is_empty() => {
            lines.insert(line, lines[line]);
            lines.join("\n")
        }
        4 if !lines.is_empty() => {
            lines.remove(line);
            lines.join("\n")
        }
        5 if !lines.is_empty() => {
            let other = random.below(lines.len());
            lines.swap(line, other);
            lines.join("\r\n")
        }
        _ => text.replacen(['1', '2'], "99999999999", 1 + random.below(3)),
    }
}

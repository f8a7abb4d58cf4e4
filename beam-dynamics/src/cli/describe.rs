//! `describe`: the contents of blade files.

use std::path::{Path, PathBuf};

use shared_geom::exchange;

use crate::output::blade_text;

use super::reading_options::ReadingOptions;
use super::{DONE, Terminal, WRONG_INPUT, files};

/// The name of our own frame.
const OURS: &str = "helicoid";

/// Describes all files, even if some are wrong; reports those that cannot be read.
pub(super) fn describe_files(
    paths: &[PathBuf],
    options: ReadingOptions,
    terminal: &mut Terminal<'_>,
) -> u8 {
    files::worst_of(paths, terminal, |file, terminal| {
        describe(file, options, terminal)
    })
}

fn describe(file: &Path, options: ReadingOptions, terminal: &mut Terminal<'_>) -> u8 {
    let alone = options.length.is_none() && exchange::is_section(file);
    match options.read(file, alone.then_some(1.0)) {
        Ok((format, mut reading)) => {
            if alone {
                let note =
                    "one section: a blade of it needs --length METERS; described as 1 m of it";
                reading.remarks.insert(0, note.to_owned());
            }
            if let Some(frame) = reading.frame.as_ref().filter(|frame| *frame != OURS) {
                let note = format!("the file declares a frame of its own: {frame}");
                reading.remarks.insert(0, note);
            }
            let text = blade_text(&file.display().to_string(), format, &reading);
            terminal.show(&without_signs_of_zero(&text));
            DONE
        }
        Err(problems) => {
            terminal.report_text(&problems.to_string());
            WRONG_INPUT
        }
    }
}

/// `text` without minus signs of zeros: numbers of a few digits round to `-0.0000`. In a
/// column of a table a blank replaces the sign.
fn without_signs_of_zero(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("-0.0") {
        let (before, number) = rest.split_at(at);
        out.push_str(before);
        let digits = number[1..].find(|letter: char| !(letter.is_ascii_digit() || letter == '.'));
        let end = digits.map_or(number.len(), |digits| digits + 1);
        let (word, behind) = number.split_at(end);
        let is_zero = word[1..].chars().all(|letter| "0.".contains(letter));
        let begins = !out.ends_with(|letter: char| letter.is_ascii_alphanumeric());
        match is_zero && begins && !behind.starts_with('e') {
            true if out.ends_with("  ") => {
                out.push(' ');
                out.push_str(&word[1..]);
            }
            true => out.push_str(&word[1..]),
            false => out.push_str(word),
        }
        rest = behind;
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_lose_their_sign_and_other_numbers_keep_it() {
        for (text, expected) in [
            ("(1.2, -0.0000, -0.1)", "(1.2, 0.0000, -0.1)"),
            ("y [m]  -0.00000  2", "y [m]   0.00000  2"),
            ("-0.0001 and -0.0e-3", "-0.0001 and -0.0e-3"),
            ("1e-0.0", "1e-0.0"),
        ] {
            assert_eq!(without_signs_of_zero(text), expected);
        }
    }
}

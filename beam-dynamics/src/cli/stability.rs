//! `stability`: finds roots and boundaries over a parameter of each file, and writes the results.

use std::path::{Path, PathBuf};

use shared_geom::error::Explain;

use super::arguments::Results;
use super::progress::Progress;
use super::terminal::Terminal;
use super::{MissingTable, add_remarks, finish, statics};
use crate::analysis::stability::stability;
use crate::case::StabilitySettings;
use crate::input::{self, Input};
use crate::output::{self, ResultLocation};

/// Modes of a trimmed model without its trim.
#[derive(Debug, thiserror::Error)]
#[error("{file}: has [trim], whose controls the command modes does not find")]
pub(super) struct ModesOfTrim {
    pub file: String,
}

impl Explain for ModesOfTrim {
    fn help(&self) -> Option<String> {
        let text =
            "use the command stability, or replace the controls by parameters in another file";
        Some(text.to_owned())
    }
}

/// `stability FILE...`
pub(super) fn stability_of_files(
    files: &[PathBuf],
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let requested = MissingTable {
        file: String::new(),
        table: "stability",
        example: "parameter = \"rpm\", from = 100, to = 400 and steps = 13",
    };
    statics::each_again(
        files,
        results,
        terminal,
        (|input| input.stability.as_ref(), requested),
        stability_of,
    )
}

fn stability_of(
    path: &Path,
    input: &Input,
    settings: &StabilitySettings,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let progress = Progress::of_search(terminal.part());
    let parameter = &settings.sweep.parameter;
    let read = |given: &[(String, f64)]| {
        if let Some((_, at)) = given.iter().find(|own| own.0 == *parameter) {
            let place = format!("{parameter} = {}", input::short_number(*at, 6));
            progress.note(part(&settings.sweep.values, *at), &place);
        }
        let input = input::read_with(path, given)?;
        if settings.method.has_period() {
            input.repeating()
        } else {
            Ok(input)
        }
    };
    let mut result = stability(&input.model.name, settings, input.trim.as_ref(), &read);
    progress.finish();
    let shown = (location.name.as_str(), &mut *terminal);
    add_remarks(&mut result.remarks, (input, None), shown);
    terminal.show(&output::stability_text(&result));
    let failures = result.failures.iter().map(|(at, [reason, remedy])| {
        let (name, parameter) = (&location.name, &result.parameter);
        let at = input::short_number(*at, 9);
        format!("error: {name} at {parameter} = {at}: {reason}\n  help: {remedy}")
    });
    let failures: Vec<_> = failures.collect();
    let failure = (!failures.is_empty()).then(|| failures.join("\n"));
    finish(
        failure,
        output::write_stability(&result, location),
        terminal,
    )
}

/// The part of the range of the values, which increase or decrease, that a value ends.
fn part(values: &[f64], at: f64) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return 0.0;
    };
    let range = last - first;
    if range == 0.0 {
        0.0
    } else {
        ((at - first) / range).clamp(0.0, 1.0)
    }
}

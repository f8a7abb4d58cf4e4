//! `linearize`: writes the linear model of each file.

use std::path::Path;

use shared_geom::error::Diagnostics;

use super::arguments::Results;
use super::linearize_options::LinearizeOptions;
use super::result_locations::{in_folder, result_locations};
use super::terminal::Terminal;
use super::{WRONG_INPUT, add_remarks, files, finish};
use crate::analysis::linear::linearize;
use crate::case::LinearAbout;
use crate::input::{self, Input, LinearRequest};
use crate::output::{self, ResultLocation};

/// `linearize FILE...`
pub(super) fn linearize_files(
    options: &LinearizeOptions,
    results: &Results,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let (request, paths) = (options.request(), &options.files);
    let locations = match result_locations(paths, results) {
        Ok(locations) => locations,
        Err(problem) => {
            terminal.report(&problem);
            return WRONG_INPUT;
        }
    };
    let read = files::each(paths, terminal, |path, terminal| {
        let input = of_request(path, &request, &[]);
        input
            .map_err(|problems| terminal.report_text(&problems.to_string()))
            .ok()
    });
    let Some(inputs) = read.into_iter().collect::<Option<Vec<_>>>() else {
        return WRONG_INPUT;
    };
    let jobs: Vec<_> = paths.iter().zip(&inputs).zip(&locations).collect();
    files::worst_of(&jobs, terminal, |((path, input), location), terminal| {
        in_folder(location, "linearize", terminal, |terminal| {
            linear_of((path, &request), input, location, terminal)
        })
    })
}

/// The input, of which `[periodic]` is checked if the linear model is about a motion.
fn of_request(
    path: &Path,
    request: &LinearRequest,
    given: &[(String, f64)],
) -> Result<Input, Diagnostics> {
    let input = input::read_linear(path, request, given)?;
    match input.linear.as_ref().map(|own| &own.about) {
        Some(LinearAbout::Period | LinearAbout::Trim) => input.repeating(),
        _ => Ok(input),
    }
}

fn linear_of(
    (path, request): (&Path, &LinearRequest),
    input: &Input,
    location: &ResultLocation,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let read = |given: &[(String, f64)]| of_request(path, request, given);
    match linearize(input, &read) {
        Ok(mut model) => {
            let shown = (location.name.as_str(), &mut *terminal);
            add_remarks(&mut model.remarks, (input, None), shown);
            terminal.show(&output::linear_text(&model));
            finish(None, output::write_linear(&model, location), terminal)
        }
        Err(failure) => {
            let (name, remedy) = (&location.name, failure.remedy());
            terminal.report_text(&format!("error: {name}: {failure}\n  help: {remedy}"));
            super::NOT_REACHED
        }
    }
}

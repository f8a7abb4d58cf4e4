//! `section-analyzer check`: reports problems of a section file, without solving it.

use std::cell::LazyCell;
use std::path::Path;

use super::arguments::CheckArguments;
use super::figures::draw_section;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list, list_removed, warnings_of};
use crate::input::{self, Input};
use crate::output::{Outline, OutputFiles, ResultWriter, input_report};

/// Reads and checks a section file; draws the section if a folder is given.
pub(super) fn check_file(
    arguments: &CheckArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let file = &arguments.file;
    let input = terminal.read(file)?;
    let report = input_report(&input.section, &input.summary);
    write!(terminal.out, "{report}\nNo problem found\n")?;
    terminal.warn_if_quiet(file, &warnings_of(&input))?;
    match &arguments.out {
        Some(folder) => {
            let figures = !arguments.no_figures;
            draw(file, (folder, figures), &input, terminal)
        }
        None => Ok(()),
    }
}

/// Draws mesh and fibers.
fn draw(
    file: &Path,
    (folder, figures): (&Path, bool),
    input: &Input,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let files = OutputFiles::new(folder, &input::name_of(file))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let earlier = files.earlier();
    let mut results = ResultWriter::beside(files).with_figures(figures);
    let outline = LazyCell::new(|| Outline::new(&input.section));
    let drawn = draw_section(input, &outline, None, &mut results);
    let reported = drawn.map_err(|problem| terminal.report(&problem, NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    list_removed(&earlier.removed(), terminal)?;
    reported
}

//! `section-analyzer check`: reports problems of a section file, without solving it.

use std::cell::LazyCell;
use std::path::{Path, PathBuf};

use super::figures::draw_section;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::input::{self, Input};
use crate::output::{Outline, OutputFiles, ResultWriter, input_report};

/// Reads and checks a section file; draws the section into the folder `out`.
pub(super) fn check_file(
    file: &Path,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let input = terminal.read(file)?;
    let report = input_report(&input.section, &input.summary);
    write!(terminal.out, "{report}\nNo problem found\n")?;
    match out {
        Some(folder) => draw(file, &folder, &input, terminal),
        None => Ok(()),
    }
}

/// Draws mesh and fibers.
fn draw(
    file: &Path,
    folder: &Path,
    input: &Input,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let files = OutputFiles::new(folder, &input::name_of(file))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let mut results = ResultWriter::beside(files);
    let outline = LazyCell::new(|| Outline::new(&input.section));
    let drawn = draw_section(input, &outline, None, &mut results);
    let reported = drawn.map_err(|problem| terminal.report(&problem, NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    reported
}

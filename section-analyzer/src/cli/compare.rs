//! `section-analyzer compare`: compares two property files.

use shared_geom::error::Diagnostics;
use shared_geom::section;

use super::arguments::CompareArguments;
use super::{NOT_REACHED, Stop, Terminal};
use crate::output::comparison;
use crate::properties::Difference;

/// Compares two property files; the exit code shows whether they are equal.
pub(super) fn compare_files(
    arguments: &CompareArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let mut problems = Diagnostics::new();
    let a = problems.keep(section::read(&arguments.a));
    let b = problems.keep(section::read(&arguments.b));
    let (Some(a), Some(b)) = (a, b) else {
        return Err(terminal.report_all(&problems));
    };
    let difference = Difference::between(&a, &b, arguments.as_given);
    let names = [&arguments.a, &arguments.b].map(|file| file.display().to_string());
    let tolerance = arguments.tolerance;
    let (a, b) = ((names[0].as_str(), &a), (names[1].as_str(), &b));
    let text = comparison(a, b, &difference, tolerance);
    write!(terminal.out, "{text}")?;
    if difference.beyond(tolerance).is_empty() && difference.unlike.is_empty() {
        Ok(())
    } else {
        Err(Stop::Reported(NOT_REACHED))
    }
}

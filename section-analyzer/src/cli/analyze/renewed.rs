//! The inputs from which results are made, and results of a section of which the strengths of materials alone
//! have changed: they are of the new input too, and it is not solved again.

use shared_geom::files::write_whole;
use shared_geom::hash::sha256_of;
use shared_geom::section;

use super::outcome::{Outcome, Status};
use super::{PROGRAM, Run};
use crate::input::{Input, InputSummary};
use crate::output::{AnalysisRecord, OutputFiles};

/// Fingerprint of everything on which the results depend: the files that were read, and
/// the program. Options that change results or the list of files belong here too.
pub(in crate::cli) fn made_from(input: &Input, run: &Run) -> String {
    with_options(&input.summary.input_hash, run)
}

/// Fingerprint of the content of an input, the program and the options.
fn with_options(content: &str, run: &Run) -> String {
    let mut parts = vec![content.as_bytes(), PROGRAM.as_bytes()];
    let requested = run.sensitivity.as_ref();
    let requested = requested.map(|nodes| format!("sensitivity {nodes:?}"));
    parts.extend(requested.as_ref().map(|requested| requested.as_bytes()));
    parts.extend(run.mesh_error.then_some(&b"mesh error"[..]));
    let open = format!("open {:?}", run.open);
    parts.extend((!run.open.is_empty()).then_some(open.as_bytes()));
    parts.extend((!run.figures).then_some(&b"no figures"[..]));
    sha256_of(&parts)
}

/// Fingerprint of everything on which the results depend but for the strengths of materials; `None` if results
/// depend on them, as stresses, or name their input, as derivatives and estimates of the error.
pub(super) fn without_strengths(input: &Input, run: &Run) -> Option<String> {
    if !input.loads.is_empty() || run.sensitivity.is_some() || run.mesh_error {
        return None;
    }
    let summary = InputSummary {
        file: String::new(),
        input_hash: String::new(),
        ..input.summary.clone()
    };
    let known = Input {
        limits: Vec::new(),
        summary,
        ..input.clone()
    };
    Some(with_options(&format!("{known:?}"), run))
}

/// The outcome of an earlier run, whose files then name the new input, if strengths alone have changed. A file
/// that cannot be written is reported when the section is solved.
pub(super) fn renewed(
    files: &OutputFiles,
    (input, run): (&Input, &Run),
    made_from: &str,
) -> Option<Outcome> {
    let record = AnalysisRecord::read(files)?;
    let known = without_strengths(input, run)?;
    let _lock = files.lock().ok()?;
    if !record.holds_but_for_strengths(files, &known) {
        return None;
    }
    let mut properties = section::read(&files.properties()).ok()?;
    let report = std::fs::read_to_string(files.report()).ok()?;
    let hash = &mut properties.provenance.input_hash;
    let report = report.replacen(hash.as_str(), &input.summary.input_hash, 1);
    hash.clone_from(&input.summary.input_hash);
    write_whole(&files.properties(), &section::write(&properties)).ok()?;
    write_whole(&files.report(), &report).ok()?;
    let names = record.names(files);
    AnalysisRecord::write(files, made_from, Some(known), &names).ok()?;
    let written = names.iter().map(|name| files.folder().join(name));
    Some(Outcome {
        report,
        files: written.collect(),
        properties: Some(properties),
        ..Outcome::new(Status::Renewed)
    })
}

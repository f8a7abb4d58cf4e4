//! The record of an analysis: fingerprints of its input and its result files, by which
//! a later run detects that nothing has changed.

use std::path::Path;

use serde::{Deserialize, Serialize};
use shared_geom::files::{OutputProblem, write_whole};
use shared_geom::hash::sha256_of_file;

use super::files::OutputFiles;

const FORMAT: &str = "helicoid analysis record";
/// Version of the record; a record of another version is ignored.
const VERSION: u64 = 2;

/// Fingerprints of the input and the result files of a successful analysis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AnalysisRecord {
    format: String,
    version: u64,
    /// Fingerprint of the inputs, the options and the program.
    made_from: String,
    /// The same without the strengths of materials, if no result depends on them.
    without_strengths: Option<String>,
    files: Vec<RecordedFile>,
}

/// A result file, in the folder of the record.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct RecordedFile {
    name: String,
    content: String,
}

impl AnalysisRecord {
    /// The record of the last analysis of a section; `None` if it does not
    /// exist or cannot be read.
    pub fn read(files: &OutputFiles) -> Option<Self> {
        let text = std::fs::read_to_string(files.record()).ok()?;
        let record: Self = serde_json::from_str(&text).ok()?;
        (record.format == FORMAT && record.version == VERSION).then_some(record)
    }

    /// Writes the record of an analysis whose input has the fingerprint `made_from`, and another one
    /// `without_strengths` if no result depends on them, with the current content of the files `names`.
    ///
    /// # Errors
    /// [`OutputProblem::File`]: a file of `names` cannot be read any more, or the record
    /// cannot be written.
    pub fn write(
        files: &OutputFiles,
        made_from: &str,
        without_strengths: Option<String>,
        names: &[String],
    ) -> Result<(), OutputProblem> {
        let recorded = names.iter().map(|name| {
            let content = content_of(files, name).ok_or_else(|| OutputProblem::File {
                file: files.folder().join(name).display().to_string(),
                reason: "it cannot be read any more".to_owned(),
            })?;
            let name = name.clone();
            Ok(RecordedFile { name, content })
        });
        let record = Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            made_from: made_from.to_owned(),
            without_strengths,
            files: recorded.collect::<Result<_, OutputProblem>>()?,
        };
        // strings and lists of strings always have a JSON form
        let text = serde_json::to_string_pretty(&record).unwrap_or_default();
        write_whole(&files.record(), &(text + "\n"))
    }

    /// Whether a run whose input has the fingerprint `made_from` would write the existing
    /// files: none is missing and none has been changed.
    pub fn holds(&self, files: &OutputFiles, made_from: &str) -> bool {
        self.made_from == made_from && self.is_intact(files)
    }

    /// Whether the existing files are of an input that differs from the present one in the strengths of
    /// materials alone, on which none of them depends; its fingerprint without strengths is
    /// `without_strengths`.
    pub fn holds_but_for_strengths(&self, files: &OutputFiles, without_strengths: &str) -> bool {
        self.without_strengths.as_deref() == Some(without_strengths) && self.is_intact(files)
    }

    /// Whether no file is missing and none has been changed.
    fn is_intact(&self, files: &OutputFiles) -> bool {
        let is_intact = |file: &RecordedFile| {
            belongs(files, &file.name)
                && content_of(files, &file.name).is_some_and(|content| content == file.content)
        };
        self.files.iter().all(is_intact)
    }

    /// Names of the recorded files of this section, in the order of writing.
    pub fn names(&self, files: &OutputFiles) -> Vec<String> {
        let names = self.files.iter().map(|file| file.name.clone());
        names.filter(|name| belongs(files, name)).collect()
    }
}

/// Whether `name` is the name of a result file of this section: a file in the folder,
/// called NAME.something. An edited record must not affect other files.
fn belongs(files: &OutputFiles, name: &str) -> bool {
    let rest = name.strip_prefix(files.name());
    let is_alone = Path::new(name).file_name().is_some_and(|last| last == name);
    is_alone && rest.is_some_and(|rest| rest.starts_with('.'))
}

fn content_of(files: &OutputFiles, name: &str) -> Option<String> {
    sha256_of_file(&files.folder().join(name)).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::files::write_text;

    fn files(folder: &Path) -> OutputFiles {
        OutputFiles::new(folder, "a").unwrap()
    }

    #[test]
    fn a_record_holds_while_inputs_and_files_are_the_same() {
        let folder = tempfile::tempdir().unwrap();
        let files = files(folder.path());
        assert_eq!(AnalysisRecord::read(&files), None);
        write_text(&files.report(), "one").unwrap();
        let names = ["a.report.txt".to_owned()];
        AnalysisRecord::write(&files, "x", Some("z".to_owned()), &names).unwrap();
        let record = AnalysisRecord::read(&files).unwrap();
        assert!(record.holds(&files, "x"));
        assert!(!record.holds(&files, "y"));
        assert!(record.holds_but_for_strengths(&files, "z"));
        assert!(!record.holds_but_for_strengths(&files, "x"));
        write_text(&files.report(), "two").unwrap();
        assert!(!record.holds(&files, "x"));
        assert!(!record.holds_but_for_strengths(&files, "z"));
        std::fs::remove_file(files.report()).unwrap();
        assert!(!record.holds(&files, "x"));
    }

    #[test]
    fn a_record_of_another_kind_or_with_files_elsewhere_holds_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let files = files(folder.path());
        let text = |version: u64, name: &str| {
            format!(
                "{{\"format\": \"{FORMAT}\", \"version\": {version}, \"made_from\": \"x\", \
                 \"without_strengths\": null, \"files\": [{{\"name\": \"{name}\", \"content\": \"\"}}]}}"
            )
        };
        for (version, name) in [(1, "a.report.txt"), (2, "a.report.txt\"")] {
            write_text(&files.record(), &text(version, name)).unwrap();
            assert_eq!(AnalysisRecord::read(&files), None);
        }
        for name in ["../a.report.txt", "b.report.txt", "a", "a.x/../../b", ""] {
            write_text(&files.record(), &text(2, name)).unwrap();
            let record = AnalysisRecord::read(&files).unwrap();
            assert!(!record.holds(&files, "x"), "{name}");
            assert!(record.names(&files).is_empty(), "{name}");
        }
    }

    #[test]
    fn a_file_that_has_gone_cannot_be_recorded() {
        let folder = tempfile::tempdir().unwrap();
        let files = files(folder.path());
        let problem = AnalysisRecord::write(&files, "x", None, &["a.report.txt".to_owned()]);
        let shown = problem.unwrap_err().to_string();
        assert!(
            shown.ends_with("written: it cannot be read any more"),
            "{shown}"
        );
    }
}

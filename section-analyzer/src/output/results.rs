//! Writes the results of an analysis and records the names of its files.

use std::path::{Path, PathBuf};

use shared_geom::figure::Figure;
use shared_geom::files::{OutputProblem, write_figure, write_whole};

use super::files::OutputFiles;
use super::record::AnalysisRecord;

/// The result files of one run, recorded as they are written.
///
/// The record of the previous run is removed before writing, so that an interrupted run leaves
/// no record; files of the previous run that this run does not write are removed.
#[derive(Debug)]
pub struct ResultWriter {
    files: OutputFiles,
    earlier: Vec<String>,
    written: Vec<PathBuf>,
    /// Whether figures are drawn.
    figures: bool,
}

impl ResultWriter {
    /// Begins to replace the results of an earlier run.
    pub fn new(files: OutputFiles) -> Self {
        let earlier = AnalysisRecord::read(&files);
        let earlier = earlier.map_or_else(Vec::new, |record| record.names(&files));
        // A missing file is ignored.
        let _ = std::fs::remove_file(files.record());
        Self {
            files,
            earlier,
            written: Vec::new(),
            figures: true,
        }
    }

    /// Adds files to the results of an earlier run, which are kept.
    pub fn beside(files: OutputFiles) -> Self {
        Self {
            files,
            earlier: Vec::new(),
            written: Vec::new(),
            figures: true,
        }
    }

    /// The same, with or without figures.
    pub fn with_figures(self, figures: bool) -> Self {
        Self { figures, ..self }
    }

    /// Whether figures are drawn.
    pub fn draws(&self) -> bool {
        self.figures
    }

    /// The paths of the section's files.
    pub fn files(&self) -> &OutputFiles {
        &self.files
    }

    /// Writes a text.
    ///
    /// # Errors
    /// [`OutputProblem::File`].
    pub fn text(&mut self, file: PathBuf, text: &str) -> Result<(), OutputProblem> {
        self.add(file, |file| write_whole(file, text))
    }

    /// Draws a figure as PNG and, with the ending `svg`, as SVG. It is made only if figures are
    /// drawn; otherwise the files of an earlier run are removed.
    ///
    /// # Errors
    /// [`OutputProblem`].
    pub fn figure<F: Figure>(
        &mut self,
        file: PathBuf,
        figure: impl FnOnce() -> F,
    ) -> Result<(), OutputProblem> {
        self.figure_where(file, || Some(figure()))
    }

    /// Like [`ResultWriter::figure`], for a figure that not every section has.
    ///
    /// # Errors
    /// [`OutputProblem`].
    pub fn figure_where<F: Figure>(
        &mut self,
        file: PathBuf,
        figure: impl FnOnce() -> Option<F>,
    ) -> Result<(), OutputProblem> {
        let vector = file.with_extension("svg");
        let figure = self.draws().then(figure).flatten();
        let drawing = figure.map(|figure| figure.drawing());
        for file in [file, vector] {
            match &drawing {
                Some(drawing) => self.add(file, |file| write_figure(file, drawing))?,
                // A missing file is ignored.
                None => drop(std::fs::remove_file(file)),
            }
        }
        Ok(())
    }

    /// Records a file of the section that `write` writes.
    ///
    /// # Errors
    /// The errors of `write`.
    pub fn add(
        &mut self,
        file: PathBuf,
        write: impl FnOnce(&Path) -> Result<(), OutputProblem>,
    ) -> Result<(), OutputProblem> {
        write(&file)?;
        self.written.push(file);
        Ok(())
    }

    /// Ends a successful analysis: writes its record; returns all files written, and the reason
    /// if the record could not be written. `made_from` is the fingerprint of inputs, options
    /// and program, `without_strengths` the one without strengths of materials, if no result depends on them.
    pub fn finish(
        mut self,
        made_from: &str,
        without_strengths: Option<String>,
    ) -> (Vec<PathBuf>, Option<OutputProblem>) {
        self.remove_earlier();
        match AnalysisRecord::write(&self.files, made_from, without_strengths, &self.names()) {
            Ok(()) => {
                self.written.push(self.files.record());
                (self.written, None)
            }
            Err(problem) => (self.written, Some(problem)),
        }
    }

    /// Ends a run that adds to the results or failed, without a record; returns all files
    /// written. Results of the run that it replaces are removed.
    pub fn abandon(self) -> Vec<PathBuf> {
        self.remove_earlier();
        self.written
    }

    fn remove_earlier(&self) {
        let names = self.names();
        for name in self.earlier.iter().filter(|name| !names.contains(name)) {
            // A missing file is ignored.
            let _ = std::fs::remove_file(self.files.folder().join(name));
        }
    }

    /// Names of the written files, which all lie in the folder of the section.
    fn names(&self) -> Vec<String> {
        let name = |file: &PathBuf| {
            let name = Path::file_name(file).unwrap_or_default();
            name.to_string_lossy().into_owned()
        };
        self.written.iter().map(name).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::files::write_text;

    /// The second run writes one file less: the file is removed, and the record of the first
    /// run does not exist during the second one.
    #[test]
    fn files_of_an_earlier_run_that_are_not_replaced_go() {
        let folder = tempfile::tempdir().unwrap();
        let writer = || ResultWriter::new(OutputFiles::new(folder.path(), "a").unwrap());
        let at = |name: &str| folder.path().join(name);
        let mut first = writer();
        first.text(at("a.report.txt"), "one").unwrap();
        first.text(at("a.tip.vtu"), "one").unwrap();
        let (written, problem) = first.finish("x", None);
        assert_eq!(problem, None);
        assert_eq!(written.last(), Some(&at("a.analysis.json")));
        write_text(&at("a.notes.txt"), "by hand").unwrap();

        let mut second = writer();
        assert!(!at("a.analysis.json").exists());
        second.text(at("a.report.txt"), "two").unwrap();
        assert_eq!(second.abandon(), [at("a.report.txt")]);
        assert!(!at("a.tip.vtu").exists());
        assert!(!at("a.analysis.json").exists());
        assert!(at("a.notes.txt").exists());
    }
}

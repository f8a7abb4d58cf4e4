//! The files of an analysis, and the writing of them.

use std::io;
use std::path::{Path, PathBuf};

use shared_geom::error::Explain;
use shared_geom::figure::{self, Drawing, FigureProblem};

/// Where the results of one section go: `FOLDER/NAME.properties.json` and so on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFiles {
    folder: PathBuf,
    name: String,
}

/// Why results could not be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OutputProblem {
    /// The folder cannot be made.
    #[error("folder \"{folder}\" cannot be made: {reason}")]
    Folder {
        /// The folder.
        folder: String,
        /// The reason in words.
        reason: String,
    },
    /// A file cannot be written.
    #[error("file \"{file}\" cannot be written: {reason}")]
    File {
        /// The file.
        file: String,
        /// The reason in words.
        reason: String,
    },
    /// A figure cannot be made.
    #[error(transparent)]
    Figure(#[from] FigureProblem),
}

impl Explain for OutputProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Folder { .. } => Some("name another folder with --out".to_owned()),
            Self::Figure(problem) => problem.help(),
            Self::File { .. } => None,
        }
    }
}

impl OutputFiles {
    /// The files of the section called `name` in `folder`, which is made if it does
    /// not exist.
    ///
    /// # Errors
    /// [`OutputProblem::Folder`].
    pub fn new(folder: &Path, name: &str) -> Result<Self, OutputProblem> {
        std::fs::create_dir_all(folder).map_err(|error| OutputProblem::Folder {
            folder: folder.display().to_string(),
            reason: words(&error),
        })?;
        Ok(Self {
            folder: folder.to_owned(),
            name: name.to_owned(),
        })
    }

    /// The property file.
    pub fn properties(&self) -> PathBuf {
        self.path("properties.json")
    }

    /// The text report.
    pub fn report(&self) -> PathBuf {
        self.path("report.txt")
    }

    /// The figure of the mesh.
    pub fn mesh(&self) -> PathBuf {
        self.path("mesh.png")
    }

    /// The figure of the warping.
    pub fn warping(&self) -> PathBuf {
        self.path("warping.png")
    }

    fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Removes the property file and the figure of the warping of an earlier run,
    /// which an analysis that failed does not replace.
    pub fn remove_results(&self) {
        for file in [self.properties(), self.warping()] {
            // One that does not exist is no problem.
            let _ = std::fs::remove_file(file);
        }
    }
}

/// Writes a text file.
///
/// # Errors
/// [`OutputProblem::File`].
pub fn write_text(file: &Path, text: &str) -> Result<(), OutputProblem> {
    std::fs::write(file, text).map_err(|error| OutputProblem::File {
        file: file.display().to_string(),
        reason: words(&error),
    })
}

/// Draws a figure of `size` (width, height) \[figure pixels\] into a file.
///
/// # Errors
/// [`OutputProblem::File`] where the file cannot be made, else
/// [`OutputProblem::Figure`].
pub fn write_figure(
    file: &Path,
    size: (u32, u32),
    drawing: &impl Drawing,
) -> Result<(), OutputProblem> {
    // Made first, since the words of the backend teach less than those of the system.
    write_text(file, "")?;
    Ok(figure::save(file, size, drawing)?)
}

/// The reason of an error without its number.
fn words(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::AlreadyExists | io::ErrorKind::NotADirectory => {
            "a file of this name is in the way".to_owned()
        }
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        io::ErrorKind::NotFound => "its folder does not exist".to_owned(),
        io::ErrorKind::StorageFull => "no space is left".to_owned(),
        _ => error.to_string(),
    }
}

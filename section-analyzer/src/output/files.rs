//! The files of an analysis.

use std::path::{Path, PathBuf};

use shared_geom::files::{OutputProblem, make_folder};

/// Where the results of one section go: `FOLDER/NAME.properties.json` and so on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFiles {
    folder: PathBuf,
    name: String,
}

impl OutputFiles {
    /// The files of the section called `name` in `folder`, which is made if it does
    /// not exist.
    ///
    /// # Errors
    /// [`OutputProblem::Folder`].
    pub fn new(folder: &Path, name: &str) -> Result<Self, OutputProblem> {
        make_folder(folder)?;
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

    /// The warping as a field file.
    pub fn warping_field(&self) -> PathBuf {
        self.path("warping.vtu")
    }

    /// Strain and stress under `load` as a field file.
    pub fn stress_field(&self, load: &str) -> PathBuf {
        self.path(&format!("{load}.stress.vtu"))
    }

    /// The figure called `plot` of the stresses under `load`.
    pub fn stress_figure(&self, load: &str, plot: &str) -> PathBuf {
        self.path(&format!("{load}.{plot}.png"))
    }

    fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Removes the property file and the files of the warping of an earlier run,
    /// which an analysis that failed does not replace.
    pub fn remove_results(&self) {
        for file in [self.properties(), self.warping(), self.warping_field()] {
            // One that does not exist is no problem.
            let _ = std::fs::remove_file(file);
        }
    }
}

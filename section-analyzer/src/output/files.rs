//! The files of an analysis.

use std::path::{Path, PathBuf};

use shared_geom::files::{Earlier, OutputProblem, make_folder};
use shared_geom::run_lock::RunLock;

use super::stress_plots::STRESS_PLOTS;

/// Paths of the results of one section: `FOLDER/NAME.properties.json` and so on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputFiles {
    folder: PathBuf,
    name: String,
}

impl OutputFiles {
    /// The files of the section called `name` in `folder`, which is created if it does not
    /// exist.
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

    /// Keeps other runs from the files of the section.
    ///
    /// # Errors
    /// [`OutputProblem::InUse`].
    pub fn lock(&self) -> Result<RunLock, OutputProblem> {
        RunLock::new(&self.path("section.lock"))
    }

    /// The results that exist now.
    pub fn earlier(&self) -> Earlier {
        Earlier::new(&self.folder, &self.name)
    }

    /// The folder of the results.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The name of the section, with which its file names begin.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The record of the last analysis.
    pub fn record(&self) -> PathBuf {
        self.path("analysis.json")
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

    /// The figure of the fiber directions.
    pub fn fibers(&self) -> PathBuf {
        self.path("fibers.png")
    }

    /// The figure of the warping.
    pub fn warping(&self) -> PathBuf {
        self.path("warping.png")
    }

    /// The warping of a section without cells, as a table.
    pub fn warping_table(&self) -> PathBuf {
        self.path("warping.csv")
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

    /// The table of the integration points under `load`.
    pub fn stress_points(&self, load: &str) -> PathBuf {
        self.path(&format!("{load}.stress.csv"))
    }

    /// The table of the cells' means under `load`.
    pub fn stress_cells(&self, load: &str) -> PathBuf {
        self.path(&format!("{load}.stress_cells.csv"))
    }

    /// The table of smoothed values at nodes under `load`.
    pub fn stress_nodes(&self, load: &str) -> PathBuf {
        self.path(&format!("{load}.stress_nodes.csv"))
    }

    /// The text report of the stresses under `load`.
    pub fn stress_report(&self, load: &str) -> PathBuf {
        self.path(&format!("{load}.stress.txt"))
    }

    /// Removes the files of `load` from an earlier run.
    pub fn remove_stresses(&self, load: &str) {
        remove([
            self.stress_report(load),
            self.stress_points(load),
            self.stress_cells(load),
            self.stress_nodes(load),
            self.stress_field(load),
        ]);
        remove(STRESS_PLOTS.map(|plot| self.stress_figure(load, plot)));
    }

    /// The table of areas by region.
    pub fn areas(&self) -> PathBuf {
        self.path("areas.csv")
    }

    /// The constants of restrained warping.
    pub fn constants(&self) -> PathBuf {
        self.path("constants.csv")
    }

    /// The table of electrodes.
    pub fn electrodes(&self) -> PathBuf {
        self.path("electrodes.csv")
    }

    /// The figure of the potential at one volt of an electrode.
    pub fn potential(&self, electrode: &str) -> PathBuf {
        self.path(&format!("potential_{}.png", in_file(electrode)))
    }

    /// The figure of the electric field at one volt of an electrode.
    pub fn field(&self, electrode: &str) -> PathBuf {
        self.path(&format!("field_{}.png", in_file(electrode)))
    }

    /// Removes table and figures of the electrodes called `names` from an earlier run.
    pub fn remove_electrodes<'a>(&self, names: impl IntoIterator<Item = &'a str>) {
        remove([self.electrodes()]);
        for name in names {
            remove([self.potential(name), self.field(name)]);
        }
    }

    /// The derivatives of the properties.
    pub fn sensitivity(&self) -> PathBuf {
        self.path("sensitivity.json")
    }

    /// The discretization error of the stiffness.
    pub fn mesh_error(&self) -> PathBuf {
        self.path("mesh_error.json")
    }

    /// Removes the discretization error of an earlier run, for a run without it.
    pub fn remove_mesh_error(&self) {
        remove([self.mesh_error()]);
    }

    /// Removes the derivatives of an earlier run, for a run that does not request them.
    pub fn remove_sensitivity(&self) {
        remove([self.sensitivity()]);
    }

    fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }

    /// Removes the results of an earlier run that a failed analysis does not replace.
    pub fn remove_results(&self) {
        remove([
            self.properties(),
            self.areas(),
            self.constants(),
            self.warping(),
            self.warping_field(),
            self.sensitivity(),
            self.mesh_error(),
            self.warping_table(),
        ]);
    }

    /// Removes the constants of restrained warping of an earlier run, for a section
    /// that has none.
    pub fn remove_constants(&self) {
        remove([self.constants()]);
    }
}

/// The name of an electrode in a file name: letters, digits, `-` and `_` are kept, others are
/// replaced by their codes, so that two names make two files.
fn in_file(name: &str) -> String {
    let letter = |letter: char| match letter {
        'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' => letter.to_string(),
        other => format!("%{:X}", u32::from(other)),
    };
    name.chars().map(letter).collect()
}

/// Removes files, figures in both formats; missing files are ignored.
fn remove<const N: usize>(files: [PathBuf; N]) {
    for file in files {
        if file.extension().is_some_and(|ending| ending == "png") {
            let _ = std::fs::remove_file(file.with_extension("svg"));
        }
        let _ = std::fs::remove_file(file);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names that a file system rejects or does not distinguish have different files.
    #[test]
    fn electrodes_of_any_name_have_files_of_their_own() {
        let files = OutputFiles {
            folder: PathBuf::from("results"),
            name: "a".into(),
        };
        let shown = |name: &str| files.potential(name).display().to_string();
        assert_eq!(shown("top_1-b"), "results/a.potential_top_1-b.png");
        assert_eq!(shown("../b c"), "results/a.potential_%2E%2E%2Fb%20c.png");
        assert_ne!(files.field("a b"), files.field("a_b"));
        assert_ne!(files.field("a/b"), files.field("a%2Fb"));
    }
}

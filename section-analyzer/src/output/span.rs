//! The sections of a blade along its span, and the blade that they make.

use std::path::{Path, PathBuf};

use nalgebra::Vector2;
use shared_geom::blade::{Blade, Interpolation, Station};
use shared_geom::files::{Earlier, OutputProblem};
use shared_geom::hash::sha256_of;
use shared_geom::line::ReferenceLine;
use shared_geom::run_lock::RunLock;
use shared_geom::section::{Provenance, SectionFile, SectionProperties};

use super::layup_report::LayerRow;
use super::section_picture::SectionPicture;
use crate::input::span_loads::{SECTIONS, section_file_name};

mod compare;
mod plot;
mod table;
mod text;

pub(super) use compare::values_beside;
pub use compare::{comparison_csv, comparison_text};
pub use plot::span_plots;
pub(super) use table::SpanRow;
pub use table::{layers_csv, span_csv};
pub use text::span_text;

/// A solved section of a blade.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedStation {
    /// Position along the span [-].
    pub eta: f64,
    /// Fingerprint of its section file and mesh.
    pub fingerprint: String,
    /// Chord \[m\].
    pub chord: f64,
    /// Its properties about the reference line, in section axes.
    pub properties: SectionProperties,
    /// Its layers.
    pub layers: Vec<LayerRow>,
    /// Its picture, if the report is requested.
    pub picture: Option<SectionPicture>,
}

/// The solved sections of a blade.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedSpan<'a> {
    /// Name of the blade.
    pub name: &'a str,
    /// Its reference line.
    pub line: &'a ReferenceLine,
    /// The sections, from the root to the tip; two at one position are the sides of a jump.
    pub stations: Vec<SolvedStation>,
}

impl SolvedSpan<'_> {
    /// The name of each section, with its layers.
    pub fn layers(&self) -> impl Iterator<Item = (&str, &[LayerRow])> {
        let stations = self.stations.iter();
        stations.map(|one| (one.properties.name.as_str(), one.layers.as_slice()))
    }

    /// The blade of these sections, linear between them: stiffness and mass of each section to
    /// the last digit.
    pub fn blade(&self) -> Blade {
        let length = self.line.length();
        let station = |solved: &SolvedStation| Station {
            arc_length: solved.eta * length,
            stiffness: solved.properties.stiffness,
            mass: solved.properties.mass,
        };
        let sources = || self.stations.iter().map(|one| &one.properties.provenance);
        let hashes: Vec<&[u8]> = sources().map(|from| from.input_hash.as_bytes()).collect();
        Blade {
            name: self.name.to_owned(),
            line: self.line.clone(),
            reference_point: Vector2::zeros(),
            stations: self.stations.iter().map(station).collect(),
            interpolation: Interpolation::Linear,
            damping: None,
            provenance: Provenance {
                program: env!("CARGO_PKG_NAME").to_owned(),
                version: env!("CARGO_PKG_VERSION").to_owned(),
                input_hash: sha256_of(&hashes),
                nodes: sources().map(|from| from.nodes).sum(),
                cells: sources().map(|from| from.cells).sum(),
                history: Vec::new(),
                sections: self.stations.iter().map(section_file).collect(),
            },
        }
    }
}

/// The file of the section of a station, from the folder of the blade.
fn section_file(station: &SolvedStation) -> SectionFile {
    let name = &station.properties.name;
    SectionFile {
        file: format!("{SECTIONS}/{}", section_file_name(name)),
        fingerprint: station.fingerprint.clone(),
    }
}

/// Paths of the results of a blade.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpanFiles {
    folder: PathBuf,
    name: String,
}

impl SpanFiles {
    /// The files of the blade called `name` in `folder`.
    pub fn new(folder: &Path, name: &str) -> Self {
        Self {
            folder: folder.to_owned(),
            name: name.to_owned(),
        }
    }

    /// The beginning of the names of the files.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The results that exist now.
    pub fn earlier(&self) -> Earlier {
        Earlier::new(&self.folder, &self.name)
    }

    /// Keeps other runs from the sections, which blades of all names in one folder share.
    ///
    /// # Errors
    /// [`OutputProblem::InUse`].
    pub fn lock(&self) -> Result<RunLock, OutputProblem> {
        RunLock::new(&self.sections().join("blade.lock"))
    }

    /// The folder of the sections.
    pub fn sections(&self) -> PathBuf {
        self.folder.join(SECTIONS)
    }

    /// The folder of the files of a format.
    pub fn format(&self, format: &str) -> PathBuf {
        self.folder.join(format)
    }

    /// The blade file.
    pub fn blade(&self) -> PathBuf {
        self.path("blade.json")
    }

    /// The table of the stations.
    pub fn span(&self) -> PathBuf {
        self.path("span.csv")
    }

    /// The table of the layers at the stations.
    pub fn layers(&self) -> PathBuf {
        self.path("layers.csv")
    }

    /// The differences from another blade.
    pub fn comparison(&self) -> PathBuf {
        self.path("compare.csv")
    }

    /// The report.
    pub fn report(&self) -> PathBuf {
        self.path("report.html")
    }

    /// The reserve factors that `strength` writes.
    pub fn strength(&self) -> PathBuf {
        self.path("strength.csv")
    }

    /// The figure called `plot`.
    pub fn figure(&self, plot: &str) -> PathBuf {
        self.path(&format!("{plot}.png"))
    }

    fn path(&self, ending: &str) -> PathBuf {
        self.folder.join(format!("{}.{ending}", self.name))
    }
}

//! Arguments and help texts of the commands for layups.

use std::path::PathBuf;

use clap::Args;

use super::whole_blade::part;

pub(super) const MESH_LAYUP: &str = "\
A section of a blade, from its layup

FILE contains the contour, layers along it, webs and materials, all along the span
(NAME.layup.toml, a turbine file of windIO, or a section of PreVABS). Columns of cells run through the wall; each layer is a physical
surface. The mesh is in the unit of length of FILE, y toward the nose. With --section,
the section file is written too, with all materials and angles.";

pub(super) const MESH_LAYUP_EXAMPLE: &str = "\
Example:
  section-analyzer mesh layup blade.layup.toml --eta 0.4 --out at_0.4.msh \\
    --section at_0.4.section.toml";

pub(super) const LAYUP: &str = "\
Describes a layup and meshes its sections, without solving them

For each station: the layers and webs with their arcs, thicknesses and areas, given and
meshed. A section that cannot be meshed is reported with the layer or web; the others
are described nevertheless. A turbine file of windIO and a section of PreVABS are read too;
with --out they are written as layup files, with all that was understood of them.";

pub(super) const LAYUP_EXAMPLE: &str = "\
Examples: two stations; without --eta all at which the file has values. A turbine file as
a layup file:
  section-analyzer layup blade.layup.toml --eta 0.2,0.4
  section-analyzer layup turbine.yaml --out blade.layup.toml";

/// Arguments of `mesh layup`.
#[derive(Debug, Args)]
pub struct MeshLayupArguments {
    /// Layup file, NAME.layup.toml, turbine file of windIO, or section of PreVABS (XML)
    pub file: PathBuf,
    /// Position along the span, 0 at the root to 1 at the tip [-]
    #[arg(long, value_name = "PART", default_value_t = 0.0, value_parser = part, allow_negative_numbers = true)]
    pub eta: f64,
    /// Mesh file to write; it must not exist
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Section file to write; it must not exist
    #[arg(long, value_name = "FILE")]
    pub section: Option<PathBuf>,
    /// Replace files that exist
    #[arg(long)]
    pub force: bool,
    /// Reduce Poisson's ratios of windIO files that no material can have
    #[arg(long)]
    pub repair_materials: bool,
}

/// Arguments of `layup`.
#[derive(Debug, Args)]
pub struct LayupArguments {
    /// Layup file, NAME.layup.toml, turbine file of windIO, or section of PreVABS (XML)
    pub file: PathBuf,
    /// Positions along the span, 0 at the root to 1 at the tip [-]; the positions of the file if not given
    #[arg(long, alias = "stations", value_name = "PARTS", value_delimiter = ',', value_parser = part, allow_negative_numbers = true)]
    pub eta: Vec<f64>,
    /// Layup file to write instead; it must not exist
    #[arg(long, value_name = "FILE", conflicts_with = "eta")]
    pub out: Option<PathBuf>,
    /// Reduce Poisson's ratios of windIO files that no material can have
    #[arg(long)]
    pub repair_materials: bool,
}

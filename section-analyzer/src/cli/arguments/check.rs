//! The arguments of `check`.

use std::path::PathBuf;

use clap::Args;

pub(super) const CHECK: &str = "\
Reads and checks a section file without solving it

Reports all problems of the section file, its mesh and its tables, with file,
line and remedy; without problems, prints the contents of the file and the shapes
of the cells by region. With --out it draws the section too:
  NAME.mesh.png          the mesh in the colors of its materials
  NAME.fibers.png        wall directions and fiber angles, if a material has directions
and both as .svg too.";

pub(super) const CHECK_EXAMPLE: &str = "\
Example:
  section-analyzer check blade/root.section.toml --out blade/results";

/// A section to check, and options.
#[derive(Debug, Args)]
pub(in crate::cli) struct CheckArguments {
    /// Section file, NAME.section.toml
    pub file: PathBuf,
    /// Folder for the figures of mesh and fibers; none is written if not given
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Draw no figures; figures of an earlier run in DIR are removed
    #[arg(long)]
    pub no_figures: bool,
}

//! The arguments of `analyze`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

pub(super) const ANALYZE: &str = "\
Solves sections and writes their properties

Reads a section file, its mesh and its tables, reports all their problems at
once, solves, prints the report, and writes into the folder DIR:
  NAME.properties.json   stiffness, mass, centers: input of the beam program
  NAME.report.txt        the report: input, results, run-time checks
  NAME.areas.csv         area, moments of area, perimeter and mass by region
  NAME.constants.csv     constants of restrained warping, if all materials are isotropic
  NAME.mesh.png          the mesh in the colors of its materials, with the centers
  NAME.fibers.png        wall directions and fiber angles, if a material has directions
  NAME.warping.png       the warping under each unit internal force
  NAME.warping.vtu       the same as fields on the mesh, for ParaView
  NAME.electrodes.csv    with electrodes: coupling, free strain and capacitance per volt
  NAME.potential_ELECTRODE.png, NAME.field_ELECTRODE.png
                         potential and electric field at one volt of a driven electrode
  NAME.sensitivity.json  with --sensitivity: derivatives of stiffness, mass and centers
  NAME.mesh_error.json   with --mesh-error: discretization error of each entry of the stiffness
  NAME.LOAD.stress.txt   and its tables: see \"stress\"; for each [load.LOAD] of FILE
  NAME.analysis.json     fingerprints of the input and of the files above
and each .png as .svg too, where FILE is NAME.section.toml. An analysis that fails writes the report and the mesh,
and removes the other files of an earlier run.

Several files are solved in parallel, each by one thread. One line per section is printed
instead of the reports, in the order given; problems of one section do not keep
the others from being written. The memory is for as many sections as there are threads.

A section is solved again only if its files (section file, mesh, tables), its results
or this program have changed: NAME.analysis.json contains their fingerprints.";

pub(super) const ANALYZE_EXAMPLE: &str = "\
Examples:
  section-analyzer analyze blade/root.section.toml --out blade/results
  section-analyzer analyze blade/*.section.toml --threads 2 --no-figures
  section-analyzer analyze box.section.toml --sensitivity --sensitivity-nodes 12,40
  section-analyzer analyze box.section.toml --mesh-error
  section-analyzer analyze patch.section.toml --open sensor

The exit code of several sections is 2 if the input of any is wrong, else 1 if any
could not be solved or written, else 0.";

/// A number of threads.
pub(super) fn count(text: &str) -> Result<NonZeroUsize, &'static str> {
    text.parse()
        .map_err(|_| "expected a whole number, 1 or more")
}

/// A number of a node.
fn node(text: &str) -> Result<u64, &'static str> {
    text.trim()
        .parse()
        .map_err(|_| "expected node numbers of the mesh file separated by commas, as in 12,40")
}

/// Sections to analyze, and options.
#[derive(Debug, Args)]
pub(in crate::cli) struct AnalyzeArguments {
    /// Section files, NAME.section.toml
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,
    /// Folder for all results; the folder "results" next to each FILE if not given
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Sections solved at the same time; the number of cores if not given
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = count)]
    pub threads: Option<NonZeroUsize>,
    /// Solve sections even if nothing has changed since the last run
    #[arg(long)]
    pub force: bool,
    /// Draw no figures; figures of an earlier run are removed
    #[arg(long)]
    pub no_figures: bool,
    /// Derivatives of stiffness, mass and centers with respect to every constant of the
    /// materials and the fiber and plane angle of every region
    #[arg(long)]
    pub sensitivity: bool,
    /// Nodes whose y and z are parameters of --sensitivity too, by their numbers in the
    /// mesh file, separated by commas
    #[arg(
        long,
        value_name = "NODES",
        value_delimiter = ',',
        allow_hyphen_values = true,
        value_parser = node,
        requires = "sensitivity"
    )]
    pub sensitivity_nodes: Vec<u64>,
    /// Estimate of the discretization error of each entry of the stiffness, by a second
    /// analysis with up to four times the number of unknowns (sixteen times with walls of single
    /// linear cells)
    #[arg(long)]
    pub mesh_error: bool,
    /// Driven electrode that is open in this run, with zero charge instead of a voltage;
    /// may be given more than once, or as "all"
    #[arg(long, value_name = "ELECTRODE")]
    pub open: Vec<String>,
}

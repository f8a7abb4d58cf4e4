//! The arguments of `blade`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;
use shared_geom::error::nearest_name;
use shared_geom::exchange::Format;

use super::analyze::count;

pub(super) const WHOLE_BLADE: &str = "\
Solves the sections of a blade along its span, from its layup

FILE is a layup with a reference line (NAME.layup.toml with [line]), or a turbine file of
windIO. Its sections are meshed and solved in parallel, and written into the folder DIR:
  NAME.blade.json     the blade, stations along the line: input of beam-dynamics
  NAME.span.csv       by station: mass, EA, EI, GJ, GA, centers, principal axes
  NAME.layers.csv     by station and layer: arcs, thickness, areas as given, meshed, cut and filled
  NAME.span.png, NAME.shear.png, NAME.centers.png
                      the same over the arc length, each as .svg too
  NAME.compare.csv    with --compare FILE: by station, mass, EA, EI and GJ beside the values of another
                      blade file, as published ones, and the differences
  NAME.report.html    with --report: one page for a browser, without network: sections with
                      their layers and stresses, stiffness and mass, curves over the span, remarks; the
                      reserve factors of \"strength\" if NAME.strength.csv is in DIR
  sections/           of each station ETA: eta_ETA.section.toml, its mesh, and the files that
                      \"analyze\" writes, without figures: \"stress\" and \"analyze\" work on them
  FORMAT/             with --format: the blade in the formats of other tools

Stations are the ones of --stations or --count, else the stations of FILE, else all positions
at which the layup has values, at most 60, and more between distant ones. At a jump (a layer
or web that begins or ends) both sides are solved.

A section is solved again only if its mesh, its materials, its results or this program have
changed; a run that was stopped continues. Sections that cannot be meshed or solved are
reported, the others are written; without --skip-failed there is no blade file then.";

pub(super) const WHOLE_BLADE_EXAMPLE: &str = "\
Examples:
  section-analyzer blade rotor.layup.toml --out rotor
  section-analyzer blade rotor.layup.toml --stations 0.1,0.3,0.9 --format beamdyn,hawc2
  section-analyzer blade rotor.layup.toml --count 40 --format all
  section-analyzer blade rotor.layup.toml --out rotor --report
  section-analyzer blade turbine.yaml --out turbine
  section-analyzer blade turbine.yaml --check
  section-analyzer blade turbine.yaml --compare published/turbine_BeamDyn.dat
  beam-dynamics modes rotor/rotor.blade.json

The exit code is 2 if FILE is wrong, 1 if a section is missing or a file could not be
written, else 0.";

/// Formats by a name, or all.
#[derive(Debug, Clone)]
pub(in crate::cli) struct Formats(pub Vec<Format>);

/// A position along the span.
pub(super) fn part(text: &str) -> Result<f64, &'static str> {
    let found = text.trim().parse::<f64>().ok();
    found
        .filter(|eta| (0.0..=1.0).contains(eta))
        .ok_or("expected positions from 0 at the root to 1 at the tip, as in 0.1,0.3,0.9")
}

/// A number of stations.
fn stations(text: &str) -> Result<usize, &'static str> {
    let found = text.parse::<usize>().ok();
    found
        .filter(|count| (2..=10_000).contains(count))
        .ok_or("expected a whole number, 2 to 10000")
}

/// The formats of a name.
fn formats(text: &str) -> Result<Formats, String> {
    let written = Format::ALL.into_iter().filter(|format| format.is_written());
    let written: Vec<_> = written
        .filter(|format| *format != Format::Helicoid)
        .collect();
    if text == "all" {
        return Ok(Formats(written));
    }
    match Format::from_name(text).filter(|format| written.contains(format)) {
        Some(format) => Ok(Formats(vec![format])),
        None => {
            let names: Vec<_> = written.iter().map(|format| format.name()).collect();
            let near = nearest_name(text, names.iter().copied());
            let help = near.map_or_else(String::new, |name| format!("; did you mean \"{name}\"?"));
            Err(format!(
                "expected \"all\" or some of {}{help}",
                names.join(", ")
            ))
        }
    }
}

/// A blade, its stations, and options.
#[derive(Debug, Args)]
pub(in crate::cli) struct WholeBladeArguments {
    /// Layup file, NAME.layup.toml, or turbine file of windIO
    pub file: PathBuf,
    /// Positions along the span, 0 at the root to 1 at the tip [-]
    #[arg(long, alias = "eta", value_name = "PARTS", value_delimiter = ',', value_parser = part, allow_negative_numbers = true)]
    pub stations: Vec<f64>,
    /// Number of stations at equal distances
    #[arg(long, value_name = "COUNT", value_parser = stations, conflicts_with = "stations", allow_negative_numbers = true)]
    pub count: Option<usize>,
    /// Folder for all results; the folder "results" next to FILE if not given
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Formats of other tools in which the blade is written too, or "all"
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = formats)]
    pub format: Vec<Formats>,
    /// Write a page that shows the blade and its sections in a browser
    #[arg(long)]
    pub report: bool,
    /// Modes that the report lists: NAME.modes.csv of "beam-dynamics modes"
    #[arg(long, value_name = "FILE", requires = "report")]
    pub modes: Option<PathBuf>,
    /// Mesh and check the sections without solving them; nothing is written
    #[arg(long, conflicts_with_all = ["out", "format", "report", "compare", "skip_failed", "force", "no_figures"])]
    pub check: bool,
    /// Blade file of any format that beam-dynamics reads: write a table of the differences
    #[arg(long, value_name = "FILE")]
    pub compare: Option<PathBuf>,
    /// Reduce Poisson's ratios of windIO files that no material can have
    #[arg(long)]
    pub repair_materials: bool,
    /// Write the blade without the sections that failed; the exit code is still 1
    #[arg(long)]
    pub skip_failed: bool,
    /// Sections solved at the same time; the number of cores if not given
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = count)]
    pub threads: Option<NonZeroUsize>,
    /// Solve sections even if nothing has changed since the last run
    #[arg(long)]
    pub force: bool,
    /// Draw no figures; figures of an earlier run are removed
    #[arg(long)]
    pub no_figures: bool,
}

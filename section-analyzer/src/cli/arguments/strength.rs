//! The arguments of `strength`.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::Args;

use super::analyze::count;

pub(super) const STRENGTH: &str = "\
Reserve factors and damage of all plies of a blade under many loads, and fatigue loads

SPAN is the table NAME.span.csv that \"blade\" wrote, next to the folder of its sections, or the
blade NAME.blade.json beside it. LOADS has internal forces along the blade, about its line and in section axes, names with units:
  arc [m] or eta; any of case, time, step; axial [N], shear_y [N], ..., bending_z [N m]
                      a row for each position and instant, in any order, as \"beam-dynamics\" writes
                      with span_forces = true in [output]: NAME.ANALYSIS.BLADE.forces.csv, and
                      the table of the instants of extremes NAME.ANALYSIS.BLADE.extremes.csv
  time [s]; case, member; NAME_axial [N], ..., NAME_bending_z [N m]
                      a row for each time, as \"beam-dynamics transient\" writes; the position
                      of each NAME by --at NAME=ETA
  arc [m] or eta; axial max [N], axial min [N], ..., bending z min [N m]
                      an envelope: each combination of largest and smallest values is a load
Several tables are read together; the name of its table precedes the case of each instant.
Between the positions forces are linear. Units stand in square brackets, also of times and
positions; without them numbers are in SI units. Written are, next to SPAN or into DIR:
  NAME.strength.csv   by station and ply: the smallest reserve factor over all instants, its
                      criterion, mode, instant, position, internal force and stresses
  NAME.fatigue.csv    with times: by station and component, damage-equivalent load ranges
                      (rainflow counting of ASTM E1049)
  NAME.damage.csv     with times: by station and ply, Miner's sum by the constant-life diagram of
                      its material, the component of stress or strain, its cycles and position
Reserve factors need strengths of the materials, [material.NAME.strength], damage the slope m
of their S-N lines too. DURATIONS has the time that each case lasts in the life of the blade,
columns case and duration [h]; without it each history occurs once.";

pub(super) const STRENGTH_EXAMPLE: &str = "\
Examples:
  section-analyzer strength rotor/rotor.span.csv --loads results/gust.transient.blade_1.forces.csv
  section-analyzer strength rotor/rotor.span.csv --loads calm.csv --loads storm.csv
  section-analyzer strength rotor/rotor.span.csv --loads results/run.transient.csv \\
    --at root=0.02 --at mid=0.5 --exponents 4,10
  section-analyzer strength rotor/rotor.span.csv --loads cases.csv --durations life.csv";

/// A name and its position.
fn named(text: &str) -> Result<(String, f64), &'static str> {
    let pair = text.split_once('=').and_then(|(name, eta)| {
        let eta = eta.trim().parse::<f64>().ok()?;
        let fits = !name.trim().is_empty() && (0.0..=1.0).contains(&eta);
        fits.then(|| (name.trim().to_owned(), eta))
    });
    pair.ok_or("expected NAME=ETA with ETA from 0 to 1, as in root=0.02")
}

fn positive(text: &str) -> Result<f64, &'static str> {
    let number = text.trim().parse::<f64>().ok();
    number
        .filter(|number| *number > 0.0 && number.is_finite())
        .ok_or("expected a positive number")
}

/// A blade, its loads, and options.
#[derive(Debug, Args)]
pub(in crate::cli) struct StrengthArguments {
    /// Table of the stations of a blade, NAME.span.csv, or the blade beside it, NAME.blade.json
    pub span: PathBuf,
    /// Table of internal forces; may be given more than once
    #[arg(long, value_name = "FILE", required = true)]
    pub loads: Vec<PathBuf>,
    /// The blade or beam, if the table has several
    #[arg(long, value_name = "NAME")]
    pub member: Option<String>,
    /// Position of the columns NAME_axial and so on; may be given more than once
    #[arg(long, value_name = "NAME=ETA", value_parser = named)]
    pub at: Vec<(String, f64)>,
    /// Woehler exponents of the damage-equivalent load ranges
    #[arg(long, value_name = "NUMBERS", value_delimiter = ',', default_value = "4,10", value_parser = positive, allow_negative_numbers = true)]
    pub exponents: Vec<f64>,
    /// Table of the time that each case lasts in the life of the blade
    #[arg(long, value_name = "FILE")]
    pub durations: Option<PathBuf>,
    /// Number of cycles of these ranges; one each second if not given
    #[arg(long, value_name = "COUNT", value_parser = positive, allow_negative_numbers = true)]
    pub cycles: Option<f64>,
    /// Folder for the results; the folder of SPAN if not given
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Sections solved at the same time; the number of cores if not given
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, value_parser = count)]
    pub threads: Option<NonZeroUsize>,
}

//! The arguments of the command line, and their help texts.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use shared_geom::command_help::Shell;

use super::airfoil::AirfoilArguments;
use super::blade_options::BladeOptions;
use super::compare::CompareArguments;
use super::convert::ConvertArguments;
use super::identify::IdentifyOptions;
use super::linearize_options::LinearizeOptions;
use super::plot::PlotOptions;
use super::reading_options::ReadingOptions;

mod expand;
mod identify;
mod linearize;
mod modes;
mod periodic;
mod plot;
mod stability;
mod transient;
mod trim;

use expand::{EXPAND, EXPAND_EXAMPLE};
use identify::{IDENTIFY, IDENTIFY_EXAMPLE};
use linearize::{LINEARIZE, LINEARIZE_EXAMPLE};
use modes::{MODES, MODES_EXAMPLE};
use periodic::{PERIODIC, PERIODIC_EXAMPLE};
use plot::{PLOT, PLOT_EXAMPLE};
use stability::{STABILITY, STABILITY_EXAMPLE};
use transient::{TRANSIENT, TRANSIENT_EXAMPLE};
use trim::{TRIM, TRIM_EXAMPLE};

const ABOUT: &str = "\
Analyzes blades, rotors and mechanisms: frequencies, loads, buckling, motion in time

Beams are geometrically exact, of any 6x6 stiffness and mass. Steady equilibria at rest or \
at a rotor speed, and under loads; frequencies and modes of small motions about them, named \
and followed over the speeds; critical loads; the motion in time of beams, bodies, springs \
and joints with their reactions.

Axes: x along the blade, y toward the leading edge, z up; the rotor turns about +z unless \
the file states otherwise.";

const EXAMPLES: &str = "\
Example, a uniform blade from nothing:
  cat > blade.dynamics.toml <<'END'
  units = \"SI\"
  [properties.strip]
  ea = 3e6
  gay = 9.5e5
  gaz = 9.5e5
  gj = 2.8
  eiy = 0.64
  eiz = 160
  m = 0.11
  iy = 2.4e-8
  iz = 5.9e-6
  [[blade]]
  name = \"blade\"
  root = [0.06, 0, 0]
  properties = \"strip\"
  [[blade.piece]]
  length = 0.95
  elements = 6
  [modes]
  speeds = { from = 0, to = 750, steps = 6 }
  count = 6
  END
  beam-dynamics modes blade.dynamics.toml

Exit codes: 0 done; 1 ran but did not reach its goal; 2 wrong input or command line.";

const STATIC: &str = "\
Finds equilibria under loads

Reads the dynamics files and the files that they name, finds the equilibrium under rotation \
and constant loads and then along the path of the proportional loads, as [static] states, \
prints the steps, and writes displacements, internal forces, strains, reactions, plots and \
field files into the folder DIR, named by FILE, which is NAME.dynamics.toml.";

const STATIC_EXAMPLE: &str = "\
Example, a load at a node of a blade:
  cat >> blade.dynamics.toml <<'END'
  [[load]]
  node = \"blade/tip\"
  force = [0, 0, 20]
  [static]
  END
  beam-dynamics static blade.dynamics.toml";

const BUCKLING: &str = "\
Finds critical loads and the shapes of buckling

Reads the dynamics files and the files that they name, finds the factors of the \
proportional loads at which the model buckles, by linearized prestress about the \
equilibrium under rotation and constant loads, prints them, and writes factors and shapes \
into the folder DIR, named by FILE, which is NAME.dynamics.toml.";

const BUCKLING_EXAMPLE: &str = "\
Example:
  beam-dynamics buckling frame.dynamics.toml";

const PERFORMANCE: &str = "\
Computes power, thrust and loads of rigid rotors

Reads the rotor files and the files that they name, finds the steady state of each annulus at \
every operating point by momentum and the airfoils of the blades, prints the tables, and writes \
into the folder DIR:
  NAME.performance.csv   a row for each operating point: power, thrust, torque, coefficients
  NAME.performance.txt   the tables as printed
  NAME.span_loads.csv    loads along the blades at the points that loads_at names
  NAME.performance_1.png, .svg   the curves of the first set of points, and so on
  NAME.map_1.png, .svg   for a grid of tip speed ratio and pitch: maps of CP and CT
  NAME.span_loads_1.png, .svg    loads along the blades
where FILE is NAME.rotor.toml.";

const PERFORMANCE_EXAMPLE: &str = "\
Example, the curves of a propeller over the advance ratio from the file of its geometry:
  cat > fan.rotor.toml <<'END'
  units = \"SI\"
  [rotor]
  machine = \"propeller\"
  file = \"cam6x3.def\"
  [[sweep]]
  rotor_speed = 14000
  advance_ratio = { from = 0, to = 0.6, steps = 25 }
  END
  beam-dynamics performance fan.rotor.toml";

const CHECK: &str = "\
Reads and checks dynamics files without analyzing them

Reports all problems of the files and of the files that they name, with file, line and \
remedy; prints a summary if there are none.";

const CHECK_EXAMPLE: &str = "\
Example:
  beam-dynamics check rotor/swept.dynamics.toml";

const DESCRIBE: &str = "\
Describes the contents of blade files

For files of any known format: BeamDyn, ElastoDyn, OpenFAST, HAWC2, windIO, QBlade, DYMORE, \
VABS, tables, blade and property files. States the format, the meaning of its axes, order and \
reference point, the line with twist, the stations, mass and moments, ranges of stiffness and \
centers, damping, whether the stiffness is positive definite, and implausible and missing \
data.";

const DESCRIBE_EXAMPLE: &str = "\
Examples:
  beam-dynamics describe NREL5MW_BeamDyn.dat
  beam-dynamics describe NREL5MW_BeamDyn_Blade.dat --length 61.5";

const COMPARE: &str = "\
Compares two blade files

Reads both in any format known to `describe`, and prints the largest difference of B from A \
of each quantity, with its position: line, twist, mass, the entries of stiffness, mass and \
damping in Helicoid's axes about the line, and the lowest frequencies of both blades, clamped \
and at rest; then the quantities that differ by more than the tolerance, largest first.";

const COMPARE_EXAMPLE: &str = "\
Example, two descriptions of a blade:
  beam-dynamics compare IEA-15-240-RWT_BeamDyn.dat IEA-15-240-RWT.htc --tolerance 0.01

Exit codes: 0 equal within the tolerance; 1 different; 2 wrong input or command line.";

const CONVERT: &str = "\
Converts a blade from one format to another

Reads FROM in any format known to `describe` and writes TO, in the format of its ending \
or that named with --to, with companion files in the same folder. Numbers keep all their \
digits; data that the other format cannot hold are reported, with their size. Never overwrites \
the input.

With --into FILE, a windIO file, TO is a copy of FILE in which only the reference axis, the twist \
and the elastic properties are replaced: a complete file stays complete.";

const CONVERT_EXAMPLE: &str = "\
Examples:
  beam-dynamics convert NREL5MW_BeamDyn.dat nrel.blade.json
  beam-dynamics convert nrel.blade.json nrel.st
  beam-dynamics convert nrel.blade.json table.dat --to dymore
  beam-dynamics convert nrel.blade.json new.yaml --into turbine.yaml";

const AIRFOIL: &str = "\
Describes, draws and converts airfoil tables

Reads FILE in any known format: C81, AeroDyn 12 and 15, HAWC2 pc, windIO 1 and 2, XFOIL and XFLR5 \
polars, CSV; or takes a built-in airfoil: naca0012, flat_plate, thin. Several files of one airfoil \
are one table over their Reynolds and Mach numbers. Prints ranges of angle, Mach and Reynolds \
number, lift slope, zero lift, largest lift and least drag, remarks, and problems that keep a table \
from being used. Draws NAME.airfoil.png and .svg: cl, cd and cm over the angle of attack.

With --out NEW, writes the airfoils in the format of the ending of NEW or named with --to, and lists \
the data that this cannot hold. Never overwrites the input.";

const AIRFOIL_EXAMPLE: &str = "\
Examples:
  beam-dynamics airfoil naca0012
  beam-dynamics airfoil IEA-15-240-RWT.yaml --name FFA-W3-211
  beam-dynamics airfoil polar_Re1e6.txt polar_Re2e6.txt --viterna=17 --out section.csv
  beam-dynamics airfoil DU21_A17.dat --out DU21.dat --to aerodyn15 --no-figures

Exit codes: 0 done; 1 a result was not written; 2 wrong input or command line.";

const SCHEMA: &str = "\
Writes the description of an input file: dynamics, rotor or blade

As a JSON schema (draft 2020-12), editors complete the keys of the file and mark \
mistakes; as Markdown it is the reference page of all keys.";

const SCHEMA_EXAMPLE: &str = "\
Example, for the editors that use Taplo (Even Better TOML): write the schema
  beam-dynamics schema --out dynamics.schema.json
and name it in the first line of the dynamics file:
  #:schema ./dynamics.schema.json";

/// Files that are described.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum SchemaFile {
    /// NAME.dynamics.toml
    Dynamics,
    /// NAME.rotor.toml
    Rotor,
    /// NAME.blade.toml
    Blade,
}

/// Formats of the description.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum SchemaFormat {
    /// A JSON schema
    Json,
    /// The reference page
    Markdown,
}

const COMPLETIONS: &str = "\
Prints the completion script of a shell for commands and options

The folder for the script depends on the shell.";

const COMPLETIONS_EXAMPLE: &str = "\
Examples:
  beam-dynamics completions bash > ~/.local/share/bash-completion/completions/beam-dynamics
  beam-dynamics completions zsh > ~/.zfunc/_beam-dynamics
  beam-dynamics completions fish > ~/.config/fish/completions/beam-dynamics.fish";

const MANUAL: &str = "\
Writes the manual pages, one for each command

Without DIR all pages are printed one after the other.";

const MANUAL_EXAMPLE: &str = "\
Examples:
  beam-dynamics manual | man -l -
  beam-dynamics manual --out ~/.local/share/man/man1";

/// Summary of a command, for the list of commands.
fn first_line(text: &'static str) -> &'static str {
    text.lines().next().unwrap_or(text)
}

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "beam-dynamics", version, about = ABOUT, after_help = EXAMPLES)]
pub(super) struct Arguments {
    #[command(subcommand)]
    pub command: Command,
    /// Print no report; problems and remarks are still reported on the error stream
    #[arg(long, short, global = true)]
    quiet: bool,
}

impl Arguments {
    /// Whether no report is printed; a text that is the result of a command is printed.
    pub fn is_quiet(&self) -> bool {
        let is_text = matches!(
            self.command,
            Command::Expand { .. }
                | Command::Schema { .. }
                | Command::Completions { .. }
                | Command::Manual { .. }
        );
        self.quiet && !is_text
    }
}

/// Folder of the results, and which of them are made.
#[derive(Debug, Args)]
pub(super) struct Results {
    /// Folder for the results; the folder "results" next to each FILE if not given
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Draw no figures; removes the figures of an earlier run
    #[arg(long)]
    pub no_figures: bool,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    #[command(about = first_line(MODES), long_about = MODES, after_help = MODES_EXAMPLE)]
    Modes {
        /// Dynamics files, NAME.dynamics.toml, or blade files; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
        /// Write animated shapes of the modes for ParaView, as "shapes = true" of [modes] does
        #[arg(long)]
        vtu: bool,
        #[command(flatten)]
        blade: BladeOptions,
    },
    #[command(about = first_line(STATIC), long_about = STATIC, after_help = STATIC_EXAMPLE)]
    Static {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
    },
    #[command(about = first_line(BUCKLING), long_about = BUCKLING, after_help = BUCKLING_EXAMPLE)]
    Buckling {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
    },
    #[command(about = first_line(TRANSIENT), long_about = TRANSIENT, after_help = TRANSIENT_EXAMPLE)]
    Transient {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
        /// Continue from this state, NAME.restart.json of an earlier part of the same run
        #[arg(long, value_name = "SNAPSHOT")]
        restart: Option<PathBuf>,
    },
    #[command(about = first_line(PERIODIC), long_about = PERIODIC, after_help = PERIODIC_EXAMPLE)]
    Periodic {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
    },
    #[command(about = first_line(TRIM), long_about = TRIM, after_help = TRIM_EXAMPLE)]
    Trim {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
        /// Write NAME.trim.json as well, for other programs
        #[arg(long)]
        json: bool,
    },
    #[command(
        about = first_line(STABILITY),
        long_about = STABILITY,
        after_help = STABILITY_EXAMPLE
    )]
    Stability {
        /// Dynamics files, NAME.dynamics.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
    },
    #[command(
        about = first_line(LINEARIZE),
        long_about = LINEARIZE,
        after_help = LINEARIZE_EXAMPLE
    )]
    Linearize {
        #[command(flatten)]
        options: LinearizeOptions,
        #[command(flatten)]
        results: Results,
    },
    #[command(
        about = first_line(PERFORMANCE),
        long_about = PERFORMANCE,
        after_help = PERFORMANCE_EXAMPLE
    )]
    Performance {
        /// Rotor files, NAME.rotor.toml; several run side by side
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        results: Results,
    },
    #[command(about = first_line(PLOT), long_about = PLOT, after_help = PLOT_EXAMPLE)]
    Plot {
        /// Tables of runs in time, NAME.transient.csv or NAME.transient.nc
        #[arg(required = true, value_name = "RESULT")]
        results: Vec<PathBuf>,
        #[command(flatten)]
        options: PlotOptions,
    },
    #[command(about = first_line(IDENTIFY), long_about = IDENTIFY, after_help = IDENTIFY_EXAMPLE)]
    Identify {
        /// Tables of runs in time, NAME.transient.csv or NAME.transient.nc
        #[arg(required = true, value_name = "RESULT")]
        results: Vec<PathBuf>,
        #[command(flatten)]
        options: IdentifyOptions,
    },
    #[command(about = first_line(CHECK), long_about = CHECK, after_help = CHECK_EXAMPLE)]
    Check {
        /// Dynamics files, NAME.dynamics.toml, or blade files
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
    },
    #[command(about = first_line(EXPAND), long_about = EXPAND, after_help = EXPAND_EXAMPLE)]
    Expand {
        /// A dynamics file, NAME.dynamics.toml
        #[arg(value_name = "FILE")]
        file: PathBuf,
        /// The file to write, in the folder of FILE; default the terminal
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    #[command(about = first_line(DESCRIBE), long_about = DESCRIBE, after_help = DESCRIBE_EXAMPLE)]
    Describe {
        /// Blade files
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        #[command(flatten)]
        reading: ReadingOptions,
    },
    #[command(about = first_line(COMPARE), long_about = COMPARE, after_help = COMPARE_EXAMPLE)]
    Compare(CompareArguments),
    #[command(about = first_line(CONVERT), long_about = CONVERT, after_help = CONVERT_EXAMPLE)]
    Convert(ConvertArguments),
    #[command(about = first_line(AIRFOIL), long_about = AIRFOIL, after_help = AIRFOIL_EXAMPLE)]
    Airfoil(AirfoilArguments),
    #[command(about = first_line(SCHEMA), long_about = SCHEMA, after_help = SCHEMA_EXAMPLE)]
    Schema {
        /// The file that is described
        #[arg(long, value_enum, default_value_t = SchemaFile::Dynamics)]
        of: SchemaFile,
        /// Format of the description
        #[arg(long, value_enum, default_value_t = SchemaFormat::Json)]
        format: SchemaFormat,
        /// File to write instead of printing
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    #[command(about = first_line(COMPLETIONS), long_about = COMPLETIONS, after_help = COMPLETIONS_EXAMPLE)]
    Completions {
        /// The shell
        #[arg(value_enum)]
        shell: Shell,
    },
    #[command(about = first_line(MANUAL), long_about = MANUAL, after_help = MANUAL_EXAMPLE)]
    Manual {
        /// Folder for the pages
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
}

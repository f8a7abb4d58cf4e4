//! The arguments of the command line, and their help texts.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use shared_geom::command_help::Shell;
use shared_geom::mesh::CellKind;

mod analyze;
mod check;
mod convert;
mod layup;
mod matrices;
mod property_files;
mod strength;
mod stress;
mod whole_blade;

pub(super) use super::load_arguments::LoadArguments;
pub(super) use analyze::AnalyzeArguments;
use analyze::{ANALYZE, ANALYZE_EXAMPLE};
pub(super) use check::CheckArguments;
use check::{CHECK, CHECK_EXAMPLE};
pub(super) use convert::ConvertArguments;
use convert::{CONVERT, CONVERT_EXAMPLE};
use layup::{LAYUP, LAYUP_EXAMPLE, MESH_LAYUP, MESH_LAYUP_EXAMPLE};
pub(super) use layup::{LayupArguments, MeshLayupArguments};
use matrices::{MATRICES, MATRICES_EXAMPLE};
use property_files::{
    COMPARE, COMPARE_EXAMPLE, REPORT, REPORT_EXAMPLE, ROTATE, ROTATE_EXAMPLE, SHIFT, SHIFT_EXAMPLE,
};
pub(super) use property_files::{
    CompareArguments, Point, PrincipalName, ReportArguments, RotateArguments, ShiftArguments,
};
pub(super) use strength::StrengthArguments;
use strength::{STRENGTH, STRENGTH_EXAMPLE};
use stress::{STRESS, STRESS_EXAMPLE};
pub(super) use whole_blade::WholeBladeArguments;
use whole_blade::{WHOLE_BLADE, WHOLE_BLADE_EXAMPLE};

const ABOUT: &str = "\
Computes the 6x6 stiffness and mass of a beam section of any shape and material

From a plane mesh and the materials of its cells, the warping of the section is solved
for under each of six internal forces (axial force, two shears, torque, two bending
moments); stiffness, mass, centers and principal axes follow, with all couplings.

Axes: x along the beam, y and z in the section (mesh x is y, mesh y is z).
Components: axial, shear y, shear z, torsion, bending y, bending z, about the origin
of the mesh. Results are in SI units.";

const EXAMPLES: &str = "\
Example, a strip of aluminum:
  section-analyzer mesh rectangle --width 1 --height 0.063 \\
    --cells-y 40 --cells-z 4 --out strip.msh
  cat > strip.section.toml <<'END'
  mesh = \"strip.msh\"
  [units]
  length = \"in\"
  [material.aluminum]
  young = \"73.1 GPa\"
  poisson = 0.325
  density = \"2680 kg/m^3\"
  [[region]]
  group = \"section\"
  material = \"aluminum\"
  END
  section-analyzer analyze strip.section.toml

Exit codes: 0 done; 1 ran but did not reach its goal; 2 wrong input or command line.";

const MESH: &str = "\
Makes the mesh of a simple shape

Sizes are in the mesh's own unit of length, which the section file declares. The mesh
is centered at the origin and written in the format of gmsh (4.1, ascii). Its
boundaries are physical curves, which angles can follow; they run clockwise.";

const RECTANGLE_EXAMPLE: &str = "\
Example, 40 by 4 biquadratic cells in the physical surface \"section\":
  section-analyzer mesh rectangle --width 1 --height 0.063 \\
    --cells-y 40 --cells-z 4 --out strip.msh";

const TUBE_EXAMPLE: &str = "\
Example, a wall of 2 cells with curved sides in the physical surface \"wall\":
  section-analyzer mesh tube --outer-radius 50 --thickness 5 \\
    --cells-around 48 --cells-through 2 --out tube.msh
A wound ply then follows the physical curve \"outer\" or \"inner\":
  plane_angle = { follow = \"outer\" }";

const ELLIPSE_EXAMPLE: &str = "\
Example, a full disk of 12 x 6 x 6 cells in the physical surface \"section\":
  section-analyzer mesh ellipse --semi-y 10 --semi-z 10 --cells 6 --out disk.msh";

const BLADE: &str = "\
A section of a blade, from a file

FILE contains airfoil, skin, spar (D-spar or box-spar), cores and the size of cells;
plies have the given thickness everywhere, corners are mitred. The mesh is in the unit
of length of FILE, y toward the nose. Each ply is a physical surface; angles follow the
physical curves \"contour\" (skin) and \"spar\". With --section, a section file is started
with all regions and angles; the constants of the materials must be added.";

const BLADE_EXAMPLE: &str = "\
Example, a NACA 0012 with a D-spar of one material:
  cat > blade.toml <<'END'
  [units]
  length = \"mm\"
  [airfoil]
  naca = \"0012\"
  chord = 400
  [skin]
  plies = [{ name = \"skin\", material = \"glass\", fiber_angle = 45, thickness = 0.25 }]
  [spar]
  rear_web = 0.4
  plies = [{ name = \"spar\", material = \"carbon\", thickness = 3 }]
  [mesh]
  size = 6
  END
  section-analyzer mesh blade blade.toml --out blade.msh --section blade.section.toml";

const SCHEMA: &str = "\
Prints the description of an input file, for editors or as a page

As a JSON schema (draft 2020-12), editors complete the keys of a file and mark
mistakes while you type. As Markdown it is the reference of the documentation.";

const SCHEMA_EXAMPLE: &str = "\
Example, for the editors that use Taplo (Even Better TOML): write the schema
  section-analyzer schema --out section.schema.json
and name it in the first line of the section file:
  #:schema ./section.schema.json";

const COMPLETIONS: &str = "\
Prints the completion script of a shell for commands and options

The folder for the script depends on the shell.";

const COMPLETIONS_EXAMPLE: &str = "\
Examples:
  section-analyzer completions bash > ~/.local/share/bash-completion/completions/section-analyzer
  section-analyzer completions zsh > ~/.zfunc/_section-analyzer
  section-analyzer completions fish > ~/.config/fish/completions/section-analyzer.fish";

const MANUAL: &str = "\
Writes the manual pages, one for each command

Without DIR all pages are printed one after the other.";

const MANUAL_EXAMPLE: &str = "\
Examples:
  section-analyzer manual | man -l -
  section-analyzer manual --out ~/.local/share/man/man1";

/// A name that a mesh file can hold.
fn group_name(text: &str) -> Result<String, &'static str> {
    let fits = |letter: char| letter != '"' && !letter.is_control();
    if !text.trim().is_empty() && text.chars().all(fits) {
        Ok(text.to_owned())
    } else {
        Err("expected letters, without quotes and line breaks")
    }
}

/// First paragraph of a text, for the list of commands.
fn first_line(text: &'static str) -> &'static str {
    text.lines().next().unwrap_or_default()
}

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "section-analyzer", version, about = first_line(ABOUT), long_about = ABOUT, after_help = EXAMPLES)]
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
            Command::Schema { .. } | Command::Completions { .. } | Command::Manual { .. }
        );
        self.quiet && !is_text
    }
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    #[command(about = first_line(ANALYZE), long_about = ANALYZE, after_help = ANALYZE_EXAMPLE)]
    Analyze(AnalyzeArguments),
    #[command(about = first_line(CHECK), long_about = CHECK, after_help = CHECK_EXAMPLE)]
    Check(CheckArguments),
    #[command(about = first_line(STRESS), long_about = STRESS, after_help = STRESS_EXAMPLE)]
    Stress {
        /// Section file, NAME.section.toml
        file: PathBuf,
        #[command(flatten)]
        load: LoadArguments,
        /// Folder for the results; the folder "results" next to FILE if not given
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Draw no figures; figures of an earlier run are removed
        #[arg(long)]
        no_figures: bool,
    },
    #[command(about = first_line(MATRICES), long_about = MATRICES, after_help = MATRICES_EXAMPLE)]
    Matrices {
        /// Matrices file, NAME.matrices.toml
        file: PathBuf,
        /// Folder for the results; the folder "results" next to FILE if not given
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    #[command(about = first_line(CONVERT), long_about = CONVERT, after_help = CONVERT_EXAMPLE)]
    Convert(ConvertArguments),
    #[command(subcommand, about = first_line(MESH), long_about = MESH)]
    Mesh(Shape),
    #[command(about = first_line(LAYUP), long_about = LAYUP, after_help = LAYUP_EXAMPLE)]
    Layup(LayupArguments),
    #[command(about = first_line(WHOLE_BLADE), long_about = WHOLE_BLADE, after_help = WHOLE_BLADE_EXAMPLE)]
    Blade(WholeBladeArguments),
    #[command(about = first_line(STRENGTH), long_about = STRENGTH, after_help = STRENGTH_EXAMPLE)]
    Strength(StrengthArguments),
    #[command(about = first_line(REPORT), long_about = REPORT, after_help = REPORT_EXAMPLE)]
    Report(ReportArguments),
    #[command(about = first_line(COMPARE), long_about = COMPARE, after_help = COMPARE_EXAMPLE)]
    Compare(CompareArguments),
    #[command(about = first_line(SHIFT), long_about = SHIFT, after_help = SHIFT_EXAMPLE)]
    Shift(ShiftArguments),
    #[command(about = first_line(ROTATE), long_about = ROTATE, after_help = ROTATE_EXAMPLE)]
    Rotate(RotateArguments),
    #[command(about = first_line(SCHEMA), long_about = SCHEMA, after_help = SCHEMA_EXAMPLE)]
    Schema {
        /// The file that is described
        #[arg(long, value_enum, default_value_t = SchemaFile::Section)]
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

/// Files that are described.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum SchemaFile {
    /// NAME.section.toml
    Section,
    /// The file of "mesh blade"
    Blade,
    /// NAME.layup.toml
    Layup,
    /// NAME.matrices.toml
    Matrices,
}

/// Forms of a description.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum SchemaFormat {
    /// A JSON schema
    Json,
    /// The reference page
    Markdown,
}

/// The shapes that can be meshed.
#[derive(Debug, Subcommand)]
pub(super) enum Shape {
    /// A full rectangle
    #[command(after_help = RECTANGLE_EXAMPLE)]
    Rectangle {
        /// Size along y
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        width: f64,
        /// Size along z
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        height: f64,
        /// Cells along y
        #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
        cells_y: usize,
        /// Cells along z
        #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
        cells_z: usize,
        /// Name of the physical surface
        #[arg(long, default_value = "section", value_parser = group_name)]
        name: String,
        #[command(flatten)]
        common: Common,
    },
    /// A circular tube
    #[command(after_help = TUBE_EXAMPLE)]
    Tube {
        /// Outer radius
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        outer_radius: f64,
        /// Thickness of the wall
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        thickness: f64,
        /// Cells around
        #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
        cells_around: usize,
        /// Cells through the wall
        #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
        cells_through: usize,
        /// Straight sides: the tube becomes a polygon
        #[arg(long)]
        straight: bool,
        #[command(flatten)]
        common: Common,
    },
    #[command(about = first_line(BLADE), long_about = BLADE, after_help = BLADE_EXAMPLE)]
    Blade(BladeArguments),
    #[command(about = first_line(MESH_LAYUP), long_about = MESH_LAYUP, after_help = MESH_LAYUP_EXAMPLE)]
    Layup(MeshLayupArguments),
    /// A full ellipse or disk
    #[command(after_help = ELLIPSE_EXAMPLE)]
    Ellipse {
        /// Semi-axis along y
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        semi_y: f64,
        /// Semi-axis along z
        #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
        semi_z: f64,
        /// Cells from the core to the boundary, and along a quarter of the core
        #[arg(long, value_name = "COUNT", allow_negative_numbers = true)]
        cells: usize,
        /// Straight sides: the ellipse becomes a polygon
        #[arg(long)]
        straight: bool,
        #[command(flatten)]
        common: Common,
    },
}

/// Arguments for the section of a blade.
#[derive(Debug, Args)]
pub(super) struct BladeArguments {
    /// Blade file
    pub file: PathBuf,
    /// Mesh file to write; it must not exist
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Section file to start; it must not exist
    #[arg(long, value_name = "FILE")]
    pub section: Option<PathBuf>,
    /// Replace files that exist
    #[arg(long)]
    pub force: bool,
}

/// Arguments of every shape.
#[derive(Debug, Args)]
pub(super) struct Common {
    /// Kind of the cells; the number is their number of nodes
    #[arg(long, value_enum, default_value_t = CellName::Quad9)]
    pub cell: CellName,
    /// Mesh file to write; it must not exist
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Replace a file that exists
    #[arg(long)]
    pub force: bool,
}

/// Names of the kinds of cells.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(super) enum CellName {
    Tri3,
    Tri6,
    Quad4,
    Quad8,
    Quad9,
}

impl CellName {
    pub fn kind(self) -> CellKind {
        match self {
            Self::Tri3 => CellKind::Triangle3,
            Self::Tri6 => CellKind::Triangle6,
            Self::Quad4 => CellKind::Quadrilateral4,
            Self::Quad8 => CellKind::Quadrilateral8,
            Self::Quad9 => CellKind::Quadrilateral9,
        }
    }
}

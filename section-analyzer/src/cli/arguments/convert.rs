//! The arguments of `convert`.

use std::path::PathBuf;

use clap::Args;
use shared_geom::error::Explain;
use shared_geom::units::{Dimension, parse_as};

pub(super) const CONVERT: &str = "\
Makes a section file of a model of VABS or BECAS

MODEL is an input file of VABS 3 or 4 (also of PreVABS), or a folder of BECAS with N2D.in,
E2D.in, EMAT.in and MATPROPS.in. Next to the section file NAME.section.toml are written
  NAME.msh               the mesh, a physical surface for each material and fiber angle
  NAME.fiber_angles.csv  fiber angles by cell, if a material has more than twenty
  NAME.plane_angles.csv  plane angles by cell, if they differ within a region
None of them may exist. VABS' axes x1, x2, x3 are x, y, z; BECAS' x, y, z are y, z, x.
The models have no units: their numbers are in a consistent system, of the given units of
length and force, and of mass = force * s^2 / length.";

pub(super) const CONVERT_EXAMPLE: &str = "\
Examples, a model in inches and pounds, and a folder of BECAS in SI units:
  section-analyzer convert box.sg box.section.toml --length in --force lbf
  section-analyzer convert becas/station_3 station_3.section.toml
  section-analyzer analyze box.section.toml";

/// Arguments of `convert`.
#[derive(Debug, Args)]
pub(in crate::cli) struct ConvertArguments {
    /// Input file of VABS, or folder of BECAS
    pub model: PathBuf,
    /// Section file to write, NAME.section.toml
    pub section: PathBuf,
    /// Unit of the lengths of the model
    #[arg(long, value_name = "UNIT", default_value = "m", value_parser = length)]
    pub length: String,
    /// Unit of the forces of the model
    #[arg(long, value_name = "UNIT", default_value = "N", value_parser = force)]
    pub force: String,
}

fn length(text: &str) -> Result<String, String> {
    unit(text, Dimension::LENGTH)
}

fn force(text: &str) -> Result<String, String> {
    unit(text, Dimension::FORCE)
}

/// The name of a unit of `dimension`.
fn unit(text: &str, dimension: Dimension) -> Result<String, String> {
    match parse_as(text, dimension) {
        Ok(_) => Ok(text.to_owned()),
        Err(problem) => {
            let help = problem.help().map(|help| format!("; {help}"));
            Err(format!("{problem}{}", help.unwrap_or_default()))
        }
    }
}
